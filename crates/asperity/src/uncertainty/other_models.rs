//! Models that records or measurements contradict: a table has their losses, no draw has them.

use asperity_core::cite;
use asperity_mixed_film::SpotSpeed;
use asperity_oil::PressureLaw;

use super::evaluations::{Nominal, PathLosses};
use crate::result::AlternativeRow;
use asperity_case::case::{Alternative, LoadShareName, OperatingCase, ShareLaw};
use asperity_case::error::Error;

/// A model: its name, the case changed to it, and the measurement that refutes it.
pub(super) struct OtherModel {
    pub name: &'static str,
    pub case: OperatingCase,
    pub refuted_by: &'static str,
}

/// Laws that share the load and rub with the boundary coefficient on all asperities.
const DRY: [(&str, LoadShareName); 3] = [
    (
        "load share by Lambda*, dry asperities",
        LoadShareName::LambdaStar,
    ),
    (
        "load share by Zhu and Hu, dry asperities",
        LoadShareName::ZhuHu,
    ),
    (
        "load share by Masjedi and Khonsari, dry asperities",
        LoadShareName::MasjediKhonsari,
    ),
];
const DRY_REFUTED: &str = "superfinishing the example drive would save 47 to 53 %; measured on other pairs: 15 to 35 %; by the default: 36 %";

/// Films of the spots, with their numbers in `tests/golden/evidence/ehl-models.csv`.
const SPEEDS: [(&str, SpotSpeed, &str); 2] = [
    (
        "asperity contacts with the film of the inlet",
        SpotSpeed::Entrainment,
        "ln friction is 0.12 below 85 reference solutions; by the default 0.00 above",
    ),
    (
        "asperity contacts with the film of half the sliding speed",
        SpotSpeed::HalfSliding,
        "ln friction scatters by 0.101 about 85 reference solutions; by the default by 0.061",
    ),
];
const HALVED: &str =
    "asperity share is 0.09 below 74 reference solutions; by the default 0.01 above";
/// Slope of the change by the step rule: the sum of the changes over the sum of φ (μ_b − μ_film), of records with s below 3 and a
/// share φ above 2 %; 0.08 to 0.20 in eight of ten.
const STEP_RULE: f64 = 0.12;
const STEP_EVIDENCE: &str =
    "reference solutions do not exclude it: by it their own friction is 4 % higher in the mean";

/// Change of the loss \[W\] by the whole boundary friction on all films below 20 nm, instead of a share that falls with the film.
///
/// ```text
/// D = 0.12 φ (μ_b − μ_film) H_V P_in ≥ 0                                       [Step-rule]
/// ```
fn step_rule(share: f64, [boundary, film]: [f64; 2], loss_factor_w: f64) -> f64 {
    cite!("Step-rule");
    STEP_RULE * share * (boundary - film).max(0.0) * loss_factor_w
}

/// Change of the loss of a run by the step rule \[W\].
pub(super) fn step_rule_of(loaded: &OperatingCase, nominal: &Nominal<'_>) -> f64 {
    let (path, s) = (PathLosses::from_rows(nominal.path), nominal.summary);
    let friction = [loaded.case.model.boundary_friction, path.film_friction];
    step_rule(
        path.asperity_share,
        friction,
        s.loss_factor_local * s.power_in_w,
    )
}

/// Models whose loss follows from the run.
pub(super) fn by_formula(loaded: &OperatingCase, nominal: &Nominal<'_>) -> Vec<AlternativeRow> {
    /// s from which losses by the model were taken to be too high, and the slope of their logarithm over it.
    const BIAS: [f64; 2] = [2.1, 0.16];
    let (path, s) = (PathLosses::from_rows(nominal.path), nominal.summary);
    let rough = path.roughness_over_film.filter(|_| is_solved(loaded));
    let Some(over_film) = rough.filter(|_| path.asperity_share > 0.0) else {
        return Vec::new();
    };
    let row = |name: &str, loss_w: f64, refuted_by: &str| AlternativeRow {
        name: name.to_owned(),
        loss_w: Some(loss_w),
        refuted_by: refuted_by.to_owned(),
    };
    let mut found = vec![row(
        "step rule of the boundary layer",
        s.loss_w + step_rule_of(loaded, nominal),
        STEP_EVIDENCE,
    )];
    let bias = BIAS[1] * (over_film - BIAS[0]).max(0.0);
    if bias > 0.0 {
        found.push(row(
            "loss lowered where ridges cannot leak",
            s.loss_w + s.sliding_w * ((-bias).exp() - 1.0),
            "mean of ln friction over 85 reference solutions -0.01 without it",
        ));
    }
    found
}

