//! Surrogate flanks for flanks of which only roughness values are known.
//!
//! The load share needs the heights of both flanks. Where a flank has no trace, profiles of its finish are generated and
//! scaled to the stated values. Their shape is not known, so the loss is the mean over pairs of several shapes.

use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_roughness::generate::{Finish, LAMBDA_S, Surrogate};
use asperity_roughness::{Parameters, RoughnessError};

use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::finish::FinishName;
use super::flank_trace::{Context, Flank, Keys};
use super::input::FlankInput;
use super::law_names::LoadShareName;
use super::resolve::Case;
use super::section::Section;
use crate::flanks::surfaces::{PairsOfTeeth, Surfaces, Texture};
use crate::flanks::surrogate_record::SurrogateRecord;
use asperity_core::message::Warning;

/// Pairs that are solved.
const PAIRS: usize = 12;
/// Pairs of which those nearest to a second stated value are solved.
const CANDIDATES: usize = 36;
/// Ra above which a flank of unknown finish is ground \[m\].
const GROUND_FROM: f64 = 0.15e-6;
/// Ra below which a flank of unknown finish is superfinished \[m\].
const SUPERFINISHED_TO: f64 = 0.08e-6;
/// Relative deviation of a mean value from the stated one that is reported.
const NOTED_DEVIATION: f64 = 0.1;

/// Whether a case solves the contact of its flanks, and so needs surrogates of flanks without a trace.
pub(super) fn solves_contact(case: &Case) -> bool {
    let law = case.model.load_share;
    case.formulation.pressures().is_none() && (law.supply().is_some() || law == LoadShareName::Ehl)
}

/// A roughness parameter.
type Parameter = fn(&Parameters) -> Length;

/// Stated values of a flank without a trace, its finish and cut-off.
#[derive(Clone)]
struct Known {
    /// Name, stated value and parameter; the heights are scaled to the first.
    values: Vec<(&'static str, Length, Parameter)>,
    /// Finish of even and odd pairs.
    finishes: [Finish; 2],
    /// Cut-off λs of the values, if it is stated.
    lambda_s: Option<Length>,
}

/// One surrogate: its profile with the stated size.
struct Made {
    profile: Profile,
    /// Parameters before the profile was scaled by the factor.
    parameters: Parameters,
    factor: f64,
    lambda_s: Length,
    finish: Finish,
}

impl Made {
    fn value(&self, parameter: Parameter) -> Length {
        parameter(&self.parameters) * self.factor
    }
}

impl Known {
    /// Sum of the squared logarithms by which `made` misses the stated values.
    fn distance(&self, made: &Made) -> f64 {
        let values = self.values.iter();
        values
            .map(|(_, stated, parameter)| (made.value(*parameter) / *stated).ln().powi(2))
            .sum()
    }

