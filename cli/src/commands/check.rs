//! `asperity check`: a case looked at without running it.

use asperity::case::{self, LoadedCase};
use asperity_studies::estimate::{Estimate, estimate};
use serde_json::{Value, json};

use super::{keys, source};
use crate::args::{CheckArgs, Common};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity check`
pub fn check(args: &CheckArgs, common: &Common) -> Result<(), Failure> {
    let (source, folder) = source(&args.case)?;
    let name = source.name().to_owned();
    let findings = case::check(source, folder, &keys(&args.set));
    let failures: Vec<Failure> = findings.errors.iter().map(Failure::of).collect();
    let work = findings.case.as_ref().map(estimate).transpose();
    let work = work.map_err(|error| Failure::about(&args.case, &error))?;
    if common.json {
        print_json(&report(&failures, findings.case.as_ref(), work))?;
    }
    let Some(loaded) = &findings.case else {
        for failure in &failures {
            if !common.json {
                failure.tell();
            }
        }
        let count = failures.len();
        let plural = if count == 1 { "" } else { "s" };
        if !common.json {
            crate::output::note(&format!("{name}: {count} error{plural}"));
        }
        return match failures.into_iter().next() {
            Some(first) => Err(first.told()),
            None => Err(Failure::new(
                "E501",
                format!("{name}: no case and no error"),
            )),
        };
    };
    if common.json {
        return Ok(());
    }
    print_text(common, &text(&name, loaded, work))
}

fn report(failures: &[Failure], loaded: Option<&LoadedCase>, work: Option<Estimate>) -> Value {
    let error = |failure: &Failure| failure.json()["error"].take();
    let errors: Vec<Value> = failures.iter().map(error).collect();
    json!({
        "errors": errors,
        "warnings": loaded.map(|loaded| &loaded.warnings),
        "defaults": loaded.map(|loaded| &loaded.case.defaults),
        "estimate": work,
    })
}

fn text(name: &str, loaded: &LoadedCase, work: Option<Estimate>) -> String {
    let mut text = format!("{name}: no errors\n");
    for warning in &loaded.warnings {
        text.push_str(&asperity_report::wrapped(&warning.to_string(), "     "));
        text.push('\n');
    }
    text.push_str("defaults that a run uses\n");
    for default in &loaded.case.defaults {
        let source = default.source.as_deref();
        let source = source.map(|s| format!("  ({s})")).unwrap_or_default();
        text.push_str(&format!("  {} = {}{source}\n", default.key, default.value));
    }
    if let Some(work) = work {
        text.push_str(&format!(
            "a run takes about {} and {}: {} rough contacts\n",
            duration(work.seconds),
            memory(work.bytes),
            work.contacts
        ));
    }
    text
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "less than a second".to_owned(),
        s if s < 120.0 => format!("{s:.0} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}

fn memory(bytes: f64) -> String {
    match bytes {
        b if b < 1e6 => "less than 1 MB".to_owned(),
        b if b < 1e9 => format!("{:.0} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}
