//! Speeds and torques of a gear train, and the load of each of its meshes.

use asperity_core::quantity::{AngularSpeed, Power, Torque};
use asperity_gear::GearError;
use asperity_gear::gear_train::{GearTrain, Shaft, Stage, Torques};
use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet};

use super::resolve::Case;

/// Gears of a stage.
#[derive(Debug, Clone, PartialEq)]
pub enum StageKind {
    /// A pair, one mesh.
    Pair,
    /// A planetary set: sun and planet, planet and ring, both as often as there are planets.
    Planetary {
        /// The set.
        set: Box<PlanetarySet>,
        /// Load of the most loaded planet over the mean, K_γ.
        load_share_factor: f64,
    },
}

impl StageKind {
    /// Number of equal meshes of each kind.
    #[must_use]
    pub fn count(&self) -> u32 {
        match self {
            Self::Pair => 1,
            Self::Planetary { set, .. } => set.planets,
        }
    }

    /// Loss of the stage, with the loss of one mesh of each kind.
    #[must_use]
    pub fn loss(&self, of_each: &[Power]) -> Power {
        match (self, of_each) {
            (Self::Planetary { set, .. }, [sun, ring]) => set.loss(*sun, *ring),
            _ => of_each
                .iter()
                .fold(Power::from_si(0.0), |sum, loss| sum + *loss),
        }
    }

    /// Load of the most loaded mesh over the mean.
    #[must_use]
    pub fn load_share_factor(&self) -> f64 {
        match self {
            Self::Pair => 1.0,
            Self::Planetary {
                load_share_factor, ..
            } => *load_share_factor,
        }
    }
}

/// Load of a mesh at its pinion, as in a case of its own: positive if the pinion drives, speed without sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshLoad {
    /// Torque at the pinion.
    pub torque: Torque,
    /// Speed of the pinion, in a planetary set relative to the carrier.
    pub speed: AngularSpeed,
}

impl MeshLoad {
    /// Load of a case.
    #[must_use]
    pub fn from_case(case: &Case) -> Self {
        Self {
            torque: case.torque,
            speed: case.speed,
        }
    }
}

/// Shafts and stages of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Shafting {
    /// Shafts, the input shaft first, with the operating point.
    pub shafts: GearTrain,
    /// Gears of each stage.
    pub kinds: Vec<StageKind>,
    /// Whether losses lower the torques of the following meshes.
    pub passes_losses: bool,
}

/// Speeds, torques and mesh loads of a gear train.
#[derive(Debug, Clone, PartialEq)]
pub struct Flow {
    /// Speed of each shaft.
    pub speeds: Vec<AngularSpeed>,
    /// Torques of shafts and stages.
    pub torques: Torques,
    /// Load of each mesh of each stage.
    pub loads: Vec<Vec<MeshLoad>>,
}

impl Flow {
    /// Power into the train through all shafts.
    #[must_use]
    pub fn power_in(&self) -> Power {
        Power::from_si(self.powers().map(|power| power.max(0.0)).sum())
    }

    /// Power out of the train through all shafts.
    #[must_use]
    pub fn power_out(&self) -> Power {
        Power::from_si(self.powers().map(|power| (-power).max(0.0)).sum())
    }

    /// Power into the train at each shaft \[W\].
    fn powers(&self) -> impl Iterator<Item = f64> {
        let shafts = self.torques.shafts.iter().zip(&self.speeds);
        shafts.map(|(torque, speed)| torque.si() * speed.si())
    }
}

impl Shafting {
    /// The input shaft, by its place in [`GearTrain::shafts`].
    pub const INPUT: usize = 0;

    /// A pair of gears whose pinion is the input.
    #[must_use]
    pub fn of_one_mesh(case: &Case) -> Self {
        let mut shafts = Self::shafts_of_one_mesh();
        let load = MeshLoad::from_case(case);
        shafts.shafts[Self::INPUT].speed = Some(load.speed);
        shafts.shafts[Self::INPUT].torque = Some(load.torque);
        shafts.stages[0].teeth[1] = case.gears.ratio;
        Self {
            shafts,
            kinds: vec![StageKind::Pair],
            passes_losses: false,
        }
    }

    /// The shafts of a pair of gears without load.
    pub(crate) fn shafts_of_one_mesh() -> GearTrain {
        let shaft = |name: &str| Shaft {
            name: name.to_owned(),
            speed: None,
            torque: None,
            drag: Torque::from_si(0.0),
        };
        GearTrain {
            shafts: vec![shaft("pinion"), shaft("wheel")],
            stages: vec![Stage {
                gears: [Self::INPUT, 1],
                carrier: None,
                teeth: [1.0, 1.0],
            }],
        }
    }

    /// The train with another torque and speed of its input shaft.
    #[must_use]
    pub fn at(&self, load: MeshLoad) -> Self {
        let mut train = self.clone();
        let input = &mut train.shafts.shafts[Self::INPUT];
        (input.torque, input.speed) = (Some(load.torque), Some(load.speed));
        train
    }

