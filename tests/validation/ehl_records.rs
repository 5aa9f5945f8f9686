//! Solved asperity share against our own records of the mixed EHL contact, the reference solution (gate T9).
//!
//! The records are the table of `docs/EHL.md`; the conditions are those of the example that made it. Share of a record: mean of
//! the loads below 20 and 50 nm. Six smooth thin films, where the two differ by more than 0.15, have no defined share; they are
//! left out of the gate, and printed with it. Both sides are isothermal, with ridges across the face.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

use asperity::ehl::RecordSettings;
use asperity::lubrication::solved_shares;
use asperity::reference_solution::{LARGEST_ROUGHNESS, RefereeContact, RefereeSettings};
use rayon::prelude::*;

use crate::gate::Estimate;

#[path = "../../crates/asperity/examples/mixed_ehl_records.rs"]
#[allow(
    dead_code,
    reason = "the example also makes the records, which takes minutes"
)]
mod mixed_ehl_records;

/// Difference of the loads below 20 and 50 nm above which a record has no defined share.
const UNDEFINED: f64 = 0.15;
/// Records without a defined share.
const UNDEFINED_RECORDS: usize = 6;

/// A record and the solved share over windows of the same traces.
struct Compared {
    /// Attenuated roughness over the smooth film.
    roughness_ratio: f64,
    /// Loads below 20 and 50 nm.
    below: [f64; 2],
    /// Standard error of the load below 20 nm.
    error: f64,
    solved: Estimate,
}

impl Compared {
    fn difference(&self) -> f64 {
        self.solved.value - 0.5 * (self.below[0] + self.below[1])
    }

    fn is_defined(&self) -> bool {
        self.below[1] - self.below[0] <= UNDEFINED
    }
}

/// Columns of the table of `docs/EHL.md` by the name of the condition: σ_d/h_c, load below 20 nm, its standard error, load
/// below 50 nm.
fn records() -> BTreeMap<String, [f64; 4]> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/EHL.md");
    let text = std::fs::read_to_string(file).unwrap();
    let from = text
        .find("| condition | σ_d/h_c | below 20 nm | below 50 nm | mean gap")
        .unwrap();
    let rows = text[from..].lines().skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    let number = |text: &str| text.trim().parse::<f64>().unwrap();
    let rows = rows.map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let (share, error) = cells[3].split_once('±').unwrap();
        let found = [
            number(cells[2]),
            number(share),
            number(error),
            number(cells[4]),
        ];
        (cells[1].to_owned(), found)
    });
    rows.collect()
}

fn compared() -> &'static [Compared] {
    static ROWS: OnceLock<Vec<Compared>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let records = records();
        let conditions = mixed_ehl_records::conditions();
        assert_eq!(conditions.len(), records.len());
        let rows = conditions.into_par_iter().map(|condition| {
            let [roughness_ratio, below_20, error, below_50] = records[&condition.name];
            Compared {
                roughness_ratio,
                below: [below_20, below_50],
                error,
                solved: solved(&condition),
            }
        });
        rows.collect()
    })
}

/// Solved share, mean over the windows.
fn solved(condition: &mixed_ehl_records::Condition) -> Estimate {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let loaded = condition.load(&workspace).unwrap();
    // As the records: isothermal, ridges across the face, no tip relief.
    let keys = [
        ("model.thermal", "none"),
        ("model.lay", "0"),
        ("gears.pinion.tip_relief", "none"),
        ("gears.wheel.tip_relief", "none"),
    ];
    let loaded = keys.iter().fold(loaded, |loaded, (key, value)| {
        loaded.with_key(key, value).unwrap()
    });
    let settings = RefereeSettings {
        record: RecordSettings::default(),
        eyring_stress: None,
        beginning: 0,
    };
    let contact = RefereeContact::of(&loaded, condition.position, &settings).unwrap();
    let windows = solved_shares(&loaded, &contact).unwrap();
    let n = windows.len() as f64;
    let shares: Vec<f64> = windows.iter().map(|window| window.asperity_share).collect();
    let value = shares.iter().sum::<f64>() / n;
    let squares: f64 = shares.iter().map(|share| (share - value).powi(2)).sum();
    Estimate {
        value,
        standard_error: (squares / (n - 1.0) / n).sqrt(),
    }
}

/// Root mean square and mean of the solved share minus the share of the records.
pub struct Deviation {
    pub records: usize,
    pub root_mean_square: Estimate,
    pub mean: f64,
}

/// Deviations from the records up to the ratio of roughness to film beyond which they are not a reference, or from all; with or
/// without those that have no defined share. Errors of the records are independent.
pub fn deviation(within_reference: bool, with_undefined: bool) -> Deviation {
    let rows = compared().iter();
    let rows: Vec<&Compared> = rows
        .filter(|row| !within_reference || row.roughness_ratio < LARGEST_ROUGHNESS)
        .filter(|row| with_undefined || row.is_defined())
        .collect();
    let n = rows.len() as f64;
    let squares: f64 = rows.iter().map(|row| row.difference().powi(2)).sum();
    let value = (squares / n).sqrt();
    let errors = rows.iter().map(|row| {
        let error = row.error.hypot(row.solved.standard_error);
        (row.difference() * error / (n * value)).powi(2)
    });
    Deviation {
        records: rows.len(),
        root_mean_square: Estimate {
            value,
            standard_error: errors.sum::<f64>().sqrt(),
        },
        mean: rows.iter().map(|row| row.difference()).sum::<f64>() / n,
    }
}

#[test]
fn the_solved_share_is_compared_with_every_record_that_has_one() {
    let records = records();
    assert_eq!(records.len(), 57);
    assert_eq!(records["e-ground_60_0.1"], [1.12, 0.1570, 0.0184, 0.2082]);
    let undefined = compared().iter().filter(|row| !row.is_defined()).count();
    assert_eq!(undefined, UNDEFINED_RECORDS);
    let within = deviation(true, false);
    // The comparison of docs/EHL.md, on other windows, has a root mean square of .04.
    assert!(
        within.root_mean_square.value < 0.08,
        "{}",
        within.root_mean_square.value
    );
}
