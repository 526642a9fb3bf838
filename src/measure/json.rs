//! A measurement as one JSON object.

use serde_json::{Map, Value, json};

use super::fit::LEVEL;
use super::quantities::LENGTH;
use super::{LineFrom, Measurement, QUANTITIES};

impl Measurement {
    /// The whole measurement as JSON. If a quantity is not defined, only the reason is given, as
    /// `unknown`.
    pub fn json(&self) -> Value {
        let mut quantities = Map::new();
        for quantity in QUANTITIES.iter() {
            let unit = quantity.unit;
            let value = match self.estimate(quantity) {
                Ok(it) => {
                    let reach = it.uncertainty95();
                    let interval = [it.value - reach, it.value + reach];
                    json!({
                        "value": unit.in_unit(it.value),
                        // Half the width of the 68 % interval.
                        "uncertainty": unit.in_unit(it.uncertainty()),
                        "interval_95": interval.map(|x| unit.in_unit(x)),
                        "degrees_of_freedom": it.freedom,
                    })
                }
                Err(reason) => json!({ "unknown": reason }),
            };
            quantities.insert(format!("{}{}", quantity.id, unit.ending()), value);
        }
        let noise = self.fit.noise.map(|noise| LENGTH.in_unit(noise));
        let test = self
            .fit
            .test
            .map(|test| json!({ "f": test.f, "p": test.p, "level": LEVEL }));
        json!({
            "bodies": self.names(),
            "points": self.fit.counts,
            "noise_mm": [noise[..2], noise[2..]],
            "slows": (0..2).map(|body| self.fit.model.slows(body)).collect::<Vec<_>>(),
            "slowing_test": test,
            "line_of_impact_from": match self.known.line {
                LineFrom::Centres => "centres",
                LineFrom::Impulse => "impulse",
            },
            "masses_assumed_equal": !self.known.are_given,
            "predicted_with_restitution": self.given.restitution,
            "quantities": quantities,
            "sentences": self.sentences(),
            "warnings": self.warnings(),
        })
    }
}
