//! Shift, stretch, height and tilt of the second trace by robust least squares over the valleys.

use asperity_core::cancel::checkpoint;
use asperity_core::numerics::{Cholesky, Z_75};
use asperity_core::{Code, Fault, cite};
use std::ops::Range;

use super::noise::Noise;
use super::search::Match;
use super::traces::Trace;
use crate::error::RoughnessError;

/// Tukey's constant, in standard deviations: 95 % efficiency on normal residuals.
const TUKEY: f64 = 4.685;
/// Residuals up to this number of standard deviations are noise.
const NOISE: f64 = 3.0;
/// Least standard deviation \[m\]: rounding errors of equal traces are not noise.
const LEAST_DEVIATION: f64 = 1e-12;
/// Share of the points in a slice of the valleys, and number of slices that are matched at most.
const SLICE: f64 = 0.05;
const MOST_SLICES: usize = 10;
/// A slice is spared if its height differs by at most this number of standard errors: noise exceeds it in one of eight slices, the
/// most that are compared, for one trace in twenty.
const SPARED: f64 = 2.73;
/// The lowest two slices are worn if they differ by more than this number of standard errors.
const WORN: f64 = 4.0;
const WORN_VALLEYS: &str = "too few valleys are left for a match: the lowest twentieth of the points lost another height than the next one";
/// Numbers of a place, of which those from the height on are linear.
pub(super) const MIDDLE: usize = 0;
pub(super) const STRETCH: usize = 1;
pub(super) const HEIGHT: usize = 2;
pub(super) const TILT: usize = 3;
pub(super) const BOW: usize = 4;
const NUMBERS: usize = 5;
/// Most steps of a robust mean.
const MEAN_STEPS: usize = 20;
/// Most steps of the least squares, steps with a scale of their own, and steps of height and tilt in each.
const MAX_STEPS: usize = 60;
const FREE_STEPS: usize = 5;
const LINEAR_STEPS: usize = 10;
/// Change of the place at which they end, in spacings.
const SETTLED: f64 = 0.01;

/// Place of the second trace on the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FitPlace {
    /// Position of the middle of the second trace on the first \[m\].
    pub middle: f64,
    /// Stretch times half the length of the second trace \[m\].
    pub stretch: f64,
    /// Height to add to the second trace in its middle \[m\].
    pub height: f64,
    /// Height to add at its end, in addition \[m\].
    pub tilt: f64,
    /// Height to add at both ends, in addition, as a parabola \[m\].
    pub bow: f64,
}

impl FitPlace {
    /// Height to add to the second trace at a position from −1 to 1 \[m\].
    pub(super) fn added(&self, along: f64) -> f64 {
        self.height + (self.tilt + self.bow * along) * along
    }
}

/// Both traces at one place, at the points of the second.
pub(super) struct RelocationFit {
    /// The place.
    pub place: FitPlace,
    /// Half the length of the second trace \[m\].
    pub half: f64,
    /// Position along the second trace, from −1 to 1.
    pub along: Vec<f64>,
    /// First trace \[m\].
    pub before: Vec<f64>,
    /// Mean slope of both traces.
    slopes: Vec<f64>,
    /// Mean height of both above their mean lines \[m\], by which valleys are known.
    pub level: Vec<f64>,
    /// Residuals: height lost by the second trace \[m\].
    pub lost: Vec<f64>,
    /// Weights in the valleys, zero elsewhere.
    pub weights: Vec<f64>,
    /// Normal matrix with products of the slopes of both traces: noise, which would enlarge the squares of one, has none in the mean.
    normal: Cholesky,
    /// Share of the points that are spared valleys.
    share: f64,
    /// Numbers of the place that were fitted.
    free: usize,
    /// Noise.
    pub noise: Noise,
    /// Difference of the upper from the lower valleys, at least its standard error \[m\].
    pub uneven: f64,
}

