//! Predictive draws of the loss of one case.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P_j | loss of draw j | W |
//! | S | sliding loss at the constants θ of the draw | W |
//! | β_i | least boundary share of spots that form inside the contact, 0.6 to 0.9 | - |
//! | F | ratio of the loss factors with the drawn tip relief and in the run | - |
//! | γ | power of F, 1.15 ± 0.08 (standard deviation) | - |
//! | Q | rolling loss | W |
//! | φ | share of the load on the asperities, weighted with the sliding loss | - |
//! | s | roughness σ_d that the contact leaves over the film, weighted with the sliding loss | - |
//! | g | ln of the ratio of the losses by the model and by reference solutions, at its mean; of records, by their short waves | - |
//! | ρ | sliding loss by reference solutions with the whole boundary friction on thin films, over the sliding loss of the run | - |
//! | SE, ν | standard error of ln P by the sampling of the flanks, its degrees of freedom | - |
//!
//! The draws are the same for every case. All flanks share the constants, β_i, the tip relief and the rolling
//! loss of a draw; model error and sampling differ from flanks to other flanks.

use asperity_core::cite;
use asperity_core::numerics::interpolate;
use asperity_core::quantity::Pressure;
use asperity_ehl_regime::{FULL_FILM, GapLaw};
use asperity_tribo_friction::boundary::INNER_BOUNDARY_RANGE;
use serde::{Deserialize, Serialize};

use crate::draw::{Common, DRAWS, Draw, flank_draws, shared_draws};
use crate::hypercube::StudentOfNormal;
use crate::parameters::Ranged;
use crate::quantiles::{ENDS, Quantiles, sorted_quantiles};
use crate::relief::ReliefFactors;
use crate::sampling_error::SamplingError;
use crate::surface::QuadraticSurface;
use asperity_case::case::UncertainParameter;

/// Mean and standard deviation of the power of the ratio of loss factors.
const RELIEF_POWER: [f64; 2] = [1.15, 0.08];
/// Standard deviation of ln of the model over records: of films without load on asperities, assumed with 93 reference solutions known, and
/// from [`FULL_FILM`] up to [`COMPARED`], fitted by likelihood to 85 of them in the windows that they pass.
const FILM_ERROR: f64 = 0.03;
const MIXED_ERROR: f64 = 0.05;
/// Roughness that the contact leaves over the film up to which reference solutions are a reference.
pub const COMPARED: f64 = 3.0;
/// That from which nothing is, with the standard deviation there.
const UNKNOWN: (f64, f64) = (4.0, 0.15);
/// Standard deviation of ln friction of a reference solution, besides its travel: its standard error and grid in 93 records.
const RECORD_ERROR: f64 = 0.03;
/// ln friction of records solved again with waves down to 2.5 µm over that with their 8 µm: mean and standard deviation. Ten records
/// rose by 0.024 ± 0.036, without one near the pitch point, where little is lost, by 0.014 ± 0.015.
const SHORT_WAVES: [f64; 2] = [0.02, 0.02];
/// Largest Hertz pressure below which light load adds an error \[Pa\], its standard deviation over ln of that pressure over the
/// contact's between rough flanks, and the roughness over the film at which it is half of this: the first chosen with 55 records, the
/// others fitted to 59 by likelihood.
const LIGHT_BELOW: f64 = 0.8e9;
const LIGHT_ERROR: f64 = 0.18;
const LIGHT_ROUGHNESS: f64 = 0.2;

