//! Solved asperity share against our own records of the mixed EHL contact, the reference solution (gate T9).
//!
//! The records are the table of `fixtures/records`; the conditions are those of the example that made it. Share of a record: mean of
//! the loads below 20 and 50 nm. Six smooth thin films, where the two differ by more than 0.15, have no defined share; they are
//! left out of the gate, and printed with it. Both sides have ridges across the face; share and gap are isothermal, friction both isothermal and with heat.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::OnceLock;

use asperity::LoadedCase;
use asperity::ehl::RecordSettings;
use asperity::lubrication::{ComparedWindow, WINDOWS, compared_windows, share_settings};
use asperity::mixed_film::{
    AttenuatedTraces, GapRoughness, LoadShareSettings, LoadShareSolution, PositionFilm,
};
use asperity::reference_solution::{LARGEST_ROUGHNESS, ReferenceContact, ReferenceSettings};
use asperity::uncertainty::model_deviation;
use asperity_core::Profile;
use asperity_core::numerics::standard_normal_quantile;
use asperity_core::quantity::Length;
use asperity_ehl_regime::inlet_flow::inlet_factor;
use asperity_ehl_regime::{Attenuation, GapLaw, PairSpectrum, TraceSpectrum};

use asperity::oil::{BaseOil, TractionConstants};
use asperity_tribo_friction::FilmHeat;
use rayon::prelude::*;

use crate::gate::Estimate;
use mixed_ehl_records::EYRING_STRESS;

#[path = "../../crates/asperity/examples/mixed_ehl_records.rs"]
#[allow(
    dead_code,
    reason = "the example also makes the records, which takes minutes"
)]
pub mod mixed_ehl_records;

/// Difference of the loads below 20 and 50 nm above which a record has no defined share.
const UNDEFINED: f64 = 0.15;
/// Records without a defined share.
const UNDEFINED_RECORDS: usize = 6;

/// Mean film under the middle .8 of the contact over that under the whole contact, over which records average.
const GAP_OF_THE_MIDDLE: f64 = 0.975;

/// A row of a table of records.
struct Record {
    /// Attenuated roughness over the smooth isothermal film of the formula.
    roughness_ratio: f64,
    /// Loads below 20 and 50 nm.
    below: [f64; 2],
    /// Standard error of the load below 20 nm.
    error: f64,
    gap_um: f64,
    graded_friction: f64,
    /// Graded friction with the heat of film and surfaces, and its standard error.
    hot_friction: f64,
    hot_error: f64,
    /// Oil gained or lost over the mean flux: mean and worst step.
    balance: [f64; 2],
    mean_supply: f64,
    thinnest_nm: f64,
    warnings: String,
}

/// Share, gap and friction of the fast model, means over the windows, and standard errors of share and friction.
#[derive(Clone, Copy)]
struct Fast {
    share: Estimate,
    gap_um: f64,
    friction: f64,
    friction_error: f64,
    /// s of the whole pair by the smooth inlet, over the mass-flow film.
    roughness_ratio: f64,
}

/// A record and the fast model over windows of the same traces.
struct Compared {
    name: String,
    record: Record,
    /// By the gap law `inlet`, Ψ from both whole traces.
    inlet: Fast,
    /// The same with the heat of film and surfaces.
    hot: Fast,
    /// By the gap law `power`, and by `inlet` with Ψ from each window: of the gear meshes only.
    others: Option<[Fast; 2]>,
}

impl Compared {
    fn share(&self) -> f64 {
        0.5 * (self.record.below[0] + self.record.below[1])
    }

    /// The fast model as in a run: Ψ from both whole traces.
    fn by(&self, law: GapLaw) -> &Fast {
        match law {
            GapLaw::Inlet => &self.inlet,
            GapLaw::Power => self.power(),
        }
    }

    fn power(&self) -> &Fast {
        &self.others.as_ref().unwrap()[0]
    }