impl RelocationFit {
    /// ```text
    /// min over s, e, h, t, b of Σ_valleys ρ(z_b(s + (1 + e) x) − z_a(x) − h − t x − b x²)           [Relocation-2]
    /// ```
    ///
    /// b is 0 unless the form may have changed by a parabola.
    ///
    /// ρ is Tukey's biweight with the scale of the shortest half. The valleys are the lowest points, from a tenth of all
    /// upwards as long as the next twentieth has the same height, at most half.
    pub(super) fn new(
        [before, after]: [&Trace; 2],
        start: Match,
        has_bow: bool,
    ) -> Result<Self, Fault> {
        cite!("Relocation-2");
        let half = 0.5 * after.length();
        let mut place = FitPlace {
            middle: start.shift + half,
            stretch: start.stretch * half,
            height: 0.0,
            tilt: 0.0,
            bow: 0.0,
        };
        let free = if has_bow { NUMBERS } else { BOW };
        let mut share = 0.4;
        let mut fit = Self::settled([before, after], place, share, free)?;
        for _ in 0..2 {
            place = fit.place;
            share = fit.spared().share;
            fit = Self::settled([before, after], place, share, free)?;
        }
        let spared = fit.spared();
        fit.uneven = spared.uneven;
        if spared.is_worn {
            Err(Fault::new(Code::E143, WORN_VALLEYS))
        } else {
            Ok(fit)
        }
    }

    /// The fit of the first `free` numbers of the place to the valleys of a share of the points.
    fn settled(
        [before, after]: [&Trace; 2],
        mut place: FitPlace,
        share: f64,
        free: usize,
    ) -> Result<Self, RoughnessError> {
        let (mut chosen, mut change) = (None, f64::INFINITY);
        for step in 0..MAX_STEPS {
            checkpoint()?;
            let mut points = MatchPoints::at(before, after, place)?;
            // Valleys and a scale that follow every change of the place would change it in turn.
            if step < FREE_STEPS {
                let is_valley = points.valleys(share);
                let (middle, scale) = points.scale(&is_valley);
                points.moved(&mut place, [0.0, 0.0, middle, 0.0, 0.0]);
                let mut of_trace = vec![false; after.heights.len()];
                of_trace[points.first..points.first + is_valley.len()].copy_from_slice(&is_valley);
                chosen = Some((of_trace, scale));
            }
            let Some((is_valley, scale)) = &chosen else {
                break;
            };
            let is_valley = &is_valley[points.first..points.first + points.lost.len()];
            // Height, tilt and bow are linear, and settle first.
            for _ in 0..LINEAR_STEPS {
                let weights = points.weights(is_valley, *scale);
                points.moved(&mut place, points.step(&weights, HEIGHT..free)?);
            }
            let weights = points.weights(is_valley, *scale);
            let moved = points.step(&weights, 0..free)?;
            points.moved(&mut place, moved);
            change = (moved[0].abs() + moved[1].abs()) / before.dx;
            if step >= FREE_STEPS && change < SETTLED {
                return points.done(place, weights, *scale, share, free, after.dx);
            }
        }
        Err(RoughnessError::NotConverged {
            what: "the relocation of the trace",
            iterations: MAX_STEPS,
            residual: change,
        })
    }

    /// Change of Σ b_i r_i with each residual: of the sum itself and through the place fitted.
    pub(super) fn influence(&self, b: &[f64]) -> Vec<f64> {
        let mut by_place = [0.0; NUMBERS];
        for (i, b) in b.iter().enumerate() {
            let row = self.row(i);
            for (sum, of) in by_place.iter_mut().zip(row) {
                *sum += b * of;
            }
        }
        self.normal.solve(&mut by_place);
        let of = |(i, b): (usize, &f64)| {
            let row = self.row(i);
            let through: f64 = row.iter().zip(&by_place).map(|(j, of)| j * of).sum();
            b - through * self.weights[i]
        };
        b.iter().enumerate().map(of).collect()
    }

    /// Whether a parabola was fitted.
    pub(super) fn has_bow(&self) -> bool {
        self.free > BOW
    }

