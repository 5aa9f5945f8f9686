//! Windows of a contact on the traces, and the lay of the flanks.

use asperity::core::numerics::Z_975;
use asperity::ehl_regime::Lay;
use asperity::flanks::flank_lay::{FlankLay, mean_at, two_digits, with_mean};
use asperity::flanks::placement::PlacedTrace;
use asperity::flanks::window_places as places;
use asperity::quantity::Length;

#[test]
fn a_contact_finds_its_window_by_the_arc() {
    let placed = PlacedTrace {
        first_arc: 1e-3,
        direction: -1.0,
        base_radius: 50e-3,
    };
    // ρ 9 mm: l = 0.81 mm, 0.19 mm before the first point where the arc falls along x.
    let found = placed.middle(Length::from_si(9e-3), Length::from_si(1e-6));
    assert!((found - 190.0).abs() < 1e-9);
}

#[test]
fn places_nest_shift_along_the_path_and_fill_both_traces() {
    assert_eq!(places(0, 1, 0), [0.5, 0.5]);
    assert_eq!(places(0, 16, 0), places(0, 64, 0));
    assert_eq!(places(1, 16, 0), [0.25, 2.0 / 3.0]);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
    let [along, across] = places(4, 16, 2);
    let shifted = |first: f64, shift: f64| (first + 2.0 * shift).fract();
    assert!(near(along, shifted(0.625, 0.569_840_290_998_053_3)));
    assert!(near(across, shifted(7.0 / 9.0, 0.754_877_666_246_692_8)));
    // Every eighth of both traces is met twice by 16 windows.
    for body in [0, 1] {
        let mut met = [0; 8];
        (0..16).for_each(|k| met[(8.0 * places(k, 16, 5)[body]) as usize] += 1);
        assert!(met.iter().all(|count| (1..=3).contains(count)), "{met:?}");
    }
}

#[test]
fn both_flanks_move_with_their_mean() {
    let measured = FlankLay::Lognormal {
        median: 0.3,
        factor: 1.5,
    };
    let lays = [FlankLay::ASSUMED, measured];
    for z in [-1.5, 0.0, 0.7] {
        let found = with_mean(lays, mean_at(lays, z)).unwrap();
        for (lay, flank) in found.into_iter().zip(lays) {
            assert!((lay.gamma() - flank.at(z)).abs() < 1e-9);
        }
    }
    let same = with_mean([FlankLay::ASSUMED; 2], 0.1).unwrap();
    assert_eq!(same, [Lay::new(0.1).unwrap(); 2]);
}

#[test]
fn a_lognormal_lay_has_its_quantiles_and_stays_below_one() {
    let lay = FlankLay::Lognormal {
        median: 0.5,
        factor: 1.6,
    };
    assert!((lay.at(Z_975) - 0.8).abs() < 1e-12 && (lay.at(-Z_975) - 0.3125).abs() < 1e-12);
    assert_eq!(lay.at(4.0), 1.0);
}

#[test]
fn numbers_are_rounded_to_two_digits() {
    let digits = [0.09324, 0.0008765, 1.0, 0.0, 0.4449].map(two_digits);
    assert_eq!(digits, [0.093, 0.00088, 1.0, 0.0, 0.44]);
}
