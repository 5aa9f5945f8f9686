//! Friction of a smooth film between two bodies that touch at a point, such as ball and disc, with the heat of film and
//! surfaces.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F | load | N |
//! | a, b | half-axes of the contact along and across the motion | m |
//! | p₀ | largest pressure of Hertz, 3 F/(2 π a b) | Pa |
//! | h | central film thickness, with its thermal reduction | m |
//! | u₁, u₂, V_s | surface speeds, sliding speed u₁ − u₂ | m/s |
//! | T₀, T_s | bath temperature, mean temperature of the surfaces in the contact | K |
//! | k, ρ, c | conductivity, density, specific heat of a body | W/(m K), kg/m³, J/(kg K) |
//! | r | rise of the bodies above the bath per heat flow | K/W |
//! | K | complete elliptic integral of the ellipse, π/2 for a circle | - |
//!
//! The shear stress at a point is that of the line contact ([`film_friction`](crate::film_friction)). The mean rise of
//! the surfaces joins a fast source (Péclet numbers u a ρ c/k from about 10) to one at rest: the sum with the power 9/4
//! is within 1.2 % of the mean rise by the Green function of the half-space at every Péclet number (computed on a
//! circle). The constant of the fast source is that of strips along the motion, whose share of heat
//! and length shrinks towards the ends of the contact.

use std::f64::consts::PI;

use asperity_core::material::Material;
use asperity_core::numerics::{CompleteElliptic, gauss_legendre};
use asperity_core::quantity::{Force, Length, Speed, Temperature};
use asperity_core::{Checked, DomainError, cite};
use asperity_oil::FilmRheology;
use serde::Serialize;

use crate::error::FrictionError;
use crate::film_friction::{
    FilmArea, FilmFrictionSolution, FilmHeat, FilmSettings, LoadedFilm, MEAN_FLASH, PLACES,
};

/// Mean rise of the strips of an ellipse over that of its middle strip, B(1/2, 11/4)/B(1/2, 2).
const STRIPS: f64 = 0.838_698_164_314_915;
/// Load per length of the middle strip over F/b.
const MIDDLE_STRIP: f64 = 0.75;
/// Mean rise of a body at rest: 0.3 Q/(k a) on a circle.
const AT_REST: f64 = 0.6;
/// Power of the sum of the conductances of a fast source and one at rest.
const JOINING_POWER: f64 = 2.25;

/// A smooth film in a contact at a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmPointContact {
    /// Load F.
    pub load: Force,
    /// Half-axes a along and b across the motion.
    pub half_axes: [Length; 2],
    /// Surface speeds u₁, u₂ in the direction of motion.
    pub speeds: [Speed; 2],
    /// Materials of the two bodies.
    pub bodies: [Material; 2],
    /// Central film thickness h with its thermal reduction.
    pub film: Length,
    /// Temperature T₀ of the bath and of the oil at the inlet.
    pub temperature: Temperature,
    /// Rise r of the bodies above the bath per heat of friction \[K/W\].
    pub bulk_rise: f64,
}

impl<'a> LoadedFilm<'a> {
    /// The film of a contact at a point.
    ///
    /// ```text
    /// μ = (3/p₀) ∫₀¹ τ(z) z dz,  z = p/p₀                                  [Point-film-friction]
    /// ```
    ///
    /// # Errors
    /// When load, a half-axis, film, the sum of the speeds or a thermal constant is not positive, the bulk rise is
    /// negative, or the oil has no viscosity at the temperature.
    pub fn at_point(
        rheology: &'a FilmRheology,
        contact: &FilmPointContact,
        settings: FilmSettings,
    ) -> Result<Self, FrictionError> {
        cite!("Point-film-friction");
        let load = DomainError::positive("load", contact.load)?;
        let [a, b] = contact.half_axes;
        let a = DomainError::positive("half-axis along the motion", a)?;
        let b = DomainError::positive("half-axis across the motion", b)?;
        let [u1, u2] = contact.speeds;
        let speeds = [
            DomainError::finite("speed of the first surface", u1)?,
            DomainError::finite("speed of the second surface", u2)?,
        ];
        DomainError::positive("entrainment speed", (u1 + u2) * 0.5)?;
        let rise_per_friction = match settings.heat {
            FilmHeat::FilmAndSurfaces => surface_rise_per_friction(contact, load, [a, b], speeds)?,
            FilmHeat::Isothermal => 0.0,
        };
        let max_pressure = 1.5 * load / (PI * a * b);
        let node = |&(x, weight): &(f64, f64)| {
            let z = 0.5 * (1.0 + x);
            [max_pressure * z, 1.5 / max_pressure * weight * z]
        };
        let area = FilmArea {
            load,
            area: PI * a * b,
            half_width: a,
            max_pressure,
            speeds,
            film: DomainError::positive("film", contact.film)?,
            bulk: DomainError::positive("bath temperature", contact.temperature)?,
            rise_per_friction,
            nodes: gauss_legendre(settings.nodes).iter().map(node).collect(),
            few: gauss_legendre(PLACES).iter().map(node).collect(),
        };
        Self::on(rheology, area, settings.heat)
    }
}

