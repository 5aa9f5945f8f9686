//! The solved load share in whole cases: what moves the loss, what must not, and what was measured.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::{Mutex, OnceLock};

use asperity::case::{CaseInput, LoadedCase, load};
use asperity::core::task::on_threads;
use asperity::oil::FilmConstantName;
use asperity::result::{Losses, Summary};
use asperity_tests::assert_close;
use asperity_tests::{contacts, losses_with};

use crate::measured_cases::kept;

/// A shipped case, read once.
pub fn shipped(name: &str) -> LoadedCase {
    static READ: Mutex<BTreeMap<String, LoadedCase>> = Mutex::new(BTreeMap::new());
    asperity_paper_2022::register();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases");
    let read = || load(&folder.join(format!("{name}.toml")), None).unwrap();
    let mut known = READ.lock().unwrap();
    known.entry(name.to_owned()).or_insert_with(read).clone()
}

/// A shipped case with these keys changed.
pub fn with(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    with_keys(&shipped(name), keys)
}

/// The case with keys changed together: one alone may contradict what the others replace.
pub fn with_keys(case: &LoadedCase, keys: &[(&str, &str)]) -> LoadedCase {
    let set = |input: &mut CaseInput| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    };
    case.with(set).unwrap()
}

pub fn losses(case: &LoadedCase) -> Losses {
    asperity_tests::losses(case).unwrap()
}

/// Few offsets, as the reference computation took.
pub const FEW: [(&str, &str); 2] = [("model.positions", "16"), ("model.offsets", "4")];

/// Summary with few offsets, on the contacts of the case itself unless the keys change what they depend on.
pub fn few(name: &str, keys: &[(&str, &str)]) -> Summary {
    let kept = kept(name, &FEW);
    let case = kept.with(keys);
    losses_with(&kept.tables, &case).unwrap().summary
}

#[test]
fn the_parts_add_up_to_the_sliding_loss() {
    for name in ["e-drive", "e-drive-superfinished", "fzg-c"] {
        let found = few(name, &[]);
        let parts = found.film_w + found.lubricated_asperity_w + found.boundary_w;
        assert_close(name, parts, found.sliding_w, 1e-12);
        assert!(found.boundary_share <= found.asperity_share);
    }
}

#[test]
fn the_pressure_at_which_asperities_flow_moves_the_loss() {
    let at = |flow: &str| few("e-drive", &[("material.pinion.flow_pressure", flow)]).sliding_w;
    let (soft, hard) = (at("2.5 GPa"), at("20 GPa"));
    assert!(hard > 1.05 * soft, "{soft} {hard}");
}

#[test]
fn a_flank_that_the_film_alone_makes_flow_is_refused() {
    let soft = with("e-drive", &[("material.pinion.flow_pressure", "1.2 GPa")]);
    let error = asperity_tests::losses(&soft).unwrap_err();
    assert_eq!(error.code(), "E306");
}

#[test]
fn the_tolerance_of_the_contacts_does_not_move_the_loss() {
    for law in ["solved", "lambda-star"] {
        let at = |tolerance: &str| {
            let keys = [("model.tolerance", tolerance), ("model.load_share", law)];
            let case = with("e-drive", &[&FEW[..], &keys].concat());
            asperity::Run::new(&case)
                .execute()
                .unwrap()
                .into_only()
                .unwrap()
                .result
                .summary
        };
        let [loose, tight] = [at("1e-4"), at("1e-11")];
        assert_close("loss", loose.loss_w, tight.loss_w, 1e-6);
        // Contacts of few points are exact at any tolerance.
        for found in [loose, tight] {
            assert!(found.worst_duality_gap <= 1e-11, "{law} {found:?}");
        }
    }
}

#[test]
fn contacts_made_before_serve_other_oils_speeds_and_temperatures() {
    let case = with("e-drive", &FEW);
    let tables = contacts(&case).unwrap();
    assert!(!tables.is_empty());
    for (key, value) in [
        ("operation.bulk_temperature", "60 °C"),
        ("operation.speed", "2000 1/min"),
        ("lubricant.base_oil", "ester"),
        // Contacts under another load or of other steels are made again.
        ("operation.torque", "150 N m"),
        ("material.pinion.flow_pressure", "5 GPa"),
    ] {
        let other = case.with_key(key, value).unwrap();
        let kept = losses_with(&tables, &other).unwrap();
        assert_eq!(kept.summary, losses(&other).summary, "{key}");
    }
}

#[test]
fn a_film_of_cold_oil_rubs_with_its_limiting_stress_at_most() {
    for cold in ["-20 °C", "-30 °C"] {
        let case = with(
            "e-drive-superfinished",
            &[&FEW[..], &[("operation.bulk_temperature", cold)]].concat(),
        );
        for row in losses(&case).path {
            assert!(row.mu_film < 0.04, "{cold}: {}", row.mu_film);
            // Of thick films little is left, but the numerator of Gupta's factor never reaches its floor.
            assert!(
                row.film_central_um > 0.5 && row.thermal_reduction > 0.02,
                "{row:?}"
            );
            assert_eq!(row.regime, asperity::result::Regime::FullFilm);
        }
    }
}

