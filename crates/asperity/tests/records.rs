//! The load share `ehl` and the full film `ehl`: reference solutions along the path, kept and interpolated.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

use asperity::Error;
use asperity::case::{LoadedCase, load_with};
use asperity::quantity::Pressure;
use asperity::result::RunResult;

/// A shipped case with few positions and one offset.
fn case(name: &str, keys: &[(&str, &str)]) -> Result<LoadedCase, Error> {
    let file = Path::new("../../fixtures/cases").join(name);
    let mut loaded = load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(5), Some(1));
        input.model.depths = Some(0);
    })?;
    for (key, value) in keys {
        loaded = loaded.with_key(key, value)?;
    }
    Ok(loaded)
}

/// The e-drive with records on few cells: what is tested is not their accuracy.
fn recorded(cache: &Path, more: &[(&str, &str)]) -> LoadedCase {
    let folder = cache.display().to_string();
    let mut keys = vec![
        ("model.load_share", "ehl"),
        ("model.ehl.cells", "128"),
        ("model.ehl.travel", "2"),
        ("model.ehl.records", "3"),
        ("model.ehl.cache", folder.as_str()),
    ];
    keys.extend_from_slice(more);
    case("e-drive.toml", &keys).unwrap()
}

fn run(loaded: &LoadedCase) -> RunResult {
    asperity::Run::new(loaded)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result
}

fn files(folder: &Path) -> usize {
    std::fs::read_dir(folder).map_or(0, Iterator::count)
}

#[test]
fn shares_come_from_records_and_a_second_run_finds_them() {
    let cache = tempfile::tempdir().unwrap();
    let loaded = recorded(cache.path(), &[]);
    let first = run(&loaded);
    assert_eq!(first.records.len(), 3);
    assert_eq!(files(cache.path()), 3);
    let error = first.summary.asperity_share_standard_error.unwrap();
    assert!(error > 0.0 && error < first.summary.asperity_share);
    assert_eq!(run(&loaded), first);
    // At the place of a record its own share.
    for record in &first.records {
        let at = |row: &&asperity::result::PositionRow| {
            (row.path_fraction - record.path_fraction).abs() < 1e-12
        };
        let row = first.path.iter().find(at).unwrap();
        assert!((1.0 - row.film_share - record.solid_share).abs() < 1e-12);
        let error = row.film_share_standard_error.unwrap();
        assert!((error - record.solid_share_standard_error).abs() < 1e-12);
        assert!((row.mean_gap_um.unwrap() - record.mean_gap_um).abs() < 1e-12);
    }
    let losses = crate::runs::losses(&loaded).unwrap();
    assert_eq!(losses.summary.loss_w, first.summary.loss_w);
    assert_eq!(
        losses.summary.asperity_share_standard_error,
        first.summary.asperity_share_standard_error
    );
    // What changes the contact is another record; what does not, is not.
    run(&recorded(
        cache.path(),
        &[("operation.bulk_temperature", "80 °C")],
    ));
    assert_eq!(files(cache.path()), 6);
    run(&recorded(cache.path(), &[("model.hysteresis", "2 %")]));
    assert_eq!(files(cache.path()), 6);
}

