//! Running-in of the flanks, completed with the operation of the case and checked.

use asperity_core::DomainError;
use asperity_core::quantity::{Pressure, Quantity, Torque};
use asperity_gear::GearPair;

use super::plausibility::{AtPitchPoint, at_running_in};
use crate::input::case_input::OperationInput;
use crate::input::running_in_input::ENGAGEMENTS;
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// Running-in of the flanks before the loss is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunningInPlan {
    /// Torque at the pinion, of the sign of the operation.
    pub torque: Torque,
    /// Engagements of a tooth of the pinion; `None` until the roughness no longer changes.
    pub engagements: Option<f64>,
}

impl RunningInPlan {
    /// The Hertz pressure of the running-in, reported at the key that states its torque.
    pub(crate) fn load(
        &self,
        operation: &OperationInput,
        (gears, modulus): (&GearPair, Pressure),
        flow_pressure: [Pressure; 2],
    ) -> AtPitchPoint {
        let stated = operation
            .running_in
            .and_then(|entry| entry.stated()?.torque);
        let key = match stated {
            Some(_) => "running_in.torque",
            None => "running_in",
        };
        let [pinion, wheel] = flow_pressure.map(Pressure::si);
        let softer = Pressure::from_si(pinion.min(wheel));
        at_running_in(gears, modulus, self.torque, softer, key)
    }
}

/// The running-in that a case states.
pub(crate) fn running_in(
    operation: &OperationInput,
    gears: (&GearPair, Pressure),
    flow_pressure: [Pressure; 2],
    source: &Source,
) -> Result<Option<RunningInPlan>, CaseError> {
    let Some(stated) = operation.running_in.and_then(|entry| entry.stated()) else {
        return Ok(None);
    };
    let section = Section::new(source, "operation.running_in");
    if let Some(torque) = stated.torque {
        let value = torque.si();
        let rule = "must be finite and not zero";
        let is_load = value.is_finite() && value != 0.0;
        DomainError::require(is_load, "torque", value, Torque::SI_UNIT, rule)
            .map_err(section.domain("torque"))?;
    }
    if let Some(count) = stated.engagements {
        let [least, most] = ENGAGEMENTS;
        let rule = "must be 1 to 1e10";
        let is_possible = (least..=most).contains(&count);
        DomainError::require(is_possible, "number of engagements", count, "-", rule)
            .map_err(section.domain("engagements"))?;
    }
    let size = stated.torque.unwrap_or(operation.torque).si().abs();
    let plan = RunningInPlan {
        torque: Torque::from_si(size.copysign(operation.torque.si())),
        engagements: stated.engagements,
    };
    let load = plan.load(operation, gears, flow_pressure);
    load.refuse_flow(source)?;
    Ok(Some(plan))
}