/// Whether solved contacts give the share of the asperities.
fn is_solved(loaded: &OperatingCase) -> bool {
    matches!(loaded.case.share_law(), ShareLaw::Solved(_)) && loaded.surfaces.are_measured()
}

/// Every other model that changes something of the case.
pub(super) fn other_models(loaded: &OperatingCase) -> Result<Vec<OtherModel>, Error> {
    let case = &loaded.case;
    let own = &case.laws;
    let mut found = Vec::new();
    // Another model of the film would be another set of records.
    if matches!(case.share_law(), ShareLaw::Reference) {
        return Ok(found);
    }
    let mut add = |name, alternative, refuted_by| -> Result<(), Error> {
        found.push(OtherModel {
            name,
            case: loaded.overridden(|over| over.alternative = Some(alternative))?,
            refuted_by,
        });
        Ok(())
    };
    if is_solved(loaded) {
        for (name, spot_speed, refuted_by) in SPEEDS {
            add(name, Alternative::SpotSpeed(spot_speed), refuted_by)?;
        }
        add(
            "asperity share halved",
            Alternative::AsperityShareTimes(0.5),
            HALVED,
        )?;
        for (name, law) in DRY {
            add(name, Alternative::LoadShare(law), DRY_REFUTED)?;
        }
    }
    let shear = case.model.film_friction.shear_law();
    // The constants of an oil file belong to the law of their fit.
    let is_barus = case.model.film_pressure_law == PressureLaw::Barus && case.oil_file.is_none();
    let is_sheared = loaded.rheology().is_some() && shear.is_some();
    if is_sheared && is_barus && own.friction.is_none() {
        add(
            "viscosity by Roelands in the film",
            Alternative::FilmPressure(PressureLaw::Roelands),
            "losses of superfinished gears -72 % at 2000 1/min and -52 % at 8000 1/min",
        )?;
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::path::Path;

    use super::*;
    use crate::pipeline::losses;
    use asperity_case::case::load;

    /// Rows of a table of records by their condition and model, each a number by its column.
    fn rows(table: &str) -> BTreeMap<[String; 2], BTreeMap<String, f64>> {
        let file = Path::new("../../fixtures/records").join(table);
        let text = asperity_storage::whole_text(&file, 1_000_000).unwrap();
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let head: Vec<&str> = lines.next().unwrap().split(',').collect();
        let row = |line: &str| {
            let cells: BTreeMap<&str, &str> = head.iter().copied().zip(line.split(',')).collect();
            let name = |column: &str| (*cells.get(column).unwrap_or(&"")).to_owned();
            let number =
                |(column, cell): (&&str, &&str)| Some(((*column).to_owned(), cell.parse().ok()?));
            let numbers = cells.iter().filter_map(number).collect();
            ([name("condition"), name("model")], numbers)
        };
        lines.map(row).collect()
    }

    /// The 93 records.
    fn records() -> BTreeMap<String, BTreeMap<String, f64>> {
        let both = [rows("gear_meshes.csv"), rows("blind.csv")];
        let named = both.into_iter().flatten();
        named.map(|([name, _], row)| (name, row)).collect()
    }

    fn mean_and_deviation(values: &[f64]) -> [f64; 2] {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares = values.iter().map(|value| (value - mean).powi(2));
        [
            mean,
            (squares.sum::<f64>() / (values.len() - 1) as f64).sqrt(),
        ]
    }

    #[test]
    fn a_rule_with_a_step_adds_its_share() {
        // 0.12·0.2·(0.09 − 0.04)·1000 W.
        assert!((step_rule(0.2, [0.09, 0.04], 1000.0) - 1.2).abs() < 1e-12);
        assert_eq!(step_rule(0.2, [0.03, 0.04], 1000.0), 0.0);
    }

    #[test]
    fn the_slope_of_the_step_rule_is_that_of_the_records() {
        const BOUNDARY_FRICTION: f64 = 0.08;
        let judged = |row: &&BTreeMap<String, f64>| {
            row["below_20_nm"] > 0.02 && row["roughness_over_film"] < 3.0
        };
        let (mut changes, mut shares, mut rises) = (0.0, 0.0, Vec::new());
        for row in records().values().filter(judged) {
            changes += row["stepped"] - row["friction"];
            shares += row["below_20_nm"] * (BOUNDARY_FRICTION - row["film_friction"]);
            rises.push(row["stepped"] / row["friction"] - 1.0);
        }
        assert_eq!(
            format!("{:.2}", changes / shares),
            format!("{STEP_RULE:.2}")
        );
        let [mean, _] = mean_and_deviation(&rises);
        assert!(STEP_EVIDENCE.contains(&format!(" {:.0} % higher", 100.0 * mean)));
    }

    #[test]
    fn the_evidence_against_a_model_is_that_of_the_records() {
        let (records, windows) = (records(), rows("film_64_windows.csv"));
        let of = |name: &str, model: &str| windows.get(&[name.to_owned(), model.to_owned()]);
        let is_judged =
            |name: &str| of(name, "default").is_some_and(|row| row["roughness_over_film"] < 3.0);
        let friction = |model: &str| {
            let judged = records.iter().filter(|(name, _)| is_judged(name));
            let errors = judged.filter_map(|(name, row)| {
                Some((of(name, model)?["friction"] / row["hot_friction"]).ln())
            });
            let errors: Vec<f64> = errors.collect();
            (errors.len(), mean_and_deviation(&errors))
        };
        let (count, [default, scatter]) = friction("default");
        let (_, [inlet, _]) = friction("inlet spots");
        let (_, [_, half_sliding]) = friction("half-sliding spots");
        let expected = [
            format!(
                "ln friction is {:.2} below {count} reference solutions; by the default {default:.2} above",
                -inlet
            ),
            format!(
                "ln friction scatters by {half_sliding:.3} about {count} reference solutions; by the default by {scatter:.3}"
            ),
        ];
        assert_eq!(SPEEDS.map(|(_, _, evidence)| evidence.to_owned()), expected);
        let shares = records.iter().filter(|(name, _)| is_judged(name));
        let shares = shares.filter_map(|(name, row)| {
            let [low, high] = ["below_20_nm", "below_50_nm"].map(|column| row[column]);
            let share = of(name, "default")?["asperity_share"];
            (high - low <= 0.15).then_some([share, 0.5 * (low + high)])
        });
        let shares: Vec<[f64; 2]> = shares.collect();
        let over = |factor: f64| {
            let errors = shares.iter().map(|[fast, record]| factor * fast - record);
            mean_and_deviation(&errors.collect::<Vec<_>>())[0]
        };
        let expected = format!(
            "asperity share is {:.2} below {} reference solutions; by the default {:.2} above",
            -over(0.5),
            shares.len(),
            over(1.0)
        );
        assert_eq!(HALVED, expected);
    }

    #[test]
    fn dry_laws_save_more_than_was_measured() {
        let saving = |law: LoadShareName| {
            let loss = |case: &str| {
                let file = Path::new("../../fixtures/cases").join(case);
                let loaded = load(&file, None).unwrap();
                let by_law = Some(Alternative::LoadShare(law));
                let other = loaded.overridden(|over| over.alternative = by_law);
                losses(&other.unwrap()).unwrap().summary.loss_w
            };
            100.0 * (1.0 - loss("e-drive-superfinished.toml") / loss("e-drive.toml"))
        };
        /// The largest saving that was measured on another pair, in percent.
        const MEASURED: f64 = 35.0;
        let default = saving(LoadShareName::Solved).round();
        let savings = DRY.map(|(_, law)| saving(law).round());
        let least = savings.iter().fold(f64::INFINITY, |a, b| a.min(*b));
        let most = savings.iter().fold(0.0, |a: f64, b| a.max(*b));
        let expected = format!(
            "superfinishing the example drive would save {least} to {most} %; measured on other pairs: 15 to {MEASURED} %; by the \
             default: {default} %"
        );
        assert!(least > MEASURED, "{least}");
        assert_eq!(DRY_REFUTED, expected);
    }
}
