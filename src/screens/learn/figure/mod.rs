//! The figure of a page: its view, its keys and its mouse actions.

mod contact;
mod dial;
mod film;
mod foil;
mod frames;
mod momenta;
mod parts;
mod shots;
mod triangle;
pub(super) mod words;
mod worked;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use crate::lessons::{Figure, FigureKind};
use crate::messages::{Key, Mouse, MouseKind};
use crate::numbers::tidy;
use crate::physics::units::{deg_from_rad, rad_from_deg};
use crate::physics::{Bond, Collision, ImpactPoint, Meeting};
use crate::quiz::{Hit, Rays};
use crate::screens::foil::{FoilFigure, FoilFigureAction};
use crate::screens::route::FoilPage;
use crate::widgets::hit::{
    Face, HitPace, Markings, Overlay, Overlays, Watch, WatchAction, point_at, setup_picture,
};
use crate::widgets::input::{FormAction, KeyTable};
use crate::widgets::picture::Picture;
use crate::widgets::{Lines, Look, RayInput, areas, curves, svg};

use contact::ContactForce;
use dial::{ALPHA, FigureDial};
use film::FilmFigure;
use worked::WorkedFigure;

/// The number of steps (of degrees, for α) by which `<` and `>` change a setting.
const LEAP: i8 = 10;

/// What the keys do to the figure of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum FigureAction {
    /// change α
    Alpha(i8),
    /// set α for a head-on or a grazing collision
    AlphaEnd(u8),
    /// change what the figure shows: e, an angle, the contact time or how the collision is filmed
    Dial(i8),
    /// set the same quantity to its smallest or its largest value
    DialEnd(u8),
    /// step through the working
    Step(isize),
    /// set the numbers in the working
    Set(FormAction),
    /// watch the collision
    Watch(WatchAction),
    /// use the foil
    Foil(FoilFigureAction),
}

/// The area of a figure: a picture, and lines of text below it.
struct FigureArea<'a> {
    area: Rect,
    buf: &'a mut Buffer,
    look: &'a Look,
    /// Whether the outcome is still hidden.
    hidden: bool,
}

impl<'a> FigureArea<'a> {
    /// The area of the picture, and the text in the last `rows` rows.
    fn split(self, rows: u16) -> (Rect, Lines<'a>) {
        let [picture, below] = areas::upper(self.area, self.area.height.saturating_sub(rows));
        (picture, Lines::new(below, self.buf, *self.look))
    }
}

/// A figure with its current state.
#[derive(Debug, Clone)]
pub(super) struct LiveFigure {
    pub(super) figure: Figure,
    pub(super) collision: Collision,
    /// Whether the outcome is still hidden.
    hidden: bool,
    state: FigureState,
}

/// The state of a figure, which depends on its kind.
#[derive(Debug, Clone)]
enum FigureState {
    /// The collision that is replayed, in one frame or in two.
    Hits(Vec<Watch>),
    /// The figure has no state besides the collision.
    Plain,
    Worked(WorkedFigure),
    /// A page of the foil.
    Foil(Box<FoilFigure>),
    /// A measured film.
    Film(FilmFigure),
}

impl LiveFigure {
    /// A figure with its outcome `hidden` or shown. `alpha_deg` is the angle that the student set
    /// last.
    pub(super) fn new(mut figure: Figure, alpha_deg: Option<f64>, hidden: bool) -> Self {
        if !hidden {
            figure.shot = figure.after;
        }
        let given = figure.shot.collision();
        let collision = match (alpha_deg, figure.kind) {
            (Some(alpha_deg), _) if figure.own => given.with_alpha(rad_from_deg(alpha_deg)),
            (_, FigureKind::Explosion { third_g: None }) => momenta::moving_to_the_right(given),
            _ => given,
        };
        let mut shown = Self {
            figure,
            collision,
            hidden,
            state: FigureState::Plain,
        };
        shown.set_up(None, HitPace::Still);
        shown
    }