/// The ingredients of the draws of one case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Predictive {
    /// Loss of the run, with every constant at its median \[W\].
    pub at_medians_w: f64,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// Its sliding, rolling and other losses \[W\].
    pub parts_w: [f64; 3],
    /// Constants that are drawn.
    pub constants: Vec<Ranged>,
    /// Rows of the lower triangle of the correlations of the measured constants, in their order.
    pub correlations: Vec<Vec<f64>>,
    /// ln of the sliding loss relative to the medians; `None` if nothing is drawn.
    pub sliding: Option<QuadraticSurface>,
    /// ln of the rolling loss relative to the medians, where the temperature is drawn, on which it depends most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rolling: Option<QuadraticSurface>,
    /// φ less that at the medians.
    pub share: Option<QuadraticSurface>,
    /// Root mean square error of the first surface at points that it was not fitted to.
    pub surface_rms: f64,
    /// φ at the medians.
    pub asperity_share: f64,
    /// Film friction whose constants traction curves state; `None` without them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film_law: Option<FilmLaw>,
    /// The other law of pressure, where traction curves do not decide between two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_law: Option<OtherLaw>,
    /// The loss over β_i; `None` if no spot depends on it, or the case states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inner_boundary: Option<InnerBoundary>,
    /// Sliding loss at the largest lay that is confirmed, over that at the lay of the case; `None` of a lay among the records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub far_lay: Option<f64>,
    /// Sliding and rolling loss with the thermal reduction as printed, over those with its held steepness; `None` where nothing is
    /// held.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_thermal: Option<[f64; 2]>,
    /// The loss by other gaps than the computed flow of patches supplies; `None` of lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub patch_flow: Option<PatchFlowError>,
    /// Rules of the boundary friction of reference solutions, where these give the friction: instead of β_i, and with the
    /// error of the reference solutions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recorded: Option<RecordedRule>,
    /// Loss factors over tip reliefs; `None` if the case states its relief.
    pub relief: Option<ReliefFactors>,
    /// Law of the gap that the inlet supplies.
    pub gap_law: GapLaw,
    /// s; `None` if it is not known.
    pub roughness_over_film: Option<f64>,
    /// Largest Hertz pressure, weighted with the sliding loss \[Pa\]; `None` if it is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_pressure_pa: Option<f64>,
    /// Film weighted with the sliding loss \[m\].
    pub film_m: f64,
    /// Error by the sampling of the flanks.
    pub sampling: SamplingError,
    /// Loss at each offset with every constant at its median \[W\].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub by_offset_w: Vec<f64>,
}

/// ln of the sliding loss over the one at the middle of β_i, a parabola.
///
/// ```text
/// ln S(β_i)/S = a x + b x²,  x = (2 β_i − 0.6 − 0.9)/(0.9 − 0.6)                     [Inner-boundary-draw]
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InnerBoundary {
    /// a: constant, and slopes over the standardised boundary friction and boundary layer.
    pub slope: [f64; 3],
    /// b: the same.
    pub bend: [f64; 3],
    /// Slope and bend of the friction of the boundary layer, over that at the middle.
    pub boundary: [f64; 2],
}

impl InnerBoundary {
    /// β_i of a place in its range, 0 to 1.
    #[must_use]
    pub fn value(place: f64) -> f64 {
        let [low, high] = INNER_BOUNDARY_RANGE;
        low + place * (high - low)
    }

    /// Friction of the boundary layer at a place in the range of β_i, over that at the middle, at the medians.
    #[must_use]
    pub fn boundary_at(&self, place: f64) -> f64 {
        let [slope, bend] = self.boundary;
        let x = 2.0 * place - 1.0;
        1.0 + x * (slope + x * bend)
    }
}

/// Boundary friction of reference solutions by either of two rules.
///
/// ```text
/// 2 S/(1 + ρ) or 2 ρ S/(1 + ρ), each in half of the draws                             [Record-rule-draw]
/// ```
///
/// S: sliding loss of the run, the mean of both rules. The boundary friction of a record falls with the film from the solid film on, or
/// is whole below 20 nm: the records do not say which.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RecordedRule {
    /// ρ at the medians: sliding loss by the second rule over that by the first.
    pub stepped: f64,
}

impl RecordedRule {
    /// Factor on the sliding loss of a draw at a place of 0 to 1; the middle is the run.
    fn factor(self, place: f64) -> f64 {
        cite!("Record-rule-draw");
        let of_rule = match place {
            place if place > 0.5 => self.stepped,
            place if place < 0.5 => 1.0,
            _ => 0.5 * (1.0 + self.stepped),
        };
        of_rule / (0.5 * (1.0 + self.stepped))
    }
}

/// Standard deviation of ln of the gap that the computed flow supplies to patches: 0.02 by the wavelengths at which waves are flattened
/// alike, which are known to 12 to 16 %, 0.04 from one sample of isotropic heights to another, and 0.043, the root mean square by which
/// it lies below the gap with Patir and Cheng's factors for isotropic heights of 1 to 3 smooth gaps (docs/model/film.md).
pub const PATCH_GAP_ERROR: f64 = 0.06;

