//! Parameters of a calibration: four constants of boundary layer and oil, and nuisance terms with priors.
//!
//! | symbol | parameter | prior of its logarithm (standard deviation) |
//! |---|---|---|
//! | μ_b | boundary friction | 0.5 |
//! | h_b | boundary layer, which determines the boundary share of the load | 0.7 |
//! | Λ | limiting shear stress over pressure | 0.3 |
//! | τ₀ | Eyring stress | 0.4 |
//!
//! | nuisance term | prior |
//! |---|---|
//! | scale of each assembly | ± 3 % |
//! | rolling loss | ± 30 % |
//! | oil temperature, one offset for all points | ± 3 K |
//! | residual loss torque without load | ± 2 % of the median loss torque |
//! | loss torque of the bearings relative to the torque, for rows that include it | 0.002 ± 0.001 |
//!
//! The priors of the parameters are about twice as wide as the ranges of a case without calibration: they determine only
//! what the points do not identify. The prior of a constant of an oil file is its band. The priors of scale, rolling and temperature are typical of back-to-back rigs; the last
//! two are estimates.

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity::uncertainty::{UncertainParameter, deviation_of_curves, range};
use asperity_core::Estimate;

/// Parameter of the fit with its default.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// Name in the case.
    pub name: CalibratedName,
    /// The value of the case in SI units, the centre of its prior, with its range in the band of a case without calibration.
    pub default: Estimate,
    /// Standard deviation of the prior of its logarithm.
    pub prior: f64,
}

/// Standard deviation of the prior of a logarithm.
const fn prior(name: CalibratedName) -> f64 {
    match name {
        CalibratedName::BoundaryFriction => 0.5,
        CalibratedName::BoundaryLayer => 0.7,
        CalibratedName::LimitingShear => 0.3,
        CalibratedName::EyringStress => 0.4,
    }
}

impl Parameter {
    /// The parameters that act on the loss of `case`.
    ///
    /// # Errors
    /// When the family of the oil is not known.
    pub fn all(case: &LoadedCase) -> Result<Vec<Self>, asperity::Error> {
        let case = case.at_stated()?;
        let mut parameters = Vec::new();
        for name in CalibratedName::ALL {
            if let Some(default) = range(name.into(), &case).map_err(Box::new)? {
                let fitted = deviation_of_curves(name.into(), &case).map_err(Box::new)?;
                parameters.push(Self {
                    name,
                    default,
                    prior: fitted.unwrap_or(prior(name)),
                });
            }
        }
        Ok(parameters)
    }

    /// Name in words.
    #[must_use]
    pub fn words(&self) -> &'static str {
        UncertainParameter::from(self.name).name()
    }
}

/// Standard deviation of the scale of an assembly.
pub(crate) const ASSEMBLY: f64 = 0.03;
/// Standard deviation of the logarithm of the rolling loss relative to the model.
pub const ROLLING: f64 = 0.30;
/// Standard deviation of the oil temperature \[K\].
pub const TEMPERATURE: f64 = 3.0;
/// Standard deviation of the loss torque without load, relative to the median loss torque.
pub(crate) const NO_LOAD: f64 = 0.02;
/// Loss torque of the bearings relative to the torque of the pinion, and its standard deviation.
pub(crate) const BEARINGS: [f64; 2] = [0.002, 0.001];
