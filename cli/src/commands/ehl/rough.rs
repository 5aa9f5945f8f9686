//! Record of two rough surfaces: report, JSON and points.

use std::sync::atomic::{AtomicU64, Ordering};

use asperity::ehl::several_records::{mean_of, record_several};
use asperity::ehl::transient::{MeanFriction, Moment};
use asperity::ehl::{
    NodeState, PlasticCeiling, Record, RecordMean, RecordSettings, Solved, Window,
};
use asperity::lubrication::{HIGHEST_PRESSURE, ShareComparison};
use asperity::reference_solution::{
    ReferenceContact, estimate_json, nanometres, record_json, record_warnings,
};
use asperity::result::loss_band::Digits;
use asperity_core::quantity::Length;
use asperity_core::{Code, Fault, by_size};
use asperity_report::{Report, columns};
use serde_json::{Value, json};

use super::laws;
use super::smooth::of_scales;
use crate::args::{Common, EhlArgs};
use crate::failure::Failure;
use crate::output::{Progress, coded};

/// Record with its contact.
pub struct Recorded {
    pub title: String,
    pub solid_film: Length,
    pub cells: usize,
    pub window: Window,
    /// Travel before the record, in half-widths.
    pub start: f64,
    pub solved: Solved<Record>,
    /// Solid share of each of the averaged records.
    pub shares: Vec<RecordMean>,
    /// Attenuated roughness in the contact, of both surfaces.
    pub attenuated_roughness: Length,
    /// Pressure at which the surfaces yield.
    pub ceiling: Option<PlasticCeiling>,
}

/// Solves a record and shows its progress.
pub fn solve(
    title: String,
    contact: &ReferenceContact,
    args: &EhlArgs,
    common: &Common,
) -> Result<Recorded, Failure> {
    let settings = &contact.record;
    let shown = Progress::new(common.quiet, "half-widths travelled");
    let count = usize::from(args.records);
    // Thousandths of a half-width, summed over the records.
    let travelled: Vec<AtomicU64> = (0..count).map(|_| AtomicU64::new(0)).collect();
    let result = record_several(&contact.rough, count, settings, &|number, progress| {
        travelled[number].store((1e3 * progress.time) as u64, Ordering::Relaxed);
        let all: u64 = travelled.iter().map(|t| t.load(Ordering::Relaxed)).sum();
        shown.at((all / 1000) as usize, progress.end.ceil() as usize * count);
        true
    });
    drop(shown);
    let records = result.map_err(|error| Fault::from(error).about(&title))?;
    let none = || Failure::new(Code::E501, format!("{title}: no reference solution"));
    let solved = mean_of(&records).ok_or_else(none)?;
    let highest = solved.value.max_pressure;
    if highest > HIGHEST_PRESSURE {
        let message = format!(
            "{title}: the pressure reaches {highest:.3}, above {HIGHEST_PRESSURE}, which no steel withstands"
        );
        return Err(Failure::new(Code::E308, message));
    }
    Ok(Recorded {
        solved,
        shares: records
            .iter()
            .map(|record| record.value.solid_share)
            .collect(),
        title,
        solid_film: settings.solid_film,
        cells: settings.cells,
        window: settings.window,
        start: settings.start,
        attenuated_roughness: contact.attenuated_roughness,
        ceiling: settings.ceiling,
    })
}

impl Recorded {
    /// Attenuated roughness relative to the smooth film.
    fn roughness_over_film(&self) -> f64 {
        self.attenuated_roughness / self.solved.value.smooth_film
    }

    /// The travel over which the means are taken, in words.
    pub fn travel(&self) -> String {
        let (start, end) = (self.start, self.start + self.solved.value.travel);
        let means =
            format!("The means are over the travel from {start:.1} to {end:.1} half-widths");
        let start_up = RecordSettings::default().start;
        if start < start_up {
            format!(
                "{means}. They include a part of the start: in the first {start_up:.0} half-widths the film is still smooth."
            )
        } else {
            format!("{means}, after the start from smooth surfaces.")
        }
    }

