//! Fig. 7: oils of various densities and viscosities, with and without the pressure variation across the film.

use std::path::Path;

use asperity::PositionError;
use asperity::case::LoadedCase;
use asperity::lubrication::formula_film;
use asperity::mesh::Mesh;
use asperity::oil::ViscosityLaw;
use asperity_core::Fault;
use asperity_core::numerics::range;
use asperity_core::quantity::{Density, DynamicViscosity};
use asperity_ns_film::{FluidModel, pressure_difference_across};
use asperity_report::chart::{Axis, Chart, Line, Series};
use asperity_report::tables::write;
use serde::Serialize;

use super::figure::PaperFigure;
use crate::film_pressure::film_between;

/// Densities from light spindle oil to a fluid 15 % denser than water.
const DENSITIES: [f64; 5] = [750.0, 850.0, 950.0, 1050.0, 1150.0];
/// Viscosities from 5 mPa s to 0.5 Pa s in equal ratios.
const VISCOSITIES: [f64; 5] = [0.005, 0.0158, 0.05, 0.158, 0.5];

#[derive(Serialize)]
struct OilRow {
    density_kg_per_m3: f64,
    viscosity_mpa_s: f64,
    film_central_um: f64,
    difference_paper_pa: f64,
    difference_reynolds_cross_pa: f64,
    difference_over_hertz: f64,
    efficiency_with_percent: f64,
    efficiency_without_percent: f64,
}

/// Largest viscosity \[mPa s\] in the range of Fig. 7b.
const MOST_SHOWN: f64 = 400.0;
const TABLE: &str = "fig07_lubricants.csv";

pub(super) fn figures(case: &LoadedCase, folder: &Path) -> Result<Vec<PaperFigure>, Fault> {
    let mut rows = Vec::new();
    for density in DENSITIES {
        for viscosity in VISCOSITIES {
            rows.push(row(case, density, viscosity)?);
        }
    }
    write(&folder.join(TABLE), rows.iter())?;
    Ok(vec![
        PaperFigure::curves("fig07a_lubricants", differences(&rows)),
        PaperFigure::curves("fig07b_efficiency", efficiencies(&rows)),
    ])
}

/// Curve over the viscosity at one density.
fn curve(
    rows: &[OilRow],
    name: &str,
    line: Line,
    density: f64,
    value: fn(&OilRow) -> f64,
) -> Series {
    let here = rows.iter().filter(|row| row.density_kg_per_m3 == density);
    Series::through(
        name,
        line,
        here.map(|row| [row.viscosity_mpa_s, value(row)]),
    )
}

fn chart(id: &str, title: &str, y: Axis) -> Chart {
    Chart::new(id, title, TABLE, Axis::new("viscosity", "mPa s").log(), y)
}

fn differences(rows: &[OilRow]) -> Chart {
    let title = "Fig. 7a: pressure difference across the film of oils, the paper's model";
    let mut chart = chart("fig07a", title, Axis::new("difference", "Pa").log());
    for density in DENSITIES {
        let name = format!("{density:.0} kg/m³");
        chart = chart.with(curve(rows, &name, Line::Dots, density, |row| {
            row.difference_paper_pa.abs()
        }));
    }
    chart
}

fn efficiencies(rows: &[OilRow]) -> Chart {
    let title = "Fig. 7b: efficiency with and without that variation; 500 mPa s is off the scale. The paper states \
        99.4635, 98.4188, 98.9345 and 98.5325 %";
    // Above, the film is full and Xu's law far outside of its data: this oil alone would determine the range.
    let mixed = rows.iter().filter(|row| row.viscosity_mpa_s < MOST_SHOWN);
    let values =
        mixed.flat_map(|row| [row.efficiency_with_percent, row.efficiency_without_percent]);
    let [low, high] = range(values);
    let margin = 0.08 * (high - low).max(1e-6);
    let axis = Axis::new("efficiency", "%").within(low - margin, high + margin);
    let mut chart = chart("fig07b", title, axis);
    for density in [DENSITIES[0], DENSITIES[4]] {
        let name = |kind: &str| format!("{kind}, {density:.0} kg/m³");
        chart = chart
            .with(curve(rows, &name("with"), Line::Dots, density, |row| {
                row.efficiency_with_percent
            }))
            .with(curve(
                rows,
                &name("without"),
                Line::Dashed,
                density,
                |row| row.efficiency_without_percent,
            ));
    }
    chart
}

fn row(case: &LoadedCase, density: f64, viscosity: f64) -> Result<OilRow, Fault> {
    let oil = *case.at_stated()?.oil();
    let case = case.with(|input| {
        let lubricant = &mut input.lubricant;
        lubricant.density = Some(Density::from_si(density));
        lubricant.density_temperature = None;
        lubricant.viscosity = Some(ViscosityLaw::Given {
            dynamic_viscosity: DynamicViscosity::from_si(viscosity),
            temperature: None,
        });
        lubricant.temperature_coefficient = Some(oil.temperature_coefficient);
        lubricant.pressure_viscosity = Some(oil.pressure_viscosity);
        lubricant.thermal_conductivity = Some(oil.thermal_conductivity);
    })?;
    let case = case.at_stated()?;
    let outcome = asperity::Run::new(case.loaded()).execute()?.into_only()?;
    let station = Mesh::new(&case)?.positions.remove(0);
    let central = formula_film(&case, &station)?.film.central;
    let film = film_between(&case.case.gears, case.oil(), &station, central);
    let across = |model| {
        pressure_difference_across(model, &film)
            .map(|p| p.si())
            .map_err(PositionError::from)
    };
    let paper = across(FluidModel::Paper)?;
    let efficiency = outcome.result.summary.efficiency;
    let at = &outcome.result.path[0];
    // Without the variation the asperities carry its load, with their friction coefficient.
    let carried = outcome
        .fields
        .first()
        .and_then(|fields| fields.history.last())
        .map_or(0.0, |step| step.load_fluid);
    let more =
        (case.case.model.boundary_friction - at.mu_film) * carried * at.sliding_m_per_s.abs();
    let loss = more * at.weight_m / outcome.result.summary.power_in_w;
    Ok(OilRow {
        density_kg_per_m3: density,
        viscosity_mpa_s: viscosity * 1e3,
        film_central_um: at.film_central_um,
        difference_paper_pa: paper,
        difference_reynolds_cross_pa: across(FluidModel::ReynoldsCross)?,
        difference_over_hertz: paper.abs() / station.hertz.max_pressure.si(),
        efficiency_with_percent: 100.0 * efficiency,
        efficiency_without_percent: 100.0 * (efficiency - loss),
    })
}
