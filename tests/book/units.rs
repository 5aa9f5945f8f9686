//! The page of units says what the program reads.

use asperity_core::quantity::QUANTITIES;

#[test]
fn the_page_of_units_lists_every_quantity_with_its_units() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/UNITS.md");
    let page = std::fs::read_to_string(path).unwrap();
    for quantity in QUANTITIES {
        let units: Vec<String> = quantity
            .units
            .iter()
            .map(|unit| {
                std::iter::once(unit.symbol)
                    .chain(unit.spellings.iter().copied())
                    .map(|spelling| format!("`{spelling}`"))
                    .collect::<Vec<_>>()
                    .join(" = ")
            })
            .collect();
        let row = format!(
            "| {} | {} | {} |",
            quantity.name,
            quantity.si_unit,
            units.join(", ")
        );
        assert!(page.contains(&row), "docs/UNITS.md lacks the row\n{row}");
    }
}
