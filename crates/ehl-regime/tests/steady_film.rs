//! Factors of the steady solutions on the formulas of smooth films.

use asperity_core::quantity::Length;
use asperity_ehl_regime::steady_film::{FACTORS, LOADS, MATERIALS, factors, steady_film};
use asperity_ehl_regime::{FilmGroups, MoesNumbers};

fn at(load: f64, material: f64) -> [f64; 2] {
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
    let no_kink = |all: Vec<[f64; 2]>| {
        for three in all.windows(3) {
            for k in 0..2 {
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
