//! Questions, grading, misconceptions.
//!
//! A [`Round`] is ten [`Question`]s fixed by a seed. The player gives an [`Answer`]
//! to each: two rays and how sure they are. [`Grade`] says how far off the rays
//! are, [`diagnose`] which known misconception they fit, [`explain()`] why the discs
//! go where they go, and [`Summary`] looks back over the round.
//!
//! Nothing here draws, and nothing is random but what follows from the seed.

mod answer;
mod dice;
mod explain;
mod family;
mod grade;
mod kind;
pub mod misconceptions;
mod pieces;
mod question;
mod rays;
mod round;
mod summary;
pub mod words;

pub use answer::{Answer, Confidence};
pub use explain::{Explanation, explain, reasoning};
pub use family::Family;
pub use grade::{Grade, RIGHT_DEG, RayGrade};
pub use misconceptions::{Diagnosis, Fit, Misconception, diagnose};
pub use pieces::Pieces;
pub use question::{Given, Question};
pub use rays::{Ray, Rays};
pub use round::Round;
pub use summary::{Summary, SummaryLine};
