//! Interval of a loss as a measurement that has not been made would leave it.
//!
//! The draws of the case are narrowed about their medians by what the measurement leaves of its own quantity; all other
//! parts are drawn as before.

use asperity_core::Estimate;
use std::cell::OnceCell;
use std::collections::BTreeMap;

use asperity_core::cite;
use asperity_core::numerics::standard_normal_quantile;

use crate::draw::Draw;
use crate::predictive::{FilmLaw, Predictive};
use crate::quantiles::{PROBABILITIES, Quantiles};
use crate::sampling_error::SamplingError;
use asperity_case::case::UncertainParameter;
use asperity_case::case::law_error;

/// Simulated results of a measurement of losses.
const TRUTHS: usize = 64;

/// A measurement with what it leaves of the uncertainty of its quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Measurement {
    /// Constants of the film friction.
    FilmFriction {
        /// Standard deviation of ln loss by their errors.
        deviation: f64,
        /// Change of ln loss by one standard deviation (0.10) of the pressure-viscosity coefficient in the friction only.
        slope: f64,
    },
    /// Boundary friction μ_b.
    BoundaryFriction {
        /// Standard deviation of its logarithm.
        deviation: f64,
    },
    /// Temperature of the oil or of the flanks.
    Temperature {
        /// Its standard deviation \[K\].
        deviation: f64,
    },
    /// Lay of both flanks.
    Lay,
    /// Tip relief of both gears.
    TipRelief,
    /// Traces of further teeth.
    Traces {
        /// Ratio of their number to the traces of the case.
        times: f64,
    },
    /// Traces of flanks that are known by roughness values.
    MeasuredFlanks,
    /// Losses of other flanks with stated tip relief, on a rig.
    Losses {
        /// Standard deviation of the logarithm of their mean.
        deviation: f64,
    },
}

/// Draws of a mesh, the number of its equal meshes, and the number of its flanks: equal flanks have the same errors of model
/// and sampling.
pub type MeshDraws<'a> = (&'a Predictive, u32, usize);

/// Expected intervals of the loss of all meshes after measurements.
pub struct Expected<'a> {
    meshes: &'a [MeshDraws<'a>],
    /// Draws from which all measurements of losses start.
    shared: OnceCell<SharedLosses>,
}

impl<'a> Expected<'a> {
    /// Of `meshes`.
    #[must_use]
    pub fn new(meshes: &'a [MeshDraws<'a>]) -> Self {
        Self {
            meshes,
            shared: OnceCell::new(),
        }
    }

    /// Median, interval and spread of the loss of all meshes as a measurement is expected to leave them, with what it leaves of
    /// each mesh; `None` if its quantity is drawn in no mesh: it is stated, measured already, or without effect. Constants of the
    /// oil and the boundary layer are drawn once for all meshes.
    #[must_use]
    pub fn after(&self, measurements: &[Option<Measurement>]) -> Option<Quantiles> {
        let of_losses = measurements.iter().flatten().find_map(|known| match known {
            Measurement::Losses { deviation } => Some(*deviation),
            _ => None,
        });
        if let Some(deviation) = of_losses {
            let shared = self.shared.get_or_init(|| SharedLosses::new(self.meshes));
            return Some(shared.after(deviation));
        }
        let mut is_known = false;
        let found = total(self.meshes, |k, predictive, flanks| {
            let after = measurements.get(k).copied().flatten();
            let after = after.and_then(|measurement| predictive.losses_after(measurement, flanks));
            is_known |= after.is_some();
            after.unwrap_or_else(|| predictive.losses(flanks))
        });
        is_known.then(|| Quantiles::from_draws(&found))
    }
}

