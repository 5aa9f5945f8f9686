//! Traces made of pieces of measured ones, which keep ridges, valleys and marks as they were measured.
//!
//! Source: Efros and Freeman 2001 (image quilting), in one dimension and with blended seams at the least difference.
//!
//! A straight line and the waves longer than two pieces are removed from every trace. What is left is divided into pieces, and as many as the
//! new trace needs are drawn. They follow each other in the order in which they fit best, each end moved by up to an overlap. No
//! piece is drawn twice before all were. The order of the pieces loses a part of the waves longer than a piece: a Gaussian profile has the
//! power that trial traces of pieces lack. The traces given therefore decide all shorter waves and rare valleys.
//!
//! Of traces before a test and after one or several stages of it, which are relocated on the first, flanks are made in any state between:
//! pieces are drawn from all traces of a place, and a part of the heights that were lost is taken off. The heights are those measured,
//! without the filter of the relocation.
//!
//! A trace of n points costs at most 16 · 441 m sums over an overlap for its m pieces, whatever the length of the traces given.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z, z_c | last heights of the trace, heights before a drawn piece | m |
//! | z_b, z_a | heights before a test and in a state of it | m |
//! | Δ_i | heights lost until stage i; Δ₀ = 0 | m |
//! | S_z, S_p, S_w | densities of the traces given, of trial traces of pieces, and of the waves that these lack | m³ |
//! | s | part of the way from stage i to i + 1, in engagements n of a tooth | - |

use asperity_core::numerics::{good_fft_length, interpolate};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Fault, Profile, cite};
use serde::{Deserialize, Serialize};

use super::achieved::Generated;
use super::fitted::{MICRO, bands, gaussian, levelled, mean_square, parent_of};
use super::random::Random;
use super::scaling::check_points;
use super::state::State;
use crate::error::RoughnessError;
use crate::form::{self, Form};
use crate::gaussian_filter::{Ends, mean_line};
use crate::relocation::{Bounds, relocate};
use crate::resampling::respaced;
use crate::spectral::{PowerSpectrum, power_spectrum};

/// Shortest and longest piece \[m\].
const PIECE: [f64; 2] = [150e-6, 300e-6];
/// Length over which two pieces are fitted \[m\].
const OVERLAP: f64 = 20e-6;
/// Length over which two pieces are blended within the overlap \[m\].
const SEAM: f64 = 5e-6;
/// Waves longer than this are not in the pieces.
pub const LONG_WAVES: Length = Length::from_si(600e-6);
/// Most pieces of which the best follows the last one.
const BATCH: usize = 16;
/// Moves of an end to either side, and points compared over an overlap.
const MOVES: usize = 10;
const COMPARED: usize = 40;
/// Trial traces whose waves are compared with those given, and most points of all of them.
const TRIALS: usize = 24;
const TRIAL_POINTS: usize = 200_000;
/// Number of corrections of the waves that the pieces lack.
const CORRECTIONS: usize = 2;
/// Part of a density that counts as none.
const NONE: f64 = 1e-4;
/// Lines of a spectrum by one of a trace.
const STEPS: f64 = 4.0;

/// Measured traces to take pieces of.
#[derive(Debug, Clone)]
pub struct Pieces {
    spacing: Length,
    /// Points of the first trace.
    points: usize,
    /// Heights without long waves \[m\] of each trace.
    traces: Vec<Vec<f64>>,
    /// Heights \[m\] that each trace lost until the state; none without traces after a test.
    lost: Vec<Vec<f64>>,
    /// Spectrum of the waves that the pieces lack, as [`Fitted::spectrum`](super::Fitted::spectrum).
    spectrum: Vec<[f64; 2]>,
    /// Points of the longest trace.
    longest: usize,
    /// Mean square of the long waves \[m²\].
    square: f64,
}

/// A piece of a generated trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Piece {
    /// Index of the measured trace.
    pub trace: usize,
    /// Its first point on the measured trace; of a pair on the common length of both.
    pub first: usize,
    /// Number of its points.
    pub points: usize,
}

/// A trace with the pieces that it was made of.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Pieced {
    /// The trace.
    #[serde(flatten)]
    pub generated: Generated,
    /// Its pieces in order.
    pub pieces: Vec<Piece>,
}

/// Where a piece of a batch is joined to the last one.
#[derive(Default)]
struct Joint {
    /// Its index in the batch.
    index: usize,
    /// Points of the last piece.
    end: usize,
    /// Its first point.
    first: usize,
}

