//! How far the parameters of one trace depend on what the standards leave open.
//!
//! Sources of the choices: ISO 16610-28 (ends), ISO 4287 and ISO 21920-2 (per section or over the length),
//! ISO 13565-2 (line of the material ratio curve, which makers draw in two ways).
//!
//! Two laboratories that follow the standards may print any value of such a range.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

use crate::RoughnessError;
use crate::gaussian_filter::Ends;
use crate::height_parameters::{HeightParameters, Mode, in_sections, sections_in};
use crate::material_ratio::{RkParameters, rk_of_both_lines};
use crate::preparation::{Preparation, RoughnessFilter, prepare_with};

/// The range of one parameter over all allowed choices.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Ambiguity {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// Smallest value.
    pub low: Length,
    /// Largest value.
    pub high: Length,
    /// What is left open.
    pub choices: &'static str,
}

/// Parameters by name.
type Getter<T> = (&'static str, fn(&T) -> Option<Length>);

const HEIGHTS: [Getter<HeightParameters>; 6] = [
    ("Ra", |p| Some(p.ra)),
    ("Rq", |p| Some(p.rq)),
    ("Rz", |p| Some(p.rz)),
    ("Rt", |p| Some(p.rt)),
    ("RSm", |p| p.rsm),
    ("Rc", |p| p.rc),
];

const MATERIAL: [Getter<RkParameters>; 3] = [
    ("Rk", |p| Some(p.rk)),
    ("Rpk", |p| Some(p.rpk)),
    ("Rvk", |p| Some(p.rvk)),
];

/// The ranges of `profile` under `recipe`, sections of `lambda_c`.
///
/// Ends that the trace is too short for are left out.
///
/// # Errors
/// When the trace is too short under every convention.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::{ambiguity::ambiguity, generate::SelfAffine};
/// use asperity_roughness::preparation::{Preparation, RoughnessFilter};
/// let recipe = SelfAffine {
///     points: 12_000, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
///     roll_off: Length::from_si(100e-6), short_cut: Length::from_si(5e-6), seed: 7,
/// };
/// let trace = recipe.generate()?;
/// let found = ambiguity(&trace, &Preparation::default(), RoughnessFilter::Gaussian, Length::from_si(0.8e-3))?;
/// assert!(found.iter().all(|range| range.low <= range.high));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn ambiguity(
    profile: &Profile,
    recipe: &Preparation,
    filter: RoughnessFilter,
    lambda_c: Length,
) -> Result<Vec<Ambiguity>, RoughnessError> {
    let (mut heights, mut material, mut refused) = (Vec::new(), Vec::new(), None);
    for ends in [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect] {
        let recipe = Preparation { ends, ..*recipe };
        match evaluated(profile, &recipe, filter, lambda_c) {
            Ok((both_modes, both_lines)) => {
                heights.extend(both_modes);
                material.extend(both_lines);
            }
            Err(error) => refused = Some(error),
        }
    }
    match refused {
        Some(error) if heights.is_empty() => Err(error),
        _ => {
            let mut found = ranges(&HEIGHTS, &heights, "ends, ISO 4287 or ISO 21920-2");
            found.extend(ranges(
                &MATERIAL,
                &material,
                "ends, least-squares or secant line",
            ));
            Ok(found)
        }
    }
}

/// Parameters in both modes and with both lines.
fn evaluated(
    profile: &Profile,
    recipe: &Preparation,
    filter: RoughnessFilter,
    lambda_c: Length,
) -> Result<([HeightParameters; 2], [RkParameters; 2]), RoughnessError> {
    let prepared = prepare_with(profile, recipe, filter)?.profile;
    let sections = sections_in(&prepared, lambda_c)?;
    Ok((
        [
            in_sections(&prepared, Mode::Iso4287, sections)?,
            in_sections(&prepared, Mode::Iso21920, sections)?,
        ],
        rk_of_both_lines(prepared.heights())?,
    ))
}

fn ranges<T>(getters: &[Getter<T>], found: &[T], choices: &'static str) -> Vec<Ambiguity> {
    let range = |(parameter, get): &Getter<T>| {
        let values: Vec<f64> = found.iter().filter_map(get).map(Length::si).collect();
        let low = values.iter().copied().reduce(f64::min)?;
        let high = values.iter().copied().reduce(f64::max)?;
        Some(Ambiguity {
            parameter,
            low: Length::from_si(low),
            high: Length::from_si(high),
            choices,
        })
    };
    getters.iter().filter_map(range).collect()
}
