//! Roughness of a window as the inlet of its contact leaves it: how high it is, and where the film's pressure ripples.

use std::ops::Range;
use std::sync::Arc;

use asperity_core::numerics::{GOLDEN_SECTION, Lanes, add_times, vectorised};
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};
use asperity_ehl_regime::{Attenuation, Ripples};

use crate::error::LoadShareError;
use crate::window_gap::middle_height;

/// Parts into which a window is divided by the pressure that flattens it.
const PARTS: usize = 24;
/// Least number of places that are evaluated in a window, at even distances: eight a part.
const PLACES: usize = 8 * PARTS;

/// Points of a window up to `reach` on both sides of its middle.
fn middle(points: usize, reach: usize) -> Range<usize> {
    let aside = (points.saturating_sub(1) / 2).saturating_sub(reach);
    aside..points - aside
}

/// The evaluated places among the points up to `reach` from the middle of a window: an odd number of points apart and as many
/// points from both ends, so that the mirrored window has the same.
fn places(points: usize, reach: usize) -> impl Iterator<Item = usize> + Clone {
    let Range { start, end } = middle(points, reach);
    let points = end - start;
    let stride = match points / PLACES {
        0 => 1,
        stride => stride - (stride + 1) % 2,
    };
    let rest = points.saturating_sub(1) % stride;
    let begin = match rest % 2 {
        0 => rest / 2,
        // One place fewer.
        _ => (rest + stride) / 2,
    };
    (start + begin..end - begin).step_by(stride)
}

/// Distances of `count` places from their middle.
fn distances(count: usize) -> impl Iterator<Item = f64> {
    let middle = 0.5 * (count as f64 - 1.0);
    (0..count).map(move |i| i as f64 - middle)
}

/// Takes the slope from values at even distances.
fn level(values: &mut [f64]) {
    let count = values.len();
    let squares = distances(count).map(|x| x * x).sum::<f64>();
    let products = distances(count).zip(&*values).map(|(x, p)| x * p);
    let slope = if squares > 0.0 {
        products.sum::<f64>() / squares
    } else {
        0.0
    };
    for (p, x) in values.iter_mut().zip(distances(count)) {
        *p -= slope * x;
    }
}

/// Places of a patch for each place of a window of lines.
const OF_PATCH: usize = 4;

/// The evaluated places of a patch, spread evenly over rows and columns: the rows follow each other, the columns by the golden section.
fn places_of_patch(columns: usize, rows: usize) -> impl Iterator<Item = usize> + Clone {
    let count = (OF_PATCH * PLACES).min(columns * rows);
    (0..count).map(move |k| {
        let column = (GOLDEN_SECTION * (k as f64 + 0.5)).fract() * columns as f64;
        k * rows / count * columns + (column as usize).min(columns - 1)
    })
}

/// Flattening of the roughness by the inlet of a contact, with the choices for its windows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flattening {
    /// Flattening of the waves.
    pub attenuation: Attenuation,
    /// Weight of the heights above the mean line in σ_d².
    pub peak_weight: f64,
    /// Distance from the middle of a window up to which its film is: the mean gap is over this length.
    pub reach: Length,
    /// Reduced modulus of the contact, if the pressure of its film ripples.
    pub ripple: Option<Pressure>,
}

impl From<Attenuation> for Flattening {
    /// σ_d of all heights, no mean gap of a part of the window, and no ripple.
    fn from(attenuation: Attenuation) -> Self {
        Self {
            attenuation,
            peak_weight: 0.0,
            reach: Length::from_si(0.0),
            ripple: None,
        }
    }
}

/// A part of a window: its place in the roughness, with the pressure that flattens it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RipplePart {
    /// Share of the length.
    pub length: f64,
    /// Pressure p′ that flattens the roughness, over its mean \[Pa\].
    pub pressure: f64,
    /// Height in the film over the mean line \[m\].
    pub height: f64,
}

/// Roughness of a window in the contact.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowRoughness {
    /// σ_d
    pub deviation: Length,
    /// Mean height of the film's length over the mean line of the trace \[m\].
    pub middle: f64,
    /// Parts from the lowest pressure to the highest; none where the film does not ripple or no pressure flattens the window.
    pub ripple: Vec<RipplePart>,
}

