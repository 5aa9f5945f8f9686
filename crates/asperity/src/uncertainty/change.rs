//! Draws of the change of a loss by a change of the flanks.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f_j | change of the loss in draw j over its change with every constant at its median | - |
//! | P_j, P_j' | loss of draw j before and after the change of the flanks, without sampling of the flanks | W |
//! | c_j | watts of a ridge in draw j over its watts at the medians, over the same ratio of all ridges; by the lay of the draw | - |
//! | SE, ν | standard error of the watts by the windows of the traces, its degrees of freedom | W, - |

use asperity_core::cite;
use asperity_core::numerics::{deviation, interpolate, mean, student_t_quantile};

use super::evaluations::{Windows, widest};
use super::recorded::predictive_of;
use crate::contacts::Contacts;
use crate::pipeline::{Options, losses_of};
use crate::result::{Losses, PositionRow};
use crate::sampling::{sampling_of_teeth, wider_like_measured, windows_of_traces};
use asperity_case::case::{LoadedCase, ShareLaw};
use asperity_case::error::Error;
use asperity_uncertainty::{
    ENDS, Predictive, Ranged, SamplingError, StudentOfNormal, UncertainParameter, flank_draws,
    sorted_quantiles,
};

/// Change of a loss in all draws, relative to its change with every constant at its median.
#[derive(Debug, Clone)]
pub struct ChangeDraws {
    /// f_j.
    factors: Vec<f64>,
    /// Lay, if it is drawn, and its value in each draw.
    lay: Option<(Ranged, Vec<f64>)>,
    /// Standard normal number of the sampling.
    sampling: Vec<f64>,
}

/// Offsets of a change of a loss: it needs fewer than a loss.
const OFFSETS: usize = 16;

/// A case with the first of its offsets, and their contacts, which are shared with `contacts`.
///
/// # Errors
/// When a value that is overridden is outside its domain.
pub fn few_offsets_of(
    loaded: &LoadedCase,
    contacts: &Contacts,
) -> Result<(LoadedCase, Contacts), Error> {
    let few = contacts.first(OFFSETS);
    let case = loaded.overridden(|over| over.offsets = Some(few.offsets()))?;
    Ok((case, few))
}

impl ChangeDraws {
    /// The draws of a change from the first case with its contacts to the second; `None` if the loss has no uncertainty or does not
    /// change.
    ///
    /// ```text
    /// f_j = (P_j − P_j')/(P − P')                                                 [Change-draw]
    /// ```
    ///
    /// Both losses have the same draws of constants, structure, tip relief and error of the model: the flanks differ in a few ridges
    /// only.
    ///
    /// # Errors
    /// As [`Run::losses`](crate::Run::losses).
    pub fn new(cases: [(&LoadedCase, &Contacts); 2]) -> Result<Option<Self>, Error> {
        cite!("Change-draw");
        let mut change = vec![0.0; Predictive::count()];
        let mut at_medians = 0.0;
        let mut lay = None;
        for ((loaded, contacts), sign) in cases.into_iter().zip([1.0, -1.0]) {
            let (case, few) = few_offsets_of(loaded, contacts)?;
            let nominal = losses_of(&case, &Options::known(&few))?;
            // The ratios of two losses that are close have the windows of their difference.
            let windows = Windows {
                contacts: &few,
                offsets: OFFSETS,
            };
            let Some(drawn) = predictive_of(&case, &nominal, windows)? else {
                return Ok(None);
            };
            let drawn = Predictive {
                sampling: SamplingError::NONE,
                ..drawn
            };
            drawn.add_draws(&mut change, sign, 0);
            at_medians += sign * drawn.at_medians_w;
            lay = lay.or_else(|| drawn.drawn(UncertainParameter::Lay));
        }
        Ok((at_medians != 0.0).then(|| Self {
            factors: change.into_iter().map(|one| one / at_medians).collect(),
            lay,
            sampling: flank_draws(0).map(|draw| draw.sampling).collect(),
        }))
    }

    /// 5 % and 95 % quantiles of the lay; `None` if it is not drawn.
    #[must_use]
    pub fn ends_of_lay(&self) -> Option<[f64; 2]> {
        let (lay, _) = self.lay.as_ref()?;
        Some(lay.estimate.ends())
    }

    /// 5 % and 95 % quantiles of watts that are the mean of `by_window`, one at each offset of a case with the losses `base`.
    ///
    /// ```text
    /// W_j = f_j c_j (W + SE t_ν,j)                                                [Ridge-draw]
    /// ```
    ///
    /// `by_lay` is c at the 5 and 95 % ends of the lay; c is 1 at its median and linear between, and held beyond the ends.
    #[must_use]
    pub fn quantiles(
        &self,
        loaded: &LoadedCase,
        base: &Losses,
        by_window: &[f64],
        by_lay: [f64; 2],
    ) -> [f64; 2] {
        cite!("Ridge-draw");
        let mean = mean(by_window.iter().copied());
        let error = sampling_error_of_changes(loaded, &base.path, by_window);
        let [error, freedom] = error.unwrap_or([0.0, SamplingError::NONE.freedom]);
        let table = StudentOfNormal::new(freedom);
        let [low, high] = by_lay;
        let of_lay = |j: usize| {
            let (lay, drawn) = self.lay.as_ref()?;
            let lay = lay.estimate;
            let line = [(lay.low, low), (lay.value, 1.0), (lay.high, high)];
            Some(interpolate(&line, drawn[j]))
        };
        let draws = self.factors.iter().zip(&self.sampling).enumerate();
        let drawn = draws.map(|(j, (factor, z))| {
            factor * of_lay(j).unwrap_or(1.0) * (mean + error * table.at(*z))
        });
        sorted_quantiles(&drawn.collect::<Vec<_>>(), ENDS)
    }
}

