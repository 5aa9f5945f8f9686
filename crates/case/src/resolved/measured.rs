//! Constants that measurements of a case state.

use asperity_core::Estimate;
use serde::{Deserialize, Serialize};

use super::constant::UncertainParameter;
use super::resolve::Case;

/// Measurements that state the distribution of a constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measured {
    /// Losses on a rig, in the table `calibration` of the case.
    Calibration,
    /// Traction curves, in an oil file.
    OilFile,
    /// The surfaces of both flanks.
    Surfaces,
}

impl UncertainParameter {
    /// Value and 95 % interval by measurements that the case names.
    #[must_use]
    pub fn measured(self, case: &Case) -> Option<(Estimate, Measured)> {
        let calibration = case.input.calibration.as_ref();
        let calibrated = calibration.and_then(|given| given.of(self.calibrated_name()?));
        let fitted = || {
            let (file, name) = (case.oil_file.as_ref()?, self.fitted_name()?);
            let is_own = name.replaced_by(&case.input).is_none();
            is_own.then(|| (file.film_friction.of(name), Measured::OilFile))
        };
        calibrated
            .map(|band| (band, Measured::Calibration))
            .or_else(fitted)
    }

    /// Correlation with `other`, which the same measurements state; 0 if they state none.
    pub fn correlation(self, other: Self, measured: Measured, case: &Case) -> f64 {
        let of_calibration = || {
            let names = (self.calibrated_name()?, other.calibrated_name()?);
            let given = case.input.calibration.as_ref()?;
            Some(given.correlation(names.0, names.1))
        };
        let of_file = || {
            let names = (self.fitted_name()?, other.fitted_name()?);
            let file = case.oil_file.as_ref()?;
            Some(file.film_friction.correlation(names.0, names.1))
        };
        let found = match measured {
            Measured::Calibration => of_calibration(),
            Measured::OilFile => of_file(),
            Measured::Surfaces => None,
        };
        found.unwrap_or(0.0)
    }
}
