//! Parameters calibrated on a rig, with their 95 % intervals.

use asperity_core::Estimate;
use asperity_core::numerics::Cholesky;
use asperity_core::quantity::{Length, Pressure};
use serde::{Deserialize, Serialize};

use super::rows::{KeyNumbers, OPEN, table};

table! {
    /// Parameters calibrated on a rig, each with the 95 % interval from which the interval of the loss is sampled.
    ///
    /// `asperity calibrate` writes this table. A parameter that is left out keeps its default and its range.
    #[derive(Default)]
    CalibrationInput;

    /// Measurements from which the values come; printed with every result.
    source: Option<String>;
    /// Whether the measurements were simulated, as in a rehearsal; every result then says so (W446). Default false.
    simulated: Option<bool>;
    /// Coefficient of boundary friction μ_b, instead of `model.boundary_friction`.
    boundary_friction: Option<Estimate<f64>> = "" usual [0.02, 0.5] possible [0.001, 5.0];
    /// Thickness of the boundary layer h_b, instead of `model.boundary_layer`.
    boundary_layer: Option<Estimate<Length>> = "nm" usual [0.5, 200.0] possible [0.001, 10_000.0];
    /// Limiting shear stress of the oil over its pressure, instead of the value of its family.
    limiting_shear: Option<Estimate<f64>> = "" usual [0.01, 0.2] possible [0.001, 2.0];
    /// Eyring stress of the oil, instead of the value of its family.
    eyring_stress: Option<Estimate<Pressure>> = "MPa" usual [0.5, 100.0] possible [0.001, 10_000.0];
    /// Correlations of the logarithms, pair by pair: `[{ between = ["boundary_friction", "boundary_layer"],
    /// value = -0.9 }]`; default none.
    correlations: Option<Vec<CorrelationInput>> => table;
}

impl<T: KeyNumbers> KeyNumbers for Estimate<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        let values = [&self.value, &self.low, &self.high].into_iter();
        values.flat_map(|value| value.numbers(unit)).collect()
    }
}

/// A parameter that can be calibrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "snake_case")]
pub enum CalibratedName {
    /// Coefficient of boundary friction
    BoundaryFriction,
    /// Thickness of the boundary layer, which determines the share of boundary friction
    BoundaryLayer,
    /// Ratio of limiting shear stress to pressure
    LimitingShear,
    /// Eyring stress
    EyringStress,
}

table! {
    /// Correlation of two parameters, of their logarithms where these are normal.
    #[derive(Copy)]
    CorrelationInput<N = CalibratedName>;

    /// The two parameters.
    between: [N; 2];
    /// Their correlation, between -1 and 1.
    value: f64 = "" usual [-1.0, 1.0] possible OPEN;
}

impl CalibratedName {
    /// All, in the order of the case file.
    pub const ALL: [Self; 4] = [
        Self::BoundaryFriction,
        Self::BoundaryLayer,
        Self::LimitingShear,
        Self::EyringStress,
    ];

    /// The key in the table `calibration`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::BoundaryFriction => "boundary_friction",
            Self::BoundaryLayer => "boundary_layer",
            Self::LimitingShear => "limiting_shear",
            Self::EyringStress => "eyring_stress",
        }
    }
}

impl CalibrationInput {
    /// Value and band of a parameter in SI units.
    #[must_use]
    pub fn of(&self, name: CalibratedName) -> Option<Estimate> {
        match name {
            CalibratedName::BoundaryFriction => self.boundary_friction,
            CalibratedName::BoundaryLayer => Some(self.boundary_layer?.map(Length::si)),
            CalibratedName::LimitingShear => self.limiting_shear,
            CalibratedName::EyringStress => Some(self.eyring_stress?.map(Pressure::si)),
        }
    }

    /// Correlations of all parameters by their numbers in [`CalibratedName::ALL`].
    pub(crate) fn correlations_of_all(&self) -> impl Fn(usize, usize) -> f64 + '_ {
        |i, j| self.correlation(CalibratedName::ALL[i], CalibratedName::ALL[j])
    }

    /// Correlation of two parameters; 0 if it is not stated.
    #[must_use]
    pub fn correlation(&self, first: CalibratedName, other: CalibratedName) -> f64 {
        correlation(self.correlations.as_deref().unwrap_or(&[]), first, other)
    }
}

/// Correlation of two parameters among `pairs`; 0 if it is not stated.
pub(crate) fn correlation<N: Copy + PartialEq>(
    pairs: &[CorrelationInput<N>],
    first: N,
    other: N,
) -> f64 {
    if first == other {
        return 1.0;
    }
    let mut of_both = pairs
        .iter()
        .filter(|pair| pair.between == [first, other] || pair.between == [other, first]);
    of_both.next().map_or(0.0, |pair| pair.value)
}

/// Rows of the lower triangle L, each up to its diagonal, with L Lᵀ = the correlations of `n` parameters, given by their
/// numbers; `None` if no distribution has them.
pub fn cholesky(n: usize, correlation: impl Fn(usize, usize) -> f64) -> Option<Vec<Vec<f64>>> {
    /// Smallest square of a pivot: a correlation of 1 - 5e-7.
    const LEAST: f64 = 1e-6;
    let factor = Cholesky::new(n, correlation, LEAST)?;
    Some(factor.lower().map(<[f64]>::to_vec).collect())
}