impl Pieces {
    /// Prepares `first` and `others`, traces of one finish with equal spacings.
    ///
    /// # Errors
    /// When a trace is shorter than two of the longest pieces, the spacings differ, or they exceed half an overlap.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Pieces, SelfAffine, truncated};
    /// let measured = SelfAffine {
    ///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// }.generate()?;
    /// let plateaus = truncated(&measured, 0.3)?.0;
    /// let made = Pieces::to(&plateaus, &[])?.generate(4096, 1)?;
    /// assert!(made.pieces.len() >= 7 && made.generated.achieved.rsk.unwrap() < -0.5);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(first: &Profile, others: &[Profile]) -> Result<Self, RoughnessError> {
        let spacing = first.spacing();
        let rule = "must not exceed half of the overlap of 20 um";
        DomainError::require(
            spacing.si() <= 0.5 * OVERLAP,
            "spacing",
            spacing.si(),
            "m",
            rule,
        )?;
        let (mut traces, mut spectra) = (Vec::new(), Vec::new());
        for level in levelled(first, others)? {
            if level.length() < LONG_WAVES {
                return Err(RoughnessError::TooShort {
                    length: level.length(),
                    needed: LONG_WAVES,
                    purpose: "a trace to take pieces of",
                });
            }
            let line = mean_line(&level, LONG_WAVES, Ends::Reg1)?;
            spectra.push(power_spectrum(&level)?);
            let short = level.heights().iter().zip(&line).map(|(z, w)| z - w);
            traces.push(short.collect::<Vec<f64>>());
        }
        let mut pieces = Self {
            spacing,
            points: first.len(),
            longest: traces.iter().map(Vec::len).max().unwrap_or_default(),
            square: 0.0,
            traces,
            lost: Vec::new(),
            spectrum: Vec::new(),
        };
        pieces.spectrum = pieces.missing(&spectra)?;
        pieces.square = power(&pieces.spectrum, spacing, pieces.longest);
        Ok(pieces)
    }

    /// Spectrum of the waves that the pieces lack against the `given` spectra, in the mean over trial traces of pieces only. Trial traces of
    /// these waves show what a straight line and the window of a spectrum take from them.
    ///
    /// ```text
    /// S_w = S_z max(1 − Σ S_p/Σ S_z, 0), sums over three bands, of waves longer than the mean piece             [Pieces-4]
    /// ```
    fn missing(&self, given: &[PowerSpectrum]) -> Result<Vec<[f64; 2]>, RoughnessError> {
        cite!("Pieces-4");
        let n = self.points;
        let count = (TRIAL_POINTS / n).clamp(1, TRIALS) as u64;
        let measured = |mut heights: Vec<f64>| {
            heights.truncate(n);
            let trial = Profile::new(self.spacing, heights)?;
            power_spectrum(&form::remove(&trial, Form::Level)?)
        };
        let pieces = (0..count).map(|seed| measured(self.short(n, &mut Random::new(seed)).0));
        let pieces = bands(&pieces.collect::<Result<Vec<_>, _>>()?, 1);
        let given = bands(given, 1);
        let last = given.len().min(pieces.len());
        let near = |k: usize| k.saturating_sub(1)..(k + 2).min(last);
        let sum = |of: &[[f64; 2]], k: usize| of[near(k)].iter().map(|band| band[1]).sum::<f64>();
        let lacking = |k: usize| {
            let [frequency, density] = given[k];
            let is_long = frequency * MICRO * 0.5 * (PIECE[0] + PIECE[1]) < 1.0;
            let part = (1.0 - sum(&pieces, k) / sum(&given, k)).clamp(NONE, 1.0);
            [frequency, density * if is_long { part } else { NONE }]
        };
        let wanted: Vec<[f64; 2]> = (0..last).map(lacking).collect();
        let mut spectrum = wanted.clone();
        for _ in 0..CORRECTIONS {
            let square = power(&spectrum, self.spacing, self.longest);
            let waves = |seed| measured(self.long(&spectrum, square, n, &mut Random::new(seed))?);
            let made = bands(&(0..count).map(waves).collect::<Result<Vec<_>, _>>()?, 1);
            for (k, band) in spectrum.iter_mut().enumerate().take(made.len()) {
                let ratio = sum(&wanted, k) / sum(&made, k).max(f64::MIN_POSITIVE);
                band[1] *= ratio.clamp(0.5, 2.0);
            }
        }
        Ok(spectrum)
    }

    /// Gaussian heights at `n` points at least, of the waves of a spectrum with this mean square \[m²\].
    fn long(
        &self,
        spectrum: &[[f64; 2]],
        square: f64,
        n: usize,
        random: &mut Random,
    ) -> Result<Vec<f64>, DomainError> {
        let parent = good_fft_length(parent_of(n.max(self.longest))?);
        gaussian(
            spectrum,
            (self.spacing, self.longest),
            square,
            parent,
            random,
        )
    }

    /// Prepares traces of one finish `before` a test for flanks in a `state` of it. `after` are the traces of the same places in the same
    /// order after a stage, one stage after the other; each is relocated on its trace before.
    ///
    /// # Errors
    /// As [`to`](Self::to), when the places of a stage are not those before the test, or a trace is not of its place.
    ///
    /// ```text
    /// z_a = z_b − (1 − s) Δ_i − s Δ_(i+1),  s = (n − n_i)/(n_(i+1) − n_i)                       [Pieces-2]
    /// ```
    pub fn of_stages(before: &[Profile], after: &[Profile], state: State) -> Result<Self, Fault> {
        cite!("Pieces-2");
        let rule = "must be one for each trace before the test and each stage";
        let (n, traces) = (before.len(), after.len());
        let is_full = n > 0 && traces == n * state.stages();
        DomainError::require(
            is_full,
            "number of traces after it",
            traces as f64,
            "-",
            rule,
        )?;
        let spacing = before[0].spacing();
        let weights = state.weights();
        let (mut starts, mut lost) = (Vec::new(), Vec::new());
        for (k, place) in before.iter().enumerate() {
            let stages = after.iter().skip(k).step_by(n);
            let found = stages.map(|stage| stage_of(place, stage, spacing));
            let found: Vec<Stage> = found.collect::<Result<_, Fault>>()?;
            let (start, lost_until) = common(&found, &weights)?;
            starts.push(start);
            lost.push(lost_until);
        }
        Ok(Self {
            points: before[0].len(),
            lost,
            ..Self::to(&starts[0], &starts[1..])?
        })
    }

    /// Points of the first trace.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// A trace of `points` points, of stages in their state.
    ///
    /// # Errors
    /// When the number of points is outside its domain.
    pub fn generate(&self, points: usize, seed: u64) -> Result<Pieced, DomainError> {
        let n = check_points(points)?;
        let mut random = Random::new(seed);
        let (mut heights, pieces) = self.short(n, &mut random);
        heights.truncate(n);
        if !self.lost.is_empty() {
            let lost = self.joined(&pieces, &self.lost);
            (heights.iter_mut().zip(lost)).for_each(|(z, lost)| *z -= lost);
        }
        // A flat profile has no long waves.
        if self.square > f64::EPSILON * mean_square(&heights) {
            let long = self.long(&self.spectrum, self.square, n, &mut random)?;
            heights.iter_mut().zip(long).for_each(|(z, w)| *z += w);
        }
        Ok(Pieced {
            generated: Generated::new(Profile::new(self.spacing, heights)?),
            pieces,
        })
    }

    /// At least `n` heights of pieces, and the pieces.
    fn short(&self, n: usize, random: &mut Random) -> (Vec<f64>, Vec<Piece>) {
        let pieces = self.drawn(n, random);
        (self.joined(&pieces, &self.traces), pieces)
    }

    /// Points in a length \[m\].
    fn count(&self, length: f64) -> usize {
        (length / self.spacing.si()).round() as usize
    }

    /// Pieces for at least `n` points. They are drawn before they are joined: the best of many places would be a quiet one.
    fn drawn(&self, n: usize, random: &mut Random) -> Vec<Piece> {
        let (mut pieces, mut made): (Vec<Piece>, _) = (Vec::new(), 0);
        let mut round: Vec<Piece> = Vec::new();
        let mut batch: Vec<Piece> = Vec::new();
        while made < n {
            if batch.is_empty() {
                let mut points = made;
                while points < n && batch.len() < BATCH {
                    if round.is_empty() {
                        round = self.divided(random);
                    }
                    let piece = round.swap_remove(random.below(round.len()));
                    points += piece.points;
                    batch.push(piece);
                }
            }
            let joint = pieces.last().map(|last| self.best(last, &batch));
            let joint = joint.unwrap_or_default();
            let mut next = batch.swap_remove(joint.index);
            if let Some(last) = pieces.last_mut() {
                made = made + joint.end - last.points;
                last.points = joint.end;
                next.points = next.points + next.first - joint.first;
                next.first = joint.first;
            }
            made += next.points;
            pieces.push(next);
        }
        pieces
    }

    /// All traces divided into pieces of random lengths; before the first of a trace there is an overlap.
    fn divided(&self, random: &mut Random) -> Vec<Piece> {
        let [shortest, longest] = PIECE.map(|length| self.count(length));
        let mut pieces = Vec::new();
        for (trace, z) in self.traces.iter().enumerate() {
            let mut first = self.count(OVERLAP);
            while first < z.len() {
                let rest = z.len() - first;
                let drawn = random.between(shortest as f64, longest as f64 + 1.0) as usize;
                // No rest is shorter than the shortest piece.
                let points = match rest {
                    rest if rest <= longest => rest,
                    rest => drawn.min(rest - shortest),
                };
                pieces.push(Piece {
                    trace,
                    first,
                    points,
                });
                first += points;
            }
        }
        pieces
    }

    /// The joint of `last` and one of `batch` at which they fit best; not the piece that followed on its own trace, if there is another.
    ///
    /// ```text
    /// e = Σ (z_c,i − z_i)² over the overlap, least of the drawn pieces with both ends moved by up to an overlap   [Pieces-1]
    /// ```
    fn best(&self, last: &Piece, batch: &[Piece]) -> Joint {
        cite!("Pieces-1");
        let overlap = self.count(OVERLAP);
        let moves = |at: usize| {
            (at.saturating_sub(overlap)..=at + overlap).step_by(overlap.div_ceil(MOVES))
        };
        let step = overlap.div_ceil(COMPARED);
        let before = &self.traces[last.trace];
        let mut best = Joint::default();
        let mut least = (true, f64::INFINITY);
        for (index, piece) in batch.iter().enumerate() {
            let z = &self.traces[piece.trace];
            let follows = piece.trace == last.trace && piece.first == last.first + last.points;
            for end in moves(last.first + last.points).filter(|end| *end <= before.len()) {
                let tail = &before[end - overlap..end];
                for first in moves(piece.first).filter(|first| *first >= overlap) {
                    let head = &z[first - overlap..first];
                    let both = tail.iter().zip(head).step_by(step);
                    let miss = both.map(|(a, b)| (a - b).powi(2)).sum::<f64>();
                    if (follows, miss) < least {
                        least = (follows, miss);
                        best = Joint {
                            index,
                            end: end - last.first,
                            first,
                        };
                    }
                }
            }
        }
        best
    }

    /// The heights of pieces of `traces`: each is joined where it differs least from the end of the last one, blended over a short
    /// seam, since a wide one would smooth what does not fit.
    fn joined(&self, pieces: &[Piece], traces: &[Vec<f64>]) -> Vec<f64> {
        let [overlap, seam] = [OVERLAP, SEAM].map(|length| self.count(length).max(1));
        let around = |piece: &Piece, trace: &[Vec<f64>]| -> Vec<f64> {
            let end = piece.first + piece.points;
            trace[piece.trace][piece.first - overlap..end].to_vec()
        };
        let mut heights: Vec<f64> = Vec::new();
        let mut last: Option<&Piece> = None;
        for piece in pieces {
            let next = around(piece, traces);
            let (head, rest) = next.split_at(overlap);
            if let Some(last) = last {
                let tail = &around(last, &self.traces)[last.points..];
                let from = least_seam(tail, &around(piece, &self.traces)[..overlap], seam);
                let first = heights.len() - overlap;
                for (i, (z, head)) in heights[first..].iter_mut().zip(head).enumerate() {
                    let share = (i as f64 + 1.0 - from as f64) / (seam as f64 + 1.0);
                    *z += share.clamp(0.0, 1.0) * (head - *z);
                }
            }
            heights.extend(rest);
            last = Some(piece);
        }
        heights
    }
}