/// 5 % and 95 % quantiles of the mean of `differences` of losses, one at each offset of a case with the losses `base` \[W\], by
/// the sampling of the flanks; none without traces or with a single offset.
#[must_use]
pub fn sampling_interval(
    loaded: &LoadedCase,
    base: &Losses,
    differences: &[f64],
) -> Option<[f64; 2]> {
    const CONFIDENCE: f64 = 0.90;
    let mean = mean(differences.iter().copied());
    let [error, freedom] = sampling_error_of_changes(loaded, &base.path, differences)?;
    let half = if error > 0.0 {
        error * student_t_quantile(CONFIDENCE, freedom)
    } else {
        0.0
    };
    Some([mean - half, mean + half])
}

/// Standard error of the mean of `differences` by the sampling of the flanks, and its degrees of freedom. They are one at each offset of
/// a case with this `path`. `None` without traces, with a single offset, and by reference solutions, whose friction is the same
/// at every offset.
#[must_use]
pub fn sampling_error_of_changes(
    loaded: &LoadedCase,
    path: &[PositionRow],
    differences: &[f64],
) -> Option<[f64; 2]> {
    if matches!(loaded.case.share_law(), ShareLaw::Reference) {
        return None;
    }
    let surfaces = &loaded.surfaces;
    if surfaces.several_teeth().is_some() {
        let found = sampling_of_teeth(differences, surfaces)?;
        return Some([found.standard_error_w, found.freedom]);
    }
    let windows = windows_of_traces(&loaded.surfaces, loaded.case.model.window, widest(path))?;
    let effective = windows.min(differences.len() as f64).max(2.0);
    let error = wider_like_measured(surfaces) * deviation(differences)? / effective.sqrt();
    Some([error, effective - 1.0])
}

#[cfg(test)]
mod tests {
    use asperity_core::Profile;
    use asperity_core::numerics::Z_95;

    use super::*;
    use crate::pipeline::{LossGradient, gradient, gradient_with};
    use asperity_case::case::load_with;
    use asperity_uncertainty::Draw;

    /// Loss \[W\] that the gradients before and after a change of the heights give to it.
    fn watts(gradients: [&LossGradient; 2], heights: &[[Vec<f64>; 2]; 2]) -> f64 {
        let [before, after] = gradients.map(|one| one.by_height.iter().flatten());
        let falls = heights[0].iter().flatten().zip(heights[1].iter().flatten());
        let all = before.zip(after).zip(falls);
        all.map(|((a, b), (z, lower))| 0.5 * (a + b) * (z - lower))
            .sum()
    }

    #[test]
    fn draws_of_a_saving_follow_the_gradients_with_each_constant_at_its_ends() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let case = load_with(file, &|input| {
            (input.model.positions, input.model.offsets) = (Some(3), Some(1));
        })
        .unwrap();
        let traces = case.surfaces.traces().unwrap().map(Clone::clone);
        let pressed = traces.each_ref().map(|trace| {
            let lower = trace.heights().iter().map(|z| z.min(0.35e-6)).collect();
            Profile::new(trace.spacing(), lower).unwrap()
        });
        let heights =
            [&traces, &pressed].map(|both| both.each_ref().map(|one| one.heights().to_vec()));
        let before = gradient(&case).unwrap();
        let surfaces = before.case.surfaces.with_traces(pressed);
        let changed = before.case.with_surfaces(surfaces);
        let after = gradient(&changed).unwrap();
        let at_medians = watts([&before, &after], &heights);
        let drawn = [&before, &after].map(|found| {
            crate::uncertainty::predictive(&found.case, &found.losses, Some(&found.contacts))
                .unwrap()
                .unwrap()
        });
        // The others change it by a few percent.
        use UncertainParameter::{BoundaryFriction, BoundaryLayer, Lay, PressureViscosity};
        for kind in [BoundaryFriction, BoundaryLayer, Lay, PressureViscosity] {
            let ranged = drawn[0].constants.iter().find(|one| one.kind == kind);
            let ranged = ranged.unwrap();
            for z in [-Z_95, Z_95] {
                let found = [&before, &after].map(|found| {
                    let moved = found
                        .case
                        .overridden(|over| over.set(kind, ranged.at(z)))
                        .unwrap();
                    gradient_with(&found.contacts, &moved).unwrap()
                });
                let expected = watts([&found[0], &found[1]], &heights) / at_medians;
                let loss = |predictive: &Predictive| {
                    let mut draw = Draw::medians();
                    draw.constants[kind as usize] = z;
                    predictive.losses_by(0, &|one| *one = draw)[0]
                };
                let [a, b] = drawn.each_ref().map(loss);
                let by_draws = (a - b) / (drawn[0].at_medians_w - drawn[1].at_medians_w);
                assert!(
                    (by_draws / expected - 1.0).abs() < 0.1,
                    "{kind:?} {z}: {by_draws} {expected}"
                );
            }
        }
    }
}
