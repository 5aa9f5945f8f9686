//! The ranges of the keys of a case, and of their relations.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeSet;
use std::path::Path;

use asperity::case::{CaseInput, LoadedCase, load, range_of, schema, schema_of_named_meshes};
use serde_json::{Value, json};

/// Paths of the keys below `node` that take numbers, with or without unit; an entry of a list has the path of the list.
fn numbers(schema: &Value, node: &Value, path: &str, found: &mut BTreeSet<String>) {
    if let Some(name) = node.get("$ref").and_then(Value::as_str) {
        let name = name.trim_start_matches("#/$defs/");
        return numbers(schema, &schema["$defs"][name], path, found);
    }
    for kind in ["anyOf", "oneOf", "allOf", "prefixItems"] {
        for inner in node
            .get(kind)
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
        {
            numbers(schema, inner, path, found);
        }
    }
    if let Some(items) = node.get("items") {
        numbers(schema, items, path, found);
    }
    let below = |name: &str| format!("{path}.{name}").trim_start_matches('.').to_owned();
    let keys = node.get("properties").and_then(Value::as_object);
    for (name, inner) in keys.into_iter().flatten() {
        numbers(schema, inner, &below(name), found);
    }
    // Tables by names that the user chooses.
    if let Some(inner) = node
        .get("additionalProperties")
        .filter(|inner| inner.is_object())
    {
        numbers(schema, inner, &below("first"), found);
    }
    let is = |kind: &str| match &node["type"] {
        Value::String(name) => name == kind,
        Value::Array(names) => names.iter().any(|name| name == kind),
        _ => false,
    };
    let text = node.get("description").and_then(Value::as_str);
    let is_quantity = is("string") && text.is_some_and(|text| text.contains("with a unit"));
    if is("number") || is("integer") || is_quantity {
        found.insert(path.to_owned());
    }
}

fn numbers_of(schema: &Value) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    numbers(schema, schema, "", &mut found);
    found
}

#[test]
fn every_number_of_a_case_and_of_a_gear_train_has_a_usual_range_within_its_possible_one() {
    let [pair, train] = [schema(), schema_of_named_meshes()].map(|schema| numbers_of(&schema));
    assert!(pair.contains("vehicle.rolling_resistance") && pair.contains("surface.coast.wheel.ra"));
    assert!(train.contains("mesh.first.planetary.sun.tip_relief.amount"));
    let keys: BTreeSet<String> = pair.into_iter().chain(train).collect();
    let without: Vec<&String> = keys.iter().filter(|key| range_of(key).is_none()).collect();
    assert!(without.is_empty(), "{without:#?}");
    for key in keys {
        let range = range_of(&key).unwrap();
        let ([low, high], [least, most]) = (range.usual, range.possible);
        assert!(
            least <= low && low < high && high <= most,
            "{key}: {range:?}"
        );
    }
}

fn e_drive() -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    load(&file, None).unwrap()
}

