//! Evaluations of the losses of a case over its constants, which the draws interpolate.

use std::borrow::Cow;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::numerics::deviation;
use asperity_core::quantity::Length;

use crate::contacts::Contacts;
use crate::pipeline::{contacts, losses_at};
use crate::result::loss_band::WindowSampling;
use crate::result::{
    Losses, MeshOutcome, OffsetRow, OutsideInput, PairSampling, PositionRow, Summary,
};
use crate::sampling::{
    Independent, means_of_pairs, sampling_of_teeth, travel_sampling, wider_like_measured,
    window_sampling, windows_of_traces,
};
use asperity_case::case::{FullFilmName, LoadedCase, OperatingCase, ShareLaw, cholesky};
use asperity_case::error::{Error, PositionError};
use asperity_ehl_regime::GapLaw;
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_ehl_regime::thermal_reduction::GUPTA_HELD;
use asperity_mixed_film::{PatchGap, SpotSpeed};
use asperity_tribo_friction::boundary::INNER_BOUNDARY_RANGE;
use asperity_uncertainty::{
    FilmLaw, InnerBoundary, OtherLaw, PATCH_GAP_ERROR, PatchFlowError, Predictive,
    QuadraticSurface, Ranged, ReliefFactors, SamplingError, UncertainParameter, latin_hypercube,
    parameters,
};

/// Offsets of the evaluations: a ratio of losses needs fewer than a loss. With 8 instead of 16 the ends of the interval move by 1.5 W of
/// 920 on the shipped e-drive case and by at most 0.5 W of 411 on three other cases (29 November 2026). The surface through the
/// evaluations misses the ratio by 1.8 % on the first case, by at most 0.5 % on the others.
const OFFSETS: usize = 8;
/// Evaluations that the surface is not fitted to.
const HELD_OUT: usize = 4;
/// Evaluations over β_i: two at each of four places.
const INNER_BOUNDARY: usize = 8;
/// Evaluations of other gaps supplied to patches.
const OF_PATCHES: usize = 2;
/// Films for each constant that changes them, over which the evaluations are spread: the roughness that a film leaves costs as much as
/// its friction. Over four shipped cases and 64 places that it was not fitted to, the surface misses ln loss by 0.7 to 1.6 % with
/// three evaluations of a film and by 0.7 to 2.0 % with one (29 November 2026).
const FILMS: usize = 8;
/// Standard deviations that the evaluations reach to either side.
const REACH: f64 = 2.4;
/// Seed of their places.
const SEED: u64 = 1;
/// Difference of the seeds for the constants of a film and for the others: with the same seed both would have the same order.
const FILM_SEED: u64 = 100;

/// Whether a case has an uncertainty: its formulation may have none, and a solved full film takes seconds an evaluation.
#[must_use]
pub fn has_band(loaded: &LoadedCase) -> bool {
    let model = &loaded.case.model;
    let has_records = matches!(loaded.case.share_law(), ShareLaw::Reference);
    loaded.case.formulation.has_interval()
        && (!has_records || loaded.surfaces.are_measured())
        && model.full_film == FullFilmName::Formulas
}

/// Losses of the flanks of `loaded` as measured, with its stored contacts if there are any.
pub(super) fn evaluated(case: &OperatingCase, known: Option<&Contacts>) -> Result<Losses, Error> {
    let mut case = Cow::Borrowed(case);
    if case.running_in.is_some() {
        // No draw looks at the flanks run in.
        case = Cow::Owned(case.overridden(|over| over.as_measured = true)?);
    }
    match known {
        Some(contacts) => losses_at(contacts, &case),
        None => losses_at(&contacts(&case, &[])?, &case),
    }
}

/// The losses of a run at the medians.
#[derive(Clone, Copy)]
pub(super) struct Nominal<'a> {
    pub summary: &'a Summary,
    pub path: &'a [PositionRow],
    pub offsets: &'a [OffsetRow],
    pub pairs: Option<PairSampling>,
}

