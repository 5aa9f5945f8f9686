//! Intervals of the shipped drive with the constants of the film friction from simulated traction curves.

use std::fmt::Write as _;
use std::sync::OnceLock;

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase};
use asperity::core::quantity::Length;
use asperity_calibration::oil::fit::PointErrors;
use asperity_calibration::oil::problem::Zero;
use asperity_calibration::oil::{ConstantsOf, FitSettings, Machine, OilBase, OilFit, read_table};

use crate::band::Banded;
use crate::load_share::shipped;

/// 120 points at 40, 80 and 120 °C, 20 and 60 N, 1 and 3 m/s, simulated with 2.5 % and 0.001 of scatter.
const CURVES: &str = include_str!("../../crates/calibration/tests/golden/traction_e_fluid.csv");

/// The oil file of the curves with the oil of a case: as simulated, or without scatter and with the default errors of points.
fn oil_file(case: &LoadedCase, is_scattered: bool) -> String {
    let oil = OilBase::of_case(&case.case, ConstantsOf::Family).unwrap();
    let length = Length::from_si;
    let machine = Machine::ball_on_disc(length(9.525e-3), None, length(15e-9)).unwrap();
    let mut readings = read_table("curves.csv", CURVES, &machine).unwrap();
    let mut errors = PointErrors {
        relative: 0.025,
        floor: 1e-3,
    };
    if !is_scattered {
        errors = PointErrors::default();
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
    let fit = OilFit::of(&oil, &readings, Vec::new(), settings).unwrap();
    fit.oil_file().unwrap().to_string()
}

/// A shipped case with the constants of the family of its oil, and with those of the curves, scattered and not.
fn runs(name: &str) -> [Banded; 3] {
    let by_family = shipped(name);
    let fitted = [true, false].map(|is_scattered| {
        let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
        std::fs::write(file.path(), oil_file(&by_family, is_scattered)).unwrap();
        let named = |input: &mut CaseInput| input.lubricant.oil_file = Some(file.path().to_owned());
        by_family.with(named).unwrap()
    });
    let [scattered, precise] = fitted;
    [by_family, scattered, precise].map(|case| {
        let (outcome, drawn) = Run::new(&case).draw().unwrap();
        let result = outcome.result;
        (result.summary, result.uncertainty.unwrap(), drawn.unwrap())
    })
}

/// The cases with the limits of the ratio of standard deviations, by scattered curves and by precise ones.
const CASES: [(&str, &str, [f64; 2]); 2] = [
    ("ground", "e-drive", [0.78, 0.78]),
    ("superfinished", "e-drive-superfinished", [0.27, 0.25]),
];

fn all() -> &'static [[Banded; 3]; 2] {
    static ALL: OnceLock<[[Banded; 3]; 2]> = OnceLock::new();
    ALL.get_or_init(|| CASES.map(|(_, case, _)| runs(case)))
}

/// The table of docs/VALIDATION.md.
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
            let [low, high] = loss.quantiles_w;
            let sd = banded.2.sd_of_constants();
            let [left, law] =
                [&UNSTATED[..], &["error of the film law"]].map(|names| part(banded, names));
            let _ = writeln!(
                text,
                "| {name} | {by} | {:.0} ({low:.0} to {high:.0}) | {sd:.3} | {:.2} | {left:.3} | {law:.3} |",
                loss.median_w,
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
                let [low, high] = banded.1.loss.quantiles_w;
                high / low
            };
            assert!(width(fitted) < width(family), "{name}");
        }
    }
}
