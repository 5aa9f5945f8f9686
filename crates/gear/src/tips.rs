//! Tip radii, and whether the teeth still have a land there.
//!
//! Source: ISO 21771:2007. Symbols as in [`crate::pair`].

use asperity_core::DomainError;
use asperity_core::quantity::Length;

use crate::centre_distance::Centre;
use crate::error::{Gear, GearError};
use crate::input::GearPairInput;
use crate::involute::half_angle;
use crate::rack::Rack;

/// r_a = r + mₙ·(hₐ* + x)                                                    [Pair-4]
pub(crate) fn tip_radii(
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
pub(crate) fn tip_thickness(
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
