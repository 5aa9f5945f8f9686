//! Both flanks as measured surfaces that repeat along the lead, from which patches are cut.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | n, o | rows of a surface, and rows that its ends overlap by | - |
//! | w | weight of the beginning of the surface | - |
//! | ρ | correlation of both ends | - |
//!
//! All contacts of a case flatten the sheets by one family of curves, from the shortest inlet to the longest. The whole sheets are
//! flattened for wavelength scales half an octave apart, each when it is first needed. A window between them is a cubic
//! interpolation over the logarithm of the scale, which is right to 2.1e-4 of the height of each wave outside the contact.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::noted::Noted;
use asperity_core::profile::mirrored_indices;
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, Profile, cite};
use asperity_ehl_regime::{
    Attenuation, GapLaw, Lay, Patch, PatchPair, PatchSpectrum, RegimeError, Ripples,
};
use asperity_mixed_film::{Flattening, PatchSample, WindowRoughness};
use asperity_roughness::RoughnessError;
use asperity_roughness::generate::surface_like;
use asperity_roughness::resampling::points_after;
use asperity_roughness::surface_preparation::PreparedSurface;
use serde::{Deserialize, Serialize};

use crate::error::PositionError;

/// Most rows of a sheet: of a wider surface the middle. A patch of more costs in proportion.
const MOST_ROWS: usize = 256;
/// Part of its rows by which the ends of a surface overlap.
const OVERLAP: usize = 8;
/// Most points of a row whose flow is computed: the inlet leaves waves of some tens of them.
const MOST_COLUMNS: usize = 256;
/// Places of one sheet against the other whose flow is computed.
const FLOW_PLACES: usize = 2;
/// Wavelength scales in an octave for which sheets are flattened.
const SCALES_OF_OCTAVE: f64 = 2.0;
/// Logarithm to the base 2 of the largest scale \[1/m\] and of the smallest one: every wave of a flank is pressed flat, or none.
const WIDEST: f64 = 60.0;
/// Most flattened sheets in memory.
const MOST_KEPT: usize = 8;
/// Most patches in memory as inlets leave them, 12 kB each: a case has some hundred for every torque.
const MOST_SAMPLES: usize = 4096;
/// Least rows that a sheet is made of.
pub const LEAST_ROWS: usize = 16;

/// Seeds of the surfaces of pinion and wheel that are made like traces.
const SEEDS: [u64; 2] = [1, 2];

/// Origin of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub enum SheetSource {
    /// A scan.
    Scan(PreparedSurface),
    /// A prepared trace of a flank with this lay, 0 to 1.
    Trace(Profile, f64),
}

impl From<PreparedSurface> for SheetSource {
    fn from(scan: PreparedSurface) -> Self {
        Self::Scan(scan)
    }
}

/// A surface that was made from a trace.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MadeSheet {
    /// Lay of the flank.
    pub lay: f64,
    /// Seed of the generator; none where the trace is the same at every place along the lead.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

impl MadeSheet {
    /// The sheet of pinion or wheel with this lay. Ridges across the face are constant along the lead.
    #[must_use]
    pub fn new(body: usize, lay: f64) -> Self {
        let seed = (lay > Lay::CONFIRMED.gamma()).then(|| SEEDS[body]);
        Self { lay, seed }
    }

    fn heights(
        self,
        trace: &Profile,
        rows: usize,
        apart: Length,
    ) -> Result<Vec<f64>, RoughnessError> {
        match self.seed {
            Some(seed) => surface_like(trace, rows, apart, self.lay, seed),
            None => Ok(trace.heights().repeat(rows)),
        }
    }
}

/// Rows of a scan with rows `apart` at the distance of rows of patches, whose points are `along` apart.
///
/// # Errors
/// When a distance is not positive.
pub fn rows_of_patches(rows: usize, apart: Length, along: Length) -> Result<usize, DomainError> {
    let across = if along > apart { along } else { apart };
    points_after(rows, apart, across)
}

