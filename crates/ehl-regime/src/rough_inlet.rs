//! Inlet of a rough contact: how far it flattens the roughness, and how much more than the smooth film it supplies.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | l, v | wavelength and variance of a component of the roughness | m, m² |
//! | a | Hertz half width | m |
//! | M, L | Moes' load and material number | - |
//! | h_g | central gap of smooth flanks | m |
//! | σ_d | standard deviation of the flattened roughness | m |
//! | Ψ | mean gap of rough flanks over h_g | - |
//! | n | wavelength over the length of the rough inlet | - |
//!
//! M^(−3/4) L^(1/2) a is the length of Grubin's inlet, (h_c R/√a)^(2/3) with h_c ∝ M^(−9/8) L^(3/4). A rough inlet ends at
//! the mean gap h_g Ψ instead of h_g and is longer. Its length is that of the geometric mean of both gaps, Ψ^(1/3) times the
//! smooth one. Compared with 57 solutions of mixed lubrication in plane strain: gap to 6 % root mean square for σ_d/h_c below
//! 3; beyond, they are not a reference, because oil cannot leak along the ridges.

use asperity_core::numerics::Solved;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::attenuation::{Attenuation, TraceSpectrum};
use crate::error::RegimeError;
use crate::gap_law::GapLaw;
use crate::inlet_flow::{Lay, inlet_factor};
use crate::patch::PatchSpectrum;

/// Power of Ψ in the length of the inlet: that of √(h_g · h_g Ψ) to the power 2/3.
const LENGTH_POWER: f64 = 1.0 / 3.0;
/// Change of ln Ψ at which the iteration ends.
const TOLERANCE: f64 = 1e-13;
/// Iterations after which the change is below the tolerance whatever the roughness: it falls at least by a third each time.
const MAX_ITERATIONS: usize = 100;
/// Relative width of the bands in which neighbouring waves are summed; it moves σ_d² by less than 4e-6 of it.
const BAND: f64 = 1.0 / 256.0;

/// Variance of two traces by wavelength.
#[derive(Debug, Clone, PartialEq)]
pub struct PairSpectrum {
    /// Wavelength \[m\] and variance \[m²\] of each band, from the longest on.
    bands: Vec<[f64; 2]>,
    /// Longest wave of each band \[m\].
    longest: Vec<f64>,
}

impl PairSpectrum {
    /// The waves of both traces, which pass each other and are unrelated.
    #[must_use]
    pub fn from_traces(traces: [&TraceSpectrum; 2]) -> Self {
        Self::of_waves(traces.into_iter().flat_map(TraceSpectrum::waves).collect())
    }

    /// The waves of two patches, each by the wavelength across the motion of the wave that the inlet flattens as much.
    #[must_use]
    pub fn of_patches(patches: [&PatchSpectrum; 2]) -> Self {
        Self::of_waves(patches.into_iter().flat_map(PatchSpectrum::waves).collect())
    }

    fn of_waves(mut waves: Vec<[f64; 2]>) -> Self {
        waves.retain(|[_, variance]| *variance > 0.0);
        waves.sort_by(|a, b| b[0].total_cmp(&a[0]));
        let (mut bands, mut starts) = (Vec::new(), Vec::new());
        let mut rest = &waves[..];
        while let Some([longest, _]) = rest.first() {
            let shortest = (1.0 - BAND) * longest;
            let count = rest.partition_point(|[length, _]| *length > shortest);
            let (band, shorter) = rest.split_at(count);
            let variance: f64 = band.iter().map(|[_, v]| v).sum();
            let length = band.iter().map(|[l, v]| l * v).sum::<f64>() / variance;
            bands.push([length, variance]);
            starts.push(*longest);
            rest = shorter;
        }
        Self {
            bands,
            longest: starts,
        }
    }

    /// Standard deviation of the flattened roughness.
    ///
    /// ```text
    /// σ_d² = Σ v A²                                                        [Pair-roughness]
    /// ```
    #[must_use]
    pub fn roughness(&self, attenuation: &Attenuation) -> Length {
        cite!("Pair-roughness");
        cite!("Venner");
        let left = self.bands.iter().map(|[length, variance]| {
            variance * attenuation.ratio_of(Length::from_si(*length)).powi(2)
        });
        Length::from_si(left.sum::<f64>().sqrt())
    }
}

impl PairSpectrum {
    /// Slope dσ_d²/d ln n \[m²\] over the wavelength scale of the flattening.
    fn roughness_slope(&self, attenuation: &Attenuation) -> f64 {
        let slope = |[length, variance]: &[f64; 2]| {
            let wave = Length::from_si(*length);
            2.0 * variance * attenuation.ratio(wave) * attenuation.slope(wave)
        };
        self.bands.iter().map(slope).sum()
    }

    /// Derivative dσ_d²/dv over the variance of a wave; the wavelength of its band is the mean over its waves.
    fn by_variance(&self, attenuation: &Attenuation, wavelength: Length) -> f64 {
        let after = self
            .longest
            .partition_point(|longest| *longest >= wavelength.si());
        let Some([length, _]) = self.bands.get(after.saturating_sub(1)) else {
            return 0.0;
        };
        let band = Length::from_si(*length);
        let ratio = attenuation.ratio(band);
        let off = wavelength / band - 1.0;
        ratio * (ratio + 2.0 * attenuation.slope(band) * off)
    }
}