/// Sliding loss of patches with other gaps, over that with the gap that their computed flow supplies.
///
/// ```text
/// w_1^z (1 + u k (L − 1)),  k = (1/3 − γ)/(1/3 − 1/6), 0 ≤ k ≤ 1,  0 ≤ u ≤ 1            [Patch-flow-draw]
/// ```
///
/// w_1, L: by a gap of one standard deviation more, and by the second order in the roughness over the gap, which lines have; γ: lay; z, u:
/// standard normal and even draws. The second order is confirmed up to γ = 1/6, where it supplies a wider gap than the flow through
/// patches; between them every value is as likely as another. At γ = 1/3 the flow agrees with published factors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PatchFlowError {
    /// w_1.
    pub wider: f64,
    /// k (L − 1).
    pub by_lines: f64,
}

impl PatchFlowError {
    fn factor(self, draw: &Draw) -> f64 {
        cite!("Patch-flow-draw");
        self.wider.powf(draw.patch_gap) * (1.0 + draw.patch_law * self.by_lines)
    }
}

/// Error of the law of film friction whose constants traction curves state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FilmLaw {
    /// Share of the film friction in the sliding loss.
    pub share: f64,
    /// Standard deviation of ln of the film friction.
    pub deviation: f64,
}

/// The sliding loss by another law of pressure that traction curves admit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OtherLaw {
    /// Its probability.
    pub probability: f64,
    /// Rows of the lower triangle of the correlations of its constants.
    pub correlations: Vec<Vec<f64>>,
    /// ln of its sliding loss over the one of the run, both at their medians.
    pub shift: f64,
    /// ln of its sliding loss relative to its medians.
    pub sliding: QuadraticSurface,
}

impl FilmLaw {
    /// Factor on the sliding loss where the film friction is in error by `z` standard deviations.
    ///
    /// ```text
    /// 1 + κ (exp(s z) − 1)                                                        [Film-law-draw]
    /// ```
    ///
    /// κ is the share of the film friction in the sliding loss, s its standard deviation.
    fn factor(&self, z: f64) -> f64 {
        cite!("Film-law-draw");
        1.0 + self.share * ((self.deviation * z).exp() - 1.0)
    }
}

/// A component of the uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// A constant, by its place among those drawn.
    Constant(usize),
    /// All constants together, with the law and its error that traction curves leave.
    Constants,
    /// Sampling of the flanks.
    Sampling,
    /// Tip relief that is not stated.
    Relief,
    /// Error of the model.
    Model,
    /// β_i, or the rule of the boundary friction in records.
    InnerBoundary,
    /// Lay above 1/3.
    FarLay,
    /// Thermal reduction beyond its fit.
    HeldThermal,
    /// Gap that the computed flow supplies to patches.
    PatchFlow,
    /// Rolling loss.
    Rolling,
    /// Error of the law of film friction.
    FilmLaw,
    /// Law of pressure where traction curves do not decide it.
    PressureLaw,
}

impl Component {
    /// All besides the constants.
    const FACTORS: [Self; 10] = [
        Self::Sampling,
        Self::Relief,
        Self::Model,
        Self::InnerBoundary,
        Self::FarLay,
        Self::HeldThermal,
        Self::PatchFlow,
        Self::FilmLaw,
        Self::PressureLaw,
        Self::Rolling,
    ];

    /// The components of a case.
    pub fn all(of: &Predictive) -> impl Iterator<Item = Self> {
        let constants = 0..of.constants.len();
        constants.map(Self::Constant).chain(Self::FACTORS)
    }

