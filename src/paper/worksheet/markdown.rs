//! The question sheet and the answer key in Markdown.

use super::pictures::{ANSWER, QUESTION};
use super::{Worksheet, WorksheetPicture, pictures, words};
use crate::numbers;
use crate::paper::Markdown;
use crate::quiz::{Confidence, Form, Measure, letter};

/// A short line to write on, a long one, and a tick box.
const BLANK: &str = "____________";
const LINE: &str = "________________________________";
const BOX: char = '☐';

fn head(document: &mut Markdown, worksheet: &Worksheet, kind: &str, title: &str) {
    let questions = numbers::counted(worksheet.round.questions().len(), "question");
    let command = worksheet.command();
    let command = command.map_or(String::new(), |it| format!(" · on screen: {it}"));
    let code = worksheet.code();
    let line = format!("carrom · {kind} · {questions} · code {code}{command}");
    document.heading(1, title).paragraph(&line);
}

impl Worksheet<'_> {
    /// The questions in Markdown; the [pictures](Self::pictures) are in `folder`, beside the
    /// document.
    pub fn sheet_markdown(&self, folder: &str) -> String {
        let mut document = Markdown::new();
        head(&mut document, self, "worksheet", &self.title);
        document
            .paragraph(&format!("Name {LINE} Class {BLANK} Date {BLANK}"))
            .paragraph(words::ADVICE)
            .paragraph(&words::worth(self.round.questions()));
        for (number, question) in (1..).zip(self.round.questions()) {
            document
                .heading(2, &number.to_string())
                .paragraph(&question.text);
            let picture = WorksheetPicture::new(QUESTION, number, pictures::of_question(question));
            if let Some(WorksheetPicture { name, svg }) = picture {
                document.picture(svg.words(), &format!("{folder}/{name}"));
            }
            if let Some(task) = words::task(question) {
                document.paragraph(task);
            }
            room(&mut document, &question.form);
            let sure = Confidence::ALL.map(|sure| format!("{BOX} {}", sure.name()));
            let points = words::of_points(question);
            let sure = sure.join(" ");
            document.paragraph(&format!("How sure? {sure} · {BLANK}{points}"));
        }
        document.text().to_owned()
    }

    /// The answers in Markdown; the [pictures](Self::pictures) are in `folder`, beside the
    /// document.
    pub fn key_markdown(&self, folder: &str) -> String {
        let mut document = Markdown::new();
        let questions = self.round.questions();
        head(&mut document, self, "key", &self.key_title());
        document
            .paragraph(words::KEY_ADVICE)
            .heading(2, "At a glance")
            .numbered(questions.iter().map(words::truth))
            .paragraph(&words::tolerance())
            .paragraph(&words::points());
        for (number, question) in (1..).zip(questions) {
            document
                .heading(2, &format!("{number} {}", question.topic))
                .paragraph(&question.text)
                .strong(&words::truth(question))
                .paragraph(&question.why);
            let picture = WorksheetPicture::new(ANSWER, number, pictures::of_answer(question));
            if let Some(WorksheetPicture { name, svg }) = picture {
                document.picture(svg.words(), &format!("{folder}/{name}"));
            }
            let wrong = question.wrong_answers();
            if !wrong.is_empty() {
                let rows = wrong.into_iter().map(|(said, misconception, says)| {
                    let revealed = misconception.map_or_else(
                        || says.to_owned(),
                        |misconception| format!("{}: {says}", misconception.name()),
                    );
                    vec![words::said(question, &said), revealed]
                });
                document.table(&words::WRONG_ANSWERS, rows);
            }
        }
        document.text().to_owned()
    }
}

/// Space for an answer of this form.
fn room(document: &mut Markdown, form: &Form) {
    match form {
        Form::Rays { target, .. } => document.list(["striker", target].map(|name| {
            let name = numbers::capital(name);
            format!("{name}: {BLANK}° {BOX} left {BOX} right {BOX} stays still")
        })),
        Form::Number { quantity, .. } => {
            let name = match quantity {
                Measure::Restitution => "Answer: e =",
                _ => "Answer:",
            };
            let blank = numbers::with_unit(BLANK, quantity.unit());
            document.paragraph(&format!("{name} {blank}"))
        }
        Form::Choice { options, .. } => document.list(
            (0..)
                .zip(options)
                .map(|(i, option)| format!("{BOX} {}: {option}", letter(i))),
        ),
        Form::Shot(_) => document.paragraph(&format!("Offset: {BLANK} mm {BOX} left {BOX} right")),
    };
}
