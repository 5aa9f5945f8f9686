//! Summary: key numbers, their band, losses along the path, the pair in mesh, warnings.

use asperity::key_words::advice;
use asperity::message::{Code, Warning, outside_codes};
use asperity::result::RunResult;
use asperity::result::loss_band::{Trust, Uncertainty, rounded};
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use maud::{Markup, html};

use super::page::{figure, source};
use crate::other_models;
use crate::printed::{PrintedLoss, PrintedPart, of_mesh};
use crate::summary::priced;
use crate::units::MICRO;

/// The first screen: headline, parts, band, losses along the path, and the pair in mesh; then what the case requests.
pub(super) fn section(result: &RunResult) -> Markup {
    let mut first = headline(result);
    if let Some(gearbox) = &result.gearbox {
        first.extend(super::gearbox::tiles(gearbox, result.uncertainty.as_ref()));
    }
    html! {
        (doubt(&result.warnings))
        @for (class, tiles) in [("tiles first", first), ("tiles", parts(result))] {
            dl class=(class) {
                @for (name, value, key) in tiles {
                    div { dt { (name) } dd data-key=(key) { (value) } }
                }
            }
        }
        @if let Some(gears) = result.mesh.as_deref().and_then(gears_of) { p.sub { (gears) } }
        (of_scans(result))
        p.sub { (own_finish(result)) }
        (trust(&result.warnings, result.uncertainty.as_ref().map(Uncertainty::trust_text)))
        @if let Some(outside) = result.uncertainty.as_ref().and_then(other_models::outside) {
            p.sub { (outside) " The section \"Uncertainty and other models\" has the evidence against each." }
        }
        div.verdict {
            div {
                @if let Some(uncertainty) = &result.uncertainty {
                    (figure(&super::band::tornado(uncertainty))) (super::band::remedies(uncertainty))
                }
                (figure(&super::losses::along_the_path(result)))
            }
            @if let Some(mesh) = super::facing::in_mesh(result) { (mesh) }
        }
        @let warnings = warnings(&result.warnings.iter().map(|warning| priced(warning, result)).collect::<Vec<_>>());
        @if let Some(uncertainty) = &result.uncertainty {
            div.verdict {
                div { (super::band::evidence(&uncertainty.evidence, &|loss| uncertainty.digits().rounded(loss))) }
                div { (warnings) }
            }
        } @else { (warnings) }
        @if let Some(gearbox) = &result.gearbox { (super::gearbox::section(gearbox, result.uncertainty.is_some())) }
        @if let Some(pairs) = &result.pairs { @if let Some(sampling) = &pairs.sampling {
            (super::pairs::section(pairs, sampling, &result.flanks))
        } }
        @if let Some(line) = crate::summary::run_in(result) { p { (line) } }
        @if let Some(report) = &result.micropitting { (super::micropitting::section(report)) }
    }
}

/// The gears of the `mesh` of a train by the names that its page has for them.
fn gears_of(mesh: &str) -> Option<String> {
    let gears = mesh.rsplit(", ").next()?;
    let (first, second) = gears.split_once(" and ")?;
    Some(format!(
        "On this page, and in its keys, the {first} is the pinion and the {second} the wheel."
    ))
}

/// The loss by patches of scans next to their rows; empty without patches.
fn of_scans(result: &RunResult) -> Markup {
    html! { @if let Some(scans) = &result.scans { p { (crate::scans::verdict(scans)) } } }
}

/// The scope of the loss as to the finish: the power that these flanks lose on their asperities, and where another finish
/// is compared.
fn own_finish(result: &RunResult) -> Markup {
    html! {
        @match result.uncertainty.as_ref().map(|uncertainty| uncertainty.trust) {
            Some(Trust::Surrogates) => "The loss is for flanks generated from the stated roughness",
            Some(Trust::RoughnessValues) => "The loss is for the stated roughness values",
            _ => { "The loss is for these two flanks as stated" (heights(result).unwrap_or_default()) }
        }
        @if let Some(share) = printed(result).asperity_share { ": " (share) " of it arises where asperities touch" }
        ". "
        code { "asperity compare" } " computes what another finish would save."
    }
}

/// Ra and Rz of both flanks in brackets; `None` without a trace of each.
fn heights(result: &RunResult) -> Option<String> {
    let [pinion, wheel] = result.flanks.each_ref();
    let of = [pinion.parameters.as_ref()?, wheel.parameters.as_ref()?];
    let both = |name: &str, height: fn(&Parameters) -> Length| {
        let [pinion, wheel] = of.map(|of| {
            let um = height(of).si() * MICRO;
            rounded(um, 0.05 * um)
        });
        format!("{name} {pinion} and {wheel} µm")
    };
    let [ra, rz] = [
        both("Ra", |of| of.heights.ra),
        both("Rz", |of| of.heights.rz),
    ];
    Some(format!(" ({ra}, {rz})"))
}

