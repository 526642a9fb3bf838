//! The keys that enter an answer.

use carrom::quiz::{Form, Response};

/// The keys that enter the response `said` to a question of this form.
pub(crate) fn said(form: &Form, said: &Response) -> String {
    match (form, said) {
        (Form::Rays { side, .. }, Response::Rays(rays)) => [rays.striker, rays.target]
            .map(|angle| match angle {
                Some(angle) => format!("{:.1}<Enter>", side * angle.to_degrees() + 0.0),
                None => "x<Enter>".into(),
            })
            .concat(),
        (_, Response::Number(x)) => format!("{x:.3}<Enter>"),
        (_, Response::Choice(i)) => format!("{}<Enter>", char::from(b'a' + *i as u8)),
        (_, Response::Shot(offset)) => format!("{:.2}<Enter>", offset * 1000.0),
        _ => unreachable!("the response does not fit the form"),
    }
}
