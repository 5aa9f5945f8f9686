//! Roughness that the inlet of a lubricated line contact flattens.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | l | wavelength of a roughness component across the ridges | m |
//! | a | Hertz half width | m |
//! | M, L | Moes' load and material number, with the sum of the surface speeds | - |
//! | ∇ | dimensionless wavelength (l/a) M^(3/4) L^(−1/2) | - |
//! | A | amplitude in the contact over amplitude outside | - |
//! | E* | reduced modulus | Pa |
//! | p′ | pressure that flattens a wave | Pa |
//! | σ_d | standard deviation of the deformed composite window | m |
//!
//! Source: C. H. Venner, F. Couhier, A. A. Lubrecht, J. A. Greenwood (1997), equation 5 as quoted by an open
//! micropitting program: line contact, ridges across the motion, pure rolling, amplitudes small against the film. It
//! holds for A up to ½ and is too small above. The gap law `power` keeps the coefficients 0.125 and 0.04 that it was
//! compared with records with: they follow the transient solver of this project within 9 % for ∇ below 8 in rolling,
//! 27 % above, within 20 % with sliding up to |SRR| = 0.5.

use std::cell::RefCell;
use std::sync::Arc;

use asperity_core::numerics::{complex_inverse, real_transforms, vectorised};
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};
use rustfft::Fft;
use rustfft::num_complex::Complex;

use crate::dimensionless::FilmGroups;
use crate::error::RegimeError;
use crate::film_line;
use crate::gap_law::GapLaw;

/// Powers of M and L in ∇.
const GROUPS: (f64, f64) = (0.75, -0.5);

/// Moes' numbers of a line contact.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct MoesNumbers {
    /// Load number M.
    pub load: f64,
    /// Material number L.
    pub material: f64,
}

impl MoesNumbers {
    /// Moes' numbers from the groups with the mean speed.
    ///
    /// ```text
    /// M = W (2U)^(−1/2),  L = G (2U)^(1/4)                                   [Moes-numbers]
    /// ```
    ///
    /// # Errors
    /// When a group is not finite and positive.
    ///
    /// ```
    /// use asperity_ehl_regime::{FilmGroups, attenuation::MoesNumbers};
    /// let numbers = MoesNumbers::from_groups(&FilmGroups { material: 4000.0, speed: 5e-11, load: 1e-4 })?;
    /// assert!((numbers.load - 10.0).abs() < 1e-12 && (numbers.material - 4000.0 * 1e-10f64.sqrt().sqrt()).abs() < 1e-9);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn from_groups(groups: &FilmGroups) -> Result<Self, RegimeError> {
        cite!("Moes-numbers");
        let (g, u, w) = film_line::checked(groups)?;
        Ok(Self {
            load: w / (2.0 * u).sqrt(),
            material: g * (2.0 * u).sqrt().sqrt(),
        })
    }

    /// Dimensionless wavelength of one metre.
    ///
    /// ```text
    /// ∇/l = M^(3/4) L^(−1/2)/a                                              [Venner-nabla]
    /// ```
    ///
    /// # Errors
    /// When the half width is not positive.
    pub fn nabla_per_length(&self, half_width: Length) -> Result<f64, RegimeError> {
        cite!("Venner-nabla");
        let a = DomainError::positive("half width", half_width)?;
        Ok(self.load.powf(GROUPS.0) * self.material.powf(GROUPS.1) / a)
    }
}

/// ∇² at which X of \[Ripple-pressure\] changes from a power of -2 of ∇ to -1; fitted to the films of eight waves that were solved in
/// pure rolling.
const ROLLED: f64 = 12.0;

/// Flattening of roughness waves in the inlet of one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attenuation {
    fall: [f64; 2],
    nabla_per_length: f64,
}

impl Attenuation {
    /// The flattening with the coefficients of a gap law, at a wavelength scale of [`MoesNumbers::nabla_per_length`].
    ///
    /// # Errors
    /// When the scale is negative or not finite.
    pub fn new(law: GapLaw, nabla_per_length: f64) -> Result<Self, RegimeError> {
        let rule = "must be finite and not negative";
        let fits = nabla_per_length.is_finite() && nabla_per_length >= 0.0;
        DomainError::require(fits, "nabla per length", nabla_per_length, "1/m", rule)?;
        Ok(Self {
            fall: law.fall(),
            nabla_per_length,
        })
    }

