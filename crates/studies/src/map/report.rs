//! Report of a map, and its folder: `map.json`, `map.csv`, `efficiency.csv`, `map.html`.

use asperity_core::number;
use asperity_report::{Report, StudyResult};

use super::page;
use super::point::Map;
use super::summary::{bands, extremes, in_words, left_aside, notes, of_meshes, verdicts};
use super::table;

impl StudyResult for Map {
    const KIND: &'static str = "map";
    const NAME: &'static str = "map";

    fn report(&self) -> Report<'_> {
        self.report_with(&[])
    }
}

impl Map {
    /// Its report, with torques \[N m\] and speeds \[1/min\] drawn over the fields.
    pub(super) fn report_with<'a>(&'a self, visited: &'a [[f64; 2]]) -> Report<'a> {
        let axes = &self.axes;
        let names: Vec<&str> = self.finishes.iter().map(|f| f.name.as_str()).collect();
        let points = format!(
            "{} points: {} x {} x {}; loss of the {} only.",
            axes.points(),
            counted(axes.torque_nm.len(), "torque"),
            counted(axes.speed_rpm.len(), "speed"),
            counted(axes.temperature_c.len(), "temperature"),
            self.scope
        );
        let report = Report::new(&self.title, format!("map of {}", names.join(", ")))
            .section("Loss")
            .verdict(verdicts(self).chain(self.run_in_at()));
        let [shaft, _] = self.shafts();
        let report = page::fields(report, self, visited)
            .text([points])
            .table(extremes(self))
            .text([format!(
                "The loss torque is the loss over the speed of the {shaft}."
            )])
            .on_page()
            .table(of_meshes(self))
            .warning(left_aside(self))
            .text(bands(self))
            .in_terminal()
            .text(notes(self))
            .in_terminal();
        page::sections(report, self, visited)
            .file(|folder| table::write(self, &folder.join("map.csv")))
            .rows(page::EFFICIENCIES, || page::drawn_efficiencies(self))
    }
}

impl Map {
    /// Torque at which the flanks have run in, in words; `None` of flanks as measured.
    fn run_in_at(&self) -> Option<String> {
        let operation = &self.input.operation;
        let stated = operation.running_in?.stated()?;
        let torque = stated.torque.unwrap_or(operation.torque).si().abs();
        let of = match self.finishes.first() {
            Some(finish) if self.are_variants => format!(" of {}", in_words(&finish.name)),
            _ => String::new(),
        };
        Some(format!(
            "The flanks{of} have run in by plastic flow at {} N m, of which the interval has no part.",
            number(torque)
        ))
    }
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
