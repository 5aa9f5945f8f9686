//! Flow factor of patches over the gap, and the gap that their inlet supplies with oil.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | H | gap between the mean planes of both flanks | m |
//! | σ_d | standard deviation of the flattened roughness | m |
//! | K^⅓ | smooth gap with the same flow | m |
//! | φ_x | K/H³ | - |
//! | h_g | central gap of smooth flanks | m |
//! | h̄ | gap between the mean planes that the inlet supplies | m |
//! | Ψ | h̄/h_g | - |
//!
//! The table holds K^⅓/σ_d over H/σ_d: it rises with H whatever the roughness, about linearly both at the percolation threshold and
//! in a wide gap. Patches that lie side by side along the lead have the same fall of the pressure, so that their flows add up.

use std::num::NonZeroUsize;
use std::sync::Arc;

use asperity_core::numerics::{NodeInterval, find_root, gauss_legendre};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::RegimeError;
use crate::patch::{Patch, PatchSpectrum};

/// Nodes over the percolation threshold, in standard deviations.
const NODES: [f64; 12] = [0.1, 0.2, 0.35, 0.55, 0.8, 1.1, 1.5, 2.0, 2.7, 3.6, 4.8, 6.2];
/// Gap over σ_d from which on the expansion holds.
const WIDE: f64 = 8.0;
/// Panels and points in each of the integral over the inlet.
const PANELS: (usize, NonZeroUsize) = (4, NonZeroUsize::new(20).unwrap());

/// Range of ln h̄ below the smooth film in which its gap is searched.
const LOWEST: f64 = 40.0;

/// K^⅓/σ_d over H/σ_d of patches side by side.
#[derive(Debug, Clone, PartialEq)]
struct FlowCurve {
    /// Gap, smooth gap of the same flow and its slope, in standard deviations; the first at the percolation threshold.
    nodes: Vec<[f64; 3]>,
    /// Coefficients of the expansion in σ_d/H: of the second order, and of the third, which joins it to the last node.
    wide: [f64; 2],
}

/// Largest gap of a node over the gap of the last one: nodes do not crowd where the expansion begins.
const LAST_NODE: f64 = 0.9;
/// Width of the bracket at which ln of the gap supplied ends.
const ROOT_TOLERANCE: f64 = 1e-13;
/// Relative step of the difference quotient of the expansion.
const SLOPE_STEP: f64 = 1e-4;

impl FlowCurve {
    fn new(patches: &[Patch], sigma: f64) -> Result<Self, RegimeError> {
        let threshold = patches
            .iter()
            .map(|patch| patch.percolation_gap().si() / sigma);
        let threshold = threshold.fold(f64::INFINITY, f64::min);
        let mut gaps: Vec<f64> = NODES.iter().map(|node| threshold + node).collect();
        gaps.retain(|gap| *gap < LAST_NODE * WIDE);
        gaps.push(WIDE.max(threshold + 1.0));
        let mut points = vec![[threshold, 0.0]];
        for gap in gaps {
            let mut cubes = 0.0;
            for patch in patches {
                let smooth = patch.hydraulic_gap(Length::from_si(gap * sigma))?;
                cubes += (smooth / Length::from_si(sigma)).powi(3);
            }
            points.push([gap, (cubes / patches.len() as f64).cbrt()]);
        }
        Ok(Self::through(&points, second_order(patches)))
    }

    fn through(points: &[[f64; 2]], second: f64) -> Self {
        let [gap, smooth] = points[points.len() - 1];
        let factor = (smooth / gap).powi(3);
        let wide = [second, (factor - 1.0) * gap.powi(3) - second * gap];
        let mut nodes = with_slopes(points);
        if let Some([gap, _, slope]) = nodes.last_mut() {
            // Both sides of the last node have the slope of the expansion.
            let step = SLOPE_STEP * *gap;
            let [above, below] = [1.0, -1.0].map(|side| Self::widely(wide, *gap + side * step));
            *slope = (above - below) / (2.0 * step);
        }
        Self { nodes, wide }
    }

    fn widely([second, third]: [f64; 2], gap: f64) -> f64 {
        gap * (1.0 + (second + third / gap) / (gap * gap)).cbrt()
    }

    /// K^⅓/σ_d at H/σ_d.
    fn at(&self, gap: f64) -> f64 {
        if gap <= self.nodes[0][0] {
            return 0.0;
        }
        let interval = NodeInterval::from_nodes(&self.nodes, |node| node[0], gap);
        if interval.part > 1.0 {
            return Self::widely(self.wide, gap);
        }
        let [[x0, y0, m0], [x1, y1, m1]] = [interval.low, interval.high].map(|k| self.nodes[k]);
        let (width, t) = (x1 - x0, interval.part);
        let s = 1.0 - t;
        s * s * ((1.0 + 2.0 * t) * y0 + t * width * m0)
            + t * t * ((1.0 + 2.0 * s) * y1 - s * width * m1)
    }
}

