//! Coordinates of a point of a flank: roll length, radius, roll angle, arc from the base circle.
//!
//! Source: geometry of the involute (Litvin and Fuentes 2004, chapter 10).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | r_b | base radius | m |
//! | ρ | roll length, which is the radius of curvature in the transverse section | m |
//! | r | radius of the point | m |
//! | ξ | roll angle | rad |
//! | l | arc of the involute from the base circle | m |
//! | s | coordinate on the path of contact from T₁ | m |
//!
//! In mesh ρ₁ = s and ρ₂ = T₁T₂ − s: the tip of an external gear is in contact with the root of the other. For a ring
//! the absolute values apply, and both roll lengths increase with s. The transverse tangent is perpendicular to the
//! contact line on helical flanks too, so a trace in the transverse section is not stretched.

use asperity_core::quantity::{Angle, Length};
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

use crate::error::{Gear, GearError};
use crate::pair::GearPair;

/// A point of a flank, given by one of its coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum FlankPoint {
    /// Coordinate s on the path of contact, from T₁.
    Position(Length),
    /// Roll length ρ.
    RollLength(Length),
    /// Radius r.
    Radius(Length),
    /// Roll angle ξ.
    RollAngle(Angle),
}

impl GearPair {
    /// Arc from the base circle to a point of the flank of `gear`.
    ///
    /// ```text
    /// ρ = √(r² − r_b²) = r_b ξ,  l = ρ²/(2 r_b)                                  [Flank-arc]
    /// ```
    ///
    /// # Errors
    /// When the point is not on an involute: below the base circle, or behind T₂.
    ///
    /// ```
    /// use asperity_gear::flank_coordinate::FlankPoint;
    /// use asperity_gear::{GearPair, GearPairInput, error::Gear};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [23, 68], "1.8 mm".parse()?, "23.4 deg".parse()?, "32 mm".parse()?,
    /// ))?;
    /// let tip = pair.arc_of(Gear::Pinion, FlankPoint::Radius(pair.tip_radius[0]))?;
    /// let end = pair.arc_of(Gear::Pinion, FlankPoint::Position(pair.path().e))?;
    /// assert!((tip.si() / end.si() - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn arc_of(&self, gear: Gear, point: FlankPoint) -> Result<Length, GearError> {
        cite!("Flank-arc");
        let base = self.base_radius[gear as usize].si().abs();
        let roll = match point {
            FlankPoint::Position(s) => match gear {
                Gear::Pinion => s.si(),
                Gear::Wheel => {
                    let roll = self.path().t1t2.si() - s.si();
                    if self.internal { -roll } else { roll }
                }
            },
            FlankPoint::RollLength(roll) => roll.si(),
            FlankPoint::Radius(radius) => {
                let (r, rule) = (radius.si().abs(), "must not be below the base radius");
                DomainError::require(r >= base, "radius of a flank point", r, "m", rule)?;
                ((r - base) * (r + base)).sqrt()
            }
            FlankPoint::RollAngle(angle) => base * angle.si(),
        };
        let rule = "must not be negative";
        DomainError::require(roll >= 0.0, "roll length of a flank point", roll, "m", rule)?;
        Ok(Length::from_si(roll * roll / (2.0 * base)))
    }

    /// Sign of the change of the arc of `gear` as the contact moves along x, the common tangent towards the pinion's
    /// tip: 1, or −1 on the wheel of an external pair, whose root is in contact with the pinion's tip.
    ///
    /// ```text
    /// l₁(s) + x is in contact with l₂(s) − x; l₂(s) + x on a ring                          [Flank-meeting]
    /// ```
    #[must_use]
    pub fn arc_direction(&self, gear: Gear) -> f64 {
        cite!("Flank-meeting");
        match gear {
            Gear::Wheel if !self.internal => -1.0,
            _ => 1.0,
        }
    }

    /// Sign of the change of the arc of `gear` from its root to its tip: 1, or −1 on a ring, whose tip is inside.
    #[must_use]
    pub fn arc_towards_tip(&self, gear: Gear) -> f64 {
        match gear {
            Gear::Wheel if self.internal => -1.0,
            _ => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::GearPairInput;

    /// Teeth, module, helix, profile shifts; arcs of both gears at A, C, E.
    type Known = (
        [u32; 2],
        &'static str,
        &'static str,
        [f64; 2],
        [[f64; 3]; 2],
    );

    /// fzg-c and e-drive, with the arcs of an independent computation.
    const REFERENCE: [Known; 2] = [
        (
            [16, 24],
            "4.5 mm",
            "0 deg",
            [0.182, 0.172],
            [
                [0.000273119101, 0.00288599018, 0.00831925351],
                [0.00924764846, 0.00432898527, 0.00123803832],
            ],
        ),
        (
            [23, 68],
            "1.8 mm",
            "23.4 deg",
            [0.0, 0.0],
            [
                [0.00034147661, 0.0016488182, 0.00366247124],
                [0.00683728769, 0.00487476684, 0.00339174564],
            ],
        ),
    ];

    fn pair(teeth: [u32; 2], module: &str, helix: &str, shift: [f64; 2]) -> GearPair {
        let input = GearPairInput {
            profile_shift: Some(shift),
            ..GearPairInput::standard(
                teeth,
                module.parse().unwrap(),
                helix.parse().unwrap(),
                "14 mm".parse().unwrap(),
            )
        };
        GearPair::new(&input).unwrap()
    }

    #[test]
    fn arcs_at_the_ends_and_the_pitch_point_are_those_of_the_reference() {
        for (teeth, module, helix, shift, arcs) in REFERENCE {
            let pair = pair(teeth, module, helix, shift);
            let path = pair.path();
            for (gear, arcs) in [Gear::Pinion, Gear::Wheel].into_iter().zip(arcs) {
                for (s, expected) in [path.a, path.c, path.e].into_iter().zip(arcs) {
                    let found = pair.arc_of(gear, FlankPoint::Position(s)).unwrap();
                    // The reference is printed to nine digits.
                    assert!(
                        (found.si() / expected - 1.0).abs() < 1e-8,
                        "{teeth:?} {found}"
                    );
                }
            }
        }
    }

    #[test]
    fn every_coordinate_of_a_point_gives_one_arc() {
        let pair = pair([16, 24], "4.5 mm", "0 deg", [0.182, 0.172]);
        let base = pair.base_radius[1].si();
        let roll: f64 = 0.02;
        let points = [
            FlankPoint::RollLength(Length::from_si(roll)),
            FlankPoint::Radius(Length::from_si(base.hypot(roll))),
            FlankPoint::RollAngle(Angle::from_si(roll / base)),
            FlankPoint::Position(Length::from_si(pair.path().t1t2.si() - roll)),
        ];
        for point in points {
            let arc = pair.arc_of(Gear::Wheel, point).unwrap();
            assert!(
                (arc.si() - roll * roll / (2.0 * base)).abs() < 1e-15,
                "{point:?}"
            );
        }
        let below = FlankPoint::Radius(Length::from_si(0.99 * base));
        assert!(pair.arc_of(Gear::Wheel, below).is_err());
    }

    #[test]
    fn the_tip_of_one_gear_meets_the_root_of_the_other() {
        let pair = pair([23, 68], "1.8 mm", "23.4 deg", [0.0, 0.0]);
        let step = Length::from_si(1e-6);
        let at = |gear, s: Length| pair.arc_of(gear, FlankPoint::Position(s)).unwrap().si();
        for gear in [Gear::Pinion, Gear::Wheel] {
            let c = pair.path().c;
            let grows = at(gear, c + step) - at(gear, c);
            assert_eq!(grows.signum(), pair.arc_direction(gear));
        }
    }
}
