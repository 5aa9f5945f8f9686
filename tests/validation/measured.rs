//! The gates of measurement, computed together with one set of defaults, and the numbers of the independent
//! computation that the load share was made with, beside what was measured.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::Contacts;
use asperity::PositionError;
use asperity::case::LoadedCase;
use asperity::flanks::{Surfaces, Texture};
use asperity::lubrication::load_share_law::{LoadShare, ShareConditions, SharedLoad};
use asperity::mixed_film::{
    AttenuatedTraces, ContactTable, LoadShareSettings, PositionFilm, RoughContact, RoughWindow,
};
use asperity::oil::{BaseOil, FilmRheology, LubricantInput, ViscosityLaw};
use asperity::pipeline::{contacts, losses_with};
use asperity::result::Summary;
use asperity_contact::SolverSettings;
use asperity_core::Profile;
use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{
    Density, KinematicViscosity, Length, LineLoad, PerKelvin, Pressure, Speed, Temperature,
};
use asperity_ehl_regime::TraceSpectrum;
use asperity_report::chart::{Axis, Chart, Dress, Line, Series};
use asperity_tests::petry_johnson;

use crate::load_share::{FEW, few, losses, shipped, summary, with};

/// Traces of measured flanks.
fn traces(surfaces: &Surfaces) -> [Profile; 2] {
    surfaces.textures().clone().map(|texture| match texture {
        Texture::Trace(profile) => profile,
        _ => panic!("a fixture has traces"),
    })
}

/// Pitch line speeds m/s and the friction an independent program found there, boundary friction 0.08.
const FZG_SPEEDS: [(f64, f64); 6] = [
    (0.5, 0.0596),
    (1.25, 0.0517),
    (2.5, 0.0470),
    (5.0, 0.0435),
    (8.3, 0.0416),
    (20.0, 0.0379),
];

/// Turns per minute of the FZG pinion at a pitch line speed m/s: its working pitch radius is 36.6 mm.
fn turns(speed: f64) -> String {
    let radius = 0.0366;
    format!("{} 1/min", speed / radius * 30.0 / std::f64::consts::PI)
}

/// A case of `fixtures/measured` with few offsets and these keys changed.
fn measured(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    with(&format!("../measured/{name}"), &[&FEW[..], keys].concat())
}

/// The FZG gears with flanks of Ra 0.2 um.
fn fzg(keys: &[(&str, &str)]) -> LoadedCase {
    measured("fzg-c-ground", keys)
}

/// The same flanks and load distribution as the independent program had.
const MEAN_LENGTH: (&str, &str) = ("model.load_distribution", "mean-length");
/// Mean coefficient of friction of a mesh.
fn mean_friction(found: &Summary) -> f64 {
    found.sliding_w / (found.loss_factor_local * found.power_in_w)
}

/// A case at other speeds, temperatures or oils, with the contacts solved once.
struct Kept {
    case: LoadedCase,
    tables: Contacts,
}

impl Kept {
    fn new(case: LoadedCase) -> Self {
        let tables = contacts(&case).unwrap();
        Self { case, tables }
    }

    fn at(&self, keys: &[(&str, &str)]) -> Summary {
        let case = keys.iter().fold(self.case.clone(), |case, (key, value)| {
            case.with_key(key, value).unwrap()
        });
        losses_with(&self.tables, &case).unwrap().summary
    }
}

/// erf to 1.5e-7 (Abramowitz and Stegun 7.1.26).
fn erf(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.327_591_1 * x);
    let coefficients = [
        1.061_405_429,
        -1.453_152_027,
        1.421_413_741,
        -0.284_496_736,
        0.254_829_592,
    ];
    let sum = coefficients.iter().fold(0.0, |sum, c| sum * t + c);
    1.0 - sum * t * (-x * x).exp()
}

/// The law of the source of T1: 1 − erf(λ) of the load at the boundary coefficient, λ the film over Ra 0.2 um.
#[derive(Debug)]
struct Arana;

impl LoadShare for Arana {
    fn name(&self) -> &str {
        "arana"
    }

    fn share(&self, at: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
        let lambda = at.film.film.central.si() / 0.2e-6;
        Ok(SharedLoad::of_film(erf(lambda)))
    }
}

