//! Which answers the form of a question accepts.

use carrom::quiz::{Code, Form, Rays, Response, Round};

/// The forms of many rounds, each with realistic answers: the right answer, and the answers
/// that misconceptions lead to.
fn asked() -> Vec<(Form, Vec<Response>)> {
    let codes = (1..=60)
        .flat_map(|seed| ["mixed", "concept", "quick"].map(|course| format!("{course}-{seed}")));
    let rounds = codes.map(|code| Round::of(Code::parse(&code).unwrap()));
    let questions = rounds.flat_map(|round| round.questions().to_vec());
    let said = questions.map(|question| {
        let held = question.beliefs.iter().map(|belief| belief.said);
        let said = std::iter::once(question.form.truth()).chain(held).collect();
        (question.form, said)
    });
    said.collect()
}

#[test]
fn every_form_accepts_its_true_answer_and_those_of_misconceptions_also_when_stored() {
    for (form, said) in asked() {
        for said in said {
            assert!(form.accepts(&said), "{said:?} {form:?}");
            let kept = Response::parse(&said.to_text()).unwrap();
            assert!(form.accepts(&kept), "{kept:?} {form:?}");
        }
    }
}

#[test]
fn no_form_accepts_an_answer_out_of_range_or_of_another_kind() {
    let mut kinds = [0; 4];
    for (form, _) in asked() {
        let kind = match form {
            Form::Rays { .. } => 0,
            Form::Number { .. } => 1,
            Form::Choice { .. } => 2,
            Form::Shot(_) => 3,
        };
        kinds[kind] += 1;
        let wide = Rays::new(180.1_f64.to_radians(), 0.0);
        let still = Rays {
            striker: None,
            target: None,
        };
        let least = match &form {
            Form::Number { quantity, .. } => quantity.smallest(),
            _ => 0.0,
        };
        for (of_kind, said, fits) in [
            (0, Response::Rays(still), true),
            (0, Response::Rays(Rays::new(3.1, -3.1)), true),
            (0, Response::Rays(wide), false),
            (0, Response::Rays(Rays::new(0.0, f64::NAN)), false),
            (0, Response::Rays(Rays::new(f64::INFINITY, 0.0)), false),
            (1, Response::Number(0.5), true),
            (1, Response::Number(least - 0.1), false),
            (1, Response::Number(100_000.0), false),
            (1, Response::Number(f64::NAN), false),
            (2, Response::Choice(1), true),
            (2, Response::Choice(5), false),
            (2, Response::Choice(usize::MAX), false),
            (3, Response::Shot(0.0), true),
            (3, Response::Shot(1.0), false),
            (3, Response::Shot(f64::NEG_INFINITY), false),
        ] {
            let fits = fits && of_kind == kind;
            assert_eq!(form.accepts(&said), fits, "{said:?} {form:?}");
        }
    }
    assert!(kinds.iter().all(|count| *count > 0), "{kinds:?}");
}
