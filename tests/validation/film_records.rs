//! Friction of film and spots over 64 windows: against an independent program, and against our own records by parts and by interval.
//!
//! Thermal reduction none, ridges across the face, constants of the records, with heat. The means over the windows of every
//! record are stored in `fixtures/records/film_64_windows.csv`; `ASPERITY_WRITE=1 cargo test -p asperity-tests --test validation --
//! --ignored the_windows_of_every_record` makes them anew in some minutes. Tests hold the sum of their inputs and twelve of their rows.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::core::task::par_map;
use asperity::fingerprint::sha256;
use asperity::mixed_film::{InletSupply, LoadShareSettings, LoadShareSolution, SpotSpeed};
use asperity::reference_solution::LARGEST_ROUGHNESS;
use asperity::uncertainty::model_deviation;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::{FilmLaw, GapLaw};

use crate::ehl_records::mixed_ehl_records::{
    Condition, blind_conditions, chosen_conditions, close_conditions, conditions,
    flooded_second_blind_conditions, part_load_conditions, second_blind_conditions,
    short_wave_conditions, unseen_conditions,
};
use crate::ehl_records::{Record, Windows, mean_and_rms, records};

/// Windows that the parts are averaged over.
const WINDOWS: usize = 64;
/// Windows on the travel of a reference solution, a half-width.
const PASSED_WINDOWS: f64 = 4.0;
/// Half-widths of travel between windows that know nothing of each other, about.
const TRAVEL_OF_A_WINDOW: f64 = 14.0 / 12.0;
/// Conditions with the means of another program over the same windows: friction, asperity share, the boundary layer's part of the
/// friction, gap in µm. Its film has other nodes, and its asperity contacts formed inside the contact are sheared at the film of half
/// the sliding speed.
const OF_ANOTHER_PROGRAM: [(&str, [f64; 4]); 12] = [
    ("e-ground_90_0.1", [0.03028, 0.2879, 0.01656, 0.4955]),
    ("e-ground_120_0.5", [0.02005, 0.2917, 0.01204, 0.4992]),
    ("e-ground_60_0.9", [0.02317, 0.1238, 0.00712, 0.6746]),
    ("e-half_120_0.9", [0.01909, 0.1162, 0.006693, 0.2781]),
    ("e-quarter_120_0.5", [0.008917, 0.03606, 0.001228, 0.1547]),
    ("e-sf_150_0.1_9000", [0.02049, 0.05439, 0.002995, 0.07404]),
    ("e-sa_150_0.9_3000", [0.01735, 0.145, 0.008171, 0.09379]),
    ("fzg_8.3_0.15", [0.03958, 0.2043, 0.01202, 0.526]),
    ("fzg_0.5_0.8", [0.0424, 0.3829, 0.02528, 0.4246]),
    ("e-coarse_100_0.4_4000", [0.0278, 0.3464, 0.01836, 0.4567]),
    ("e-honed_130_0.8_9000", [0.01769, 0.1009, 0.00568, 0.2707]),
    ("fzg-fine_90_0.6_1.5", [0.03877, 0.1245, 0.007632, 0.2282]),
];

/// A formulation of the model, of which `make` makes the settings.
struct Model {
    name: &'static str,
    make: fn(LoadShareSettings) -> LoadShareSettings,
    /// Whether the records at part load and with shorter waves are computed with it as well.
    for_all: bool,
}

const DEFAULT: &str = "default";
/// The default over the windows that the record passes.
const PASSED: &str = "passed";
const FILM_ONLY: &str = "film only";
/// Rows of the stored table by laws that the records refuted: commit 1078c1ac made them.
const REFUTED: [&str; 3] = ["film only own", "film only hertz", "formula"];
const MODELS: [Model; 6] = [
    Model {
        name: DEFAULT,
        make: |of| of,
        for_all: true,
    },
    Model {
        name: FILM_ONLY,
        make: film_only,
        for_all: true,
    },
    Model {
        name: "inner 0.6",
        make: |of| LoadShareSettings {
            inner_boundary: 0.6,
            ..of
        },
        for_all: false,
    },
    Model {
        name: "inner 0.9",
        make: |of| LoadShareSettings {
            inner_boundary: 0.9,
            ..of
        },
        for_all: false,
    },
    Model {
        name: "inlet spots",
        make: |of| LoadShareSettings {
            spot_speed: SpotSpeed::Entrainment,
            ..of
        },
        for_all: false,
    },
    Model {
        name: "half-sliding spots",
        make: |of| LoadShareSettings {
            spot_speed: SpotSpeed::HalfSliding,
            ..of
        },
        for_all: false,
    },
];

/// The film in every spot, without a boundary layer: friction that no rule of the boundary layer takes part in.
fn film_only(settings: LoadShareSettings) -> LoadShareSettings {
    LoadShareSettings {
        spot_speed: SpotSpeed::Entrainment,
        boundary_layer: Length::from_si(0.0),
        ..settings
    }
}