/// A gate: what was measured, its rule, what comes out, whether it holds where there is a rule.
struct Gate {
    measured: String,
    rule: &'static str,
    here: String,
    holds: Option<bool>,
}

fn gate(measured: impl Into<String>, rule: &'static str, here: String, holds: bool) -> Gate {
    Gate {
        measured: measured.into(),
        rule,
        here,
        holds: Some(holds),
    }
}

fn gates() -> &'static [Gate] {
    static GATES: OnceLock<Vec<Gate>> = OnceLock::new();
    GATES.get_or_init(|| {
        let mut rows = fzg_gates();
        rows.extend(SPEEDS.iter().map(petry_johnson_gate));
        rows.extend(finish_gates());
        rows.extend(oil_gates());
        rows.push(running_in_gate());
        rows.push(share_gate());
        rows.push(film_gate());
        rows
    })
}

/// T1: FZG type C-mod with tip relief.
fn fzg_gates() -> Vec<Gate> {
    let kept = Kept::new(measured("fzg-c-mod", &[]));
    let slow = |mu_b: &str| {
        let keys = [
            ("operation.speed", &*turns(0.5)),
            ("model.boundary_friction", mu_b),
        ];
        mean_friction(&kept.at(&keys))
    };
    let (mu, lower) = (slow("0.08"), slow("0.07"));
    let nominal = kept.at(&[("operation.speed", &turns(8.3))]);
    let factor = nominal.loss_factor_local;
    let film = losses(&kept.case.with_key("operation.speed", &turns(8.3)).unwrap());
    let central: Vec<f64> = film.path.iter().map(|row| row.film_central_um).collect();
    let film = central.iter().sum::<f64>() / central.len() as f64;
    let source: Vec<f64> = FZG_SPEEDS
        .iter()
        .map(|(speed, _)| {
            let turns = turns(*speed);
            let ours = kept.at(&[("operation.speed", &turns)]).loss_w;
            let law = kept
                .case
                .with_key("model.film_friction", "eyring-arana")
                .and_then(|case| case.with_key("model.boundary_friction", "0.065"))
                .and_then(|case| case.with_key("operation.speed", &turns))
                .unwrap();
            let law = with_arana(law);
            100.0 * (ours / losses(&law).summary.loss_w - 1.0)
        })
        .collect();
    let within = source.iter().all(|change| change.abs() <= 15.0);
    let source: Vec<String> = source
        .iter()
        .map(|change| format!("{change:+.1}"))
        .collect();
    vec![
        gate(
            "T1 FZG C-mod, ground Ra 0.2 um, 0.5 m/s: mean mu at most 0.065 (surrogate traces: ground fixture x 0.8)",
            "0.055 to 0.068",
            format!("{mu:.4} ({lower:.4} with mu_b 0.07)"),
            (0.055..=0.068).contains(&mu),
        ),
        gate(
            "T1 H_VL 0.1680 with 35 um relief (printed; length of the relief not: here over the double contact)",
            "within 5 %",
            format!("{factor:.4}, {:+.1} %", 100.0 * (factor / 0.1680 - 1.0)),
            (factor / 0.1680 - 1.0).abs() < 0.05,
        ),
        gate(
            "T1 film at 8.3 m/s just below 0.2 um",
            "0.15 to 0.20 um",
            format!("{film:.3} um as a gap, mean over the path"),
            (0.15..=0.20).contains(&film),
        ),
        gate(
            "T1 loss by the source's law (within 5 % of its measurement), coded anew: 0.5, 1.25, 2.5, 5, 8.3, 20 m/s",
            "within 15 %",
            format!("{} %", source.join(", ")),
            within,
        ),
    ]
}

fn with_arana(mut case: LoadedCase) -> LoadedCase {
    case.case = case.case.with_load_share(Arc::new(Arana));
    case
}

const SPEEDS: [(u32, [f64; 2], f64); 5] = [
    (2000, [166.0, 174.0], 152.0),
    (4000, [286.0, 320.0], 326.0),
    (6000, [456.0, 499.0], 505.0),
    (8000, [606.0, 633.0], 683.0),
    (10_000, [472.0, 640.0], 859.0),
];