    /// Its name in words.
    #[must_use]
    pub fn name(self, of: &Predictive) -> &'static str {
        let is_recorded = of.recorded.is_some();
        match self {
            Self::Constant(k) => of.constants[k].kind.name(),
            Self::Constants => "all constants",
            Self::Sampling => "sampling of the flanks",
            Self::Relief => "tip relief not stated",
            Self::Model if is_recorded => "error of the reference solutions",
            Self::Model => "error of the model",
            Self::InnerBoundary if is_recorded => "boundary friction below 20 nm",
            Self::InnerBoundary => "boundary share of inner contacts",
            Self::FarLay => "lay above 1/3",
            Self::HeldThermal => "thermal reduction beyond its fit",
            Self::PatchFlow => "flow over the patch",
            Self::Rolling => "rolling loss",
            Self::FilmLaw => "error of the film law",
            Self::PressureLaw => "law of pressure of the film",
        }
    }

    /// Copies what is drawn of it.
    fn copy(self, constants: &[Ranged], from: &Draw, to: &mut Draw) {
        match self {
            Self::Constant(k) => {
                let axis = constants[k].kind as usize;
                to.constants[axis] = from.constants[axis];
            }
            Self::Constants => {
                to.constants = from.constants;
                (to.film_law, to.pressure_law) = (from.film_law, from.pressure_law);
            }
            Self::Sampling => {
                to.of_flanks.sampling = from.of_flanks.sampling;
                to.of_flanks.form = from.of_flanks.form;
                to.of_flanks.place = from.of_flanks.place;
            }
            Self::Relief => {
                (to.relief, to.length, to.power) = (from.relief, from.length, from.power);
            }
            Self::Model => {
                to.weight = from.weight;
                to.of_flanks.model = from.of_flanks.model;
            }
            Self::InnerBoundary => to.inner_boundary = from.inner_boundary,
            Self::FarLay => to.far_lay = from.far_lay,
            Self::HeldThermal => to.held_thermal = from.held_thermal,
            Self::PatchFlow => (to.patch_gap, to.patch_law) = (from.patch_gap, from.patch_law),
            Self::Rolling => to.rolling = from.rolling,
            Self::FilmLaw => to.film_law = from.film_law,
            Self::PressureLaw => to.pressure_law = from.pressure_law,
        }
    }
}

impl Predictive {
    /// The losses of a quarter of the draws as of [`losses`](Self::losses), with these components at their medians.
    pub fn losses_holding(&self, common: impl Into<Common>, held: &[Component]) -> Vec<f64> {
        /// A fourth of the draws is enough for the width of an interval over another one.
        const EVERY: usize = 4;
        let (medians, law) = (Draw::medians(), self.law());
        let drawn = common.into().draws().step_by(EVERY).map(|mut draw| {
            for component in held {
                component.copy(&self.constants, &medians, &mut draw);
            }
            law.loss(&draw)
        });
        drawn.collect()
    }

    /// The losses of all draws \[W\].
    ///
    /// ```text
    /// P_j = S(θ_j, β_i,j) F(c_j, l_j)^γ exp(−w_j g + e_j) + Q exp(q n_j),  ln P_j += SE t_ν,j   [Predictive-draw]
    /// ```
    ///
    /// A draw above the power P_in into the mesh is set to it, and a draw below P₀²/P_in, as far below the loss P₀ at the medians,
    /// to that: Student's t of few traces has tails in which no loss is left.
    #[must_use]
    pub fn draws_w(&self) -> Vec<f64> {
        self.losses(0)
    }

    /// The losses of all draws of a mesh with these draws in common with others, by default of the flanks with a number.
    pub fn losses(&self, common: impl Into<Common>) -> Vec<f64> {
        self.losses_by(common, &|_| {})
    }

    /// The losses of all draws as of [`losses`](Self::losses), with every draw changed by `change`.
    pub fn losses_by(&self, common: impl Into<Common>, change: &dyn Fn(&mut Draw)) -> Vec<f64> {
        cite!("Predictive-draw");
        let law = self.law();
        let drawn = common.into().draws().map(|mut draw| {
            change(&mut draw);
            law.loss(&draw)
        });
        drawn.collect()
    }

    /// The losses of all draws \[W\] as parts of a sum, as over a cycle: as of [`losses`](Self::losses), with the
    /// standard error of the sampling times `sampling`.
    #[must_use]
    pub fn draws_of_sum_w(&self, common: impl Into<Common>, sampling: f64) -> Vec<f64> {
        let mut scaled = self.clone();
        scaled.sampling.standard_error *= sampling;
        scaled.losses(common)
    }

    /// Adds `count` times the losses of all draws, as of [`losses`](Self::losses), to `total` \[W\].
    pub fn add_draws(&self, total: &mut [f64], count: f64, common: impl Into<Common>) {
        for (total, loss) in total.iter_mut().zip(self.losses(common)) {
            *total += count * loss;
        }
    }

    /// Median, quantiles and spread of the draws.
    #[must_use]
    pub fn quantiles(&self) -> Quantiles {
        Quantiles::from_draws(&self.draws_w())
    }

