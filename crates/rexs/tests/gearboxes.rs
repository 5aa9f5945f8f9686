//! Gearboxes made up for these tests: a helical pair behind another, a planetary set, a pair of bevel gears.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::io::{Cursor, Write};

use asperity_core::Code;
use asperity_rexs::{Flanks, Model, StageKind, case_text, operating_points, stages};

/// Two stages on three shafts, and one of bevel gears; the wheel is gear 1 of the second.
const CHAIN: &str = include_str!("gearboxes/chain.rexs");
const PLANETARY: &str = include_str!("gearboxes/planetary.rexs");

fn chain() -> Model {
    Model::read(CHAIN.as_bytes()).unwrap()
}

fn text_of(model: &Model, stage: usize) -> asperity_rexs::CaseText {
    case_text(model, "box.rexs", stage, 1, &Flanks::default()).unwrap()
}

fn has(toml: &str, line: &str) {
    assert!(
        toml.lines().any(|found| found == line),
        "{line}\nin\n{toml}"
    );
}

#[test]
fn stages_are_in_the_order_of_the_file_and_the_pinion_is_the_smaller_gear() {
    let stages = stages(&chain()).unwrap();
    let kinds: Vec<&StageKind> = stages.iter().map(|stage| &stage.kind).collect();
    let StageKind::Pair { pinion, wheel, .. } = kinds[0] else {
        panic!("{kinds:?}");
    };
    assert_eq!((pinion.as_str(), wheel.as_str()), ("11", "12"));
    let StageKind::Pair { pinion, wheel, .. } = kinds[1] else {
        panic!("{kinds:?}");
    };
    assert_eq!((pinion.as_str(), wheel.as_str()), ("13", "14"));
    assert!(matches!(kinds[2], StageKind::Other { kind } if kind == "bevel_stage"));
}

/// The model is that of `CHAIN`.
fn is_chain(bytes: &[u8]) {
    let model = Model::read(bytes).unwrap();
    assert_eq!(model.components.len(), chain().components.len());
    assert_eq!(text_of(&model, 1).toml, text_of(&chain(), 1).toml);
}

#[test]
fn what_a_spectrum_sums_up_is_no_second_component() {
    let id = chain().components.keys().next().unwrap().clone();
    for aside in [
        "accumulation",
        "vendor_data",
        "results",
        "custom",
        "history",
        "components_of_before",
    ] {
        let sums = format!(
            r#"<{aside}><component id="{id}" type="x"><attribute id="operating_time" unit="h">5000</attribute></component></{aside}>"#
        );
        let spectrum = format!("<load_spectrum>{sums}</load_spectrum></model>");
        is_chain(CHAIN.replace("</model>", &spectrum).as_bytes());
        is_chain(
            CHAIN
                .replace("<components>", &format!("{sums}<components>"))
                .as_bytes(),
        );
    }
}

#[test]
fn a_model_is_read_in_the_encoding_that_it_has() {
    let start = CHAIN.find("<model").unwrap();
    let named = |encoding: &str| {
        format!("<?xml version='1.0' encoding=\"{encoding}\"?>\n<!-- Prüfstand für Getriebe -->\n")
            + &CHAIN[start..]
    };
    let in_latin = |text: String| text.chars().map(|c| c as u8).collect::<Vec<u8>>();
    assert!(CHAIN[start..].is_ascii());
    is_chain(named("UTF-8").as_bytes());
    is_chain(format!("\u{feff}{}", named("utf-8")).as_bytes());
    for label in ["ISO-8859-1", "windows-1252", "latin1"] {
        is_chain(&in_latin(named(label)));
    }
    let words = |mark: &str| -> Vec<u16> {
        (mark.to_owned() + &named("UTF-16"))
            .encode_utf16()
            .collect()
    };
    for mark in ["\u{feff}", ""] {
        is_chain(
            &words(mark)
                .iter()
                .flat_map(|w| w.to_le_bytes())
                .collect::<Vec<u8>>(),
        );
        is_chain(
            &words(mark)
                .iter()
                .flat_map(|w| w.to_be_bytes())
                .collect::<Vec<u8>>(),
        );
    }
    // Entities, comments, instructions and blanks between elements say nothing else.
    let plain = named("UTF-8");
    for (old, new) in [
        ("Prüfstand", "Pr&#252;fstand"),
        ("</components>", "<!-- end --></components>"),
        ("<components>", "<?sort by id?><components>"),
        ("\n", "\r\n\r\n"),
        ("\"", "'"),
        (
            "<attribute id=\"number_of_teeth\">20<",
            "<attribute unit=\"\" id=\"number_of_teeth\"> &#50;0 <",
        ),
    ] {
        let text = plain.replace(old, new);
        assert!(text != plain, "{old}");
        is_chain(text.as_bytes());
    }
    // A declaration in a comment, or cut off, is none.
    is_chain(named("UTF-8").replace("Prüfstand", "encoding=").as_bytes());
    assert!(Model::read(b"<?xml encoding=").is_err());
}

