//! Limits of the estimated time and memory.

use asperity::case::LoadedCase;
use asperity::pipeline::Kept;
use asperity_core::Code;
use asperity_studies::estimate::{Cost, estimate};

use crate::args::WorkArgs;
use crate::failure::Failure;

/// Rejects `runs` runs of `meshes` with an estimated time or memory above the limits.
pub fn check_work<'a>(
    limits: &WorkArgs,
    meshes: impl IntoIterator<Item = &'a LoadedCase>,
    fields: &Kept,
    runs: usize,
) -> Result<(), Failure> {
    // A case without an estimate has no result either; the run reports the error.
    match estimate(meshes, fields) {
        Ok(estimate) => check(limits, &estimate, runs),
        Err(_) => Ok(()),
    }
}

fn check(limits: &WorkArgs, estimate: &Cost, runs: usize) -> Result<(), Failure> {
    const HOUR: f64 = 3600.0;
    const GIGABYTE: f64 = 1e9;
    let hours = estimate.seconds * runs as f64 / HOUR;
    let gigabytes = estimate.bytes / GIGABYTE;
    let contacts = estimate.contacts * runs;
    let refused = |much: String, option: &str, limit: f64, least: f64| {
        Err(Failure::new(
            Code::E209,
            format!(
                "{contacts} rough contacts take about {much} (limit {limit}); reduce model.positions or \
                 model.offsets, or pass {option} {:.0}",
                least.ceil()
            ),
        ))
    };
    if hours > limits.max_hours {
        return refused(
            format!("{hours:.1} h"),
            "--max-hours",
            limits.max_hours,
            hours,
        );
    }
    if gigabytes > limits.max_gb {
        let much = format!("{gigabytes:.1} GB of memory");
        return refused(much, "--max-gb", limits.max_gb, gigabytes);
    }
    Ok(())
}
