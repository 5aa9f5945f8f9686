//! Loads of the two bearings of a shaft by statics.
//!
//! Source: Newton; balance of forces and moments of a simply supported shaft. All shafts are parallel to z.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | T₁ | torque of the shaft on gear 1, positive about +z | N m |
//! | e, t | unit vectors from the axis of gear 1 to the axis of gear 2, and 90° ahead of it about +z | - |
//! | s | 1 for external gears, −1 for a ring | - |
//! | r_w | working pitch radii, negative of a ring | m |
//! | F_t, F_r, F_a | tangential, radial and axial force, see [`Forces`](crate::forces::Forces) | N |
//! | h | 1 if the helix of gear 1 is right-handed, −1 if left-handed | - |
//! | F, ρ, z | force on the shaft, lever arm of its point of action from the axis, its place along the shaft | N, m, m |
//! | R₁, R₂ | forces of the bearings at z₁ and z₂ | N |
//!
//! Limits: the shaft is rigid, the bearings carry no moment, and one of them carries the whole axial force.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Force, Length, Torque};

use crate::error::GearError;
use crate::pair::GearPair;

/// Force on a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftForce {
    /// Place along the shaft.
    pub at: Length,
    /// Force along x, y and z \[N\].
    pub force: [f64; 3],
    /// Lever arm of the point of action from the axis along x and y \[m\].
    pub arm: [f64; 2],
}

/// Load of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingLoad {
    /// Radial load.
    pub radial: Force,
    /// Axial load.
    pub axial: Force,
}

impl GearPair {
    /// Forces of the teeth on the shafts of gear 1 and gear 2, whose centre line from gear 1 to gear 2 has the angle
    /// `direction` from x. The helix of gear 1 is right-handed unless `is_left_handed`.
    ///
    /// F₁ = −s (T₁/|T₁|) F_t t − s F_r e + h (T₁/|T₁|) F_a z,  F₂ = −F₁,  ρ₁ = s r_w1 e,  ρ₂ = −|r_w2| e  [Statics-1]
    ///
    /// # Errors
    /// When torque or angle are not finite.
    pub fn shaft_forces(
        &self,
        torque: Torque,
        at: Length,
        direction: Angle,
        is_left_handed: bool,
    ) -> Result<[ShaftForce; 2], GearError> {
        cite!("Statics-1");
        let angle = DomainError::finite("angle of the centre line", direction)?;
        let forces = self.forces(torque)?;
        let [first, second] = self.working_pitch_radius.map(|radius| radius.si());
        let side = second.signum();
        let (sin, cos) = angle.sin_cos();
        let sign = torque.si().signum();
        let hand = if is_left_handed { -sign } else { sign };
        let tangential = -side * sign * forces.tangential.si();
        let radial = -side * forces.radial.si();
        let force = [
            -tangential * sin + radial * cos,
            tangential * cos + radial * sin,
            hand * forces.axial.si(),
        ];
        let arm = |radius: f64| [radius * cos, radius * sin];
        let on_first = ShaftForce {
            at,
            force,
            arm: arm(side * first),
        };
        let on_second = ShaftForce {
            at,
            force: force.map(|part| -part),
            arm: arm(-second.abs()),
        };
        Ok([on_first, on_second])
    }
}

