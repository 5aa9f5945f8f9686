//! Scaling and monotonicity of friction and rolling.

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, SpecificHeat, Speed,
    ThermalConductivity,
};
use asperity_tribo_friction::xu::XuConditions;
use asperity_tribo_friction::{
    RoughnessReading, XuCoefficients, XuLaw, doleschel, flash_temperature, matsumoto,
    mixed_friction, rolling_force,
};
use proptest::prelude::*;

const XU: XuLaw = XuLaw {
    coefficients: XuCoefficients::XU_2005,
    roughness: RoughnessReading::AsIs,
    friction_scale: 1.0,
};

const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(235e6),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(45.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};

/// Contact, viscosity, pressure-viscosity coefficient and thermal factor of the rolling resistance.
type Rolling = (LineContact, DynamicViscosity, PressureViscosity, f64);

/// Root of b₃/q + b₄ − b₅ e^(−q), by bisection in Python.
const PEAK: f64 = 0.505195;

prop_compose! {
    fn xu_position()(
        slide_to_roll in 0.01..1.0_f64,
        pressure in 0.4..2.0_f64,
        viscosity in 5.0..150.0_f64,
        entrainment in 1.0..20.0_f64,
        radius in 0.004..0.05_f64,
        roughness in 0.0..1.0_f64,
    ) -> XuConditions {
        XuConditions {
            slide_to_roll,
            max_pressure: Pressure::from_si(pressure * 1e9),
            viscosity: DynamicViscosity::from_si(viscosity * 1e-3),
            entrainment: Speed::from_si(entrainment),
            radius: Length::from_si(radius),
            combined_roughness: Length::from_si(roughness * 1e-6),
        }
    }
}

prop_compose! {
    fn rolling_position()(
        entrainment in 0.5..30.0_f64,
        radius in 0.003..0.1_f64,
        load in 1e4..1e6_f64,
        viscosity in 5e-3..0.5_f64,
        alpha in 1e-8..3e-8_f64,
    ) -> Rolling {
        let contact = LineContact {
            load: LineLoad::from_si(load),
            radius: Length::from_si(radius),
            modulus: Pressure::from_si(115e9),
            speeds: [Speed::from_si(entrainment); 2],
            bodies: [STEEL; 2],
        };
        (contact, DynamicViscosity::from_si(viscosity), PressureViscosity::from_si(alpha), 1.0)
    }
}

