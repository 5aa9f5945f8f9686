//! The consistent film: Reynolds' equation along the film, second-order pressure difference across it.
//!
//! A parabolic velocity that conserves the flow satisfies Reynolds' equation. To second order in the
//! slope of the film, the pressure difference between the walls consists of the shear stress on the
//! inclined wall 1 and the centrifugal force of the curved flow. Valid for thin films, h ≪ r₂ and
//! |h'| ≪ 1, with the viscosity and density of the section.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h, h' | thickness of the film and its slope along x | m, - |
//! | q | flow per unit width | m²/s |
//! | u₁, u₂ | speeds of the walls | m/s |
//! | η, ρ | viscosity and density | Pa s, kg/m³ |
//! | r₂ | radius of the path of the flow, equal to the radius of wall 2 | m |
//! | τ_w1, τ_w2 | shear stress η·du/dy at the walls | Pa |
//! | p₁, p₂ | pressure at the walls | Pa |

use std::num::NonZeroUsize;

use asperity_core::DomainError;
use asperity_core::numerics::gauss_legendre;
use asperity_core::quantity::{Density, DynamicViscosity, Length, Pressure, Speed};
use serde::Serialize;

use crate::FilmError;
use crate::velocity_profile::VelocityProfile;

/// Section of the film: its flow, fluid and walls.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmSection {
    /// Speed u₁ of wall 1.
    pub wall_1: Speed,
    /// Speed u₂ of wall 2.
    pub wall_2: Speed,
    /// Thickness h.
    pub thickness: Length,
    /// Slope h' = dh/dx of the thickness.
    pub slope: f64,
    /// Flow q per unit width \[m²/s\].
    pub flow: f64,
    /// Viscosity η.
    pub viscosity: DynamicViscosity,
    /// Density ρ.
    pub density: Density,
    /// Radius r₂ of wall 2.
    pub radius: Length,
}

/// Flow in a section of the film.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CrossFilm {
    /// Velocity through the film.
    pub profile: VelocityProfile,
    /// Pressure gradient along the film, dp/dx \[Pa/m\].
    pub pressure_gradient: f64,
    /// Shear stress τ_w1 at wall 1.
    pub wall_shear_1: Pressure,
    /// Shear stress τ_w2 at wall 2.
    pub wall_shear_2: Pressure,
    /// Pressure difference across the film, p₁ − p₂.
    pub difference: Pressure,
}

