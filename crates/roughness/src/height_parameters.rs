//! Height, spacing and slope parameters according to ISO 4287 and ISO 21920-2.
//!
//! Source: ISO 4287:1997 with ISO 4288 (per sampling length, then the mean, as roughness testers print), and
//! ISO 21920-2:2021 (field parameters over the evaluation length, feature parameters per section).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | height above the mean line of the filter (not centred again) | m |
//! | l_e, l_c | evaluation length, section (sampling) length | m |
//! | n | sections, ⌊l_e/l_c⌋; section i is z[i N/n .. (i+1) N/n] | - |
//!
//! On surfaces with single features the two standards differ by large factors, so every value states its mode.

use asperity_core::cite;
use asperity_core::numerics::{extremes, sum};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::elements::{Element, elements, overlapping_elements};
use crate::error::RoughnessError;
use crate::spectral::{each_slope, mean_square};

/// Fraction of Rz (or Rp, Rv) that a profile element must exceed on either side (ISO 4287, ISO 21920-2).
const DISCRIMINATION: f64 = 0.1;

/// Standard that defines the parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Mode {
    /// ISO 4287: per sampling length, then the mean, as roughness testers print.
    #[default]
    Iso4287,
    /// ISO 21920-2: over the evaluation length.
    Iso21920,
}

impl std::fmt::Display for Mode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Iso4287 => "ISO 4287",
            Self::Iso21920 => "ISO 21920-2",
        })
    }
}

/// Height, spacing and slope parameters of a profile.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HeightParameters {
    /// Standard of the definitions.
    pub mode: Mode,
    /// Number of sections.
    pub sections: usize,
    /// Arithmetic mean height.
    pub ra: Length,
    /// Root mean square height.
    pub rq: Length,
    /// Skewness; `None` for a flat profile.
    pub rsk: Option<f64>,
    /// Kurtosis, 3 for Gaussian heights; `None` for a flat profile.
    pub rku: Option<f64>,
    /// Mean peak height.
    pub rp: Length,
    /// Mean pit depth, positive.
    pub rv: Length,
    /// Rp + Rv.
    pub rz: Length,
    /// Largest Rz of a section (also called Rmax, Rzx).
    pub rz1max: Length,
    /// Total height over the evaluation length.
    pub rt: Length,
    /// Mean width of profile elements; `None` without elements.
    pub rsm: Option<Length>,
    /// Mean height of profile elements; `None` without elements.
    pub rc: Option<Length>,
    /// Root mean square slope, 7-point.
    pub rdq: f64,
    /// Number of sections without a profile element (in ISO 21920-2 the whole trace is one section).
    pub sections_without_element: usize,
}

/// The parameters of a filtered profile, in sections of `lambda_c`.
///
/// # Errors
/// When the profile is shorter than one section or has too few points for a slope.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::height_parameters::{Mode, height_parameters};
/// let wave = |i: usize| 1e-6 * (i as f64 / 100.0 * std::f64::consts::TAU).sin();
/// let profile = Profile::new(Length::from_si(0.8e-6), (0..5000).map(wave).collect())?;
/// let parameters = height_parameters(&profile, Mode::Iso4287, "0.8 mm".parse()?)?;
/// assert_eq!(parameters.sections, 5);
/// assert!((parameters.rq.si() - 1e-6 / 2f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn height_parameters(
    profile: &Profile,
    mode: Mode,
    lambda_c: Length,
) -> Result<HeightParameters, RoughnessError> {
    in_sections(profile, mode, sections_in(profile, lambda_c)?)
}

/// n = ⌊l_e/l_c⌋, l_e = N dx                                                  [Section-1]
///
/// # Errors
/// When the section length is not positive, or longer than the profile.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// let profile = Profile::new(Length::from_si(1e-6), vec![0.0; 4000])?;
/// let n = asperity_roughness::height_parameters::sections_in(&profile, Length::from_si(0.8e-3))?;
/// assert_eq!(n, 5);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn sections_in(profile: &Profile, section_length: Length) -> Result<usize, RoughnessError> {
    cite!("Section-1");
    // Five sections of 0.8 mm must not become four due to the rounding of dx.
    const ROUNDING: f64 = 1e-9;
    let lc = DomainError::positive("section length", section_length)?;
    let evaluated = profile.spacing() * profile.len() as f64;
    let sections = (evaluated.si() / lc * (1.0 + ROUNDING)).floor();
    if sections < 1.0 {
        return Err(RoughnessError::TooShort {
            length: evaluated,
            needed: section_length,
            purpose: "one section",
        });
    }
    Ok((sections as usize).min(profile.len()))
}

