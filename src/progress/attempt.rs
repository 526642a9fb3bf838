//! One answer, with everything known about it.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::{LEVEL, TABLE};
use crate::physics::units::deg_from_rad;
use crate::quiz::{
    Answer, Clue, Code, Confidence, Figures, Form, Grade, Misconception, Question, Rays, Topic,
    figures,
};

/// The family to which all questions in chapters belong.
pub const LESSON: &str = "lesson";

/// The largest possible error of an angle, in degrees, with a margin for rounding.
const FURTHEST_OFF_DEG: f64 = 180.0 + 1e-6;
/// The maximum number of choices in a chapter's question, with room for future versions.
const MOST_LINES: u64 = 26;

pub(crate) fn figures_text(figures: &Figures) -> String {
    serde_json::to_string(figures).unwrap_or_default()
}

/// One answer, with everything known about it. An attempt is not specific to the quiz: anything
/// that asks questions can record answers. The serialized form is used in a pupil's hand-in, a file
/// that contains the player's name only once.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Attempt {
    /// The time in seconds since the start of 1970 (UTC), which is set by the store; `None` until
    /// the attempt is stored, or if the time is unknown.
    #[serde(default)]
    pub time_s: Option<i64>,
    /// The player's name.
    #[serde(skip)]
    pub player: String,
    /// The family of the question, by its name in files: "where-to", or [`LESSON`], [`TABLE`] or
    /// [`LEVEL`].
    pub family: String,
    /// The topic, as the id of a [`Topic`] or the title of a chapter.
    pub topic: String,
    /// The seed of the round; 0 if there is none.
    pub seed: u64,
    /// The number, from 1, of the question in the round, the page in the chapter, the move in the
    /// game, or the level in the list.
    pub number: u32,
    /// The figures of the question. For quiz questions they include the code of the `round`, the
    /// `misconceptions` that an answer could have shown, by their names in files, and `by_chance`,
    /// the probability that a guess fits a given one of these misconceptions.
    pub question: Figures,
    /// The answer.
    pub answer: Figures,
    /// The correct answer.
    pub truth: Figures,
    /// The error of the angle in degrees, or the largest of several errors; `None` if the answer
    /// had no angle.
    #[serde(default)]
    pub error_deg: Option<f64>,
    /// The credit, from 0 to 1.
    pub credit: f64,
    /// Whether the answer counts as right.
    pub right: bool,
    /// How sure the player was; `None` if the player was not asked.
    #[serde(default)]
    pub confidence: Option<Confidence>,
    /// The misconception that the answer fits, by its name in files.
    #[serde(default)]
    pub misconception: Option<String>,
}

impl Attempt {
    /// An answer to question `number` (from 1) of the round with this code.
    pub fn of_quiz(
        player: &str,
        code: &Code,
        number: u32,
        question: &Question,
        answer: &Answer,
    ) -> Self {
        let grade = Grade::new(question, answer);
        let noted = json!({(ROUND): code.to_string(), "difficulty": question.difficulty.id()});
        let attempt = Self {
            player: player.to_owned(),
            family: question.family.id().to_owned(),
            topic: question.topic.id().to_owned(),
            seed: code.seed,
            number,
            question: figures(noted),
            answer: question.form.kept(&answer.said),
            truth: question.form.kept(&question.form.truth()),
            error_deg: grade.angle_error.map(deg_from_rad),
            credit: grade.credit,
            right: grade.right,
            confidence: Some(answer.confidence),
            ..Self::default()
        };
        attempt.with_evidence(question, answer)
    }

    /// This attempt, with the figures of the question added, and with the evidence for
    /// misconceptions that the answer provides.
    pub(crate) fn with_evidence(mut self, question: &Question, answer: &Answer) -> Self {
        let clue = Clue::new(question, answer);
        let beliefs = clue.could_show.iter().map(|it| it.id());
        self.question.extend(question.figures.clone());
        let noted = json!({(MISCONCEPTIONS): Vec::from_iter(beliefs), (BY_CHANCE): clue.by_chance});
        self.question.extend(figures(noted));
        self.misconception = clue.shows.map(|it| it.id().to_owned());
        self
    }

    /// The topic as shown: "equal masses, by offset", or the title of the chapter.
    pub(crate) fn topic_name(&self) -> String {
        match self.family.as_str() {
            LESSON => self.topic.clone(),
            _ => Topic::with_id(self.topic.clone()).name(),
        }
    }