    /// Share of the load on thin films in both halves of the travel, if they differ by more than the standard error explains.
    fn unsteady(&self) -> Option<[f64; 2]> {
        let record = &self.solved.value;
        let mean = |half: &[Moment]| {
            half.iter().map(|moment| moment.solid_share).sum::<f64>() / half.len().max(1) as f64
        };
        let (first, second) = record.history.split_at(record.history.len() / 2);
        let halves = [first, second].map(mean);
        let change = (halves[1] - halves[0]).abs();
        (change > 2.0 * record.solid_share.standard_error).then_some(halves)
    }

    /// A mean over the travel with its standard error, which says nothing if the halves of the travel differ.
    pub fn shown(&self, mean: f64, standard_error: f64) -> String {
        self.shown_with("", mean, standard_error)
    }

    /// A mean with its unit, and its standard error.
    pub fn shown_with(&self, unit: &str, mean: f64, standard_error: f64) -> String {
        match self.unsteady() {
            None => with_error(unit, mean, standard_error),
            Some(_) => {
                let digits = Digits::of_uncertainty(2.0 * standard_error);
                format!("{}{unit} (not steady)", digits.rounded(mean))
            }
        }
    }

    /// Doubt about the means of a travel whose halves differ, in words.
    pub fn doubt(&self) -> Option<String> {
        /// Ratio of the next travel to this one.
        const LONGER: f64 = 4.0;
        let [first, second] = self.unsteady()?;
        Some(format!(
            "Not steady: the share of the load on thin films is {first:.2} in the first half of the travel and {second:.2} in the second. \
            The means of this travel are known no better than that: repeat with --half-widths {:.0}.",
            LONGER * self.solved.value.travel
        ))
    }

    /// Warnings with their codes.
    pub fn warnings(&self) -> Vec<(Code, String)> {
        record_warnings(&self.solved.value, self.attenuated_roughness, self.ceiling)
    }

    /// Record as JSON.
    pub fn json(&self, comparison: Option<&ShareComparison>) -> Value {
        let (record, evidence) = (&self.solved.value, &self.solved.evidence);
        let more = json!({
            "title": self.title,
            "kind": "rough",
            "cells": self.cells,
            "blocks": record.blocks,
            "records": self.shares.iter().map(estimate_json).collect::<Vec<_>>(),
            "solid_film_nm": nanometres(self.solid_film),
            "attenuated_roughness_um": self.attenuated_roughness.si() * 1e6,
            "roughness_over_film": self.roughness_over_film(),
            "steps": evidence.steps,
            "steps_cut": evidence.steps_cut,
            "loose_steps": evidence.loose_steps,
            "newton_iterations": evidence.newton_iterations,
            "gmres_iterations": evidence.gmres_iterations,
            "gmres_capped": evidence.gmres_capped,
            "load_error": evidence.load_error,
            "complementarity": evidence.complementarity,
            "mass_balance": evidence.mass_balance,
            "mean_mass_balance": evidence.mean_mass_balance,
            "boundary_supply": evidence.boundary_supply,
            "mean_boundary_supply": evidence.mean_boundary_supply,
            "comparison": comparison,
            "warnings": coded(self.warnings()),
        });
        let mut numbers = record_json(record);
        if let Value::Object(more) = more {
            numbers.extend(more);
        }
        Value::Object(numbers)
    }

