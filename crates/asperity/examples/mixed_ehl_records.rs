//! Records of the mixed lubricated contact of 65 gear conditions: `fixtures/records/gear_meshes.csv`.
//!
//! ```text
//! cargo run --release -p asperity --example mixed_ehl_records > fixtures/records/gear_meshes.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- blind > fixtures/records/blind.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- second > fixtures/records/second_blind.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- part > fixtures/records/part_load.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- chosen > fixtures/records/part_load_chosen.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- unseen > fixtures/records/part_load_unseen.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- short > fixtures/records/short_waves.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- close > fixtures/records/close.csv
//! cargo run --release -p asperity --example mixed_ehl_records -- fzg_8.3 hb=2
//! ```
//!
//! Prints the conditions whose names begin with a word, or all, as many at a time as there are threads: of the gear meshes, of
//! the `blind` test or of the `second` one, at `part` load of scaled flanks or of other finishes (`chosen`, on which the model may
//! be chosen, and `unseen`), ten gear meshes with `short` waves, or conditions that are `close` to each other. A row is printed as soon as it is
//! solved; one that is not solved has no numbers.
//! `list` prints slide-to-roll ratio, Hertz pressure in GPa and roughness over the film without a record. Keys: `hb` (contact film
//! in nm), `cells`, `start` and `length` (travel in half-widths). Run it in the folder of the workspace.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::load_with;
use asperity::core::task::{par_map, threads};
use asperity::ehl::{RecordSettings, transient};
use asperity::lubrication::formula_film;
use asperity::quantity::Length;
use asperity::quantity::Pressure;
use asperity::reference_solution::{Inlet, ReferenceContact, ReferenceSettings, record_warnings};
use asperity::roughness::generate::{
    Ground, HeightDistribution, NonGaussian, PlateauHoned, SelfAffine, lower_envelope,
};
use asperity_core::Profile;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

const E_DRIVE: &str = "fixtures/cases/e-drive.toml";
const SUPERFINISHED: &str = "fixtures/cases/e-drive-superfinished.toml";
const FZG: &str = "fixtures/cases/fzg-c.toml";
/// Speed of the FZG pinion over the speed of the pitch line \[s/(min m)\].
const FZG_TURNS: f64 = 2166.0 / 8.3;
/// Eyring stress of the records: polyalphaolefin, mineral oil.
const EYRING_STRESS: [Pressure; 2] = [Pressure::from_si(4e6), Pressure::from_si(5e6)];
/// Boundary friction of the records.
pub const BOUNDARY_FRICTION: f64 = 0.08;
/// Travel of the records \[half-widths\].
const TRAVEL: f64 = 14.0;
/// Travel of the records of generated flanks at part load: their contact is so narrow that 14 half-widths are a few waves, and the
/// start from smooth flanks still shows in them.
const LIGHT_TRAVEL: f64 = 42.0;
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
    /// Generated flanks of a finish, from the seeds of pinion and wheel.
    Generated(Finish, [u64; 2]),
}

/// Finishes of the blind tests.
#[derive(Clone, Copy)]
enum Finish {
    /// The recipe of the ground flanks of the fixtures.
    Ground,
    /// Deeper grooves of coarser grits on a smoother background of longer waves.
    Coarse,
    /// Fine grits.
    Fine,
    /// The recipe of the superfinished flanks of the fixtures.
    Superfinished,
    /// Short waves only.
    Polished,
    /// Plateaus with valleys.
    Honed,
    /// Heights with a tail of valleys.
    Dales,
    /// Long waves.
    Long,
    /// Tall plateaus between deep, wide valleys.
    Plateaus,
    /// Crossed marks: the lower envelope of the grooves of two passes.
    Crossed,
    /// Heights with a tail of peaks.
    Peaked,
    /// Short, steep waves of peened flanks.
    Peened,
    /// Ground, with the peaks worn to a fine profile.
    RunIn,
    /// Low, short waves of lapped flanks.
    Lapped,
    /// Ground, with the heights halved.
    Half,
    /// Ground, with a quarter of the heights.
    Quarter,
}

impl Finish {
    /// A self-affine trace: Rq, Hurst exponent, roll-off, shortest wave, seed.
    fn affine(rq_um: f64, hurst: f64, [roll_off, short_cut]: [f64; 2], seed: u64) -> SelfAffine {
        SelfAffine {
            points: 6001,
            spacing: SPACING,
            rq: Length::from_si(1e-6 * rq_um),
            hurst,
            roll_off: Length::from_si(1e-6 * roll_off),
            short_cut: Length::from_si(1e-6 * short_cut),
            seed,
        }
    }

