//! The paper's film: the radial momentum equation integrated across the gap.
//!
//! The paper assumes a parabola of velocity through the film whose argument is the gap at the angle θ,
//! so that u_θ depends only on θ. It derives u_r from continuity and integrates dP/dr from wall 2 to
//! wall 1. The misprints are corrected. The velocity field still has no single-valued pressure; the model
//! serves only for comparison with the paper. At the pitch point, where both walls have the same speed,
//! the pressure difference equals the one of the consistent film; with sliding the terms in ∂u/∂θ
//! dominate and are far too large.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | θ, r | angle and radius at the centre of cylinder 2 | rad, m |
//! | r₁, r₂ | radii of the cylinders | m |
//! | h₀, h | gap on the line of centres and at θ | m |
//! | H | thickness that the parabola spans | m |
//! | u∞ | speed in the middle of the film | m/s |
//! | D = −R_b | constant of integration of u_r | m |
//! | f, f', f'' | first to third derivative of u_θ over θ | m/s |
//! | ρ, μ | density, viscosity | kg/m³, Pa s |
//!
//! Equations of the paper that are not evaluated here: continuity, which the velocities below satisfy; the
//! assumptions of a plane and steady flow; and three statements, of which the first two are not used.
//!
//! - ∂ρ/∂t + (1/r)·∂(r·ρ·u_r)/∂r + (1/r)·∂(ρ·u_θ)/∂θ + ∂(ρ·u_z)/∂z = 0   `[P22]`
//! - assumption: u_z = 0   `[P24]`
//! - assumption: ∂ⁱu_r/∂zⁱ = 0   `[P25]`
//! - assumption: ∂uᵢ/∂t = 0   `[P26]`
//! - assumption: ∂ⁱu_θ/∂zⁱ = 0   `[P27]`
//! - assumption: g = 0   `[P28]`
//! - not used: u_r(r = δ_BL) = u∞   `[P33]`
//! - not used: R_b = m·z·cos α   `[P35]`
//! - ∂P/∂z = 0   `[P37]`

use std::f64::consts::PI;

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Density, DynamicViscosity, Length, Pressure, Speed};
use serde::Serialize;

use crate::FilmError;
use crate::gap::{paper_gap, paper_rise};
use crate::velocity_profile::{VelocityProfile, parabola};

/// Section of the paper's film.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PaperFilm {
    /// The parabola: wall speeds w₁·r₁ and w₂·r₂, the speed u∞ in the middle, and H.
    pub profile: VelocityProfile,
    /// Radius r₁ of cylinder 1.
    pub radius_1: Length,
    /// Radius r₂ of cylinder 2.
    pub radius_2: Length,
    /// Gap h₀ on the line of centres.
    pub least_gap: Length,
    /// Angle θ of the section.
    pub angle: Angle,
    /// Base radius R_b.
    pub base_radius: Length,
    /// Density ρ.
    pub density: Density,
    /// Viscosity μ.
    pub viscosity: DynamicViscosity,
}

/// Velocity and its derivatives at a point, in cylinder coordinates, for [`radial_momentum`].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct LocalFlow {
    /// r \[m\].
    pub radius: f64,
    /// u_θ \[m/s\].
    pub along: f64,
    /// ∂u_θ/∂θ \[m/s\].
    pub along_theta: f64,
    /// u_r \[m/s\].
    pub radial: f64,
    /// ∂u_r/∂r \[1/s\].
    pub radial_r: f64,
    /// ∂²u_r/∂r² \[1/(m s)\].
    pub radial_rr: f64,
    /// ∂u_r/∂θ \[m/s\].
    pub radial_theta: f64,
    /// ∂²u_r/∂θ² \[m/s\].
    pub radial_theta_theta: f64,
}

