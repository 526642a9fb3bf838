//! Impacts of a single pair of discs, or of several pairs at the same instant.

use glam::DVec2;

use super::super::Motion;
use super::super::impact::Contact;
use super::super::shot::EventKind;
use super::broad_phase::Seeker;
use super::contact::{TOUCHING, contact};
use super::impulse::{Touch, simultaneous};
use super::play::ShotInPlay;
use super::schedule::SAME_TIME;

impl ShotInPlay<'_> {
    /// Resolves the contact of two discs, together with all simultaneous contacts that share a disc
    /// with it.
    pub(super) fn impact(&mut self, i: usize, k: usize, time: f64) {
        let pair = [i.min(k), i.max(k)];
        // All discs that collide now have a forecast for the present time; usually there are just
        // these two discs.
        if self.schedule.due(time + SAME_TIME) > 2 {
            let pairs = self.gather(pair, time);
            if pairs.len() > 1 {
                return self.impact_of_many(&pairs, time);
            }
        }
        self.impact_of_two(pair, time);
        self.forecast(&pair, time);
    }

    fn impact_of_two(&mut self, discs: [usize; 2], time: f64) {
        let [i, k] = discs;
        let (a, b) = (self.bodies[i].at(time), self.bodies[k].at(time));
        let contact = self.contact_of(discs, [a, b]);
        let Some(impact) = contact.resolve() else {
            return;
        };
        let after = [impact.v1, impact.v2];
        self.event(
            time,
            EventKind::Impact {
                discs,
                normal: contact.normal,
                before: [contact.u1, contact.u2],
                after,
            },
        );
        let position = self.unpressed(discs, [a.position, b.position]);
        for (side, disc) in discs.into_iter().enumerate() {
            self.release(disc, time, Motion::new(position[side], after[side]));
        }
    }

    /// The positions of two discs in contact. If the pair slid in contact, it may overlap slightly
    /// (see [`PRESS`](super::contact::PRESS)). Such discs are moved apart, with their centre of
    /// mass fixed, because many small overlaps would otherwise add up.
    fn unpressed(&self, [i, k]: [usize; 2], [a, b]: [DVec2; 2]) -> [DVec2; 2] {
        let apart = b - a;
        let distance = apart.length();
        let overlap = self.bodies[i].radius + self.bodies[k].radius - distance;
        if overlap <= TOUCHING {
            return [a, b];
        }
        let (m_i, m_k) = (self.bodies[i].mass, self.bodies[k].mass);
        let shift = apart * (overlap / (distance * (m_i + m_k)));
        [a - shift * m_k, b + shift * m_i]
    }

    fn contact_of(&self, discs: [usize; 2], [a, b]: [Motion; 2]) -> Contact {
        let apart = b.position - a.position;
        let mut contact = Contact {
            m1: self.bodies[discs[0]].mass,
            m2: self.bodies[discs[1]].mass,
            u1: a.velocity,
            u2: b.velocity,
            normal: apart / apart.length(),
            restitution: 0.0,
        };
        contact.restitution = self.restitution(self.board.restitution, contact.approach_speed());
        contact
    }

    /// This pair and all other pairs that are in contact at the same time and share a disc with it,
    /// either directly or through other pairs.
    fn gather(&mut self, pair: [usize; 2], time: f64) -> Vec<[usize; 2]> {
        let mut pairs = vec![pair];
        let mut discs = pair.to_vec();
        let mut asked = 0;
        while let Some(&disc) = discs.get(asked) {
            asked += 1;
            self.work.add(self.bodies.len());
            for k in 0..self.bodies.len() {
                let pair = [disc.min(k), disc.max(k)];
                let moving = self.bodies[disc].moving || self.bodies[k].moving;
                if k != disc
                    && moving
                    && !pairs.contains(&pair)
                    && contact(
                        &Seeker::new(&self.bodies[disc], time, time),
                        &self.bodies[k],
                        SAME_TIME,
                    )
                    .is_some()
                {
                    pairs.push(pair);
                    if !discs.contains(&k) {
                        discs.push(k);
                    }
                }
            }
        }
        pairs
    }

    fn impact_of_many(&mut self, pairs: &[[usize; 2]], time: f64) {
        let mut discs = pairs.concat();
        discs.sort_unstable();
        discs.dedup();
        let mut motions: Vec<Motion> = discs.iter().map(|&i| self.bodies[i].at(time)).collect();
        let place = |disc: usize| discs.partition_point(|&d| d < disc);
        let mut touches = Vec::new();
        for &pair in pairs {
            let contact = self.contact_of(pair, pair.map(|disc| motions[place(disc)]));
            let approach = contact.approach_speed();
            if approach > 0.0 {
                touches.push(Touch {
                    discs: pair,
                    normal: contact.normal,
                    wanted: (1.0 + contact.restitution) * approach,
                });
            }
        }
        let Some(impulses) = simultaneous(&touches, self.bodies, &mut self.work) else {
            return;
        };
        for (touch, impulse) in touches.iter().zip(impulses) {
            let [a, b] = touch.discs;
            let push = |disc: usize| touch.normal * (impulse / self.bodies[disc].mass);
            let before = [motions[place(a)].velocity, motions[place(b)].velocity];
            let after = [before[0] - push(a), before[1] + push(b)];
            motions[place(a)].velocity = after[0];
            motions[place(b)].velocity = after[1];
            self.event(
                time,
                EventKind::Impact {
                    discs: touch.discs,
                    normal: touch.normal,
                    before,
                    after,
                },
            );
        }
        for touch in &touches {
            let [a, b] = touch.discs.map(place);
            let pair = [motions[a].position, motions[b].position];
            let position = self.unpressed(touch.discs, pair);
            motions[a].position = position[0];
            motions[b].position = position[1];
        }
        for (&disc, &motion) in discs.iter().zip(&motions) {
            self.release(disc, time, motion);
        }
        self.forecast(&discs, time);
    }
}
