//! Checks that the page of rules names each law that the referee quotes.

use std::collections::BTreeSet;

use super::super::case::{QUEEN_POINTS, QUEEN_WORTHLESS_FROM};
use super::super::ending::MOST_POINTS;
use super::super::points::{POINTS_TO_WIN, QUEEN};
use super::super::{Case, Law, QueenBefore, RuleLine, Rules, Side, Taken, judge};
use crate::game::Colour;
use crate::game::score::{GAME_BOARDS, GAME_POINTS, MATCH_GAMES};

/// All combinations of these values.
fn pairs<A: Copy, B: Copy>(a: &[A], b: &[B]) -> Vec<(A, B)> {
    a.iter().flat_map(|a| b.iter().map(|b| (*a, *b))).collect()
}

/// The numbers of all laws that the referee can quote, found by judging every kind of stroke.
fn quoted() -> BTreeSet<String> {
    use QueenBefore::{Covered, OnBoard, ToCover};
    let both = [false, true];
    let counts = pairs(&[1, 2, 9], &[0, 1, 2, 9]);
    let fates = [
        OnBoard,
        ToCover,
        Covered(Colour::White),
        Covered(Colour::Black),
    ];
    let queens = pairs(&fates, &both);
    let strikers = pairs(&both, &pairs(&both, &[None, Some(0), Some(2)]));
    let debts = pairs(&both, &both);
    let mut laws: BTreeSet<_> = [
        Law::DUE_WAITS,
        Law::DUE_IS_PAID,
        Law::GAME,
        Law::EXTRA_BOARD,
        Law::MATCH,
    ]
    .map(|law| law.to_string())
    .into();
    for (
        (own, other),
        ((queen, queen_fell), ((striker_fell, (touched, break_tries)), (owes, may))),
    ) in pairs(
        &pairs(&counts, &counts),
        &pairs(&queens, &pairs(&strikers, &debts)),
    ) {
        let side = |(before, fell): (u8, u8)| Side {
            before,
            fell: fell.min(before),
            score: 0,
            taken: Taken::default(),
        };
        let case = Case {
            colour: Colour::White,
            own: side(own),
            other: side(other),
            queen,
            queen_fell,
            striker_fell,
            touched,
            break_tries,
            owes,
            may_take_queen: may,
        };
        laws.extend(
            judge(Rules::Tournament, &case)
                .law
                .map(|law| law.to_string()),
        );
    }
    laws
}

/// The rules of a page as one text.
fn text(rules: Rules) -> String {
    let lines = rules.page().map(|line| match line {
        RuleLine::Heading(text) | RuleLine::Rule(text) => text,
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_page_of_rules_has_every_law_that_the_referee_quotes() {
    let page = text(Rules::Tournament);
    let brackets = page
        .split('(')
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let laws = brackets.filter(|words| words.starts_with("law "));
    let named: BTreeSet<_> = laws
        .flat_map(|words| words.split([' ', ',']))
        .filter(|word| word.starts_with(|c: char| c.is_ascii_digit()))
        .map(str::to_owned)
        .collect();
    let quoted = quoted();
    assert!(quoted.len() > 30, "{quoted:?}");
    let missing: Vec<_> = quoted.difference(&named).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_numbers_on_the_page_of_rules_are_those_of_the_referee() {
    let page = text(Rules::Tournament);
    for expected in [
        format!("{QUEEN_POINTS} points for the queen"),
        format!("a score of {QUEEN_WORTHLESS_FROM} points upwards"),
        format!("more than {MOST_POINTS} points"),
        format!("A game is played to {GAME_POINTS} points"),
        format!("first side to win {MATCH_GAMES} games"),
    ] {
        assert!(page.contains(&expected), "{expected}");
    }
    assert_eq!(GAME_BOARDS, 8, "the page says: after eight boards");
    assert!(text(Rules::Friendly).contains(&format!("{QUEEN_POINTS} points for the queen")));
    let all = Taken { white: 9, black: 9 };
    let page = text(Rules::Points);
    for expected in [
        format!("the queen, the red coin, {QUEEN} points"),
        format!("worth {} points", all.points(true)),
        format!("with {POINTS_TO_WIN} points, more than half"),
        format!("each side has {} points", all.points(true) / 2),
    ] {
        assert!(page.contains(&expected), "{expected}");
    }
    assert_eq!(POINTS_TO_WIN, all.points(true) / 2 + 1);
    for rules in Rules::ALL {
        assert!(rules.page().count() > 2, "{rules:?}");
    }
}
