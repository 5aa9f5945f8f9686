//! Settings of a map.

use asperity::case::train::Train;
use asperity_core::Fault;
use asperity_report::{Described, Nodes, Setting, settings};

use super::axes::Axes;
use super::draws::MapBand;

settings! {
    /// Settings of a map.
    pub struct MapSettings {
        /// Torques at the pinion in N m: a..b:n, a..b:n:log or a list [default: 0 and 12 from 1 % of the largest, both
        /// signs]; 0 is added between both signs
        [value_name = "AXIS", allow_hyphen_values = true] torque: Option<Nodes>,
        /// Speeds of the pinion in 1/min: a..b:n, a..b:n:log or a list [default: 0, 1 and 16 more, closer at low speed]; 0
        /// is added
        [value_name = "AXIS", allow_hyphen_values = true] speed: Option<Nodes>,
        /// Temperatures of the flanks in °C: a..b:n or a list [default: the temperature of the case]
        [value_name = "AXIS", allow_hyphen_values = true] temperature: Option<Nodes>,
        /// Whether the loss has median, 5 and 95 % quantiles, as in asperity run
        [value_name = "POINTS"] band: MapBand = "nodes",
    }
}

impl MapSettings {
    /// Axes of the map of a case.
    ///
    /// # Errors
    /// When a text is not an axis, or a node is not possible.
    pub fn axes(&self, case: &Train) -> Result<Axes, Fault> {
        let of = |name: &str, stated: &Option<Nodes>, usual: fn(&Train) -> Vec<f64>| match stated {
            None => Ok(usual(case)),
            Some(stated) => stated.nodes(name),
        };
        let torque = of("torque", &self.torque, Axes::default_torque)?;
        let speed = of("speed", &self.speed, Axes::default_speed)?;
        let temperature = of("temperature", &self.temperature, Axes::default_temperature)?;
        let axes = Axes::new(&torque, &speed, &temperature);
        axes.map_err(|error| error.about("axes"))
    }

    /// Description of the study.
    #[must_use]
    pub fn study() -> Described {
        let about = "Finishes by name, as in `compare` [default: the traces of the case]";
        let finishes = Setting::new("finishes", "Option<Finishes>", about, None);
        Described::new::<Self>(
            "map",
            "Losses over torque, speed and temperature, in both directions of the power",
            "The losses are of the mesh only, without bearings, seals and churning. Every point is the run at this torque, speed and \
                temperature; its quantiles (loss_median_w, loss_p05_w, loss_p95_w) are from draws at three torques and three speeds.",
            "points",
            vec![Setting::new("case", "Case", "The case", None), finishes],
        )
    }
}
