//! The same breaks, played exactly by carrom and in fixed steps of 1/240 s by rapier2d.
//!
//! `cd benches/versus && cargo run --release`
//!
//! The comparison answers two questions: how long does a break take, and in which direction does a
//! single coin leave?

#[path = "../../scenes/mod.rs"]
mod scenes;

use std::time::Instant;

use carrom::physics::{Board, Engine, EventKind, Limits, Shot};
use rapier2d_f64::prelude::*;
use scenes::{COIN, STRIKER, Table, breaks, closed_board};

const STEP: f64 = 1.0 / 240.0;

fn main() {
    let board = closed_board();
    let tables = breaks();
    let exact = time(50, || play_exactly(&board, &tables));
    let stepped = time(5, || {
        for table in &tables {
            Stepped::new(&board, table).play(&board);
        }
    });
    let count = tables.len() as f64;
    println!("a break of 19 coins, best of the rounds:");
    println!("  carrom            {:10.1} µs", exact / count * 1e6);
    println!("  rapier2d, 1/240 s {:10.1} µs", stepped / count * 1e6);
    println!("  ratio             {:10.1}", stepped / exact);
    println!();
    println!("direction of the target after one hit at 2.5 m/s, error in degrees:");
    println!("  alpha      carrom        rapier2d");
    for alpha in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0_f64] {
        let (exact, stepped) = one_hit(alpha.to_radians());
        println!("  {alpha:5}  {exact:12.1e}  {stepped:12.3}");
    }
}

fn play_exactly(board: &Board, tables: &[Table]) {
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    for table in tables {
        let limits = Limits::default();
        let played = engine.play_into(&mut shot, board, &table.discs, &table.start, limits);
        played.expect("a playable table");
        std::hint::black_box(&shot);
    }
}

/// The errors of carrom and of rapier, in degrees, in the direction of a coin that is hit at the
/// impact angle `alpha`: it should leave along the line of impact, at −alpha.
fn one_hit(alpha: f64) -> (f64, f64) {
    let board = closed_board();
    let b = (STRIKER.radius + COIN.radius) * alpha.sin();
    let table = Table::pair((-0.2, 0.0), (2.5, 0.0), (0.05, -b));
    let mut shot = Shot::default();
    Engine::default()
        .play_into(
            &mut shot,
            &board,
            &table.discs,
            &table.start,
            Limits::default(),
        )
        .expect("a playable table");
    let EventKind::Impact { after, .. } = shot.events()[0].kind else {
        panic!("no impact");
    };
    let error = |y: f64, x: f64| (y.atan2(x) + alpha).to_degrees();
    let mut stepped = Stepped::new(&board, &table);
    let coin = loop {
        stepped.step(&board);
        let v = stepped.velocity(1);
        if v.norm() > 0.1 {
            break v;
        }
    };
    (error(after[1].y, after[1].x), error(coin.y, coin.x))
}

fn time(rounds: usize, mut work: impl FnMut()) -> f64 {
    let timed = (0..rounds).map(|_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    });
    timed.fold(f64::INFINITY, f64::min)
}

/// A table in rapier: no gravity, no contact friction, sliding friction applied by hand.
struct Stepped {
    parameters: IntegrationParameters,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad: BroadPhaseBvh,
    narrow: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    ccd: CCDSolver,
    discs: Vec<RigidBodyHandle>,
}

impl Stepped {
    fn new(board: &Board, table: &Table) -> Self {
        let mut bodies = RigidBodySet::new();
        let mut colliders = ColliderSet::new();
        let mut discs = Vec::new();
        for (disc, start) in table.discs.iter().zip(&table.start) {
            let body = RigidBodyBuilder::dynamic()
                .translation(vector![start.position.x, start.position.y])
                .linvel(vector![start.velocity.x, start.velocity.y])
                .lock_rotations()
                .ccd_enabled(true)
                .can_sleep(false);
            let handle = bodies.insert(body);
            let shape = ColliderBuilder::ball(disc.radius)
                .mass(disc.mass)
                .friction(0.0)
                .restitution(board.restitution);
            colliders.insert_with_parent(shape, handle, &mut bodies);
            discs.push(handle);
        }
        let half = 0.5 * board.side;
        for (x, y) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
            let wall = ColliderBuilder::cuboid(half, half)
                .translation(vector![2.0 * half * x, 2.0 * half * y])
                .friction(0.0)
                .restitution(board.cushion_restitution)
                .restitution_combine_rule(CoefficientCombineRule::Min);
            colliders.insert(wall);
        }
        let parameters = IntegrationParameters {
            dt: STEP,
            // Tolerances for discs of a few centimetres.
            length_unit: 0.01,
            ..IntegrationParameters::default()
        };
        Self {
            parameters,
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            broad: BroadPhaseBvh::new(),
            narrow: NarrowPhase::new(),
            bodies,
            colliders,
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            ccd: CCDSolver::new(),
            discs,
        }
    }

    fn velocity(&self, disc: usize) -> Vector<f64> {
        *self.bodies[self.discs[disc]].linvel()
    }

    /// Makes one step; returns the greatest speed after friction, before any collision.
    fn step(&mut self, board: &Board) -> f64 {
        let lost = board.deceleration() * STEP;
        let mut fastest = 0.0_f64;
        for &disc in &self.discs {
            let body = &mut self.bodies[disc];
            let v = *body.linvel();
            let speed = v.norm();
            if speed > 0.0 {
                body.set_linvel(v * ((speed - lost).max(0.0) / speed), true);
            }
            fastest = fastest.max(speed - lost);
        }
        self.pipeline.step(
            &vector![0.0, 0.0],
            &self.parameters,
            &mut self.islands,
            &mut self.broad,
            &mut self.narrow,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.ccd,
            &(),
            &(),
        );
        fastest
    }

    /// Steps until all discs are at rest, for at most ten seconds.
    fn play(&mut self, board: &Board) {
        for _ in 0..2400 {
            if self.step(board) <= 0.0 {
                break;
            }
        }
    }
}
