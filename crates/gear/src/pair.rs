//! Working geometry of a gear pair.
//!
//! Source: ISO 21771:2007 (definitions and symbols).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | mₙ, mₜ | normal, transverse module | m |
//! | αₙ, αₜ, α_wt | normal, transverse, working transverse pressure angle | rad |
//! | β, β_b | helix angle at the reference and the base cylinder | rad |
//! | x₁, x₂ | profile shift coefficients, in normal modules | - |
//! | a | centre distance | m |
//! | r, r_b, r_w, r_a | reference, base, working pitch, tip radius | m |
//! | b | width over which the faces overlap | m |
//!
//! Limits: parallel axes, perfect involutes, rigid teeth, no backlash. A pair is an error if a tip reaches past the
//! mating involute, a tooth is pointed, or contact is not continuous. Undercut below the path of contact and
//! interference of tips inside a ring away from the line of action ([`GearPair::tips_may_foul`]) are not checked.
//!
//! A ring follows the signs of ISO 21771: with z₂ < 0 also u, r₂, r_b2, r_w2, r_a2, a and T₁T₂ are
//! negative, and every formula holds unchanged except A = T₁T₂ − sgn(z₂)·√(r_a2² − r_b2²).

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Length};
use serde::{Deserialize, Serialize};

use crate::centre_distance::Centre;
use crate::error::GearError;
use crate::input::GearPairInput;
use crate::path_of_contact::{MIN_OVERLAP, PathOfContact};
use crate::rack::Rack;
use crate::tips::{tip_radii, tip_thickness};

/// Minimum difference of the tooth numbers without tip interference between a pinion and its ring with standard addenda
/// (one more than the least that clears, references/small_constants.py).
const MIN_RING_DIFFERENCE: u32 = 10;

/// The working geometry of a gear pair. Index 0 is gear 1, the pinion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GearPair {
    /// Tooth numbers |z₁|, |z₂|.
    pub teeth: [u32; 2],
    /// Whether gear 2 is a ring. Its radii, the ratio, a and T₁T₂ are then negative.
    pub internal: bool,
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
    /// Profile shift coefficients; `None` if only their sum is known.
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
    /// Thickness of the teeth at their tips in the transverse section; `None` if only the sum of the profile shifts is
    /// known.
    pub tip_thickness: Option<[Length; 2]>,
    /// The path of contact.
    pub path: PathOfContact,
}