/// Coefficient of (σ_d/H)² in the flow factor of a wide gap.
///
/// ```text
/// φ_x = 1 − 3 (3 ⟨k_x²/k²⟩ − 1) (σ_d/H)² + c (σ_d/H)³                       [Flow-expansion]
/// ```
///
/// The mean is over the waves of the roughness. The last term, which skewed heights have, joins it to the last solution.
fn second_order(patches: &[Patch]) -> f64 {
    cite!("Flow-expansion");
    let (mut weighted, mut variance) = (0.0, 0.0);
    for patch in patches {
        let square = patch.rms().si().powi(2);
        weighted += square * PatchSpectrum::new(patch).mean_square_cosine();
        variance += square;
    }
    3.0 * (1.0 - 3.0 * weighted / variance)
}

/// Points with slopes between which cubic curves rise as the points do.
fn with_slopes(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    let chord = |k: usize| (points[k + 1][1] - points[k][1]) / (points[k + 1][0] - points[k][0]);
    let last = points.len() - 1;
    let slope = |k: usize| match k {
        0 => chord(0),
        _ if k == last => chord(last - 1),
        _ => {
            let (below, above) = (chord(k - 1), chord(k));
            let [w0, w1] = [
                points[k][0] - points[k - 1][0],
                points[k + 1][0] - points[k][0],
            ];
            let (a, b) = (2.0 * w1 + w0, w1 + 2.0 * w0);
            if below * above > 0.0 {
                (a + b) / (a / below + b / above)
            } else {
                0.0
            }
        }
    };
    (0..=last)
        .map(|k| [points[k][0], points[k][1], slope(k)])
        .collect()
}

/// Flow factor over the gap of patches with a shape, for any standard deviation.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FlowTable, Patch};
/// // Ridges across the flow, 8 heights to the wave: 1/⟨(h/H)⁻³⟩.
/// let um = |value: f64| Length::from_si(value * 1e-6);
/// let z = |i: usize| 1e-7 * ((i % 8) as f64 * std::f64::consts::TAU / 8.0).sin();
/// let heights: Vec<f64> = (0..32).map(z).collect();
/// let mean = (0..8).map(|i| (1.0 - z(i) / 0.3e-6).powi(-3)).sum::<f64>() / 8.0;
/// let patch = Patch::new(heights, [8, 4], [um(1.0), um(1.0)])?;
/// let (sigma, table) = (patch.rms(), FlowTable::new(&[patch])?);
/// assert!((table.factor(um(0.3), sigma) * mean - 1.0).abs() < 0.01);
/// assert_eq!(table.factor(um(0.1), sigma), 0.0);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FlowTable {
    /// Curves with their weights, which are one together; none for smooth patches.
    curves: Vec<(Arc<FlowCurve>, f64)>,
}

impl FlowTable {
    /// The table of patches that lie side by side along the lead, each with its repetitions.
    ///
    /// # Errors
    /// When there is no patch, or the flow through one has no solution.
    pub fn new(patches: &[Patch]) -> Result<Self, RegimeError> {
        let number = patches.len();
        let rule = "must be at least one";
        DomainError::require(number > 0, "patches", number as f64, "-", rule)?;
        let squares = patches.iter().map(|patch| patch.rms().si().powi(2));
        let sigma = (squares.sum::<f64>() / number as f64).sqrt();
        let curves = if sigma > 0.0 {
            vec![(Arc::new(FlowCurve::new(patches, sigma)?), 1.0)]
        } else {
            Vec::new()
        };
        Ok(Self { curves })
    }

    /// The table through computed gaps K^⅓/σ_d over H/σ_d, both rising from the percolation gap, with the
    /// coefficient of (σ_d/H)² in a wide gap: a published law of the flow.
    ///
    /// # Errors
    /// When there are fewer than three points, or they do not rise.
    pub fn through(points: &[[f64; 2]], second_order: f64) -> Result<Self, RegimeError> {
        let number = points.len();
        let rises = |pair: &[[f64; 2]]| pair[1][0] > pair[0][0] && pair[1][1] > pair[0][1];
        let fits = number > 2 && points[0][1] >= 0.0 && points.windows(2).all(rises);
        let rule = "must be three at least, and rise";
        DomainError::require(fits, "points of a flow table", number as f64, "-", rule)?;
        let curve = FlowCurve::through(points, second_order);
        Ok(Self {
            curves: vec![(Arc::new(curve), 1.0)],
        })
    }

