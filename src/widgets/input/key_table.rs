//! The keys of a screen, as data: the current keys with their labels and actions. The key handling,
//! the bottom line, the help page and the buttons of a touch screen all use the same table.

use std::collections::BTreeMap;

use crate::messages::Key;

/// The actions of a screen or of part of a screen. The doc comment of each variant is its line on
/// the help page, and its name in kebab-case is its name in `keys.toml`.
pub trait KeyAction: Copy {
    /// The name of the action in `keys.toml`, without the group before it, such as "next-set".
    fn id(self) -> &'static str;
    /// The description of the action, a phrase without a full stop.
    fn help(self) -> &'static str;
}

impl<A: Copy + Into<&'static str> + strum::EnumMessage> KeyAction for A {
    fn id(self) -> &'static str {
        self.into()
    }

    fn help(self) -> &'static str {
        self.get_documentation().unwrap_or_default()
    }
}

/// The keys that the player has rebound, indexed by the id of the row, such as "lab.next-set".
pub type Rebound = BTreeMap<String, Vec<Key>>;

/// Keys for one action, or for one action in several directions.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyRow<A> {
    /// The name of the row in `keys.toml`, such as "lab.next-set".
    pub id: String,
    /// The label in the bottom line, one or two words; empty if the row is not shown there.
    pub name: &'static str,
    /// The text on the help page.
    pub help: &'static str,
    /// The labels of the keys if they have separate buttons; otherwise empty.
    pub words: &'static [&'static str],
    /// The text that the bottom line shows instead of listing all the keys.
    brief: Option<&'static str>,
    keys: Vec<(Key, A)>,
    aliases: Vec<(Key, A)>,
}

impl<A: Copy> KeyRow<A> {
    /// The keys that the screen shows for this row.
    pub fn keys(&self) -> impl Iterator<Item = Key> + '_ {
        self.keys.iter().map(|(key, _)| *key)
    }

    /// All keys of this row, including those that are not shown.
    pub fn all_keys(&self) -> impl Iterator<Item = Key> + '_ {
        self.keys.iter().chain(&self.aliases).map(|(key, _)| *key)
    }

    /// The names of the keys as shown on the screen, such as "arrows", "0-9", ", .".
    pub fn shown(&self) -> String {
        shown(&self.keys().collect::<Vec<_>>())
    }

    /// The keys as shown in the bottom line.
    pub(crate) fn brief(&self) -> String {
        self.brief.map_or_else(|| self.shown(), str::to_owned)
    }

    /// Replaces the keys, in the same order; the actions stay the same. If there are fewer new keys
    /// than actions, the remaining actions have no key.
    fn rebind(&mut self, keys: &[Key]) {
        self.brief = None;
        self.aliases.clear();
        let actions = self.keys.iter().map(|(_, action)| *action);
        self.keys = keys.iter().copied().zip(actions).collect();
    }

    fn lose(&mut self, taken: &[Key]) {
        self.keys.retain(|(key, _)| !taken.contains(key));
        self.aliases.retain(|(key, _)| !taken.contains(key));
    }

    fn find(&self, key: Key) -> Option<A> {
        let mut all = self.keys.iter().chain(&self.aliases);
        all.find_map(|(own, action)| (*own == key).then_some(*action))
    }
}

/// The keys that a screen currently accepts, most useful first.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct KeyTable<A> {
    group: &'static str,
    rows: Vec<KeyRow<A>>,
    /// Whether the latest call that adds keys has added a row of its own that `when` has not
    /// removed. A call without keys adds no row, and `with` adds the rows of another table; the
    /// methods that change the last row then have no effect.
    added: bool,
}

impl<A: KeyAction> KeyTable<A> {
    /// Adds a key.
    pub fn on(self, key: impl Into<Key>, action: A, name: &'static str) -> Self {
        self.each([(key, action)], name)
    }

