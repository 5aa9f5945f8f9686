//! Output of a cycle: `cycle.json`, `cycle.csv`, `cycle.html` and summary.

use std::path::Path;

use asperity_core::Fault;
use asperity_report::{StudyResult, tables};
use serde::Serialize;

use super::energy::CycleResult;
use super::page;
use super::summary::summary;
use crate::map::Map;

#[derive(Serialize)]
struct CyclePointRow<'a> {
    time_s: f64,
    torque_nm: f64,
    speed_rpm: f64,
    loss_w: f64,
    loss_median_w: Option<f64>,
    loss_p05_w: Option<f64>,
    loss_p95_w: Option<f64>,
    finish: &'a str,
}

impl StudyResult for CycleResult {
    const KIND: &'static str = "cycle";
    const NAME: &'static str = "cycle";
    /// Map on which the cycle was evaluated.
    type Context<'a> = &'a Map;

    fn summary(&self, _: &Map) -> String {
        summary(self)
    }

    fn page(&self, map: &Map) -> String {
        page::render(self, map)
    }

    fn write_tables(&self, _: &Map, folder: &Path) -> Result<(), Fault> {
        let rows = self.finishes.iter().flat_map(|finish| {
            let points = self.points.iter().zip(&finish.loss_w);
            points.enumerate().map(move |(k, (point, loss_w))| {
                let drawn = finish.drawn_w.get(k);
                let of = |which: usize| drawn.map(|drawn| drawn[which]);
                CyclePointRow {
                    time_s: point.time_s,
                    torque_nm: point.torque_nm,
                    speed_rpm: point.speed_rpm,
                    loss_w: *loss_w,
                    loss_median_w: of(0),
                    loss_p05_w: of(1),
                    loss_p95_w: of(2),
                    finish: &finish.name,
                }
            })
        });
        tables::write(&folder.join("cycle.csv"), rows)
    }
}