/// The loss \[W\] with all defaults, of superfinished flanks known by their Rq.
fn petry_johnson_by_default(speed: u32) -> f64 {
    let case = with("../measured/petry-johnson", &[]);
    let case = case.with_key("operation.speed", &format!("{speed} 1/min"));
    losses(&case.unwrap()).summary.loss_w
}

fn petry_johnson_gate(&(speed, [low, high], _): &(u32, [f64; 2], f64)) -> Gate {
    let found = petry_johnson_by_default(speed);
    let holds = (0.75 * low..=1.25 * high).contains(&found);
    let mut gate = gate(
        format!(
            "T2 Petry-Johnson superfinished 40/40, {speed} 1/min: {low:.0} to {high:.0} W (grade C)"
        ),
        "within 25 %",
        format!("{found:.0} W"),
        holds,
    );
    if speed > 8000 {
        (gate.rule, gate.holds) = ("printed beyond 8000", None);
    }
    gate
}

/// T3 to T5: superfinishing and limiting shear.
fn finish_gates() -> Vec<Gate> {
    let britton: Vec<Britton> = [70.0, 90.0, 110.0].map(britton).into();
    let inside = britton
        .iter()
        .filter(|row| (0.2..=0.5).contains(&row.film_ratio));
    let mut inside = inside.map(|row| row.change).peekable();
    let any = inside.peek().is_some();
    let holds = any && inside.all(|change| (-0.40..=-0.20).contains(&change));
    let (ground, fine) = null_pair();
    let null = fine / ground - 1.0;
    let film = |name: &str, oil: &str| {
        let case = with(name, &[&FEW[..], &[("lubricant.base_oil", oil)]].concat());
        let path = losses(&case).path;
        path.iter().map(|row| row.mu_film).fold(0.0, f64::max)
    };
    let limits = [("mineral", 0.047), ("naphthenic", 0.053), ("pao", 0.035)];
    let found = limits.map(|(oil, limit)| (oil, limit, film("e-drive-superfinished", oil)));
    let text = found.map(|(oil, limit, mu)| format!("{oil} {mu:.4} (limit {limit})"));
    let britton_text = britton.iter().map(Britton::text);
    vec![
        gate(
            "T3 Britton, Ra 0.4 to 0.05 um, jet oil: friction -30 % (temperature unknown)",
            "-20 to -40 % at h/Rq 0.2 to 0.5",
            britton_text.collect::<Vec<_>>().join("; "),
            holds,
        ),
        gate(
            "T4 superfinishing of thick films brings nothing measurable (FZG at 40 °C, 20 m/s)",
            "below 8 %",
            format!("{:.1} %", 100.0 * null),
            null.abs() < 0.08,
        ),
        gate(
            "T5 limiting shear stress over pressure",
            "film friction at most that + 0.005",
            text.join(", "),
            found.iter().all(|(_, limit, mu)| *mu <= limit + 0.005),
        ),
    ]
}

/// FZG flanks in a thick film: friction of ground and superfinished ones.
fn null_pair() -> (f64, f64) {
    let keys = [
        ("operation.temperature", "40 °C"),
        ("operation.speed", &*turns(20.0)),
    ];
    let friction = |name: &str| mean_friction(&losses(&measured(name, &keys)).summary);
    (friction("fzg-c-ground"), friction("fzg-c-superfinished"))
}

/// The rig of T3 at one temperature.
struct Britton {
    celsius: f64,
    film_ratio: f64,
    change: f64,
}

impl Britton {
    fn text(&self) -> String {
        format!(
            "{:.0} °C, h/Rq {:.2}: {:.0} %",
            self.celsius,
            self.film_ratio,
            100.0 * self.change
        )
    }
}

