//! Hits that more than one family asks about, and the question made of one.

use std::ops::RangeInclusive;

use std::collections::BTreeMap;

use serde_json::{Map, Value};

use super::where_to::figures;
use crate::physics::Disc;
use crate::quiz::dice::Dice;
use crate::quiz::misconceptions::catalogue::SINE_COSINE;
use crate::quiz::{
    Difficulty, Family, Form, Hit, Illustration, Markings, Misconception, Pieces, Placement,
    Question, Response, Topic, WrongAnswer,
};

/// What a hit on a resting target is drawn from.
pub(super) struct Setting<'a> {
    /// The sets of pieces.
    pub(super) pieces: &'a [Pieces],
    /// Impact angles in degrees, in steps of five.
    pub(super) fives_deg: RangeInclusive<u32>,
    /// Coefficients of restitution.
    pub(super) restitutions: &'a [f64],
}

impl Setting<'_> {
    /// A hit: the pieces, α, e, a speed of 2 to 5 m/s, the side, and a direction that is
    /// the freer the harder the question.
    pub(super) fn draw(&self, difficulty: Difficulty, dice: &mut Dice) -> Option<Hit> {
        let pieces = *dice.pick(self.pieces)?;
        let (from, to) = (self.fives_deg.start() / 5, self.fives_deg.end() / 5);
        let alpha_deg = f64::from(5 * (from + dice.below((to + 1).saturating_sub(from))));
        let restitution = *dice.pick(self.restitutions)?;
        let speed = f64::from(2 + dice.below(4));
        let left = dice.coin();
        let turn = difficulty.turn_deg();
        Some(Hit {
            pieces,
            given: Placement::Angle {
                // 0.0 - x, not -x: a head-on hit has no side.
                alpha_deg: if left { 0.0 - alpha_deg } else { alpha_deg },
            },
            restitution,
            speed,
            direction_deg: f64::from(turn * dice.below(360 / turn)),
        })
    }
}

/// What a question about a hit is made of, besides the hit.
pub(super) struct Asked {
    pub(super) family: Family,
    pub(super) difficulty: Difficulty,
    pub(super) topic: Topic,
    /// What is asked, after the hit has been described.
    pub(super) ask: String,
    pub(super) form: Form,
    pub(super) beliefs: Vec<WrongAnswer>,
    pub(super) why: String,
    /// Figures besides those of the hit.
    pub(super) more: Map<String, Value>,
}

/// The question about a hit that is told in other words, beside another picture.
pub(super) fn told(hit: &Hit, text: &str, picture: Illustration, asked: Asked) -> Question {
    Question {
        text: format!("{text} {}", asked.ask),
        picture,
        ..about(hit, asked)
    }
}

/// A question about a hit that is given in full.
pub(super) fn about(hit: &Hit, asked: Asked) -> Question {
    let mut figures = figures(hit);
    figures.extend(asked.more);
    Question {
        family: asked.family,
        difficulty: asked.difficulty,
        topic: asked.topic,
        text: format!("{} {}", hit.setting(), asked.ask),
        picture: Illustration::Before {
            collision: hit.collision(),
            shown: Markings::given(hit),
        },
        form: asked.form,
        beliefs: asked.beliefs,
        replies: BTreeMap::new(),
        why: asked.why,
        figures,
    }
}

/// To take the sine for the cosine in what the struck disc of this name gets.
pub(super) fn sine_for_cosine(x: f64, name: &str) -> Option<WrongAnswer> {
    let says = format!("You took the sine for the cosine. Head-on the {name} gets the most.");
    number(&SINE_COSINE, x, says)
}

/// Figures with their names, besides those of the hit.
pub(super) fn more<const N: usize>(figures: [(&str, Value); N]) -> Map<String, Value> {
    figures
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect()
}

/// The belief that gives a number, if it gives one worth typing: finite and not
/// negative.
pub(super) fn number(
    misconception: &'static Misconception,
    said: f64,
    says: String,
) -> Option<WrongAnswer> {
    let sane = said.is_finite() && said >= 0.0;
    sane.then(|| WrongAnswer::new(misconception, Response::Number(said), says))
}

/// The beliefs whose answer can be given and is not the true one by accident; the others
/// are none.
pub(super) fn wrong(
    form: &Form,
    beliefs: impl IntoIterator<Item = Option<WrongAnswer>>,
) -> Vec<WrongAnswer> {
    /// What rounding alone may do.
    const SAME: f64 = 1e-6;
    let can_be_said = |said: &Response| match (form, said) {
        (Form::Number { quantity, .. }, Response::Number(x)) => {
            (quantity.smallest()..=quantity.largest()).contains(x)
        }
        _ => true,
    };
    beliefs
        .into_iter()
        .flatten()
        .filter(|belief| can_be_said(&belief.said))
        .filter(|belief| form.spacing(&belief.said, &form.truth()) > SAME)
        .collect()
}

/// What misconceptions would choose: which one, which choice, and what is wrong with it.
pub(super) type Chosen = (&'static Misconception, usize, String);

/// The beliefs among these that choose wrongly; of those that choose alike the first.
pub(super) fn wrong_choices(
    right: usize,
    chosen: impl IntoIterator<Item = Chosen>,
) -> Vec<WrongAnswer> {
    let mut beliefs: Vec<WrongAnswer> = Vec::new();
    for (misconception, choice, says) in chosen {
        let said = Response::Choice(choice);
        if choice != right && !beliefs.iter().any(|belief| belief.said == said) {
            beliefs.push(WrongAnswer::new(misconception, said, says));
        }
    }
    beliefs
}

/// Two discs of one size with these masses in grams.
pub(super) fn pair(m1_g: u32, m2_g: u32) -> Pieces {
    let disc = |mass_g| Disc::from_g_mm(f64::from(mass_g), 15.0);
    Pieces::Own {
        striker: disc(m1_g),
        target: disc(m2_g),
    }
}

/// A picture of a hit about to happen that shows nothing of where the two will meet.
pub(super) fn unmarked(hit: &Hit) -> Illustration {
    Illustration::Before {
        collision: hit.collision(),
        shown: Markings {
            figures: true,
            ..Markings::default()
        },
    }
}
