//! Heights over a rectangle of a flank, and their waves in both directions.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, y | along rolling, along the lead | m |
//! | λ_x, λ_y | wavelengths of a component along x and y | m |
//! | r | λ_x/λ_y: 0 across the motion, 1 without a direction, ∞ along it | - |
//! | λ_e | wavelength across the motion of the wave that the inlet flattens as much | m |
//!
//! A patch is repeated in both directions. A measured one must be mirrored first, so that it repeats without a jump.
//!
//! The rule for λ_e is derived with the linearised inlet of references/rough_inlet.py, extended to waves that vary along the lead:
//! four contacts with M 26 to 200 and L 7 to 11, waves of ¼ to 2 half widths. As far as half of the amplitude is left at
//! most, λ_e/min(λ_x, λ_y) is 0.9 to 1 for r up to 1, 1.3 to 1.6 for r = 2, 1.6 to 2.0 for r = 4 and 1.8 to 2.2 for r = 16. Shorter waves
//! along the motion are flattened more than this. Across the motion λ_e is λ_x exactly.

use std::sync::Arc;

use asperity_core::numerics::{complex_inverse, real_transforms};
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};
use rustfft::Fft;
use rustfft::num_complex::Complex;

use crate::attenuation::{Attenuation, Ripples};
use crate::error::RegimeError;

/// λ_e of a long wave along the motion over λ_y.
const ALONG: f64 = 2.0;

/// The points of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchGrid {
    size: [usize; 2],
    spacing: [f64; 2],
}

impl PatchGrid {
    /// Number of heights along rolling and along the lead.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Distance of the heights along rolling and along the lead.
    #[must_use]
    pub fn spacing(&self) -> [Length; 2] {
        self.spacing.map(Length::from_si)
    }
}

/// Heights of one flank, or of two together, on a rectangular grid, free of their mean.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    heights: Vec<f64>,
    grid: PatchGrid,
}

impl Patch {
    /// Rows of heights \[m\] one after another, each along rolling: number of heights in a row and of rows, and their distances.
    ///
    /// # Errors
    /// When the number of heights is not the product of `size`, one of both is below two, a distance is not positive or a
    /// height not finite.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::Patch;
    /// let um = |value: f64| Length::from_si(value * 1e-6);
    /// let patch = Patch::new(vec![0.0, 2e-7, 0.0, 2e-7], [2, 2], [um(1.0), um(2.0)])?;
    /// assert_eq!(patch.rms(), um(0.1));
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn new(
        mut heights: Vec<f64>,
        size: [usize; 2],
        spacing: [Length; 2],
    ) -> Result<Self, RegimeError> {
        let [dx, dy] = spacing;
        let spacing = [
            DomainError::positive("spacing along rolling", dx)?,
            DomainError::positive("spacing along the lead", dy)?,
        ];
        let number = heights.len();
        let rule = "must be the product of two numbers of heights from 2 on";
        let fits = size[0] > 1 && size[1] > 1 && Some(number) == size[0].checked_mul(size[1]);
        DomainError::require(fits, "heights of a patch", number as f64, "-", rule)?;
        for &z in &heights {
            DomainError::finite("height", Length::from_si(z))?;
        }
        let mean = heights.iter().sum::<f64>() / number as f64;
        heights.iter_mut().for_each(|z| *z -= mean);
        let grid = PatchGrid { size, spacing };
        Ok(Self { heights, grid })
    }

    /// Heights \[m\] over their mean, row by row.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Points of the patch.
    #[must_use]
    pub const fn grid(&self) -> PatchGrid {
        self.grid
    }

    /// Standard deviation of the heights.
    #[must_use]
    pub fn rms(&self) -> Length {
        let squares = self.heights.iter().map(|z| z * z).sum::<f64>();
        Length::from_si((squares / self.heights.len() as f64).sqrt())
    }

    /// Composite of this patch and another one, which is moved by whole numbers of heights: the flanks as they face each other.
    pub(crate) fn composite(mut self, other: &Self, [x, y]: [usize; 2]) -> Self {
        let [columns, rows] = self.grid.size;
        for (j, row) in self.heights.chunks_exact_mut(columns).enumerate() {
            let from = &other.heights[(j + y) % rows * columns..][..columns];
            for (i, z) in row.iter_mut().enumerate() {
                *z += from[(i + x) % columns];
            }
        }
        self
    }
}