    /// Standard deviation of a number of the place.
    pub(super) fn deviation_of_place(&self, number: usize) -> f64 {
        let mut direction = [0.0; NUMBERS];
        direction[number] = 1.0;
        self.normal.solve(&mut direction);
        let each = |i: usize| -> f64 {
            let row = self.row(i);
            let sum: f64 = row.iter().zip(&direction).map(|(j, d)| j * d).sum();
            sum * self.weights[i]
        };
        let a: Vec<f64> = (0..self.lost.len()).map(each).collect();
        self.noise.variance(&a).sqrt()
    }

    /// Share of the points in the valleys that were matched.
    pub(super) fn matched(&self) -> f64 {
        self.share
    }

    /// Standard deviation of the height by the choice of the valleys: noise of the trace that chooses them is below zero in them \[m\].
    ///
    /// ```text
    /// s = σ² f/(2 q √3)                                                                          [Relocation-6]
    /// ```
    ///
    /// σ² is the variance of the difference of both traces, f the density of the heights at the highest of the valleys, and q the share
    /// of the valleys. Both traces choose with equal weights. If all noise is in one of them, the mean difference in the valleys is off by
    /// √3 s, to either side.
    pub(super) fn choice(&self) -> f64 {
        cite!("Relocation-6");
        const STEP: f64 = 0.05;
        let at = self.levels();
        let [low, high] = [self.share - STEP, self.share + STEP];
        let width = at(high) - at(low.max(0.0));
        let density = (high - low.max(0.0)) / width.max(LEAST_DEVIATION);
        let bound = 0.5 * self.noise.deviation().powi(2) * density / self.share;
        bound / 3.0_f64.sqrt()
    }

    /// Height that a share of the points does not exceed \[m\].
    fn levels(&self) -> impl Fn(f64) -> f64 {
        let mut sorted = self.level.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        move |share| sorted[(share * (sorted.len() - 1) as f64) as usize]
    }

    /// Height of the highest of the valleys \[m\].
    pub(super) fn highest_valley(&self) -> f64 {
        self.levels()(self.share)
    }

    /// Change of a residual with each number of the place, zero with one that was not fitted.
    fn row(&self, i: usize) -> [f64; NUMBERS] {
        let mut row = row(self.slopes[i], self.along[i]);
        row[self.free..].fill(0.0);
        row
    }

    /// The valleys from the lowest slice upwards, as long as the next has the same height.
    fn spared(&self) -> Spared {
        let n = self.lost.len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_unstable_by(|i, j| self.level[*i].total_cmp(&self.level[*j]));
        let size = (SLICE * n as f64) as usize;
        let slice = |k: usize| {
            let points = &order[k * size..(k + 1) * size];
            let values: Vec<f64> = points.iter().map(|i| self.lost[*i]).collect();
            let (location, weights) = location(&values);
            let mut a = vec![0.0; n];
            let sum: f64 = weights.iter().sum();
            for (i, weight) in points.iter().zip(&weights) {
                a[*i] = weight / sum;
            }
            (location, self.noise.variance(&a))
        };
        let differs = |a: (f64, f64), b: (f64, f64), most: f64| {
            (a.0 - b.0).abs() > most * (a.1 + b.1).sqrt() + LEAST_DEVIATION
        };
        let mut slices = vec![slice(0), slice(1)];
        for k in slices.len()..MOST_SLICES {
            let next = slice(k);
            if differs(next, weighted(&slices), SPARED) {
                // The slice before may be worn in part.
                slices.truncate((slices.len() - 1).max(2));
                break;
            }
            slices.push(next);
        }
        let (deep, high) = slices.split_at(slices.len().div_ceil(2));
        let [deep, high] = [deep, high].map(weighted);
        Spared {
            share: SLICE * slices.len() as f64,
            uneven: (deep.0 - high.0).abs().max((deep.1 + high.1).sqrt()),
            is_worn: slices.len() == 2 && differs(slices[0], slices[1], WORN),
        }
    }
}

/// Valleys that wear spared.
struct Spared {
    /// Share of all points.
    share: f64,
    /// Difference of the upper from the lower valleys, at least its standard error \[m\].
    uneven: f64,
    /// Whether the lowest two slices differ, so that even these are worn.
    is_worn: bool,
}

