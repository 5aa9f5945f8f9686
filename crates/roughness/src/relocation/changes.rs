//! Change of roughness parameters and of the material ratio curve, with the change that noise would make.

use asperity_core::cancel::checkpoint;
use asperity_core::quantity::Length;
use asperity_core::{Profile, cite};

use super::relocated::{Relocation, SETS};
use crate::error::RoughnessError;
use crate::form::Form;
use crate::gaussian_filter::{Ends, mean_line};
use crate::generate::Random;
use crate::height_parameters::{Mode, in_sections, sections_in};
use crate::material_levels::MaterialLevels;
use crate::material_ratio::rk_parameters;
use crate::preparation::{LAMBDA_C, Preparation, prepare};

/// Share of the sets of noise that change a number by less than its floor.
const FLOOR: f64 = 0.95;

/// A number before and after.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Change<T> {
    /// Name of the parameter, or material ratio in %.
    pub of: T,
    /// Before.
    pub before: Length,
    /// After.
    pub after: Length,
    /// Change that noise makes in one of twenty pairs of unchanged traces.
    pub floor: Length,
}

impl<T> Change<T> {
    /// Difference.
    pub fn difference(&self) -> Length {
        self.after - self.before
    }

    /// Whether noise does not explain the difference.
    pub fn is_clear(&self) -> bool {
        self.difference().si().abs() > self.floor.si()
    }
}

impl Relocation {
    /// Ra, Rq, Rpk, Rk and Rvk of both traces over the overlap, per section of λ_c = 0.25 mm as in ISO 4287.
    ///
    /// ```text
    /// floor = 95 % quantile of |X(z_b + n) − X(z_b)| over made noise n                            [Relocation-5]
    /// ```
    ///
    /// # Errors
    /// When the overlap is too short for the filter.
    pub fn parameters(&self) -> Result<[Change<&'static str>; 5], RoughnessError> {
        let [before, after] = [parameters(&self.before)?, parameters(&self.after)?];
        let floors = self.floors(&before, parameters)?;
        let change = |k: usize| Change {
            of: ["Ra", "Rq", "Rpk", "Rk", "Rvk"][k],
            before: Length::from_si(before[k]),
            after: Length::from_si(after[k]),
            floor: Length::from_si(floors[k]),
        };
        Ok([0, 1, 2, 3, 4].map(change))
    }

    /// Levels at material ratios \[%\] of both traces, above the mean line of the first.
    ///
    /// # Errors
    /// When a ratio is not within 0 and 100 %.
    pub fn material_ratio(&self, ratios: &[f64]) -> Result<Vec<Change<f64>>, RoughnessError> {
        let line = mean_line(&self.before, LAMBDA_C, Ends::Reg1)?;
        let levels = |profile: &Profile| -> Result<Vec<f64>, RoughnessError> {
            let heights = profile.heights().iter().zip(&line).map(|(z, w)| z - w);
            let curve = MaterialLevels::from_heights(&heights.collect::<Vec<f64>>())?;
            let levels = ratios.iter().map(|ratio| Ok(curve.level(*ratio)?.si()));
            levels.collect()
        };
        let [before, after] = [levels(&self.before)?, levels(&self.after)?];
        let floors = self.floors(&before, levels)?;
        // The height of the second trace is as uncertain as what was removed.
        let height = 0.5 * (self.removed.high - self.removed.low).si();
        let change = |(k, ratio): (usize, &f64)| Change {
            of: *ratio,
            before: Length::from_si(before[k]),
            after: Length::from_si(after[k]),
            floor: Length::from_si(floors[k].hypot(height)),
        };
        Ok(ratios.iter().enumerate().map(change).collect())
    }

    /// Changes of `numbers` that noise on the first trace, whose numbers are `before`, stays below in most cases.
    fn floors<N: AsRef<[f64]>>(
        &self,
        before: &N,
        numbers: impl Fn(&Profile) -> Result<N, RoughnessError>,
    ) -> Result<Vec<f64>, RoughnessError> {
        cite!("Relocation-5");
        let z = self.before.heights();
        let mut random = Random::new(2);
        let mut changes = vec![Vec::new(); before.as_ref().len()];
        for _ in 0..SETS {
            checkpoint()?;
            let noise = self.differences.made(z.len(), &mut random);
            let noisy = z.iter().zip(noise).map(|(z, n)| z + n).collect();
            let found = numbers(&Profile::new(self.before.spacing(), noisy)?)?;
            let pairs = found.as_ref().iter().zip(before.as_ref());
            for (changes, (found, before)) in changes.iter_mut().zip(pairs) {
                changes.push((found - before).abs());
            }
        }
        let floor = |mut changes: Vec<f64>| {
            changes.sort_unstable_by(f64::total_cmp);
            changes[(FLOOR * SETS as f64) as usize]
        };
        Ok(changes.into_iter().map(floor).collect())
    }
}

/// Ra, Rq, Rpk, Rk and Rvk \[m\].
fn parameters(profile: &Profile) -> Result<[f64; 5], RoughnessError> {
    let recipe = Preparation {
        form: Form::Level,
        lambda_s: None,
        lambda_c: Some(LAMBDA_C),
        ends: Ends::Cut,
    };
    let rough = prepare(profile, &recipe)?.profile;
    let sections = sections_in(&rough, LAMBDA_C)?;
    let heights = in_sections(&rough, Mode::Iso4287, sections)?;
    let core = rk_parameters(rough.heights())?;
    Ok([heights.ra, heights.rq, core.rpk, core.rk, core.rvk].map(Length::si))
}
