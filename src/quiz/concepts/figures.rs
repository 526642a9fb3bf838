//! Replaces the placeholders in a text with figures calculated from the question's own hit.

use crate::numbers::{short, true_minus, with_unit};
use crate::physics::CollisionSpec;
use crate::physics::named::{Constant, Quantity};

/// The number of decimal places of a number that does not come from a hit.
const DECIMALS: usize = 2;
/// The number of decimal places of a percentage.
const PERCENT_DECIMALS: usize = 1;

/// `text` with every `{name field=value ...}` replaced by its figure. A `%` before the closing
/// brace turns a fraction into a percentage.
///
/// # Errors
/// If a name or a field is unknown or a figure is undefined, returns a message that says what was
/// expected.
pub(super) fn fill(text: &str, hit: Option<CollisionSpec>) -> Result<String, String> {
    let mut filled = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        let (asked, after) = after.split_once('}').ok_or("expected } after {")?;
        filled.push_str(plain(before)?);
        filled.push_str(&figure(asked, hit)?);
        rest = after;
    }
    filled.push_str(plain(rest)?);
    Ok(filled)
}

fn plain(text: &str) -> Result<&str, String> {
    if text.contains('}') {
        return Err("expected { before }".into());
    }
    Ok(text)
}

fn figure(asked: &str, hit: Option<CollisionSpec>) -> Result<String, String> {
    let (asked, percent) = match asked.trim().strip_suffix('%') {
        Some(share) => (share, true),
        None => (asked, false),
    };
    let mut words = asked.split_whitespace();
    let name = words.next().unwrap_or_default();
    let fields: Vec<(&str, &str)> = words
        .map(|word| {
            word.split_once('=')
                .ok_or_else(|| format!("{name}: expected field=value, found {word}"))
        })
        .collect::<Result<_, _>>()?;
    let (value, decimals) = match Constant::named(name) {
        Some(mut constant) => {
            for (field, value) in fields {
                constant.set(field, value)?;
            }
            (constant.value(), DECIMALS)
        }
        None => of_hit(name, &fields, hit)?,
    };
    let value = value.ok_or_else(|| format!("expected a figure, but {name} is undefined here"))?;
    Ok(if percent {
        with_unit(&true_minus(&short(100.0 * value, PERCENT_DECIMALS)), "%")
    } else {
        true_minus(&short(value, decimals))
    })
}

/// A quantity of the hit with these fields set, and the number of decimal places to which the
/// quantity is printed.
fn of_hit(
    name: &str,
    fields: &[(&str, &str)],
    hit: Option<CollisionSpec>,
) -> Result<(Option<f64>, usize), String> {
    let quantity = Quantity::named(name)
        .ok_or_else(|| format!("expected the name of a number, found {{{name}}}"))?;
    let mut shot = hit.ok_or_else(|| format!("{name}: expected a hit that defines it"))?;
    for (field, value) in fields {
        shot.set(field, value)?;
    }
    shot.check()?;
    Ok((quantity.of(&shot.collision()), quantity.decimals))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_come_from_the_hit() {
        for (text, filled) in [
            ("no figure", "no figure"),
            ("{v1} m/s at {theta1_deg}°", "2 m/s at 60°"),
            ("{v2}", "3.46"),
            ("{theta1_deg alpha_deg=25}°", "65°"),
            ("{separation_deg m2_g=5.5}°", "51.2°"),
            ("{v2y}", "−1.73"),
            ("{v1n}", "0"),
            ("{energy2_share %}, {energy2_share}", "75 %, 0.75"),
            ("{rutherford_ratio angle_deg=60 to_deg=90}", "4"),
            ("{space_share angle_deg=60 %}", "25 %"),
        ] {
            assert_eq!(
                fill(text, Some(CollisionSpec::default())).as_deref(),
                Ok(filled)
            );
        }
    }

    #[test]
    fn an_undefined_figure_is_reported() {
        for (text, hit, message) in [
            (
                "{speed3}",
                true,
                "expected the name of a number, found {speed3}",
            ),
            ("{v1}", false, "v1: expected a hit that defines it"),
            (
                "{theta1_deg alpha_deg=0}",
                true,
                "expected a figure, but theta1_deg is undefined here",
            ),
            ("{v1 30}", true, "v1: expected field=value, found 30"),
            (
                "{v1 m1_g=-3}",
                true,
                "m1_g: expected a mass in g from 0.1 to 1000, found -3",
            ),
            ("{v1", true, "expected } after {"),
            ("v1}", true, "expected { before }"),
        ] {
            let found = fill(text, hit.then(CollisionSpec::default));
            assert_eq!(found, Err(message.to_owned()));
        }
    }
}
