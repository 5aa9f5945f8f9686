//! Windows of a contact on the traces, their spacing, and the lay of the flanks.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use crate::runs::losses;
use asperity::case::{CaseInput, LoadedCase, load_with};
use asperity::core::Profile;
use asperity::core::numerics::Z_975;
use asperity::ehl_regime::Lay;
use asperity::flanks::flank_lay::{FlankLay, mean_at, two_digits, with_mean};
use asperity::flanks::placement::PlacedTrace;
use asperity::flanks::window_places as places;
use asperity::flanks::{Sheets, Window, row_place};
use asperity::quantity::Length;
use asperity::roughness::preparation::Preparation;
use asperity::roughness::surface_preparation::{PreparedSurface, prepare_surface};

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
    assert!(
        near(row_place(0, 0), 0.2)
            && near(
                row_place(5, 1),
                (0.24_f64 + 0.618_033_988_749_894_9).fract()
            )
    );
    // Every eighth of both traces is met twice by 16 windows.
    for body in [0, 1] {
        let mut met = [0; 8];
        (0..16).for_each(|k| met[(8.0 * places(k, 16, 5)[body]) as usize] += 1);
        assert!(met.iter().all(|count| (1..=3).contains(count)), "{met:?}");
    }
}

/// A flank of waves from 3 to 240 µm, in points `spacing` µm apart.
fn flank(spacing: f64, seed: f64) -> Profile {
    let points = (3000.0 / spacing) as usize + 1;
    let height = |i: usize| {
        let x = i as f64 * spacing;
        let waves = (0..90).map(|k| {
            let length = 3.0 * 1.05_f64.powi(k);
            let phase = seed * f64::from(k * k + 1);
            0.02e-6 * (length / 20.0).sqrt() * (TAU * x / length + phase).sin()
        });
        waves.sum()
    };
    let spacing = Length::from_si(1e-6 * spacing);
    Profile::new(spacing, (0..points).map(height).collect()).unwrap()
}