proptest! {
    #[test]
    fn xu_peaks_at_the_same_product_whatever_the_rest(position in xu_position()) {
        let viscosity: f64 = position.viscosity.si() * 1e3;
        let peak = PEAK / (position.max_pressure.si() * 1e-9 * viscosity.log10());
        let mu = |factor: f64| {
            let at = XuConditions { slide_to_roll: factor * peak, ..position };
            XU.coefficient(&at).unwrap().value
        };
        // A thousandth off the peak costs 1e-6 of the value, far above rounding; PEAK's own
        // six digits are finer still.
        prop_assert!(mu(1.0) > mu(0.999) && mu(1.0) > mu(1.001));
    }

    #[test]
    fn xu_is_even_in_sliding_and_a_power_of_speed_and_radius(
        position in xu_position(),
        c in 1.1..5.0_f64,
    ) {
        let mu = |at: XuConditions| XU.coefficient(&at).unwrap().value;
        let base = mu(position);
        let b = XuCoefficients::XU_2005;
        let reversed = XuConditions { slide_to_roll: -position.slide_to_roll, ..position };
        prop_assert_eq!(mu(reversed), base);
        let faster = XuConditions { entrainment: position.entrainment * c, ..position };
        prop_assert!((mu(faster) / base / c.powf(b.b6) - 1.0).abs() < 1e-12);
        let larger = XuConditions { radius: position.radius * c, ..position };
        prop_assert!((mu(larger) / base / c.powf(b.b8) - 1.0).abs() < 1e-12);
        let smooth = XuConditions { combined_roughness: Length::from_si(0.0), ..position };
        let roughness = (position.combined_roughness.si() * 1e6).exp_m1();
        prop_assert!(((base / mu(smooth)).ln() - b.b9 * roughness).abs() < 1e-12);
    }

    #[test]
    fn rolling_resistance_is_the_published_power_of_each_input(
        position in rolling_position(),
        c in 1.1..5.0_f64,
    ) {
        let force = |(contact, eta, alpha, phi): Rolling| rolling_force(&contact, eta, alpha, phi).unwrap().si();
        let base = force(position);
        let power = |at: Rolling, exponent: f64| {
            (force(at) / base / c.powf(exponent) - 1.0).abs() < 1e-12
        };
        let (contact, eta, alpha, phi) = position;
        let other = |contact: LineContact| (contact, eta, alpha, phi);
        // The last three from R/α · (α η V_e/R)^0.658 · (w/(E′R))^0.0126.
        let powers = [
            power(other(LineContact { speeds: contact.speeds.map(|u| u * c), ..contact }), 0.658),
            power((contact, eta * c, alpha, phi), 0.658),
            power(other(LineContact { load: contact.load * c, ..contact }), 0.0126),
            power((contact, eta, alpha, c), 1.0),
            power((contact, eta, alpha * c, phi), -0.342),
            power(other(LineContact { radius: contact.radius * c, ..contact }), 0.342 - 0.0126),
            power(other(LineContact { modulus: contact.modulus * c, ..contact }), -0.0126),
        ];
        prop_assert_eq!(powers, [true; 7]);
    }

    #[test]
    fn asperity_shares_fall_as_the_film_grows(film in 1e-9..1e-5_f64, c in 1.0..10.0_f64) {
        let (thin, thick) = (Length::from_si(film), Length::from_si(film * c));
        for share in [
            matsumoto::asperity_share as fn(Length, Length) -> _,
            doleschel::asperity_share,
        ] {
            let roughness = Length::from_si(1e-6);
            let (before, after) = (share(thin, roughness).unwrap(), share(thick, roughness).unwrap());
            prop_assert!((0.0..=1.0).contains(&before));
            prop_assert!(after <= before);
        }
    }

    #[test]
    fn mixed_friction_is_linear_in_both_coefficients(
        solid in proptest::collection::vec(0.0..1e9_f64, 1..50),
        share in 0.0..1.0_f64,
        mu in 0.001..0.3_f64,
    ) {
        let dx = Length::from_si(1e-6);
        let fluid: Vec<f64> = solid.iter().map(|p| share * p).collect();
        let both = mixed_friction(dx, &solid, &fluid, mu, mu).unwrap();
        let load: f64 = solid.iter().zip(&fluid).map(|(s, f)| s + f).sum::<f64>() * dx.si();
        prop_assert!((both.total.si() - mu * load).abs() <= 1e-12 * mu * load);
        let doubled = mixed_friction(dx, &solid, &fluid, 2.0 * mu, mu).unwrap();
        prop_assert!((doubled.solid.si() - 2.0 * both.solid.si()).abs() <= 1e-12 * both.total.si());
        prop_assert_eq!(doubled.fluid, both.fluid);
    }

    #[test]
    fn flash_of_one_material_is_blok_s_difference_of_roots(
        first in 0.1..50.0_f64,
        second in 0.1..50.0_f64,
        mu in 0.01..0.2_f64,
    ) {
        let at = |first, second| {
            let contact = LineContact {
                load: LineLoad::from_si(1e5),
                radius: Length::from_si(0.01),
                modulus: Pressure::from_si(115e9),
                speeds: [first, second].map(Speed::from_si),
                bodies: [STEEL; 2],
            };
            flash_temperature(&contact, Length::from_si(1e-4), mu).unwrap()
        };
        let b = (45.0 * 7830.0 * 465.0_f64).sqrt();
        let expected = 1.11 * mu * 1e5 * (first.sqrt() - second.sqrt()).abs() / (b * 2e-4_f64.sqrt());
        // The difference of roots cancels when the speeds are nearly equal.
        prop_assert!((at(first, second) - expected).abs() < 1e-10);
        prop_assert_eq!(at(first, second), at(second, first));
    }
}
