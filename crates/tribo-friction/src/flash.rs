//! Blok's flash temperature of a line contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ΔT | largest rise of the surface temperature in the contact | K |
//! | μ w | friction force per length of contact line | N/m |
//! | u₁, u₂ | surface speeds in the direction of motion | m/s |
//! | B | thermal contact coefficient √(k ρ c) of a flank | W s^½/(m² K) |
//! | a | half width of the contact | m |
//!
//! Source: H. Blok (1937), as in ISO/TS 6336-20 and AGMA 925. The constant is 1.11 for a
//! semi-elliptic heat source moving fast over both flanks (1.1115 by quadrature of Blok's
//! integral). Fast means Péclet numbers u a ρ c/(2 k) above about 5; for slower flanks heat runs
//! ahead of the contact and the formula reads too high. Both surfaces must move through the
//! contact in the same direction.

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{Length, Speed};
use asperity_core::{DomainError, cite};

use crate::error::FrictionError;

/// Blok's constant of a semi-elliptic source.
const SEMI_ELLIPSE: f64 = 1.11;

/// Largest rise of the surface temperature in a contact with this Hertz half width and friction coefficient.
///
/// ```text
/// ΔT = 1.11 μ w |u₁ − u₂|/( (B₁ √u₁ + B₂ √u₂) √(2a) ),  B = √(k ρ c)             [Blok]
/// ```
///
/// In kelvin. For flanks of one material it is 1.11 μ w |√u₁ − √u₂|/(B √(2a)).
///
/// # Errors
/// When μ is negative, load, half width or a thermal constant not positive, a speed negative or
/// both speeds 0.
///
/// ```
/// use asperity_core::{line_contact::LineContact, material::Material};
/// use asperity_tribo_friction::flash_temperature;
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "235 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// let contact = LineContact {
///     load: "113.41 N/mm".parse()?, radius: "9.88 mm".parse()?, modulus: "115.385 GPa".parse()?,
///     speeds: ["3.5532 m/s".parse()?, "4.9907 m/s".parse()?], bodies: [steel, steel],
/// };
/// let rise = flash_temperature(&contact, "0.1112 mm".parse()?, 0.0627)?;
/// assert!((rise - 14.4).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn flash_temperature(
    contact: &LineContact,
    half_width: Length,
    friction: f64,
) -> Result<f64, FrictionError> {
    cite!("Blok");
    let mu = DomainError::require(
        friction.is_finite() && friction >= 0.0,
        "friction coefficient",
        friction,
        "-",
        "must be finite and not negative",
    )?;
    let w = DomainError::positive("line load", contact.load)?;
    let [first, second] = conductions(contact.bodies.each_ref(), contact.speeds)?;
    let a = DomainError::positive("half width", half_width)?;
    let sliding = contact.sliding().si().abs();
    Ok(SEMI_ELLIPSE * mu * w * sliding / ((first + second) * (2.0 * a).sqrt()))
}

/// Share of the frictional heat that goes into the first flank, of equal surface temperatures in the contact.
///
/// ```text
/// β = B₁ √u₁/(B₁ √u₁ + B₂ √u₂),  B = √(k ρ c)                                    [Blok-share]
/// ```
///
/// Both flanks fast (Péclet numbers above about 5); a flank that stands still takes none.
///
/// # Errors
/// When a thermal constant is not positive, a speed negative or both speeds 0.
///
/// ```
/// use asperity_core::material::Material;
/// use asperity_tribo_friction::flash::heat_share;
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "235 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// // A flank four times as fast takes twice as much.
/// let share = heat_share([&steel, &steel], ["8 m/s".parse()?, "2 m/s".parse()?])?;
/// assert!((share - 2.0 / 3.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn heat_share(flanks: [&Material; 2], speeds: [Speed; 2]) -> Result<f64, FrictionError> {
    cite!("Blok-share");
    let [first, second] = conductions(flanks, speeds)?;
    Ok(first / (first + second))
}

/// B √u of each flank.
fn conductions(
    flanks: [&Material; 2],
    [first, second]: [Speed; 2],
) -> Result<[f64; 2], FrictionError> {
    let u_1 = DomainError::non_negative("speed of the first surface", first)?;
    let u_2 = DomainError::non_negative("speed of the second surface", second)?;
    let rule = "at least one surface must move";
    let sum = u_1 + u_2;
    DomainError::require(sum > 0.0, "sum of the surface speeds", sum, "m/s", rule)?;
    Ok([
        thermal_contact_coefficient(flanks[0])? * u_1.sqrt(),
        thermal_contact_coefficient(flanks[1])? * u_2.sqrt(),
    ])
}

/// B = √(k ρ c)
fn thermal_contact_coefficient(material: &Material) -> Result<f64, DomainError> {
    let k = DomainError::positive("conductivity", material.conductivity)?;
    let rho = DomainError::positive("density", material.density)?;
    let c = DomainError::positive("heat capacity", material.heat_capacity)?;
    Ok((k * rho * c).sqrt())
}