    fn inlet_of_windows(&self) -> &Fast {
        &self.others.as_ref().unwrap()[1]
    }

    fn difference(&self, law: GapLaw) -> f64 {
        self.by(law).share.value - self.share()
    }

    fn is_defined(&self) -> bool {
        self.record.below[1] - self.record.below[0] <= UNDEFINED
    }

    fn is_within_reference(&self) -> bool {
        self.record.roughness_ratio < LARGEST_ROUGHNESS
    }
}

/// The records of a table of `fixtures/records` by the name of their condition.
fn records(table: &str) -> BTreeMap<String, Record> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/records");
    let text = std::fs::read_to_string(file.join(format!("{table}.csv"))).unwrap();
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(head, mixed_ehl_records::COLUMNS);
    let rows = lines.map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |name: &str| cells[head.iter().position(|column| *column == name).unwrap()];
        let number = |name: &str| cell(name).parse::<f64>().unwrap();
        let found = Record {
            roughness_ratio: number("roughness_over_film"),
            below: ["below_20_nm", "below_50_nm"].map(number),
            error: number("below_20_nm_error"),
            gap_um: number("gap_um"),
            graded_friction: number("graded"),
            hot_friction: number("hot_graded"),
            hot_error: number("hot_graded_error"),
            balance: ["mean_balance", "worst_balance"].map(number),
            mean_supply: number("mean_supply"),
            thinnest_nm: number("thinnest_nm"),
            warnings: cell("warnings").to_owned(),
        };
        (cell("condition").to_owned(), found)
    });
    rows.collect()
}

/// The records of the gear meshes.
fn gear_meshes() -> &'static [Compared] {
    static ROWS: OnceLock<Vec<Compared>> = OnceLock::new();
    ROWS.get_or_init(|| compared("gear_meshes", mixed_ehl_records::conditions(), true))
}

/// The records of the blind test, listed before the first was made.
fn blind() -> &'static [Compared] {
    static ROWS: OnceLock<Vec<Compared>> = OnceLock::new();
    ROWS.get_or_init(|| compared("blind", mixed_ehl_records::blind_conditions(), false))
}

/// The records from which the gap law was derived and its limits were set.
fn first_57() -> &'static [Compared] {
    &gear_meshes()[..57]
}

/// The records of a table beside the fast model.
fn compared(
    table: &str,
    conditions: Vec<mixed_ehl_records::Condition>,
    with_others: bool,
) -> Vec<Compared> {
    let mut records = records(table);
    assert_eq!(conditions.len(), records.len());
    let mut pairs = Vec::new();
    for condition in conditions {
        let record = records.remove(&condition.name).unwrap();
        pairs.push((condition, record));
    }
    let rows = pairs.into_par_iter().map(|(condition, record)| {
        let windows = Windows::of(&condition, WINDOWS);
        let cold = FilmHeat::Isothermal;
        Compared {
            name: condition.name,
            record,
            inlet: windows.fast(GapLaw::Inlet, false, cold),
            hot: windows.fast(GapLaw::Inlet, false, FilmHeat::FilmAndSurfaces),
            others: with_others.then(|| {
                let others = [(GapLaw::Power, false), (GapLaw::Inlet, true)];
                others.map(|(law, each)| windows.fast(law, each, cold))
            }),
        }
    });
    rows.collect()
}

/// The contact of a condition with its windows.
pub struct Windows {
    loaded: LoadedCase,
    contact: ReferenceContact,
    windows: Vec<ComparedWindow>,
    spectra: [TraceSpectrum; 2],
}