/// A wave of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PatchWave {
    /// Wavenumbers along rolling and along the lead \[1/m\]: numbers of waves in a metre.
    numbers: [f64; 2],
}

impl PatchWave {
    /// Wavelength of the wave across the motion that the inlet flattens as much.
    ///
    /// ```text
    /// λ_e = λ_x for r ≤ 1, 2^(1 − 1/r) λ_y for r > 1,  r = λ_x/λ_y                 [Patch-wave]
    /// ```
    ///
    /// Oil leaves a wave along the motion along its own length: the inlet takes it for one up to twice as long.
    pub fn effective(self) -> Length {
        let [x, y] = self.numbers;
        Length::from_si(if x >= y {
            1.0 / x
        } else {
            ALONG.powf(1.0 - x / y) / y
        })
    }

    /// Wavelength in its own direction, which its elastic deformation depends on.
    fn true_length(self) -> Length {
        let [x, y] = self.numbers;
        Length::from_si(1.0 / x.hypot(y))
    }
}

/// The waves of a patch, to be flattened by the inlet of any contact.
#[derive(Clone)]
pub struct PatchSpectrum {
    /// For each wavenumber along rolling from zero on, those along the lead.
    waves: Vec<Complex<f64>>,
    along_lead: Arc<dyn Fft<f64>>,
    grid: PatchGrid,
}

impl std::fmt::Debug for PatchSpectrum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PatchSpectrum")
            .field("grid", &self.grid)
            .finish_non_exhaustive()
    }
}

impl PatchSpectrum {
    /// The waves of a patch.
    #[must_use]
    pub fn new(patch: &Patch) -> Self {
        let [columns, rows] = patch.grid.size;
        let (forward, _) = real_transforms(columns);
        let along_lead = complex_inverse(rows);
        let numbers = columns / 2 + 1;
        let mut waves = vec![Complex::default(); numbers * rows];
        let (mut row, mut of_row) = (vec![0.0; columns], forward.make_output_vec());
        for j in 0..rows {
            row.copy_from_slice(&patch.heights[j * columns..][..columns]);
            let done = forward.process(&mut row, &mut of_row);
            debug_assert!(done.is_ok(), "buffers are made by the plan");
            for (k, value) in of_row.iter().enumerate() {
                // The inverse transform of the conjugates is the conjugate of the transform.
                waves[k * rows + j] = value.conj();
            }
        }
        for column in waves.chunks_exact_mut(rows) {
            along_lead.process(column);
            column.iter_mut().for_each(|value| *value = value.conj());
        }
        Self {
            waves,
            along_lead,
            grid: patch.grid,
        }
    }

    /// Points of the patch.
    #[must_use]
    pub const fn grid(&self) -> PatchGrid {
        self.grid
    }

