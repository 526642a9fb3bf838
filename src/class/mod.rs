//! A round for a class: the participants, two votes per question, scores, the results of each
//! question, and tables for the teacher.
//!
//! Each question is asked twice: everyone predicts in silence and votes; then the class discusses
//! the question and may change its votes (E. Mazur, *Peer Instruction*, 1997). Both votes are
//! saved; the later one is scored, always by accuracy and never by speed.
//!
//! A class votes in one of three ways ([`WayOfVoting`]): up to eight teams at one keyboard; hands
//! or cards that are counted (a tally: counts for the choices of [`ClassRound::choices`], set by
//! [`ClassRound::count`]); or up to 250 people on their own devices. The methods on votes
//! ([`ClassRound::said`], [`ClassRound::results`], [`ClassRound::clues`], [`ClassRound::voted`])
//! are the same for all three: a counted hand is a vote like any other. A tally lacks only what
//! requires a name (ballots, points, standings).
//!
//! Every change to the participants or the votes is a [`ClassChange`] ([`ClassRound::change`]). A
//! file of a round contains an earlier state and the changes since then, so a vote from a device is
//! saved by appending it.
//!
//! This module does not use the network: people join and leave through changes.

mod advice;
mod asked;
mod ballot;
mod beliefs;
mod device;
mod host;
mod items;
mod join_code;
mod limits;
mod names;
mod nicknames;
mod old_formats;
mod people;
pub mod protocol;
mod pupil_view;
mod round;
mod saved;
mod scores;
mod session;
mod step;
mod tables;
mod tally;
mod way;

pub use advice::Advice;
pub use asked::{AskedQuestion, RevealedTruth};
pub(crate) use ballot::feedback;
pub use ballot::{Ballot, Said, Vote};
pub(crate) use beliefs::{ClassBelief, beliefs};
pub use device::ConnectionId;
pub use host::{HostCall, HostNews, JoinDetails, Newcomer};
pub(crate) use items::answer_name;
pub use items::{ItemAnalysis, items};
pub use join_code::{JoinCode, NoJoinCode, SeatToken};
pub use limits::{Allowance, Bucket, CodeVerdict, GuardedCode};
pub(crate) use names::is_same_class;
pub use names::{LONGEST_NAME, MOST_PEOPLE, MOST_TEAMS, NameTrouble, team_names};
pub(crate) use nicknames::is_nickname;
pub use round::{ClassChange, ClassRound, Participant, appended};
pub use scores::{Standing, standings};
pub use session::{HandInOnItsWay, Session, SessionEffect};
pub use step::{ClassPlace, ClassStep};
pub use tables::{answers_csv, items_csv};
pub use way::WayOfVoting;
