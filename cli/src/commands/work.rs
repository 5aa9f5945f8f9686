//! Estimate of the work before it is done, and its limit.

use asperity::case::LoadedCase;
use asperity::case::planetary::LoadedPlanetary;
use asperity::pipeline::KeptFields;
use asperity_studies::estimate::{Estimate, estimate, estimate_of_set};

use crate::args::WorkArgs;
use crate::failure::Failure;

/// Refuses `runs` runs of a case whose time or memory is estimated above the limits.
pub fn check_work(
    limits: &WorkArgs,
    loaded: &LoadedCase,
    kept: &KeptFields,
    runs: usize,
) -> Result<(), Failure> {
    // A case that has no estimate has no run, which says why.
    match estimate(loaded, kept) {
        Ok(found) => check(limits, &found, runs),
        Err(_) => Ok(()),
    }
}

/// The same for both meshes of a planetary set.
pub fn check_work_of_set(
    limits: &WorkArgs,
    set: &LoadedPlanetary,
    kept: &KeptFields,
) -> Result<(), Failure> {
    match estimate_of_set(set, kept) {
        Ok(found) => check(limits, &found, 1),
        Err(_) => Ok(()),
    }
}

fn check(limits: &WorkArgs, found: &Estimate, runs: usize) -> Result<(), Failure> {
    const HOUR: f64 = 3600.0;
    const GIGABYTE: f64 = 1e9;
    let hours = found.seconds * runs as f64 / HOUR;
    let gigabytes = found.bytes / GIGABYTE;
    let contacts = found.contacts * runs;
    let refused = |much: String, option: &str, limit: f64, least: f64| {
        Err(Failure::new(
            "E209",
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