/// The parameters of a filtered profile divided into `sections` equal sections.
///
/// # Errors
/// When `sections` is zero, or a section has fewer than the seven points of a slope.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::height_parameters::{Mode, in_sections};
/// let heights = (0..500).map(|i| if i % 2 == 0 { 1e-6 } else { -1e-6 }).collect();
/// let profile = Profile::new(Length::from_si(1e-6), heights)?;
/// let parameters = in_sections(&profile, Mode::Iso21920, 5)?;
/// assert_eq!(parameters.rz.si(), 2e-6);
/// assert!((parameters.ra.si() - 1e-6).abs() < 1e-18);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn in_sections(
    profile: &Profile,
    mode: Mode,
    sections: usize,
) -> Result<HeightParameters, RoughnessError> {
    const MIN_POINTS: usize = 7;
    let z = profile.heights();
    let n = sections;
    DomainError::require(n > 0, "sections", 0.0, "-", "must be at least one")?;
    RoughnessError::at_least(z.len() / n, MIN_POINTS, "the slope of a section")?;
    let parts: Vec<&[f64]> = (0..n)
        .map(|i| &z[i * z.len() / n..(i + 1) * z.len() / n])
        .collect();
    let dx = profile.spacing().si();
    let raw = match mode {
        Mode::Iso4287 => per_section(&parts, dx),
        Mode::Iso21920 => over_the_length(z, &parts, dx),
    };
    let (low, high) = extremes(z);
    Ok(raw.finish(mode, n, high - low))
}

/// Values of [`HeightParameters`] in SI units and points.
struct RawMoments {
    moments: Moments,
    rp: f64,
    rv: f64,
    rz1max: f64,
    element: Option<Element>,
    empty: usize,
    rdq: f64,
    dx: f64,
}

impl RawMoments {
    fn finish(self, mode: Mode, sections: usize, rt: f64) -> HeightParameters {
        let length = Length::from_si;
        HeightParameters {
            mode,
            sections,
            ra: length(self.moments.ra),
            rq: length(self.moments.rq),
            rsk: self.moments.shape.map(|(rsk, _)| rsk),
            rku: self.moments.shape.map(|(_, rku)| rku),
            rp: length(self.rp),
            rv: length(self.rv),
            rz: length(self.rp + self.rv),
            rz1max: length(self.rz1max),
            rt: length(rt),
            rsm: self.element.map(|element| length(element.width * self.dx)),
            rc: self.element.map(|element| length(element.height)),
            rdq: self.rdq,
            sections_without_element: self.empty,
        }
    }
}

/// Ra, Rq, and (Rsk, Rku) unless the profile is flat.
#[derive(Debug, Clone, Copy)]
struct Moments {
    ra: f64,
    rq: f64,
    shape: Option<(f64, f64)>,
}

/// Ra = ⟨|z|⟩,  Rq = √⟨z²⟩,  Rsk = ⟨z³⟩/Rq³,  Rku = ⟨z⁴⟩/Rq⁴                      [Height-1]
fn moments(z: &[f64]) -> Moments {
    cite!("Height-1");
    let n = z.len() as f64;
    let rq = (sum(z, |z| z * z) / n).sqrt();
    // Heights are divided by Rq so that their powers do not underflow.
    let shape = (rq > 0.0).then(|| {
        let scale = 1.0 / rq;
        let power = |p: i32| sum(z, |z| (z * scale).powi(p)) / n;
        (power(3), power(4))
    });
    Moments {
        ra: sum(z, f64::abs) / n,
        rq,
        shape,
    }
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0_usize), |(sum, count), value| {
        (sum + value, count + 1)
    });
    (count > 0).then(|| sum / count as f64)
}

