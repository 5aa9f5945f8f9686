//! The film against closed forms and recomputed readings of the paper.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use std::f64::consts::PI;

use crate::common::close;
use asperity_core::quantity::{Angle, AngularSpeed, Density, DynamicViscosity, Length, Speed};
use asperity_ns_film::film_pressure::{Rupture, film_pressure};
use asperity_ns_film::gap::{GapShape, exact_gap, paper_gap};
use asperity_ns_film::model::wall_speed;
use asperity_ns_film::paper::{angular_pitch, base_radius};
use asperity_ns_film::reynolds_cross::FilmSection;
use asperity_ns_film::velocity_profile::VelocityProfile;
use asperity_ns_film::{
    FilmConditions, FluidModel, pressure_difference_across, pressure_difference_over_thickness,
};

/// Pinion 3000 1/min.
const OMEGA_1: f64 = 100.0 * PI;

/// The pitch point of the paper's Table 2 with one reading of its radii.
struct PitchPoint {
    r1: f64,
    r2: f64,
    rb1: f64,
    rb2: f64,
}

impl PitchPoint {
    fn new(helix_degrees: f64, r1: f64, r2: f64) -> Self {
        let cos = helix_degrees.to_radians().cos();
        let module = Length::from_si(1.3e-3 / cos);
        let angle = Angle::from_si((20f64.to_radians().tan() / cos).atan());
        let base = |z| base_radius(module, z, angle).unwrap().si();
        Self {
            r1,
            r2,
            rb1: base(50),
            rb2: base(120),
        }
    }

    /// Flank radii in the transverse section.
    fn helical() -> Self {
        Self::new(30.0, 14.540_105_461_476_728e-3, 34.896_253_107_544_15e-3)
    }

    /// Flank radii as if the gears were spur gears, as the paper's text says.
    fn spur() -> Self {
        Self::new(0.0, 11.115_654_658_084_23e-3, 26.677_571_179_402_157e-3)
    }

    fn conditions(&self, thickness: f64) -> FilmConditions {
        let (r1, r2) = (Length::from_si(self.r1), Length::from_si(self.r2));
        let speed = |omega, r| wall_speed(AngularSpeed::from_si(omega), r).unwrap();
        FilmConditions {
            wall_1: speed(OMEGA_1, r1),
            wall_2: speed(OMEGA_1 * 50.0 / 120.0, r2),
            radius_1: r1,
            radius_2: r2,
            film_thickness: Length::from_si(thickness),
            angle: Angle::from_si(0.0),
            base_radius: Length::from_si(self.rb2),
            middle_speed: None,
            viscosity: DynamicViscosity::from_si(0.0975),
            density: Density::from_si(998.0),
        }
    }

    /// The paper's film with u∞ = 0 and a parabola over H.
    fn standing(&self, thickness: f64, span: f64, base_radius: f64) -> f64 {
        let mut film = self.conditions(thickness).paper_film();
        film.profile.middle = Speed::from_si(0.0);
        film.profile.thickness = Length::from_si(span);
        film.base_radius = Length::from_si(base_radius);
        film.pressure_difference().unwrap().si()
    }
}

