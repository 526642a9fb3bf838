//! The lab's notebook.

use crate::physics::CollisionSpec;
use crate::quiz::{Figures, Rays, figures};

use super::figures_text;

/// A hit in the lab's notebook. The result of the hit is not stored, because it follows from the
/// settings.
#[derive(Debug, Clone, PartialEq)]
pub struct NotedHit {
    /// The time in seconds since the start of 1970 (UTC), which is set by the store; `None` until
    /// the hit is stored, or if the time is unknown.
    pub time_s: Option<i64>,
    /// The settings of the collision.
    pub setup: CollisionSpec,
    /// The prediction, if there was one.
    pub said: Option<Rays>,
}

impl NotedHit {
    /// The maximum number of a player's hits that are read; if there are more, only the latest are
    /// read.
    pub(crate) const MOST: usize = 1000;

    /// Creates a hit that has not been stored yet.
    pub(crate) fn new(setup: CollisionSpec, said: Option<Rays>) -> Self {
        Self {
            time_s: None,
            setup,
            said,
        }
    }

    /// Reads a stored hit from its settings, which have the same form as in a link, and its
    /// prediction as JSON; `None` if carrom cannot have written these texts.
    pub(crate) fn of_texts(time_s: Option<i64>, setup: &str, said: Option<&str>) -> Option<Self> {
        let said = match said {
            Some(said) => Some(rays_of_text(said)?),
            None => None,
        };
        Some(Self {
            time_s,
            setup: CollisionSpec::from_link(setup).ok()?,
            said,
        })
    }
}

/// Formats two rays as JSON.
pub(crate) fn rays_text(rays: &Rays) -> String {
    figures_text(&figures(rays.json()))
}

/// Reads what [`rays_text`] writes; `None` for anything else.
pub(crate) fn rays_of_text(text: &str) -> Option<Rays> {
    let read: Figures = serde_json::from_str(text).ok()?;
    Rays::of_figures(&read).filter(Rays::are_in_range)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hit_that_carrom_cannot_have_written_is_not_read() {
        let said = rays_text(&Rays::new(1.0, 0.5));
        let read = |setup, said| NotedHit::of_texts(Some(1), setup, said);
        let hit = read("m2:5.5,b:-12", Some(&said)).unwrap();
        assert_eq!(hit.setup.to_link(), "m2:5.5,b:-12");
        let [theta1, theta2] = [hit.said.unwrap().striker, hit.said.unwrap().target];
        assert!((theta1.unwrap() - 1.0).abs() < 1e-12 && (theta2.unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(read("", None).unwrap().setup, CollisionSpec::default());
        let long = "m1:".to_owned() + &"9".repeat(10_000);
        for setup in ["m2:-5", "m2:NaN", "b:1e9", "mass:3", "=1+1", &long] {
            assert_eq!(read(setup, None), None, "{setup}");
        }
        for said in [
            "",
            "[]",
            "1",
            r#"{"theta1_deg":200,"theta2_deg":0}"#,
            r#"{"theta1_deg":20}"#,
            r#"{"theta1_deg":"=1","theta2_deg":0}"#,
        ] {
            assert_eq!(read("", Some(said)), None, "{said}");
        }
    }
}
