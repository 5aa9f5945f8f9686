//! Gear trains: speeds and torques of shafts that gear pairs and planetary sets connect.
//!
//! Source: Willis equation; virtual work. A pair of gears is a planetary set whose carrier is the housing.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ω₁, ω₂, ω_c | speeds of first gear, second gear and carrier | rad/s |
//! | z₁, z₂ | tooth numbers, z₂ negative if both gears turn in the same direction relative to the carrier | - |
//! | T₁, T₂, T_c | torques that the shafts exert on the gears, positive in the positive direction of rotation | N m |
//! | P_loss | loss of the stage | W |
//!
//! Limits: every torque follows from one shaft after another; parallel paths, over which the torque divides by stiffness,
//! and coupled sets that need a simultaneous solution are refused.

use asperity_core::quantity::{AngularSpeed, Power, Torque};
use asperity_core::{DomainError, cite};

use crate::error::GearError;

/// Largest difference between two speeds or torques of a shaft, relative to the larger one: rounding of a few products.
const TOLERANCE: f64 = 1e-9;

/// Two gears in mesh on a carrier: a pair, or sun and ring of a planetary set.
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    /// Shafts of the first and the second gear, by their place in [`GearTrain::shafts`].
    pub gears: [usize; 2],
    /// Shaft of the carrier; `None` for the housing.
    pub carrier: Option<usize>,
    /// Tooth numbers; the second is negative if both gears turn in the same direction relative to the carrier.
    pub teeth: [f64; 2],
}

/// A shaft of a gear train.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    /// Name, for errors.
    pub name: String,
    /// Stated speed, zero if the shaft is held; `None` if it follows from the stages.
    pub speed: Option<AngularSpeed>,
    /// Torque into the train at this shaft, zero if nothing is connected; `None` if it follows from the stages.
    pub torque: Option<Torque>,
    /// Torque that seals and bearings take from the shaft, negative if it turns in the negative direction.
    pub drag: Torque,
}

/// Shafts and the stages that connect them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GearTrain {
    /// The shafts.
    pub shafts: Vec<Shaft>,
    /// The stages.
    pub stages: Vec<Stage>,
}

/// Torques of a gear train.
#[derive(Debug, Clone, PartialEq)]
pub struct Torques {
    /// Torque into the train at each shaft.
    pub shafts: Vec<Torque>,
    /// Torques of the shafts of first gear, second gear and carrier on each stage.
    pub stages: Vec<[Torque; 3]>,
}