/// What a case may state: changes of the e-drive stage, which together have every number with a usual value.
fn usual_cases() -> Vec<Value> {
    let bearing = |kind: &str, more: Value| {
        let of_all = json!({ "shaft": "pinion", "kind": kind, "bore": "40 mm", "outside_diameter": "68 mm", "radial": "2 kN",
            "axial": "1 kN", "at_torque": "145 N m", "r1": 4.3e-7, "s1": 4.63e-3, "s2": 4.25, "k_z": 3.1, "k_rs": 3e-8,
            "mu_bl": 0.12, "mu_ehl": 0.04 });
        merged(of_all, &more)
    };
    let flank = |at: Value| json!({ "surface": { "pinion": { "at": at, "from": "root", "mirrored": null } } });
    vec![
        json!({ "gears": {
            "pressure_angle": "20 deg", "profile_shift": [0.2, -0.1], "addendum": 1.0, "relief_tolerance": "3 um",
            "end_relief": { "amount": "10 um", "length": "3 mm" }, "pitch_deviations": ["6 um", "-6 um"],
            "pinion": { "tip_relief": { "amount": "12 um", "length": "2.9 mm" }, "root_relief": { "amount": "8 um", "length": "2 mm" },
                "tip_chamfer": "0.1 mm", "crowning": "5 um", "lead_slope": "6 um", "profile_slope": "3 um",
                "profile_crowning": "3 um", "dedendum": 1.25, "fillet_radius": 0.38 }
        } }),
        json!({ "gears": {
            "profile_shift": null, "centre_distance": "89.6 mm", "tip_diameter": ["49 mm", "137.5 mm"],
            "pinion": { "tip_relief": { "amount": "12 um", "start_diameter": "47 mm" } }
        } }),
        json!({ "material": { "pinion": { "young": "206 GPa", "poisson": 0.3, "elastic_limit": "1500 MPa", "flow_pressure": "7 GPa",
            "density": "7830 kg/m3", "conductivity": "45 W/(m K)", "heat_capacity": "460 J/(kg K)" } } }),
        json!({ "material": { "pinion": { "hardness": "700 HV", "elastic_limit": null, "flow_pressure": null } } }),
        json!({ "operation": { "temperature_deviation": "3 K" }, "lubricant": {
            "density_temperature": "15 °C", "thermal_expansion": "0.0007 1/K", "pressure_viscosity": "15 1/GPa",
            "pressure_viscosity_factor": 1.0, "limiting_shear_temperature": "0.003 1/K", "thermal_conductivity": "0.14 W/(m K)",
            "heat_capacity": "2000 J/(kg K)"
        } }),
        json!({ "lubricant": { "viscosity": { "law": "iso-vg", "at_40": null, "at_100": null, "grade": 32.0, "viscosity_index": 130.0 } } }),
        json!({ "lubricant": { "viscosity": { "law": "vogel", "at_40": null, "at_100": null, "limit_viscosity": "0.06 mPa s",
            "slope_kelvin": 900.0, "pole_kelvin": 170.0 } } }),
        json!({ "lubricant": { "temperature_coefficient": "0.03 1/K", "viscosity": { "law": "given", "at_40": null, "at_100": null,
            "dynamic_viscosity": "7 mPa s", "temperature": "90 °C" } } }),
        json!({ "operation": { "bulk_temperature": null, "oil_temperature": "90 °C", "bulk": { "law": "network",
            "pinion_to_oil": "12 W/K", "wheel_to_oil": "30 W/K", "between": "3 W/K" } } }),
        json!({ "operation": { "running_in": { "torque": "302 N m", "engagements": 1e3 } } }),
        json!({ "surface": { "noise_cutoff": "2.5 um", "outliers": 6.0, "pinion": { "range": "0.2 mm .. 2.9 mm" } } }),
        json!({ "surface": { "pinion": { "dx": "0.5 um" } } }),
        json!({ "surface": { "pinion": { "base_radius": "20.6 mm" } } }),
        flank(json!({ "diameter": "44 mm", "x": "0.5 mm" })),
        flank(json!({ "radius": "22 mm" })),
        flank(json!({ "roll_length": "6 mm" })),
        flank(json!({ "roll_angle": "16 deg" })),
        flank(json!({ "position": "6 mm" })),
        json!({ "surface": { "pinion": { "traces": [{ "file": "../profiles/ground_pinion.csv", "y": "12 mm", "from": "root",
            "range": "0.2 mm .. 2.9 mm", "at": { "diameter": "44 mm" } }], "file": null } } }),
        json!({ "surface": { "pinion": { "file": null, "like": ["../profiles/ground_pinion.csv"],
            "after": ["../profiles/ground_pinion.csv"], "state": 0.5 } } }),
        json!({ "surface": { "pinion": { "file": null, "like": ["../profiles/ground_pinion.csv"],
            "after": [{ "file": "../profiles/ground_pinion.csv", "engagements": 1e4 }], "engagements": 5e3 } } }),
        json!({ "model": { "load_share": "lambda-star" }, "surface": {
            "pinion": { "file": null, "rq": "0.4 um", "ra": "0.32 um", "rz": "2.4 um", "rpk": "0.3 um", "asperity_radius": "20 um" },
            "wheel": { "file": null, "mirrored": null, "rq": "0.4 um" }
        } }),
        json!({ "model": { "window": 3.0, "stiffness_factor": 0.8, "face_coupling": 1.55, "friction_scale": 1.0,
            "film_friction": { "iso-14179-2": 1.0 }, "boundary_friction": 0.09, "boundary_layer": "10 nm", "lay": 0.08,
            "hysteresis": "0.5 %", "tolerance": 1e-8, "full_film": "ehl-transient", "ehl": { "travel": 20.0 } } }),
        json!({ "model": { "film_friction": { "constant": 0.04 }, "inlet_layer": "1 um", "inner_boundary": 0.75,
            "load_distribution": { "table": [[0.0, 0.5], [1.0, 0.5]] } } }),
        json!({ "paper": { "position": 0.25, "delta_step": "80 nm", "numerical_error": "1 %" } }),
        json!({ "calibration": {
            "boundary_friction": { "value": 0.09, "low": 0.08, "high": 0.1 },
            "boundary_layer": { "value": "10 nm", "low": "8 nm", "high": "13 nm" },
            "limiting_shear": { "value": 0.06, "low": 0.05, "high": 0.07 },
            "eyring_stress": { "value": "9 MPa", "low": "6 MPa", "high": "13 MPa" },
            "correlations": [{ "between": ["boundary_friction", "boundary_layer"], "value": -0.5 }]
        } }),
        json!({ "gearbox": { "temperature": "85 °C", "seals": [{ "shaft": "pinion", "diameter": "40 mm" }],
            "jet": { "flow": "2.5 l/min", "speed": "20 m/s" }, "bearings": [
            bearing("deep-groove-ball", json!({ "r2": 1.7, "static_rating": "11 kN" })),
            bearing("tapered-roller", json!({ "r2": 10.9, "axial_factor": 1.6, "s1": 0.019, "s2": 2.0, "mu_ehl": 0.002 })),
        ] } }),
        json!({ "micropitting": { "load_factor": 1.21, "permissible": 0.2, "ra": ["0.3 um", "0.3 um"] } }),
        json!({ "map": { "torque_max": "300 N m", "speed_max": "12000 1/min" }, "vehicle": { "mass": "1800 kg", "wheel_radius": "335 mm",
            "ratio": 9.8, "drag_area": "0.6 m2", "rolling_resistance": 0.009, "inertia_factor": 1.04, "grade": "2 %" } }),
    ]
}

