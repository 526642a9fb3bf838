//! The lines of a worked solution in spoken form.

use crate::physics::worked::WorkedStep;

/// The lines of a step: columns are separated by commas, and a line that continues the one before
/// is joined to it.
pub(super) fn lines(step: &WorkedStep) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for line in &step.lines {
        let columns = line.trim().split("  ").map(str::trim);
        let columns: Vec<&str> = columns.filter(|it| !it.is_empty()).collect();
        let line_alone = columns.join(", ").replace(",,", ",");
        match (line.starts_with(' '), lines.last_mut()) {
            (true, Some(before)) => {
                let joint = if line_alone.starts_with('=') {
                    " "
                } else {
                    ", "
                };
                *before = format!("{before}{joint}{line_alone}");
            }
            _ => lines.push(line_alone),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;
    use crate::physics::worked::steps;
    use crate::shells::plain::spoken;

    #[test]
    fn every_line_starts_with_its_subject() {
        let collision = CollisionSpec::default().collision();
        let steps = steps(&collision, false);
        let said: Vec<String> = steps.iter().flat_map(lines).collect();
        for line in &said {
            assert!(
                !line.starts_with(['=', ' ']) && !line.contains("  "),
                "{line}"
            );
        }
        let knowns: Vec<String> = said.iter().take(3).map(|line| spoken(line)).collect();
        assert_eq!(
            knowns,
            [
                "striker, m 1 equals 15 grams, u 1 equals (4, 0) metres per second, speed 4 metres \
                 per second",
                "target, m 2 equals 15 grams, u 2 equals 0, at rest",
                "impact angle, alpha equals 30 degrees",
            ]
        );
        let speed = said.iter().find(|line| line.contains('√')).unwrap();
        assert!(
            spoken(speed).contains("metres per second, speed the square root of"),
            "{speed}"
        );
    }
}
