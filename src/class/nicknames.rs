//! Nicknames that carrom gives to pupils' devices: a colour and an animal.

use super::join_code::SeatToken;

const COLOURS: [&str; 16] = [
    "Amber", "Azure", "Blue", "Bronze", "Copper", "Coral", "Crimson", "Golden", "Green", "Indigo",
    "Jade", "Orange", "Purple", "Scarlet", "Silver", "Violet",
];
/// Animals whose names are not insults.
const ANIMALS: [&str; 20] = [
    "Badger", "Beaver", "Crane", "Dolphin", "Falcon", "Finch", "Fox", "Heron", "Ibis", "Kestrel",
    "Lynx", "Marten", "Otter", "Owl", "Panda", "Puffin", "Robin", "Seal", "Swift", "Tern",
];
const ALL: usize = COLOURS.len() * ANIMALS.len();

fn nickname(number: usize) -> String {
    let number = number % ALL;
    let (animal, colour) = (number / COLOURS.len(), number % COLOURS.len());
    format!("{} {}", COLOURS[colour], ANIMALS[animal])
}

/// Whether this is one of the nicknames, perhaps with a number.
pub(crate) fn is_nickname(name: &str) -> bool {
    let mut words = name.split(' ');
    let is_known = words.next().is_some_and(|it| COLOURS.contains(&it))
        && words.next().is_some_and(|it| ANIMALS.contains(&it));
    let mut rest = words.map(|it| it.parse::<u16>().is_ok());
    is_known && rest.next().unwrap_or(true) && rest.next().is_none()
}

/// Chooses a nickname that is not `taken`, unless all are. A device that already had a nickname
/// asks for it (`asked`) and gets it if it is free; otherwise the random token determines the
/// nickname.
pub(super) fn for_device(asked: &str, token: SeatToken, taken: impl Fn(&str) -> bool) -> String {
    if is_nickname(asked) && !taken(asked) {
        return asked.to_owned();
    }
    let start = token.number_below(ALL);
    // 87 has no common factor with the number of nicknames, so this visits all of them.
    let mut all = (0..ALL).map(|step| nickname(start + 87 * step));
    let free = all.find(|name| !taken(name));
    free.unwrap_or_else(|| nickname(start))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::class::{LONGEST_NAME, MOST_PEOPLE};

    #[test]
    fn everyone_in_the_largest_class_gets_a_nickname_of_their_own() {
        let mut given = BTreeSet::new();
        for pupil in 0..MOST_PEOPLE as u128 {
            let token =
                SeatToken::of(pupil.wrapping_mul(0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835));
            let name = for_device("", token, |name| given.contains(name));
            assert!(is_nickname(&name) && name.len() <= LONGEST_NAME, "{name}");
            assert!(given.insert(name));
        }
        let all: BTreeSet<_> = (0..ALL).map(nickname).collect();
        assert_eq!(all.len(), ALL);
    }

    #[test]
    fn a_device_gets_the_nickname_that_it_had_unless_somebody_else_has_it() {
        let token = SeatToken::of(5);
        assert_eq!(for_device("Blue Otter", token, |_| false), "Blue Otter");
        let other = for_device("Blue Otter", token, |name| name == "Blue Otter");
        assert!(is_nickname(&other) && other != "Blue Otter");
        for name in [
            "Ada",
            "",
            "Blue",
            "Blue Otter x",
            "Blue Otter 2 3",
            "blue otter",
        ] {
            assert!(!is_nickname(name), "{name}");
        }
        assert!(is_nickname("Blue Otter 2"));
    }
}
