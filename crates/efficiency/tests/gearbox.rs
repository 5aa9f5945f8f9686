//! Losses beside the mesh, against hand calculations and an independent computation (Python, double precision).

use asperity_core::quantity::{
    AngularSpeed, Density, Force, KinematicViscosity, Length, Speed, VolumeFlow,
};
use asperity_efficiency::oil_jet::jet_power;
use asperity_efficiency::rolling_bearing::{BearingConstants, BearingForm, RollingBearing};
use asperity_efficiency::shaft_seal::seal_torque;

const RPM_3000: AngularSpeed = AngularSpeed::from_si(100.0 * std::f64::consts::PI);
const NU_10: KinematicViscosity = KinematicViscosity::from_si(10e-6);

/// 6008-sized, grease, of a series of SKF's deep groove ball bearings.
const BALL: RollingBearing = RollingBearing {
    form: BearingForm::DeepGrooveBall {
        static_rating: Force::from_si(11e3),
    },
    bore: Length::from_si(40e-3),
    outside_diameter: Length::from_si(68e-3),
    constants: BearingConstants {
        r1: 4.3e-7,
        r2: 1.7,
        s1: 4.63e-3,
        s2: 4.25,
        k_z: 3.1,
        k_rs: 6e-8,
        mu_bl: 0.12,
        mu_ehl: 0.04,
    },
};

fn newtons(radial: f64, axial: f64) -> [Force; 2] {
    [Force::from_si(radial), Force::from_si(axial)]
}

#[track_caller]
fn assert_close(value: f64, expected: f64, relative: f64) {
    assert!(
        (value / expected - 1.0).abs() < relative,
        "{value} is not {expected} to {relative:e}"
    );
}

#[test]
fn a_seal_loses_what_was_computed_by_hand() {
    // 7.69e-6 · 40² · 3000 by hand.
    let torque = seal_torque(Length::from_si(40e-3)).unwrap();
    assert_close(torque.si() * RPM_3000.si(), 36.912, 1e-12);
    assert!(seal_torque(Length::from_si(0.0)).is_err());
    assert!(seal_torque(Length::from_si(f64::NAN)).is_err());
}

#[test]
fn a_jet_takes_what_was_computed_by_hand() {
    // 820 · 2.5e-3/60 · 20 · 20.4 by hand.
    let (rho, q) = (Density::from_si(820.0), VolumeFlow::from_si(2.5e-3 / 60.0));
    let speed = Speed::from_si;
    let power = jet_power(rho, q, speed(20.0), speed(0.4)).unwrap();
    assert_close(power.si(), 13.94, 1e-12);
    assert_eq!(
        jet_power(rho, q, speed(0.0), speed(40.0)).unwrap().si(),
        0.0
    );
    assert!(jet_power(rho, q, speed(20.0), speed(-0.4)).is_err());
    assert!(jet_power(rho, VolumeFlow::from_si(-1.0), speed(20.0), speed(0.4)).is_err());
}

#[test]
fn torques_of_a_deep_groove_ball_bearing_are_those_of_an_independent_computation() {
    for (axial, rolling, sliding, power) in [
        (0.0, 28.97173, 23.93106, 16.6199),
        (1000.0, 65.69444, 40.4594, 33.34921),
    ] {
        let found = BALL
            .torque(newtons(2000.0, axial), RPM_3000, NU_10)
            .unwrap();
        // Printed to seven digits.
        assert_close(found.value.rolling.si() * 1e3, rolling, 2e-7);
        assert_close(found.value.sliding.si() * 1e3, sliding, 2e-7);
        assert_close(found.value.total().si() * RPM_3000.si(), power, 2e-7);
        assert!(found.outside.is_empty());
    }
}

#[test]
fn a_bearing_in_a_bath_is_replenished() {
    let bath = RollingBearing {
        constants: BearingConstants {
            k_rs: 0.0,
            ..BALL.constants
        },
        ..BALL
    };
    let load = newtons(2000.0, 0.0);
    let starved = BALL.torque(load, RPM_3000, NU_10).unwrap().value;
    let full = bath.torque(load, RPM_3000, NU_10).unwrap().value;
    assert_eq!(starved.sliding, full.sliding);
    // exp(−6e-8 · 10 · 3000 · 108 · √(3.1/56)) by hand.
    let expected = (-6e-8 * 10.0 * 3000.0 * 108.0 * (3.1_f64 / 56.0).sqrt()).exp();
    assert_close(starved.rolling / full.rolling, expected, 1e-12);
}

