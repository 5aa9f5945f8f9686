//! Traces and surfaces like measured ones: of pieces where heights, slopes or curvatures are not Gaussian, of spectrum and heights elsewhere.
//!
//! Source: Lobato and Velasco 2004, the scatter of skewness and kurtosis of correlated Gaussian numbers.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | Rsk, Rku | skewness and kurtosis of heights, slopes or curvatures, means over m traces | - |
//! | ρ_k | autocorrelation at a distance of k points | - |
//! | n | points of a trace | - |

use asperity_core::numerics::range;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Fault, Profile, cite};
use serde::{Deserialize, Serialize};

use super::achieved::Generated;
use super::fitted::{Fitted, levelled};
use super::fitted_surface::FittedSurface;
use super::pieces::{Piece, Pieces};
use super::state::State;
use super::surface_pieces::{SurfacePiece, SurfacePieces};
use super::teeth::{Teeth, times};
use crate::Warning;
use crate::autocorrelation::autocorrelation;
use crate::error::RoughnessError;

/// Standard errors by which a Gaussian texture may miss skewness 0 and kurtosis 3.
const ERRORS: f64 = 3.0;
/// Distance of the heights whose differences are slopes and curvatures \[m\].
const LAG: f64 = 2.5e-6;
/// Part of a trace over which its autocorrelation is summed.
const SUMMED: f64 = 0.25;
/// Ratio of the greatest to the least Rq or root mean square slope from which traces count as several finishes.
const DIFFERENT: f64 = 2.0;

/// A way to make traces like measured ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Pieces of the traces.
    Pieces,
    /// Spectrum and heights of the traces, with random phases.
    Spectrum,
}

/// Maker of traces like measured ones.
#[derive(Debug, Clone)]
pub struct Like {
    maker: Maker,
    /// Scatter between the teeth of the traces.
    pub teeth: Teeth,
    /// Doubts about the traces.
    pub warnings: Vec<Warning>,
}

#[derive(Debug, Clone)]
enum Maker {
    Pieces(Pieces),
    Spectrum(Fitted),
}

/// Maker of surfaces like measured ones.
#[derive(Debug, Clone)]
pub struct LikeSurface {
    maker: SurfaceMaker,
    /// Doubts about the surfaces.
    pub warnings: Vec<Warning>,
}

#[derive(Debug, Clone)]
enum SurfaceMaker {
    Pieces(SurfacePieces),
    Spectrum(FittedSurface),
}

/// A surface like measured ones.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MadeSurface {
    /// Heights \[m\], row by row.
    pub heights: Vec<f64>,
    /// Its method.
    pub method: Method,
    /// Its pieces in order; none of a spectrum.
    pub pieces: Vec<SurfacePiece>,
}

/// Rows of a surface by which its method is chosen; ridges along the lead make close ones equal.
const ROWS: usize = 4;

impl LikeSurface {
    /// Prepares `surfaces`, heights \[m\] row by row, all of the same size and spacings.
    ///
    /// Without a `method`, surfaces are made of pieces unless heights, slopes and curvatures of four rows of each are Gaussian.
    ///
    /// # Errors
    /// When a surface has too few or too many points, heights are missing, or the sizes differ.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{LikeSurface, Method};
    /// // Dimples every 60 um on a plane.
    /// let columns = 400;
    /// let dimple = |k: usize| {
    ///     let r = ((k % columns % 60) as f64 - 30.0).hypot((k / columns % 60) as f64 - 30.0);
    ///     -1e-6 * (1.0 - r / 20.0).max(0.0)
    /// };
    /// let z: Vec<f64> = (0..columns * 300).map(dimple).collect();
    /// let like = LikeSurface::to(&[z], columns, [Length::from_si(1e-6); 2], None)?;
    /// assert_eq!(like.generate(1).method, Method::Pieces);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(
        surfaces: &[Vec<f64>],
        columns: usize,
        spacings: [Length; 2],
        method: Option<Method>,
    ) -> Result<Self, RoughnessError> {
        let (mut rows, mut middles) = (Vec::new(), Vec::new());
        for z in surfaces {
            let all = z.chunks_exact(columns.max(1));
            let profile = |row: &[f64]| Profile::new(spacings[0], row.to_vec());
            // A flat row has no shape.
            let shaped = all.clone().filter(|row| row.iter().any(|z| *z != row[0]));
            let step = all.len().div_ceil(ROWS).max(1);
            for row in shaped.step_by(step) {
                rows.push(profile(row)?);
            }
            middles.extend(all.clone().nth(all.len() / 2).map(profile).transpose()?);
        }
        let chosen = match (method, rows.split_first()) {
            (Some(method), _) => method,
            // A tilt would hide the shape of the heights.
            (None, Some((first, others))) => chosen(&levelled(first, others)?)?,
            (None, None) => chosen(&rows)?,
        };
        let mut warnings = Vec::new();
        if let Some((first, others)) = middles.split_first() {
            warnings.extend(different(&levelled(first, others)?));
            if others.is_empty() && chosen == Method::Pieces {
                let length = first.length();
                warnings.push(Warning::OneTrace { length });
            }
        }
        let maker = match chosen {
            Method::Pieces => SurfaceMaker::Pieces(SurfacePieces::to(surfaces, columns, spacings)?),
            Method::Spectrum => {
                SurfaceMaker::Spectrum(FittedSurface::to(surfaces, columns, spacings)?)
            }
        };
        Ok(Self { maker, warnings })
    }

    /// Whether long waves are generated in addition to the pieces.
    #[must_use]
    pub fn has_long_waves(&self) -> bool {
        match &self.maker {
            SurfaceMaker::Pieces(maker) => maker.has_long_waves(),
            SurfaceMaker::Spectrum(_) => false,
        }
    }

    /// A surface of the size of those given.
    #[must_use]
    pub fn generate(&self, seed: u64) -> MadeSurface {
        match &self.maker {
            SurfaceMaker::Pieces(maker) => {
                let made = maker.generate(seed);
                MadeSurface {
                    heights: made.heights,
                    method: Method::Pieces,
                    pieces: made.pieces,
                }
            }
            SurfaceMaker::Spectrum(maker) => MadeSurface {
                heights: maker.generate(seed),
                method: Method::Spectrum,
                pieces: Vec::new(),
            },
        }
    }
}

