//! Solved load share of two profiles over entrainment speeds, averaged over windows of the profiles.
//!
//! ```text
//! cargo run --release -p asperity-mixed-film --example shares_of_two_profiles first.txt second.txt [key=value ...]
//! ```
//!
//! The files hold one height in metres a line. Keys, SI units: `dx`, `amplitude` (factor on the heights),
//! `srr`, `p0`, `r`, `e`, `eta0`, `alpha`, `tau0`, `limit` (limiting shear over pressure), `mub`, `flow`, `um`
//! (speeds, separated by commas), `windows`.

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use std::collections::HashMap;
use std::f64::consts::PI;

use asperity_contact::SolverSettings;
use asperity_contact::hertz_line::HertzLine;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, DynamicViscosity, Length, LineLoad, PerKelvin, Pressure, PressureViscosity,
    SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use asperity_ehl_regime::{PairSpectrum, TraceSpectrum};
use asperity_mixed_film::{
    AttenuatedTraces, ContactTable, LoadShareSettings, PositionFilm, RoughContact, RoughWindow,
};
use asperity_oil::{BaseOil, FilmRheology, LubricantInput, TractionConstants, ViscosityLaw};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// Prints a row for each speed.
pub fn main() -> Outcome<()> {
    let mut files = Vec::new();
    let mut keys = HashMap::new();
    for word in std::env::args().skip(1) {
        match word.split_once('=') {
            Some((key, value)) => {
                keys.insert(key.to_owned(), value.to_owned());
            }
            None => files.push(word),
        }
    }
    let number = |key: &str, default: f64| -> Outcome<f64> {
        Ok(keys.get(key).map_or(Ok(default), |text| text.parse())?)
    };
    let [first, second] = files.as_slice() else {
        return Err("give two files of heights".into());
    };
    let factor = number("amplitude", 1.0)?;
    let read = |path: &String| -> Outcome<Vec<f64>> {
        let text = std::fs::read_to_string(path)?;
        let heights = text
            .split_whitespace()
            .map(|word| Ok(factor * word.parse::<f64>()?));
        heights.collect()
    };
    let heights = [read(first)?, read(second)?];
    let spacing = Length::from_si(number("dx", 0.5e-6)?);
    let spectra = [
        TraceSpectrum::new(&heights[0], spacing)?,
        TraceSpectrum::new(&heights[1], spacing)?,
    ];
    let radius = Length::from_si(number("r", 10e-3)?);
    let modulus = Pressure::from_si(number("e", 115.384_615e9)?);
    let p_0 = number("p0", 1.2e9)?;
    let load = LineLoad::from_si(PI * radius.si() * p_0 * p_0 / modulus.si());
    let hertz = HertzLine::new(load, radius, modulus)?;
    let rheology = rheology(&number)?;
    let settings = LoadShareSettings {
        boundary_friction: number("mub", 0.1)?,
        ..LoadShareSettings::default()
    };
    let reach = (3.0 * (hertz.half_width / spacing)).ceil() as usize;
    let points = 2 * reach + 1;
    let count = number("windows", 8.0)? as usize;
    let place = |part: f64, length: usize| (part * length.saturating_sub(points) as f64) as usize;
    let mut windows = Vec::new();
    for k in 0..count {
        let starts = [
            place((k as f64 + 0.5) / count as f64, heights[0].len()),
            place((0.5 + k as f64 * 0.618_034).fract(), heights[1].len()),
        ];
        let composite: Vec<f64> = (0..points)
            .map(|i| heights[0][starts[0] + i] + heights[1][starts[1] + i])
            .collect();
        let mut rough = RoughContact::new(&RoughWindow {
            composite: &composite,
            spacing,
            load,
            radius,
            modulus,
            flow_pressure: Pressure::from_si(number("flow", 7e9)?),
            settings: SolverSettings::default(),
        })?;
        windows.push((starts, ContactTable::build(&mut rough)?));
    }
    println!("u_m m/s, h_c um, sigma_d um, solid share, mean gap um, friction");
    for text in keys.get("um").map_or("5", String::as_str).split(',') {
        let speed: f64 = text.parse()?;
        let half_slip = 0.5 * number("srr", 0.2)?;
        let contact = LineContact {
            load,
            radius,
            modulus,
            speeds: [1.0 + half_slip, 1.0 - half_slip].map(|part| Speed::from_si(speed * part)),
            bodies: [steel(), steel()],
        };
        let mut film = PositionFilm::new(&rheology, &contact, bulk(), &settings)?;
        let flattening = film.flattening(&PairSpectrum::from_traces(spectra.each_ref()))?;
        let traces = AttenuatedTraces::new(spectra.each_ref(), &flattening);
        let mut sums = [0.0; 4];
        for (starts, table) in &windows {
            let roughness = traces.window(*starts, points)?;
            let found = film.share(table, &roughness)?.value;
            let values = [
                roughness.deviation.si() * 1e6,
                found.asperity_share,
                found.mean_gap.si() * 1e6,
                found.coefficient,
            ];
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += value / windows.len() as f64;
            }
        }
        let [rms, share, gap, friction] = sums;
        let smooth = film.smooth_film().si() * 1e6;
        println!("{speed}, {smooth:.4}, {rms:.4}, {share:.4}, {gap:.4}, {friction:.5}");
    }
    Ok(())
}

fn bulk() -> Temperature {
    Temperature::from_si(363.15)
}

fn steel() -> Material {
    Material {
        young: Pressure::from_si(210e9),
        poisson: 0.3,
        elastic_limit: Pressure::from_si(1.5e9),
        density: Density::from_si(7830.0),
        conductivity: ThermalConductivity::from_si(45.0),
        heat_capacity: SpecificHeat::from_si(465.0),
    }
}

/// An oil of density 850 kg/m³ with the viscosity and constants of the keys.
fn rheology(number: &dyn Fn(&str, f64) -> Outcome<f64>) -> Outcome<FilmRheology> {
    let density = 850.0;
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::Given {
            dynamic_viscosity: DynamicViscosity::from_si(number("eta0", 0.01)?),
            temperature: None,
        }),
        temperature_coefficient: Some(PerKelvin::from_si(0.028)),
        density: Some(Density::from_si(density)),
        base_oil: Some(BaseOil::Pao),
        ..LubricantInput::default()
    }
    .resolve(bulk())?;
    let constants = TractionConstants {
        eyring_stress: Pressure::from_si(number("tau0", 4e6)?),
        limiting_shear: number("limit", 0.05)?,
        ..TractionConstants::from_family(BaseOil::Pao)?
    };
    let alpha = PressureViscosity::from_si(number("alpha", 1.8e-8)?);
    Ok(FilmRheology::with_alpha(&oil, constants, alpha, bulk())?)
}