impl GearPair {
    /// Derives the working geometry.
    ///
    /// If both centre distance and profile shifts are given, they must agree to 0.01 mₙ; the mesh then has the given
    /// centre distance and the teeth the given shifts. A centre distance without shifts determines only the sum of the
    /// shifts: without tip radii an external pair takes the division with equal specific sliding at both ends of contact,
    /// and a ring is refused.
    ///
    /// # Errors
    /// When a number is out of its domain, the inputs contradict each other, or the geometry is invalid: interference,
    /// pointed tips, or a contact ratio (transverse for spur, total for helical pairs) of 1 or less.
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
        Self::derive(input, false)
    }

    /// Derives the working geometry of a pinion inside a ring.
    ///
    /// Gear 2 of the input is the ring; its tooth number, tip radius and the centre distance are given as magnitudes.
    /// The sign of its profile shift follows ISO 21771: a positive shift moves the teeth of the ring towards its axis.
    ///
    /// # Errors
    /// As [`GearPair::new`]; also when the ring has no more teeth than the pinion, or its tips reach
    /// below the involute of the pinion.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::internal(&GearPairInput::standard(
    ///     [24, 75], "1.5 mm".parse()?, "0 deg".parse()?, "20 mm".parse()?,
    /// ))?;
    /// assert!((pair.centre_distance.si() + 38.25e-3).abs() < 1e-12);
    /// assert!((pair.path().eps_alpha - 1.923058).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn internal(input: &GearPairInput) -> Result<Self, GearError> {
        Self::derive(input, true)
    }

    fn derive(input: &GearPairInput, internal: bool) -> Result<Self, GearError> {
        let rack = Rack::new(input, internal)?;
        let face_width = face_width(input)?;
        let mut centre = Centre::new(input, &rack)?;
        if input.tip_radius.is_none() && centre.profile_shift.is_none() {
            centre.profile_shift = centre.divided(&rack, input.addendum);
        }
        let tip_radius = tip_radii(input, &rack, &centre)?;
        let tip_thickness = tip_thickness(&rack, &centre, tip_radius)?;
        let path = PathOfContact::new(
            rack.base_radius,
            tip_radius,
            centre.working_angle,
            rack.transverse_module * (std::f64::consts::PI * rack.alpha_t.cos()),
            face_width * rack.beta_b.tan(),
        )?;
        let [z1, z2] = rack.teeth;
        let a = centre.distance;
        Ok(Self {
            teeth: input.teeth,
            internal,
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

    /// The pair with chamfered tips: the active tip radii are the tip radii minus the radial chamfers (plus, for a
    /// ring).
    ///
    /// # Errors
    /// When a chamfer is negative, takes a tip below its base circle, or leaves no continuous contact.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [23, 68], "1.8 mm".parse()?, "23.4 deg".parse()?, "32 mm".parse()?,
    /// ))?;
    /// let chamfered = pair.with_tip_chamfer(["0.1 mm".parse()?; 2])?;
    /// assert!(chamfered.path().eps_alpha < pair.path().eps_alpha);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_tip_chamfer(&self, chamfer: [Length; 2]) -> Result<Self, GearError> {
        const NAMES: [&str; 2] = ["tip chamfer of the pinion", "tip chamfer of the wheel"];
        let mut tip_radius = self.tip_radius;
        for (gear, radius) in tip_radius.iter_mut().enumerate() {
            DomainError::non_negative(NAMES[gear], chamfer[gear])?;
            *radius = *radius - chamfer[gear];
            let (tip, base) = (*radius, self.base_radius[gear]);
            DomainError::require(
                tip / base > 1.0,
                NAMES[gear],
                chamfer[gear].si(),
                "m",
                "must leave the tip outside the base circle",
            )?;
        }
        let path = PathOfContact::new(
            self.base_radius,
            tip_radius,
            self.working_pressure_angle.si(),
            self.path.base_pitch,
            self.face_width * self.base_helix.si().tan(),
        )?;
        Ok(Self {
            tip_radius,
            tip_thickness: None,
            path,
            ..self.clone()
        })
    }

    /// Division of the sum of the profile shifts according to the tip radii of full-depth teeth.
    pub(crate) fn likely_profile_shift(&self) -> [f64; 2] {
        let addendum = |gear: usize| {
            (self.tip_radius[gear] - self.reference_radius[gear]) / self.normal_module
        };
        let difference = addendum(0) - addendum(1);
        let sum = self.profile_shift_sum;
        [0.5 * (sum + difference), 0.5 * (sum - difference)]
    }

    /// Tip alteration coefficient in normal modules, by which the tips of an external pair are shortened so that they keep the
    /// clearance of the basic rack:
    ///
    /// ```text
    /// k = (a − r₁ − r₂)/mₙ − (x₁ + x₂)                                           [Pair-5]
    /// ```
    ///
    /// Zero or negative without backlash. Source: ISO 21771:2007; drawings apply it or state tip diameters.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let input = GearPairInput {
    ///     profile_shift: Some([0.6, 0.36]),
    ///     ..GearPairInput::standard([12, 24], "3 mm".parse()?, "0 deg".parse()?, "30 mm".parse()?)
    /// };
    /// assert!((GearPair::new(&input)?.tip_alteration() + 0.1267).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tip_alteration(&self) -> f64 {
        cite!("Pair-5");
        let [r1, r2] = self.reference_radius;
        (self.centre_distance - r1 - r2) / self.normal_module - self.profile_shift_sum
    }

    /// Whether the tips of a pinion and its ring may interfere away from the line of action, because their tooth
    /// numbers differ by less than ten.
    pub fn tips_may_foul(&self) -> bool {
        let [z1, z2] = self.teeth;
        self.internal && z2.saturating_sub(z1) < MIN_RING_DIFFERENCE
    }

    /// Whether this is a spur pair: a helix without overlap is neglected.
    pub fn is_spur(&self) -> bool {
        self.path.eps_beta < MIN_OVERLAP
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
