//! A shot of one's own in lines: `set offset 12`, then `shoot`.

use super::answering;
use super::figure;
use super::number::number;
use super::spoken::sentence;
use super::talk::{Leave, Talk};
use crate::physics::{Bond, Collision, CollisionSpec, ImpactPoint};
use crate::quiz::{Rays, RaysGrade, Response, why};

/// How a shot is set and played.
pub(super) const HELP: &str = "For a shot of your own, say set and what it shall be: set offset \
                               12 in millimetres, set angle 40 in degrees, set speed 3 in metres \
                               per second, set striker 15 or set target 25 in grams, set e 0.8. \
                               Then say shoot.";

/// What somebody wants of a shot of their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ShotWish {
    /// That it shall be this one.
    Set(CollisionSpec),
    /// That it is played.
    Shoot,
}

impl ShotWish {
    /// What a line means for the shot `of`; `None` if it is about something else.
    ///
    /// # Errors
    /// A kind line on what was expected.
    pub(super) fn read(heard: &str, of: &CollisionSpec) -> Option<Result<Self, String>> {
        let heard = heard.to_lowercase();
        let mut words = heard.split_whitespace();
        match words.next() {
            Some("shoot") => Some(Ok(Self::Shoot)),
            Some("set") => {
                let name = words.next().unwrap_or_default();
                let value = words.collect::<Vec<_>>().join(" ");
                Some(set(name, &value, of).map(Self::Set))
            }
            _ => None,
        }
    }
}

/// The shot with one of its numbers set.
fn set(name: &str, value: &str, of: &CollisionSpec) -> Result<CollisionSpec, String> {
    let reach_mm = of.r1_mm + of.r2_mm;
    let read = |unit: &str, least: f64, most: f64| number(value, unit, least, most);
    // What is set by hand slips; a pair that sticks stays together whatever e is.
    Ok(match name {
        "offset" | "b" => CollisionSpec {
            point: ImpactPoint::Offset {
                offset_mm: read("mm", -reach_mm, reach_mm)?,
            },
            ..*of
        },
        "angle" | "alpha" => CollisionSpec {
            point: ImpactPoint::Angle {
                alpha_deg: read("°", -90.0, 90.0)?,
            },
            ..*of
        },
        "speed" | "u" => CollisionSpec {
            speed: read("m/s", 0.1, 20.0)?,
            ..*of
        },
        "striker" => CollisionSpec {
            m1_g: read("g", 0.1, 1000.0)?,
            ..*of
        },
        "target" | "coin" => CollisionSpec {
            m2_g: read("g", 0.1, 1000.0)?,
            ..*of
        },
        "e" => CollisionSpec {
            restitution: read("", 0.0, 1.0)?,
            bond: Bond::Slip,
            ..*of
        },
        _ => return Err(HELP.to_owned()),
    })
}

/// Says how a shot is set.
pub(super) fn say_set(talk: &mut Talk, spec: &CollisionSpec) -> Result<(), Leave> {
    talk.say_all(figure::whole_set_up(spec))
}

/// Asks where both will go, plays the shot, and says why.
pub(super) fn shoot(talk: &mut Talk, spec: &CollisionSpec) -> Result<(), Leave> {
    let collision = spec.collision();
    let lead: Vec<String> = figure::whole_set_up(spec).into();
    let said = answering::rays(talk, &lead, collision.side(), "target")?;
    if let Some(Response::Rays(said)) = said {
        let right = RaysGrade::new(&said, &Rays::from(&collision.outcome())).is_right();
        talk.say(if right { "Right." } else { "Not quite." })?;
        tell_rays(talk, (said, right), &collision, "target")?;
    }
    talk.say_all(figure::result(&collision))
}

/// Says what was said of both discs, and whether rightly, where they go, and why.
pub(super) fn tell_rays(
    talk: &mut Talk,
    (said, right): (Rays, bool),
    collision: &Collision,
    target: &str,
) -> Result<(), Leave> {
    let truth = Rays::from(&collision.outcome());
    talk.say(&format!("You said: {}.", said.words(target)))?;
    talk.say(&format!("It is: {}.", truth.words(target)))?;
    let (title, text) = why(collision, Some(said));
    if !right && !title.is_empty() {
        talk.say(&format!("It looks like this: {}", sentence(title)))?;
    }
    talk.say(&text)
}

/// The lab: shots of one's own, one after the other.
///
/// # Errors
/// If the player quits, or nothing more is to be heard.
pub fn lab(talk: &mut Talk) -> Result<(), Leave> {
    talk.say("carrom, the lab. Type help at any time, and quit to leave.")?;
    let mut spec = CollisionSpec::default();
    talk.say(HELP)?;
    say_set(talk, &spec)?;
    loop {
        let wish = talk.ask_for(&[], "Set, or shoot?", HELP, |heard| {
            ShotWish::read(heard, &spec).unwrap_or_else(|| Err(HELP.to_owned()))
        })?;
        match wish {
            ShotWish::Set(new) => {
                spec = new;
                say_set(talk, &spec)?;
            }
            ShotWish::Shoot => shoot(talk, &spec)?,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(heard: &str) -> Option<Result<ShotWish, String>> {
        ShotWish::read(heard, &CollisionSpec::default())
    }

    #[test]
    fn a_shot_is_set_word_by_word() {
        let Some(Ok(ShotWish::Set(spec))) = read("Set offset 12 mm") else {
            panic!("an offset was set");
        };
        assert_eq!(spec.point, ImpactPoint::Offset { offset_mm: 12.0 });
        let Some(Ok(ShotWish::Set(spec))) = read("set target 25") else {
            panic!("a mass was set");
        };
        assert_eq!(
            (spec.m2_g, spec.m1_g),
            (25.0, CollisionSpec::default().m1_g)
        );
        assert_eq!(read("shoot"), Some(Ok(ShotWish::Shoot)));
        assert_eq!(read("next"), None);
    }

    #[test]
    fn what_cannot_be_set_is_said() {
        for heard in [
            "set",
            "set wind 3",
            "set offset far",
            "set offset 900",
            "set e 2",
        ] {
            assert!(matches!(read(heard), Some(Err(_))), "{heard}");
        }
    }
}