#[test]
fn each_number_of_a_case_names_its_attribute() {
    let case = text_of(&chain(), 1);
    let toml = &case.toml;
    has(
        toml,
        "teeth = [20, 41]  # cylindrical_gear 11, 12: number_of_teeth",
    );
    has(
        toml,
        "module = \"2 mm\"  # cylindrical_gear 11, 12: normal_module",
    );
    has(
        toml,
        "helix = \"15 deg\"  # cylindrical_gear 11, 12: helix_angle_reference_diameter, without sign",
    );
    has(
        toml,
        "profile_shift = [0.2, -0.1]  # cylindrical_gear_flank 21, 22: addendum_modification_coefficient",
    );
    has(
        toml,
        "pinion.tip_chamfer = \"0.1 mm\"  # cylindrical_gear_flank 21: tooth_tip_chamfer",
    );
    has(
        toml,
        "pinion.ra = \"0.4 um\"  # cylindrical_gear 11: arithmetic_mean_roughness_flank_iso_4287_1997",
    );
    has(
        toml,
        "density = \"880 kg/m3\"  # lubricant 40: density_at_15_degree_celsius",
    );
    has(
        toml,
        "pinion.flow_pressure = \"6864.655 MPa\"  # material 41: surface_hardness_vickers, 700 HV",
    );
    let said = case.notes.join("\n");
    assert!(
        said.contains(
            "12 (Wheel): tip_diameter 1 mm on a reference diameter of 84.893 mm is ignored"
        ),
        "{said}"
    );
    assert!(said.contains("surface.wheel.file"), "{said}");
}

#[test]
fn an_external_pair_without_shifts_leaves_their_division_to_the_case() {
    let text = CHAIN.replace("addendum_modification_coefficient", "unknown_attribute");
    let case = text_of(&Model::read(text.as_bytes()).unwrap(), 1);
    assert!(
        case.toml.contains("\ncentre_distance = \""),
        "{}",
        case.toml
    );
    assert!(!case.toml.contains("profile_shift"), "{}", case.toml);
}

#[test]
fn speed_and_torque_pass_through_the_ratios() {
    let model = chain();
    let stages = stages(&model).unwrap();
    let [first, second] = [0, 1].map(|k| operating_points(&model, &stages[k]).unwrap());
    assert_eq!(first.len(), 2);
    let value = |found: &Option<(f64, String)>| found.as_ref().unwrap().0;
    assert_eq!(value(&first[0].torque), 100.0);
    assert_eq!(value(&first[0].speed), 1500.0);
    assert_eq!(value(&first[1].temperature), 75.0);
    assert_eq!(first[1].share, Some(60.0));
    // The power is the same at every shaft.
    assert!((value(&second[0].torque) - 100.0 * 41.0 / 20.0).abs() < 1e-10);
    assert!((value(&second[0].speed) - 1500.0 * 20.0 / 41.0).abs() < 1e-10);
    let other = case_text(&model, "box.rexs", 1, 2, &Flanks::default()).unwrap();
    assert!(
        other
            .toml
            .contains("torque = \"50 N m\"  # pinion; load case 2"),
        "{}",
        other.toml
    );
    assert!(
        other.toml.contains("# load case 1 (40 %), torque 100 N m"),
        "{}",
        other.toml
    );
}

