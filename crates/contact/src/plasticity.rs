//! Plastic flow of the surface at a limit of the pressure.
//!
//! Source: perfect plasticity of the surface as in Almqvist et al. 2007; the paper's eq. 6, with its
//! circular definition of the elastic stress corrected. Where the pressure is at the flow pressure the
//! bodies would overlap; the overlap is the plastic displacement. While the load grows, loading in one
//! step or in many gives the same displacement, and loading the residual profiles again in the same
//! position is elastic. Flow below the surface is not modelled here.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, p_flow | pressure, pressure at which the softer surface flows | Pa |
//! | g | gap under elastic displacement only | m |
//! | w | plastic displacement of both bodies together | m |
//! | D | energy dissipated per metre of face width | J/m |
//! | σ_VM, σ_y | von Mises stress, elastic limit | Pa |
//! | c = (1 − ν²)/E | plane-strain compliance of a body | 1/Pa |

use asperity_core::material::Material;
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::ContactError;

/// Flow pressure over elastic limit: the hardness of a metal is about three times its yield stress
/// (Tabor 1951).
pub const FLOW_OVER_YIELD: f64 = 3.0;

/// Largest pressure of a Hertz line contact at first yield, relative to the elastic limit in tension
/// (Johnson 1985, von Mises, ν = 0.3).
pub const FIRST_YIELD: f64 = 1.79;

/// σ_pl = max(0, σ_VM − σ_y)                                                                  `[P6]`
///
/// The part of von Mises stresses \[Pa\] beyond the elastic limit, as
/// [`StressField::von_mises`](crate::subsurface::StressField::von_mises) returns them.
///
/// # Errors
/// When the elastic limit is not positive.
///
/// ```
/// use asperity_contact::plasticity::plastic_stress;
/// assert_eq!(plastic_stress(&[300e6, 200e6], "235 MPa".parse()?)?, [65e6, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plastic_stress(von_mises: &[f64], elastic_limit: Pressure) -> Result<Vec<f64>, DomainError> {
    cite!("P6");
    let limit = DomainError::positive("elastic limit", elastic_limit)?;
    let beyond = von_mises.iter().map(|stress| (stress - limit).max(0.0));
    Ok(beyond.collect())
}

/// p_flow = 3·σ_y of the softer body                                                     [Tabor-1]
///
/// # Errors
/// When an elastic limit is not positive.
pub fn flow_pressure(first: &Material, second: &Material) -> Result<Pressure, DomainError> {
    cite!("Tabor-1");
    let one = DomainError::positive("elastic limit", first.elastic_limit)?;
    let other = DomainError::positive("elastic limit", second.elastic_limit)?;
    Ok(Pressure::from_si(FLOW_OVER_YIELD * one.min(other)))
}

/// p_flow = min(p_flow,1, p_flow,2)                                                      [Tabor-2]
///
/// Flow pressure of a contact of two bodies: the flow pressure of the softer body.
///
/// # Errors
/// When a flow pressure is not positive.
///
/// ```
/// use asperity_contact::plasticity::softer_flow_pressure;
/// let softer = softer_flow_pressure("7 GPa".parse()?, "4.5 GPa".parse()?)?;
/// assert_eq!(softer, "4.5 GPa".parse()?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn softer_flow_pressure(first: Pressure, second: Pressure) -> Result<Pressure, DomainError> {
    cite!("Tabor-2");
    let one = DomainError::positive("flow pressure", first)?;
    let other = DomainError::positive("flow pressure", second)?;
    Ok(Pressure::from_si(one.min(other)))
}

/// p₀ = 1.79·σ_y of the softer body                                                      [Yield-1]
///
/// Largest pressure of a Hertz line contact at which a body begins to yield below its surface.
///
/// # Errors
/// When an elastic limit is not positive.
pub fn first_yield_pressure(first: &Material, second: &Material) -> Result<Pressure, DomainError> {
    cite!("Yield-1");
    let one = DomainError::positive("elastic limit", first.elastic_limit)?;
    let other = DomainError::positive("elastic limit", second.elastic_limit)?;
    Ok(Pressure::from_si(FIRST_YIELD * one.min(other)))
}