/// Means over the windows of a condition.
#[derive(Debug, Clone, Copy)]
struct Windowed {
    friction: f64,
    /// Standard deviation of the friction over the windows.
    deviation: f64,
    asperity_share: f64,
    boundary: f64,
    /// s of the whole pair over the mass-flow film.
    roughness_over_film: f64,
    smooth_film_um: f64,
    gap_um: f64,
    hertz_pressure_gpa: f64,
}

/// Columns of the stored table after condition and model.
const COLUMNS: [&str; 8] = [
    "friction",
    "deviation",
    "asperity_share",
    "boundary",
    "roughness_over_film",
    "smooth_film_um",
    "gap_um",
    "hertz_pressure_gpa",
];

impl Windowed {
    fn new(windows: &Windows, settings: &LoadShareSettings) -> Self {
        let solved = windows.solutions(settings, false);
        let n = solved.len() as f64;
        let mean = |of: fn(&LoadShareSolution) -> f64| solved.iter().map(of).sum::<f64>() / n;
        let friction = mean(|solved| solved.coefficient);
        let squares = solved.iter().map(|of| (of.coefficient - friction).powi(2));
        Self {
            friction,
            deviation: (squares.sum::<f64>() / (n - 1.0)).sqrt(),
            asperity_share: mean(|solved| solved.asperity_share),
            boundary: mean(|solved| solved.parts.boundary),
            roughness_over_film: mean(|solved| solved.roughness_over_film),
            smooth_film_um: mean(|solved| solved.smooth_film.si() * 1e6),
            gap_um: mean(|solved| solved.mean_gap.si() * 1e6),
            hertz_pressure_gpa: windows.max_pressure().si() * 1e-9,
        }
    }

    const fn numbers(&self) -> [f64; COLUMNS.len()] {
        [
            self.friction,
            self.deviation,
            self.asperity_share,
            self.boundary,
            self.roughness_over_film,
            self.smooth_film_um,
            self.gap_um,
            self.hertz_pressure_gpa,
        ]
    }

    fn read(numbers: &[&str]) -> Self {
        let numbers: Vec<f64> = numbers.iter().map(|text| text.parse().unwrap()).collect();
        let number = |name: &str| {
            let place = COLUMNS.iter().position(|column| *column == name);
            numbers[place.unwrap()]
        };
        Self {
            friction: number("friction"),
            deviation: number("deviation"),
            asperity_share: number("asperity_share"),
            boundary: number("boundary"),
            roughness_over_film: number("roughness_over_film"),
            smooth_film_um: number("smooth_film_um"),
            gap_um: number("gap_um"),
            hertz_pressure_gpa: number("hertz_pressure_gpa"),
        }
    }
}

/// A table of records: its name, and its conditions.
type Table = (&'static str, fn() -> Vec<Condition>);
pub const GEAR_MESHES: &str = "gear_meshes";
pub const BLIND: &str = "blind";
pub const SECOND_BLIND: &str = "second_blind";
const PART_LOAD: &str = "part_load";
const SHORT_WAVES: &str = "short_waves";
/// Other finishes at part load: those that the error of the model is fitted on, and those that were not looked at before.
const CHOSEN: &str = "part_load_chosen";
const UNSEEN: &str = "part_load_unseen";
/// The second blind test's eight at part load, with a flooded inlet.
const SECOND_PART: &str = "part_load_second";
/// Conditions that are close to each other.
pub const CLOSE: &str = "close";
const TABLES: [Table; 9] = [
    (GEAR_MESHES, conditions),
    (BLIND, blind_conditions),
    (SECOND_BLIND, second_blind_conditions),
    (PART_LOAD, part_load_conditions),
    (SHORT_WAVES, short_wave_conditions),
    (CHOSEN, chosen_conditions),
    (UNSEEN, unseen_conditions),
    (SECOND_PART, second_part_load_conditions),
    (CLOSE, close_conditions),
];
/// Conditions of the second blind test at full load, before those at part load.
const FULL_LOAD: usize = 16;

fn second_part_load_conditions() -> Vec<Condition> {
    flooded_second_blind_conditions().split_off(FULL_LOAD)
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn stored_file() -> PathBuf {
    workspace().join("fixtures/records/film_64_windows.csv")
}

/// SHA-256 of what the conditions of the records are made of: cases, traces, and the recipes of the example. A change of the fast
/// model shows in the twelve rows that are computed again.
fn sum_of_inputs() -> String {
    const INPUTS: [&str; 10] = [
        "crates/asperity/examples/mixed_ehl_records.rs",
        "fixtures/cases/e-drive.toml",
        "fixtures/cases/e-drive-superfinished.toml",
        "fixtures/cases/fzg-c.toml",
        "fixtures/profiles/ground_pinion.csv",
        "fixtures/profiles/ground_wheel.csv",
        "fixtures/profiles/ground_fine_pinion.csv",
        "fixtures/profiles/ground_fine_wheel.csv",
        "fixtures/profiles/superfinished.csv",
        "fixtures/profiles/superfinished_wheel.csv",
    ];
    let sum = |name: &str| {
        let text = std::fs::read_to_string(workspace().join(name)).unwrap();
        // A checkout may end lines otherwise.
        sha256(text.replace("\r\n", "\n").as_bytes())
    };
    sha256(INPUTS.map(sum).join("\n").as_bytes())
}

/// Means over the windows by condition and model.
type Stored = BTreeMap<String, BTreeMap<String, Windowed>>;

/// The stored means, with the sum of their inputs.
fn stored() -> &'static (String, Stored) {
    static STORED: OnceLock<(String, Stored)> = OnceLock::new();
    STORED.get_or_init(|| {
        let text = std::fs::read_to_string(stored_file()).unwrap();
        let mut lines = text.lines();
        let sum = lines.next().unwrap().strip_prefix("# inputs ").unwrap();
        let head: Vec<&str> = lines.next().unwrap().split(',').collect();
        assert_eq!(head[2..], COLUMNS);
        let mut found = Stored::new();
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let by_model = found.entry(cells[0].to_owned()).or_default();
            by_model.insert(cells[1].to_owned(), Windowed::read(&cells[2..]));
        }
        (sum.to_owned(), found)
    })
}

