//! Centre distance and profile shifts.
//!
//! Source: ISO 21771:2007. Symbols as in [`crate::pair`].

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Length};

use crate::error::GearError;
use crate::input::GearPairInput;
use crate::involute::{inverse_involute, involute};
use crate::rack::Rack;

/// Permitted difference in normal modules between a given centre distance and the centre distance from the profile
/// shifts: the effect of rounding two coefficients to two decimals.
const CENTRE_DISTANCE_TOLERANCE: f64 = 0.01;

/// Consistent centre distance, working pressure angle and profile shifts.
#[derive(Debug, Clone)]
pub(crate) struct Centre {
    pub(crate) distance: Length,
    pub(crate) working_angle: f64,
    pub(crate) shift_sum: f64,
    pub(crate) profile_shift: Option<[f64; 2]>,
}

impl Centre {
    pub(crate) fn new(input: &GearPairInput, rack: &Rack) -> Result<Self, GearError> {
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
        if (from_distance.distance - from_shifts.distance).si().abs() > tolerance.si() {
            return Err(GearError::InconsistentCentreDistance {
                given,
                from_shifts: Length::from_si(from_shifts.distance.si().abs()),
                tolerance,
            });
        }
        Ok(Self {
            distance: from_distance.distance,
            working_angle: from_distance.working_angle,
            ..from_shifts
        })
    }

    /// inv α_wt = inv αₜ + 2 tan αₙ·(x₁ + x₂)/(z₁ + z₂),  a = (r_b1 + r_b2)/cos α_wt  [Pair-2]
    fn from_shifts(profile_shift: [f64; 2], rack: &Rack) -> Result<Self, GearError> {
        cite!("Pair-2");
        let shift_sum = profile_shift[0] + profile_shift[1];
        let working_angle = if shift_sum == 0.0 {
            rack.alpha_t
        } else {
            let reference = involute(Angle::from_si(rack.alpha_t))?;
            let working = reference + 2.0 * rack.alpha_n.tan() * shift_sum / rack.tooth_sum();
            DomainError::require(
                working > 0.0,
                "sum of the profile shifts",
                shift_sum,
                "-",
                "is so low that the base circles overlap",
            )?;
            inverse_involute(working)?.angle.si()
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
        cite!("Pair-3");
        let given = DomainError::positive("centre distance", distance)?;
        let base_radii = rack.base_radius_sum();
        if given <= base_radii.si().abs() {
            return Err(GearError::CentreDistanceTooSmall {
                given: distance,
                base_radii: Length::from_si(base_radii.si().abs()),
            });
        }
        let distance = Length::from_si(given.copysign(base_radii.si()));
        let working_angle = (base_radii / distance).acos();
        let difference =
            involute(Angle::from_si(working_angle))? - involute(Angle::from_si(rack.alpha_t))?;
        Ok(Self {
            distance,
            working_angle,
            shift_sum: difference * rack.tooth_sum() / (2.0 * rack.alpha_n.tan()),
            profile_shift: None,
        })
    }
}
