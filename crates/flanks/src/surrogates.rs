//! Surrogate flanks for flanks of which only roughness values are known.
//!
//! The load share needs the heights of both flanks. Where a flank has no trace, profiles of its finish are generated and
//! scaled to the stated values. Their shape is not known, so the loss is the mean over pairs of several shapes.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::generate::{Finish, Surrogate};
use asperity_roughness::{Parameters, RoughnessError};

use crate::surfaces::{PairsOfTeeth, Surfaces, Texture};
use crate::surrogate_record::SurrogateRecord;
use crate::trace::Flank;

/// Pairs that are solved.
const PAIRS: usize = 12;
/// Pairs of which those nearest to a second stated value are solved.
const CANDIDATES: usize = 36;
/// Distance of the points of a surrogate whose partner has no trace.
const SPACING: Length = Length::from_si(0.5e-6);

/// A roughness parameter that is stated of a flank without a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatedParameter {
    /// Ra.
    Ra,
    /// Rq.
    Rq,
    /// Rz.
    Rz,
    /// Rpk.
    Rpk,
}

impl StatedParameter {
    /// Its symbol.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ra => "Ra",
            Self::Rq => "Rq",
            Self::Rz => "Rz",
            Self::Rpk => "Rpk",
        }
    }

    fn of(self, parameters: &Parameters) -> Length {
        match self {
            Self::Ra => parameters.heights.ra,
            Self::Rq => parameters.heights.rq,
            Self::Rz => parameters.heights.rz,
            Self::Rpk => parameters.material.rpk,
        }
    }
}

/// Knowledge of a flank without a trace.
#[derive(Debug, Clone, PartialEq)]
pub struct KnownFlank {
    /// Stated values; the heights are scaled to the first.
    pub values: Vec<(StatedParameter, Length)>,
    /// Finish of even and odd pairs.
    pub finishes: [Finish; 2],
    /// Cut-off λs of the values, if it is stated.
    pub lambda_s: Option<Length>,
}

/// Everything that surrogates follow from, except the traces of the other flank.
#[derive(Debug, Clone, PartialEq)]
pub struct SurrogateInputs {
    /// The flanks without a trace.
    pub known: [Option<KnownFlank>; 2],
    /// Length of a surrogate.
    pub length: Length,
    /// Cut-offs λc and λs of the case.
    pub cutoffs: [Option<Length>; 2],
}

/// Both flanks in pairs, with a record of those that were generated.
#[derive(Debug, Clone)]
pub struct Surrogates {
    /// The pairs.
    pub surfaces: Surfaces,
    /// Records of pinion and wheel; `None` of a traced flank.
    pub records: [Option<SurrogateRecord>; 2],
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
    fn value(&self, parameter: StatedParameter) -> Length {
        parameter.of(&self.parameters) * self.factor
    }
}

impl KnownFlank {
    /// Sum of the squared logarithms by which `made` misses the stated values.
    fn distance(&self, made: &Made) -> f64 {
        let values = self.values.iter();
        values
            .map(|(parameter, stated)| (made.value(*parameter) / *stated).ln().powi(2))
            .sum()
    }

    fn make(&self, recipe: Surrogate) -> Result<Made, RoughnessError> {
        let (profile, parameters) = recipe.generate()?;
        let scaled_to = self.values.first();
        let factor = scaled_to.map_or(1.0, |(parameter, stated)| {
            *stated / parameter.of(&parameters)
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

    /// Whether the finish is open between two.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.finishes[0] != self.finishes[1]
    }
}

/// The surrogates of the flanks without a trace, each pair with a trace of the other flank if that has one; `None` if there is no
/// pair.
///
/// # Errors
/// With the flank, 0 of the pinion, when the generator refuses the numbers.
pub fn surrogates(
    inputs: &SurrogateInputs,
    flanks: &[Vec<Flank>; 2],
) -> Result<Option<Surrogates>, (usize, RoughnessError)> {
    let known = &inputs.known;
    let known_flanks = || known.iter().flatten();
    let is_open = known_flanks().any(KnownFlank::is_open);
    let is_selected = known_flanks().any(|known| known.values.len() > 1);
    let count = if is_selected { CANDIDATES } else { PAIRS };
    let mut all = flanks.iter().flatten();
    let spacing = all.find_map(|flank| match &flank.texture {
        Texture::Trace(trace) => Some(trace.spacing()),
        Texture::Values { .. } => None,
    });
    let recipe = |body: usize, number: usize, known: &KnownFlank| Surrogate {
        finish: known.finishes[number % 2],
        number: [number, count],
        body,
        length: inputs.length,
        spacing: spacing.unwrap_or(SPACING),
        lambda_s: known.lambda_s,
        lambda_c: inputs.cutoffs[0],
    };
    let mut candidates = Vec::with_capacity(count);
    for k in 0..count {
        let make = |body: usize| {
            let made = known[body]
                .as_ref()
                .map(|known| known.make(recipe(body, k, known)));
            made.transpose().map_err(|error| (body, error))
        };
        candidates.push([make(0)?, make(1)?]);
    }
    let chosen = nearest(candidates, known, is_open);
    let pairs = chosen.iter().enumerate();
    let met = pairs.map(|(k, pair)| vec![in_contact(inputs, pair, flanks, k)]);
    let met = met.collect();
    let surfaces = Surfaces::of_pairs(PairsOfTeeth { teeth: None, met });
    let records = [0, 1].map(|body: usize| record(&chosen, body));
    Ok(surfaces.map(|surfaces| Surrogates { surfaces, records }))
}

/// The pairs nearest to all stated values, the nearest first; of an open finish half of each, in turn.
fn nearest(
    candidates: Vec<[Option<Made>; 2]>,
    known: &[Option<KnownFlank>; 2],
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
    inputs: &SurrogateInputs,
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
        (None, None) => inputs.cutoffs[1],
    };
    let longer = |a: Length, b: Length| if a < b { b } else { a };
    let noise_cutoff = [lambda_s(0), lambda_s(1)]
        .into_iter()
        .flatten()
        .reduce(longer);
    let rz = [0, 1].map(|body: usize| match &pair[body] {
        Some(made) => Some(made.value(StatedParameter::Rz)),
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
    let mean = |parameter: StatedParameter| {
        let values = made().map(|made| 1e6 * made.value(parameter).si());
        values.sum::<f64>() / count as f64
    };
    let has = |finish: &Finish| made().any(|made| made.finish == *finish);
    let lambda_s = || made().map(|made| 1e6 * made.lambda_s.si());
    let finishes = [Finish::Ground, Finish::Superfinished];
    (count > 0).then(|| SurrogateRecord {
        count,
        finishes: (finishes.iter().filter(|finish| has(finish)))
            .map(|finish| finish.name().to_owned())
            .collect(),
        ra_um: mean(StatedParameter::Ra),
        rz_um: mean(StatedParameter::Rz),
        rpk_um: mean(StatedParameter::Rpk),
        lambda_s_um: [
            lambda_s().fold(f64::INFINITY, f64::min),
            lambda_s().fold(0.0, f64::max),
        ],
    })
}
