//! The command line, with one file per subcommand.

mod board;
mod class;
mod completions;
mod concept;
mod examples;
mod failure;
mod figure;
mod given;
mod glossary;
mod guide;
mod hand_in;
mod keys;
mod lesson;
mod level;
mod man;
mod measure;
mod misconceptions;
mod new;
mod options;
mod page;
mod play;
mod progress;
mod replay;
mod set;
mod simulate;
mod solve;
mod tape;
mod worksheet;
mod written;

use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::{CommandFactory, Parser, Subcommand};
use serde::Serialize;

pub(crate) use failure::Failure;
pub(crate) use options::GlobalOptions;

use crate::app::{App, Data};
use crate::class::JoinCode;
use crate::files::{LONGEST_QUOTE, escape_control, escape_control_lines, quoted, write_json};
use crate::physics::CollisionSpec;
use crate::quiz::{Code, concepts};
use crate::screens::{FoilPage, KeptSettings, Route, code_of, host_of};
use options::Auto;

/// A terminal game that teaches glancing collisions.
///
/// Aim a striker at a coin, set how far off-centre it hits, predict where both will go,
/// then watch the exact collision and its explanation. Without a command, carrom opens
/// the home screen; `?` explains every screen.
#[derive(Debug, Parser)]
#[command(name = "carrom", version, after_help = EXAMPLES)]
pub(crate) struct Cli {
    #[command(flatten)]
    options: GlobalOptions,
    /// Write plain lines without any control codes, for screen readers, Braille displays
    /// and scripts
    #[arg(long, global = true)]
    plain: bool,
    #[command(subcommand)]
    command: Option<Command>,
}

const EXAMPLES: &str = "\
Examples:
  carrom                       open the game
  carrom learn 2               read the second chapter
  carrom lab                   go straight to the lab
  carrom lab --set m2=5.5,b=12 --hide
                               exactly this hit, its outcome hidden until you predict it
  carrom quiz --code mixed-7   a round of the quiz, the same for everyone with this code
  carrom quiz --list mixed-7   its questions, to choose from
  carrom class --set ours.toml the questions that you have chosen, in a class round
  carrom class --teams Ants,Bees --palette light
                               a round for a class, on a projector
  carrom class --host --class 10b
                               the same, with everyone on their own phone or laptop
  carrom class --report 10b --out 10b.html
                               a report of the latest round of 10b, to print
  carrom class --forget 10b    delete everything that is kept about 10b
  carrom join 192.168.43.117   join that class
  carrom levels --levels mine  the levels, with your own from the folder mine
  carrom board                 the board of the day, the same for everyone
  carrom worksheet --seed 7 --count 12 --out sheets
                               a round on paper, with an answer key for the teacher
  carrom progress --csv        every answer you gave, for a spreadsheet
  carrom progress --report me.html
                               a report on your progress, for a portfolio or a teacher
  carrom hand-in --class 10b   every answer in one small file, for a teacher
  carrom gather handed-in --out class.html
                               a gradebook from the files of a class
  carrom misconceptions        every misconception that the program knows
  carrom glossary impulse      a term of mechanics, explained in one sentence
  carrom --charset ascii       for terminals and fonts without Unicode
  carrom solve --alpha-deg 30  solve a collision, step by step
  carrom measure tracks.txt    analyse a filmed collision, with uncertainties
  carrom level check mine.toml check whether your own level can be won
  carrom replay game.toml      replay an exported game, bit for bit
  carrom lesson check mine     check your own chapters
  carrom concept check mine    check your own questions in words
  carrom class --concepts mine ask them in a class round
  carrom figure curves --svg curves.svg
                               a figure from the lessons as a picture
  carrom new level our-level   start your own level (or chapter, or questions)
  carrom guide                 the guides for teachers, to read here or in a browser
  carrom page --levels mine --out our-class.html
                               all of carrom in one file for a browser, with your levels
  carrom keys                  every key, as a file you can edit
  carrom tape hit.tape --svg   play a script without a terminal, save its pictures

Exit status: 0 success, 1 failure, 2 invalid arguments or input.";