/// Sum of the losses `of` all meshes, by the number of the mesh, its draws and its flanks.
fn total(
    meshes: &[MeshDraws<'_>],
    mut of: impl FnMut(usize, &Predictive, usize) -> Vec<f64>,
) -> Vec<f64> {
    let mut total = vec![0.0; Predictive::count()];
    for (k, (predictive, count, flanks)) in meshes.iter().enumerate() {
        for (total, loss) in total.iter_mut().zip(of(k, predictive, *flanks)) {
            *total += f64::from(*count) * loss;
        }
    }
    total
}

/// Draws of the loss, and of its part that the losses of other flanks determine.
struct SharedLosses {
    /// ln of the losses of all draws, from the smallest on.
    own: Vec<f64>,
    /// ln of the losses of the same draws by what all flanks share.
    shared: Vec<f64>,
    /// The latter from the smallest on.
    truths: Vec<f64>,
    /// Median of the losses \[W\].
    median_w: f64,
    /// Standard deviation of their logarithm by the errors of the model.
    model_error: f64,
}

impl SharedLosses {
    fn new(meshes: &[MeshDraws<'_>]) -> Self {
        let shared_w = total(meshes, |_, predictive, _| {
            predictive.losses_by(0, &|draw| {
                hold_relief(draw);
                draw.of_flanks = Draw::medians().of_flanks;
            })
        });
        let drawn_w = total(meshes, |_, predictive, flanks| predictive.losses(flanks));
        let median_w = Quantiles::from_draws(&drawn_w).drawn.value;
        let mut pairs: Vec<[f64; 2]> = (drawn_w.into_iter().zip(shared_w))
            .map(|(own, shared)| [own.ln(), shared.ln()])
            .collect();
        pairs.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let [own, shared] = [0, 1].map(|k| pairs.iter().map(|pair| pair[k]).collect::<Vec<_>>());
        let mut truths = shared.clone();
        truths.sort_unstable_by(f64::total_cmp);
        Self {
            own,
            shared,
            truths,
            median_w,
            model_error: model_error(meshes),
        }
    }

    /// The mean interval after losses with this error were measured on other flanks, over simulated results.
    ///
    /// ```text
    /// w_j ∝ exp(−(ln P_j' − y)²/2s²),  s² = s_m² + s_e²                                   [Expected-losses]
    /// ```
    ///
    /// P_j': loss of a draw with the constants, structure, weight of the bias and rolling loss that all flanks share, at the
    /// medians of the rest; y: the simulated result; s_m, s_e: errors of the measurement and of the model. Errors of the model
    /// of different flanks are independent.
    fn after(&self, deviation: f64) -> Quantiles {
        cite!("Expected-losses");
        let error = deviation.hypot(self.model_error);
        let mut sums = [0.0; 3];
        for k in 0..TRUTHS {
            let place = |k: usize| (k as f64 + 0.5) / TRUTHS as f64;
            // Errors in another order than the truths.
            let noise = error * standard_normal_quantile(place((29 * k + 7) % TRUTHS));
            let result = self.truths[(place(k) * self.truths.len() as f64) as usize] + noise;
            let weight = |shared: &f64| (-0.5 * ((shared - result) / error).powi(2)).exp();
            let weights: Vec<f64> = self.shared.iter().map(weight).collect();
            let ([low, median, high], variance) = weighted(&self.own, &weights);
            sums[0] += low - median;
            sums[1] += high - median;
            sums[2] += variance;
        }
        let [low, high, variance] = sums.map(|sum| sum / TRUTHS as f64);
        Quantiles {
            drawn: Estimate::new(
                self.median_w,
                [low, high].map(|end| self.median_w * end.exp()),
            ),
            sd_ln: variance.sqrt(),
        }
    }
}

/// Standard deviation of ln of the loss of all meshes by the errors of the model, which equal flanks share.
fn model_error(meshes: &[MeshDraws<'_>]) -> f64 {
    let loss = |(predictive, count, _): &MeshDraws<'_>| f64::from(*count) * predictive.at_medians_w;
    let all: f64 = meshes.iter().map(loss).sum();
    let mut of_flanks: BTreeMap<usize, f64> = BTreeMap::new();
    for mesh in meshes {
        *of_flanks.entry(mesh.2).or_default() += loss(mesh) / all * mesh.0.model_error();
    }
    of_flanks.into_values().fold(0.0, f64::hypot)
}

impl Predictive {
    /// The losses of all draws \[W\], as of flanks number `flanks`, as `measurement` is expected to leave them; `None` if its
    /// quantity is not drawn.
    ///
    /// Constants, relief and lay are narrowed about their medians. Traction curves determine the pressure-viscosity coefficient
    /// of the friction and not the one of the film thickness: a normal error of ln of the sliding loss replaces the draws of
    /// Eyring stress, limiting shear stress and α:
    ///
    /// ```text
    /// s² = s_c² + (a − f)² + 0.02²                                               [Expected-film-friction]
    /// ```
    ///
    /// s_c, f: standard deviation by the constants and slope over α in the friction, both of ln of the sliding loss; a: slope over
    /// α in film and friction; 0.02 the error of the law.
    fn losses_after(&self, measurement: Measurement, flanks: usize) -> Option<Vec<f64>> {
        use UncertainParameter as P;
        let mut left = self.clone();
        let narrowed = |scales: [f64; UncertainParameter::ALL.len()], left: &Self| {
            left.losses_by(flanks, &|draw| {
                for (z, scale) in draw.constants.iter_mut().zip(scales) {
                    *z *= scale;
                }
            })
        };
        let scaled = |kinds: &[P], scale: f64| {
            std::array::from_fn(|k| {
                if kinds.contains(&UncertainParameter::ALL[k]) {
                    scale
                } else {
                    1.0
                }
            })
        };
        match measurement {
            Measurement::FilmFriction { deviation, slope } => {
                cite!("Expected-film-friction");
                const CONSTANTS: [P; 3] = [P::EyringStress, P::LimitingShear, P::PressureViscosity];
                let [sliding, rolling, _] = self.parts_w;
                let mut own = self.constants.iter();
                let is_measured =
                    own.any(|one| CONSTANTS.contains(&one.kind) && one.measured.is_some());
                let is_drawn = CONSTANTS.iter().any(|kind| self.draws(*kind));
                if self.film_law.is_some() || is_measured || !is_drawn {
                    return None;
                }
                let of_sliding = (sliding + rolling) / sliding;
                let of_film = if self.draws(P::PressureViscosity) {
                    self.slope(P::PressureViscosity) - of_sliding * slope
                } else {
                    0.0
                };
                let of_constants = of_sliding * deviation;
                left.film_law = Some(FilmLaw {
                    share: 1.0,
                    deviation: of_constants.hypot(of_film).hypot(law_error(0.0)),
                });
                Some(narrowed(scaled(&CONSTANTS, 0.0), &left))
            }
            Measurement::BoundaryFriction { deviation } => {
                let own = self.spread(P::BoundaryFriction)?;
                let scale = (deviation / own).min(1.0);
                Some(narrowed(scaled(&[P::BoundaryFriction], scale), &left))
            }
            Measurement::Temperature { deviation } => {
                let mut own = self.constants.iter();
                let own = own
                    .find(|constant| constant.kind == P::TemperatureError)?
                    .at(1.0);
                let scale = (deviation / own).min(1.0);
                Some(narrowed(scaled(&[P::TemperatureError], scale), &left))
            }
            Measurement::Lay => self
                .draws(P::Lay)
                .then(|| narrowed(scaled(&[P::Lay], 0.0), &left)),
            Measurement::TipRelief => {
                self.relief.as_ref()?;
                Some(self.losses_by(flanks, &hold_relief))
            }
            Measurement::Traces { times } => {
                let known = self.sampling.standard_error > 0.0 && self.sampling.form == 0.0;
                left.sampling.standard_error /= times.sqrt();
                left.sampling.freedom *= times;
                known.then(|| left.losses(flanks))
            }
            Measurement::MeasuredFlanks => {
                left.sampling = SamplingError::NONE;
                (self.sampling.form > 0.0).then(|| left.losses(flanks))
            }
            Measurement::Losses { .. } => None,
        }
    }

    /// Whether a constant is drawn from its family.
    pub fn draws(&self, kind: UncertainParameter) -> bool {
        let mut own = self.constants.iter();
        own.any(|constant| constant.kind == kind && constant.measured.is_none())
    }

    /// Standard deviation of ln of a constant that is drawn from its family.
    fn spread(&self, kind: UncertainParameter) -> Option<f64> {
        let mut own = self.constants.iter();
        let own = own.find(|constant| constant.kind == kind && constant.measured.is_none())?;
        Some((own.at(1.0) / own.at(-1.0)).ln() / 2.0)
    }

    /// Change of ln of the sliding loss by a standard deviation of a constant.
    fn slope(&self, kind: UncertainParameter) -> f64 {
        let at = |z: f64| {
            let place =
                |constant: &crate::parameters::Ranged| if constant.kind == kind { z } else { 0.0 };
            let z: Vec<f64> = self.constants.iter().map(place).collect();
            self.sliding.as_ref().map_or(0.0, |surface| surface.at(&z))
        };
        0.5 * (at(1.0) - at(-1.0))
    }
}

fn hold_relief(draw: &mut Draw) {
    let medians = Draw::medians();
    (draw.relief, draw.length, draw.power) = (medians.relief, medians.length, medians.power);
}

/// 5 %, 50 % and 95 %, and the variance, of weighted values from the smallest on.
fn weighted(values: &[f64], weights: &[f64]) -> ([f64; 3], f64) {
    let total: f64 = weights.iter().sum();
    let both = || values.iter().zip(weights);
    let mean = both().map(|(value, weight)| weight * value).sum::<f64>() / total;
    let squares = both().map(|(value, weight)| weight * (value - mean).powi(2));
    let variance = squares.sum::<f64>() / total;
    let (mut below, mut quantiles) = (0.0, [f64::NAN; 3]);
    let mut open = quantiles.iter_mut().zip(PROBABILITIES).peekable();
    for (value, weight) in both() {
        below += weight;
        while let Some((quantile, _)) = open.next_if(|(_, share)| below >= share * total) {
            *quantile = *value;
        }
    }
    (quantiles, variance)
}
