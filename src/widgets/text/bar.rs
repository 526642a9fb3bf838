//! Bars that show a share of a whole.

use super::{Charset, blocks::LEFT};

/// A bar `width` cells wide, of which the fraction `share` is filled. `share` is clamped to the
/// range from 0 to 1; NaN gives an empty bar.
///
/// In Unicode the bar is filled to the nearest eighth of a cell, in ASCII to the nearest cell.
///
/// ```
/// use carrom::widgets::{Charset, bar::bar};
/// assert_eq!(bar(0.6, 10, Charset::Ascii), "######....");
/// assert_eq!(bar(0.6, 10, Charset::Unicode), "██████░░░░");
/// ```
pub fn bar(share: f64, width: u16, charset: Charset) -> String {
    let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
    let width = usize::from(width);
    match charset {
        Charset::Ascii => {
            let full = (share * width as f64).round() as usize;
            "#".repeat(full) + &".".repeat(width - full)
        }
        Charset::Unicode => {
            let eighths = (share * 8.0 * width as f64).round() as usize;
            let mut bar = "█".repeat(eighths / 8);
            if let Some(part) = (eighths % 8).checked_sub(1) {
                bar.push(LEFT[part]);
            }
            let empty = width - eighths.div_ceil(8);
            bar + &"░".repeat(empty)
        }
    }
}

/// A line that marks the part of a bar between the fractions `from` and `to`.
pub(crate) fn stretch(from: f64, to: f64, width: u16, charset: Charset) -> String {
    let [from, to] = [from, to].map(|share| (share * f64::from(width)).round() as usize);
    let [left, line, right] = match charset {
        Charset::Ascii => ["|", "-", "|"],
        Charset::Unicode => ["├", "─", "┤"],
    };
    let inner = to.saturating_sub(from + 2);
    format!("{}{left}{}{right}", " ".repeat(from), line.repeat(inner))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_has_the_given_width_for_any_share() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            for width in [0, 1, 7, 10, 33] {
                for share in [-1.0, 0.0, 0.01, 0.31, 0.5, 0.999, 1.0, 7.0, f64::NAN] {
                    let cells = bar(share, width, charset).chars().count();
                    assert_eq!(cells, usize::from(width), "{share} {charset:?}");
                }
            }
        }
    }
}