/// Whether a key takes a count, which a step of the run refuses.
fn is_count(key: &str) -> bool {
    let counts = [
        "positions",
        "offsets",
        "depths",
        "power",
        "row",
        "rows",
        "tooth",
        "teeth",
        "columns",
        "x",
        "z",
        "records",
        "cells",
        "engagements",
        "per_planet",
        "seed",
    ];
    let name = key.rsplit('.').next();
    name.is_some_and(|name| counts.contains(&name)) && !key.ends_with("at.x")
}

/// The key of the first of several equal tables.
fn of_first(key: &str) -> String {
    let of_pinion = key
        .replace(".wheel", ".pinion")
        .replace("surface.coast.", "surface.");
    of_pinion
        .replace(".traces.", ".")
        .replace(".like.", ".")
        .replace(".after.", ".")
        .replace(".root_relief.", ".tip_relief.")
}

/// `base` with the keys of `change`; `null` removes a key.
fn merged(mut base: Value, change: &Value) -> Value {
    let Some(keys) = change.as_object() else {
        return change.clone();
    };
    if !base.is_object() {
        base = json!({});
    }
    for (key, value) in keys {
        base[key] = merged(base[key].take(), value);
        if let (Value::Null, Some(base)) = (value, base.as_object_mut()) {
            base.remove(key);
        }
    }
    base
}