/// Rise of the mean surface temperature in the contact per friction coefficient \[K\].
///
/// ```text
/// T_s − T₀ = μ F V_s (1/(G₁ + G₂) + r),  G_i = (G_f^q + G_s^q)^(1/q),  q = 9/4     [Point-surface-heat]
/// G_f = b √(k ρ c) √(2 a u_i)/0.502280288,  G_s = π k max(a, b)/(0.6 K)
/// ```
fn surface_rise_per_friction(
    contact: &FilmPointContact,
    load: f64,
    [a, b]: [f64; 2],
    speeds: [f64; 2],
) -> Result<f64, FrictionError> {
    cite!("Point-surface-heat");
    let (long, short) = (a.max(b), a.min(b));
    let square = (short / long) * (short / long);
    let at_rest = PI * long / (AT_REST * CompleteElliptic::from_complement(square).first);
    let fast = b * (2.0 * a).sqrt() / (MIDDLE_STRIP * STRIPS * MEAN_FLASH);
    let mut conductance = 0.0;
    for (u, body) in speeds.iter().zip(&contact.bodies) {
        let k = DomainError::positive("conductivity", body.conductivity)?;
        let rho = DomainError::positive("density", body.density)?;
        let c = DomainError::positive("heat capacity", body.heat_capacity)?;
        let moving = fast * (k * rho * c * u.abs()).sqrt();
        conductance += (moving.powf(JOINING_POWER) + (at_rest * k).powf(JOINING_POWER))
            .powf(1.0 / JOINING_POWER);
    }
    let rule = "must be finite and not negative";
    let rise = contact.bulk_rise;
    let is_valid = rise.is_finite() && rise >= 0.0;
    DomainError::require(is_valid, "bulk rise", rise, "K/W", rule)?;
    Ok(load * (speeds[0] - speeds[1]).abs() * (1.0 / conductance + rise))
}

/// Friction of the smooth film of a contact at a point.
///
/// # Errors
/// As [`LoadedFilm::at_point`].
///
/// ```
/// use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
/// use asperity_core::material::Material;
/// use asperity_tribo_friction::{FilmPointContact, FilmSettings, point_film::solve};
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "1500 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "21 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// let oil = LubricantInput {
///     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
/// }.resolve("90 °C".parse()?)?;
/// let rheology = FilmRheology::new(&oil, BaseOil::Mineral)?;
/// // A ball of 19.05 mm on a disc under 30 N at 2 m/s and a slide-to-roll ratio of 50 %.
/// let contact = FilmPointContact {
///     load: "30 N".parse()?, half_axes: ["122.9 um".parse()?; 2], speeds: ["2.5 m/s".parse()?, "1.5 m/s".parse()?],
///     bodies: [steel, steel], film: "139 nm".parse()?, temperature: "90 °C".parse()?, bulk_rise: 0.0,
/// };
/// let friction = solve(&rheology, &contact, FilmSettings::default())?.value;
/// assert!((friction.coefficient - 0.033).abs() < 1e-3, "{}", friction.coefficient);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    rheology: &FilmRheology,
    contact: &FilmPointContact,
    settings: FilmSettings,
) -> Result<Checked<FilmFrictionSolution>, FrictionError> {
    LoadedFilm::at_point(rheology, contact, settings)?.solve()
}
