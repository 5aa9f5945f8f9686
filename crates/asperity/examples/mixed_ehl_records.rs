//! Records of the mixed lubricated contact of 57 gear conditions: the table of `docs/EHL.md`.
//!
//! ```text
//! cargo run --release -p asperity --example mixed_ehl_records [name] [key=value ...]
//! ```
//!
//! Prints the conditions whose names begin with `name`, or all. Keys: `hb` (contact film in nm), `cells`,
//! `start` and `length` (travel in half-widths). Run it in the folder of the workspace.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::load_with;
use asperity::ehl::{RecordSettings, transient};
use asperity::lubrication::FormulaFilm;
use asperity::quantity::Length;
use asperity::reference_solution::{RefereeContact, RefereeSettings};
use asperity::roughness::generate::SelfAffine;
use asperity_core::Profile;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

const E_DRIVE: &str = "fixtures/cases/e-drive.toml";
const SUPERFINISHED: &str = "fixtures/cases/e-drive-superfinished.toml";
const FZG: &str = "fixtures/cases/fzg-c.toml";
/// Speed of the FZG pinion over the speed of the pitch line \[s/(min m)\].
const FZG_TURNS: f64 = 2166.0 / 8.3;
/// Spacing of the synthetic traces.
const SPACING: Length = Length::from_si(0.5e-6);

/// Surfaces of a condition.
#[derive(Clone, Copy)]
enum Flanks {
    OfCase,
    /// The flanks of the case with their heights multiplied.
    Scaled(f64),
    Fine,
    SelfAffine,
}

/// A contact to record.
pub struct Condition {
    /// Name in the table.
    pub name: String,
    /// Place on the path, 0 at A and 1 at E.
    pub position: f64,
    case: &'static str,
    flanks: Flanks,
    keys: Vec<(&'static str, String)>,
}

impl Condition {
    fn e_drive(class: &str, temperature: u32, position: f64) -> Self {
        Self {
            name: format!("e-{class}_{temperature}_{position}"),
            case: E_DRIVE,
            flanks: Flanks::OfCase,
            position,
            keys: vec![("operation.temperature", format!("{temperature} °C"))],
        }
    }

    fn at_speed(mut self, rpm: u32) -> Self {
        self.name = format!("{}_{rpm}", self.name);
        self.keys.push(("operation.speed", format!("{rpm} 1/min")));
        self
    }

    fn on(mut self, flanks: Flanks) -> Self {
        self.flanks = flanks;
        self
    }

    fn with(mut self, key: &'static str, value: &str) -> Self {
        self.keys.push((key, value.to_owned()));
        self
    }

    /// FZG gears at a speed of the pitch line \[m/s\].
    fn fzg(pitch_line: f64, position: f64) -> Self {
        Self {
            name: format!("fzg_{pitch_line}_{position}"),
            case: FZG,
            flanks: Flanks::OfCase,
            position,
            keys: vec![(
                "operation.speed",
                format!("{} 1/min", pitch_line * FZG_TURNS),
            )],
        }
    }

