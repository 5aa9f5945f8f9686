//! Fields against closed forms and balances.

use asperity_core::quantity::{Length, Pressure};

use crate::plasticity::plastic_stress;

use super::{StressField, graded_depths, hertz_stress, subsurface_stress};
use crate::ContactError;
use crate::hertz_line::HertzLine;

/// A Hertz contact of half width 1 m and pressure 1 Pa; its cells' mean pressures over |x| ≤ 3.
fn hertz_cells(cells_per_half_width: usize) -> (f64, Vec<f64>) {
    let dx = 1.0 / cells_per_half_width as f64;
    let load = |x: f64| {
        let x = x.clamp(-1.0, 1.0);
        0.5 * (x * (1.0 - x * x).sqrt() + x.asin())
    };
    let pressure = (0..6 * cells_per_half_width)
        .map(|i| -3.0 + i as f64 * dx)
        .map(|left| (load(left + dx) - load(left)) / dx)
        .collect();
    (dx, pressure)
}

fn hertz() -> HertzLine {
    HertzLine {
        half_width: Length::from_si(1.0),
        max_pressure: Pressure::from_si(1.0),
    }
}

fn field(pressure: &[f64], traction: Option<&[f64]>, dx: f64, depths: &[f64]) -> StressField {
    subsurface_stress(pressure, traction, Length::from_si(dx), depths).unwrap()
}

/// Largest difference of the field under sliding Hertz from the closed form, at 0.5 and 0.786 b.
fn error_against_mcewen(cells: usize, mu: f64) -> f64 {
    let (dx, pressure) = hertz_cells(cells);
    let traction: Vec<f64> = pressure.iter().map(|p| mu * p).collect();
    let depths = [0.5, 0.786_151];
    let field = field(&pressure, Some(&traction), dx, &depths);
    let mut worst = 0.0f64;
    for (row, &z) in depths.iter().enumerate() {
        for j in 0..field.points {
            let x = Length::from_si(-3.0 + (j as f64 + 0.5) * dx);
            let exact = hertz_stress(&hertz(), mu, x, Length::from_si(z)).unwrap();
            let at = row * field.points + j;
            for (got, exact) in [
                (field.sigma_xx[at], exact.sigma_xx),
                (field.sigma_zz[at], exact.sigma_zz),
                (field.tau_xz[at], exact.tau_xz),
            ] {
                worst = worst.max((got - exact.si()).abs());
            }
        }
    }
    worst
}

#[test]
fn the_field_of_hertz_converges_with_the_square_of_the_cell() {
    for mu in [0.0, 0.3] {
        let errors: Vec<f64> = [16, 32, 64].map(|n| error_against_mcewen(n, mu)).to_vec();
        // Second order: a factor of four a halving, within the next order of the smallest grid.
        for pair in errors.windows(2) {
            assert!(
                (3.8..4.3).contains(&(pair[0] / pair[1])),
                "{mu}: {errors:?}"
            );
        }
        assert!(errors[2] < 1e-4, "{errors:?}");
    }
}

#[test]
fn peaks_of_the_hertz_field_are_where_the_closed_form_has_them() {
    let (dx, pressure) = hertz_cells(64);
    let depths = graded_depths(Length::from_si(0.02), Length::from_si(1.0), 300).unwrap();
    let field = field(&pressure, None, dx, &depths);
    let shear = field.peak(&field.max_shear()).unwrap();
    let mises = field.peak(&field.von_mises(0.3).unwrap()).unwrap();
    // Johnson 1985 p. 103 and von Mises with ν = 0.3; the depths are 1.7 % apart, and values at a
    // maximum err with the square of that.
    assert!((shear.value.si() - 0.300_283).abs() < 1e-4);
    assert!((shear.depth.si() - 0.786_15).abs() < 0.01);
    assert!((mises.value.si() - 0.557_516).abs() < 1e-4);
    assert!((mises.depth.si() - 0.704_29).abs() < 0.01);
    // The middle lies between the points 191 and 192.
    assert!((shear.position.si() - 191.5 * dx).abs() < 0.51 * dx);
    // Tresca's is twice the shear stress in the plane as long as σ_yy lies between.
    let tresca = field.peak(&field.tresca(0.3).unwrap()).unwrap();
    assert!((tresca.value.si() - 2.0 * shear.value.si()).abs() < 1e-12);
}