#[test]
fn a_loss_by_records_has_an_interval_and_no_draw_solves_a_record() {
    let cache = tempfile::tempdir().unwrap();
    let run = |keys: &[(&str, &str)]| {
        let loaded = recorded(cache.path(), keys);
        let run = asperity::Run::new(&loaded).interval(true);
        run.execute().unwrap().into_only().unwrap().result
    };
    let stated = run(&[("model.lay", "0")]);
    assert_eq!(files(cache.path()), 3);
    let of = |result: &RunResult| result.uncertainty.clone().unwrap();
    let found = of(&stated);
    let [low, high] = found.loss.drawn().ends();
    assert!(low < stated.summary.loss_w && stated.summary.loss_w < high);
    let [falls, whole] = [0, 1].map(|k: usize| found.structures[k].loss_w.unwrap());
    // The run has the mean of both rules.
    assert!((0.5 * (falls + whole) / stated.summary.loss_w - 1.0).abs() < 1e-12);
    let ratios = stated
        .records
        .iter()
        .map(|record| record.stepped_friction / record.friction);
    let ratios: Vec<f64> = ratios.collect();
    let largest = ratios.iter().fold(0.0, |a: f64, b| a.max(*b));
    let rise = (whole - stated.summary.rolling_w) / (falls - stated.summary.rolling_w);
    // Heat lowers the film friction, which makes the boundary friction a larger part.
    assert!(1.0 < rise && rise < 1.1 * largest, "{rise} {ratios:?}");
    let names: Vec<_> = found
        .loss
        .parts
        .iter()
        .map(|part| part.name.as_str())
        .collect();
    for name in [
        "error of the reference solutions",
        "boundary friction below 20 nm",
        "boundary friction",
    ] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert!(!names.contains(&"error of the model") && !names.contains(&"lay"));
    // Ridges that leave the direction across the face leak, as the model says.
    let usual = run(&[]);
    assert_eq!(files(cache.path()), 3);
    let found = of(&usual);
    assert!(found.loss.parts.iter().any(|part| part.name == "lay"));
    // The run has its lay, with draws and without.
    let of_run = |lay: &str| {
        let fast = case("e-drive.toml", &[("model.lay", lay)]).unwrap();
        crate::runs::losses(&fast).unwrap().summary.sliding_w
    };
    let at_medians =
        |of: &RunResult| of.summary.sliding_w * of.summary.at_medians_w() / of.summary.loss_w;
    let lay = usual
        .defaults
        .iter()
        .find(|default| default.key == "model.lay");
    let expected = of_run(&lay.unwrap().value) / of_run("0");
    let found_ratio = at_medians(&usual) / at_medians(&stated);
    assert!(expected > 1.001 && (found_ratio / expected - 1.0).abs() < 1e-12);
    let without = crate::runs::losses(&recorded(cache.path(), &[]))
        .unwrap()
        .summary;
    assert_eq!(Some(without.loss_w), usual.summary.loss_at_medians_w);
    assert_eq!(without.efficiency_deviation, None);
    assert!((found.loss.median_w - usual.summary.loss_w).abs() < 1e-12);
}

#[test]
fn a_record_at_light_load_begins_where_its_inlet_is_flooded() {
    use asperity::ehl::RecordSettings;
    use asperity::reference_solution::{Inlet, ReferenceContact, ReferenceSettings};
    let record = |torque: &str, inlet: Inlet| {
        let loaded = case("e-drive.toml", &[("operation.torque", torque)]).unwrap();
        let settings = ReferenceSettings {
            record: RecordSettings::default(),
            eyring_stress: None,
            with_heat: false,
            beginning: 0,
            shortest_wave: None,
            inlet,
        };
        ReferenceContact::new(&loaded.at_stated().unwrap(), 0.9, &settings)
            .unwrap()
            .record
    };
    let stated = RecordSettings::default();
    let full = record("145 N m", Inlet::ByLoad);
    assert_eq!((full.window, full.cells), (stated.window, stated.cells));
    let light = record("20 N m", Inlet::ByLoad);
    assert!(light.window.inlet < -5.0, "{:?}", light.window);
    let cell = |settings: &RecordSettings| {
        (settings.window.outlet - settings.window.inlet) / settings.cells as f64
    };
    assert!(cell(&light) <= cell(&stated) && cell(&light) > 0.9 * cell(&stated));
    assert_eq!(light.window, record("20 N m", Inlet::Flooded).window);
    assert_eq!(record("20 N m", Inlet::Stated).window, stated.window);
}