impl GearTrain {
    /// Speed of every shaft:
    ///
    /// z₁(ω₁ − ω_c) + z₂(ω₂ − ω_c) = 0                                            [Train-1]
    ///
    /// # Errors
    /// When a speed does not follow from the stated ones, or contradicts them.
    ///
    /// ```
    /// use asperity_core::quantity::{AngularSpeed, Power, Torque};
    /// use asperity_gear::gear_train::{GearTrain, Shaft, Stage};
    /// let shaft = |name: &str, speed: Option<f64>, torque: Option<f64>| Shaft {
    ///     name: name.to_owned(),
    ///     speed: speed.map(AngularSpeed::from_si),
    ///     torque: torque.map(Torque::from_si),
    ///     drag: Torque::from_si(0.0),
    /// };
    /// // Sun drives, ring is held, carrier is the output: 1 + 75/27.
    /// let set = GearTrain {
    ///     shafts: vec![
    ///         shaft("sun", Some(300.0), Some(100.0)), shaft("ring", Some(0.0), None), shaft("carrier", None, None),
    ///     ],
    ///     stages: vec![Stage { gears: [0, 1], carrier: Some(2), teeth: [27.0, 75.0] }],
    /// };
    /// let speeds = set.speeds()?;
    /// assert!((speeds[2].si() - 300.0 * 27.0 / 102.0).abs() < 1e-12);
    /// let torques = set.torques(&speeds, &[Power::from_si(600.0)])?;
    /// let power: f64 = torques.shafts.iter().zip(&speeds).map(|(t, n)| t.si() * n.si()).sum();
    /// assert!((power - 600.0).abs() < 1e-9);
    /// # Ok::<(), asperity_gear::GearError>(())
    /// ```
    pub fn speeds(&self) -> Result<Vec<AngularSpeed>, GearError> {
        cite!("Train-1");
        let mut speeds: Vec<Option<f64>> = Vec::with_capacity(self.shafts.len());
        for shaft in &self.shafts {
            let stated = shaft.speed;
            speeds.push(
                stated
                    .map(|speed| DomainError::finite("speed of a shaft", speed))
                    .transpose()?,
            );
        }
        while let Some((shaft, speed)) = self.stages.iter().find_map(|stage| stage.third(&speeds)) {
            speeds[shaft] = Some(speed);
        }
        let known: Option<Vec<f64>> = speeds.iter().copied().collect();
        let Some(known) = known else {
            let unknown = speeds.iter().position(Option::is_none).unwrap_or(0);
            return Err(self.refused(unknown, "has no speed that follows from the input shaft"));
        };
        for stage in &self.stages {
            let [z1, z2] = stage.teeth;
            let of_carrier = stage.carrier.map_or(0.0, |shaft| known[shaft]);
            let turns = stage.gears.map(|shaft| known[shaft] - of_carrier);
            let parts = [z1 * turns[0], z2 * turns[1]];
            let largest = parts[0].abs().max(parts[1].abs());
            if (parts[0] + parts[1]).abs() > TOLERANCE * largest {
                return Err(self.refused(
                    stage.gears[1],
                    "would turn at two speeds: its stages contradict each other",
                ));
            }
        }
        Ok(known.into_iter().map(AngularSpeed::from_si).collect())
    }

    /// Torque of every shaft and on every stage, with the loss of each stage:
    ///
    /// T₁ + T₂ + T_c = 0,  T₁(ω₁ − ω_c) + T₂(ω₂ − ω_c) = P_loss                   [Train-2]
    ///
    /// The torque into a shaft is the sum of its torques on the stages and of its drag. Without losses the torques of the gears
    /// are in the ratio of their tooth numbers.
    ///
    /// # Errors
    /// When a torque does not follow from the stated ones, or contradicts them.
    pub fn torques(&self, speeds: &[AngularSpeed], losses: &[Power]) -> Result<Torques, GearError> {
        cite!("Train-2");
        let mut stages: Vec<Option<[f64; 3]>> = vec![None; self.stages.len()];
        for _ in 0..self.stages.len() {
            let next = (0..self.stages.len()).find_map(|k| {
                let place = stages[k]
                    .is_none()
                    .then(|| self.known_torque(k, &stages))??;
                Some((k, place))
            });
            let Some((k, (place, torque))) = next else {
                break;
            };
            let loss = losses.get(k).map_or(0.0, |loss| loss.si());
            stages[k] = Some(self.stages[k].torques(speeds, loss, place, torque));
        }
        if let Some(k) = stages.iter().position(Option::is_none) {
            return Err(self.refused(
                self.stages[k].gears[0],
                "has a torque that does not follow from the tooth numbers: the power takes parallel paths, or several \
                 shafts are outputs",
            ));
        }
        let of_shaft = |shaft: usize| {
            let places = self.places_of(shaft);
            places
                .filter_map(|(k, place)| Some(stages[k]?[place]))
                .sum::<f64>()
        };
        let mut torques = Vec::with_capacity(self.shafts.len());
        for (number, shaft) in self.shafts.iter().enumerate() {
            let torque = of_shaft(number) + shaft.drag.si();
            let largest = self
                .places_of(number)
                .filter_map(|(k, place)| Some(stages[k]?[place].abs()))
                .fold(0.0, f64::max);
            let is_balanced = |stated: Torque| (torque - stated.si()).abs() <= TOLERANCE * largest;
            if shaft.torque.is_some_and(|stated| !is_balanced(stated)) {
                return Err(self.refused(number, "has torques that are not in balance"));
            }
            torques.push(shaft.torque.unwrap_or(Torque::from_si(torque)));
        }
        let stages = stages.into_iter().flatten();
        Ok(Torques {
            shafts: torques,
            stages: stages.map(|torques| torques.map(Torque::from_si)).collect(),
        })
    }

