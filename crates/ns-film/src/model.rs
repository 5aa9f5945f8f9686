//! Pressure difference across the film by either of two film models.

use asperity_core::DomainError;
use asperity_core::quantity::{
    Angle, AngularSpeed, Density, DynamicViscosity, Length, Pressure, Speed,
};
use serde::{Deserialize, Serialize};

use crate::FilmError;
use crate::gap::GapShape;
use crate::paper::PaperFilm;
use crate::reynolds_cross::{CrossFilm, FilmSection};
use crate::velocity_profile::VelocityProfile;

/// Model of the pressure in the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum FluidModel {
    /// Reynolds' equation along the film and a second-order balance across it: consistent.
    #[default]
    ReynoldsCross,
    /// The paper's radial momentum equation with its misprints corrected.
    Paper,
}

/// Film between two cylinders at one angle from the line of centres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmConditions {
    /// Speed u₁ of wall 1; see [`wall_speed`].
    pub wall_1: Speed,
    /// Speed u₂ of wall 2.
    pub wall_2: Speed,
    /// Radius r₁ of cylinder 1.
    pub radius_1: Length,
    /// Radius r₂ of cylinder 2.
    pub radius_2: Length,
    /// Film thickness h₀ on the line of centres.
    pub film_thickness: Length,
    /// Angle θ at the centre of cylinder 2; zero on the line of centres.
    pub angle: Angle,
    /// Base radius R_b of the paper's model.
    pub base_radius: Length,
    /// Speed u∞ in the middle of the paper's film; the mean speed of the walls if `None`.
    pub middle_speed: Option<Speed>,
    /// Viscosity.
    pub viscosity: DynamicViscosity,
    /// Density.
    pub density: Density,
}

/// u = ω·r                                                                    [Wall-1]
///
/// # Errors
/// When the rotational speed is not finite or the radius is not positive.
///
/// ```
/// use asperity_ns_film::model::wall_speed;
/// let u = wall_speed("3000 1/min".parse()?, "14.54 mm".parse()?)?;
/// assert!((u.si() - 4.5679).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn wall_speed(rotation: AngularSpeed, radius: Length) -> Result<Speed, FilmError> {
    asperity_core::cite!("Wall-1");
    let omega = DomainError::finite("rotational speed", rotation)?;
    Ok(Speed::from_si(
        omega * DomainError::positive("radius", radius)?,
    ))
}

impl FilmConditions {
    /// Section of the consistent film: the gap of the relative radius at x = r₂·sin θ, and the flow
    /// without pressure gradient on the line of centres, q = ½·(u₁ + u₂)·h₀, as in an
    /// elastohydrodynamic film.
    ///
    /// # Errors
    /// When a number is not finite, or a length is not positive.
    pub fn section(&self) -> Result<FilmSection, FilmError> {
        let r1 = DomainError::positive("radius 1", self.radius_1)?;
        let r2 = DomainError::positive("radius 2", self.radius_2)?;
        let theta = DomainError::finite("angle", self.angle)?;
        let relative = Length::from_si(r1 * r2 / (r1 + r2));
        let x = Length::from_si(r2 * theta.sin());
        let shape = GapShape::Parabola;
        let mean = 0.5 * (self.wall_1.si() + self.wall_2.si());
        Ok(FilmSection {
            wall_1: self.wall_1,
            wall_2: self.wall_2,
            thickness: shape.gap(self.film_thickness, x, relative)?,
            slope: shape.slope(x, relative)?,
            flow: mean * self.film_thickness.si(),
            viscosity: self.viscosity,
            density: self.density,
            radius: self.radius_2,
        })
    }

    /// Velocity, wall shear, pressure gradient and pressure difference of the consistent film.
    ///
    /// # Errors
    /// When a number is not finite, or a length, the viscosity or the density is not positive.
    pub fn cross_film(&self) -> Result<CrossFilm, FilmError> {
        self.section()?.cross_film()
    }

    /// Section of the paper's film; its parabola spans the film thickness h₀.
    pub fn paper_film(&self) -> PaperFilm {
        let mean = (self.wall_1 + self.wall_2) * 0.5;
        PaperFilm {
            profile: VelocityProfile {
                wall_1: self.wall_1,
                middle: self.middle_speed.unwrap_or(mean),
                wall_2: self.wall_2,
                thickness: self.film_thickness,
            },
            radius_1: self.radius_1,
            radius_2: self.radius_2,
            least_gap: self.film_thickness,
            angle: self.angle,
            base_radius: self.base_radius,
            density: self.density,
            viscosity: self.viscosity,
        }
    }
}

/// Pressure at wall 1 minus pressure at wall 2.
///
/// # Errors
/// When a number is not finite, or a length, the viscosity or the density is not positive.
///
/// ```
/// use asperity_ns_film::model::{FilmConditions, FluidModel, pressure_difference_across, wall_speed};
/// let (r1, r2) = ("14.54 mm".parse()?, "34.896 mm".parse()?);
/// let film = FilmConditions {
///     wall_1: wall_speed("3000 1/min".parse()?, r1)?, wall_2: wall_speed("1250 1/min".parse()?, r2)?,
///     radius_1: r1, radius_2: r2, film_thickness: "100 nm".parse()?, angle: "0 deg".parse()?,
///     base_radius: "34.56 mm".parse()?, middle_speed: None, viscosity: "97.5 mPa s".parse()?, density: "998 kg/m3".parse()?,
/// };
/// for model in [FluidModel::ReynoldsCross, FluidModel::Paper] {
///     assert!(pressure_difference_across(model, &film)?.si().abs() < 1.0);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pressure_difference_across(
    model: FluidModel,
    conditions: &FilmConditions,
) -> Result<Pressure, FilmError> {
    match model {
        FluidModel::ReynoldsCross => Ok(conditions.cross_film()?.difference),
        FluidModel::Paper => conditions.paper_film().pressure_difference(),
    }
}

/// Pressure difference \[Pa\] at each film thickness \[m\], with the other values of `conditions`
/// (figure 8 of the paper).
///
/// # Errors
/// As for [`pressure_difference_across`].
///
/// ```
/// # use asperity_ns_film::model::{FilmConditions, FluidModel, pressure_difference_over_thickness};
/// # let film = FilmConditions {
/// #     wall_1: "4.57 m/s".parse()?, wall_2: "4.57 m/s".parse()?,
/// #     radius_1: "14.54 mm".parse()?, radius_2: "34.896 mm".parse()?, film_thickness: "100 nm".parse()?, angle: "0 deg".parse()?,
/// #     base_radius: "34.56 mm".parse()?, middle_speed: None, viscosity: "97.5 mPa s".parse()?, density: "998 kg/m3".parse()?,
/// # };
/// let fig8 = pressure_difference_over_thickness(FluidModel::Paper, &film, &[1e-7, 1e-6, 1e-5])?;
/// assert!((fig8[2] / fig8[0] - 100.0).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pressure_difference_over_thickness(
    model: FluidModel,
    conditions: &FilmConditions,
    thicknesses: &[f64],
) -> Result<Vec<f64>, FilmError> {
    thicknesses
        .iter()
        .map(|&thickness| {
            let at = FilmConditions {
                film_thickness: Length::from_si(thickness),
                ..*conditions
            };
            pressure_difference_across(model, &at).map(Pressure::si)
        })
        .collect()
}
