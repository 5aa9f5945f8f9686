//! Centre distance and profile shifts.
//!
//! Source: ISO 21771:2007. Symbols as in [`crate::pair`].

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::numerics::find_root;
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
            return Err(GearError::inconsistent_centre_distance(
                given,
                Length::from_si(from_shifts.distance.si().abs()),
                tolerance,
            ));
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
            return Err(GearError::centre_distance_too_small(
                distance,
                Length::from_si(base_radii.si().abs()),
            ));
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

    /// Divides the sum of the profile shifts of an external pair for equal specific sliding at A and E.
    ///
    /// ```text
    /// ρ₂(A)·ρ₂(E) = u²·ρ₁(A)·ρ₁(E)                                             [Shift-division]
    /// ```
    ///
    /// ρ₁, ρ₂: distances from T₁ and T₂ \[m\] for the tip radii r + mₙ·(hₐ* + x); u = z₂/z₁. The specific sliding
    /// 1 − ρ₂/(u ρ₁) of the pinion's root at A then equals 1 − u ρ₁/ρ₂ of the wheel's root at E. `None` if every
    /// division lets a tip interfere, and for a ring.
    pub(crate) fn divided(&self, rack: &Rack, addendum: f64) -> Option<[f64; 2]> {
        let [base_1, base_2] = rack.base_radius.map(Length::si);
        let [reference_1, reference_2] = rack.reference_radius.map(Length::si);
        let t1t2 = self.distance.si() * self.working_angle.sin();
        if rack.internal || !(addendum.is_finite() && addendum > 0.0) {
            return None;
        }
        cite!("Shift-division");
        // Shift at which the tip of a gear reaches the foot of the mating gear's perpendicular.
        let limit = |base: f64, reference: f64| {
            (t1t2.hypot(base) - reference) / rack.normal_module.si() - addendum
        };
        // Distance of a tip circle's end of contact from the gear's own foot.
        let reach = |base: f64, reference: f64, shift: f64| {
            let tip = reference + rack.normal_module.si() * (addendum + shift);
            (tip * tip - base * base).max(0.0).sqrt()
        };
        let squared_ratio = (rack.teeth[1] / rack.teeth[0]).powi(2);
        let excess = |shift: f64| {
            let at_e = reach(base_1, reference_1, shift);
            let at_a = reach(base_2, reference_2, self.shift_sum - shift);
            at_a * (t1t2 - at_e) - squared_ratio * at_e * (t1t2 - at_a)
        };
        let low = self.shift_sum - limit(base_2, reference_2);
        let high = limit(base_1, reference_1);
        if low >= high {
            return None;
        }
        let root = find_root(excess, low, high, 1e-12).ok()?.value;
        Some([root, self.shift_sum - root])
    }
}
