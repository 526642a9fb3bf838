//! An open page: its figure, and the state of its question.

use crate::lessons::ChapterPage;
use crate::physics::Collision;
use crate::quiz::{Form, Response};
use crate::screens::learn::figure::LiveFigure;
use crate::widgets::hit::{HitPace, Watch};
use crate::widgets::{AnswerInput, RayInput};

#[derive(Debug, Clone)]
pub(super) struct OpenPage {
    pub(super) page: ChapterPage,
    pub(super) figure: Option<LiveFigure>,
    /// The state of the page's question; `None` if the page has no question.
    pub(super) stage: Option<CheckpointStage>,
    /// The first wrong answer, after which a hint was shown.
    pub(super) first: Option<Response>,
    /// Whether keys go to the figure first.
    pub(super) on_figure: bool,
}

/// The state of a question.
#[derive(Debug, Clone)]
pub(super) enum CheckpointStage {
    /// The question is waiting for an answer or, after a hint, for a second answer.
    Asking(AnswerInput),
    /// The question was answered, and the right answer is shown.
    Answered(Response),
}

impl OpenPage {
    /// A newly opened page. `tries` holds the final answer to its question and the wrong first
    /// answer, if there was one; `alpha_deg` is the impact angle that the student set last.
    pub(super) fn new(
        page: ChapterPage,
        alpha_deg: Option<f64>,
        tries: Option<(Response, Option<Response>)>,
    ) -> Self {
        let hidden = page.checkpoint.is_some();
        let figure = page.figure;
        let figure = figure.map(|figure| LiveFigure::new(figure, alpha_deg, hidden));
        let mut open = Self {
            page,
            figure,
            stage: None,
            first: None,
            on_figure: false,
        };
        let input = open.form().map(|form| AnswerInput::new(&form));
        open.stage = input.map(CheckpointStage::Asking);
        open.on_figure = open.is_open_to_figure();
        if let (Some((answer, first)), true) = (tries, open.is_asking()) {
            open.first = first;
            open.reveal(answer, HitPace::Still);
            open.figure.iter_mut().for_each(LiveFigure::explain);
        }
        open
    }

    /// The page's question as the quiz asks it, about the collision in the figure; `None` if the
    /// page has no question.
    pub(super) fn form(&self) -> Option<Form> {
        let checkpoint = self.page.checkpoint.as_ref()?;
        Some(checkpoint.form(self.collision()))
    }

    /// Begins the second try: the rays keep their positions and can be changed.
    pub(super) fn ask_again(&mut self, first: Response, form: &Form) {
        self.first = Some(first);
        let rays = first.rays().map(Response::Rays);
        self.stage = Some(CheckpointStage::Asking(AnswerInput::saying(form, rays)));
    }

    /// Whether keys go to the figure first on a newly opened page.
    fn is_open_to_figure(&self) -> bool {
        !self.is_asking() && self.figure.as_ref().is_some_and(LiveFigure::is_set_by_keys)
    }

    /// The collision of the figure.
    pub(super) fn collision(&self) -> Option<&Collision> {
        self.figure.as_ref().map(|figure| &figure.collision)
    }

    /// The answer being entered.
    pub(super) fn input(&self) -> Option<&AnswerInput> {
        match &self.stage {
            Some(CheckpointStage::Asking(input)) => Some(input),
            _ => None,
        }
    }

    /// Mutable access to the answer being entered.
    pub(super) fn input_mut(&mut self) -> Option<&mut AnswerInput> {
        match &mut self.stage {
            Some(CheckpointStage::Asking(input)) => Some(input),
            _ => None,
        }
    }

    /// The rays that are turned in the figure.
    pub(super) fn rays(&self) -> Option<&RayInput> {
        self.input()?.rays()
    }

    /// Whether a question is waiting for its answer.
    pub(super) fn is_asking(&self) -> bool {
        self.input().is_some()
    }

    /// The first answer, while a second one is being entered.
    pub(super) fn hinted(&self) -> Option<Response> {
        self.first.filter(|_| self.is_asking())
    }

    /// The collision that is being explained step by step.
    pub(super) fn explaining(&self) -> Option<&Watch> {
        let watch = self.figure.as_ref().and_then(LiveFigure::watch);
        watch.filter(|watch| !self.is_asking() && !watch.is_revealed())
    }

    /// Shows the result of an answer.
    pub(super) fn reveal(&mut self, answer: Response, pace: HitPace) {
        self.stage = Some(CheckpointStage::Answered(answer));
        if let Some(figure) = &mut self.figure {
            figure.reveal(answer.rays(), pace);
        }
        self.on_figure = self.is_open_to_figure();
    }
}
