//! Keys of the case file of a gear train.

use std::sync::LazyLock;

use super::case_file::{CaseFile, Checked};
use super::known_keys::first_unknown;
use crate::case::train_input::TrainCaseInput;

/// The JSON schema of a case file of several meshes.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(TrainCaseInput).to_value()
}

impl CaseFile for TrainCaseInput {
    fn schema() -> &'static serde_json::Value {
        static SCHEMA: LazyLock<serde_json::Value> = LazyLock::new(schema);
        &SCHEMA
    }
}

impl Checked for TrainCaseInput {
    const VALID: &'static str = r#"
train = { input = "input" }
mesh.only = { shafts = ["input", "output"], gears = { teeth = [23, 68], module = "2 mm", face_width = "30 mm" } }
planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { pinion = { rq = "0.3 um" }, wheel = { rq = "0.3 um" }, sun = { rq = "0.3 um" }, planet = { rq = "0.3 um" }, ring = { rq = "0.3 um" } }
"#;
}

/// Whether a case of a gear train has the key.
pub(crate) fn is_key_of_train(key: &str) -> bool {
    first_unknown(TrainCaseInput::schema(), std::iter::once(key)).is_none()
}