/// Friction of the fixtures' flanks brought to Ra 0.4 um against superfinished ones, in a jet ester of
/// 5.1 mm²/s at 100 °C: 250 N/mm on 9 mm radius at 8 and 12 m/s, three pairs of windows.
fn britton(celsius: f64) -> Britton {
    let starts = [[300, 2000], [1500, 900], [2600, 1700]];
    let ground = shipped("e-drive").surfaces;
    let ground = traces(&ground.with_heights_times(0.4 / 0.24).unwrap());
    let fine = traces(&shipped("e-drive-superfinished").surfaces);
    let rheology = jet_ester();
    let contact = LineContact {
        load: LineLoad::from_si(250e3),
        radius: Length::from_si(9e-3),
        modulus: Pressure::from_si(210e9 / 2.0 / 0.91),
        speeds: [8.0, 12.0].map(Speed::from_si),
        bodies: shipped("e-drive").case.materials,
    };
    let bulk = Temperature::from_si(celsius + 273.15);
    let mut film =
        PositionFilm::new(&rheology, &contact, bulk, &LoadShareSettings::default()).unwrap();
    let mut mean = |flanks: &[Profile; 2]| {
        let spectra = flanks
            .each_ref()
            .map(|z| TraceSpectrum::new(z.heights(), z.spacing()).unwrap());
        let nabla = film.nabla_per_length();
        let attenuated = AttenuatedTraces::new([&spectra[0], &spectra[1]], nabla).unwrap();
        let spacing = flanks[0].spacing();
        let a = (4.0 * 250e3 * 9e-3 / (std::f64::consts::PI * contact.modulus.si())).sqrt();
        let points = 2 * (3.0 * a / spacing.si()).ceil() as usize + 1;
        let (mut friction, mut square) = (0.0, 0.0);
        for start in starts {
            let at = |k: usize, i: usize| flanks[k].heights()[start[k] + i];
            let composite: Vec<f64> = (0..points).map(|i| at(0, i) + at(1, i)).collect();
            let mut rough = RoughContact::new(&RoughWindow {
                composite: &composite,
                spacing,
                load: contact.load,
                radius: contact.radius,
                modulus: contact.modulus,
                flow_pressure: Pressure::from_si(7e9),
                settings: SolverSettings::default(),
            })
            .unwrap();
            let table = ContactTable::build(&mut rough).unwrap();
            let rms = attenuated.window_rms(start, points).unwrap();
            friction += film.share(&table, rms).unwrap().value.coefficient / 3.0;
            let n = points as f64;
            let middle = composite.iter().sum::<f64>() / n;
            square += composite.iter().map(|z| (z - middle).powi(2)).sum::<f64>() / (3.0 * n);
        }
        (friction, film.smooth_film().si() / square.sqrt())
    };
    let (ground, film_ratio) = mean(&ground);
    let (fine, _) = mean(&fine);
    Britton {
        celsius,
        film_ratio,
        change: fine / ground - 1.0,
    }
}

fn jet_ester() -> FilmRheology {
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(26e-6),
            at_100: KinematicViscosity::from_si(5.1e-6),
        }),
        density: Some(Density::from_si(1000.0)),
        thermal_expansion: Some(PerKelvin::from_si(0.63e-3)),
        base_oil: Some(BaseOil::Ester),
        ..LubricantInput::default()
    };
    let oil = oil.resolve(Temperature::from_si(363.15)).unwrap();
    FilmRheology::new(&oil, BaseOil::Ester).unwrap()
}

/// T6: base oils of one viscosity in the FZG gears at 90 °C.
fn oil_gates() -> Vec<Gate> {
    let kept = Kept::new(fzg(&[]));
    let at = |oil: &str, speed: f64| {
        let keys = [
            ("lubricant.base_oil", oil),
            ("operation.speed", &*turns(speed)),
        ];
        mean_friction(&kept.at(&keys))
    };
    let ratio = |oil: &str, speed: f64| at(oil, speed) / at("mineral", speed);
    let [glycol, ester] = ["polyglycol", "ester"].map(|oil| [2.5, 8.3].map(|v| ratio(oil, v)));
    let text = |[slow, fast]: [f64; 2]| format!("{slow:.2} at 2.5 m/s, {fast:.2} at 8.3 m/s");
    let all =
        |ratios: [f64; 2], low: f64, high: f64| ratios.iter().all(|r| (low..=high).contains(r));
    vec![
        gate(
            "T6 polyglycol over mineral oil in the gear rig 0.6",
            "0.45 to 0.75",
            text(glycol),
            all(glycol, 0.45, 0.75),
        ),
        gate(
            "T6 ester over mineral oil in the gear rig 0.6 to 1.0",
            "0.45 to 1.15",
            text(ester),
            all(ester, 0.45, 1.15),
        ),
    ]
}

