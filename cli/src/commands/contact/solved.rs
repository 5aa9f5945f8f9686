//! A solved contact: report, JSON and file of points.

use std::path::Path;

use asperity_contact::{ContactSolution, ContactWarning};
use asperity_core::Code;
use asperity_core::quantity::{Length, Pressure};
use asperity_report::Report;
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output::{coded, save};

/// Solved contact with its smooth reference.
pub struct SolvedContact {
    /// File and position.
    pub title: String,
    /// Spacing of the points.
    pub spacing: Length,
    /// Positions \[m\].
    pub x: Vec<f64>,
    /// Undeformed gap \[m\].
    pub undeformed: Vec<f64>,
    /// Solution.
    pub solution: ContactSolution,
    /// Largest pressure of the smooth contact.
    pub hertz_pressure: Pressure,
}

impl SolvedContact {
    /// Warnings with their codes.
    fn warnings(&self) -> Vec<(Code, String)> {
        let coded = |warning: ContactWarning| {
            let code = match warning {
                ContactWarning::PressureAtEnd { .. } => Code::W413,
                _ => Code::W414,
            };
            (code, warning.to_string())
        };
        self.solution.warnings().into_iter().map(coded).collect()
    }

    /// The contact as JSON, with the subsurface stress.
    pub fn json(&self, stress: Option<Value>) -> Value {
        let s = &self.solution;
        json!({
            "title": self.title,
            "points": s.pressure.len(),
            "load_n_per_m": s.load.si(),
            "approach_m": s.approach.si(),
            "approach_datum_m": s.datum.si(),
            "contact_fraction": s.contact_fraction,
            "p_max_pa": s.max_pressure.si(),
            "p_end_pa": s.end_pressure.si(),
            "hertz_p_max_pa": self.hertz_pressure.si(),
            "plastic_energy_j_per_m": s.dissipated.si(),
            "elastic_energy_j_per_m": s.elastic_energy.si(),
            "iterations": s.iterations,
            "residual": {
                "duality_gap": s.certificate.duality_gap,
                "penetration": s.certificate.penetration,
                "load_error": s.certificate.load_error,
                "reference_gap_m": s.certificate.reference_gap.si(),
            },
            "stress": stress,
            "warnings": coded(self.warnings()),
        })
    }

    /// The contact as a report, with lines about the subsurface stress.
    pub fn report<'a>(&self, stress: Vec<String>) -> Report<'a> {
        let s = &self.solution;
        let touching = format!(
            "contact fraction {:.6}   largest pressure {:.7} (of smooth flanks {:.1} MPa)",
            s.contact_fraction,
            s.max_pressure,
            self.hertz_pressure.si() * 1e-6
        );
        let load = format!(
            "load {:.6}   approach {:.7} (datum {:.6})",
            s.load, s.approach, s.datum
        );
        let solved = format!(
            "{} iterations; duality gap {:.1e}, penetration {:.1e}, load error {:.1e}",
            s.iterations,
            s.certificate.duality_gap,
            s.certificate.penetration,
            s.certificate.load_error,
        );
        let warnings = self.warnings().into_iter();
        Report::new(&self.title, "")
            .verdict([touching])
            .verdict(stress)
            .text([load, format!("plastic work {:.4e} J/m", s.dissipated.si())])
            .text([solved])
            .warning(warnings.map(|(code, warning)| format!("{code} {warning}")))
    }

    /// Writes x, undeformed gap, pressure, gap and displacement per point; every number can be read back
    /// exactly.
    pub fn write_points(&self, path: &Path) -> Result<(), Failure> {
        let s = &self.solution;
        let mut text =
            String::from("x_m,h_m,pressure_pa,gap_m,displacement_m,plastic_displacement_m\n");
        for i in 0..self.x.len() {
            text.push_str(&format!(
                "{:e},{:e},{:e},{:e},{:e},{:e}\n",
                self.x[i],
                self.undeformed[i],
                s.pressure[i],
                s.gap[i],
                s.displacement[i],
                s.plastic_displacement[i],
            ));
        }
        save(path, text.as_bytes())
    }
}
