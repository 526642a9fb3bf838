//! The prediction before a beam: the share deflected by more than 90°.

/// The choices, and the share that each stands for. Most are powers of ten, because for a rare
/// event the order of magnitude matters.
pub(crate) const CHOICES: [(&str, f64); 9] = [
    ("all of them", 1.0),
    ("seven in ten", 0.7),
    ("half of them", 0.5),
    ("1 in 10", 1e-1),
    ("1 in 100", 1e-2),
    ("1 in 1,000", 1e-3),
    ("1 in 10,000", 1e-4),
    ("1 in 100,000", 1e-5),
    ("1 in a million", 1e-6),
];

/// The feedback on an answer, now that the share is known.
pub(crate) fn explain(said: f64, share: f64) -> String {
    let off = |choice: f64| (choice / share).log10().abs();
    if CHOICES.iter().all(|(_, other)| off(said) <= off(*other)) {
        return "Right: none of the answers is closer.".into();
    }
    let times = (said / share).max(share / said);
    let times = if times < 10.0 {
        format!("{times:.1}")
    } else {
        // Most choices are powers of ten, so more digits would suggest too much precision.
        super::words::count(super::words::to_figures(times, 2) as u64)
    };
    if said > share {
        format!("You expected a share about {times} times as large.")
    } else {
        format!("The share is about {times} times what you expected.")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_answer_is_right_and_feedback_on_others_gives_the_factor() {
        assert!(explain(0.7, 0.707).starts_with("Right"));
        assert!(explain(1e-5, 8.5e-6).starts_with("Right"));
        assert!(explain(0.5, 8.5e-6).contains("59,000 times as large"));
        assert!(explain(0.5, 0.707).contains("about 1.4 times what you expected"));
    }
}
