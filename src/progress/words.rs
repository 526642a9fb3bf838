//! Numbers as text.

/// Formats a fraction as a percentage; "-" if there is none.
pub(crate) fn percent(share: Option<f64>) -> String {
    share.map_or("-".into(), |share| format!("{:.0} %", 100.0 * share))
}

/// Formats an angle in degrees with one decimal place; "-" if there is none.
pub(crate) fn degrees(angle_deg: Option<f64>) -> String {
    match angle_deg {
        Some(angle) if angle.is_finite() => format!("{angle:.1}°"),
        _ => "-".into(),
    }
}
