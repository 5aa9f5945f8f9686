//! Requested material ratios at levels and heights between ratios.

use asperity_core::by_size;
use asperity_core::quantity::Length;
use asperity_report::profile_json::um;
use asperity_roughness::material_levels::MaterialLevels;
use serde_json::{Value, json};

use super::evaluated::EvaluatedFile;
use crate::args::{ProfileInfoArgs, Ratios};

/// Requested values of the roughness profile over its evaluation length.
pub struct Levels {
    /// Rmr(c) `[%]` by c.
    ratios: Vec<(Length, f64)>,
    /// Rdc(p, q).
    heights: Vec<(Ratios, Length)>,
}

impl Levels {
    /// Evaluates the values requested in `args`. An evaluated profile has Rk parameters and thus a curve.
    pub fn new(evaluated: &EvaluatedFile, args: &ProfileInfoArgs) -> Self {
        let rough = &evaluated.parts.roughness.profile;
        let (mut ratios, mut heights) = (Vec::new(), Vec::new());
        if let Ok(levels) = MaterialLevels::from_heights(rough.heights()) {
            ratios.extend(args.rmr.iter().map(|c| (*c, levels.ratio(*c))));
            let difference = |both: &Ratios| {
                let height = levels.difference(both.upper, both.lower).ok()?;
                Some((*both, height))
            };
            heights.extend(args.rdc.iter().filter_map(difference));
        }
        Self { ratios, heights }
    }

    /// Lines of a report.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        let ratio = |(c, percent): &(Length, f64)| format!("Rmr({} um) {percent:.2} %", um(*c));
        let height = |(both, height): &(Ratios, Length)| {
            format!(
                "Rdc({} %, {} %) {} um",
                both.upper,
                both.lower,
                by_size(um(*height), 4)
            )
        };
        let heights = self.heights.iter().map(height);
        self.ratios.iter().map(ratio).chain(heights)
    }

    /// The values as JSON; `None` if none were requested.
    pub fn json(&self) -> Option<Value> {
        let is_requested = !(self.ratios.is_empty() && self.heights.is_empty());
        let ratio = |(c, percent): &(Length, f64)| json!({ "c_um": um(*c), "percent": percent });
        let height = |(both, height): &(Ratios, Length)| json!({ "p_percent": both.upper, "q_percent": both.lower, "um": um(*height) });
        is_requested.then(|| {
            json!({
                "rmr": self.ratios.iter().map(ratio).collect::<Vec<_>>(),
                "rdc": self.heights.iter().map(height).collect::<Vec<_>>(),
            })
        })
    }
}
