//! Difference of two runs by the draws that they have in common, and what it decides.

use serde::{Deserialize, Serialize};

use crate::result::{AlternativeRow, Losses, Uncertainty};
use asperity_case::case::LoadedCase;
use asperity_case::error::Error;
use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use asperity_uncertainty::{Common, Predictive, Watts, median_with_ends};

use super::common_draws::{CommonConstant, CommonTraces, DrawnCase, common_by, common_constants};
use super::evaluations::at_losses;

/// Probability from which the sign of a difference holds.
const SURE: f64 = 0.95;

estimate_keys! { Share: "median_share" "share_quantiles"; }

/// Difference of the losses of two runs, draw by draw: what both have in common, as the friction of their oil, cancels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PairedDifference {
    /// Difference of the runs, with every constant at its median \[W\].
    pub at_medians_w: f64,
    /// Median of the difference with its 5 % and 95 % quantiles \[W\].
    #[serde(flatten, with = "Watts")]
    pub watts: Estimate,
    /// The same of the difference over the loss of the first.
    #[serde(flatten, with = "Share")]
    pub share: Estimate,
    /// Share of the draws with the sign of the median.
    pub probability: f64,
    /// The difference by every model that was tried, the refuted ones included.
    pub models: Vec<AlternativeRow>,
    /// Decision by the draws and the models.
    pub verdict: Verdict,
    /// Constants of both, and how far their draws are common.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub common: Vec<CommonConstant>,
}

/// Decision that a difference allows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Verdict {
    /// The cases do not differ.
    Equal,
    /// The sign holds in the draws and under every model.
    Holds,
    /// The sign holds in the draws, but not under these models.
    Except(Vec<String>),
    /// The draws leave the sign open.
    Undecided,
}

impl Verdict {
    fn new(watts: Estimate, probability: f64, models: &[AlternativeRow]) -> Self {
        if watts == Estimate::new(0.0, [0.0; 2]) {
            return Self::Equal;
        }
        if probability < SURE {
            return Self::Undecided;
        }
        let disagrees = |row: &&AlternativeRow| row.loss_w.is_some_and(|d| d * watts.value <= 0.0);
        let others = models.iter().filter(disagrees);
        let others: Vec<String> = others.map(|row| row.name.clone()).collect();
        if others.is_empty() {
            Self::Holds
        } else {
            Self::Except(others)
        }
    }
}

impl PairedDifference {
    /// The least and the largest difference by the models \[W\]; none without models.
    #[must_use]
    pub fn model_range_w(&self) -> Option<[f64; 2]> {
        let known: Vec<f64> = self.models.iter().filter_map(|row| row.loss_w).collect();
        let low = known.iter().copied().reduce(f64::min)?;
        let high = known.iter().copied().reduce(f64::max)?;
        Some([low, high])
    }
}

/// The drawn loss of a mesh of a gear train.
#[derive(Debug, Clone, Copy)]
pub struct DrawnMesh<'a> {
    /// Its case.
    pub loaded: &'a LoadedCase,
    /// Draws.
    pub predictive: &'a Predictive,
    /// Loss by every model.
    pub uncertainty: &'a Uncertainty,
    /// Number of equal meshes.
    pub count: u32,
    /// Draws in common with other meshes.
    pub common: Common,
}

impl<'a> DrawnMesh<'a> {
    /// Loss of all equal meshes with every constant at its median \[W\].
    fn at_medians_w(&self) -> f64 {
        f64::from(self.count) * self.predictive.at_medians_w
    }

    /// Its case with its draws.
    pub(super) fn drawn(&self) -> DrawnCase<'a> {
        (self.loaded, self.predictive)
    }
}

/// The loss of all meshes of a gear train in every draw \[W\].
#[must_use]
pub fn losses_of_meshes(meshes: &[DrawnMesh<'_>]) -> Vec<f64> {
    let mut total = vec![0.0; Predictive::count()];
    for mesh in meshes {
        let count = f64::from(mesh.count);
        mesh.predictive.add_draws(&mut total, count, mesh.common);
    }
    total
}

/// Two runs, each mesh with its draws in common with the other run. The run that loses more at the medians has the first set of
/// draws, so that the order of the two changes the sign of their difference only.
#[must_use]
pub fn beside<'a>(first: Vec<DrawnMesh<'a>>, other: Vec<DrawnMesh<'a>>) -> [Vec<DrawnMesh<'a>>; 2] {
    beside_by(first, other, CommonTraces::AsStated)
}

fn beside_by<'a>(
    first: Vec<DrawnMesh<'a>>,
    other: Vec<DrawnMesh<'a>>,
    traces: CommonTraces,
) -> [Vec<DrawnMesh<'a>>; 2] {
    let at_medians =
        |meshes: &[DrawnMesh<'_>]| -> f64 { meshes.iter().map(DrawnMesh::at_medians_w).sum() };
    let is_swapped = at_medians(&other) > at_medians(&first);
    let mut both = if is_swapped {
        [other, first]
    } else {
        [first, other]
    };
    let [base, beside] = both
        .each_ref()
        .map(|meshes| -> Vec<DrawnCase<'a>> { meshes.iter().map(DrawnMesh::drawn).collect() });
    let flanks: Vec<usize> = both[0].iter().map(|mesh| mesh.common.flanks).collect();
    let common = common_by(&base, &flanks, &beside, traces);
    for (meshes, common) in both.iter_mut().zip(common) {
        for (mesh, common) in meshes.iter_mut().zip(common) {
            mesh.common = common;
        }
    }
    if is_swapped {
        both.reverse();
    }
    both
}

/// A mesh with its draws and its losses by every model.
pub type MeshResult<'a> = (&'a LoadedCase, &'a Predictive, &'a Uncertainty);

/// The loss of the mesh `other` minus the loss of the mesh `first`, with the draws that both have in common.
#[must_use]
pub fn difference(first: MeshResult<'_>, other: MeshResult<'_>) -> PairedDifference {
    let [first, other] = beside(vec![single(first)], vec![single(other)]);
    difference_of_meshes(&first, &other)
}

fn single<'a>((loaded, predictive, uncertainty): MeshResult<'a>) -> DrawnMesh<'a> {
    DrawnMesh {
        loaded,
        predictive,
        uncertainty,
        count: 1,
        common: 0.into(),
    }
}