/// Mean square \[m²\] of waves of a spectrum that are not longer than `points`.
fn power(spectrum: &[[f64; 2]], spacing: Length, points: usize) -> f64 {
    let step = 1.0 / (points as f64 * spacing.si() * MICRO * STEPS);
    let logarithms = spectrum
        .iter()
        .map(|[f, density]| [f.ln(), density.max(f64::MIN_POSITIVE).ln()]);
    let logarithms: Vec<_> = logarithms.collect();
    let lines = STEPS as usize..=(0.5 * STEPS * points as f64) as usize;
    let density = |k: usize| interpolate(&logarithms, (k as f64 * step).ln()).exp();
    lines.map(density).sum::<f64>() * step / (MICRO * MICRO)
}

/// Heights of a place before a test, and lost until a stage of it, over the part that both traces have.
struct Stage {
    /// Distance of its first point from the first point of the trace before.
    start: Length,
    before: Profile,
    lost: Vec<f64>,
}

fn stage_of(before: &Profile, after: &Profile, spacing: Length) -> Result<Stage, Fault> {
    let found = relocate(before, after, Bounds::default())?;
    // The filter of the relocation would act in addition to the filter of whoever evaluates the flank.
    let [start, after] = found.as_measured(before, after)?;
    let first = (found.start / before.spacing()).ceil();
    let first = before.spacing() * first;
    let before = respaced(&start, spacing)?;
    let after = respaced(&after, spacing)?;
    let both = before.heights().iter().zip(after.heights());
    Ok(Stage {
        start: first,
        lost: both.map(|(before, after)| before - after).collect(),
        before,
    })
}

