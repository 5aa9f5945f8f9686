//! Models that measurements refute: a table has their losses, no draw has them.

use asperity_oil::PressureLaw;

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

/// Every other model that changes something of the case.
pub(super) fn other_models(loaded: &LoadedCase) -> Vec<OtherModel> {
    let case = &loaded.case;
    let own = &case.laws;
    let mut found = Vec::new();
    let is_solved = own.load_share.is_none()
        && case.model.load_share == LoadShareName::Solved
        && loaded.surfaces.are_measured();
    if is_solved {
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
