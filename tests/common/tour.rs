//! A tour of every moment at which carrom has a key table of its own.

use carrom::app::App;
use carrom::game::{BoardCode, Rules};
use carrom::levels::Shelf;
use carrom::measure::{self, Given, Measurement, Reading};
use carrom::quiz::Code;
use carrom::screens::{FoilPage, Route, Settings};
use carrom::shells::classroom::Who;
use carrom::shells::{Classroom, Headless};

/// One moment: the screen at which the game is opened, and the keys that lead from that screen to
/// the moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TourStop {
    pub(crate) name: &'static str,
    /// The screen, much as on the command line: "quiz mixed-7".
    place: &'static str,
    /// The keys that lead to the moment, as for [`Headless::press`].
    keys: &'static str,
    /// Whether keys that are not in the key table have a meaning too: letters are typed, or any key
    /// closes the help.
    pub(crate) takes_any: bool,
}

const fn moment(name: &'static str, place: &'static str, keys: &'static str) -> TourStop {
    TourStop {
        name,
        place,
        keys,
        takes_any: false,
    }
}

impl TourStop {
    const fn taking_any(self) -> Self {
        Self {
            takes_any: true,
            ..self
        }
    }
}

/// A class round of two questions with the largest number of teams, each of which has its own key.
const CLASS: &str = "class from-angle2-7 Ants Bees Cats Dogs Elks Fish Gnus Hens";
/// A class whose pupils use their own devices.
const DEVICES: &str = "host";
/// The code of the round on devices, unless the place gives another code after a colon.
const ON_DEVICES: &str = "from-angle2-7";
/// Moves to the row of South's name on the page of a new game between two people.
const TO_A_NAME: &str = "<Down><Down><Down><Left><Left><Down>";
/// Plays two strokes of a practice game.
const TWO_STROKES: &str = "<Left><Enter><Up><Space><End><Space><Down><Space><End>";
const STROKE_BEFORE: &str = "<Left><Enter><Up><Space><End><Space><Down><Space><End>p";
/// Answers two questions of a round.
const LOOKING_BACK: &str = "60<Enter>30<Enter>2<End><Enter>60<Enter>30<Enter>2<End><Enter>";
/// Gives the answers of somebody who copies the given angle.
const FOUND_OUT: &str = "57<Enter>57<Enter>266<Enter>66<Enter>2c<Enter>2";
const TO_THE_SHOT: &str = "<Enter><Enter><Enter><End><Enter><Enter><End><Enter>";
const TO_THE_SCORES: &str = "<Enter><Enter><Enter><End><Enter><Enter><End><Enter><End><Enter>";
const TO_THE_SECOND: &str =
    "<Enter><Enter><Enter><End><Enter><Enter><End><Enter><End><Enter><Enter>";
const TO_THE_END: &str = "<Enter><Enter><Enter><End><Enter><Enter><End><Enter><End><Enter><Enter>\
                          <Enter><Enter><End><Enter><Enter><End><Enter><End><Enter><Enter>";

/// Makes two hits in the lab, then opens the notebook.
const NOTEBOOK: &str =
    "<Enter>60<Enter>30<Enter><Escape>5<Enter><Enter>60<Enter>30<Enter><Escape>n";
const PLOT: &str = "<Enter>60<Enter>30<Enter><Escape>5<Enter><Enter>60<Enter>30<Enter><Escape>ng";
/// Predicts a hit, and watches it to its end.
const SEEN: &str = "<Enter>60<Enter>30<Enter><Enter><Enter>";

/// Predicts both paths correctly three times, then opens the live picture.
const THREE_RIGHT: &str = "<Enter>60<Enter>30<Enter><Escape><Enter>60<Enter>30<Enter><Escape><Enter>60<Enter>30<Enter><Escape>v";

