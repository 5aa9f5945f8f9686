//! Steady film of smooth surfaces: report, JSON and points.

use asperity::ehl::traction::{Heat, Traction, TractionLaw, traction};
use asperity::ehl::{
    FrictionLaw, RoughContact, Scales, Solved, SteadyFilm, SteadySettings, Warning, steady,
};
use asperity::oil::ShearLaw;
use asperity_core::{Code, Fault, by_size};
use asperity_report::Report;
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output::coded;

/// Steady film and its traction.
pub struct Smooth {
    pub title: String,
    cells: usize,
    pub solved: Solved<SteadyFilm>,
    /// Isothermal and thermal traction.
    traction: [Option<Traction>; 2],
}

/// Solves the contact of smooth surfaces and, if a friction law is given, its traction with limiting shear stress:
/// isothermal and thermal.
pub fn solve(
    title: String,
    contact: &RoughContact,
    friction: Option<FrictionLaw>,
    heat: Heat,
    cells: usize,
) -> Result<Smooth, Failure> {
    let RoughContact { contact, oil, .. } = contact;
    let settings = SteadySettings {
        cells,
        window: None,
    };
    let failed = |error| Fault::from(error).about(&title);
    let solved = steady::solve(contact, oil, &settings).map_err(failed)?;
    let law = |law: FrictionLaw, heat| TractionLaw {
        shear: match oil.shear_law {
            ShearLaw::Newtonian => ShearLaw::Eyring {
                stress: law.eyring_stress,
            },
            other => other,
        },
        limit: Some(law.limiting_slope),
        heat,
    };
    let of = |law: Option<TractionLaw>| {
        law.map(|law| traction(contact, oil, &solved.value, &law))
            .transpose()
            .map_err(failed)
    };
    let traction = [
        of(friction.map(|known| law(known, None)))?,
        of(friction.map(|known| law(known, Some(heat))))?,
    ];
    Ok(Smooth {
        traction,
        cells,
        solved,
        title,
    })
}

impl Smooth {
    /// Isothermal traction, and traction with heating.
    pub fn tractions(&self) -> [Option<Traction>; 2] {
        self.traction
    }

    pub fn warnings(&self) -> Vec<(Code, String)> {
        let text = |warning: &Warning| match warning {
            Warning::InletUnresolved { cells } => format!(
                "the inlet zone spans {cells:.1} cells (2 needed): the film comes out too thin; pass more --cells"
            ),
            Warning::SteepBarus { exponent } => format!(
                "alpha p0 is {exponent:.1} under Barus' law: the pressure spike keeps growing as the grid is refined"
            ),
            Warning::ExtrapolatedViscosity { pressure } => {
                format!("at {pressure:.4} the viscosity law is far extrapolated")
            }
            _ => String::from("outside the range of the solver"),
        };
        let warnings = self.solved.value.warnings.iter();
        warnings
            .map(|warning| (Code::W401, text(warning)))
            .collect()
    }

    /// Film as JSON.
    pub fn json(&self) -> Value {
        let (film, evidence) = (&self.solved.value, &self.solved.evidence);
        let scales = &film.scales;
        json!({
            "title": self.title,
            "kind": "smooth",
            "cells": self.cells,
            "half_width_um": scales.half_width.si() * 1e6,
            "hertz_pressure_pa": scales.max_pressure.si(),
            "moes_load": scales.moes_load,
            "moes_lubricant": scales.moes_lubricant,
            "slide_to_roll": scales.slide_to_roll,
            "solid_share": 0.0,
            "solid_share_standard_error": 0.0,
            "steps": 0,
            "steps_cut": 0,
            "mean_film_um": mean_film_um(film),
            "central_film_um": film.central_film.si() * 1e6,
            "minimum_film_um": film.minimum_film.si() * 1e6,
            "minimum_place": film.minimum_place,
            "flux": film.flux,
            "spike_pressure_pa": film.spike.map(|(p, _)| p * scales.max_pressure.si()),
            "spike_place": film.spike.map(|(_, x)| x),
            "exit": film.exit,
            "rolling_force_n_per_m": film.rolling_force.si(),
            "traction_coefficient": self.traction[0].map(|traction| traction.coefficient),
            "traction_isothermal": self.traction[0],
            "traction_thermal": self.traction[1],
            "newton_iterations": evidence.newton_iterations,
            "gmres_iterations": evidence.gmres_iterations,
            "load_error": evidence.load_error,
            "complementarity": evidence.complementarity,
            "mass_balance": evidence.mass_balance,
            "warnings": coded(self.warnings()),
        })
    }