impl WindowRoughness {
    /// A window whose film does not ripple.
    #[must_use]
    pub const fn even(deviation: Length) -> Self {
        Self {
            deviation,
            middle: 0.0,
            ripple: Vec::new(),
        }
    }

    /// Records the equations behind a roughness that is known from before.
    pub fn cite_known(&self) {
        cite!("Venner");
        cite!("Attenuated-trace");
        cite!("Gap-roughness");
        cite!("Window-gap");
        if !self.ripple.is_empty() {
            cite!("Ripple-pressure");
            cite!("Ripple-height");
            cite!("Ripple-parts");
        }
    }

    /// Whether pressure flattens it anywhere.
    pub(crate) fn is_rippled(&self) -> bool {
        self.ripple.iter().any(|part| part.pressure != 0.0)
    }

    /// The window of the sums of `N` flattened heights \[m\], and of the ripples of its film, which reaches `reach` points from
    /// its middle.
    pub(crate) fn new<const N: usize>(
        heights: [&[f64]; N],
        ripples: Option<Ripples<[&[f64]; N]>>,
        reach: f64,
        peak_weight: f64,
    ) -> Self {
        Self {
            deviation: deviation(heights, peak_weight),
            middle: middle_height(heights, reach),
            ripple: ripples.map_or_else(Vec::new, |ripples| {
                ripple(&AtPlaces::new(ripples, rounded(reach)))
            }),
        }
    }
}

/// A flattened patch of both flanks: its deviation, and the places where its ripple is evaluated.
#[derive(Debug, Clone)]
pub struct PatchSample {
    deviation: f64,
    middle: f64,
    at: Option<AtPlaces>,
}

impl PatchSample {
    /// The patch of these flattened heights \[m\] in rows of `columns`, with the ripples of its film if it ripples. The film
    /// reaches `reach` columns from the middle. Each row is in balance as a line is.
    ///
    /// # Errors
    /// When the numbers of ripples and heights differ, or the heights are not whole rows.
    pub fn new(
        heights: &[f64],
        columns: usize,
        ripples: Option<Ripples<&[f64]>>,
        reach: f64,
    ) -> Result<Self, LoadShareError> {
        let rows = heights.len().checked_div(columns).unwrap_or(0);
        let rule = "must be whole rows";
        let fits = rows > 0 && rows * columns == heights.len();
        let number = heights.len() as f64;
        DomainError::require(fits, "heights of a patch", number, "-", rule)?;
        for number in ripples
            .iter()
            .flat_map(|of| [of.pressures.len(), of.heights.len()])
        {
            let rule = "must be as many as the heights of the patch";
            let fits = number == heights.len();
            DomainError::require(fits, "ripples of a patch", number as f64, "-", rule)?;
        }
        let of_row = |row| middle_height([row], reach);
        let middles: f64 = heights.chunks_exact(columns).map(of_row).sum();
        let at = |ripples| AtPlaces::of_patch(ripples, columns, rounded(reach));
        Ok(Self {
            deviation: deviation([heights], 0.0).si(),
            middle: middles / rows as f64,
            at: ripples.map(at),
        })
    }

    /// Roughness of a patch between several flattenings, whose weights are one together.
    #[must_use]
    pub fn between(flattenings: &[(Arc<Self>, f64)]) -> WindowRoughness {
        let weighted = |of: &dyn Fn(&Self) -> f64| -> f64 {
            flattenings
                .iter()
                .map(|(one, weight)| weight * of(one))
                .sum()
        };
        let places = flattenings
            .iter()
            .filter_map(|(one, weight)| Some((one.at.as_ref()?, *weight)));
        let at = places.fold(None, |sums: Option<AtPlaces>, (at, weight)| {
            let mut sums = sums.unwrap_or_else(|| AtPlaces {
                pressures: vec![0.0; at.pressures.len()],
                heights: vec![0.0; at.heights.len()],
            });
            add_times(&mut sums.pressures, weight, &at.pressures);
            add_times(&mut sums.heights, weight, &at.heights);
            Some(sums)
        });
        WindowRoughness {
            deviation: Length::from_si(weighted(&|one| one.deviation).max(0.0)),
            middle: weighted(&|one| one.middle),
            ripple: at.as_ref().map_or_else(Vec::new, ripple),
        }
    }
}

