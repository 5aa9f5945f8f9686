//! Settings of a cycle on a map.

use std::sync::Arc;

use asperity_core::{Code, Fault, number};
use asperity_report::{Input, Setting, StudySettings, Watch, Work, settings};

use super::energy::{CycleResult, evaluate};
use super::trace::named_cycle;
use crate::map::Map;

/// A cycle, and the map on which it is evaluated.
#[derive(Debug, Clone)]
pub struct CycleOnMap {
    /// The map, whose case has the vehicle.
    pub map: Arc<Map>,
    /// Name of the cycle.
    pub name: String,
    /// Text of its table.
    pub text: String,
}

impl Input for CycleOnMap {
    fn described() -> Vec<Setting> {
        let trace = "File, frame or columns: time_s, and torque_nm with speed_rpm at the pinion, or speed_km_h";
        let vehicle =
            "Keys of `[vehicle]`, ``{\"mass\": \"1600 kg\"}``, instead of those of the case";
        vec![
            Setting::new("map", "Map", "The map", None),
            Setting::new("trace", "Cycle", trace, None),
            Setting::new("vehicle", "Option<Vehicle>", vehicle, None),
        ]
    }

    fn title(&self) -> String {
        self.map.title.clone()
    }
}

settings! {
    /// Settings of a cycle.
    pub struct CycleSettings {
        /// Temperature of the flanks in °C, one of the map [default: next to the temperature of the case]
        [long = "temperature", value_name = "°C"] temperature_c: Option<f64>,
        /// Names of the columns of a cycle without names, or instead of its own, e.g. time_s,speed_km_h; - leaves one out
        [value_name = "NAMES", value_delimiter = ','] columns: Vec<String>,
        /// Permit more than 5 % of the energy of the cycle outside of the map, where the ratio of loss to torque is
        /// constant
        allow_outside: bool,
    }
}

impl CycleSettings {
    /// Number of the stated temperature among those of the map.
    fn temperature(&self, map: &Map) -> Result<usize, Fault> {
        /// Largest difference of equal temperatures \[K\].
        const EQUAL: f64 = 1e-9;
        let nodes = &map.axes.temperature_c;
        let Some(celsius) = self.temperature_c else {
            return Ok(map.case_temperature());
        };
        let mut places = nodes.iter();
        let at = places.position(|node| (*node - celsius).abs() <= EQUAL);
        at.ok_or_else(|| {
            let known: Vec<String> = nodes.iter().map(|node| number(*node)).collect();
            let (known, stated) = (known.join(", "), number(celsius));
            let message = format!("temperature_c = {stated}: the map has {known} °C");
            Fault::new(Code::E209, message)
        })
    }
}

impl StudySettings for CycleSettings {
    type Input = CycleOnMap;
    type Found = CycleResult;
    const COMMAND: &'static str = "cycle";
    const FOLDER: &'static str = "";
    const ABOUT: &'static str = "Energy lost over a driving cycle, from a map";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[
            ("map", "results/demo-case-map"),
            ("trace", "demo/urban.csv"),
        ],
        &[
            ("map", "results/demo-case-map"),
            ("trace", "trace.csv"),
            ("keys", "vehicle.mass=1600 kg"),
            ("temperature_c", "90"),
        ],
    ];
    const METHOD: &'static str = "The loss torque is interpolated between the points of the map; its interval follows from the samples of the map.";
    const STEPS: &'static str = "";

    fn work(&self, given: &CycleOnMap) -> Result<Option<Work>, Fault> {
        self.temperature(&given.map)?;
        Ok(None)
    }

    fn run(&self, given: CycleOnMap, _: &Watch<'_>) -> Result<CycleResult, Fault> {
        let CycleOnMap { map, name, text } = given;
        let temperature = self.temperature(&map)?;
        let names = (!self.columns.is_empty()).then_some(&self.columns[..]);
        let cycle = named_cycle(&text, names, map.input.vehicle.as_ref())?;
        evaluate(&map, temperature, &cycle, &name, self.allow_outside)
    }
}