    fn make(&self, recipe: Surrogate) -> Result<Made, RoughnessError> {
        let (profile, parameters) = recipe.generate()?;
        let scaled_to = self.values.first();
        let factor = scaled_to.map_or(1.0, |(_, stated, parameter)| {
            *stated / parameter(&parameters)
        });
        let heights = profile.heights().iter().map(|z| factor * z).collect();
        Ok(Made {
            profile: Profile::new(profile.spacing(), heights)?,
            parameters,
            factor,
            lambda_s: recipe.lambda_s(),
            finish: recipe.finish,
        })
    }
}

/// Both flanks in pairs, with a record of those that were generated.
pub(super) struct Surrogates {
    pub surfaces: Surfaces,
    pub records: [Option<SurrogateRecord>; 2],
    /// Finishes and cut-offs that the case leaves open.
    pub assumed: Vec<DefaultUsed>,
}

/// The surrogates of the flanks without a trace, each pair with a trace of the other flank if that has one; `None` if both
/// have traces, or the contact is not solved.
pub(super) fn surrogates(
    context: Context<'_>,
    inputs: [(&FlankInput, &Keys); 2],
    flanks: &[Vec<Flank>; 2],
    warnings: &mut Vec<Warning>,
) -> Result<Option<Surrogates>, CaseError> {
    let case = context.case;
    let is_traced = |body: usize| {
        let first = flanks[body].first().map(|flank| &flank.texture);
        matches!(first, Some(Texture::Trace(_)))
    };
    let traced = [is_traced(0), is_traced(1)];
    if traced == [true; 2] || !solves_contact(case) {
        return Ok(None);
    }
    let mut assumed = Vec::new();
    let mut known: [Option<Known>; 2] = [None, None];
    for body in (0..2).filter(|body| !traced[*body]) {
        known[body] = match &known[0] {
            Some(pinion) if values_of(inputs[0].0) == values_of(inputs[1].0) => {
                Some(pinion.clone())
            }
            _ => Some(known_of(context, inputs[body], &mut assumed)?),
        };
    }
    let known_flanks = || known.iter().flatten();
    if traced == [false; 2] && known_flanks().all(|known| known.lambda_s.is_none()) {
        assumed.push(DefaultUsed {
            key: "surface.noise_cutoff".into(),
            value: "\"2.5 um\" to \"25 um\"".to_owned(),
            source: Some("of the stated roughness values, drawn for each surrogate pair".into()),
        });
    }
    let is_open = known_flanks().any(|known| known.finishes[0] != known.finishes[1]);
    let is_selected = known_flanks().any(|known| known.values.len() > 1);
    let count = if is_selected { CANDIDATES } else { PAIRS };
    let spacing = flanks
        .iter()
        .flatten()
        .find_map(|flank| match &flank.texture {
            Texture::Trace(trace) => Some(trace.spacing()),
            Texture::Values { .. } => None,
        });
    let lambda_c = case.preparation.lambda_c;
    let recipe = |body: usize, number: usize, known: &Known| Surrogate {
        finish: known.finishes[number % 2],
        number: [number, count],
        body,
        length: trace_length(case),
        spacing: spacing.unwrap_or(SPACING),
        lambda_s: known.lambda_s,
        lambda_c,
    };
    let mut candidates = Vec::with_capacity(count);
    for k in 0..count {
        let make = |body: usize| {
            let made = known[body]
                .as_ref()
                .map(|known| known.make(recipe(body, k, known)));
            let refused = |source| {
                CaseError::preparation(format!("surrogate of {}", inputs[body].1.table), source)
            };
            made.transpose().map_err(refused)
        };
        candidates.push([make(0)?, make(1)?]);
    }
    let chosen = nearest(candidates, &known, is_open);
    let pairs = chosen.iter().enumerate();
    let met = pairs.map(|(k, pair)| vec![in_contact(case, pair, flanks, k)]);
    let met = met.collect();
    let surfaces = Surfaces::of_pairs(PairsOfTeeth { teeth: None, met });
    let records = [0, 1].map(|body: usize| record(&chosen, body));
    warnings.push(generated(&known, &records));
    if is_open {
        let text = "a flank with Ra between 0.08 and 0.15 um may be ground or superfinished: half of its surrogates are ground, half are superfinished. State surface.finish";
        warnings.push(Warning::new(Code::W437, text));
    }
    Ok(surfaces.map(|surfaces| Surrogates {
        surfaces,
        records,
        assumed,
    }))
}

/// Distance of the points of a surrogate.
const SPACING: Length = Length::from_si(0.5e-6);

/// Length of a surrogate: a usual trace, on large gears the height of a tooth, and at least five sections.
fn trace_length(case: &Case) -> Length {
    const USUAL: f64 = 3e-3;
    const LONGEST: f64 = 40e-3;
    let section = case.preparation.lambda_c.map_or(0.0, Length::si);
    let height = 2.0 * case.gears.normal_module.si();
    Length::from_si(height.clamp(USUAL, LONGEST).max(5.0 * section))
}

/// Stated values, finish and cut-off of a flank.
fn known_of(
    context: Context<'_>,
    (input, keys): (&FlankInput, &Keys),
    assumed: &mut Vec<DefaultUsed>,
) -> Result<Known, CaseError> {
    let section = Section::of(context.source, keys.table);
    let stated: [(&str, Option<Length>, Parameter); 4] = [
        ("Ra", input.ra, |of| of.heights.ra),
        ("Rq", input.rq, |of| of.heights.rq),
        ("Rz", input.rz, |of| of.heights.rz),
        ("Rpk", input.rpk, |of| of.material.rpk),
    ];
    let stated = stated.into_iter();
    let values = stated.filter_map(|(name, value, parameter)| Some((name, value?, parameter)));
    let values = values.collect();
    let surface = &context.case.input.surface;
    let (finish, of) = match input.finish {
        Some(finish) => (Some(finish), section),
        None => (surface.finish, Section::of(context.source, "surface")),
    };
    let finishes = match finish {
        Some(finish) => {
            let recipe = finish.recipe().ok_or_else(|| {
                CaseError::no_recipe(of.place("finish"), of.key("finish"), finish.name())
            })?;
            [recipe; 2]
        }
        None => by_ra(input, section, assumed),
    };
    let lambda_s = surface.noise_cutoff.map(|stated| {
        // No stylus resolves less than the shortest cut-off.
        Length::from_si(stated.si().max(LAMBDA_S[0].si()))
    });
    Ok(Known {
        values,
        finishes,
        lambda_s,
    })
}

/// Everything that decides the surrogates of a flank.
fn values_of(input: &FlankInput) -> ([Option<Length>; 4], Option<FinishName>) {
    ([input.ra, input.rq, input.rz, input.rpk], input.finish)
}

/// Finish of even and odd pairs where none is stated.
fn by_ra(input: &FlankInput, section: Section<'_>, assumed: &mut Vec<DefaultUsed>) -> [Finish; 2] {
    /// Rq and Rz over Ra, near enough for a limit that is judgement.
    const RATIOS: [f64; 2] = [1.25, 7.0];
    let of = |value: Option<Length>, ratio: f64| value.map(|value| value.si() / ratio);
    let ra = of(input.ra, 1.0)
        .or(of(input.rq, RATIOS[0]))
        .or(of(input.rz, RATIOS[1]));
    let ra = ra.unwrap_or_default();
    let (name, finish, why) = if ra > GROUND_FROM {
        (FinishName::Ground, Finish::Ground, "Ra above 0.15 um")
    } else if ra < SUPERFINISHED_TO {
        let finish = Finish::Superfinished;
        (FinishName::Superfinished, finish, "Ra below 0.08 um")
    } else {
        return [Finish::Ground, Finish::Superfinished];
    };
    assumed.push(DefaultUsed {
        key: section.key("finish"),
        value: format!("\"{}\"", name.name()),
        source: Some(why.into()),
    });
    [finish; 2]
}

/// The pairs nearest to all stated values, the nearest first; of an open finish half of each, in turn.
fn nearest(
    candidates: Vec<[Option<Made>; 2]>,
    known: &[Option<Known>; 2],
    is_open: bool,
) -> Vec<[Option<Made>; 2]> {
    let distance = |pair: &[Option<Made>; 2]| -> f64 {
        let flanks = pair.iter().zip(known);
        let known =
            flanks.filter_map(|(made, known)| Some(known.as_ref()?.distance(made.as_ref()?)));
        known.sum()
    };
    let mut classes: [Vec<(f64, [Option<Made>; 2])>; 2] = Default::default();
    for (k, pair) in candidates.into_iter().enumerate() {
        classes[if is_open { k % 2 } else { 0 }].push((distance(&pair), pair));
    }
    for class in &mut classes {
        class.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    let [mut first, mut second] = classes.map(|class| class.into_iter().map(|(_, pair)| pair));
    let in_turn = std::iter::from_fn(|| Some([first.next(), second.next()]));
    in_turn
        .take(PAIRS)
        .flat_map(|both| both.into_iter().flatten())
        .take(PAIRS)
        .collect()
}

/// Pair `k`, whose traced flank has one of its traces.
fn in_contact(
    case: &Case,
    pair: &[Option<Made>; 2],
    flanks: &[Vec<Flank>; 2],
    k: usize,
) -> Surfaces {
    let traced = |body: usize| &flanks[body][k % flanks[body].len()];
    let textures = [0, 1].map(|body: usize| match &pair[body] {
        Some(made) => Texture::Trace(made.profile.clone()),
        None => traced(body).texture.clone(),
    });
    let lambda_s = |body: usize| match (&pair[body], &traced(body).report.preparation) {
        (Some(made), _) => Some(made.lambda_s),
        (None, Some(record)) => record.recipe.lambda_s,
        (None, None) => case.preparation.lambda_s,
    };
    let longer = |a: Length, b: Length| if a < b { b } else { a };
    let noise_cutoff = [lambda_s(0), lambda_s(1)]
        .into_iter()
        .flatten()
        .reduce(longer);
    let rz = [0, 1].map(|body: usize| match &pair[body] {
        Some(made) => Some(made.value(|of| of.heights.rz)),
        None => {
            let parameters = traced(body).report.parameters.as_ref();
            parameters.map(|parameters| parameters.heights.rz)
        }
    });
    Surfaces::new(textures, noise_cutoff, false).with_rz(rz)
}

/// Record of the surrogates of a flank; `None` of a traced flank.
fn record(chosen: &[[Option<Made>; 2]], body: usize) -> Option<SurrogateRecord> {
    let made = || chosen.iter().filter_map(|pair| pair[body].as_ref());
    let count = made().count();
    let mean = |parameter: Parameter| {
        made()
            .map(|made| 1e6 * made.value(parameter).si())
            .sum::<f64>()
            / count as f64
    };
    let has = |finish: Finish| made().any(|made| made.finish == finish);
    let lambda_s = || made().map(|made| 1e6 * made.lambda_s.si());
    let names = [
        (Finish::Ground, FinishName::Ground),
        (Finish::Superfinished, FinishName::Superfinished),
    ];
    (count > 0).then(|| SurrogateRecord {
        count,
        finishes: (names.iter().filter(|(finish, _)| has(*finish)))
            .map(|(_, name)| name.name().to_owned())
            .collect(),
        ra_um: mean(|of| of.heights.ra),
        rz_um: mean(|of| of.heights.rz),
        rpk_um: mean(|of| of.material.rpk),
        lambda_s_um: [
            lambda_s().fold(f64::INFINITY, f64::min),
            lambda_s().fold(0.0, f64::max),
        ],
    })
}

/// W438: flanks that were generated, the stated values that they miss, and an unknown cut-off.
fn generated(known: &[Option<Known>; 2], records: &[Option<SurrogateRecord>; 2]) -> Warning {
    let text = |body: usize| Some(of_flank(known[body].as_ref()?, records[body].as_ref()?));
    let text = match [text(0), text(1)] {
        [Some(pinion), Some(wheel)] if pinion == wheel => format!("both flanks: {pinion}"),
        [Some(pinion), Some(wheel)] => format!("pinion: {pinion}. Wheel: {wheel}"),
        [Some(one), None] => format!("pinion: {one}"),
        [None, one] => format!("wheel: {}", one.unwrap_or_default()),
    };
    Warning::new(Code::W438, text)
}

fn of_flank(known: &Known, record: &SurrogateRecord) -> String {
    let names: Vec<_> = known.values.iter().map(|(name, ..)| *name).collect();
    let mut text = format!(
        "no trace was measured, {} surrogates ({}) have the stated {}",
        record.count,
        record.finishes.join(", "),
        names.join(", ")
    );
    for (name, stated, _) in known.values.iter().skip(1) {
        let mean = match *name {
            "Rz" => record.rz_um,
            "Rpk" => record.rpk_um,
            _ => continue,
        };
        let stated = 1e6 * stated.si();
        if (mean / stated - 1.0).abs() > NOTED_DEVIATION {
            text += &format!(" but {name} {mean:.3} um where {stated:.3} um is stated");
        }
    }
    if known.lambda_s.is_none() {
        text += "; their noise cut-off is assumed to be 2.5 to 25 um: state surface.noise_cutoff";
    }
    text
}
