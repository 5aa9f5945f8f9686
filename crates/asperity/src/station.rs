//! One mesh position without roughness: motion, load, Hertz contact, smooth film.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::OutOfRange;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{Length, LineLoad};
use asperity_ehl_regime::{FilmConditions, FilmThickness};
use asperity_gear::Kinematics;

/// A place on the path of contact that represents a part of the mesh.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Coordinate along the line of action from T₁.
    pub s: Length,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Weight in the cycle mean: the loaded length of contact line.
    pub weight: Length,
    /// Mean of f |V_s| over that length, over the same at the place itself.
    pub sliding_factor: f64,
    /// Whether the rough contact must be resolved.
    pub resolution: Resolution,
    /// Zone of the face that it represents.
    pub zone: usize,
}

/// Whether the rough contact at a mesh position must be resolved by the points of the traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resolution {
    /// It must be, or there is no result.
    Required,
    /// Where the points are too far apart, the roughness of the whole traces is used for the window: the
    /// position carries so little of the loss, or none.
    WhereFine,
}

/// A mesh position: everything that does not depend on the roughness.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Station {
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
    /// Zone of the face that it represents, each with traces of its own: 0 where these stand for the whole face.
    pub zone: usize,
    /// Radii and speeds.
    pub motion: Kinematics,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Smooth dry contact.
    pub hertz: HertzLine,
    /// Inputs of the film laws.
    pub film_conditions: FilmConditions,
    /// Thermal reduction φ of film and rolling.
    pub thermal_reduction: f64,
    /// Smooth film with thermal reduction, as the formulae give it: their central film is one of mass flow.
    pub film: FilmThickness,
    /// The same with the central film as Λ* and the tables take it.
    pub film_shown: FilmThickness,
    /// Inputs that left their fitted range.
    pub outside: Vec<OutOfRange>,
}

impl Station {
    /// The loaded line contact of bodies of these materials.
    pub fn line_contact(&self, bodies: [Material; 2]) -> LineContact {
        LineContact {
            load: self.load,
            radius: self.motion.radius,
            modulus: self.film_conditions.modulus,
            speeds: [self.motion.u1, self.motion.u2],
            bodies,
        }
    }
}
