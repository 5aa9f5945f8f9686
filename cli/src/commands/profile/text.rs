//! Report of one profile.

use asperity_core::quantity::Length;
use asperity_core::{Code, by_size, decimals};
use asperity_profile_io::read::FilterState;
use asperity_report::profile_json::{height, um};
use asperity_report::{Cell, Report, Table, columns};
use asperity_roughness::height_parameters::HeightParameters;
use asperity_roughness::material_ratio::RkParameters;

use super::details::Details;
use super::evaluated::EvaluatedFile;
use super::file_facts::{FileFacts, rounded};
use super::plan::as_is;
use crate::args::name_of;

/// Report of a profile, which begins with the facts of the file and whether a run takes it, and ends with the lines of a case.
pub(super) fn report<'a>(
    evaluated: &EvaluatedFile,
    facts: &FileFacts,
    details: &Details,
    case_lines: String,
) -> Report<'a> {
    let warnings = evaluated.warnings();
    let warnings = warnings.iter();
    facts
        .report()
        .verdict([usable(evaluated)])
        .text([recipe(evaluated)])
        .text(stated_cutoffs(evaluated))
        .table(heights(evaluated, details))
        .table(material(evaluated, details))
        .text(details.levels.lines())
        .text(spectral(evaluated, details))
        .text([summits(details), hurst(details), choices(evaluated)])
        .table(printed(evaluated))
        .warning(warnings.map(|warning| format!("{} {}", warning.code(), warning)))
        .code(case_lines)
}

/// Whether a run takes the trace.
fn usable(evaluated: &EvaluatedFile) -> String {
    let warnings = evaluated.warnings();
    if warnings.iter().any(|warning| warning.code() == Code::W124) {
        return format!(
            "usable: no, no flank has such heights: a run rejects them ({})",
            Code::W124
        );
    }
    match warnings.len() {
        0 => "usable: yes".to_owned(),
        1 => "usable: yes, with a warning".to_owned(),
        count => format!("usable: yes, with {count} warnings"),
    }
}

/// Form, cut-offs and sections of the evaluation.
fn recipe(evaluated: &EvaluatedFile) -> String {
    let record = &evaluated.parts.roughness.record;
    let recipe = &record.recipe;
    let cutoff = |value: Option<Length>| value.map_or("none".to_owned(), |v| v.to_string());
    let filter = match recipe.lambda_c {
        Some(_) => format!(" ({})", name_of(&record.filter)),
        None => String::new(),
    };
    format!(
        "form {}, lambda_s {}, lambda_c {}{filter}, ends {}, {} sections of {}",
        evaluated.plan.form(),
        cutoff(recipe.lambda_s),
        cutoff(recipe.lambda_c),
        name_of(&recipe.ends),
        evaluated.iso4287.heights.sections,
        rounded(evaluated.section),
    )
}

/// Options for the filtering of the instrument, if a different one is used.
fn stated_cutoffs(evaluated: &EvaluatedFile) -> Vec<String> {
    let (facts, recipe) = (&evaluated.reading.metadata, &evaluated.plan.recipe);
    let state = evaluated.reading.filter_state;
    if state == FilterState::Roughness {
        let options = as_is(&evaluated.reading);
        let line = format!("to use the filtering of the instrument, pass {options}");
        return recipe.lambda_c.map(|_| line).into_iter().collect();
    }
    let stated = [facts.lambda_c, facts.lambda_s];
    let used = [recipe.lambda_c, recipe.lambda_s];
    let as_stated = stated
        .iter()
        .zip(&used)
        .all(|(stated, used)| stated.is_none() || stated == used);
    let mut lines = Vec::new();
    if as_stated && stated.iter().any(Option::is_some) {
        lines.push("cut-offs as the file states them".to_owned());
    }
    let differs = |stated: Option<Length>, used: Option<Length>| {
        let used = used.unwrap_or_default().si();
        stated.is_some_and(|stated| (stated.si() - used).abs() > 1e-9 * stated.si())
    };
    let option = |name: &str, length: Option<Length>| {
        length.map_or(String::new(), |length| format!(" --{name} \"{length}\""))
    };
    if differs(facts.lambda_c, recipe.lambda_c) || differs(facts.lambda_s, recipe.lambda_s) {
        lines.push(format!(
            "the cut-offs of the file are overridden; to filter like the instrument, pass{}{}",
            option("lambda-c", facts.lambda_c),
            option("lambda-s", facts.lambda_s)
        ));
    }
    lines
}

