//! Numbers as text.

/// A fraction as a percentage; "-" if there is none.
pub(crate) fn percent(share: Option<f64>) -> String {
    share.map_or("-".into(), |share| format!("{:.0} %", 100.0 * share))
}

/// An angle in degrees to a tenth; "-" if there is none.
pub(crate) fn degrees(angle_deg: Option<f64>) -> String {
    match angle_deg {
        Some(angle) if angle.is_finite() => format!("{angle:.1}°"),
        _ => "-".into(),
    }
}