    /// The same without the scatter and the form of surrogate flanks, as by traces with the same mean; none unless the
    /// flanks are surrogates.
    pub fn with_traces(&self) -> Option<Quantiles> {
        let measured = Self {
            sampling: SamplingError::NONE,
            ..self.clone()
        };
        (self.sampling.form > 0.0).then(|| measured.quantiles())
    }

    /// Standard deviation of ln loss with only the constants of film and boundary layer drawn, all together.
    #[must_use]
    pub fn sd_of_constants(&self) -> f64 {
        self.alone(Component::Constants)
            .map_or(0.0, |found| found.sd_ln)
    }

    /// Median, quantiles and spread with only `component` drawn; `None` if it changes nothing.
    pub fn alone(&self, component: Component) -> Option<Quantiles> {
        self.law().alone(component)
    }

    /// Loss at the medians with β_i at a place in its range, or by one of the rules of records, 0 to 1 \[W\]; `None` if neither is
    /// drawn.
    pub fn at_inner_boundary(&self, place: f64) -> Option<f64> {
        if self.inner_boundary.is_none() && self.recorded.is_none() {
            return None;
        }
        let draw = Draw {
            inner_boundary: place,
            ..Draw::medians()
        };
        Some(self.law().loss(&draw))
    }

    /// The loss at the largest lay that is confirmed, relative to the run; `None` of a lay among the records.
    pub fn at_confirmed_lay(&self) -> Option<f64> {
        self.far_lay?;
        let law = self.law();
        let draw = Draw {
            far_lay: 1.0,
            ..Draw::medians()
        };
        Some(law.loss(&draw) / law.loss(&Draw::medians()))
    }

    /// The loss without tip relief and with the largest, relative to the run; `None` if the relief is stated.
    pub fn at_ends_of_relief(&self) -> Option<[f64; 2]> {
        self.relief.as_ref()?;
        let law = self.law();
        let at = |relief: f64| {
            let draw = Draw {
                relief,
                ..Draw::medians()
            };
            law.loss(&draw)
        };
        Some([0.0, 1.0].map(|relief| at(relief) / at(0.5)))
    }

