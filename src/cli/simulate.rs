//! `carrom simulate`: plays the shot of a scene and prints what happens.

use std::path::PathBuf;

use anyhow::anyhow;
use glam::DVec2;
use serde::Serialize;

use super::{Failure, given, print, print_json};
use crate::files::LARGEST;
use crate::levels::{Patience, Scene};
use crate::numbers::four_figures;
use crate::physics::units::mm_from_m;
use crate::physics::{Event, EventKind, Sample, Shot};

/// Play the shot of a scene and print what happens
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Scene or level file; - reads standard input
    file: PathBuf,
    /// Print one JSON object instead of a table
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args) -> Result<(), Failure> {
    let scene = given::read(&args.file, LARGEST, Scene::read)?;
    let shot = scene.play(Patience::Seconds);
    let shot = shot.map_err(|error| anyhow!("{}: {error}", args.file.display()))?;
    match args.json {
        true => print_json(&ShotReport::of(&shot)),
        false => print(table(&scene, &shot).as_bytes()),
    }
}

/// What `--json` prints.
#[derive(Debug, Serialize)]
struct ShotReport {
    duration_s: f64,
    events: Vec<ShotEvent>,
    r#final: Vec<DiscEnd>,
    energy_before_j: f64,
    energy_after_j: f64,
}

#[derive(Debug, Serialize)]
struct ShotEvent {
    t_s: f64,
    kind: &'static str,
    discs: Vec<usize>,
}

#[derive(Debug, Serialize)]
struct DiscEnd {
    disc: usize,
    state: &'static str,
    at_mm: [f64; 2],
}

impl ShotReport {
    fn of(shot: &Shot) -> Self {
        let happening = |event: &Event| ShotEvent {
            t_s: event.time,
            kind: event.kind.into(),
            discs: discs_of(&event.kind),
        };
        let end = |(disc, sample): (usize, Sample)| DiscEnd {
            disc,
            state: sample.state.into(),
            at_mm: sample.position.to_array().map(mm_from_m),
        };
        Self {
            duration_s: shot.duration(),
            events: shot.events().iter().map(happening).collect(),
            r#final: shot.final_states().enumerate().map(end).collect(),
            energy_before_j: shot.energy_before(),
            energy_after_j: shot.energy_after(),
        }
    }
}

/// A time to a tenth of a millisecond, or in scientific notation if it is 10⁶ s or more, as can
/// happen if friction is nearly zero.
fn seconds(time: f64) -> String {
    match time < 1e6 {
        true => format!("{time:.4}"),
        false => four_figures(time),
    }
}

fn discs_of(kind: &EventKind) -> Vec<usize> {
    let (first, second) = kind.discs();
    std::iter::once(first).chain(second).collect()
}

fn table(scene: &Scene, shot: &Shot) -> String {
    let row = |time: &str, what: &str, at: DVec2, discs: &str| {
        let [x, y] = at.to_array().map(mm_from_m);
        format!("{time:>9}  {what:8} {x:9.2} {y:9.2}  {discs}\n")
    };
    let mut table = String::from("    t (s)  event       x (mm)    y (mm)  discs\n");
    for event in shot.events() {
        let discs = discs_of(&event.kind);
        let names: Vec<_> = discs.iter().map(|&disc| scene.name(disc)).collect();
        // The position of an impact is that of the first disc.
        let at = shot.at(event.kind.discs().0, event.time).position;
        let time = seconds(event.time);
        table += &row(&time, event.kind.into(), at, &names.join(" on "));
    }
    table += &format!("\nat the end, after {} s\n", seconds(shot.duration()));
    for (disc, end) in shot.final_states().enumerate() {
        table += &row("", end.state.into(), end.position, &scene.name(disc));
    }
    let energies_mj = [shot.energy_before(), shot.energy_after()].map(|energy| 1000.0 * energy);
    let [before, after] = energies_mj;
    table + &format!("\nenergy {before:.4} mJ before, {after:.4} mJ after\n")
}
