//! Answering a question in lines.

use super::number::number;
use super::talk::{Leave, Prompt, Talk};
use crate::physics::units::{m_from_mm, rad_from_deg};
use crate::quiz::{Confidence, Form, Measure, Rays, Response, letter};

/// Hears the answer to a question in its form; `None` if it is skipped.
pub(super) fn answer(
    talk: &mut Talk,
    question: &[String],
    form: &Form,
) -> Result<Option<Response>, Leave> {
    match form {
        Form::Rays { side, target, .. } => rays(talk, question, *side, target),
        Form::Number { quantity, .. } => {
            let unit = unit_words(*quantity);
            let help = format!("Type a number{unit}, such as 2.5. Type skip to leave it open.");
            let lines = [question, &[format!("Your answer{unit}?")]].concat();
            let asked = Prompt {
                lines: &lines,
                help: &help,
            };
            let read = |heard: &str| {
                let (least, most) = (quantity.smallest(), quantity.largest());
                skipped(heard, |heard| number(heard, quantity.unit(), least, most))
            };
            Ok(talk.ask_for(&asked, read)?.map(Response::Number))
        }
        Form::Choice { options, .. } => Ok(choose(talk, question, options)?.map(Response::Choice)),
        Form::Shot(aim) => {
            let most_mm = (1.1e3 * aim.collision.contact_distance()).ceil();
            let line = "Your offset in millimetres? A minus puts the coin to the left.";
            let lines = [question, &[line.to_owned()]].concat();
            let asked = Prompt {
                lines: &lines,
                help: "The offset is how far the coin's centre lies from the striker's path: 0 is \
                       head-on. Type a number in millimetres, or skip.",
            };
            let read = |heard: &str| skipped(heard, |heard| number(heard, "mm", -most_mm, most_mm));
            let offset_mm = talk.ask_for(&asked, read)?;
            Ok(offset_mm.map(|offset_mm| Response::Shot(m_from_mm(offset_mm))))
        }
    }
}

/// Hears which of these it is; `None` if that is skipped.
pub(super) fn choose(
    talk: &mut Talk,
    question: &[String],
    options: &[String],
) -> Result<Option<usize>, Leave> {
    let mut lines = question.to_vec();
    let lettered = options.iter().enumerate();
    lines.extend(lettered.map(|(i, option)| format!("{}: {option}", letter(i))));
    lines.push("Which one?".into());
    let asked = Prompt {
        lines: &lines,
        help: "Type the letter of your choice. Type skip to leave it open.",
    };
    talk.ask_for(&asked, |heard| {
        skipped(heard, |heard| choice(heard, options.len()))
    })
}

/// Hears two rays, one after the other.
pub(super) fn rays(
    talk: &mut Talk,
    question: &[String],
    side: f64,
    target: &str,
) -> Result<Option<Response>, Leave> {
    let help = format!(
        "Type an angle in degrees from the striker's old direction, such as 30, or still for a \
         disc that stays where it is. The striker counts to the side away from the {target}, the \
         {target} to its own side; a minus turns to the other side. Rims are smooth unless the \
         question says otherwise. Type skip to leave it open."
    );
    let striker = [
        question,
        &[format!(
            "The striker's angle in degrees, to the side away from the {target}?"
        )],
    ]
    .concat();
    let target = [format!("The {target}'s angle in degrees, to its own side?")];
    let read = |heard: &str| {
        skipped(heard, |heard| match heard.to_lowercase().as_str() {
            "still" => Ok(None),
            angle => number(angle, "°", -180.0, 180.0)
                .map(Some)
                .map_err(|_| "Please type an angle from minus 180 to 180, or still.".to_owned()),
        })
    };
    let mut angles = [None; 2];
    for (angle, lines) in angles.iter_mut().zip([striker.as_slice(), &target]) {
        let asked = Prompt { lines, help: &help };
        match talk.ask_for(&asked, read)? {
            Some(said) => *angle = said,
            None => return Ok(None),
        }
    }
    let signed = |angle: Option<f64>| angle.map(|angle| side * rad_from_deg(angle));
    Ok(Some(Response::Rays(Rays {
        striker: signed(angles[0]),
        target: signed(angles[1]),
    })))
}

/// Hears how sure the player is.
pub(super) fn confidence(talk: &mut Talk) -> Result<Confidence, Leave> {
    let lines = ["How sure are you? 1 guess, 2 think so, 3 sure.".to_owned()];
    let asked = Prompt {
        lines: &lines,
        help: "Sure brings 10 points if you are right and takes 6 if you are not; think so brings \
               9 or takes 2; guess brings 7 or nothing. The honest answer is the one that pays.",
    };
    talk.ask_for(&asked, |heard| match heard.to_lowercase().as_str() {
        "1" | "guess" => Ok(Confidence::Guess),
        "2" | "think so" | "think-so" => Ok(Confidence::ThinkSo),
        "3" | "sure" => Ok(Confidence::Sure),
        _ => Err("Please type 1, 2 or 3.".into()),
    })
}

/// Reads an answer that may be left open.
pub(super) fn skipped<T>(
    heard: &str,
    read: impl Fn(&str) -> Result<T, String>,
) -> Result<Option<T>, String> {
    match heard.to_lowercase().as_str() {
        "skip" | "s" => Ok(None),
        _ => read(heard).map(Some),
    }
}

/// Reads the letter or the number of a choice.
fn choice(heard: &str, count: usize) -> Result<usize, String> {
    let expected = || {
        format!(
            "Please type a letter from A to {}.",
            letter(count.saturating_sub(1))
        )
    };
    let mut letters = heard.chars();
    let (Some(first), None) = (letters.next(), letters.next()) else {
        return Err(expected());
    };
    let index = match first.to_ascii_lowercase() {
        c @ 'a'..='z' => c as usize - 'a' as usize,
        c @ '1'..='9' => c as usize - '1' as usize,
        _ => return Err(expected()),
    };
    if index < count {
        Ok(index)
    } else {
        Err(expected())
    }
}

/// The unit of a quantity as it follows "your answer".
pub(super) fn unit_words(quantity: Measure) -> &'static str {
    match quantity {
        Measure::Angle => " in degrees",
        Measure::Share => " in percent",
        Measure::Speed => " in metres per second",
        Measure::Mass => " in grams",
        Measure::Length => " in millimetres",
        Measure::Times => ", how many times",
        Measure::Restitution => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_letters_or_numbers() {
        assert_eq!(
            (choice("b", 3), choice("C", 3), choice("1", 3)),
            (Ok(1), Ok(2), Ok(0))
        );
        for heard in ["d", "4", "0", "", "ab", "é"] {
            assert!(choice(heard, 3).is_err(), "{heard}");
        }
    }
}
