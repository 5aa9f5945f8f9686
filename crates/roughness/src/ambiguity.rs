//! Ambiguity of roughness parameters: their dependence on choices that the standards leave open.
//!
//! Sources of the choices: ISO 16610-28 (ends), ISO 4287 and ISO 21920-2 (per section or over the length), ISO 13565-2
//! (equivalent line of the material ratio curve, by least squares or as a secant), ISO 3274 (λ_s, which older
//! instruments do not apply).
//!
//! Laboratories that follow the standards may report any value in such a range. The choices are changed from the recipe
//! one at a time, which attributes each range to a choice.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

use crate::error::RoughnessError;
use crate::gaussian_filter::Ends;
use crate::height_parameters::{HeightParameters, Mode, in_sections, sections_in};
use crate::material_ratio::{RkParameters, rk_of_both_lines};
use crate::preparation::{Preparation, RoughnessFilter, prepare_with};

/// Division of the evaluation length into sections.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sections {
    /// Sections of this length, as many as fit.
    OfLength(Length),
    /// This number of equal sections.
    Number(usize),
}

impl Sections {
    /// Number of sections in `profile`.
    ///
    /// # Errors
    /// When the profile is shorter than a section.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::ambiguity::Sections;
    /// let profile = Profile::new(Length::from_si(1e-6), vec![0.0; 4000])?;
    /// assert_eq!(Sections::OfLength("0.8 mm".parse()?).number_in(&profile)?, 5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn number_in(self, profile: &Profile) -> Result<usize, RoughnessError> {
        match self {
            Self::OfLength(length) => sections_in(profile, length),
            Self::Number(number) => Ok(number),
        }
    }
}

/// A choice that the standards leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Choice {
    /// Treatment of the ends by the filters: `cut`, `reg0`, `reg1` or `reflect`.
    Ends,
    /// ISO 4287 or ISO 21920-2.
    Standard,
    /// The line of Rk by least squares or as a secant.
    Line,
    /// With λ_s of the recipe, or without λ_s.
    ShortCutoff,
}

/// Range of a parameter over a choice, in the unit of its [`Ambiguity`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spread {
    /// The varied choice.
    pub choice: Choice,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

/// Range of a parameter over all permitted choices.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ambiguity {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// SI unit of the values: `m`, `%`, or `-`.
    pub unit: &'static str,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// Ranges over the individual choices that the parameter depends on.
    pub spreads: Vec<Spread>,
}

/// Name, unit and accessor of a parameter.
type Getter<T> = (&'static str, &'static str, fn(&T) -> Option<f64>);

const HEIGHTS: [Getter<HeightParameters>; 12] = [
    ("Ra", "m", |p| Some(p.ra.si())),
    ("Rq", "m", |p| Some(p.rq.si())),
    ("Rz", "m", |p| Some(p.rz.si())),
    ("Rz1max", "m", |p| Some(p.rz1max.si())),
    ("Rp", "m", |p| Some(p.rp.si())),
    ("Rv", "m", |p| Some(p.rv.si())),
    ("Rt", "m", |p| Some(p.rt.si())),
    ("Rc", "m", |p| p.rc.map(Length::si)),
    ("RSm", "m", |p| p.rsm.map(Length::si)),
    ("Rsk", "-", |p| p.rsk),
    ("Rku", "-", |p| p.rku),
    ("Rdq", "-", |p| Some(p.rdq)),
];

const MATERIAL: [Getter<RkParameters>; 5] = [
    ("Rk", "m", |p| Some(p.rk.si())),
    ("Rpk", "m", |p| Some(p.rpk.si())),
    ("Rvk", "m", |p| Some(p.rvk.si())),
    ("Mr1", "%", |p| Some(p.mr1)),
    ("Mr2", "%", |p| Some(p.mr2)),
];

/// Ranges of the parameters of `profile` under `recipe`, evaluated in `sections`; `prepared` is the profile prepared
/// with the recipe.
///
/// End treatments that require a longer trace are omitted.
///
/// # Errors
/// When `prepared` has too few points.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::{ambiguity::{Sections, ambiguity}, generate::SelfAffine};
/// use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare};
/// let recipe = SelfAffine {
///     points: 12_000, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
///     roll_off: Length::from_si(100e-6), short_cut: Length::from_si(5e-6), seed: 7,
/// };
/// let trace = recipe.generate()?;
/// let sections = Sections::OfLength(Length::from_si(0.8e-3));
/// let (recipe, filter) = (Preparation::default(), RoughnessFilter::Gaussian);
/// let prepared = prepare(&trace, &recipe)?.profile;
/// let ranges = ambiguity(&trace, &prepared, &recipe, filter, sections)?;
/// assert!(ranges.iter().all(|range| range.low <= range.high));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn ambiguity(
    profile: &Profile,
    prepared: &Profile,
    recipe: &Preparation,
    filter: RoughnessFilter,
    sections: Sections,
) -> Result<Vec<Ambiguity>, RoughnessError> {
    let of = |recipe: &Preparation| {
        let prepared = prepare_with(profile, recipe, filter)?.profile;
        evaluated(&prepared, sections)
    };
    let base = evaluated(prepared, sections)?;
    let is_filtered = recipe.lambda_c.or(recipe.lambda_s).is_some();
    let others = [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect].into_iter();
    // The robust filter always extends to the ends; the only choice is whether they are cut.
    let is_cut = |ends: Ends| ends == Ends::Cut;
    let is_other = |ends: &Ends| match filter {
        RoughnessFilter::Gaussian => *ends != recipe.ends,
        RoughnessFilter::RobustGaussian => {
            is_cut(*ends) != is_cut(recipe.ends) && [Ends::Cut, Ends::Reg1].contains(ends)
        }
    };
    let others = others.filter(|ends| is_filtered && is_other(ends));
    let other_ends = others.filter_map(|ends| of(&Preparation { ends, ..*recipe }).ok());
    let long = Preparation {
        lambda_s: None,
        ..*recipe
    };
    let all = Variations {
        other_ends: other_ends.collect(),
        without_short: recipe.lambda_s.and_then(|_| of(&long).ok()),
        base,
    };
    let mut ranges = all.ranges(&HEIGHTS, Choice::Standard, |e| &e.heights);
    ranges.extend(all.ranges(&MATERIAL, Choice::Line, |e| &e.lines));
    Ok(ranges)
}

