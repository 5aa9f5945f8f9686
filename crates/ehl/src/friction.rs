//! Shear stress of the film with a limiting stress, and boundary friction.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η₀, α | viscosity and its slope over pressure at the temperature of the film | Pa s, 1/Pa |
//! | γ | shear rate (u₁ − u₂)/h | 1/s |
//! | τ₀, τ_L | Eyring stress, limiting stress τ_L0 + Λ·p | Pa |
//! | μ_b, h_b | boundary friction, thickness of the boundary layer | -, m |
//! | H_b, h_s | film of nodes in contact, solid film | m |

use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity};
use asperity_core::{DomainError, cite};
use asperity_oil::{LARGEST_BARUS_EXPONENT, ShearLaw, limited_stress};
use serde::{Deserialize, Serialize};

/// Thinnest film of the shear rate \[m\].
pub(crate) const THINNEST: f64 = 2e-9;

/// Shear law of the film and of the boundary layer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FrictionLaw {
    /// Viscosity η₀ at the temperature of the film.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α at that temperature.
    pub pressure_viscosity: PressureViscosity,
    /// Eyring stress τ₀.
    pub eyring_stress: Pressure,
    /// Limiting stress τ_L0 without pressure.
    pub limiting_stress: Pressure,
    /// Slope Λ of the limiting stress over the pressure.
    pub limiting_slope: f64,
    /// Boundary friction μ_b.
    pub boundary_friction: f64,
    /// Thickness h_b of the boundary layer.
    pub boundary_layer: Length,
}

/// Friction of one state of the film, over the normal load.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Friction {
    /// Film friction everywhere.
    pub film: f64,
    /// Boundary friction with the weight min(1, e^(−(h − H_b)/h_b)), the film with the rest.
    pub shifted: f64,
    /// Boundary friction with the weight e^(−h/h_b), the film with the rest.
    pub graded: f64,
    /// Boundary friction below the solid film, the film above it.
    pub stepped: f64,
    /// Share of the load on the boundary layer, with the weight of `shifted`.
    pub boundary_share: f64,
}

/// A node of a film: weight \[m\], pressure \[Pa\], film \[m\], shear stress of the film \[Pa\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct ShearedNode {
    pub(crate) weight: f64,
    pub(crate) pressure: f64,
    pub(crate) film: f64,
    pub(crate) stress: f64,
}

/// Films at which the weights of the boundary friction change \[m\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundaryFilms {
    /// Film H_b of nodes in contact.
    pub(crate) contact: f64,
    /// Film h_s below which load counts as carried by solids.
    pub(crate) solid: f64,
}

