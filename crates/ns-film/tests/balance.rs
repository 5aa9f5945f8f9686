//! Flow, momentum and shear of the film are in balance.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use crate::common::close;
use asperity_core::quantity::{Angle, Density, DynamicViscosity, Length, Speed};
use asperity_ns_film::paper::{LocalFlow, PaperFilm, radial_momentum};
use asperity_ns_film::reynolds_cross::FilmSection;
use asperity_ns_film::velocity_profile::VelocityProfile;

fn section() -> FilmSection {
    FilmSection {
        wall_1: Speed::from_si(5.0),
        wall_2: Speed::from_si(3.0),
        thickness: Length::from_si(2e-6),
        slope: 0.004,
        flow: 6e-6,
        viscosity: DynamicViscosity::from_si(0.1),
        density: Density::from_si(900.0),
        radius: Length::from_si(0.03),
    }
}

#[test]
fn the_parabola_that_conserves_flow_obeys_reynolds() {
    let s = section();
    let across = s.cross_film().unwrap();
    close(across.profile.flow(), s.flow, 1e-14);
    // Stokes along the film: dp/dx = η·d²u/dy² = 2·η·A.
    let [a, _, _] = across.profile.coefficients().unwrap();
    close(across.pressure_gradient, 2.0 * 0.1 * a, 1e-12);
}

#[test]
fn shear_and_pressure_balance_on_a_slice_of_film() {
    let s = section();
    let across = s.cross_film().unwrap();
    let difference = across.wall_shear_1 - across.wall_shear_2;
    close(difference.si(), 2e-6 * across.pressure_gradient, 1e-12);
    for (height, shear) in [(2e-6, across.wall_shear_1), (0.0, across.wall_shear_2)] {
        let rate = across.profile.shear_rate(Length::from_si(height)).unwrap();
        close(shear.si(), 0.1 * rate, 1e-12);
    }
}

#[test]
fn the_tilted_wall_is_in_balance() {
    // Across the film p₁ − p₂ = η·(∂v/∂y at wall 1 − at wall 2) with ∂v/∂y = −∂u/∂x from
    // continuity; ∂u/∂x by a central difference of the parabolas of two neighbouring sections.
    let s = section();
    let dx = 1e-9;
    let u_at = |x: f64, y: f64| {
        let h = Length::from_si(2e-6 + 0.004 * x);
        let profile = VelocityProfile::carrying(s.flow, s.wall_1, s.wall_2, h).unwrap();
        let [a, b, c] = profile.coefficients().unwrap();
        (a * y + b) * y + c
    };
    let stretch = |y: f64| (u_at(dx, y) - u_at(-dx, y)) / (2.0 * dx);
    let expected = 0.1 * (stretch(0.0) - stretch(2e-6));
    let got = s.cross_film().unwrap().difference - s.centrifugal_difference().unwrap();
    // Error of the difference (h'·dx/h)², 4e-12, and cancellation 1e-9.
    close(got.si(), expected, 1e-7);
}

/// A paper film in which every term counts.
fn paper_film(angle: f64) -> PaperFilm {
    PaperFilm {
        profile: VelocityProfile {
            wall_1: Speed::from_si(5.0),
            middle: Speed::from_si(4.5),
            wall_2: Speed::from_si(3.0),
            thickness: Length::from_si(1e-4),
        },
        radius_1: Length::from_si(0.014),
        radius_2: Length::from_si(0.035),
        least_gap: Length::from_si(1e-4),
        angle: Angle::from_si(angle),
        base_radius: Length::from_si(0.033),
        density: Density::from_si(998.0),
        viscosity: DynamicViscosity::from_si(0.0975),
    }
}

fn along(angle: f64) -> f64 {
    let film = paper_film(angle);
    let [a, b, c] = film.profile.coefficients().unwrap();
    let h = film.gap().unwrap().si();
    (a * h + b) * h + c
}

fn radial(angle: f64, r: f64) -> f64 {
    let film = paper_film(angle);
    film.radial_velocity(Length::from_si(r)).unwrap().si()
}

const R: f64 = 0.0352;
const THETA: f64 = 0.02;

fn central(f: impl Fn(f64) -> f64, at: f64, step: f64) -> f64 {
    (f(at + step) - f(at - step)) / (2.0 * step)
}

