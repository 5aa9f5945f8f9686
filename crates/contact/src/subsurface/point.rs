//! Stress at one point and its equivalent stresses.

use asperity_core::quantity::Pressure;
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::ContactError;

/// Stresses in the plane at one point, tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlaneStress {
    /// σ_xx, along the surface.
    pub sigma_xx: Pressure,
    /// σ_zz, into the body.
    pub sigma_zz: Pressure,
    /// τ_xz.
    pub tau_xz: Pressure,
}

impl PlaneStress {
    /// τ₁ = √(¼·(σ_xx − σ_zz)² + τ_xz²), the largest shear stress in the plane     [Shear-1]
    ///
    /// ```
    /// use asperity_contact::subsurface::PlaneStress;
    /// let stress = PlaneStress { sigma_xx: "-3 MPa".parse()?, sigma_zz: "-9 MPa".parse()?, tau_xz: "4 MPa".parse()? };
    /// assert_eq!(stress.max_shear(), "5 MPa".parse()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn max_shear(&self) -> Pressure {
        cite!("Shear-1");
        Pressure::from_si(max_shear(self.components()))
    }

    /// σ_M = √(½·((σ_xx − σ_zz)² + (σ_zz − σ_yy)² + (σ_yy − σ_xx)²) + 3·τ_xz²)       [Mises-1]
    ///
    /// with σ_yy = ν·(σ_xx + σ_zz).
    ///
    /// # Errors
    /// When ν is outside −1 < ν ≤ 0.5.
    ///
    /// ```
    /// use asperity_contact::subsurface::PlaneStress;
    /// // Pure shear yields at τ = σ/√3.
    /// let stress = PlaneStress { sigma_xx: "0 Pa".parse()?, sigma_zz: "0 Pa".parse()?, tau_xz: "1 MPa".parse()? };
    /// assert!((stress.von_mises(0.3)?.si() - 3f64.sqrt() * 1e6).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn von_mises(&self, poisson: f64) -> Result<Pressure, ContactError> {
        cite!("Mises-1");
        let nu = check_poisson(poisson)?;
        Ok(Pressure::from_si(von_mises(self.components(), nu)))
    }

    /// σ_T = max(2·τ₁, |σ₁ − σ_yy|, |σ₂ − σ_yy|),  σ₁,₂ = ½·(σ_xx + σ_zz) ± τ₁         [Tresca-1]
    ///
    /// the largest difference of principal stresses, with σ_yy = ν·(σ_xx + σ_zz).
    ///
    /// # Errors
    /// When ν is outside −1 < ν ≤ 0.5.
    ///
    /// ```
    /// use asperity_contact::subsurface::PlaneStress;
    /// let stress = PlaneStress { sigma_xx: "0 Pa".parse()?, sigma_zz: "0 Pa".parse()?, tau_xz: "1 MPa".parse()? };
    /// assert_eq!(stress.tresca(0.3)?, "2 MPa".parse()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tresca(&self, poisson: f64) -> Result<Pressure, ContactError> {
        cite!("Tresca-1");
        let nu = check_poisson(poisson)?;
        Ok(Pressure::from_si(tresca(self.components(), nu)))
    }

    fn components(&self) -> [f64; 3] {
        [self.sigma_xx.si(), self.sigma_zz.si(), self.tau_xz.si()]
    }
}

pub(super) fn check_poisson(poisson: f64) -> Result<f64, DomainError> {
    DomainError::require(
        poisson > -1.0 && poisson <= 0.5,
        "Poisson's ratio",
        poisson,
        "-",
        "must lie above -1 and not above 0.5",
    )
}

pub(super) fn max_shear([xx, zz, xz]: [f64; 3]) -> f64 {
    (0.5 * (xx - zz)).hypot(xz)
}

pub(super) fn von_mises([xx, zz, xz]: [f64; 3], nu: f64) -> f64 {
    let yy = nu * (xx + zz);
    let differences = (xx - zz).powi(2) + (zz - yy).powi(2) + (yy - xx).powi(2);
    (0.5 * differences + 3.0 * xz * xz).sqrt()
}

pub(super) fn tresca([xx, zz, xz]: [f64; 3], nu: f64) -> f64 {
    let shear = max_shear([xx, zz, xz]);
    let off_plane = (0.5 - nu) * (xx + zz);
    (2.0 * shear).max(off_plane.abs() + shear)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equivalents_of_simple_states_are_the_textbook_ones() {
        let state = |xx: f64, zz: f64, xz: f64| PlaneStress {
            sigma_xx: Pressure::from_si(xx),
            sigma_zz: Pressure::from_si(zz),
            tau_xz: Pressure::from_si(xz),
        };
        // Hydrostatic only with ν = ½, where σ_yy equals the others: nothing yields.
        assert_eq!(state(-2.0, -2.0, 0.0).von_mises(0.5).unwrap().si(), 0.0);
        assert_eq!(state(-2.0, -2.0, 0.0).tresca(0.5).unwrap().si(), 0.0);
        // Uniaxial with ν = 0: the stress itself.
        assert!((state(-3.0, 0.0, 0.0).von_mises(0.0).unwrap().si() - 3.0).abs() < 1e-15);
        assert_eq!(state(-3.0, 0.0, 0.0).tresca(0.0).unwrap().si(), 3.0);
        // σ_yy is the extreme principal stress: 2·0.1·(−4) = ... |−4 − (−0.8)| = 3.2.
        assert!((state(-4.0, -4.0, 0.0).tresca(0.1).unwrap().si() - 3.2).abs() < 1e-15);
        assert!(state(1.0, 0.0, 0.0).von_mises(0.6).is_err());
        assert!(state(1.0, 0.0, 0.0).tresca(f64::NAN).is_err());
    }
}