#[test]
fn a_planetary_set_counts_once() {
    let model = Model::read(PLANETARY.as_bytes()).unwrap();
    assert_eq!(stages(&model).unwrap().len(), 1);
    let toml = text_of(&model, 1).toml;
    has(
        &toml,
        "teeth = [27, 24, -75]  # sun, planet, ring cylindrical_gear 1, 2, 4: number_of_teeth",
    );
    assert!(toml.contains("planets = 2"), "{toml}");
    assert!(toml.contains("centre_distance = \"38.25 mm\""), "{toml}");
}

#[test]
fn json_and_zip_say_what_xml_says() {
    let xml = chain();
    let value = |text: &str| serde_json::Value::from(text.to_owned());
    let component = |component: &asperity_rexs::Component| {
        let attributes: Vec<_> = component
            .attributes
            .iter()
            .map(|(id, attribute)| {
                let number = attribute.text.parse::<f64>();
                let kind = if number.is_ok() {
                    "floating_point"
                } else {
                    "string"
                };
                let held = number.map_or_else(|_| value(&attribute.text), |number| number.into());
                serde_json::json!({ "id": id, "unit": attribute.unit, kind: held })
            })
            .collect();
        serde_json::json!({
            "id": component.id, "type": component.kind, "name": component.name,
            "attributes": attributes,
        })
    };
    let components: Vec<_> = xml.components.values().map(component).collect();
    let relations: Vec<_> = xml
        .relations
        .iter()
        .map(|relation| {
            let refs: Vec<_> = relation
                .roles
                .iter()
                .map(|(role, id)| serde_json::json!({ "role": role, "id": id }))
                .collect();
            serde_json::json!({ "id": relation.id, "type": relation.kind, "refs": refs })
        })
        .collect();
    let cases: Vec<_> = xml
        .load_cases
        .iter()
        .map(|case| {
            let components: Vec<_> = case.components.values().map(component).collect();
            serde_json::json!({ "id": case.id, "components": components })
        })
        .collect();
    let json = serde_json::json!({ "model": {
        "version": xml.version, "applicationId": xml.program, "components": components,
        "relations": relations, "load_spectrum": { "id": 1, "load_cases": cases },
    }});
    let json = json.to_string();
    let model = Model::read(json.as_bytes()).unwrap();
    for stage in [1, 2] {
        assert_eq!(text_of(&model, stage), text_of(&xml, stage));
    }
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    zip.start_file("gearbox/box.rexsj", options).unwrap();
    zip.write_all(json.as_bytes()).unwrap();
    // Files that systems add.
    for name in [
        "__MACOSX/gearbox/._box.rexsj",
        "gearbox/._box.rexs",
        "__MACOSX/._gearbox.rexs",
    ] {
        zip.start_file(name, options).unwrap();
        zip.write_all(b"\0\x05\x16\x07").unwrap();
    }
    let bytes = zip.finish().unwrap().into_inner();
    assert_eq!(Model::read(&bytes).unwrap(), model);
}