    /// Adds keys for one action in several directions. The row takes its name in `keys.toml` and
    /// its help text from the first action.
    pub fn each<K: Into<Key>>(
        mut self,
        keys: impl IntoIterator<Item = (K, A)>,
        name: &'static str,
    ) -> Self {
        let keys: Vec<_> = keys.into_iter().map(|(key, a)| (key.into(), a)).collect();
        self.added = !keys.is_empty();
        if let Some((_, first)) = keys.first() {
            self.rows.push(KeyRow {
                id: format!("{}.{}", self.group, first.id()),
                name,
                help: first.help(),
                words: &[],
                brief: None,
                keys,
                aliases: Vec::new(),
            });
        }
        self
    }

    /// Adds one key for each of the `amounts` of an action, in the same order.
    pub fn by<const N: usize, T>(
        self,
        keys: [impl Into<Key>; N],
        action: impl Fn(T) -> A,
        amounts: [T; N],
        name: &'static str,
    ) -> Self {
        self.each(keys.into_iter().zip(amounts.map(action)), name)
    }
}

impl<A: Copy> KeyTable<A> {
    /// Creates an empty table, whose rows are called "group.action" in `keys.toml`.
    pub fn new(group: &'static str) -> Self {
        Self {
            group,
            rows: Vec::new(),
            added: false,
        }
    }

    /// Adds alternative keys for the actions of the last row; these keys are not shown.
    pub fn or<K: Into<Key>>(mut self, aliases: impl IntoIterator<Item = (K, A)>) -> Self {
        if let Some(row) = self.rows.last_mut().filter(|_| self.added) {
            let aliases = aliases.into_iter().map(|(key, a)| (key.into(), a));
            row.aliases.extend(aliases);
        }
        self
    }

    /// Removes the last row unless the condition `holds`.
    pub fn when(mut self, holds: bool) -> Self {
        if !holds && std::mem::take(&mut self.added) {
            self.rows.pop();
        }
        self
    }