    /// The patch that the inlet of a contact leaves.
    ///
    /// ```text
    /// ẑ_d = A(λ_e) ẑ                                                       [Attenuated-patch]
    /// ```
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Attenuation, GapLaw, Patch, PatchSpectrum};
    /// // A wave of 20 um across rolling at 0.5 um spacing, ∇ = 10: A = 1/5.7.
    /// let z = |i: usize| ((i % 40) as f64 * std::f64::consts::TAU / 40.0).sin();
    /// let um = Length::from_si(0.5e-6);
    /// let patch = Patch::new((0..400).map(z).collect(), [40, 10], [um, um])?;
    /// let left = PatchSpectrum::new(&patch).attenuated(&Attenuation::new(GapLaw::Inlet, 10.0 / 20e-6)?);
    /// assert!((left.heights()[10] - 1.0 / 5.7).abs() < 1e-12);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn attenuated(&self, attenuation: &Attenuation) -> Patch {
        cite!("Attenuated-patch");
        cite!("Patch-wave");
        cite!("Venner");
        self.filtered(|wave| attenuation.ratio_of(wave.effective()))
    }

    /// Pressures \[Pa\] of the waves of the patch in the contact over their mean, and their heights in the film, row by row.
    ///
    /// ```text
    /// p′/z = (π E*/λ)/√(1 + X²),  z_f/z = X/√(1 + X²),  1/λ² = 1/λ_x² + 1/λ_y²                  [Patch-ripple]
    /// ```
    ///
    /// X as in \[Ripple-pressure\], at λ_e. A wave of pressure of amplitude p displaces both surfaces by p λ/(π E*),
    /// whatever its direction.
    #[must_use]
    pub fn ripple(&self, attenuation: &Attenuation, modulus: Pressure) -> Ripples<Vec<f64>> {
        cite!("Patch-ripple");
        cite!("Patch-wave");
        let pressures = self.filtered(|wave| {
            let flat = std::f64::consts::PI * modulus.si() / wave.true_length().si();
            flat * attenuation.pressed(wave.effective())
        });
        let heights = self.filtered(|wave| attenuation.film_ratio_of(wave.effective()));
        Ripples {
            pressures: pressures.heights,
            heights: heights.heights,
        }
    }

    /// Mean product of two heights \[m²\] over their distance in points, row by row; the patch repeats.
    #[must_use]
    pub fn autocorrelation(&self) -> Vec<f64> {
        let points = (self.grid.size[0] * self.grid.size[1]) as f64;
        let power = |wave: &Complex<f64>| Complex::new(wave.norm_sqr() / points, 0.0);
        self.inverse(self.waves.iter().map(power).collect(), |_| 1.0)
            .heights
    }

    fn filtered(&self, factor: impl Fn(PatchWave) -> f64) -> Patch {
        self.inverse(self.waves.clone(), factor)
    }

    /// Heights of waves in the order of the spectrum, each times a factor.
    fn inverse(&self, mut waves: Vec<Complex<f64>>, factor: impl Fn(PatchWave) -> f64) -> Patch {
        let [columns, rows] = self.grid.size;
        let numbers = columns / 2 + 1;
        let scale = 1.0 / (columns * rows) as f64;
        waves[0] = Complex::default();
        for (k, column) in waves.chunks_exact_mut(rows).enumerate() {
            // A wave and its image in the lead are flattened alike.
            for j in usize::from(k == 0)..=rows / 2 {
                let of_both = scale * factor(self.wave(k * rows + j));
                column[j] *= of_both;
                if j > 0 && 2 * j < rows {
                    column[rows - j] *= of_both;
                }
            }
            self.along_lead.process(column);
        }
        let (_, inverse) = real_transforms(columns);
        let mut heights = vec![0.0; columns * rows];
        let mut of_row = vec![Complex::default(); numbers];
        for (j, row) in heights.chunks_exact_mut(columns).enumerate() {
            for (k, value) in of_row.iter_mut().enumerate() {
                *value = waves[k * rows + j];
            }
            // Real by symmetry but for rounding, which the transform refuses.
            of_row[0].im = 0.0;
            if columns % 2 == 0 {
                of_row[numbers - 1].im = 0.0;
            }
            let done = inverse.process(&mut of_row, row);
            debug_assert!(done.is_ok(), "buffers have the lengths of the plan");
        }
        Patch {
            heights,
            grid: self.grid,
        }
    }

    fn wave(&self, index: usize) -> PatchWave {
        let [columns, rows] = self.grid.size;
        let (k, j) = (index / rows, index % rows);
        let [dx, dy] = self.grid.spacing;
        let numbers = [
            k as f64 / (columns as f64 * dx),
            j.min(rows - j) as f64 / (rows as f64 * dy),
        ];
        PatchWave { numbers }
    }

    /// Every wave with its variance \[m²\].
    fn variances(&self) -> impl Iterator<Item = (PatchWave, f64)> {
        let [columns, rows] = self.grid.size;
        let points = (columns * rows) as f64;
        let waves = self.waves.iter().enumerate().skip(1);
        waves.map(move |(index, value)| {
            let k = index / rows;
            let mirrors = if k == 0 || 2 * k == columns { 1.0 } else { 2.0 };
            let variance = mirrors * value.norm_sqr() / (points * points);
            (self.wave(index), variance)
        })
    }

    /// Wavelength λ_e \[m\] and variance \[m²\] of every wave.
    pub(crate) fn waves(&self) -> impl Iterator<Item = [f64; 2]> {
        cite!("Patch-wave");
        let waves = self.variances();
        waves.map(|(wave, variance)| [wave.effective().si(), variance])
    }

    /// Mean of k_x²/k² over the waves, weighted with their variances: 1 across the motion, ½ without a lay, 0 along it, also
    /// without roughness.
    #[must_use]
    pub fn mean_square_cosine(&self) -> f64 {
        let (mut along, mut all) = (0.0, 0.0);
        for (wave, variance) in self.variances() {
            let [x, y] = wave.numbers;
            along += variance * x * x / (x * x + y * y);
            all += variance;
        }
        if all > 0.0 { along / all } else { 0.0 }
    }
}