/// T7: running-in on ground and on superfinished flanks.
fn running_in_gate() -> Gate {
    let run_in = |case: &LoadedCase| {
        let found = losses(case);
        let run_in = found.run_in.unwrap();
        let points = 100.0 * (run_in.summary.efficiency - found.summary.efficiency);
        let rq = run_in.run_in.rq_um[0] / run_in.measured.rq_um[0] - 1.0;
        (points, 100.0 * rq)
    };
    let on = [("model.run_in", "true")];
    let (fzg, rq) = run_in(&fzg(&on));
    let (drive, _) = run_in(&with("e-drive", &[&FEW[..], &on].concat()));
    let (fine, _) = run_in(&with("e-drive-superfinished", &[&FEW[..], &on].concat()));
    gate(
        "T7 running-in: Sq to -17 %, efficiency about +0.1 point on FZG gears, none for superfinished ones",
        "+0.03 to +0.3 point; 0",
        format!(
            "FZG {fzg:+.3} point (Rq {rq:.0} %), e-drive {drive:+.3}, superfinished {fine:+.3}"
        ),
        (0.03..=0.3).contains(&fzg) && fine.abs() < 0.005,
    )
}

/// One speed of the ground e-drive flanks: the film ratio, the solved share and those of published laws.
struct ShareRow {
    lambda: f64,
    solved: f64,
    laws: BTreeMap<&'static str, f64>,
}

const LAWS: [&str; 3] = ["lambda-star", "zhu-hu", "masjedi-khonsari"];

/// T9: asperity shares over the film ratio, by the speed.
fn shares() -> &'static [ShareRow] {
    static SHARES: OnceLock<Vec<ShareRow>> = OnceLock::new();
    SHARES.get_or_init(|| {
        let kept = Kept::new(with("e-drive", &FEW));
        let speeds = [100, 300, 1000, 3000, 9000, 25_000];
        let mut rows: Vec<ShareRow> = Vec::new();
        let colder = [9000, 25_000];
        for (temperature, speeds) in [
            ("90 °C", &speeds[..]),
            ("40 °C", &colder),
            ("15 °C", &colder),
        ] {
            for speed in speeds {
                let speed = format!("{speed} 1/min");
                let keys = [
                    ("operation.speed", &*speed),
                    ("operation.temperature", temperature),
                ];
                let case = keys.iter().fold(kept.case.clone(), |case, (key, value)| {
                    case.with_key(key, value).unwrap()
                });
                let path = losses_with(&kept.tables, &case).unwrap().path;
                let ratios = path.iter().filter_map(|row| row.film_ratio);
                let lambda = ratios.sum::<f64>() / path.len() as f64;
                let of = |law: &str| {
                    let case = case.with_key("model.load_share", law).unwrap();
                    losses(&case).summary.asperity_share
                };
                let mut laws: BTreeMap<_, _> = LAWS.map(|law| (law, of(law))).into();
                laws.insert("1 - erf(lambda)", 1.0 - erf(lambda));
                laws.insert("(1 - lambda/2)^2", (1.0 - 0.5 * lambda).max(0.0).powi(2));
                rows.push(ShareRow {
                    lambda,
                    solved: kept.at(&keys).asperity_share,
                    laws,
                });
            }
        }
        rows.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
        rows
    })
}

fn share_gate() -> Gate {
    let rows = shares();
    let touching = rows.iter().filter(|row| row.solved > 1e-3);
    let last = touching.map(|row| row.lambda).fold(0.0, f64::max);
    // How far below the least or above the most of them.
    let away = |row: &ShareRow| {
        let laws = || row.laws.values().copied();
        let (low, high) = (laws().fold(1.0, f64::min), laws().fold(0.0, f64::max));
        (row.solved - high).max(low - row.solved).max(0.0)
    };
    let farthest = rows.iter().max_by(|a, b| away(a).total_cmp(&away(b)));
    let (distance, place) = farthest.map_or((0.0, 0.0), |row| (away(row), row.lambda));
    gate(
        "T9 load share over lambda: published laws, contact seen up to lambda about 2",
        "among them to 0.05",
        format!(
            "{distance:.2} away from them all at lambda {place:.2}; above 0.1 % up to lambda {last:.2}"
        ),
        distance <= 0.05 && (1.0..=3.0).contains(&last),
    )
}

