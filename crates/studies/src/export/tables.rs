//! Tables as text: CSV with a row per node or per torque, and the transmission loss map of VECTO.

use super::error;
use std::fmt::Write as _;
use std::path::Path;

use asperity_core::Fault;
use asperity_report::tables::text;
use serde::Serialize;

use super::field::Field;
use super::given::{ExportGiven, With};

/// CSV with one row per node, mesh and added loss in separate columns.
pub(super) fn csv(given: &ExportGiven<'_>) -> Result<Option<Vec<u8>>, Fault> {
    #[derive(Serialize)]
    struct NodeRow<'a> {
        torque_nm: f64,
        speed_rpm: f64,
        temperature_c: f64,
        loss_torque_nm: f64,
        mesh_loss_torque_nm: f64,
        added_loss_torque_nm: f64,
        loss_w: f64,
        scope: &'a str,
        outside: String,
    }
    let mut rows = Vec::new();
    let mut points = given.finish.points.iter();
    for field in given.fields {
        let (total, across) = (field.total_nm(), field.speed_rpm.len());
        let omega = field.omega();
        for (index, mesh) in field.mesh_nm.iter().enumerate() {
            let (torque, speed) = (index / across, index % across);
            let marks = points.next().map(|point| point.outside.join("; "));
            rows.push(NodeRow {
                torque_nm: field.torque_nm[torque],
                speed_rpm: field.speed_rpm[speed],
                temperature_c: field.temperature_c,
                loss_torque_nm: total[index],
                mesh_loss_torque_nm: *mesh,
                added_loss_torque_nm: total[index] - mesh,
                loss_w: total[index] * omega[speed],
                scope: &field.scope,
                outside: marks.unwrap_or_default(),
            });
        }
    }
    text(Path::new("map.csv"), rows)
        .map(Some)
        .map_err(error::unwritten)
}

/// CSV with one row per node and mesh of a gear train, the loss torque of all equal meshes at the input shaft.
pub(super) fn meshes_csv(given: &ExportGiven<'_>) -> Result<Option<Vec<u8>>, Fault> {
    if given.finish.meshes.is_empty() {
        return Ok(None);
    }
    #[derive(Serialize)]
    struct ExportMeshRow<'a> {
        torque_nm: f64,
        speed_rpm: f64,
        temperature_c: f64,
        mesh: &'a str,
        loss_torque_nm: f64,
    }
    let mut rows = Vec::new();
    for field in given.fields {
        let across = field.speed_rpm.len();
        for (mesh, losses) in &field.parts {
            for (index, loss) in losses.iter().enumerate() {
                rows.push(ExportMeshRow {
                    torque_nm: field.torque_nm[index / across],
                    speed_rpm: field.speed_rpm[index % across],
                    temperature_c: field.temperature_c,
                    mesh,
                    loss_torque_nm: *loss,
                });
            }
        }
    }
    text(Path::new("map.csv"), rows)
        .map(Some)
        .map_err(error::unwritten)
}

/// CSV of the loss torque \[N m\]: speeds in the first row, a torque before each row of values.
pub(super) fn wide(field: &Field, _: &With<'_>) -> Result<Vec<u8>, Fault> {
    let mut text = String::from("torque_nm/speed_rpm");
    // Writing into a string cannot fail.
    for speed in &field.speed_rpm {
        let _ = write!(text, ",{speed}");
    }
    text.push('\n');
    let total = field.total_nm();
    for (torque, row) in field
        .torque_nm
        .iter()
        .zip(total.chunks(field.speed_rpm.len()))
    {
        let _ = write!(text, "{torque}");
        for value in row {
            let _ = write!(text, ",{value}");
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}

/// Transmission loss map of VECTO: speed, torque and loss torque of the input shaft, for both signs of the torque. VECTO
/// looks up by the output torque, so the loss must increase more slowly than the torque.
pub(super) fn vecto(field: &Field, _: &With<'_>) -> Result<Vec<u8>, Fault> {
    const FORMAT: &str = "VECTO";
    field.check_size(FORMAT)?;
    field.check_signs(FORMAT)?;
    field.check_slope(FORMAT)?;
    let (total, across) = (field.total_nm(), field.speed_rpm.len());
    let mut text = format!(
        "# scope {}\n# {}\n# {}\nInput Speed [rpm],Input Torque [Nm],Torque Loss [Nm]\n",
        field.scope,
        field.head(),
        Field::BEYOND
    );
    for (j, speed) in field.speed_rpm.iter().enumerate() {
        for (i, torque) in field.torque_nm.iter().enumerate() {
            // Writing into a string cannot fail.
            let _ = writeln!(text, "{speed},{torque},{}", total[i * across + j]);
        }
    }
    Ok(text.into_bytes())
}
