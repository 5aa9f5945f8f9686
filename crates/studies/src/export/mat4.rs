//! MAT-files of level 4: five numbers, a name and the values of each matrix. MATLAB, Octave, scipy and the tables of
//! Modelica read them.

use super::field::Field;
use super::names::degrees;

/// MAT-file of level 4 under construction.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mat4 {
    matrices: Vec<Matrix>,
}

/// Named matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// Name of the variable.
    pub name: String,
    /// Number of rows.
    pub rows: usize,
    /// Values row by row.
    pub values: Vec<f64>,
    /// Whether the values are character codes.
    pub is_text: bool,
}

impl Mat4 {
    /// Adds a matrix with `values` row by row.
    #[must_use]
    pub fn with(mut self, name: &str, rows: usize, values: &[f64]) -> Self {
        self.matrices.push(Matrix {
            name: name.to_owned(),
            rows,
            values: values.to_vec(),
            is_text: false,
        });
        self
    }

    /// Adds a text; characters beyond Latin-1 become question marks.
    #[must_use]
    pub fn with_text(mut self, name: &str, text: &str) -> Self {
        let code = |c: char| u8::try_from(u32::from(c)).unwrap_or(b'?');
        self.matrices.push(Matrix {
            name: name.to_owned(),
            rows: 1,
            values: text.chars().map(|c| f64::from(code(c))).collect(),
            is_text: true,
        });
        self
    }

    /// The bytes: `type, rows, columns, 0, length of the name with its zero` as little-endian i32, the name, and the
    /// values column by column.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for matrix in &self.matrices {
            let columns = matrix.values.len() / matrix.rows.max(1);
            let head = [
                usize::from(matrix.is_text),
                matrix.rows,
                columns,
                0,
                matrix.name.len() + 1,
            ];
            for number in head {
                // A map has fewer than 2³¹ nodes.
                let number = i32::try_from(number).unwrap_or(i32::MAX);
                bytes.extend(number.to_le_bytes());
            }
            bytes.extend(matrix.name.as_bytes());
            bytes.push(0);
            for column in 0..columns {
                for row in 0..matrix.rows {
                    bytes.extend(matrix.values[row * columns + column].to_le_bytes());
                }
            }
        }
        bytes
    }
}

/// Fields of a finish: torque by speed, one set of variables per temperature.
pub(super) fn bytes(fields: &[Field]) -> Vec<u8> {
    let Some(first) = fields.first() else {
        return Vec::new();
    };
    let temperatures: Vec<f64> = fields.iter().map(|field| field.temperature_c).collect();
    let torques = first.torque_nm.len();
    let mut file = Mat4::default()
        .with_text("scope", &first.scope)
        .with_text(
            "units",
            "torque N m, speed 1/min, loss W, loss torque N m; lossTorque: torque N m down, speed rad/s across",
        )
        .with_text("head", &first.head())
        .with_text("beyond", Field::BEYOND)
        .with("torque_nm", torques, &first.torque_nm)
        .with("speed_rpm", 1, &first.speed_rpm)
        .with("temperature_c", 1, &temperatures);
    for field in fields {
        let suffix = match fields.len() {
            1 => String::new(),
            _ => format!("_{}", degrees(field.temperature_c)),
        };
        let named = |name: &str| format!("{name}{suffix}");
        let (total, omega) = (field.total_nm(), field.omega());
        let power = |index: usize| total[index] * omega[index % omega.len()];
        let loss: Vec<f64> = (0..total.len()).map(power).collect();
        file = file
            .with(&named("loss_torque_nm"), torques, &total)
            .with(&named("loss_w"), torques, &loss)
            .with(&named("efficiency"), torques, &efficiency(field, &total))
            .with(&named("lossTorque"), torques + 1, &with_axes(field, &total));
        if let Some(added) = &field.added_nm {
            file = file
                .with(&named("mesh_loss_torque_nm"), torques, &field.mesh_nm)
                .with(&named("added_loss_torque_nm"), torques, added);
        }
    }
    file.bytes()
}

/// Efficiency at the nodes; NaN without torque.
fn efficiency(field: &Field, total: &[f64]) -> Vec<f64> {
    let across = field.speed_rpm.len();
    let of = |(index, loss): (usize, &f64)| {
        let torque = field.torque_nm[index / across];
        match torque {
            t if t > 0.0 => 1.0 - loss / t,
            t if t < 0.0 => t.abs() / (t.abs() + loss),
            _ => f64::NAN,
        }
    };
    total.iter().enumerate().map(of).collect()
}

/// Layout of Modelica: corner and speeds \[rad/s\] in the first row, a torque before each row of values.
fn with_axes(field: &Field, total: &[f64]) -> Vec<f64> {
    let mut values = vec![0.0];
    values.extend(field.omega());
    for (torque, row) in field
        .torque_nm
        .iter()
        .zip(total.chunks(field.speed_rpm.len()))
    {
        values.push(*torque);
        values.extend(row);
    }
    values
}
