//! Answering a question in lines.

use super::number::number;
use super::spoken::unit_name;
use super::talk::{Leave, Talk};
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
            let unit = unit_words(quantity);
            let asked = format!("Your answer{unit}?");
            let help = format!("Type a number{unit}, such as 2.5. Type skip to leave it open.");
            let (least, most) = (quantity.smallest(), quantity.largest());
            let read = |heard: &str| number(heard, quantity.unit(), least, most);
            let said = talk.ask_or_skip(question, &asked, &help, read)?;
            Ok(said.map(Response::Number))
        }
        Form::Choice { options, .. } => choose(talk, question, options),
        Form::Shot(aim) => {
            let most_mm = aim.furthest_offset_mm();
            let asked = "Your offset in millimetres? A minus puts the coin to the left.";
            let help = "The offset is how far the coin's centre lies from the striker's path: 0 is \
                        head-on. Type a number in millimetres, or skip.";
            let read = |heard: &str| number(heard, "mm", -most_mm, most_mm);
            let offset_mm = talk.ask_or_skip(question, asked, help, read)?;
            Ok(offset_mm.map(|offset_mm| Response::Shot(m_from_mm(offset_mm))))
        }
    }
}

/// Hears which of these it is; `None` if that is skipped.
pub(super) fn choose(
    talk: &mut Talk,
    question: &[String],
    options: &[String],
) -> Result<Option<Response>, Leave> {
    let mut lead = question.to_vec();
    let lettered = options.iter().enumerate();
    lead.extend(lettered.map(|(i, option)| format!("{}: {option}", letter(i))));
    let help = "Type the letter of your choice. Type skip to leave it open.";
    let read = |heard: &str| choice(heard, options.len());
    let chosen = talk.ask_or_skip(&lead, "Which one?", help, read)?;
    Ok(chosen.map(Response::Choice))
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
    let read = |heard: &str| match heard.to_lowercase().as_str() {
        "still" => Ok(None),
        angle => number(angle, "°", -180.0, 180.0)
            .map(|angle| Some(side * rad_from_deg(angle)))
            .map_err(|_| "Please type an angle from minus 180 to 180, or still.".to_owned()),
    };
    let asked = format!(
        "The striker's angle in degrees? Plus is away from the {target}, minus to its side."
    );
    let Some(striker) = talk.ask_or_skip(question, &asked, &help, read)? else {
        return Ok(None);
    };
    let asked = format!("The {target}'s angle in degrees? Plus is to its own side, minus across.");
    let target = talk.ask_or_skip(&[], &asked, &help, read)?;
    Ok(target.map(|target| Response::Rays(Rays { striker, target })))
}

/// Hears how sure the player is.
pub(super) fn confidence(talk: &mut Talk) -> Result<Confidence, Leave> {
    let asked = "How sure are you? 1 guess, 2 think so, 3 sure.";
    let help = "Sure brings 10 points if you are right and takes 6 if you are not; think so brings \
                9 or takes 2; guess brings 7 or nothing. The honest answer is the one that pays.";
    let read = |heard: &str| match heard.to_lowercase().as_str() {
        "1" | "guess" => Ok(Confidence::Guess),
        "2" | "think so" | "think-so" => Ok(Confidence::ThinkSo),
        "3" | "sure" => Ok(Confidence::Sure),
        _ => Err("Please type 1, 2 or 3.".to_owned()),
    };
    talk.ask_for(&[], asked, help, read)
}

/// Reads the letter or the number of a choice.
fn choice(heard: &str, count: usize) -> Result<usize, String> {
    let is_named = |at: &usize| {
        let (letter, number) = (letter(*at).to_string(), (at + 1).to_string());
        heard.eq_ignore_ascii_case(&letter) || heard == number
    };
    let last = letter(count.saturating_sub(1));
    let chosen = (0..count).find(is_named);
    chosen.ok_or_else(|| format!("Please type a letter from A to {last}."))
}

/// The unit of a quantity as it follows "your answer".
fn unit_words(quantity: &Measure) -> String {
    match quantity {
        Measure::Times => ", how many times".into(),
        _ if quantity.unit().is_empty() => String::new(),
        _ => format!(" in {}", unit_name(quantity.unit())),
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