/// Heights before the test over the part that all `stages` have, and the sum of those lost with `weights`.
fn common(stages: &[Stage], weights: &[f64]) -> Result<(Profile, Vec<f64>), DomainError> {
    let start = |k: usize| stages[k].start.si();
    let by_start = |a: &usize, b: &usize| start(*a).total_cmp(&start(*b));
    let last = &stages[(0..stages.len()).max_by(by_start).unwrap_or_default()];
    let dx = last.before.spacing().si();
    // Points of a stage before the common part, seldom a whole number of them.
    let skipped = |stage: &Stage| (last.start.si() - stage.start.si()) / dx;
    let has = |stage: &Stage| (stage.lost.len() as f64 - skipped(stage)).floor() as usize;
    let n = stages.iter().map(has).min().unwrap_or_default();
    let rule = "must be two at least";
    let name = "points that all stages of a trace have";
    DomainError::require(n > 1, name, n as f64, "-", rule)?;
    let before = last.before.heights()[..n].to_vec();
    let before = Profile::new(last.before.spacing(), before)?;
    let mut lost = vec![0.0; n];
    for (stage, weight) in stages.iter().zip(weights) {
        let first = skipped(stage);
        let (whole, part) = (first.floor() as usize, first.fract());
        let next = |i: usize| stage.lost[(whole + i + 1).min(stage.lost.len() - 1)];
        for (i, sum) in lost.iter_mut().enumerate() {
            let here = stage.lost[whole + i];
            *sum += weight * (here + part * (next(i) - here));
        }
    }
    Ok((before, lost))
}