/// Sums of the ripples at the evaluated places of a window.
#[derive(Debug, Clone)]
struct AtPlaces {
    pressures: Vec<f64>,
    heights: Vec<f64>,
}

impl AtPlaces {
    fn new<const N: usize>(ripples: Ripples<[&[f64]; N]>, reach: usize) -> Self {
        let sums = |of: [&[f64]; N]| -> Vec<f64> {
            let sum = |i: usize| of.iter().map(|values| values[i]).sum();
            places(of[0].len(), reach).map(sum).collect()
        };
        let mut pressures = sums(ripples.pressures);
        level(&mut pressures);
        Self {
            pressures,
            heights: sums(ripples.heights),
        }
    }

    fn of_patch(ripples: Ripples<&[f64]>, columns: usize, reach: usize) -> Self {
        let within = middle(columns, reach);
        let middles = |of: &[f64], of_row: fn(&mut [f64])| {
            let mut all = Vec::with_capacity(of.len() / columns * within.len());
            for row in of.chunks_exact(columns) {
                let start = all.len();
                all.extend_from_slice(&row[within.clone()]);
                of_row(&mut all[start..]);
            }
            all
        };
        let heights = middles(ripples.heights, |_| {});
        let pressures = middles(ripples.pressures, level);
        let places = places_of_patch(within.len(), heights.len() / within.len());
        let at = |of: &[f64]| places.clone().map(|i| of[i]).collect();
        Self {
            pressures: at(&pressures),
            heights: at(&heights),
        }
    }

    fn iter(&self) -> impl Iterator<Item = (f64, f64)> {
        let pressures = self.pressures.iter().copied();
        pressures.zip(self.heights.iter().copied())
    }
}