    /// Sets up the state anew for the current collision.
    fn set_up(&mut self, said: Option<Rays>, pace: HitPace) {
        use FigureState::{Film, Foil, Hits, Plain, Worked};
        let watch = || match said {
            Some(_) => Watch::new(self.collision, said, pace),
            None => Watch::revealed(self.collision),
        };
        let hit = |watch| Hits(vec![watch]);
        self.state = match self.figure.kind {
            FigureKind::Split { lines } if said.is_none() => {
                hit(watch().with_layers(split_layers(lines)))
            }
            FigureKind::Lab | FigureKind::Split { .. } => hit(watch()),
            FigureKind::Frames => Hits(frames::watches(&self.collision).into()),
            FigureKind::Worked { blank } => Worked(WorkedFigure::given(blank, self.hidden)),
            FigureKind::Film { filming } => Film(FilmFigure::new(&self.collision, filming)),
            FigureKind::Solve => Worked(WorkedFigure::of_own()),
            FigureKind::Foil {
                levelled, rings, ..
            } if !self.hidden => {
                let page = self.foil_page().unwrap_or_default();
                let watched = pace != HitPace::Still;
                let figure = FoilFigure::new(page, levelled, watched).counted_in(rings);
                Foil(Box::new(figure))
            }
            _ => Plain,
        };
    }

    /// The question of where both discs will go, if the shot is given by the impact angle and suits
    /// the quiz: smooth discs, the coin at rest.
    pub(super) fn question_by_angle(&self) -> Option<Hit> {
        let collision = &self.collision;
        let hit = collision.outcome().meeting == Meeting::Hit;
        let at_rest = collision.u2 == glam::DVec2::ZERO && collision.bond == Bond::Slip;
        let is_smooth = collision.rims.friction <= 0.0;
        let by_angle = hit && at_rest && is_smooth && !self.figure.shot.is_by_offset();
        by_angle.then(|| Hit {
            given: ImpactPoint::Angle {
                alpha_deg: self.alpha_deg(),
            },
            ..Hit::from(collision)
        })
    }

    /// The page of the foil's own screen that shows more, if the figure is one of its pages.
    pub(super) fn foil_page(&self) -> Option<FoilPage> {
        let FigureKind::Foil { page, .. } = self.figure.kind else {
            return None;
        };
        let at = usize::from(page).checked_sub(1)?;
        FoilPage::ALL.get(at).copied()
    }

    /// The collision that is replayed, for its explanation.
    pub(super) fn watch(&self) -> Option<&Watch> {
        match &self.state {
            FigureState::Hits(hits) if !self.hidden && self.figure.kind.is_hit() => hits.first(),
            _ => None,
        }
    }

    /// Shows the outcome. After a prediction it is played from the start, unless motion is reduced;
    /// otherwise the moment of contact is shown.
    pub(super) fn reveal(&mut self, said: Option<Rays>, pace: HitPace) {
        self.hidden = false;
        if self.figure.shot != self.figure.after {
            self.figure.shot = self.figure.after;
            self.collision = self.figure.shot.collision();
        }
        match &mut self.state {
            FigureState::Worked(worked) => worked.reveal(),
            _ => self.set_up(said, pace),
        }
    }

    /// Shows the whole explanation of the collision at once.
    pub(super) fn explain(&mut self) {
        if let FigureState::Hits(hits) = &mut self.state {
            hits.iter_mut().for_each(Watch::reveal);
        }
    }

    /// Whether the figure uses arrow keys, so that keys go to it first.
    pub(super) fn is_set_by_keys(&self) -> bool {
        self.dial().is_some() || self.worked().is_some()
    }

    /// The worked solution, if the figure is text rather than a picture.
    pub(super) fn worked(&self) -> Option<&WorkedFigure> {
        match &self.state {
            FigureState::Worked(worked) => Some(worked),
            _ => None,
        }
    }

