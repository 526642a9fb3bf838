//! The view of a level: the board or an impact, and beside it the goals and dials, the predicted
//! rays, the result and the explanation.

use super::made_shot::{MadeShot, asked};
use super::{LevelAction, LevelPhase, LevelPlay, PendingShot, board};
use crate::levels::{FEW_SHOTS, Level, LevelAim, Win};
use crate::numbers;
use crate::physics::units::g_from_kg;
use crate::quiz::{Ray, why};
use crate::screens::levels::words;
use crate::screens::{Context, View};
use crate::widgets::hit::{CONTACT, Watch, contact_picture};
use crate::widgets::input::SettingsForm;
use crate::widgets::panel::Panel;
use crate::widgets::panels::{reason, said_and_true};
use crate::widgets::replay::{ImpactPrediction, ShotAction, ShotImpact};
use crate::widgets::{RayInput, Role};

/// The number of earlier shots that are listed while the next one is being set.
const SHOWN_EARLIER: usize = 2;

type LevelPanel = Panel<LevelAction>;

/// The board or an enlarged impact, and the panel beside it.
pub(super) fn view<'s>(play: &'s LevelPlay, cx: &Context) -> View<'s, LevelAction> {
    let level = play.level();
    let panel = panel(play, cx);
    let view = match &play.phase {
        LevelPhase::Aim => {
            let scene = level.aimed(&play.dials.aim);
            let board = move |area| board::of_aim(level, &scene, play.dials.met, area);
            let impact = play.dials.met.and_then(|met| met.impact);
            let contact = impact.map(|impact| {
                let faces = words::faces(&level.scene, &impact);
                move |area| contact_picture(area, faces, &impact.collision)
            });
            View::drawn("aim", board, panel)
                .with_inset(CONTACT, contact)
                .dragging(play.dials.drag_words())
        }
        LevelPhase::Predict(pending) => {
            let prediction = &pending.prediction;
            let faces = words::faces(&level.scene, &prediction.impact);
            let hit = move |area| prediction.picture(faces, area);
            return View::drawn("where will they go?", hit, panel).dragging(RayInput::DRAG);
        }
        LevelPhase::Watch(made) => {
            if let Some(watch) = made.player.zoom() {
                return View::drawn(watch.slowed_title(), |area| watch.picture(area), panel);
            }
            let title = match made.is_shown {
                true => "a shot that wins".into(),
                false => format!("shot {}", play.shots),
            };
            View::drawn(title, |area| board::of_made(level, made, area), panel)
        }
    };
    // A collision fills the area; a board is square.
    match level.is_of_the_first_hit() {
        true => view,
        false => view.square(),
    }
}

fn panel(play: &LevelPlay, cx: &Context) -> LevelPanel {
    let mut panel = match &play.phase {
        LevelPhase::Aim => aim(play, cx),
        LevelPhase::Predict(pending) => say(play, pending),
        LevelPhase::Watch(made) => match made.player.zoom() {
            Some(watch) => enlarged(play, made, watch),
            None if made.watched => outcome(play, made, cx),
            None => watching(play, made),
        },
    };
    panel.subject = play.shots as usize;
    panel
}

/// The goals, below the level's title.
fn goals(play: &LevelPlay) -> LevelPanel {
    let mut panel = Panel::new(&play.level().title);
    panel.heading("Goal");
    for goal in &play.level().goals {
        panel.paragraph(goal.describe(&play.level().scene), Role::Text);
    }
    panel.gap();
    panel
}

fn aim(play: &LevelPlay, cx: &Context) -> LevelPanel {
    let mut panel = goals(play);
    panel.part(LevelAction::Set, |panel| {
        play.form.write(&play.dials, panel);
        play.form.write_about(&play.dials, panel);
    });
    write_masses(play.level(), &play.dials.aim, &mut panel);
    panel.gap();
    panel.warning(play.trouble.as_deref().or(play.guard.refusal()));
    panel.gap();
    let says = !play.level().say_first.is_empty();
    let set = LevelAction::Set(SettingsForm::SET);
    let shoot = ("shoot", LevelAction::Go);
    panel.prompts(match (says, cx.settings.predict) {
        _ if play.form.is_typing() => vec![("set it", set)],
        (true, true) => vec![("predict both paths", LevelAction::Go)],
        (true, false) => vec![shoot, ("predict", LevelAction::Predict)],
        (false, _) => vec![shoot],
    });
    let hidden = play.earlier.len().saturating_sub(SHOWN_EARLIER);
    for [set, result] in play.earlier.iter().skip(hidden) {
        panel.gap();
        panel.line(set, Role::Dim);
        panel.paragraph(result, Role::Dim);
    }
    if !play.earlier.is_empty() {
        panel.gap();
    }
    hints(play, &mut panel);
    panel
}

