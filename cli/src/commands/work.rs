//! Estimate of the work before it is done, and its limit.

use asperity::case::LoadedCase;
use asperity_studies::estimate::estimate;

use crate::args::WorkArgs;
use crate::failure::Failure;

/// Refuses `runs` runs of a case whose time or memory is estimated above the limits.
pub fn check_work(limits: &WorkArgs, loaded: &LoadedCase, runs: usize) -> Result<(), Failure> {
    const HOUR: f64 = 3600.0;
    const GIGABYTE: f64 = 1e9;
    // A case that has no estimate has no run, which says why.
    let Ok(found) = estimate(loaded) else {
        return Ok(());
    };
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
