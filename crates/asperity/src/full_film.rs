//! A film that carries the whole load, from the elastohydrodynamic solution instead of formulas.

use asperity_core::quantity::Length;
use asperity_ehl::traction::{Heat, TractionLaw, traction};
use asperity_ehl::{Oil, ShearLaw, SteadySettings, ViscosityLaw, steady};
use asperity_ehl_regime::inlet_flow::CentralFilm;
use asperity_tribo_friction::{PressureLaw, ShearLaw as FilmShearLaw};
use serde::{Deserialize, Serialize};

use crate::case::{Case, FullFilmName};
use crate::error::PositionError;
use crate::records::PathRecords;
use crate::referee::smooth_contact;
use crate::station::Station;

/// Deviation from the formulas that a run warns about.
pub(crate) const NOTED_DEVIATION: f64 = 0.1;

/// A full film at one mesh position.
#[derive(Debug, Clone)]
pub(crate) struct FullFilm {
    half_width: f64,
    /// Places over the half-width, pressures \[Pa\] and films \[m\] there.
    x: Vec<f64>,
    pressure: Vec<f64>,
    film: Vec<f64>,
    /// Friction coefficient; none for a published law, which has its own.
    pub coefficient: Option<f64>,
    pub row: FullFilmRow,
}

/// Elastohydrodynamic solution of a full film beside the formulas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FullFilmRow {
    /// Gap in the middle, of records the mean gap, thermal reduction of smooth films included \[µm\].
    pub film_central_um: f64,
    /// Minimum film, thermal reduction included \[µm\].
    pub film_minimum_um: f64,
    /// Largest pressure \[MPa\].
    pub p_max_mpa: f64,
    /// Friction coefficient; absent where a published law gives it.
    pub mu: Option<f64>,
    /// Central film over that of the formula minus 1, both as flow of mass at ambient density.
    pub film_central_deviation: f64,
    /// Minimum film over that of the formula, minus 1.
    pub film_minimum_deviation: f64,
    /// Friction coefficient over that of the friction law, minus 1.
    pub mu_deviation: Option<f64>,
}

impl FullFilmRow {
    /// Largest deviation from a formula.
    pub(crate) fn largest_deviation(&self) -> f64 {
        let films = self
            .film_central_deviation
            .abs()
            .max(self.film_minimum_deviation.abs());
        self.mu_deviation.map_or(films, |mu| films.max(mu.abs()))
    }
}

impl FullFilm {
    /// The full film of `station` by the choice of the case; none for formulas, and where records were asked
    /// for and there are none. `law` is the friction of the film by the case's law, none for a published one.
    pub(crate) fn at(
        case: &Case,
        station: &Station,
        records: Option<&PathRecords>,
        law: Option<f64>,
    ) -> Result<Option<Self>, PositionError> {
        match (case.model.full_film, records) {
            (FullFilmName::Ehl, _) => Ok(Some(Self::smooth(case, station, law)?)),
            (FullFilmName::EhlTransient, Some(records)) => {
                Ok(Some(Self::recorded(station, records, law)?))
            }
            _ => Ok(None),
        }
    }

    /// Steady film of smooth flanks with its traction: limiting shear stress, heat of film and surfaces.
    ///
    /// The inlet is isothermal; the thermal reduction of the case thins the film as it does that of the formula.
    fn smooth(case: &Case, station: &Station, law: Option<f64>) -> Result<Self, PositionError> {
        let (contact, oil) = smooth_contact(case, station);
        let settings = SteadySettings {
            cells: case.model.ehl.cells,
            window: None,
        };
        let film = steady::solve(&contact, &oil, &settings)?.value;
        let reduction = station.thermal_reduction;
        let scale = film.scales.film_length(1.0).si() * reduction;
        let coefficient = match law {
            Some(_) => {
                let law = traction_law(case)?;
                // The film is solved with Roelands' law; its shear is that of the case's friction.
                let sheared = Oil {
                    viscosity_law: viscosity_law(case, oil.viscosity_law),
                    ..oil
                };
                Some(traction(&contact, &sheared, &film, &law)?.coefficient)
            }
            None => None,
        };
        // The formula's central film is a flow of mass.
        let flow = film.flux * scale / station.film.central.si();
        let central = film.central_film.si() * reduction;
        let p_0 = station.hertz.max_pressure.si();
        Ok(Self::new(
            station,
            Fields {
                x: film.x,
                pressure: film.pressure.iter().map(|p| p * p_0).collect(),
                film: film.film.iter().map(|h| h * scale).collect(),
            },
            [central, film.minimum_film.si() * reduction, flow],
            (coefficient, law),
        ))
    }