/// T10: power of the speed in the film.
fn film_gate() -> Gate {
    let film = |speed: f64| {
        let case = fzg(&[("operation.speed", &turns(speed))]);
        let path = losses(&case).path;
        path.iter().map(|row| row.film_central_um).sum::<f64>()
    };
    let power = |slow: f64, fast: f64| (film(fast) / film(slow)).ln() / (fast / slow).ln();
    let (slow, fast) = (power(0.5, 1.0), power(8.3, 16.6));
    gate(
        "T10 film on a rig over speed (oils not named): power 0.65 to 0.72",
        "within",
        format!("{slow:.3} at 0.5 m/s, with its heat {fast:.3} at 8.3 m/s"),
        (0.65..=0.72).contains(&slow),
    )
}

/// Gates of measurement, computed with one set of defaults.
pub fn gate_table() -> String {
    let mut text = String::from("| measured | rule | here | holds |\n|---|---|---|---|\n");
    for row in gates() {
        let verdict = match row.holds {
            Some(true) => "pass",
            Some(false) => "**FAIL**",
            None => "-",
        };
        let (measured, rule, here) = (&row.measured, row.rule, &row.here);
        let _ = writeln!(text, "| {measured} | {rule} | {here} | {verdict} |");
    }
    text.push_str("\nTest: `most_gates_of_measurement_hold_together`.\n");
    text
}

#[test]
fn most_gates_of_measurement_hold_together() {
    let held = gates()
        .iter()
        .filter(|gate| gate.holds == Some(true))
        .count();
    let ruled = gates().iter().filter(|gate| gate.holds.is_some()).count();
    println!("{}", gate_table());
    // They are reported, never tuned one by one.
    assert!(4 * held > 3 * ruled, "{}", gate_table());
}

/// A number of the independent computation, ours with its load distribution and with the default one.
struct Reference {
    what: String,
    independent: f64,
    alike: f64,
    default: f64,
    measured: String,
    digits: usize,
}

/// How far ours may be from the independent computation with the same load distribution: 32 places weighted to
/// 8 there, cells here, and other windows.
const ALIKE: f64 = 0.06;

fn references() -> &'static [Reference] {
    static ROWS: OnceLock<Vec<Reference>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let mut rows = drive_references();
        rows.extend(fzg_references());
        rows.extend(SPEEDS.iter().map(|&(speed, [low, high], independent)| {
            let trapezoid = petry_johnson()
                .with("model", toml::toml! { load_distribution = "trapezoid" })
                .with("operation.speed", format!("{speed} 1/min"));
            Reference {
                what: format!("Petry-Johnson, {speed} 1/min, W"),
                independent,
                alike: trapezoid.run().result.summary.loss_w,
                default: petry_johnson_by_default(speed),
                measured: format!("{low:.0} to {high:.0}"),
                digits: 0,
            }
        }));
        rows.extend(
            [(70.0, -0.26), (90.0, -0.41)].map(|(celsius, independent)| {
                let found = britton(celsius);
                Reference {
                    what: format!(
                        "Britton, {celsius} °C, h/Rq {:.2}, change",
                        found.film_ratio
                    ),
                    independent,
                    alike: found.change,
                    default: found.change,
                    measured: "-0.30, temperature unknown".to_owned(),
                    digits: 2,
                }
            }),
        );
        let (ground, fine) = null_pair();
        rows.push(Reference {
            what: "null test: superfinished in a thick film, FZG 40 °C, 20 m/s, change".to_owned(),
            independent: -0.001,
            alike: fine / ground - 1.0,
            default: fine / ground - 1.0,
            measured: "nothing measurable".to_owned(),
            digits: 3,
        });
        rows
    })
}