impl FrictionLaw {
    /// Checks every constant of the law.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn validate(&self) -> Result<(), DomainError> {
        DomainError::positive("viscosity of the friction law", self.viscosity)?;
        DomainError::positive(
            "pressure-viscosity coefficient of the friction law",
            self.pressure_viscosity,
        )?;
        DomainError::positive("Eyring stress of the friction law", self.eyring_stress)?;
        DomainError::positive("limiting stress", self.limiting_stress)?;
        DomainError::positive("boundary layer", self.boundary_layer)?;
        for (name, value) in [
            ("slope of the limiting stress", self.limiting_slope),
            ("boundary friction", self.boundary_friction),
        ] {
            DomainError::require(
                (0.0..1.0).contains(&value),
                name,
                value,
                "-",
                "must lie between 0 and 1",
            )?;
        }
        Ok(())
    }

    /// Shear stress of the film at a pressure and a shear rate.
    ///
    /// ```text
    /// τ_E = τ₀·arsinh(η₀·e^min(αp, 40)·γ/τ₀),  τ = τ_E·(1 + (τ_E/τ_L)⁴)^(−1/4)    [Limited-Eyring]
    /// ```
    ///
    /// ```
    /// use asperity_ehl::FrictionLaw;
    /// let law = FrictionLaw {
    ///     viscosity: "10 mPa s".parse()?, pressure_viscosity: "18 1/GPa".parse()?,
    ///     eyring_stress: "5 MPa".parse()?, limiting_stress: "2 MPa".parse()?, limiting_slope: 0.05,
    ///     boundary_friction: 0.1, boundary_layer: "10 nm".parse()?,
    /// };
    /// let stress = law.film_stress(1e9, 1e6);
    /// assert!(stress < 52e6 && stress > 0.9 * 52e6);
    /// assert!((law.film_stress(0.0, 1e3) / 10.0 - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn film_stress(&self, pressure: f64, shear_rate: f64) -> f64 {
        let exponent = (self.pressure_viscosity.si() * pressure).min(LARGEST_BARUS_EXPONENT);
        let law = ShearLaw::Eyring {
            stress: self.eyring_stress,
        };
        let eyring = law.stress(self.viscosity.si() * exponent.exp(), shear_rate);
        let limit = self.limiting_stress.si() + self.limiting_slope * pressure;
        limited_stress([eyring, 0.0], [limit, 0.0])[0]
    }

    /// Shear stress of the film at a sliding speed and film \[m/s, m\].
    pub(crate) fn sheared(&self, pressure: f64, sliding: f64, film: f64) -> f64 {
        self.film_stress(pressure, sliding.abs() / film.max(THINNEST))
    }

    /// Weight of the boundary friction that is whole on nodes in contact.
    pub(crate) fn shifted_weight(&self, film: f64, films: BoundaryFilms) -> f64 {
        ((films.contact - film) / self.boundary_layer.si())
            .exp()
            .min(1.0)
    }

    /// Friction of a film.
    ///
    /// ```text
    /// μ = Σ wᵢ·[β·μ_b·p + (1 − β)·τ(p, Δu/h)]/Σ wᵢ·p,
    /// β = min(1, e^(−(h − H_b)/h_b)), e^(−h/h_b) or [h ≤ h_s]                      [EHL-friction]
    /// ```
    ///
    /// The first weight is 1 on nodes in contact, so that it does not depend on H_b, which is not a measured
    /// length. If no film is below H_b, the first weight is the second times e^(H_b/h_b), and so is the difference
    /// between the friction and the film friction.
    pub(crate) fn friction(
        &self,
        nodes: impl Iterator<Item = ShearedNode>,
        films: BoundaryFilms,
    ) -> Friction {
        cite!("Limited-Eyring");
        cite!("EHL-friction");
        let (layer, mu_b) = (self.boundary_layer.si(), self.boundary_friction);
        let (mut sum, mut load) = (Friction::default(), 0.0);
        for node in nodes.filter(|node| node.pressure > 0.0) {
            let (weight, pressure, film) = (node.weight, node.pressure, node.film);
            let stress = weight * node.stress;
            let boundary = weight * mu_b * pressure;
            let mixed = |share: f64| share * boundary + (1.0 - share) * stress;
            let shifted = self.shifted_weight(film, films);
            load += weight * pressure;
            sum.film += stress;
            sum.shifted += mixed(shifted);
            sum.graded += mixed((-film / layer).exp());
            sum.boundary_share += shifted * weight * pressure;
            sum.stepped += if film <= films.solid {
                boundary
            } else {
                stress
            };
        }
        let per_load = if load > 0.0 { 1.0 / load } else { 0.0 };
        Friction {
            film: sum.film * per_load,
            shifted: sum.shifted * per_load,
            graded: sum.graded * per_load,
            stepped: sum.stepped * per_load,
            boundary_share: sum.boundary_share * per_load,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> FrictionLaw {
        FrictionLaw {
            viscosity: DynamicViscosity::from_si(0.01),
            pressure_viscosity: PressureViscosity::from_si(1.8e-8),
            eyring_stress: Pressure::from_si(5e6),
            limiting_stress: Pressure::from_si(2e6),
            limiting_slope: 0.05,
            boundary_friction: 0.1,
            boundary_layer: Length::from_si(10e-9),
        }
    }

    #[test]
    fn the_stress_is_newtonian_then_eyring_then_limited() {
        let law = law();
        assert!((law.film_stress(0.0, 1e6) / 1e4 - 1.0).abs() < 1e-4);
        // η = 0.01·e^5.4 = 2.2141 Pa s; 4.43e6/5e6: τ_E = 5e6·arsinh(0.8856).
        let eyring = 5e6 * 0.885_63_f64.asinh();
        let limit: f64 = 2e6 + 0.05 * 0.3e9;
        let expected = eyring * (1.0 + (eyring / limit).powi(4)).powf(-0.25);
        assert!((law.film_stress(0.3e9, 2e6) / expected - 1.0).abs() < 1e-4);
        assert!((law.film_stress(3e9, 1e8) / (2e6 + 0.15e9) - 1.0).abs() < 0.2);
        assert!(law.film_stress(1e300, 1e8).is_finite());
    }

    #[test]
    fn boundary_friction_is_whole_on_nodes_in_contact_and_fades_above_them() {
        let law = law();
        let of = |film: f64, contact: f64| {
            let films = BoundaryFilms {
                contact,
                solid: 20e-9,
            };
            let node = ShearedNode {
                weight: 1.0,
                pressure: 1e9,
                film,
                stress: law.sheared(1e9, 1.0, film),
            };
            law.friction([node].into_iter(), films)
        };
        let in_contact = of(5e-9, 5e-9);
        assert_eq!(in_contact.shifted, 0.1);
        assert_eq!(in_contact.stepped, 0.1);
        assert_eq!(in_contact.boundary_share, 1.0);
        // A film below the contact film carries no more than its load.
        assert_eq!(of(1e-9, 5e-9).shifted, 0.1);
        assert_eq!(of(0.0, 5e-9).graded, 0.1);
        let above = of(12e-9, 5e-9);
        assert!((above.boundary_share - (-0.7_f64).exp()).abs() < 1e-12);
        // The identity that takes a friction of one weight to the other.
        let identity = above.film + (above.graded - above.film) * 0.5_f64.exp();
        assert!((above.shifted - identity).abs() < 1e-12, "{above:?}");
        assert_ne!(above.shifted, above.graded);
    }
}
