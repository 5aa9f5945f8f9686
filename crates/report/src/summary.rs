//! The summary for the terminal, in 80 columns.

use crate::other_models;
use crate::printed::{
    BOUNDARY, LUBRICATED, PrintedLoss, gearbox_with_interval, of_mesh, stated, stated_parts, watts,
};
use crate::tables::BODIES;
use crate::wrap::{COLUMNS, wrapped_within};
use crate::{ridges, scans};
use asperity::message::{Subject, Warning};
use asperity::result::loss_band::{Trust, Uncertainty, UncertaintyPart, rounded};
use asperity::result::{
    BulkReport, FlankRecord, GearboxReport, MicropittingReport, PairSampling, PositionRow, Regime,
    RunResult, Summary, TracePairs,
};
use asperity_core::Code;
use asperity_core::decimals;
use asperity_storage::one_line;

/// Indentation of the text of a message, behind its code.
const MESSAGE: &str = "     ";
/// Indentation of the second line of a value, behind its name.
const INDENT: &str = "  ";

/// Verdict, details and warnings as plain text in 80 columns.
pub fn summary(result: &RunResult) -> String {
    summary_within(result, COLUMNS)
}

/// Verdict, details and warnings in `columns`.
pub fn summary_within(result: &RunResult, columns: usize) -> String {
    let mut text = text_of(&verdict(result, columns)) + &details(result, columns);
    for warning in &result.warnings {
        text.push_str(&note(warning, columns));
    }
    text
}

/// The first screen in `columns`: the verdict, and at most one warning: about an input that makes the result doubtful, or
/// else the one that is worth most watts. Where they have more than `most` lines, the verdict leaves out what the result can do
/// without.
pub fn brief(result: &RunResult, columns: usize, most: usize) -> String {
    let mut parts = verdict(result, columns);
    parts.extend(
        weightiest(result).map(|warning| (SummaryPart::Needed, short_note(&warning, columns))),
    );
    for rank in [SummaryPart::Bulk, SummaryPart::Regime, SummaryPart::Remedy] {
        if text_of(&parts).lines().count() > most {
            parts.retain(|(part, _)| *part != rank);
        }
    }
    text_of(&parts)
}

/// Parts of a verdict: those that a first screen needs, and those that it can do without.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SummaryPart {
    Needed,
    Regime,
    Bulk,
    Remedy,
}

fn text_of(parts: &[(SummaryPart, String)]) -> String {
    parts.iter().map(|(_, text)| text.as_str()).collect()
}

/// The warning in two lines: its sentences as far as they fit, with its worth. The explanation of its code has the rest.
pub(crate) fn short_note(warning: &Warning, columns: usize) -> String {
    line(&short_text(warning, columns), MESSAGE, columns)
}

/// The warning as far as it fits into two lines of `columns`, with its worth.
pub(crate) fn short_text(warning: &Warning, columns: usize) -> String {
    let text = one_line(&warning.to_string()).into_owned();
    // Behind the text its worth, and the mesh of a train in brackets.
    let of_mesh = || text.rfind(" [").filter(|_| text.ends_with(']'));
    let (text, worth) = match text.rfind(WORTH).or_else(of_mesh) {
        Some(at) => text.split_at(at),
        None => (text.as_str(), ""),
    };
    let shown = |kept: &str| format!("{kept}{worth}");
    let is_short = |kept: &str| line(&shown(kept), MESSAGE, columns).lines().count() <= 2;
    if is_short(text) {
        return shown(text);
    }
    // Up to the last full stop or semicolon that fits, else colon or comma, else word.
    let last = |signs: &[&str]| {
        let ends = signs.iter().flat_map(|sign| text.match_indices(sign));
        let fits = ends.map(|(at, _)| at).filter(|at| is_short(&text[..*at]));
        fits.max()
    };
    match last(&[". ", "; "]).or_else(|| last(&[": ", ", "])) {
        Some(at) => shown(&text[..at]),
        None => {
            let cut = |at: usize| format!("{}… (explain {})", &text[..at], warning.code);
            let words = text.match_indices(' ').map(|(at, _)| at);
            let at = words.filter(|at| is_short(&cut(*at))).max();
            at.map_or_else(|| shown(text), |at| shown(&cut(at)))
        }
    }
}

/// The line with efficiency and loss, as in [`brief`] and [`summary`].
pub fn headline(result: &RunResult) -> String {
    let [loss, efficiency] = of_mesh(result);
    format!("efficiency (mesh only)  {efficiency}   loss {loss}")
}

