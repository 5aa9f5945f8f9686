//! Lots of flanks of the recipe of a case, their inspection and their loss.

use super::error::of_recipe;
#[cfg(test)]
use asperity::case::LoadShareName;
use asperity::case::LoadedCase;
use asperity::core::cancel::checkpoint;
use asperity::flanks::surfaces::PairsOfTeeth;
use asperity::flanks::{Surfaces, Texture};
use asperity::pipeline::check_heights;
use asperity::{PositionError, Run};
use asperity_core::numerics::{good_fft_length, mean, standard_normal_quantile};
use asperity_core::quantity::Length;
use asperity_core::task::try_par_map;
use asperity_core::{DomainError, Fault, Profile};
use asperity_roughness::generate::{Fitted, stretched};
use asperity_roughness::height_parameters::{Mode, in_sections, sections_in};
use asperity_roughness::material_ratio::rk_parameters;
use chacha20::ChaCha8Rng;
use rand_core::Rng;
use schemars::JsonSchema;
use serde::de::IntoDeserializer;
use serde::{Deserialize, Serialize};

use crate::sweep::{stream, uniform};

/// Pairs of flanks whose mean loss is the loss of a lot.
pub(super) const PAIRS: usize = 16;
/// Lots of which one pair each is run together, so that they share positions, smooth films and the load of the gears.
pub(super) const TOGETHER: usize = 16;
/// Offsets of each pair of traces; other windows of the same flanks would change the loss of a lot by half a percent.
pub(super) const OFFSETS: usize = 2;
/// Ratio of Rq of both flanks up to which they have one recipe.
const ALIKE: f64 = 1.25;
/// Points of all periodic profiles of a recipe by the number of lots: a million points, of 200 lots, have mean parameters
/// with an error of a percent.
const POINTS_OF_A_LOT: usize = 5000;
/// Fewest traces in them.
const FEWEST_TRACES: usize = 32;
/// Roughness parameter of a call-out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RoughnessParameter {
    /// Reduced peak height.
    Rpk,
    /// Root mean square height.
    Rq,
    /// Root mean square slope.
    Rdq,
}

impl std::str::FromStr for RoughnessParameter {
    type Err = serde::de::value::Error;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::deserialize(name.into_deserializer())
    }
}

impl RoughnessParameter {
    /// All parameters; the first is preferred.
    pub const ALL: [Self; 3] = [Self::Rpk, Self::Rq, Self::Rdq];

    /// Symbol on a drawing.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Rpk => "Rpk",
            Self::Rq => "Rq",
            Self::Rdq => "Rdq",
        }
    }

    /// Unit; empty for a slope.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Rpk | Self::Rq => "um",
            Self::Rdq => "",
        }
    }
}

/// Values of [`RoughnessParameter::ALL`] in their units.
pub(super) type Values = [f64; 3];

/// Factors on heights, wavelengths and peaks.
#[derive(Clone, Copy)]
struct Shape([f64; 3]);

impl Shape {
    const RECIPE: Self = Self([1.0; 3]);

    /// This shape with all factors scattered by `scatter`, the standard deviation of their logarithms.
    fn scattered(self, scatter: f64, random: &mut ChaCha8Rng) -> Self {
        let factor = |_| (scatter * standard_normal_quantile(uniform(random))).exp();
        let factors = [0, 1, 2].map(factor);
        Self([0, 1, 2].map(|k| self.0[k] * factors[k]))
    }
}

/// Recipe of one flank or both, with endless traces.
struct Recipe {
    /// Periodic profiles.
    wholes: Vec<Profile>,
    /// Points of a trace that is inspected.
    points: usize,
    /// Mean parameters of its traces.
    values: Values,
}

/// A lot at the height of the recipe.
pub(super) struct Lot {
    /// Parameters of each inspected trace over the parameters of the recipe, mean of both recipes if there are two.
    pub inspected: Vec<Values>,
    /// Logarithms of the parameters of each of its pairs, root mean squares of both flanks; the first pair is run.
    pub pairs: Vec<Values>,
}

/// Lots with a pair of flanks of each.
pub(super) struct Batch {
    pub lots: Vec<Lot>,
    /// Their first pairs.
    met: Surfaces,
}

/// Manufacture of lots for a case.
pub(super) struct Process {
    pub case: LoadedCase,
    /// Of both flanks, or of pinion and wheel.
    recipes: Vec<Recipe>,
    /// Points of the traces of pinion and wheel that are run, as many as those of the case or a little more.
    points: [usize; 2],
    spacing: Length,
    /// Length of a section of the height parameters.
    section: Length,
    scatter: f64,
    seed: u64,
    /// Mean Ra of the recipes \[m\].
    pub ra: f64,
}

