//! The measured form of a flank as relief of the load map.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use crate::reference::{golden, unmodified};
use asperity_core::quantity::Length;
use asperity_gear::{
    AmountDirection, GearError, GearPair, LoadLaw, MeasuredForm, MicroGeometry, Relief,
    ReliefExtent, ReliefShape,
};

/// The form over the roll length of gear `gear` that has the heights `height` at the distance ρ from the tip end of
/// the active flank; sampled finely from root to tip.
fn form(pair: &GearPair, gear: usize, height: impl Fn(f64) -> f64) -> MeasuredForm {
    const POINTS: usize = 2000;
    let path = pair.path();
    let at = |s: Length| match gear {
        0 => s.si(),
        _ => (path.t1t2 - s).si().abs(),
    };
    let (low, high) = (at(path.a).min(at(path.e)), at(path.a).max(at(path.e)));
    // Roll lengths of a ring grow towards its root.
    let tip = if pair.internal && gear == 1 {
        low
    } else {
        high
    };
    let roll = |k: usize| low + (high - low) * k as f64 / (POINTS - 1) as f64;
    MeasuredForm {
        roll_length: (0..POINTS).map(|k| Length::from_si(roll(k))).collect(),
        height: (0..POINTS)
            .map(|k| Length::from_si(height((tip - roll(k)).abs())))
            .collect(),
    }
}

fn drawn(gear: usize, amount: f64, length: f64, shape: ReliefShape) -> MicroGeometry {
    let mut micro = MicroGeometry {
        direction: AmountDirection::Normal,
        ..MicroGeometry::default()
    };
    micro.tip_relief[gear] = Some(Relief {
        amount: Length::from_si(amount),
        extent: ReliefExtent::RollLength(Length::from_si(length)),
        shape,
    });
    micro
}

#[test]
fn a_measured_form_acts_as_the_relief_it_shows() {
    let (amount, golden) = (12e-6, golden());
    let cases = golden.cases().into_iter().chain(golden.rings());
    for case in cases {
        let pair = case.pair();
        for (gear, shape, power) in [(0, ReliefShape::Linear, 1), (1, ReliefShape::Parabolic, 2)] {
            let length = 0.4 * (pair.path().e - pair.path().a).si();
            // Any constant is left out: the gears turn by it.
            let height =
                |from_tip: f64| 3e-6 - amount * (1.0 - from_tip / length).max(0.0).powi(power);
            let mut micro = MicroGeometry::default();
            micro.measured[gear] = Some(form(&pair, gear, height));
            let [measured, drawn] = [micro, drawn(gear, amount, length, shape)]
                .map(|micro| case.elastic(&micro).loss_factor());
            let none = case.elastic(&unmodified()).loss_factor();
            assert!(
                (measured / drawn - 1.0).abs() < 1e-3,
                "{} {gear}: {measured} {drawn}",
                case.name
            );
            assert!(
                (drawn / none - 1.0).abs() > 3e-3,
                "{}: the relief counts",
                case.name
            );
        }
    }
}

#[test]
fn a_level_form_changes_nothing_and_a_broken_one_is_refused() {
    let case = golden().case("fzg-c");
    let pair = case.pair();
    let level = |height: f64| MicroGeometry {
        measured: [0, 1].map(|gear| Some(form(&pair, gear, |_| height))),
        ..MicroGeometry::default()
    };
    let none = case.elastic(&unmodified());
    for height in [0.0, 1e-5] {
        let found = case.elastic(&level(height));
        assert!((found.loss_factor() / none.loss_factor() - 1.0).abs() < 1e-12);
        assert!(found.micro_geometry().relieves_profile());
    }
    let refused = |change: &dyn Fn(&mut MeasuredForm)| {
        let mut micro = level(0.0);
        change(micro.measured[0].as_mut().unwrap());
        let settings = Default::default();
        let materials = [crate::reference::steel(); 2];
        let made = asperity_gear::LoadMap::new(
            &pair,
            case.torque(),
            &LoadLaw::Elastic,
            &micro,
            &materials,
            &settings,
        );
        matches!(made, Err(GearError::Domain(_)))
    };
    assert!(refused(&|form| form.roll_length.swap(3, 4)));
    assert!(refused(&|form| form.height.truncate(5)));
    assert!(refused(&|form| form.height[7] = Length::from_si(f64::NAN)));
    assert!(refused(&|form| {
        form.height.clear();
        form.roll_length.clear();
    }));
}

#[test]
fn the_mean_of_forms_is_taken_where_all_of_them_are() {
    let at = |values: &[f64]| {
        values
            .iter()
            .map(|v| Length::from_si(*v))
            .collect::<Vec<_>>()
    };
    let one = MeasuredForm {
        roll_length: at(&[1.0, 2.0, 3.0]),
        height: at(&[0.0, 1.0, 4.0]),
    };
    let other = MeasuredForm {
        roll_length: at(&[1.5, 3.5]),
        height: at(&[2.0, 6.0]),
    };
    let mean = MeasuredForm::mean(&[one.clone(), other.clone()]).unwrap();
    assert_eq!(mean.roll_length, at(&[2.0, 3.0]));
    assert_eq!(mean.height, at(&[0.5 * (1.0 + 3.0), 0.5 * (4.0 + 5.0)]));
    assert_eq!(
        MeasuredForm::mean(std::slice::from_ref(&one)),
        Some(one.clone())
    );
    assert_eq!(MeasuredForm::mean(&[]), None);
    let beside = MeasuredForm {
        roll_length: at(&[7.0, 8.0]),
        ..other
    };
    assert_eq!(MeasuredForm::mean(&[one, beside]), None);
}
