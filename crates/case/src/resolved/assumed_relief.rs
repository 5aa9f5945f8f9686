//! Tip relief of gears whose case states none.

use asperity_core::cite;
use asperity_core::quantity::{Length, Torque};
use asperity_gear::{AmountDirection, GearError, MicroGeometry, Relief, ReliefExtent, ReliefShape};

use super::load_inputs::LoadInputs;
use crate::input::case_input::CaseInput;

/// Tip relief of gears whose case states none: between none and the approach of the teeth under their largest load.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AssumedRelief {
    /// Approach of the teeth without relief, normal to the flank.
    pub approach: Length,
    /// Roll length from the tip to the end of double contact.
    pub roll_length: Length,
    /// Gears whose relief is not stated.
    pub gears: [bool; 2],
}

/// Inputs of such a relief.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ReliefInputs {
    /// The load without it, at the larger of the torque of the case and the largest torque of its map.
    load: LoadInputs,
    /// Gears whose relief is not stated.
    unstated: [bool; 2],
}

impl ReliefInputs {
    /// The inputs of a case whose load is `load`.
    pub(crate) fn new(input: &CaseInput, load: &LoadInputs) -> Self {
        let flanks = [input.gears.pinion, input.gears.wheel].map(Option::unwrap_or_default);
        let own = load.torque.si().abs();
        let most = input.map.and_then(|map| map.torque_max);
        let torque = most.map_or(own, |most| most.si().abs().max(own));
        Self {
            load: load.at(Torque::from_si(torque)),
            unstated: flanks.map(|flank| flank.tip_relief.is_none() && !flank.is_from_trace()),
        }
    }
}

impl AssumedRelief {
    /// Amount of a run, over the approach.
    pub const AMOUNT: f64 = 0.5;
    /// Roll length of a run, relative to the roll length to the end of double contact.
    pub const LENGTH: f64 = 0.75;

    /// The relief that a case does not state; `None` if both gears state theirs, or a single pair of teeth carries the load
    /// throughout.
    ///
    /// ```text
    /// C_a = c δ over the roll length l L,  L = (ε_α − 1) p_et                      [Assumed-relief]
    /// ```
    ///
    /// # Errors
    /// When the load over the teeth has no solution without relief.
    pub(crate) fn from_inputs(inputs: &ReliefInputs) -> Result<Option<Self>, GearError> {
        let ReliefInputs { load, unstated } = inputs;
        let path = load.gears.path();
        let beyond = path.eps_alpha - 1.0;
        if *unstated == [false; 2] || !load.is_elastic() || beyond <= 0.0 {
            return Ok(None);
        }
        // Under a load that no teeth bear the stiffness is meaningless; the pressure then names the load.
        let approach = load.by_its_law()?.evidence().mean_approach;
        let Some(approach) = approach.filter(|approach| approach.si() > 0.0) else {
            return Ok(None);
        };
        Ok(Some(Self {
            approach,
            roll_length: path.base_pitch * beyond,
            gears: *unstated,
        }))
    }

    /// `micro` with the amount `c` times the approach over `l` times the roll length, at the gears that state none.
    #[must_use]
    pub fn put_into(&self, micro: &MicroGeometry, c: f64, l: f64) -> MicroGeometry {
        cite!("Assumed-relief");
        let relief = (c > 0.0).then(|| Relief {
            amount: self.approach * c,
            extent: ReliefExtent::RollLength(self.roll_length * l),
            shape: ReliefShape::Linear,
        });
        let mut assumed = micro.clone();
        for (gear, is_assumed) in self.gears.into_iter().enumerate() {
            if is_assumed {
                assumed.tip_relief[gear] = relief;
            }
        }
        if micro.is_unmodified() {
            assumed.direction = AmountDirection::Normal;
        }
        assumed
    }

    /// The load inputs with the relief c δ over the roll length l L; edge contact of the tips where there is none.
    #[must_use]
    pub fn under(&self, load: &LoadInputs, c: f64, l: f64) -> LoadInputs {
        load.on(self.put_into(load.micro_geometry(), c, l), c == 0.0)
    }
}