    /// Grooves of grits with their Rq and spacing, on a self-affine background.
    fn ground(rq_um: f64, grit_spacing_um: f64, background: SelfAffine) -> Outcome<Profile> {
        let grooves = Ground {
            points: background.points,
            spacing: SPACING,
            rq: Length::from_si(1e-6 * rq_um),
            grit_spacing: Length::from_si(1e-6 * grit_spacing_um),
            grit_radius: Length::from_si(60e-6),
            grit_protrusion: Length::from_si(0.5e-6),
            seed: background.seed - 500,
        };
        let (grooves, background) = (grooves.generate()?, background.generate()?);
        let heights = grooves.heights().iter().zip(background.heights());
        Ok(Profile::new(
            SPACING,
            heights.map(|(a, b)| a + b).collect(),
        )?)
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Ground => "ground",
            Self::Coarse => "coarse",
            Self::Fine => "fine",
            Self::Superfinished => "superfinished",
            Self::Polished => "polished",
            Self::Honed => "honed",
            Self::Dales => "dales",
            Self::Long => "long",
            Self::Plateaus => "plateaus",
            Self::Crossed => "crossed",
            Self::Peaked => "peaked",
            Self::Peened => "peened",
            Self::RunIn => "run-in",
            Self::Lapped => "lapped",
            Self::Half => "half",
            Self::Quarter => "quarter",
        }
    }

    fn trace(self, seed: u64) -> Outcome<Profile> {
        let affine = Self::affine;
        Ok(match self {
            Self::Ground => Self::ground(0.12, 9.0, affine(0.32, 0.7, [60.0, 5.0], seed + 500))?,
            Self::Coarse => Self::ground(0.3, 18.0, affine(0.2, 0.85, [100.0, 5.0], seed + 500))?,
            Self::Fine => Self::ground(0.1, 6.0, affine(0.15, 0.65, [40.0, 5.0], seed + 500))?,
            Self::Superfinished => affine(0.08, 0.8, [150.0, 4.0], seed).generate()?,
            Self::Polished => affine(0.05, 0.6, [40.0, 4.0], seed).generate()?,
            Self::Honed => {
                let recipe = PlateauHoned {
                    coarse: affine(0.5, 0.8, [80.0, 5.0], seed),
                    fine: affine(0.06, 0.7, [30.0, 5.0], seed + 500),
                    depth: Length::from_si(0.25e-6),
                };
                recipe.generate()?
            }
            Self::Dales => {
                let recipe = NonGaussian {
                    spectrum: affine(0.3, 0.8, [50.0, 5.0], seed),
                    heights: HeightDistribution::WeibullDales { shape: 1.5 },
                };
                recipe.generate()?.profile
            }
            Self::Long => affine(0.25, 0.9, [200.0, 5.0], seed).generate()?,
            Self::Plateaus => {
                let recipe = PlateauHoned {
                    coarse: affine(0.9, 0.8, [120.0, 5.0], seed),
                    fine: affine(0.05, 0.7, [25.0, 5.0], seed + 500),
                    depth: Length::from_si(0.1e-6),
                };
                recipe.generate()?
            }
            Self::Crossed => {
                let first = Self::ground(0.22, 11.0, affine(0.1, 0.7, [50.0, 5.0], seed + 500))?;
                let second = Self::ground(0.22, 16.0, affine(0.1, 0.7, [50.0, 5.0], seed + 800))?;
                lower_envelope(&first, &second)?
            }
            Self::Peaked => {
                let recipe = NonGaussian {
                    spectrum: affine(0.2, 0.8, [45.0, 5.0], seed),
                    heights: HeightDistribution::WeibullPeaks { shape: 2.0 },
                };
                recipe.generate()?.profile
            }
            Self::Peened => affine(0.3, 0.5, [25.0, 5.0], seed).generate()?,
            Self::RunIn => {
                let ground = Self::ground(0.15, 10.0, affine(0.3, 0.7, [70.0, 5.0], seed + 500))?;
                let fine = affine(0.05, 0.8, [40.0, 5.0], seed + 800).generate()?;
                let lowered = fine.heights().iter().map(|z| z + 0.15e-6).collect();
                lower_envelope(&ground, &Profile::new(SPACING, lowered)?)?
            }
            Self::Lapped => affine(0.06, 0.7, [18.0, 4.0], seed).generate()?,
            Self::Half => times(0.5, &Self::Ground.trace(seed)?)?,
            Self::Quarter => times(0.25, &Self::Ground.trace(seed)?)?,
        })
    }
}

/// A trace with its heights multiplied.
fn times(factor: f64, trace: &Profile) -> Outcome<Profile> {
    let heights = trace.heights().iter().map(|z| factor * z).collect();
    Ok(Profile::new(trace.spacing(), heights)?)
}