    /// Record as a report, with the laws of load sharing in comparison.
    pub fn report<'a>(&self, comparison: Option<&ShareComparison>) -> Report<'a> {
        let (record, evidence) = (&self.solved.value, &self.solved.evidence);
        let share = format!(
            "solid share (below {:.0} nm) {} over {:.1} half-widths{}",
            nanometres(self.solid_film),
            self.shown(record.solid_share.mean, record.solid_share.standard_error),
            record.travel,
            match self.shares.len() {
                1 => String::new(),
                count => format!(" in {count} reference solutions"),
            },
        );
        let film = format!(
            "smooth central film {} um   mean film {} um, spread {} um",
            by_size(record.smooth_film.si() * 1e6, 4),
            self.shown(
                record.mean_film.mean * 1e6,
                record.mean_film.standard_error * 1e6
            ),
            by_size(record.film_spread.si() * 1e6, 4),
        );
        let below = columns! { below in &record.load_below;
            number film "films up to" "nm" "{:.0}" = nanometres(below.film);
            number share "share of the load" "" = self.shown(below.share.mean, below.share.standard_error);
        };
        let pressure = format!(
            "largest pressure {:.3} GPa on average, {:.3} GPa at most; {:.4} of the load at the flow pressure",
            record.mean_max_pressure.mean * 1e-9,
            record.max_pressure.si() * 1e-9,
            record.plastic_share.mean
        );
        let oil = format!(
            "oil gained or lost {:.4} of the flux on average, {:.2} at most in a step; supplied by the boundary film {:.4}",
            evidence.mean_mass_balance, evidence.mass_balance, evidence.mean_boundary_supply,
        );
        let solved = format!(
            "{} steps, {} cut, {} with a held node; {:.1} Newton per step, {:.1} GMRES per Newton; load error {:.1e}",
            evidence.steps,
            evidence.steps_cut,
            evidence.loose_steps,
            evidence.newton_iterations as f64 / evidence.steps.max(1) as f64,
            evidence.gmres_iterations as f64 / evidence.newton_iterations.max(1) as f64,
            evidence.load_error,
        );
        let warnings = self.warnings().into_iter();
        let report = Report::new(&self.title, "")
            .verdict([share])
            .verdict(self.doubt())
            .verdict(self.friction())
            .table(below)
            .text([
                self.travel(),
                film,
                pressure,
                of_scales(&record.scales),
                oil,
                solved,
            ])
            .warning(warnings.map(|(code, warning)| format!("{code} {warning}")));
        match comparison {
            Some(comparison) => laws::shown(report, comparison),
            None => report,
        }
    }

    /// The friction, isothermal and with heat.
    fn friction(&self) -> Vec<String> {
        let record = &self.solved.value;
        let friction = |name: &str, friction: &MeanFriction| {
            format!(
                "{name} {} (boundary below the solid film {:.5}, film alone {:.5})",
                self.shown(friction.shifted.mean, friction.shifted.standard_error),
                friction.stepped.mean,
                friction.film.mean
            )
        };
        let mut lines = Vec::new();
        lines.extend(
            record
                .friction
                .as_ref()
                .map(|cold| friction("friction", cold)),
        );
        if let Some(heated) = &record.heated {
            lines.push(friction("with heat", &heated.friction));
            lines.push(format!(
                "rise of the film {:.1} K, of the surfaces {:.1} K",
                heated.film_rise.mean, heated.surface_rise.mean
            ));
        }
        lines
    }

    /// Pressure, film and state per point at all recorded times.
    pub fn points(&self) -> String {
        let record = &self.solved.value;
        let a = record.scales.half_width.si();
        let p_0 = record.scales.max_pressure.si();
        let mut text = String::from("travel_half_widths,x_m,pressure_pa,film_m,state\n");
        for frame in &record.frames {
            for (i, x) in record.x.iter().enumerate() {
                let state = match frame.state[i] {
                    NodeState::Full => "full",
                    NodeState::Cavitated => "cavitated",
                    NodeState::Contact => "contact",
                };
                text.push_str(&format!(
                    "{},{:e},{:e},{:e},{state}\n",
                    frame.time,
                    x * a,
                    frame.pressure[i] * p_0,
                    record.scales.film_length(frame.film[i]).si(),
                ));
            }
        }
        text
    }
}

/// Mean with its standard error, which a record of few blocks does not have.
fn with_error(unit: &str, mean: f64, standard_error: f64) -> String {
    if standard_error.is_finite() {
        let digits = Digits::of_uncertainty(standard_error);
        let [mean, error] = [mean, standard_error].map(|value| digits.rounded(value));
        format!("{mean}{unit} (standard error {error})")
    } else {
        format!("{mean:.4}{unit} (solution too short for a standard error)")
    }
}