/// Writes the mass of the disc that is shot, and the masses of the others.
fn write_masses(level: &Level, aim: &LevelAim, panel: &mut LevelPanel) {
    let scene = level.aimed(aim);
    let (mut shot, mut others) = (String::new(), Vec::new());
    for (disc, piece) in scene.pieces.iter().enumerate() {
        let mass = match level.unknown_mass.contains(&disc) {
            true => "?".into(),
            false => format!("{:.1}", g_from_kg(piece.disc.mass)),
        };
        if disc == scene.stroke.disc {
            shot = mass;
        } else if !others.contains(&mass) {
            others.push(mass);
        }
    }
    if !others.is_empty() {
        panel.fact("masses", format!("{shot} on {} g", others.join(", ")));
    }
}

/// The hints shown so far, and the prompt for the next or, after the last, for the solution.
fn hints(play: &LevelPlay, panel: &mut LevelPanel) {
    let all = &play.level().hints;
    for (number, hint) in all.iter().take(play.hints).enumerate() {
        panel.gap();
        panel.heading(format!("Hint {} of {}", number + 1, all.len()));
        panel.paragraph(hint, Role::Text);
    }
    if play.hints == 0 {
        panel.prompt("a hint", LevelAction::Hint);
    } else if play.hints < all.len() {
        panel.gap();
        panel.prompt("another hint", LevelAction::Hint);
    } else {
        panel.gap();
        panel.prompt("show me a shot that wins", LevelAction::ShowMe);
    }
}

fn say(play: &LevelPlay, pending: &PendingShot) -> LevelPanel {
    let mut panel = Panel::new("predict it");
    let ImpactPrediction { impact, rays } = &pending.prediction;
    let name = words::short(&play.level().scene, impact.discs[1]);
    let unknown = &play.level().unknown_mass;
    let is_secret = impact.discs.map(|disc| unknown.contains(&disc));
    pending.prediction.write_facts(is_secret, &mut panel);
    panel.gap();
    panel.heading("The first hit");
    panel.part(LevelAction::Say, |panel| {
        rays.write_all(panel, name, "shoot!");
    });
    panel
}

fn watching(play: &LevelPlay, made: &MadeShot) -> LevelPanel {
    let mut panel = goals(play);
    let clock = made.player.clock();
    panel.fact("time", format!("{:.2} s", clock.time()));
    panel.fact("watched at", clock.rate.words());
    panel.gap();
    let go_on = LevelAction::Watch(ShotAction::GoOn);
    panel.prompt("go on, or skip to the end", go_on);
    panel
}

