//! The rough contact of a patch against that of lines.

use asperity_contact::SolverSettings;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_mixed_film::{ContactTable, PatchWindow, RoughContact};

const COLUMNS: usize = 300;
const LOAD: f64 = 2e5;

/// Heights of a trace whose waves have phases that depend on `phase`, rms 0.16 µm.
fn trace(phase: f64) -> Vec<f64> {
    let height = |i: usize| {
        let waves = (4..60).map(|k| {
            let k = f64::from(k);
            k.powf(-1.3)
                * (std::f64::consts::TAU * k * i as f64 / COLUMNS as f64 + k * k + phase * k).cos()
        });
        0.8e-6 * waves.sum::<f64>()
    };
    (0..COLUMNS).map(height).collect()
}

fn window(composite: &[f64]) -> PatchWindow<'_> {
    PatchWindow {
        composite,
        columns: COLUMNS,
        rows: composite.len() / COLUMNS,
        spacings: [1.5e-6, 4e-6].map(Length::from_si),
        load: LineLoad::from_si(LOAD),
        radius: Length::from_si(10e-3),
        modulus: Pressure::from_si(115e9),
        flow_pressure: Pressure::from_si(7e9),
        settings: SolverSettings {
            tolerance: 1e-11,
            ..SolverSettings::default()
        },
    }
}

#[test]
fn a_patch_constant_along_the_lead_is_its_line() {
    let line = trace(0.0);
    let patch = line.repeat(4);
    let [mut of_line, mut of_patch] =
        [&line, &patch].map(|heights| RoughContact::of_patch(&window(heights)).unwrap());
    let [first, touch] = [&of_line, &of_patch].map(|contact| contact.first_touch_gap().si());
    assert!((touch / first - 1.0).abs() < 1e-12);
    let [one, all] = [&mut of_line, &mut of_patch]
        .map(|contact| [0.03, 0.4, 0.99].map(|share| contact.at(share).unwrap()));
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-8;
    for (one, all) in one.iter().zip(&all) {
        assert!(close(all.mean_gap.si(), one.mean_gap.si()));
        assert!(close(all.area, one.area));
        assert!(close(all.max_pressure.si(), one.max_pressure.si()));
        assert!((all.dissipated - one.dissipated).si().abs() <= 1e-8 * one.dissipated.si());
        // Round-off gives a ridge several peaks along the lead; together they are the spot of the line.
        let mut loads = vec![0.0; one.spots.len()];
        for spot in &all.spots {
            assert!(spot.length.si() > 1e3 * 16e-6);
            let same = one.spots.iter().position(|of_line| {
                close(spot.joint_load.si(), of_line.joint_load.si())
                    && close(spot.width.si(), of_line.width.si())
            });
            loads[same.unwrap()] += spot.load.si();
        }
        for (load, spot) in loads.iter().zip(&one.spots) {
            assert!(
                (load - spot.load.si()).abs() < 1e-8 * LOAD,
                "{load} {spot:?}"
            );
        }
    }
}

#[test]
fn a_patch_with_crests_of_several_heights_carries_more_at_a_gap_than_its_lines() {
    let rows: Vec<Vec<f64>> = (0..6).map(|row| trace(2.0 * f64::from(row))).collect();
    let share = |heights: &[f64]| {
        let contact = || RoughContact::of_patch(&window(heights));
        let table = ContactTable::new(&contact().unwrap());
        table
            .share_at_gap(Length::from_si(0.25e-6), contact)
            .unwrap()
    };
    let of_patch = share(&rows.concat());
    let of_lines = rows.iter().map(|row| share(row)).sum::<f64>() / 6.0;
    assert!(of_patch > 2.0 * of_lines, "{of_patch} {of_lines}");
    assert!(
        RoughContact::of_patch(&PatchWindow {
            rows: 5,
            ..window(&rows.concat())
        })
        .is_err()
    );
}
