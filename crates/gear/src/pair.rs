//! From the drawing of a gear pair to its working geometry.
//!
//! Source: ISO 21771:2007 (definitions and symbols).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | mₙ, mₜ | normal, transverse module | m |
//! | αₙ, αₜ, α_wt | normal, transverse, working transverse pressure angle | rad |
//! | β, β_b | helix angle at the reference, at the base cylinder | rad |
//! | x₁, x₂ | profile shift coefficients, in normal modules | - |
//! | a | centre distance | m |
//! | r, r_b, r_w, r_a | reference, base, working pitch, tip radius | m |
//! | b | width over which the faces overlap | m |
//!
//! Limits: external pairs on parallel axes, perfect involutes, rigid teeth, no backlash. A pair is
//! refused when a tip reaches past the mating involute, when a tooth is pointed, or when contact is
//! not continuous. Undercut that the tool leaves below the path of contact is not looked for.

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Length};
use serde::Serialize;

use crate::error::{Gear, GearError};
use crate::input::{GearPairInput, Plane};
use crate::involute::{self, ToothSection, half_angle};
use crate::path_of_contact::PathOfContact;

/// Largest helix angle accepted; drawings end near 45°, beyond 60° the pair is a pair of screws.
const STEEPEST_HELIX_DEGREES: f64 = 60.0;

/// Largest normal pressure angle accepted; beyond it a full-depth rack tooth is pointed.
const LARGEST_PRESSURE_ANGLE_DEGREES: f64 = 45.0;

/// Difference in normal modules accepted between a given centre distance and that of the given
/// profile shifts: what rounding two coefficients to two decimals can do.
const CENTRE_DISTANCE_TOLERANCE: f64 = 0.01;

/// The working geometry of a gear pair. Index 0 is gear 1, the pinion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GearPair {
    /// Tooth numbers z₁, z₂.
    pub teeth: [u32; 2],
    /// Gear ratio u = z₂/z₁.
    pub ratio: f64,
    /// Normal module mₙ.
    pub normal_module: Length,
    /// Transverse module mₜ.
    pub transverse_module: Length,
    /// Normal pressure angle αₙ.
    pub normal_pressure_angle: Angle,
    /// Transverse pressure angle αₜ.
    pub transverse_pressure_angle: Angle,
    /// Working transverse pressure angle α_wt.
    pub working_pressure_angle: Angle,
    /// Helix angle |β| at the reference cylinder.
    pub helix: Angle,
    /// Helix angle β_b at the base cylinder.
    pub base_helix: Angle,
    /// Width b over which the faces overlap.
    pub face_width: Length,
    /// Profile shift coefficients; none when only their sum is known.
    pub profile_shift: Option<[f64; 2]>,
    /// x₁ + x₂.
    pub profile_shift_sum: f64,
    /// Centre distance a.
    pub centre_distance: Length,
    /// Reference radii r.
    pub reference_radius: [Length; 2],
    /// Base radii r_b.
    pub base_radius: [Length; 2],
    /// Working pitch radii r_w.
    pub working_pitch_radius: [Length; 2],
    /// Tip radii r_a.
    pub tip_radius: [Length; 2],
    /// Thickness of the teeth at their tips in the transverse section; none when only the sum of
    /// the profile shifts is known.
    pub tip_thickness: Option<[Length; 2]>,
    /// The path of contact.
    pub path: PathOfContact,
}

impl GearPair {
    /// Derives the working geometry.
    ///
    /// Centre distance and profile shifts may both be given, if they agree to 0.01 mₙ; the given
    /// centre distance then counts for the mesh and the shifts for the teeth. With the centre
    /// distance alone only the sum of the shifts follows, and the tip radii must be given.
    ///
    /// # Errors
    /// When a number is out of its domain, the givens contradict each other, or the pair does not
    /// work: interference, pointed tips, or a contact ratio (transverse for spur, total for
    /// helical pairs) of 1 or less.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// assert!((pair.centre_distance.si() - 127.59441e-3).abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(input: &GearPairInput) -> Result<Self, GearError> {
        let rack = Rack::new(input)?;
        let face_width = face_width(input)?;
        let centre = Centre::new(input, &rack)?;
        let tip_radius = tip_radii(input, &rack, &centre)?;
        let tip_thickness = tip_thickness(&rack, &centre, tip_radius)?;
        let path = PathOfContact::new(
            rack.base_radius,
            tip_radius,
            centre.working_angle,
            rack.transverse_module * (std::f64::consts::PI * rack.alpha_t.cos()),
            face_width * rack.beta_b.tan(),
        )?;
        let [z1, z2] = rack.teeth.map(f64::from);
        let a = centre.distance;
        Ok(Self {
            teeth: input.teeth,
            ratio: z2 / z1,
            normal_module: rack.normal_module,
            transverse_module: rack.transverse_module,
            normal_pressure_angle: input.pressure_angle,
            transverse_pressure_angle: Angle::from_si(rack.alpha_t),
            working_pressure_angle: Angle::from_si(centre.working_angle),
            helix: Angle::from_si(rack.beta),
            base_helix: Angle::from_si(rack.beta_b),
            face_width,
            profile_shift: centre.profile_shift,
            profile_shift_sum: centre.shift_sum,
            centre_distance: a,
            reference_radius: rack.reference_radius,
            base_radius: rack.base_radius,
            working_pitch_radius: [a * (z1 / (z1 + z2)), a * (z2 / (z1 + z2))],
            tip_radius,
            tip_thickness,
            path,
        })
    }

    /// The path of contact.
    pub fn path(&self) -> &PathOfContact {
        &self.path
    }

    /// Whether the teeth are straight.
    pub fn is_spur(&self) -> bool {
        self.helix.si() == 0.0
    }
}

