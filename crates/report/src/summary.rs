//! The summary for the terminal, in 80 columns.

use std::fmt::Write as _;

use crate::printed::{
    PrintedLoss, gearbox_with_interval, included, mesh_with_interval, stated, stated_parts, watts,
};
use crate::tables::BODIES;
use crate::wrap::{COLUMNS, wrapped};
use asperity::message::Warning;
use asperity::result::loss_band::{Trust, Uncertainty, UncertaintyPart, rounded};
use asperity::result::{
    BulkReport, GearboxReport, MicropittingReport, PairSampling, PositionRow, PublishedOutcome,
    RunResult, Summary,
};
use asperity_storage::one_line;

/// Indentation of the text of a message, behind its code.
const INDENT: &str = "     ";

/// Efficiency, losses, regime and warnings as plain text.
pub fn summary(result: &RunResult) -> String {
    let mut text = numbers(result);
    for warning in &result.warnings {
        text.push_str(&note(warning));
    }
    text
}

/// The summary with the two most important warnings; the others are counted in one line.
pub fn brief(result: &RunResult) -> String {
    let mut text = numbers(result);
    let rank = |warning: &&Warning| MATTERS.iter().position(|code| *code == warning.code);
    let mut weighty: Vec<&Warning> = result
        .warnings
        .iter()
        .filter(|w| rank(w).is_some())
        .collect();
    weighty.sort_by_key(rank);
    weighty.truncate(SHOWN_NOTES);
    for warning in &weighty {
        text.push_str(&note(warning));
    }
    let others = result.warnings.len() - weighty.len();
    if others > 0 {
        let plural = if others == 1 { "" } else { "s" };
        let more = if weighty.is_empty() { "" } else { "more " };
        text.push_str(&format!("{others} {more}note{plural}: --notes\n"));
    }
    text
}

/// Relative load error above which a solution is reported as not converged: the paper stops at 1 %.
const LARGE_LOAD_ERROR: f64 = 0.011;
/// Number of warnings on the first screen.
const SHOWN_NOTES: usize = 2;
/// Codes of warnings that put the efficiency in doubt and name a remedy, the most important first.
const MATTERS: &[&str] = &[
    "W402", "W439", "W426", "W412", "W415", "W405", "W201", "W124", "W128", "W112", "W118", "W111",
    "W125", "W117", "W113", "W437", "W438", "W408", "W404", "W410",
];

fn note(warning: &Warning) -> String {
    format!("{}\n", wrapped(&one_line(&warning.to_string()), INDENT))
}

fn numbers(result: &RunResult) -> String {
    let mut text = String::new();
    // Writing into a string cannot fail.
    let _ = write_losses(&mut text, result);
    if let Some(gearbox) = &result.gearbox {
        text.push_str(&gearbox_text(gearbox, result.uncertainty.as_ref()));
    }
    if let Some(uncertainty) = &result.uncertainty {
        text.push_str(&uncertainty_text(uncertainty));
    }
    let pairs = result.pairs.as_ref();
    if let Some(pairs) = pairs.and_then(|pairs| pairs.sampling.as_ref()) {
        text.push_str(&pairs_text(pairs));
    }
    if let Some(bulk) = &result.bulk {
        text.push_str(&bulk_text(bulk));
    }
    if let Some(report) = &result.micropitting {
        text.push_str(&micropitting_text(report));
    }
    text.push_str(&relief_text(result));
    let _ = write_regime(&mut text, result);
    let _ = write_run_in(&mut text, result);
    text
}