    /// Sets the button labels of the last row's keys.
    pub fn called(mut self, words: &'static [&'static str]) -> Self {
        if let Some(row) = self.rows.last_mut().filter(|_| self.added) {
            row.words = words;
        }
        self
    }

    /// Sets the text that the bottom line shows instead of all keys of the rows with matching
    /// actions: the most useful keys, or an example.
    pub fn in_brief(mut self, brief: &'static str, is: impl Fn(A) -> bool) -> Self {
        for row in &mut self.rows {
            if row.keys.first().is_some_and(|(_, action)| is(*action)) {
                row.brief = Some(brief);
            }
        }
        self
    }

    /// Changes the label in the bottom line of the rows with matching actions.
    pub fn renamed(mut self, name: &'static str, is: impl Fn(A) -> bool) -> Self {
        for row in &mut self.rows {
            if row.keys.first().is_some_and(|(_, action)| is(*action)) {
                row.name = name;
            }
        }
        self
    }

    /// This table without the rows with matching actions.
    pub fn without(mut self, is: impl Fn(A) -> bool) -> Self {
        self.rows
            .retain(|row| !row.keys.first().is_some_and(|(_, action)| is(*action)));
        self
    }

    /// This table without `keys`, which have another meaning on the screen.
    pub(crate) fn without_keys(mut self, keys: &[Key]) -> Self {
        self.rows.iter_mut().for_each(|row| row.lose(keys));
        self
    }

    /// Changes the id of each row in which `key` is the only key shown.
    pub(crate) fn identified(mut self, key: Key, id: &str) -> Self {
        for row in &mut self.rows {
            if let [(own, _)] = row.keys.as_slice()
                && *own == key
            {
                id.clone_into(&mut row.id);
            }
        }
        self
    }

    /// This table without keys that an earlier row already uses and without rows that have no shown
    /// keys left; rows with the same id are merged into the first of them.
    pub(crate) fn distinct(mut self) -> Self {
        let mut taken = Vec::new();
        let mut rows: Vec<KeyRow<A>> = Vec::new();
        for mut row in self.rows {
            row.lose(&taken);
            taken.extend(row.all_keys());
            match rows.iter_mut().find(|earlier| earlier.id == row.id) {
                Some(earlier) => earlier
                    .aliases
                    .extend(row.keys.into_iter().chain(row.aliases)),
                None if row.keys.is_empty() => {}
                None => rows.push(row),
            }
        }
        self.rows = rows;
        self
    }

    /// Adds the keys of part of the screen.
    pub fn with<B: Copy>(mut self, part: KeyTable<B>, action: impl Fn(B) -> A) -> Self {
        self.rows.extend(part.map(action).rows);
        self.added = false;
        self
    }

    /// This table with each action converted by `action`.
    pub fn map<B>(self, action: impl Fn(A) -> B) -> KeyTable<B> {
        let map = |keys: Vec<(Key, A)>| keys.into_iter().map(|(key, a)| (key, action(a))).collect();
        let rows = self.rows.into_iter().map(|row| KeyRow {
            id: row.id,
            name: row.name,
            help: row.help,
            words: row.words,
            brief: row.brief,
            keys: map(row.keys),
            aliases: map(row.aliases),
        });
        KeyTable {
            group: self.group,
            rows: rows.collect(),
            added: self.added,
        }
    }

    /// This table with the player's own key bindings: rebound rows have the new keys, and no other
    /// row uses them.
    pub fn rebound(mut self, rebound: &Rebound) -> Self {
        if rebound.is_empty() {
            return self;
        }
        let own = self.rows.iter().filter_map(|row| rebound.get(&row.id));
        let taken: Vec<Key> = own.flatten().copied().collect();
        for row in &mut self.rows {
            match rebound.get(&row.id) {
                Some(keys) => row.rebind(keys),
                None => row.lose(&taken),
            }
        }
        self
    }

    /// The rows, the most useful first.
    pub fn rows(&self) -> &[KeyRow<A>] {
        &self.rows
    }

    /// The action of a key; a capital letter without an action of its own has the action of the
    /// lower-case letter.
    pub fn find(&self, key: Key) -> Option<A> {
        self.exact(key).or_else(|| self.folded(key))
    }

    /// The first key with this action.
    pub(crate) fn key_of(&self, action: &A) -> Option<Key>
    where
        A: PartialEq,
    {
        let mut keys = self
            .rows
            .iter()
            .flat_map(|row| row.keys.iter().chain(&row.aliases));
        keys.find_map(|(key, own)| (own == action).then_some(*key))
    }

    /// All keys with an action, including those that are not shown.
    pub fn keys(&self) -> impl Iterator<Item = Key> + '_ {
        self.rows.iter().flat_map(KeyRow::all_keys)
    }

    /// The action of a key; capital and lower-case letters are different keys.
    pub fn exact(&self, key: Key) -> Option<A> {
        self.rows.iter().find_map(|row| row.find(key))
    }

    /// For a capital letter, the action of the lower-case letter.
    pub(crate) fn folded(&self, key: Key) -> Option<A> {
        match key {
            Key::Char(c) if c.is_ascii_uppercase() => self.exact(Key::Char(c.to_ascii_lowercase())),
            _ => None,
        }
    }
}

