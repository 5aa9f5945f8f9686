//! Intervals of the shipped drive with the constants of the film friction from simulated traction curves.

use std::fmt::Write as _;
use std::sync::OnceLock;

use asperity::Contacts;
use asperity::case::{CaseInput, LoadedCase};
use asperity::core::quantity::Length;
use asperity::evidence::Effort;
use asperity::uncertainty::predictive;
use asperity_calibration::evidence::EvidenceTable;
use asperity_calibration::oil::fit::PointErrors;
use asperity_calibration::oil::problem::{Priors, TractionProblem, Zero};
use asperity_calibration::oil::{
    ConstantsOf, FitSettings, Machine, OilBase, OilFit, OilPlan, OilPlanSettings, PlanSettings,
    PriorSettings, Reading, SetPoint, Setting, read_table, set_points, simulated,
};
use asperity_core::numerics::standard_normal_quantile;
use asperity_report::Settings as _;
use asperity_tests::{contacts, losses_with};

use crate::band::{Banded, banded, both};
use crate::load_share::{shipped, with};

/// 120 points at 40, 80 and 120 °C, 20 and 60 N, 1 and 3 m/s, simulated with 2.5 % and 0.001 of scatter.
const CURVES: &str = include_str!("../../crates/calibration/tests/golden/traction_e_fluid.csv");

/// The oil file of the curves with the oil of a case: as simulated, or without scatter and with the default errors of points.
fn oil_file(case: &LoadedCase, is_scattered: bool) -> String {
    let oil = OilBase::of_case(case, ConstantsOf::Family).unwrap();
    let length = Length::from_si;
    let machine = Machine::ball_on_disc(length(9.525e-3), None, length(15e-9)).unwrap();
    let (mut readings, _) = read_table("curves.csv", CURVES, &machine).unwrap();
    let mut errors = PointErrors {
        relative: 0.025,
        floor: 1e-3,
    };
    if !is_scattered {
        errors = PriorSettings::usual().unwrap().errors().unwrap();
        for reading in &mut readings {
            let found = machine.predict(&oil.rheology, &reading.setting).unwrap();
            reading.traction = found.friction.coefficient;
        }
    }
    let settings = FitSettings {
        is_wide: false,
        zero: Zero::Curve,
        errors,
        is_forced: false,
    };
    let fit = OilFit::new(&oil, readings.into(), settings).unwrap();
    fit.oil_file().unwrap().to_string()
}

/// The case with an oil file.
fn naming(case: &LoadedCase, oil_file: &str) -> LoadedCase {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), oil_file).unwrap();
    let named = |input: &mut CaseInput| input.lubricant.oil_file = Some(file.path().to_owned());
    case.with(named).unwrap()
}

/// A shipped case with the constants of these oil files.
fn runs(name: &str, files: &[String; 2]) -> [Banded; 2] {
    files
        .each_ref()
        .map(|file| banded(naming(&shipped(name), file)))
}

/// The cases with the limits of the ratio of standard deviations, by scattered curves and by precise ones.
const CASES: [(&str, &str, [f64; 2]); 2] = [
    ("ground", "e-drive", [0.99, 0.99]),
    ("superfinished", "e-drive-superfinished", [0.28, 0.25]),
];

