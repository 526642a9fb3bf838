//! `carrom simulate`: plays the shot of a scene and prints what happens.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::anyhow;
use serde::Serialize;

use super::{Failure, given, print};
use crate::files::{self, FileErrors};
use crate::levels::Scene;
use crate::physics::units::mm_from_m;
use crate::physics::{DiscState, Event, EventKind, Sample, Shot};

/// Play the shot of a scene and print what happens
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Scene or level file; - reads standard input
    file: PathBuf,
    /// Print one JSON object instead of a table
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let scene = read(&args.file).map_err(|fault| Failure::Input(fault.into()))?;
    let shot = scene
        .play()
        .map_err(|error| anyhow!("{}: {error}", args.file.display()))?;
    let mut report = Vec::new();
    if args.json {
        serde_json::to_writer(&mut report, &ShotReport::of(&shot))?;
        writeln!(report)?;
    } else {
        write_table(&scene, &shot, &mut report)?;
    }
    print(&report)?;
    Ok(ExitCode::SUCCESS)
}

fn read(file: &Path) -> Result<Scene, FileErrors> {
    let (name, bytes) = given::bytes(file, files::LARGEST)?;
    Scene::read(&name, &bytes)
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
            kind: kind_name(&event.kind),
            discs: discs_of(&event.kind),
        };
        let end = |(disc, sample): (usize, Sample)| DiscEnd {
            disc,
            state: state_name(sample.state),
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

const fn kind_name(kind: &EventKind) -> &'static str {
    match kind {
        EventKind::Impact { .. } => "impact",
        EventKind::Cushion { .. } => "cushion",
        EventKind::Pocket { .. } => "pocket",
        EventKind::Rest { .. } => "rest",
    }
}

fn discs_of(kind: &EventKind) -> Vec<usize> {
    let (first, second) = kind.discs();
    std::iter::once(first).chain(second).collect()
}

/// `moving` can only be the end of a shot on a board without friction.
const fn state_name(state: DiscState) -> &'static str {
    match state {
        DiscState::Moving => "moving",
        DiscState::Resting => "rest",
        DiscState::Pocketed => "pocketed",
    }
}

fn write_table(scene: &Scene, shot: &Shot, out: &mut Vec<u8>) -> io::Result<()> {
    writeln!(
        out,
        "{:>9}  {:8} {:>9} {:>9}  discs",
        "t (s)", "event", "x (mm)", "y (mm)"
    )?;
    for event in shot.events() {
        let discs = discs_of(&event.kind);
        let names: Vec<_> = discs.iter().map(|&disc| scene.name(disc)).collect();
        // An impact is where the first of the two discs is.
        let at = shot.at(event.kind.discs().0, event.time).position;
        writeln!(
            out,
            "{:9.4}  {:8} {:9.2} {:9.2}  {}",
            event.time,
            kind_name(&event.kind),
            mm_from_m(at.x),
            mm_from_m(at.y),
            names.join(" on "),
        )?;
    }
    writeln!(out, "\nat the end, after {:.4} s", shot.duration())?;
    for (disc, end) in shot.final_states().enumerate() {
        writeln!(
            out,
            "{:9}  {:8} {:9.2} {:9.2}  {}",
            "",
            state_name(end.state),
            mm_from_m(end.position.x),
            mm_from_m(end.position.y),
            scene.name(disc),
        )?;
    }
    writeln!(
        out,
        "\nenergy {:.4} mJ before, {:.4} mJ after",
        1000.0 * shot.energy_before(),
        1000.0 * shot.energy_after(),
    )
}