fn drive_references() -> Vec<Reference> {
    let kept =
        |name: &str, keys: &[(&str, &str)]| Kept::new(with(name, &[&FEW[..], keys].concat()));
    let pairs = ["e-drive", "e-drive-superfinished"];
    let [ground, fine] = pairs.map(|name| [kept(name, &[MEAN_LENGTH]), kept(name, &[])]);
    let mut rows = Vec::new();
    let temperatures = [
        (40, 530.0, 495.0),
        (60, 534.0, 454.0),
        (90, 569.0, 397.0),
        (120, 627.0, 351.0),
    ];
    for (celsius, on_ground, on_fine) in temperatures {
        let temperature = format!("{celsius} °C");
        let at = |kept: &Kept| {
            kept.at(&[("operation.temperature", &temperature)])
                .sliding_w
        };
        let (ground, fine) = (ground.each_ref().map(at), fine.each_ref().map(at));
        let mut push = |what: &str, independent, [alike, default]: [f64; 2], digits| {
            rows.push(Reference {
                what: format!("e-drive {celsius} °C, {what}"),
                independent,
                alike,
                default,
                measured: match what {
                    "superfinishing" if celsius == 90 => "-0.15 to -0.35 on other gears",
                    _ => "-",
                }
                .to_owned(),
                digits,
            });
        };
        push("ground, sliding W", on_ground, ground, 0);
        push("superfinished, sliding W", on_fine, fine, 0);
        let change = [0, 1].map(|k: usize| fine[k] / ground[k] - 1.0);
        push("superfinishing", on_fine / on_ground - 1.0, change, 2);
    }
    rows
}

fn fzg_references() -> Vec<Reference> {
    let kept = [Kept::new(fzg(&[MEAN_LENGTH])), Kept::new(fzg(&[]))];
    let rows = FZG_SPEEDS.iter().map(|(speed, independent)| {
        let turns = turns(*speed);
        let [alike, default] = kept
            .each_ref()
            .map(|kept| mean_friction(&kept.at(&[("operation.speed", &turns)])));
        Reference {
            what: format!("FZG ground x 0.8, {speed} m/s, mean mu"),
            independent: *independent,
            alike,
            default,
            measured: match speed {
                0.5 => "at most 0.065",
                _ => "-",
            }
            .to_owned(),
            digits: 4,
        }
    });
    rows.collect()
}

/// Numbers of the independent computation beside ours and the measurement.
pub fn reference_table() -> String {
    let mut text = String::from(
        "| quantity | independent | here, its load distribution | here, default | measured |\n\
         |---|---|---|---|---|\n",
    );
    for row in references() {
        let digits = row.digits;
        let _ = writeln!(
            text,
            "| {} | {:.digits$} | {:.digits$} | {:.digits$} | {} |",
            row.what, row.independent, row.alike, row.default, row.measured
        );
    }
    text.push_str("\nTest: `the_load_share_gives_what_was_computed_elsewhere`.\n");
    text
}

#[test]
fn the_load_share_gives_what_was_computed_elsewhere() {
    println!("{}", reference_table());
    for row in references() {
        let (seen, expected) = (row.alike, row.independent);
        // Changes of some ten per cent are compared in points; Britton's were made with the first form of the
        // inlet supply, Petry-Johnson's with a limiting shear stress of 0.04 instead of 0.035.
        let near = match &*row.what {
            what if what.starts_with("Britton") => (seen - expected).abs() < 0.15,
            what if what.starts_with("Petry") => (seen / expected - 1.0).abs() < 0.12,
            _ if row.digits == 2 || row.digits == 3 => (seen - expected).abs() < 0.05,
            _ => (seen / expected - 1.0).abs() < ALIKE,
        };
        assert!(near, "{}: {seen} for {expected}", row.what);
    }
}