/// dP/dr = ρ·(u_θ²/r − u_r·∂u_r/∂r − (u_θ/r)·∂u_r/∂θ)
///       + μ·(∂²u_r/∂r² + (1/r)·∂u_r/∂r + (1/r²)·∂²u_r/∂θ² − u_r/r² − (2/r²)·∂u_θ/∂θ)      `[P23]`
///
/// in Pa/m: the steady Navier-Stokes equation along the radius.
///
/// # Errors
/// When the radius is not positive.
///
/// ```
/// use asperity_ns_film::paper::{LocalFlow, radial_momentum};
/// // Rigid rotation: only the centrifugal force.
/// let flow = LocalFlow { radius: 0.01, along: 5.0, ..LocalFlow::default() };
/// let gradient = radial_momentum(&flow, "998 kg/m3".parse()?, "97.5 mPa s".parse()?)?;
/// assert!((gradient / (998.0 * 25.0 / 0.01) - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn radial_momentum(
    flow: &LocalFlow,
    density: Density,
    viscosity: DynamicViscosity,
) -> Result<f64, FilmError> {
    asperity_core::cite!("P23");
    let r = DomainError::positive("radius", Length::from_si(flow.radius))?;
    let (rho, mu) = (density.si(), viscosity.si());
    let inertia = flow.along * flow.along / r
        - flow.radial * flow.radial_r
        - flow.along / r * flow.radial_theta;
    let friction = flow.radial_rr + flow.radial_r / r + flow.radial_theta_theta / (r * r)
        - flow.radial / (r * r)
        - 2.0 * flow.along_theta / (r * r);
    Ok(rho * inertia + mu * friction)
}

/// 2·π/z \[rad\], the angle from one tooth to the next                           `[P34]`
///
/// # Errors
/// When there is no tooth.
///
/// ```
/// use asperity_ns_film::paper::angular_pitch;
/// assert!((angular_pitch(50)?.si() - 0.12566370614359174).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn angular_pitch(teeth: u32) -> Result<Angle, FilmError> {
    asperity_core::cite!("P34");
    let z = f64::from(teeth);
    DomainError::require(z > 0.0, "number of teeth", z, "-", "must be at least 1")?;
    Ok(Angle::from_si(2.0 * PI / z))
}

/// R_b = m_t·z·cos(α_t)/2                                                    `[P36]`
///
/// # Errors
/// When the module is not positive, there is no tooth, or the angle is not within 0 to 90°.
///
/// ```
/// use asperity_ns_film::paper::base_radius;
/// let radius = base_radius("2 mm".parse()?, 30, "20 deg".parse()?)?;
/// assert!((radius.si() - 0.030 * 20f64.to_radians().cos()).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn base_radius(
    transverse_module: Length,
    teeth: u32,
    transverse_pressure_angle: Angle,
) -> Result<Length, FilmError> {
    asperity_core::cite!("P36");
    let m = DomainError::positive("transverse module", transverse_module)?;
    let z = f64::from(teeth);
    DomainError::require(z > 0.0, "number of teeth", z, "-", "must be at least 1")?;
    let alpha = DomainError::non_negative("transverse pressure angle", transverse_pressure_angle)?;
    DomainError::require(
        alpha < 0.5 * PI,
        "transverse pressure angle",
        alpha,
        "rad",
        "must be below a right angle",
    )?;
    Ok(Length::from_si(0.5 * m * z * alpha.cos()))
}

/// u_θ and its derivatives with respect to θ at a gap.
struct Kernel {
    u: f64,
    f: f64,
    f1: f64,
    f2: f64,
    h: f64,
}

/// Section of the paper's film at any gap h₀, with all other inputs checked; made by
/// [`PaperFilm::at_any_gap`].
#[derive(Debug, Clone, Copy)]
pub struct PaperSection {
    /// w₁·r₁, u∞ and w₂·r₂.
    speeds: [f64; 3],
    /// h − h₀.
    rise: f64,
    /// (r₁ + r₂)·sin θ and (r₁ + r₂)·cos θ, the first two derivatives of h.
    turn: [f64; 2],
    d: f64,
    r2: f64,
    rho: f64,
    mu: f64,
}

impl PaperSection {
    /// [`PaperFilm::pressure_difference`] with both the gap h₀ and the thickness of the parabola equal to `gap`.
    ///
    /// # Errors
    /// When the gap is not positive.
    #[inline]
    pub fn pressure_difference(&self, gap: Length) -> Result<Pressure, FilmError> {
        let h0 = DomainError::positive("film thickness", gap)?;
        Ok(self.difference(&self.kernel(parabola(self.speeds, h0), h0 + self.rise)))
    }

