//! A round for a class round one screen: teams, two votes a question, scores, what each
//! question showed, and the tables a teacher takes home.
//!
//! Each question is asked twice: everyone predicts in silence and votes, the teams talk,
//! and may change their vote (E. Mazur, *Peer Instruction*, 1997). Both votes are kept;
//! the second one scores, by how near it is and never by how fast it came.

mod ballot;
mod items;
mod names;
mod saved;
mod scores;
mod step;
mod tables;

pub use ballot::{Ballot, ClassRound, Vote};
pub use items::{ItemAnalysis, Spread, items};
pub use names::{LONGEST_NAME, MOST_TEAMS, NameTrouble, team_names};
pub use scores::{Standing, standings};
pub use step::{ClassPlace, ClassStep};
pub use tables::{answers_csv, items_csv};
