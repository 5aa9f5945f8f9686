//! Stress field under any pressure and traction on a grid.
//!
//! Pressure and traction are constant over each cell, so every cell is a loaded strip and the field is
//! exact for this load. For a smooth load with the same cell averages the error is proportional to the
//! square of the cell width. At each depth the field is a convolution of the load with the stresses of
//! a strip, computed by real transforms: one forward transform per load, and per depth four for the
//! kernels and three inverse transforms.

use std::sync::Arc;

use asperity_core::cancel::checkpoint;
use asperity_core::numerics::{good_fft_length, real_transforms};
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealToComplex};
use serde::Serialize;

use super::point::{check_poisson, max_shear, tresca, von_mises};
use super::strip::{StripStress, unit};
use crate::ContactError;

/// Depth of the field in half widths of the contact. Below, the von Mises stress is under a third of p₀.
const DEPTH_IN_HALF_WIDTHS: f64 = 3.0;
/// Largest number of depths of a grid.
const MOST_DEPTHS: usize = 1_000_000;

/// Stresses under a surface on a grid of depths and positions, tension positive.
///
/// The arrays hold one row per depth, the value at depth i and position j at i·points + j.
/// Position j is the middle of cell j: j·spacing from the first.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StressField {
    /// Depths of the rows \[m\].
    pub depths: Vec<f64>,
    /// Positions in a row.
    pub points: usize,
    /// Distance between positions.
    pub spacing: Length,
    /// σ_xx \[Pa\].
    pub sigma_xx: Vec<f64>,
    /// σ_zz \[Pa\].
    pub sigma_zz: Vec<f64>,
    /// τ_xz \[Pa\].
    pub tau_xz: Vec<f64>,
}

/// Largest value of a field and its position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Peak {
    /// The value.
    pub value: Pressure,
    /// Position along the surface, from the first point.
    pub position: Length,
    /// Depth.
    pub depth: Length,
}

/// Zone of the grid points at which the equivalent stress exceeds the elastic limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct YieldZone {
    /// Number of grid points above the limit.
    pub points: usize,
    /// Least depth above the limit.
    pub shallowest: Length,
    /// Greatest depth above the limit.
    pub deepest: Length,
    /// First position above the limit, from the first point.
    pub first: Length,
    /// Last position above the limit, from the first point.
    pub last: Length,
}

/// σ(x, z) = Σⱼ K(x − xⱼ, z)·pⱼ + Σⱼ K'(x − xⱼ, z)·qⱼ                          [Subsurface-3]
///
/// K: stresses by a uniform strip, see [`strip_unit`](super::strip_unit)                 `[Subsurface-1]`
///
/// with K = A, B, C and K' = D, C, A of [`strip_unit`](super::strip_unit) for σ_xx, σ_zz, τ_xz, and cells of
/// half width a = ½·`spacing`.
///
/// `pressure` and `traction` are per cell \[Pa\], `depths` in \[m\], zero allowed.
///
/// # Errors
/// When there is no pressure or no depth, the arrays differ in length, the spacing is not positive,
/// or a value is not finite or a depth negative.
///
/// ```
/// use asperity_contact::subsurface::subsurface_stress;
/// // Ten cells of 10 um under 1 GPa are a strip of half width 50 um: p/π at that depth.
/// let mut pressure = vec![0.0; 31];
/// pressure[10..20].fill(1e9);
/// let field = subsurface_stress(&pressure, None, "10 um".parse()?, &[5e-6, 50e-6])?;
/// let peak = field.peak(&field.max_shear()).ok_or("no field")?;
/// assert!(peak.value.si() > 0.3e9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn subsurface_stress(
    pressure: &[f64],
    traction: Option<&[f64]>,
    spacing: Length,
    depths: &[f64],
) -> Result<StressField, ContactError> {
    cite!("Subsurface-3");
    cite!("Subsurface-1");
    let dx = DomainError::positive("spacing", spacing)?;
    check(pressure, traction, depths)?;
    let points = pressure.len();
    let mut transform = Transform::new(points);
    let p = transform.spectrum(|padded| padded[..points].copy_from_slice(pressure));
    let q = traction.map(|q| transform.spectrum(|padded| padded[..points].copy_from_slice(q)));
    let size = depths.len() * points;
    let mut field = StressField {
        depths: depths.to_vec(),
        points,
        spacing,
        sigma_xx: Vec::with_capacity(size),
        sigma_zz: Vec::with_capacity(size),
        tau_xz: Vec::with_capacity(size),
    };
    for &depth in depths {
        checkpoint()?;
        let z = depth / (0.5 * dx);
        let column: Vec<StripStress> = (0..points).map(|lag| unit(2.0 * lag as f64, z)).collect();
        let a = transform.kernel(1.0, |lag| column[lag].xx_of_pressure);
        let b = transform.kernel(1.0, |lag| column[lag].zz_of_pressure);
        let c = transform.kernel(-1.0, |lag| column[lag].xz_of_pressure);
        match &q {
            None => {
                transform.convolve(&[(&a, &p)], &mut field.sigma_xx);
                transform.convolve(&[(&b, &p)], &mut field.sigma_zz);
                transform.convolve(&[(&c, &p)], &mut field.tau_xz);
            }
            Some(q) => {
                let d = transform.kernel(-1.0, |lag| column[lag].xx_of_traction);
                transform.convolve(&[(&a, &p), (&d, q)], &mut field.sigma_xx);
                transform.convolve(&[(&b, &p), (&c, q)], &mut field.sigma_zz);
                transform.convolve(&[(&c, &p), (&a, q)], &mut field.tau_xz);
            }
        }
    }
    Ok(field)
}

