//! The families of the quiz over thousands of seeds: the true answer agrees with an independent
//! calculation, every misconception is recognized by its answer, and every text is readable.

mod both_moving;
mod centre_of_mass;
mod concept;
mod energy_share;
mod hit;
mod largest_deflection;
mod make_it_so;
mod owed;
mod restitution;
mod rutherford;
mod separation;
mod slip_or_stick;
mod speeds;
mod weigh;
mod where_to;