/// The names of keys as shown on the screen.
fn shown(keys: &[Key]) -> String {
    let mut words: Vec<String> = Vec::new();
    let mut rest = keys;
    if keys.len() >= 4 && Key::ARROWS.iter().all(|arrow| keys[..4].contains(arrow)) {
        words.push("arrows".into());
        rest = &keys[4..];
    }
    while let Some((first, others)) = rest.split_first() {
        let digit = |key: &Key| match key {
            Key::Char(c) => c.to_digit(10),
            _ => None,
        };
        let run = rest.windows(2).take_while(
            |pair| matches!((digit(&pair[0]), digit(&pair[1])), (Some(a), Some(b)) if b == a + 1),
        );
        let run = run.count();
        if run >= 3 {
            words.push(format!("{first}-{}", rest[run]));
            rest = &rest[run + 1..];
        } else {
            words.push(first.to_string());
            rest = others;
        }
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
    #[strum(serialize_all = "kebab-case")]
    enum Action {
        /// next set of pieces
        NextSet,
        /// choose a setting
        Choose(i8),
        /// type a number
        Digit(char),
    }

    fn table() -> KeyTable<Action> {
        KeyTable::new("lab")
            .on(Key::Char('s'), Action::NextSet, "pieces")
            .each(
                [
                    (Key::Up, Action::Choose(-1)),
                    (Key::Down, Action::Choose(1)),
                ],
                "choose",
            )
            .or([(Key::Tab, Action::Choose(1))])
            .each(
                ('0'..='9').map(|c| (Key::Char(c), Action::Digit(c))),
                "type",
            )
    }

    #[test]
    fn a_row_has_its_keys_name_and_help() {
        let table = table();
        let shown: Vec<_> = table
            .rows()
            .iter()
            .map(|row| (row.id.as_str(), row.shown(), row.name, row.help))
            .collect();
        assert_eq!(
            shown,
            [
                ("lab.next-set", "s".into(), "pieces", "next set of pieces"),
                ("lab.choose", "Up Down".into(), "choose", "choose a setting"),
                ("lab.digit", "0-9".into(), "type", "type a number"),
            ]
        );
    }

    #[test]
    fn the_bottom_line_shows_an_example_until_the_row_is_rebound() {
        let table = table().in_brief("5 Enter", |it| matches!(it, Action::Digit(_)));
        let last = |table: &KeyTable<Action>| table.rows()[2].brief();
        assert_eq!(last(&table), "5 Enter");
        assert_eq!(table.rows()[1].brief(), "Up Down");
        let rebound = Rebound::from([("lab.digit".into(), vec![Key::Char('x')])]);
        assert_eq!(last(&table.rebound(&rebound)), "x");
    }

    #[test]
    fn a_key_has_the_action_of_its_row() {
        let table = table();
        assert_eq!(table.exact(Key::Tab), Some(Action::Choose(1)));
        assert_eq!(table.exact(Key::Up), Some(Action::Choose(-1)));
        assert_eq!(table.exact(Key::Char('S')), None);
        assert_eq!(table.folded(Key::Char('S')), Some(Action::NextSet));
        assert_eq!(table.folded(Key::Left), None);
    }

    #[test]
    fn a_condition_applies_only_to_the_row_before_it() {
        let table = table()
            .each([(Key::F(5), Action::NextSet); 0], "nothing")
            .or([(Key::F(5), Action::NextSet)])
            .when(false);
        assert_eq!(table.rows().len(), 3);
        assert_eq!(table.exact(Key::F(5)), None);
        assert_eq!(
            table
                .on(Key::F(6), Action::NextSet, "")
                .when(false)
                .rows()
                .len(),
            3
        );
    }

    #[test]
    fn rebound_keys_are_removed_from_all_other_rows() {
        let keys = |keys: &[char]| keys.iter().map(|c| Key::Char(*c)).collect::<Vec<_>>();
        let rebound = Rebound::from([
            ("lab.choose".to_owned(), keys(&['k', 's'])),
            ("quiz.other".to_owned(), keys(&['0'])),
        ]);
        let table = table().rebound(&rebound);
        assert_eq!(table.exact(Key::Char('k')), Some(Action::Choose(-1)));
        assert_eq!(table.exact(Key::Char('s')), Some(Action::Choose(1)));
        assert_eq!(table.exact(Key::Down), None);
        assert_eq!(table.exact(Key::Tab), None);
        assert_eq!(table.exact(Key::Char('0')), Some(Action::Digit('0')));
        assert_eq!(table.rows()[0].shown(), "");
        assert_eq!(table.rows()[1].shown(), "k s");
    }
}
