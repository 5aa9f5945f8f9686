//! Symbols of a gear drawing and short forms instead of the keys of a case.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeMap;

use asperity::CaseInput;
use asperity::case::{load, markdown};
use toml::{Table, Value};

/// Tables whose symbols may be above all tables.
const ABOVE_ALL: [&str; 3] = ["gears", "operation", "lubricant"];

/// The first symbol of each key by the path of the key, as the page of the case file lists them.
fn symbols() -> BTreeMap<String, String> {
    let page = markdown().unwrap();
    let (_, listed) = page.split_once("\n## Symbols of a drawing\n").unwrap();
    let listed = listed.split("\n## ").next().unwrap();
    let (_, listed) = listed
        .split_once("`surface.pinion = \"flank.csv\"`. ")
        .unwrap();
    // `m_n` or `mn` or `m` for `gears.module`
    let rows = listed.trim().trim_end_matches('.').split(", ").map(|row| {
        let words: Vec<&str> = row.split('`').skip(1).step_by(2).collect();
        (words[words.len() - 1].to_owned(), words[0].to_owned())
    });
    let mut symbols: BTreeMap<String, String> = rows.collect();
    for (key, symbol) in symbols.clone() {
        // The page names one of two gears.
        symbols.insert(key.replacen(".pinion.", ".wheel.", 1), symbol);
    }
    // Symbol and key are the same.
    symbols.insert("lubricant.oil".to_owned(), "oil".to_owned());
    symbols
}

/// The table with the symbols of its keys; those of the tables [`ABOVE_ALL`] are moved to `top`, if there is one.
fn drawn(
    table: Table,
    above: &str,
    symbols: &BTreeMap<String, String>,
    top: &mut Option<Table>,
) -> Table {
    let mut out = Table::new();
    for (name, value) in table {
        let path = format!("{above}.{name}");
        let path = path.trim_start_matches('.');
        let value = match value {
            Value::Table(inner) => Value::Table(drawn(inner, path, symbols, top)),
            value => value,
        };
        let place = match top {
            Some(top) if symbols.contains_key(path) && ABOVE_ALL.contains(&above) => top,
            _ => &mut out,
        };
        let name = symbols.get(path).cloned().unwrap_or(name);
        place.insert(name, value);
    }
    out
}

#[test]
fn every_shipped_case_can_be_written_in_the_symbols_of_its_drawing() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let symbols = symbols();
    assert_eq!(symbols["gears.wheel.crowning"], "C_beta");
    let mut seen = 0;
    for file in std::fs::read_dir(folder).unwrap() {
        let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
        let of_keys: CaseInput = text.parse().unwrap();
        for mut top in [None, Some(Table::new())] {
            let mut table = drawn(text.parse().unwrap(), "", &symbols, &mut top);
            table.extend(top.unwrap_or_default());
            let written = toml::to_string(&table).unwrap();
            assert!(
                !written.contains("teeth") && !written.contains("torque"),
                "{written}"
            );
            assert_eq!(written.parse::<CaseInput>().unwrap(), of_keys, "{written}");
            seen += 1;
        }
    }
    assert!(seen > 6);
}

#[test]
fn a_symbol_is_named_with_its_key_and_never_replaces_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("case.toml");
    let text = "z = [23, 68]\ngears = { m_n = \"2 mm\", b = \"30 mm\" }\nn = \"3000 1/min\"\nT = \"100 N m\"\n\
        theta = \"60 °C\"\noil = \"M100\"\nsurface = { pinion = { rq = \"0.3 um\" }, wheel = { rq = \"0.3 um\" } }\n";
    std::fs::write(&file, text).unwrap();
    let loaded = load(&file, None).unwrap();
    let named = loaded
        .warnings
        .iter()
        .find(|warning| warning.code == "W202");
    let named = &named.unwrap().text;
    assert!(
        named.contains("gears.m_n is gears.module") && named.contains("T is operation.torque"),
        "{named}"
    );
    let both = text.replace("m_n =", "module = \"2 mm\", m_n =");
    let refused = both.parse::<CaseInput>().unwrap_err().to_string();
    assert!(
        refused.contains("unknown key \"gears.m_n\"") && refused.contains("module"),
        "{refused}"
    );
    let mut input = loaded.case.input.clone();
    input.set("gears.z", "[24, 68]").unwrap();
    assert_eq!(input.gears.teeth, [24, 68]);
}

/// A case with this oil and this flank of the pinion.
fn case(lubricant: &str, pinion: &str) -> Result<CaseInput, asperity::Error> {
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }}\n\
         operation = {{ torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }}\n\
         lubricant = {{ {lubricant} }}\nsurface = {{ pinion = {pinion} }}\n"
    );
    text.parse()
}

#[test]
fn two_viscosities_of_a_data_sheet_need_no_law() {
    let of = |viscosity: &str| {
        let oil = format!("viscosity = {{ {viscosity} }}, density = \"865 kg/m3\"");
        case(&oil, "{ rq = \"0.3 um\" }")
    };
    let both = "at_40 = \"68 mm2/s\", at_100 = \"10.4 mm2/s\"";
    let named = of(&format!("law = \"astm-d341\", {both}")).unwrap();
    assert_eq!(of(both).unwrap(), named);
    let grade = of("grade = \"ISO VG 68\", viscosity_index = 100").unwrap();
    let number = of("law = \"iso-vg\", grade = 68, viscosity_index = 100").unwrap();
    assert_eq!(grade, number);
    let refused = of("at_40 = \"68 mm2/s\"").unwrap_err().to_string();
    assert!(refused.contains("at_100"), "{refused}");
}

#[test]
fn a_text_in_place_of_a_flank_is_its_file() {
    let of = |pinion: &str| case("oil = \"m100\"", pinion).unwrap();
    assert_eq!(of("\"a.csv\""), of("{ file = \"a.csv\" }"));
}