    /// Whether a number is being typed in the figure.
    pub(super) fn is_typing(&self) -> bool {
        self.worked().is_some_and(WorkedFigure::is_typing)
    }

    /// What the student sets in this figure, if there is anything to set.
    fn dial(&self) -> Option<FigureDial> {
        FigureDial::of(self).filter(|_| !self.hidden)
    }

    /// Sets the dial, if there is one, to the step nearest to a value; returns whether there is one.
    fn set_dial(&mut self, value: impl Fn(&FigureDial) -> f64) -> bool {
        let Some(dial) = self.dial() else {
            return false;
        };
        let value = dial.nearest(value(&dial));
        let collision = &mut self.collision;
        match &mut self.figure.kind {
            FigureKind::Force { time_ms } => *time_ms = value,
            FigureKind::Parts => collision.restitution = value,
            FigureKind::Film { filming } => *filming.of(filming.sets) = value,
            FigureKind::Explosion { third_g: None } => momenta::turn_pieces(collision, value),
            FigureKind::Explosion { .. } | FigureKind::Coalesce => {
                momenta::turn_second(collision, value);
            }
            _ => *collision = collision.with_alpha(rad_from_deg(value)),
        }
        self.set_up(None, HitPace::Still);
        true
    }

    /// Whether the lab can show the collision full-size; the lab has no explosions.
    pub(super) fn is_for_the_lab(&self) -> bool {
        !matches!(self.figure.kind, FigureKind::Explosion { .. })
    }

    pub(super) fn title(&self) -> String {
        if self.hidden && self.covers_outcome() {
            return "before the hit".into();
        }
        match self.figure.kind {
            FigureKind::Lab | FigureKind::Split { .. } => {
                let watch = self.watch();
                watch.map_or("the hit".into(), |watch| watch.title("the hit"))
            }
            FigureKind::Triangle { .. } => triangle::title(&self.collision).into(),
            FigureKind::Frames => "one hit, two frames".into(),
            FigureKind::Curves => "speeds afterwards".into(),
            FigureKind::Angles => "the two angles".into(),
            FigureKind::Energy => "shares of energy".into(),
            FigureKind::Worked { .. } | FigureKind::Solve | FigureKind::Foil { .. } => {
                match &self.state {
                    FigureState::Worked(worked) => worked.title(&self.collision),
                    FigureState::Foil(plot) => plot.title().into(),
                    _ => "α-particles near an atom".into(),
                }
            }
            FigureKind::Shots { space, .. } => shots::title(space).into(),
            FigureKind::Force { .. } => "the force of the contact".into(),
            FigureKind::Coalesce | FigureKind::Explosion { .. } => {
                "the momenta, tip to tail".into()
            }
            FigureKind::Parts => "the energy in two parts".into(),
            FigureKind::Film { .. } => "a simulated film, measured".into(),
        }
    }

    /// Whether a hidden outcome is replaced by a picture of the discs before the collision.
    fn covers_outcome(&self) -> bool {
        let kind = self.figure.kind;
        kind.is_hit() || matches!(kind, FigureKind::Triangle { .. } | FigureKind::Frames)
    }

