//! Two rough flanks rolling and sliding through each other: load against film, films, friction.
//!
//! ```text
//! cargo run --release -p asperity-ehl --example two_rough_flanks [key=value ...]
//! ```
//!
//! Without files the flanks are waves of random phase. Keys, SI units: `z1`, `z2` (files with one height
//! in metres a line, periodic) and their spacing `dx`; `amplitude` (factor on the heights), `um`, `srr`,
//! `p0`, `r`, `eta0`, `alpha`, `z`, `tau0` (0: Newtonian), `n`, `start`, `length`, `courant`, `flow` (plastic
//! ceiling), `limit`, `mub`, `tauf` (friction law), `hb` (contact film), `offset1`,
//! `offset2` (in half-widths).

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use std::collections::HashMap;
use std::time::Instant;

use asperity_core::Profile;
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_ehl::{
    FrictionLaw, LineContact, MovingProfile, Oil, PlasticCeiling, RecordSettings, RoughContact,
    transient,
};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

struct Keys(HashMap<String, String>);

impl Keys {
    fn number(&self, key: &str, default: f64) -> Outcome<f64> {
        Ok(self.0.get(key).map_or(Ok(default), |text| text.parse())?)
    }

    /// Heights of a file, or waves of random phase.
    fn surface(&self, key: &str, seed: u32) -> Outcome<MovingProfile> {
        let heights: Vec<f64> = match self.0.get(key) {
            Some(path) => std::fs::read_to_string(path)?
                .split_whitespace()
                .map(str::parse)
                .collect::<Result<_, _>>()?,
            None => waves(seed),
        };
        let amplitude = self.number("amplitude", 1.0)?;
        let heights = heights.into_iter().map(|z| amplitude * z).collect();
        let spacing = Length::from_si(self.number("dx", 0.5e-6)?);
        Ok(MovingProfile::periodic(&Profile::new(spacing, heights)?))
    }
}

/// Waves of 20 to 800 µm with amplitudes in proportion to their length, Rq 0.1 µm.
fn waves(seed: u32) -> Vec<f64> {
    let points = 4800;
    let mut state = seed;
    let mut phase = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1u32 << 24) * std::f64::consts::TAU
    };
    let modes: Vec<(f64, f64)> = (3..=120).map(|k| (f64::from(k), phase())).collect();
    let heights: Vec<f64> = (0..points)
        .map(|i| {
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(points);
            modes
                .iter()
                .map(|(k, phase)| (k * turn + phase).cos() / k)
                .sum()
        })
        .collect();
    let square: f64 = heights.iter().map(|z: &f64| z * z).sum();
    let scale = 0.1e-6 / (square / f64::from(points)).sqrt();
    heights.into_iter().map(|z| scale * z).collect()
}

fn main() -> Outcome<()> {
    let keys = Keys(
        std::env::args()
            .skip(1)
            .filter_map(|text| {
                text.split_once('=')
                    .map(|(k, v)| (k.to_owned(), v.to_owned()))
            })
            .collect(),
    );
    let eta0 = DynamicViscosity::from_si(keys.number("eta0", 0.01)?);
    let alpha = PressureViscosity::from_si(keys.number("alpha", 1.8e-8)?);
    let tau0 = keys.number("tau0", 5e6)?;
    let oil = Oil {
        viscosity: eta0,
        pressure_viscosity: alpha,
        viscosity_law: PressureViscosityLaw::Roelands {
            exponent: keys.number("z", 0.6)?,
        },
        density_law: DensityLaw::DowsonHigginson,
        shear_law: if tau0 > 0.0 {
            ShearLaw::Eyring {
                stress: Pressure::from_si(tau0),
            }
        } else {
            ShearLaw::Newtonian
        },
    };
    let contact = LineContact::at_pressure(
        Length::from_si(keys.number("r", 10e-3)?),
        Pressure::from_si(keys.number("e", 115.384_615e9)?),
        Pressure::from_si(keys.number("p0", 1.2e9)?),
        Speed::from_si(keys.number("um", 5.0)?),
        keys.number("srr", 0.2)?,
    )?;
    let a = contact.scales(&oil)?.half_width;
    let offset = |key| keys.number(key, 100.0).map(|turns| a * turns);
    let rough = RoughContact {
        contact,
        oil,
        surface_1: keys.surface("z1", 1)?.shifted(offset("offset1")?),
        surface_2: keys.surface("z2", 2)?.shifted(offset("offset2")?),
    };
    let flow = keys.number("flow", 0.0)?;
    let settings = RecordSettings {
        cells: keys.number("n", 512.0)? as usize,
        start: keys.number("start", 3.0)?,
        length: keys.number("length", 4.0)?,
        courant: keys.number("courant", 1.0)?,
        contact_film: Length::from_si(keys.number("hb", 5e-9)?),
        ceiling: (flow > 0.0).then_some(PlasticCeiling {
            pressure: Pressure::from_si(flow),
        }),
        friction: Some(FrictionLaw {
            viscosity: eta0,
            pressure_viscosity: alpha,
            eyring_stress: Pressure::from_si(keys.number("tauf", 5e6)?),
            limiting_stress: Pressure::from_si(2e6),
            limiting_slope: keys.number("limit", 0.05)?,
            boundary_friction: keys.number("mub", 0.1)?,
            boundary_layer: Length::from_si(10e-9),
        }),
        ..RecordSettings::default()
    };
    let start = Instant::now();
    let solved = transient::record(&rough, &settings)?;
    let seconds = start.elapsed().as_secs_f64();
    let (record, evidence) = (&solved.value, &solved.evidence);
    println!("smooth central film {:.4}", record.smooth_film);
    for below in &record.load_below {
        println!(
            "load on films up to {:8}: {:.5} +- {:.5}",
            below.film.to_string(),
            below.share.mean,
            below.share.standard_error
        );
    }
    println!(
        "load on contact nodes {:.5}, at the flow pressure {:.5}",
        record.contact_share.mean, record.plastic_share.mean
    );
    println!(
        "mean film {:.5} +- {:.5} um, spread {:.4}",
        1e6 * record.mean_film.mean,
        1e6 * record.mean_film.standard_error,
        record.film_spread
    );
    println!(
        "largest pressure: mean {:.4} GPa, ever {:.4}",
        1e-9 * record.mean_max_pressure.mean,
        record.max_pressure
    );
    if let Some(friction) = &record.friction {
        println!(
            "friction {:.5} +- {:.5}; film {:.5}, graded {:.5}, stepped {:.5}",
            friction.shifted.mean,
            friction.shifted.standard_error,
            friction.film.mean,
            friction.graded.mean,
            friction.stepped.mean
        );
    }
    let steps = evidence.steps as f64;
    println!(
        "{} steps, {} cut, {} loose; Newton {:.2} a step, GMRES {:.1} a Newton; {seconds:.2} s, {:.2} ms a step",
        evidence.steps,
        evidence.steps_cut,
        evidence.loose_steps,
        evidence.newton_iterations as f64 / steps,
        evidence.gmres_iterations as f64 / evidence.newton_iterations as f64,
        1e3 * seconds / steps
    );
    println!(
        "load error {:.1e}, complementarity {:.1e}; mass balance {:.5}, at most {:.4}; boundary supply {:.5}, at most {:.4}",
        evidence.load_error,
        evidence.complementarity,
        evidence.mean_mass_balance,
        evidence.mass_balance,
        evidence.mean_boundary_supply,
        evidence.boundary_supply
    );
    Ok(())
}