    /// Dimensionless wavelength of one metre.
    #[must_use]
    pub fn nabla_per_length(&self) -> f64 {
        self.nabla_per_length
    }

    /// Amplitude of a wave in the contact over its amplitude outside.
    ///
    /// ```text
    /// A = 1/(1 + 0.17 ∇ + 0.03 ∇²), `power`: 1/(1 + 0.125 ∇ + 0.04 ∇²)           [Venner]
    /// ```
    ///
    /// 1 for short waves, which pass undeformed; 0 for long ones.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Attenuation, GapLaw};
    /// let [inlet, power] = [GapLaw::Inlet, GapLaw::Power].map(|law| Attenuation::new(law, 1e5));
    /// let wave = Length::from_si(100e-6);
    /// assert!((inlet?.ratio(wave) - 1.0 / 5.7).abs() < 1e-15);
    /// assert!((power?.ratio(wave) - 1.0 / 6.25).abs() < 1e-15);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn ratio(&self, wavelength: Length) -> f64 {
        cite!("Venner");
        self.ratio_of(wavelength)
    }

    /// [`ratio`](Self::ratio) for a loop over many waves, around which the equation is cited.
    pub(crate) fn ratio_of(&self, wavelength: Length) -> f64 {
        self.ratio_at(self.nabla_per_length * wavelength.si())
    }

    fn ratio_at(&self, nabla: f64) -> f64 {
        let [first, second] = self.fall;
        1.0 / (1.0 + nabla * (first + second * nabla))
    }

    /// Pressure of a wave in the contact over its height outside \[Pa/m\].
    ///
    /// ```text
    /// p′/z = (π E*/l)/√(1 + X²),  X = 2 √(12 + ∇²)/∇²                                               [Ripple-pressure]
    /// ```
    ///
    /// A wave of pressure of amplitude p displaces both surfaces by p l/(π E*). The 12 fits the films of waves that were solved in
    /// pure rolling, from ∇ = 1.4 to 30 within .1, seven of eight within .02; in this fit pressure and film are a quarter of a wave apart. Pressures of eight
    /// other waves, which the fit has not seen, are 1.1 to 1.4 times the solved ones, one is twice as high.
    ///
    /// ```
    /// use asperity_core::quantity::{Length, Pressure};
    /// use asperity_ehl_regime::{Attenuation, GapLaw};
    /// let (wave, modulus) = (Length::from_si(50e-6), Pressure::from_si(115e9));
    /// let pressure = |nabla| Attenuation::new(GapLaw::Inlet, nabla).map(|a| a.ripple(wave, modulus));
    /// assert_eq!(pressure(0.0)?, 0.0);
    /// // A wave that is pressed flat altogether.
    /// assert!((pressure(1e12)? / (std::f64::consts::PI * 115e9 / 50e-6) - 1.0).abs() < 1e-12);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn ripple(&self, wavelength: Length, modulus: Pressure) -> f64 {
        cite!("Ripple-pressure");
        self.ripple_of(wavelength, modulus)
    }

    /// [`ripple`](Self::ripple) for a loop over many waves, around which the equation is cited.
    fn ripple_of(&self, wavelength: Length, modulus: Pressure) -> f64 {
        std::f64::consts::PI * modulus.si() / wavelength.si() * self.pressed(wavelength)
    }

    /// Pressure of a wave over the pressure that presses it flat.
    pub(crate) fn pressed(&self, wavelength: Length) -> f64 {
        let [pressed, ..] = self.rolled(wavelength);
        pressed
    }

    /// Slope of [`ripple`](Self::ripple) over ln ∇ \[Pa/m\].
    #[must_use]
    pub fn ripple_slope(&self, wavelength: Length, modulus: Pressure) -> f64 {
        let [pressed, film, rise] = self.rolled(wavelength);
        std::f64::consts::PI * modulus.si() / wavelength.si() * pressed * film * film * rise
    }

    /// Amplitude of a wave in the film over its amplitude outside.
    ///
    /// ```text
    /// z_f/z = X/√(1 + X²)                                                                       [Ripple-height]
    /// ```
    ///
    /// X as in \[Ripple-pressure\]. The amplitude [`ratio`](Self::ratio), with which roughness enters the supply, is smaller for short waves.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Attenuation, GapLaw};
    /// let film = |nabla| Attenuation::new(GapLaw::Inlet, nabla).map(|a| a.film_ratio(Length::from_si(1.0)));
    /// assert_eq!(film(0.0)?, 1.0);
    /// // Solved waves: .90, .59 and .14.
    /// assert!((film(1.87)? - 0.92).abs() < 0.01 && (film(3.73)? - 0.59).abs() < 0.01);
    /// assert!((film(14.9)? - 0.14).abs() < 0.01);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn film_ratio(&self, wavelength: Length) -> f64 {
        cite!("Ripple-height");
        self.film_ratio_of(wavelength)
    }

    /// [`film_ratio`](Self::film_ratio) for a loop over many waves, around which the equation is cited.
    pub(crate) fn film_ratio_of(&self, wavelength: Length) -> f64 {
        let [_, film, _] = self.rolled(wavelength);
        film
    }

    /// Slope of [`film_ratio`](Self::film_ratio) over ln ∇.
    #[must_use]
    pub fn film_slope(&self, wavelength: Length) -> f64 {
        let [pressed, film, rise] = self.rolled(wavelength);
        -film * pressed * pressed * rise
    }

    /// 1/√(1 + X²) and X/√(1 + X²) with X of \[Ripple-pressure\], and the slope of -ln X over ln ∇.
    #[inline(always)]
    fn rolled(&self, wavelength: Length) -> [f64; 3] {
        let nabla = self.nabla_per_length * wavelength.si();
        let square = nabla * nabla;
        let short = ROLLED + square;
        let inverse = 1.0 / (square * square + 4.0 * short).sqrt();
        [
            square * inverse,
            2.0 * short.sqrt() * inverse,
            2.0 - square / short,
        ]
    }

    /// Slope dA/d ln ∇ at a wavelength.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Attenuation, GapLaw};
    /// let wave = Length::from_si(20e-6);
    /// let ratio = |nabla: f64| Attenuation::new(GapLaw::Inlet, nabla).map(|a| a.ratio(wave));
    /// let quotient = (ratio(1e5 * 1.0001)? - ratio(1e5 * 0.9999)?) / 2e-4;
    /// let slope = Attenuation::new(GapLaw::Inlet, 1e5)?.slope(wave);
    /// assert!((slope / quotient - 1.0).abs() < 1e-7);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn slope(&self, wavelength: Length) -> f64 {
        let nabla = self.nabla_per_length * wavelength.si();
        let [first, second] = self.fall;
        -self.ratio_at(nabla).powi(2) * nabla * (first + 2.0 * second * nabla)
    }
}