impl Windows {
    pub fn of(condition: &mixed_ehl_records::Condition, count: usize) -> Self {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let loaded = condition.load(&workspace).unwrap();
        // As the records: isothermal, ridges across the face.
        let keys = [("model.thermal", "none"), ("model.lay", "0")];
        let loaded = keys.iter().fold(loaded, |loaded, (key, value)| {
            loaded.with_key(key, value).unwrap()
        });
        let settings = ReferenceSettings {
            record: RecordSettings::default(),
            eyring_stress: None,
            with_heat: false,
            beginning: 0,
        };
        let contact = ReferenceContact::of(&loaded, condition.position, &settings).unwrap();
        let windows = compared_windows(&loaded, &contact, count).unwrap();
        let spectrum = |z: &Profile| TraceSpectrum::new(z.heights(), z.spacing()).unwrap();
        let spectra = contact.traces.each_ref().map(spectrum);
        Self {
            loaded,
            contact,
            windows,
            spectra,
        }
    }

    /// The choices of the case, with heat.
    pub fn settings(&self) -> LoadShareSettings {
        share_settings(&self.loaded, &self.contact).unwrap()
    }

    /// The fast model in every window with the constants of the records and no thermal reduction of the film, with Ψ in the length
    /// of the inlet from both whole traces or from each window.
    pub fn solutions(
        &self,
        settings: &LoadShareSettings,
        of_each_window: bool,
    ) -> Vec<LoadShareSolution> {
        let case = &self.loaded.case;
        let line = (self.contact.position).line_contact(case.modulus, case.materials);
        let rheology = case.rheology.clone().unwrap();
        let constants = TractionConstants {
            eyring_stress: match case.lubricant.base_oil() {
                Some(BaseOil::Pao) => EYRING_STRESS[0],
                _ => EYRING_STRESS[1],
            },
            ..*rheology.constants()
        };
        let rheology = rheology.with_constants(constants).unwrap();
        let mut film = PositionFilm::new(&rheology, &line, case.temperature, settings).unwrap();
        let spectra = self.spectra.each_ref();
        let flattening = film.flattening(&PairSpectrum::of(spectra)).unwrap();
        let whole = AttenuatedTraces::new(spectra, &flattening);
        let of_window = |window: &ComparedWindow| {
            let mut roughness = whole.window(window.starts, window.points).unwrap();
            let next = |rms: Length| {
                let psi = inlet_factor(rms, film.supply_film(), settings.lay).unwrap();
                let scale = film.nabla_per_length() * psi.powf(-1.0 / 3.0);
                let attenuation = Attenuation::new(settings.gap_law, scale).unwrap();
                let traces = AttenuatedTraces::new(spectra, &attenuation.into());
                let window = traces.window(window.starts, window.points);
                window.unwrap().deviation
            };
            for _ in 0..WINDOW_ITERATIONS * usize::from(of_each_window) {
                let rms = roughness.deviation;
                let (first, second) = (next(rms), next(next(rms)));
                let (step, change) = (first - rms, second - first - first + rms);
                roughness.deviation = rms - step * (step / change);
            }
            film.share(&window.contact, &roughness).unwrap().value
        };
        self.windows.iter().map(of_window).collect()
    }

    fn fast(&self, law: GapLaw, of_each_window: bool, heat: FilmHeat) -> Fast {
        let mut settings = self.settings();
        settings.gap_law = law;
        settings.film.heat = heat;
        self.fast_by(&settings, of_each_window)
    }

    fn fast_by(&self, settings: &LoadShareSettings, of_each_window: bool) -> Fast {
        let solved = self.solutions(settings, of_each_window);
        let found = solved.iter().map(|solved| {
            [
                solved.asperity_share,
                solved.mean_gap.si() * 1e6,
                solved.coefficient,
                solved.roughness_over_film,
            ]
        });
        let found: Vec<[f64; 4]> = found.collect();
        let n = found.len() as f64;
        let mean = |k: usize| found.iter().map(|values| values[k]).sum::<f64>() / n;
        let error = |k: usize| {
            let middle = mean(k);
            let squares: f64 = found.iter().map(|row| (row[k] - middle).powi(2)).sum();
            (squares / (n - 1.0) / n).sqrt()
        };
        Fast {
            share: Estimate {
                value: mean(0),
                standard_error: error(0),
            },
            friction_error: error(2),
            gap_um: mean(1),
            friction: mean(2),
            roughness_ratio: mean(3),
        }
    }
}