/// Runs of both cases: with the constants of the family of the oil, which are the shipped ones, and with those of the curves.
fn all() -> [[&'static Banded; 3]; 2] {
    static FITTED: OnceLock<[[Banded; 2]; 2]> = OnceLock::new();
    let fitted = FITTED.get_or_init(|| {
        // Both cases have the same oil.
        let [ground, fine] = CASES.map(|(_, case, _)| shipped(case));
        assert_eq!(ground.case.lubricant, fine.case.lubricant);
        let files = [true, false].map(|is_scattered| oil_file(&ground, is_scattered));
        CASES.map(|(_, case, _)| runs(case, &files))
    });
    [0, 1].map(|k: usize| {
        let [scattered, precise] = &fitted[k];
        [&both()[k], scattered, precise]
    })
}

/// Loss with the constants of the oil's family and with two oil files.
pub fn table() -> String {
    let mut text = String::from(
        "| e-drive, tip relief stated | constants | loss W, median (5 to 95 %) | sd of ln loss by the constants | over the family | of it what no curve states | error of the law |\n|---|---|---|---|---|---|---|\n",
    );
    let by = [
        "of the family",
        "curves with 2.5 % and 0.001 of scatter",
        "curves with 1.5 % and 0.0003",
    ];
    for ((name, ..), runs) in CASES.iter().zip(all()) {
        let family = runs[0].2.sd_of_constants();
        for (by, banded) in by.iter().zip(runs) {
            let loss = &banded.1.loss;
            let [low, high] = loss.drawn().ends();
            let sd = banded.2.sd_of_constants();
            let [left, law] =
                [&UNSTATED[..], &["error of the film law"]].map(|names| part(banded, names));
            let _ = writeln!(
                text,
                "| {name} | {by} | {:.0} ({low:.0} to {high:.0}) | {sd:.3} | {:.2} | {left:.3} | {law:.3} |",
                loss.drawn().value,
                sd / family,
            );
        }
    }
    text.push_str("\nTest: `traction_curves_narrow_the_part_of_the_constants`.\n");
    text
}

/// Constants that no traction curve states: of the boundary layer, and the pressure-viscosity coefficient of the film
/// thickness.
const UNSTATED: [&str; 4] = [
    "boundary friction",
    "boundary layer",
    "lay",
    "pressure-viscosity",
];

/// Standard deviation of ln loss by independent parts.
fn part(banded: &Banded, names: &[&str]) -> f64 {
    let parts = banded.1.loss.parts.iter();
    let of_names = parts.filter(|part| names.contains(&&*part.name));
    of_names.map(|part| part.sd_ln).fold(0.0, f64::hypot)
}

#[test]
fn traction_curves_narrow_the_part_of_the_constants() {
    for ((name, _, limits), [family, fitted @ ..]) in CASES.into_iter().zip(all()) {
        for (fitted, limit) in fitted.iter().zip(limits) {
            let ratio = fitted.2.sd_of_constants() / family.2.sd_of_constants();
            assert!(ratio <= limit, "{name}: {ratio}");
            // On ground flanks nearly all that is left is the boundary layer.
            let left = part(fitted, &UNSTATED) / fitted.2.sd_of_constants();
            assert!(left > 0.9 || name == "superfinished", "{name}: {left}");
            let width = |banded: &Banded| {
                let [low, high] = banded.1.loss.drawn().ends();
                high / low
            };
            assert!(width(fitted) < width(family), "{name}");
        }
    }
}

/// Simulated traction curves behind a mean on superfinished and on ground flanks. The width of the interval that they leave
/// scatters by 2 and 1 % (standard deviation), so either mean by 0.6 %; 5 % are allowed.
const SIMULATED: [usize; 2] = [10, 3];
/// Strata of each other measurement behind a mean.
const STRATA: usize = 4;

/// Oil files of simulated machines that measure the standard plan on the oil of a case.
fn simulated_oil_files(case: &LoadedCase) -> Vec<String> {
    let oil = OilBase::of_case(case, ConstantsOf::Family).unwrap();
    let settings = OilPlanSettings::usual().unwrap().plan().unwrap();
    let PlanSettings {
        machine,
        is_wide,
        zero,
        errors,
        ..
    } = settings;
    let plan = OilPlan::new(&oil, None, &settings).unwrap();
    let mut table =
        String::from("load_n,mean_speed_m_s,slide_roll_percent,temperature_c,traction\n");
    for point in &plan.points {
        for sign in [1.0, -1.0] {
            let _ = writeln!(
                table,
                "{},{},{},{},{}",
                point.load_n,
                point.mean_speed_m_s,
                sign * point.slide_roll_percent,
                point.temperature_c,
                sign * point.expected_traction
            );
        }
    }
    let (planned, _) = read_table("simulated.csv", &table, &machine).unwrap();
    let points = set_points(&planned);
    let law = oil.rheology.laws().1;
    let priors = Priors::family(oil.deviations);
    let problem = TractionProblem::new(&oil, law, priors, zero, &points);
    let of_seed = |seed: usize| {
        let (_, friction) = simulated(&problem, false, errors, seed as u64).unwrap();
        let measured = |reading: &Reading| {
            let mut reading = reading.clone();
            let key = |at: &Setting| {
                let slide = at.slide_to_roll.abs();
                [at.load.si(), at.mean_speed.si(), slide, at.temperature.si()]
            };
            let own = key(&reading.setting);
            let same = |point: &SetPoint| {
                let pairs = key(&point.reading.setting).into_iter().zip(own);
                pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9 * b)
            };
            let k = points.iter().position(same).unwrap();
            reading.traction = friction[k].copysign(reading.setting.slide_to_roll);
            reading
        };
        let readings: Vec<Reading> = planned.iter().map(measured).collect();
        let settings = FitSettings {
            is_wide,
            zero,
            errors,
            is_forced: true,
        };
        let fit = OilFit::new(&oil, readings.into(), settings).unwrap();
        fit.oil_file().unwrap().to_string()
    };
    (1..=SIMULATED[0]).map(of_seed).collect()
}

