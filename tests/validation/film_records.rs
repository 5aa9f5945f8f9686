//! Parts of the friction of film and spots in the same windows as an independent program and as our own records.
//!
//! Thermal reduction none, ridges across the face, constants of the records, with heat, 64 windows.

use std::fmt::Write as _;

use asperity::mixed_film::{
    FilmPressure, GapRoughness, LoadShareSettings, LoadShareSolution, SpotSpeed,
};
use asperity_core::quantity::Length;
use rayon::prelude::*;

use crate::ehl_records::Windows;
use crate::ehl_records::mixed_ehl_records::{Condition, blind_conditions, conditions};

/// Windows that the parts are averaged over.
const WINDOWS: usize = 64;
/// Conditions with the means of another program over the same windows: friction, asperity share, the boundary layer's part of the
/// friction, gap in µm. Its film has other nodes, and its inner spots are sheared at the film of half the sliding speed.
const OF_ANOTHER_PROGRAM: [(&str, [f64; 4]); 12] = [
    ("e-ground_90_0.1", [0.03028, 0.2879, 0.01656, 0.4955]),
    ("e-ground_120_0.5", [0.02005, 0.2917, 0.01204, 0.4992]),
    ("e-ground_60_0.9", [0.02317, 0.1238, 0.00712, 0.6746]),
    ("e-half_120_0.9", [0.01909, 0.1162, 0.006693, 0.2781]),
    ("e-quarter_120_0.5", [0.008917, 0.03606, 0.001228, 0.1547]),
    ("e-sf_150_0.1_9000", [0.02049, 0.05439, 0.002995, 0.07404]),
    ("e-sa_150_0.9_3000", [0.01735, 0.145, 0.008171, 0.09379]),
    ("fzg_8.3_0.15", [0.03958, 0.2043, 0.01202, 0.526]),
    ("fzg_0.5_0.8", [0.0424, 0.3829, 0.02528, 0.4246]),
    ("e-coarse_100_0.4_4000", [0.0278, 0.3464, 0.01836, 0.4567]),
    ("e-honed_130_0.8_9000", [0.01769, 0.1009, 0.00568, 0.2707]),
    ("fzg-fine_90_0.6_1.5", [0.03877, 0.1245, 0.007632, 0.2282]),
];

/// The carried spots, the rippled film and the heights above the mean line, with β_i.
fn changed(settings: LoadShareSettings, inner_boundary: f64) -> LoadShareSettings {
    LoadShareSettings {
        spot_speed: SpotSpeed::Carried,
        inner_boundary,
        film_pressure: FilmPressure::Rippled,
        gap_roughness: GapRoughness::Peaks,
        ..settings
    }
}

/// The film in every spot, without a boundary layer: friction that no rule of the boundary layer takes part in.
fn film_only(settings: LoadShareSettings, film_pressure: FilmPressure) -> LoadShareSettings {
    LoadShareSettings {
        spot_speed: SpotSpeed::Entrainment,
        boundary_layer: Length::from_si(0.0),
        film_pressure,
        gap_roughness: GapRoughness::Peaks,
        ..settings
    }
}

fn mean(solved: &[LoadShareSolution], of: fn(&LoadShareSolution) -> f64) -> f64 {
    solved.iter().map(of).sum::<f64>() / solved.len() as f64
}

/// Friction, share, parts of film, lubricated asperities and boundary layer, s, h_c and gap in µm.
fn parts(solved: &[LoadShareSolution]) -> [f64; 8] {
    let of: [fn(&LoadShareSolution) -> f64; 8] = [
        |s| s.coefficient,
        |s| s.asperity_share,
        |s| s.parts.film,
        |s| s.parts.lubricated_asperities,
        |s| s.parts.boundary,
        |s| s.roughness_over_film,
        |s| s.smooth_film.si() * 1e6,
        |s| s.mean_gap.si() * 1e6,
    ];
    of.map(|of| mean(solved, of))
}

#[test]
fn parts_of_friction_are_those_of_an_independent_program() {
    let mut all = conditions();
    all.extend(blind_conditions());
    all.retain(|one| OF_ANOTHER_PROGRAM.iter().any(|(name, _)| *name == one.name));
    assert_eq!(all.len(), OF_ANOTHER_PROGRAM.len());
    all.into_par_iter().for_each(|condition| {
        let windows = Windows::of(&condition, WINDOWS);
        let solved = windows.solutions(&changed(windows.settings(), 0.75), false);
        let [friction, share, _, _, boundary, _, _, gap] = parts(&solved);
        let found = [friction, share, boundary, gap];
        let row = OF_ANOTHER_PROGRAM
            .iter()
            .find(|(name, _)| *name == condition.name);
        let (name, expected) = row.unwrap();
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found / expected - 1.0).abs() < 0.02,
                "{name}: {found} {expected}"
            );
        }
    });
}

#[test]
#[ignore = "some minutes; prints the parts of every record"]
fn parts_of_every_record() {
    let all = |set, conditions: Vec<Condition>| -> Vec<(&str, Condition)> {
        conditions.into_iter().map(|one| (set, one)).collect()
    };
    let mut rows = all("gear_meshes", conditions());
    rows.extend(all("blind", blind_conditions()));
    println!("set,condition,model,mu,phi,film,lubricated,boundary,s,h_c_um,gap_um");
    rows.into_par_iter().for_each(|(set, condition)| {
        let windows = Windows::of(&condition, WINDOWS);
        let base = windows.settings();
        let models = [
            ("today", base),
            ("own film only", film_only(base, FilmPressure::Own)),
            ("film only", film_only(base, FilmPressure::Rippled)),
            ("inner 0.6", changed(base, 0.6)),
            ("inner 0.75", changed(base, 0.75)),
            ("inner 0.9", changed(base, 0.9)),
        ];
        let mut text = String::new();
        for (name, settings) in models {
            let found = parts(&windows.solutions(&settings, false));
            let cells = found.map(|number| format!("{number:.6}"));
            let _ = writeln!(text, "{set},{},{name},{}", condition.name, cells.join(","));
        }
        print!("{text}");
    });
}
