//! Both traces as they are compared: without noise, and with heights between their points.

use asperity_core::Profile;
use asperity_core::numerics::mean;
use asperity_core::quantity::Length;

use crate::error::RoughnessError;
use crate::gaussian_filter::{Ends, mean_line};
use crate::preparation::{LAMBDA_C, Preparation};

/// Least noise cut-off in spacings: between its points a cubic line follows the waves that the filter leaves.
const CUTOFF_SPACINGS: f64 = 3.0;

/// Longest end without a match, in lengths of the trace.
const LONGEST_END: f64 = 0.125;

/// Noise cut-off of two traces: the usual one, longer if a trace is too coarse for it.
pub(super) fn noise_cutoff(before: &Profile, after: &Profile) -> Length {
    let usual = Preparation::default().lambda_s.map_or(0.0, Length::si);
    let coarser = before.spacing().si().max(after.spacing().si());
    Length::from_si(usual.max(CUTOFF_SPACINGS * coarser))
}

/// Weights of four points in the cubic through them, `u` spacings behind the second.
fn cubic(u: f64) -> [f64; 4] {
    [
        -u * (u - 1.0) * (u - 2.0) / 6.0,
        (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0,
        -(u + 1.0) * u * (u - 2.0) / 2.0,
        (u + 1.0) * u * (u - 1.0) / 6.0,
    ]
}

/// Height of `heights` at `place` in spacings, by the cubic through four points; at the ends of the trace by its first or last four.
pub(super) fn height_at(heights: &[f64], place: f64) -> f64 {
    let first = (place.floor() - 1.0).clamp(0.0, heights.len() as f64 - 4.0);
    let weights = cubic(place - first - 1.0);
    let four = heights.iter().skip(first as usize).zip(weights);
    four.map(|(z, weight)| weight * z).sum()
}

/// A trace without noise.
pub(super) struct Trace {
    /// Distance of the points \[m\].
    pub dx: f64,
    /// Mean height \[m\].
    pub middle: f64,
    /// Heights about their mean \[m\].
    pub heights: Vec<f64>,
    /// Heights above the mean line of λ_c \[m\].
    pub rough: Vec<f64>,
}

impl Trace {
    pub(super) fn new(profile: &Profile, noise_cutoff: Length) -> Result<Self, RoughnessError> {
        let smooth = mean_line(profile, noise_cutoff, Ends::Reg1)?;
        let middle = mean(smooth.iter().copied());
        let heights: Vec<f64> = smooth.iter().map(|z| z - middle).collect();
        let smooth = Profile::new(profile.spacing(), heights.clone())?;
        let line = mean_line(&smooth, LAMBDA_C, Ends::Reg1)?;
        Ok(Self {
            dx: profile.spacing().si(),
            middle,
            rough: heights.iter().zip(line).map(|(z, w)| z - w).collect(),
            heights,
        })
    }

    /// Length \[m\].
    pub(super) fn length(&self) -> f64 {
        (self.heights.len() - 1) as f64 * self.dx
    }

    /// Height, slope and height above the mean line at `x` \[m\]; `None` less than two spacings from an end.
    pub(super) fn at(&self, x: f64) -> Option<[f64; 3]> {
        let place = x / self.dx;
        let whole = place.floor();
        let first = (whole >= 1.0).then(|| whole as usize - 1)?;
        let z = self.heights.get(first..first + 4)?;
        let rough = self.rough.get(first..first + 4)?;
        let u = place - whole;
        let value = cubic(u);
        let slope = [
            -(3.0 * u * u - 6.0 * u + 2.0) / 6.0,
            (3.0 * u * u - 4.0 * u - 1.0) / 2.0,
            -(3.0 * u * u - 2.0 * u - 2.0) / 2.0,
            (3.0 * u * u - 1.0) / 6.0,
        ];
        let sum = |weights: &[f64; 4], z: &[f64]| -> f64 {
            weights.iter().zip(z).map(|(weight, z)| weight * z).sum()
        };
        Some([sum(&value, z), sum(&slope, z) / self.dx, sum(&value, rough)])
    }

    /// Heights above the mean line, but at most their median, as a match of valleys reads them, and the place of the first \[m\]: at the
    /// ends the mean line follows long waves, which are not alike at the ends of two traces of one place.
    pub(super) fn valleys(&self) -> (Vec<f64>, f64) {
        let end = (0.5 * LAMBDA_C.si()).min(LONGEST_END * self.length());
        let left_out = (end / self.dx) as usize;
        let rough = &self.rough[left_out..self.rough.len() - left_out];
        let mut sorted = rough.to_vec();
        let middle = sorted.len() / 2;
        let (_, level, _) = sorted.select_nth_unstable_by(middle, f64::total_cmp);
        let valleys = rough.iter().map(|z| z.min(*level)).collect();
        (valleys, left_out as f64 * self.dx)
    }
}