#[derive(Debug, Subcommand)]
enum Command {
    #[command(flatten)]
    Open(OpenCommand),
    Solve(solve::Args),
    Simulate(simulate::Args),
    Replay(replay::Args),
    #[command(subcommand)]
    Level(level::Command),
    #[command(subcommand)]
    Lesson(lesson::Command),
    #[command(subcommand)]
    Concept(concept::Command),
    #[command(subcommand)]
    Set(set::Command),
    Misconceptions(misconceptions::Args),
    Glossary(glossary::Args),
    Figure(figure::Args),
    HandIn(hand_in::HandInArgs),
    Gather(hand_in::GatherArgs),
    Page(page::Args),
    Worksheet(worksheet::Args),
    Tape(tape::Args),
    New(new::Args),
    Examples(examples::Args),
    Guide(guide::Args),
    /// Print all keys, as a file you can edit
    Keys,
    Completions(completions::Args),
    /// Print the manual page (carrom man | man -l -)
    Man,
}

/// Commands that open the game at a screen.
#[derive(Debug, Subcommand)]
enum OpenCommand {
    /// Open the lessons: glancing collisions, chapter by chapter
    Learn {
        /// The chapter to open, by its number or name
        chapter: Option<String>,
    },
    /// Open the lab: set up a glancing collision, predict where both discs will go, and see why
    Lab {
        /// The hit to set up, such as m1=15,m2=5.5,b=12,e=0.8 (carrom guide start)
        #[arg(long, value_name = "FIELD=NUMBER,..", value_parser = read_hit)]
        set: Option<CollisionSpec>,
        /// Hide the outcome of this hit until it has been predicted
        #[arg(long, requires = "set")]
        hide: bool,
    },
    /// Open the foil: beams of particles, from the carrom board to the atom
    Foil,
    /// Open the quiz and choose a round (--seed N starts the ten hits of that seed at once)
    Quiz {
        /// The round to play, by its code: mixed-7, speeds6-7, or 7 for ten hits
        #[arg(long, value_name = "CODE", value_parser = Code::read)]
        code: Option<Code>,
        /// The file of the set to play: questions that you have chosen
        #[arg(long, value_name = "FILE", conflicts_with = "code")]
        set: Option<PathBuf>,
        /// Print the questions for a code instead
        #[arg(long, value_name = "CODE", value_parser = Code::read, conflicts_with_all = ["code", "set"])]
        list: Option<Code>,
        /// Print them as one JSON object
        #[arg(long, requires = "list")]
        json: bool,
    },
    Class(class::Args),
    /// Join a class from your own device
    Join {
        /// The address of the class, as shown on the board: 192.168.43.117:8090
        #[arg(value_parser = |address: &str| read_host(address))]
        address: Option<String>,
        /// The code of the class, as shown on the board: BCDFGH
        #[arg(long, value_name = "CODE")]
        code: Option<JoinCode>,
    },
    /// Open the table: carrom itself, the whole board
    Table,
    Board(board::Args),
    Measure(measure::Args),
    Progress(progress::Args),
    /// Open the screen for teachers: worksheets, cards, Moodle, reports, the gradebook, the guides
    Teacher {
        /// The page for browsers (default: the one in this program, or carrom.html beside it)
        #[arg(long, value_name = "FILE")]
        page: Option<PathBuf>,
    },
    /// Open the settings: appearance, motion, the player
    Settings,
    /// Open the levels: small puzzles on the board, solved by aiming
    Levels {
        /// The level to play, by its ID or PACK/ID
        name: Option<String>,
    },
}

/// Reads a hit for the lab; a colon is accepted in place of `=`, as in links.
fn read_hit(text: &str) -> Result<CollisionSpec, String> {
    let read = CollisionSpec::from_link(&text.replace('=', ":"));
    read.map_err(|expected| match expected.contains("expected") {
        true => expected,
        false => format!("expected {}", expected.replace(':', "=")),
    })
}

/// Reads a typed address of a class.
fn read_host(address: &str) -> Result<String, String> {
    match host_of(address) {
        Some(_) => Ok(address.to_owned()),
        None => Err("expected an address, such as 192.168.43.117:8090".into()),
    }
}

impl OpenCommand {
    /// The given port for serving a class, and the given page for browsers.
    fn port_and_page(&self) -> (Option<u16>, Option<&Path>) {
        match self {
            Self::Class(args) => (args.port, args.page.as_deref()),
            Self::Teacher { page } => (None, page.as_deref()),
            _ => (None, None),
        }
    }

    /// Whether the command opens a screen rather than printing.
    fn opens(&self) -> bool {
        match self {
            Self::Progress(args) => !args.prints(),
            Self::Board(args) => !args.json,
            Self::Class(args) => !args.prints(),
            Self::Measure(args) => args.screen,
            Self::Quiz { list, .. } => list.is_none(),
            _ => true,
        }
    }