/// At least one moment in every phase of every screen.
pub(crate) const TOUR: &[TourStop] = &[
    moment("home", "home", ""),
    moment("contents of Learn", "learn", ""),
    moment("contents, a chapter started", "learn", "<Enter>n<Escape>"),
    moment("glossary", "glossary", ""),
    moment("a chapter, a number question", "chapter 1", ""),
    moment("a chapter, a multiple-choice question", "chapter 2", ""),
    moment("a chapter, a rays question", "chapter 2", "nnn"),
    moment("a chapter, a second try", "chapter 2", "a<Enter>"),
    moment("a chapter, an answer shown", "chapter 2", "b<Enter>"),
    moment("a chapter, a hit replayed", "chapter 2", "n"),
    moment("a chapter, a hit rotated", "chapter 1", "nnnnnn"),
    moment("a chapter, its figure", "chapter 2", "<Tab>"),
    moment("a chapter, a worked shot", "chapter 5", "n"),
    moment("a chapter, a shot to solve", "chapter 5", "nnnnnn"),
    moment("a chapter, two frames", "chapter 11", "nnnn"),
    moment(
        "a chapter, the force of a contact",
        "chapter 13",
        "c<Enter>",
    ),
    moment("a chapter, momenta", "chapter 14", "nnn1.67<Enter>"),
    moment("a chapter, the energy in parts", "chapter 15", "c<Enter>"),
    moment("a chapter, the foil", "chapter 10", "nn90<Enter>"),
    moment("a chapter, a beam", "chapter 10", "nnnnc<Enter>"),
    moment("a chapter, 1913", "chapter 10", "nnnnnb<Enter>"),
    moment("lab, setting up", "lab", ""),
    moment("lab, a number typed", "lab", "12"),
    moment("lab, live", "lab", THREE_RIGHT),
    moment("lab, predicting", "lab", "<Enter>"),
    moment("lab, an angle typed", "lab", "<Enter>6"),
    moment(
        "lab, replayed",
        "lab",
        "<Enter>45<Enter>45<Enter><End><End>",
    ),
    moment("lab, explained", "lab", "<Enter>45<Enter>45<Enter><End>"),
    moment("lab, watching", "lab", "<Enter>60<Enter>30<Enter>"),
    moment(
        "lab, a mystery coin",
        "lab",
        "m<Enter>60<Enter>30<Enter><End>",
    ),
    moment(
        "lab, a mass typed",
        "lab",
        "m<Enter>60<Enter>30<Enter><End>5",
    ),
    moment("lab, the notebook", "lab", NOTEBOOK),
    moment("lab, a plot of the notebook", "lab", PLOT),
    moment("lab, an empty notebook", "lab", "n"),
    moment("lab, a hidden outcome", "hidden-lab", ""),
    moment(
        "lab, watching to see",
        "seen-lab",
        "<Enter>60<Enter>30<Enter>",
    ),
    moment("lab, what was seen", "seen-lab", SEEN),
    moment("foil, tracks", "foil", ""),
    moment("foil, counts", "foil", "<Tab>"),
    moment(
        "foil, predicting the share that returns",
        "foil",
        "<Tab><Enter>",
    ),
    moment("foil, a beam running", "foil", "<Tab><Enter>e<Enter>"),
    moment(
        "foil, a beam stopped",
        "foil",
        "<Tab><Enter>e<Enter><Escape>",
    ),
    moment("foil, 1913", "foil", "<Tab><Tab>"),
    moment("choosing a round", "quiz", ""),
    moment("choosing a round, its code", "quiz", "c").taking_any(),
    moment("quiz, rays", "quiz 7", ""),
    moment("quiz, a choice", "quiz separation-7", ""),
    moment("quiz, a number", "quiz speeds-7", ""),
    moment("quiz, a number typed", "quiz speeds-7", "5"),
    moment("quiz, how sure", "quiz 7", "60<Enter>30<Enter>"),
    moment("quiz, watching", "quiz 7", "60<Enter>30<Enter>2"),
    moment("quiz, explained", "quiz 7", "60<Enter>30<Enter>2<End>"),
    moment(
        "quiz, what was seen",
        "seen-quiz 7",
        "60<Enter>30<Enter>2<Enter><Enter>",
    ),
    moment("quiz, looking back", "quiz from-angle2-7", LOOKING_BACK),
    moment(
        "quiz, the misconceptions found",
        "quiz find-out-7",
        FOUND_OUT,
    ),
    moment(
        "quiz, a question looked at again",
        "quiz from-angle1-7",
        "60<Enter>30<Enter>2<End><Enter><Enter>",
    ),
    moment("class, setting up", "class", "").taking_any(),
    moment("class, a team's name", "class", "Ants").taking_any(),
    moment("class, earlier rounds", "class", "<End><Enter>"),
    moment("class, a kind of round", "class", "<Down><Down>"),
    moment("class, described", CLASS, "<Enter>"),
    moment("class, predicting", CLASS, "<Enter><Enter>"),
    moment("class, voting", CLASS, "<Enter><Enter><Enter>"),
    moment(
        "class, a team's vote",
        CLASS,
        "<Enter><Enter><Enter><Enter>",
    ),
    moment(
        "class, a vote given",
        CLASS,
        "<Enter><Enter><Enter><Enter>30<Enter>60<Enter><Home>",
    ),
    moment("class, a blank screen", CLASS, "<Enter>p"),
    moment(
        "class, counting cards",
        "class from-angle2-7",
        "<End><Up><Up><Enter><Enter><Enter>",
    )
    .taking_any(),
    moment("class, talking", CLASS, "<Enter><Enter><Enter><End><Enter>"),
    moment("class, the shot", CLASS, TO_THE_SHOT),
    moment("class, the scores", CLASS, TO_THE_SCORES),
    moment("class, the second question", CLASS, TO_THE_SECOND),
    moment("class, the end", CLASS, TO_THE_END),
    moment("class, the lobby", DEVICES, ""),
    moment("class, who is in", DEVICES, "w"),
    moment("class, a participant chosen", DEVICES, "w<Space>").taking_any(),
    moment("class, described on devices", DEVICES, "<Enter>"),
    moment("class, voting on devices", DEVICES, "<Enter><Enter>"),
    moment(
        "class, talking on devices",
        DEVICES,
        "<Enter><Enter><Enter>",
    ),
    moment(
        "class, the shot on devices",
        DEVICES,
        "<Enter><Enter><Enter><Enter><Enter>",
    ),
    moment(
        "class, the scores on devices",
        DEVICES,
        "<Enter><Enter><Enter><Enter><Enter><End><Enter>",
    ),
    moment("joining", "join", "").taking_any(),
    moment("joining, in", "pupil", ""),
    moment("joining, the vote", "pupil <Enter><Enter>", ""),
    moment(
        "joining, a choice",
        "pupil:both-moving1-7 <Enter><Enter>",
        "",
    ),
    moment(
        "joining, how sure",
        "pupil <Enter><Enter>",
        "60<Enter>30<Enter>",
    ),
    moment(
        "joining, the shot",
        "pupil <Enter><Enter><Enter><Enter><Enter>",
        "",
    ),
    moment(
        "joining, the shot explained",
        "pupil <Enter><Enter><Enter><Enter><Enter>",
        "<End>",
    ),
    moment("levels", "levels", ""),
    moment("a level, aiming", "level square-corner", ""),
    moment("a level, predicting", "level square-corner", "pp<Enter>"),
    moment("a level, watching", "level square-corner", "p<Enter>"),
    moment("a level, all hints", "level square-corner", "hhh"),
    moment("a level, a shot shown", "level square-corner", "hhhh<End>"),
    moment("a level, missed", "level two-at-a-stroke", "p<Enter><End>"),
    moment(
        "a level, an impact",
        "level square-corner",
        "p<Enter><End>i",
    ),
    moment(
        "a level, an impact explained",
        "level square-corner",
        "p<Enter><End>i<End>",
    ),
    moment("table, a new game", "table", ""),
    moment("table, a name typed", "table", TO_A_NAME).taking_any(),
    moment("table, aiming", "table", "<Enter>"),
    moment("table, a number typed", "table", "<Enter>9"),
    moment("table, calling", "table", "<Enter>c<Space>"),
    moment("table, watching", "table", "<Enter><Up><Down><Space>"),
    moment(
        "table, a stroke at its end",
        "table",
        "<Enter><Up><Down><Space><End>",
    ),
    moment("table, impacts", "table", "<Enter><Up><Down><Space><End>i"),
    moment(
        "table, an impact",
        "table",
        "<Enter><Up><Down><Space><End>i<Enter>",
    ),
    moment(
        "table, an impact explained",
        "table",
        "<Enter><Up><Down><Space><End>i<Enter><End>",
    ),
    moment("table, strokes", "table", TWO_STROKES),
    moment("table, the stroke before", "table", STROKE_BEFORE),
    moment("table, practice", "table", "<Left><Enter>"),
    moment("table, placing coins", "table", "<Left><Enter>p"),
    moment("a board", "board 2024-02-26", ""),
    moment("a board, its code typed", "board 2024-02-26", "47"),
    moment("a board, aiming", "board 2024-02-26", "<Enter>"),
    moment(
        "table, saved games",
        "table",
        "<Enter><Up><Down><Space><End><Escape>ys",
    ),
    moment("rules", "rules", ""),
    moment("teacher", "teacher", ""),
    moment("teacher, a code", "teacher", "<Down>").taking_any(),
    moment("teacher, cards", "teacher", "<Down><Down>"),
    moment("measured", "measured", ""),
    moment("measured, all results", "measured", "a"),
    moment("measured, its settings", "measured", "m"),
    moment("measured, a mass typed", "measured", "m3"),
    moment("help at the table", "table", "?").taking_any(),
    moment("progress", "progress", ""),
    moment("settings", "settings", ""),
    moment("settings, the player", "settings", "<End>"),
    moment(
        "settings, the players",
        "quiz from-angle1-7",
        "60<Enter>30<Enter>2<End><Enter><Escape><Escape>s<End><Enter>",
    ),
    moment("settings, a name typed", "settings", "<End><Enter>").taking_any(),
    moment(
        "a chapter page opened from the quiz",
        "quiz 7",
        "20<Enter>20<Enter>2<End>c",
    ),
    moment("help", "lab", "?").taking_any(),
    moment("a question", "home", "<Escape>"),
];