/// The loss of a mesh minus the loss of the mesh `first`, whose traces are of the same places before a test; `concordance` is that of
/// their heights.
#[must_use]
pub fn difference_of_places(
    first: MeshResult<'_>,
    other: MeshResult<'_>,
    concordance: f64,
) -> PairedDifference {
    let traces = CommonTraces::OfOnePlace(concordance);
    let [first, other] = beside_by(vec![single(first)], vec![single(other)], traces);
    difference_of_meshes(&first, &other)
}

/// Change of the loss of a mesh from a case with its draws to a changed case with its own: median with 5 % and 95 % quantiles \[W\].
#[must_use]
pub fn change_between(first: DrawnCase<'_>, changed: DrawnCase<'_>) -> Estimate {
    asperity_core::cite!("Paired-difference");
    let common = common_by(&[first], &[0], &[changed], CommonTraces::AsStated);
    let of = |drawn: &Predictive, common: &[Common]| {
        let mut total = vec![0.0; Predictive::count()];
        for common in common {
            drawn.add_draws(&mut total, 1.0, *common);
        }
        total
    };
    let (own, theirs) = (of(first.1, &common[0]), of(changed.1, &common[1]));
    median_with_ends(&differences([&own, &theirs]))
}

/// The same of a changed case with its losses. Its draws have its losses, conditions and sampling, and over the constants they change
/// as before: no evaluation is needed.
///
/// # Errors
/// As [`Run::losses`](crate::Run::losses).
pub fn change_of(
    first: DrawnCase<'_>,
    changed: &LoadedCase,
    losses: &Losses,
) -> Result<Estimate, Error> {
    let drawn = at_losses(&changed.at_stated()?, losses, first.1)?;
    Ok(change_between(first, (changed, &drawn)))
}

/// The losses of a run minus the losses of the first, draw by draw.
#[must_use]
pub fn differences([first, own]: [&[f64]; 2]) -> Vec<f64> {
    first
        .iter()
        .zip(own)
        .map(|(first, own)| own - first)
        .collect()
}

/// The loss of all meshes of `other` minus the loss of all meshes of `first`, draw by draw. Cases that differ in nothing
/// differ by exactly 0.
///
/// ```text
/// δ_j = P_other,j − P_first,j                                                [Paired-difference]
/// ```
///
/// The meshes come from [`beside`], which puts their draws in common.
#[must_use]
pub fn difference_of_meshes(first: &[DrawnMesh<'_>], other: &[DrawnMesh<'_>]) -> PairedDifference {
    asperity_core::cite!("Paired-difference");
    let [own, theirs] = [first, other].map(losses_of_meshes);
    let deltas = differences([&own, &theirs]);
    let shares: Vec<f64> = deltas.iter().zip(&own).map(|(d, a)| d / a).collect();
    let watts = median_with_ends(&deltas);
    let agreeing = deltas.iter().filter(|d| **d * watts.value > 0.0).count();
    let probability = agreeing as f64 / deltas.len() as f64;
    let of_model = |row: &AlternativeRow| {
        let of_mesh = |mesh: &DrawnMesh<'_>| {
            let found = mesh
                .uncertainty
                .models()
                .find(|other| other.name == row.name)?;
            Some(found.loss_w.map(|loss| f64::from(mesh.count) * loss))
        };
        // A model that a mesh does not have is not a model of the train.
        let sum = |meshes: &[DrawnMesh<'_>]| {
            let losses = meshes.iter().map(of_mesh).collect::<Option<Vec<_>>>()?;
            Some(losses.into_iter().sum::<Option<f64>>())
        };
        let (own, theirs) = (sum(first)?, sum(other)?);
        Some(AlternativeRow {
            loss_w: own.zip(theirs).map(|(a, b)| b - a),
            ..row.clone()
        })
    };
    let models = first
        .first()
        .into_iter()
        .flat_map(|mesh| mesh.uncertainty.models());
    let models: Vec<AlternativeRow> = models.filter_map(of_model).collect();
    let at_medians =
        |meshes: &[DrawnMesh<'_>]| -> f64 { meshes.iter().map(DrawnMesh::at_medians_w).sum() };
    let pair = first.first().zip(other.first());
    let common = pair.map_or(Vec::new(), |(a, b)| {
        common_constants(a.drawn(), b.drawn(), [&a.common, &b.common])
    });
    PairedDifference {
        at_medians_w: at_medians(other) - at_medians(first),
        watts,
        share: median_with_ends(&shares),
        probability,
        verdict: Verdict::new(watts, probability, &models),
        models,
        common,
    }
}
