//! Study of a map: its settings, its finishes, and a cycle and exports besides it in its folder.

use std::path::{Path, PathBuf};

use asperity::case::train::Train;
use asperity::case::{CaseInput, OperationInput};
use asperity_core::{Code, Fault};
use asperity_report::{
    Input, Nodes, Report, Setting, StudyResult, StudySettings, Watch, Work, make_folder, settings,
    write_bytes,
};
use serde::Serialize;

use super::axes::Axes;
use super::draws::MapBand;
use super::evaluation::at_torque;
use super::grid::map;
use super::point::Map;
use crate::compare::Finishes;
use crate::cycle::{self, Cycle, CyclePoint};
use crate::estimate::has_records;
use crate::export::{AddedLoss, Format, With, check, export};

/// Folder of the exports within the folder of a map.
const EXPORTS: &str = "export";

/// A case on its own flanks, or on several finishes.
#[derive(Debug, Clone)]
pub struct CaseOrFinishes(pub Finishes);

impl Input for CaseOrFinishes {
    fn described() -> Vec<Setting> {
        let finishes =
            "Finishes or other variants by name, as in `compare` [default: the case itself]";
        Finishes::arguments("The case", "Option<Finishes>", finishes)
    }

    fn title(&self) -> String {
        self.0.title()
    }
}

settings! {
    /// Settings of a map.
    pub struct MapSettings {
        /// Torques at the pinion in N m, or with a final % in percent of the torque of the case: a..b:n, a..b:n:log or a list
        /// [default: 0 and 12 from 1 % of the largest, both signs]; 0 is added between both signs
        [value_name = "AXIS"] torque: Option<Nodes>,
        /// Speeds of the pinion in 1/min: a..b:n, a..b:n:log or a list, or in % of the speed of the case [default: 0, 1 and 16
        /// more, closer at low speed]; 0 is added
        [value_name = "AXIS"] speed: Option<Nodes>,
        /// Temperatures of the flanks in °C: a..b:n or a list [default: the temperature of the case]
        [value_name = "AXIS"] temperature: Option<Nodes>,
        /// Whether the loss has median, 5 and 95 % quantiles, as in asperity run
        [value_name = "POINTS"] band: MapBand = "nodes",
        /// Cycle whose points are drawn over the map, in the format of asperity cycle
        [value_name = "TRACE.csv"] cycle: Option<PathBuf>,
        /// Also write the map for these programs, into the folder of the map
        [value_name = "FORMAT", value_delimiter = ','] export: Vec<Format>,
        /// Table with the loss torque of bearings, seals and churning, added to the exports as a separate part:
        /// columns torque_nm, speed_rpm, loss_torque_nm (and temperature_c)
        [value_name = "TABLE.csv", requires = "export"] add_loss: Option<PathBuf>,
    }
}

impl MapSettings {
    /// Axes of the map of a case.
    ///
    /// # Errors
    /// When a text is not an axis, a node is not possible, or the case has no loss at standstill, which every map has.
    pub fn axes(&self, case: &Train) -> Result<Axes, Fault> {
        if case.cases().any(has_records) {
            let message = "load_share = \"ehl\" and full_film = \"ehl-transient\" have no map: it has a node at standstill, computed at \
                1 1/min, where the film is too thin for these solutions";
            let help = "Map the case with model.load_share = \"lambda-star\" and without model.full_film, or run it at torques and speeds \
                of its own with asperity sweep.";
            return Err(Fault::new(Code::E205, message).helping(help));
        }
        let operation = case.shafting.operation();
        let torque = Nodes::of_case(self.torque.as_ref(), "torque", operation.torque.si())?;
        let torque = torque.unwrap_or_else(|| Axes::default_torque(case));
        let rpm = operation.speed.si() * 30.0 / std::f64::consts::PI;
        let speed = Nodes::of_case(self.speed.as_ref(), "speed", rpm)?;
        let speed = speed.unwrap_or_else(|| Axes::default_speed(case));
        let temperature = match &self.temperature {
            None => vec![Axes::case_temperature(case)],
            Some(stated) => stated.nodes("temperature")?,
        };
        let axes = Axes::new(&torque, &speed, &temperature);
        axes.map_err(|error| error.about("axes"))
    }

    /// Data besides the map of `finishes` in its folder.
    fn extras(&self, finishes: &Finishes) -> Result<Extras, Fault> {
        let names = finishes.0.iter().map(|finish| finish.name.as_str());
        let names: Vec<&str> = names.collect();
        for format in &self.export {
            check(&names, *format, self.cycle.is_some())?;
        }
        let vehicle = finishes.first()?.input.vehicle.as_ref();
        let cycle = self.cycle.as_deref();
        let cycle = cycle.map(|file| cycle::read(file, vehicle)).transpose()?;
        let points = cycle.iter().flat_map(|cycle| &cycle.points);
        let added = self.add_loss.as_deref().map(AddedLoss::open).transpose();
        Ok(Extras {
            visited: points.map(CyclePoint::forwards).collect(),
            cycle,
            added: added.map_err(|error| error.about("add_loss"))?,
            formats: self.export.clone(),
        })
    }
}