/// Parameters in both modes (ISO 4287 first) and with both equivalent lines (least squares first).
struct EvaluatedVariation {
    heights: [HeightParameters; 2],
    lines: [RkParameters; 2],
}

fn evaluated(prepared: &Profile, sections: Sections) -> Result<EvaluatedVariation, RoughnessError> {
    let sections = sections.number_in(prepared)?;
    Ok(EvaluatedVariation {
        heights: [
            in_sections(prepared, Mode::Iso4287, sections)?,
            in_sections(prepared, Mode::Iso21920, sections)?,
        ],
        lines: rk_of_both_lines(prepared.heights())?,
    })
}

/// Parameters of the recipe and of recipes with one changed choice.
struct Variations {
    base: EvaluatedVariation,
    other_ends: Vec<EvaluatedVariation>,
    without_short: Option<EvaluatedVariation>,
}

impl Variations {
    /// Ranges of the parameters that exist for the recipe itself; `second` is the choice between the two values of
    /// `both`.
    fn ranges<T>(
        &self,
        getters: &[Getter<T>],
        second: Choice,
        both: fn(&EvaluatedVariation) -> &[T; 2],
    ) -> Vec<Ambiguity> {
        let range = |&(parameter, unit, get): &Getter<T>| {
            let first = |e: &EvaluatedVariation| get(&both(e)[0]);
            let base = first(&self.base)?;
            let spread = |choice, values: Vec<f64>| {
                (!values.is_empty()).then(|| Spread {
                    choice,
                    low: values.iter().copied().fold(base, f64::min),
                    high: values.iter().copied().fold(base, f64::max),
                })
            };
            let ends = self.other_ends.iter().filter_map(first);
            let short = self.without_short.iter().filter_map(first);
            let other = get(&both(&self.base)[1]).into_iter();
            let spreads = [
                spread(Choice::Ends, ends.collect()),
                spread(second, other.collect()),
                spread(Choice::ShortCutoff, short.collect()),
            ];
            let spreads: Vec<Spread> = spreads.into_iter().flatten().collect();
            Some(Ambiguity {
                parameter,
                unit,
                low: spreads.iter().map(|s| s.low).fold(base, f64::min),
                high: spreads.iter().map(|s| s.high).fold(base, f64::max),
                spreads,
            })
        };
        getters.iter().filter_map(range).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUTOFF: Length = Length::from_si(0.8e-3);

    /// A wave of 100 points with a step of one wave's height after two thirds.
    fn stepped() -> Profile {
        let wave = |i: usize| 1e-6 * (i as f64 / 100.0 * std::f64::consts::TAU).sin();
        let step = |i: usize| if i > 8000 { 1e-6 } else { 0.0 };
        let heights = (0..12_000).map(|i| wave(i) + step(i)).collect();
        Profile::new(Length::from_si(0.5e-6), heights).unwrap()
    }

    fn of(name: &str, recipe: &Preparation) -> Ambiguity {
        let (sections, filter) = (Sections::OfLength(CUTOFF), RoughnessFilter::Gaussian);
        let prepared = prepare_with(&stepped(), recipe, filter).unwrap().profile;
        let found = ambiguity(&stepped(), &prepared, recipe, filter, sections).unwrap();
        found.into_iter().find(|a| a.parameter == name).unwrap()
    }

    #[test]
    fn each_parameter_is_open_by_the_choices_it_depends_on() {
        let choices = |name| {
            let found = of(name, &Preparation::default());
            found.spreads.iter().map(|s| s.choice).collect::<Vec<_>>()
        };
        let (ends, short) = (Choice::Ends, Choice::ShortCutoff);
        assert_eq!(choices("Ra"), [ends, Choice::Standard, short]);
        assert_eq!(choices("Rk"), [ends, Choice::Line, short]);
    }

    #[test]
    fn the_range_holds_every_value_that_the_choices_give() {
        let recipe = Preparation::default();
        let found = of("Rz", &recipe);
        for ends in [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect] {
            let recipe = Preparation { ends, ..recipe };
            let prepared = prepare_with(&stepped(), &recipe, RoughnessFilter::Gaussian);
            let rough = prepared.unwrap().profile;
            let sections = sections_in(&rough, CUTOFF).unwrap();
            let rz = in_sections(&rough, Mode::Iso4287, sections).unwrap().rz;
            assert!((found.low..=found.high).contains(&rz.si()), "{ends:?}");
        }
        let of_ends = &found.spreads[0];
        assert!(of_ends.low < of_ends.high, "the step is cut differently");
    }

    #[test]
    fn without_a_filter_only_the_standards_and_the_line_are_open() {
        let recipe = Preparation {
            lambda_s: None,
            lambda_c: None,
            ..Preparation::default()
        };
        let found = of("Rq", &recipe);
        let choices: Vec<Choice> = found.spreads.iter().map(|s| s.choice).collect();
        assert_eq!(choices, [Choice::Standard]);
    }
}