    /// The keys that control the figure.
    pub(super) fn keys(&self) -> KeyTable<FigureAction> {
        use FigureAction::{Alpha, AlphaEnd, Dial, DialEnd, Foil};
        let mut keys = KeyTable::new("figure");
        if let Some(dial) = self.dial() {
            let is_alpha = dial.name == ALPHA;
            let by: fn(i8) -> FigureAction = if is_alpha { Alpha } else { Dial };
            let end: fn(u8) -> FigureAction = if is_alpha { AlphaEnd } else { DialEnd };
            keys = keys
                .by([Key::Left, Key::Right], by, [-1, 1], dial.name)
                .or([('<', by(-LEAP)), ('>', by(LEAP))])
                .by([Key::Home, Key::End], end, [0, 1], "");
        }
        let watched = |watch: &Watch| {
            use WatchAction::{Again, Frame, Scrub, ToggleLayer};
            let spare = |action| matches!(action, Frame | Scrub(_) | ToggleLayer(_));
            let keys = watch.keys().renamed("play again", |action| action == Again);
            keys.renamed("", spare)
        };
        match &self.state {
            _ if self.hidden && self.covers_outcome() => keys,
            FigureState::Hits(hits) => match hits.as_slice() {
                [] => keys,
                [hit] => keys.with(watched(hit), FigureAction::Watch),
                // If the collision is shown in two frames, no key switches to another frame.
                [hit, ..] => {
                    let watched = watched(hit).without_keys(&[Key::Char('f')]);
                    keys.with(watched, FigureAction::Watch)
                }
            },
            FigureState::Worked(worked) => worked.keys(&self.collision),
            FigureState::Foil(plot) => keys.with(plot.keys(), Foil),
            FigureState::Plain | FigureState::Film(_) => keys,
        }
    }

    pub(super) fn act(&mut self, action: FigureAction) {
        match (action, &mut self.state) {
            (FigureAction::Alpha(by) | FigureAction::Dial(by), _) => {
                self.set_dial(|dial| dial.stepped(by));
            }
            (FigureAction::AlphaEnd(end) | FigureAction::DialEnd(end), _) => {
                self.set_dial(|dial| dial.at(end.into()));
            }
            (action, FigureState::Worked(worked)) => worked.act(action, &mut self.collision),
            (FigureAction::Watch(action), FigureState::Hits(hits)) => {
                hits.iter_mut().for_each(|watch| watch.act(action));
            }
            (FigureAction::Foil(action), FigureState::Foil(plot)) => plot.act(action),
            _ => {}
        }
    }

    /// The impact angle in degrees.
    pub(super) fn alpha_deg(&self) -> f64 {
        tidy(self.collision.alpha().map_or(0.0, deg_from_rad))
    }

    /// Handles the mouse over the picture, where `rays` can be turned; returns whether the mouse
    /// was used.
    pub(super) fn mouse(
        &mut self,
        mouse: &Mouse,
        area: Rect,
        rays: Option<&mut RayInput>,
        look: &Look,
    ) -> bool {
        let (cell, held) = (mouse.cell(), mouse.is_held());
        let pressed = mouse.kind == MouseKind::Down;
        if let Some(rays) = rays {
            if held {
                point_at(area, &self.collision, rays, mouse.place(), pressed);
            }
            return held;
        }
        if let FigureState::Foil(plot) = &mut self.state {
            return plot.mouse(mouse, area);
        }
        let watched = match &self.state {
            FigureState::Plain | FigureState::Film(_) if held => {
                let collision = &self.collision;
                let value = match self.figure.kind {
                    FigureKind::Triangle { step } => {
                        triangle::alpha_at(collision, step, area, cell)
                    }
                    kind @ (FigureKind::Angles | FigureKind::Curves | FigureKind::Energy) => {
                        curves::alpha_at(kind, collision, area, look, cell)
                    }
                    // Other dials run from the left edge of the picture to the right edge.
                    _ => {
                        let share = f64::from(cell.0 - area.x) / f64::from(area.width.max(2) - 1);
                        self.dial().map(|dial| dial.at(share))
                    }
                };
                return value.is_some_and(|value| self.set_dial(|_| value));
            }
            FigureState::Hits(_) => match mouse.kind {
                MouseKind::ScrollUp => Some(Key::Char('.')),
                MouseKind::ScrollDown => Some(Key::Char(',')),
                MouseKind::Down => Some(Key::Char(' ')),
                _ => None,
            },
            FigureState::Worked(_) if pressed => {
                self.act(FigureAction::Step(1));
                return true;
            }
            _ => None,
        };
        let action = watched.and_then(|key| self.keys().find(key));
        action.is_some_and(|action| {
            self.act(action);
            true
        })
    }