/// Prepared surfaces of pinion and wheel with the same distances of points and rows, and the same number of rows.
#[derive(Debug)]
pub struct Sheets {
    heights: [Vec<f64>; 2],
    columns: [usize; 2],
    rows: usize,
    spacings: [Length; 2],
    known: KnownSheets,
}

/// Results that both sheets keep, each made at first need.
#[derive(Debug, Default)]
struct KnownSheets {
    waves: Noted<Result<SheetWaves, PositionError>>,
    flattened: Mutex<BTreeMap<SheetInlet, Arc<FlattenedSheets>>>,
    /// By the number of columns from the middle up to which the film is evaluated, too.
    samples: Mutex<BTreeMap<(PatchPlace, SheetInlet, u64), Arc<PatchSample>>>,
}

/// The waves of both sheets, each mirrored at the ends of its rows, so that it repeats without a jump.
#[derive(Debug)]
struct SheetWaves {
    whole: [PatchSpectrum; 2],
    /// The middles of both, with equal sizes: the flow through them as they pass each other.
    passing: PatchPair,
}

impl PartialEq for Sheets {
    fn eq(&self, other: &Self) -> bool {
        self.heights == other.heights
            && self.columns == other.columns
            && self.spacings == other.spacings
    }
}

/// An inlet for which whole sheets are flattened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct SheetInlet {
    /// Place of its wavelength scale among those that are computed.
    scale: i32,
    /// Bits of the reduced modulus, if the film ripples.
    modulus: Option<u64>,
}

/// Both sheets as an inlet leaves them, in single precision.
#[derive(Debug)]
struct FlattenedSheets {
    heights: [Vec<f32>; 2],
    /// Ripples of the film, if it ripples.
    ripples: Option<Ripples<[Vec<f32>; 2]>>,
}

impl Sheets {
    /// Two surfaces with points `along` apart, and rows as near as the rows of the finer scan, but not nearer than `along`. A trace
    /// has points `along` apart.
    ///
    /// # Errors
    /// When no flank has a scan, a scan has fewer than 16 rows at this distance, or a surface cannot be made or resampled.
    pub fn new(
        sources: [impl Into<SheetSource>; 2],
        along: Length,
    ) -> Result<Self, RoughnessError> {
        let sources = sources.map(Into::into);
        let finer = sources.iter().filter_map(|source| match source {
            SheetSource::Scan(surface) => Some(surface.spacings[1].si()),
            SheetSource::Trace(..) => None,
        });
        let finer = finer.fold(f64::INFINITY, f64::min);
        let rule = "needs a scan of at least one flank";
        DomainError::require(finer.is_finite(), "surfaces", 0.0, "-", rule)?;
        let across = Length::from_si(finer.max(along.si()));
        let mut rows = MOST_ROWS + MOST_ROWS / (OVERLAP - 1);
        let respaced = sources.map(|source| match source {
            SheetSource::Scan(surface) => {
                let surface = surface.respaced([along, across])?;
                rows = rows.min(surface.rows());
                Ok(SheetSource::Scan(surface))
            }
            made => Ok::<_, DomainError>(made),
        });
        let [first, second] = respaced;
        let both = [first?, second?];
        let rule =
            "must be at least 16; scan a wider part of the flank, or state contact = \"lines\"";
        DomainError::require(
            rows >= LEAST_ROWS,
            "rows at the spacing of patches",
            rows as f64,
            "-",
            rule,
        )?;
        let kept = rows - rows / OVERLAP;
        let mut columns = [0; 2];
        let mut heights = [Vec::new(), Vec::new()];
        for (body, source) in both.into_iter().enumerate() {
            (columns[body], heights[body]) = match source {
                SheetSource::Scan(surface) => (surface.columns, repeated(&surface, rows)),
                SheetSource::Trace(trace, lay) => {
                    let made = MadeSheet::new(body, lay);
                    (trace.len(), made.heights(&trace, kept, across)?)
                }
            };
        }
        Ok(Self {
            heights,
            columns,
            rows: kept,
            spacings: [along, across],
            known: KnownSheets::default(),
        })
    }

