//! Patches of two flanks that pass each other: what the inlet leaves of them, and their flow factor.
//!
//! The shape of the flattened roughness changes slowly with the length of the inlet: flow tables are computed at wavelength scales a
//! factor of two apart, each when it is first needed, and taken between them.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::numerics::GOLDEN_SECTION;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::attenuation::Attenuation;
use crate::error::RegimeError;
use crate::flow_table::FlowTable;
use crate::gap_law::GapLaw;
use crate::patch::{Patch, PatchSpectrum};
use crate::rough_inlet::{PairSpectrum, RoughInlet};

/// Offset along rolling of the first place, in distances of successive ones. A patch that is mirrored at the ends of its rows then
/// never faces its image in the other patch; there the pressure would be even at both ends, and more oil would pass.
const FIRST: f64 = 0.25;
/// Scale of the shortest inlet over the longest wave, and of the longest inlet over the shortest wave: no wave is flattened, and
/// every wave is in the same proportion.
const SCALES: [f64; 2] = [0.01, 1000.0];

/// Change of ln Ψ at which the iteration of the inlet ends.
const TOLERANCE: f64 = 1e-10;

/// Patches of two flanks on grids of the same size and spacing.
#[derive(Debug)]
pub struct PatchPair {
    patches: [PatchSpectrum; 2],
    waves: PairSpectrum,
    places: usize,
    /// Longest and shortest wave [m].
    lengths: [f64; 2],
    /// By the logarithm of the wavelength scale to the base 2.
    tables: Mutex<BTreeMap<i32, Arc<FlowTable>>>,
}

impl PatchPair {
    /// The patches of both flanks, whose flow is the mean at `places` places of one against the other.
    ///
    /// # Errors
    /// When the grids differ, or there is no place.
    pub fn new(patches: [PatchSpectrum; 2], places: usize) -> Result<Self, RegimeError> {
        let [first, second] = &patches;
        let rule = "must be at least one";
        DomainError::require(places > 0, "places of a patch", places as f64, "-", rule)?;
        let [grid, other] = [first.grid(), second.grid()];
        let ([dx, dy], size) = (grid.spacing(), grid.size());
        let rule = "must be the same in both patches of a pair";
        let (other, [other_x, other_y]) = (other.size(), other.spacing());
        for (held, expected) in [(other[0], size[0]), (other[1], size[1])] {
            DomainError::require(held == expected, "heights of a row", held as f64, "-", rule)?;
        }
        for (held, expected) in [(other_x, dx), (other_y, dy)] {
            let held = held.si();
            DomainError::require(held == expected.si(), "spacing", held, "m", rule)?;
        }
        let waves = PairSpectrum::of_patches(patches.each_ref());
        let longest = (size[0] as f64 * dx.si()).max(2.0 * size[1] as f64 * dy.si());
        let lengths = [longest, 2.0 * dx.si().min(dy.si())];
        Ok(Self {
            patches,
            waves,
            places,
            lengths,
            tables: Mutex::default(),
        })
    }

    /// Variance of both patches by wavelength across the motion.
    #[must_use]
    pub fn waves(&self) -> &PairSpectrum {
        &self.waves
    }

    /// The second patch's offset at a place, which is one against the other.
    #[must_use]
    pub fn offset(&self, place: usize) -> [usize; 2] {
        let size = self.patches[0].grid().size();
        let along = (place as f64 + FIRST) / self.places as f64;
        let parts = [along.fract(), (GOLDEN_SECTION * place as f64).fract()];
        [0, 1].map(|d: usize| (parts[d] * size[d] as f64) as usize)
    }

    /// Flow table of the flanks as an inlet leaves them.
    ///
    /// # Errors
    /// When a flow has no solution.
    pub fn flow(&self, attenuation: &Attenuation) -> Result<FlowTable, RegimeError> {
        let [longest, shortest] = self.lengths;
        let [least, most] = [SCALES[0] / longest, SCALES[1] / shortest].map(f64::log2);
        let scale = attenuation.nabla_per_length().log2().clamp(least, most);
        let below = scale.floor();
        let table = |power: f64| self.table(power as i32);
        let first = table(below)?;
        if scale == below {
            return Ok(FlowTable::clone(&first));
        }
        let second = table(below + 1.0)?;
        Ok(FlowTable::between(&first, &second, scale - below))
    }

    /// The inlet of a contact with the smooth gap h_g and the wavelength scale of smooth flanks, by the computed flow.
    ///
    /// ```text
    /// n = ∇ Ψ^(−1/3),  Ψ of σ_d(n) and φ_x(n) by [Rough-inlet-computed]      [Patch-inlet]
    /// ```
    ///
    /// # Errors
    /// When the gap is not positive, the wavelength scale negative or not finite, or a flow has no solution.
    pub fn inlet(
        &self,
        nabla_per_length: f64,
        smooth_gap: Length,
    ) -> Result<RoughInlet, RegimeError> {
        cite!("Patch-inlet");
        let factor = |sigma, attenuation: &Attenuation| {
            self.flow(attenuation)?.inlet_factor(sigma, smooth_gap)
        };
        RoughInlet::by(&self.waves, nabla_per_length, smooth_gap, TOLERANCE, factor)
    }

    fn table(&self, power: i32) -> Result<Arc<FlowTable>, RegimeError> {
        // Threads that need a table wait for the first one.
        let mut known = self.tables.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(table) = known.get(&power) {
            return Ok(Arc::clone(table));
        }
        let attenuation = Attenuation::new(GapLaw::Inlet, f64::from(power).exp2())?;
        let [first, second] = &self.patches;
        let (first, second) = (
            first.attenuated(&attenuation),
            second.attenuated(&attenuation),
        );
        let place = |place| first.clone().composite(&second, self.offset(place));
        let patches: Vec<Patch> = (0..self.places).map(place).collect();
        let made = Arc::new(FlowTable::new(&patches)?);
        known.insert(power, Arc::clone(&made));
        Ok(made)
    }
}