/// Steps by Steffensen of Ψ of one window.
const WINDOW_ITERATIONS: usize = 2;

/// Mean and root mean square of the fast model minus the records: share (of those that have one), ln gap, ln friction.
fn statistics<'a>(rows: impl Iterator<Item = (&'a Compared, &'a Fast)> + Clone) -> [[f64; 2]; 3] {
    let defined = rows.clone().filter(|(row, _)| row.is_defined());
    [
        mean_and_rms(defined.map(|(row, fast)| fast.share.value - row.share())),
        mean_and_rms(rows.clone().map(|(row, fast)| gap_error(row, fast))),
        mean_and_rms(rows.map(|(row, fast)| (fast.friction / row.record.graded_friction).ln())),
    ]
}

/// ln of the fast model's friction over the record's: at the bulk temperature, and with heat.
fn friction_errors(row: &Compared) -> [f64; 2] {
    let [cold, hot] = [row.inlet.friction, row.hot.friction];
    [
        (cold / row.record.graded_friction).ln(),
        (hot / row.record.hot_friction).ln(),
    ]
}

/// ln of the fast model's gap over the record's.
fn gap_error(row: &Compared, fast: &Fast) -> f64 {
    (fast.gap_um / (GAP_OF_THE_MIDDLE * row.record.gap_um)).ln()
}

fn mean_and_rms(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let values: Vec<f64> = values.collect();
    let n = values.len() as f64;
    let squares = values.iter().map(|value| value * value).sum::<f64>();
    [values.iter().sum::<f64>() / n, (squares / n).sqrt()]
}

/// Mean and standard deviation.
fn spread(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let values: Vec<f64> = values.collect();
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (n > 1.0).then(|| [mean, (squares / (n - 1.0)).sqrt()])
}

/// Ends of the classes of s.
const CLASSES: [f64; 7] = [0.0, 0.6, 1.2, 1.8, 2.3, 3.0, 6.0];

/// Fast model minus records of the gear meshes by classes of s, mean ± standard deviation.
pub fn class_table() -> String {
    let mut text = String::from(
        "| s | records | φ | ln gap | ln μ at the bulk temperature | ln μ with heat |\n|---|---|---|---|---|---|\n",
    );
    for ends in CLASSES.windows(2) {
        let is_in = |row: &&Compared| (ends[0]..ends[1]).contains(&row.hot.roughness_ratio);
        let rows = || gear_meshes().iter().filter(is_in);
        let defined = rows().filter(|row| row.is_defined());
        let columns = [
            spread(defined.map(|row| row.difference(GapLaw::Inlet))),
            spread(rows().map(|row| gap_error(row, &row.inlet))),
            spread(rows().map(|row| friction_errors(row)[0])),
            spread(rows().map(|row| friction_errors(row)[1])),
        ];
        let cells = columns.map(|column| match column {
            Some([mean, deviation]) => format!("{mean:+.3} ± {deviation:.3}"),
            None => "-".to_owned(),
        });
        let count = rows().count();
        let _ = writeln!(
            text,
            "| {} to {} | {count} | {} |",
            ends[0],
            ends[1],
            cells.join(" | ")
        );
    }
    text
}