/// Data besides a map in its folder.
#[derive(Debug, Clone, PartialEq, Default)]
struct Extras {
    /// Torques \[N m\] and speeds \[1/min\] of the cycle, drawn over the fields.
    visited: Vec<[f64; 2]>,
    cycle: Option<Cycle>,
    added: Option<AddedLoss>,
    /// Formats in which the map is written, too.
    formats: Vec<Format>,
}

impl Extras {
    fn with<'a>(&'a self, beside: Option<&'a Path>) -> With<'a> {
        With {
            added: self.added.as_ref(),
            cycle: self.cycle.as_ref(),
            beside,
        }
    }

    /// Writes the exports of `map` into its folder.
    fn write(&self, map: &Map, folder: &Path) -> Result<(), Fault> {
        if self.formats.is_empty() {
            return Ok(());
        }
        let folder = folder.join(EXPORTS);
        let with = self.with(Some(&folder));
        let files = self.formats.iter().map(|format| export(map, *format, with));
        let files = files.collect::<Result<Vec<_>, Fault>>()?;
        make_folder(&folder)?;
        let mut files = files.iter().flatten();
        files.try_for_each(|file| write_bytes(&folder.join(&file.name), &file.bytes))
    }
}

/// A map, with a cycle and exports in its folder.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub struct MapStudy {
    /// The map.
    pub map: Map,
    #[serde(skip)]
    extras: Extras,
}

impl From<Map> for MapStudy {
    fn from(map: Map) -> Self {
        Self {
            map,
            extras: Extras::default(),
        }
    }
}

impl StudyResult for MapStudy {
    const KIND: &'static str = Map::KIND;
    const NAME: &'static str = Map::NAME;

    fn report(&self) -> Report<'_> {
        let report = self.map.report_with(&self.extras.visited);
        report.file(|folder| self.extras.write(&self.map, folder))
    }
}

/// Whether a case differs from another only by torque, speed or temperature.
fn differs_by_point(first: &CaseInput, other: &CaseInput) -> bool {
    let operation = OperationInput {
        temperature_deviation: other.operation.temperature_deviation,
        running_in: other.operation.running_in,
        ..first.operation
    };
    let at_point = CaseInput {
        title: first.title.clone(),
        operation,
        ..other.clone()
    };
    other.operation != first.operation && at_point == *first
}

impl StudySettings for MapSettings {
    type Input = CaseOrFinishes;
    type Found = MapStudy;
    const COMMAND: &'static str = "map";
    const ABOUT: &'static str =
        "Losses over torque, speed and temperature, in both directions of the power";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("case", "demo/case.toml")],
        &[
            ("case", "demo/case.toml"),
            ("torque", "-150..150:13"),
            ("speed", "500..16000:8"),
            ("temperature", "60,90"),
        ],
        &[
            ("case", "demo/case.toml"),
            (
                "finishes",
                "ground=demo/ground_pinion.csv,demo/ground_wheel.csv",
            ),
            (
                "finishes",
                "superfinished=demo/superfinished_pinion.csv,demo/superfinished_wheel.csv",
            ),
            ("export", "vecto,modelica,fmu"),
        ],
    ];
    const METHOD: &'static str = "The losses are of the mesh only, without bearings, seals and churning. Every point is the run at this \
        torque, speed and temperature; the median of its loss and the quantiles (loss_p05_w, loss_p95_w) are from samples at three torques \
        and three speeds. Flanks with operation.running_in run in once, at its torque, and the whole map is theirs.";
    const STEPS: &'static str = "points";

    fn work(&self, CaseOrFinishes(given): &CaseOrFinishes) -> Result<Option<Work>, Fault> {
        let first = given.first()?;
        let torques = self.axes(first)?.torque_nm.len();
        let torques = if first.shafting.passes_losses {
            2 * torques
        } else {
            torques.div_ceil(2)
        };
        // Flanks run in once, not at every torque.
        let meshes = first.cases().map(|case| at_torque(case, case.case.torque));
        let meshes = meshes.collect::<Result<_, _>>()?;
        Ok(Some(Work::new(meshes, torques * given.0.len())))
    }

    fn run(&self, given: CaseOrFinishes, watch: &Watch<'_>) -> Result<MapStudy, Fault> {
        let CaseOrFinishes(finishes) = given;
        let first = finishes.first()?;
        for finish in &finishes.0 {
            if differs_by_point(&first.input, &finish.case.input) {
                let message = format!(
                    "{}: torque, speed and temperature of a map are those of its axes, and nothing else changes",
                    finish.name
                );
                let help = "Give the axes of the map, or compare the variants at one operating point: asperity compare.";
                return Err(Fault::new(Code::E205, message).helping(help));
            }
        }
        let axes = self.axes(first)?;
        let extras = self.extras(&finishes)?;
        let mut map = map(&finishes.0, &axes, self.band, watch.progress)?;
        if let Some(code) = map.refused() {
            let advice = "Run the case at one of its points: its error names the cause.";
            return Err(Fault::new(code, "no point of the map has a loss").helping(advice));
        }
        map.table_warnings = extras.with(None).warnings();
        Ok(MapStudy { map, extras })
    }
}