impl<'a> Nominal<'a> {
    pub fn from_losses(losses: &'a Losses) -> Self {
        Self {
            summary: &losses.summary,
            path: &losses.path,
            offsets: &losses.offsets,
            pairs: losses.pairs,
        }
    }

    pub(crate) fn of_outcome(outcome: &'a MeshOutcome) -> Self {
        let result = &outcome.result;
        Self {
            summary: &result.summary,
            path: &result.path,
            offsets: &outcome.offsets,
            pairs: result.pairs.as_ref().and_then(|pairs| pairs.sampling),
        }
    }
}

/// Contacts of a case, and the number of offsets that its evaluations have of them.
#[derive(Clone, Copy)]
pub(super) struct Windows<'a> {
    pub contacts: &'a Contacts,
    /// Of all pairs of traces together.
    pub offsets: usize,
}

impl<'a> Windows<'a> {
    /// As many as a ratio of losses needs.
    pub fn few(contacts: &'a Contacts) -> Self {
        Self {
            contacts,
            offsets: OFFSETS,
        }
    }
}

/// The draws of a case, and what only its own result shows of them.
pub(super) struct EvaluatedLosses {
    pub predictive: Predictive,
    /// ln of the sliding loss of each position over that at the medians.
    pub of_positions: Vec<QuadraticSurface>,
    pub held: Vec<String>,
    pub evaluations: usize,
}

/// Number of evaluations of a case.
pub(super) fn count(loaded: &OperatingCase) -> usize {
    let dimensions = parameters(loaded).map_or(0, |(drawn, _)| drawn.len());
    match dimensions {
        0 => 0,
        n => {
            let laws = if loaded.case.other_law().is_some() {
                2
            } else {
                1
            };
            laws * (1 + QuadraticSurface::evaluations(n))
                + HELD_OUT
                + if draws_inner_boundary(loaded) {
                    INNER_BOUNDARY
                } else {
                    0
                }
                + match (loaded.surfaces.sheets(), loaded.lay_beyond_records()) {
                    (Some(_), _) => OF_PATCHES,
                    (None, Ok(Some(_))) => 1,
                    (None, _) => 0,
                }
        }
    }
}

/// Evaluates a case whose losses follow from its contacts around `nominal`, its losses at the medians; `done` is called after each
/// evaluation.
pub(super) fn by_contacts(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    contacts: Windows<'_>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<EvaluatedLosses, Error> {
    let (constants, held) = parameters(loaded).map_err(whole)?;
    let Windows { contacts, offsets } = contacts;
    let base_case = few_offsets(loaded, offsets)?;
    let each = base_case.case.model.offsets;
    let few = if loaded.surfaces.is_surrogate() {
        contacts.of_first_pair(&base_case).first(each)
    } else {
        contacts.first(each)
    };
    let mut predictive = at_medians(loaded, nominal, constants)?;
    let mut of_positions = Vec::new();
    // Without sliding there is no ratio.
    if !predictive.constants.is_empty() && nominal.summary.sliding_w > 0.0 {
        let constants = predictive.constants.clone();
        let base = EvaluationBase {
            loaded: &base_case,
            constants: &constants,
            contacts: Windows {
                contacts: &few,
                offsets,
            },
            number: AtomicUsize::new(0),
            done,
        };
        of_positions = Fits::new(base)?.enter(loaded, &mut predictive)?;
    }
    Ok(EvaluatedLosses {
        predictive,
        of_positions,
        held,
        evaluations: count(loaded),
    })
}

fn whole(error: PositionError) -> Error {
    Error::Whole(Box::new(error))
}