#[test]
fn the_papers_film_hits_the_recomputed_readings() {
    // Readings of the paper at 100 nm and 1 mm with H = r₂ + h₀ as printed and four choices of R_b,
    // recomputed independently in double precision.
    let readings = |p: &PitchPoint| [p.rb1, p.rb2, 2.0 * p.rb1, 2.0 * p.rb2];
    let helical = PitchPoint::helical();
    let spur = PitchPoint::spur();
    for (point, at_100_nm, at_1_mm) in [
        (
            &helical,
            [
                0.056_767_761_831_787_07,
                0.526_105_925_063_304_9,
                0.392_009_306_997_156_9,
                1.330_685_633_460_192_6,
            ],
            [
                406.482_317_407_725_5,
                4_141.244_133_815_026_5,
                3_074.169_329_127_225_4,
                10_543.692_961_941_828,
            ],
        ),
        (
            &spur,
            [
                0.083_044_856_146_562_64,
                0.497_349_364_791_133_73,
                0.378_976_648_035_542_04,
                1.207_585_665_324_684_4,
            ],
            [
                573.930_516_791_976_6,
                3_647.529_482_383_013,
                2_769.358_349_357_003,
                8_916.556_280_539_076,
            ],
        ),
    ] {
        for (i, base) in readings(point).into_iter().enumerate() {
            close(
                point.standing(1e-7, point.r2 + 1e-7, base),
                at_100_nm[i],
                1e-9,
            );
            close(
                point.standing(1e-3, point.r2 + 1e-3, base),
                at_1_mm[i],
                1e-9,
            );
        }
    }
    // H = film thickness and u∞ = 0: the jet in the middle makes the reading impossible.
    close(
        helical.standing(1e-7, 1e-7, helical.rb2),
        -162_770.908_159_015_8,
        1e-9,
    );
    close(
        spur.standing(1e-7, 1e-7, spur.rb2),
        -120_513.960_487_989_8,
        1e-9,
    );
    // H = film thickness and u∞ = mean speed of the walls: the choice used.
    let used = |p: &PitchPoint| {
        pressure_difference_across(FluidModel::Paper, &p.conditions(1e-7)).unwrap()
    };
    close(used(&helical).si(), 0.059_674_113_946_688_14, 1e-9);
    close(used(&spur).si(), 0.045_619_789_443_481_16, 1e-9);
}

#[test]
fn the_consistent_film_hits_the_recomputed_values() {
    // Recomputed independently in double precision.
    for (point, speed, thin, thick) in [
        (
            PitchPoint::helical(),
            4.567_908_850_019_612,
            0.059_674_199_448_826_8,
            588.351_677_938_071_9,
        ),
        (
            PitchPoint::spur(),
            3.492_085_901_367_858_5,
            0.045_619_874_960_895_306,
            447.856_355_505_838_34,
        ),
    ] {
        let film = point.conditions(1e-7);
        close(film.wall_1.si(), speed, 1e-14);
        let difference = pressure_difference_across(FluidModel::ReynoldsCross, &film).unwrap();
        close(difference.si(), thin, 1e-9);
        let section = point.conditions(1e-3).section().unwrap();
        close(
            section.centrifugal_difference_thick().unwrap().si(),
            thick,
            1e-9,
        );
    }
}

#[test]
fn across_a_thin_film_the_pressure_hardly_varies() {
    // The finding of the paper's figure 8, against the 598.54 MPa of the contact.
    let point = PitchPoint::helical();
    for model in [FluidModel::ReynoldsCross, FluidModel::Paper] {
        let film = point.conditions(1e-7);
        let at_100_nm = pressure_difference_across(model, &film).unwrap().si();
        assert!(at_100_nm.abs() <= 1.0);
        let thicknesses: Vec<f64> = (0..=50)
            .map(|i| 1e-8 * 10f64.powf(f64::from(i) / 25.0))
            .collect();
        let sweep = pressure_difference_over_thickness(model, &film, &thicknesses).unwrap();
        assert!(sweep.iter().all(|dp| dp.abs() / 598.54e6 < 1e-3));
        // Away from the line of centres as well.
        let aside = FilmConditions {
            angle: Angle::from_si(1e-4),
            ..film
        };
        let dp = pressure_difference_across(model, &aside).unwrap().si();
        assert!(dp.abs() / 598.54e6 < 1e-3, "{dp}");
    }
}