/// Mean and root mean square of the fast model minus the records of the gear meshes, by gap law.
pub fn law_table() -> String {
    let mut text = String::from(
        "| gap law | Ψ of | records | φ | ln gap | ln μ at the bulk temperature | ln μ with heat |\n|---|---|---|---|---|---|---|\n",
    );
    type Of = fn(&Compared) -> &Fast;
    let by: [(&str, &str, Of); 3] = [
        ("power", "window", |row| row.power()),
        ("inlet", "window", |row| row.inlet_of_windows()),
        ("inlet", "both traces", |row| &row.inlet),
    ];
    for (law, of, fast) in by {
        for (name, rows, end) in [
            ("first 57", first_57(), f64::INFINITY),
            ("first 57, σ_d/h_c below 3", first_57(), LARGEST_ROUGHNESS),
            ("all", gear_meshes(), f64::INFINITY),
            ("all, σ_d/h_c below 3", gear_meshes(), LARGEST_ROUGHNESS),
        ] {
            let rows = || rows.iter().filter(|row| row.record.roughness_ratio < end);
            let cold = statistics(rows().map(|row| (row, fast(row))));
            let with_heat = of == "both traces";
            let hot = || mean_and_rms(rows().map(|row| friction_errors(row)[1]));
            let hot = with_heat.then(hot);
            let cell = |[mean, rms]: [f64; 2]| format!("{mean:+.3}, {rms:.3}");
            let [share, gap, friction] = cold.map(cell);
            let hot = hot.map_or("-".to_owned(), cell);
            let _ = writeln!(
                text,
                "| `{law}` | {of} | {name} | {share} | {gap} | {friction} | {hot} |"
            );
        }
    }
    text
}

/// 5 and 95 % quantiles of ln of the fast model's friction over a record's, by the bias and error that a run draws; with
/// the standard errors of windows and record, which a run draws apart.
fn drawn_errors(row: &Compared, with_sampling: bool) -> [f64; 2] {
    const DRAWS: usize = 200;
    let [bias, mut error] =
        model_deviation(GapLaw::Inlet, row.hot.roughness_ratio, row.hot.share.value);
    if with_sampling {
        error = error.hypot(row.hot.friction_error / row.hot.friction);
        error = error.hypot(row.record.hot_error / row.record.hot_friction);
    }
    let place = |k: usize| (k as f64 + 0.5) / DRAWS as f64;
    let mut drawn = Vec::new();
    for weight in (0..DRAWS).map(place) {
        let normal = |k| weight * bias + error * standard_normal_quantile(place(k));
        drawn.extend((0..DRAWS).map(normal));
    }
    drawn.sort_by(f64::total_cmp);
    [0.05, 0.95].map(|part| drawn[(part * drawn.len() as f64) as usize])
}

fn is_covered(row: &Compared, with_sampling: bool) -> bool {
    let [low, high] = drawn_errors(row, with_sampling);
    (low..high).contains(&friction_errors(row)[1])
}

/// Every record of the blind test, then mean and root mean square below and above a ratio of 3.
pub fn blind_table() -> String {
    let mut text = String::from(
        "| condition | σ_d/h_c | s | φ: record, fast | gap µm: record × .975, fast | graded μ: record, fast, ln | with heat: record, fast, ln | 90 % of ln | within |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for row in blind() {
        let (record, fast) = (&row.record, &row.inlet);
        let [cold, hot] = friction_errors(row);
        let [low, high] = drawn_errors(row, false);
        let undefined = match row.is_defined() {
            true => "",
            false => " (undefined)",
        };
        let _ = writeln!(
            text,
            "| {} | {:.2} | {:.2} | {:.3}, {:.3}{undefined} | {:.3}, {:.3} | {:.5}, {:.5}, {cold:+.3} | {:.5}, {:.5}, {hot:+.3} | {low:+.3} to {high:+.3} | {} |",
            row.name,
            record.roughness_ratio,
            row.hot.roughness_ratio,
            row.share(),
            fast.share.value,
            GAP_OF_THE_MIDDLE * record.gap_um,
            fast.gap_um,
            record.graded_friction,
            fast.friction,
            record.hot_friction,
            row.hot.friction,
            if is_covered(row, false) {
                "yes"
            } else {
                "**no**"
            },
        );
    }
    text.push_str(
        "\n| records | φ | ln gap | ln μ at the bulk temperature | ln μ with heat | within 90 % | with errors of sampling |\n|---|---|---|---|---|---|---|\n",
    );
    for (name, low, high) in [
        ("all", 0.0, f64::INFINITY),
        ("σ_d/h_c below 3", 0.0, LARGEST_ROUGHNESS),
        ("σ_d/h_c above 3", LARGEST_ROUGHNESS, f64::INFINITY),
    ] {
        let is_in = |row: &&Compared| (low..high).contains(&row.record.roughness_ratio);
        let rows = || blind().iter().filter(is_in);
        let cold = statistics(rows().map(|row| (row, &row.inlet)));
        let hot = mean_and_rms(rows().map(|row| friction_errors(row)[1]));
        let cells = [cold[0], cold[1], cold[2], hot];
        let cells = cells.map(|[mean, rms]| format!("{mean:+.3}, {rms:.3}"));
        let [within, with_sampling] =
            [false, true].map(|with| rows().filter(|row| is_covered(row, with)).count());
        let _ = writeln!(
            text,
            "| {name} | {} | {within} of {} | {with_sampling} |",
            cells.join(" | "),
            rows().count()
        );
    }
    text
}

