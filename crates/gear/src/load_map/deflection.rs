//! Transmission error and mesh stiffness.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | δ | approach of the teeth, normal to the flank | m |
//! | TE | transmission error along the transverse line of action | m |
//! | c_γ | mesh stiffness per metre of face width | N/m² |

use asperity_core::cite;
use asperity_core::numerics::range;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use super::map::{LoadMap, LoadModel};
use super::phases::MeshPhase;
use crate::error::GearError;

/// Number of evenly spaced phases per pitch.
const PHASES: u32 = 64;

/// Transmission error over a mesh cycle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TransmissionError {
    /// Mean over the mesh cycle.
    pub mean: Length,
    /// Difference of maximum and minimum.
    pub peak_to_peak: Length,
    /// Mean over the phases of F_bt/(b TE), in N/m².
    pub mesh_stiffness: f64,
    /// Phases in pitches from the start of the cycle with the transmission errors.
    pub curve: Vec<(f64, Length)>,
}

impl LoadMap {
    /// TE = δ/cos β_b at 64 even phases of each pitch of the cycle                 [TE-1]
    ///
    /// c_γ = mean of F_bt/(b TE)                                                 [TE-2]
    ///
    /// `None` for a law without deflections.
    ///
    /// # Errors
    /// As [`at_phase`](Self::at_phase).
    pub fn transmission_error(&self) -> Result<Option<TransmissionError>, GearError> {
        let LoadModel::Elastic(grid, _) = &self.model else {
            return Ok(None);
        };
        cite!("TE-1");
        cite!("TE-2");
        let cos = self.pair.base_helix.si().cos();
        let mut rows = Vec::new();
        let mut evidence = self.evidence.clone();
        let mut curve = Vec::new();
        for pitch in 0..grid.separation.pitches() {
            for n in 0..PHASES {
                let phase = MeshPhase {
                    phase: (f64::from(n) + 0.5) / f64::from(PHASES),
                    weight: 1.0,
                    pitch,
                };
                if let Some(approach) = self.solve(&phase, &mut rows, &mut evidence, &mut |_| ())? {
                    curve.push((phase.phase + pitch as f64, Length::from_si(approach / cos)));
                }
            }
        }
        let errors = || curve.iter().map(|(_, error)| error.si());
        let count = curve.len() as f64;
        let transverse = self.force * cos / self.pair.face_width.si();
        let [low, high] = range(errors());
        Ok(Some(TransmissionError {
            mean: Length::from_si(errors().sum::<f64>() / count),
            peak_to_peak: Length::from_si(high - low),
            mesh_stiffness: errors().map(|te| transverse / te).sum::<f64>() / count,
            curve,
        }))
    }
}
