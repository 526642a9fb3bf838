//! The counts of Geiger and Marsden, beside the law.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::dvec2;
use ratatui::layout::Rect;

use super::setup::FoilSetup;
use super::{FoilAction, words};
use crate::beams::{Angle, Series};
use crate::physics::rutherford::{GOLD_DENSITY, MEASURED_SHARE, Rutherford};
use crate::widgets::panel::Panel;
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Charset, Look, Role};

/// A metal, and its appearance in the plot.
struct ShownMetal {
    name: &'static str,
    count: fn(&Angle) -> f64,
    /// The mark of its counts in ASCII and in Unicode.
    marks: [char; 2],
    role: Role,
}

impl ShownMetal {
    fn mark(&self, charset: Charset) -> char {
        self.marks[usize::from(charset == Charset::Unicode)]
    }
}

const METALS: [ShownMetal; 2] = [
    ShownMetal {
        name: "gold",
        count: |angle| angle.gold,
        marks: ['o', '●'],
        role: Role::CoinOut,
    },
    ShownMetal {
        name: "silver",
        count: |angle| angle.silver,
        marks: ['x', '×'],
        role: Role::StrikerOut,
    },
];

/// The title of the picture.
pub(super) fn title(levelled: bool) -> &'static str {
    if levelled {
        "deviation from the law"
    } else {
        "their counts against the law"
    }
}

/// The counts against 1/sin⁴(Θ/2), or their deviation from the law.
pub(super) fn picture(levelled: bool, area: Rect, look: Look) -> Picture {
    let law = Axis::log("1/sin⁴(Θ/2), small Θ right", 1.0, 5000.0);
    let count = match levelled {
        true => Axis::linear("above the law (%)", -25.0, 50.0).every(25.0),
        false => Axis::log("scintillations counted", 10.0, 300_000.0),
    };
    let mut plot = Plot::new(area, look, law, count);
    let draw = if levelled { levels } else { counts };
    for metal in &METALS {
        draw(&mut plot, look, metal, &Series::new(metal.count));
    }
    plot.picture()
}

/// Draws the counts of a metal, and the law as a straight line.
fn counts(plot: &mut Plot, look: Look, metal: &ShownMetal, series: &Series) {
    let ShownMetal { name, role, .. } = *metal;
    let line = [1.0, 5000.0].map(|law| dvec2(law, law * series.scale));
    plot.curve(line, Role::Dim);
    for (_, law, count) in &series.points {
        plot.mark(dvec2(*law, *count), metal.mark(look.charset), role);
    }
    if let Some((_, law, count)) = series.points.get(series.points.len() / 2) {
        let sides = if name == "gold" {
            [LabelSide::AboveLeft, LabelSide::Left]
        } else {
            [LabelSide::BelowRight, LabelSide::Right]
        };
        let text = format!("{name} {}", metal.mark(look.charset));
        plot.label(&text, dvec2(*law, *count), &sides, role);
    }
}

/// The deviation of each count from the law in per cent, and the range of the deviations for gold.
fn levels(plot: &mut Plot, look: Look, metal: &ShownMetal, series: &Series) {
    let ShownMetal { name, role, .. } = *metal;
    let percent = |excess: f64| 100.0 * excess;
    if name == "gold" {
        let (low, high) = series.band();
        plot.hline(0.0, Pen::new(Role::Dim));
        for edge in [low, high] {
            plot.hline(percent(edge), Pen::new(Role::Arc).dashed());
        }
    }
    for point in &series.points {
        let at = dvec2(point.1, percent(series.excess(*point)));
        plot.mark(at, metal.mark(look.charset), role);
    }
    // The upper left corner is empty, so the labels start there.
    let mut at = dvec2(1.5, 35.0);
    if name == "gold" {
        let (low, high) = series.band();
        for (edge, side) in [(low, LabelSide::Below), (high, LabelSide::Above)] {
            let text = format!("gold {}", signed(edge));
            plot.label(&text, dvec2(8.0, percent(edge)), &[side], Role::Text);
        }
        at.y = 42.0;
    }
    let legend = format!("{} {name}", metal.mark(look.charset));
    plot.label(&legend, at, &[LabelSide::Right], role);
}