#[test]
fn across_an_elastohydrodynamic_inlet_it_stays_below_two_ten_thousandths() {
    // Grubin's inlet at the pitch point of Table 2: film 1.9582 um, pressure along the film from
    // the reduced pressure; the largest difference across was recomputed as 71 447 Pa where the
    // pressure is 400 MPa, 1.044 half widths before the middle.
    let (eta0, alpha, u, r, a) = (0.0975, 2e-8, 4.5679, 0.011_626_9, 1.206_248_7e-4);
    let h0 = 1.958_206_061_130_72e-6;
    let gap = |xi: f64| {
        let root = (xi * xi - 1.0).sqrt();
        h0 + a * a / (2.0 * r) * (xi * root - (xi + root).ln())
    };
    let slope = |xi: f64| a / r * (xi * xi - 1.0).sqrt();
    let rise = |xi: f64| 12.0 * eta0 * u * (gap(xi) - h0) / gap(xi).powi(3);
    // With ξ = 1 + t² the integrand is smooth at the edge of the contact.
    let n = 40_000;
    let dt = 59f64.sqrt() / f64::from(n);
    let step = |i: i32| {
        let t = (f64::from(i) + 0.5) * dt;
        (1.0 + t * t, 2.0 * t * a * dt)
    };
    let whole: f64 = (0..n).map(step).map(|(xi, dx)| rise(xi) * dx).sum();
    let (mut reduced, mut largest, mut at) = (0.0, 0.0, (0.0, 0.0));
    for (xi, dx) in (0..n).map(step) {
        reduced += rise(xi) * dx;
        // e^(−α·p) runs from zero at the contact to one far away.
        let thinning = reduced / whole;
        let (p, h) = (-thinning.ln() / alpha, gap(xi));
        if p > 4e8 {
            continue;
        }
        let eta = eta0 / thinning;
        let section = FilmSection {
            wall_1: Speed::from_si(u),
            wall_2: Speed::from_si(u),
            thickness: Length::from_si(h),
            slope: slope(xi),
            flow: u * h0,
            viscosity: DynamicViscosity::from_si(eta),
            density: Density::from_si(998.0),
            radius: Length::from_si(34.9e-3),
        };
        let across = section.cross_film().unwrap();
        let tilt = across.difference - section.centrifugal_difference().unwrap();
        if tilt.si() > largest {
            (largest, at) = (tilt.si(), (p, xi));
        }
    }
    // Grids differ by 1e-4 in where 400 MPa lies; the half width was rounded alike.
    close(largest, 71_446.6, 2e-3);
    close(at.1, 1.044_44, 1e-3);
    assert!(largest / at.0 < 2e-4);
}

#[test]
fn the_printed_gap_is_right_for_equal_radii_only() {
    let point = PitchPoint::helical();
    let gaps = |r1: f64, r2: f64, theta: f64| {
        let (h0, angle) = (Length::from_si(0.0), Angle::from_si(theta));
        let (r1, r2) = (Length::from_si(r1), Length::from_si(r2));
        let exact = exact_gap(h0, angle, r1, r2).unwrap().si();
        exact / paper_gap(h0, angle, r1, r2).unwrap().si()
    };
    // Recomputed with 40 digits; r₂/r₁ = 2.4 in the limit.
    close(
        gaps(point.r1, point.r2, 0.01),
        2.400_898_111_692_818_5,
        1e-9,
    );
    close(gaps(point.r1, point.r2, 1e-5), 2.4, 1e-8);
    close(gaps(0.02, 0.02, 1e-4), 1.0, 1e-7);
}

#[test]
fn parabola_and_cylinder_agree_near_the_line_of_centres() {
    let (h0, r) = (Length::from_si(1e-6), Length::from_si(0.01));
    let gap = |shape: GapShape, x: f64| shape.gap(h0, Length::from_si(x), r).unwrap().si();
    let slope = |shape: GapShape, x: f64| shape.slope(Length::from_si(x), r).unwrap();
    for x in [-3e-4, 1e-5, 2e-4] {
        // The next term of the rise is x²/4R² of it.
        let parabola = gap(GapShape::Parabola, x) - 1e-6;
        let cylinder = gap(GapShape::Cylinder, x) - 1e-6;
        assert!((cylinder / parabola - 1.0 - x * x / 4e-4).abs() < 1e-6);
        for shape in [GapShape::Parabola, GapShape::Cylinder] {
            let difference = (gap(shape, x + 1e-8) - gap(shape, x - 1e-8)) / 2e-8;
            assert!((difference - slope(shape, x)).abs() < 1e-9);
        }
    }
    // A quarter round: the exact cylinder, where the parabola has long left it.
    close(gap(GapShape::Cylinder, 0.006), 1e-6 + 0.002, 1e-14);
}

