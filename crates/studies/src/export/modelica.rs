//! Tables of the Modelica Standard Library as text, for `CombiTable2Ds`.

use std::fmt::Write as _;

use super::field::Field;
use super::given::With;
use asperity_core::Fault;

/// Table `lossTorque` over torque \[N m\] and speed \[rad/s\]; with an added loss also separate tables of the mesh and of
/// the added loss.
pub(super) fn text(field: &Field, _: &With<'_>) -> Result<Vec<u8>, Fault> {
    field.check_size("Modelica")?;
    let mut text = format!(
        "#1\n# {}\n# {} (extrapolation = NoExtrapolation)\n# scope = {}; u1 = torque of the input shaft N m, u2 = its speed rad/s, value = loss torque N m\n",
        field.head(),
        Field::BEYOND,
        field.scope
    );
    write(&mut text, "lossTorque", field, &field.total_nm());
    if let Some(added) = &field.added_nm {
        write(&mut text, "meshLossTorque", field, &field.mesh_nm);
        write(&mut text, "addedLossTorque", field, added);
    }
    Ok(text.into_bytes())
}

/// First row: corner and speeds; then a torque and its values in each row. Writing into a string cannot fail.
fn write(text: &mut String, name: &str, field: &Field, values: &[f64]) {
    let (rows, columns) = (field.torque_nm.len() + 1, field.speed_rpm.len() + 1);
    let _ = write!(text, "double {name}({rows},{columns})\n0");
    for omega in field.omega() {
        let _ = write!(text, " {omega}");
    }
    text.push('\n');
    for (torque, row) in field.torque_nm.iter().zip(values.chunks(columns - 1)) {
        let _ = write!(text, "{torque}");
        for value in row {
            let _ = write!(text, " {value}");
        }
        text.push('\n');
    }
}
