//! The study of ridges against the study of sensitivities.

use std::path::Path;

use asperity::case;
use asperity_studies::ridges::ridges;
use asperity_studies::sensitivity::sensitivity;

#[test]
fn the_octaves_add_up_to_the_change_that_the_sensitivity_finds() {
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let few = |input: &mut case::CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(1));
    };
    let case = case::load_with(file, &few).unwrap();
    let by_log_height = ridges(&case, &|_, _| {}).unwrap().found.by_log_height_w;
    let changes = sensitivity(&case, &|_, _| {}).unwrap().rows;
    let of_heights = |to: &str| {
        let row = (changes.iter()).find(|row| row.what.starts_with("heights") && row.to == to);
        row.and_then(|row| row.effect).unwrap().difference_w
    };
    let change = of_heights("× 1.25") - of_heights("× 0.8");
    let expected = change / (1.25_f64 / 0.8).ln();
    let error = by_log_height / expected - 1.0;
    assert!(
        error.abs() < 0.1,
        "{by_log_height} W by the gradient, {expected} W by runs"
    );
}
