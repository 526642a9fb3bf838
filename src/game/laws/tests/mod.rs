//! Tests of the laws and the other rules. A test of one law is named after it, and plays strokes on
//! a board set up for it.

mod board_ends;
mod break_and_turn;
mod dues;
mod house_rules;
mod laying;
mod page;
mod points;
mod queen_and_cover;
mod validity;
mod whole_games;
