//! README, documents and `tests/golden/evidence` have the tables that the tests compute.
//!
//! In a document a table is between `<!-- name -->` and `<!-- end -->`. A table that no document shows is the file `NAME.csv` of
//! `tests/golden/evidence`. `ASPERITY_WRITE=1 cargo test --workspace --test validation document` writes both.

use std::path::Path;

use crate::{
    band, ehl_records, evidence, film_records, fluid_film, full_film_losses, gates, gear_tool,
    load_share, measured, oil_file, paper_formulation, paper_statements, parity, petry_johnson,
    rough_contact, share_laws, shipped_cases, spot_values, steady_films, table_2,
};

/// Every table by the name of its place.
fn tables() -> Vec<(&'static str, String)> {
    let compared = [
        table_2::geometry(),
        table_2::points(),
        table_2::films(),
        table_2::friction(),
        table_2::film_parameter(),
        full_film_losses::losses(),
        spot_values::spot_values(),
        gear_tool::spur_pairs(),
        gear_tool::helical_pairs(),
        petry_johnson::losses(),
        fluid_film::at_the_pitch_point(),
        rough_contact::smooth_flanks(),
        steady_films::films(),
        paper_formulation::printed_deformation(),
    ];
    let mut tables: Vec<_> = compared
        .iter()
        .map(|table| (table.name, table.markdown()))
        .collect();
    tables.push(("petry-johnson-measured", petry_johnson::beside_measured()));
    tables.push(("gates-that-count", gates::gate_table()));
    tables.push(("gates", gates::all_gates()));
    tables.push(("ehl-laws", ehl_records::law_table()));
    tables.push(("ehl-classes", film_records::class_table()));
    tables.push(("ehl-blind", film_records::blind_table()));
    tables.push(("ehl-second-blind", film_records::second_blind_table()));
    tables.push(("ehl-coverage", film_records::coverage_table()));
    tables.push(("ehl-models", film_records::model_table()));
    tables.push(("ehl-parts", film_records::part_table()));
    tables.push(("ehl-short-waves", film_records::short_wave_table()));
    tables.push(("ehl-part-load", film_records::part_load_table()));
    tables.extend(film_records::other_part_load_tables());
    tables.push(("load-share-laws", share_laws::share_table()));
    tables.push(("cold-oil", measured::cold_table()));
    tables.push(("band", band::table()));
    tables.push(("oil-file", oil_file::table()));
    tables.push(("one-key", load_share::one_key_changed()));
    tables.push(("gate-count", parity::count()));
    tables.push(("film", fluid_film::over_thickness()));
    tables.push(("paper-statements", paper_statements::table()));
    tables
}

fn mark(name: &str) -> String {
    format!("<!-- {name} -->\n")
}

/// `document` with each table in its place.
fn with_tables(mut document: String, tables: &[(&str, String)]) -> String {
    for (name, table) in tables {
        let begin = mark(name);
        let Some(place) = document.find(&begin) else {
            continue;
        };
        let start = place + begin.len();
        let length = document[start..].find("<!-- end -->").unwrap();
        document.replace_range(start..start + length, table);
    }
    document
}

#[test]
fn the_documents_show_what_the_tests_compute() {
    let tables = tables();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = vec![root.join("README.md")];
    for folder in ["docs", "docs/model"] {
        let entries = std::fs::read_dir(root.join(folder)).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        files.extend(paths.filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    let mut documents = String::new();
    for file in files {
        documents += &hold(&file, &tables);
    }
    let mut stored = Vec::new();
    for (name, table) in &tables {
        match documents.matches(&mark(name)).count() {
            0 => {
                evidence::hold(name, table);
                stored.push(*name);
            }
            places => assert_eq!(places, 1, "{name} has two places"),
        }
    }
    let others = shipped_cases::NAMES
        .into_iter()
        .chain(evidence::OF_REFUSED_LAW);
    evidence::hold_names(stored.into_iter().chain(others));
}

/// Compares or writes the tables of a document, and returns it.
fn hold(path: &Path, tables: &[(&str, String)]) -> String {
    let document = std::fs::read_to_string(path).unwrap();
    let made = with_tables(document.clone(), tables);
    if evidence::is_writing() {
        std::fs::write(path, &made).unwrap();
        return made;
    }
    for (shown, made) in document.lines().zip(made.lines()) {
        assert_eq!(
            shown,
            made,
            "{}: not up to date; see the top of this file",
            path.display()
        );
    }
    assert_eq!(document.len(), made.len(), "{} is stale", path.display());
    document
}