    #[inline]
    fn kernel(&self, [a, b, c]: [f64; 3], h: f64) -> Kernel {
        let [sine, cosine] = self.turn;
        let slope = 2.0 * a * h + b;
        Kernel {
            u: (a * h + b) * h + c,
            f: slope * sine,
            f1: 2.0 * a * sine * sine + slope * cosine,
            f2: 6.0 * a * sine * cosine - slope * sine,
            h,
        }
    }

    #[inline]
    fn difference(&self, k: &Kernel) -> Pressure {
        let (r, h, d) = (self.r2, k.h, self.d);
        let outer = r + h;
        let i1 = (h / r).ln_1p();
        let i2 = h / (r * outer);
        let i3 = h * (2.0 * r + h) / (2.0 * r * r * outer * outer);
        let inertia =
            k.u * k.u * i1 + k.u * k.f1 * (i1 + d * i2) + k.f * k.f * (d * i2 + d * d * i3);
        let friction = k.f * i2 + k.f2 * (i2 + d * i3);
        Pressure::from_si(self.rho * inertia - self.mu * friction)
    }
}

impl PaperFilm {
    /// h at the angle of the section; see [`paper_gap`].
    ///
    /// # Errors
    /// When the angle is not finite, or the gap or a radius is not positive.
    pub fn gap(&self) -> Result<Length, FilmError> {
        paper_gap(self.least_gap, self.angle, self.radius_1, self.radius_2)
    }