fn rounded(reach: f64) -> usize {
    reach.round() as usize
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// σ_d of heights of which those above the mean line have the weight `weight`.
///
/// ```text
/// σ_d² = (w/n) Σ 2 max(y − ȳ, 0)² + ((1 − w)/n) Σ (y − ȳ)²                        [Gap-roughness]
/// ```
///
/// Across ridges the flow is the mean of h⁻³, in which what lies below the mean line hardly counts. Both sums are the same for
/// heights that are distributed evenly about their mean. w is 1 up to a lay of 1/3, 0 at 1, and between them linear in
/// the lay factor t.
///
/// The heights are the sums of those of `N` arrays.
fn deviation<const N: usize>(heights: [&[f64]; N], weight: f64) -> Length {
    cite!("Gap-roughness");
    let n = heights[0].len() as f64;
    // The compiler turns sums in lanes into vectors, but not a sum in order.
    let squares = vectorised(
        #[inline(always)]
        || {
            let mut sum = Lanes::new([0.0]);
            sum.fold(heights, |[sum], of| [sum + of.iter().sum::<f64>()]);
            let line = sum.total()[0] / n;
            let mut squares = Lanes::new([0.0]);
            squares.fold(heights, |[sum], of| {
                let y = of.iter().sum::<f64>() - line;
                let above = if y > 0.0 { y } else { 0.0 };
                [sum + weight * 2.0 * above * above + (1.0 - weight) * y * y]
            });
            squares.total()[0]
        },
    );
    Length::from_si((squares / n).sqrt())
}

/// Derivative of σ_d over each of `heights`; zero where σ_d is.
///
/// ```text
/// ∂σ_d/∂y_i = (w (2 max(y_i − ȳ, 0) − (2/n) Σ max(y − ȳ, 0)) + (1 − w)(y_i − ȳ))/(n σ_d)         [Rms-gradient]
/// ```
pub(crate) fn deviation_gradient(heights: &[f64], weight: f64) -> Vec<f64> {
    cite!("Rms-gradient");
    let n = heights.len() as f64;
    let deviation = deviation([heights], weight).si();
    if deviation == 0.0 {
        return vec![0.0; heights.len()];
    }
    let line = mean(heights);
    let peaks = heights.iter().map(|z| (z - line).max(0.0)).sum::<f64>() / n;
    let of = |z: &f64| {
        let y = z - line;
        let of_peaks = 2.0 * (y.max(0.0) - peaks);
        (weight * of_peaks + (1.0 - weight) * y) / (n * deviation)
    };
    heights.iter().map(of).collect()
}

/// Parts that share a place of a window, with its share in each and the slope of that over u.
type Placed = [(usize, f64, f64); 3];

/// Scale of the pressures of a window: mean and standard deviation of those at its places.
#[derive(Clone, Copy)]
struct Scale {
    mean: f64,
    deviation: f64,
}

impl Scale {
    fn from_pressures(pressures: &[f64]) -> Self {
        let n = pressures.len() as f64;
        let mean = pressures.iter().sum::<f64>() / n;
        let squares = pressures
            .iter()
            .map(|p| (p - mean) * (p - mean))
            .sum::<f64>();
        Self {
            mean,
            deviation: (squares / n).sqrt(),
        }
    }

    #[inline(always)]
    fn u(self, pressure: f64) -> f64 {
        (pressure - self.mean) / self.deviation
    }

    /// ```text
    /// p′ of |ξ| < 0.8 a, less its slope over ξ
    /// x = N (1/2 + u/(4 √(1 + u²/4))) − k − 1/2,  u = (p′ − mean p′)/sd p′
    /// w_k = 3/4 − x² for |x| < 1/2, else (3/2 − |x|)²/2 for |x| < 3/2              [Ripple-parts]
    /// ```
    ///
    /// A place counts in three of the N parts, by the quadratic B-spline about their middles: the parts change steadily with the
    /// heights. What falls beyond the first or last part counts in it. At the mean a part is .17 standard deviations wide, at twice
    /// the deviation .47.
    ///
    /// ξ is the distance from the middle of the contact, whose middle 0.8 the mean gap has, too. Within it p′ carries no load, as the
    /// whole load is given; and no moment, as a pressure that rises along rolling moves the contact until it is even.
    fn placed(self, pressure: f64) -> Placed {
        let (place, root) = self.place(pressure);
        let slope = 0.25 * PARTS as f64 / (root * root * root);
        let (middle, weights) = weights(place);
        let [below, above] = [weights[0], weights[2]].map(|weight| (2.0 * weight).sqrt());
        [
            (middle.saturating_sub(1), weights[0], -below * slope),
            (middle, weights[1], (below - above) * slope),
            ((middle + 1).min(PARTS - 1), weights[2], above * slope),
        ]
    }

    /// N times the place among the parts from 0 to 1, and √(1 + u²/4).
    #[inline(always)]
    fn place(self, pressure: f64) -> (f64, f64) {
        let u = self.u(pressure);
        let root = (1.0 + 0.25 * u * u).sqrt();
        (PARTS as f64 * (0.5 + 0.25 * u / root), root)
    }
}

/// The middle one of the three parts in which a place counts, and its weights in them.
#[inline(always)]
fn weights(place: f64) -> (usize, [f64; 3]) {
    let middle = (place as usize).min(PARTS - 1);
    let x = place - middle as f64 - 0.5;
    let [below, above] = [0.5 - x, 0.5 + x];
    (
        middle,
        [0.5 * below * below, 0.75 - x * x, 0.5 * above * above],
    )
}

/// Number of places in each part, with the sums over them of pressure and height.
fn sums(at: &AtPlaces, scale: Scale) -> [[f64; 3]; PARTS] {
    let mut places = at.pressures.clone();
    vectorised(
        #[inline(always)]
        || {
            for place in &mut places {
                *place = scale.place(*place).0;
            }
        },
    );
    // A part before the first and one behind the last, which count in these; four numbers each are a vector.
    let mut sums = [[0.0; 4]; PARTS + 2];
    for (place, (p, z)) in places.iter().zip(at.iter()) {
        let (middle, weights) = weights(*place);
        for (sums, weight) in sums[middle..].iter_mut().zip(weights) {
            for (sum, value) in sums.iter_mut().zip([1.0, p, z, 0.0]) {
                *sum += weight * value;
            }
        }
    }
    let [before, first, .., last, behind] = &mut sums;
    add_times(first, 1.0, before);
    add_times(last, 1.0, behind);
    std::array::from_fn(|part| {
        let [places, pressure, height, _] = sums[part + 1];
        [places, pressure, height]
    })
}

/// The parts of a window that have places, in the order of their pressures.
fn ripple(at: &AtPlaces) -> Vec<RipplePart> {
    cite!("Ripple-parts");
    let scale = Scale::from_pressures(&at.pressures);
    if scale.deviation == 0.0 {
        return Vec::new();
    }
    let sums = sums(at, scale);
    let total = |of: usize| sums.iter().map(|part| part[of]).sum::<f64>();
    let n = total(0);
    let height = total(2) / n;
    let filled = sums.iter().filter(|[places, ..]| *places > 0.0);
    let part = |[places, pressure, z]: &[f64; 3]| RipplePart {
        length: places / n,
        pressure: pressure / places - scale.mean,
        height: z / places - height,
    };
    filled.map(part).collect()
}

/// Derivatives over pressure and height at each point of a window, from those over length, pressure and height of its parts.
///
/// ```text
/// g_i = Σ_k (dw_ik/du_i) c_ik,  c_ik = J_l/n + (J_p (p_i − p_k) + J_y (y_i − y_k))/n_k
/// ∂J/∂p_i = q_i − mean q − x_i Σ x q/Σ x²,  q_i = Σ_k w_ik J_p/n_k + (g_i − u_i mean(g u))/sd p′     [Ripple-gradient]
/// ```
///
/// n_k, p_k, y_k are number of places, pressure and height of part k, J_l, J_p, J_y the derivatives over them, w_ik the share of
/// place i in it, x_i its distance from the middle.
pub(crate) fn part_gradient(
    ripples: &Ripples<Vec<f64>>,
    reach: f64,
    by_parts: &[[f64; 3]],
) -> Ripples<Vec<f64>> {
    cite!("Ripple-gradient");
    let mut gradient = ripples.each(|of| vec![0.0; of.len()]);
    let reach = rounded(reach);
    let at = AtPlaces::new(ripples.each(|of| [of.as_slice()]), reach);
    let scale = Scale::from_pressures(&at.pressures);
    if scale.deviation == 0.0 {
        return gradient;
    }
    let sums = sums(&at, scale);
    let n = sums.iter().map(|part| part[0]).sum::<f64>();
    let mut of_parts = [[0.0; 3]; PARTS];
    let filled = (0..PARTS).filter(|k| sums[*k][0] > 0.0);
    for (k, by_part) in filled.zip(by_parts) {
        of_parts[k] = *by_part;
    }
    let value = |part: usize, p: f64, z: f64| {
        let [places, pressure, height] = sums[part];
        let [by_length, by_pressure, by_height] = of_parts[part];
        if places == 0.0 {
            return 0.0;
        }
        let of_means = by_pressure * (p - pressure / places) + by_height * (z - height / places);
        by_length / n + of_means / places
    };
    let mut at_places = [0, 1].map(|_| vec![0.0; at.pressures.len()]);
    let mut by_scale = 0.0;
    let [over_pressure, over_height] = &mut at_places;
    for (i, (p, z)) in at.iter().enumerate() {
        let mut moved = 0.0;
        for (part, weight, slope) in scale.placed(p) {
            if sums[part][0] > 0.0 {
                let [_, by_pressure, by_height] = of_parts[part];
                over_pressure[i] += weight * by_pressure / sums[part][0];
                over_height[i] += weight * by_height / sums[part][0];
            }
            moved += slope * value(part, p, z);
        }
        over_pressure[i] += moved / scale.deviation;
        by_scale += moved * scale.u(p);
    }
    for (over, p) in over_pressure.iter_mut().zip(&at.pressures) {
        *over -= scale.u(*p) * by_scale / (n * scale.deviation);
    }
    level(over_pressure);
    let both = [&mut gradient.pressures, &mut gradient.heights];
    for (of, at_places) in both.into_iter().zip(&at_places) {
        let mean = mean(at_places);
        for (i, over) in places(of.len(), reach).zip(at_places) {
            of[i] = over - mean;
        }
    }
    gradient
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points from the middle of the windows of the tests up to their ends.
    const REACH: f64 = 220.0;

    fn ripple(heights: &[f64], pressures: &[f64]) -> Vec<RipplePart> {
        let (pressures, heights) = ([pressures], [heights]);
        super::ripple(&AtPlaces::new(
            Ripples { pressures, heights },
            rounded(REACH),
        ))
    }

    #[test]
    fn places_of_a_patch_are_in_every_column_and_row_alike() {
        for (columns, rows) in [(601, 192), (603, 64), (605, 256), (50, 7), (3, 5)] {
            let found: Vec<usize> = places_of_patch(columns, rows).collect();
            let count = found.len();
            assert_eq!(count, (OF_PATCH * PLACES).min(columns * rows));
            // In any twelfth of the columns as many as in any other, but for two.
            let twelfth = |part: usize| {
                let within = |i: &&usize| **i % columns * 12 / columns == part;
                found.iter().filter(within).count()
            };
            let expected = count as f64 / 12.0;
            if columns > 100 {
                for part in 0..12 {
                    assert!(
                        (twelfth(part) as f64 - expected).abs() < 4.0,
                        "{columns} {rows}"
                    );
                }
            }
            let of_row = |row: usize| found.iter().filter(|i| **i / columns == row).count();
            let least = count / rows;
            assert!((0..rows).all(|row| (least..=least + 1).contains(&of_row(row))));
        }
    }

    #[test]
    fn a_patch_constant_along_the_lead_ripples_as_its_line() {
        let line = wave(603);
        let pressures: Vec<f64> = line.iter().map(|z| 3.0 * z + 7.0).collect();
        let moment = |parts: &[RipplePart]| -> f64 {
            parts
                .iter()
                .map(|part| part.length * part.pressure * part.height)
                .sum()
        };
        let expected = moment(&ripple(&line, &pressures));
        // 192 rows had all of their places in one column.
        for rows in [4, 64, 192, 256] {
            let patch = PatchSample::new(
                &line.repeat(rows),
                603,
                Some(Ripples {
                    pressures: &pressures.repeat(rows),
                    heights: &line.repeat(rows),
                }),
                REACH,
            );
            let found = PatchSample::between(&[(Arc::new(patch.unwrap()), 1.0)]);
            assert!(
                (moment(&found.ripple) / expected - 1.0).abs() < 0.01,
                "{rows}"
            );
        }
    }

    fn wave(points: usize) -> Vec<f64> {
        let turn = std::f64::consts::TAU / points as f64;
        (0..points)
            .map(|i| (turn * (i as f64 + 0.5)).sin())
            .collect()
    }

    #[test]
    fn peaks_of_even_heights_have_their_standard_deviation() {
        let heights = wave(1000);
        for weight in [0.0, 0.3, 1.0] {
            let found = deviation([&heights], weight).si();
            assert!((found - 0.5_f64.sqrt()).abs() < 1e-12, "{weight}: {found}");
        }
        // A plateau with one deep valley in ten: nine tenths a tenth above the mean line, a tenth nine tenths below it.
        let plateau: Vec<f64> = (0..1000).map(|i| f64::from(u8::from(i >= 100))).collect();
        let found = deviation([&plateau], 1.0).si();
        assert!(
            (found - (2.0_f64 * 0.9 * 0.01).sqrt()).abs() < 1e-12,
            "{found}"
        );
        let rms = deviation([&plateau], 0.0).si();
        assert!((rms - 0.3).abs() < 1e-12, "{rms}");
    }

    #[test]
    fn the_gradient_of_the_peaks_is_their_central_difference() {
        let heights: Vec<f64> = wave(40).iter().map(|z| z + 0.4 * z * z).collect();
        for weight in [0.0, 0.4, 1.0] {
            let gradient = deviation_gradient(&heights, weight);
            for i in 0..heights.len() {
                let at = |step: f64| {
                    let mut moved = heights.clone();
                    moved[i] += step;
                    deviation([&moved], weight).si()
                };
                let quotient = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((gradient[i] - quotient).abs() < 1e-9, "{weight} {i}");
            }
        }
    }

    #[test]
    fn parts_of_a_window_keep_its_means_and_the_order_of_their_pressures() {
        // Even about the middle: no slope is taken.
        let heights: Vec<f64> = wave(1003).iter().map(|z| z * z).collect();
        let pressures: Vec<f64> = heights.iter().map(|z| 3.0 * z + 7.0).collect();
        let parts = ripple(&heights, &pressures);
        let total = |of: &dyn Fn(&RipplePart) -> f64| parts.iter().map(of).sum::<f64>();
        assert!((total(&|part| part.length) - 1.0).abs() < 1e-12);
        assert!(total(&|part| part.length * part.pressure).abs() < 1e-12);
        assert!(total(&|part| part.length * part.height).abs() < 1e-12);
        for pair in parts.windows(2) {
            assert!(pair[0].pressure < pair[1].pressure);
        }
        // The pressure follows the height.
        for part in &parts {
            assert!((part.pressure - 3.0 * part.height).abs() < 1e-12);
        }
        assert_eq!(ripple(&heights, &vec![7.0; heights.len()]), []);
        // What rises along rolling moves the contact, and what is outside of it does not act.
        let other = |i: usize| {
            0.5 * i as f64
                + if i.abs_diff(501) > rounded(REACH) {
                    9.0
                } else {
                    0.0
                }
        };
        let sloping: Vec<f64> = (pressures.iter().enumerate())
            .map(|(i, p)| p + other(i))
            .collect();
        for (part, moved) in parts.iter().zip(ripple(&heights, &sloping)) {
            assert!((part.pressure - moved.pressure).abs() < 1e-9);
            assert!((part.length - moved.length).abs() < 1e-9);
        }
    }

    #[test]
    fn a_mirrored_window_has_the_same_places() {
        for points in (1..2000).step_by(7).chain([1, 2, 3, 10_000, 10_001]) {
            let found: Vec<usize> = places(points, points).collect();
            let mirrored: Vec<usize> = found.iter().rev().map(|i| points - 1 - i).collect();
            assert_eq!(found, mirrored);
            assert!(
                found.len() >= points.min(PLACES - 1),
                "{points}: {}",
                found.len()
            );
        }
    }

    #[test]
    fn the_gradient_of_the_parts_is_their_central_difference() {
        let heights: Vec<f64> = wave(600).iter().map(|z| z + 0.4 * z * z).collect();
        let other = |i: usize| (0.7 * i as f64).sin();
        let pressures: Vec<f64> = (heights.iter().enumerate())
            .map(|(i, z)| 3.0 * z + other(i))
            .collect();
        // Any smooth number of the parts.
        let number = |parts: &[RipplePart]| {
            let of = |part: &RipplePart| {
                part.length * (part.pressure.powi(2) + (part.height * part.pressure).sin())
            };
            parts.iter().map(of).sum::<f64>()
        };
        let by_parts: Vec<[f64; 3]> = (ripple(&heights, &pressures).iter())
            .map(|part| {
                let RipplePart {
                    length: l,
                    pressure: p,
                    height: z,
                } = part;
                let (sin, cos) = (z * p).sin_cos();
                [p * p + sin, l * (2.0 * p + z * cos), l * p * cos]
            })
            .collect();
        let ripples = Ripples {
            pressures: pressures.clone(),
            heights: heights.clone(),
        };
        let gradient = part_gradient(&ripples, REACH, &by_parts);
        // A wide bump moves many places between the parts.
        let bump = |i: usize| f64::exp(-((i as f64 - 200.0) / 60.0).powi(2));
        let both = [&gradient.pressures, &gradient.heights];
        for (which, gradient) in both.into_iter().enumerate() {
            let at = |step: f64| {
                let moved = |of: &[f64], is_moved: bool| -> Vec<f64> {
                    let step = if is_moved { step } else { 0.0 };
                    let moved = of
                        .iter()
                        .enumerate()
                        .map(|(i, value)| value + step * bump(i));
                    moved.collect()
                };
                number(&ripple(
                    &moved(&heights, which == 1),
                    &moved(&pressures, which == 0),
                ))
            };
            let expected: f64 = gradient.iter().enumerate().map(|(i, g)| g * bump(i)).sum();
            let quotient = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!(
                (expected / quotient - 1.0).abs() < 1e-4,
                "{which}: {expected} {quotient}"
            );
        }
    }
}