impl TourStop {
    /// The game at this moment, in a window of 80 × 24.
    pub(crate) fn game(&self, settings: Settings) -> Headless {
        let (place, rest) = self.place.split_once(' ').unwrap_or((self.place, ""));
        let number = || rest.parse::<usize>().unwrap_or(1).saturating_sub(1);
        let (place, code) = place.split_once(':').unwrap_or((place, ON_DEVICES));
        match place {
            "host" => return devices(code, self.keys, &settings, |_| Who::Host),
            "pupil" => {
                let mut pupil = devices(code, rest, &settings, |ada| ada);
                pupil.press(self.keys);
                return pupil;
            }
            _ => {}
        }
        let (place, sees) = match place.strip_prefix("seen-") {
            Some(place) => (place, true),
            None => (place, settings.sees),
        };
        let settings = Settings { sees, ..settings };
        let place = match place {
            "learn" => Route::Learn,
            "chapter" => Route::Chapter(number()),
            "lab" => Route::Lab,
            "hidden-lab" => Route::LabOf {
                setup: Default::default(),
                hidden: true,
            },
            "foil" => Route::Foil(FoilPage::default()),
            "quiz" => Route::Quiz(Code::parse(rest)),
            "class" => {
                let mut words = rest.split_whitespace();
                Route::Class {
                    code: words.next().and_then(Code::parse),
                    teams: words.map(str::to_owned).collect(),
                    name: String::new(),
                }
            }
            "join" => Route::Join {
                address: Some(String::new()),
                code: None,
                again: false,
            },
            "glossary" => Route::Glossary,
            "levels" => Route::Levels,
            "level" => Route::Level(Shelf::default().find(rest).expect(rest)),
            "table" => Route::Table,
            "board" => Route::Board(BoardCode::parse(rest).ok()),
            "rules" => Route::Rules(Rules::Tournament),
            "measured" => measured(),
            "teacher" => Route::Teacher,
            "progress" => Route::Progress,
            "settings" => Route::Settings,
            _ => Route::Home,
        };
        let mut game = Headless::new(App::new(place, settings, 7), 80, 24);
        game.press(self.keys);
        game
    }
}