/// Superfinished flanks in cold oil.
pub fn cold_table() -> String {
    static TABLE: OnceLock<String> = OnceLock::new();
    let made = TABLE.get_or_init(|| {
        let mut text = String::from(
            "| oil at | thermal reduction of the film | factor over the path | sliding W | rolling W | film friction | central gap um |\n\
             |---|---|---|---|---|---|---|\n",
        );
        for temperature in ["-20 °C", "-30 °C"] {
            for law in ["gupta", "murch-wilson"] {
                let keys = [("operation.temperature", temperature), ("model.thermal", law)];
                let found = losses(&with("e-drive-superfinished", &[&FEW[..], &keys].concat()));
                let span = |of: fn(&asperity::result::PositionRow) -> f64| {
                    let values = || found.path.iter().map(of);
                    [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)]
                };
                let [low, high] = span(|row| row.thermal_reduction);
                let [thin, thick] = span(|row| row.film_central_um);
                let [_, friction] = span(|row| row.mu_film);
                let _ = writeln!(
                    text,
                    "| {temperature} | {law} | {low:.3} to {high:.3} | {:.0} | {:.0} | at most {friction:.4} | {thin:.2} to {thick:.2} |",
                    found.summary.sliding_w, found.summary.rolling_w,
                );
            }
        }
        text.push_str("\nTest: `a_film_of_cold_oil_rubs_with_its_limiting_stress_at_most`.\n");
        text
    });
    made.clone()
}

/// Asperity shares over the film ratio.
pub fn share_table() -> String {
    let mut names: Vec<&str> = shares()[0].laws.keys().copied().collect();
    names.sort_unstable();
    let mut text = format!("| lambda | solved | {} |\n", names.join(" | "));
    let _ = writeln!(text, "|---{}|", "|---".repeat(1 + names.len()));
    for row in shares() {
        let laws = names.iter().map(|name| format!("{:.3}", row.laws[name]));
        let laws: Vec<String> = laws.collect();
        let _ = writeln!(
            text,
            "| {:.2} | {:.3} | {} |",
            row.lambda,
            row.solved,
            laws.join(" | ")
        );
    }
    text.push_str("\nTest: `the_share_lies_among_published_laws`.\n");
    text
}

/// The same as a picture.
fn share_picture() -> String {
    let lambda: Vec<f64> = shares().iter().map(|row| row.lambda).collect();
    let solved: Vec<f64> = shares().iter().map(|row| row.solved).collect();
    let axes = [
        Axis::new("film ratio h_min/Rq", "-").log(),
        Axis::new("share of the load on asperities", "-"),
    ];
    let [x, y] = axes;
    let title = "Asperity share of the e-drive's ground flanks, and published laws";
    let mut chart = Chart::new("load-share", title, "VALIDATION.md", x, y);
    chart = chart.with(Series::new("solved", Line::Dots, &lambda, &solved));
    for name in shares()[0].laws.keys() {
        let of: Vec<f64> = shares().iter().map(|row| row.laws[name]).collect();
        chart = chart.with(Series::new(name, Line::Dashed, &lambda, &of));
    }
    chart.svg(Dress::Alone)
}

#[test]
fn the_share_lies_among_published_laws() {
    println!("{}", share_table());
    let solved: Vec<f64> = shares().iter().map(|row| row.solved).collect();
    assert!(solved.is_sorted_by(|a, b| a >= b), "{solved:?}");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures/load_share.svg");
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        std::fs::write(&file, share_picture()).unwrap();
    }
    // Digits of a drawing may differ between processors; what it draws is held by the table.
    let shown = std::fs::read_to_string(&file).unwrap();
    assert!(shown.contains("<svg") && share_picture().contains("<svg"));
    assert!(shares()[0].laws.keys().all(|name| shown.contains(name)));
}

#[test]
fn superfinishing_pays_on_hot_thin_oil_and_not_in_thick_films() {
    let change = |keys: &[(&str, &str)]| {
        let loss = |name: &str| summary(name, &[&FEW[..], keys].concat()).loss_w;
        loss("e-drive-superfinished") / loss("e-drive") - 1.0
    };
    let [cold, hot] = ["40 °C", "120 °C"].map(|t| change(&[("operation.temperature", t)]));
    assert!(hot < cold && cold < 0.0, "{hot} {cold}");
    assert!(few("e-drive", &[]).boundary_w > few("e-drive-superfinished", &[]).boundary_w);
}