/// The inlet of a rough contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughInlet {
    /// Ψ of both whole traces.
    pub inlet_factor: f64,
    /// Flattening of the roughness by this inlet.
    pub attenuation: Attenuation,
    /// Last change of ln Ψ and number of iterations.
    pub evidence: Solved,
}

impl RoughInlet {
    /// The inlet of a contact with the smooth gap h_g and the wavelength scale `nabla_per_length` of smooth flanks.
    ///
    /// ```text
    /// n = ∇ Ψ^(−1/3),  Ψ = √(1 + 2.342 t (σ_d(n)/h_g)²)                    [Rough-inlet]
    /// ```
    ///
    /// ln Ψ is a contraction of itself: the slope lies between 0 and 2/3, as A falls at most by n^(−2).
    ///
    /// # Errors
    /// When the gap is not positive or the wavelength scale negative or not finite.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{Lay, PairSpectrum, RoughInlet, TraceSpectrum};
    /// let wave: Vec<f64> = (0..400).map(|i| 0.3e-6 * (f64::from(i) * std::f64::consts::TAU / 100.0).sin()).collect();
    /// let trace = TraceSpectrum::new(&wave, Length::from_si(0.5e-6))?;
    /// let waves = PairSpectrum::from_traces([&trace, &trace]);
    /// // A thin film is fed through an inlet that the roughness lengthens: waves are flattened less.
    /// let inlet = RoughInlet::new(&waves, 1e5, Length::from_si(0.05e-6), Lay::ACROSS)?;
    /// assert!(inlet.inlet_factor > 5.0 && inlet.attenuation.nabla_per_length() < 0.6e5);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn new(
        waves: &PairSpectrum,
        nabla_per_length: f64,
        smooth_gap: Length,
        lay: Lay,
    ) -> Result<Self, RegimeError> {
        cite!("Rough-inlet");
        let factor = |sigma, _: &Attenuation| inlet_factor(sigma, smooth_gap, lay);
        Self::by(waves, nabla_per_length, smooth_gap, TOLERANCE, factor)
    }

    /// The inlet whose Ψ is `factor` of σ_d and of the flattening.
    pub(crate) fn by(
        waves: &PairSpectrum,
        nabla_per_length: f64,
        smooth_gap: Length,
        tolerance: f64,
        factor: impl Fn(Length, &Attenuation) -> Result<f64, RegimeError>,
    ) -> Result<Self, RegimeError> {
        DomainError::positive("smooth gap", smooth_gap)?;
        let mut attenuation = Attenuation::new(GapLaw::Inlet, nabla_per_length)?;
        let (mut log, mut change, mut iterations) = (0.0_f64, f64::INFINITY, 0);
        while change > tolerance && iterations < MAX_ITERATIONS {
            let next = factor(waves.roughness(&attenuation), &attenuation)?.ln();
            (change, log) = ((next - log).abs(), next);
            let scale = nabla_per_length * (-LENGTH_POWER * log).exp();
            attenuation = Attenuation::new(GapLaw::Inlet, scale)?;
            iterations += 1;
        }
        Ok(Self {
            inlet_factor: log.exp(),
            attenuation,
            evidence: Solved {
                value: log.exp(),
                residual: change,
                iterations,
            },
        })
    }

    /// Derivative d ln n/dz \[1/m\] of the wavelength scale over each height of both traces, whose variance is `waves`.
    ///
    /// ```text
    /// d ln n = −(K/3)/(1 + (K/3) ∂σ_d²/∂ ln n) Σ ∂σ_d²/∂v dv,  K = (Ψ² − 1)/(2 Ψ² σ_d²)
    /// Σ ∂σ_d²/∂v ∂v/∂z_j = (2/N) (D z)_j,  D = A² + 2 A (dA/d ln ∇)(l/l_B − 1)     [Inlet-gradient]
    /// ```
    ///
    /// D filters the trace of N points; l_B is the mean wavelength of the band that holds l.
    #[must_use]
    pub fn scale_gradient(
        &self,
        waves: &PairSpectrum,
        traces: [&TraceSpectrum; 2],
    ) -> [Vec<f64>; 2] {
        cite!("Inlet-gradient");
        let attenuation = &self.attenuation;
        let variance = waves.roughness(attenuation).si().powi(2);
        let square = self.inlet_factor * self.inlet_factor;
        let steepness = if variance > 0.0 {
            LENGTH_POWER * (square - 1.0) / (2.0 * square * variance)
        } else {
            0.0
        };
        let scale = -steepness / (1.0 + steepness * waves.roughness_slope(attenuation));
        let by_variance = |wave| waves.by_variance(attenuation, wave);
        let mut gradient = TraceSpectrum::filtered_pair(traces, by_variance);
        for of in &mut gradient {
            let each = 2.0 * scale / of.len() as f64;
            of.iter_mut().for_each(|value| *value *= each);
        }
        gradient
    }
}