/// w = max(−g, 0) where p = p_flow, else 0                                             [Plastic-1]
///
/// `pressure` in Pa and `gap` in m belong to one solution; the gap includes only the elastic
/// displacement.
///
/// ```
/// use asperity_contact::plasticity::plastic_displacement;
/// let w = plastic_displacement(&[4e9, 1e9, 0.0], &[-1e-8, 0.0, 1e-6], Some("4 GPa".parse()?));
/// assert_eq!(w, [1e-8, 0.0, 0.0]);
/// # Ok::<(), asperity_core::quantity::QuantityError>(())
/// ```
pub fn plastic_displacement(
    pressure: &[f64],
    gap: &[f64],
    flow_pressure: Option<Pressure>,
) -> Vec<f64> {
    cite!("Plastic-1");
    let limit = flow_pressure.map_or(f64::INFINITY, Pressure::si);
    let pairs = pressure.iter().zip(gap);
    pairs
        .map(|(&p, &g)| if p >= limit { (-g).max(0.0) } else { 0.0 })
        .collect()
}

/// D = p_flow·Σ w·dx                                                                   [Plastic-2]
///
/// ```
/// use asperity_contact::plasticity::dissipated_energy;
/// let energy = dissipated_energy(&[1e-6, 3e-6], "1 um".parse()?, Some("4 GPa".parse()?));
/// assert!((energy.si() - 16e-3).abs() < 1e-15);
/// # Ok::<(), asperity_core::quantity::QuantityError>(())
/// ```
pub fn dissipated_energy(
    plastic_displacement: &[f64],
    spacing: Length,
    flow_pressure: Option<Pressure>,
) -> LineEnergy {
    cite!("Plastic-2");
    let area = plastic_displacement.iter().sum::<f64>() * spacing.si();
    LineEnergy::from_si(flow_pressure.map_or(0.0, |limit| limit.si() * area))
}

/// sᵢ = cᵢ/(c₁ + c₂),  c = (1 − ν²)/E                                                    [Share-1]
///
/// Share of each body in the elastic displacement; the shares sum to one.
///
/// # Errors
/// When a modulus is not positive or a Poisson's ratio is outside −1 < ν ≤ 0.5.
pub fn elastic_shares(first: &Material, second: &Material) -> Result<[f64; 2], ContactError> {
    cite!("Share-1");
    let (one, other) = (first.compliance()?, second.compliance()?);
    Ok([one / (one + other), other / (one + other)])
}

/// s₁ = σ_y2/(σ_y1 + σ_y2),  s₂ = 1 − s₁                                                 [Share-2]
///
/// Share of each body in the plastic displacement, in inverse proportion to the elastic limits: the
/// softer body has the larger share, equal bodies have half each. This is a convention, because a
/// surface model does not resolve which of the two bodies flows.
///
/// # Errors
/// When an elastic limit is not positive.
pub fn plastic_shares(first: &Material, second: &Material) -> Result<[f64; 2], ContactError> {
    cite!("Share-2");
    let one = DomainError::positive("elastic limit", first.elastic_limit)?;
    let other = DomainError::positive("elastic limit", second.elastic_limit)?;
    Ok([other / (one + other), one / (one + other)])
}