/// What the basic rack and the tooth numbers give, before the gears are brought together.
struct Rack {
    teeth: [u32; 2],
    normal_module: Length,
    transverse_module: Length,
    alpha_n: f64,
    alpha_t: f64,
    beta: f64,
    beta_b: f64,
    reference_radius: [Length; 2],
    base_radius: [Length; 2],
}

impl Rack {
    /// mₜ = mₙ/cos β, tan αₜ = tan αₙ/cos β, sin β_b = sin β·cos αₙ,
    /// r = mₜ z/2, r_b = r·cos αₜ                                            [Pair-1]
    fn new(input: &GearPairInput) -> Result<Self, GearError> {
        for z in input.teeth {
            DomainError::require(z >= 1, "teeth", z.into(), "-", "must be at least 1")?;
        }
        let module = DomainError::positive("module", input.module)?;
        let alpha_n = DomainError::positive("pressure angle", input.pressure_angle)?;
        DomainError::require(
            alpha_n <= LARGEST_PRESSURE_ANGLE_DEGREES.to_radians(),
            "pressure angle",
            alpha_n.to_degrees(),
            "deg",
            "must not be above 45 deg",
        )?;
        let beta = DomainError::finite("helix angle", input.helix)?.abs();
        DomainError::require(
            beta <= STEEPEST_HELIX_DEGREES.to_radians(),
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
        let r = input
            .teeth
            .map(|z| Length::from_si(0.5 * m_t * f64::from(z)));
        Ok(Self {
            teeth: input.teeth,
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

    fn tooth(&self, gear: usize, profile_shift: f64) -> ToothSection {
        ToothSection {
            teeth: self.teeth[gear],
            profile_shift,
            normal_pressure_angle: Angle::from_si(self.alpha_n),
            transverse_pressure_angle: Angle::from_si(self.alpha_t),
            base_radius: self.base_radius[gear],
        }
    }

    fn tooth_sum(&self) -> f64 {
        f64::from(self.teeth[0]) + f64::from(self.teeth[1])
    }

    fn base_radius_sum(&self) -> Length {
        self.base_radius[0] + self.base_radius[1]
    }
}

fn face_width(input: &GearPairInput) -> Result<Length, DomainError> {
    let [b1, b2] = input.face_width;
    let narrower =
        DomainError::positive("face width", b1)?.min(DomainError::positive("face width", b2)?);
    let Some(overlap) = input.overlap else {
        return Ok(Length::from_si(narrower));
    };
    let overlap = DomainError::positive("overlap", overlap)?;
    let width = DomainError::require(
        overlap <= narrower,
        "overlap",
        overlap,
        "m",
        "must not be wider than the narrower face",
    )?;
    Ok(Length::from_si(width))
}

/// How the two gears are brought together.
struct Centre {
    distance: Length,
    working_angle: f64,
    shift_sum: f64,
    profile_shift: Option<[f64; 2]>,
}

impl Centre {
    fn new(input: &GearPairInput, rack: &Rack) -> Result<Self, GearError> {
        let shifts = match (input.profile_shift, input.centre_distance) {
            (None, Some(distance)) => return Self::from_distance(distance, rack),
            (None, None) => [0.0; 2],
            (Some(shifts), _) => shifts,
        };
        for x in shifts {
            DomainError::require(x.is_finite(), "profile shift", x, "-", "must be finite")?;
        }
        let from_shifts = Self::from_shifts(shifts, rack)?;
        let Some(given) = input.centre_distance else {
            return Ok(from_shifts);
        };
        let tolerance = rack.normal_module * CENTRE_DISTANCE_TOLERANCE;
        let from_distance = Self::from_distance(given, rack)?;
        if (given - from_shifts.distance).si().abs() > tolerance.si() {
            return Err(GearError::InconsistentCentreDistance {
                given,
                from_shifts: from_shifts.distance,
                tolerance,
            });
        }
        Ok(Self {
            distance: given,
            working_angle: from_distance.working_angle,
            ..from_shifts
        })
    }

    /// inv α_wt = inv αₜ + 2 tan αₙ·(x₁ + x₂)/(z₁ + z₂),  a = (r_b1 + r_b2)/cos α_wt  [Pair-2]
    fn from_shifts(profile_shift: [f64; 2], rack: &Rack) -> Result<Self, GearError> {
        let shift_sum = profile_shift[0] + profile_shift[1];
        let working_angle = if shift_sum == 0.0 {
            rack.alpha_t
        } else {
            let reference = involute::involute(Angle::from_si(rack.alpha_t))?;
            let working = reference + 2.0 * rack.alpha_n.tan() * shift_sum / rack.tooth_sum();
            DomainError::require(
                working > 0.0,
                "sum of the profile shifts",
                shift_sum,
                "-",
                "is so low that the base circles overlap",
            )?;
            involute::inverse_involute(working)?.angle.si()
        };
        Ok(Self {
            distance: rack.base_radius_sum() / working_angle.cos(),
            working_angle,
            shift_sum,
            profile_shift: Some(profile_shift),
        })
    }

    /// cos α_wt = (r_b1 + r_b2)/a,  x₁ + x₂ = (inv α_wt − inv αₜ)·(z₁ + z₂)/(2 tan αₙ)  [Pair-3]
    fn from_distance(distance: Length, rack: &Rack) -> Result<Self, GearError> {
        DomainError::positive("centre distance", distance)?;
        if distance <= rack.base_radius_sum() {
            return Err(GearError::CentreDistanceTooSmall {
                given: distance,
                base_radii: rack.base_radius_sum(),
            });
        }
        let working_angle = (rack.base_radius_sum() / distance).acos();
        let difference = involute::involute(Angle::from_si(working_angle))?
            - involute::involute(Angle::from_si(rack.alpha_t))?;
        Ok(Self {
            distance,
            working_angle,
            shift_sum: difference * rack.tooth_sum() / (2.0 * rack.alpha_n.tan()),
            profile_shift: None,
        })
    }
}

/// r_a = r + mₙ·(hₐ* + x)                                                    [Pair-4]
fn tip_radii(
    input: &GearPairInput,
    rack: &Rack,
    centre: &Centre,
) -> Result<[Length; 2], GearError> {
    let radii = match (input.tip_radius, centre.profile_shift) {
        (Some(radii), _) => radii,
        (None, None) => {
            return Err(GearError::TipRadiusUnknown {
                sum: centre.shift_sum,
            });
        }
        (None, Some([x1, x2])) => {
            let h = input.addendum;
            DomainError::require(
                h.is_finite() && h > 0.0,
                "addendum",
                h,
                "-",
                "must be finite and greater than zero",
            )?;
            let [r1, r2] = rack.reference_radius;
            let m_n = rack.normal_module;
            [r1 + m_n * (h + x1), r2 + m_n * (h + x2)]
        }
    };
    for (radius, base) in radii.into_iter().zip(rack.base_radius) {
        DomainError::require(
            radius.si().is_finite() && radius > base,
            "tip radius",
            radius.si(),
            "m",
            "must be finite and larger than the base radius",
        )?;
    }
    Ok(radii)
}

/// The tip lands, or the refusal of a pair whose teeth are pointed.
fn tip_thickness(
    rack: &Rack,
    centre: &Centre,
    tip_radius: [Length; 2],
) -> Result<Option<[Length; 2]>, GearError> {
    let half_angles = |x: [f64; 2]| -> Result<[f64; 2], DomainError> {
        let angle = |gear: usize| half_angle(&rack.tooth(gear, x[gear]), tip_radius[gear]);
        Ok([angle(0)?, angle(1)?])
    };
    let Some(shifts) = centre.profile_shift else {
        // z·(half-angle) is linear in x, so the sum over both gears does not depend on the division.
        let angles = half_angles([centre.shift_sum, 0.0])?;
        let [z1, z2] = rack.teeth.map(f64::from);
        let sum = z1 * angles[0] + z2 * angles[1];
        return if sum > 0.0 {
            Ok(None)
        } else {
            Err(GearError::PointedTips { sum })
        };
    };
    let angles = half_angles(shifts)?;
    let thickness = [0, 1].map(|gear| tip_radius[gear] * (2.0 * angles[gear]));
    for (gear, thickness) in [Gear::Pinion, Gear::Wheel].into_iter().zip(thickness) {
        if thickness.si() <= 0.0 {
            return Err(GearError::PointedTip { gear, thickness });
        }
    }
    Ok(Some(thickness))
}
