//! A question under construction.

use serde_json::{Map, Value};

use super::where_to::figures;
use crate::quiz::question::{
    AimTask, Dice, Difficulty, Family, Form, Hit, Illustration, Markings, Measure, Misconception,
    Question, Response, Topic, WrongAnswer,
};

/// A wrong answer as declared, even if it cannot be given.
struct OutlinedAnswer {
    /// The misconception behind the answer; `None` for a wrong choice that no known misconception
    /// leads to.
    misconception: Option<Misconception>,
    /// The answer; `None` if the misconception leads to no answer here.
    response: Option<Response>,
    says: String,
}

/// A question under construction: its setting, what it asks, and the right and wrong answers.
///
/// Wrong answers are declared even if they make no sense for the numbers drawn; [`why`](Self::why)
/// leaves out those that cannot be given or happen to be right.
pub(super) struct Outline {
    question: Question,
    wrong: Vec<OutlinedAnswer>,
}

impl Outline {
    /// Creates a question that begins with this text and has this picture beside it.
    pub(super) fn new(text: impl Into<String>, picture: Illustration) -> Self {
        let question = Question {
            // The family and the difficulty are set later, by the generator.
            family: Family::WhereTo,
            difficulty: Difficulty::Middle,
            topic: Topic::with_id(""),
            text: text.into(),
            picture,
            form: Form::Choice {
                options: Vec::new(),
                right: 0,
            },
            beliefs: Vec::new(),
            replies: std::collections::BTreeMap::new(),
            why: String::new(),
            figures: Map::new(),
        };
        Self {
            question,
            wrong: Vec::new(),
        }
    }

    /// Creates a question about a hit whose numbers are all given.
    pub(super) fn about(hit: &Hit) -> Self {
        let picture = Illustration::before(hit.collision(), Markings::given(hit));
        Self::with_text(hit, hit.setting(), picture)
    }

    /// Creates a question about a hit, with this setting and this picture.
    pub(super) fn with_text(hit: &Hit, text: impl Into<String>, picture: Illustration) -> Self {
        let mut draft = Self::new(text, picture);
        draft.question.figures = figures(hit);
        draft
    }

    /// Adds the actual question after the setting.
    pub(super) fn ask(mut self, text: impl AsRef<str>) -> Self {
        self.question.text += " ";
        self.question.text += text.as_ref();
        self
    }

    pub(super) fn topic(mut self, topic: impl Into<Topic>) -> Self {
        self.question.topic = topic.into();
        self
    }

    /// Sets the name of this type of question within its family, and the topic.
    pub(super) fn named(self, id: &str, topic: impl Into<Topic>) -> Self {
        self.figure("asked", id).topic(topic)
    }

    /// Adds a value that defines the question and is stored with each answer.
    pub(super) fn figure(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.question.figures.insert(name.into(), value.into());
        self
    }

    /// Makes this number the right answer.
    pub(super) fn number(mut self, quantity: Measure, truth: f64) -> Self {
        self.question.form = Form::Number { quantity, truth };
        self
    }

    /// Makes the answer a shot.
    pub(super) fn shot(mut self, aim: AimTask) -> Self {
        self.question.form = Form::Shot(aim);
        self
    }

    /// Makes the question a choice among these texts; `right` is the index of the right one.
    pub(super) fn options<T: Into<String>>(
        mut self,
        options: impl IntoIterator<Item = T>,
        right: usize,
    ) -> Self {
        let options = options.into_iter().map(Into::into).collect();
        self.question.form = Form::Choice { options, right };
        self
    }

    /// Adds the answer that a misconception leads to: a value of the required quantity, or an
    /// offset in metres; `None` if the misconception leads to no answer here.
    pub(super) fn wrong(
        mut self,
        misconception: Misconception,
        answer: impl Into<Option<f64>>,
    ) -> Self {
        let response = match self.question.form {
            Form::Shot(_) => Response::Shot,
            _ => Response::Number,
        };
        self.push(misconception, answer.into().map(response));
        self
    }

    /// Adds the [`option`](Self::options) that a misconception leads to; the misconception is
    /// `None` if no known misconception leads to this wrong option. If several misconceptions lead
    /// to the same option, the first is used.
    pub(super) fn chooses(
        mut self,
        misconception: impl Into<Option<Misconception>>,
        choice: impl Into<Option<usize>>,
    ) -> Self {
        self.push(misconception, choice.into().map(Response::Choice));
        self
    }

    /// Sets the feedback for the wrong answer that was declared last.
    pub(super) fn says(mut self, says: impl Into<String>) -> Self {
        if let Some(last) = self.wrong.last_mut() {
            last.says = says.into();
        }
        self
    }

    fn push(
        &mut self,
        misconception: impl Into<Option<Misconception>>,
        response: Option<Response>,
    ) {
        self.wrong.push(OutlinedAnswer {
            misconception: misconception.into(),
            response,
            says: String::new(),
        });
    }

    /// Shuffles the choices.
    pub(super) fn shuffled(mut self, dice: &mut Dice) -> Self {
        if let Form::Choice { options, right } = &mut self.question.form {
            let mut order: Vec<usize> = (0..options.len()).collect();
            dice.shuffle(&mut order);
            let place = |old: usize| order.iter().position(|it| *it == old).unwrap_or(old);
            *options = order.iter().map(|old| options[*old].clone()).collect();
            *right = place(*right);
            for wrong in &mut self.wrong {
                if let Some(Response::Choice(choice)) = &mut wrong.response {
                    *choice = place(*choice);
                }
            }
            self.wrong.sort_by_key(|wrong| match wrong.response {
                Some(Response::Choice(choice)) => choice,
                _ => 0,
            });
        }
        self
    }

    /// Adds the explanation and completes the question, without any wrong answers that cannot be
    /// given or happen to be right.
    pub(super) fn why(self, why: impl Into<String>) -> Option<Question> {
        /// The largest distance between two answers, in units of the largest tolerance, that can
        /// be caused by rounding alone.
        const SAME: f64 = 1e-6;
        let mut question = self.question;
        question.why = why.into();
        let form = &question.form;
        for wrong in self.wrong {
            let Some(response) = wrong.response else {
                continue;
            };
            let can_be_given = match (form, response) {
                (Form::Number { quantity, .. }, Response::Number(x)) => {
                    (0.0..=quantity.largest()).contains(&x)
                }
                (Form::Choice { .. }, _) => {
                    let same = |other: &WrongAnswer| other.said == response;
                    !question.beliefs.iter().any(same)
                }
                (_, Response::Shot(offset)) => offset.is_finite(),
                _ => true,
            };
            if !can_be_given || form.spacing(&response, &form.truth()) <= SAME {
                continue;
            }
            if let Some(misconception) = wrong.misconception {
                question.beliefs.push(WrongAnswer {
                    misconception,
                    said: response,
                    telltale: None,
                    says: wrong.says,
                });
            } else if let Response::Choice(choice) = response {
                question.replies.insert(choice, wrong.says);
            }
        }
        Some(question)
    }
}
