//! Filters of a trace: those of the case, of its file, or by default.

use asperity_profile_io::read::{FilterState, Reading};
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::Preparation;

use super::defaults::DefaultUsed;
use super::flank_place::ReadPlace;
use super::resolve::Case;
use crate::message::Warning;

/// Filters of one trace: those of the case, else those its file states, else the defaults.
pub(super) struct Filters {
    pub preparation: Preparation,
    /// Cut-offs that the file states and the case leaves open.
    pub stated: Vec<DefaultUsed>,
    /// The warning that the case asks for other cut-offs than the file states.
    pub overridden: Option<Warning>,
}

impl Filters {
    /// Filters that lose nothing at the ends of a placed trace, unless the case says how they are treated.
    pub(super) fn keep_ends(&mut self, case: &Case, key: &'static str, place: &ReadPlace) {
        if case.input.surface.ends.is_none() {
            self.preparation.ends = Ends::Reg1;
            self.stated.push(DefaultUsed {
                key: "surface.ends".into(),
                value: "\"reg1\"".to_owned(),
                source: Some("a placed trace keeps its ends".into()),
            });
        }
        if place.assumed_from {
            self.stated.push(DefaultUsed {
                key: format!("{key}.from").into(),
                value: "\"root\"".to_owned(),
                source: None,
            });
        }
    }

    pub(super) fn of(case: &Case, file: &str, reading: Option<&Reading>) -> Self {
        /// Cut-offs that differ by less are the same as printed.
        const SAME: f64 = 1e-6;
        let asked = &case.input.surface;
        let mut filters = Self {
            preparation: case.preparation,
            stated: Vec::new(),
            overridden: None,
        };
        // What was filtered before has been filtered with them.
        let unfiltered = reading.filter(|r| r.filter_state != FilterState::Roughness);
        let Some(facts) = unfiltered.map(|reading| &reading.metadata) else {
            return filters;
        };
        let mut others = Vec::new();
        let preparation = &mut filters.preparation;
        for (key, name, given, of_file, used) in [
            (
                "surface.cutoff",
                "λc",
                asked.cutoff,
                facts.lambda_c,
                &mut preparation.lambda_c,
            ),
            (
                "surface.noise_cutoff",
                "λs",
                asked.noise_cutoff,
                facts.lambda_s,
                &mut preparation.lambda_s,
            ),
        ] {
            let Some(of_file) = of_file else {
                continue;
            };
            match given {
                None => {
                    *used = Some(of_file);
                    filters.stated.push(DefaultUsed {
                        key: key.into(),
                        value: format!("\"{of_file}\""),
                        source: Some(format!("stated in {file}").into()),
                    });
                }
                Some(given) if (given / of_file - 1.0).abs() > SAME => {
                    others.push(format!("{name} {of_file}, the case {key} = {given}"));
                }
                Some(_) => {}
            }
        }
        if !others.is_empty() {
            filters.overridden = Some(Warning::new(
                "W129",
                format!("{file}: the file states {}", others.join("; ")),
            ));
        }
        filters
    }
}