    pub(super) fn advance(&mut self, passed: Duration, pace: HitPace) {
        match &mut self.state {
            FigureState::Hits(hits) => {
                hits.iter_mut()
                    .for_each(|watch| watch.advance(passed, pace));
            }
            FigureState::Foil(plot) => plot.advance(),
            _ => {}
        }
    }

    /// The time until the figure must next be advanced.
    pub(super) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match &self.state {
            _ if self.hidden => None,
            FigureState::Hits(hits) => hits.iter().find_map(|watch| watch.wake(pace)),
            FigureState::Foil(plot) => plot.wake(),
            _ => None,
        }
    }

    /// Draws the figure, with the predicted rays.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, look: &Look, rays: Option<&RayInput>) {
        for picture in self.lay_out(area, buf, look, rays) {
            picture.draw(buf, look);
        }
    }

    /// Writes the text of the figure, and returns its pictures.
    fn lay_out(
        &self,
        area: Rect,
        buf: &mut Buffer,
        look: &Look,
        rays: Option<&RayInput>,
    ) -> Vec<Picture> {
        let collision = &self.collision;
        if self.hidden && self.covers_outcome() {
            let given = Markings {
                offset: self.figure.shot.is_by_offset(),
                angle: !self.figure.shot.is_by_offset(),
                figures: true,
            };
            let faces = Face::STRIKER_AND_COIN;
            return vec![setup_picture(area, faces, collision, given, rays)];
        }
        let figure = FigureArea {
            area,
            buf,
            look,
            hidden: self.hidden,
        };
        match (&self.state, self.figure.kind) {
            (FigureState::Hits(hits), FigureKind::Frames) => frames::lay_out(hits, figure),
            (FigureState::Hits(hits), _) => hits.iter().map(|watch| watch.picture(area)).collect(),
            (_, FigureKind::Triangle { step }) => {
                vec![triangle::lay_out(collision, step, figure)]
            }
            (FigureState::Foil(plot), _) => vec![plot.picture(area, look)],
            (FigureState::Film(film), _) => vec![film.lay_out(figure)],
            (_, FigureKind::Foil { .. }) => vec![foil::picture(area)],
            (_, FigureKind::Shots { space, beyond_deg }) => {
                vec![shots::lay_out(space, beyond_deg, figure)]
            }
            (_, FigureKind::Force { time_ms }) => {
                vec![ContactForce::new(collision, time_ms).lay_out(figure)]
            }
            (_, kind @ (FigureKind::Coalesce | FigureKind::Explosion { .. })) => {
                vec![momenta::lay_out(kind, collision, figure)]
            }
            (_, FigureKind::Parts) => vec![parts::lay_out(collision, figure)],
            // A worked solution is text.
            (FigureState::Worked(_), _) => vec![],
            (_, kind) => curves::curves_and_hit(kind, collision, area, look).into(),
        }
    }
}

/// The lines n and t and, unless only the `lines` are to be shown, the components of u.
fn split_layers(lines: bool) -> Overlays {
    use Overlay::{Angles, Split, Trails, Triangle, Velocities};
    let mut layers = Overlays::default().without([Velocities, Angles, Triangle, Trails]);
    if !lines {
        layers.toggle(Split);
    }
    layers
}

/// Why a figure cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct FigureError(String);

/// Draws a figure from a description such as `curves alpha_deg=30`, as an SVG picture.
///
/// # Errors
/// Returns what was expected in the description.
pub fn draw_figure(words: &str, look: &Look) -> Result<String, FigureError> {
    let figure = Figure::from_words(words).map_err(FigureError)?;
    Ok(svg_of(&LiveFigure::new(figure, None, false), look))
}

/// A figure in its current state, as an SVG picture.
pub(super) fn svg_of(shown: &LiveFigure, look: &Look) -> String {
    svg::of_panel(&shown.title(), look, |area, cells| {
        shown.lay_out(area, cells, look, None)
    })
}