#[test]
fn a_finer_trace_of_the_same_flank_loses_the_same() {
    let few = |input: &mut CaseInput| {
        input.set("model.positions", "4").unwrap();
        input.set("model.offsets", "4").unwrap();
    };
    let case = load_with(Path::new("../../fixtures/cases/e-drive.toml"), &few).unwrap();
    let measured = |spacings: [f64; 2], keys: &[(&str, &str)]| {
        let names = ["pinion.csv", "wheel.csv"].map(PathBuf::from);
        let seeds = [0.37, 0.71];
        let traces = [0, 1].map(|k: usize| (names[k].clone(), flank(spacings[k], seeds[k])));
        let changed = case.holding(&traces).with(|input| {
            input.set("surface.pinion.file", "\"pinion.csv\"").unwrap();
            input.set("surface.wheel.file", "\"wheel.csv\"").unwrap();
            for (key, value) in keys {
                input.set(key, value).unwrap();
            }
        });
        let changed = changed.unwrap();
        let spacing = changed.surfaces.traces().unwrap()[0].spacing();
        (changed, 1e6 * spacing.si())
    };
    let loss = |case: &LoadedCase| losses(case).unwrap().summary.loss_w;
    let near = |a: f64, b: f64, part: f64| (a / b - 1.0).abs() < part;
    let (usual, spacing) = measured([0.5; 2], &[]);
    assert!(near(spacing, 0.5, 1e-9), "{spacing}");
    let usual = loss(&usual);
    // A fifth of λs; the filter is a sum over other points.
    for spacings in [[0.3; 2], [0.25; 2], [0.0625; 2], [0.125, 0.5], [0.2, 0.3]] {
        let (finer, spacing) = measured(spacings, &[]);
        assert!(near(spacing, 0.5, 1e-9), "{spacings:?}: {spacing}");
        let warned = finer.warnings.iter().any(|warning| warning.code == "W119");
        assert!(!warned, "{spacings:?}");
        let finer = loss(&finer);
        assert!(near(finer, usual, 1e-3), "{spacings:?}: {finer} {usual}");
    }
    // The coarser trace takes the points of the finer where both are coarser than the rule.
    let (coarser, spacing) = measured([0.6, 0.8], &[]);
    assert!(near(spacing, 0.6, 1e-9), "{spacing}");
    let told = |warning: &asperity::core::message::Warning| warning.code == "W119";
    assert!(coarser.warnings.iter().any(told));
    // A longer and a shorter λs, none, and a contact so narrow that it needs the points.
    for (cutoff, common) in [("\"8 um\"", 0.5), ("\"1.3 um\"", 0.26), ("\"0 um\"", 0.25)] {
        let keys = [("surface.noise_cutoff", cutoff)];
        assert!(near(measured([0.25; 2], &keys).1, common, 1e-9));
    }
    let small = [("operation.torque", "\"4 N m\"")];
    let (narrow, spacing) = measured([0.0625; 2], &small);
    assert!(spacing < 0.3, "{spacing}");
    // The points follow a change of the torque.
    let wide = narrow.with_key("operation.torque", "145 N m").unwrap();
    let spacing = wide.surfaces.traces().unwrap()[0].spacing();
    assert!(near(1e6 * spacing.si(), 0.5, 1e-9));
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

/// Points and rows of a made surface, 1 and 2 um apart.
const SIZE: [usize; 2] = [600, 90];

/// Heights without order, from the middle bits of products.
fn random(k: usize) -> f64 {
    let bits = (k as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let bits = (bits ^ (bits >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((bits >> 40) as f64 / (1_u64 << 24) as f64 - 0.5) * 1e-7
}

fn surface(height: &dyn Fn(usize, usize) -> f64) -> PreparedSurface {
    let [columns, rows] = SIZE;
    let z: Vec<f64> = (0..columns * rows)
        .map(|k| height(k % columns, k / columns))
        .collect();
    let recipe = Preparation {
        lambda_s: None,
        lambda_c: None,
        ..Preparation::default()
    };
    let spacings = [1e-6, 2e-6].map(Length::from_si);
    prepare_surface(&z, columns, spacings, &recipe).unwrap()
}

#[test]
fn rows_of_a_sheet_are_independent_beyond_their_waves() {
    let rows = |every: usize| {
        let rough = |seed: usize| surface(&|x, y| random(x + SIZE[0] * (y / every) + seed));
        let sheets = Sheets::new([rough(0), rough(1 << 20)], Length::from_si(1e-6)).unwrap();
        let of = sheets.independent_rows(Length::from_si(20e-6)).unwrap();
        of / sheets.rows() as f64
    };
    // Rows without relation, bands of six equal rows, correlated as they overlap, and ridges.
    assert!((rows(1) - 1.0).abs() < 0.1, "{}", rows(1));
    let overlap: f64 = (-5..=5)
        .map(|y: i32| (1.0 - f64::from(y.abs()) / 6.0).powi(2))
        .sum();
    assert!((rows(6) * overlap - 1.0).abs() < 0.2, "{}", rows(6));
    assert!((rows(1000) * (SIZE[1] - SIZE[1] / 8) as f64 - 1.0).abs() < 1e-9);
}

#[test]
fn sheets_repeat_along_the_lead_and_keep_their_variance() {
    let [columns, rows] = SIZE;
    let rough = surface(&|x, y| random(x + columns * y));
    let ridges = surface(&|x, _| random(x));
    let sheets = Sheets::new([rough, ridges], Length::from_si(1e-6)).unwrap();
    assert_eq!(sheets.spacings(), [1e-6, 2e-6].map(Length::from_si));
    assert_eq!(sheets.rows(), rows - rows / 8);
    let [(rough, _), (ridges, _)] = [0, 1].map(|body| sheets.of_body(body));
    // Ridges run on; unrelated ends keep their mean square where they overlap.
    let first = &ridges[..columns];
    let off = |z: &[f64]| {
        let both = z.iter().zip(first);
        both.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()))
    };
    assert!(ridges.chunks(columns).all(|row| off(row) < 1e-20));
    let square = |z: &[f64]| z.iter().map(|z| z * z).sum::<f64>() / z.len() as f64;
    let (overlap, rest) = rough.split_at(rows / 8 * columns);
    assert!((square(overlap) / square(rest) - 1.0).abs() < 0.03);
    // A patch is the sum of both, mirrored beyond its ends, the wheel's rows moved.
    let window = Window {
        starts: [-1, 500],
        points: 5,
    };
    let at_own_spacing = window.patch(&sheets, Length::from_si(1e-6), 7.5 / sheets.rows() as f64);
    assert_eq!(
        (at_own_spacing.starts, at_own_spacing.shift),
        ([-1, 500], 7)
    );
    let patch = sheets.composite(at_own_spacing);
    let at = |x: usize, y: usize| rough[y * columns + x];
    assert_eq!(patch[0], at(1, 0) + ridges[7 * columns + 500]);
    assert_eq!(patch[1], at(0, 0) + ridges[7 * columns + 501]);
    assert_eq!(patch[5 * 77 + 4], at(3, 77) + ridges[5 * columns + 504]);
    let finer = Window {
        starts: [9, 40],
        points: 8 * 5 + 1,
    };
    let finer = finer.patch(&sheets, Length::from_si(0.25e-6), 0.0);
    assert_eq!((finer.starts, finer.points), ([2, 10], 11));
    // At the spacing of a coarser patch both surfaces have fewer points and rows.
    let coarse = Sheets::new(
        [
            surface(&|x, y| 1e-7 * ((x as f64) / 9.0).sin() * ((y as f64) / 4.0).cos()),
            surface(&|x, _| 1e-7 * ((x as f64) / 9.0).sin()),
        ],
        Length::from_si(3e-6),
    );
    let coarse = coarse.unwrap();
    assert_eq!(coarse.of_body(0).1, 200);
    assert_eq!(coarse.rows(), 60 - 60 / 8);
    let few = Sheets::new(
        [surface(&|_, _| 0.0), surface(&|_, _| 0.0)],
        Length::from_si(20e-6),
    );
    assert!(few.unwrap_err().to_string().contains("wider part"));
}
