//! One mesh position without roughness and oil: motion, load, Hertz contact.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_gear::Kinematics;

use crate::error::PositionError;

/// Whether the rough contact at a mesh position must be resolved by the points of the traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resolution {
    /// It must be, or there is no result.
    Required,
    /// If the points are too far apart, the roughness of the whole traces is used for the window: the
    /// position carries so little of the loss, or none.
    WhereFine,
}

/// A mesh position: everything that depends on neither roughness nor oil.
#[derive(Debug, Clone)]
pub struct MeshPosition {
    /// Number of the position from A.
    pub number: usize,
    /// Coordinate along the line of action from T₁.
    pub s: Length,
    /// Weight in the cycle mean \[m of loaded contact line\].
    pub weight: f64,
    /// Mean of f |V_s| over the contact line that the position represents, relative to that at the position.
    pub sliding_factor: f64,
    /// Whether the rough contact must be resolved.
    pub resolution: Resolution,
    /// Cell of the path that it represents, from 0: zones of the face divide a cell.
    pub cell: usize,
    /// Zone of the face that it represents, each with traces of its own: 0 where these represent the whole face.
    pub zone: usize,
    /// Radii and speeds.
    pub motion: Kinematics,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Smooth dry contact.
    pub hertz: HertzLine,
}

impl MeshPosition {
    /// The loaded line contact of the position between bodies of the reduced modulus `modulus`.
    pub fn line_contact(&self, modulus: Pressure, bodies: [Material; 2]) -> LineContact {
        LineContact {
            load: self.load,
            radius: self.motion.radius,
            modulus,
            speeds: [self.motion.u1, self.motion.u2],
            bodies,
        }
    }

    /// `share` of the Hertz pressure \[Pa\] at the points `x` \[m\].
    pub fn hertz_pressure(&self, x: &[f64], share: f64) -> Result<Vec<f64>, PositionError> {
        x.iter()
            .map(|&x| Ok(share * self.hertz.pressure(Length::from_si(x))?.si()))
            .collect()
    }

    /// Sliding speed \[m/s\] that gives, times the friction force at the position, the mean sliding power over the
    /// contact line that it represents.
    pub fn mean_sliding(&self) -> f64 {
        self.motion.sliding.si().abs() * self.sliding_factor
    }
}