/// Pressures \[Pa\] of the waves of two rough flanks in a contact, and their heights in its film \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ripples<T> {
    /// Pressures p′.
    pub pressures: T,
    /// Heights z_f.
    pub heights: T,
}

impl<T> Ripples<T> {
    /// `of` pressures and of heights.
    pub fn each<'a, S>(&'a self, of: impl Fn(&'a T) -> S) -> Ripples<S> {
        Ripples {
            pressures: of(&self.pressures),
            heights: of(&self.heights),
        }
    }
}

/// The spectrum of a whole prepared trace, to be attenuated for any contact.
///
/// The trace is taken as periodic and its mean as form: windows are cut from the attenuated whole.
#[derive(Clone)]
pub struct TraceSpectrum {
    spectrum: Vec<Complex<f64>>,
    /// Complex, as one such transform gives the heights of two traces.
    inverse: Arc<dyn Fft<f64>>,
    points: usize,
    spacing: f64,
}

impl std::fmt::Debug for TraceSpectrum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TraceSpectrum")
            .field("points", &self.points)
            .field("spacing", &self.spacing)
            .finish_non_exhaustive()
    }
}

impl TraceSpectrum {
    /// The spectrum of heights in m, `spacing` apart.
    ///
    /// # Errors
    /// When the spacing is not positive, there are fewer than two heights or one is not finite.
    pub fn new(heights: &[f64], spacing: Length) -> Result<Self, RegimeError> {
        let dx = DomainError::positive("spacing", spacing)?;
        let points = heights.len();
        let rule = "at least two heights are needed";
        DomainError::require(points > 1, "heights", points as f64, "-", rule)?;
        for &z in heights {
            DomainError::finite("height", Length::from_si(z))?;
        }
        let (forward, _) = real_transforms(points);
        let mut signal = heights.to_vec();
        let mut spectrum = forward.make_output_vec();
        let done = forward.process(&mut signal, &mut spectrum);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        Ok(Self {
            spectrum,
            inverse: complex_inverse(points),
            points,
            spacing: dx,
        })
    }

