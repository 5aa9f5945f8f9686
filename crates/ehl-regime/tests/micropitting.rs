//! Local specific film thickness of the micropitting rating.

use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_ehl_regime::micropitting::{OilAt, RatedContact, specific_film};

fn oil(viscosity: f64, alpha: f64) -> OilAt {
    OilAt {
        viscosity: DynamicViscosity::from_si(viscosity),
        pressure_viscosity: PressureViscosity::from_si(alpha),
    }
}

fn contact(rho: f64, p: f64, speeds: [f64; 2]) -> RatedContact {
    RatedContact {
        radius: Length::from_si(rho * 1e-3),
        pressure: Pressure::from_si(p * 1e6),
        speeds: speeds.map(Speed::from_si),
        // 206 GPa, 0.3.
        modulus: Pressure::from_si(206e9 / 0.91),
    }
}

#[test]
fn films_of_the_rating_are_those_of_an_independent_computation() {
    // (Python, double precision, printed to seven digits.)
    for (found, bulk, hot, ra, film, lambda) in [
        (
            contact(10.0, 1000.0, [5.0, 3.0]),
            oil(0.01, 1.6e-8),
            oil(0.006, 1.5e-8),
            0.5e-6,
            0.1845311,
            0.3690623,
        ),
        (
            contact(6.0, 1300.0, [2.0, 3.0]),
            oil(0.02, 1.8e-8),
            oil(0.008, 1.6e-8),
            0.4e-6,
            0.1677224,
            0.4193059,
        ),
    ] {
        let h = found.film(bulk, hot).unwrap();
        assert!((h.si() * 1e6 / film - 1.0).abs() < 3e-7, "{h}");
        let ra = Length::from_si(ra);
        let found = specific_film(h, [ra, ra]).unwrap();
        assert!((found / lambda - 1.0).abs() < 3e-7, "{found}");
    }
}

#[test]
fn flash_of_the_rating_is_that_of_an_independent_computation() {
    let found = contact(10.0, 1000.0, [5.0, 3.0])
        .flash(0.05, [12940.0; 2])
        .unwrap();
    assert!((found / 32.44577 - 1.0).abs() < 2e-7, "{found}");
    let rolling = contact(10.0, 1000.0, [4.0, 4.0]).flash(0.05, [12940.0; 2]);
    assert_eq!(rolling.unwrap(), 0.0);
}

#[test]
fn what_is_no_contact_has_no_film() {
    let whole = contact(10.0, 1000.0, [5.0, 3.0]);
    let (cold, none) = (oil(0.01, 1.6e-8), oil(0.0, 1.6e-8));
    assert!(whole.film(cold, none).is_err() && whole.film(none, cold).is_err());
    assert!(contact(0.0, 1000.0, [5.0, 3.0]).film(cold, cold).is_err());
    assert!(
        contact(10.0, f64::NAN, [5.0, 3.0])
            .film(cold, cold)
            .is_err()
    );
    assert!(whole.flash(-0.1, [12940.0; 2]).is_err());
    assert!(whole.flash(0.1, [0.0, 12940.0]).is_err());
    let (h, flat) = (Length::from_si(1e-7), Length::from_si(0.0));
    assert!(specific_film(h, [flat, flat]).is_err());
}