impl Process {
    /// Fits the recipes to the traces of `loaded`, and makes periodic profiles for `lots` lots.
    pub(super) fn new(
        loaded: &LoadedCase,
        (scatter, seed): (f64, u64),
        lots: usize,
    ) -> Result<Self, Fault> {
        let case = loaded.without_gearbox().overridden(|over| {
            over.as_measured = true;
            over.offsets = Some(OFFSETS);
        })?;
        let traces = [traces(&case.surfaces, 0)?, traces(&case.surfaces, 1)?];
        check_heights(&case).map_err(|error| asperity::Error::from(Box::new(error)))?;
        let first = [&traces[0][0], &traces[1][0]];
        let section = case.case.preparation.lambda_c;
        let section = section.unwrap_or_else(|| first[0].length() / 5.0);
        let rq = |body: usize| -> Result<f64, Fault> {
            let of = traces[body]
                .iter()
                .map(|trace| Ok(Inspected::new(trace, section)?.values[1]));
            Ok(of.sum::<Result<f64, Fault>>()? / traces[body].len() as f64)
        };
        let ratio = rq(0)? / rq(1)?;
        let all: Vec<Profile> = traces.concat();
        let of_recipes: Vec<&[Profile]> = if (1.0 / ALIKE..=ALIKE).contains(&ratio) {
            vec![&all]
        } else {
            traces.iter().map(Vec::as_slice).collect()
        };
        let mut recipes = Vec::new();
        let mut ra = 0.0;
        for traces in &of_recipes {
            let (recipe, own) = Recipe::new(traces, section, (seed, lots * POINTS_OF_A_LOT))?;
            recipes.push(recipe);
            ra += own / of_recipes.len() as f64;
        }
        Ok(Self {
            points: first.map(|trace| good_fft_length(trace.len())),
            spacing: first[0].spacing(),
            case,
            recipes,
            section,
            scatter,
            seed,
            ra,
        })
    }

    /// Values of each recipe.
    pub(super) fn values(&self) -> Vec<Values> {
        self.recipes.iter().map(|recipe| recipe.values).collect()
    }

    /// Variance of the mean of what differs from trace to trace over all pairs of the profiles, over its variance between pairs:
    /// 2/N for N traces in the profiles of both flanks, 1/N for N in each of two recipes.
    pub(super) fn variance_of_profiles(&self) -> f64 {
        let inverse = |recipe: &Recipe| {
            let points: usize = recipe.wholes.iter().map(Profile::len).sum();
            recipe.points as f64 / points as f64
        };
        let sum = self.recipes.iter().map(inverse).sum::<f64>();
        2.0 * sum / (self.recipes.len() as f64).powi(2)
    }

    /// The lots of these `numbers`, of which `count` traces of each recipe are inspected, on flanks that are in none of their
    /// pairs.
    pub(super) fn batch(
        &self,
        numbers: std::ops::Range<usize>,
        count: usize,
    ) -> Result<Batch, Fault> {
        let (mut lots, mut met) = (Vec::new(), Vec::new());
        for number in numbers {
            checkpoint().map_err(asperity::Error::from)?;
            let (lot, first) = self.lot(number, (count, 1))?;
            lots.push(lot);
            met.push(first);
        }
        let met = Surfaces::of_pairs(PairsOfTeeth { teeth: None, met });
        let met = met.ok_or_else(no_profile)?;
        Ok(Batch { lots, met })
    }

    /// A lot with `count` inspected traces, and its first `kept` pairs.
    fn lot(
        &self,
        number: usize,
        (count, kept): (usize, usize),
    ) -> Result<(Lot, Vec<Surfaces>), Fault> {
        let mut random = stream(self.seed, number as u64, false);
        let Shape(of_lot) = Shape::RECIPE.scattered(self.scatter, &mut random);
        let shape = Shape([1.0, of_lot[1], of_lot[2]]);
        let mut flank = |recipe: &Recipe, points: usize| {
            let own = shape.scattered(self.scatter, &mut random);
            recipe.flank((self.spacing, points), own, &mut random)
        };
        let mut inspected = Vec::with_capacity(count);
        for _ in 0..count {
            let mut mean = [0.0; 3];
            for recipe in &self.recipes {
                let found = Inspected::new(&flank(recipe, recipe.points)?, self.section)?;
                for (mean, (value, of_recipe)) in
                    mean.iter_mut().zip(found.values.iter().zip(recipe.values))
                {
                    *mean += value / of_recipe / self.recipes.len() as f64;
                }
            }
            inspected.push(mean);
        }
        let (mut pairs, mut first) = (Vec::with_capacity(PAIRS), Vec::with_capacity(kept));
        for number in 0..PAIRS {
            let mut of = |body: usize| {
                let recipe = self.recipes.get(body).unwrap_or(&self.recipes[0]);
                flank(recipe, self.points[body])
            };
            let traces = [of(0)?, of(1)?];
            let [one, other] = &traces;
            let found = [
                Inspected::new(one, self.section)?,
                Inspected::new(other, self.section)?,
            ];
            let [one, other] = [found[0].values, found[1].values];
            pairs.push([0, 1, 2].map(|k| 0.5 * (0.5 * (one[k].powi(2) + other[k].powi(2))).ln()));
            if number < kept {
                let rz = found.map(|found| Some(found.rz));
                first.push(self.case.surfaces.with_traces(traces).with_rz(rz));
            }
        }
        Ok((Lot { inspected, pairs }, first))
    }