/// A damaged file and what its refusal says.
#[test]
fn damaged_files_name_component_and_attribute() {
    let cases: &[(&str, &str, &str)] = &[
        ("<relations>", "<relations", "line "),
        ("</model>", "", "the file ends inside of an element"),
        ("<model ", "<gearbox ", "expected <model>, not <gearbox>"),
        (
            "version=\"1.4\"",
            "version=\"3.0\"",
            "REXS version \"3.0\" is not known",
        ),
        ("version=\"1.4\"", "", "REXS version \"\" is not known"),
        (
            "<attribute id=\"number_of_teeth\">20</attribute>",
            "",
            "cylindrical_gear 11 (Pinion): attribute number_of_teeth is missing",
        ),
        (
            ">20</attribute>",
            ">20.5</attribute>",
            "11 (Pinion): attribute number_of_teeth is \"20.5\"",
        ),
        (
            ">20</attribute>",
            ">twenty</attribute>",
            "attribute number_of_teeth is \"twenty\"",
        ),
        (
            ">20</attribute>",
            ">0</attribute>",
            "attribute number_of_teeth is \"0\"",
        ),
        (
            ">20</attribute>",
            ">NaN</attribute>",
            "attribute number_of_teeth is \"NaN\"",
        ),
        (
            ">20</attribute>",
            ">1e300</attribute>",
            "attribute number_of_teeth is \"1e300\"",
        ),
        (
            "<attribute id=\"normal_module\" unit=\"mm\">2</attribute>",
            "",
            "cylindrical_gear 11 (Pinion): attribute normal_module is missing",
        ),
        (
            "<attribute id=\"normal_module\" unit=\"mm\">2</attribute>",
            "<attribute id=\"normal_module\" unit=\"furlong\">2</attribute>",
            "attribute normal_module is in \"furlong\", expected mm",
        ),
        (
            "<attribute id=\"normal_module\" unit=\"mm\">2</attribute>",
            "<attribute id=\"normal_module\" unit=\"mm\">2.1</attribute>",
            "12 (Wheel): attribute normal_module is \"2\", which differs from its mating gear",
        ),
        (
            "unit=\"deg\">15<",
            "unit=\"deg\">16<",
            "attribute helix_angle_reference_diameter is \"-15\"",
        ),
        (
            "<attribute id=\"face_width\" unit=\"mm\">21</attribute>",
            "",
            "12 (Wheel): attribute face_width is missing",
        ),
        (
            "<ref id=\"11\" role=\"gear_1\"/>",
            "",
            "relation 1 (stage): role gear_1 is missing",
        ),
        (
            "<ref id=\"11\" role=\"gear_1\"/>",
            "<ref id=\"99\" role=\"gear_1\"/>",
            "relation 1 (stage): gear_1 is component 99, which is missing",
        ),
        (
            "<component id=\"12\" type=\"cylindrical_gear\"",
            "<component id=\"11\" type=\"cylindrical_gear\"",
            "component 11 occurs twice",
        ),
        (
            "<attribute id=\"viscosity_at_100_degree_celsius\" unit=\"mm^2 / s\">11</attribute>",
            "",
            "lubricant 40 (VG 100): attribute viscosity_at_100_degree_celsius is missing",
        ),
        (
            "unit=\"kg / dm^3\">0.88<",
            "unit=\"kg\">0.88<",
            "attribute density_at_15_degree_celsius is in \"kg\"",
        ),
        (
            "<attribute id=\"rotational_speed\" unit=\"1 / min\">1500<",
            "<attribute id=\"rotational_speed\" unit=\"1 / min\">fast<",
            "attribute rotational_speed is \"fast\"",
        ),
    ];
    for (sound, damaged, said) in cases {
        assert!(CHAIN.contains(sound), "{sound}");
        let text = CHAIN.replacen(sound, damaged, 1);
        let refused = Model::read(text.as_bytes())
            .and_then(|model| case_text(&model, "box.rexs", 1, 1, &Flanks::default()));
        let error = refused.unwrap_err().to_string();
        assert!(error.contains(said), "{damaged}: {error}");
    }
}

#[test]
fn what_is_no_stage_of_cylindrical_gears_is_refused() {
    let model = chain();
    let refused = |stage, load_case| {
        case_text(&model, "box.rexs", stage, load_case, &Flanks::default()).unwrap_err()
    };
    for (stage, load_case, message) in [
        (0, 1, "there is no stage 0; the file has 3"),
        (4, 1, "there is no stage 4; the file has 3"),
        (1, 3, "there is no load case 3; the file has 2"),
        (3, 1, "stage 3 is a "),
    ] {
        let error = refused(stage, load_case);
        assert_eq!(error.code(), Code::E133);
        assert!(error.to_string().starts_with(message), "{error}");
    }
    for bytes in [
        &b""[..],
        b"PK\x03\x04",
        b"%PDF",
        b"[]",
        b"{}",
        b"{ \"model\": 1 }",
    ] {
        assert!(Model::read(bytes).is_err());
    }
}

#[test]
fn names_cannot_break_out_of_the_case() {
    let text = CHAIN.replace(
        "name=\"First stage\"",
        "name=\"a&quot;&#10;[model]&#10;x = &quot;\"",
    );
    let model = Model::read(text.as_bytes()).unwrap();
    let flanks = Flanks {
        pinion: Some("a\"b\\c.csv".into()),
        wheel: None,
    };
    let case = case_text(&model, "b\nox\".rexs", 1, 1, &flanks).unwrap();
    assert!(
        !case.toml.lines().any(|line| line.trim() == "[model]"),
        "{}",
        case.toml
    );
    assert!(
        case.toml.contains(r#"pinion.file = "a\"b\\c.csv""#),
        "{}",
        case.toml
    );
}