#[test]
fn every_law_of_the_load_share_runs_by_its_name() {
    let at = |law: &str| few("e-drive", &[("model.load_share", law)]);
    let solved = at("solved");
    for law in ["lambda-star", "zhu-hu", "masjedi-khonsari", "jgp"] {
        let classical = at(law);
        // All asperity load at the boundary coefficient costs more than lubricated asperities.
        assert!(classical.sliding_w > solved.sliding_w, "{law}");
        assert_eq!(classical.lubricated_asperity_w, 0.0);
    }
}

#[test]
fn the_share_is_the_same_on_one_and_two_threads() {
    let case = with("e-drive", &FEW);
    let on = |threads: usize| on_threads(threads, || losses(&case).summary).unwrap();
    assert_eq!(on(1), on(2));
}

#[test]
fn an_oil_without_a_family_is_refused_or_assumed() {
    let mut case = shipped("e-drive");
    let error = case
        .with(|input| {
            input.lubricant.base_oil = None;
            input.lubricant.pressure_viscosity = "10 1/GPa".parse().ok();
        })
        .unwrap_err();
    assert_eq!(error.code(), "E208");
    case = case
        .with(|input| {
            input.lubricant.base_oil = None;
            input.lubricant.assume_base_oil = Some(asperity::oil::BaseOil::Mineral);
        })
        .unwrap();
    let mut listed = case.case.defaults.iter();
    assert!(listed.any(|used| used.key.ends_with("base_oil")));
}

#[test]
fn every_assumed_constant_is_told_with_its_band_and_how_sure_it_is() {
    let few = [("model.positions", "2"), ("model.offsets", "1")];
    let of = |keys: &[(&str, &str)]| {
        let result = asperity_tests::run(&with("e-drive", &[&few[..], keys].concat())).result;
        result.film_constants
    };
    let told = of(&[]);
    for name in [
        FilmConstantName::LimitingShear,
        FilmConstantName::EyringStress,
        FilmConstantName::BoundaryFriction,
        FilmConstantName::BoundaryLayer,
    ] {
        let constant = told.iter().find(|constant| constant.name == name);
        let constant = constant.unwrap_or_else(|| panic!("{name:?} is not in {told:?}"));
        let constant = &constant.constant;
        assert!(constant.low.unwrap() < constant.value && constant.value < constant.high.unwrap());
        assert!(!constant.source.is_empty());
    }
    // What the case gives is no assumption.
    let given = of(&[("model.boundary_friction", "0.1")]);
    assert!(
        given
            .iter()
            .all(|constant| constant.name != FilmConstantName::BoundaryFriction)
    );
    assert!(of(&[("formulation", "paper")]).is_empty());
}

/// One key changed on the shipped drive, ground flanks.
const CHANGES: [(&str, &str); 17] = [
    ("model.boundary_friction", "0.065"),
    ("model.boundary_friction", "0.12"),
    ("model.boundary_layer", "5 nm"),
    ("model.boundary_layer", "20 nm"),
    ("model.lay", "0.16666666666666666"),
    ("model.lay", "isotropic"),
    ("material.pinion.flow_pressure", "2.5 GPa"),
    ("model.film_pressure_law", "roelands"),
    ("model.film_friction", "xu"),
    ("model.load_share", "lambda-star"),
    ("model.load_share", "zhu-hu"),
    ("model.load_share", "masjedi-khonsari"),
    ("model.load_share", "jgp"),
    ("model.load_distribution", "mean-length"),
    ("lubricant.base_oil", "mineral"),
    ("lubricant.base_oil", "polyglycol"),
    ("operation.bulk_temperature", "60 °C"),
];

/// Losses of the defaults and of each change, and of the run-in flanks.
fn changes() -> &'static (f64, Vec<f64>, f64) {
    static CHANGED: OnceLock<(f64, Vec<f64>, f64)> = OnceLock::new();
    CHANGED.get_or_init(|| {
        let base = losses(&with(
            "e-drive",
            &[&FEW[..], &[("operation.running_in", "true")]].concat(),
        ));
        let changed = CHANGES.map(|(key, value)| few("e-drive", &[(key, value)]).loss_w);
        let run_in = base.run_in.unwrap().summary.loss_w;
        (base.summary.loss_w, changed.to_vec(), run_in)
    })
}

/// Effect of one changed key on the loss.
pub fn one_key_changed() -> String {
    let (base, changed, run_in) = changes();
    let mut text = format!(
        "| key | value | loss W | change |\n|---|---|---|---|\n| - | defaults | {base:.0} | |\n"
    );
    let rows = CHANGES.iter().zip(changed).map(|(row, loss)| (*row, *loss));
    for ((key, value), loss) in rows.chain([(("operation.running_in", "true"), *run_in)]) {
        let change = 100.0 * (loss / base - 1.0);
        let value = match value {
            "0.16666666666666666" => "1/6",
            value => value,
        };
        let _ = writeln!(text, "| `{key}` | {value} | {loss:.0} | {change:+.0} % |");
    }
    text.push_str("\nTest: `every_choice_of_the_load_share_moves_the_loss`.\n");
    text
}

#[test]
fn every_choice_of_the_load_share_moves_the_loss() {
    let (base, changed, run_in) = changes();
    for ((key, value), loss) in CHANGES.iter().zip(changed) {
        assert!((loss / base - 1.0).abs() > 1e-4, "{key} {value}: {loss}");
    }
    assert!(run_in < base);
}