    /// The reason why the answer is impossible; `None` if it is a possible answer to some question.
    ///
    /// Anyone can change files and databases. All code that counts, shows or hands in answers
    /// relies on this check: numbers are finite and in range, and the answer is of the same kind as
    /// the correct answer.
    pub fn fault(&self) -> Option<&'static str> {
        let error_is_possible = |error: f64| match self.family.as_str() {
            // In a chapter, an angle may be any number, so its error may exceed 180°.
            LESSON => error >= 0.0 && error.is_finite(),
            _ => (0.0..=FURTHEST_OFF_DEG).contains(&error),
        };
        if !(0.0..=1.0).contains(&self.credit) {
            Some("its credit is not a number from 0 to 1")
        } else if !self.error_deg.is_none_or(error_is_possible) {
            Some("its error is not an angle")
        } else if !self.answer_is_possible() {
            Some("its answer is out of range or of the wrong kind")
        } else {
            None
        }
    }

    fn answer_is_possible(&self) -> bool {
        let (answer, truth) = (&self.answer, &self.truth);
        let is_like_truth = truth.is_empty() || answer.keys().all(|name| truth.contains_key(name));
        let is_in_range = match self.family.as_str() {
            LESSON => lesson_answer_is_possible(answer),
            _ => Form::could_be_kept(answer),
        };
        // The result counts even if the answer itself was not stored.
        answer.is_empty() || (is_like_truth && is_in_range)
    }

    /// The evidence for misconceptions in this answer. Unknown misconceptions are left out. If the
    /// misconceptions that an answer could have shown were not stored, only the one that it did
    /// show is included.
    pub(crate) fn clue(&self) -> Clue {
        let noted = self.question.get(MISCONCEPTIONS).and_then(Value::as_array);
        let noted = noted.map_or(&[][..], Vec::as_slice);
        let ids = noted.iter().filter_map(Value::as_str);
        let by_chance = self.question.get(BY_CHANCE).and_then(Value::as_f64);
        Clue {
            question: format!("{} {}", self.number, figures_text(&self.question)),
            could_show: ids.filter_map(Misconception::with_id).collect(),
            shows: self.shows(),
            by_chance: by_chance
                .filter(|chance| (0.001..=0.9).contains(chance))
                .unwrap_or_else(|| self.by_chance_at_most(noted.len())),
        }
    }

    /// The misconception that the answer fits, if this version of carrom knows it.
    pub fn shows(&self) -> Option<Misconception> {
        Misconception::with_id(self.misconception.as_deref()?)
    }

    /// Whether the answer was given in the quiz, rather than in a chapter, at the table or in a
    /// level.
    pub(crate) fn is_of_quiz(&self) -> bool {
        ![LESSON, TABLE, LEVEL].contains(&self.family.as_str())
    }

    /// The round in which the answer was given: the code of the round, the title of the chapter, or
    /// the name for the table or for the levels.
    pub fn round(&self) -> String {
        match self.family.as_str() {
            LESSON => return format!("chapter: {}", self.topic),
            TABLE => return "table".into(),
            LEVEL => return "levels".into(),
            _ => {}
        }
        // Earlier versions stored only the seed.
        let noted = self.question.get(ROUND).and_then(Value::as_str);
        noted.map_or_else(|| self.seed.to_string(), str::to_owned)
    }

    /// Whether the answer was given in a review.
    pub(crate) fn is_of_review(&self) -> bool {
        self.is_of_quiz() && self.round().starts_with("review")
    }

    /// The topic of the answer in the quiz; for a checkpoint in a chapter, the topic under which
    /// the checkpoint is reviewed.
    pub(crate) fn quiz_topic(&self) -> Option<&str> {
        match self.family.as_str() {
            LESSON => self.question.get(REVIEWED_BY)?.as_str(),
            _ => Some(&self.topic),
        }
    }

    /// The points for accuracy, from 0 to [`Grade::MOST`], not taking the confidence into account.
    pub fn points(&self) -> f64 {
        Grade::MOST * self.credit
    }

    /// The points, taking the confidence into account.
    pub fn earned(&self) -> f64 {
        self.confidence
            .map_or(self.points(), |it| it.points(self.credit))
    }

    /// An upper bound, based on the answer, for the probability that a guess fits a misconception;
    /// used if the probability itself was not stored. The number of choices was at least three, and
    /// greater than the number of stored misconceptions.
    fn by_chance_at_most(&self, misconceptions: usize) -> f64 {
        match self.truth.contains_key("choice") {
            true => 1.0 / (misconceptions + 1).max(3) as f64,
            false => ONE_BY_CHANCE,
        }
    }

    /// Whether the player was sure but wrong.
    pub(crate) fn is_surely_wrong(&self) -> bool {
        self.confidence == Some(Confidence::Sure) && !self.right
    }
}

/// Whether this is a possible answer to a checkpoint in a chapter: two rays, any number, or a
/// choice counted from 1.
fn lesson_answer_is_possible(answer: &Figures) -> bool {
    match (answer.get("number"), answer.get("choice")) {
        (Some(number), None) => number.is_f64() || number.is_i64() || number.is_u64(),
        (None, Some(line)) => matches!(line.as_u64(), Some(1..=MOST_LINES)),
        _ => Rays::of_figures(answer).is_some_and(|it| it.are_in_range()),
    }
}

/// The key of the round's code in [`Attempt::question`].
pub(crate) const ROUND: &str = "round";

/// The key of the topic under which a chapter's question is reviewed.
pub(crate) const REVIEWED_BY: &str = "topic";

/// The key of the misconceptions that an answer could have shown.
const MISCONCEPTIONS: &str = "misconceptions";

/// The key of the probability that a guess fits a given one of these misconceptions.
const BY_CHANCE: &str = "by_chance";