#[test]
fn sliding_goes_from_broken_to_whole_film() {
    let at = |rpm: f64| {
        let speed = AngularSpeed::from_si(rpm * std::f64::consts::PI / 30.0);
        BALL.torque(newtons(2000.0, 0.0), speed, NU_10)
            .unwrap()
            .value
    };
    let (still, fast) = (at(0.0), at(1e6));
    assert_eq!(still.rolling.si(), 0.0);
    assert_close(still.sliding / fast.sliding, 0.12 / 0.04, 1e-12);
}

#[test]
fn roller_bearings_follow_their_exponents() {
    let constants = BALL.constants;
    let roller = |form, size: f64| RollingBearing {
        form,
        bore: Length::from_si(40e-3 * size),
        outside_diameter: Length::from_si(80e-3 * size),
        constants,
    };
    let still = AngularSpeed::from_si(0.0);
    let sliding = |bearing: RollingBearing, radial, axial| {
        let found = bearing
            .torque(newtons(radial, axial), still, NU_10)
            .unwrap();
        found.value.sliding.si() * 1e3 / constants.mu_bl
    };
    let cylinder = BearingForm::CylindricalRoller;
    // G_sl = S₁ d_m^0.9 F_a + S₂ d_m F_r by hand, d_m 60 mm.
    let expected = 4.63e-3 * 60_f64.powf(0.9) * 300.0 + 4.25 * 60.0 * 2000.0;
    assert_close(
        sliding(roller(cylinder, 1.0), 2000.0, 300.0),
        expected,
        1e-12,
    );
    let taper = BearingForm::TaperedRoller { axial_factor: 1.6 };
    let expected = 4.63e-3 * 60_f64.powf(0.82) * (2000.0 + 4.25 * 1.6 * 300.0);
    assert_close(sliding(roller(taper, 1.0), 2000.0, 300.0), expected, 1e-12);
    // Rolling at a speed so low that neither reduction counts: 2^2.41 and 2^2.38 of the size, 2^0.31 of the load.
    let slow = AngularSpeed::from_si(1e-6);
    let rolling = |bearing: RollingBearing, radial| {
        let found = bearing.torque(newtons(radial, 0.0), slow, NU_10).unwrap();
        found.value.rolling.si()
    };
    for (form, exponent) in [(cylinder, 2.41), (taper, 2.38)] {
        let one = rolling(roller(form, 1.0), 2000.0);
        let exact = 1e-6;
        assert_close(
            rolling(roller(form, 2.0), 2000.0) / one,
            2_f64.powf(exponent),
            exact,
        );
        assert_close(
            rolling(roller(form, 1.0), 4000.0) / one,
            2_f64.powf(0.31),
            exact,
        );
    }
}

#[test]
fn a_bearing_says_what_its_form_is_not_for() {
    let found = BALL
        .torque(newtons(2000.0, 6000.0), RPM_3000, NU_10)
        .unwrap();
    assert_eq!(found.outside[0].name, "axial load over static rating");
    let cylinder = RollingBearing {
        form: BearingForm::CylindricalRoller,
        ..BALL
    };
    let found = cylinder
        .torque(newtons(1000.0, 600.0), RPM_3000, NU_10)
        .unwrap();
    assert_eq!(found.outside[0].name, "axial over radial load");
    for (radial, axial) in [(-1.0, 0.0), (1.0, -1.0), (f64::NAN, 0.0)] {
        assert!(
            BALL.torque(newtons(radial, axial), RPM_3000, NU_10)
                .is_err()
        );
    }
    let inside_out = RollingBearing {
        bore: BALL.outside_diameter,
        ..BALL
    };
    assert!(inside_out.check().is_err());
    let without = RollingBearing {
        constants: BearingConstants {
            r1: 0.0,
            ..BALL.constants
        },
        ..BALL
    };
    assert!(without.check().is_err());
    for axial_factor in [0.0, -1.6, f64::INFINITY, f64::NAN] {
        let form = BearingForm::TaperedRoller { axial_factor };
        assert!(RollingBearing { form, ..BALL }.check().is_err());
    }
}
