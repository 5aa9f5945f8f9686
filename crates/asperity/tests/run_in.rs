//! Flanks that run in, and what the mesh then loses.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::path::Path;

use asperity::case::{LoadedCase, load};
use asperity::result::RunInFlanks;

fn with(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let case = load(&folder.join(format!("{name}.toml")), None).unwrap();
    let few = [
        ("model.positions", "16"),
        ("model.offsets", "4"),
        ("model.run_in", "true"),
    ];
    let keys = few.iter().chain(keys);
    keys.fold(case, |case, (key, value)| {
        case.with_key(key, value).unwrap()
    })
}

fn run_in(name: &str, keys: &[(&str, &str)]) -> (f64, RunInFlanks) {
    let losses = asperity::losses(&with(name, keys), &|_, _| ()).unwrap();
    (losses.summary.loss_w, losses.run_in.unwrap())
}

#[test]
fn running_in_takes_height_and_loss_off_ground_flanks() {
    for name in ["e-drive", "e-drive-superfinished", "fzg-c", "table2"] {
        let start = std::time::Instant::now();
        let (measured, found) = run_in(name, &[]);
        println!("{name} {measured} {} {:?} {:?} {:?}", found.summary.loss_w, found.measured, found.run_in, start.elapsed());
        println!("{} {} {}", found.summary.boundary_share, found.summary.efficiency, found.running_in.first_pass_w);
        for cycle in found.cycles {
            println!("{cycle:?}");
        }
    }
}