impl FilmSection {
    /// p₁ − p₂ = h'·τ_w1 + ρ·(u₁² + u₁·u₂ + u₂²)·h/(3·r₂)                            [Cross-1]
    ///
    /// with velocity, pressure gradient and wall shear.
    ///
    /// # Errors
    /// When a number is not finite, or the thickness, the viscosity, the density or the radius is
    /// not positive.
    ///
    /// ```
    /// use asperity_ns_film::reynolds_cross::FilmSection;
    /// let section = FilmSection {
    ///     wall_1: "4.5679 m/s".parse()?, wall_2: "4.5679 m/s".parse()?, thickness: "100 nm".parse()?, slope: 0.0,
    ///     flow: 4.5679e-7, viscosity: "97.5 mPa s".parse()?, density: "998 kg/m3".parse()?, radius: "34.896 mm".parse()?,
    /// };
    /// assert!((section.cross_film()?.difference.si() - 0.0597).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cross_film(&self) -> Result<CrossFilm, FilmError> {
        asperity_core::cite!("Cross-1");
        let profile =
            VelocityProfile::carrying(self.flow, self.wall_1, self.wall_2, self.thickness)?;
        let slope = DomainError::require(
            self.slope.is_finite(),
            "slope of the film",
            self.slope,
            "-",
            "must be finite",
        )?;
        let gradient = self.pressure_gradient()?;
        let [shear_1, shear_2] = self.wall_shear()?;
        let difference = slope * shear_1 + self.centrifugal_difference()?.si();
        Ok(CrossFilm {
            profile,
            pressure_gradient: gradient,
            wall_shear_1: Pressure::from_si(shear_1),
            wall_shear_2: Pressure::from_si(shear_2),
            difference: Pressure::from_si(difference),
        })
    }

    /// dp/dx = 6·η·((u₁ + u₂)·h − 2·q)/h³ \[Pa/m\]                                [Reynolds-1]
    ///
    /// # Errors
    /// As for [`cross_film`](Self::cross_film).
    ///
    /// ```
    /// # use asperity_ns_film::reynolds_cross::FilmSection;
    /// let section = FilmSection {
    ///     wall_1: "2 m/s".parse()?, wall_2: "2 m/s".parse()?, thickness: "1 um".parse()?, slope: 0.0,
    ///     flow: 0.0, viscosity: "10 mPa s".parse()?, density: "998 kg/m3".parse()?, radius: "1 mm".parse()?,
    /// };
    /// assert!((section.pressure_gradient()? / 2.4e11 - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure_gradient(&self) -> Result<f64, FilmError> {
        asperity_core::cite!("Reynolds-1");
        let (h, u1, u2) = self.walls()?;
        let eta = DomainError::positive("viscosity", self.viscosity)?;
        let q = DomainError::require(
            self.flow.is_finite(),
            "flow",
            self.flow,
            "m2/s",
            "must be finite",
        )?;
        Ok(6.0 * eta * ((u1 + u2) * h - 2.0 * q) / (h * h * h))
    }

    /// τ_w1, τ_w2 = η·(u₁ − u₂)/h ± (h/2)·dp/dx \[Pa\]                              [Cross-2]
    ///
    /// # Errors
    /// As for [`cross_film`](Self::cross_film).
    ///
    /// ```
    /// # use asperity_ns_film::reynolds_cross::FilmSection;
    /// let section = FilmSection {
    ///     wall_1: "3 m/s".parse()?, wall_2: "1 m/s".parse()?, thickness: "1 um".parse()?, slope: 0.0,
    ///     flow: 2e-6, viscosity: "10 mPa s".parse()?, density: "998 kg/m3".parse()?, radius: "1 mm".parse()?,
    /// };
    /// // No pressure gradient: pure shear, 10 mPa s · 2 m/s / 1 um.
    /// assert!(section.wall_shear()?.iter().all(|tau| (tau / 2e4 - 1.0).abs() < 1e-12));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn wall_shear(&self) -> Result<[f64; 2], FilmError> {
        asperity_core::cite!("Cross-2");
        let (h, u1, u2) = self.walls()?;
        let couette = self.viscosity.si() * (u1 - u2) / h;
        let poiseuille = 0.5 * h * self.pressure_gradient()?;
        Ok([couette + poiseuille, couette - poiseuille])
    }

    /// ρ·(u₁² + u₁·u₂ + u₂²)·h/(3·r₂), the centrifugal part of the difference       [Cross-3]
    ///
    /// # Errors
    /// As for [`cross_film`](Self::cross_film).
    ///
    /// ```
    /// # use asperity_ns_film::reynolds_cross::FilmSection;
    /// let section = FilmSection {
    ///     wall_1: "2 m/s".parse()?, wall_2: "2 m/s".parse()?, thickness: "1 um".parse()?, slope: 0.0,
    ///     flow: 0.0, viscosity: "10 mPa s".parse()?, density: "1000 kg/m3".parse()?, radius: "1 mm".parse()?,
    /// };
    /// assert!((section.centrifugal_difference()?.si() - 4.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn centrifugal_difference(&self) -> Result<Pressure, FilmError> {
        asperity_core::cite!("Cross-3");
        let (h, u1, u2) = self.walls()?;
        let rho = DomainError::positive("density", self.density)?;
        let r2 = DomainError::positive("radius of wall 2", self.radius)?;
        Ok(Pressure::from_si(
            rho * (u1 * u1 + u1 * u2 + u2 * u2) * h / (3.0 * r2),
        ))
    }

    /// ρ·∫₀ʰ u(y)²/(r₂ + y) dy, the centrifugal difference of a film of any thickness    [Cross-4]
    ///
    /// with the parabola of the section. Equals ρ·u²·ln(1 + h/r₂) for uniform velocity, and
    /// [`centrifugal_difference`](Self::centrifugal_difference) for a thin film without pressure gradient.
    ///
    /// # Errors
    /// As for [`cross_film`](Self::cross_film).
    ///
    /// ```
    /// # use asperity_ns_film::reynolds_cross::FilmSection;
    /// let section = FilmSection {
    ///     wall_1: "2 m/s".parse()?, wall_2: "2 m/s".parse()?, thickness: "1 mm".parse()?, slope: 0.0,
    ///     flow: 2e-3, viscosity: "10 mPa s".parse()?, density: "1000 kg/m3".parse()?, radius: "1 mm".parse()?,
    /// };
    /// assert!((section.centrifugal_difference_thick()?.si() - 4000.0 * 2f64.ln()).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn centrifugal_difference_thick(&self) -> Result<Pressure, FilmError> {
        asperity_core::cite!("Cross-4");
        let profile =
            VelocityProfile::carrying(self.flow, self.wall_1, self.wall_2, self.thickness)?;
        let [a, b, c] = profile.coefficients()?;
        let h = self.thickness.si();
        let rho = DomainError::positive("density", self.density)?;
        let r2 = DomainError::positive("radius of wall 2", self.radius)?;
        let integrand = |y: f64| {
            let u = (a * y + b) * y + c;
            u * u / (r2 + y)
        };
        // Sixteen points: round-off for films up to as thick as the radius.
        let rule = gauss_legendre(NonZeroUsize::MIN.saturating_add(15));
        let terms = rule
            .iter()
            .map(|(node, weight)| weight * integrand(0.5 * h * (1.0 + node)));
        Ok(Pressure::from_si(rho * 0.5 * h * terms.sum::<f64>()))
    }

    fn walls(&self) -> Result<(f64, f64, f64), DomainError> {
        Ok((
            DomainError::positive("film thickness", self.thickness)?,
            DomainError::finite("speed of wall 1", self.wall_1)?,
            DomainError::finite("speed of wall 2", self.wall_2)?,
        ))
    }
}