    /// Means over the records beside the position.
    fn recorded(
        station: &Station,
        records: &PathRecords,
        law: Option<f64>,
    ) -> Result<Self, PositionError> {
        let p_0 = station.hertz.max_pressure;
        let (x, pressure, film) = records.profile(station.s);
        let share = records.at(station.s, law);
        let gap = Length::from_si(share.mean_gap.mean);
        // The formula's film is a flow of mass: the gap is thinner by the density under pressure.
        let gap_of_formula = CentralFilm::Gap.thickness(station.film.central, p_0)?;
        let minimum = film
            .iter()
            .zip(&x)
            .filter(|(_, x)| x.abs() < 1.0)
            .map(|(film, _)| *film)
            .fold(f64::INFINITY, f64::min);
        let flow = gap / gap_of_formula;
        let pressure = pressure.iter().map(|p| p * p_0.si()).collect();
        Ok(Self::new(
            station,
            Fields { x, pressure, film },
            [gap.si(), minimum, flow],
            (share.film_coefficient, law),
        ))
    }

    fn new(
        station: &Station,
        fields: Fields,
        [central, minimum, flow]: [f64; 3],
        (coefficient, law): (Option<f64>, Option<f64>),
    ) -> Self {
        let off = |value: f64, formula: f64| value / formula - 1.0;
        let largest = fields.pressure.iter().copied().fold(0.0, f64::max);
        let deviation = coefficient
            .zip(law.filter(|law| *law > 0.0))
            .map(|(mu, law)| off(mu, law));
        Self {
            half_width: station.hertz.half_width.si(),
            row: FullFilmRow {
                film_central_um: central * 1e6,
                film_minimum_um: minimum * 1e6,
                p_max_mpa: largest * 1e-6,
                mu: coefficient,
                film_central_deviation: flow - 1.0,
                film_minimum_deviation: off(minimum, station.film.minimum.si()),
                mu_deviation: deviation,
            },
            x: fields.x,
            pressure: fields.pressure,
            film: fields.film,
            coefficient,
        }
    }

    /// Pressures at the points `x` \[m\]; zero outside the solution.
    pub(crate) fn pressure_at(&self, x: &[f64]) -> Vec<f64> {
        let value = |x: &f64| match self.cell(*x) {
            Some((k, part)) => self.pressure[k] + part * (self.pressure[k + 1] - self.pressure[k]),
            None => 0.0,
        };
        x.iter().map(value).collect()
    }

    /// Films at the points `x` \[m\]; outside the solution that of its end and the parabola beyond.
    pub(crate) fn gap_at(&self, x: &[f64], radius: Length) -> Vec<f64> {
        let last = self.x.len() - 1;
        let value = |x: &f64| match self.cell(*x) {
            Some((k, part)) => self.film[k] + part * (self.film[k + 1] - self.film[k]),
            None => {
                let end = if *x < 0.0 { 0 } else { last };
                let edge = self.x[end] * self.half_width;
                self.film[end] + (x * x - edge * edge) / (2.0 * radius.si())
            }
        };
        x.iter().map(value).collect()
    }

    /// Cell of the solution that holds `x` \[m\], and the place in it.
    fn cell(&self, x: f64) -> Option<(usize, f64)> {
        let x = x / self.half_width;
        let after = self.x.partition_point(|node| *node <= x);
        if after == 0 || after >= self.x.len() {
            return None;
        }
        let (low, high) = (self.x[after - 1], self.x[after]);
        Some((after - 1, (x - low) / (high - low)))
    }
}

struct Fields {
    x: Vec<f64>,
    pressure: Vec<f64>,
    film: Vec<f64>,
}

/// Viscosity over pressure of the film friction of the case.
fn viscosity_law(case: &Case, of_film: ViscosityLaw) -> ViscosityLaw {
    match case.model.film_pressure_law {
        PressureLaw::Barus => ViscosityLaw::Barus,
        _ => of_film,
    }
}

/// Shear law of the film friction with the limiting stress and the heat of the case.
fn traction_law(case: &Case) -> Result<TractionLaw, PositionError> {
    let rheology = case
        .rheology
        .as_ref()
        .ok_or(asperity_core::lubricant::LubricantError::NoBaseOil)?;
    let constants = rheology.constants();
    let shear = match rheology.laws().0 {
        FilmShearLaw::Newton => ShearLaw::Newtonian,
        FilmShearLaw::Carreau => ShearLaw::Carreau {
            modulus: constants.carreau.critical_stress,
            exponent: constants.carreau.exponent,
        },
        _ => ShearLaw::Eyring {
            stress: constants.eyring_stress,
        },
    };
    Ok(TractionLaw {
        shear,
        limit: Some(constants.limiting_shear),
        heat: Some(Heat {
            bulk: case.temperature,
            temperature_coefficient: case.oil.temperature_coefficient,
            oil_conductivity: case.oil.thermal_conductivity,
            material: case.materials[0],
        }),
    })
}