    /// Mean loss of all pairs of a lot with all heights times `height` \[W\].
    #[cfg(test)]
    pub(super) fn loss_of_lot(&self, number: usize, height: f64) -> Result<f64, Fault> {
        let (_, met) = self.lot(number, (0, PAIRS))?;
        let met = met.into_iter().map(|met| vec![met]).collect();
        let met = Surfaces::of_pairs(PairsOfTeeth { teeth: None, met }).unwrap();
        Ok(mean(self.losses_of_pairs(&met, height)?))
    }

    /// Loss of the first pair of each lot with all heights times `height` \[W\].
    pub(super) fn losses(&self, batch: &Batch, height: f64) -> Result<Vec<f64>, Fault> {
        self.losses_of_pairs(&batch.met, height)
    }

    fn losses_of_pairs(&self, met: &Surfaces, height: f64) -> Result<Vec<f64>, Fault> {
        let case = self.case.with_surfaces(met.with_heights_times(height)?);
        let found = Run::new(&case).losses()?.into_only()?;
        let each = found.offsets.len() / met.pairs();
        let pairs = found.offsets.chunks_exact(each);
        Ok(pairs
            .map(|rows| mean(rows.iter().map(|row| row.loss_w)))
            .collect())
    }
}

impl Recipe {
    /// The recipe of `traces` and its mean Ra \[m\].
    fn new(
        traces: &[Profile],
        section: Length,
        (seed, size): (u64, usize),
    ) -> Result<(Self, f64), Fault> {
        let fitted = Fitted::to(&traces[0], &traces[1..], seed).map_err(of_recipe)?;
        let points = fitted.points;
        let going = || checkpoint().map_err(asperity::Error::from);
        let whole = |k: usize| -> Result<Profile, Fault> {
            going()?;
            // Consecutive seeds would share profiles.
            let seed = stream(seed, k as u64, true).next_u64();
            let longer = Fitted {
                seed,
                // The transforms of a prime number of points take several times as long.
                points: points.next_power_of_two(),
                ..fitted.clone()
            };
            Ok(longer.generate_whole()?)
        };
        let mut wholes = vec![whole(0)?];
        let count = size.max(FEWEST_TRACES * points).div_ceil(wholes[0].len());
        wholes.extend(try_par_map(1..count, whole)?);
        let (mut sum, mut ra, mut number) = ([0.0; 3], 0.0, 0.0);
        for whole in &wholes {
            going()?;
            for part in whole.heights().chunks_exact(points) {
                let found = Inspected::new(&Profile::new(fitted.spacing, part.to_vec())?, section)?;
                for (sum, value) in sum.iter_mut().zip(found.values) {
                    *sum += value;
                }
                ra += found.ra.si();
                number += 1.0;
            }
        }
        let recipe = Self {
            wholes,
            points,
            values: sum.map(|sum| sum / number),
        };
        Ok((recipe, ra / number))
    }

    /// A trace of `points` points from a random place, with the factors of `shape`.
    fn flank(
        &self,
        (spacing, points): (Length, usize),
        Shape([height, wavelength, peak]): Shape,
        random: &mut ChaCha8Rng,
    ) -> Result<Profile, DomainError> {
        let z = self.wholes[(uniform(random) * self.wholes.len() as f64) as usize].heights();
        let begin = uniform(random) * z.len() as f64;
        let mut part = stretched(z, begin, wavelength.recip(), points);
        for z in &mut part {
            *z *= if *z > 0.0 { height * peak } else { height };
        }
        Profile::new(spacing, part)
    }
}