/// The distribution of the loss of a run at the medians, in which nothing is evaluated yet.
fn at_medians(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    constants: Vec<Ranged>,
) -> Result<Predictive, Error> {
    let path = PathLosses::from_rows(nominal.path);
    let summary = nominal.summary;
    let others_w = summary.loss_w - summary.sliding_w - summary.rolling_w;
    Ok(Predictive {
        at_medians_w: summary.loss_w,
        power_in_w: summary.power_in_w,
        parts_w: [summary.sliding_w, summary.rolling_w, others_w],
        correlations: correlations(loaded, &constants),
        sliding: None,
        rolling: None,
        share: None,
        surface_rms: 0.0,
        asperity_share: path.asperity_share,
        film_law: film_law(loaded, summary),
        other_law: None,
        inner_boundary: None,
        recorded: None,
        far_lay: None,
        held_thermal: None,
        patch_flow: None,
        relief: ReliefFactors::from_case(&loaded.case).map_err(whole)?,
        gap_law: match loaded.case.share_law() {
            ShareLaw::Solved(contact) => contact.supply.gap_law(),
            _ => GapLaw::Inlet,
        },
        roughness_over_film: path.roughness_over_film,
        max_pressure_pa: path.max_pressure_pa,
        film_m: path.film_m,
        sampling: sampling_error(loaded, nominal, path.asperity_share)?,
        by_offset_w: nominal.offsets.iter().map(|row| row.loss_w).collect(),
        constants,
    })
}

/// The draws of a changed case with the losses `losses`, which change over the constants as in `before`.
pub(super) fn at_losses(
    changed: &OperatingCase,
    losses: &Losses,
    before: &Predictive,
) -> Result<Predictive, Error> {
    let found = at_medians(
        changed,
        &Nominal::from_losses(losses),
        before.constants.clone(),
    )?;
    Ok(Predictive {
        power_in_w: found.power_in_w,
        at_medians_w: found.at_medians_w,
        parts_w: found.parts_w,
        asperity_share: found.asperity_share,
        relief: found.relief,
        roughness_over_film: found.roughness_over_film,
        max_pressure_pa: found.max_pressure_pa,
        film_m: found.film_m,
        sampling: found.sampling,
        by_offset_w: found.by_offset_w,
        ..before.clone()
    })
}

/// Losses at other constants, to which surfaces are fitted.
struct Fits<'a> {
    base: EvaluationBase<'a>,
    /// Places of the constants, and the losses there.
    fitted: Vec<Vec<f64>>,
    found: Vec<Losses>,
    /// Losses at the medians.
    middle: Losses,
}

impl<'a> Fits<'a> {
    fn new(base: EvaluationBase<'a>) -> Result<Self, Error> {
        let dimensions = base.constants.len();
        let fitted = base.places(QuadraticSurface::evaluations(dimensions), SEED);
        let middle = base.at(&vec![0.0; dimensions], None)?;
        Ok(Self {
            found: base.all(&fitted, None)?,
            base,
            fitted,
            middle,
        })
    }

    /// Logarithm of the sliding loss over its value at the medians.
    fn ratio(&self, losses: &Losses) -> f64 {
        (losses.summary.sliding_w / self.middle.summary.sliding_w).ln()
    }

    fn fit(&self, of: &dyn Fn(&Losses) -> f64) -> Option<QuadraticSurface> {
        QuadraticSurface::fit(&self.fitted, &self.found.iter().map(of).collect::<Vec<_>>())
    }

    /// Puts surfaces and factors into `predictive`, and returns the surfaces of the positions.
    fn enter(
        &self,
        loaded: &OperatingCase,
        predictive: &mut Predictive,
    ) -> Result<Vec<QuadraticSurface>, Error> {
        let middle = &self.middle;
        let share = |losses: &Losses| {
            PathLosses::from_rows(&losses.path).asperity_share - path_share(middle)
        };
        predictive.sliding = self.fit(&|losses| self.ratio(losses));
        predictive.share = self.fit(&share);
        let temperature = UncertainParameter::TemperatureError;
        if predictive.draws(temperature) && middle.summary.rolling_w > 0.0 {
            let rolling = |losses: &Losses| losses.summary.rolling_w / middle.summary.rolling_w;
            predictive.rolling = self.fit(&|losses| rolling(losses).ln());
        }
        let of_position = |k: usize| {
            let of = |losses: &Losses| losses.path[k].sliding_w_per_m;
            let base = of(middle);
            self.fit(&|losses: &Losses| {
                if base > 0.0 {
                    (of(losses) / base).ln()
                } else {
                    0.0
                }
            })
        };
        let of_positions = (0..middle.path.len()).filter_map(of_position).collect();
        predictive.other_law = self.other_law(loaded)?;
        if let Some(surface) = predictive.sliding.clone() {
            predictive.surface_rms = self.error_of(&surface)?;
            self.enter_factors(loaded, &surface, predictive)?;
        }
        Ok(of_positions)
    }