    /// The surfaces with all heights multiplied by `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let times = |heights: &Vec<f64>| heights.iter().map(|z| factor * z).collect();
        Self {
            heights: self.heights.each_ref().map(times),
            columns: self.columns,
            rows: self.rows,
            spacings: self.spacings,
            known: KnownSheets::default(),
        }
    }

    /// The surfaces with `change` of every row, which keeps the number of its points.
    ///
    /// # Errors
    /// The errors of `change`, and when a row has another number of points.
    pub fn with_changed_rows<E: From<DomainError>>(
        &self,
        change: impl Fn(&Profile) -> Result<Profile, E>,
    ) -> Result<Self, E> {
        let mut heights = [Vec::new(), Vec::new()];
        for (body, changed) in heights.iter_mut().enumerate() {
            let columns = self.columns[body];
            for row in self.heights[body].chunks_exact(columns) {
                let row = change(&Profile::new(self.spacings[0], row.to_vec())?)?;
                let rule = "must be the number of points before";
                let points = row.len() as f64;
                DomainError::require(row.len() == columns, "points of a row", points, "-", rule)?;
                changed.extend(row.into_heights());
            }
        }
        Ok(Self {
            heights,
            columns: self.columns,
            rows: self.rows,
            spacings: self.spacings,
            known: KnownSheets::default(),
        })
    }

    /// Rows of both sheets.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Distance of the points of a row, and of the rows.
    #[must_use]
    pub fn spacings(&self) -> [Length; 2] {
        self.spacings
    }

    /// Heights \[m\] of pinion or wheel, row by row, and the points of a row.
    #[must_use]
    pub fn of_body(&self, body: usize) -> (&[f64], usize) {
        (&self.heights[body], self.columns[body])
    }

    /// Sums z₁ + z₂ \[m\] of both flanks in a patch, row by row; the flanks are mirrored beyond the ends of their rows.
    #[must_use]
    pub fn composite(&self, place: PatchPlace) -> Vec<f64> {
        sums(&self.heights, self.columns, self.rows, place)
    }

    /// Number of rows of a patch that count as independent where a loss averages over `width` along rolling; 1 where ridges run
    /// along the lead.
    ///
    /// ```text
    /// m = n/Σ_y q(y),  q(y) = Σ_x (1 − |x|/b_e) r²(x, y)/Σ_x (1 − |x|/b_e) r²(x, 0)              [Sheet-rows]
    /// ```
    ///
    /// r is the autocorrelation of both flanks together, y goes over all n rows. q is the correlation of the mean squares of normally
    /// distributed heights in two rows of length b_e.
    ///
    /// # Errors
    /// When a sheet refuses its numbers.
    pub fn independent_rows(&self, width: Length) -> Result<f64, PositionError> {
        cite!("Sheet-rows");
        let points = width / self.spacings[0];
        let least = self.columns[0].min(self.columns[1]);
        let reach = (points.ceil().max(1.0) as usize).min(least / 2);
        // Products of both flanks by rows, the distances along rolling from -reach to reach.
        let mut products = vec![0.0; self.rows * (2 * reach + 1)];
        for body in [0, 1] {
            let columns = self.columns[body];
            let size = [columns, self.rows];
            let patch = Patch::new(self.heights[body].clone(), size, self.spacings)?;
            let of_body = PatchSpectrum::new(&patch).autocorrelation();
            let rows = products.chunks_exact_mut(2 * reach + 1);
            for (sums, row) in rows.zip(of_body.chunks_exact(columns)) {
                for (sum, x) in sums.iter_mut().zip(columns - reach..) {
                    *sum += row[x % columns];
                }
            }
        }
        let weight = |x: usize| (1.0 - x.abs_diff(reach) as f64 / points.max(1.0)).max(0.0);
        let square = |row: &[f64]| -> f64 {
            let squares = row.iter().enumerate();
            squares.map(|(x, r)| weight(x) * r * r).sum()
        };
        let squares: Vec<f64> = products.chunks_exact(2 * reach + 1).map(square).collect();
        let all = squares.iter().sum::<f64>() / squares[0];
        Ok(if all.is_finite() {
            (self.rows as f64 / all).max(1.0)
        } else {
            1.0
        })
    }

    /// Waves of both sheets.
    ///
    /// # Errors
    /// When a sheet refuses its numbers.
    fn waves(&self) -> Result<&SheetWaves, PositionError> {
        let waves = self.known.waves.get_or_init(|| self.transformed());
        waves.as_ref().map_err(Clone::clone)
    }

    fn transformed(&self) -> Result<SheetWaves, PositionError> {
        let least = self.columns[0].min(self.columns[1]).min(MOST_COLUMNS);
        let spectrum = |body: usize, columns: std::ops::Range<usize>| {
            let mut mirrored = Vec::with_capacity(2 * columns.len() * self.rows);
            for row in self.heights[body].chunks_exact(self.columns[body]) {
                let row = &row[columns.clone()];
                mirrored.extend(row.iter().chain(row.iter().rev()));
            }
            let size = [2 * columns.len(), self.rows];
            let patch = Patch::new(mirrored, size, self.spacings)?;
            Ok::<_, RegimeError>(PatchSpectrum::new(&patch))
        };
        let middle = |body: usize| {
            let first = (self.columns[body] - least) / 2;
            spectrum(body, first..first + least)
        };
        Ok(SheetWaves {
            whole: [
                spectrum(0, 0..self.columns[0])?,
                spectrum(1, 0..self.columns[1])?,
            ],
            passing: PatchPair::new([middle(0)?, middle(1)?], FLOW_PLACES)?,
        })
    }

    /// The sheets as they pass each other in the inlet of a contact.
    ///
    /// # Errors
    /// When a sheet refuses its numbers.
    pub fn passing(&self) -> Result<&PatchPair, PositionError> {
        Ok(&self.waves()?.passing)
    }

    /// Roughness of both flanks in a patch as `flattening` leaves it.
    ///
    /// # Errors
    /// When a sheet refuses its numbers.
    pub fn window(
        &self,
        place: PatchPlace,
        flattening: &Flattening,
    ) -> Result<WindowRoughness, PositionError> {
        cite!("Attenuated-patch");
        cite!("Patch-wave");
        cite!("Venner");
        cite!("Gap-roughness");
        if flattening.ripple.is_some() {
            cite!("Patch-ripple");
        }
        let modulus = flattening.ripple.map(|modulus| modulus.si().to_bits());
        let reach = flattening.reach / self.spacings[0];
        let mut around = Vec::with_capacity(4);
        for (scale, weight) in scales(flattening.attenuation.nabla_per_length()) {
            let inlet = SheetInlet { scale, modulus };
            around.push((self.sample(place, inlet, reach)?, weight));
        }
        Ok(PatchSample::between(&around))
    }

    /// A patch as an inlet leaves it.
    fn sample(
        &self,
        place: PatchPlace,
        inlet: SheetInlet,
        reach: f64,
    ) -> Result<Arc<PatchSample>, PositionError> {
        let known = || {
            self.known
                .samples
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        if let Some(sample) = known().get(&(place, inlet, reach.to_bits())) {
            return Ok(Arc::clone(sample));
        }
        let FlattenedSheets { heights, ripples } = &*self.flattened(inlet)?;
        let cut = |of| sums(of, self.columns, self.rows, place);
        let ripples = ripples.as_ref().map(|ripples| ripples.each(cut));
        let made = Arc::new(PatchSample::new(
            &cut(heights),
            place.points,
            ripples.as_ref().map(|ripples| ripples.each(Vec::as_slice)),
            reach,
        )?);
        let mut known = known();
        if known.len() >= MOST_SAMPLES {
            known.clear();
        }
        known.insert((place, inlet, reach.to_bits()), Arc::clone(&made));
        Ok(made)
    }

    /// Both sheets as an inlet leaves them. Threads that need them wait for the first one.
    fn flattened(&self, inlet: SheetInlet) -> Result<Arc<FlattenedSheets>, PositionError> {
        let known = &self.known.flattened;
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(flattened) = known.get(&inlet) {
            return Ok(Arc::clone(flattened));
        }
        let scale = (f64::from(inlet.scale) / SCALES_OF_OCTAVE).exp2();
        let attenuation = Attenuation::new(GapLaw::Inlet, scale)?;
        let whole = &self.waves()?.whole;
        let of_flanks = |values: [Vec<f64>; 2]| {
            // The mirror images are left out.
            [0, 1].map(|body: usize| {
                let columns = self.columns[body];
                let rows = values[body].chunks_exact(2 * columns);
                rows.flat_map(|row| row[..columns].iter().map(|z| *z as f32))
                    .collect::<Vec<f32>>()
            })
        };
        let ripple = |bits: u64| {
            let modulus = Pressure::from_si(f64::from_bits(bits));
            let [one, other] = [0, 1].map(|body: usize| whole[body].ripple(&attenuation, modulus));
            Ripples {
                pressures: of_flanks([one.pressures, other.pressures]),
                heights: of_flanks([one.heights, other.heights]),
            }
        };
        let heights = |body: usize| whole[body].attenuated(&attenuation).heights().to_vec();
        let made = Arc::new(FlattenedSheets {
            heights: of_flanks([0, 1].map(heights)),
            ripples: inlet.modulus.map(ripple),
        });
        known.insert(inlet, Arc::clone(&made));
        if known.len() > MOST_KEPT {
            let distance = |of: &SheetInlet| of.scale.abs_diff(inlet.scale);
            if let Some(farthest) = known.keys().copied().max_by_key(distance) {
                known.remove(&farthest);
            }
        }
        Ok(made)
    }
}

