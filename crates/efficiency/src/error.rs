//! Errors of losses and efficiencies.

use asperity_core::quantity::{LineEnergy, Power, Temperature};
use asperity_core::{Code, Fault, decimals, number};

asperity_core::fault_error! {
    /// Errors of losses and efficiency.
    EfficiencyError
}

impl EfficiencyError {
    /// A mean without positions.
    pub(crate) fn no_positions() -> Self {
        Fault::new(Code::E209, "a mesh loss needs at least one position").into()
    }

    /// Two arrays of a sum differ in length.
    pub(crate) fn length_mismatch(name: &'static str, found: usize, expected: usize) -> Self {
        let text = format!("{name} has {found} points where {expected} are needed");
        Fault::new(Code::E209, text).into()
    }

    /// The losses are not below the input power.
    pub fn loss_exceeds_input(loss: Power, input: Power) -> Self {
        let text = format!("the losses, {loss:.6}, are not below the input power, {input:.6}");
        Fault::new(Code::E209, text).into()
    }

    /// The energy of a deformation is negative.
    pub(crate) fn negative_energy(name: &'static str, energy: LineEnergy) -> Self {
        let text = format!("{name} = {energy}: a deformation cannot release more than it took");
        Fault::new(Code::E209, text).into()
    }

    /// The bulk temperature does not converge: the last one after `steps` steps, and the change \[K\] that the next would make.
    pub(crate) fn bulk_not_settled(temperature: Temperature, residual: f64, steps: usize) -> Self {
        let text = format!(
            "the bulk temperature did not settle in {steps} steps (last {:.0} °C, still moving by {} K)",
            temperature.celsius(),
            decimals(residual, 2)
        );
        Fault::new(Code::E311, text).into()
    }

    /// The rows of a loss table, of one temperature if there are several, do not form a grid of distinct torques and speeds.
    pub(crate) fn no_grid(rows: usize, torques: usize, speeds: usize) -> Self {
        let text =
            format!("{rows} rows do not form a grid of {torques} torques and {speeds} speeds");
        Fault::new(Code::E138, text).into()
    }

    /// A loss table has no row at a torque \[N m\] that lies beyond the torques of its speed \[1/min\].
    pub(crate) fn hole_in_table(torque_nm: f64, speed_rpm: f64) -> Self {
        let text = format!(
            "no row at {} N m, {} 1/min, where rows at other speeds have this torque, and nothing is extrapolated; add it, or leave this torque or this speed out",
            number(torque_nm),
            number(speed_rpm)
        );
        Fault::new(Code::E138, text).into()
    }

    /// A row of a loss table has an invalid number: the speed of the row if the rule is about torque, speed or temperature.
    pub(crate) fn table_row(rule: &'static str, value: f64) -> Self {
        let text = format!("{rule}, and is {} in a row", number(value));
        Fault::new(Code::E138, text).into()
    }

    /// The operating point, at a torque \[N m\], a speed \[1/min\] and a temperature \[°C\], is outside of the loss table.
    pub(crate) fn not_in_table(torque_nm: f64, speed_rpm: f64, temperature_c: f64) -> Self {
        let text = format!(
            "the table has no loss at {} N m, {} 1/min, {} °C; nothing is extrapolated",
            number(torque_nm),
            number(speed_rpm),
            number(temperature_c)
        );
        Fault::new(Code::E313, text).into()
    }
}