    /// The surface by the other law of pressure that the curves of the oil file admit.
    fn other_law(&self, loaded: &OperatingCase) -> Result<Option<OtherLaw>, Error> {
        let Some(other) = other_law(loaded, self.base.contacts.offsets)? else {
            return Ok(None);
        };
        let (by_other, _) = parameters(&other.case).map_err(whole)?;
        let base = EvaluationBase {
            loaded: &other.case,
            constants: &by_other,
            contacts: self.base.contacts,
            number: AtomicUsize::new(self.base.number.load(Ordering::Relaxed)),
            done: self.base.done,
        };
        let found = base.all(&self.fitted, None)?;
        let at_medians = base.at(&vec![0.0; by_other.len()], None)?;
        let shift = self.ratio(&at_medians);
        let changes = found.iter().map(|losses| self.ratio(losses) - shift);
        let sliding = QuadraticSurface::fit(&self.fitted, &changes.collect::<Vec<_>>());
        Ok(sliding.map(|sliding| OtherLaw {
            probability: other.probability,
            correlations: correlations(&other.case, &by_other),
            shift,
            sliding,
        }))
    }

    /// Root mean square by which `surface` misses the logarithm at places that it was not fitted to.
    fn error_of(&self, surface: &QuadraticSurface) -> Result<f64, Error> {
        let others = self.base.places(HELD_OUT, SEED + 1);
        let found = self.base.all(&others, None)?;
        let squares = others.iter().zip(&found);
        let squares = squares.map(|(z, losses)| (surface.at(z) - self.ratio(losses)).powi(2));
        Ok((squares.sum::<f64>() / HELD_OUT as f64).sqrt())
    }

    /// Factors that single evaluations give: inner boundary friction, thermal reduction beyond its fit, lay above 1/3.
    fn enter_factors(
        &self,
        loaded: &OperatingCase,
        surface: &QuadraticSurface,
        predictive: &mut Predictive,
    ) -> Result<(), Error> {
        let (base, middle) = (&self.base, &self.middle);
        if draws_inner_boundary(loaded) {
            let ratio = |losses: &Losses| self.ratio(losses);
            let boundary_w = middle.summary.boundary_w;
            let found = inner_boundary(base, &ratio, boundary_w, surface)?;
            predictive.inner_boundary = Some(found);
        }
        let is_held = |note: &OutsideInput| note.correlation == GUPTA_HELD;
        if middle.outside.iter().any(is_held) {
            let printed = base.loaded.overridden(|over| over.printed_thermal = true)?;
            let found = evaluated(&printed, Some(base.contacts.contacts))?;
            let rolling = if middle.summary.rolling_w > 0.0 {
                found.summary.rolling_w / middle.summary.rolling_w
            } else {
                1.0
            };
            predictive.held_thermal = Some([self.ratio(&found).exp(), rolling]);
        }
        if loaded.surfaces.sheets().is_some() {
            predictive.patch_flow = Some(self.by_other_gaps()?);
        } else if loaded.lay_beyond_records().map_err(whole)?.is_some() {
            let lay = Some([Lay::CONFIRMED; 2]);
            let confirmed = base.loaded.overridden(|over| over.lay = lay)?;
            let found = evaluated(&confirmed, Some(base.contacts.contacts))?;
            (base.done)(1 + base.number.fetch_add(1, Ordering::Relaxed));
            predictive.far_lay = Some(self.ratio(&found).exp());
        }
        Ok(())
    }
}

