//! The laws, one by one: each test is named after the law it checks, and plays a stroke on a board
//! set up for it.

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
