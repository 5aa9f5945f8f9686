//! Factors of the steady solutions on the formulas of smooth films.

use asperity_core::quantity::Length;
use asperity_ehl_regime::steady_film::{FACTORS, LOADS, MATERIALS, factors, steady_film};
use asperity_ehl_regime::{FilmGroups, MoesNumbers};

fn at(load: f64, material: f64) -> [f64; 3] {
    factors(&MoesNumbers { load, material })
}

#[test]
fn factors_are_those_of_the_table_at_its_numbers() {
    for (load, row) in LOADS.iter().zip(&FACTORS) {
        for (material, expected) in MATERIALS.iter().zip(row) {
            for (found, expected) in at(*load, *material).iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < 1e-12, "{load} {material}");
            }
        }
    }
}

#[test]
fn the_film_has_no_kink_over_load_and_material() {
    let no_kink = |all: Vec<[f64; 3]>| {
        for three in all.windows(3) {
            for k in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|i| three[i][k].ln());
                // In steps of a hundredth of ln M or ln L.
                assert!((a - 2.0 * b + c).abs() < 1e-3, "{three:?}");
            }
        }
    };
    let steps = |from: i32, to: i32| (from..to).map(|k| (0.01 * f64::from(k)).exp());
    for material in [0.5, 1.5, 4.4, 6.0, 11.0, 16.0, 25.0] {
        no_kink(steps(-500, 900).map(|load| at(load, material)).collect());
    }
    for load in [0.05, 0.3, 1.2, 5.0, 30.0, 600.0] {
        no_kink(steps(1, 309).map(|material| at(load, material)).collect());
    }
}

#[test]
fn a_rigid_contact_has_martins_film() {
    // h = 4.9 U/W R of rigid cylinders in an oil without pressure-viscosity, to which the solution at the lowest M and L is next; below
    // it the film stays in proportion to 1/W.
    let speed = 1e-12_f64;
    for load in [0.1, 0.01, 1e-3] {
        let groups = FilmGroups {
            material: 1.0 / (2.0 * speed).sqrt().sqrt(),
            speed,
            load: load * (2.0 * speed).sqrt(),
        };
        let films = steady_film(&groups, Length::from_si(1.0)).unwrap();
        for film in films {
            let ratio = film.si() / (4.9 * speed / groups.load);
            assert!((ratio - 1.0).abs() < 0.03, "{load}: {ratio}");
        }
    }
}

/// Load of a rigid parabola h = 1 + x²/2 in an oil without pressure-viscosity between ridges of the standard deviation `sigma`, up to
/// a factor: −∫ x p′ dx with p′ ∝ (h − h_e)(1 + 6 σ²/h²)/h³ up to the exit, where the pressure and its slope are 0.
fn rigid_load(sigma: f64) -> f64 {
    let up_to = |exit: f64| {
        const STEPS: i32 = 4000;
        // x = √2 tan t
        let (begin, end) = (
            1e-4 - std::f64::consts::FRAC_PI_2,
            (exit / 2.0_f64.sqrt()).atan(),
        );
        let width = (end - begin) / f64::from(STEPS);
        let at_exit = 1.0 + 0.5 * exit * exit;
        let mut sums = [0.0; 2];
        for k in 0..STEPS {
            let t = begin + width * (f64::from(k) + 0.5);
            let x = 2.0_f64.sqrt() * t.tan();
            let h = 1.0 + 0.5 * x * x;
            let rise = (h - at_exit) * (1.0 + 6.0 * (sigma / h).powi(2)) / h.powi(3);
            let part = rise * 2.0_f64.sqrt() / t.cos().powi(2) * width;
            sums[0] += part;
            sums[1] -= x * part;
        }
        sums
    };
    let (mut low, mut high) = (0.0, 3.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if up_to(middle)[0] > 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    up_to(low)[1]
}

#[test]
fn ridges_raise_the_gap_of_a_rigid_contact_by_reynolds_equation() {
    // The load is in proportion to 1/h: the smooth film h_s of the same load is W₀/W, and C is of σ = h_s.
    let smooth = rigid_load(0.0);
    let (mut low, mut high) = (0.1, 1.0);
    for _ in 0..40 {
        let sigma: f64 = 0.5 * (low + high);
        if sigma < smooth / rigid_load(sigma) {
            low = sigma
        } else {
            high = sigma
        }
    }
    let rise = (rigid_load(low) / smooth).powi(2) - 1.0;
    let found = at(0.1, 1.0)[2];
    println!("{rise:.4} {found:.4}");
    assert!((found / rise - 1.0).abs() < 0.01, "{found} {rise}");
}
