//! Folder of a calibration: `calibration.json`, `calibration.toml` (the block), `points.csv`, `calibration.html`. Folder of
//! a design: `design.json`, `design.csv` to fill in, `design.html`, and on request `simulated.csv`.

use std::fmt::Write as _;
use std::path::Path;

use asperity_core::Fault;
use asperity_report::{StudyResult, tables, write_text};

use crate::design::Design;
use crate::page;
use crate::result::Calibration;
use crate::rig_table::SIMULATED;
use crate::summary::{design_summary, summary};

/// Kind of both folders in messages.
const KIND: &str = "calibration";

impl StudyResult for Calibration {
    const KIND: &'static str = KIND;
    const NAME: &'static str = "calibration";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(self)
    }

    fn page(&self, (): ()) -> String {
        page::render(self)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_text(&folder.join("calibration.toml"), &self.block)?;
        tables::write(&folder.join("points.csv"), self.points.iter())
    }
}

impl StudyResult for Design {
    const KIND: &'static str = KIND;
    const NAME: &'static str = "design";
    /// Simulated losses at the points \[W\].
    type Context<'a> = Option<&'a [f64]>;

    fn summary(&self, simulated: Option<&[f64]>) -> String {
        let mut text = design_summary(self);
        if simulated.is_some() {
            text.push_str("simulated.csv holds SIMULATED losses at these points\n");
        }
        text
    }

    fn page(&self, _: Option<&[f64]>) -> String {
        page::render_design(self)
    }

    fn write_tables(&self, simulated: Option<&[f64]>, folder: &Path) -> Result<(), Fault> {
        write_text(&folder.join("design.csv"), &table(self, None))?;
        match simulated {
            Some(losses) => write_text(&folder.join("simulated.csv"), &table(self, Some(losses))),
            None => Ok(()),
        }
    }
}

/// Rig table for `design`, with empty or simulated losses.
fn table(design: &Design, simulated: Option<&[f64]>) -> String {
    let mut text = String::new();
    if simulated.is_some() {
        text.push_str(&format!(
            "# {SIMULATED} by {}: not measured\n",
            design.program
        ));
    }
    text.push_str(
        "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,assembly,order,includes,flank_state\n",
    );
    for (k, (number, assembly)) in design.rows().enumerate() {
        let point = &design.points[number];
        let loss = simulated.and_then(|losses| losses.get(k));
        let measured = loss.map_or(",".to_owned(), |loss| {
            format!("{loss:.3},{:.3}", design.limits.sigma * loss)
        });
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{measured},{},{},mesh,",
            point.torque_nm,
            point.speed_rpm,
            point.temperature_c,
            assembly + 1,
            k + 1
        );
    }
    text
}