#[test]
fn the_blind_records_are_compared_as_listed() {
    println!("{}", blind_table());
    let rows = blind();
    assert_eq!(rows.len(), 28);
    // The outcome, printed in docs/records/ehl-blind-test.md: the interval of 90 % holds fewer. Another number means that a record or the law has
    // changed since.
    let within = rows.iter().filter(|row| is_covered(row, false)).count();
    assert_eq!(within, 18);
}

/// Windows of the experiment on the causes of the failures.
const MANY_WINDOWS: usize = 64;

/// Fast model minus a record, by the three choices of windows and heights.
struct ByCause {
    name: String,
    roughness_ratio: f64,
    /// Share, of a record that has one.
    share: [Option<f64>; 3],
    /// ln gap, and ln friction with heat.
    gap_and_friction: [[f64; 2]; 3],
}

/// Share, ln gap and ln friction with heat, of the fast model minus a record, with 8 windows, with 64, and with 64 and σ_d of the
/// peaks.
fn by_cause(table: &str, conditions: Vec<mixed_ehl_records::Condition>) -> Vec<ByCause> {
    let records = records(table);
    let rows = conditions.into_par_iter().map(|condition| {
        let record = &records[&condition.name];
        let many = Windows::of(&condition, MANY_WINDOWS);
        let few = Windows::of(&condition, WINDOWS);
        let cold = |windows: &Windows| windows.fast(GapLaw::Inlet, false, FilmHeat::Isothermal);
        let hot = |windows: &Windows| {
            windows
                .fast(GapLaw::Inlet, false, FilmHeat::FilmAndSurfaces)
                .friction
        };
        let (first, second) = ((cold(&few), hot(&few)), (cold(&many), hot(&many)));
        let of_peaks = |heat: FilmHeat| {
            let mut settings = many.settings();
            settings.gap_roughness = GapRoughness::Peaks;
            settings.film.heat = heat;
            many.fast_by(&settings, false)
        };
        let third = [FilmHeat::Isothermal, FilmHeat::FilmAndSurfaces].map(of_peaks);
        let third = (third[0], third[1].friction);
        let share = 0.5 * (record.below[0] + record.below[1]);
        let is_defined = record.below[1] - record.below[0] <= UNDEFINED;
        let all = [first, second, third];
        ByCause {
            name: condition.name,
            roughness_ratio: record.roughness_ratio,
            share: all.map(|(fast, _)| is_defined.then_some(fast.share.value - share)),
            gap_and_friction: all.map(|(fast, hot)| {
                let gap = (fast.gap_um / (GAP_OF_THE_MIDDLE * record.gap_um)).ln();
                [gap, (hot / record.hot_friction).ln()]
            }),
        }
    });
    rows.collect()
}