#[test]
fn yield_begins_in_the_depth_of_the_largest_mises_stress() {
    let (dx, pressure) = hertz_cells(64);
    let depths = graded_depths(Length::from_si(0.02), Length::from_si(1.0), 300).unwrap();
    let field = field(&pressure, None, dx, &depths);
    let mises = field.von_mises(0.3).unwrap();
    let zone = |limit| {
        let plastic = plastic_stress(&mises, Pressure::from_si(limit)).unwrap();
        field.yield_zone(&plastic)
    };
    assert_eq!(zone(0.558), None);
    let small = zone(0.557).unwrap();
    assert!(small.shallowest.si() < 0.704 && small.deepest.si() > 0.704);
    let large = zone(0.4).unwrap();
    assert!(large.points > small.points && large.first < small.first && large.last > small.last);
}

#[test]
fn the_share_that_yields_is_the_share_by_the_closed_form_of_hertz() {
    let (dx, pressure) = hertz_cells(64);
    let depths = graded_depths(Length::from_si(0.005), Length::from_si(1.0), 300).unwrap();
    let field = field(&pressure, None, dx, &depths);
    let mises = field.von_mises(0.3).unwrap();
    // The middle lies between the points 191 and 192.
    let middle = Length::from_si(191.5 * dx);
    let half_width = Length::from_si(1.0);
    for limit in [0.3, 0.45, 0.55] {
        let plastic = plastic_stress(&mises, Pressure::from_si(limit)).unwrap();
        let share = field.yield_share(&plastic, middle, half_width);
        // Middles of cells of the section.
        let n = 200;
        let at = |k: usize| (k as f64 + 0.5) / n as f64;
        let cells = (0..n * n).map(|k| [at(k / n), at(k % n)].map(Length::from_si));
        let yields = |[x, z]: &[Length; 2]| {
            let stress = hertz_stress(&hertz(), 0.0, *x, *z).unwrap();
            stress.von_mises(0.3).unwrap().si() > limit
        };
        let exact = cells.filter(yields).count() as f64 / (n * n) as f64;
        assert!(
            exact > 0.0 && (share - exact).abs() < 4e-3,
            "{limit}: {share} {exact}"
        );
    }
    let elastic = plastic_stress(&mises, Pressure::from_si(0.56)).unwrap();
    assert_eq!(field.yield_share(&elastic, middle, half_width), 0.0);
    // A section without a point has no such share.
    let away = Length::from_si(100.0);
    assert_eq!(field.yield_share(&mises, away, half_width), 0.0);
}

#[test]
fn the_fast_field_equals_the_direct_sum() {
    let (n, dx) = (23, 0.1);
    let load = |seed: usize| -> Vec<f64> {
        (0..n)
            .map(|i| ((i * seed + 5) % 19) as f64 / 7.0 - 1.0)
            .collect()
    };
    let (p, q) = (load(7), load(11));
    let depths = [0.0, 0.03, 1.0];
    let fast = field(&p, Some(&q), dx, &depths);
    for (row, &z) in depths.iter().enumerate() {
        for i in 0..n {
            let mut sum = [0.0; 3];
            for j in 0..n {
                let x = Length::from_si((i as f64 - j as f64) * dx);
                let k =
                    super::strip_unit(x, Length::from_si(z), Length::from_si(0.5 * dx)).unwrap();
                sum[0] += k.xx_of_pressure * p[j] + k.xx_of_traction * q[j];
                sum[1] += k.zz_of_pressure * p[j] + k.xz_of_pressure * q[j];
                sum[2] += k.xz_of_pressure * p[j] + k.xx_of_pressure * q[j];
            }
            let at = row * n + i;
            // Sums of 46 terms of size 1: round-off.
            assert!((fast.sigma_xx[at] - sum[0]).abs() < 1e-13);
            assert!((fast.sigma_zz[at] - sum[1]).abs() < 1e-13);
            assert!((fast.tau_xz[at] - sum[2]).abs() < 1e-13);
        }
    }
}

#[test]
fn stress_is_linear_in_the_load() {
    let (dx, p) = hertz_cells(8);
    let q: Vec<f64> = p
        .iter()
        .rev()
        .enumerate()
        .map(|(i, p)| p * i as f64)
        .collect();
    let depths = [0.1, 0.9];
    let both = field(&p, Some(&q), dx, &depths);
    let none = vec![0.0; p.len()];
    let of_pressure = field(&p, None, dx, &depths);
    let of_traction = field(&none, Some(&q), dx, &depths);
    for at in 0..both.sigma_xx.len() {
        let sum = of_pressure.sigma_xx[at] + of_traction.sigma_xx[at];
        assert!((both.sigma_xx[at] - sum).abs() < 1e-12);
        let sum = of_pressure.tau_xz[at] + of_traction.tau_xz[at];
        assert!((both.tau_xz[at] - sum).abs() < 1e-12);
    }
}