/// A trace like measured ones.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct MadeLike {
    /// The trace.
    #[serde(flatten)]
    pub generated: Generated,
    /// Its method.
    pub method: Method,
    /// Its pieces in order; none of a spectrum.
    pub pieces: Vec<Piece>,
    /// Its recipe, where it has one.
    pub recipe: Option<Fitted>,
}

impl Like {
    /// Prepares `first` and `others`, traces of one finish with equal spacings.
    ///
    /// Without a `method`, traces are made of pieces unless heights, slopes and curvatures are Gaussian.
    ///
    /// # Errors
    /// When the spacings differ, or a trace is too short for the method.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Like, Method, SelfAffine, truncated};
    /// let measured = SelfAffine {
    ///     points: 6000, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// }.generate()?;
    /// assert_eq!(Like::to(&measured, &[], None)?.method(), Method::Spectrum);
    /// let plateaus = truncated(&measured, 0.3)?.0;
    /// assert_eq!(Like::to(&plateaus, &[], None)?.method(), Method::Pieces);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(
        first: &Profile,
        others: &[Profile],
        method: Option<Method>,
    ) -> Result<Self, RoughnessError> {
        let traces = levelled(first, others)?;
        let chosen = method.map_or_else(|| chosen(&traces), Ok)?;
        let mut warnings = Vec::new();
        if others.is_empty() && chosen == Method::Pieces {
            let length = first.length();
            warnings.push(Warning::OneTrace { length });
        }
        warnings.extend(different(&traces));
        let teeth = Teeth::of(&traces)?;
        let each = traces.iter().enumerate();
        let alike = each.map(|(k, trace)| teeth.levelled(k, trace));
        let alike = alike.collect::<Result<Vec<_>, _>>()?;
        let (first, others) = (&alike[0], &alike[1..]);
        let maker = match chosen {
            Method::Pieces => Maker::Pieces(Pieces::to(first, others)?),
            Method::Spectrum => Maker::Spectrum(Fitted::to(first, others, 0)?),
        };
        Ok(Self {
            maker,
            teeth,
            warnings,
        })
    }

    /// Prepares traces `before` a test for flanks in a `state` of it. `after` are the traces of the same places in the same order after
    /// a stage, one stage after the other. The flanks are made of pieces.
    ///
    /// # Errors
    /// As [`to`](Self::to), and when a trace after a stage is missing or not of its place.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Like, SelfAffine, State, truncated};
    /// let before = SelfAffine {
    ///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// }.generate()?;
    /// let stages = [truncated(&before, 0.1)?.0, truncated(&before, 0.2)?.0];
    /// let before = [before];
    /// let rq = |engagements| -> Result<f64, asperity_core::Fault> {
    ///     let state = State::after(engagements, &[1e4, 1e6])?;
    ///     Ok(Like::of_stages(&before, &stages, state)?.generate(1)?.generated.achieved.rq.si())
    /// };
    /// assert!(rq(0.0)? > rq(1e4)? && rq(1e4)? > rq(3e5)? && rq(3e5)? > rq(1e6)?);
    /// # Ok::<(), asperity_core::Fault>(())
    /// ```
    pub fn of_stages(before: &[Profile], after: &[Profile], state: State) -> Result<Self, Fault> {
        let rule = "must be one for each trace before the test and each stage";
        let n = before.len();
        let is_full = n > 0 && after.len() == n * state.stages();
        let given = after.len() as f64;
        DomainError::require(is_full, "number of traces after it", given, "-", rule)?;
        let traces = levelled(&before[0], &before[1..])?;
        let teeth = Teeth::of(&traces)?;
        let alike = |traces: &[Profile]| -> Result<Vec<Profile>, DomainError> {
            let each = traces.iter().enumerate();
            each.map(|(k, trace)| teeth.levelled(k % n, trace))
                .collect()
        };
        let pieces = Pieces::of_stages(&alike(before)?, &alike(after)?, state)?;
        let one = (before.len() == 1).then(|| Warning::OneTrace {
            length: before[0].length(),
        });
        Ok(Self {
            maker: Maker::Pieces(pieces),
            teeth,
            warnings: one.into_iter().chain(different(&traces)).collect(),
        })
    }

    /// The method of its traces.
    #[must_use]
    pub fn method(&self) -> Method {
        match self.maker {
            Maker::Pieces(_) => Method::Pieces,
            Maker::Spectrum(_) => Method::Spectrum,
        }
    }

    /// A trace with as many points as the first of the measured ones.
    ///
    /// # Errors
    /// When it would have too many points.
    pub fn generate(&self, seed: u64) -> Result<MadeLike, RoughnessError> {
        let method = self.method();
        let factor = self.teeth.factor(seed);
        let of_tooth = |made: Generated| -> Result<Generated, DomainError> {
            if factor == 1.0 {
                return Ok(made);
            }
            Ok(Generated::new(times(&made.profile, factor)?))
        };
        Ok(match &self.maker {
            Maker::Pieces(pieces) => {
                let made = pieces.generate(pieces.points(), seed)?;
                MadeLike {
                    generated: of_tooth(made.generated)?,
                    method,
                    pieces: made.pieces,
                    recipe: None,
                }
            }
            Maker::Spectrum(fitted) => {
                let recipe = fitted.times(factor, seed);
                MadeLike {
                    generated: recipe.generate()?,
                    method,
                    pieces: Vec::new(),
                    recipe: Some(recipe),
                }
            }
        })
    }
}

