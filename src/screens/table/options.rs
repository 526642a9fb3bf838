//! The options of a game, chosen before the first break.

use super::words;
use crate::game::{
    Company, Game, GameSetup, GameStage, Hands, Length, Player, Rules, SavedGame, Seat, SeatNames,
    Team,
};
use crate::numbers::capital;

/// Everything that can be chosen for a game.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The rules, the length and the pieces; South breaks first, and the packs have no seed yet.
    pub setup: GameSetup,
    /// The players and their aids. In singles only South and North are used.
    pub company: Company,
}

impl Default for Options {
    /// One person against the computer, for one board.
    fn default() -> Self {
        use Player::{Computer, Person};
        Self {
            setup: GameSetup {
                length: Length::Board,
                ..GameSetup::default()
            },
            company: Company {
                players: [Person, Computer, Computer, Computer],
                ..Company::default()
            },
        }
    }
}

impl Options {
    /// The options of a board for one player.
    pub(super) fn solo() -> Self {
        Self::default().with(|options| options.setup.rules = Rules::Solo)
    }

    /// Singles of two people, without the computer.
    pub fn two_people() -> Self {
        Self {
            company: Company::default(),
            ..Self::default()
        }
    }

    /// These options after a change.
    #[must_use]
    pub fn with(mut self, change: impl FnOnce(&mut Self)) -> Self {
        change(&mut self);
        self
    }

    /// The setup of a game with these options; `seed` determines its opening packs.
    pub fn seeded(&self, seed: u64) -> GameSetup {
        let mut setup = self.setup;
        setup.seed = Some(seed);
        if setup.rules.is_alone() {
            setup.hands = Hands::Two;
        }
        setup
    }

    /// The options of a saved game.
    pub fn of(saved: &SavedGame) -> Self {
        Self {
            setup: GameSetup {
                first_breaker: Seat::South,
                seed: None,
                ..saved.record.setup
            },
            company: saved.company.clone(),
        }
    }

    /// The players as a saved game contains them: with names only if they may have names.
    pub fn saved_company(&self) -> Company {
        let mut company = self.company.clone();
        if !self.has_names() {
            company.names = SeatNames::default();
        }
        company
    }

    /// The player at a seat; always a person if there is only one player.
    pub fn player(&self, seat: Seat) -> Player {
        match self.setup.rules {
            Rules::Practice | Rules::Solo => Player::Person,
            _ => self.company.players[seat as usize],
        }
    }

    /// The team whose human players call the strokes made from this seat: they call their own
    /// team's strokes and, if all opponents are computers, the opponents' strokes.
    pub(super) fn caller(&self, game: &Game, seat: Seat) -> Team {
        let own = game.team(seat);
        let has_person = |team: Team| {
            let mut seats = self.seats().filter(|seat| game.team(*seat) == team);
            seats.any(|seat| self.player(seat) == Player::Person)
        };
        match has_person(own) || !has_person(own.other()) {
            true => own,
            false => own.other(),
        }
    }

    /// The seats in use, in the order of turns.
    pub fn seats(&self) -> impl Iterator<Item = Seat> + '_ {
        let seats = Seat::ALL.into_iter();
        seats.filter(|seat| self.setup.hands.plays(*seat))
    }

    /// The number of seats with this kind of player.
    pub fn count(&self, player: Player) -> usize {
        let seats = self.seats();
        seats.filter(|seat| self.player(*seat) == player).count()
    }

    /// Whether several people share the keyboard.
    pub(super) fn is_shared(&self) -> bool {
        !self.setup.rules.is_alone() && self.count(Player::Person) > 1
    }

    /// Whether two people play each other, and so may have names.
    pub(super) fn has_names(&self) -> bool {
        self.setup.hands == Hands::Two && self.is_shared()
    }

    /// The name of the player at a seat: "you" for a person if nobody else is at the keyboard.
    pub fn seat_name(&self, seat: Seat) -> &str {
        match self.player(seat) {
            Player::Person if !self.is_shared() => "you",
            _ if self.has_names() && !self.company.names.of(seat).is_empty() => {
                self.company.names.of(seat)
            }
            Player::Computer if self.count(Player::Computer) == 1 => "computer",
            _ => seat.into(),
        }
    }

    /// The score between the names of the two teams. Friendly games count boards, the others count
    /// points: in point carrom those of the board in play, in a tournament those of the finished
    /// boards.
    pub(super) fn score(&self, game: &Game) -> String {
        let points = game.points();
        match self.setup.rules {
            Rules::Tournament | Rules::Points => self.between_names(|team| points[team]),
            Rules::Friendly | Rules::Practice | Rules::Solo => self.boards_won(game),
        }
    }

    /// The numbers of boards that the teams have won, between their names. A board counts as soon
    /// as it is over.
    pub(super) fn boards_won(&self, game: &Game) -> String {
        let games = game.score().games;
        let last = match game.stage() {
            GameStage::GameOver(team) | GameStage::MatchOver(team) => Some(team),
            GameStage::Playing | GameStage::BoardOver(_) => None,
        };
        self.between_names(|team| games[team] + u8::from(last == Some(team)))
    }

    fn between_names(&self, value: impl Fn(Team) -> u8) -> String {
        let [a, b] = Team::BOTH.map(value);
        let [first, second] = Team::BOTH.map(|team| self.team_name(team));
        format!("{first} {a} : {b} {second}")
    }

    /// The word for what is won at the end: a board, a game or a match.
    pub(super) fn whole(&self) -> &'static str {
        match (self.setup.length, self.setup.rules) {
            (Length::Match, Rules::Tournament) => "match",
            (Length::Game, Rules::Tournament) => "game",
            _ => "board",
        }
    }

    /// A sentence such as "You win the match".
    pub(super) fn wins(&self, team: Team, what: &str) -> String {
        let wins = words::does(self.team_name(team), "wins");
        capital(&format!("{wins} the {what}"))
    }

    /// The name of a team.
    pub fn team_name(&self, team: Team) -> &str {
        match (self.setup.hands, team) {
            _ if self.setup.rules.is_alone() => "you",
            (Hands::Two, Team::First) => self.seat_name(Seat::South),
            (Hands::Two, Team::Second) => self.seat_name(Seat::North),
            (Hands::Four, Team::First) => "S + N",
            (Hands::Four, Team::Second) => "E + W",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_depend_on_who_is_at_the_keyboard() {
        let alone = Options::default();
        assert_eq!(alone.seat_name(Seat::South), "you");
        assert_eq!(alone.team_name(Team::Second), "computer");
        let two = Options::two_people();
        assert_eq!(two.seat_name(Seat::South), "South");
        let mut named = two;
        named.company.names.set(Seat::South, "Ada");
        assert_eq!(named.team_name(Team::First), "Ada");
        assert_eq!(named.team_name(Team::Second), "North");
        named.setup.hands = Hands::Four;
        assert_eq!(named.seat_name(Seat::South), "South");
        named.company.players[Seat::North as usize] = Player::Computer;
        named.setup.hands = Hands::Two;
        assert_eq!(named.seat_name(Seat::South), "you");
        let doubles = alone.with(|options| options.setup.hands = Hands::Four);
        assert_eq!(doubles.seat_name(Seat::South), "you");
        assert_eq!(doubles.seat_name(Seat::West), "West");
        assert_eq!(doubles.count(Player::Computer), 3);
    }
}