    /// Prints or writes something, if the command does not open a screen.
    fn print(&self, options: &GlobalOptions) -> Result<(), Failure> {
        match self {
            Self::Progress(args) => progress::run(args, options),
            Self::Board(args) => board::run(args),
            Self::Class(args) => class::run(args, options),
            Self::Measure(args) => measure::run(args, options),
            Self::Quiz {
                list: Some(code),
                json,
                ..
            } => set::list(code, *json, options),
            _ => Ok(()),
        }
    }

    /// The file of the set to play.
    fn set(&self) -> Option<&Path> {
        match self {
            Self::Quiz { set, .. } => set.as_deref(),
            Self::Class(args) => args.set.as_deref(),
            _ => None,
        }
    }

    /// The screen to open, given these levels, chapters, questions and options.
    ///
    /// # Errors
    /// If there is no level or chapter with that name, or no question for a code.
    fn route(&self, data: &Data, options: &GlobalOptions) -> Result<Route, String> {
        Ok(match self {
            Self::Learn { chapter } => named(data, "learn", chapter.as_deref())?,
            Self::Lab { set, hide } => set.map_or(Route::Lab, |setup| Route::LabOf {
                setup,
                hidden: *hide,
            }),
            Self::Quiz { code, .. } => {
                // If only a seed is given, the round has ten hits.
                let code = filled(code.as_ref(), &data.own)?;
                Route::Quiz(code.or_else(|| options.seed.map(Code::hits)))
            }
            Self::Class(args) => args.route(filled(args.code.as_ref(), &data.own)?)?,
            Self::Join { address, code } => Route::Join {
                code: code.or_else(|| code_of(address.as_deref()?)),
                address: Some(address.as_deref().and_then(host_of).unwrap_or_default()),
                again: false,
            },
            Self::Foil => Route::Foil(FoilPage::default()),
            Self::Table => Route::Table,
            Self::Board(args) => Route::Board(args.code()),
            Self::Progress(_) => Route::Progress,
            Self::Measure(args) => Route::Measured(Arc::new(
                args.measurement().map_err(|it| it.error().to_string())?,
            )),
            Self::Teacher { .. } => Route::Teacher,
            Self::Settings => Route::Settings,
            Self::Levels { name } => named(data, "levels", name.as_deref())?,
        })
    }
}

/// The names of the teams of a class.
type Teams = Vec<String>;

/// The code of the given set, or a code completed with the teacher's own questions if it requires
/// them.
///
/// # Errors
/// If the round requires a teacher's own questions and there are none.
fn filled(code: Option<&Code>, own: &Arc<concepts::Library>) -> Result<Option<Code>, String> {
    if let Some(set) = own.sets.first() {
        return Ok(Some(Code::of_set(set)));
    }
    code.cloned().map(|code| code.with_own(own)).transpose()
}

/// The route with this name that shows `value`, or the route's start if there is no value.
///
/// # Errors
/// If no page of that route shows the value.
fn named(data: &Data, name: &str, value: Option<&str>) -> Result<Route, String> {
    let value = value.unwrap_or_default();
    let route = data.route(name, value);
    route.map_err(|expected| format!("expected {expected}, found {}", quoted(value)))
}

/// The app with these options, opened at a screen, or at the home screen if that is `None`.
///
/// # Errors
/// What is wrong with the arguments.
fn app(
    screen: Option<&OpenCommand>,
    options: &GlobalOptions,
    folder: Option<&Path>,
    auto: Auto,
    seed: u64,
) -> Result<App, String> {
    let data = Data {
        shelf: options.shelf(),
        book: options.book(),
        own: options.own_with(screen.and_then(OpenCommand::set))?,
        folder: folder.map(|folder| folder.display().to_string()),
    };
    let route = screen.map_or(Ok(Route::Home), |screen| screen.route(&data, options))?;
    let kept = folder.map_or_else(|| Ok(KeptSettings::default()), given::settings);
    let set = options.settings(auto, kept.as_ref().unwrap_or(&KeptSettings::default()));
    let mut app = App::with_data(data, route, set, seed);
    match kept {
        Ok(kept) => app.set_kept(Some(kept)),
        Err(errors) => {
            app.set_kept(None);
            app.notify(format!(
                "carrom uses the default settings and does not save your changes; the file is unchanged. {errors}"
            ));
        }
    }
    match folder.map(keys::rebound) {
        None => {}
        Some(Ok(rebound)) => app.settings_mut().keys = rebound,
        Some(Err(errors)) => app.notify(format!("carrom uses the default keys. {errors}")),
    }
    Ok(app)
}

