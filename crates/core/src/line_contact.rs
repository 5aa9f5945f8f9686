//! Loaded line contact in motion: the conditions that film, friction and heat have in common.

use serde::Serialize;

use crate::material::Material;
use crate::quantity::{Length, LineLoad, Pressure, Speed};

/// Loaded line contact of two moving bodies.
///
/// ```
/// use asperity_core::{line_contact::LineContact, material::Material};
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "1500 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// let contact = LineContact {
///     load: "300 N/mm".parse()?, radius: "9 mm".parse()?, modulus: "115.385 GPa".parse()?,
///     speeds: ["4.5 m/s".parse()?, "3.5 m/s".parse()?], bodies: [steel, steel],
/// };
/// assert_eq!((contact.entrainment().si(), contact.sliding().si()), (4.0, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LineContact {
    /// Load per length of contact line w.
    pub load: LineLoad,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Surface speeds u₁, u₂ in the direction of motion.
    pub speeds: [Speed; 2],
    /// Materials of the two bodies.
    pub bodies: [Material; 2],
}

impl LineContact {
    /// Entrainment speed (u₁ + u₂)/2.
    #[must_use]
    pub fn entrainment(&self) -> Speed {
        (self.speeds[0] + self.speeds[1]) * 0.5
    }

    /// Sliding speed u₁ − u₂.
    #[must_use]
    pub fn sliding(&self) -> Speed {
        self.speeds[0] - self.speeds[1]
    }
}