    /// Every place of `shaft` on a stage: the stage, and 0, 1 or 2 for first gear, second gear and carrier.
    pub fn places_of(&self, shaft: usize) -> impl Iterator<Item = (usize, usize)> {
        let stages = self.stages.iter().enumerate();
        stages.flat_map(move |(k, stage)| {
            let places = stage.shafts().into_iter().enumerate();
            places.filter_map(move |(place, at)| (at == Some(shaft)).then_some((k, place)))
        })
    }

    /// A torque on stage `k` that follows from the balance of its shaft, and its place.
    fn known_torque(&self, k: usize, stages: &[Option<[f64; 3]>]) -> Option<(usize, f64)> {
        let shafts = self.stages[k].shafts().into_iter().enumerate();
        let mut known = shafts.filter_map(|(place, shaft)| {
            let shaft = shaft?;
            let stated = self.shafts[shaft].torque?.si() - self.shafts[shaft].drag.si();
            let mut others = self.places_of(shaft).filter(|at| *at != (k, place));
            let rest =
                others.try_fold(stated, |rest, (k, place)| Some(rest - stages[k]?[place]))?;
            Some((place, rest))
        });
        known.next()
    }

    fn refused(&self, shaft: usize, rule: &'static str) -> GearError {
        GearError::train(&self.shafts[shaft].name, rule)
    }
}

impl Stage {
    fn shafts(&self) -> [Option<usize>; 3] {
        let [first, second] = self.gears;
        [Some(first), Some(second), self.carrier]
    }

    /// The shaft whose speed follows from the speeds of the two others, and its speed.
    fn third(&self, speeds: &[Option<f64>]) -> Option<(usize, f64)> {
        let [z1, z2] = self.teeth;
        let [first, second] = self.gears;
        let of_carrier = match self.carrier {
            None => Some(0.0),
            Some(shaft) => speeds[shaft],
        };
        match (speeds[first], speeds[second], of_carrier) {
            (Some(n1), None, Some(nc)) => Some((second, nc - (n1 - nc) * z1 / z2)),
            (None, Some(n2), Some(nc)) => Some((first, nc - (n2 - nc) * z2 / z1)),
            (Some(n1), Some(n2), None) => {
                let speed = (z1 * n1 + z2 * n2) / (z1 + z2);
                self.carrier.map(|carrier| (carrier, speed))
            }
            _ => None,
        }
    }

