//! `asperity check`: checks of a case without running it.

use asperity::case::{self, DefaultUsed, LoadedCase, Train};
use asperity::message::Warning;
use asperity::pipeline::{Kept, chooses_offsets};
use asperity::{Error, Run};
use asperity_core::Code;
use asperity_report::Report;
use asperity_studies::estimate::{Cost, estimate, measured};
use serde_json::{Value, json};

use super::{keys, source};
use crate::args::{CheckArgs, Common};
use crate::failure::Failure;
use crate::output::{Progress, READING, print_json, print_report};

/// Largest number of errors that are shown.
const MOST_ERRORS: usize = 50;

/// `asperity check`
pub fn check(args: &CheckArgs, common: &Common) -> Result<(), Failure> {
    let reading = Progress::new(common.quiet, READING);
    let (source, folder) = source(&args.case)?;
    let name = source.name().to_owned();
    let findings = case::check(source, folder, &keys(&args.set));
    let (errors, valid) = (findings.errors, findings.case.map(valid_case));
    let shown = errors.iter().take(MOST_ERRORS);
    let mut failures: Vec<Failure> = shown.map(Failure::from_error).collect();
    let not_shown = errors.len() - failures.len();
    // Errors that a run would report after reading the case.
    let valid = match valid.transpose() {
        Ok(valid) => valid,
        Err(error) => {
            failures.push(Failure::about(&args.case, &error));
            None
        }
    };
    drop(reading);
    let Some(valid) = &valid else {
        if common.json {
            print_json(&report(&failures, not_shown, None))?;
        }
        for failure in &failures {
            if !common.json {
                failure.print();
            }
        }
        let count = counted(failures.len() + not_shown, "error", "errors");
        if !common.json {
            let more = match not_shown {
                0 => String::new(),
                _ => format!("; {not_shown} more than the {MOST_ERRORS} shown"),
            };
            crate::output::note(&format!("{name}: {count}{more}"));
        }
        return match failures.into_iter().next() {
            Some(first) => Err(first.printed()),
            None => Err(Failure::new(
                Code::E501,
                format!("{name}: no case and no error"),
            )),
        };
    };
    // A list that is requested is printed in full.
    let common = Common {
        notes: common.notes || args.explain_defaults,
        ..common.clone()
    };
    print_report(
        &common,
        || report(&failures, not_shown, Some(valid)),
        || report_of(&name, valid, args.explain_defaults),
        None,
    )
}

/// Report on a case without errors.
struct ValidCase {
    warnings: Vec<Warning>,
    defaults: Vec<DefaultUsed>,
    work: Cost,
    /// Meshes in which a flank has several traces.
    traced: Vec<TracedCase>,
    /// Whether the run adds offsets until the sampling error of the loss is small.
    may_need_more: bool,
}

/// Traces of a mesh in which a flank has several.
#[derive(serde::Serialize)]
struct TracedCase {
    /// Traces of pinion and wheel.
    traces: [usize; 2],
    /// Number of teeth with a trace.
    teeth: [usize; 2],
}

fn traced(loaded: &LoadedCase) -> Option<TracedCase> {
    let sampled = loaded.sampled.as_ref()?;
    Some(TracedCase {
        traces: [0, 1].map(|body: usize| sampled.traces[body].len()),
        teeth: loaded.surfaces.teeth()?,
    })
}

fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

fn valid_case(train: Train) -> Result<ValidCase, Error> {
    let warnings = Run::new(&train).check()?;
    let fields = Kept::Highest;
    let work = measured(train.cases(), &fields).or_else(|_| estimate(train.cases(), &fields))?;
    let may_need_more = train.cases().any(chooses_offsets);
    Ok(ValidCase {
        traced: train.cases().filter_map(traced).collect(),
        may_need_more,
        warnings,
        defaults: train.defaults,
        work,
    })
}

fn report(failures: &[Failure], not_shown: usize, valid: Option<&ValidCase>) -> Value {
    let error = |failure: &Failure| failure.json()["error"].take();
    let errors: Vec<Value> = failures.iter().map(error).collect();
    json!({
        "errors": errors,
        "errors_not_shown": not_shown,
        "warnings": valid.map(|valid| &valid.warnings),
        "defaults": valid.map(|valid| &valid.defaults),
        "estimate": valid.map(|valid| &valid.work),
        "traced": valid.map(|valid| &valid.traced),
    })
}

/// Report of a case without its run: duration, traces, defaults and warnings.
fn report_of<'a>(name: &str, valid: &ValidCase, lists_defaults: bool) -> Report<'a> {
    let traced = valid.traced.iter().map(|mesh| {
        let of = |body: usize| {
            let traces = counted(mesh.traces[body], "trace", "traces");
            format!(
                "{traces} of {}",
                counted(mesh.teeth[body], "tooth", "teeth")
            )
        };
        let pairs = counted(mesh.teeth[0] * mesh.teeth[1], "pair", "pairs");
        format!("pinion {}, wheel {}: {pairs}", of(0), of(1))
    });
    let work = format!(
        "a run takes {} and {}: {} rough contacts{}",
        duration(valid.work.seconds),
        memory(valid.work.bytes),
        valid.work.contacts,
        if valid.may_need_more { " or more" } else { "" },
    );
    let report = Report::new(&format!("{name}: no errors"), "")
        .verdict([work])
        .text(traced);
    let listed = defaults(&valid.defaults, lists_defaults);
    let report = if lists_defaults {
        report.code(listed)
    } else {
        report.text([listed.trim_end()])
    };
    report.warning(&valid.warnings)
}

/// The defaults that a case uses, listed or counted.
pub(super) fn defaults(defaults: &[DefaultUsed], is_listed: bool) -> String {
    if !is_listed {
        return format!("defaults used: {} (--explain-defaults)\n", defaults.len());
    }
    let mut text = "defaults used\n".to_owned();
    for default in defaults {
        let source = default.source.as_deref();
        let source = source.map(|s| format!("  ({s})")).unwrap_or_default();
        text.push_str(&format!("  {} = {}{source}\n", default.key, default.value));
    }
    text
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "less than a second".to_owned(),
        s if s < 120.0 => format!("about {s:.0} s"),
        s if s < 7200.0 => format!("about {:.0} min", s / 60.0),
        s => format!("about {:.1} h", s / 3600.0),
    }
}

fn memory(bytes: f64) -> String {
    match bytes {
        b if b < 1e6 => "less than 1 MB".to_owned(),
        b if b < 1e9 => format!("{:.0} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}
