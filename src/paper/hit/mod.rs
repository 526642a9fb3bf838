//! The picture of a hit, for worksheets and explanations.

mod after;
mod aim;
mod before;
mod measures;
mod placing;
mod seen;
mod sheet;
mod stage;
#[cfg(test)]
mod tests;

use super::Svg;
use crate::physics::Collision;
use crate::quiz::AimTask;
use sheet::Sheet;
use stage::Stage;

/// What the picture of a hit shows beside the two discs and their ways to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Shown {
    /// The offset b, from the striker's line of motion to the target's centre.
    pub offset: bool,
    /// The impact angle α, from the striker's line of motion to the line of impact;
    /// that line is then shown too. Nothing for a miss, which has none.
    pub angle: bool,
    /// The line of impact, through both centres at contact.
    pub line_of_impact: bool,
    /// The masses, upon the discs.
    pub masses: bool,
    /// Whether b, α, θ₁ and θ₂ have their values with them: "α = 30.0°" and not "α".
    pub numbers: bool,
    /// Whether the velocities have theirs: "u = 4.00 m/s" and not "u".
    pub speeds: bool,
    /// What is shown of the time after the hit.
    pub after: After,
}

/// What the picture of a hit shows of the time after it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum After {
    /// Nothing.
    #[default]
    Nothing,
    /// A protractor round the striker's place at contact, empty, into which both rays
    /// can be drawn with a pencil. Both departures begin in its middle: the target's,
    /// too, runs along the line through both centres.
    Space,
    /// Both departures as arrows, with θ₁ and θ₂ measured from the striker's line of
    /// motion, and a square corner where they part at a right angle.
    Departures,
}

/// Draws a hit, seen from above: the discs before they meet, the striker's (or both)
/// place at contact in dashes, and what is [`Shown`]. x is to the right and y up.
///
/// The letters are those of the lessons: u before, v after, b, α, θ₁ and θ₂. Letters are
/// of one size whatever the hit, so the picture is as large as it needs to be: some 6 to
/// 12 cm wide. A miss is drawn as one, with the discs where they are nearest.
#[must_use]
pub fn hit_picture(collision: &Collision, shown: &Shown) -> Svg {
    draw(collision, shown).picture()
}

/// Draws a hit as somebody has seen it: both discs at contact, the ways they came and
/// went with θ₁ and θ₂. All arrows are of one length, so that nothing tells of masses
/// and speeds.
#[must_use]
pub fn seen_picture(collision: &Collision) -> Svg {
    draw_seen(collision).picture()
}

/// Draws a shot whose offset is to be chosen: the striker on its way, a scale of offsets
/// in millimetres across it, true to the size of the discs, and the way that one of the
/// two is to go.
#[must_use]
pub fn aim_picture(aim: &AimTask) -> Svg {
    draw_aim(aim).picture()
}

fn draw_seen(collision: &Collision) -> Sheet {
    let shown = Shown {
        numbers: true,
        after: After::Departures,
        ..Shown::default()
    };
    let stage = Stage::new(collision, &shown);
    let mut sheet = Sheet::new(&words(collision, &shown), stage.scale());
    seen::ways(&mut sheet, &stage);
    sheet.place_labels();
    sheet
}

fn draw_aim(aim: &AimTask) -> Sheet {
    let shown = Shown {
        numbers: true,
        speeds: true,
        ..Shown::default()
    };
    let stage = Stage::new(&aim.with(0.0), &shown).nearer();
    let words = "A striker on its way to a disc at rest, a scale of offsets across the way, \
                 and where one of the two is to go, seen from above";
    let mut sheet = Sheet::new(words, aim::LARGER * stage.scale());
    aim::shot(&mut sheet, &stage, aim);
    sheet.place_labels();
    sheet
}

fn draw(collision: &Collision, shown: &Shown) -> Sheet {
    let stage = Stage::new(collision, shown);
    let mut sheet = Sheet::new(&words(collision, shown), stage.scale());
    measures::protractor(&mut sheet, &stage);
    before::lines(&mut sheet, &stage);
    before::discs(&mut sheet, &stage);
    measures::angle(&mut sheet, &stage);
    measures::offset(&mut sheet, &stage);
    after::departures(&mut sheet, &stage);
    before::velocities(&mut sheet, &stage);
    before::name_line(&mut sheet, &stage);
    sheet.place_labels();
    sheet
}

/// What is to be seen, without giving away what is not shown.
fn words(collision: &Collision, shown: &Shown) -> String {
    let meets = match collision.alpha() {
        Some(_) => "A striker meets",
        None => "A striker passes",
    };
    let target = if collision.u2.length() > 0.0 {
        "another moving disc"
    } else {
        "a disc at rest"
    };
    let after = match shown.after {
        After::Nothing => "",
        After::Space => ", with an empty protractor for where both go",
        After::Departures => ", and both go on",
    };
    format!("{meets} {target}{after}, seen from above")
}