    /// Torque and speed of the input shaft.
    #[must_use]
    pub fn operation(&self) -> MeshLoad {
        let input = &self.shafts.shafts[Self::INPUT];
        MeshLoad {
            torque: input.torque.unwrap_or(Torque::from_si(0.0)),
            speed: input.speed.unwrap_or(AngularSpeed::from_si(0.0)),
        }
    }

    /// The train with the torques that parts take from its shafts, against their rotation.
    #[must_use]
    pub fn with_drags(&self, drags: &[Torque]) -> Self {
        let mut train = self.clone();
        for (shaft, drag) in train.shafts.shafts.iter_mut().zip(drags) {
            shaft.drag = *drag;
        }
        train
    }

    /// Power into the train through all shafts, with the loss of one mesh of each kind in each stage.
    ///
    /// # Errors
    /// As [`flow`](Self::flow).
    pub fn power_in(&self, losses: &[Vec<Power>]) -> Result<Power, GearError> {
        Ok(self.flow(losses)?.power_in())
    }

    /// The flow with the loss of one mesh of each kind in each stage; without losses if `losses` is empty. The loads are
    /// those of torques that the losses lower.
    ///
    /// # Errors
    /// When the stages do not determine a speed or torque, or a mesh carries no torque.
    pub fn flow(&self, losses: &[Vec<Power>]) -> Result<Flow, GearError> {
        let speeds = self.shafts.speeds()?;
        let torques = self.torques(&speeds, losses)?;
        let loads = (0..self.kinds.len()).map(|k| {
            let first = losses.get(k).and_then(|losses| losses.first());
            self.loads(k, &speeds, torques.stages[k], first.copied())
        });
        Ok(Flow {
            loads: loads.collect::<Result<_, _>>()?,
            speeds,
            torques,
        })
    }

    /// Loss of all meshes, with the loss of one mesh of each kind in each stage.
    #[must_use]
    pub fn loss(&self, losses: &[Vec<Power>]) -> Power {
        let stages = self.kinds.iter().zip(losses);
        stages.fold(Power::from_si(0.0), |sum, (kind, of_each)| {
            sum + kind.loss(of_each)
        })
    }

    /// Torques of shafts and stages with the loss of one mesh of each kind in each stage.
    fn torques(
        &self,
        speeds: &[AngularSpeed],
        losses: &[Vec<Power>],
    ) -> Result<Torques, GearError> {
        let stages = self.kinds.iter().zip(losses);
        let of_stages: Vec<Power> = stages.map(|(kind, losses)| kind.loss(losses)).collect();
        self.shafts.torques(speeds, &of_stages)
    }

    /// Torques that load the meshes: by the tooth numbers, or with the losses if the train passes them on.
    ///
    /// # Errors
    /// When a torque does not follow from the stated ones, or contradicts them.
    pub fn loading_torques(
        &self,
        speeds: &[AngularSpeed],
        losses: &[Vec<Power>],
    ) -> Result<Torques, GearError> {
        self.torques(speeds, if self.passes_losses { losses } else { &[] })
    }

    /// Loads of the meshes of stage `k`; `lost` is the loss of one of its first meshes.
    fn loads(
        &self,
        k: usize,
        speeds: &[AngularSpeed],
        [torque, _, _]: [Torque; 3],
        lost: Option<Power>,
    ) -> Result<Vec<MeshLoad>, GearError> {
        let shafts = &self.shafts;
        let [first, second] = shafts.stages[k].gears;
        if torque.si() == 0.0 {
            return Err(GearError::train(
                &shafts.shafts[first].name,
                "carries no torque: leave out meshes that run idle",
            ));
        }
        let (turns, other) = (speeds[first], speeds[second]);
        match &self.kinds[k] {
            StageKind::Pair => Ok(vec![MeshLoad {
                torque: torque * turns.si().signum(),
                speed: AngularSpeed::from_si(turns.si().abs()),
            }]),
            StageKind::Planetary {
                set,
                load_share_factor,
            } => {
                let [sun, mut ring] = set.meshes(&PlanetaryOperation {
                    sun_torque: torque * (turns - other).si().signum(),
                    sun_speed: turns,
                    ring_speed: other,
                    load_share_factor: *load_share_factor,
                })?;
                // The planet passes on what its mesh with the sun leaves, or supplies the loss of that mesh as well.
                if let Some(lost) = lost.filter(|_| self.passes_losses) {
                    ring.torque = Torque::from_si(ring.torque.si() - lost.si() / ring.speed.si());
                }
                let load = |mesh: asperity_gear::planetary::PlanetaryMesh| MeshLoad {
                    torque: mesh.torque,
                    speed: mesh.speed,
                };
                Ok(vec![load(sun), load(ring)])
            }
        }
    }
}