/// Depths for a field: a geometric series of `count` depths from `finest` to three half widths.
///
/// # Errors
/// When a length is not positive, `finest` is not less than three half widths, or `count` is below 2.
///
/// ```
/// use asperity_contact::subsurface::graded_depths;
/// let depths = graded_depths("1 um".parse()?, "100 um".parse()?, 40)?;
/// assert!(depths.len() == 40 && depths[0] == 1e-6 && (depths[39] - 300e-6).abs() < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn graded_depths(
    finest: Length,
    half_width: Length,
    count: usize,
) -> Result<Vec<f64>, ContactError> {
    let first = DomainError::positive("finest depth", finest)?;
    let last = DEPTH_IN_HALF_WIDTHS * DomainError::positive("half width", half_width)?;
    DomainError::require(
        first < last,
        "finest depth",
        first,
        "m",
        "must lie above three half widths",
    )?;
    let rule = "must be 2 to 1000000";
    DomainError::require(
        (2..=MOST_DEPTHS).contains(&count),
        "count",
        count as f64,
        "-",
        rule,
    )?;
    let step = (last / first).ln() / (count - 1) as f64;
    Ok((0..count)
        .map(|i| first * (step * i as f64).exp())
        .collect())
}

impl StressField {
    /// Position of a point, from the first point.
    pub fn position(&self, point: usize) -> Length {
        self.spacing * point as f64
    }

    /// τ₁ = √(¼·(σ_xx − σ_zz)² + τ_xz²)  `[Shear-1]`
    ///
    /// τ₁ \[Pa\] at every point, in the order of the stresses; see
    /// [`PlaneStress::max_shear`](super::PlaneStress::max_shear).
    pub fn max_shear(&self) -> Vec<f64> {
        cite!("Shear-1");
        self.every(max_shear)
    }

    /// σ_M = √(½·((σ_xx − σ_zz)² + (σ_zz − σ_yy)² + (σ_yy − σ_xx)²) + 3·τ_xz²)  `[Mises-1]`
    ///
    /// σ_M \[Pa\] at every point; see [`PlaneStress::von_mises`](super::PlaneStress::von_mises).
    ///
    /// # Errors
    /// When ν is outside −1 < ν ≤ 0.5.
    pub fn von_mises(&self, poisson: f64) -> Result<Vec<f64>, ContactError> {
        cite!("Mises-1");
        let nu = check_poisson(poisson)?;
        Ok(self.every(|stress| von_mises(stress, nu)))
    }