/// A record beside the model.
pub struct Row {
    pub name: String,
    /// Travel of the record \[half-widths\].
    travel: f64,
    record: Record,
    by: &'static BTreeMap<String, Windowed>,
}

impl Row {
    fn by(&self, model: &str) -> &Windowed {
        &self.by[model]
    }

    fn fast(&self) -> &Windowed {
        self.by(DEFAULT)
    }

    /// Film, roughness, pressure and friction of the model.
    pub fn conditions(&self) -> [f64; 4] {
        let fast = self.fast();
        let roughness = fast.roughness_over_film * fast.smooth_film_um;
        let [film, pressure] = [fast.smooth_film_um, fast.hertz_pressure_gpa];
        [film, roughness, pressure, fast.friction]
    }

    /// ln of the model's friction over the record's.
    fn error_by(&self, model: &str) -> f64 {
        (self.by(model).friction / self.record.friction).ln()
    }

    fn error(&self) -> f64 {
        self.error_by(DEFAULT)
    }

    /// ln of the model's friction over the record's, both by the film alone.
    fn film_error(&self, model: &str) -> f64 {
        (self.by(model).friction / self.record.film_friction).ln()
    }

    /// ln of the model's friction over the record's, in the windows that the record passes.
    pub fn passed_error(&self) -> f64 {
        self.error_by(PASSED)
    }

    pub fn is_within_reference(&self) -> bool {
        self.fast().roughness_over_film < LARGEST_ROUGHNESS
    }

    /// Friction that the boundary layer adds to the film's: of the record, of the model.
    fn boundary(&self) -> [f64; 2] {
        [
            self.record.friction - self.record.film_friction,
            self.fast().friction - self.by(FILM_ONLY).friction,
        ]
    }

    /// Standard deviation of the error as a run draws it, or with the sampling of record and windows.
    pub fn deviation(&self, with_sampling: bool) -> f64 {
        let fast = self.fast();
        let [_, model] = model_deviation(
            GapLaw::Inlet,
            fast.roughness_over_film,
            fast.asperity_share,
            Some(Pressure::from_si(1e9 * fast.hertz_pressure_gpa)),
        );
        if !with_sampling {
            return model;
        }
        let windows = (TRAVEL_OF_A_WINDOW / self.travel + 1.0 / WINDOWS as f64).sqrt();
        let of_windows = fast.deviation / fast.friction * windows;
        let of_record = self.record.friction_error / self.record.friction;
        model.hypot(of_windows).hypot(of_record)
    }

    fn is_covered(&self, with_sampling: bool) -> bool {
        self.error().abs() < NINETY_PERCENT * self.deviation(with_sampling)
    }

    /// Whether the error in the windows that the record passes is within the interval without any error of sampling.
    fn is_covered_where_passed(&self) -> bool {
        self.passed_error().abs() < NINETY_PERCENT * self.deviation(false)
    }
}

/// Standard deviations on each side that hold 90 %.
const NINETY_PERCENT: f64 = 1.645;

/// The records of a table in the order of its conditions.
pub fn rows(table: &str) -> Vec<Row> {
    let (_, conditions) = TABLES.iter().find(|(name, _)| *name == table).unwrap();
    let mut records = records(table);
    let solved = conditions().into_iter().filter_map(|condition| {
        let record = records.remove(&condition.name)?;
        Some(Row {
            by: &stored().1[&condition.name],
            name: condition.name,
            travel: condition.travel,
            record,
        })
    });
    let solved = solved.collect();
    assert!(records.is_empty());
    solved
}

/// The records that the model was chosen on: gear meshes, and the first blind test.
fn chosen_on() -> Vec<Row> {
    let mut all = rows(GEAR_MESHES);
    all.extend(rows(BLIND));
    all
}