    /// The loss of one draw after another.
    pub fn law(&self) -> DrawnLoss<'_> {
        DrawnLoss {
            of: self,
            bias: self.model_deviation()[0],
            model_error: self.model_error(),
            rolling_error: self.rolling_error(),
            student: StudentOfNormal::new(self.sampling.freedom),
        }
    }

    /// Standardised constants of a draw, measured ones correlated; beyond the constants 0.
    pub fn standardised(
        &self,
        draw: &Draw,
        correlations: &[Vec<f64>],
    ) -> [f64; UncertainParameter::ALL.len()] {
        let mut z = [0.0; UncertainParameter::ALL.len()];
        for (z, constant) in z.iter_mut().zip(&self.constants) {
            *z = draw.constants[constant.kind as usize];
        }
        if correlations.is_empty() {
            return z;
        }
        let own = z;
        let of_measured = |(k, _): &(usize, &Ranged)| self.constants[*k].measured.is_some();
        let measured = || self.constants.iter().enumerate().filter(of_measured);
        for ((k, _), row) in measured().zip(correlations) {
            let own = measured().map(|(k, _)| own[k]);
            z[k] = row.iter().zip(own).map(|(l, z)| l * z).sum();
        }
        z
    }

    /// ln of the sliding loss over the one at the middle of β_i.
    fn by_inner_boundary(&self, draw: &Draw, z: &[f64]) -> f64 {
        let Some(InnerBoundary { slope, bend, .. }) = &self.inner_boundary else {
            return 0.0;
        };
        cite!("Inner-boundary-draw");
        let of = |kind| {
            let mut kinds = self.constants.iter();
            kinds
                .position(|constant| constant.kind == kind)
                .map_or(0.0, |k| z[k])
        };
        let (friction, layer) = (
            of(UncertainParameter::BoundaryFriction),
            of(UncertainParameter::BoundaryLayer),
        );
        let at = |[constant, by_friction, by_layer]: &[f64; 3]| {
            constant + by_friction * friction + by_layer * layer
        };
        let x = 2.0 * draw.inner_boundary - 1.0;
        x * (at(slope) + x * at(bend))
    }

    /// The sliding loss of a lay above 1/3 over the one at the lay of the case.
    ///
    /// ```text
    /// 1 + u (S(1/6)/S − 1),  0 ≤ u ≤ 1                                              [Far-lay-draw]
    /// ```
    ///
    /// Nothing judges the loss at such a lay: every value between that at the largest lay at which the contact of lines is
    /// confirmed and that at the lay of the case is as likely as another.
    fn by_far_lay(&self, draw: &Draw) -> f64 {
        let Some(confirmed) = self.far_lay else {
            return 1.0;
        };
        cite!("Far-lay-draw");
        1.0 + draw.far_lay * (confirmed - 1.0)
    }

    /// Sliding and rolling loss over those with the held steepness of the thermal reduction.
    ///
    /// ```text
    /// 1 + u (P_printed/P_held − 1),  0 ≤ u ≤ 1                                    [Held-thermal-draw]
    /// ```
    ///
    /// Neither the printed form, whose film thins as the oil thickens, nor the held one was measured there.
    fn by_held_thermal(&self, draw: &Draw) -> [f64; 2] {
        let Some(printed) = self.held_thermal else {
            return [1.0; 2];
        };
        cite!("Held-thermal-draw");
        printed.map(|ratio| 1.0 + draw.held_thermal * (ratio - 1.0))
    }

    /// Bias of the model, drawn with a weight of 0 to 1, and its standard deviation.
    fn model_deviation(&self) -> [f64; 2] {
        if self.recorded.is_some() {
            return record_deviation();
        }
        let s = self.roughness_over_film.unwrap_or(0.0);
        let pressure = self.max_pressure_pa.map(Pressure::from_si);
        model_deviation(self.gap_law, s, self.asperity_share, pressure)
    }

    /// Standard deviation of ln loss by the model and the surface.
    #[must_use]
    pub fn model_error(&self) -> f64 {
        let [_, error] = self.model_deviation();
        error.hypot(self.surface_rms)
    }

    /// q: standard deviation of ln Q, 0.12 up to a film of 0.5 um and 0.25 from 1 um.
    fn rolling_error(&self) -> f64 {
        let thick = ((self.film_m - 0.5e-6) / 0.5e-6).clamp(0.0, 1.0);
        0.12 + 0.13 * thick
    }

    /// The factor of each draw on the sliding loss at constants, relief and model error, for the rows of a path: without
    /// the constants' own part, which differs from position to position. `draws_w` are the losses of all draws.
    fn factors_of_sliding(&self, draws_w: &[f64]) -> Vec<(Vec<f64>, f64)> {
        let law = self.law();
        let [sliding, _, other] = self.parts_w;
        let draws = shared_draws().zip(draws_w);
        let factor = |(draw, loss): (Draw, &f64)| {
            let z = &self.standardised(&draw, &self.correlations)[..self.constants.len()];
            let sheared = sliding * self.sliding.as_ref().map_or(0.0, |s| s.at(z)).exp();
            let factor = ((loss - law.rolling(&draw, z) - other) / sheared).max(0.0);
            (z.to_vec(), factor)
        };
        draws.map(factor).collect()
    }

    /// 5 % and 95 % quantiles of the sliding loss of positions \[W/m\] over the draws with the losses `draws_w`. Each position
    /// has its loss in the run, and the surface of ln of its loss relative to the medians, 0 beyond the surfaces.
    #[must_use]
    pub fn quantiles_along_path(
        &self,
        draws_w: &[f64],
        sliding_w_per_m: &[f64],
        of_positions: &[QuadraticSurface],
    ) -> Vec<[f64; 2]> {
        let draws = self.factors_of_sliding(draws_w);
        let at = |(k, sliding): (usize, &f64)| {
            let ln = |z: &[f64]| of_positions.get(k).map_or(0.0, |surface| surface.at(z));
            let drawn = draws
                .iter()
                .map(|(z, factor)| sliding * factor * ln(z).exp());
            sorted_quantiles(&drawn.collect::<Vec<_>>(), ENDS)
        };
        sliding_w_per_m.iter().enumerate().map(at).collect()
    }

    /// A constant with its value in all draws; `None` if it is not drawn.
    #[must_use]
    pub fn drawn(&self, kind: UncertainParameter) -> Option<(Ranged, Vec<f64>)> {
        let k = self.constants.iter().position(|one| one.kind == kind)?;
        let constant = self.constants[k];
        let values =
            shared_draws().map(|draw| constant.at(self.standardised(&draw, &self.correlations)[k]));
        Some((constant, values.collect()))
    }

    /// Number of draws.
    #[must_use]
    pub const fn count() -> usize {
        DRAWS
    }
}