impl Fits<'_> {
    /// The loss of patches by other gaps than their computed flow supplies.
    fn by_other_gaps(&self) -> Result<PatchFlowError, Error> {
        let base = &self.base;
        let with = |gap: PatchGap| {
            let other = base.loaded.overridden(|over| over.patch_gap = gap)?;
            let found = evaluated(&other, Some(base.contacts.contacts))?;
            (base.done)(1 + base.number.fetch_add(1, Ordering::Relaxed));
            Ok::<_, Error>(self.ratio(&found).exp())
        };
        let lay = base.loaded.surfaces.lay(base.loaded.case.model.lay);
        let [lay, confirmed, known] =
            [lay.map_err(whole)?, Lay::CONFIRMED, Lay::RECORDED].map(Lay::gamma);
        let nearness = ((known - lay) / (known - confirmed)).clamp(0.0, 1.0);
        Ok(PatchFlowError {
            wider: with(PatchGap::Times(PATCH_GAP_ERROR.exp()))?,
            by_lines: nearness * (with(PatchGap::SecondOrder)? - 1.0),
        })
    }
}

/// A case with the offsets and surrogates of the evaluations: a ratio of losses needs few, whatever the case states.
fn few_offsets(loaded: &OperatingCase, offsets: usize) -> Result<OperatingCase, Error> {
    let few = if loaded.surfaces.is_surrogate() {
        loaded.first_pair()
    } else {
        loaded.clone()
    };
    let each = offsets / few.surfaces.pairs();
    let each = each.max(1).min(loaded.case.model.offsets);
    few.overridden(|over| over.offsets = Some(each))
}

/// The case by the other law of pressure, with its probability, where the curves of an oil file do not decide the law.
struct ByOtherLaw {
    case: OperatingCase,
    probability: f64,
}

fn other_law(loaded: &OperatingCase, offsets: usize) -> Result<Option<ByOtherLaw>, Error> {
    let Some((law, probability)) = loaded.case.other_law() else {
        return Ok(None);
    };
    let by_other = loaded.with_keys(|input| input.model.film_pressure_law = Some(law))?;
    Ok(Some(ByOtherLaw {
        case: few_offsets(&by_other, offsets)?,
        probability,
    }))
}

fn path_share(losses: &Losses) -> f64 {
    PathLosses::from_rows(&losses.path).asperity_share
}

/// Whether the loss depends on β_i, which the case does not state.
fn draws_inner_boundary(loaded: &LoadedCase) -> bool {
    let case = &loaded.case;
    matches!(case.share_law(), ShareLaw::Solved(of) if of.spot_speed == SpotSpeed::Carried)
        && loaded.surfaces.are_measured()
        && case.input.model.inner_boundary.is_none()
        && case.overrides.inner_boundary.is_none()
}

/// Common input of all evaluations.
struct EvaluationBase<'a> {
    loaded: &'a OperatingCase,
    constants: &'a [Ranged],
    contacts: Windows<'a>,
    number: AtomicUsize,
    done: &'a (dyn Fn(usize) + Sync),
}

impl EvaluationBase<'_> {
    /// The losses with the constants at `z`, and with another β_i.
    fn at(&self, z: &[f64], inner_boundary: Option<f64>) -> Result<Losses, Error> {
        let drawn = self.loaded.overridden(|over| {
            for (constant, z) in self.constants.iter().zip(z) {
                over.set(constant.kind, constant.at(*z));
            }
            over.inner_boundary = inner_boundary.or(over.inner_boundary);
        })?;
        let found = evaluated(&drawn, Some(self.contacts.contacts))?;
        (self.done)(1 + self.number.fetch_add(1, Ordering::Relaxed));
        Ok(found)
    }

    /// The losses at these places, one after the other, as neighbours with the same film share the roughness that it leaves. Their
    /// positions are computed in parallel.
    fn all(&self, points: &[Vec<f64>], inner_boundary: Option<f64>) -> Result<Vec<Losses>, Error> {
        let at = |z: &Vec<f64>| self.at(z, inner_boundary);
        points.iter().map(at).collect()
    }

    /// Places of evaluations, even over the standardised constants; where they are many, neighbours have the same film.
    fn places(&self, count: usize, seed: u64) -> Vec<Vec<f64>> {
        let changes_film = |constant: &&Ranged| constant.kind.changes_film();
        let of_film = self.constants.iter().filter(changes_film).count();
        let of_one = (count / (FILMS * of_film).max(1)).max(1);
        let films = latin_hypercube(count.div_ceil(of_one), of_film, FILM_SEED + seed);
        let others = latin_hypercube(count, self.constants.len() - of_film, seed);
        let place = |(k, others): (usize, &Vec<f64>)| {
            let [mut film, mut others] = [&films[k / of_one], others].map(|of| of.iter());
            let constants = self.constants.iter();
            let parts = constants.map(|constant| {
                if changes_film(&constant) {
                    film.next()
                } else {
                    others.next()
                }
            });
            parts
                .flatten()
                .map(|part| REACH * (2.0 * part - 1.0))
                .collect()
        };
        others.iter().enumerate().map(place).collect()
    }
}