    /// The table between two others, linear in K^⅓: `part` 0 is the first.
    pub(crate) fn between(first: &Self, second: &Self, part: f64) -> Self {
        let weighted = |table: &Self, weight: f64| {
            let curves = table.curves.clone();
            curves
                .into_iter()
                .map(move |(curve, w)| (curve, w * weight))
        };
        let curves = weighted(first, 1.0 - part).chain(weighted(second, part));
        Self {
            curves: curves.filter(|(_, weight)| *weight > 0.0).collect(),
        }
    }

    /// K^⅓/σ_d at H/σ_d.
    fn smooth_gap(&self, gap: f64) -> f64 {
        self.curves
            .iter()
            .map(|(curve, weight)| weight * curve.at(gap))
            .sum()
    }

    /// Flow at a gap between the mean planes over the flow of the smooth gap; zero below the percolation threshold.
    #[must_use]
    pub fn factor(&self, gap: Length, attenuated_rms: Length) -> f64 {
        let sigma = attenuated_rms.si();
        if sigma == 0.0 || self.curves.is_empty() {
            return 1.0;
        }
        let gap = gap.si() / sigma;
        (self.smooth_gap(gap) / gap).powi(3)
    }

    /// Gap between the mean planes over the gap of smooth flanks with the same flow.
    ///
    /// ```text
    /// ∫ (h − h̄)/(h³ φ_x(h)) ds = ∫ (h − h_g)/h³ ds,  h = h̄ + k s^(3/2), h_g + k s^(3/2),
    /// Ψ = h̄/h_g                                                    [Rough-inlet-computed]
    /// ```
    ///
    /// The sides of the integrals are Grubin's inlet: the oil's reduced pressure rises to the same value.
    ///
    /// # Errors
    /// When σ_d is negative or the gap not positive.
    pub fn inlet_factor(
        &self,
        attenuated_rms: Length,
        smooth_gap: Length,
    ) -> Result<f64, RegimeError> {
        cite!("Rough-inlet-computed");
        let sigma = DomainError::non_negative("attenuated roughness", attenuated_rms)?;
        let gap = DomainError::positive("smooth gap", smooth_gap)?;
        if sigma == 0.0 || self.curves.is_empty() {
            return Ok(1.0);
        }
        let threshold = self.curves.iter().map(|(curve, _)| curve.nodes[0][0]);
        let threshold = threshold.fold(f64::INFINITY, f64::min).max(0.0);
        let target = (gap / sigma).ln();
        // Over the logarithm of the gap above the threshold one.
        let excess = |over: f64| self.smooth_film(threshold + over.exp()).ln() - target;
        let mut low = target;
        while low > target - LOWEST && excess(low) > 0.0 {
            low -= 1.0;
        }
        let mut high = low + 1.0;
        while excess(high) < 0.0 {
            high += 1.0;
        }
        // Patches that percolate at zero gap pass more than the thinnest film needs.
        let over = if excess(low) > 0.0 {
            low
        } else {
            let root = find_root(excess, low, high, ROOT_TOLERANCE);
            root.map_err(|error| RegimeError::no_inlet(&error))?.value
        };
        Ok((threshold + over.exp()) * sigma / gap)
    }

    /// h_g/σ_d at h̄/σ_d. With h = h̄ (1 + u³) the integral is h̄^(5/3) ∫ 3 u⁴/K du, for any k.
    fn smooth_film(&self, mean: f64) -> f64 {
        let rough = inlet_integral(|u| self.smooth_gap(mean * (1.0 + u)) / mean);
        let smooth = inlet_integral(|u| 1.0 + u);
        mean * (smooth / rough).powf(0.75)
    }
}

/// ∫ 3 u⁴/k(u³)³ du from 0 to ∞.
fn inlet_integral(smooth_gap: impl Fn(f64) -> f64) -> f64 {
    let (panels, points) = PANELS;
    let rule = gauss_legendre(points);
    let width = 1.0 / panels as f64;
    let mut sum = 0.0;
    for panel in 0..panels {
        for (x, weight) in rule.iter() {
            let t = width * (panel as f64 + 0.5 * (x + 1.0));
            let u = t / (1.0 - t);
            let slope = (1.0 - t) * (1.0 - t);
            sum += 0.5 * width * weight * 3.0 * u.powi(4) / (smooth_gap(u.powi(3)).powi(3) * slope);
        }
    }
    sum
}
