//! Figures in words.

/// "1 answer", "7 answers".
pub(crate) fn answers(count: usize) -> String {
    match count {
        1 => "1 answer".into(),
        _ => format!("{count} answers"),
    }
}

/// "1 angle", "7 angles".
pub(crate) fn angles(count: usize) -> String {
    match count {
        1 => "1 angle".into(),
        _ => format!("{count} angles"),
    }
}

/// A share as a percentage; "-" where there is none.
pub(crate) fn percent(share: Option<f64>) -> String {
    share.map_or("-".into(), |share| format!("{:.0} %", 100.0 * share))
}

/// An angle in degrees to a tenth; "-" where there is none.
pub(crate) fn degrees(angle_deg: Option<f64>) -> String {
    match angle_deg {
        Some(angle) if angle.is_finite() => format!("{angle:.1}°"),
        _ => "-".into(),
    }
}
