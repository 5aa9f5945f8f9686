//! Line contact and the scales that make it dimensionless.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | a, p₀ | half width and largest pressure of the Hertz contact | m, Pa |
//! | u_m, S | mean speed (u₁ + u₂)/2, slide-to-roll ratio (u₁ − u₂)/u_m | m/s, - |
//! | X, P, H, T | x/a, p/p₀, h·R/a², t·u_m/a | - |
//! | λ | 12·u_m·η₀·R²/(a³·p₀) | - |
//! | M, L | Moes' load and lubricant parameters, with E′ = 2·E* and u₁ + u₂ | - |

use std::f64::consts::PI;

use asperity_contact::hertz_line::HertzLine;
use asperity_core::quantity::{Length, LineLoad, Pressure, Speed};
use asperity_core::{DomainError, cite};
use asperity_oil::PressureViscosityLaw;
use serde::{Deserialize, Serialize};

use crate::error::EhlError;
use crate::oil::Oil;

/// Two cylinders in lubricated line contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LineContact {
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Reduced modulus E*, 1/E* = Σ (1 − ν²)/E.
    pub modulus: Pressure,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Speed u₁ of the first surface relative to the contact, along x.
    pub speed_1: Speed,
    /// Speed u₂ of the second surface relative to the contact, along x.
    pub speed_2: Speed,
}

/// Scales and numbers of a lubricated line contact.
///
/// λ = 12·u_m·η₀·R²/(a³·p₀) = 3π²/(8·M²)                                    `[EHL-scales]`
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scales {
    /// Half width a of the Hertz contact.
    pub half_width: Length,
    /// Largest Hertz pressure p₀.
    pub max_pressure: Pressure,
    /// Film scale a²/R \[m\].
    #[serde(skip)]
    pub(crate) film: f64,
    /// Mean speed u_m \[m/s\].
    #[serde(skip)]
    pub(crate) entrainment: f64,
    /// Sliding speed u₁ − u₂ \[m/s\].
    #[serde(skip)]
    pub(crate) sliding: f64,
    /// λ of the Reynolds equation.
    pub speed: f64,
    /// Slide-to-roll ratio (u₁ − u₂)/u_m.
    pub slide_to_roll: f64,
    /// Moes' load parameter M.
    pub moes_load: f64,
    /// Moes' lubricant parameter L; zero for an isoviscous oil.
    pub moes_lubricant: f64,
}

impl LineContact {
    /// Contact with the largest Hertz pressure, mean speed and slide-to-roll ratio given.
    ///
    /// # Errors
    /// When radius, modulus or pressure is not positive.
    ///
    /// ```
    /// use asperity_ehl::LineContact;
    /// let contact = LineContact::at_pressure(
    ///     "10 mm".parse()?, "115.4 GPa".parse()?, "1.2 GPa".parse()?, "5 m/s".parse()?, 0.2,
    /// )?;
    /// assert!((contact.load.si() / 392_021.0 - 1.0).abs() < 1e-4);
    /// assert_eq!(contact.speed_1, "5.5 m/s".parse()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at_pressure(
        radius: Length,
        modulus: Pressure,
        max_pressure: Pressure,
        mean_speed: Speed,
        slide_to_roll: f64,
    ) -> Result<Self, EhlError> {
        let r = DomainError::positive("radius", radius)?;
        let e = DomainError::positive("modulus", modulus)?;
        let p_0 = DomainError::positive("largest Hertz pressure", max_pressure)?;
        Ok(Self {
            radius,
            modulus,
            load: LineLoad::from_si(PI * r * p_0 * p_0 / e),
            speed_1: mean_speed * (1.0 + 0.5 * slide_to_roll),
            speed_2: mean_speed * (1.0 - 0.5 * slide_to_roll),
        })
    }

    /// Scales of this contact with `oil`.
    ///
    /// # Errors
    /// When an input is outside its domain or the mean speed is not positive.
    pub fn scales(&self, oil: &Oil) -> Result<Scales, EhlError> {
        cite!("EHL-scales");
        oil.validate()?;
        let r = DomainError::positive("radius", self.radius)?;
        let modulus = DomainError::positive("modulus", self.modulus)?;
        let w = DomainError::positive("load", self.load)?;
        let u_1 = DomainError::finite("speed of surface 1", self.speed_1)?;
        let u_2 = DomainError::finite("speed of surface 2", self.speed_2)?;
        let u_m = DomainError::positive(
            "mean speed of the surfaces",
            Speed::from_si(0.5 * (u_1 + u_2)),
        )?;
        let hertz = HertzLine::new(self.load, self.radius, self.modulus)?;
        let (a, p_0) = (hertz.half_width.si(), hertz.max_pressure.si());
        let (eta, e_prime) = (oil.viscosity.si(), 2.0 * modulus);
        let speed_group = eta * 2.0 * u_m / (e_prime * r);
        let alpha = match oil.viscosity_law {
            PressureViscosityLaw::Isoviscous => 0.0,
            _ => oil.pressure_viscosity.si(),
        };
        Ok(Scales {
            half_width: hertz.half_width,
            max_pressure: hertz.max_pressure,
            film: a * a / r,
            entrainment: u_m,
            sliding: u_1 - u_2,
            speed: 12.0 * u_m * eta * r * r / (a.powi(3) * p_0),
            slide_to_roll: (u_1 - u_2) / u_m,
            moes_load: w / (e_prime * r) / speed_group.sqrt(),
            moes_lubricant: alpha * e_prime * speed_group.powf(0.25),
        })
    }
}

