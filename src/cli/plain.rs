//! `--plain`: a command as a talk in lines, with no screen control.

use std::io;

use anyhow::anyhow;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::play::any_seed;
use super::{Failure, GlobalOptions, solve};
use crate::files::quoted;
use crate::messages::StoreCall;
use crate::quiz::Code;
use crate::shells::plain::{self, AnswerRecorder, Leave, Talk};

/// A round of the quiz.
pub(super) fn quiz(code: Option<&Code>, options: &GlobalOptions) -> Result<(), Failure> {
    let own = options.own();
    let code = super::round(code, options, &own).map_err(Failure::input)?;
    let seed = options.seed.unwrap_or_else(any_seed);
    with_recorder(options, |recorder| plain::quiz(recorder, code, seed, &own))
}

/// The chapters, from one of them on.
pub(super) fn learn(chapter: Option<&str>, options: &GlobalOptions) -> Result<(), Failure> {
    let book = options.book();
    let library = book.library();
    let chapter = chapter
        .map(|name| library.find(name).ok_or_else(|| unknown(name)))
        .transpose()
        .map_err(Failure::input)?;
    with_recorder(options, |recorder| plain::learn(recorder, library, chapter))
}

fn unknown(name: &str) -> String {
    let what = "the number or the name of a chapter, such as 2 or the-line-of-impact";
    format!("expected {what}, found {}", quoted(name))
}

/// The lab.
pub(super) fn lab() -> Result<(), Failure> {
    talk(plain::lab)
}

/// A worked solution; where it is not said where the two meet, the hit is asked for.
pub(super) fn solve(args: &solve::Args) -> Result<(), Failure> {
    let steps = args.is_complete().then(|| args.steps()).transpose()?;
    talk(|talk| plain::solve(talk, steps.as_deref()))
}

/// Names the commands that know `--plain` where it was given to another.
pub(super) fn advise(message: &mut clap::Error) {
    let unknown = message
        .get(ContextKind::InvalidArg)
        .map(ToString::to_string);
    if message.kind() == ErrorKind::UnknownArgument && unknown.as_deref() == Some("--plain") {
        message.remove(ContextKind::SuggestedArg);
        // It would be the usage of what was suggested.
        message.remove(ContextKind::Usage);
        let known = "plain lines are known to: carrom learn --plain, carrom lab --plain, carrom quiz \
                     --plain, carrom solve --plain";
        message.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![known.into()]),
        );
    }
}

fn with_recorder(
    options: &GlobalOptions,
    run: impl FnOnce(&mut AnswerRecorder) -> Result<(), Leave>,
) -> Result<(), Failure> {
    let mut store = options.store();
    let player = options.player_name();
    let mut keep = |call: &StoreCall| store.answer(call);
    let talked = talk(|talk| run(&mut AnswerRecorder::new(talk, &player, &mut keep)));
    store.pay_at_last().map_err(|lost| anyhow!(lost))?;
    talked
}

/// A talk over standard input and output. To leave it early is no failure.
fn talk(run: impl FnOnce(&mut Talk) -> Result<(), Leave>) -> Result<(), Failure> {
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    match run(&mut Talk::new(&mut input, &mut output)) {
        Ok(()) | Err(Leave::Quit | Leave::Ended) => Ok(()),
        Err(Leave::Failed(error)) => Err(anyhow!(error).into()),
    }
}
