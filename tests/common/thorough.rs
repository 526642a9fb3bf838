//! How often tests try something at random.

/// The number of cases that a test tries: `many` if `CARROM_THOROUGH` is set, as in CI, and `few`
/// otherwise.
pub(crate) fn cases<N>(few: N, many: N) -> N {
    match std::env::var_os("CARROM_THOROUGH") {
        Some(_) => many,
        None => few,
    }
}