/// The traced teeth, the mean over their pairs and the contributions to its error.
fn pairs_text(pairs: &PairSampling) -> String {
    let [pinion, wheel] = pairs.traces;
    let own = |power: f64| rounded(power, pairs.half_width_w);
    let bound = pairs.not_sampled().map_or(String::new(), |gear| {
        format!(", {gear} not sampled: lower bound")
    });
    let [s1, s2] = pairs.between_w;
    let line = format!(
        "pairs  {pinion} traced teeth of the pinion on {wheel} of the wheel, mean {} W, standard error {} W{bound}; \
        s_1 {} between teeth of the pinion, s_2 {} of the wheel, s_12 {} W from pair to pair",
        own(pairs.mean_w),
        two_digits(pairs.standard_error_w),
        two_digits(s1),
        two_digits(s2),
        two_digits(pairs.interaction_w),
    );
    wrapped(&line, "  ") + "\n"
}

/// Relief derived from the traces.
fn relief_text(result: &RunResult) -> String {
    let gears = BODIES.iter().zip(&result.flanks);
    let reliefs = gears.filter_map(|(gear, flank)| {
        let form = flank.form.as_ref()?;
        Some(format!(
            "{gear} {:.1} um at the tip, {:.1} um at the root",
            form.at_tip_um, form.at_root_um
        ))
    });
    let reliefs: Vec<String> = reliefs.collect();
    match reliefs.is_empty() {
        true => String::new(),
        false => {
            let line = format!("relief  from the traces: {}", reliefs.join("; "));
            wrapped(&line, "  ") + "\n"
        }
    }
}

/// A scatter with two digits.
pub(crate) fn two_digits(power: f64) -> String {
    match power > 0.0 {
        true => rounded(power, power),
        false => "0".to_owned(),
    }
}

/// The gearbox: its efficiency, and the losses from the input by part.
fn gearbox_text(gearbox: &GearboxReport, of_mesh: Option<&Uncertainty>) -> String {
    let losses: Vec<f64> = gearbox.parts.iter().map(|part| part.loss_w).collect();
    let parts = gearbox.parts.iter().zip(stated_parts(&losses));
    let parts = parts.map(|(part, loss)| format!("{} {loss}", part.name));
    let parts: Vec<String> = parts.collect();
    let line = format!(
        "  besides the mesh {}, from the input and without a band: {}",
        stated(gearbox.parts_w),
        parts.join(", ")
    );
    let beside = wrapped(&line, "  ");
    format!("{}\n{beside}\n", gearbox_headline(gearbox, of_mesh))
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
    let scope = match report.outside.is_empty() {
        true => "by the form of ISO/TS 6336-22",
        false => "by the form of ISO/TS 6336-22, outside of its scope",
    };
    let line = format!(
        "micropitting  lambda_GF {:.3} at {:.0} % of the path, {}; {against}; {scope}",
        report.lambda_min,
        100.0 * report.path_fraction,
        report.place
    );
    format!("{}\n", wrapped(&line, "  "))
}

/// The bulk temperature computed from the loss, and the method.
fn bulk_text(bulk: &BulkReport) -> String {
    let gears = bulk.gears_c.map_or(String::new(), |[pinion, wheel]| {
        format!(": pinion {pinion:.0}, wheel {wheel:.0}")
    });
    format!(
        "bulk    {:.0} °C{gears}; oil {:.0} °C, rise by the loss ({})\n",
        bulk.bulk_c, bulk.oil_c, bulk.law
    )
}