/// A value with another one instead of one of its entries.
type Replace<'a> = Box<dyn Fn(Value) -> Value + 'a>;

/// Every way to scale one number, which is not zero, of `value` by `factor`, with the path of its key.
fn scaled(value: &Value, path: &str, factor: f64, found: &mut Vec<(String, Value)>) {
    let below = |name: &str| format!("{path}.{name}").trim_start_matches('.').to_owned();
    let mut inner: Vec<(String, Value, Replace<'_>)> = Vec::new();
    match value {
        Value::Object(keys) => {
            for (key, old) in keys {
                let with = move |new| {
                    let mut keys = keys.clone();
                    keys[key] = new;
                    Value::Object(keys)
                };
                inner.push((below(key), old.clone(), Box::new(with)));
            }
        }
        Value::Array(entries) => {
            for (index, old) in entries.iter().enumerate() {
                let with = move |new| {
                    let mut entries = entries.clone();
                    entries[index] = new;
                    Value::Array(entries)
                };
                inner.push((path.to_owned(), old.clone(), Box::new(with)));
            }
        }
        Value::Number(number) => {
            let number = factor * number.as_f64().unwrap();
            if number != 0.0 {
                found.push((path.to_owned(), json!(number)));
            }
        }
        Value::String(text) => {
            let (number, unit) = text.split_once(' ').unwrap_or((text, ""));
            if let Ok(number) = number.parse::<f64>() {
                let text = format!("{} {unit}", factor * number);
                found.push((path.to_owned(), json!(text)));
            }
        }
        _ => {}
    }
    for (path, old, with) in inner {
        let mut scaled_below = Vec::new();
        scaled(&old, &path, factor, &mut scaled_below);
        found.extend(
            scaled_below
                .into_iter()
                .map(|(path, new)| (path, with(new))),
        );
    }
}

#[test]
fn a_number_a_thousand_times_off_is_refused_or_noted_first() {
    let e_drive = e_drive();
    let base = serde_json::to_value(&e_drive.case.input).unwrap();
    let tried = |value: Value| {
        let input: CaseInput = serde_json::from_value(value).map_err(|error| error.to_string())?;
        let case = e_drive.with(|case| *case = input);
        let case = case.map_err(|error| error.to_string())?;
        let mut warnings = case.warnings.clone().into_iter();
        Ok::<_, String>(
            warnings
                .find(|warning| warning.code == "W201")
                .map(|warning| warning.text),
        )
    };
    let mut seen = BTreeSet::new();
    let mut wrong = Vec::new();
    for change in [vec![base.clone()], usual_cases()].concat() {
        let found = tried(merged(base.clone(), &change));
        assert_eq!(found, Ok(None), "{change}");
        for factor in [1e3, 1e-3] {
            let mut off = Vec::new();
            scaled(&change, "", factor, &mut off);
            for (key, change) in off.into_iter().filter(|(key, _)| !is_count(key)) {
                let range = range_of(&key).unwrap();
                seen.insert(of_first(&key));
                // Near zero a signed number is usual.
                let is_judged = factor > 1.0 || range.usual[0] > 0.0;
                if is_judged && tried(merged(base.clone(), &change)) == Ok(None) {
                    wrong.push(format!("{key}, {factor} times, in {change}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    let all = numbers_of(&schema()).into_iter();
    let all = all.filter(|key| !is_count(key)).map(|key| of_first(&key));
    // Keys of bearings in a gear train, and of scans, which these cases do not have.
    let of_others = [
        "gearbox.bearings.at",
        "gearbox.bearings.planet_mass",
        "surface.pinion.dy",
    ];
    seen.extend(of_others.map(str::to_owned));
    let left_out: BTreeSet<String> = all.filter(|key| !seen.contains(key)).collect();
    assert!(left_out.is_empty(), "{left_out:#?}");
}