/// The computed scales around `scale` \[1/m\] with their weights.
///
/// ```text
/// f(t) = Σ w_k f_k,  w_k = Π_(l≠k) (t − l)/(k − l),  k, l = −1..2
/// ```
///
/// t: two of the logarithm to the base 2 of the scale over its lower neighbour.
fn scales(scale: f64) -> impl Iterator<Item = (i32, f64)> {
    let place = SCALES_OF_OCTAVE * scale.log2().clamp(-WIDEST, WIDEST);
    let below = place.floor();
    let t = place - below;
    let weights = [
        -t * (t - 1.0) * (t - 2.0) / 6.0,
        (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
        -(t + 1.0) * t * (t - 2.0) / 2.0,
        (t + 1.0) * t * (t - 1.0) / 6.0,
    ];
    let each = (below as i32 - 1..).zip(weights);
    each.filter(|(_, weight)| *weight != 0.0)
}

/// Sums of both flanks in a patch, row by row, from rows of `columns` values.
fn sums<T: Copy + Into<f64>>(
    of: &[Vec<T>; 2],
    columns: [usize; 2],
    rows: usize,
    place: PatchPlace,
) -> Vec<f64> {
    let PatchPlace {
        starts,
        points,
        shift,
    } = place;
    let places = [0, 1].map(|body: usize| -> Vec<usize> {
        mirrored_indices(columns[body], starts[body], points).collect()
    });
    let mut sums = Vec::with_capacity(rows * points);
    for row in 0..rows {
        let first = &of[0][row * columns[0]..][..columns[0]];
        let second = &of[1][(row + shift) % rows * columns[1]..][..columns[1]];
        let both = places[0].iter().zip(&places[1]);
        sums.extend(both.map(|(i, j)| first[*i].into() + second[*j].into()));
    }
    sums
}

/// Place of a patch on both sheets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct PatchPlace {
    /// First points of the patch in the rows of pinion and wheel; negative beyond the ends of the rows.
    pub starts: [isize; 2],
    /// Points of the patch in a row, an odd number.
    pub points: usize,
    /// Row of the wheel that meets the first row of the pinion.
    pub shift: usize,
}

