//! After the last question: the final scores, the class's misconceptions, and the results of each
//! question.

use strum::{EnumMessage, FromRepr, IntoStaticStr};

use super::stage::Stage;
use super::{ClassAction, RoundAction, scores};
use crate::class::{ClassRound, ItemAnalysis, WayOfVoting, answer_name, beliefs, items};
use crate::messages::Key;
use crate::numbers::fixed;
use crate::progress::words::percent;
use crate::quiz::Question;
use crate::screens::View;
use crate::widgets::Role;
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;
use crate::widgets::panels::Heading;

/// A page after the last question.
#[derive(Debug, Clone, Copy, PartialEq, Eq, FromRepr)]
pub(super) enum EndPage {
    /// The scoreboard.
    Board,
    /// The class's misconceptions.
    Held,
    /// The results of each question.
    Items,
}

/// What the keys do after the last question.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum EndAction {
    /// go to the previous or next page
    TurnPage(isize),
}

impl EndPage {
    /// The keys that turn the pages.
    pub(super) fn keys() -> KeyTable<EndAction> {
        let keys = KeyTable::new("class");
        keys.by([Key::Left, Key::Right], EndAction::TurnPage, [-1, 1], "")
    }

    /// The page `by` pages after this one; the first or the last page if there is no such page.
    pub(super) fn turned(self, by: isize) -> Self {
        let to = (self as usize).saturating_add_signed(by);
        Self::from_repr(to).unwrap_or(Self::Items)
    }

    pub(super) fn view(self, play: &Stage) -> View<'_, ClassAction> {
        let mut panel = Panel::new("");
        // Each page has a `subject` of its own, except the scoreboard, which keeps the last
        // question's.
        panel.subject = usize::MAX - self as usize;
        match self {
            Self::Board => return board(play),
            Self::Held => write_held(play.round(), &mut panel),
            Self::Items => write_items(play.round(), &mut panel),
        }
        View::text(panel)
    }
}

/// The final scoreboard.
fn board(play: &Stage) -> View<'_, ClassAction> {
    let handed = match play.session.handed_in() {
        0 => String::new(),
        handed => format!("{handed} handed in their own answers."),
    };
    let mut foot = Panel::new("");
    foot.prompt(
        "write a report, and tables for a spreadsheet",
        ClassAction::Round(RoundAction::Tables),
    );
    scores::view(play, Heading::new(&["The end"], handed)).with_foot(foot)
}

fn write_held(round: &ClassRound, panel: &mut Panel<ClassAction>) {
    panel.large(["Your beliefs", "Beliefs"], LARGE_FROM);
    panel.gap();
    let held = beliefs(round);
    if held.is_empty() {
        panel.paragraph(
            "No vote fits a known misconception. That is rare, and good.",
            Role::Text,
        );
        return;
    }
    let about = match round.way() {
        WayOfVoting::Teams => {
            "Teams whose votes show the belief, before and after the discussion. A team is counted \
             only if two questions show it. Below: the number of votes that fit it."
        }
        WayOfVoting::Devices => {
            "How many of you show the belief in your votes, before and after the discussion. You \
             are counted only if two questions show it. Below: the number of votes that fit it."
        }
        WayOfVoting::Tally => {
            "The number of votes that fit the belief, before and after the discussion."
        }
    };
    panel.paragraph(about, Role::Dim);
    for it in held {
        panel.gap();
        let [first, second] = it.teams;
        let teams = match it.teams {
            [0, 0] => String::new(),
            _ => format!("{first}, then {second}"),
        };
        panel.pair((it.misconception.name(), Role::Title), (teams, Role::Title));
        let [first, second] = it.votes;
        panel.line(format!("votes: {first}, then {second}"), Role::Dim);
        panel.paragraph(it.misconception.advice(), Role::Text);
    }
}

fn write_items(round: &ClassRound, panel: &mut Panel<ClassAction>) {
    panel.large(["Questions"], LARGE_FROM);
    panel.gap();
    for heads in [
        ["right", "", "degrees off", "", "tells"],
        ["first", "then", "first", "then", "apart"],
    ] {
        panel.columns(("", Role::Dim), heads.map(|head| (head, Role::Dim)));
    }
    for item in items(round, round.questions().len()) {
        let Some(question) = round.questions().get(item.question) else {
            continue;
        };
        let [first, then] = item.votes.map(|it| percent(it.share_right()));
        let [first_off, then_off] = item.votes.map(|it| {
            let spread = it.spread_deg();
            spread.map_or("-".into(), |[mean, _]| fixed(mean, 1))
        });
        let apart = item.discrimination.map_or("-".into(), |it| fixed(it, 2));
        let name = format!("{} {}", item.question + 1, question.topic.name());
        let values = [first, then, first_off, then_off, apart];
        panel.columns((name, Role::Title), values.map(|it| (it, Role::Title)));
        panel.item(summary(question, &item), Role::Text);
        if let Some((misconception, count)) = item.commonest {
            panel.item(format!("{}: {count}", misconception.name()), Role::Text);
        }
    }
    panel.gap();
    panel.paragraph(
        "\"right\": how many votes were right. \"degrees off\": the mean error of angles; for two \
         rays the larger error counts. \"tells apart\": how well a question separates those \
         with the better results from the others, -1 to 1; it requires ten teams or pupils. \
         \"gain\": the share of the possible improvement that the discussion achieved.",
        Role::Dim,
    );
}

/// "A: 4 then 2; B: 17 then 19. gain 50 %. changed from wrong to right: 3, from right to wrong: 1"
fn summary(question: &Question, item: &ItemAnalysis) -> String {
    let counts = item.counts.iter().map(|(said, [first, second])| {
        let name = answer_name(question, said);
        format!("{name}: {first} then {second}")
    });
    let counts: Vec<String> = counts.take(MOST_COUNTS).collect();
    let mut summary = vec![counts.join("; ")];
    if let Some(gain) = item.gain {
        summary.push(format!("gain {:.0} %", 100.0 * gain));
    }
    if let Some([right, wrong]) = item.changed {
        summary.push(format!(
            "changed from wrong to right: {right}, from right to wrong: {wrong}"
        ));
    }
    summary.retain(|it| !it.is_empty());
    summary.join(". ")
}

/// A panel with at least this number of rows has its title in large letters.
const LARGE_FROM: u16 = 19;

/// The maximum number of answers that are listed with their counts.
const MOST_COUNTS: usize = 5;