impl Cli {
    /// Checks combinations of options that clap cannot check.
    ///
    /// # Errors
    /// What was expected.
    fn check(&self) -> Result<(), String> {
        let (code, set) = match &self.command {
            Some(Command::Open(OpenCommand::Quiz { code, set, .. })) => (code, set),
            Some(Command::Open(OpenCommand::Class(args))) => (&args.code, &args.set),
            Some(Command::Worksheet(args)) => (&args.code, &args.set),
            _ => (&None, &None),
        };
        let has_plain_lines = matches!(
            &self.command,
            None | Some(Command::Open(_) | Command::Solve(_))
        );
        if self.plain && !has_plain_lines {
            return Err(
                "--plain works only with a screen, such as carrom quiz --plain, and with \
                 carrom solve"
                    .into(),
            );
        }
        let other = match (code, set) {
            (Some(_), _) => "--code, not both: a code contains its seed",
            (None, Some(_)) => "--set, not both: a set always has the same questions",
            (None, None) => return Ok(()),
        };
        match self.options.seed {
            Some(_) => Err(format!("use either --seed or {other}")),
            None => Ok(()),
        }
    }
}

/// Runs the command in the arguments (the first is the program's name).
///
/// # Errors
/// What went wrong, with its exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<ExitCode, Failure> {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(message) => {
            // Help goes to standard output, errors to standard error. If neither can be
            // written, there is no way to report that.
            let _ = say(&message);
            return Ok(ExitCode::from(if message.use_stderr() { 2 } else { 0 }));
        }
    };
    cli.check().map_err(Failure::input)?;
    let options = &cli.options;
    let done = match &cli.command {
        None => return play::run(options, None, cli.plain),
        Some(Command::Open(screen)) if screen.opens() => {
            return play::run(options, Some(screen), cli.plain);
        }
        Some(Command::Open(command)) => command.print(options),
        Some(Command::Solve(args)) if args.plain => solve::plain(args),
        Some(Command::Solve(args)) => return solve::run(args, options),
        Some(Command::Simulate(args)) => simulate::run(args),
        Some(Command::Replay(args)) => replay::run(args),
        Some(Command::Level(command)) => level::run(command, options),
        Some(Command::Lesson(command)) => lesson::run(command, options),
        Some(Command::Concept(command)) => concept::run(command, options),
        Some(Command::Set(command)) => set::run(command, options),
        Some(Command::Misconceptions(args)) => misconceptions::run(args, options),
        Some(Command::Glossary(args)) => glossary::run(args, options),
        Some(Command::HandIn(args)) => hand_in::hand_in(args, options),
        Some(Command::Gather(args)) => hand_in::gather(args, options),
        Some(Command::Figure(args)) => figure::run(args, options),
        Some(Command::Page(args)) => page::run(args, options),
        Some(Command::Worksheet(args)) => worksheet::run(args, options),
        Some(Command::Tape(args)) => tape::run(args, options),
        Some(Command::New(args)) => new::run(args),
        Some(Command::Examples(args)) => examples::run(args),
        Some(Command::Guide(args)) => guide::run(args, options),
        Some(Command::Keys) => keys::run(options),
        Some(Command::Completions(args)) => completions::run(args, Cli::command()),
        Some(Command::Man) => man::run(Cli::command()),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// Prints an error in the arguments, or help. An error is printed without colour if an argument is
/// too long to quote in full, or contains characters that control a terminal.
fn say(message: &clap::Error) -> io::Result<()> {
    let words = env::args_os().map(|word| word.to_string_lossy().into_owned());
    let odd: Vec<_> = words.filter(is_odd).collect();
    if odd.is_empty() || !message.use_stderr() {
        return message.print();
    }
    let plain = quoting_briefly(message.to_string(), &odd);
    writeln!(io::stderr(), "{}", escape_control_lines(&plain))
}

/// Whether a word is too long to quote in full, or contains characters that control a terminal.
fn is_odd(word: &String) -> bool {
    escape_control(word, LONGEST_QUOTE) != *word
}

/// The message with each of the `odd` arguments shortened if it is too long.
fn quoting_briefly(mut message: String, odd: &[String]) -> String {
    for word in odd {
        // clap quotes only the value after the `=`.
        let value = word
            .split_once('=')
            .map_or(word.as_str(), |(_, value)| value);
        for long in [word, value] {
            if long.len() > LONGEST_QUOTE {
                message = message.replace(long, &escape_control(long, LONGEST_QUOTE));
            }
        }
    }
    message
}

/// The app that `carrom` opens with these arguments (in one string, which is split into words as in
/// a shell), for use without a terminal. By default it uses ASCII, no colour and a fixed seed.
///
/// # Errors
/// What is wrong with the arguments.
pub fn open(arguments: &str) -> Result<App, String> {
    open_within(arguments, &GlobalOptions::default()).map(|(app, _)| app)
}

/// Like [`open`], but takes missing options from `outer`, and also returns the options.
fn open_within(arguments: &str, outer: &GlobalOptions) -> Result<(App, GlobalOptions), String> {
    let words = shlex::split(arguments).ok_or("expected a closing quote in the arguments")?;
    let odd: Vec<_> = words.iter().filter(|it| is_odd(it)).cloned().collect();
    let words = std::iter::once("carrom".to_owned()).chain(words);
    let cli = Cli::try_parse_from(words).map_err(|error| {
        let message = quoting_briefly(error.to_string(), &odd);
        let first = message.lines().next().unwrap_or_default();
        first.strip_prefix("error: ").unwrap_or(first).to_owned()
    })?;
    cli.check()?;
    let screen = match &cli.command {
        None if !cli.plain => None,
        Some(Command::Open(screen)) if !cli.plain && screen.opens() => Some(screen),
        _ => return Err("expected a command that opens a screen".into()),
    };
    let options = cli.options.or(outer);
    let seed = options.seed.unwrap_or(1);
    let folder = options.given_data_dir();
    let app = app(screen, &options, folder, Auto::PLAINEST, seed)?;
    Ok((app, options))
}

/// Writes a string, which may contain any characters, to standard output in the charset of the
/// options.
fn print_text(text: &str, options: &GlobalOptions) -> Result<(), Failure> {
    let mut text = escape_control_lines(&options.printed().text(text));
    if !text.is_empty() {
        text.push('\n');
    }
    print(text.as_bytes())
}

/// Writes one JSON object on its own line.
fn write_json_line(out: &mut impl Write, object: &impl Serialize) -> io::Result<()> {
    write_json(out, object)?;
    out.write_all(b"\n")
}

/// Prints one JSON object on its own line.
fn print_json(object: &impl Serialize) -> Result<(), Failure> {
    let mut line = Vec::new();
    write_json_line(&mut line, object)?;
    print(&line)
}

/// Prints the names of written files, one per line.
fn print_names<'a, T: 'a>(
    documents: impl IntoIterator<Item = &'a (PathBuf, T)>,
) -> Result<(), Failure> {
    let names = documents
        .into_iter()
        .map(|(path, _)| format!("{}\n", path.display()));
    print(names.collect::<String>().as_bytes())
}

/// Writes to standard output. A reader that stops early (`carrom man | head`) is not an
/// error.
fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::{Charset, Depth};

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn arguments_in_one_string_open_an_app() {
        let app = open("quiz --seed 7 --charset unicode --player 'Ada L'").unwrap();
        assert_eq!(app.settings().charset, Charset::Unicode);
        assert_eq!(app.settings().depth, Depth::None);
        assert_eq!(app.settings().player, "Ada L");
        assert!(open("quiz --code mixed-7").is_ok());
    }

    #[test]
    fn errors_in_arguments_are_reported() {
        let wrong = |arguments| open(arguments).err().unwrap_or_default();
        assert_eq!(wrong("lab 'x"), "expected a closing quote in the arguments");
        assert_eq!(wrong("man"), "expected a command that opens a screen");
        assert_eq!(wrong("lob"), "unrecognized subcommand 'lob'");
        assert!(wrong("quiz --seed x").starts_with("invalid value 'x' for '--seed <N>'"));
        let no_code = wrong("quiz --code mixed");
        assert!(
            no_code.starts_with("invalid value 'mixed' for '--code <CODE>'"),
            "{no_code}"
        );
        assert!(
            no_code.contains("expected the code of a round"),
            "{no_code}"
        );
    }
}