/// A fraction as a signed percentage.
fn signed(share: f64) -> String {
    format!("{:+.0}%", 100.0 * share).replace('-', "−")
}

/// Writes the text beside the picture.
pub(super) fn write(panel: &mut Panel<FoilAction>) {
    let [gold, silver] = METALS.map(|metal| Series::new(metal.count));
    let text = "Hans Geiger and Ernest Marsden sat in the dark and counted by eye the flashes of \
                single α-particles on a screen, at one angle Θ after another.";
    panel.paragraph(text, Role::Text);
    panel.gap();
    let text = "If an atom's charge is all in one small place, the counts are proportional to \
                1/sin⁴(Θ/2): the straight lines.";
    panel.paragraph(text, Role::Text);
    panel.gap();
    let counts =
        |f: fn(f64, f64) -> f64, start| gold.points.iter().map(|point| point.2).fold(start, f);
    let (most, least) = (counts(f64::max, 0.0), counts(f64::min, f64::INFINITY));
    let ((low, high), (silver_low, silver_high)) = (gold.band(), silver.band());
    let [low, high, silver_low, silver_high] = [low, high, silver_low, silver_high].map(signed);
    let text = format!(
        "The counts for gold go from {least} to {}, a factor of {}, and deviate by {low} to {high} \
         from the law. Silver: {silver_low} to {silver_high}. Both are too high at small angles; \
         Geiger and Marsden thought that this was probably within their errors. The second plot \
         shows the deviations.",
        words::count(most as u64),
        words::count(words::rounded(most / least) as u64),
    );
    panel.paragraph(text, Role::Text);
    panel.prompt("the other plot", FoilAction::OtherPlot);
    panel.gap();
    let text = "The counts are relative, so each metal has a line of its own. The height of a line \
                is fitted; its slope is not. A second series, at smaller angles, has yet another \
                scale, so it cannot be joined to this one.";
    panel.paragraph(text, Role::Dim);
    panel.gap();
    panel.heading("The absolute number");
    panel.paragraph(absolute_check(), Role::Text);
    panel.gap();
    panel.heading("“1 in 8000”");
    let back = words::share(FoilSetup::default().law().share_beyond(FRAC_PI_2));
    let text = format!(
        "That number is from 1909, and not from a gold foil: it is the share of α-particles that \
         came back from a thick platinum plate, many layers deep. A gold foil of 0.21 µm turns \
         back far fewer: {back}."
    );
    panel.paragraph(text, Role::Text);
}

/// The only count whose absolute scale is known: measured in 1913 at 45°, behind gold 2.1·10⁻⁵ cm
/// thick, on a screen of 1 mm² at a distance of 1 cm.
fn absolute_check() -> String {
    let (beam, nuclei) = (Rutherford::radium_c_on_gold(), GOLD_DENSITY * 2.1e-7);
    let share = beam.share_into(FRAC_PI_4, 1e-6 / 1e-4, nuclei);
    let shown = |share: f64| format!("{:.1}×10⁻⁷", share * 1e7);
    let measured = shown(MEASURED_SHARE);
    let share = share.map_or("none".into(), shown);
    format!(
        "At 45°, behind 0.21 µm of gold, a screen of 1 mm² at 1 cm caught {measured} of all \
         particles, give or take a fifth. With Z = 79 and nothing fitted, the formula gives \
         {share}."
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_gives_the_result_of_the_formula() {
        assert!(
            absolute_check().ends_with("3.2×10⁻⁷."),
            "{}",
            absolute_check()
        );
    }

    #[test]
    fn the_range_is_written_with_signs() {
        let [gold, silver] = METALS.map(|metal| Series::new(metal.count));
        let said = |series: &Series| {
            let (low, high) = series.band();
            (signed(low), signed(high))
        };
        assert_eq!(said(&gold), ("−15%".into(), "+23%".into()));
        assert_eq!(said(&silver), ("−15%".into(), "+41%".into()));
    }
}