fn outcome(play: &LevelPlay, made: &MadeShot, cx: &Context) -> LevelPanel {
    let mut panel = Panel::new(match (&made.win, made.is_shown) {
        (_, true) => "shown",
        (Some(_), _) => "won",
        (None, _) => "not yet",
    });
    match &made.win {
        None if made.is_shown => {
            let setting = play.dials.words_of(&play.level().solution);
            let text = format!("This shot wins: {setting}. It was shown to you and earns no star.");
            panel.paragraph(text, Role::Title);
        }
        Some(win) => {
            let won = match play.hints {
                0 => "Won!".into(),
                hints => format!("Won, with {}!", numbers::counted(hints, "hint")),
            };
            panel.pair((won, Role::Good), (words::stars(win.stars()), Role::Good));
        }
        None => {
            let (met, all) = (made.verdict.met(), play.level().goals.len());
            let cheer = match met {
                0 => "Not yet. See what was off, then change one thing at a time.".into(),
                _ => format!("Not yet, but you have met {met} of {all} goals: you are on the way."),
            };
            panel.paragraph(cheer, Role::Title);
        }
    }
    panel.gap();
    for finding in &made.verdict.findings {
        let (mark, role) = match finding.met {
            true => ("✓ ", Role::Good),
            false => ("✗ ", Role::Warn),
        };
        panel.marked(mark, format!("{}.", numbers::capital(&finding.text)), role);
    }
    if let Some(impact) = made.player.impacts().first() {
        answers(play, made, impact, &mut panel);
    }
    panel.gap();
    match &made.win {
        Some(win) => won(play, *win, &mut panel, cx),
        None if made.is_shown => {
            panel.paragraph(&play.level().explanation, Role::Text);
            panel.gap();
            panel.prompt("play it yourself", LevelAction::AimAgain);
        }
        None => {
            panel.prompt("try again from the same aim", LevelAction::AimAgain);
            if !made.player.impacts().is_empty() {
                let look = LevelAction::Watch(ShotAction::Impacts);
                panel.prompt("look at the hit, enlarged", look);
            }
            hints(play, &mut panel);
        }
    }
    panel
}

/// Writes the explanation, how to earn more stars, and the next step.
fn won(play: &LevelPlay, win: Win, panel: &mut LevelPanel, cx: &Context) {
    panel.paragraph(&play.level().explanation, Role::Text);
    panel.gap();
    if !win.has_few_shots() {
        let text = format!("One more star: win with at most {FEW_SHOTS} shots and no hint.");
        panel.paragraph(text, Role::Dim);
    }
    if !win.is_accurate() {
        let text = match win.said_right {
            Some(_) if cx.settings.predict => "One more star: predict the paths within 4°.",
            Some(_) => "One more star: predict the paths first.",
            None => "One more star: win with the first shot.",
        };
        panel.paragraph(text, Role::Dim);
    }
    let next = match play.number + 1 < cx.shelf.count() {
        true => "the next level",
        false => "back to the list: that was the last level!",
    };
    panel.prompt(next, LevelAction::NextLevel);
}

/// The prediction beside the true directions.
fn answers(play: &LevelPlay, made: &MadeShot, impact: &ShotImpact, panel: &mut LevelPanel) {
    let Some(said) = &made.said else {
        return;
    };
    panel.gap();
    let mut names = [None; 2];
    for ray in asked(said) {
        let body = usize::from(ray == Ray::Target);
        names[body] = Some(words::short(&play.level().scene, impact.discs[body]));
    }
    said_and_true(&impact.collision, &said.so_far(), names, false, panel);
}

/// One impact, enlarged, explained as in the lab.
fn enlarged(play: &LevelPlay, made: &MadeShot, watch: &Watch) -> LevelPanel {
    let Some((number, impact)) = made.player.chosen() else {
        return Panel::new("");
    };
    let count = made.player.impacts().len();
    let mut panel = Panel::new(format!("impact {} of {count}", number + 1));
    let scene = &play.level().scene;
    let [first, second] = impact.discs.map(|disc| scene.name(disc));
    let met = numbers::capital(&format!("{first} on {second}"));
    panel.paragraph(met, Role::Title);
    // Nothing is hidden in a shot that won, or in one that carrom played to show a solution.
    let may_hide = made.win.is_none() && !made.is_shown;
    let unknown = &play.level().unknown_mass;
    let is_secret = impact.discs.map(|disc| may_hide && unknown.contains(&disc));
    if !watch.write_facts(is_secret, &mut panel) {
        return panel;
    }
    let said = made.said.as_ref().filter(|_| number == 0);
    if said.is_some() {
        answers(play, made, impact, &mut panel);
    }
    panel.gap();
    if is_secret.contains(&true) {
        let text = "One mass here is unknown. The angles of the first collision give it: with no \
                    energy lost, m₁ / m₂ = sin(θ₁ + 2 θ₂) / sin θ₁.";
        panel.paragraph(text, Role::Text);
    } else {
        let why = why(&impact.collision, said.and_then(RayInput::both));
        reason(&why, &mut panel);
    }
    panel
}
