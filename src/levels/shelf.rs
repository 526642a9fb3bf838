//! The levels that are available to this player, and the player's best results.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::level::Level;
use super::library::{LevelLibrary, Pack};
use super::stars::{MOST_STARS, Starred, Win};

/// All levels, numbered from 0 across all packs, with the best result in each level.
#[derive(Debug, Clone, Default)]
pub struct Shelf {
    /// `None` if there are only the built-in levels, which are read when they are first needed.
    library: Option<Arc<LevelLibrary>>,
    /// The largest number of stars won in a level, indexed by the name of the pack and the id of
    /// the level.
    best: BTreeMap<(String, String), u8>,
    /// The index of the entry that was selected last: a level, or a problem (the problems are
    /// numbered after the levels).
    pub at: usize,
}

impl Shelf {
    /// Creates a shelf with the levels of this library, none of which has been won yet.
    pub fn new(library: LevelLibrary) -> Self {
        Self {
            library: Some(Arc::new(library)),
            ..Self::default()
        }
    }

    /// The levels, and the errors in the files that were left out.
    pub fn library(&self) -> &LevelLibrary {
        let own = self.library.as_deref();
        own.unwrap_or_else(|| LevelLibrary::embedded_once())
    }

    /// The levels and their packs, in order of number.
    pub fn levels(&self) -> impl Iterator<Item = (&Pack, &Level)> {
        let packs = self.library().packs.iter();
        packs.flat_map(|pack| pack.levels.iter().map(move |level| (pack, level)))
    }

    /// A level and its pack; `None` if there is no level with this number.
    pub fn get(&self, number: usize) -> Option<(&Pack, &Level)> {
        self.levels().nth(number)
    }

    /// The number of the level called `name`, which is the id of the level, or the name of its pack
    /// and its id separated by a slash.
    pub fn find(&self, name: &str) -> Option<usize> {
        let wanted = |(pack, level): (&Pack, &Level)| match name.split_once('/') {
            Some(name) => name == (&pack.name, &level.id),
            None => name == level.id,
        };
        self.levels().position(wanted)
    }

    /// The number of levels.
    pub fn count(&self) -> usize {
        let packs = self.library().packs.iter();
        packs.map(|pack| pack.levels.len()).sum()
    }

    /// The largest number of stars won in a level; 0 if the level was never won.
    pub fn stars(&self, number: usize) -> u8 {
        let key = |(pack, level): (&Pack, &Level)| (pack.name.clone(), level.id.clone());
        let stars = self
            .get(number)
            .and_then(|found| self.best.get(&key(found)));
        stars.copied().unwrap_or(0)
    }

    /// The first level that was never won; `None` if every level was won.
    pub fn next(&self) -> Option<usize> {
        (0..self.count()).find(|number| self.stars(*number) == 0)
    }

    /// Records that a level was won, and returns the stars to be saved if there are more of them
    /// than before.
    pub fn won(&mut self, number: usize, win: Win) -> Option<Starred> {
        let (pack, level) = self.get(number)?;
        let starred = Starred {
            pack: pack.name.clone(),
            level: level.id.clone(),
            stars: win.stars(),
        };
        self.recall(&starred).then_some(starred)
    }

    /// Drops all stars, because those of another player will be requested.
    pub(crate) fn forget(&mut self) {
        self.best.clear();
    }

    /// Records stars that were won before; returns whether there are more of them than were known.
    pub fn recall(&mut self, starred: &Starred) -> bool {
        let key = (starred.pack.clone(), starred.level.clone());
        let best = self.best.entry(key).or_default();
        let stars = starred.stars.min(MOST_STARS);
        let more = stars > *best;
        *best = stars.max(*best);
        more
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_worse_win_keeps_the_stars() {
        let mut shelf = Shelf::default();
        assert_eq!(shelf.stars(0), 0);
        let (pack, level) = shelf.get(0).unwrap();
        let starred = |stars| Starred {
            pack: pack.name.clone(),
            level: level.id.clone(),
            stars,
        };
        let wins = [1, 3, 2, 3].map(starred);
        for (won, (more, most)) in wins
            .iter()
            .zip([(true, 1), (true, 3), (false, 3), (false, 3)])
        {
            assert_eq!(shelf.recall(won), more);
            assert_eq!(shelf.stars(0), most);
        }
        assert_eq!(shelf.stars(1), 0);
    }
}