    /// u_r = −f·(r + D)/r                                                       `[P31]`
    ///
    /// # Errors
    /// When a number is outside its domain, see [`pressure_difference`](Self::pressure_difference),
    /// or the radius is not positive.
    ///
    /// ```
    /// # use asperity_ns_film::{paper::PaperFilm, velocity_profile::VelocityProfile};
    /// # let u = "4.5679 m/s".parse()?;
    /// # let film = PaperFilm {
    /// #     profile: VelocityProfile { wall_1: u, middle: u, wall_2: u, thickness: "100 nm".parse()? },
    /// #     radius_1: "14.54 mm".parse()?, radius_2: "34.896 mm".parse()?, least_gap: "100 nm".parse()?, angle: "0 deg".parse()?,
    /// #     base_radius: "35 mm".parse()?, density: "998 kg/m3".parse()?, viscosity: "97.5 mPa s".parse()?,
    /// # };
    /// // On the line of centres the film flows parallel to the walls.
    /// assert_eq!(film.radial_velocity(film.radius_2)?.si(), 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn radial_velocity(&self, radius: Length) -> Result<Speed, FilmError> {
        asperity_core::cite!("P31");
        let (section, k) = self.kernel()?;
        let r = DomainError::positive("radius", radius)?;
        Ok(Speed::from_si(-k.f * (r + section.d) / r))
    }

    /// dP/dr = ρ·(u²/r + u·f'·(1/r + D/r²) + f²·(D/r² + D²/r³)) − μ·(f/r² + f''·(1/r² + D/r³))   `[Paper-2]`
    ///
    /// in Pa/m, with u = u_θ.
    ///
    /// # Errors
    /// As for [`radial_velocity`](Self::radial_velocity).
    ///
    /// ```
    /// # use asperity_ns_film::{paper::PaperFilm, velocity_profile::VelocityProfile};
    /// # let u = "4.5679 m/s".parse()?;
    /// # let film = PaperFilm {
    /// #     profile: VelocityProfile { wall_1: u, middle: u, wall_2: u, thickness: "100 nm".parse()? },
    /// #     radius_1: "14.54 mm".parse()?, radius_2: "34.896 mm".parse()?, least_gap: "100 nm".parse()?, angle: "0 deg".parse()?,
    /// #     base_radius: "35 mm".parse()?, density: "998 kg/m3".parse()?, viscosity: "97.5 mPa s".parse()?,
    /// # };
    /// let centrifugal = 998.0 * 4.5679f64.powi(2) / 34.896e-3;
    /// assert!((film.pressure_gradient(film.radius_2)? / centrifugal - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure_gradient(&self, radius: Length) -> Result<f64, FilmError> {
        asperity_core::cite!("Paper-2");
        let (section, k) = self.kernel()?;
        let (r, d) = (DomainError::positive("radius", radius)?, section.d);
        let (r2, r3) = (r * r, r * r * r);
        let inertia =
            k.u * k.u / r + k.u * k.f1 * (1.0 / r + d / r2) + k.f * k.f * (d / r2 + d * d / r3);
        let friction = k.f / r2 + k.f2 * (1.0 / r2 + d / r3);
        Ok(section.rho * inertia - section.mu * friction)
    }

    /// P(r₂ + h) − P(r₂) = ρ·(u²·I₁ + u·f'·(I₁ + D·I₂) + f²·(D·I₂ + D²·I₃)) − μ·(f·I₂ + f''·(I₂ + D·I₃))   [Paper-1]
    ///
    /// the integral of [`pressure_gradient`](Self::pressure_gradient) across the film, with Iₙ = ∫r⁻ⁿ dr from r₂ to
    /// r₂ + h in forms that do not cancel for h ≪ r₂.
    ///
    /// # Errors
    /// When a speed or the angle is not finite, or a length, the density or the viscosity is not
    /// positive.
    ///
    /// ```
    /// # use asperity_ns_film::{paper::PaperFilm, velocity_profile::VelocityProfile};
    /// # let u = "4.5679 m/s".parse()?;
    /// # let film = PaperFilm {
    /// #     profile: VelocityProfile { wall_1: u, middle: u, wall_2: u, thickness: "100 nm".parse()? },
    /// #     radius_1: "14.54 mm".parse()?, radius_2: "34.896 mm".parse()?, least_gap: "100 nm".parse()?, angle: "0 deg".parse()?,
    /// #     base_radius: "35 mm".parse()?, density: "998 kg/m3".parse()?, viscosity: "97.5 mPa s".parse()?,
    /// # };
    /// assert!((film.pressure_difference()?.si() - 0.0597).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure_difference(&self) -> Result<Pressure, FilmError> {
        asperity_core::cite!("Paper-1");
        let (section, kernel) = self.kernel()?;
        Ok(section.difference(&kernel))
    }

    /// Section with the gap h₀ and the thickness H of the parabola left open, as one variable.
    ///
    /// # Errors
    /// As for [`pressure_difference`](Self::pressure_difference).
    ///
    /// ```
    /// # use asperity_ns_film::{paper::PaperFilm, velocity_profile::VelocityProfile};
    /// # let u = "4.5679 m/s".parse()?;
    /// # let film = PaperFilm {
    /// #     profile: VelocityProfile { wall_1: u, middle: u, wall_2: u, thickness: "100 nm".parse()? },
    /// #     radius_1: "14.54 mm".parse()?, radius_2: "34.896 mm".parse()?, least_gap: "100 nm".parse()?, angle: "0 deg".parse()?,
    /// #     base_radius: "35 mm".parse()?, density: "998 kg/m3".parse()?, viscosity: "97.5 mPa s".parse()?,
    /// # };
    /// let section = film.at_any_gap()?;
    /// assert_eq!(section.pressure_difference(film.least_gap)?, film.pressure_difference()?);
    /// assert!(section.pressure_difference("0 nm".parse()?).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at_any_gap(&self) -> Result<PaperSection, FilmError> {
        // Checks all inputs and records the equations.
        self.pressure_difference()?;
        self.section()
    }

    fn kernel(&self) -> Result<(PaperSection, Kernel), FilmError> {
        let coefficients = self.profile.coefficients()?;
        let h = self.gap()?.si();
        let section = self.section()?;
        let kernel = section.kernel(coefficients, h);
        Ok((section, kernel))
    }

    fn section(&self) -> Result<PaperSection, FilmError> {
        let theta = DomainError::finite("angle", self.angle)?;
        let r1 = DomainError::positive("radius 1", self.radius_1)?;
        let r2 = DomainError::positive("radius 2", self.radius_2)?;
        let (sine, cosine) = theta.sin_cos();
        Ok(PaperSection {
            speeds: [
                DomainError::finite("speed of wall 1", self.profile.wall_1)?,
                DomainError::finite("speed in the middle", self.profile.middle)?,
                DomainError::finite("speed of wall 2", self.profile.wall_2)?,
            ],
            rise: paper_rise(theta, r1, r2),
            turn: [(r1 + r2) * sine, (r1 + r2) * cosine],
            d: -DomainError::positive("base radius", self.base_radius)?,
            r2,
            rho: DomainError::positive("density", self.density)?,
            mu: DomainError::positive("viscosity", self.viscosity)?,
        })
    }
}
