//! Filters of a trace: from the case, from its file, or by default.

use asperity_core::Code;
use asperity_core::quantity::Length;
use asperity_gear::Gear;
use asperity_profile_io::read::{FilterState, Reading};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::Preparation;

use super::defaults::DefaultUsed;
use super::flank_form::{FormError, is_from_trace, shortest_form};
use super::flank_place::ReadPlace;
use super::resolve::Case;
use asperity_core::message::Warning;

/// Filters of one trace: from the case, else from its file, else the defaults.
pub(super) struct Filters {
    pub preparation: Preparation,
    /// Cut-offs that the file states and the case leaves open.
    pub stated: Vec<DefaultUsed>,
    /// The warning that the cut-offs of the case differ from those of the file.
    pub overridden: Option<Warning>,
    /// The warning that the cut-off is longer than stated.
    pub parted: Option<Warning>,
}

impl Filters {
    /// Keeps the ends of a placed trace in filtering, unless the case states their treatment.
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

    /// Leaves the form in a trace from which the relief is taken, and returns the cut-off at which it is separated from the
    /// roughness; `None` if the relief of the gear is drawn.
    pub(super) fn part_form(
        &mut self,
        case: &Case,
        gear: Gear,
        reading: Option<&Reading>,
    ) -> Result<Option<Length>, FormError> {
        let (true, Some(shortest)) = (is_from_trace(case, gear), shortest_form(case)?) else {
            return Ok(None);
        };
        if reading.is_some_and(|reading| reading.filter_state == FilterState::Roughness) {
            return Err(FormError::Filtered);
        }
        match case.input.surface.form {
            None => self.stated.push(DefaultUsed {
                key: "surface.form".into(),
                value: "\"none\"".to_owned(),
                source: Some("of a trace that the relief is taken from".into()),
            }),
            Some(Form::None | Form::Mean) => {}
            Some(other) => return Err(FormError::Removed(other)),
        }
        self.preparation.form = Form::None;
        let stated = self.preparation.lambda_c;
        let cutoff = match stated {
            Some(stated) if stated >= shortest => stated,
            _ => {
                let stated = stated.map_or("no cut-off".to_owned(), |stated| format!("{stated}"));
                self.parted = Some(Warning::new(
                    Code::W434,
                    format!(
                        "form and roughness of the {gear} are parted at {:.2} mm, eight half-widths of the contact, instead of {stated}: shorter waves lie within a contact and count as roughness",
                        shortest.si() * 1e3
                    ),
                ));
                shortest
            }
        };
        self.preparation.lambda_c = Some(cutoff);
        Ok(Some(cutoff))
    }

    pub(super) fn of(case: &Case, file: &str, reading: Option<&Reading>) -> Self {
        /// Cut-offs that differ by less are the same as printed.
        const SAME: f64 = 1e-6;
        let surface = &case.input.surface;
        let mut filters = Self {
            preparation: case.preparation,
            stated: Vec::new(),
            overridden: None,
            parted: None,
        };
        // A roughness profile was filtered with the cut-offs of its file.
        let unfiltered = reading.filter(|r| r.filter_state != FilterState::Roughness);
        let Some(facts) = unfiltered.map(|reading| &reading.metadata) else {
            return filters;
        };
        let mut others = Vec::new();
        let preparation = &mut filters.preparation;
        for (key, name, stated, of_file, used) in [
            (
                "surface.cutoff",
                "λc",
                surface.cutoff,
                facts.lambda_c,
                &mut preparation.lambda_c,
            ),
            (
                "surface.noise_cutoff",
                "λs",
                surface.noise_cutoff,
                facts.lambda_s,
                &mut preparation.lambda_s,
            ),
        ] {
            let Some(of_file) = of_file else {
                continue;
            };
            match stated {
                None => {
                    *used = Some(of_file);
                    filters.stated.push(DefaultUsed {
                        key: key.into(),
                        value: format!("\"{of_file}\""),
                        source: Some(format!("stated in {file}").into()),
                    });
                }
                Some(stated) if (stated / of_file - 1.0).abs() > SAME => {
                    others.push(format!("{name} {of_file}, the case {key} = {stated}"));
                }
                Some(_) => {}
            }
        }
        if !others.is_empty() {
            filters.overridden = Some(Warning::new(
                Code::W129,
                format!("{file}: the file states {}", others.join("; ")),
            ));
        }
        filters
    }
}
