//! The carrom command.

fn main() {}