/// Loads of two bearings at the places `bearings` along a shaft, the first or the second of which carries the axial force:
///
/// R₁ + R₂ + Σ F = 0,  Σ (ρ + (z − z₁) z) × F + (z₂ − z₁) z × R₂ = 0 across the shaft           [Statics-2]
///
/// # Errors
/// When the bearings are at one place, or a place is not finite.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_gear::shaft_statics::{ShaftForce, bearing_loads};
/// // 900 N at a third of the span: 600 N and 300 N.
/// let force = ShaftForce { at: "30 mm".parse()?, force: [900.0, 0.0, 0.0], arm: [0.0, 0.0] };
/// let loads = bearing_loads(["10 mm".parse()?, "70 mm".parse()?], 0, &[force])?;
/// assert!((loads[0].radial.si() - 600.0).abs() < 1e-9 && (loads[1].radial.si() - 300.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bearing_loads(
    bearings: [Length; 2],
    locating: usize,
    forces: &[ShaftForce],
) -> Result<[BearingLoad; 2], GearError> {
    cite!("Statics-2");
    let [first, second] = bearings.map(|at| DomainError::finite("place of a bearing", at));
    let first = first?;
    let span = second? - first;
    let rule = "must differ between the bearings of a shaft";
    DomainError::require(span != 0.0, "place of a bearing", first, "m", rule)?;
    let mut sum = [0.0; 3];
    let mut moment = [0.0; 2];
    for ShaftForce { at, force, arm } in forces {
        let z = at.si() - first;
        moment[0] += arm[1] * force[2] - z * force[1];
        moment[1] += z * force[0] - arm[0] * force[2];
        for (sum, force) in sum.iter_mut().zip(force) {
            *sum += force;
        }
    }
    let at_second = [-moment[1] / span, moment[0] / span];
    let at_first = [-sum[0] - at_second[0], -sum[1] - at_second[1]];
    let load = |number: usize, [x, y]: [f64; 2]| BearingLoad {
        radial: Force::from_si(x.hypot(y)),
        axial: Force::from_si(if number == locating {
            sum[2].abs()
        } else {
            0.0
        }),
    };
    Ok([load(0, at_first), load(1, at_second)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::GearPairInput;

    fn pair(is_ring: bool) -> GearPair {
        let input = GearPairInput::standard(
            [24, 75],
            "2 mm".parse().unwrap(),
            "20 deg".parse().unwrap(),
            "20 mm".parse().unwrap(),
        );
        if is_ring {
            GearPair::internal(&input).unwrap()
        } else {
            GearPair::new(&input).unwrap()
        }
    }

    /// Moment of a force about the axis of its shaft [N m].
    fn about_axis(on: &ShaftForce) -> f64 {
        on.arm[0] * on.force[1] - on.arm[1] * on.force[0]
    }

    #[test]
    fn the_teeth_hold_the_torques_of_both_shafts_and_push_the_gears_apart() {
        for (is_ring, ratio) in [(false, 75.0 / 24.0), (true, -75.0 / 24.0)] {
            let pair = pair(is_ring);
            for (torque, degrees) in [(40.0, 0.0), (40.0, 137.0), (-25.0, 250.0)] {
                let direction = Angle::from_si(f64::to_radians(degrees));
                let at = Length::from_si(0.03);
                let of = |is_left| {
                    pair.shaft_forces(Torque::from_si(torque), at, direction, is_left)
                        .unwrap()
                };
                let [on_first, on_second] = of(false);
                // The torques of the shafts and of the teeth on each gear are in balance.
                assert!((about_axis(&on_first) + torque).abs() < 1e-12 * torque.abs());
                let second = torque * ratio;
                assert!((about_axis(&on_second) + second).abs() < 1e-12 * second.abs());
                // The point of action pushes the pinion towards its own axis.
                let inwards =
                    on_first.force[0] * on_first.arm[0] + on_first.force[1] * on_first.arm[1];
                assert!(inwards < 0.0);
                // A right-handed pinion that drives in the positive direction is pushed along +z.
                assert_eq!(on_first.force[2].signum(), torque.signum());
                assert_eq!(of(true)[0].force[2], -on_first.force[2]);
            }
        }
    }

    #[test]
    fn reactions_and_forces_are_in_balance_about_any_point() {
        // An overhung gear: the nearer bearing carries more than the force.
        let force = ShaftForce {
            at: Length::from_si(0.09),
            force: [0.0, 1000.0, 0.0],
            arm: [0.0, 0.0],
        };
        let bearings = [0.0, 0.06].map(Length::from_si);
        let [far, near] = bearing_loads(bearings, 0, &[force]).unwrap();
        assert!((far.radial.si() - 500.0).abs() < 1e-9 && (near.radial.si() - 1500.0).abs() < 1e-9);
        // An axial force at a radius of 20 mm tilts the shaft: 3000·0.02/0.06.
        let axial = ShaftForce {
            at: Length::from_si(0.03),
            force: [0.0, 0.0, -3000.0],
            arm: [0.02, 0.0],
        };
        let [first, second] = bearing_loads(bearings, 1, &[axial]).unwrap();
        for (load, expected) in [
            (first.radial, 1000.0),
            (second.radial, 1000.0),
            (second.axial, 3000.0),
        ] {
            assert!((load.si() - expected).abs() < 1e-9, "{load:?}");
        }
        assert_eq!(first.axial.si(), 0.0);
        assert!(bearing_loads([bearings[0]; 2], 0, &[axial]).is_err());
    }
}
