//! The options of a game, chosen before the first break.

use super::words;
use crate::game::opponent::{PlayerHand, Strength};
pub use crate::game::{Aids, Player};
use crate::game::{
    Company, Game, GameSetup, GameStage, Hands, Length, PieceSet, Rules, SavedGame, Seat,
    SeatNames, Team,
};
use crate::numbers::capital;

/// Everything that can be chosen for a game.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The rules.
    pub rules: Rules,
    /// How long the game lasts.
    pub length: Length,
    /// Singles or doubles.
    pub hands: Hands,
    /// The player at each seat, in the order of [`Seat::ALL`]; in singles only South and North are
    /// used.
    pub players: [Player; 4],
    /// The strength of the computer at each seat, in the same order.
    pub strengths: [Strength; 4],
    /// The names of two people who share the keyboard.
    pub names: SeatNames,
    /// The set of pieces.
    pub set: PieceSet,
    /// Coefficient of restitution of two discs.
    pub restitution: f64,
    /// How steady the people's hands are.
    pub hand: PlayerHand,
    /// Whether the players call the first impact before each stroke.
    pub call: bool,
    /// The aids that are shown while aiming.
    pub aids: Aids,
}

impl Default for Options {
    /// One person against the computer, for one board.
    fn default() -> Self {
        use Player::{Computer, Person};
        Self {
            rules: Rules::default(),
            length: Length::Board,
            hands: Hands::default(),
            players: [Person, Computer, Computer, Computer],
            strengths: [Strength::default(); 4],
            names: SeatNames::default(),
            set: PieceSet::default(),
            restitution: GameSetup::default().restitution,
            hand: PlayerHand::default(),
            call: false,
            aids: Aids::default(),
        }
    }
}

impl Options {
    /// The options of a board for one player.
    pub(super) fn solo() -> Self {
        Self {
            rules: Rules::Solo,
            ..Self::default()
        }
    }

    /// Singles of two people, without the computer.
    pub fn two_people() -> Self {
        Self {
            players: [Player::Person; 4],
            ..Self::default()
        }
    }

    /// The setup of a game with these options; `seed` determines its opening packs.
    pub fn setup(&self, seed: u64) -> GameSetup {
        GameSetup {
            rules: self.rules,
            hands: match self.rules {
                Rules::Practice | Rules::Solo => Hands::Two,
                _ => self.hands,
            },
            length: self.length,
            set: self.set,
            restitution: self.restitution,
            first_breaker: Seat::South,
            seed: Some(seed),
        }
    }

    /// The options of a saved game.
    pub fn of(saved: &SavedGame) -> Self {
        let (setup, company) = (&saved.record.setup, &saved.company);
        Self {
            rules: setup.rules,
            length: setup.length,
            hands: setup.hands,
            players: company.players,
            strengths: company.strengths,
            names: company.names.clone(),
            set: setup.set,
            restitution: setup.restitution,
            hand: company.hand,
            call: company.call,
            aids: company.aids,
        }
    }

    /// The options that a saved game contains in addition to its setup.
    pub fn company(&self) -> Company {
        Company {
            players: self.players,
            strengths: self.strengths,
            names: match self.has_names() {
                true => self.names.clone(),
                false => SeatNames::default(),
            },
            hand: self.hand,
            call: self.call,
            aids: self.aids,
        }
    }

    /// The player at a seat; always a person if there is only one player.
    pub fn player(&self, seat: Seat) -> Player {
        match self.rules {
            Rules::Practice | Rules::Solo => Player::Person,
            _ => self.players[seat as usize],
        }
    }

    /// The strength of the computer at a seat.
    pub fn strength(&self, seat: Seat) -> Strength {
        self.strengths[seat as usize]
    }

    /// The team whose human players call the strokes from a seat: their own strokes, and those of a
    /// computer that plays against them.
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

    /// Sets the player at a seat.
    pub fn set_player(&mut self, seat: Seat, player: Player) {
        self.players[seat as usize] = player;
    }

    /// The seats in use, in the order of turns.
    pub fn seats(&self) -> impl Iterator<Item = Seat> + '_ {
        Seat::ALL.into_iter().filter(|seat| self.hands.plays(*seat))
    }

    /// The number of seats with this kind of player.
    pub fn count(&self, player: Player) -> usize {
        self.seats()
            .filter(|seat| self.player(*seat) == player)
            .count()
    }

    /// Whether several people share the keyboard.
    pub(super) fn is_shared(&self) -> bool {
        !self.rules.is_alone() && self.count(Player::Person) > 1
    }

    /// Whether two people play each other; they may have names.
    pub(super) fn has_names(&self) -> bool {
        self.hands == Hands::Two && self.is_shared()
    }

    /// The name of the player at a seat, which is "you" if nobody else is at the keyboard.
    pub fn seat_name(&self, seat: Seat) -> &str {
        match self.player(seat) {
            Player::Person if !self.is_shared() => "you",
            _ if self.has_names() && !self.names.of(seat).is_empty() => self.names.of(seat),
            Player::Computer if self.count(Player::Computer) == 1 => "computer",
            _ => seat.into(),
        }
    }

    /// The score between the names of the two teams. Friendly games count boards, the others count
    /// points: in point carrom those of the board in play, in a tournament those of the finished
    /// boards.
    pub(super) fn score(&self, game: &Game) -> String {
        let points = game.points();
        match self.rules {
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

    /// The word for what the last board decides: a board, a game or a match.
    pub(super) fn whole(&self) -> &'static str {
        match (self.length, self.rules) {
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
        match (self.hands, team) {
            _ if self.rules.is_alone() => "you",
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
        named.names.set(Seat::South, "Ada");
        assert_eq!(named.team_name(Team::First), "Ada");
        assert_eq!(named.team_name(Team::Second), "North");
        named.hands = Hands::Four;
        assert_eq!(named.seat_name(Seat::South), "South");
        named.set_player(Seat::North, Player::Computer);
        named.hands = Hands::Two;
        assert_eq!(named.seat_name(Seat::South), "you");
        let doubles = Options {
            hands: Hands::Four,
            ..alone
        };
        assert_eq!(doubles.seat_name(Seat::South), "you");
        assert_eq!(doubles.seat_name(Seat::West), "West");
        assert_eq!(doubles.count(Player::Computer), 3);
    }
}