fn is_compared(row: &&Row) -> bool {
    row.is_within_reference()
}

fn mean_and_deviation(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let values: Vec<f64> = values.collect();
    let [mean, rms] = mean_and_rms(values.iter().copied());
    let n = values.len() as f64;
    [mean, ((rms * rms - mean * mean) * n / (n - 1.0)).sqrt()]
}

/// ln μ: mean, standard deviation and root mean square.
fn of_friction<'a>(rows: impl Iterator<Item = &'a Row> + Clone, model: &str) -> [f64; 3] {
    let [mean, rms] = mean_and_rms(rows.clone().map(|row| row.error_by(model)));
    let [_, deviation] = mean_and_deviation(rows.map(|row| row.error_by(model)));
    [mean, deviation, rms]
}

fn correlation(pairs: &[[f64; 2]]) -> f64 {
    let of = |k: usize| mean_and_deviation(pairs.iter().map(|pair| pair[k]));
    let [[x, x_sd], [y, y_sd]] = [of(0), of(1)];
    let products = pairs.iter().map(|pair| (pair[0] - x) * (pair[1] - y));
    products.sum::<f64>() / (pairs.len() as f64 - 1.0) / (x_sd * y_sd)
}

/// Sum over the records below a ratio of 3 that the boundary layer adds more than `LEAST_BOUNDARY` to, model over record, with
/// their number and the standard deviation of the ratio of one.
fn boundary_sum() -> (usize, f64, f64) {
    let rows = chosen_on();
    let adds = |row: &&Row| row.boundary()[0] / row.record.friction > LEAST_BOUNDARY;
    let parts: Vec<[f64; 2]> = rows
        .iter()
        .filter(is_compared)
        .filter(adds)
        .map(Row::boundary)
        .collect();
    let sum = |k: usize| parts.iter().map(|part| part[k]).sum::<f64>();
    let [_, scatter] = mean_and_deviation(parts.iter().map(|part| part[1] / part[0]));
    (parts.len(), sum(1) / sum(0), scatter)
}

/// Part of the friction above which the boundary layer's part of a record is compared.
const LEAST_BOUNDARY: f64 = 0.15;

/// Formulations of the model against the 93 records.
pub fn model_table() -> String {
    let all = chosen_on();
    let blind = rows(BLIND);
    let mut text = String::from(
        "| model | s < 3: mean, standard deviation, root mean square | first blind test, s < 3: mean, root mean square | s > 3: mean | correlation with φ |\n|---|---|---|---|---|\n",
    );
    for (model, name) in [
        (
            "formula",
            "film at Hertz's pressure, σ_d of all heights, spots fed at the entrainment speed",
        ),
        (DEFAULT, "**default**"),
        ("inner 0.6", "default, β_i 0.6"),
        ("inner 0.9", "default, β_i 0.9"),
        (
            "inlet spots",
            "default, asperity contacts with the film of the inlet",
        ),
        (
            "half-sliding spots",
            "default, asperity contacts with the film of half the sliding speed",
        ),
    ] {
        let compared = all.iter().filter(is_compared);
        let [mean, deviation, rms] = of_friction(compared.clone(), model);
        let [blind_mean, _, blind_rms] = of_friction(blind.iter().filter(is_compared), model);
        let above = all.iter().filter(|row| !row.is_within_reference());
        let [high, ..] = of_friction(above, model);
        let pairs = compared.map(|row| [row.by(model).asperity_share, row.error_by(model)]);
        let pairs: Vec<[f64; 2]> = pairs.collect();
        let correlation = correlation(&pairs);
        let _ = writeln!(
            text,
            "| {name} | {mean:+.3}, {deviation:.3}, {rms:.3} | {blind_mean:+.3}, {blind_rms:.3} | {high:+.3} | {correlation:.2} |"
        );
    }
    text
}

/// Ends of the classes of the central film \[µm\].
const FILMS: [f64; 7] = [0.0, 0.05, 0.1, 0.15, 0.2, 0.3, f64::INFINITY];

/// The film and the boundary layer apart.
pub fn part_table() -> String {
    let all = chosen_on();
    let mut text = String::from("| part | solutions | model and reference |\n|---|---|---|\n");
    for (model, name) in [
        ("film only hertz", "film at Hertz's pressure"),
        ("film only own", "film at its own pressure"),
        (FILM_ONLY, "film at its own, rippled pressure"),
    ] {
        let compared = all.iter().filter(is_compared);
        let [mean, rms] = mean_and_rms(compared.clone().map(|row| row.film_error(model)));
        let count = compared.count();
        let _ = writeln!(
            text,
            "| {name}, s < 3 | {count} | ln μ: mean {mean:+.3}, root mean square {rms:.3} |"
        );
    }
    let (count, sum, scatter) = boundary_sum();
    let _ = writeln!(
        text,
        "| boundary layer where it adds more than 15 %, s < 3 | {count} | ratio of the sums {sum:.2}, scatter of one solution {scatter:.2} |"
    );
    let mut all = all;
    all.extend(rows(SECOND_BLIND));
    all.extend(rows(PART_LOAD));
    for ends in FILMS.windows(2) {
        let is_in = |row: &&Row| (ends[0]..ends[1]).contains(&row.fast().smooth_film_um);
        let parts: Vec<[f64; 2]> = all.iter().filter(is_in).map(Row::boundary).collect();
        let sum = |k: usize| parts.iter().map(|part| part[k]).sum::<f64>();
        let name = if ends[1].is_finite() {
            format!("{} to {} µm", ends[0], ends[1])
        } else {
            format!("above {} µm", ends[0])
        };
        let (count, ratio) = (parts.len(), sum(1) / sum(0));
        let _ = writeln!(
            text,
            "| boundary layer, central film {name}, all solutions | {count} | ratio of the sums {ratio:.2} |"
        );
    }
    text
}