    /// Film as a report.
    pub fn report<'a>(&self) -> Report<'a> {
        let (film, evidence) = (&self.solved.value, &self.solved.evidence);
        let spike = match film.spike {
            Some((pressure, place)) => format!(
                "spike {:.3} GPa at x/a {place:.3}",
                pressure * film.scales.max_pressure.si() * 1e-9
            ),
            None => String::from("no spike"),
        };
        let thickness = format!(
            "central film {} um   minimum film {} um at x/a {:.3}",
            by_size(film.central_film.si() * 1e6, 4),
            by_size(film.minimum_film.si() * 1e6, 4),
            film.minimum_place,
        );
        let pressure = format!(
            "{spike}   pressure ends at x/a {:.3}   rolling force {:.2} N/m per surface",
            film.exit,
            film.rolling_force.si(),
        );
        let solved = format!(
            "{} Newton, {} GMRES; load error {:.1e}, mass balance {:.1e}",
            evidence.newton_iterations,
            evidence.gmres_iterations,
            evidence.load_error,
            evidence.mass_balance
        );
        let warnings = self.warnings().into_iter();
        Report::new(&format!("{}, smooth", self.title), "")
            .verdict([thickness])
            .verdict(self.traction_line())
            .text([of_scales(&film.scales), pressure, solved])
            .warning(warnings.map(|(code, warning)| format!("{code} {warning}")))
    }

    /// The traction coefficient, isothermal and with heat.
    fn traction_line(&self) -> Option<String> {
        let [cold, hot] = &self.traction;
        let hot = hot.as_ref().map_or(String::new(), |hot| {
            format!(
                ", thermal {:.5} (film +{:.1} K, surfaces +{:.1} K)",
                hot.coefficient, hot.film_rise, hot.surface_rise
            )
        });
        let cold = cold.as_ref()?.coefficient;
        Some(format!("traction coefficient, isothermal {cold:.5}{hot}"))
    }

    /// Pressure, film and void fraction per point.
    pub fn points(&self) -> String {
        let film = &self.solved.value;
        let scales = &film.scales;
        let mut text = String::from("x_m,pressure_pa,film_m,void_fraction\n");
        for (i, x) in film.x.iter().enumerate() {
            text.push_str(&format!(
                "{:e},{:e},{:e},{:e}\n",
                x * scales.half_width.si(),
                film.pressure[i] * scales.max_pressure.si(),
                scales.film_length(film.film[i]).si(),
                film.void[i],
            ));
        }
        text
    }
}

/// Half-width, pressure and dimensionless numbers of a contact.
pub(super) fn of_scales(scales: &Scales) -> String {
    format!(
        "half width {:.4}   p0 {:.4}   slide-to-roll {:.3}   M {:.1}, L {:.1}",
        scales.half_width,
        scales.max_pressure,
        scales.slide_to_roll,
        scales.moes_load,
        scales.moes_lubricant,
    )
}

/// Mean film within the half-width \[µm\].
fn mean_film_um(film: &SteadyFilm) -> f64 {
    let inside = film.x.iter().zip(&film.film).filter(|(x, _)| x.abs() < 1.0);
    let (sum, count) = inside.fold((0.0, 0.0), |(sum, count), (_, h)| (sum + h, count + 1.0));
    film.scales.film_length(sum / count).si() * 1e6
}
