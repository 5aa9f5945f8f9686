//! Filters of a trace: as stated, from its file, or by default.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::{Ends, shortest_noise_cutoff};
use asperity_roughness::preparation::Preparation;

use crate::flank_form::FormError;
use crate::statements::Statements;

/// Filters of the traces of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedFilters {
    /// Everything stated or by default.
    pub preparation: Preparation,
    /// Cut-offs λc and λs, if they are stated.
    pub cutoffs: [Option<Length>; 2],
    /// Treatment of the ends, if it is stated.
    pub ends: Option<Ends>,
    /// Form that is removed, if it is stated.
    pub form: Option<Form>,
}

/// Filters of one trace, with their differences from the filters of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filters {
    /// The filters.
    pub preparation: Preparation,
    /// Cut-offs λc and λs of the file that the case leaves open.
    pub of_file: [Option<Length>; 2],
    /// Cut-offs λc and λs of the file in whose place the case states others.
    pub overridden: [Option<Length>; 2],
    /// Whether the ends remain since the trace is placed.
    pub keeps_ends: bool,
    /// Whether the ends remain since the trace is of a scan that is too short without them.
    pub keeps_ends_of_scan: bool,
    /// Cut-off λs that follows the spacing of a scan whose points are farther apart than the default.
    pub of_spacing: Option<Length>,
    /// Whether the form stays in the trace although the case does not state so.
    pub keeps_form: bool,
    /// Cut-off between form and roughness that is longer than λc, the second value.
    pub parted: Option<(Length, Option<Length>)>,
}

impl Filters {
    /// The stated filters, else the filters of the file, else the defaults.
    pub(crate) fn new(stated: StatedFilters, of_heights: &Statements) -> Self {
        /// Cut-offs that differ by less are the same as printed.
        const SAME: f64 = 1e-6;
        let mut filters = Self {
            preparation: stated.preparation,
            of_file: [None; 2],
            overridden: [None; 2],
            keeps_ends: false,
            keeps_ends_of_scan: false,
            of_spacing: None,
            keeps_form: false,
            parted: None,
        };
        // A roughness profile was filtered with the cut-offs of its file.
        if of_heights.is_roughness() {
            return filters;
        }
        let preparation = &mut filters.preparation;
        let used = [&mut preparation.lambda_c, &mut preparation.lambda_s];
        for (k, used) in used.into_iter().enumerate() {
            let Some(of_file) = of_heights.cutoffs[k] else {
                continue;
            };
            match stated.cutoffs[k] {
                None => {
                    *used = Some(of_file);
                    filters.of_file[k] = Some(of_file);
                }
                Some(stated) if (stated / of_file - 1.0).abs() > SAME => {
                    filters.overridden[k] = Some(of_file);
                }
                Some(_) => {}
            }
        }
        filters
    }

    /// Fits filters that are not stated to the row of a scan, of which the contacts need the length `needed`: λs follows points that are
    /// farther apart, and the ends remain where too little would be left. A row of less than one and a half cut-offs has no part that
    /// its ends do not reach: it is left to be refused.
    pub(crate) fn fit_scan(&mut self, stated: StatedFilters, row: &Profile, needed: Length) {
        let preparation = &mut self.preparation;
        let spacing = row.spacing();
        let is_open = stated.cutoffs[1].is_none() && self.of_file[1].is_none();
        if is_open && preparation.lambda_s.is_some_and(|cutoff| cutoff < spacing) {
            self.of_spacing = Some(shortest_noise_cutoff(spacing));
            preparation.lambda_s = self.of_spacing;
        }
        let (Some(cutoff), None) = (preparation.lambda_c, stated.ends) else {
            return;
        };
        let left = row.length() - cutoff;
        let is_long = left >= cutoff * 0.5;
        if preparation.ends == Ends::Cut && is_long && (left < needed || left < cutoff) {
            preparation.ends = Ends::Reg1;
            self.keeps_ends_of_scan = true;
        }
    }

    /// Keeps the ends of a placed trace in filtering, unless their treatment is stated.
    pub(crate) fn keep_ends(&mut self, stated: StatedFilters) {
        if stated.ends.is_none() {
            self.preparation.ends = Ends::Reg1;
            self.keeps_ends = true;
        }
    }

    /// Leaves the form in a trace from which the relief is taken, and returns the cut-off at which it is separated from the
    /// roughness: λc, or `shortest` if that is longer.
    pub(crate) fn part_form(
        &mut self,
        stated: StatedFilters,
        shortest: Length,
        of_heights: &Statements,
    ) -> Result<Length, FormError> {
        if of_heights.is_roughness() {
            return Err(FormError::Filtered);
        }
        match stated.form {
            None => self.keeps_form = true,
            Some(Form::None | Form::Mean) => {}
            Some(other) => return Err(FormError::Removed(other)),
        }
        self.preparation.form = Form::None;
        let used = self.preparation.lambda_c;
        let cutoff = match used {
            Some(used) if used >= shortest => used,
            _ => {
                self.parted = Some((shortest, used));
                shortest
            }
        };
        self.preparation.lambda_c = Some(cutoff);
        Ok(cutoff)
    }
}