/// A contact to record.
pub struct Condition {
    /// Name in the table.
    pub name: String,
    /// Place on the path, 0 at A and 1 at E.
    pub position: f64,
    case: &'static str,
    flanks: Flanks,
    /// Factor on the heights of generated flanks.
    heights: f64,
    /// Factor on the Eyring stress of the records.
    eyring: f64,
    keys: Vec<(&'static str, String)>,
    /// Shortest wave in its traces, if another than that of the other records.
    pub shortest_wave: Option<Length>,
    /// Cells of its grid at least.
    least_cells: usize,
    /// Travel of its record \[half-widths\].
    pub travel: f64,
    /// Whether its window begins where the inlet is flooded, with cells as wide as in the window of the other records.
    is_flooded: bool,
}

impl Condition {
    fn e_drive(class: &str, temperature: u32, position: f64) -> Self {
        Self {
            name: format!("e-{class}_{temperature}_{position}"),
            case: E_DRIVE,
            flanks: Flanks::OfCase,
            position,
            heights: 1.0,
            eyring: 1.0,
            keys: vec![("operation.bulk_temperature", format!("{temperature} °C"))],
            shortest_wave: None,
            least_cells: 0,
            travel: TRAVEL,
            is_flooded: false,
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

    /// The e-drive's ground flanks at 90 °C and a fifth of the path, at any torque \[N m\] and speed \[1/min\].
    pub fn at_operation(torque: f64, speed: f64) -> Self {
        Self::e_drive("ground", 90, 0.2)
            .with("operation.torque", &format!("{torque} N m"))
            .with("operation.speed", &format!("{speed} 1/min"))
    }

    /// Generated flanks on the gears of a drive.
    fn generated((drive, finish, seeds, celsius, place, speed, torque): Generated) -> Self {
        let (name, case) = match drive {
            Drive::FirstStage => ("e", E_DRIVE),
            Drive::FewTeeth => ("few", E_DRIVE),
            Drive::FzgA => ("fzg-a", FZG),
        };
        let condition = Self {
            name: format!(
                "{name}-{}_{celsius}_{place}_{speed}_{torque}",
                finish.name()
            ),
            position: place,
            case,
            flanks: Flanks::Generated(finish, seeds),
            heights: 1.0,
            eyring: 1.0,
            keys: vec![
                ("operation.bulk_temperature", format!("{celsius} °C")),
                ("operation.speed", format!("{speed} 1/min")),
                ("operation.torque", format!("{torque} N m")),
            ],
            shortest_wave: None,
            least_cells: 0,
            travel: TRAVEL,
            is_flooded: false,
        };
        match drive {
            Drive::FirstStage => condition,
            Drive::FewTeeth => condition
                .with("gears.teeth", "[13, 80]")
                .with("gears.profile_shift", "[0, 0]"),
            Drive::FzgA => condition.with("gears.profile_shift", "[0.8635, -0.5]"),
        }
    }

    /// FZG gears at a speed of the pitch line \[m/s\].
    fn fzg(pitch_line: f64, position: f64) -> Self {
        Self {
            name: format!("fzg_{pitch_line}_{position}"),
            case: FZG,
            flanks: Flanks::OfCase,
            position,
            heights: 1.0,
            eyring: 1.0,
            keys: vec![(
                "operation.speed",
                format!("{} 1/min", pitch_line * FZG_TURNS),
            )],
            shortest_wave: None,
            least_cells: 0,
            travel: TRAVEL,
            is_flooded: false,
        }
    }

    /// Eyring stress of its record.
    pub fn eyring_stress(&self) -> Pressure {
        let of_oil = EYRING_STRESS[usize::from(self.case == FZG)];
        Pressure::from_si(self.eyring * of_oil.si())
    }

    /// The settings of its record, with heat.
    pub fn settings(&self, record: &RecordSettings) -> ReferenceSettings {
        ReferenceSettings {
            record: RecordSettings {
                cells: record.cells.max(self.least_cells),
                length: self.travel,
                ..record.clone()
            },
            eyring_stress: Some(self.eyring_stress()),
            with_heat: true,
            beginning: 0,
            shortest_wave: self.shortest_wave,
            inlet: match self.is_flooded {
                true => Inlet::Flooded,
                false => Inlet::Stated,
            },
        }
    }

    /// Its contact, as it is recorded.
    pub fn contact(
        &self,
        loaded: &LoadedCase,
        record: &RecordSettings,
    ) -> Outcome<ReferenceContact> {
        let settings = self.settings(record);
        Ok(ReferenceContact::new(
            &loaded.at_stated()?,
            self.position,
            &settings,
        )?)
    }

    /// Loads the case from the folder of the workspace.
    pub fn load(&self, workspace: &Path) -> Outcome<LoadedCase> {
        let mut loaded = load_with(&workspace.join(self.case), &|_| {})?;
        let boundary_friction = BOUNDARY_FRICTION.to_string();
        for (key, value) in [
            ("model.boundary_friction", &*boundary_friction),
            ("gears.pinion.tip_relief", "none"),
            ("gears.wheel.tip_relief", "none"),
        ] {
            loaded = loaded.with_key(key, value)?;
        }
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
            Flanks::Generated(finish, seeds) => {
                let names = ["pinion", "wheel"].map(|flank| format!("generated {flank}"));
                let [pinion, wheel] = seeds.map(|seed| times(self.heights, &finish.trace(seed)?));
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
    for (speed, position, temperature) in [
        (2.5, 0.8, 120),
        (8.3, 0.15, 40),
        (8.3, 0.8, 60),
        (8.3, 0.15, 120),
        (8.3, 0.8, 150),
    ] {
        let mut condition = Condition::fzg(speed, position);
        condition.name = format!("fzg_{speed}_{temperature}C_{position}");
        all.push(condition.with("operation.bulk_temperature", &format!("{temperature} °C")));
    }
    for cutoff in ["0.08", "0.8"] {
        let mut condition = Condition::fzg(8.3, 0.15);
        condition.name = format!("fzg_cut{cutoff}_8.3_0.15");
        all.push(condition.with("surface.cutoff", &format!("{cutoff} mm")));
    }
    for (t, x) in [(120, 0.5), (90, 0.9)] {
        let condition = Condition::e_drive("elastic", t, x);
        all.push(condition.with("material.pinion.flow_pressure", "60 GPa"));
    }
    let mut elastic = Condition::fzg(8.3, 0.15);
    elastic.name = "fzg_elastic_8.3_0.15".to_owned();
    all.push(elastic.with("material.pinion.flow_pressure", "60 GPa"));
    all
}

/// The conditions of the blind test, on traces that no record had before. Name, finish, seeds, then the case with its place,
/// temperature [°C] and speed: of the e-drive [1/min], of the pitch line of FZG gears [m/s].
pub fn blind_conditions() -> Vec<Condition> {
    use Finish::{Coarse, Dales, Fine, Ground, Honed, Long, Polished, Superfinished};
    let e_drive = [
        (Ground, [71, 72], 70, 0.2, 9000),
        (Ground, [71, 72], 110, 0.4, 9000),
        (Ground, [73, 74], 130, 0.7, 9000),
        (Ground, [73, 74], 110, 0.3, 1200),
        (Coarse, [81, 82], 80, 0.2, 9000),
        (Coarse, [81, 82], 130, 0.8, 9000),
        (Coarse, [83, 84], 100, 0.4, 4000),
        (Coarse, [83, 84], 140, 0.2, 2500),
        (Fine, [91, 92], 100, 0.2, 9000),
        (Fine, [91, 92], 140, 0.6, 9000),
        (Fine, [93, 94], 80, 0.8, 2000),
        (Superfinished, [101, 102], 110, 0.2, 2000),
        (Superfinished, [101, 102], 70, 0.6, 9000),
        (Polished, [111, 112], 130, 0.4, 5000),
        (Honed, [121, 122], 80, 0.2, 9000),
        (Honed, [121, 122], 130, 0.8, 9000),
        (Dales, [131, 132], 100, 0.4, 9000),
        (Dales, [131, 132], 140, 0.2, 9000),
        (Long, [141, 142], 80, 0.4, 9000),
        (Long, [141, 142], 120, 0.7, 6000),
    ];
    let fzg = [
        (Ground, [75, 76], 90, 0.3, 1.0),
        (Ground, [75, 76], 90, 0.6, 12.0),
        (Coarse, [85, 86], 90, 0.3, 4.0),
        (Fine, [95, 96], 90, 0.6, 1.5),
        (Superfinished, [103, 104], 90, 0.3, 1.0),
        (Honed, [123, 124], 90, 0.6, 2.0),
        (Dales, [133, 134], 70, 0.3, 6.0),
        (Long, [143, 144], 110, 0.3, 1.5),
    ];
    let e_drive = e_drive.map(|(finish, seeds, celsius, place, speed)| {
        let condition = Condition::e_drive(finish.name(), celsius, place);
        let condition = condition.on(Flanks::Generated(finish, seeds));
        condition.at_speed(speed)
    });
    let fzg = fzg.map(|(finish, seeds, celsius, place, speed)| {
        let mut condition = Condition::fzg(speed, place).on(Flanks::Generated(finish, seeds));
        condition.name = format!("fzg-{}_{celsius}_{place}_{speed}", finish.name());
        condition.with("operation.bulk_temperature", &format!("{celsius} °C"))
    });
    e_drive.into_iter().chain(fzg).collect()
}

/// Gears of the second blind test and of the other finishes at part load.
#[derive(Clone, Copy, PartialEq)]
enum Drive {
    /// First stage of the e-drive.
    FirstStage,
    /// The e-drive's gears with 13 and 80 teeth: near A the contact moves slowly over the pinion.
    FewTeeth,
    /// FZG gears type A.
    FzgA,
}

/// A condition on generated flanks: drive, finish, seeds of pinion and wheel, temperature \[°C\], place, speed \[1/min\],
/// torque \[N m\].
type Generated = (Drive, Finish, [u64; 2], u32, f64, u32, f64);

/// The conditions of the second blind test. Finishes, seeds, places, temperatures and speeds that no record of the first two tables has; the last eight
/// are at part load.
pub fn second_blind_conditions() -> Vec<Condition> {
    use Drive::{FewTeeth, FirstStage, FzgA};
    use Finish::{Coarse, Crossed, Ground, Lapped, Peaked, Peened, Plateaus, RunIn};
    let rows = [
        (FirstStage, Crossed, [201, 202], 75, 0.15, 8000, 145.0),
        (FirstStage, Crossed, [201, 202], 115, 0.85, 6000, 145.0),
        (FirstStage, Crossed, [203, 204], 95, 0.45, 8000, 145.0),
        (FirstStage, Plateaus, [211, 212], 75, 0.72, 7000, 145.0),
        (FirstStage, Plateaus, [211, 212], 115, 0.25, 8000, 145.0),
        (FirstStage, Plateaus, [213, 214], 95, 0.12, 5000, 145.0),
        (FirstStage, Peaked, [221, 222], 95, 0.28, 8000, 145.0),
        (FirstStage, Peaked, [221, 222], 115, 0.65, 8000, 145.0),
        (FirstStage, Peened, [231, 232], 95, 0.35, 10000, 145.0),
        (FirstStage, Peened, [233, 234], 75, 0.78, 1500, 145.0),
        (FirstStage, RunIn, [241, 242], 115, 0.18, 5000, 145.0),
        (FirstStage, Lapped, [251, 252], 95, 0.74, 3500, 145.0),
        (FzgA, Crossed, [205, 206], 75, 0.9, 1000, 183.4),
        (FzgA, Plateaus, [215, 216], 95, 0.12, 1200, 183.4),
        (FzgA, RunIn, [243, 244], 115, 0.7, 2500, 183.4),
        (FewTeeth, Ground, [271, 272], 95, 0.007, 8000, 15.0),
        (FirstStage, Ground, [273, 274], 95, 0.25, 8000, 20.0),
        (FirstStage, Plateaus, [217, 218], 75, 0.85, 4500, 20.0),
        (FirstStage, Crossed, [207, 208], 115, 0.62, 6000, 50.0),
        (FirstStage, Peened, [235, 236], 95, 0.15, 8000, 50.0),
        (FirstStage, Lapped, [253, 254], 115, 0.32, 2200, 20.0),
        (FirstStage, RunIn, [245, 246], 75, 0.38, 1500, 50.0),
        (FzgA, Peaked, [223, 224], 95, 0.82, 1500, 50.0),
        (FewTeeth, Coarse, [285, 286], 75, 0.06, 6000, 20.0),
    ];
    rows.map(Condition::generated).into_iter().collect()
}

/// The conditions of the second blind test in windows with a flooded inlet.
pub fn flooded_second_blind_conditions() -> Vec<Condition> {
    flooded(second_blind_conditions(), TRAVEL)
}

/// With flooded inlets, and records of the `travel`.
fn flooded(conditions: Vec<Condition>, travel: f64) -> Vec<Condition> {
    let flood = |condition| Condition {
        is_flooded: true,
        travel,
        ..condition
    };
    conditions.into_iter().map(flood).collect()
}

/// Conditions at part load: the e-drive's flanks with their heights multiplied, by temperature \[°C\], place, speed \[1/min\] and
/// torque \[N m\].
pub fn part_load_conditions() -> Vec<Condition> {
    let places = [
        (90, 0.9, 2500, 40),
        (100, 0.75, 2000, 50),
        (90, 0.1, 9000, 145),
        (90, 0.9, 9000, 40),
        (90, 0.9, 9000, 20),
    ];
    let each = |(celsius, place, speed, torque): (u32, f64, u32, u32)| {
        [0.005, 0.05, 0.1, 0.2, 0.4].map(|factor| {
            let condition = Condition::e_drive("scaled", celsius, place).at_speed(speed);
            let mut condition = condition.on(Flanks::Scaled(factor));
            condition.name = format!("{}_{torque}_{factor}", condition.name);
            condition.is_flooded = true;
            condition.with("operation.torque", &format!("{torque} N m"))
        })
    };
    places.into_iter().flat_map(each).collect()
}

/// Conditions at part load on which the model may be chosen: sixteen finishes, each twice, on seeds that no other record has. Torque,
/// speed, temperature and place were drawn over 10 to 60 N m, 500 to 12 000 1/min, 40 to 130 °C and .08 to .92 of the path, away
/// from the pitch point; where σ_d/h_c was above 3, beyond which no record is a reference, a higher speed replaced the one drawn.
pub fn chosen_conditions() -> Vec<Condition> {
    use Drive::{FirstStage, FzgA};
    use Finish::{
        Coarse, Crossed, Dales, Fine, Ground, Half, Honed, Lapped, Long, Peaked, Peened, Plateaus,
        Polished, Quarter, RunIn, Superfinished,
    };
    let rows = [
        (FzgA, Ground, [1001, 1002], 70, 0.67, 4800, 33.0),
        (FirstStage, Half, [1011, 1012], 90, 0.80, 3600, 16.0),
        (FirstStage, Quarter, [1021, 1022], 50, 0.47, 1200, 35.0),
        (FzgA, Coarse, [1031, 1032], 90, 0.37, 1000, 21.0),
        (FirstStage, Fine, [1041, 1042], 50, 0.72, 4400, 20.0),
        (FirstStage, Honed, [1051, 1052], 50, 0.43, 10100, 25.0),
        (FzgA, Dales, [1061, 1062], 110, 0.66, 950, 11.0),
        (FirstStage, Long, [1071, 1072], 70, 0.68, 4700, 18.0),
        (FirstStage, Polished, [1081, 1082], 65, 0.16, 3300, 12.0),
        (FzgA, Superfinished, [1091, 1092], 80, 0.63, 5400, 17.0),
        (FirstStage, Plateaus, [1101, 1102], 85, 0.91, 2000, 52.0),
        (FirstStage, Crossed, [1111, 1112], 95, 0.29, 2500, 58.0),
        (FzgA, Peaked, [1121, 1122], 125, 0.16, 2100, 47.0),
        (FirstStage, Peened, [1131, 1132], 105, 0.74, 9200, 51.0),
        (FirstStage, RunIn, [1141, 1142], 75, 0.85, 6000, 24.0),
        (FzgA, Lapped, [1151, 1152], 120, 0.35, 650, 23.0),
        (FzgA, Ground, [1005, 1006], 60, 0.77, 1200, 19.0),
        (FirstStage, Half, [1015, 1016], 125, 0.08, 1400, 12.0),
        (FzgA, Quarter, [1025, 1026], 115, 0.70, 500, 31.0),
        (FirstStage, Coarse, [1035, 1036], 80, 0.33, 8000, 15.0),
        (FirstStage, Fine, [1045, 1046], 40, 0.39, 750, 13.0),
        (FzgA, Honed, [1055, 1056], 100, 0.41, 1500, 44.0),
        (FzgA, Dales, [1065, 1066], 90, 0.82, 2400, 55.0),
        (FzgA, Long, [1075, 1076], 55, 0.52, 1800, 40.0),
        (FirstStage, Polished, [1085, 1086], 115, 0.29, 11700, 41.0),
        (
            FirstStage,
            Superfinished,
            [1095, 1096],
            45,
            0.23,
            1800,
            28.0,
        ),
        (FirstStage, Plateaus, [1105, 1106], 110, 0.71, 5400, 11.0),
        (FzgA, Crossed, [1115, 1116], 65, 0.87, 550, 38.0),
        (FzgA, Peaked, [1125, 1126], 100, 0.28, 4700, 29.0),
        (FirstStage, Peened, [1135, 1136], 60, 0.20, 7200, 14.0),
        (FirstStage, RunIn, [1145, 1146], 130, 0.12, 3000, 14.0),
        (FirstStage, Lapped, [1155, 1156], 105, 0.40, 1400, 27.0),
    ];
    let conditions = rows.map(Condition::generated).into_iter();
    flooded(conditions.collect(), LIGHT_TRAVEL)
}

/// Conditions at part load that are not looked at before the model is fixed, drawn as the chosen ones.
pub fn unseen_conditions() -> Vec<Condition> {
    use Drive::{FirstStage, FzgA};
    use Finish::{
        Coarse, Crossed, Dales, Fine, Ground, Half, Honed, Lapped, Long, Peaked, Peened, Plateaus,
        Polished, Quarter, RunIn, Superfinished,
    };
    let rows = [
        (FirstStage, Ground, [2001, 2002], 55, 0.71, 3600, 13.0),
        (FirstStage, Half, [2011, 2012], 90, 0.90, 1500, 10.0),
        (FzgA, Quarter, [2021, 2022], 110, 0.65, 5400, 11.0),
        (FirstStage, Coarse, [2031, 2032], 105, 0.17, 4200, 30.0),
        (FirstStage, Fine, [2041, 2042], 100, 0.20, 9800, 43.0),
        (FzgA, Honed, [2051, 2052], 100, 0.89, 5000, 38.0),
        (FirstStage, Dales, [2061, 2062], 95, 0.66, 2200, 13.0),
        (FirstStage, Long, [2071, 2072], 70, 0.46, 3800, 36.0),
        (FzgA, Polished, [2081, 2082], 70, 0.45, 2600, 28.0),
        (FirstStage, Superfinished, [2091, 2092], 55, 0.41, 700, 46.0),
        (FirstStage, Plateaus, [2101, 2102], 120, 0.69, 5900, 16.0),
        (FzgA, Crossed, [2111, 2112], 130, 0.33, 5700, 39.0),
        (FirstStage, Peaked, [2121, 2122], 85, 0.12, 1200, 31.0),
        (FirstStage, Peened, [2131, 2132], 105, 0.76, 3100, 33.0),
        (FzgA, RunIn, [2141, 2142], 85, 0.79, 2300, 23.0),
        (FirstStage, Lapped, [2151, 2152], 90, 0.66, 800, 17.0),
        (FirstStage, Ground, [2005, 2006], 125, 0.81, 4300, 52.0),
        (FzgA, Half, [2015, 2016], 75, 0.12, 1800, 23.0),
        (FzgA, Quarter, [2025, 2026], 125, 0.61, 850, 15.0),
        (FirstStage, Coarse, [2035, 2036], 45, 0.29, 11600, 12.0),
        (FzgA, Fine, [2045, 2046], 80, 0.39, 2100, 54.0),
        (FirstStage, Honed, [2055, 2056], 110, 0.69, 1900, 26.0),
        (FirstStage, Dales, [2065, 2066], 65, 0.35, 1100, 25.0),
        (FzgA, Long, [2075, 2076], 120, 0.35, 2700, 22.0),
        (FzgA, Polished, [2085, 2086], 60, 0.53, 4700, 19.0),
        (FzgA, Superfinished, [2095, 2096], 50, 0.49, 4900, 15.0),
        (FirstStage, Plateaus, [2105, 2106], 75, 0.14, 2200, 18.0),
        (FirstStage, Crossed, [2115, 2116], 65, 0.85, 1600, 41.0),
        (FirstStage, Peaked, [2125, 2126], 115, 0.24, 1600, 50.0),
        (FzgA, Peened, [2135, 2136], 40, 0.25, 5200, 59.0),
        (FzgA, RunIn, [2145, 2146], 45, 0.83, 4500, 20.0),
        (FirstStage, Lapped, [2155, 2156], 55, 0.61, 5500, 12.0),
    ];
    let conditions = rows.map(Condition::generated).into_iter();
    flooded(conditions.collect(), LIGHT_TRAVEL)
}

/// Conditions of the gear meshes that are solved again with shorter waves.
const SHORT_WAVES: [&str; 10] = [
    "e-fine_150_0.9",
    "e-fine_90_0.1",
    "e-ground_150_0.1",
    "e-ground_60_0.1",
    "e-ground_90_0.1",
    "e-ground_90_0.5",
    "e-ground_90_0.9",
    "e-half_150_0.9",
    "fzg_2.5_0.8",
    "fzg_8.3_0.15",
];

/// The conditions with waves of 8 µm at least on a finer grid, and with shorter waves, of 4 and of 2.5 µm at least.
pub fn short_wave_conditions() -> Vec<Condition> {
    let of = |(micrometres, least_cells): (f64, usize)| {
        let mut all = conditions();
        all.retain(|condition| SHORT_WAVES.contains(&&*condition.name));
        for condition in &mut all {
            condition.name = format!("{}_{micrometres}um", condition.name);
            condition.shortest_wave = Some(Length::from_si(1e-6 * micrometres));
            condition.least_cells = least_cells;
        }
        all
    };
    let finer = [(8.0, 1024), (4.0, 0), (2.5, 0)];
    finer.into_iter().flat_map(of).collect()
}

/// Travel of the records of close conditions \[half-widths\].
const CLOSE_TRAVEL: f64 = 28.0;

/// A change of a condition.
#[derive(Clone, Copy)]
enum Change {
    None,
    /// Factor on the speed.
    Speed(f64),
    /// Degrees more.
    Warmer(u32),
    /// Factor on the torque.
    Torque(f64),
    /// Factor on the heights of both traces.
    Heights(f64),
    /// Factor on the Eyring stress.
    Eyring(f64),
    /// Pressure-viscosity coefficient \[1/GPa\].
    PressureViscosity(f64),
    /// Further along the path.
    Place(f64),
}

/// Conditions that are close to each other: pairs of flanks on seeds of their own, six at full load and two at part load with flooded
/// inlets, each with changes of speed, temperature, torque, heights, oil and place.
pub fn close_conditions() -> Vec<Condition> {
    use Change::{Eyring, Heights, Place, PressureViscosity, Speed, Torque, Warmer};
    use Drive::{FirstStage, FzgA};
    use Finish::{Crossed, Ground, Plateaus, RunIn, Superfinished};
    let changes = [
        Change::None,
        Speed(1.01),
        Speed(1.1),
        Speed(1.4),
        Warmer(1),
        Warmer(15),
        Torque(0.997),
        Torque(0.97),
        Torque(0.85),
        Heights(0.97),
        Heights(0.9),
        Heights(0.7),
        Heights(1.2),
        Eyring(1.3),
        PressureViscosity(14.0),
        PressureViscosity(16.0),
        Place(0.05),
        Place(0.3),
    ];
    let bases = [
        (FirstStage, Ground, [3001, 3002], 90, 0.2, 9000, 145.0),
        (FirstStage, Crossed, [3011, 3012], 110, 0.6, 6000, 145.0),
        (FirstStage, RunIn, [3021, 3022], 75, 0.06, 5000, 120.0),
        (FirstStage, Ground, [3031, 3032], 125, 0.12, 7000, 145.0),
        (
            FirstStage,
            Superfinished,
            [3041, 3042],
            115,
            0.6,
            4000,
            145.0,
        ),
        (FzgA, Plateaus, [3061, 3062], 90, 0.55, 2166, 183.4),
    ];
    let light = [
        (FirstStage, Ground, [3071, 3072], 70, 0.65, 5000, 25.0),
        (FzgA, Plateaus, [3081, 3082], 80, 0.3, 2000, 35.0),
    ];
    let close = |base: Generated| {
        changes.map(|change| {
            let condition = Condition::generated(changed(base, change));
            let (finish, seeds) = (base.1.name(), base.2);
            let condition = Condition {
                name: format!("close-{finish}-{}_{}", seeds[0], change.name()),
                travel: CLOSE_TRAVEL,
                ..condition
            };
            match change {
                Heights(factor) => Condition {
                    heights: factor,
                    ..condition
                },
                Eyring(factor) => Condition {
                    eyring: factor,
                    ..condition
                },
                PressureViscosity(value) => {
                    condition.with("lubricant.pressure_viscosity", &format!("{value} 1/GPa"))
                }
                _ => condition,
            }
        })
    };
    let light = flooded(light.into_iter().flat_map(close).collect(), LIGHT_TRAVEL);
    bases.into_iter().flat_map(close).chain(light).collect()
}

impl Change {
    fn name(self) -> String {
        match self {
            Self::None => "base".to_owned(),
            Self::Speed(factor) => format!("speed_{factor}"),
            Self::Warmer(kelvin) => format!("warmer_{kelvin}"),
            Self::Torque(factor) => format!("torque_{factor}"),
            Self::Heights(factor) => format!("heights_{factor}"),
            Self::Eyring(factor) => format!("eyring_{factor}"),
            Self::PressureViscosity(value) => format!("alpha_{value}"),
            Self::Place(step) => format!("place_{step}"),
        }
    }
}

/// A condition with a change of its operation or place.
fn changed(base: Generated, change: Change) -> Generated {
    let (drive, finish, seeds, celsius, place, speed, torque) = base;
    match change {
        Change::Speed(factor) => {
            let speed = (factor * f64::from(speed)).round() as u32;
            (drive, finish, seeds, celsius, place, speed, torque)
        }
        Change::Warmer(kelvin) => (drive, finish, seeds, celsius + kelvin, place, speed, torque),
        Change::Torque(factor) => (drive, finish, seeds, celsius, place, speed, factor * torque),
        Change::Place(step) => (drive, finish, seeds, celsius, place + step, speed, torque),
        _ => base,
    }
}

/// Settings of the records of a table, whose travel their conditions state: every step is a frame.
pub fn record_settings() -> RecordSettings {
    RecordSettings {
        frame_interval: Some(0.0),
        ..RecordSettings::default()
    }
}

/// Head of the tables.
pub const COLUMNS: [&str; 33] = [
    "condition",
    "place",
    "roughness_over_film",
    "below_20_nm",
    "below_20_nm_error",
    "below_50_nm",
    "gap_um",
    "gap_error_um",
    "mean_largest_pressure_gpa",
    "largest_pressure_gpa",
    "film_friction",
    "friction",
    "friction_error",
    "graded",
    "graded_error",
    "stepped",
    "hot_film_friction",
    "hot_friction",
    "hot_friction_error",
    "hot_graded",
    "hot_graded_error",
    "film_rise_k",
    "surface_rise_k",
    "mean_balance",
    "worst_balance",
    "mean_supply",
    "largest_supply",
    "thinnest_nm",
    "steps",
    "cut",
    "held",
    "warnings",
    "seconds",
];

/// A row of the table.
fn row(condition: &Condition, settings: &RecordSettings) -> Outcome<String> {
    let loaded = condition.load(Path::new("."))?;
    let contact = condition.contact(&loaded, settings)?;
    let begin = Instant::now();
    let solved = transient::record(&contact.rough, &contact.record)?;
    let seconds = begin.elapsed().as_secs_f64();
    let (record, evidence) = (&solved.value, &solved.evidence);
    let friction = record.friction.ok_or("no law of friction")?;
    let heated = record.heated.ok_or("no heat")?;
    let inner = record.frames.iter().map(|frame| {
        let inner = &frame.film[1..frame.film.len() - 1];
        inner.iter().copied().fold(f64::INFINITY, f64::min)
    });
    let thinnest = record
        .scales
        .film_length(inner.fold(f64::INFINITY, f64::min));
    let roughness = contact.attenuated_roughness;
    let warnings = record_warnings(record, roughness, contact.record.ceiling);
    let codes: Vec<&str> = warnings.iter().map(|(code, _)| code.as_str()).collect();
    let numbers = [
        roughness_over_film(&loaded, &contact)?,
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
        friction.graded.standard_error,
        friction.stepped.mean,
        heated.friction.film.mean,
        heated.friction.shifted.mean,
        heated.friction.shifted.standard_error,
        heated.friction.graded.mean,
        heated.friction.graded.standard_error,
        heated.film_rise.mean,
        heated.surface_rise.mean,
        evidence.mean_mass_balance,
        evidence.mass_balance,
        evidence.mean_boundary_supply,
        evidence.boundary_supply,
        1e9 * thinnest.si(),
    ];
    let numbers = numbers.map(|number| format!("{number:.5}"));
    Ok(format!(
        "{},{},{},{},{},{},{},{seconds:.0}",
        condition.name,
        condition.position,
        numbers.join(","),
        evidence.steps,
        evidence.steps_cut,
        evidence.loose_steps,
        codes.join(" "),
    ))
}

/// A row without numbers, of a condition that was not solved.
fn unsolved_row(condition: &Condition) -> String {
    let empty = ",".repeat(COLUMNS.len() - 2);
    format!("{},{}{empty}", condition.name, condition.position)
}

/// Attenuated roughness over the isothermal central film of the formula.
fn roughness_over_film(loaded: &LoadedCase, contact: &ReferenceContact) -> Outcome<f64> {
    let formula = formula_film(&loaded.at_stated()?, &contact.position)?;
    let film = formula.film.central / formula.thermal_reduction;
    Ok(contact.attenuated_roughness / film)
}

/// Prints a row for each condition.
pub fn main() -> Outcome<()> {
    let (mut prefix, mut settings) = (String::new(), record_settings());
    let (mut table, mut is_list): (fn() -> Vec<Condition>, bool) = (conditions, false);
    let mut travel = None;
    for word in std::env::args().skip(1) {
        match word.split_once('=') {
            Some(("hb", value)) => {
                settings.contact_film = Length::from_si(1e-9 * value.parse::<f64>()?)
            }
            Some(("cells", value)) => settings.cells = value.parse()?,
            Some(("start", value)) => settings.start = value.parse()?,
            Some(("length", value)) => travel = Some(value.parse()?),
            Some((key, _)) => return Err(format!("unknown key {key}").into()),
            None if word == "blind" => table = blind_conditions,
            None if word == "second" => table = second_blind_conditions,
            None if word == "flooded" => table = flooded_second_blind_conditions,
            None if word == "part" => table = part_load_conditions,
            None if word == "chosen" => table = chosen_conditions,
            None if word == "unseen" => table = unseen_conditions,
            None if word == "short" => table = short_wave_conditions,
            None if word == "close" => table = close_conditions,
            None if word == "list" => is_list = true,
            None => prefix = word,
        }
    }
    let mut conditions = table();
    for condition in &mut conditions {
        condition.travel = travel.unwrap_or(condition.travel);
    }
    let chosen: Vec<&Condition> = conditions
        .iter()
        .filter(|condition| condition.name.starts_with(&prefix))
        .collect();
    if is_list {
        for condition in chosen {
            let loaded = condition.load(Path::new("."))?;
            let contact = condition.contact(&loaded, &settings)?;
            let ratio = roughness_over_film(&loaded, &contact)?;
            let (slide, pressure) = (
                contact.position.motion.slide_to_roll.abs(),
                1e-9 * contact.position.hertz.max_pressure.si(),
            );
            println!("{},{slide:.2},{pressure:.2},{ratio:.5}", condition.name);
        }
        return Ok(());
    }
    println!("{}", COLUMNS.join(","));
    for at_a_time in chosen.chunks(threads()) {
        let rows = par_map(at_a_time, |condition| {
            row(condition, &settings).unwrap_or_else(|error| {
                eprintln!("{}: {error}", condition.name);
                unsolved_row(condition)
            })
        });
        for row in rows {
            println!("{row}");
        }
        std::io::stdout().flush()?;
    }
    Ok(())
}
