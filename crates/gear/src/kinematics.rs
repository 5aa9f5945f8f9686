//! Curvatures and surface speeds along the path of contact.
//!
//! Source: Niemann and Winter, Maschinenelemente II.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | distance from T₁ along the line of action | m |
//! | ρ₁, ρ₂ | radii of curvature in the transverse section | m |
//! | R | relative radius in the section normal to the contact line | m |
//! | u₁, u₂ | speeds of the flanks through the contact, in the profile direction | m/s |
//! | V_s, V_e | sliding, entrainment speed | m/s |
//! | SRR | slide-to-roll ratio V_s/V_e | - |

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{AngularSpeed, Length, Speed};
use serde::Serialize;

use crate::error::GearError;
use crate::pair::GearPair;

/// Curvatures and speeds at a point of the line of action.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Kinematics {
    /// Transverse radius of curvature of flank 1, ρ₁ = s.
    pub rho1: Length,
    /// Transverse radius of curvature of flank 2, ρ₂ = T₁T₂ − s; negative for the concave flank of a ring.
    pub rho2: Length,
    /// Relative radius of curvature R, normal to the contact line.
    pub radius: Length,
    /// Speed of flank 1, u₁ = ω₁ρ₁.
    pub u1: Speed,
    /// Speed of flank 2, u₂ = ω₂ρ₂.
    pub u2: Speed,
    /// Sliding speed V_s = u₁ − u₂: negative before the pitch point.
    pub sliding: Speed,
    /// Entrainment speed V_e = (u₁ + u₂)/2.
    pub entrainment: Speed,
    /// Slide-to-roll ratio V_s/V_e.
    pub slide_to_roll: f64,
}

impl GearPair {
    /// ρ₁ = s, ρ₂ = T₁T₂ − s, R = ρ₁ρ₂/(ρ₁ + ρ₂)/cos β_b                      [Kinematics-1]
    ///
    /// u_i = ω_i ρ_i, V_s = u₁ − u₂ = (ω₁ + ω₂)(s − C), V_e = (u₁ + u₂)/2       [Kinematics-2]
    ///
    /// # Errors
    /// When s is not between T₁ and T₂, or the speed is not positive.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let motion = pair.kinematics(pair.path().c, "3000 1/min".parse()?)?;
    /// assert_eq!(motion.sliding.si(), 0.0);
    /// assert!((motion.radius.si() - 11.627e-3).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn kinematics(
        &self,
        s: Length,
        pinion_speed: AngularSpeed,
    ) -> Result<Kinematics, GearError> {
        cite!("Kinematics-1");
        cite!("Kinematics-2");
        let omega1 = DomainError::positive("pinion speed", pinion_speed)?;
        let omega2 = omega1 / self.ratio;
        let (s, t1t2) = (s.si(), self.path.t1t2.si());
        // With a ring T₂ lies behind T₁ and does not bound the line of action; a base pitch beyond E does.
        let end = if self.internal {
            (self.path.e + self.path.base_pitch).si()
        } else {
            t1t2
        };
        if !(0.0..=end).contains(&s) {
            return Err(GearError::off_path(
                Length::from_si(s),
                Length::from_si(0.0),
                Length::from_si(end),
            ));
        }
        let (rho1, rho2) = (s, t1t2 - s);
        let (u1, u2) = (omega1 * rho1, omega2 * rho2);
        // u₁ − u₂ would leave a rounding error at the pitch point instead of zero.
        let sliding = (omega1 + omega2) * (s - self.path.c.si());
        let entrainment = 0.5 * (u1 + u2);
        Ok(Kinematics {
            rho1: Length::from_si(rho1),
            rho2: Length::from_si(rho2),
            radius: Length::from_si(rho1 * rho2 / t1t2 / self.base_helix.si().cos()),
            u1: Speed::from_si(u1),
            u2: Speed::from_si(u2),
            sliding: Speed::from_si(sliding),
            entrainment: Speed::from_si(entrainment),
            slide_to_roll: sliding / entrainment,
        })
    }
}
