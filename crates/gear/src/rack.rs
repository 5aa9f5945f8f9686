//! Geometry of the single gears from the basic rack and the tooth numbers.
//!
//! Source: ISO 21771:2007. Symbols as in [`crate::pair`].

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Length};

use crate::error::GearError;
use crate::input::{GearPairInput, Plane};
use crate::involute::ToothSection;

/// Maximum helix angle; drawings have up to 45°, and pairs above 60° are screws.
const MAX_HELIX_DEGREES: f64 = 60.0;

/// Maximum normal pressure angle; above it a full-depth rack tooth is pointed.
const MAX_PRESSURE_ANGLE_DEGREES: f64 = 45.0;

/// The transverse section and its radii.
#[derive(Debug, Clone)]
pub(crate) struct Rack {
    /// z₁, z₂; negative for a ring, like its radii.
    pub(crate) teeth: [f64; 2],
    pub(crate) internal: bool,
    pub(crate) normal_module: Length,
    pub(crate) transverse_module: Length,
    pub(crate) alpha_n: f64,
    pub(crate) alpha_t: f64,
    pub(crate) beta: f64,
    pub(crate) beta_b: f64,
    pub(crate) reference_radius: [Length; 2],
    pub(crate) base_radius: [Length; 2],
}

impl Rack {
    /// mₜ = mₙ/cos β, tan αₜ = tan αₙ/cos β, sin β_b = sin β·cos αₙ,
    /// r = mₜ z/2, r_b = r·cos αₜ                                            [Pair-1]
    pub(crate) fn new(input: &GearPairInput, internal: bool) -> Result<Self, GearError> {
        cite!("Pair-1");
        let teeth = signed_teeth(input.teeth, internal)?;
        let module = DomainError::positive("module", input.module)?;
        let alpha_n = DomainError::positive("pressure angle", input.pressure_angle)?;
        DomainError::require(
            alpha_n <= MAX_PRESSURE_ANGLE_DEGREES.to_radians(),
            "pressure angle",
            alpha_n.to_degrees(),
            "deg",
            "must not be above 45 deg",
        )?;
        let beta = DomainError::finite("helix angle", input.helix)?.abs();
        DomainError::require(
            beta <= MAX_HELIX_DEGREES.to_radians(),
            "helix angle",
            beta.to_degrees(),
            "deg",
            "must lie within 60 deg",
        )?;
        let (m_n, m_t) = match input.module_plane {
            Plane::Normal => (module, module / beta.cos()),
            Plane::Transverse => (module * beta.cos(), module),
        };
        let alpha_t = (alpha_n.tan() / beta.cos()).atan();
        let r = teeth.map(|z| Length::from_si(0.5 * m_t * z));
        Ok(Self {
            teeth,
            internal,
            normal_module: Length::from_si(m_n),
            transverse_module: Length::from_si(m_t),
            alpha_n,
            alpha_t,
            beta,
            beta_b: (beta.sin() * alpha_n.cos()).asin(),
            reference_radius: r,
            base_radius: r.map(|r| r * alpha_t.cos()),
        })
    }

    pub(crate) fn tooth(&self, gear: usize, profile_shift: f64) -> ToothSection {
        ToothSection {
            teeth: self.teeth[gear].abs() as u32,
            profile_shift,
            normal_pressure_angle: Angle::from_si(self.alpha_n),
            transverse_pressure_angle: Angle::from_si(self.alpha_t),
            base_radius: self.base_radius[gear],
        }
    }

    pub(crate) fn tooth_sum(&self) -> f64 {
        self.teeth[0] + self.teeth[1]
    }

    pub(crate) fn base_radius_sum(&self) -> Length {
        self.base_radius[0] + self.base_radius[1]
    }
}

/// The tooth numbers with the signs of ISO 21771: negative for a ring.
fn signed_teeth(teeth: [u32; 2], internal: bool) -> Result<[f64; 2], DomainError> {
    for z in teeth {
        DomainError::require(z >= 1, "teeth", z.into(), "-", "must be at least 1")?;
    }
    let [z1, z2] = teeth.map(f64::from);
    if !internal {
        return Ok([z1, z2]);
    }
    DomainError::require(
        z2 > z1,
        "teeth of the ring",
        z2,
        "-",
        "must be more than the teeth of the gear inside it",
    )?;
    Ok([z1, -z2])
}