/// Decimals of a height in µm and of a slope, which have more if they are small.
const HEIGHT: usize = 4;

/// Parameter of a table: name, digits, value.
type ParameterLine<T> = (&'static str, usize, fn(&T) -> Option<f64>);

const HEIGHTS: [ParameterLine<HeightParameters>; 12] = [
    ("Ra", HEIGHT, |p| Some(um(p.ra))),
    ("Rq", HEIGHT, |p| Some(um(p.rq))),
    ("Rz", HEIGHT, |p| Some(um(p.rz))),
    ("Rz1max", HEIGHT, |p| Some(um(p.rz1max))),
    ("Rp", HEIGHT, |p| Some(um(p.rp))),
    ("Rv", HEIGHT, |p| Some(um(p.rv))),
    ("Rt", HEIGHT, |p| Some(um(p.rt))),
    ("Rc", HEIGHT, |p| p.rc.map(um)),
    ("RSm", 3, |p| p.rsm.map(um)),
    ("Rsk", 3, |p| p.rsk),
    ("Rku", 3, |p| p.rku),
    ("Rdq", HEIGHT, |p| Some(p.rdq)),
];

fn heights(evaluated: &EvaluatedFile, details: &Details) -> Table {
    let columns = [
        Some(&evaluated.iso4287.heights),
        Some(&evaluated.iso21920.heights),
        Some(&evaluated.primary),
        evaluated.waviness.as_ref(),
    ];
    let rows = HEIGHTS.map(|(name, digits, value)| {
        let of = |p: &HeightParameters| number(value(p), digits);
        (
            name,
            columns.map(|p| p.map(of)),
            open(name, digits, details),
        )
    });
    columns! { (name, [iso4287, iso21920, whole, waviness], open) in rows;
            head name "parameter" "µm" = name;
            number iso4287 "R iso4287" "" = Cell::optional(iso4287);
            number iso21920 "R iso21920" "" = Cell::optional(iso21920);
            number whole "P whole" "" = Cell::optional(whole);
            number waviness "W whole" "" = Cell::optional(waviness);
            text open "open" "" = open;
    }
}

const MATERIAL: [ParameterLine<RkParameters>; 5] = [
    ("Rk", HEIGHT, |m| Some(um(m.rk))),
    ("Rpk", HEIGHT, |m| Some(um(m.rpk))),
    ("Rvk", HEIGHT, |m| Some(um(m.rvk))),
    ("Mr1", 2, |m| Some(m.mr1)),
    ("Mr2", 2, |m| Some(m.mr2)),
];

fn material(evaluated: &EvaluatedFile, details: &Details) -> Table {
    let rows = MATERIAL.map(|(name, digits, value)| {
        let columns = [Some(&evaluated.iso4287.material), details.secant.as_ref()];
        let shown = columns.map(|m| number(m.and_then(value), digits));
        (name, shown, open(name, digits, details))
    });
    columns! { (name, [least_squares, secant], open) in rows;
        head name "parameter" "µm, %" = name;
        number least_squares "least squares" "" = least_squares;
        number secant "secant" "" = secant;
        text open "open" "" = open;
    }
}

/// Range of a parameter over the permitted choices.
fn open(name: &str, digits: usize, details: &Details) -> String {
    let ambiguity = details.ambiguity.iter().find(|a| a.parameter == name);
    ambiguity.map_or(String::new(), |range| {
        let factor = if range.unit == "m" { 1e6 } else { 1.0 };
        let shown = |value: f64| number(Some(factor * value), digits);
        format!("{} .. {}", shown(range.low), shown(range.high))
    })
}

/// Choices over which the ranges extend.
fn choices(evaluated: &EvaluatedFile) -> String {
    let recipe = &evaluated.plan.recipe;
    let ends = recipe.lambda_c.or(recipe.lambda_s).is_some();
    let choices = [
        ends.then_some("ends"),
        Some("standard"),
        Some("line of Rk"),
        recipe
            .lambda_s
            .is_some()
            .then_some("with or without lambda_s"),
    ];
    let choices: Vec<&str> = choices.into_iter().flatten().collect();
    let choices = choices.join(", ");
    format!("open = range over permitted choices: {choices}, one at a time")
}

fn spectral(evaluated: &EvaluatedFile, details: &Details) -> Vec<String> {
    let s = &evaluated.iso4287.spectral;
    let moments = format!(
        "m0 {} um2, m2 {}, m4 {} 1/um2, bandwidth {}",
        by_size(s.m0 * 1e12, 5),
        by_size(s.m2, 5),
        by_size(s.m4 * 1e-12, 5),
        number(s.bandwidth(), 2)
    );
    let correlation = details.correlation.map_or("none".to_owned(), |lengths| {
        let shown = |length: Option<Length>| length.map_or("never".to_owned(), micrometres);
        format!(
            "to 0.2 in {}, to 1/e in {}",
            shown(lengths.to_one_fifth),
            shown(lengths.to_one_over_e)
        )
    });
    let mut lines = vec![moments, format!("autocorrelation {correlation}")];
    if let Some(median) = details.median_wavelength() {
        let median = micrometres(median);
        lines.push(format!(
            "spectrum: half of m0 in waves over {median}; --json --curves prints it"
        ));
    }
    lines
}

fn summits(details: &Details) -> String {
    let shown = details.summits.map_or("none".to_owned(), |summits| {
        format!(
            "{:.1} per mm (Gaussian {:.1}), {} um high (standard deviation {} um), radius {}",
            1e-3 * summits.density,
            1e-3 * summits.spectral_density,
            height(summits.mean_height),
            height(summits.height_deviation),
            summits.mean_radius.map_or("none".to_owned(), micrometres),
        )
    });
    format!("summits {shown}")
}

fn hurst(details: &Details) -> String {
    let range = details.wavelengths;
    let over = format!(
        "waves from {} to {}",
        micrometres(range.longest),
        micrometres(range.shortest)
    );
    let shown = match &details.hurst {
        Ok(fit) => format!(
            "{:.3}, standard error {:.3}, over {over} ({} bands){}",
            fit.hurst,
            fit.standard_error,
            fit.bands,
            if (0.0..=1.0).contains(&fit.hurst) {
                ""
            } else {
                ": not a self-affine profile"
            }
        ),
        Err(reason) => format!("none over {over}: {reason}. Pass --hurst 200um:8um"),
    };
    format!("Hurst exponent {shown}")
}

/// Values printed by the instrument, with the computed value of the same parameter.
fn printed(evaluated: &EvaluatedFile) -> Table {
    columns! { printed in &evaluated.reading.metadata.printed;
        head name "parameter" "";
        number printed "printed" "" = format!("{:.*}", printed.decimals, printed.value);
        text unit "unit" "";
        number computed "computed" "" = value_of(&printed.name, evaluated)
            .map_or("not computed".to_owned(), |v| format!("{v:.0$}", printed.decimals.max(3)));
    }
}

/// Computed value of a parameter by its printed name, in µm, percent or as a number.
fn value_of(name: &str, evaluated: &EvaluatedFile) -> Option<f64> {
    let (r, m) = (&evaluated.iso4287.heights, &evaluated.iso4287.material);
    let (p, w) = (&evaluated.primary, evaluated.waviness.as_ref());
    Some(match name {
        "Ra" => um(r.ra),
        "Rq" => um(r.rq),
        "Rz" => um(r.rz),
        "Rp" => um(r.rp),
        "Rv" => um(r.rv),
        "Rt" => um(r.rt),
        "Rc" => um(r.rc?),
        "RSm" => um(r.rsm?),
        "Rsk" => r.rsk?,
        "Rku" => r.rku?,
        "RDq" | "Rdq" => r.rdq,
        "Rmax" | "Rz1max" | "Rzx" => um(r.rz1max),
        "Rk" => um(m.rk),
        "Rpk" => um(m.rpk),
        "Rvk" => um(m.rvk),
        "Mr1" => m.mr1,
        "Mr2" => m.mr2,
        "Pa" => um(p.ra),
        "Pq" => um(p.rq),
        "Pt" => um(p.rt),
        "Wa" => um(w?.ra),
        "Wq" => um(w?.rq),
        "Wt" => um(w?.rt),
        _ => return None,
    })
}

/// A length in micrometres with four digits.
fn micrometres(length: Length) -> String {
    const DIGITS: i32 = 4;
    let value = um(length);
    let decimals = DIGITS - 1 - value.abs().max(1e-9).log10().floor() as i32;
    format!("{value:.*} um", decimals.max(0) as usize)
}

/// A number formatted for its column.
fn number(value: Option<f64>, digits: usize) -> String {
    const WIDEST: f64 = 1e6;
    match value {
        None => "none".to_owned(),
        Some(v) if v.abs() >= WIDEST => format!("{v:.4e}"),
        Some(v) if digits >= HEIGHT => by_size(v, digits),
        Some(v) => decimals(v, digits),
    }
}