/// ln of the sliding loss over β_i: at the medians, at either side of the boundary layer, and at one side of the boundary friction.
///
/// `ratio` is ln of the sliding loss over the loss at the medians, and `boundary_w` the friction of the boundary layer there. At the
/// middle of β_i the logarithm is `surface`, whose error enters the slopes of the bend only.
fn inner_boundary(
    base: &EvaluationBase<'_>,
    ratio: &dyn Fn(&Losses) -> f64,
    boundary_w: f64,
    surface: &QuadraticSurface,
) -> Result<InnerBoundary, Error> {
    /// Standard deviations to the side: at the 5 and 95 % quantiles.
    const SIDE: f64 = 1.645;
    let kinds = [
        UncertainParameter::BoundaryLayer,
        UncertainParameter::BoundaryFriction,
    ];
    let beside = |kind: UncertainParameter, side: f64| {
        let of = |constant: &Ranged| if constant.kind == kind { side } else { 0.0 };
        base.constants.iter().map(of).collect::<Vec<f64>>()
    };
    let [layer, friction] = kinds;
    let places = [
        beside(layer, 0.0),
        beside(layer, SIDE),
        beside(layer, -SIDE),
        beside(friction, SIDE),
    ];
    let [low_end, high_end] = INNER_BOUNDARY_RANGE.map(|share| base.all(&places, Some(share)));
    let (low, high) = (low_end?, high_end?);
    let log = |k: usize| {
        let middle = match k {
            0 => 0.0,
            _ => surface.at(&places[k]),
        };
        let [low, high] = [&low[k], &high[k]].map(|end| ratio(end) - middle);
        [0.5 * (high - low), 0.5 * (high + low)]
    };
    let logs = [0, 1, 2, 3].map(log);
    let [slope, bend] = [0, 1].map(|of: usize| {
        let by_friction = (logs[3][of] - logs[0][of]) / SIDE;
        let by_layer = (logs[1][of] - logs[2][of]) / (2.0 * SIDE);
        [logs[0][of], by_friction, by_layer]
    });
    let boundary = if boundary_w > 0.0 {
        let [low, high] = [&low, &high].map(|end| end[0].summary.boundary_w / boundary_w);
        [0.5 * (high - low), 0.5 * (high + low) - 1.0]
    } else {
        [0.0; 2]
    };
    Ok(InnerBoundary {
        slope,
        bend,
        boundary,
    })
}

/// Rows of the lower triangle of the correlations of the measured constants.
fn correlations(loaded: &OperatingCase, constants: &[Ranged]) -> Vec<Vec<f64>> {
    let measured: Vec<_> = constants
        .iter()
        .filter_map(|constant| Some((constant.kind, constant.measured?)))
        .collect();
    let of_both = |i: usize, j: usize| match (measured[i], measured[j]) {
        _ if i == j => 1.0,
        ((first, by), (other, by_other)) if by == by_other => {
            first.correlation(other, by, &loaded.case)
        }
        _ => 0.0,
    };
    // A case whose correlations contradict each other is refused.
    cholesky(measured.len(), of_both).unwrap_or_default()
}