/// Component of the uncertainty that the warnings of a code are about.
const SUBJECTS: &[(Code, Subject)] = &[
    (Code::W439, Subject::TipRelief),
    (Code::W415, Subject::FastModel),
    (Code::W404, Subject::Sampling),
    (Code::W406, Subject::Sampling),
    (Code::W407, Subject::Sampling),
    (Code::W417, Subject::Sampling),
    (Code::W418, Subject::Sampling),
    (Code::W437, Subject::Sampling),
    (Code::W450, Subject::Sampling),
];

/// Beginning of the worth of a warning.
const WORTH: &str = " (effect on loss: ";

/// A warning with its worth in words, if that is known and not printed as 0.
pub(crate) fn priced(warning: &Warning, result: &RunResult) -> Warning {
    let digits = result.uncertainty.as_ref().map(Uncertainty::digits);
    let known = worth(warning, result).zip(digits);
    let known = known.filter(|(watts, digits)| digits.steps(*watts) > 0.0);
    known.map_or_else(
        || warning.clone(),
        |(watts, digits)| warning.with(&format!("{WORTH}{} W)", digits.rounded(watts))),
    )
}

/// The warning of the first screen, with its worth in words.
pub(crate) fn weightiest(result: &RunResult) -> Option<Warning> {
    let doubt = |warning: &&Warning| warning.code.doubt();
    let doubtful = result.warnings.iter().filter(|w| doubt(w).is_some());
    let digits = result.uncertainty.as_ref().map(Uncertainty::digits);
    if let Some(warning) = doubtful.min_by_key(doubt) {
        return Some(priced(warning, result));
    }
    let digits = digits?;
    let worth = result.warnings.iter().filter_map(|warning| {
        let watts = worth(warning, result)?;
        (digits.steps(watts) > 0.0).then_some((warning, watts))
    });
    let (warning, _) = worth.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    Some(priced(warning, result))
}

/// Change of the loss \[W\] that `warning` is about: half the range of its component of the uncertainty, or the contact of
/// the tip edges.
fn worth(warning: &Warning, result: &RunResult) -> Option<f64> {
    if let (Code::W421, Some(edges)) = (warning.code, &result.load.edge_contact) {
        return Some((edges.with / edges.without - 1.0).abs() * result.summary.sliding_w);
    }
    let of_code = SUBJECTS.iter().find(|(code, _)| *code == warning.code);
    let subject = warning.about.or(of_code.map(|(_, subject)| *subject))?;
    let mut parts = result.uncertainty.as_ref()?.loss.parts.iter();
    Some(
        parts
            .find(|part| part.about == Some(subject))?
            .half_range_w(),
    )
}

pub(crate) fn note(warning: &Warning, columns: usize) -> String {
    let text = one_line(&warning.to_string()).into_owned();
    line(&text, MESSAGE, columns)
}

/// `text` as a line of output, broken at `columns`.
fn line(text: &str, indent: &str, columns: usize) -> String {
    wrapped_within(text, indent, columns) + "\n"
}

/// Title, headline, parts, regime, the composition of the interval, and the ridges. The headline is never broken.
fn verdict(result: &RunResult, columns: usize) -> Vec<(SummaryPart, String)> {
    let of_mesh = result.uncertainty.as_ref();
    let head = line(&one_line(&result.title), INDENT, columns) + &headline(result) + "\n";
    let printed = PrintedLoss::new(&result.summary, of_mesh);
    let gearbox = result.gearbox.as_ref();
    let gearbox = gearbox.map(|gearbox| gearbox_headline(gearbox, of_mesh));
    let regime = format!("regime  {}", regime(&result.summary));
    let needed = |text: String| (SummaryPart::Needed, text);
    let lines = gearbox.into_iter().chain([parts(&printed)]).map(needed);
    let lines = lines.chain([(SummaryPart::Regime, regime)]);
    let lines = lines.chain(
        result
            .bulk
            .as_ref()
            .map(|bulk| (SummaryPart::Bulk, bulk_text(bulk))),
    );
    let lines = lines.chain(replaced_oil(&result.warnings).map(needed));
    let lines = lines.chain(run_in(result).map(needed));
    let lines = lines.chain(of_mesh.map_or(Vec::new(), |of_mesh| composition(of_mesh, columns)));
    let lines = lines.chain(ridges::line(result).map(needed));
    let lines = lines.map(|(part, text)| (part, line(&text, INDENT, columns)));
    [needed(head)].into_iter().chain(lines).collect()
}