    /// σ_T = max(2·τ₁, |σ₁ − σ_yy|, |σ₂ − σ_yy|)  `[Tresca-1]`
    ///
    /// σ_T \[Pa\] at every point; see [`PlaneStress::tresca`](super::PlaneStress::tresca).
    ///
    /// # Errors
    /// When ν is outside −1 < ν ≤ 0.5.
    pub fn tresca(&self, poisson: f64) -> Result<Vec<f64>, ContactError> {
        cite!("Tresca-1");
        let nu = check_poisson(poisson)?;
        Ok(self.every(|stress| tresca(stress, nu)))
    }

    /// Largest of `values` \[Pa\], one per point of this field, as returned by the equivalent stresses;
    /// `None` without values.
    pub fn peak(&self, values: &[f64]) -> Option<Peak> {
        let (index, &value) = values
            .iter()
            .take(self.sigma_xx.len())
            .enumerate()
            .max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        Some(Peak {
            value: Pressure::from_si(value),
            position: self.position(index % self.points),
            depth: Length::from_si(self.depths[index / self.points]),
        })
    }

    /// Zone in which the von Mises stress exceeds the elastic limit; `None` if there is no such zone.
    ///
    /// `plastic`: [`plastic_stress`](crate::plasticity::plastic_stress) of this field, one value per point.
    ///
    /// ```
    /// use asperity_contact::plasticity::plastic_stress;
    /// use asperity_contact::subsurface::subsurface_stress;
    /// let field = subsurface_stress(&[1e9; 8], None, "10 um".parse()?, &[10e-6, 40e-6, 90e-6])?;
    /// let mises = field.von_mises(0.3)?;
    /// assert!(field.yield_zone(&plastic_stress(&mises, "2 GPa".parse()?)?).is_none());
    /// let zone = field.yield_zone(&plastic_stress(&mises, "0.45 GPa".parse()?)?).ok_or("elastic")?;
    /// assert!(zone.deepest.si() > 10e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn yield_zone(&self, plastic: &[f64]) -> Option<YieldZone> {
        let mut zone: Option<YieldZone> = None;
        for (index, _) in self.beyond(plastic) {
            let depth = Length::from_si(self.depths[index / self.points]);
            let position = self.position(index % self.points);
            let grown = zone.get_or_insert(YieldZone {
                points: 0,
                shallowest: depth,
                deepest: depth,
                first: position,
                last: position,
            });
            grown.points += 1;
            grown.shallowest = smaller(grown.shallowest, depth);
            grown.deepest = larger(grown.deepest, depth);
            grown.first = smaller(grown.first, position);
            grown.last = larger(grown.last, position);
        }
        zone
    }

    /// Share of a section in which the von Mises stress exceeds the elastic limit, 0 to 1.
    ///
    /// The section is 2·`half_width` wide about `middle`, which counts from the first point, and `half_width` deep. A
    /// depth of the grid represents the layer between the middles to its neighbours, the first one up to the surface.
    ///
    /// `plastic`: [`plastic_stress`](crate::plasticity::plastic_stress) of this field, one value per point.
    pub fn yield_share(&self, plastic: &[f64], middle: Length, half_width: Length) -> f64 {
        let reach = half_width.si();
        let middles = self.depths.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let bounds: Vec<f64> = [0.0].into_iter().chain(middles).chain([reach]).collect();
        let layers = bounds.windows(2);
        let layers: Vec<f64> = layers
            .map(|bound| bound[1].min(reach) - bound[0].min(reach))
            .collect();
        let is_below = |point: usize| (self.position(point) - middle).si().abs() <= reach;
        let columns = (0..self.points).filter(|point| is_below(*point)).count();
        let beyond = self.beyond(plastic).map(|(index, _)| index);
        let beyond = beyond.filter(|index| is_below(index % self.points));
        let area: f64 = beyond.map(|index| layers[index / self.points]).sum();
        if columns == 0 {
            return 0.0;
        }
        area / (columns as f64 * reach)
    }

    /// Points of this field with a plastic stress, with their numbers.
    fn beyond<'a>(&self, plastic: &'a [f64]) -> impl Iterator<Item = (usize, &'a f64)> {
        let of_field = plastic.iter().take(self.sigma_xx.len()).enumerate();
        of_field.filter(|(_, stress)| **stress > 0.0)
    }

    /// An equivalent stress at every point.
    fn every(&self, equivalent: impl Fn([f64; 3]) -> f64) -> Vec<f64> {
        (self.sigma_xx.iter().zip(&self.sigma_zz))
            .zip(&self.tau_xz)
            .map(|((&xx, &zz), &xz)| equivalent([xx, zz, xz]))
            .collect()
    }
}

