//! The same mesh under the torque of the other sign.

use asperity_core::numerics::deviation;
use asperity_core::quantity::Power;
use asperity_efficiency::equivalent_friction;
use asperity_efficiency::output_torque::{MeshOperation, power_flow};

use super::cycle::operation;
use crate::result::Losses;
use asperity_case::case::Case;
use asperity_case::error::{Error, PositionError};

/// Numbers that the direction of the power changes; all others are those in [`Losses`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Reversed {
    /// Efficiency of the mean loss.
    pub efficiency: f64,
    /// Its standard deviation over the offsets; absent with one offset.
    pub efficiency_deviation: Option<f64>,
    /// Friction coefficient that explains the loss.
    pub mu_equivalent: f64,
}

impl Losses {
    /// Efficiency with the torque of `case` reversed and the same flanks loaded: the losses are the same, the
    /// power into the mesh is not, because the other gear drives.
    ///
    /// # Errors
    /// When the losses are not below the power into the mesh.
    ///
    /// ```
    /// use asperity::{Run, case};
    /// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    /// let case = case::load_with(file, &|input| {
    ///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    /// })?;
    /// let coast = case.with_key("operation.torque", "-145 N m")?;
    /// let [drive, other] = [&case, &coast].map(|case| Run::new(case).losses());
    /// let (drive, other) = (drive?.into_only()?, other?.into_only()?);
    /// assert_eq!(drive.summary.loss_w, other.summary.loss_w);
    /// assert_eq!(drive.reversed(&case.case)?.efficiency, other.summary.efficiency);
    /// # Ok::<(), asperity::Error>(())
    /// ```
    pub fn reversed(&self, case: &Case) -> Result<Reversed, Error> {
        self.of_other_direction(case)
            .map_err(|error| Error::Whole(Box::new(error)))
    }

    fn of_other_direction(&self, case: &Case) -> Result<Reversed, PositionError> {
        let forward = operation(case);
        let reversed = MeshOperation {
            pinion_torque: -forward.pinion_torque,
            ..forward
        };
        let efficiencies = self
            .offsets
            .iter()
            .map(|row| Ok(power_flow(&reversed, Power::from_si(row.loss_w))?.efficiency))
            .collect::<Result<Vec<f64>, PositionError>>()?;
        let loss = Power::from_si(self.summary.loss_w);
        let efficiency = power_flow(&reversed, loss)?.efficiency;
        let factor = self.summary.loss_factor_local;
        Ok(Reversed {
            efficiency,
            efficiency_deviation: deviation(&efficiencies),
            mu_equivalent: equivalent_friction(efficiency, factor)?.value,
        })
    }
}