/// Mean of values with their variances, weighted by the inverse variances, and its variance.
fn weighted(values: &[(f64, f64)]) -> (f64, f64) {
    let least = LEAST_DEVIATION * LEAST_DEVIATION;
    let weight = |variance: f64| 1.0 / (variance + least);
    let sum: f64 = values.iter().map(|value| weight(value.1)).sum();
    let mean = values
        .iter()
        .map(|value| weight(value.1) * value.0)
        .sum::<f64>()
        / sum;
    (mean, 1.0 / sum)
}

/// Robust mean of values, and their weights.
fn location(values: &[f64]) -> (f64, Vec<f64>) {
    let (mut middle, deviation) = shortest_half(values);
    let mut weights = Vec::new();
    for _ in 0..MEAN_STEPS {
        weights = values
            .iter()
            .map(|z| biweight(z - middle, deviation))
            .collect();
        let sum: f64 = weights.iter().sum();
        let next = values.iter().zip(&weights).map(|(z, w)| z * w).sum::<f64>() / sum;
        let change = (next - middle).abs();
        middle = next;
        if change < 1e-3 * LEAST_DEVIATION {
            break;
        }
    }
    (middle, weights)
}

fn row(slope: f64, along: f64) -> [f64; NUMBERS] {
    [slope, slope * along, -1.0, -along, -along * along]
}

fn biweight(residual: f64, deviation: f64) -> f64 {
    let relative = residual / (TUKEY * deviation);
    (1.0 - relative * relative).max(0.0).powi(2)
}

/// Middle of the shortest interval with half of the values, and the standard deviation that a normal distribution has with it.
fn shortest_half(values: &[f64]) -> (f64, f64) {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let half = sorted.len() / 2;
    let width = |i: &usize| sorted[i + half] - sorted[*i];
    let shortest = (0..sorted.len() - half).min_by(|i, j| width(i).total_cmp(&width(j)));
    let i = shortest.unwrap_or(0);
    let deviation = 0.5 * width(&i) / Z_75;
    (
        0.5 * (sorted[i] + sorted[i + half]),
        deviation.max(LEAST_DEVIATION),
    )
}

/// Normal matrix, the sum of `of` over all points by point, row and column. Unknowns that are not free stay as they are.
fn normal(
    of: impl Fn(usize, usize, usize) -> f64,
    weights: &[f64],
    free: &Range<usize>,
) -> Result<Cholesky, RoughnessError> {
    let sum = |j: usize, k: usize| {
        if free.contains(&j) && free.contains(&k) {
            (0..weights.len()).map(|i| of(i, j, k)).sum()
        } else {
            f64::from(u8::from(j == k))
        }
    };
    Cholesky::new(NUMBERS, sum, 0.0).ok_or(RoughnessError::TooFewPoints {
        points: weights.iter().filter(|weight| **weight > 0.0).count(),
        needed: NUMBERS,
        purpose: "the match of two traces",
    })
}

/// Both traces at the points of the second that lie on the first.
struct MatchPoints {
    half: f64,
    first: usize,
    along: Vec<f64>,
    before: Vec<f64>,
    slopes: Vec<f64>,
    after_slopes: Vec<f64>,
    level: Vec<f64>,
    lost: Vec<f64>,
}

impl MatchPoints {
    fn at(before: &Trace, after: &Trace, place: FitPlace) -> Result<Self, RoughnessError> {
        const MIN_POINTS: usize = 200;
        let half = 0.5 * after.length();
        let mut points = Self {
            half,
            first: 0,
            along: Vec::new(),
            before: Vec::new(),
            slopes: Vec::new(),
            after_slopes: Vec::new(),
            level: Vec::new(),
            lost: Vec::new(),
        };
        for (i, (z, rough)) in after.heights.iter().zip(&after.rough).enumerate() {
            let along = i as f64 * after.dx / half - 1.0;
            let x = place.middle + (half + place.stretch) * along;
            let on_both = before.at(x).zip(after.at(i as f64 * after.dx));
            let Some(([height, slope, level], [_, after_slope, _])) = on_both else {
                continue;
            };
            if points.along.is_empty() {
                points.first = i;
            }
            points.along.push(along);
            points.before.push(height);
            points.slopes.push(slope);
            points.after_slopes.push(after_slope);
            points.level.push(0.5 * (level + rough));
            points.lost.push(height - z - place.added(along));
        }
        RoughnessError::at_least(points.along.len(), MIN_POINTS, "the overlap of two traces")?;
        Ok(points)
    }