fn smaller(a: Length, b: Length) -> Length {
    Length::from_si(a.si().min(b.si()))
}

fn larger(a: Length, b: Length) -> Length {
    Length::from_si(a.si().max(b.si()))
}

fn check(pressure: &[f64], traction: Option<&[f64]>, depths: &[f64]) -> Result<(), ContactError> {
    for (name, values) in [("pressure", pressure), ("depths", depths)] {
        if values.is_empty() {
            return Err(ContactError::WrongLength {
                name,
                need: 1,
                got: 0,
            });
        }
    }
    let traction = traction.unwrap_or(pressure);
    if traction.len() != pressure.len() {
        return Err(ContactError::WrongLength {
            name: "traction",
            need: pressure.len(),
            got: traction.len(),
        });
    }
    finite("pressure", pressure, "Pa")?;
    finite("traction", traction, "Pa")?;
    finite("depths", depths, "m")?;
    match depths.iter().position(|&z| z < 0.0) {
        None => Ok(()),
        Some(index) => Err(ContactError::BadElement {
            name: "depths",
            index,
            value: depths[index],
            unit: "m",
            rule: "must not be negative",
        }),
    }
}

fn finite(name: &'static str, values: &[f64], unit: &'static str) -> Result<(), ContactError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(ContactError::BadElement {
            name,
            index,
            value: values[index],
            unit,
            rule: "must be finite",
        }),
    }
}

type Spectrum = Vec<Complex<f64>>;

/// Convolution over a window without periodicity, by zero-padded transforms.
struct Transform {
    points: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    padded: Vec<f64>,
    product: Spectrum,
    scratch: Spectrum,
}

impl Transform {
    fn new(points: usize) -> Self {
        let length = good_fft_length(2 * points - 1);
        let (forward, inverse) = real_transforms(length);
        let scratch = forward.get_scratch_len().max(inverse.get_scratch_len());
        Self {
            points,
            padded: forward.make_input_vec(),
            product: forward.make_output_vec(),
            scratch: vec![Complex::default(); scratch],
            forward,
            inverse,
        }
    }

    /// Transform of the zero-padded values that `fill` writes.
    fn spectrum(&mut self, fill: impl FnOnce(&mut [f64])) -> Spectrum {
        self.padded.fill(0.0);
        fill(&mut self.padded);
        let mut spectrum = self.forward.make_output_vec();
        let done =
            self.forward
                .process_with_scratch(&mut self.padded, &mut spectrum, &mut self.scratch);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        spectrum
    }

    /// Transform of an even (`parity` 1) or odd (−1) kernel, from its values at lags ≥ 0.
    fn kernel(&mut self, parity: f64, value: impl Fn(usize) -> f64) -> Spectrum {
        let (points, length) = (self.points, self.padded.len());
        self.spectrum(|padded| {
            padded[0] = value(0);
            for lag in 1..points {
                padded[lag] = value(lag);
                padded[length - lag] = parity * value(lag);
            }
        })
    }

    /// Appends the sum of all kernel ∗ load within the window to `output`.
    fn convolve(&mut self, terms: &[(&Spectrum, &Spectrum)], output: &mut Vec<f64>) {
        let scale = 1.0 / self.padded.len() as f64;
        self.product.fill(Complex::default());
        for (kernel, load) in terms {
            for ((sum, kernel), load) in self.product.iter_mut().zip(*kernel).zip(*load) {
                *sum += kernel * load * scale;
            }
        }
        // Of a real signal the first coefficient and, for even lengths, the last one are real.
        self.product[0].im = 0.0;
        if let Some(last) = self.product.last_mut() {
            last.im = 0.0;
        }
        let done = self.inverse.process_with_scratch(
            &mut self.product,
            &mut self.padded,
            &mut self.scratch,
        );
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        output.extend_from_slice(&self.padded[..self.points]);
    }
}
