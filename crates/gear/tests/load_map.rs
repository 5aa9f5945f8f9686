//! The load map against an independent program, `tests/golden/load_map.json` (computed again by
//! `references/load_map.py`), and closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use crate::reference::{Case, cells, golden, map, relief, unmodified};
use asperity_core::quantity::Length;
use asperity_gear::{GearPair, LoadLaw, LoadMapSettings, MicroGeometry};

/// The reference values come with 64 to 256 cells and 36 phases; MESH tolerances: 1e-3 of H_V at 64
/// cells, which is what the discretisation costs.
const ELASTIC: f64 = 1e-3;

/// With relief the contact ends inside cells; a third of the error goes with each doubling.
const ELASTIC_RELIEVED: f64 = 1e-3;

#[track_caller]
fn close(value: f64, expected: f64, relative: f64, what: &str) {
    assert!(
        (value / expected - 1.0).abs() < relative,
        "{what}: {value} is not {expected} to {relative:e}"
    );
}

fn slices(count: usize) -> LoadMapSettings {
    LoadMapSettings {
        face_coupling: 0.0,
        ..cells(count)
    }
}

#[test]
fn elastic_loss_factors_are_those_of_the_reference() {
    for case in golden().cases() {
        let found = case.elastic(&unmodified());
        assert!(found.evidence().converged);
        close(
            found.loss_factor(),
            case.row.number("elastic"),
            ELASTIC,
            &case.name,
        );
    }
}

#[test]
fn laws_without_deflections_have_the_loss_factors_of_the_reference() {
    let settings = LoadMapSettings::default();
    for case in golden().cases() {
        let factor = |law| case.map(&law, &unmodified(), &settings).loss_factor();
        close(
            factor(LoadLaw::Uniform),
            case.row.number("uniform"),
            2e-4,
            &case.name,
        );
        if let Some(expected) = case.row.0["min_potential"].as_f64() {
            close(factor(LoadLaw::MinPotential), expected, 2e-4, &case.name);
        }
    }
}

#[test]
fn slices_without_coupling_have_the_loss_factors_of_the_reference() {
    for case in golden().cases() {
        let found = case.map(&LoadLaw::Elastic, &unmodified(), &slices(256));
        close(
            found.loss_factor(),
            case.row.number("slices"),
            2e-4,
            &case.name,
        );
    }
}

#[test]
fn relieved_loss_factors_are_those_of_the_reference() {
    let golden = golden();
    for row in golden.rows("relief") {
        let case: Case = golden.case(row.text(0));
        let micro = relief(row.at(1), row.at(2), row.at(3) == 2.0);
        let found = case.map(&LoadLaw::Elastic, &micro, &cells(192));
        let what = format!("{:?}", row.0);
        assert!(found.evidence().converged, "{what}");
        close(found.loss_factor(), row.at(4), ELASTIC_RELIEVED, &what);
        // 64 cells.
        let coarse = case.elastic(&micro);
        close(coarse.loss_factor(), row.at(4), 5e-3, &what);
    }
}

#[test]
fn transmission_errors_are_those_of_the_reference() {
    for case in golden().cases() {
        let found = case.map(&LoadLaw::Elastic, &unmodified(), &cells(128));
        let error = found.transmission_error().unwrap().unwrap();
        let expected = |key: &str| case.row.number(key);
        close(error.mean.si(), expected("te_mean"), 1e-2, &case.name);
        let peaks = expected("te_peak_to_peak");
        let off = (error.peak_to_peak.si() - peaks).abs();
        assert!(
            off < (0.05 * peaks).max(0.05e-6),
            "{}: {error:?}",
            case.name
        );
        close(error.mesh_stiffness, expected("c_gamma"), 1e-2, &case.name);
    }
}

#[test]
fn the_loss_factor_falls_with_the_load_where_relief_is_not_filled() {
    let golden = golden();
    for row in golden.rows("load") {
        let case = golden.case(row.text(0));
        let micro = relief(1e-5, case.double_contact(), false);
        let torque = case.torque * row.at(1);
        let found = map(&case.pair(), torque, &LoadLaw::Elastic, &micro, &cells(128));
        close(
            found.loss_factor(),
            row.at(2),
            2e-3,
            &format!("{:?}", row.0),
        );
    }
}