    /// Whether each point is among the lowest `share`.
    fn valleys(&self, share: f64) -> Vec<bool> {
        let mut sorted = self.level.clone();
        let last = ((share * sorted.len() as f64) as usize).min(sorted.len() - 1);
        let (_, level, _) = sorted.select_nth_unstable_by(last, f64::total_cmp);
        let level = *level;
        self.level.iter().map(|z| *z < level).collect()
    }

    /// Middle and standard deviation of the residuals in the valleys.
    fn scale(&self, is_valley: &[bool]) -> (f64, f64) {
        let valleys = self
            .lost
            .iter()
            .zip(is_valley)
            .filter(|(_, is_valley)| **is_valley);
        shortest_half(&valleys.map(|(lost, _)| *lost).collect::<Vec<f64>>())
    }

    fn weights(&self, is_valley: &[bool], deviation: f64) -> Vec<f64> {
        let weight = |(lost, is_valley): (&f64, &bool)| {
            if *is_valley {
                biweight(*lost, deviation)
            } else {
                0.0
            }
        };
        self.lost.iter().zip(is_valley).map(weight).collect()
    }

    /// Change of the place by weighted least squares, of its free numbers only.
    fn step(&self, weights: &[f64], free: Range<usize>) -> Result<[f64; NUMBERS], RoughnessError> {
        let row = |i: usize| row(self.slopes[i], self.along[i]);
        let mut right = [0.0; NUMBERS];
        for (i, weight) in weights.iter().enumerate() {
            let row = row(i);
            for k in free.clone() {
                right[k] -= weight * row[k] * self.lost[i];
            }
        }
        let of = |i: usize, j: usize, k: usize| weights[i] * row(i)[j] * row(i)[k];
        normal(of, weights, &free)?.solve(&mut right);
        Ok(right)
    }

    /// Moves the place; residuals follow height and tilt.
    fn moved(&mut self, place: &mut FitPlace, change: [f64; NUMBERS]) {
        place.middle += change[0];
        place.stretch += change[1];
        place.height += change[2];
        place.tilt += change[3];
        place.bow += change[4];
        for (i, lost) in self.lost.iter_mut().enumerate() {
            let row = row(self.slopes[i], self.along[i]);
            *lost += row.iter().zip(&change).map(|(j, d)| j * d).sum::<f64>();
        }
    }

    fn done(
        self,
        place: FitPlace,
        weights: Vec<f64>,
        scale: f64,
        share: f64,
        free: usize,
        dx: f64,
    ) -> Result<RelocationFit, RoughnessError> {
        let counts = |(lost, weight): (&f64, &f64)| *weight > 0.0 && lost.abs() < NOISE * scale;
        let counts = self.lost.iter().zip(&weights).map(counts);
        let normal = normal(
            |i, j, k| {
                let of = |slopes: &[f64]| row(slopes[i], self.along[i]);
                let [first, second] = [of(&self.slopes), of(&self.after_slopes)];
                0.5 * weights[i] * (first[j] * second[k] + first[k] * second[j])
            },
            &weights,
            &(0..free),
        )?;
        let mean = |(first, second): (&f64, &f64)| 0.5 * (first + second);
        let slopes = self
            .slopes
            .iter()
            .zip(&self.after_slopes)
            .map(mean)
            .collect();
        Ok(RelocationFit {
            noise: Noise::new(&self.lost, &counts.collect::<Vec<bool>>(), dx),
            place,
            half: self.half,
            along: self.along,
            before: self.before,
            slopes,
            level: self.level,
            lost: self.lost,
            weights,
            normal,
            share,
            free,
            uneven: 0.0,
        })
    }
}