/// z − s·w                                                                             [Plastic-3]
///
/// Profile in m of a body after its share s of an elastic or plastic displacement in m, up to the
/// shorter array.
///
/// ```
/// use asperity_contact::plasticity::displaced_profile;
/// assert_eq!(displaced_profile(&[2e-6, 1e-6], &[1e-6, 0.0], 0.5), [1.5e-6, 1e-6]);
/// ```
pub fn displaced_profile(heights: &[f64], displacement: &[f64], share: f64) -> Vec<f64> {
    cite!("Plastic-3");
    let pairs = heights.iter().zip(displacement);
    pairs.map(|(z, w)| z - share * w).collect()
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::{Density, SpecificHeat, ThermalConductivity};

    use super::*;
    use crate::hertz_line::HertzLine;
    use crate::subsurface::hertz_stress;

    fn steel(elastic_limit: f64) -> Material {
        Material {
            young: Pressure::from_si(210e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(elastic_limit),
            density: Density::from_si(7830.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(465.0),
        }
    }

    #[test]
    fn stress_is_plastic_beyond_the_elastic_limit_only() {
        let limit = Pressure::from_si(235e6);
        let stress = plastic_stress(&[235e6, 0.0, 500e6], limit);
        assert_eq!(stress, Ok(vec![0.0, 0.0, 265e6]));
        assert!(plastic_stress(&[1.0], Pressure::from_si(0.0)).is_err());
        assert!(plastic_stress(&[1.0], Pressure::from_si(f64::NAN)).is_err());
    }

    #[test]
    fn equal_bodies_share_evenly_and_the_softer_takes_more() {
        let (hard, soft) = (steel(900e6), steel(300e6));
        assert_eq!(elastic_shares(&hard, &soft), Ok([0.5, 0.5]));
        assert_eq!(plastic_shares(&hard, &hard), Ok([0.5, 0.5]));
        assert_eq!(plastic_shares(&hard, &soft), Ok([0.25, 0.75]));
        let bronze = Material {
            young: Pressure::from_si(105e9),
            ..hard
        };
        let [stiff, compliant] = elastic_shares(&hard, &bronze).unwrap();
        assert!((stiff - 1.0 / 3.0).abs() < 1e-15 && (stiff + compliant - 1.0).abs() < 1e-15);
        assert!(plastic_shares(&hard, &steel(0.0)).is_err());
        let rubber = Material {
            poisson: 0.6,
            ..hard
        };
        assert!(elastic_shares(&hard, &rubber).is_err());
    }

    #[test]
    fn the_softer_body_sets_the_flow_pressure() {
        assert_eq!(
            flow_pressure(&steel(900e6), &steel(300e6)).map(Pressure::si),
            Ok(900e6)
        );
        assert!(flow_pressure(&steel(900e6), &steel(f64::NAN)).is_err());
    }

    #[test]
    fn a_contact_flows_at_the_pressure_of_the_softer_body() {
        let softer = |one: f64, other: f64| {
            softer_flow_pressure(Pressure::from_si(one), Pressure::from_si(other)).map(Pressure::si)
        };
        assert_eq!((softer(7e9, 4e9), softer(4e9, 7e9)), (Ok(4e9), Ok(4e9)));
        assert!(softer(7e9, 0.0).is_err() && softer(f64::NAN, 7e9).is_err());
    }

    #[test]
    fn a_contact_first_yields_where_its_von_mises_stress_meets_the_elastic_limit() {
        let (hard, soft) = (steel(900e6), steel(300e6));
        let onset = first_yield_pressure(&hard, &soft).unwrap();
        let contact = HertzLine {
            half_width: Length::from_si(1e-4),
            max_pressure: onset,
        };
        let on_axis = (0..400).map(|k| {
            let depth = Length::from_si(f64::from(k) * 0.5e-6);
            let stress = hertz_stress(&contact, 0.0, Length::from_si(0.0), depth).unwrap();
            stress.von_mises(0.3).unwrap().si()
        });
        // The factor has three digits.
        assert!((on_axis.fold(0.0, f64::max) / 300e6 - 1.0).abs() < 3e-3);
        assert!(first_yield_pressure(&hard, &steel(0.0)).is_err());
    }

    #[test]
    fn without_a_flow_pressure_nothing_flows() {
        let w = plastic_displacement(&[1e12], &[-1e-6], None);
        assert_eq!(w, [0.0]);
        assert_eq!(dissipated_energy(&w, Length::from_si(1e-6), None).si(), 0.0);
    }
}