/// The loss of one draw after another, with what all draws share.
pub struct DrawnLoss<'a> {
    of: &'a Predictive,
    bias: f64,
    model_error: f64,
    rolling_error: f64,
    student: StudentOfNormal,
}

impl DrawnLoss<'_> {
    /// Median, quantiles and spread with only `component` drawn; `None` if it changes nothing.
    pub fn alone(&self, component: Component) -> Option<Quantiles> {
        let draws = shared_draws().zip(flank_draws(0));
        let drawn = draws.map(|(draw, of_flanks)| {
            let mut alone = Draw::medians();
            let draw = Draw { of_flanks, ..draw };
            component.copy(&self.of.constants, &draw, &mut alone);
            self.loss(&alone)
        });
        let found = Quantiles::from_draws(&drawn.collect::<Vec<_>>());
        (found.sd_ln > 1e-9).then_some(found)
    }

    /// The loss of a draw \[W\].
    pub fn loss(&self, draw: &Draw) -> f64 {
        let of = self.of;
        let [sliding, _, other] = of.parts_w;
        let standardised = |correlations| of.standardised(draw, correlations);
        let z = &standardised(&of.correlations)[..of.constants.len()];
        let at = |surface: &Option<QuadraticSurface>| surface.as_ref().map_or(0.0, |s| s.at(z));
        let law = of.other_law.as_ref();
        let mut sheared = match law.filter(|law| draw.pressure_law < law.probability) {
            Some(law) => {
                let own = law.sliding.at(&standardised(&law.correlations)[..z.len()]);
                sliding * (law.shift + own).exp()
            }
            None => sliding * at(&of.sliding).exp(),
        };
        sheared *= of.by_inner_boundary(draw, z).exp();
        sheared *= of
            .recorded
            .map_or(1.0, |rule| rule.factor(draw.inner_boundary));
        sheared *= of.by_far_lay(draw) * of.by_held_thermal(draw)[0];
        sheared *= of.patch_flow.map_or(1.0, |error| error.factor(draw));
        if let Some(law) = &of.film_law {
            sheared *= law.factor(draw.film_law);
        }
        let of_relief = of.relief.as_ref().map_or(1.0, |relief| {
            let power = RELIEF_POWER[0] + RELIEF_POWER[1] * draw.power;
            relief.ratio(draw.relief, draw.length).powf(power)
        });
        let of_model = (-draw.weight * self.bias + self.model_error * draw.of_flanks.model).exp();
        let rolling = self.rolling(draw, z);
        let of_sampling = of.sampling.standard_error * self.student.at(draw.of_flanks.sampling)
            + of.sampling.form * draw.of_flanks.form
            + of.sampling.shift(draw.of_flanks.place);
        let loss = (sheared * of_relief * of_model + rolling + other) * of_sampling.exp();
        let least = of.at_medians_w * (of.at_medians_w / of.power_in_w).min(1.0);
        loss.max(least).min(of.power_in_w)
    }

    /// Rolling loss of a draw \[W\].
    fn rolling(&self, draw: &Draw, z: &[f64]) -> f64 {
        let of_constants = self
            .of
            .rolling
            .as_ref()
            .map_or(0.0, |surface| surface.at(z));
        let [_, of_thermal] = self.of.by_held_thermal(draw);
        let of_error = (of_constants + self.rolling_error * draw.rolling).exp();
        self.of.parts_w[1] * of_thermal * of_error
    }
}