fn write_losses(text: &mut String, result: &RunResult) -> std::fmt::Result {
    let s = &result.summary;
    let printed = PrintedLoss::of(s, &result.running_in, result.uncertainty.as_ref());
    writeln!(text, "{}", one_line(&result.title))?;
    match &result.uncertainty {
        Some(uncertainty) => writeln!(text, "{}", headline(s, uncertainty))?,
        None => writeln!(
            text,
            "efficiency (mesh only)  {:.4} %   loss {}   power in {}",
            100.0 * s.efficiency,
            printed.loss,
            watts(s.power_in_w),
        )?,
    }
    let mut parts = vec![
        format!("sliding {}", printed.sliding),
        format!("rolling {}", printed.rolling),
    ];
    if s.deformation_w != [0.0, 0.0] {
        let [pinion, wheel] = &printed.deformation;
        parts.push(format!("deformation {pinion} + {wheel}"));
    }
    if included(&result.running_in) > 0.0 {
        parts.push(format!("running-in {}", printed.running_in));
    }
    let losses = format!("  [{}]", parts.join(" | "));
    let factors = format!(
        "mu_eq {:.4}   H_V {:.4} (local {:.4})",
        s.mu_equivalent, s.loss_factor, s.loss_factor_local
    );
    let together = losses.chars().count() + 3 + factors.chars().count();
    let between = if together <= COLUMNS { "   " } else { "\n  " };
    writeln!(text, "{losses}{between}{factors}")?;
    writeln!(
        text,
        "  sliding in film {}, lubricated asperities {}, boundary layer {}",
        printed.film, printed.lubricated, printed.boundary,
    )
}

fn write_regime(text: &mut String, result: &RunResult) -> std::fmt::Result {
    let s = &result.summary;
    write!(text, "regime  ")?;
    if s.mixed_share <= 0.0 {
        write!(text, "full film all along the path")?;
    } else {
        write!(text, "mixed on {:.0} % of the path", 100.0 * s.mixed_share)?;
    }
    let value = |row: &PositionRow| {
        row.lambda_star
            .map_or("-".to_owned(), |v| format!("{v:.2}"))
    };
    if let (Some(first), Some(last)) = (result.path.first(), result.path.last()) {
        if result.path.len() > 1 {
            write!(
                text,
                "   Lambda* {} near A .. {} near E",
                value(first),
                value(last)
            )?;
        } else {
            write!(text, "   Lambda* {}", value(first))?;
        }
    }
    writeln!(text)?;
    let count = match s.positions {
        1 => "the one position".to_owned(),
        n => format!("all {n} positions"),
    };
    if s.worst_load_error > LARGE_LOAD_ERROR {
        writeln!(
            text,
            "not converged  {count}: the load error is up to {:.0} %, within model.numerical_error",
            100.0 * s.worst_load_error
        )?;
    } else if s.mixed_share > 0.0 {
        writeln!(
            text,
            "converged  {count} (worst load error {:.0e}, duality gap {:.0e})",
            s.worst_load_error, s.worst_duality_gap,
        )?;
    } else {
        writeln!(text, "converged  {count} (full film: no contact to solve)")?;
    }
    if let Some(error) = s.asperity_share_standard_error {
        writeln!(
            text,
            "share of the load below 20 nm  {:.3}, standard error {error:.3} ({} records of mixed lubrication)",
            s.asperity_share,
            result.records.len()
        )?;
    }
    if s.offsets > 1 && result.uncertainty.is_none() && result.pairs.is_none() {
        writeln!(text, "spread  over {} profile offsets", s.offsets)?;
    }
    if result.running_in.energy_per_engagement_j > 0.0 {
        writeln!(
            text,
            "running-in  {:.2e} J of plastic work in the first engagement{}",
            result.running_in.energy_per_engagement_j,
            if result.running_in.included {
                ""
            } else {
                " (not counted)"
            }
        )?;
    }
    Ok(())
}

/// The losses as measured and run in, if the flanks were run in.
fn write_run_in(text: &mut String, result: &RunResult) -> std::fmt::Result {
    let Some(run_in) = &result.run_in else {
        return Ok(());
    };
    let (before, after) = (&result.summary, &run_in.summary);
    let printed = PrintedLoss::of(after, &run_in.running_in, None);
    let heights = |rq: [f64; 2]| format!("Rq {:.3} and {:.3} um", rq[0], rq[1]);
    for (name, s, rq) in [
        ("as measured", before, run_in.measured.rq_um),
        ("run in", after, run_in.run_in.rq_um),
    ] {
        writeln!(
            text,
            "{name:<11}  loss {}, {:.4} %, boundary layer on {:.1} % of the load, {}",
            watts(s.loss_w),
            100.0 * s.efficiency,
            100.0 * s.boundary_share,
            heights(rq),
        )?;
    }
    writeln!(
        text,
        "  sliding run in {}: film {}, lubricated asperities {}, boundary layer {}",
        printed.sliding, printed.film, printed.lubricated, printed.boundary,
    )
}