/// The parts of a loss in a line.
fn parts(printed: &PrintedLoss) -> String {
    let parts = printed.parts.iter().filter_map(|part| match part.name {
        LUBRICATED => None,
        BOUNDARY if part.watts > 0.0 => Some(format!(
            "asperities {} ({BOUNDARY} {})",
            printed.asperities, printed.boundary
        )),
        BOUNDARY => Some(format!("asperities {}", printed.asperities)),
        name => Some(format!("{name} {}", part.text)),
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// Share of the path from which a regime is stated without it.
const NEARLY_ALL: f64 = 0.95;

/// The regime with the load on the asperities.
pub(crate) fn regime(s: &Summary) -> String {
    let percent = |share: f64| {
        if share < 0.005 {
            "< 1 %".to_owned()
        } else {
            format!("{:.0} %", 100.0 * share)
        }
    };
    let mixed = format!("mixed on {} of the path", percent(s.mixed_share));
    let regime = match s.regime {
        Regime::FullFilm => "full film all along the path".to_owned(),
        Regime::Mixed => mixed,
        Regime::Boundary if s.mixed_share >= NEARLY_ALL => s.regime_words().to_owned(),
        Regime::Boundary => s.regime_words().replacen(Regime::Mixed.name(), &mixed, 1),
    };
    if s.mixed_share == 0.0 && s.asperity_share < 0.005 {
        regime
    } else {
        format!(
            "{regime}, {} of the load on asperities",
            percent(s.asperity_share)
        )
    }
}

/// Lines behind the verdict: powers and factors, the run against the median, what the case requests, convergence.
fn details(result: &RunResult, columns: usize) -> String {
    let mut lines = vec![factors(&result.summary), film_parameter(result)];
    if let Some(gearbox) = &result.gearbox {
        lines.push(besides_the_mesh(gearbox));
    }
    lines.extend(shift(result));
    lines.extend(result.uncertainty.as_ref().and_then(other_models::outside));
    let pairs = result.pairs.iter();
    let sampled = pairs.filter_map(|pairs| Some((pairs, pairs.sampling.as_ref()?)));
    lines.extend(
        sampled.map(|(pairs, sampling)| pairs_text(sampling, sampled_as(pairs, &result.flanks))),
    );
    lines.extend(result.micropitting.as_ref().map(micropitting_text));
    lines.extend(result.scans.as_ref().map(scans::verdict));
    lines.extend(result.no_scans.as_deref().map(scans::without));
    lines.extend(relief_text(result));
    lines.push(convergence(result));
    lines.extend(solver_notes(result));
    lines
        .iter()
        .map(|text| line(text, INDENT, columns))
        .collect()
}

fn factors(s: &Summary) -> String {
    format!(
        "power in {}   mu_eq {:.4}   H_V {:.4} (local {:.4})",
        watts(s.power_in_w),
        s.mu_equivalent,
        s.loss_factor_ohlendorf,
        s.loss_factor_local
    )
}

/// The traced teeth, the mean over their pairs and the contributions to its error.
fn pairs_text(pairs: &PairSampling, names: [&str; 2]) -> String {
    let [pinion, _] = pairs.traces;
    let teeth = names[0];
    let wheel = counted_of_wheel(pairs, names);
    let [of_pinion, _] = names.map(one_of);
    let own = |power: f64| rounded(power, pairs.half_width_w);
    let bound = pairs.bound();
    let [s1, s2] = pairs.between_w;
    format!(
        "pairs  {pinion} {teeth} of the pinion on {wheel} of the wheel, mean {} W, standard error {} W{bound}; \
        s_1 {} between {of_pinion} of the pinion, s_2 {} of the wheel, s_12 {} W from pair to pair",
        own(pairs.mean_w),
        two_digits(pairs.standard_error_w),
        two_digits(s1),
        two_digits(s2),
        two_digits(pairs.interaction_w),
    )
}

/// Words for the several traces of each flank: rows of its scan, or as [`FlankRecord::teeth`].
pub(crate) fn sampled_as(pairs: &TracePairs, flanks: &[FlankRecord; 2]) -> [&'static str; 2] {
    [0, 1].map(|body| {
        if pairs.traces[body].iter().all(|trace| trace.row.is_some()) {
            ROWS
        } else {
            flanks[body].teeth()
        }
    })
}

/// Words for rows of a scan.
const ROWS: &str = "rows";

/// The last of the words for several traces.
pub(crate) fn one_of(name: &str) -> &str {
    if name == ROWS { ROWS } else { "teeth" }
}

/// Number of flanks of the wheel, which are named if those of the pinion have another name.
pub(crate) fn counted_of_wheel(pairs: &PairSampling, [pinion, wheel]: [&str; 2]) -> String {
    let count = pairs.traces[1];
    if pinion == wheel {
        count.to_string()
    } else {
        format!("{count} {wheel}")
    }
}

/// Relief derived from the traces.
fn relief_text(result: &RunResult) -> Option<String> {
    let gears = BODIES.iter().zip(&result.flanks);
    let reliefs = gears.filter_map(|(gear, flank)| {
        let form = flank.form.as_ref()?;
        Some(format!(
            "{gear} {:.1} um at the tip, {:.1} um at the root",
            form.at_tip_um, form.at_root_um
        ))
    });
    let reliefs: Vec<String> = reliefs.collect();
    (!reliefs.is_empty()).then(|| format!("relief  from the traces: {}", reliefs.join("; ")))
}

/// A scatter with two digits.
pub(crate) fn two_digits(power: f64) -> String {
    if power > 0.0 {
        rounded(power, power)
    } else {
        "0".to_owned()
    }
}

/// The losses of the gearbox in addition to the mesh, by part.
#[must_use]
pub fn besides_the_mesh(gearbox: &GearboxReport) -> String {
    let losses: Vec<f64> = gearbox.parts.iter().map(|part| part.loss_w).collect();
    let parts = gearbox.parts.iter().zip(stated_parts(&losses));
    let parts = parts.map(|(part, loss)| format!("{} {loss}", part.name));
    let parts: Vec<String> = parts.collect();
    format!(
        "in addition to the mesh {}, from the input and without an interval: {}",
        stated(gearbox.parts_w),
        parts.join(", ")
    )
}

fn gearbox_headline(gearbox: &GearboxReport, of_mesh: Option<&Uncertainty>) -> String {
    let Some(of_mesh) = of_mesh else {
        return format!(
            "efficiency (gearbox)    {:.4} %   loss {}",
            100.0 * gearbox.efficiency,
            watts(gearbox.loss_w)
        );
    };
    let [loss, efficiency] = gearbox_with_interval(gearbox, of_mesh);
    format!("efficiency (gearbox)    {efficiency}   loss {loss}")
}

/// The smallest specific film, its position, and its permissible value.
fn micropitting_text(report: &MicropittingReport) -> String {
    let against = match (report.permissible, report.safety) {
        (Some(permissible), Some(safety)) => {
            format!("S_lambda {safety:.2} over the user's {permissible:.3}")
        }
        _ => "no permissible value stated".to_owned(),
    };
    let scope = if report.outside.is_empty() {
        "by the form of ISO/TS 6336-22"
    } else {
        "by the form of ISO/TS 6336-22, outside of its scope"
    };
    format!(
        "micropitting  lambda_GF {:.3} at {:.0} % of the path, {}; {against}; {scope}",
        report.lambda_min,
        100.0 * report.path_fraction,
        report.place
    )
}

/// The bulk temperature computed from the loss, and the method.
fn bulk_text(bulk: &BulkReport) -> String {
    let gears = bulk.gears_c.map_or(String::new(), |[pinion, wheel]| {
        format!(": pinion {pinion:.0}, wheel {wheel:.0}")
    });
    format!(
        "bulk    {:.0} °C{gears}; oil {:.0} °C, rise by the loss ({})",
        bulk.bulk_c, bulk.oil_c, bulk.law
    )
}

fn film_parameter(result: &RunResult) -> String {
    let value = |row: &PositionRow| {
        row.lambda_star
            .map_or("-".to_owned(), |v| format!("{v:.2}"))
    };
    match &result.path[..] {
        [] => "Lambda* -".to_owned(),
        [only] => format!("Lambda* {}", value(only)),
        [first, .., last] => {
            format!("Lambda* {} near A .. {} near E", value(first), value(last))
        }
    }
}

/// Positions of a result in words.
fn positions(s: &Summary) -> String {
    match s.positions {
        1 => "the one position".to_owned(),
        n => format!("all {n} positions"),
    }
}

fn convergence(result: &RunResult) -> String {
    let s = &result.summary;
    let count = positions(s);
    if s.mixed_share > 0.0 {
        format!(
            "solved  {count} (worst load error {:.0e}, duality gap {:.0e})",
            s.worst_load_error, s.worst_duality_gap,
        )
    } else {
        format!("solved  {count} (full film: no contact to solve)")
    }
}

/// The share of thin films with its error, the offsets of a run without interval, and the plastic work.
fn solver_notes(result: &RunResult) -> Vec<String> {
    let s = &result.summary;
    let mut lines = Vec::new();
    if let Some(error) = s.asperity_share_standard_error {
        lines.push(format!(
            "share of the load below 20 nm  {:.3}, standard error {error:.3} ({} reference solutions)",
            s.asperity_share,
            result.records.len()
        ));
    }
    let has_interval = result.uncertainty.is_some() || result.pairs.is_some();
    if let (Some(deviation), false) = (s.efficiency_deviation, has_interval) {
        lines.push(format!(
            "spread  standard deviation of the efficiency {:.4} % over {} profile offsets",
            100.0 * deviation,
            s.offsets
        ));
    }
    let mut defaults = result.defaults.iter();
    let lay = defaults.find(|default| default.key == "model.lay");
    if let Some(origin) = lay.and_then(|lay| lay.source.as_deref()) {
        lines.push(format!("lay  {origin}"));
    }
    let work = result.running_in.energy_per_engagement_j;
    if work > 0.0 {
        lines.push(format!(
            "running-in  {work:.2e} J of plastic work in the first engagement (not counted)"
        ));
    }
    lines
}

/// The oil that replaces the oil of the case, in a line of the first screen.
pub(crate) fn replaced_oil(warnings: &[Warning]) -> Option<String> {
    let mut warnings = warnings.iter();
    let of_oil = warnings.find(|warning| warning.about == Some(Subject::Oil));
    of_oil.map(|warning| format!("oil     {}", warning.text))
}

/// Loss and Rq run in and as measured, in a line, if the flanks were run in.
pub(crate) fn run_in(result: &RunResult) -> Option<String> {
    let run_in = result.run_in.as_ref()?;
    let rounded = |loss: f64| match &result.uncertainty {
        Some(uncertainty) => format!("{} W", uncertainty.digits().rounded(loss)),
        None => watts(loss),
    };
    let [[after, of_wheel], [before, wheel]] = [run_in.run_in.rq_um, run_in.measured.rq_um];
    let engagements = run_in.steps.last().map_or(0.0, |step| step.engagements);
    let more = if run_in.is_settled {
        ""
    } else {
        ", with which Rq still changes"
    };
    Some(format!(
        "Run in over {engagements} engagements at {} N m{more}: loss {} instead of {}, Rq {after:.3} and {of_wheel:.3} for {before:.3} and {wheel:.3} µm; \
        asperity running-in computes how long and at which torque",
        decimals(run_in.torque_nm, 1),
        rounded(run_in.summary.loss_w),
        rounded(result.summary.loss_w)
    ))
}

/// Largest parts of the uncertainty that the first screen names.
const LARGEST_PARTS: usize = 3;
/// Deviation of the median from the run that is worth a line.
const NOTED_SHIFT: f64 = 0.01;

/// The largest parts of the interval, what narrows it in one line, and the trust in the flanks.
fn composition(uncertainty: &Uncertainty, columns: usize) -> Vec<(SummaryPart, String)> {
    let digits = uncertainty.digits();
    let parts = uncertainty.loss.parts.iter().take(LARGEST_PARTS);
    let parts: Vec<_> = parts
        .filter(|part| digits.steps(part.half_range_w()) > 0.0)
        .collect();
    let mut lines = Vec::new();
    if !parts.is_empty() {
        let half = |part: &UncertaintyPart| digits.rounded(part.half_range_w());
        let named = parts
            .iter()
            .map(|part| format!("{} {} W", part.name, half(part)));
        let named: Vec<String> = named.collect();
        let named = named.join(", ");
        let named = format!("uncertain  {named} (each half the width of its 90 % interval)");
        lines.push((SummaryPart::Needed, named));
        // Of flanks without traces the sampling is narrowed by traces.
        let is_vain = |part: &UncertaintyPart| {
            part.about == Some(Subject::Sampling)
                && uncertainty.with_traces_w.is_some()
                && !uncertainty.traces_narrow()
        };
        let narrowed = parts.into_iter().filter(|part| !is_vain(part));
        let narrowed: Vec<&UncertaintyPart> = narrowed.collect();
        if !narrowed.is_empty() {
            lines.push((SummaryPart::Remedy, remedies(&narrowed, columns)));
        }
    }
    if uncertainty.trust != Trust::SolvedContact {
        let trust = format!("trust  {}", uncertainty.trust_text());
        lines.push((SummaryPart::Needed, trust));
    }
    lines
}

/// The measurements that narrow the largest part, and the others as long as they fit into the line.
fn remedies(parts: &[&UncertaintyPart], columns: usize) -> String {
    let mut text = String::from("to narrow it  ");
    let mut named: Vec<&str> = Vec::new();
    for part in parts {
        let between = if named.is_empty() { "" } else { "; " };
        let longer = format!("{text}{between}{}", part.remedy);
        let fits = longer.chars().count() <= columns || named.is_empty();
        if fits && !named.contains(&part.remedy.as_str()) {
            named.push(&part.remedy);
            text = longer;
        }
    }
    text
}

/// The run with all constants at their medians against the median of the draws, where they differ.
fn shift(result: &RunResult) -> Option<String> {
    let uncertainty = result.uncertainty.as_ref()?;
    let at_medians = result.summary.loss_at_medians_w?;
    let shift = result.summary.loss_w / at_medians - 1.0;
    (shift.abs() > NOTED_SHIFT).then(|| {
        format!(
            "with every constant at its median the loss is {} W; the median of the samples is {:.0} % {}. Inputs that are not stated \
            (tip relief, lay), flow through areal windows, errors above a fifth, and a mean error of the model \
            (gap law `power`, reference solutions) change the loss more in one direction",
            uncertainty.digits().rounded(at_medians),
            100.0 * shift.abs(),
            if shift > 0.0 { "higher" } else { "lower" },
        )
    })
}

/// Losses over the boundary share that is drawn, and by models that records or measurements contradict.
pub fn models(result: &RunResult) -> String {
    let Some(uncertainty) = &result.uncertainty else {
        return "no other models without an uncertainty\n".to_owned();
    };
    let table = other_models::models(uncertainty).text("");
    format!("other models, and the evidence against them\n{table}")
}

/// Table of the published laws, each instead of film and asperity friction.
pub fn published_laws(result: &RunResult) -> String {
    let table = other_models::published_laws(result).text("");
    format!("published laws, each instead of film and asperity friction\n{table}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_film_is_all_along_the_path_only_where_nothing_is_mixed() {
        let of = |mixed_share: f64, asperity_share: f64, boundary_w: f64| {
            let summary = serde_json::json!({
                "regime": Regime::of_friction(mixed_share, boundary_w, 90.0),
                "scope": "mesh", "efficiency": 0.99, "offsets": 2, "power_in_w": 1e5, "torque_out_nm": 1.0,
                "loss_w": 100.0, "sliding_w": 90.0, "film_w": 80.0, "lubricated_asperity_w": 5.0,
                "boundary_w": boundary_w, "rolling_w": 10.0, "deformation_w": [0.0, 0.0],
                "deformation_in_contact_w": [0.0, 0.0], "hysteresis_w": 0.0, "elastic_cycling_w": 0.0,
                "asperity_share": asperity_share, "boundary_share": 0.0, "mu_equivalent": 0.03,
                "loss_factor_ohlendorf": 0.1, "loss_factor_local": 0.1, "mixed_share": mixed_share, "positions": 4,
                "worst_load_error": 0.0, "worst_duality_gap": 0.0
            });
            regime(&serde_json::from_value(summary).unwrap())
        };
        assert_eq!(of(0.0, 0.0, 0.0), "full film all along the path");
        let expected = "full film all along the path, 1 % of the load on asperities";
        assert_eq!(of(0.0, 0.01, 0.0), expected);
        let expected = "mixed on 25 % of the path, 7 % of the load on asperities";
        assert_eq!(of(0.25, 0.07, 1.0), expected);
        let expected = "boundary, 61 % of the load on asperities";
        assert_eq!(of(1.0, 0.61, 50.0), expected);
        let expected = "mixed, mostly boundary friction, 33 % of the load on asperities";
        assert_eq!(of(0.99, 0.33, 50.0), expected);
    }
}
