//! A figure as written in a text, and its comparison with the value calculated by the engine.

use super::formula::superscript;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct WrittenFigure {
    /// The figure as shown on the screen.
    pub(super) shown: String,
    value: f64,
    /// The largest permitted difference from the true value.
    margin: f64,
}

/// The permitted rounding error, as a fraction of the value of a root or of one unit in the last
/// decimal place.
const NOISE: f64 = 1e-9;

impl WrittenFigure {
    /// Reads `3.46`, `-1`, `3.2e-7`, `sqrt 5` or `2 sqrt 3`.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        let text = text.trim().replace('−', "-");
        let wrong = || format!("expected a figure such as 3.46, 3.2e-7 or 2 sqrt 3, found {text}");
        if let Some((factor, root)) = text.split_once("sqrt") {
            let (factor, root) = (factor.trim(), root.trim());
            let whole = |text: &str| text.parse::<u32>().ok().filter(|n| (1..10_000).contains(n));
            let times = match factor {
                "" => 1,
                factor => whole(factor).ok_or_else(wrong)?,
            };
            let under = whole(root).ok_or_else(wrong)?;
            let value = f64::from(times) * f64::from(under).sqrt();
            return Ok(Self {
                shown: format!("{factor}√{under}"),
                value,
                margin: NOISE * value,
            });
        }
        let is_plain = |b: u8| b.is_ascii_digit() || b"+-.e".contains(&b);
        let value: f64 = text.parse().map_err(|_| wrong())?;
        if !(text.bytes().all(is_plain) && value.is_finite() && text.len() <= 16) {
            return Err(wrong());
        }
        let (mantissa, exponent) = match text.split_once('e') {
            Some((mantissa, exponent)) => (mantissa, exponent.parse().map_err(|_| wrong())?),
            None => (text.as_str(), 0),
        };
        let decimals = mantissa.split_once('.').map_or(0, |(_, after)| after.len()) as i32;
        let step = 10.0_f64.powi(exponent - decimals);
        let mut shown = mantissa.replace('-', "−");
        if text.contains('e') {
            shown += "×10";
            shown += &superscript(&exponent.to_string()).unwrap_or_default();
        }
        Ok(Self {
            shown,
            value,
            margin: step * (0.5 + NOISE),
        })
    }

    /// Whether the figure equals `truth` rounded to the same number of decimal places; a root must
    /// equal `truth` itself.
    pub(super) fn agrees(&self, truth: f64) -> bool {
        (truth - self.value).abs() <= self.margin
    }

    /// `truth` for a message: with as many decimal places as [`Self::agrees`] compares, or with two
    /// if there is a power of ten.
    pub(super) fn corrected(&self, truth: f64) -> String {
        let places = (-self.margin.log10()).floor().clamp(0.0, 12.0) as usize;
        match self.shown.contains("×10") {
            true => format!("{truth:.2e}"),
            false => format!("{truth:.places$}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_compared_to_their_last_decimal_place() {
        let root = 12.0_f64.sqrt();
        for (written, truth, agrees) in [
            ("3.46", root, true),
            ("3.47", root, false),
            ("3.5", root, true),
            ("3", root, true),
            ("2 sqrt 3", root, true),
            ("2 sqrt 2", root, false),
            ("sqrt 5", 5.0_f64.sqrt(), true),
            ("3.2e-7", 3.2212e-7, true),
            ("3.3e-7", 3.2212e-7, false),
            ("−1.00", -1.0, true),
            ("0.5", 0.45, true),
        ] {
            assert_eq!(
                WrittenFigure::read(written).unwrap().agrees(truth),
                agrees,
                "{written}"
            );
        }
    }

    #[test]
    fn figures_are_shown_as_on_paper() {
        let shown = |text| WrittenFigure::read(text).unwrap().shown;
        assert_eq!(shown("3.2e-7"), "3.2×10⁻⁷");
        assert_eq!(shown("2 sqrt 3"), "2√3");
        assert_eq!(shown("sqrt 5"), "√5");
        assert_eq!(shown("-1.00"), "−1.00");
        assert_eq!(
            WrittenFigure::read("3.50")
                .unwrap()
                .corrected(12.0_f64.sqrt()),
            "3.46"
        );
    }

    #[test]
    fn text_that_is_not_a_figure_is_refused() {
        for text in [
            "", "abc", "nan", "inf", "1e999", "sqrt", "sqrt -2", "2 sqrt x", "1 2", "--1",
        ] {
            assert!(WrittenFigure::read(text).is_err(), "{text}");
        }
    }
}
