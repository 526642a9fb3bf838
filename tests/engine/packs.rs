//! The built-in levels can be won, but not by chance.

use std::collections::BTreeSet;
use std::process::Command;

use carrom::files::FileLibrary;
use carrom::levels::{Level, LevelLibrary, Trial, winning_share};

fn levels() -> Vec<Level> {
    let library = LevelLibrary::embedded();
    assert_eq!(library.problems, []);
    library
        .packs
        .into_iter()
        .flat_map(|pack| pack.levels)
        .collect()
}

#[test]
fn there_are_at_least_forty_levels_in_the_expected_packs() {
    assert!(levels().len() >= 40);
    let packs = LevelLibrary::embedded().packs;
    let names: Vec<_> = packs.iter().map(|pack| pack.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "first-hits",
            "right-angle",
            "speeds-and-shares",
            "unequal-masses",
            "off-centre",
            "weighing",
            "energy-lost",
            "cushions",
            "combinations",
            "design",
            "two-ideas",
            "impulse-and-energy",
        ]
    );
}

/// An id opens a level from the command line, so ids must be unique across all packs.
#[test]
fn no_two_levels_share_an_id_or_a_title() {
    let levels = levels();
    let ids: BTreeSet<_> = levels.iter().map(|level| &level.id).collect();
    assert_eq!(ids.len(), levels.len());
    let titles: BTreeSet<_> = levels.iter().map(|level| &level.title).collect();
    assert_eq!(titles.len(), levels.len());
}

#[test]
fn every_level_has_hints_in_stages_and_an_explanation() {
    for level in levels() {
        assert!(level.hints.len() >= 2, "{}", level.id);
        assert!(level.explanation.len() > 150, "{}", level.id);
    }
}

#[test]
fn the_stored_solution_wins_and_the_initial_aim_does_not() {
    for level in levels() {
        let trial = Trial::of(&level).unwrap();
        assert!(trial.verdict.won(), "{}: {:?}", level.id, trial.verdict);
        assert!(!trial.opens_won, "{}", level.id);
    }
}

#[test]
fn the_stored_solution_can_be_reached_by_key_presses() {
    for level in levels() {
        for (dial, _) in level.adjust.dials() {
            let way = level.solution.get(dial) - level.start().get(dial);
            let presses = way / dial.step();
            assert!(
                (presses - presses.round()).abs() < 1e-9,
                "{}: {dial:?}",
                level.id
            );
        }
    }
}

#[test]
fn few_aims_win_but_not_too_few() {
    for level in levels() {
        let share = winning_share(&level, 4000);
        assert!((0.001..0.2).contains(&share), "{}: {share}", level.id);
    }
}

#[test]
fn level_check_finds_no_problem() {
    let output = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["level", "check"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(output.stderr, b"");
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), levels().len());
    assert!(text.lines().all(|line| line.contains(": won: ")));
}