#[test]
fn the_heat_of_the_film_lowers_the_friction_of_its_records() {
    let cache = tempfile::tempdir().unwrap();
    let with = |conductivity: &str| {
        let keys = [
            ("model.thermal", "none"),
            ("lubricant.thermal_conductivity", conductivity),
        ];
        run(&recorded(cache.path(), &keys)).summary
    };
    let [poor, good] = [with("0.09 W/(m K)"), with("0.28 W/(m K)")];
    // The records are isothermal, so they are the same.
    assert_eq!(files(cache.path()), 3);
    assert_eq!(poor.asperity_share, good.asperity_share);
    assert!(poor.film_w < 0.99 * good.film_w, "{poor:?} {good:?}");
    let lubricated = poor.lubricated_asperity_w / good.lubricated_asperity_w;
    assert!(lubricated < 0.99, "{poor:?} {good:?}");
}

#[test]
fn elastic_records_above_the_flow_pressure_carry_a_warning_with_their_pressure() {
    let cache = tempfile::tempdir().unwrap();
    let warned = |flow: &str| {
        let keys = [
            ("material.pinion.flow_pressure", flow),
            // Coarser cells blunt the peaks.
            ("model.ehl.cells", "256"),
            ("model.ehl.records", "2"),
        ];
        let result = run(&recorded(cache.path(), &keys));
        let largest = result.records.iter().map(|record| record.p_max_mpa);
        let text = result.warnings.into_iter().find(|w| w.code == "W435");
        (largest.fold(0.0, f64::max), text.map(|w| w.text))
    };
    // Steel yields at its flow pressure and passes it nowhere.
    let (largest, text) = warned("7 GPa");
    assert!(largest <= 7000.0 * (1.0 + 1e-9) && text.is_none());
    // A ceiling that no steel has is none.
    let (largest, text) = warned("15 GPa");
    assert!(largest > 7000.0, "{largest}");
    let text = text.unwrap();
    let said = format!(
        "the pressure reaches {:.3}, above the 7 GPa",
        Pressure::from_si(1e6 * largest)
    );
    assert!(text.contains(&said), "{text}");
}

#[test]
fn records_hold_both_weights_of_the_boundary_friction() {
    let cache = tempfile::tempdir().unwrap();
    let result = run(&recorded(cache.path(), &[]));
    for record in &result.records {
        // The weight that is whole on contact nodes is the larger one on every film.
        assert!(record.graded_friction < record.friction, "{record:?}");
    }
}

#[test]
fn a_damaged_record_is_solved_again_and_off_keeps_nothing() {
    let cache = tempfile::tempdir().unwrap();
    let loaded = recorded(cache.path(), &[("model.ehl.records", "2")]);
    let first = run(&loaded);
    for entry in std::fs::read_dir(cache.path()).unwrap() {
        std::fs::write(entry.unwrap().path(), b"{\"solid_share\":1").unwrap();
    }
    assert_eq!(run(&loaded), first);
    let off = run(&recorded(
        cache.path(),
        &[("model.ehl.records", "2"), ("model.ehl.cache", "off")],
    ));
    assert_eq!(off.summary, first.summary);
    assert_eq!(files(cache.path()), 2);
}

#[test]
fn a_steady_solution_stands_for_a_full_film_and_says_where_the_formulas_are_off() {
    let loaded = case("e-drive-superfinished.toml", &[("model.full_film", "ehl")]).unwrap();
    let formulas = case("e-drive-superfinished.toml", &[]).unwrap();
    let (solved, plain) = (run(&loaded), run(&formulas));
    let films: Vec<_> = solved.path.iter().filter_map(|row| row.full_film).collect();
    assert!(!films.is_empty(), "no position in full film");
    for film in &films {
        // Flow of mass and minimum film are those of the formulas to some 20 %.
        assert!(film.film_central_deviation.abs() < 0.25, "{film:?}");
        assert!(film.film_minimum_deviation.abs() < 0.25, "{film:?}");
        assert!(film.mu.unwrap() > 0.0);
    }
    assert!(plain.path.iter().all(|row| row.full_film.is_none()));
    assert_ne!(solved.summary.loss_w, plain.summary.loss_w);
    let noted = solved.warnings.iter().any(|warning| warning.code == "W416");
    let off = films.iter().any(|film| {
        let mu = film.mu_deviation.unwrap_or(0.0).abs();
        mu.max(film.film_central_deviation.abs())
            .max(film.film_minimum_deviation.abs())
            > 0.1
    });
    assert_eq!(noted, off);
    println!("{films:#?}");
}

