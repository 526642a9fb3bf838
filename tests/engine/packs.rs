//! The built-in levels can be won, but rarely by chance.

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

/// The share of aims that win measures the difficulty. Within a pack the share falls from level
/// to level, with few exceptions: the rank correlation is at least 0.9.
#[test]
fn the_share_of_winning_aims_is_small_and_falls_from_level_to_level() {
    for pack in LevelLibrary::embedded().packs {
        let shares = pack.levels.iter().map(|level| winning_share(level, 4000));
        let shares: Vec<f64> = shares.collect();
        for (level, share) in pack.levels.iter().zip(&shares) {
            assert!((0.001..0.2).contains(share), "{}: {share}", level.id);
        }
        let order = spearman_of_falling(&shares);
        assert!(order >= 0.9, "{}: {order} {shares:?}", pack.name);
    }
}

/// Spearman's correlation between the positions of these values and their ranks, the largest
/// first. Equal values keep their order.
fn spearman_of_falling(values: &[f64]) -> f64 {
    let mut ranked: Vec<usize> = (0..values.len()).collect();
    ranked.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let off = ranked.iter().enumerate();
    let squares: f64 = off
        .map(|(rank, at)| (rank as f64 - *at as f64).powi(2))
        .sum();
    let n = values.len() as f64;
    1.0 - 6.0 * squares / (n * (n * n - 1.0))
}

#[test]
fn the_correlation_is_one_for_falling_values_and_minus_one_for_rising_ones() {
    assert_eq!(spearman_of_falling(&[9.0, 4.0, 1.0]), 1.0);
    assert_eq!(spearman_of_falling(&[1.0, 4.0, 9.0]), -1.0);
    assert_eq!(spearman_of_falling(&[4.0, 9.0, 1.0]), 0.5);
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