/// X = (1/n) Σ Xᵢ over the sampling lengths; Rp = ⟨max z⟩, Rv = ⟨−min z⟩, Rz = Rp + Rv   [Height-2]
fn per_section(parts: &[&[f64]], dx: f64) -> RawMoments {
    cite!("Height-2");
    let each: Vec<HeightSection> = parts
        .iter()
        .map(|part| HeightSection::new(part, dx))
        .collect();
    let average =
        |value: fn(&HeightSection) -> f64| mean(each.iter().map(value)).unwrap_or_default();
    let shapes = || each.iter().filter_map(|section| section.moments.shape);
    let shape = mean(shapes().map(|s| s.0)).zip(mean(shapes().map(|s| s.1)));
    let found_elements: Vec<Element> = each.iter().filter_map(|section| section.element).collect();
    let ranges = each.iter().map(|section| section.high - section.low);
    RawMoments {
        moments: Moments {
            ra: average(|section| section.moments.ra),
            rq: average(|section| section.moments.rq),
            shape,
        },
        rp: average(|section| section.high),
        rv: average(|section| -section.low),
        rz1max: ranges.fold(0.0, f64::max),
        empty: parts.len() - found_elements.len(),
        element: mean_element(&found_elements),
        rdq: average(|section| section.rdq),
        dx,
    }
}

/// Height parameters of one sampling length.
struct HeightSection {
    moments: Moments,
    low: f64,
    high: f64,
    element: Option<Element>,
    rdq: f64,
}

impl HeightSection {
    fn new(z: &[f64], dx: f64) -> Self {
        let (low, high) = extremes(z);
        let threshold = DISCRIMINATION * (high - low);
        Self {
            moments: moments(z),
            low,
            high,
            element: mean_element(&elements(z, threshold, threshold)),
            rdq: mean_square(each_slope(z, dx)).sqrt(),
        }
    }
}

/// Field parameters over the evaluation length.
///
/// ```text
/// Rp, Rv = mean over sections of the highest hill and the deepest dale with its extremum in the section, or 0  [Height-3]
/// ```
fn over_the_length(z: &[f64], parts: &[&[f64]], dx: f64) -> RawMoments {
    cite!("Height-3");
    let n = parts.len();
    let (hills, dales) = hills_and_dales(z, n);
    let height = |values: &[f64]| values.iter().sum::<f64>() / n as f64;
    let (rp, rv) = (height(&hills), height(&dales));
    let ranges = hills.iter().zip(&dales).map(|(hill, dale)| hill + dale);
    let found_elements = overlapping_elements(z, DISCRIMINATION * rp, DISCRIMINATION * rv);
    RawMoments {
        moments: moments(z),
        rp,
        rv,
        rz1max: ranges.fold(0.0, f64::max),
        empty: usize::from(found_elements.is_empty()),
        element: mean_element(&found_elements),
        rdq: mean_square(each_slope(z, dx)).sqrt(),
        dx,
    }
}

/// Highest hill and deepest dale (both positive) of each of `n` sections; a hill or dale is a run of
/// points on one side of the mean line and belongs to the section of its extremum.
fn hills_and_dales(z: &[f64], n: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut hills, mut dales) = (vec![0.0; n], vec![0.0; n]);
    // Side, position and size of the extremum of the current run.
    let (mut up, mut at, mut size) = (z.first().is_some_and(|z| *z > 0.0), 0, f64::NEG_INFINITY);
    let mut close = |up: bool, at: usize, size: f64| {
        // Section i holds the points i N/n .. (i+1) N/n, rounded down.
        let section = ((at + 1) * n).div_ceil(z.len()) - 1;
        let target = if up { &mut hills } else { &mut dales };
        if let Some(best) = target.get_mut(section) {
            *best = size.max(*best);
        }
    };
    for (i, height) in z.iter().enumerate() {
        if (*height > 0.0) != up {
            close(up, at, size);
            (up, size) = (!up, f64::NEG_INFINITY);
        }
        if height.abs() > size {
            (at, size) = (i, height.abs());
        }
    }
    if !z.is_empty() {
        close(up, at, size);
    }
    (hills, dales)
}

fn mean_element(elements: &[Element]) -> Option<Element> {
    let width = mean(elements.iter().map(|element| element.width))?;
    let height = mean(elements.iter().map(|element| element.height))?;
    Some(Element { width, height })
}
