//! Local specific film thickness of the micropitting rating.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ_n | radius of relative curvature in the normal plane | mm |
//! | p | local Hertz pressure, with the user's load factors | N/mm² |
//! | v_Σ | sum of the surface speeds | m/s |
//! | η, α | dynamic viscosity, pressure-viscosity coefficient at the bulk (M) and the contact (B) temperature | Pa s, m²/N |
//! | E_r | 2/Σ((1 − ν²)/E) | N/mm² |
//! | B_M | thermal contact coefficient √(λ ρ c) | N/(m s^0.5 K) |
//!
//! Source: ISO/TS 6336-22:2018 (formerly ISO/TR 15144-1), whose text was not available. h and λ as quoted by Jbily et al.
//! 2024; G_M, U and W are Dowson and Higginson's groups in these units, 1600 is their 1.6 and √π/2 the largest rise
//! under a fast semi-elliptic source plus 1.5 % (references/small_constants.py); the power of S is as quoted there.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};

use crate::error::RegimeError;

/// Factor of h (Jbily et al. 2024, eq. 10), for µm and mm.
const FILM: f64 = 1600.0;

/// The oil at one temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OilAt {
    /// Dynamic viscosity.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient.
    pub pressure_viscosity: PressureViscosity,
}

/// A contact point of the rating.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedContact {
    /// Radius of relative curvature.
    pub radius: Length,
    /// Hertz pressure.
    pub pressure: Pressure,
    /// Surface speeds of pinion and wheel.
    pub speeds: [Speed; 2],
    /// E_r, twice the reduced modulus of the contact.
    pub modulus: Pressure,
}

impl RatedContact {
    /// Film thickness.
    ///
    /// ```text
    /// h = 1600 ρ_n G_M^0.6 U^0.7 W^−0.13 S^0.22 µm,
    /// G_M = 1e6 α_M E_r,  U = η_M v_Σ/(2000 E_r ρ_n),  W = 2π p²/E_r²,  S = α_B η_B/(α_M η_M)
    /// in mm, N, m/s                                                                 [Micropitting-1]
    /// ```
    ///
    /// # Errors
    /// When a number is not positive.
    ///
    /// ```
    /// use asperity_ehl_regime::micropitting::{OilAt, RatedContact};
    /// let contact = RatedContact {
    ///     radius: "10 mm".parse()?, pressure: "1000 MPa".parse()?,
    ///     speeds: ["5 m/s".parse()?, "3 m/s".parse()?], modulus: "226.373626 GPa".parse()?,
    /// };
    /// let oil = |eta: &str, alpha: &str| -> Result<OilAt, Box<dyn std::error::Error>> {
    ///     Ok(OilAt { viscosity: eta.parse()?, pressure_viscosity: alpha.parse()? })
    /// };
    /// let film = contact.film(oil("10 mPa s", "16 1/GPa")?, oil("6 mPa s", "15 1/GPa")?)?;
    /// assert!((film.si() * 1e6 - 0.184531).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn film(&self, bulk: OilAt, contact: OilAt) -> Result<Length, RegimeError> {
        cite!("Micropitting-1");
        let rho = DomainError::positive("radius", self.radius)? * 1e3;
        let p = DomainError::positive("pressure", self.pressure)? * 1e-6;
        let e_r = DomainError::positive("modulus", self.modulus)? * 1e-6;
        let [u1, u2] = self.speeds;
        let sum = DomainError::positive("sum of the speeds", u1 + u2)?;
        let [eta_m, eta_b] = [bulk, contact].map(|oil| oil.viscosity);
        let eta_m = DomainError::positive("viscosity", eta_m)?;
        let eta_b = DomainError::positive("viscosity", eta_b)?;
        let [alpha_m, alpha_b] = [bulk, contact].map(|oil| oil.pressure_viscosity);
        let alpha_m = DomainError::positive("pressure-viscosity coefficient", alpha_m)?;
        let alpha_b = DomainError::positive("pressure-viscosity coefficient", alpha_b)?;
        let g = 1e6 * alpha_m * e_r;
        let u = eta_m * sum / (2000.0 * e_r * rho);
        let w = 2.0 * std::f64::consts::PI * (p / e_r) * (p / e_r);
        let s = alpha_b * eta_b / (alpha_m * eta_m);
        let film = FILM * rho * g.powf(0.6) * u.powf(0.7) * w.powf(-0.13) * s.powf(0.22);
        Ok(Length::from_si(film * 1e-6))
    }

    /// Flash temperature over the bulk \[K\]; `effusivity` is B_M of pinion and wheel.
    ///
    /// ```text
    /// ϑ_fl = (√π/2) 1e6 µ p |v₁ − v₂|/(B₁ √v₁ + B₂ √v₂) √(8 ρ_n p/(1000 E_r))        [Micropitting-2]
    /// ```
    ///
    /// # Errors
    /// When a number is not positive, or the friction coefficient negative.
    ///
    /// ```
    /// use asperity_ehl_regime::micropitting::RatedContact;
    /// let contact = RatedContact {
    ///     radius: "10 mm".parse()?, pressure: "1000 MPa".parse()?,
    ///     speeds: ["5 m/s".parse()?, "3 m/s".parse()?], modulus: "226.373626 GPa".parse()?,
    /// };
    /// assert!((contact.flash(0.05, [12940.0; 2])? - 32.44577).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn flash(&self, friction: f64, effusivity: [f64; 2]) -> Result<f64, RegimeError> {
        cite!("Micropitting-2");
        let rho = DomainError::positive("radius", self.radius)? * 1e3;
        let p = DomainError::positive("pressure", self.pressure)? * 1e-6;
        let e_r = DomainError::positive("modulus", self.modulus)? * 1e-6;
        let v1 = DomainError::positive("speed of the pinion", self.speeds[0])?;
        let v2 = DomainError::positive("speed of the wheel", self.speeds[1])?;
        let holds = friction.is_finite() && friction >= 0.0;
        let rule = "must be finite and not negative";
        DomainError::require(holds, "friction coefficient", friction, "-", rule)?;
        let above = "must be finite and greater than zero";
        let [b1, b2] = effusivity;
        for b in effusivity {
            let holds = b.is_finite() && b > 0.0;
            DomainError::require(
                holds,
                "thermal contact coefficient",
                b,
                "W s^0.5/(m2 K)",
                above,
            )?;
        }
        let width = (8.0 * rho * p / (1000.0 * e_r)).sqrt();
        let heat = friction * p * 1e6 * (v1 - v2).abs() / (b1 * v1.sqrt() + b2 * v2.sqrt());
        Ok(0.5 * std::f64::consts::PI.sqrt() * heat * width)
    }
}

/// Film over the mean of the flanks' Ra.
///
/// ```text
/// λ_GF = h/((Ra₁ + Ra₂)/2)                                                           [Micropitting-3]
/// ```
///
/// # Errors
/// When the film is not positive, or the flanks have no roughness.
pub fn specific_film(film: Length, ra: [Length; 2]) -> Result<f64, RegimeError> {
    cite!("Micropitting-3");
    let h = DomainError::positive("film", film)?;
    let mean =
        0.5 * (DomainError::non_negative("Ra", ra[0])? + DomainError::non_negative("Ra", ra[1])?);
    let mean = DomainError::positive("mean Ra", Length::from_si(mean))?;
    Ok(h / mean)
}