#[test]
#[ignore = "some minutes; the table of docs/records/ehl-blind-test.md is renewed by hand"]
fn causes_of_the_blind_failures() {
    let blind = by_cause("blind", mixed_ehl_records::blind_conditions());
    let meshes = by_cause("gear_meshes", mixed_ehl_records::conditions());
    for row in &blind {
        let or_dash =
            |share: Option<f64>| share.map_or("-".to_owned(), |share| format!("{share:+.3}"));
        let share = row.share.map(or_dash).join(", ");
        let column = |k: usize| {
            row.gap_and_friction
                .map(|of| format!("{:+.3}", of[k]))
                .join(", ")
        };
        println!("| {} | {share} | {} | {} |", row.name, column(0), column(1));
    }
    for (of, rows, end) in [
        ("28 blind", &blind, f64::INFINITY),
        ("25 blind below 3", &blind, LARGEST_ROUGHNESS),
        ("65", &meshes, f64::INFINITY),
        ("60 of 65 below 3", &meshes, LARGEST_ROUGHNESS),
    ] {
        let rows = || rows.iter().filter(|row| row.roughness_ratio < end);
        let cell = |[mean, rms]: [f64; 2]| format!("{mean:+.3}, {rms:.3}");
        for which in 0..3 {
            let share = mean_and_rms(rows().filter_map(|row| row.share[which]));
            let gap = mean_and_rms(rows().map(|row| row.gap_and_friction[which][0]));
            let friction = mean_and_rms(rows().map(|row| row.gap_and_friction[which][1]));
            println!(
                "| {of} | {which} | {} | {} | {} |",
                cell(share),
                cell(gap),
                cell(friction)
            );
        }
    }
}

#[test]
#[ignore = "prints every row"]
fn every_record_and_the_fast_model() {
    println!("name,s,ratio,share,dphi,lngap,lnmu,lnmu_hot,power_lnmu");
    for row in gear_meshes() {
        let [cold, hot] = friction_errors(row);
        println!(
            "{},{:.4},{:.4},{:.4},{:.4},{:.4},{cold:.4},{hot:.4},{:.4}",
            row.name,
            row.hot.roughness_ratio,
            row.record.roughness_ratio,
            row.share(),
            row.difference(GapLaw::Inlet),
            gap_error(row, &row.inlet),
            (row.power().friction / row.record.graded_friction).ln(),
        );
    }
}

#[test]
fn the_gap_law_inlet_follows_57_records() {
    let rows = first_57();
    for name in ["pair", "window"] {
        let fast = |row: &'static Compared| match name {
            "pair" => &row.inlet,
            _ => row.inlet_of_windows(),
        };
        for (end, limits) in [
            // The aim of the mean friction, .03, is missed: the width of spots by ∫p² dx raises the mean from .030 to .036, and
            // spots that part at the lowest pressure between them to .0375; the scatter is as it was. The limit holds what was
            // found.
            (f64::INFINITY, [0.05, 0.075, 0.038, 0.11]),
            (LARGEST_ROUGHNESS, [0.04, 0.065, 0.02, 0.065]),
        ] {
            let rows = rows.iter().filter(|row| row.record.roughness_ratio < end);
            let [share, gap, friction] = statistics(rows.map(|row| (row, fast(row))));
            println!(
                "Ψ of each {name}, σ_d/h_c below {end}: share {share:.4?}, ln gap {gap:.4?}, ln friction {friction:.4?}"
            );
            let seen = [share[1], gap[1], friction[0].abs(), friction[1]];
            if name == "window" {
                assert!(
                    seen.iter().zip(limits).all(|(seen, limit)| *seen < limit),
                    "{seen:?}"
                );
            }
        }
    }
    let rows = rows.iter().map(|row| (row, row.power()));
    println!("gap law power: {:.4?}", statistics(rows));
}

