//! Tip radii and tip thickness.
//!
//! Source: ISO 21771:2007. Symbols as in [`crate::pair`].

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Length};

use crate::centre_distance::Centre;
use crate::error::{Gear, GearError};
use crate::input::GearPairInput;
use crate::involute::{half_angle, involute};
use crate::rack::Rack;

/// r_a = r + mₙ·(hₐ* + x)                                                    [Pair-4]
pub(crate) fn tip_radii(
    input: &GearPairInput,
    rack: &Rack,
    centre: &Centre,
) -> Result<[Length; 2], GearError> {
    cite!("Pair-4");
    let radii = match (input.tip_radius, centre.profile_shift) {
        (Some(radii), _) => signed(radii, rack),
        (None, None) => {
            return Err(GearError::tip_radius_unknown(centre.shift_sum));
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
        let same_side = radius.si() * base.si() > 0.0;
        DomainError::require(
            radius.si().is_finite() && same_side && radius.si().abs() > base.si().abs(),
            "tip radius",
            radius.si(),
            "m",
            "must be finite and larger than the base radius; are pinion and wheel exchanged, or radii stated as diameters?",
        )?;
    }
    Ok(radii)
}

/// Tip thickness of both gears, or an error if a tooth is pointed.
pub(crate) fn tip_thickness(
    rack: &Rack,
    centre: &Centre,
    tip_radius: [Length; 2],
) -> Result<Option<[Length; 2]>, GearError> {
    let half_angles = |x: [f64; 2]| -> Result<[f64; 2], DomainError> {
        let angle = |gear: usize| half_angle(&rack.tooth(gear, x[gear]), tip_radius[gear]);
        let second = if rack.internal {
            ring_half_angle(rack, x[1], tip_radius[1])?
        } else {
            angle(1)?
        };
        Ok([angle(0)?, second])
    };
    let Some(shifts) = centre.profile_shift else {
        // z·(half-angle) is linear in x, so its sum over both gears does not depend on the division of the shifts.
        let angles = half_angles([centre.shift_sum, 0.0])?;
        let [z1, z2] = rack.teeth.map(f64::abs);
        let sum = z1 * angles[0] + z2 * angles[1];
        return if sum > 0.0 {
            Ok(None)
        } else {
            Err(GearError::pointed_tips(sum))
        };
    };
    let angles = half_angles(shifts)?;
    let thickness =
        [0, 1].map(|gear| Length::from_si(2.0 * tip_radius[gear].si().abs() * angles[gear]));
    for (gear, thickness) in [Gear::Pinion, Gear::Wheel].into_iter().zip(thickness) {
        if thickness.si() <= 0.0 {
            return Err(GearError::pointed_tip(gear, thickness));
        }
    }
    Ok(Some(thickness))
}

fn signed(radii: [Length; 2], rack: &Rack) -> [Length; 2] {
    if rack.internal {
        [radii[0], -radii[1]]
    } else {
        radii
    }
}

/// Half the angular thickness of a ring tooth at a radius: π/(2|z|) + 2 x tan αₙ/|z| − inv αₜ + inv α_r.
fn ring_half_angle(rack: &Rack, shift: f64, radius: Length) -> Result<f64, DomainError> {
    let z = rack.teeth[1].abs();
    let cosine = rack.base_radius[1] / radius;
    let here = involute(Angle::from_si(cosine.min(1.0).acos()))?;
    let reference = involute(Angle::from_si(rack.alpha_t))?;
    Ok((std::f64::consts::FRAC_PI_2 + 2.0 * shift * rack.alpha_n.tan()) / z - reference + here)
}
