//! The boards for one player are the same on every machine, and the search clears each of them in
//! its par.

use carrom::game::opponent::clearing;
use carrom::game::{BoardCode, Fingerprint, Game, Move};
use jiff::ToSpan;
use jiff::civil::Date;

/// The boards for a hundred days.
fn hundred() -> impl Iterator<Item = BoardCode> {
    let first = Date::constant(2026, 11, 26);
    (0..100).map(move |days| BoardCode::of_day(first + days.days()).unwrap())
}

/// The FNV-1a hash of these texts.
fn hash(texts: impl IntoIterator<Item = String>) -> u64 {
    let bytes = texts
        .into_iter()
        .flat_map(|text| text.into_bytes().into_iter());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Plays the strokes of the search, each of which must be legal. Returns the par, and the strokes
/// with all their digits.
fn cleared(code: BoardCode) -> (usize, String) {
    let strikes = clearing(code).unwrap_or_else(|| panic!("{code} is not cleared"));
    let mut game = Game::new(code.setup());
    for strike in &strikes {
        assert!(game.play().won.is_none(), "{code}");
        Move::Strike(*strike).make(&mut game).unwrap();
    }
    assert!(game.play().won.is_some(), "{code}");
    assert!(game.coins().is_empty(), "{code}");
    (strikes.len(), format!("{strikes:?}"))
}

#[test]
fn a_hundred_days_have_the_same_boards_on_every_machine() {
    let start = |code: BoardCode| Fingerprint::of(&Game::new(code.setup())).to_string();
    assert_eq!(
        format!("{:016x}", hash(hundred().map(start))),
        "a8d923051d37b5f5"
    );
}

/// The engine plays the strokes of the search, which shows that each of these boards can be
/// cleared in its par.
#[test]
fn the_search_clears_a_hundred_boards_with_the_same_strokes_on_every_machine() {
    let cleared: Vec<_> = hundred().map(cleared).collect();
    let mut pars = [0; 13];
    for (par, _) in &cleared {
        pars[*par] += 1;
    }
    println!("boards by their par, from 0: {pars:?}");
    assert_eq!(pars.iter().sum::<u32>(), 100);
    let strikes = cleared.into_iter().map(|(_, strikes)| strikes);
    assert_eq!(format!("{:016x}", hash(strikes)), "020ecb9e4d5413ab");
}
