//! Forces between the teeth, without friction.
//!
//! Source: ISO 6336-1:2019.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | T₁ | torque at gear 1 | N m |
//! | F_bt | force along the transverse line of action | N |
//! | F_bn | force normal to the flanks | N |
//! | F_t, F_r, F_a | tangential, radial, axial part at the working pitch cylinder | N |

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Force, Torque};
use serde::Serialize;

use crate::error::{Gear, GearError};
use crate::pair::GearPair;

/// Magnitudes of the tooth forces, and the driving gear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Forces {
    /// The driving gear: gear 2 if the torque at gear 1 is negative.
    pub driver: Gear,
    /// F_bt, along the transverse line of action.
    pub transverse_base: Force,
    /// F_bn, normal to the flanks.
    pub normal_base: Force,
    /// F_t, tangential at the working pitch cylinder.
    pub tangential: Force,
    /// F_r, radial.
    pub radial: Force,
    /// F_a, axial.
    pub axial: Force,
}

impl GearPair {
    /// F_bt = |T₁|/r_b1, F_bn = F_bt/cos β_b, F_t = |T₁|/r_w1, F_r = F_t·tan α_wt,
    /// F_a = F_bt·tan β_b                                                       [Force-1]
    ///
    /// `torque` acts on gear 1; gear 2 drives if it is negative.
    ///
    /// # Errors
    /// When the torque is not finite.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let forces = pair.forces("285 N m".parse()?)?;
    /// assert!((forces.normal_base.si() - 9332.02).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn forces(&self, torque: Torque) -> Result<Forces, GearError> {
        cite!("Force-1");
        let t1 = DomainError::finite("torque", torque)?;
        let driver = if t1 < 0.0 { Gear::Wheel } else { Gear::Pinion };
        let f_bt = t1.abs() / self.base_radius[0].si();
        let f_t = t1.abs() / self.working_pitch_radius[0].si();
        let beta_b = self.base_helix.si();
        Ok(Forces {
            driver,
            transverse_base: Force::from_si(f_bt),
            normal_base: Force::from_si(f_bt / beta_b.cos()),
            tangential: Force::from_si(f_t),
            radial: Force::from_si(f_t * self.working_pressure_angle.si().tan()),
            axial: Force::from_si(f_bt * beta_b.tan()),
        })
    }
}
