//! Models that records or measurements contradict: a table has their losses, no draw has them.

use asperity_core::cite;
use asperity_mixed_film::SpotSpeed;
use asperity_oil::PressureLaw;

use super::evaluations::{Nominal, Path};
use crate::result::AlternativeRow;
use asperity_case::case::{LoadShareName, LoadedCase};

/// A model: its name, the case changed to it, and the measurement that refutes it.
pub(super) struct OtherModel {
    pub name: &'static str,
    pub case: LoadedCase,
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
const DRY_REFUTED: &str = "superfinishing would save 50 to 57 %, measured pairs 15 to 35 % (gate T3 of VALIDATION.md); asperity share 0.07 to \
    0.25 above records of mixed lubrication";

/// Films of the spots, with their numbers in docs/records/ehl-friction-parts.md.
const SPEEDS: [(&str, SpotSpeed, &str); 2] = [
    (
        "spots with the film of the inlet",
        SpotSpeed::Entrainment,
        "ln friction 0.14 below 85 records of mixed lubrication, by the model 0.01",
    ),
    (
        "spots with the film of half the sliding speed",
        SpotSpeed::HalfSliding,
        "scatter of ln friction over 85 records of mixed lubrication 0.095, of the model 0.052",
    ),
];
/// Slope of the change by the step rule: .24 to .44 of the share of the reference in 21 records.
const STEP_RULE: f64 = 0.27;

/// Change of the loss \[W\] by the whole boundary friction on all films below h_b, instead of a share that falls with the film.
///
/// ```text
/// D = 0.27 φ (μ_b − μ_film) H_V P_in ≥ 0                                       [Step-rule]
/// ```
fn step_rule(share: f64, [boundary, film]: [f64; 2], loss_factor_w: f64) -> f64 {
    cite!("Step-rule");
    STEP_RULE * share * (boundary - film).max(0.0) * loss_factor_w
}

/// Models whose loss follows from the run.
pub(super) fn by_formula(loaded: &LoadedCase, nominal: &Nominal<'_>) -> Vec<AlternativeRow> {
    /// s from which losses by the model were taken to be too high, and the slope of their logarithm over it.
    const BIAS: [f64; 2] = [2.1, 0.16];
    let case = &loaded.case;
    let (path, s) = (Path::of(nominal.path), nominal.summary);
    let rough = path.roughness_over_film.filter(|_| is_solved(loaded));
    let Some(over_film) = rough.filter(|_| path.asperity_share > 0.0) else {
        return Vec::new();
    };
    let friction = [case.model.boundary_friction, path.film_friction];
    let step = step_rule(
        path.asperity_share,
        friction,
        s.loss_factor_local * s.power_in_w,
    );
    let row = |name: &str, loss_w: f64, refuted_by: &str| AlternativeRow {
        name: name.to_owned(),
        loss_w: Some(loss_w),
        refuted_by: refuted_by.to_owned(),
    };
    let mut found = vec![row(
        "step rule of the boundary layer",
        s.loss_w + step,
        "boundary part of 52 records of mixed lubrication 1.09 of that of the model without it",
    )];
    let bias = BIAS[1] * (over_film - BIAS[0]).max(0.0);
    if bias > 0.0 {
        found.push(row(
            "loss lowered where ridges cannot leak",
            s.loss_w + s.sliding_w * ((-bias).exp() - 1.0),
            "mean of ln friction over 85 records of mixed lubrication -0.01 without it",
        ));
    }
    found
}

/// Whether solved contacts give the share of the asperities.
fn is_solved(loaded: &LoadedCase) -> bool {
    loaded.case.laws.load_share.is_none()
        && loaded.case.model.load_share == LoadShareName::Solved
        && loaded.surfaces.are_measured()
}

/// Every other model that changes something of the case.
pub(super) fn other_models(loaded: &LoadedCase) -> Vec<OtherModel> {
    let case = &loaded.case;
    let own = &case.laws;
    let mut found = Vec::new();
    if is_solved(loaded) {
        for (name, spot_speed, refuted_by) in SPEEDS {
            if case.model.spot_speed != spot_speed {
                let mut other = loaded.clone();
                other.case.model.spot_speed = spot_speed;
                found.push(OtherModel {
                    name,
                    case: other,
                    refuted_by,
                });
            }
        }
        let mut half = loaded.clone();
        half.case.model.asperity_share_factor *= 0.5;
        found.push(OtherModel {
            name: "asperity share halved",
            case: half,
            refuted_by: "asperity share 0.14 below records of mixed lubrication",
        });
        for (name, law) in DRY {
            let mut dry = loaded.clone();
            dry.case.model.load_share = law;
            found.push(OtherModel {
                name,
                case: dry,
                refuted_by: DRY_REFUTED,
            });
        }
    }
    let shear = case.model.film_friction.shear_law();
    // The constants of an oil file belong to the law of their fit.
    let is_barus = case.model.film_pressure_law == PressureLaw::Barus && case.oil_file.is_none();
    if let (Some(rheology), Some(shear), true, true) =
        (&case.rheology, shear, is_barus, own.friction.is_none())
    {
        let mut roelands = loaded.clone();
        roelands.case.model.film_pressure_law = PressureLaw::Roelands;
        roelands.case.rheology = Some(rheology.clone().with_laws(shear, PressureLaw::Roelands));
        found.push(OtherModel {
            name: "viscosity by Roelands in the film",
            case: roelands,
            refuted_by: "losses of superfinished gears -72 % at 2000 1/min and -52 % at 8000 1/min (gate T2 of VALIDATION.md)",
        });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_with_a_step_adds_its_share() {
        // 0.27·0.2·(0.09 − 0.04)·1000 W.
        assert!((step_rule(0.2, [0.09, 0.04], 1000.0) - 2.7).abs() < 1e-12);
        assert_eq!(step_rule(0.2, [0.03, 0.04], 1000.0), 0.0);
    }
}
