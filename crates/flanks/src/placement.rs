//! Places of the traces on their flanks, and the windows in contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | l | arc of the involute from the base circle | m |
//! | ρ | roll length of a contact | m |
//! | r_b | base radius | m |
//! | x | common tangent, towards the pinion's tip | m |
//! | a | half width of the contact | m |
//!
//! Traces are stored along x, so the window of a contact is a run of neighbouring points on both. A window
//! beyond the end of a trace continues on the mirror image of the trace.

use asperity_core::quantity::Length;
use asperity_core::{Profile, cite};

use crate::error::PositionError;
use crate::mesh_position::MeshPosition;

/// Share of the loss that must lie on the traces, or there is no placement.
pub const LEAST_COVERAGE: f64 = 0.3;
/// Share of the loss below which the missing places are said.
pub const FULL_COVERAGE: f64 = 0.9;

/// Place of one trace on its flank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedTrace {
    /// Arc of the first point, from the base circle \[m\].
    pub first_arc: f64,
    /// Growth of the arc along x: 1 or −1.
    pub direction: f64,
    /// Base radius of the gear \[m\].
    pub base_radius: f64,
}

/// Places of both traces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Traces of pinion and wheel.
    pub traces: [PlacedTrace; 2],
    /// Assumed misplacement of each trace along x in half-widths, opposite for the two traces; 0 unless the effect of a
    /// misplacement is requested.
    pub misplaced: f64,
}

impl PlacedTrace {
    /// Index \[points\] on the trace of the middle of a contact with the roll length `roll`.
    ///
    /// ```text
    /// i = ±(ρ²/(2 r_b) − l₀)/dx                                                  [Flank-window]
    /// ```
    #[must_use]
    pub fn middle(&self, roll: Length, spacing: Length) -> f64 {
        cite!("Flank-window");
        let arc = roll.si() * roll.si() / (2.0 * self.base_radius);
        self.direction * (arc - self.first_arc) / spacing.si()
    }

    /// Roll lengths of the first and the last point of `trace`; 0 where it reaches below the base circle.
    pub fn roll_lengths(&self, trace: &Profile) -> [Length; 2] {
        let last = self.first_arc + self.direction * trace.length().si();
        [self.first_arc, last].map(|arc| self.roll_length(arc))
    }

    /// Roll length of the point at an arc \[m\]; 0 below the base circle.
    pub fn roll_length(&self, arc: f64) -> Length {
        // ρ = √(2 r_b l), [Flank-arc] solved for ρ.
        Length::from_si((2.0 * self.base_radius * arc.max(0.0)).sqrt())
    }
}

impl Placement {
    /// Middles of the contact at `position` on traces of `points` points `spacing` apart, and whether both lie on
    /// data; where they do not, the nearest places that do.
    pub fn middles(
        &self,
        position: &MeshPosition,
        points: [usize; 2],
        spacing: Length,
    ) -> ([usize; 2], bool) {
        let rolls = [position.motion.rho1, position.motion.rho2];
        let shift = self.misplaced * position.hertz.half_width.si() / spacing.si();
        let mut covered = true;
        let middles = [0, 1].map(|body: usize| {
            let last = points[body] as f64 - 1.0;
            let exact = self.traces[body].middle(rolls[body], spacing);
            covered &= (-0.5..=last + 0.5).contains(&exact);
            let side = if body == 0 { shift } else { -shift };
            (exact + side).round().clamp(0.0, last) as usize
        });
        (middles, covered)
    }

    /// Share of the loss at places that both traces cover, by f |V_s|.
    pub fn coverage<'a>(
        &self,
        positions: impl Iterator<Item = &'a MeshPosition>,
        points: [usize; 2],
        spacing: Length,
    ) -> f64 {
        let (mut covered, mut total) = (0.0, 0.0);
        for position in positions {
            let weight = position.weight * position.load.si() * position.mean_sliding();
            total += weight;
            if self.middles(position, points, spacing).1 {
                covered += weight;
            }
        }
        covered / total
    }
}

/// Refuses a placement on which hardly any contact lies.
pub fn check_coverage(coverage: f64) -> Result<(), PositionError> {
    if coverage >= LEAST_COVERAGE {
        Ok(())
    } else {
        Err(PositionError::not_covered(coverage))
    }
}