/// What is measured on a trace of a lot.
struct Inspected {
    /// Parameters in their units.
    values: Values,
    ra: Length,
    rz: Length,
}

impl Inspected {
    fn new(trace: &Profile, section: Length) -> Result<Self, Fault> {
        const MICRO: f64 = 1e6;
        let sections = sections_in(trace, section).map_err(of_recipe)?;
        let heights = in_sections(trace, Mode::Iso4287, sections).map_err(of_recipe)?;
        let material = rk_parameters(trace.heights()).map_err(of_recipe)?;
        Ok(Self {
            values: [
                material.rpk.si() * MICRO,
                heights.rq.si() * MICRO,
                heights.rdq,
            ],
            ra: heights.ra,
            rz: heights.rz,
        })
    }
}

/// Distinct traces of a flank.
fn traces(surfaces: &Surfaces, body: usize) -> Result<Vec<Profile>, Fault> {
    let mut found: Vec<Profile> = Vec::new();
    for pair in surfaces.each() {
        match &pair.textures()[body] {
            Texture::Trace(trace) if !found.contains(trace) => found.push(trace.clone()),
            Texture::Trace(_) => {}
            _ => return Err(no_profile()),
        }
    }
    Ok(found)
}

fn no_profile() -> Fault {
    PositionError::no_profile().into()
}

/// The e-drive at two positions with the first `points` of its traces, whose heights are multiplied by `factors`. Its load
/// share is the law of Zhu and Hu, which rises with the heights and needs no contact: lots and limits ask for losses only.
#[cfg(test)]
pub(super) fn e_drive_of(points: usize, factors: [f64; 2]) -> LoadedCase {
    let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    let load = asperity::case::load_with(file, &|input| {
        input.model.positions = Some(2);
        input.model.load_share = Some(LoadShareName::ZhuHu);
    });
    let case = load.unwrap();
    let changed = [0, 1].map(|body: usize| {
        let trace = traces(&case.surfaces, body).unwrap().remove(0);
        let heights = trace.heights().iter().take(points);
        let heights = heights.map(|z| factors[body] * z).collect();
        Profile::new(trace.spacing(), heights).unwrap()
    });
    case.with_surfaces(case.surfaces.with_traces(changed))
}

#[cfg(test)]
mod tests {
    use std::sync::OnceLock;

    use super::*;

    /// The e-drive with all heights of the wheel times `factor`.
    fn e_drive(factor: f64) -> LoadedCase {
        e_drive_of(3600, [1.0, factor])
    }

    /// Lots of flanks of one finish, scattered by 10 %.
    fn alike() -> &'static Process {
        static PROCESS: OnceLock<Process> = OnceLock::new();
        PROCESS.get_or_init(|| Process::new(&e_drive(1.0), (0.1, 1), 20).unwrap())
    }

    /// Mean and standard deviation of Rq over the traces of 24 lots, over Rq of the recipe.
    fn rq(process: &Process) -> [f64; 2] {
        let lots = process.batch(0..24, 8).unwrap().lots.into_iter();
        let all: Vec<f64> = lots
            .flat_map(|lot| lot.inspected)
            .map(|values| values[1])
            .collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let squares = all.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        [mean, (squares / all.len() as f64).sqrt()]
    }

    #[test]
    fn traces_of_lots_have_the_parameters_of_the_recipe_with_the_stated_scatter() {
        let even = Process::new(&e_drive(1.0), (0.0, 1), 20).unwrap();
        let [[even, sampled], [mean, scattered]] = [rq(&even), rq(alike())];
        // 192 traces from 32 lengths: 8 % over the root of 32.
        assert!(
            (even - 1.0).abs() < 0.03 && (mean - even).abs() < 0.03,
            "{even} {mean}"
        );
        // Heights scatter by 10 %, the upper halves of traces and lots by 10 % more: (1 + 2/4) of its square, and waves
        // that the sections of the parameter cut off add a little.
        let added = (scattered.powi(2) - sampled.powi(2)).sqrt();
        assert!((0.10..0.15).contains(&added), "{added}");
    }

    #[test]
    fn flanks_of_different_finishes_have_recipes_of_their_own() {
        assert_eq!(alike().values().len(), 1);
        let process = Process::new(&e_drive(0.3), (0.1, 1), 20).unwrap();
        let [pinion, wheel] = process.values()[..] else {
            panic!("two recipes");
        };
        // The measured Rq of the flanks differ by 5 %, the recipes are of single traces.
        assert!(
            (wheel[1] / pinion[1] / 0.3 - 1.0).abs() < 0.2,
            "{wheel:?} {pinion:?}"
        );
    }
}
