//! The gears and steels of the library: every number has its certainty and a source that is listed.

#![allow(clippy::unwrap_used, reason = "helpers of tests may panic")]

use std::collections::BTreeSet;

use asperity_core::presets::{
    Certainty, FigureRow, PresetError, gears, planetary_sets, read_gears, read_steels, sources,
    steel, steels,
};

/// Every number of every preset, with the name of its preset.
fn with_every_row(look: &mut dyn FnMut(&str, &FigureRow<'_>)) {
    for gears in gears().unwrap() {
        gears.rows().iter().for_each(|row| look(&gears.name, row));
    }
    for steel in steels().unwrap() {
        steel.rows().iter().for_each(|row| look(&steel.name, row));
    }
}

#[test]
fn every_number_of_every_preset_has_a_source_and_no_source_is_idle() {
    let listed: BTreeSet<String> = sources().unwrap().into_iter().map(|s| s.key).collect();
    assert_eq!(
        listed.len(),
        sources().unwrap().len(),
        "a source has two entries"
    );
    let mut used = BTreeSet::new();
    let mut numbers = 0;
    with_every_row(&mut |preset, row| {
        assert!(listed.contains(row.source), "{preset}: {}", row.key);
        // A derived number says how, one that is taken over says from what unless it was chosen freely.
        let taken_over = row.certainty == Certainty::Assumed && row.source != "own_choice";
        if row.certainty == Certainty::C || taken_over {
            assert!(row.note.is_some(), "{preset}: {} says not how", row.key);
        }
        used.insert(row.source.to_owned());
        numbers += 1;
    });
    assert!(numbers > 150, "{numbers}");
    // That of the heat capacity of a sintered steel is named in a note.
    used.insert("ternero_2021".to_owned());
    for set in planetary_sets().unwrap() {
        for row in set.gear_rows().iter().chain(&set.operation_rows()) {
            assert!(listed.contains(row.source), "{}: {}", set.name, row.key);
            used.insert(row.source.to_owned());
        }
    }
    assert_eq!(used, listed);
    for source in sources().unwrap() {
        assert!(source.text.len() > 20, "{}", source.key);
    }
}

#[test]
fn names_are_their_own() {
    let gears: Vec<String> = gears().unwrap().into_iter().map(|one| one.name).collect();
    let steels: Vec<String> = steels().unwrap().into_iter().map(|one| one.name).collect();
    for names in [gears, steels] {
        let unique: BTreeSet<String> = names.iter().map(|name| name.to_lowercase()).collect();
        assert_eq!(unique.len(), names.len());
    }
    assert_eq!(steel("1.6587").unwrap().name, "18CrNiMo7-6");
    assert_eq!(steel(" 42crmo4 ").unwrap().name, "42CrMo4");
    assert!(matches!(
        steel("brass"),
        Err(PresetError::Unknown { known, .. }) if known.len() == 6
    ));
}

/// The first of the gears as text, changed.
fn gears_with(change: impl Fn(&mut serde_json::Value)) -> Result<usize, PresetError> {
    let first = &gears().unwrap()[..1];
    let mut value = serde_json::to_value(first).unwrap();
    change(&mut value[0]["gears"]["module"]);
    read_gears(&value.to_string(), &sources().unwrap()).map(|gears| gears.len())
}

#[test]
fn a_number_without_certainty_or_source_is_refused() {
    let refused_as_text = |key: &str| {
        let without = gears_with(|module| {
            module.as_object_mut().unwrap().remove(key);
        });
        matches!(without, Err(PresetError::File { reason, .. }) if reason.contains(key))
    };
    assert_eq!(gears_with(|_| ()), Ok(1));
    assert!(refused_as_text("certainty") && refused_as_text("source"));
    assert!(refused_as_text("value"));
    assert!(matches!(
        gears_with(|module| module["source"] = "somebody_1999".into()),
        Err(PresetError::NoSource { key: "gears.module", source_key, .. }) if source_key == "somebody_1999"
    ));
    // What has no source but our choice is assumed, whatever it claims.
    assert!(matches!(
        gears_with(|module| module["source"] = "own_choice".into()),
        Err(PresetError::OwnChoice {
            key: "gears.module",
            certainty: "A",
            ..
        })
    ));
    assert!(gears_with(|module| module["certainty"] = "D".into()).is_err());
    assert!(gears_with(|module| module["value"] = "4.5".into()).is_err());

    let mut steel = serde_json::to_value(&steels().unwrap()[..1]).unwrap();
    let read = |value: &serde_json::Value| read_steels(&value.to_string(), &sources().unwrap());
    assert_eq!(read(&steel).unwrap().len(), 1);
    steel[0]["hardness"]["source"] = "nobody".into();
    assert!(matches!(
        read(&steel),
        Err(PresetError::NoSource {
            key: "hardness",
            ..
        })
    ));
}

#[test]
fn modules_and_shifts_of_the_cars_follow_from_their_tip_diameters() {
    let mut cars = 0;
    for preset in gears().unwrap() {
        let numbers = &preset.gears;
        // Those of the test rigs are not inferred.
        let Some(tip) = numbers
            .tip_diameter
            .as_ref()
            .filter(|_| !preset.name.starts_with("fzg"))
        else {
            continue;
        };
        let [d1, d2] = tip.value.map(|d| d.si() * 1e3);
        let [z1, z2] = numbers.teeth.value.map(f64::from);
        let cos = numbers.helix.value.si().cos();
        let module = (d1 + d2) / ((z1 + z2) / cos + 4.0);
        // Printed with two digits behind the point.
        let printed = numbers.module.value.si() * 1e3;
        assert!((printed - module).abs() <= 0.005 + 1e-9, "{}", preset.name);
        let shift = (d1 - d2 - printed * (z1 - z2) / cos) / (4.0 * printed);
        let [x1, x2] = numbers.profile_shift.value;
        assert!(
            (x1 - shift).abs() <= 0.005 + 1e-9 && x1 == -x2,
            "{}",
            preset.name
        );
        cars += 1;
    }
    assert_eq!(cars, 4);
}

#[test]
fn the_second_stages_turn_by_the_ratio_of_the_first() {
    let all = gears().unwrap();
    let of = |name: &str| all.iter().find(|one| one.name == name).unwrap();
    for car in ["vw-id3", "tesla-model3"] {
        let (first, second) = (of(&format!("{car}-1")), of(&format!("{car}-2")));
        let [z1, z2] = first.gears.teeth.value.map(f64::from);
        let torque = first.operation.torque.value.si() * z2 / z1;
        let speed = first.operation.speed.value.si() * z1 / z2;
        // Printed with one digit behind the point.
        assert!(
            (second.operation.torque.value.si() - torque).abs() < 0.051,
            "{car}"
        );
        assert!(
            (second.operation.speed.value.si() / speed - 1.0).abs() < 1e-4,
            "{car}"
        );
    }
}