impl Scales {
    /// Length of a dimensionless film H.
    pub fn film_length(&self, film: f64) -> Length {
        Length::from_si(film * self.film)
    }

    /// Dimensionless film of a length.
    pub(crate) fn film_of(&self, film: Length) -> f64 {
        film.si() / self.film
    }

    /// h/R·(η₀(u₁ + u₂)/(E′R))^(−1/2) of a dimensionless film: the unit of Moes' diagram.
    pub fn moes_film(&self, film: f64) -> f64 {
        8.0 * self.moes_load / PI * film
    }

    /// Dimensionless central film of Moes' formula: a start value (the published law with its sources
    /// is in `asperity-ehl-regime`).
    pub(crate) fn film_guess(&self) -> f64 {
        let (m, l) = (self.moes_load, self.moes_lubricant.max(1e-6));
        let rigid_isoviscous = 3.0 / m;
        let elastic_isoviscous = 2.621 * m.powf(-0.2);
        let rigid_piezoviscous = 1.287 * l.powf(2.0 / 3.0);
        let elastic_piezoviscous = 1.311 * m.powf(-0.125) * l.powf(0.75);
        let s = 0.2 * (7.0 + 8.0 * (-2.0 * elastic_isoviscous / rigid_isoviscous).exp());
        let isoviscous = rigid_isoviscous.powf(7.0 / 3.0) + elastic_isoviscous.powf(7.0 / 3.0);
        let piezoviscous = rigid_piezoviscous.powf(-3.5) + elastic_piezoviscous.powf(-3.5);
        let film =
            (isoviscous.powf(3.0 * s / 7.0) + piezoviscous.powf(-2.0 * s / 7.0)).powf(1.0 / s);
        film * PI / (8.0 * m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::quantity::{DynamicViscosity, PressureViscosity};
    use asperity_oil::{DensityLaw, ShearLaw};

    #[test]
    fn the_gear_case_has_its_dimensionless_numbers() {
        let oil = Oil {
            viscosity: DynamicViscosity::from_si(0.01),
            pressure_viscosity: PressureViscosity::from_si(1.8e-8),
            viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
            density_law: DensityLaw::DowsonHigginson,
            shear_law: ShearLaw::Newtonian,
        };
        let contact = LineContact::at_pressure(
            Length::from_si(10e-3),
            Pressure::from_si(115.4e9),
            Pressure::from_si(1.2e9),
            Speed::from_si(5.0),
            0.2,
        )
        .unwrap();
        let scales = contact.scales(&oil).unwrap();
        assert!((scales.half_width.si() / 207.972e-6 - 1.0).abs() < 1e-5);
        assert!((scales.moes_load / 25.8041 - 1.0).abs() < 1e-5);
        assert!((scales.moes_lubricant / 10.6586 - 1.0).abs() < 1e-5);
        let m = scales.moes_load;
        assert!((scales.speed / (3.0 * PI * PI / (8.0 * m * m)) - 1.0).abs() < 1e-13);
        let alpha_p = 1.8e-8 * scales.max_pressure.si();
        assert!((scales.moes_lubricant * (m / (2.0 * PI)).sqrt() / alpha_p - 1.0).abs() < 1e-13);
        let standing = LineContact {
            speed_2: -contact.speed_1,
            ..contact
        };
        assert!(standing.scales(&oil).is_err());
    }
}