#[test]
fn the_gap_law_inlet_follows_the_speed() {
    // Gap at 0.15 of the path of the FZG pair by an independent program, 20 to 0.5 m/s; the records have .620 to .452 um.
    for (speed, gap) in [
        ("20", 0.6234),
        ("8.3", 0.5439),
        ("5", 0.5130),
        ("2.5", 0.4760),
        ("1.25", 0.4397),
        ("0.5", 0.3896),
    ] {
        let name = format!("fzg_{speed}_0.15");
        let row = gear_meshes().iter().find(|row| row.name == name).unwrap();
        let [pair, window] =
            [&row.inlet, row.inlet_of_windows()].map(|fast| fast.gap_um / gap - 1.0);
        assert!(
            window.abs() < 2e-3 && pair.abs() < 5e-3,
            "{name}: {window} {pair}"
        );
    }
}

/// Root mean square and mean of the solved share minus the share of the records.
pub struct Deviation {
    pub records: usize,
    pub root_mean_square: Estimate,
    pub mean: f64,
}

/// Deviations from the records up to the ratio of roughness to film beyond which they are not a reference, or from all; with or
/// without those that have no defined share. Errors of the records are independent.
pub fn deviation(law: GapLaw, within_reference: bool, with_undefined: bool) -> Deviation {
    let rows = gear_meshes().iter();
    let rows: Vec<&Compared> = rows
        .filter(|row| !within_reference || row.is_within_reference())
        .filter(|row| with_undefined || row.is_defined())
        .collect();
    let n = rows.len() as f64;
    let squares: f64 = rows.iter().map(|row| row.difference(law).powi(2)).sum();
    let value = (squares / n).sqrt();
    let errors = rows.iter().map(|row| {
        let error = row.record.error.hypot(row.by(law).share.standard_error);
        (row.difference(law) * error / (n * value)).powi(2)
    });
    Deviation {
        records: rows.len(),
        root_mean_square: Estimate {
            value,
            standard_error: errors.sum::<f64>().sqrt(),
        },
        mean: rows.iter().map(|row| row.difference(law)).sum::<f64>() / n,
    }
}

#[test]
fn the_solved_share_is_compared_with_every_record_that_has_one() {
    let undefined = gear_meshes().iter().filter(|row| !row.is_defined()).count();
    assert_eq!(undefined, UNDEFINED_RECORDS);
    // The comparison of docs/records/ehl-comparison.md with the law `power`, on other windows, has a root mean square of .04.
    for (law, most) in [(GapLaw::Inlet, 0.04), (GapLaw::Power, 0.08)] {
        let within = deviation(law, true, false).root_mean_square.value;
        assert!(within < most, "{law:?}: {within}");
    }
}

#[test]
fn films_of_all_records_stay_positive_and_keep_their_oil() {
    let records = records("gear_meshes");
    assert!(records.len() >= 60);
    let ratios = || records.values().map(|record| record.roughness_ratio);
    let low = ratios().fold(f64::INFINITY, f64::min);
    let high = ratios().fold(0.0, f64::max);
    assert!(low < 0.25 && high > 4.5, "{low} {high}");
    for (name, record) in &records {
        // A hundredth of the contact film of 5 nm.
        assert!(record.thinnest_nm >= 0.05, "{name}: {}", record.thinnest_nm);
        let most = match record.roughness_ratio {
            ratio if ratio < 3.0 => 0.02,
            _ => 0.03,
        };
        let [mean, worst] = record.balance;
        assert!(mean < most && worst < 7.0, "{name}: {mean} {worst}");
        assert!(record.mean_supply < 0.66, "{name}: {}", record.mean_supply);
        // Heat lowers the friction, and elastic surfaces are warned of above the flow pressure.
        assert!(record.hot_friction < record.graded_friction, "{name}");
        // The film of the warning is that of the solver, a gap, up to a fifth thinner than the formula's.
        let warned = record.warnings.contains("W415");
        let ratio = record.roughness_ratio / LARGEST_ROUGHNESS;
        assert!(ratio < 1.0 || warned, "{name}");
        assert!(ratio > 0.8 || !warned, "{name}");
        let elastic = name.contains("elastic");
        assert_eq!(record.warnings.contains("W435"), elastic, "{name}");
    }
}