/// The error of the law of film friction whose constants an oil file states.
fn film_law(loaded: &OperatingCase, summary: &Summary) -> Option<FilmLaw> {
    let case = &loaded.case;
    let file = case.oil_file.as_ref()?;
    (summary.sliding_w > 0.0).then(|| FilmLaw {
        share: 1.0 - summary.boundary_w / summary.sliding_w,
        deviation: file.film_friction.law_error(loaded.temperature()),
    })
}

/// Means over a path, weighted with the sliding loss.
pub(super) struct PathLosses {
    pub asperity_share: f64,
    pub film_friction: f64,
    pub roughness_over_film: Option<f64>,
    max_pressure_pa: Option<f64>,
    film_m: f64,
}

impl PathLosses {
    pub fn from_rows(path: &[PositionRow]) -> Self {
        let power = |row: &PositionRow| row.weight_m * row.sliding_w_per_m;
        let total: f64 = path.iter().map(power).sum();
        let mean = |of: &dyn Fn(&PositionRow) -> f64| {
            if total > 0.0 {
                path.iter().map(|row| power(row) * of(row)).sum::<f64>() / total
            } else {
                0.0
            }
        };
        let is_known = path.iter().any(|row| row.roughness_over_film.is_some());
        Self {
            asperity_share: mean(&|row| 1.0 - row.film_share),
            film_friction: mean(&|row| row.mu_film),
            roughness_over_film: is_known
                .then(|| mean(&|row| row.roughness_over_film.unwrap_or(0.0))),
            max_pressure_pa: (total > 0.0).then(|| mean(&|row| 1e6 * row.hertz_pressure_mpa)),
            film_m: mean(&|row| 1e-6 * row.film_central_um),
        }
    }
}

/// The sliding loss of each position and its standard deviation over the offsets \[W\].
pub(super) fn losses_of_positions(path: &[PositionRow]) -> Vec<[f64; 2]> {
    let of = |row: &PositionRow| {
        let deviation = row.sliding_deviation_w_per_m.unwrap_or(0.0);
        [row.sliding_w_per_m, deviation].map(|power| row.weight_m * power)
    };
    path.iter().map(of).collect()
}

/// Half width of the widest contact of a path.
pub(super) fn widest(path: &[PositionRow]) -> Length {
    let half_widths = path.iter().map(|row| 1e-6 * row.half_width_um);
    Length::from_si(half_widths.fold(0.0, f64::max))
}

/// The sampling error of ln loss: between pairs of teeth, over windows, or by the misplacement of placed traces.
fn sampling_error(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    asperity_share: f64,
) -> Result<SamplingError, Error> {
    if let Some(found) = travelled(loaded, nominal, asperity_share) {
        return Ok(SamplingError {
            standard_error: found.standard_error,
            freedom: found.freedom,
            ..SamplingError::NONE
        });
    }
    let surfaces = &loaded.surfaces;
    let shifts = misplaced(loaded, nominal.summary.loss_w)?;
    let losses: Vec<f64> = nominal.offsets.iter().map(|row| row.loss_w).collect();
    let of_pairs = means_of_pairs(&losses, surfaces.pairs());
    let logs: Vec<f64> = of_pairs.iter().map(|loss| loss.ln()).collect();
    if surfaces.is_surrogate() {
        return Ok(of_surrogates(&logs, asperity_share));
    }
    let of_place = SamplingError {
        shifts,
        ..SamplingError::NONE
    };
    if surfaces.several_teeth().is_some() {
        let found = sampling_of_teeth(&logs, surfaces).filter(|found| found.standard_error_w > 0.0);
        let of_pairs = found.map_or(of_place, |found| SamplingError {
            standard_error: found.standard_error_w,
            freedom: found.freedom,
            ..of_place
        });
        // Rows of one scan resemble each other: they scatter less than teeth, and do not say more than the windows along them.
        let of_scan = loaded.sampled.as_ref().filter(|sampled| {
            let mut traces = sampled.traces.iter().flatten();
            traces.any(|trace| trace.row.is_some())
        });
        let of_windows = match of_scan {
            Some(_) => of_windows(loaded, nominal, asperity_share).map_err(whole)?,
            None => None,
        };
        return Ok(match of_windows {
            Some(windows) if windows.standard_error > of_pairs.standard_error => SamplingError {
                standard_error: windows.standard_error,
                freedom: windows.freedom,
                ..of_pairs
            },
            _ => of_pairs,
        });
    }
    if shifts.is_some() {
        return Ok(of_place);
    }
    let found = of_windows(loaded, nominal, asperity_share).map_err(whole)?;
    Ok(found.map_or(SamplingError::NONE, |found| SamplingError {
        standard_error: found.standard_error,
        freedom: found.freedom,
        ..SamplingError::NONE
    }))
}