#[test]
fn loads_of_one_resultant_are_alike_far_below() {
    // Saint-Venant: two symmetric loads of one resultant differ by a quadrupole, whose relative
    // share falls with the square of the depth.
    let n = 401;
    let mut strip = vec![0.0; n];
    strip[190..211].fill(1.0);
    let mut line = vec![0.0; n];
    line[200] = 21.0;
    let depths = [40.0, 80.0, 160.0];
    let (a, b) = (
        field(&strip, None, 1.0, &depths),
        field(&line, None, 1.0, &depths),
    );
    let share: Vec<f64> = (0..3)
        .map(|row| row * n + 200)
        .map(|at| (a.sigma_zz[at] / b.sigma_zz[at] - 1.0).abs())
        .collect();
    for pair in share.windows(2) {
        assert!((3.7..4.1).contains(&(pair[0] / pair[1])), "{share:?}");
    }
}

#[test]
fn every_depth_is_in_equilibrium() {
    // ∂σ_xx/∂x + ∂τ_xz/∂z = 0 and ∂τ_xz/∂x + ∂σ_zz/∂z = 0, by central differences over a grid of
    // equal steps: the residual falls with the square of the step.
    let residual = |cells: usize| {
        let (dx, p) = hertz_cells(cells);
        let q: Vec<f64> = p.iter().map(|p| 0.4 * p).collect();
        let f = field(&p, Some(&q), dx, &[0.6 - dx, 0.6, 0.6 + dx]);
        let n = f.points;
        (1..n - 1).fold(0.0f64, |worst, j| {
            let along = |s: &[f64]| (s[n + j + 1] - s[n + j - 1]) / (2.0 * dx);
            let down = |s: &[f64]| (s[2 * n + j] - s[j]) / (2.0 * dx);
            worst
                .max((along(&f.sigma_xx) + down(&f.tau_xz)).abs())
                .max((along(&f.tau_xz) + down(&f.sigma_zz)).abs())
        })
    };
    let (coarse, fine) = (residual(16), residual(32));
    assert!(
        fine < 2e-2 && (3.5..4.5).contains(&(coarse / fine)),
        "{coarse} {fine}"
    );
}

#[test]
fn each_depth_carries_the_whole_load() {
    // Horizontal and vertical balance of the half-plane above a cut at z: ∫σ_zz dx = −w, and
    // ∫τ_xz dx = −∫q dx, up to what lies beyond the window, (4/3π)·(z/x)³ at each side.
    let n = 2001;
    let mut p = vec![0.0; n];
    p[990..1011].fill(2.0);
    let q: Vec<f64> = p.iter().map(|p| 0.1 * p).collect();
    let f = field(&p, Some(&q), 1.0, &[5.0, 30.0]);
    for row in 0..2 {
        let normal: f64 = f.sigma_zz[row * n..(row + 1) * n].iter().sum();
        let tangential: f64 = f.tau_xz[row * n..(row + 1) * n].iter().sum();
        assert!((normal / -42.0 - 1.0).abs() < 1e-4, "{normal}");
        // Of the traction the cut loses (4/π)·z/x: it decays slowly along x.
        let lost = 4.0 / std::f64::consts::PI * f.depths[row] / 1000.0;
        assert!(
            (tangential / -4.2 - 1.0 + lost).abs() < 0.1 * lost,
            "{tangential}"
        );
    }
}

#[test]
fn a_wrong_load_is_named() {
    let call = |p: &[f64], q: Option<&[f64]>, z: &[f64]| {
        subsurface_stress(p, q, Length::from_si(1.0), z).unwrap_err()
    };
    assert!(matches!(
        call(&[1.0, 2.0], Some(&[1.0]), &[1.0]),
        ContactError::WrongLength {
            name: "traction",
            need: 2,
            got: 1
        }
    ));
    assert!(matches!(
        call(&[1.0, f64::NAN], None, &[1.0]),
        ContactError::BadElement {
            name: "pressure",
            index: 1,
            ..
        }
    ));
    assert!(matches!(
        call(&[1.0], None, &[1.0, -1.0]),
        ContactError::BadElement {
            name: "depths",
            index: 1,
            ..
        }
    ));
    assert!(matches!(
        call(&[], None, &[1.0]),
        ContactError::WrongLength {
            name: "pressure",
            ..
        }
    ));
    assert!(graded_depths(Length::from_si(4.0), Length::from_si(1.0), 5).is_err());
    for count in [0, 1, 1_000_001, usize::MAX] {
        assert!(graded_depths(Length::from_si(0.1), Length::from_si(1.0), count).is_err());
    }
}
