//! Inputs of a gear pair.

use asperity_core::quantity::{Angle, Length};
use serde::{Deserialize, Serialize};

/// Addendum of the basic rack in normal modules (ISO 53:1998, profile A).
const STANDARD_ADDENDUM: f64 = 1.0;

/// Normal pressure angle of the basic rack (ISO 53:1998).
const STANDARD_PRESSURE_ANGLE_DEGREES: f64 = 20.0;

/// Section in which a module is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Plane {
    /// The normal section: mₙ, the module of the tool.
    #[default]
    Normal,
    /// The transverse section: mₜ = mₙ/cos β.
    Transverse,
}

/// Drawing data of an external cylindrical gear pair. Index 0 is gear 1, the pinion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GearPairInput {
    /// Tooth numbers z₁, z₂.
    pub teeth: [u32; 2],
    /// Module.
    pub module: Length,
    /// The section in which `module` is measured.
    #[serde(default)]
    pub module_plane: Plane,
    /// Helix angle β at the reference cylinder; the hand does not matter.
    pub helix: Angle,
    /// Normal pressure angle αₙ of the basic rack.
    pub pressure_angle: Angle,
    /// Face widths b₁, b₂.
    pub face_width: [Length; 2],
    /// Width over which the faces overlap, if less than the narrower face width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub overlap: Option<Length>,
    /// Profile shift coefficients x₁, x₂, in normal modules; a positive one brings the teeth of a ring towards its axis. Default: zero; with a centre distance and no tip radii, its
    /// sum of the shifts, divided for equal specific sliding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profile_shift: Option<[f64; 2]>,
    /// Centre distance; default: without backlash.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_distance: Option<Length>,
    /// Tip radii; default r + mₙ·(hₐ* + x).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip_radius: Option<[Length; 2]>,
    /// Addendum hₐ* of the basic rack, in normal modules.
    #[serde(default = "standard_addendum")]
    pub addendum: f64,
}

fn standard_addendum() -> f64 {
    STANDARD_ADDENDUM
}

impl GearPairInput {
    /// A pair of the basic rack of ISO 53 (αₙ = 20°, hₐ* = 1) without profile shift, with `module`
    /// in the normal section.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let input = GearPairInput {
    ///     profile_shift: Some([0.3, -0.3]),
    ///     ..GearPairInput::standard([20, 60], "2 mm".parse()?, "0 deg".parse()?, "25 mm".parse()?)
    /// };
    /// assert!((GearPair::new(&input)?.centre_distance.si() - 0.080).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn standard(teeth: [u32; 2], module: Length, helix: Angle, face_width: Length) -> Self {
        Self {
            teeth,
            module,
            module_plane: Plane::Normal,
            helix,
            pressure_angle: Angle::from_si(STANDARD_PRESSURE_ANGLE_DEGREES.to_radians()),
            face_width: [face_width; 2],
            overlap: None,
            profile_shift: None,
            centre_distance: None,
            tip_radius: None,
            addendum: STANDARD_ADDENDUM,
        }
    }

    /// The pair with gears 1 and 2 exchanged.
    pub fn swapped(&self) -> Self {
        let reversed = |pair: [Length; 2]| [pair[1], pair[0]];
        Self {
            teeth: [self.teeth[1], self.teeth[0]],
            face_width: reversed(self.face_width),
            profile_shift: self.profile_shift.map(|[x1, x2]| [x2, x1]),
            tip_radius: self.tip_radius.map(reversed),
            ..self.clone()
        }
    }
}