    /// Heights \[m\] of the trace in the contact, free of their mean.
    ///
    /// ```text
    /// ẑ_d = A ẑ                                                          [Attenuated-trace]
    /// ```
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Attenuation, GapLaw, TraceSpectrum};
    /// // A wave of 20 um at 0.5 um spacing, ∇ = 10: A = 1/6.25.
    /// let wave: Vec<f64> = (0..400).map(|i| (f64::from(i) * std::f64::consts::TAU / 40.0).sin()).collect();
    /// let spectrum = TraceSpectrum::new(&wave, Length::from_si(0.5e-6))?;
    /// let flat = spectrum.attenuated(&Attenuation::new(GapLaw::Power, 10.0 / 20e-6)?);
    /// assert!((flat[10] - wave[10] / 6.25).abs() < 1e-12);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    #[must_use]
    pub fn attenuated(&self, attenuation: &Attenuation) -> Vec<f64> {
        cite!("Venner");
        self.filtered(|wavelength| attenuation.ratio_of(wavelength))
    }

    /// Heights \[m\] of two traces in the contact, as [`TraceSpectrum::attenuated`] gives each.
    #[must_use]
    pub fn attenuated_pair(
        [first, second]: [&Self; 2],
        attenuation: &Attenuation,
    ) -> [Vec<f64>; 2] {
        cite!("Venner");
        Self::filtered_pair([first, second], |wavelength| {
            attenuation.ratio_of(wavelength)
        })
    }

    /// Pressures \[Pa\] of the waves of two traces in the contact by \[Ripple-pressure\], and their heights in the film \[m\] by
    /// \[Ripple-height\], free of their means.
    #[must_use]
    pub fn ripple_pair(
        traces: [&Self; 2],
        attenuation: &Attenuation,
        modulus: Pressure,
    ) -> Ripples<[Vec<f64>; 2]> {
        cite!("Ripple-pressure");
        cite!("Ripple-height");
        Ripples {
            pressures: Self::filtered_pair(traces, |wave| attenuation.ripple_of(wave, modulus)),
            heights: Self::filtered_pair(traces, |wave| attenuation.film_ratio_of(wave)),
        }
    }

    /// [`filtered`](Self::filtered) of two traces, which cost one transform together if they have as many points.
    #[must_use]
    pub fn filtered_pair(
        [first, second]: [&Self; 2],
        factor: impl Fn(Length) -> f64,
    ) -> [Vec<f64>; 2] {
        cite!("Attenuated-trace");
        if first.points == second.points && first.spacing == second.spacing {
            Self::transformed(first, Some(second), factor)
        } else {
            [first, second].map(|trace| trace.filtered(&factor))
        }
    }

    /// Heights of the trace, free of their mean, each wave multiplied by `factor` of its wavelength.
    ///
    /// A filter is its own adjoint: Σ y F(z) = Σ F(y) z.
    #[must_use]
    pub fn filtered(&self, factor: impl Fn(Length) -> f64) -> Vec<f64> {
        cite!("Attenuated-trace");
        let [heights, _] = Self::transformed(self, None, factor);
        heights
    }

    /// Sums y = F₁ s₁ + F₂ s₂ + … of signals of each of two traces, free of their means: each wave of a signal is multiplied by
    /// its factor of `factors` of the wavelength.
    ///
    /// Traces with the same number of points share the transforms of their signals and of the sums.
    #[must_use]
    pub fn filtered_sums<const N: usize>(
        [first, second]: [&Self; 2],
        [of_first, of_second]: [[&[f64]; N]; 2],
        factors: impl Fn(Length) -> [f64; N],
    ) -> [Vec<f64>; 2] {
        cite!("Attenuated-trace");
        if first.points == second.points && first.spacing == second.spacing {
            return first.summed(of_first, Some(of_second), factors);
        }
        let [one, _] = first.summed(of_first, None, &factors);
        let [other, _] = second.summed(of_second, None, &factors);
        [one, other]
    }

    /// The sum of filtered signals, and the sum of the signals of another trace with the same number of points.
    fn summed<const N: usize>(
        &self,
        signals: [&[f64]; N],
        others: Option<[&[f64]; N]>,
        factors: impl Fn(Length) -> [f64; N],
    ) -> [Vec<f64>; 2] {
        let n = self.points;
        let length = n as f64 * self.spacing;
        let scaled =
            |k: usize| factors(Length::from_si(length / k as f64)).map(|factor| factor / n as f64);
        let factors: Vec<_> = (1..=n / 2).map(scaled).collect();
        let mut sums = vec![Complex::default(); n];
        for which in 0..N {
            let other = |i: usize| others.map_or(0.0, |others| others[which][i]);
            // The inverse transform of the conjugate is the conjugate of the transform.
            let signal = signals[which].iter().enumerate();
            let mut waves: Vec<_> = signal.map(|(i, z)| Complex::new(*z, -other(i))).collect();
            self.inverse.process(&mut waves);
            for (k, factors) in (1..).zip(&factors) {
                sums[k] += waves[k].conj() * factors[which];
                if 2 * k != n {
                    sums[n - k] += waves[n - k].conj() * factors[which];
                }
            }
        }
        self.inverse.process(&mut sums);
        [
            sums.iter().map(|value| value.re).collect(),
            sums.iter().map(|value| value.im).collect(),
        ]
    }

    /// Heights of one trace, or of two of as many points in the real and the imaginary part of one signal.
    fn transformed(
        first: &Self,
        second: Option<&Self>,
        factor: impl Fn(Length) -> f64,
    ) -> [Vec<f64>; 2] {
        thread_local! {
            /// The signal and the work space of its transform, kept: a run needs thousands, and clearing new ones took a
            /// fiftieth of its time.
            static SPACE: RefCell<Vec<Complex<f64>>> = const { RefCell::new(Vec::new()) };
        }
        let mut space = SPACE.take();
        let heights = Self::transformed_in(&mut space, first, second, factor);
        SPACE.set(space);
        heights
    }

    /// [`Self::transformed`], computed in `space`, which may hold anything.
    fn transformed_in(
        space: &mut Vec<Complex<f64>>,
        first: &Self,
        second: Option<&Self>,
        factor: impl Fn(Length) -> f64,
    ) -> [Vec<f64>; 2] {
        let points = first.points;
        let length = points as f64 * first.spacing;
        space.resize(
            points + first.inverse.get_inplace_scratch_len(),
            Complex::default(),
        );
        let (signal, work) = space.split_at_mut(points);
        // The mean; all other coefficients follow.
        signal[0] = Complex::default();
        let count = first.spectrum.len() - 1;
        let mut scales = vec![0.0; count];
        vectorised(
            #[inline(always)]
            || {
                for (k, scale) in (1..).zip(&mut scales) {
                    let wave: i32 = k;
                    *scale = factor(Length::from_si(length / f64::from(wave))) / points as f64;
                }
            },
        );
        let (low, high) = signal[1..].split_at_mut(count);
        let others = second.map(|second| &second.spectrum[1..]);
        // What one wave of both traces is in the signal, and its mirror image.
        let both = |k: usize, scale: f64| {
            let one = first.spectrum[k + 1] * scale;
            let other = others.map_or_else(Complex::default, |others| others[k] * scale);
            [
                Complex::new(one.re - other.im, one.im + other.re),
                Complex::new(one.re + other.im, other.re - one.im),
            ]
        };
        // Of an even number of points the last wave is its own mirror image: real.
        if let Some(last) = low.get_mut(high.len()) {
            let [one, mirror] = both(high.len(), scales[count - 1]);
            *last = 0.5 * (one + mirror);
        }
        let places = low.iter_mut().zip(high.iter_mut().rev()).enumerate();
        for ((k, (place, mirror)), scale) in places.zip(&scales) {
            [*place, *mirror] = both(k, *scale);
        }
        first.inverse.process_with_scratch(signal, work);
        let imaginary = |_: &Self| signal.iter().map(|value| value.im).collect();
        [
            signal.iter().map(|value| value.re).collect(),
            second.map_or_else(Vec::new, imaginary),
        ]
    }

    /// Wavelength \[m\] and variance \[m²\] of every wave.
    pub(crate) fn waves(&self) -> impl Iterator<Item = [f64; 2]> {
        let points = self.points as f64;
        let length = points * self.spacing;
        let waves = self.spectrum.iter().enumerate().skip(1);
        waves.map(move |(k, value)| {
            let mirrors = if 2 * k == self.points { 1.0 } else { 2.0 };
            let variance = mirrors * value.norm_sqr() / (points * points);
            [length / k as f64, variance]
        })
    }

    /// Distance of the points.
    #[must_use]
    pub fn spacing(&self) -> Length {
        Length::from_si(self.spacing)
    }

    /// Number of points of the trace.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }
}