#[test]
fn a_full_film_can_be_that_of_records() {
    let keys = [
        ("model.full_film", "ehl-transient"),
        ("model.load_share", "lambda-star"),
        ("model.ehl.cells", "128"),
        ("model.ehl.travel", "2"),
        ("model.ehl.records", "2"),
        ("model.ehl.cache", "off"),
    ];
    let solved = run(&case("e-drive-superfinished.toml", &keys).unwrap());
    assert_eq!(solved.records.len(), 2);
    assert_eq!(solved.summary.asperity_share_standard_error, None);
    let row = solved
        .path
        .iter()
        .find(|row| row.full_film.is_some())
        .unwrap();
    let film = row.full_film.unwrap();
    // The mean gap of superfinished flanks is near their smooth film.
    assert!((0.7..1.4).contains(&(film.film_central_um / row.film_central_um)));
    assert!(film.p_max_mpa > row.hertz_pressure_mpa * 0.9);
    // Between two records neither pressure nor film leaves what those have.
    let films = solved.path.iter().filter_map(|row| row.full_film);
    for film in films {
        let gaps = solved.records.iter().map(|record| record.mean_gap_um);
        let (least, most) = gaps.fold((f64::INFINITY, 0.0_f64), |(low, high), gap| {
            (low.min(gap), high.max(gap))
        });
        assert!(
            (0.5 * least..=most).contains(&film.film_minimum_um),
            "{film:?}"
        );
    }
}

#[test]
fn records_of_a_flank_that_changed_are_not_taken_for_those_of_the_new_one() {
    let folder = tempfile::tempdir().unwrap();
    let fixtures = Path::new("../../fixtures");
    let copy = |name: &str, to: &str| {
        std::fs::copy(fixtures.join("profiles").join(name), folder.path().join(to)).unwrap();
    };
    copy("ground_pinion.csv", "pinion.csv");
    let cache = folder.path().join("kept");
    let keys = [
        ("surface.pinion", "{ file = \"pinion.csv\" }"),
        (
            "surface.wheel",
            "{ file = \"pinion.csv\", mirrored = true }",
        ),
    ];
    let case = |cache: &str| {
        let file = folder.path().join("case.toml");
        std::fs::copy(fixtures.join("cases/e-drive.toml"), &file).unwrap();
        let loaded = load_with(&file, &|input| {
            (input.model.positions, input.model.offsets) = (Some(5), Some(1));
            input.model.depths = Some(0);
            for (key, value) in keys {
                input.set(key, value).unwrap();
            }
        });
        let more = [
            ("model.load_share", "ehl"),
            ("model.ehl.cells", "128"),
            ("model.ehl.travel", "2"),
            ("model.ehl.records", "2"),
            ("model.ehl.cache", cache),
        ];
        let loaded = more
            .iter()
            .try_fold(loaded.unwrap(), |loaded, (key, value)| {
                loaded.with_key(key, value)
            });
        run(&loaded.unwrap()).summary
    };
    let before = case("kept");
    assert_eq!(files(&cache), 2);
    copy("ground_fine_pinion.csv", "pinion.csv");
    let after = case("kept");
    assert_eq!(files(&cache), 4);
    assert_eq!(after, case("off"));
    assert_ne!(after, before);
}
