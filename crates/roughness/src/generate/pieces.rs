//! Traces made of pieces of measured ones, which keep ridges, dales and marks as they were measured.
//!
//! Source: Efros and Freeman 2001 (image quilting), in one dimension and with blended seams at the least difference.
//!
//! A straight line and the waves longer than two pieces are removed from every trace. What is left is divided into pieces, and as many as the
//! new trace needs are drawn. They follow each other in the order in which they fit best, each end moved by up to an overlap. No
//! piece is drawn twice before all were. The long waves are a Gaussian profile with the spectrum that was removed. The traces given
//! therefore decide all shorter waves and rare dales.
//!
//! Of pairs of traces before and after a test, the second relocated on the first, flanks are made in any state between: pieces are drawn
//! as pairs, and a part of the heights that were lost is taken off. Relocation leaves no waves shorter than 2.5 µm.
//!
//! A trace of n points costs at most 16 · 441 m sums over an overlap for its m pieces, whatever the length of the traces given.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z, z_c | last heights of the trace, heights before a drawn piece | m |
//! | z_b, z_a | heights before and after a test | m |
//! | s | state | - |

use asperity_core::numerics::good_fft_length;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Fault, Profile, cite};
use serde::{Deserialize, Serialize};

use super::achieved::Generated;
use super::fitted::{MICRO, bands, gaussian, levelled, mean_square, parent_of};
use super::random::Random;
use super::scaling::check_points;
use crate::error::RoughnessError;
use crate::gaussian_filter::{Ends, mean_line, transmission};
use crate::relocation::{Bounds, relocate};
use crate::resampling::respaced;
use crate::spectral::power_spectrum;

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

/// Measured traces to take pieces of.
#[derive(Debug, Clone)]
pub struct Pieces {
    spacing: Length,
    /// Points of the first trace.
    points: usize,
    /// Heights without long waves \[m\] of each trace.
    traces: Vec<Vec<f64>>,
    /// Heights \[m\] that each trace lost in a test; none without traces after it.
    lost: Vec<Vec<f64>>,
    /// Spectrum of the long waves, as [`Fitted::spectrum`](super::Fitted::spectrum).
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
    /// let made = Pieces::to(&plateaus, &[])?.generate(4096, 1, 0.0)?;
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
        let (mut traces, mut spectra, mut square) = (Vec::new(), Vec::new(), 0.0);
        for level in levelled(first, others)? {
            if level.length() < LONG_WAVES {
                return Err(RoughnessError::TooShort {
                    length: level.length(),
                    needed: LONG_WAVES,
                    purpose: "a trace to take pieces of",
                });
            }
            let line = mean_line(&level, LONG_WAVES, Ends::Reg1)?;
            square += mean_square(&line);
            spectra.push(power_spectrum(&level)?);
            let short = level.heights().iter().zip(&line).map(|(z, w)| z - w);
            traces.push(short.collect::<Vec<f64>>());
        }
        let mut spectrum = bands(&spectra);
        for [frequency, density] in &mut spectrum {
            let wavelength = Length::from_si(1.0 / (*frequency * MICRO));
            *density *= transmission(wavelength, LONG_WAVES)?.powi(2);
        }
        Ok(Self {
            spacing,
            points: first.len(),
            longest: traces.iter().map(Vec::len).max().unwrap_or_default(),
            square: square / traces.len() as f64,
            traces,
            lost: Vec::new(),
            spectrum,
        })
    }

    /// Prepares `first` and `others`, pairs of traces before and after a test, of one finish; each second trace is relocated on its
    /// first.
    ///
    /// # Errors
    /// As [`to`](Self::to), and when a pair is not of one place.
    pub fn of_pairs(first: &[Profile; 2], others: &[[Profile; 2]]) -> Result<Self, Fault> {
        let spacing = first[0].spacing();
        let (mut traces, mut lost) = (Vec::new(), Vec::new());
        for [before, after] in std::iter::once(first).chain(others) {
            let found = relocate(before, after, Bounds::default())?;
            let before = respaced(&found.before, spacing)?;
            let after = respaced(&found.after, spacing)?;
            let both = before.heights().iter().zip(after.heights());
            lost.push(both.map(|(before, after)| before - after).collect());
            traces.push(before);
        }
        Ok(Self {
            points: first[0].len(),
            lost,
            ..Self::to(&traces[0], &traces[1..])?
        })
    }

    /// Points of the first trace.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// A trace of `points` points in a `state` from before a test, 0, to after it, 1; other than 0 only of pairs.
    ///
    /// # Errors
    /// When the number of points or the state is outside its domain.
    ///
    /// ```text
    /// z = z_b − s (z_b − z_a)                                                                   [Pieces-2]
    /// ```
    pub fn generate(&self, points: usize, seed: u64, state: f64) -> Result<Pieced, DomainError> {
        cite!("Pieces-2");
        let last = if self.lost.is_empty() { 0.0 } else { 1.0 };
        let rule = "must be from 0 to 1, and 0 without traces after a test";
        DomainError::require((0.0..=last).contains(&state), "state", state, "-", rule)?;
        let n = check_points(points)?;
        let mut random = Random::new(seed);
        let pieces = self.drawn(n, &mut random);
        let mut heights = self.joined(&pieces, &self.traces);
        heights.truncate(n);
        if state > 0.0 {
            let lost = self.joined(&pieces, &self.lost);
            (heights.iter_mut().zip(lost)).for_each(|(z, lost)| *z -= state * lost);
        }
        // A flat profile has no long waves.
        if self.square > f64::EPSILON * mean_square(&heights) {
            let parent = good_fft_length(parent_of(n.max(self.longest))?);
            let waves = (self.spacing, self.longest);
            let long = gaussian(&self.spectrum, waves, self.square, parent, &mut random)?;
            heights.iter_mut().zip(long).for_each(|(z, w)| *z += w);
        }
        Ok(Pieced {
            generated: Generated::new(Profile::new(self.spacing, heights)?),
            pieces,
        })
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
        let made = source.generate(3 * all, 1, 0.0).unwrap();
        assert_eq!(made, source.generate(3 * all, 1, 0.0).unwrap());
        assert_ne!(made, source.generate(3 * all, 2, 0.0).unwrap());
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