/// Medians of efficiency and loss with their intervals, and the digits that these leave.
fn headline(s: &Summary, uncertainty: &Uncertainty) -> String {
    let [loss, efficiency] = mesh_with_interval(s.power_in_w, uncertainty);
    format!(
        "efficiency (mesh only)  {efficiency}   loss {loss}\n  power in {}",
        watts(s.power_in_w)
    )
}

/// Largest parts of the uncertainty that the first screen names.
const LARGEST_PARTS: usize = 3;
/// Deviation of the median from the run that is worth a line.
const NOTED_SHIFT: f64 = 0.03;

/// The largest parts of the uncertainty, what narrows them, and the trust in the flanks.
fn uncertainty_text(uncertainty: &Uncertainty) -> String {
    const INDENT: &str = "  ";
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
        lines.push(format!(
            "uncertain  {} (half of 5 to 95 %, each alone)",
            named.join(", ")
        ));
        let mut remedies: Vec<&str> = Vec::new();
        for part in &parts {
            if !remedies.contains(&part.remedy.as_str()) {
                remedies.push(&part.remedy);
            }
        }
        lines.push(format!("narrower with  {}", remedies.join("; ")));
    }
    let shift = uncertainty.scale() - 1.0;
    if shift.abs() > NOTED_SHIFT {
        lines.push(format!(
            "the run with every constant at its median loses {} W, the median of the draws lies {:+.0} % off: \
            the boundary rule, the feed of the spots and the bias of the model change the loss in one direction",
            digits.rounded(uncertainty.at_medians_w),
            100.0 * shift,
        ));
    }
    if uncertainty.trust != Trust::SolvedContact {
        lines.push(format!("trust  {}", uncertainty.trust_text()));
    }
    lines
        .iter()
        .map(|line| wrapped(line, INDENT) + "\n")
        .collect()
}

/// Losses by the admissible structures of the model, and by models that measurements refute.
pub fn models(result: &RunResult) -> String {
    let Some(uncertainty) = &result.uncertainty else {
        return "no other models without an uncertainty\n".to_owned();
    };
    let digits = uncertainty.digits();
    let rows = uncertainty.models().map(|row| {
        let loss = row.loss_w.map(|loss| digits.rounded(loss) + " W");
        let loss = loss.unwrap_or("-".to_owned());
        let line = format!("{:<52}  {loss:>8}  {}", row.name, row.standing());
        wrapped(&line, "    ") + "\n"
    });
    std::iter::once("other models, and what refutes them\n".to_owned())
        .chain(rows)
        .collect()
}

/// Table of the published laws, each in place of film and asperity friction.
pub fn published_laws(result: &RunResult) -> String {
    let mut text = String::from(
        "published laws, each in place of film and asperity friction\n\
         law              loss      asperities  range\n",
    );
    for entry in &result.published_laws {
        let loss = match &entry.outcome {
            PublishedOutcome::Applied { loss_w, .. } => watts(*loss_w),
            _ => "-".to_owned(),
        };
        let asperities = if entry.includes_asperities {
            "in"
        } else {
            "out"
        };
        let range = match (entry.inside_its_range, &entry.outcome) {
            (_, PublishedOutcome::Refused(why)) => why.clone(),
            (true, _) => "inside".to_owned(),
            (false, _) => format!("outside: {}", entry.outside.join("; ")),
        };
        let line = format!("{:<15}  {loss:<8}  {asperities:<10}  {range}", entry.law);
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{}",
            wrapped(&line, "                                       ")
        );
    }
    text
}