/// The middle `n` rows, without those by which both ends overlap, so that the last row is followed by the first.
///
/// ```text
/// z = (w z_begin + (1 − w) z_end)/√(w² + (1 − w)² + 2 w (1 − w) ρ),  w = (j + 1)/(o + 1)           [Sheet-1]
/// ```
///
/// The root keeps the variance of ends that are unrelated (ρ = 0), and ridges that run on from one end to the other (ρ = 1).
fn repeated(surface: &PreparedSurface, n: usize) -> Vec<f64> {
    cite!("Sheet-1");
    let columns = surface.columns;
    let first = (surface.rows() - n) / 2;
    let part = &surface.heights[first * columns..(first + n) * columns];
    let overlap = n / OVERLAP;
    let mut kept = part[..(n - overlap) * columns].to_vec();
    let (begin, end) = (&part[..overlap * columns], &part[(n - overlap) * columns..]);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let both = (product(begin, begin) * product(end, end)).sqrt();
    let correlation = if both > 0.0 {
        (product(begin, end) / both).clamp(0.0, 1.0)
    } else {
        1.0
    };
    for j in 0..overlap {
        let w = (j + 1) as f64 / (overlap + 1) as f64;
        let rest = 1.0 - w;
        let scale = (w * w + rest * rest + 2.0 * w * rest * correlation).sqrt();
        let row = j * columns..(j + 1) * columns;
        let ends = begin[row.clone()].iter().zip(&end[row.clone()]);
        for (z, (begin, end)) in kept[row].iter_mut().zip(ends) {
            *z = (w * begin + rest * end) / scale;
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use asperity_roughness::preparation::Preparation;
    use asperity_roughness::surface_preparation::prepare_surface;

    use super::*;

    #[test]
    fn a_wave_between_two_scales_is_right_to_a_part_of_its_height() {
        // Every wave of a sheet is multiplied by a number of its own: a window is right to what this number is.
        let wave = Length::from_si(20e-6);
        let ratio = |scale: f64| Attenuation::new(GapLaw::Inlet, scale).map(|of| of.ratio(wave));
        let mut worst = 0.0_f64;
        for k in -2000..2000 {
            // Scales from 1e-6 to 1e6 over the wave, at all places between the computed ones.
            let scale = 10.0_f64.powf(0.003 * f64::from(k)) / wave.si();
            let of = |(at, weight): (i32, f64)| {
                weight * ratio((f64::from(at) / SCALES_OF_OCTAVE).exp2()).unwrap()
            };
            let between: f64 = scales(scale).map(of).sum();
            worst = worst.max((between - ratio(scale).unwrap()).abs());
        }
        assert!(worst < 2.1e-4, "{worst:e}");
        // The weights are one together, and one at a computed scale.
        let sum: f64 = scales(3.7e5).map(|(_, weight)| weight).sum();
        assert!((sum - 1.0).abs() < 1e-12);
        assert_eq!(scales(2.0_f64.powi(20)).collect::<Vec<_>>(), [(40, 1.0)]);
    }

    #[test]
    fn patches_in_memory_are_bounded_and_found_again() {
        let height = |k: usize| 1e-7 * ((k % 300) as f64 * 0.3 + (k / 300) as f64).sin();
        let z: Vec<f64> = (0..300 * 20).map(height).collect();
        let recipe = Preparation {
            lambda_s: None,
            lambda_c: None,
            ..Preparation::default()
        };
        let um = Length::from_si(1e-6);
        let surface = prepare_surface(&z, 300, [um; 2], &recipe).unwrap();
        let sheets = Sheets::new([surface.clone(), surface], um).unwrap();
        let flattening = Flattening::from(Attenuation::new(GapLaw::Inlet, 3.7e5).unwrap());
        let window = |start: isize, shift: usize| {
            let place = PatchPlace {
                starts: [start, 3],
                points: 9,
                shift,
            };
            sheets.window(place, &flattening).unwrap()
        };
        let first = window(0, 0);
        for start in 0..200 {
            for shift in 0..8 {
                window(start, shift);
            }
        }
        let kept = sheets.known.samples.lock().unwrap().len();
        assert!(kept > 0 && kept <= MOST_SAMPLES, "{kept}");
        assert_eq!(window(0, 0), first);
    }
}