/// The measurement of a shipped example.
pub(crate) fn measured() -> Route {
    let coins = include_bytes!("../../assets/examples/measured/coins.csv");
    let tracks = measure::read(&[("coins.csv", &coins[..])], &Reading::default());
    let given = Given {
        masses: Some([0.0085, 0.0075]),
        radii: Some([0.012_875, 0.011_625]),
        ..Given::default()
    };
    let measurement = Measurement::new(tracks.unwrap_or_default(), given);
    match measurement {
        Ok(measurement) => Route::Measured(measurement.into()),
        Err(_) => Route::Home,
    }
}

/// A class of two pupils on their own devices, after the teacher has pressed these keys. Returns
/// the device that `choose` selects when given the first pupil.
fn devices(
    code: &str,
    teachers: &str,
    settings: &Settings,
    choose: impl FnOnce(Who) -> Who,
) -> Headless {
    let opened = |place, player: &str| {
        let settings = Settings {
            player: player.to_owned(),
            ..settings.clone()
        };
        App::new(place, settings, 7)
    };
    let code = Code::parse(code);
    let name = String::new();
    let mut class = Classroom::new(
        opened(
            Route::Host {
                code,
                name,
                nicknames: false,
            },
            "teacher",
        )
        .into(),
    );
    let [ada, _] = ["Ada", "Bo"].map(|name| {
        let place = Route::Join {
            address: None,
            code: class.code(),
            again: false,
        };
        let pupil = class.add(name, opened(place, name), 80, 24);
        class.game(pupil).press("<Enter>");
        class.settle();
        pupil
    });
    class.game(Who::Host).press(teachers);
    class.settle();
    class.into_game(choose(ada))
}