    /// Loads the case from the folder of the workspace.
    pub fn load(&self, workspace: &Path) -> Outcome<LoadedCase> {
        let mut loaded = load_with(&workspace.join(self.case), &|_| {})?;
        for (key, value) in &self.keys {
            loaded = loaded.with_key(key, value)?;
        }
        let files = match self.flanks {
            Flanks::OfCase => return Ok(loaded),
            Flanks::Fine => ["ground_fine_pinion", "ground_fine_wheel"]
                .map(|name| format!("../profiles/{name}.csv")),
            Flanks::Scaled(factor) => {
                let names = ["pinion", "wheel"].map(|flank| format!("scaled {flank}"));
                let traces =
                    ["ground_pinion", "ground_wheel"].map(|name| scaled(workspace, name, factor));
                let [pinion, wheel] = traces;
                let held = [
                    (PathBuf::from(&names[0]), pinion?),
                    (PathBuf::from(&names[1]), wheel?),
                ];
                loaded = loaded.holding(&held);
                names
            }
            Flanks::SelfAffine => {
                let names = ["pinion", "wheel"].map(|flank| format!("self-affine {flank}"));
                let held = [
                    (PathBuf::from(&names[0]), self_affine(1)?),
                    (PathBuf::from(&names[1]), self_affine(2)?),
                ];
                loaded = loaded.holding(&held);
                names
            }
        };
        let [pinion, wheel] = files;
        Ok(loaded
            .with_key("surface.pinion.file", &pinion)?
            .with_key("surface.wheel.file", &wheel)?)
    }
}

/// The ground trace `name` of the fixtures with its heights multiplied by `factor`.
fn scaled(workspace: &Path, name: &str, factor: f64) -> Outcome<Profile> {
    let file = workspace.join(format!("fixtures/profiles/{name}.csv"));
    let text = asperity_storage::whole_text(&file, 10_000_000)?;
    let heights: Result<Vec<f64>, _> = text
        .lines()
        .skip(1)
        .filter_map(|line| Some(line.split_once(',')?.1))
        .map(str::parse::<f64>)
        .collect();
    let heights = heights?.into_iter().map(|z| 1e-6 * factor * z).collect();
    Ok(Profile::new(SPACING, heights)?)
}

/// A fine self-affine trace.
fn self_affine(seed: u64) -> Outcome<Profile> {
    let recipe = SelfAffine {
        points: 6000,
        spacing: SPACING,
        rq: Length::from_si(0.1e-6),
        hurst: 0.8,
        roll_off: Length::from_si(100e-6),
        short_cut: Length::from_si(8e-6),
        seed,
    };
    Ok(recipe.generate()?)
}

/// The conditions of the table.
pub fn conditions() -> Vec<Condition> {
    let mut all = Vec::new();
    let places = |temperatures: &[u32], positions: &[f64]| {
        let mut pairs = Vec::new();
        for temperature in temperatures {
            pairs.extend(positions.iter().map(|position| (*temperature, *position)));
        }
        pairs
    };
    for (t, x) in places(&[60, 90, 120, 150], &[0.1, 0.5, 0.9]) {
        all.push(Condition::e_drive("ground", t, x));
    }
    for (t, x) in [
        (60, 0.1),
        (90, 0.1),
        (150, 0.1),
        (90, 0.9),
        (120, 0.9),
        (150, 0.9),
    ] {
        all.push(Condition::e_drive("half", t, x).on(Flanks::Scaled(0.5)));
    }
    for (t, x) in [(90, 0.1), (150, 0.1), (120, 0.5)] {
        all.push(Condition::e_drive("quarter", t, x).on(Flanks::Scaled(0.25)));
    }
    for (t, x) in [(90, 0.1), (150, 0.9)] {
        all.push(Condition::e_drive("fine", t, x).on(Flanks::Fine));
    }
    for cutoff in ["0.08", "0.8"] {
        for (t, x) in places(&[90, 150], &[0.1, 0.9]) {
            let condition = Condition::e_drive(&format!("cut{cutoff}"), t, x);
            all.push(condition.with("surface.cutoff", &format!("{cutoff} mm")));
        }
    }
    for (t, x) in places(&[90, 150], &[0.1]) {
        let condition = Condition::e_drive("elastic", t, x);
        all.push(condition.with("material.pinion.flow_pressure", "60 GPa"));
    }
    for rpm in [1000, 3000, 20000] {
        all.push(Condition::e_drive("speed", 90, 0.3).at_speed(rpm));
    }
    for (t, x, rpm) in [
        (90, 0.1, 3000),
        (90, 0.1, 9000),
        (150, 0.1, 9000),
        (120, 0.9, 9000),
        (150, 0.9, 3000),
    ] {
        all.push(
            Condition::e_drive("sa", t, x)
                .on(Flanks::SelfAffine)
                .at_speed(rpm),
        );
    }
    for (t, x, rpm) in [
        (90, 0.1, 1000),
        (90, 0.1, 9000),
        (120, 0.1, 3000),
        (150, 0.1, 9000),
        (90, 0.9, 9000),
    ] {
        let mut condition = Condition::e_drive("sf", t, x).at_speed(rpm);
        condition.case = SUPERFINISHED;
        all.push(condition);
    }
    for (speed, position) in [
        (0.5, 0.15),
        (0.5, 0.8),
        (1.25, 0.15),
        (2.5, 0.15),
        (2.5, 0.8),
        (5.0, 0.15),
        (8.3, 0.15),
        (8.3, 0.8),
        (20.0, 0.15),
    ] {
        all.push(Condition::fzg(speed, position));
    }
    for (speed, position, temperature) in [(2.5, 0.8, 120), (8.3, 0.15, 40)] {
        let mut condition = Condition::fzg(speed, position);
        condition.name = format!("fzg_{speed}_{temperature}C_{position}");
        all.push(condition.with("operation.temperature", &format!("{temperature} °C")));
    }
    all
}

/// A row of the table.
fn row(condition: &Condition, settings: &RecordSettings) -> Outcome<String> {
    let loaded = condition.load(Path::new("."))?;
    let settings = RefereeSettings {
        record: settings.clone(),
        eyring_stress: None,
        beginning: 0,
    };
    let contact = RefereeContact::of(&loaded, condition.position, &settings)?;
    let begin = Instant::now();
    let solved = transient::record(&contact.rough, &contact.record)?;
    let seconds = begin.elapsed().as_secs_f64();
    let (record, evidence) = (&solved.value, &solved.evidence);
    let friction = record.friction.ok_or("no law of friction")?;
    let inner = record.frames.iter().map(|frame| {
        let inner = &frame.film[1..frame.film.len() - 1];
        inner.iter().copied().fold(f64::INFINITY, f64::min)
    });
    let thinnest = record
        .scales
        .film_length(inner.fold(f64::INFINITY, f64::min));
    // The film of the formulas without its thermal reduction.
    let formula = FormulaFilm::of(&loaded.case, &contact.position)?;
    let film = formula.film.central / formula.thermal_reduction;
    Ok(format!(
        "| {} | {:.2} | {:.4} ± {:.4} | {:.4} | {:.4} ± {:.4} | {:.2}, {:.1} | {:.5} | {:.5} ± {:.5} | {:.5} | {:.5} | \
         {:.5}, {:.3} | {:.4}, {:.2} | {:.2} | {}, {}, {} | {seconds:.0} |",
        condition.name,
        contact.attenuated_roughness / film,
        record.solid_share.mean,
        record.solid_share.standard_error,
        record.load_below[3].share.mean,
        1e6 * record.mean_film.mean,
        1e6 * record.mean_film.standard_error,
        1e-9 * record.mean_max_pressure.mean,
        1e-9 * record.max_pressure.si(),
        friction.film.mean,
        friction.shifted.mean,
        friction.shifted.standard_error,
        friction.graded.mean,
        friction.stepped.mean,
        evidence.mean_mass_balance,
        evidence.mass_balance,
        evidence.mean_boundary_supply,
        evidence.boundary_supply,
        1e9 * thinnest.si(),
        evidence.steps,
        evidence.steps_cut,
        evidence.loose_steps,
    ))
}

/// Prints a row for each condition.
pub fn main() -> Outcome<()> {
    let (mut prefix, mut settings) = (
        String::new(),
        RecordSettings {
            length: 14.0,
            // Every step.
            frame_interval: Some(0.0),
            ..RecordSettings::default()
        },
    );
    for word in std::env::args().skip(1) {
        match word.split_once('=') {
            Some(("hb", value)) => {
                settings.contact_film = Length::from_si(1e-9 * value.parse::<f64>()?)
            }
            Some(("cells", value)) => settings.cells = value.parse()?,
            Some(("start", value)) => settings.start = value.parse()?,
            Some(("length", value)) => settings.length = value.parse()?,
            Some((key, _)) => return Err(format!("unknown key {key}").into()),
            None => prefix = word,
        }
    }
    println!(
        "| condition | σ_d/h_c | below 20 nm | below 50 nm | mean gap µm | p_max GPa: mean, largest | μ of the film | μ | graded | \
         stepped | mass balance: mean, worst | boundary supply: mean, largest | thinnest film nm | steps, cut, held | CPU s |"
    );
    for condition in conditions().iter().filter(|c| c.name.starts_with(&prefix)) {
        println!("{}", row(condition, &settings)?);
    }
    Ok(())
}
