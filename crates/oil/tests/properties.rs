//! Properties of the lubricant laws that hold for every input.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use asperity_core::quantity::{
    DynamicViscosity, KinematicViscosity, Pressure, PressureViscosity, Temperature,
};
use asperity_oil::{AstmD341, roelands, roelands_exponent};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn oil_thins_with_temperature_and_thickens_with_pressure(
        at_100 in 3.0..50.0f64,
        steepness in 2.5..12.0f64,
        t in 260.0..400.0f64,
        p in 0.0..1.5e9f64,
        alpha in 5e-9..3e-8f64,
    ) {
        let nu = |v: f64| KinematicViscosity::from_si(v * 1e-6);
        let law = AstmD341::from_data_sheet(nu(at_100 * steepness), nu(at_100)).unwrap();
        let at = |t| law.kinematic_viscosity(Temperature::from_si(t)).unwrap().value.si();
        prop_assert!(at(t) > at(t + 1.0));
        prop_assert!(law.temperature_coefficient(Temperature::from_si(t)).unwrap().si() > 0.0);
        let (eta, alpha) = (DynamicViscosity::from_si(0.01), PressureViscosity::from_si(alpha));
        let under = |p| roelands(eta, alpha, Pressure::from_si(p)).unwrap().si();
        prop_assert!(under(p + 1e6) > under(p));
        // Roelands' form lies below Barus' exponential of the same slope while Z < 1.
        let z = roelands_exponent(eta, alpha).unwrap();
        prop_assert!(z > 1.0 || under(p) <= eta.si() * (alpha.si() * p).exp() * (1.0 + 1e-12));
    }
}