/// The probability that a guess at a number or one ray fits a misconception, as for quiz questions.
const ONE_BY_CHANCE: f64 = 0.08;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ImpactPoint;
    use crate::quiz::{Hit, Pieces, Ray, Response};

    const HIT: Hit = Hit {
        pieces: Pieces::Equal,
        given: ImpactPoint::Angle { alpha_deg: 30.0 },
        restitution: 1.0,
        speed: 4.0,
        direction_deg: 90.0,
    };

    fn attempt(theta1_deg: f64, theta2_deg: f64) -> Attempt {
        let rays = Rays::new(theta1_deg.to_radians(), theta2_deg.to_radians());
        noted(rays, Confidence::Sure)
    }

    fn noted(rays: Rays, confidence: Confidence) -> Attempt {
        let answer = Answer::new(Response::Rays(rays), confidence);
        let code = Code::parse("7").unwrap();
        Attempt::of_quiz("Ada", &code, 3, &Question::from(&HIT), &answer)
    }

    fn read(figures: &str) -> Figures {
        serde_json::from_str(figures).unwrap()
    }

    #[test]
    fn an_impossible_answer_has_a_fault() {
        let sound = attempt(60.0, 30.0);
        assert_eq!(sound.fault(), None);
        for (credit, error_deg) in [
            (f64::NAN, None),
            (-0.1, None),
            (1.1, None),
            (f64::INFINITY, None),
            (1.0, Some(f64::NAN)),
            (1.0, Some(-1.0)),
            (1.0, Some(181.0)),
            (1.0, Some(f64::INFINITY)),
        ] {
            let changed = Attempt {
                credit,
                error_deg,
                ..sound.clone()
            };
            assert!(changed.fault().is_some(), "{credit} {error_deg:?}");
        }
        // Each answer is out of range or not of the same kind as the correct answer.
        for answer in [
            "{\"choice\":99}",
            "{\"choice\":\"B\"}",
            "{\"theta1_deg\":200.0,\"theta2_deg\":0.0}",
            "{\"theta1_deg\":null}",
            "{\"theta1_deg\":20.0}",
        ] {
            let changed = Attempt {
                answer: read(answer),
                ..sound.clone()
            };
            assert!(changed.fault().is_some(), "{answer}");
        }
        let of_chapter = |answer: &str, truth: &str| Attempt {
            family: LESSON.into(),
            answer: read(answer),
            truth: read(truth),
            error_deg: Some(5000.0),
            ..sound.clone()
        };
        for (answer, truth, is_sound) in [
            ("{\"number\":-1e6}", "{\"number\":2,\"unit\":\"°\"}", true),
            ("{\"choice\":2}", "{\"choice\":1}", true),
            ("{\"theta1_deg\":null,\"theta2_deg\":0}", "{}", true),
            ("{\"choice\":99}", "{\"choice\":1}", false),
            ("{\"choice\":0}", "{\"choice\":1}", false),
            ("{\"choice\":1}", "{\"number\":1,\"unit\":\"\"}", false),
            ("{\"number\":\"1\"}", "{\"number\":1,\"unit\":\"\"}", false),
        ] {
            let fault = of_chapter(answer, truth).fault();
            assert_eq!(fault.is_none(), is_sound, "{answer} {fault:?}");
        }
    }

    #[test]
    fn an_attempt_stores_everything_about_the_answer() {
        let right = attempt(60.0, 30.0);
        assert!(right.right && !right.is_surely_wrong());
        assert!((right.credit - 1.0).abs() < 1e-12);
        assert!(right.error_deg.unwrap() < 1e-9);
        assert_eq!(right.misconception, None);
        // Equal masses leave an elastic collision at right angles: 60° and 30°.
        let truth = &right.truth;
        assert!((truth["theta1_deg"].as_f64().unwrap() - 60.0).abs() < 1e-9);
        assert!((truth["theta2_deg"].as_f64().unwrap() - 30.0).abs() < 1e-9);
        let figures = &right.question;
        assert_eq!(figures["alpha_deg"].as_f64(), Some(30.0));
        assert_eq!(figures["direction_deg"].as_f64(), Some(90.0));
        let clue = right.clue();
        assert!(clue.could_show.contains(&Misconception::CopiedAngle));
        assert!(!clue.could_show.contains(&Misconception::Lossless));
        assert!((clue.by_chance - 0.01).abs() < 1e-12);
    }

    #[test]
    fn the_error_is_the_larger_of_two_rays() {
        let copied = attempt(30.0, 30.0);
        assert!(copied.is_surely_wrong());
        assert!((copied.error_deg.unwrap() - 30.0).abs() < 1e-9);
        assert_eq!(copied.misconception.as_deref(), Some("copied-angle"));
        let rays = Rays {
            striker: None,
            ..HIT.truth()
        };
        let still = noted(rays, Confidence::Guess);
        // There is no angle error for the striker, but the answer is still wrong.
        assert!(rays.apart(&HIT.truth(), Ray::Striker).is_none());
        assert!(still.error_deg.unwrap() < 1e-9 && !still.right);
    }
}