    /// All torques from the torque at `place`.
    fn torques(&self, speeds: &[AngularSpeed], loss: f64, place: usize, torque: f64) -> [f64; 3] {
        let [z1, z2] = self.teeth;
        let of_carrier = self.carrier.map_or(0.0, |shaft| speeds[shaft].si());
        let [turns_1, turns_2] = self.gears.map(|shaft| speeds[shaft].si() - of_carrier);
        let lost = |turns: f64| if loss == 0.0 { 0.0 } else { loss / turns };
        let [first, second] = match place {
            0 => [torque, torque * z2 / z1 + lost(turns_2)],
            1 => [torque * z1 / z2 + lost(turns_1), torque],
            _ => {
                let first = (-torque - lost(turns_2)) / (1.0 + z2 / z1);
                [first, -torque - first]
            }
        };
        [first, second, -(first + second)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shaft(name: &str, speed: Option<f64>, torque: Option<f64>) -> Shaft {
        Shaft {
            name: name.to_owned(),
            speed: speed.map(AngularSpeed::from_si),
            torque: torque.map(Torque::from_si),
            drag: Torque::from_si(0.0),
        }
    }

    fn pair(gears: [usize; 2], teeth: [f64; 2]) -> Stage {
        Stage {
            gears,
            carrier: None,
            teeth,
        }
    }

    fn power(train: &GearTrain, losses: &[f64]) -> f64 {
        let speeds = train.speeds().unwrap();
        let losses: Vec<Power> = losses.iter().copied().map(Power::from_si).collect();
        let torques = train.torques(&speeds, &losses).unwrap();
        let at_shafts = torques.shafts.iter().zip(&speeds);
        at_shafts
            .map(|(torque, speed)| torque.si() * speed.si())
            .sum()
    }

    /// A pair, an idler and a set, which drives by its carrier.
    fn mixed(torque: f64) -> GearTrain {
        GearTrain {
            shafts: vec![
                shaft("in", Some(100.0), Some(torque)),
                shaft("idler", None, Some(0.0)),
                shaft("carrier", None, Some(0.0)),
                shaft("ring", Some(0.0), None),
                shaft("out", None, None),
            ],
            stages: vec![
                pair([0, 1], [20.0, 31.0]),
                pair([1, 2], [31.0, 40.0]),
                Stage {
                    gears: [4, 3],
                    carrier: Some(2),
                    teeth: [27.0, 75.0],
                },
            ],
        }
    }

    #[test]
    fn speeds_and_torques_follow_from_the_tooth_numbers() {
        let train = mixed(10.0);
        let speeds: Vec<f64> = train.speeds().unwrap().iter().map(|n| n.si()).collect();
        // The idler reverses, the sun of a held ring turns 1 + 75/27 times as fast as the carrier.
        assert!((speeds[1] + 100.0 * 20.0 / 31.0).abs() < 1e-12);
        assert!((speeds[2] - 50.0).abs() < 1e-12);
        assert!((speeds[4] - 50.0 * 102.0 / 27.0).abs() < 1e-12);
        let torques = train.torques(&train.speeds().unwrap(), &[]).unwrap().shafts;
        let torques: Vec<f64> = torques.iter().map(|torque| torque.si()).collect();
        assert_eq!(torques[..3], [10.0, 0.0, 0.0]);
        assert!((torques[4] + 20.0 * 27.0 / 102.0).abs() < 1e-12);
        assert!((torques[3] + 20.0 * 75.0 / 102.0).abs() < 1e-12);
    }

    #[test]
    fn powers_and_losses_are_in_balance_in_both_directions_of_the_power() {
        for torque in [10.0, -10.0] {
            let losses = [3.0, 5.0, 7.0];
            let found = power(&mixed(torque), &losses);
            assert!((found - 15.0).abs() < 1e-12 * 1000.0, "{torque}: {found}");
        }
    }

    #[test]
    fn drags_of_shafts_take_their_power_from_the_train() {
        for torque in [10.0, -10.0] {
            let mut train = mixed(torque);
            let speeds = train.speeds().unwrap();
            let mut taken = 0.0;
            for (shaft, speed) in train.shafts.iter_mut().zip(&speeds) {
                shaft.drag = Torque::from_si(0.2 * speed.si().signum());
                taken += shaft.drag.si() * speed.si();
            }
            let found = power(&train, &[3.0, 5.0, 7.0]);
            assert!(
                (found - 15.0 - taken).abs() < 1e-12 * 1000.0,
                "{torque}: {found}"
            );
            assert!(taken > 0.0);
        }
    }

    #[test]
    fn a_train_that_does_not_determine_its_shafts_is_refused_by_name() {
        let says = |train: &GearTrain| {
            let speeds = train.speeds();
            let torques = speeds.and_then(|speeds| train.torques(&speeds, &[]));
            torques.unwrap_err().to_string()
        };
        let mut train = mixed(10.0);
        train.shafts[3].speed = None;
        assert!(says(&train).contains("ring"), "{}", says(&train));
        let mut train = mixed(10.0);
        train.shafts[2].torque = None;
        assert!(says(&train).contains("several shafts are outputs"));
        // A loop that turns at two speeds, and one that divides the torque.
        let mut train = mixed(10.0);
        train.stages[2] = pair([0, 2], [20.0, 41.0]);
        train.shafts.truncate(3);
        assert!(says(&train).contains("two speeds"), "{}", says(&train));
        train.stages[2] = pair([0, 2], [20.0, -40.0]);
        train.shafts[2].torque = None;
        assert!(says(&train).contains("parallel"), "{}", says(&train));
    }
}