#[test]
fn a_vanishing_helix_is_a_spur_pair() {
    let golden = golden();
    let case = golden.case("e-drive");
    let with_helix = |degrees: f64| {
        let mut case = case.clone();
        case.input.helix = asperity_core::quantity::Angle::from_si(degrees.to_radians());
        case
    };
    for row in golden.rows("helix") {
        let case = with_helix(row.at(0));
        let settings = LoadMapSettings::default();
        let factor = |law| case.map(&law, &unmodified(), &settings).loss_factor();
        let what = format!("{:?}", row.0);
        close(factor(LoadLaw::Uniform), row.at(1), 2e-4, &what);
        close(factor(LoadLaw::MinPotential), row.at(2), 2e-4, &what);
        close(factor(LoadLaw::Elastic), row.at(4), ELASTIC, &what);
    }
    for (law, spur) in [
        (LoadLaw::Uniform, 0.136_892_7),
        (LoadLaw::MinPotential, 0.128_303_0),
        (LoadLaw::Elastic, 0.130_968_4),
    ] {
        let factor = |degrees: f64| {
            let case = with_helix(degrees);
            case.map(&law, &unmodified(), &LoadMapSettings::default())
                .loss_factor()
        };
        let exact = factor(0.0);
        assert!((exact - spur).abs() < 2e-7, "{} {exact}", law.name());
        assert!((factor(1e-6) - exact).abs() < 1e-7, "{}", law.name());
        assert!((factor(1e-3) - exact).abs() < 5e-5, "{}", law.name());
    }
}

#[test]
fn the_loss_factor_passes_whole_overlap_ratios_smoothly() {
    // 192 cells in the reference.
    for (whole, expected) in [
        (1.0, [0.150_532, 0.150_534, 0.150_535]),
        (2.0, [0.151_054, 0.151_053, 0.151_050]),
    ] {
        for (offset, expected) in [-1e-3, 0.0, 1e-3].into_iter().zip(expected) {
            let mut case = golden().case("e-drive");
            let sine: f64 = (whole + offset) * std::f64::consts::PI * 1.8 / 32.0;
            case.input.helix = asperity_core::quantity::Angle::from_si(sine.asin());
            let found = case
                .map(&LoadLaw::Elastic, &unmodified(), &cells(192))
                .loss_factor();
            close(found, expected, 2e-4, &format!("{whole} {offset}"));
        }
    }
}

#[test]
fn iso_stiffness_has_the_loss_factors_of_a_second_program() {
    // Without and with 10 um of linear relief over the double contact, 64 cells.
    for (name, plain, relieved) in [
        ("C14", 0.19460, 0.18894),
        ("H701", 0.14082, 0.12354),
        ("e-drive", 0.14969, 0.11284),
        ("table2", 0.07497, 0.04769),
        ("spur-25-50", 0.13457, 0.12364),
    ] {
        let case = golden().case(name);
        let factor = |micro: &MicroGeometry| {
            case.map(&LoadLaw::IsoStiffness, micro, &cells(64))
                .loss_factor()
        };
        close(factor(&unmodified()), plain, 1e-3, name);
        close(
            factor(&relief(1e-5, case.double_contact(), false)),
            relieved,
            2e-3,
            name,
        );
    }
}

#[test]
fn shares_of_a_spur_pair_are_those_of_the_reference() {
    for case in golden().cases() {
        let pair = case.pair();
        if !pair.is_spur() {
            continue;
        }
        let found = case.elastic(&unmodified());
        let force = case.row.number("force");
        for row in case.row.0["share"].as_array().unwrap() {
            let (xi, share) = (row[0].as_f64().unwrap(), row[1].as_f64().unwrap());
            let s = pair.path().place(xi).si().min(pair.path().e.si());
            let load = found.mean_line_load(Length::from_si(s)).unwrap().si();
            close(
                load * pair.face_width.si() / force,
                share,
                2e-4,
                &format!("{} {xi}", case.name),
            );
        }
    }
}

