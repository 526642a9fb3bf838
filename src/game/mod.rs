//! Carrom itself: pieces, the pack, placing the striker, the laws and the score.
//!
//! A pure module: no screen and no clock. A [`Stroke`] is data, [`Game::apply`] returns
//! [`Ruling`]s, and a game is a plain value: to undo a stroke, keep a copy of the game. Two
//! parts use the engine: a [`Record`], to replay its moves, and the opponent, to simulate shots.
//!
//! | file | contents |
//! |---|---|
//! | `pieces` | pieces, sets, the lines on the board |
//! | `pack` | the opening pack |
//! | `seat` | seats, teams, the order of turns |
//! | `placing` | where the striker may be placed |
//! | `steps` | the steps in which a stroke is set |
//! | `free_place` | where a coin is put back |
//! | `stroke` | the facts about a stroke that the laws use |
//! | `laws` | the referee's decisions |
//! | `score` | points, boards, games, the match |
//! | `play` | one board, from the break to its end |
//! | `table` | a whole game at the table |
//! | `validity` | the requests that a game refuses |
//! | `record` | a game move by move, for a bit-for-bit replay |
//! | `saved` | a record as a file, with who plays |
//! | `solo` | boards for one player, each from a code |
//! | `results` | what a player won and lost, from the saved games |
//! | `opponent` | the computer opponent, and hints for the player |

pub(crate) mod free_place;
pub(crate) mod laws;
pub mod opponent;
pub(crate) mod pack;
pub(crate) mod pieces;
pub(crate) mod placing;
mod play;
mod record;
mod results;
mod saved;
mod score;
mod seat;
mod solo;
pub(crate) mod steps;
mod stroke;
mod table;
mod validity;

pub use laws::{BoardWon, Rules, Ruling, RulingEffect};
pub(crate) use laws::{RuleLine, announced};
pub(crate) use pieces::PieceSet;
pub use pieces::{Coin, Colour, Piece};
pub(crate) use placing::{BaseLines, Stand};
pub use record::{Call, Move, Record, Strike};
pub(crate) use record::{MoveError, RecordError};
pub(crate) use results::Results;
pub use saved::{Aids, Company, Fingerprint, Player, SavedGame, SeatNames, is_player_name};
pub use score::Length;
pub(crate) use seat::ByTeam;
pub use seat::{Hands, Seat, Team};
pub use solo::BoardCode;
pub use stroke::Stroke;
pub use table::{Game, GameSetup, GameStage};
