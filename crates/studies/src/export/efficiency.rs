//! One efficiency instead of a map, for FASTSim.

use asperity_core::Fault;

use super::error;
use super::field::Field;
use super::given::With;
use crate::cycle::Coverage;

/// Transmission of a vehicle of FASTSim: output energy relative to input energy over the time in which the input drives.
pub(super) fn fastsim(field: &Field, with: &With<'_>) -> Result<Vec<u8>, Fault> {
    let cycle = with.cycle.ok_or_else(|| error::no_cycle("fastsim"))?;
    let surface = field.surface();
    let coverage = Coverage::new(&surface, cycle);
    coverage
        .check()
        .map_err(|source| error::uncovered("fastsim", source))?;
    let (mut entered, mut lost, mut outside) = (0.0, 0.0, 0);
    for point in &cycle.points {
        let [torque_nm, speed_rpm] = point.forwards();
        if torque_nm <= 0.0 {
            continue;
        }
        let loss = surface.loss_torque(torque_nm, speed_rpm);
        let angle = speed_rpm * point.weight_s;
        entered += torque_nm * angle;
        lost += loss.value * angle;
        outside += usize::from(loss.is_outside);
    }
    if entered <= 0.0 {
        return Err(error::no_drive("fastsim"));
    }
    let (head, scope) = (field.head(), &field.scope);
    Ok(format!(
        "# scope {scope}\n# {head}\n# weighted by a cycle, {outside} of its points outside the map; multiply by the efficiencies of the rest of the driveline\neff_interp: {}\n",
        1.0 - lost / entered
    )
    .into_bytes())
}
