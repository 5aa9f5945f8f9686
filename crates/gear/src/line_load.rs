//! Load per length of contact line along the path of contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f | load per length of contact line, normal to the flank | N/m |
//! | F_bn | force normal to the flanks | N |
//! | R(ξ), v(ξ) | share and weight of the load sharing law | - |
//! | b | width over which the faces overlap | m |
//!
//! Limits: on a helical pair f is the load at the mean length of the contact lines. Their length varies during a mesh
//! cycle by less than 1/(ε_α ε_β) of its mean, and is constant if ε_α or ε_β is a whole number.

use asperity_core::cite;
use asperity_core::quantity::{Length, LineLoad, Torque};

use crate::error::GearError;
use crate::load_sharing::{LoadSharing, Weights};
use crate::pair::GearPair;

impl GearPair {
    /// spur: f = F_bn·R(ξ)/b                                                    [Load-1]
    ///
    /// helical: f = F_bn·cos β_b·v(ξ)/(b·∫₀^ε_α v dξ); with v = 1 this is
    /// F_bn/(b ε_α/cos β_b)                                                     [Load-2]
    ///
    /// `torque` acts on gear 1 and may have either sign.
    ///
    /// # Errors
    /// When s is not on the path A to E, the torque is not finite, or the law does not hold for
    /// this pair.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput, LoadSharing};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let f = pair.line_load(pair.path().c, "285 N m".parse()?, &LoadSharing::Uniform)?;
    /// assert!((f.si() - 113.409e3).abs() < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn line_load(
        &self,
        s: Length,
        torque: Torque,
        sharing: &LoadSharing,
    ) -> Result<LineLoad, GearError> {
        let xi = self.path.coordinate_on_path(s)?;
        let weights = self.weights(sharing)?;
        let force = self.forces(torque)?.normal_base.si();
        Ok(LineLoad::from_si(force * self.unit_line_load(&weights, xi)))
    }

    /// The weights of a law, which must hold for this pair.
    pub(crate) fn weights<'a>(&self, sharing: &'a LoadSharing) -> Result<Weights<'a>, GearError> {
        if matches!(sharing, LoadSharing::Trapezoid) && !self.is_spur() {
            return Err(GearError::SpurLawOnHelical {
                law: sharing.name(),
            });
        }
        Weights::new(sharing, self.path.eps_alpha)
    }

    /// f/F_bn \[1/m\] at a coordinate on the path.
    pub(crate) fn unit_line_load(&self, weights: &Weights<'_>, xi: f64) -> f64 {
        let b = self.face_width.si();
        if self.is_spur() {
            cite!("Load-1");
            weights.share(xi) / b
        } else {
            cite!("Load-2");
            self.base_helix.si().cos() * weights.at(xi) / (b * weights.integral())
        }
    }
}