/// Pieces, unless skewness and kurtosis of heights, slopes and curvatures are within three standard errors of 0 and 3.
///
/// Slopes and curvatures are differences over 2.5 µm, which noise and digits do not decide.
///
/// ```text
/// |Rsk| ≤ 3 √(6/(m n) Σ (1 − |k|/n) ρ_k³),  |Rku − 3| ≤ 3 √(24/(m n) Σ (1 − |k|/n) ρ_k⁴)      [Like-1]
/// ```
fn chosen(traces: &[Profile]) -> Result<Method, RoughnessError> {
    cite!("Like-1");
    let mut is_all = true;
    for order in 0..3 {
        let of = |trace: &Profile| {
            let lag = (LAG / trace.spacing().si()).round().max(1.0) as usize;
            (0..order).fold(trace.heights().to_vec(), |z, _| {
                let pairs = z.iter().zip(z.iter().skip(lag));
                pairs.map(|(a, b)| b - a).collect()
            })
        };
        is_all &= is_gaussian(&traces.iter().map(of).collect::<Vec<_>>())?;
    }
    Ok(if is_all {
        Method::Spectrum
    } else {
        Method::Pieces
    })
}

fn is_gaussian(traces: &[Vec<f64>]) -> Result<bool, RoughnessError> {
    // Sums over the traces of skewness, of kurtosis less 3, and of their variances.
    let mut sums = [[0.0; 2]; 2];
    for z in traces {
        let n = z.len() as f64;
        let mean = z.iter().sum::<f64>() / n;
        let moment = |power| z.iter().map(|z| (z - mean).powi(power)).sum::<f64>() / n;
        let square = moment(2);
        let departures = [
            moment(3) / square.powf(1.5),
            moment(4) / square.powi(2) - 3.0,
        ];
        let correlation = autocorrelation(z)?;
        let correlation = &correlation[1..((SUMMED * n) as usize).max(1)];
        for (k, [departure, variance]) in sums.iter_mut().enumerate() {
            let power = k as i32 + 3;
            let both =
                |(i, rho): (usize, &f64)| 2.0 * (1.0 - (i as f64 + 1.0) / n) * rho.powi(power);
            let others: f64 = correlation.iter().enumerate().map(both).sum();
            *departure += departures[k];
            // Of independent points at least: a wave has correlations of both signs.
            *variance += [6.0, 24.0][k] / n * (1.0 + others.max(0.0));
        }
    }
    Ok(sums
        .iter()
        .all(|[departure, variance]| departure.abs() <= ERRORS * variance.sqrt()))
}

/// The warning that traces differ as several finishes do.
fn different(traces: &[Profile]) -> Option<Warning> {
    let measures = traces.iter().map(super::Achieved::from_profile);
    let measures: Vec<_> = measures.collect();
    let of = |values: Vec<f64>| {
        let [low, high] = range(values);
        (high > DIFFERENT * low).then_some([low, high])
    };
    let rq = of(measures.iter().map(|a| a.rq.si()).collect()).map(|ends| ends.map(Length::from_si));
    let rdq = || of(measures.iter().filter_map(|a| a.rdq).collect());
    match (rq, rdq()) {
        (Some([from, to]), _) => Some(Warning::HeightsDiffer { from, to }),
        (None, Some([from, to])) => Some(Warning::SlopesDiffer { from, to }),
        (None, None) => None,
    }
}