/// Width of the interval of ln loss, and standard deviation of ln loss by the constants, on contacts solved once.
fn spreads(tables: &Contacts, case: &LoadedCase) -> [f64; 2] {
    let nominal = losses_with(tables, case).unwrap();
    let drawn = predictive(case, &nominal, Some(tables)).unwrap().unwrap();
    let [low, high] = drawn.quantiles().drawn.ends();
    [(high / low).ln(), drawn.sd_of_constants()]
}

/// Means over cases that were measured.
fn mean_spreads(tables: &Contacts, cases: impl Iterator<Item = LoadedCase>) -> [f64; 2] {
    let found: Vec<[f64; 2]> = cases.map(|case| spreads(tables, &case)).collect();
    let mean = |k: usize| found.iter().map(|one| one[k]).sum::<f64>() / found.len() as f64;
    [mean(0), mean(1)]
}

/// The expected interval after each measurement, with the interval of the case itself.
struct Expected<'a> {
    name: &'a str,
    table: EvidenceTable,
    spreads: [f64; 2],
}

impl<'a> Expected<'a> {
    fn new(name: &'a str, tables: &Contacts, case: &LoadedCase) -> Self {
        let table = EvidenceTable::new(&case.clone().into(), &Effort::usual(), &|_, _| {});
        Self {
            name,
            table: table.unwrap(),
            spreads: spreads(tables, case),
        }
    }

    /// Holds the expected interval against the mean of the measured ones.
    fn hold(&self, key: &str, [measured, _]: [f64; 2]) {
        let row = self.table.rows.iter().find(|row| row.key == key).unwrap();
        let ratio = row.width * self.spreads[0] / measured;
        println!("{} {key}: expected over measured {ratio:.3}", self.name);
        assert!((ratio - 1.0).abs() < 0.05, "{} {key}: {ratio}", self.name);
    }
}

#[test]
fn expected_intervals_are_those_of_simulated_measurements() {
    let few = [("model.positions", "6"), ("model.offsets", "4")];
    let files = simulated_oil_files(&shipped("e-drive"));
    let places = || (0..STRATA).map(|k| (k as f64 + 0.5) / STRATA as f64);
    // Part of the constants after the standard plan. The aims are .75 and .25. The first is missed by .21: on ground flanks the film
    // makes a quarter of the loss, and no traction curve states the boundary layer.
    let [many, few_curves] = SIMULATED;
    for (name, aim, count) in [
        ("e-drive", 0.97, few_curves),
        ("e-drive-superfinished", 0.25, many),
    ] {
        let case = with(name, &few);
        let tables = contacts(&case).unwrap();
        let expected = Expected::new(name, &tables, &case);
        let by_curves = mean_spreads(
            &tables,
            files[..count].iter().map(|file| naming(&case, file)),
        );
        expected.hold("traction-plan", by_curves);
        let ratio = by_curves[1] / expected.spreads[1];
        println!("{name}: part of the constants {ratio:.3} of the family's");
        assert!(ratio <= aim, "{name}: {ratio}");
        if name == "e-drive" {
            // Boundary friction of 0.09, measured with an error of 10 %.
            let by_curve = places().map(|place| {
                let found = 0.09 * (0.1 * standard_normal_quantile(place)).exp();
                let [low, high] = [-1.96, 1.96].map(|z: f64| found * (0.1 * z).exp());
                let band = format!("{{ value = {found}, low = {low}, high = {high} }}");
                case.with_key("calibration.boundary_friction", &band)
                    .unwrap()
            });
            expected.hold("stribeck-curve", mean_spreads(&tables, by_curve));
            // Lays as drawn, each measured.
            let by_scan = places().map(|place| {
                case.with_key("model.lay", &(place / 6.0).to_string())
                    .unwrap()
            });
            expected.hold("areal-scan", mean_spreads(&tables, by_scan));
        } else {
            let deviating = |case: &LoadedCase, by: &str| {
                case.with_key("operation.temperature_deviation", by)
                    .unwrap()
            };
            let by_probe = places().map(|place| {
                let celsius = 90.0 + 10.0 * standard_normal_quantile(place);
                let flanks = format!("{celsius} °C");
                let probed = case.with_key("operation.bulk_temperature", &flanks);
                deviating(&probed.unwrap(), "1 K")
            });
            let by_probe = mean_spreads(&tables, by_probe);
            let unsure = Expected::new(name, &tables, &deviating(&case, "10 K"));
            unsure.hold("thermocouple", by_probe);
        }
    }
}