/// Ends of the classes of s.
const CLASSES: [f64; 7] = [0.0, 0.6, 1.2, 1.8, 2.3, 3.0, 6.0];

/// Fast model minus the 93 records by classes of s, mean ± standard deviation.
pub fn class_table() -> String {
    let all = chosen_on();
    let mut text = String::from(
        "| s | solutions | φ | ln gap | ln μ | ln μ, film alone |\n|---|---|---|---|---|---|\n",
    );
    for ends in CLASSES.windows(2) {
        let is_in = |row: &&Row| (ends[0]..ends[1]).contains(&row.fast().roughness_over_film);
        let in_class = || all.iter().filter(is_in);
        let share = |row: &Row| Some(row.fast().asperity_share - row.record.share()?);
        let columns = [
            mean_and_deviation(in_class().filter_map(share)),
            mean_and_deviation(in_class().map(|row| row.record.gap_error(row.fast().gap_um))),
            mean_and_deviation(in_class().map(Row::error)),
            mean_and_deviation(in_class().map(|row| row.film_error(FILM_ONLY))),
        ];
        let cells = columns.map(|[mean, deviation]| format!("{mean:+.3} ± {deviation:.3}"));
        let _ = writeln!(
            text,
            "| {} to {} | {} | {} |",
            ends[0],
            ends[1],
            in_class().count(),
            cells.join(" | ")
        );
    }
    text
}

/// Records within the interval of 90 %.
pub fn coverage_table() -> String {
    let second = rows(SECOND_BLIND);
    let (full, part) = second.split_at(FULL_LOAD.min(second.len()));
    let mut text = String::from(
        "| solutions | ln μ: mean, root mean square | within 90 % with the errors of sampling | by the error of the model only | ln μ in the windows of the solution: mean, root mean square | within 90 % by the error of the model only |\n|---|---|---|---|---|---|\n",
    );
    for (name, rows) in [
        ("65 gear meshes", &*rows(GEAR_MESHES)),
        ("28 of the first blind test", &*rows(BLIND)),
        ("both", &*chosen_on()),
        ("second blind test", &*second),
        ("its full load", full),
        ("its part load", part),
        ("its part load, flooded inlet", &*rows(SECOND_PART)),
        ("scaled flanks, part load", &*rows(PART_LOAD)),
        ("other finishes at part load, chosen half", &*rows(CHOSEN)),
        ("other finishes at part load, unseen half", &*rows(UNSEEN)),
    ] {
        let [mean, rms] = mean_and_rms(rows.iter().map(Row::error));
        let [with, without] = [true, false].map(|with| covered(rows, with));
        let [passed_mean, passed_rms] = mean_and_rms(rows.iter().map(Row::passed_error));
        let passed = covered_where_passed(rows);
        let count = rows.len();
        let _ = writeln!(
            text,
            "| {name} | {mean:+.3}, {rms:.3} | {with} of {count} | {without} | {passed_mean:+.3}, {passed_rms:.3} | {passed} |"
        );
    }
    text
}

fn covered(rows: &[Row], with_sampling: bool) -> usize {
    rows.iter()
        .filter(|row| row.is_covered(with_sampling))
        .count()
}

fn covered_where_passed(rows: &[Row]) -> usize {
    rows.iter()
        .filter(|row| row.is_covered_where_passed())
        .count()
}

/// Every record of the first blind test.
pub fn blind_table() -> String {
    listed(&rows(BLIND))
}