#[test]
fn width_errors_load_one_end_and_leave_the_loss() {
    let case = golden().case("e-drive");
    for (crowning, lead_slope, expected, width) in [
        (8e-6, 0.0, 0.15058, 1.296),
        (0.0, 15e-6, 0.15041, 1.762),
        (8e-6, 15e-6, 0.15061, 1.46),
        (0.0, 40e-6, 0.15006, 2.922),
    ] {
        let micro = MicroGeometry {
            crowning: Length::from_si(crowning),
            lead_slope: Length::from_si(lead_slope),
            direction: asperity_gear::AmountDirection::Normal,
            ..MicroGeometry::default()
        };
        let found = case.map(&LoadLaw::Elastic, &micro, &cells(192));
        close(found.loss_factor(), expected, 1e-3, "loss");
        close(found.face_load_factor(), width, 1e-2, "width");
    }
}

#[test]
fn pitch_deviations_hardly_change_the_loss() {
    let case = golden().case("fzg-c");
    for (pitch, expected) in [
        (vec![0.0, 5e-6], 0.19492),
        (vec![0.0, 1e-5], 0.194_924),
        (vec![0.0, 1e-5, 0.0], 0.194_922),
    ] {
        let micro = MicroGeometry {
            pitch: pitch.into_iter().map(Length::from_si).collect(),
            ..MicroGeometry::default()
        };
        close(case.elastic(&micro).loss_factor(), expected, 1e-5, "pitch");
    }
}

#[test]
fn edge_contact_costs_what_the_reference_says() {
    for (name, expected) in [("e-drive", 0.1586), ("fzg-c", 0.2076), ("table2", 0.0823)] {
        let case = golden().case(name);
        let settings = LoadMapSettings {
            edge_contact: true,
            ..LoadMapSettings::default()
        };
        let found = case.map(&LoadLaw::Elastic, &unmodified(), &settings);
        // Printed with four digits.
        close(found.loss_factor(), expected, 1.5e-3, name);
    }
}

#[test]
fn ring_pairs_have_the_loss_factors_of_the_reference() {
    let settings = LoadMapSettings::default();
    for case in golden().rings() {
        let expected = |key: &str| case.row.number(key);
        let factor = |law| case.map(&law, &unmodified(), &settings).loss_factor();
        close(
            factor(LoadLaw::Uniform),
            expected("uniform"),
            2e-4,
            &case.name,
        );
        close(
            factor(LoadLaw::MinPotential),
            expected("min_potential"),
            2e-4,
            &case.name,
        );
        close(
            factor(LoadLaw::Elastic),
            expected("elastic"),
            ELASTIC,
            &case.name,
        );
        let independent = case.map(&LoadLaw::Elastic, &unmodified(), &slices(256));
        close(
            independent.loss_factor(),
            expected("slices"),
            2e-4,
            &case.name,
        );
    }
}

#[test]
fn a_chamfer_acts_like_relief() {
    let case = golden().case("e-drive");
    for (chamfer, expected) in [(0.1e-3, 0.1440), (0.2e-3, 0.1374), (0.3e-3, 0.1306)] {
        let pair: GearPair = case
            .pair()
            .with_tip_chamfer([Length::from_si(chamfer); 2])
            .unwrap();
        let settings = LoadMapSettings::default();
        let found = map(
            &pair,
            case.torque,
            &LoadLaw::Elastic,
            &unmodified(),
            &settings,
        );
        close(found.loss_factor(), expected, 1e-3, "chamfer");
    }
}

#[test]
fn profile_crowning_lowers_the_loss() {
    let case = golden().case("e-drive");
    for (amount, expected) in [(5e-6, 0.13261), (10e-6, 0.11536)] {
        let micro = MicroGeometry {
            profile_crowning: Length::from_si(amount),
            direction: asperity_gear::AmountDirection::Normal,
            ..MicroGeometry::default()
        };
        close(
            case.elastic(&micro).loss_factor(),
            expected,
            2e-3,
            "crowning",
        );
    }
}