#[test]
fn the_papers_velocities_conserve_mass() {
    // ∂(r·u_r)/∂r + ∂u_θ/∂θ = 0.
    let outward = central(|r| r * radial(THETA, r), R, 1e-6);
    let turning = central(along, THETA, 1e-5);
    assert!((outward + turning).abs() < 1e-5 * turning.abs());
}

#[test]
fn the_papers_gradient_is_the_radial_momentum_of_its_own_velocities() {
    let second = |f: &dyn Fn(f64) -> f64, at: f64, step: f64| {
        (f(at + step) - 2.0 * f(at) + f(at - step)) / (step * step)
    };
    let flow = LocalFlow {
        radius: R,
        along: along(THETA),
        along_theta: central(along, THETA, 1e-5),
        radial: radial(THETA, R),
        radial_r: central(|r| radial(THETA, r), R, 1e-6),
        radial_rr: second(&|r| radial(THETA, r), R, 1e-5),
        radial_theta: central(|t| radial(t, R), THETA, 1e-5),
        radial_theta_theta: second(&|t| radial(t, R), THETA, 1e-4),
    };
    let film = paper_film(THETA);
    let closed = film.pressure_gradient(Length::from_si(R)).unwrap();
    let momentum = radial_momentum(&flow, film.density, film.viscosity).unwrap();
    // Differences of second order with steps of 1e-4 to 1e-6 of the scale.
    close(closed, momentum, 1e-5);
    // The viscous part alone, which the inertia would hide.
    let light = Density::from_si(1e-9);
    let viscous = PaperFilm {
        density: light,
        ..film
    };
    let closed = viscous.pressure_gradient(Length::from_si(R)).unwrap();
    let momentum = radial_momentum(&flow, light, film.viscosity).unwrap();
    close(closed, momentum, 1e-4);
}

#[test]
fn the_papers_difference_is_the_integral_of_its_gradient() {
    let film = paper_film(THETA);
    let (r2, h) = (0.035, film.gap().unwrap().si());
    // Simpson's rule over a gap of a hundredth of the radius: exact to 1e-12.
    let n = 100;
    let sum: f64 = (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n {
                1.0
            } else {
                2.0 + 2.0 * f64::from(i % 2)
            };
            let r = Length::from_si(r2 + h * f64::from(i) / f64::from(n));
            weight * film.pressure_gradient(r).unwrap()
        })
        .sum();
    let integral = sum * h / (3.0 * f64::from(n));
    close(film.pressure_difference().unwrap().si(), integral, 1e-10);
}

#[test]
fn the_radial_momentum_is_its_terms_added_by_hand() {
    let flow = LocalFlow {
        radius: 0.5,
        along: 3.0,
        along_theta: 0.7,
        radial: 0.4,
        radial_r: 1.1,
        radial_rr: 5.0,
        radial_theta: 0.25,
        radial_theta_theta: 0.9,
    };
    // 9/0.5 - 0.4·1.1 - 6·0.25 = 16.06; 5 + 2.2 + 3.6 - 1.6 - 5.6 = 3.6
    let found = radial_momentum(
        &flow,
        Density::from_si(2.0),
        DynamicViscosity::from_si(10.0),
    );
    close(found.unwrap(), 2.0 * 16.06 + 10.0 * 3.6, 1e-12);
}

#[test]
fn a_thick_film_adds_the_centrifugal_force_over_its_height() {
    for flow in [1.0, 1.4] {
        let section = FilmSection {
            flow: flow * section().flow,
            ..section()
        };
        let (h, r) = (section.thickness, section.radius.si());
        let profile =
            VelocityProfile::carrying(section.flow, section.wall_1, section.wall_2, h).unwrap();
        let count = 4000;
        let terms = (0..count).map(|k| {
            let y = (f64::from(k) + 0.5) / f64::from(count) * h.si();
            profile.speed(Length::from_si(y)).unwrap().si().powi(2) / (r + y)
        });
        let expected = section.density.si() * terms.sum::<f64>() * h.si() / f64::from(count);
        let found = section.centrifugal_difference_thick().unwrap().si();
        close(found, expected, 1e-6);
    }
}