/// Correlation of the error of the model in two conditions on the same teeth.
///
/// ```text
/// ρ = 1/√(1 + d²),  d² = Σ (Δ ln x_i/ℓ_i)²                                                  [Model-common]
/// ```
///
/// x: film, roughness, largest Hertz pressure and friction, with ℓ = 0.8, 0.6, 0.11 and 0.15; values that are not known have no
/// distance. Friction stands for the shear of the oil. The lengths follow by likelihood from 108 reference solutions on six pairs of
/// traces in close conditions at full load, with the errors of their windows apart; 95 % of ℓ:
/// 0.55 to 1.17, 0.43 to 0.83, 0.07 to 0.17 and 0.11 to 0.19. Most of the error belongs to
/// the traces: at another place of the path it differs by 0.02.
#[must_use]
pub fn model_correlation(lengths: [f64; 4], a: [f64; 4], b: [f64; 4]) -> f64 {
    cite!("Model-common");
    let pairs = a.into_iter().zip(b).zip(lengths);
    let distances = pairs.map(|((a, b), length)| (a / b).ln() / length);
    let squares = distances.filter(|one| one.is_finite()).map(|one| one * one);
    (1.0 + squares.sum::<f64>()).sqrt().recip()
}

/// Lengths of ln film, roughness, pressure and friction over which the error of the model changes.
pub const MODEL_LENGTHS: [f64; 4] = [0.8, 0.6, 0.11, 0.15];

/// Bias g of ln of the losses by the model over those by reference solutions, and its standard deviation.
///
/// ```text
/// sd² = e² + l²,  e = 0.03 + min(φ, 0.02) up to s = 3, then a line to 0.15 at 4
/// l = 0.18 ln(0.8 GPa/p_H) s/(s + 0.2) for p_H < 0.8 GPa
/// gap law power: g = min(0.2, 0.16 max(0, s − 2)), e as below s = 3                           [Model-bias]
/// ```
///
/// s is the roughness that the contact leaves over the film, p_H its largest Hertz pressure. e was compared with 93 records with heat
/// at full load (`power`: 24 without); l was fitted to 59 at part load. The bias is drawn with a weight of 0 to 1, as the records
/// have errors of their own. Pressures above 0.8 GPa, or not known, add nothing.
///
/// ```
/// use asperity_core::quantity::Pressure;
/// use asperity_uncertainty::model_deviation;
/// use asperity_ehl_regime::GapLaw;
/// let of = |s, phi, gpa: f64| model_deviation(GapLaw::Inlet, s, phi, Some(Pressure::from_si(1e9 * gpa)));
/// let [bias, error] = of(2.0, 0.2, 1.1);
/// assert!(bias == 0.0 && (error - 0.05).abs() < 1e-15);
/// assert_eq!(of(1.0, 0.0, 1.1), [0.0, 0.03]);
/// // At .3 GPa the error of rough flanks is a sixth, of nearly smooth ones 7 %.
/// assert!((of(2.0, 0.2, 0.3)[1] - 0.1681).abs() < 1e-4 && (of(0.1, 0.0, 0.3)[1] - 0.066).abs() < 1e-4);
/// ```
#[must_use]
pub fn model_deviation(
    law: GapLaw,
    roughness_over_film: f64,
    asperity_share: f64,
    max_pressure: Option<Pressure>,
) -> [f64; 2] {
    cite!("Model-bias");
    let s = roughness_over_film;
    let bias = match law {
        GapLaw::Inlet => 0.0,
        GapLaw::Power => (0.16 * (s - 2.0).max(0.0)).min(0.2),
    };
    let compared = interpolate(
        &[(0.0, FILM_ERROR), (FULL_FILM, MIXED_ERROR)],
        asperity_share,
    );
    let error = match law {
        GapLaw::Inlet => interpolate(&[(COMPARED, compared), UNKNOWN], s),
        GapLaw::Power => compared,
    };
    let light = max_pressure.map_or(0.0, |pressure| {
        LIGHT_ERROR * (LIGHT_BELOW / pressure.si()).ln().max(0.0) / (1.0 + LIGHT_ROUGHNESS / s)
    });
    [bias, error.hypot(light)]
}

/// Bias of ln of the losses by reference solutions, and its standard deviation.
///
/// ```text
/// g = −0.04, w g uniform: mean −0.02 by waves below 8 µm;  sd² = 0.03² + 0.02² − 0.04²/12       [Record-bias]
/// ```
fn record_deviation() -> [f64; 2] {
    cite!("Record-bias");
    let [mean, deviation] = SHORT_WAVES;
    let uniform = 2.0 * mean / 12_f64.sqrt();
    let rest = (deviation * deviation - uniform * uniform).max(0.0);
    [-2.0 * mean, (RECORD_ERROR * RECORD_ERROR + rest).sqrt()]
}
