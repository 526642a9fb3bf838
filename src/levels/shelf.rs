//! The levels there are for this player, and what has been done with them.

use std::sync::Arc;

use super::level::Level;
use super::library::{LevelLibrary, Pack};
use super::stars::{Best, MOST_STARS, Starred, Win};

/// All levels, numbered from 0 through all packs, with the best that was done in each.
#[derive(Debug, Clone, Default)]
pub struct Shelf {
    /// `None` where there are those of the program alone, which are read only when
    /// they are looked at.
    library: Option<Arc<LevelLibrary>>,
    best: Best,
    /// The level, or after the last of them the problem, that was looked at last.
    pub at: usize,
}

impl Shelf {
    /// A shelf of other levels than those of the program alone, none of them won yet.
    pub fn new(library: LevelLibrary) -> Self {
        Self {
            library: Some(Arc::new(library)),
            ..Self::default()
        }
    }

    /// The levels and what was wrong with files that are left out.
    pub fn library(&self) -> &LevelLibrary {
        let own = self.library.as_deref();
        own.unwrap_or_else(|| LevelLibrary::embedded_once())
    }

    /// The levels with their packs, by number.
    pub fn levels(&self) -> impl Iterator<Item = (&Pack, &Level)> {
        let packs = self.library().packs.iter();
        packs.flat_map(|pack| pack.levels.iter().map(move |level| (pack, level)))
    }

    /// A level and its pack; `None` beyond the last.
    pub fn get(&self, number: usize) -> Option<(&Pack, &Level)> {
        self.levels().nth(number)
    }

    /// The number of the level called `name`: its id, or the name of its pack and its
    /// id with a stroke between.
    pub fn find(&self, name: &str) -> Option<usize> {
        let wanted = |(pack, level): (&Pack, &Level)| match name.split_once('/') {
            Some(name) => name == (&pack.name, &level.id),
            None => name == level.id,
        };
        self.levels().position(wanted)
    }

    /// How many levels there are.
    pub fn count(&self) -> usize {
        let packs = self.library().packs.iter();
        packs.map(|pack| pack.levels.len()).sum()
    }

    /// Stars of a level; 0 if it was never won.
    pub fn stars(&self, number: usize) -> u8 {
        let stars = |(pack, level): (&Pack, &Level)| self.best.stars(&pack.name, &level.id);
        self.get(number).map_or(0, stars)
    }

    /// The first level that was never won; `None` if all were.
    pub fn next(&self) -> Option<usize> {
        (0..self.count()).find(|number| self.stars(*number) == 0)
    }

    /// Notes that a level was won, and gives what is worth keeping: the stars, if they
    /// are more than before.
    pub fn won(&mut self, number: usize, win: Win) -> Option<Starred> {
        let (pack, level) = self.get(number)?;
        let starred = Starred {
            pack: pack.name.clone(),
            level: level.id.clone(),
            stars: win.stars(),
        };
        self.recall(&starred).then_some(starred)
    }

    /// Notes stars that were won before; says whether they are more than was known.
    pub fn recall(&mut self, starred: &Starred) -> bool {
        let stars = starred.stars.min(MOST_STARS);
        self.best.keep(&starred.pack, &starred.level, stars)
    }
}