/// Every record at part load on other finishes: of the chosen half, of the unseen half, and of the second blind test.
pub fn other_part_load_tables() -> [(&'static str, String); 3] {
    [
        ("ehl-part-load-chosen", CHOSEN),
        ("ehl-part-load-unseen", UNSEEN),
        ("ehl-part-load-second", SECOND_PART),
    ]
    .map(|(mark, table)| (mark, listed(&rows(table))))
}

/// Every record of the second blind test.
pub fn second_blind_table() -> String {
    listed(&rows(SECOND_BLIND))
}

/// A row for every record with its interval, then mean and root mean square.
fn listed(rows: &[Row]) -> String {
    let mut text = String::from(
        "| condition | s | φ: reference, model | gap µm: reference × 0.975, model | μ: reference, model, ln | film alone, ln | 90 % of ln | within |\n|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let (record, fast) = (&row.record, row.fast());
        let [low, high] = record.below;
        let undefined = match record.share() {
            Some(_) => "",
            None => " (undefined)",
        };
        let gap = fast.gap_um / record.gap_error(fast.gap_um).exp();
        let _ = writeln!(
            text,
            "| {} | {:.2} | {:.3}, {:.3}{undefined} | {gap:.3}, {:.3} | {:.5}, {:.5}, {:+.3} | {:+.3} | ±{:.3} | {} |",
            row.name,
            fast.roughness_over_film,
            0.5 * (low + high),
            fast.asperity_share,
            fast.gap_um,
            record.friction,
            fast.friction,
            row.error(),
            row.film_error(FILM_ONLY),
            NINETY_PERCENT * row.deviation(true),
            if row.is_covered(true) {
                "yes"
            } else {
                "**no**"
            },
        );
    }
    text
}

/// Ten records with waves of 8 µm at least on 1024 cells, and with shorter waves, over those on 512 cells.
pub fn short_wave_table() -> String {
    let (long, short) = (rows(GEAR_MESHES), rows(SHORT_WAVES));
    let mut text = String::from(
        "| condition | shortest wave µm | μ of the reference | load below 20 nm | gap | μ of the model |\n|---|---|---|---|---|---|\n",
    );
    for row in &short {
        let (name, wave) = row.name.rsplit_once('_').unwrap();
        let base = long.iter().find(|row| row.name == name).unwrap();
        let [friction, load, gap, fast] = risen(row, base);
        let wave = match wave.trim_end_matches("um") {
            "8" => "8, 1024 cells",
            wave => wave,
        };
        let _ = writeln!(
            text,
            "| {name} | {wave} | {friction:+.1} % | {load:+.0} % | {gap:+.1} % | {fast:+.1} % |"
        );
    }
    text
}

/// Rises in per cent of friction, load below 20 nm and gap of the record, and of the model's friction.
fn risen(row: &Row, base: &Row) -> [f64; 4] {
    let of = |row: &Row| {
        let record = &row.record;
        [
            record.friction,
            record.below[0],
            record.gap_um,
            row.fast().friction,
        ]
    };
    let (new, old) = (of(row), of(base));
    [0, 1, 2, 3].map(|k: usize| 100.0 * (new[k] / old[k] - 1.0))
}

/// Records of scaled flanks at part load.
pub fn part_load_table() -> String {
    let mut text = String::from(
        "| condition | s | φ: reference, model | film alone, own pressure, ln | rippled, ln | μ: reference, model, ln |\n|---|---|---|---|---|---|\n",
    );
    for row in rows(PART_LOAD) {
        let (record, fast) = (&row.record, row.fast());
        let [low, high] = record.below;
        let _ = writeln!(
            text,
            "| {} | {:.2} | {:.3}, {:.3} | {:+.3} | {:+.3} | {:.5}, {:.5}, {:+.3} |",
            row.name,
            fast.roughness_over_film,
            0.5 * (low + high),
            fast.asperity_share,
            row.film_error("film only own"),
            row.film_error(FILM_ONLY),
            record.friction,
            fast.friction,
            row.error(),
        );
    }
    text
}

#[test]
fn the_fast_model_follows_the_93_records() {
    println!("{}\n{}\n{}", model_table(), part_table(), class_table());
    let all = chosen_on();
    assert_eq!(all.len(), 93);
    // The row that the model was chosen with, by another program, had .05: in it errors of film and boundary layer cancelled, which
    // waves with the pressures and films of solved ones no longer do. Both parts are checked below.
    let near = |found: f64, expected: f64| (found - expected).abs() < 0.012;
    let [mean, deviation, rms] = of_friction(all.iter().filter(is_compared), DEFAULT);
    assert!(
        mean.abs() < 0.012 && near(deviation, 0.05) && near(rms, 0.05),
        "{mean} {rms}"
    );
    let blind = rows(BLIND);
    let [mean, _, rms] = of_friction(blind.iter().filter(is_compared), DEFAULT);
    // The program that the model was chosen with had .009 by Dowson and Toyoda's film.
    assert!(
        (mean - 0.009).abs() < 0.014 && near(rms, 0.07),
        "{mean} {rms}"
    );
    let above = all.iter().filter(|row| !row.is_within_reference());
    let [mean, ..] = of_friction(above, DEFAULT);
    // Beyond the reference, where ridges of the records cannot leak: .056 by that program.
    assert!((mean - 0.106).abs() < 0.015, "{mean}");
    // Parts: the film alone, and what the boundary layer adds.
    let film = |rows: &mut dyn Iterator<Item = &Row>| {
        mean_and_rms(rows.map(|row| row.film_error(FILM_ONLY)))
    };
    let [mean, rms] = film(&mut all.iter().filter(is_compared));
    assert!(mean.abs() < 0.02 && rms < 0.07, "{mean} {rms}");
    let (count, sum, _) = boundary_sum();
    assert!(count > 40 && (0.85..1.1).contains(&sum), "{count} {sum}");
    // Smooth flanks at part load.
    let part = rows(PART_LOAD);
    let smooth = || part.iter().filter(|row| row.name.ends_with("_0.005"));
    assert_eq!(smooth().count(), 5);
    for row in smooth() {
        let error = row.film_error(FILM_ONLY);
        assert!(error.abs() < 0.06, "{}: {error}", row.name);
    }
    // At full load.
    let [mean, rms] = film(&mut part[10..15].iter());
    assert!(mean.abs() < 0.02 && rms < 0.06, "{mean} {rms}");
}

#[test]
fn the_interval_holds_the_records_that_it_was_judged_on() {
    println!("{}", coverage_table());
    let all = covered(&chosen_on(), true);
    assert!(all >= 80, "{all} of 93");
}

#[test]
fn the_interval_holds_the_unseen_half_at_part_load() {
    let [chosen, unseen] = [CHOSEN, UNSEEN].map(rows);
    for (conditions, rows) in [
        (chosen_conditions(), &chosen),
        (unseen_conditions(), &unseen),
    ] {
        assert_eq!((conditions.len(), rows.len()), (32, 32));
    }
    // 85 to 95 % of 32 was asked for: in the windows that the record passes, where sampling is no error. With the errors of sampling
    // one more lies within.
    let within = [covered_where_passed(&unseen), covered(&unseen, true)];
    assert!(
        (28..=30).contains(&within[0]) && (28..=31).contains(&within[1]),
        "{within:?}"
    );
    for rows in [&chosen, &unseen] {
        let [mean, rms] = mean_and_rms(rows.iter().map(Row::error));
        assert!(mean.abs() < 0.15 && rms < 0.32, "{mean} {rms}");
        let [mean, rms] = mean_and_rms(rows.iter().map(Row::passed_error));
        assert!(mean.abs() < 0.03 && rms < 0.12, "{mean} {rms}");
    }
    // Scaled flanks: 64 windows of the traces have .2.
    let [_, rms] = mean_and_rms(rows(PART_LOAD).iter().map(Row::passed_error));
    assert!(rms < 0.05, "{rms}");
}

/// Largest second differences of ln μ over even steps of ln torque from 5 to 300 N m at 9000 1/min and of ln speed from 5 to
/// 30 000 1/min at 30 N m, in windows whose middles stay where they are.
fn largest_bends(windows: usize, steps: [u32; 2]) -> [f64; 2] {
    let spread = |[low, high]: [f64; 2], steps: u32| {
        (0..=steps).map(move |k| low * (high / low).powf(f64::from(k) / f64::from(steps)))
    };
    let torques = spread([5.0, 300.0], steps[0]).map(|torque| [torque, 9000.0]);
    let speeds = spread([5.0, 30_000.0], steps[1]).map(|speed| [30.0, speed]);
    let middles = Windows::new(&Condition::at_operation(300.0, 9000.0), windows).middles();
    let bend = |operations: Vec<[f64; 2]>| {
        let friction = |[torque, speed]: [f64; 2]| {
            let windows = Windows::about(&Condition::at_operation(torque, speed), &middles);
            Windowed::new(&windows, &windows.settings()).friction.ln()
        };
        let logs = par_map(operations, friction);
        let bends = logs
            .windows(3)
            .map(|of| (of[0] - 2.0 * of[1] + of[2]).abs());
        bends.fold(0.0, f64::max)
    };
    let found = [torques.collect(), speeds.collect()].map(bend);
    println!("{windows} windows, over torque and speed: {found:.5?}");
    found
}

#[test]
fn friction_has_no_kink_over_torque_and_speed() {
    // Few windows leave the kinks of their own spots.
    let found = largest_bends(4, [20, 30]);
    assert!(found[0] < 0.36 && found[1] < 0.07, "{found:?}");
}

#[test]
#[ignore = "some five minutes"]
fn friction_has_no_kink_over_torque_and_speed_in_fine_steps() {
    // In steps of 7 % single windows touch within a step at the lowest torques: .0071.
    let found = largest_bends(256, [120, 120]);
    assert!(found.iter().all(|bend| *bend < 0.006), "{found:?}");
    // A jump would stay where steps are finer; by whole cells one of .0049 did.
    let found = largest_bends(256, [480, 480]);
    assert!(found.iter().all(|bend| *bend < 0.003), "{found:?}");
}

#[test]
fn the_second_blind_test_has_the_outcome_that_is_printed() {
    println!("{}", second_blind_table());
    let rows = rows(SECOND_BLIND);
    assert_eq!(second_blind_conditions().len(), 24);
    // 18 when it was blind, one fewer than it asks for. Another number means that a record or the model has changed since.
    assert_eq!((rows.len(), covered(&rows, true)), (24, 21));
}

#[test]
fn shorter_waves_move_the_records_as_the_pages_say() {
    println!("{}", short_wave_table());
    let (long, short) = (rows(GEAR_MESHES), rows(SHORT_WAVES));
    for row in short.iter().filter(|row| row.name.ends_with("_2.5um")) {
        let name = row.name.trim_end_matches("_2.5um");
        let base = long.iter().find(|row| row.name == name).unwrap();
        let [friction, load, ..] = risen(row, base);
        let most = match name {
            "e-ground_90_0.5" => [15.0, 30.0],
            _ => [4.5, 12.0],
        };
        assert!(
            friction.abs() < most[0] && load.abs() < most[1],
            "{name}: {friction} {load}"
        );
    }
}

#[test]
fn parts_of_friction_are_those_of_an_independent_program() {
    let mut all = conditions();
    all.extend(blind_conditions());
    all.retain(|one| OF_ANOTHER_PROGRAM.iter().any(|(name, _)| *name == one.name));
    assert_eq!(all.len(), OF_ANOTHER_PROGRAM.len());
    par_map(all, |condition| {
        let windows = Windows::new(&condition, WINDOWS);
        let seen = Windowed::new(&windows, &windows.settings());
        let by_formula = LoadShareSettings {
            film_law: FilmLaw::DowsonToyoda,
            supply: InletSupply::Grubin,
            ..windows.settings()
        };
        let by_formula = Windowed::new(&windows, &by_formula);
        let found = [
            by_formula.friction,
            by_formula.asperity_share,
            by_formula.boundary,
            by_formula.gap_um,
        ];
        let row = OF_ANOTHER_PROGRAM
            .iter()
            .find(|(name, _)| *name == condition.name);
        let (name, expected) = row.unwrap();
        // Its film has Hertz's pressures, the thickness of the mass flow, and waves with pressures by 1 - A and heights by A: friction
        // differs by -5 to 2 % on ground flanks, by 9 and 12 % on long waves. Share, boundary layer and gap are the same.
        for ((found, expected), most) in found.iter().zip(expected).zip([0.12, 0.03, 0.03, 0.03]) {
            assert!(
                (found / expected - 1.0).abs() < most,
                "{name}: {found} {expected}"
            );
        }
        // Transforms differ in their last digits by processor, and the stored numbers have six.
        let stored = &stored().1[*name][DEFAULT];
        for ((column, seen), stored) in COLUMNS.iter().zip(seen.numbers()).zip(stored.numbers()) {
            assert!(
                (seen - stored).abs() < 1e-3 * stored.abs() + 2e-6,
                "{name}, {column}: {seen}, stored {stored}; see the top of this file"
            );
        }
    });
}

#[test]
fn the_stored_windows_have_the_inputs_of_today() {
    let (sum, stored) = stored();
    assert_eq!(*sum, sum_of_inputs(), "see the top of this file");
    for (table, conditions) in TABLES {
        for condition in conditions() {
            assert!(
                stored.contains_key(&condition.name),
                "{table}: {}",
                condition.name
            );
        }
    }
}

fn stored_row(condition: &Condition, model: &str, windowed: &Windowed) -> String {
    let numbers = windowed.numbers().map(|number| format!("{number:.6}"));
    format!("{},{model},{}\n", condition.name, numbers.join(","))
}

#[test]
#[ignore = "some minutes; makes the stored windows anew"]
fn the_windows_of_every_record() {
    let mut all = Vec::new();
    // The eight of the second blind test are among its own.
    for (table, conditions) in TABLES.into_iter().filter(|(name, _)| *name != SECOND_PART) {
        let is_chosen_on = table == GEAR_MESHES || table == BLIND;
        all.extend(conditions().into_iter().map(|one| (is_chosen_on, one)));
    }
    let parts = par_map(all, |(every_model, condition)| {
        let windows = Windows::new(&condition, WINDOWS);
        let mut text = String::new();
        for model in MODELS.iter().filter(|model| every_model || model.for_all) {
            let settings = (model.make)(windows.settings());
            text += &stored_row(&condition, model.name, &Windowed::new(&windows, &settings));
        }
        // A new condition has none.
        let kept = stored().1.get(&condition.name);
        for model in REFUTED {
            if let Some(windowed) = kept.and_then(|kept| kept.get(model)) {
                text += &stored_row(&condition, model, windowed);
            }
        }
        let count = (PASSED_WINDOWS * condition.travel) as usize;
        let passed = Windows::passed(&condition, count);
        text + &stored_row(
            &condition,
            PASSED,
            &Windowed::new(&passed, &passed.settings()),
        )
    });
    let text = format!(
        "# inputs {}\ncondition,model,{}\n{}",
        sum_of_inputs(),
        COLUMNS.join(","),
        parts.concat()
    );
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        std::fs::write(stored_file(), text).unwrap();
        return;
    }
    assert!(
        text == std::fs::read_to_string(stored_file()).unwrap(),
        "other windows"
    );
}
