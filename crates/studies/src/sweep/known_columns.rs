//! Columns of the results of a case.

use asperity::case::train::Train;
use asperity::result::Summary;
use asperity::train::{MeshRow, Whole};
use serde_json::{Value, json};

/// Columns that need the draws of a case.
pub(super) const DRAWN: [&str; 3] = ["loss_at_medians_w", "loss_p05_w", "loss_p95_w"];

pub(super) fn is_drawn(name: &str) -> bool {
    DRAWN.contains(&name)
}

/// Whether a column requires the draws of a case, as its own or as one of a mesh.
pub(super) fn needs_draws(name: &str) -> bool {
    let of_mesh = name.rsplit_once('.').map(|(_, column)| column);
    is_drawn(name) || of_mesh.is_some_and(is_drawn)
}

/// The numbers of a gear train by the names of their columns, which are those of a pair of gears where both have them; those
/// of its meshes begin with `mesh.NAME.`.
pub(super) fn numbers_of(result: &Whole) -> Value {
    let kinds = &result.kinds;
    let gearbox = result.gearbox.as_ref();
    let mut numbers = json!({
        "efficiency": result.efficiency,
        "loss_w": result.loss_w,
        "power_in_w": result.power_in_w,
        "sliding_w": kinds.film_w + kinds.lubricated_asperity_w + kinds.boundary_w,
        "gearbox_efficiency": gearbox.map(|gearbox| gearbox.efficiency),
        "gearbox_loss_w": gearbox.map(|gearbox| gearbox.loss_w),
        "oil_c": result.heat.as_ref().map(|heat| heat.oil_c),
    });
    let mut add = |prefix: String, row: Value| {
        if let (Some(all), Value::Object(row)) = (numbers.as_object_mut(), row) {
            all.extend(
                row.into_iter()
                    .map(|(name, value)| (format!("{prefix}{name}"), value)),
            );
        }
    };
    add(String::new(), json!(kinds));
    for mesh in &result.meshes {
        add(format!("mesh.{}.", mesh.mesh), json!(mesh));
    }
    numbers
}

/// Names of all numbers that a case of the study can have in its row.
pub(super) fn known_columns(case: &Train) -> Vec<String> {
    let numbers = match case.only() {
        Some(_) => {
            let mut summary = Summary::default();
            summary.gearbox_efficiency = Some(0.0);
            summary.gearbox_loss_w = Some(0.0);
            summary.asperity_share_standard_error = Some(0.0);
            json!(summary)
        }
        None => {
            let mut train = Whole::default();
            train.meshes.extend(case.meshes().map(|mesh| {
                let mut row = MeshRow::default();
                row.mesh.clone_from(&mesh.name);
                let drawn = [
                    &mut row.loss_at_medians_w,
                    &mut row.loss_p05_w,
                    &mut row.loss_p95_w,
                ];
                for number in drawn {
                    *number = Some(0.0);
                }
                row
            }));
            numbers_of(&train)
        }
    };
    let numbers = numbers.as_object().into_iter().flatten();
    let numbers = numbers.filter(|(_, value)| value.is_number() || value.is_null());
    let names = numbers.map(|(name, _)| name.as_str());
    names.chain(DRAWN).map(str::to_owned).collect()
}