/// First of `seam` points at which `tail` and `head` differ least.
fn least_seam(tail: &[f64], head: &[f64], seam: usize) -> usize {
    let squares: Vec<f64> = tail
        .iter()
        .zip(head)
        .map(|(a, b)| (a - b).powi(2))
        .collect();
    let sums = squares.windows(seam).map(|part| part.iter().sum::<f64>());
    let least = sums.enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b));
    least.map_or(0, |(first, _)| first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{SelfAffine, truncated};

    #[test]
    fn a_trace_of_pieces_follows_its_source_and_uses_no_place_twice() {
        let trace = |seed| {
            let recipe = SelfAffine {
                points: 2400 + 100 * seed as usize,
                spacing: Length::from_si(0.5e-6),
                rq: Length::from_si(0.3e-6),
                hurst: 0.8,
                roll_off: Length::from_si(50e-6),
                short_cut: Length::from_si(5e-6),
                seed,
            };
            truncated(&recipe.generate().unwrap(), 0.3).unwrap().0
        };
        let source = Pieces::to(&trace(1), &[trace(2)]).unwrap();
        let overlap = source.count(OVERLAP);
        let all: usize = source.traces.iter().map(|z| z.len() - overlap).sum();
        let made = source.generate(3 * all, 1).unwrap();
        assert_eq!(made, source.generate(3 * all, 1).unwrap());
        assert_ne!(made, source.generate(3 * all, 2).unwrap());
        let heights = source.joined(&made.pieces, &source.traces);
        let mut used: Vec<Vec<i32>> = source.traces.iter().map(|z| vec![0; z.len()]).collect();
        let mut at = 0;
        for piece in &made.pieces {
            let range = piece.first..piece.first + piece.points;
            assert!(
                (300 - 2 * overlap..=600 + 2 * overlap).contains(&piece.points),
                "{piece:?}"
            );
            for count in &mut used[piece.trace][range.clone()] {
                *count += 1;
            }
            let inner = piece.points - overlap;
            let taken = &source.traces[piece.trace][range][..inner];
            assert_eq!(taken, &heights[at..at + inner]);
            at += piece.points;
        }
        // Three rounds, but for moved ends; the last piece may be left over.
        for count in used.concat() {
            assert!((0..=6).contains(&count), "{count}");
        }
        let thrice = used.concat().iter().filter(|count| **count == 3).count();
        assert!(thrice > all / 2, "{thrice} of {all}");
    }
}
