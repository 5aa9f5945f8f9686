//! Flanks of which only roughness values are known: what a case states of them, and what is assumed.

use asperity_core::Code;
use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_flanks::surfaces::Texture;
use asperity_flanks::surrogate_record::SurrogateRecord;
use asperity_flanks::surrogates::{
    KnownFlank, StatedParameter, SurrogateInputs, Surrogates, surrogates,
};
use asperity_flanks::trace::Flank;
use asperity_roughness::generate::{Finish, LAMBDA_S};

use super::flank_inputs::FlankInputs;
use super::flank_trace::{Context, FlankKeys};
use crate::input::case_input::FlankInput;
use crate::input::finish::FinishName;
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::section::Section;

/// Ra above which a flank of unknown finish is ground \[m\].
const GROUND_FROM: f64 = 0.15e-6;
/// Ra below which a flank of unknown finish is superfinished \[m\].
const SUPERFINISHED_TO: f64 = 0.08e-6;
/// Relative deviation of a mean value from the stated one that is reported.
const NOTED_DEVIATION: f64 = 0.1;

/// The surrogates of the flanks without a trace, with the finishes and cut-offs that the case leaves open; `None` if both have
/// traces, or the contact is not solved.
pub(crate) fn surrogates_of(
    context: Context<'_>,
    inputs: [(&FlankInput, &FlankKeys); 2],
    flanks: &[Vec<Flank>; 2],
    warnings: &mut Vec<Warning>,
) -> Result<Option<(Surrogates, Vec<DefaultUsed>)>, CaseError> {
    let is_traced = |body: usize| {
        let first = flanks[body].first().map(|flank| &flank.texture);
        matches!(first, Some(Texture::Trace(_)))
    };
    let traced = [is_traced(0), is_traced(1)];
    if traced == [true; 2] || !context.inputs.solves_contact {
        return Ok(None);
    }
    let mut assumed = Vec::new();
    let mut known: [Option<KnownFlank>; 2] = [None, None];
    for body in (0..2).filter(|body| !traced[*body]) {
        known[body] = match &known[0] {
            Some(pinion) if values_of(inputs[0].0) == values_of(inputs[1].0) => {
                Some(pinion.clone())
            }
            _ => Some(known_of(
                context,
                inputs[body].0,
                inputs[body].1,
                &mut assumed,
            )?),
        };
    }
    let known_flanks = || known.iter().flatten();
    if traced == [false; 2] && known_flanks().all(|known| known.lambda_s.is_none()) {
        assumed.push(DefaultUsed {
            key: "surface.noise_cutoff".into(),
            value: "\"2.5 um\" to \"25 um\"".to_owned(),
            source: Some("of the stated roughness values, sampled for each surrogate pair".into()),
        });
    }
    let is_open = known_flanks().any(KnownFlank::is_open);
    let preparation = &context.inputs.preparation;
    let made_of = SurrogateInputs {
        known,
        length: trace_length(context.inputs),
        cutoffs: [preparation.lambda_c, preparation.lambda_s],
    };
    let made = surrogates(&made_of, flanks).map_err(|(body, error)| {
        CaseError::preparation(format!("surrogate of {}", inputs[body].1.table), error)
    })?;
    if let Some(made) = &made {
        warnings.push(generated(&made_of.known, &made.records));
    }
    if is_open {
        let text = "a flank with Ra between 0.08 and 0.15 um may be ground or superfinished: half of its surrogates are ground, half are superfinished. State surface.finish";
        warnings.push(Warning::new(Code::W437, text));
    }
    Ok(made.map(|made| (made, assumed)))
}

/// Length of a surrogate: a usual trace, on large gears the height of a tooth, and at least five sections.
fn trace_length(inputs: &FlankInputs) -> Length {
    const USUAL: f64 = 3e-3;
    const LONGEST: f64 = 40e-3;
    let section = inputs.preparation.lambda_c.map_or(0.0, Length::si);
    let height = 2.0 * inputs.gears.normal_module.si();
    Length::from_si(height.clamp(USUAL, LONGEST).max(5.0 * section))
}

/// Stated values, finish and cut-off of a flank.
fn known_of(
    context: Context<'_>,
    input: &FlankInput,
    keys: &FlankKeys,
    assumed: &mut Vec<DefaultUsed>,
) -> Result<KnownFlank, CaseError> {
    let section = Section::new(context.source, keys.table);
    let stated = [
        (StatedParameter::Ra, input.ra),
        (StatedParameter::Rq, input.rq),
        (StatedParameter::Rz, input.rz),
        (StatedParameter::Rpk, input.rpk),
    ];
    let stated = stated.into_iter();
    let values = stated.filter_map(|(parameter, value)| Some((parameter, value?)));
    let values = values.collect();
    let surface = &context.inputs.surface;
    let (finish, of) = match input.finish {
        Some(finish) => (Some(finish), section),
        None => (surface.finish, Section::new(context.source, "surface")),
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
    Ok(KnownFlank {
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
    /// Rq and Rz over Ra, near enough for a limit that is assumed.
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

/// W438: flanks that were generated, the stated values that they miss, and an unknown cut-off.
fn generated(known: &[Option<KnownFlank>; 2], records: &[Option<SurrogateRecord>; 2]) -> Warning {
    let text = |body: usize| Some(of_flank(known[body].as_ref()?, records[body].as_ref()?));
    let text = match [text(0), text(1)] {
        [Some(pinion), Some(wheel)] if pinion == wheel => format!("both flanks: {pinion}"),
        [Some(pinion), Some(wheel)] => format!("pinion: {pinion}. Wheel: {wheel}"),
        [Some(one), None] => format!("pinion: {one}"),
        [None, one] => format!("wheel: {}", one.unwrap_or_default()),
    };
    Warning::new(Code::W438, text)
}

fn of_flank(known: &KnownFlank, record: &SurrogateRecord) -> String {
    let names: Vec<_> = known
        .values
        .iter()
        .map(|(parameter, _)| parameter.name())
        .collect();
    let mut text = format!(
        "no trace was measured, {} surrogates ({}) have the stated {}",
        record.count,
        record.finishes.join(", "),
        names.join(", ")
    );
    for (parameter, stated) in known.values.iter().skip(1) {
        let mean = match parameter {
            StatedParameter::Rz => record.rz_um,
            StatedParameter::Rpk => record.rpk_um,
            _ => continue,
        };
        let name = parameter.name();
        let stated = 1e6 * stated.si();
        if (mean / stated - 1.0).abs() > NOTED_DEVIATION {
            text += &format!(" but {name} {mean:.3} um where {stated:.3} um is stated");
        }
    }
    if known.lambda_s.is_none() {
        text += ". Their noise cut-off is assumed to be 2.5 to 25 um: state surface.noise_cutoff";
    }
    text
}