/// Sampling error over the windows of one trace or scan of each flank; `None` without them.
pub(super) fn of_windows(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    asperity_share: f64,
) -> Result<Option<WindowSampling>, PositionError> {
    let (window, widest) = (loaded.case.model.window, widest(nominal.path));
    let independent = Independent::new(&loaded.surfaces, window, widest)?;
    let positions = losses_of_positions(nominal.path);
    let offsets = nominal.summary.offsets;
    let found = independent
        .map(|independent| window_sampling(&positions, offsets, independent, asperity_share));
    let wider = wider_like_measured(&loaded.surfaces);
    Ok(found.map(|found| WindowSampling {
        standard_error: wider * found.standard_error,
        ..found
    }))
}

/// Sampling error of a loss by records: of the windows that passed through their contacts, and of no more than the traces have;
/// `None` without records.
pub(super) fn travelled(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    asperity_share: f64,
) -> Option<WindowSampling> {
    let friction = nominal.summary.recorded_friction?;
    let of_traces = windows_of_traces(
        &loaded.surfaces,
        loaded.case.model.window,
        widest(nominal.path),
    )?;
    let (passed, error) = if friction.standard_error.is_finite() {
        let passed = friction.windows.round().max(1.0) as usize;
        (passed, friction.standard_error)
    } else {
        // A travel of one block says nothing of its scatter.
        (1, 0.0)
    };
    Some(travel_sampling(passed, error, of_traces, asperity_share))
}

/// The error of flanks that are known by roughness values: the scatter of the pairs of surrogates, and their form.
///
/// ```text
/// ln P = mean ln P_k + s_k t(n − 1) + N(0, (0.27 φ)²)                           [Surrogate-error]
/// ```
fn of_surrogates(logs: &[f64], asperity_share: f64) -> SamplingError {
    const FORM: f64 = 0.27;
    asperity_core::cite!("Surrogate-error");
    SamplingError {
        standard_error: deviation(logs).unwrap_or(0.0),
        freedom: (logs.len() as f64 - 1.0).max(1.0),
        form: FORM * asperity_share,
        shifts: None,
    }
}

/// Standard error of ln loss by the sampling of the flanks.
pub(super) fn standard_error(loaded: &OperatingCase, nominal: &Nominal<'_>) -> Result<f64, Error> {
    let share = PathLosses::from_rows(nominal.path).asperity_share;
    Ok(sampling_error(loaded, nominal, share)?.standard_error)
}

/// Changes of ln loss where placed traces are misplaced by two half-widths against each other; none where they are
/// not placed.
fn misplaced(loaded: &OperatingCase, nominal: f64) -> Result<Option<[f64; 2]>, Error> {
    const HALF_WIDTHS: f64 = 2.0;
    let mut changes = [0.0; 2];
    for (change, by) in changes.iter_mut().zip([-HALF_WIDTHS, HALF_WIDTHS]) {
        let Some(surfaces) = loaded.surfaces.misplaced(by) else {
            return Ok(None);
        };
        let other = loaded.with_surfaces(surfaces);
        *change = (evaluated(&other, None)?.summary.loss_w / nominal).ln();
    }
    Ok(Some(changes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surrogates_scatter_as_their_pairs_do() {
        let found = of_surrogates(&[6.0, 6.1, 6.2, 6.1], 0.2);
        assert!((found.standard_error - (0.02_f64 / 3.0).sqrt()).abs() < 1e-12);
        assert_eq!(found.freedom, 3.0);
        assert!((found.form - 0.054).abs() < 1e-15);
    }
}