/// Mark of a warning that makes the result doubtful.
pub(crate) const DOUBTFUL: &str = "Result doubtful:";

/// The gravest warning that makes a result doubtful with its remedy, before the loss.
pub(crate) fn doubt(warnings: &[Warning]) -> Markup {
    let doubtful = warnings
        .iter()
        .filter(|warning| warning.code.doubt().is_some());
    html! { @if let Some(warning) = doubtful.min_by_key(|warning| warning.code.doubt()) {
        p.grave {
            strong { (DOUBTFUL) } " " code { (warning.code.as_str()) } " " (warning.text) ". " b { "First: " } (advice(warning.code))
        }
    } }
}

/// Codes of the warnings that lower the trust in the loss, those that make it doubtful first, then its `level`.
pub(crate) fn trust(warnings: &[Warning], level: Option<String>) -> Markup {
    let codes = || warnings.iter().map(|warning| warning.code);
    let mut doubtful: Vec<Code> = codes().filter(|code| code.doubt().is_some()).collect();
    doubtful.sort_by_key(|code| code.doubt());
    doubtful.dedup();
    let doubtful: Vec<&str> = doubtful.into_iter().map(Code::as_str).collect();
    let of = |what: &str, codes: String| (!codes.is_empty()).then(|| format!("{what} {codes}"));
    let parts = [
        of("doubtful by", doubtful.join(" ")),
        of("outside fitted ranges by", outside_codes(codes())),
        level,
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    html! { @if !parts.is_empty() { p.sub { "Trust: " (parts.join("; ")) "." } } }
}

/// The warnings. The first of a code opens to its cause and its remedy.
pub(crate) fn warnings(warnings: &[Warning]) -> Markup {
    let is_first = |at: usize| {
        warnings[..at]
            .iter()
            .all(|other| other.code != warnings[at].code)
    };
    html! {
        @if !warnings.is_empty() {
            h3 { "Warnings" }
            ul.warnings { @for (at, warning) in warnings.iter().enumerate() { li.grave[warning.code.doubt().is_some()] {
                @let text = html! {
                    @if warning.code.doubt().is_some() { strong { (DOUBTFUL) } " " }
                    code { (warning.code.as_str()) } " " (warning.text)
                };
                @if is_first(at) {
                    details {
                        summary { (text) }
                        p { b { "Why: " } (warning.code.explain().meaning) }
                        p { b { "What to do: " } (advice(warning.code)) }
                    }
                } @else { (text) }
            } } }
        }
    }
}

/// Name, formatted value and key in `result.json` of a number.
type OverviewTile = (&'static str, String, &'static str);

/// Key numbers: efficiency, loss and regime.
fn headline(result: &RunResult) -> Vec<OverviewTile> {
    let [loss, efficiency] = of_mesh(result);
    let mut tiles = match &result.uncertainty {
        Some(_) => vec![
            (
                "efficiency (mesh only), in brackets 5 to 95 %",
                efficiency,
                "summary.efficiency",
            ),
            ("loss, in brackets 5 to 95 %", loss, "summary.loss_w"),
        ],
        None => vec![
            ("efficiency (mesh only)", efficiency, "summary.efficiency"),
            ("loss", loss, "summary.loss_w"),
        ],
    };
    if let Some(bulk) = &result.bulk {
        let value = format!("{:.0} °C, oil {:.0} °C", bulk.bulk_c, bulk.oil_c);
        tiles.push(("bulk temperature by the loss", value, "bulk.bulk_c"));
    }
    tiles
}

/// The loss and its parts as text.
fn printed(result: &RunResult) -> PrintedLoss {
    PrintedLoss::new(&result.summary, result.uncertainty.as_ref())
}

/// Parts of the loss with their shares, and the regime.
fn parts(result: &RunResult) -> Vec<OverviewTile> {
    let s = &result.summary;
    let parts = printed(result).parts.into_iter();
    let tile = |part: PrintedPart| {
        let value = format!("{}, {} of the loss", part.text, part.share);
        (part.name, value, part.key)
    };
    let regime = [
        (
            "mixed, of the path",
            format!("{:.1} %", 100.0 * s.mixed_share),
            "summary.mixed_share",
        ),
        (
            "load on asperities",
            format!("{:.1} %", 100.0 * s.asperity_share),
            "summary.asperity_share",
        ),
    ];
    parts.map(tile).chain(regime).collect()
}

/// The loss by published friction laws, each instead of film and asperity friction.
pub(super) fn laws(result: &RunResult) -> Markup {
    html! {
        h3 { "Published friction laws, each instead of film and asperity friction" }
        (other_models::published_laws(result))
        (source("friction_laws.csv"))
    }
}