#[test]
fn the_parabola_passes_through_walls_and_middle() {
    let profile = VelocityProfile {
        wall_1: Speed::from_si(3.0),
        middle: Speed::from_si(7.0),
        wall_2: Speed::from_si(-1.0),
        thickness: Length::from_si(2e-6),
    };
    for (y, u) in [(0.0, -1.0), (1e-6, 7.0), (2e-6, 3.0)] {
        let got = profile.speed(Length::from_si(y)).unwrap().si();
        assert!((got - u).abs() < 1e-14);
    }
    assert!(profile.speed(Length::from_si(2.1e-6)).is_err());
}

#[test]
fn the_base_radius_is_half_of_what_is_printed() {
    // Pinion of Table 2: m_t 1.3/cos 30°, 50 teeth; the printed formula gives the diameter.
    let point = PitchPoint::helical();
    let m_t = 1.3e-3 / 30f64.to_radians().cos();
    let alpha_t = (20f64.to_radians().tan() / 30f64.to_radians().cos()).atan();
    close(point.rb1, 0.5 * m_t * 50.0 * alpha_t.cos(), 1e-14);
    close(point.rb2 / point.rb1, 2.4, 1e-14);
    close(angular_pitch(50).unwrap().si() * 50.0, 2.0 * PI, 1e-15);
    assert!(angular_pitch(0).is_err());
}

/// Positions s·tan γ for |γ| up to `reach`, with s = √(2·R·h₀).
fn cylinder(n: i32, reach: f64) -> (f64, Vec<f64>, Vec<f64>) {
    let (r, h0) = (0.01, 1e-6);
    let s = f64::sqrt(2.0 * r * h0);
    let x: Vec<f64> = (0..=n)
        .map(|i| s * (reach * (2.0 * f64::from(i) / f64::from(n) - 1.0)).tan())
        .collect();
    let h = x.iter().map(|x| h0 + x * x / (2.0 * r)).collect();
    (s, x, h)
}

#[test]
fn a_rigid_cylinder_carries_what_the_closed_forms_say() {
    // w/(η·ū·R/h₀): 4 for half Sommerfeld exactly; 4.894 968 and a rupture at x = 0.475 130·√(2·R·h₀)
    // for Reynolds, from the closed integrals with mpmath; 0 for full Sommerfeld.
    let (u, eta) = (Speed::from_si(2.0), DynamicViscosity::from_si(0.01));
    let unit = 0.01 * 1.0 * 0.01 / 1e-6;
    let (s, x, h) = cylinder(4000, 1.57);
    let film = |rupture| film_pressure(&x, &h, u, eta, rupture).unwrap();
    let reynolds = film(Rupture::Reynolds);
    // Second order in 4000 intervals leaves 2e-5, the cut at 1256·√(2·R·h₀) less.
    close(reynolds.load.si() / unit, 4.894_968_493_913_369, 3e-5);
    let end = reynolds.pressure.iter().rposition(|p| *p > 0.0).unwrap();
    assert!((x[end] / s - 0.475_13).abs() < 2e-3);
    assert!(reynolds.residual < 1e-9, "{}", reynolds.residual);
    // The flow is what passes the rupture without pressure, ū·h there.
    close(reynolds.flow, 1e-6 * (1.0 + 0.475_13f64.powi(2)), 1e-3);
    close(film(Rupture::HalfSommerfeld).load.si() / unit, 4.0, 3e-5);
    let full = film(Rupture::FullSommerfeld);
    assert!((full.load.si() / unit).abs() < 1e-9 && full.ruptured == 0);
}

#[test]
fn the_film_converges_with_the_square_of_the_spacing() {
    let load = |n| {
        let (_, x, h) = cylinder(n, 1.4);
        let (u, eta) = (Speed::from_si(2.0), DynamicViscosity::from_si(0.01));
        let film = film_pressure(&x, &h, u, eta, Rupture::HalfSommerfeld).unwrap();
        film.load.si()
    };
    let (coarse, middle, fine) = (load(200), load(400), load(800));
    let ratio = (coarse - middle) / (middle - fine);
    assert!((3.8..4.2).contains(&ratio), "{ratio}");
}
