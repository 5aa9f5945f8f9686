//! A result names the equations that ran, and no other.

use asperity::pipeline::Kept;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::case::{
    Case, CaseInput, FilmFrictionInput, LoadShareName, LoadedCase, load, load_with,
};
use asperity::core::quantity::LineLoad;
use asperity::formulation::FormulationChoice;
use asperity::laws::Laws;
use asperity::oil::ShearLawName;
use asperity::result::{EquationUse, MeshOutcome};
use asperity_ehl_regime::{FilmLaw, LoadShareLaw, ThermalLaw};
use asperity_gear::{GearError, LoadConditions, LoadDistribution, LoadLaw, LoadMap};
use asperity_tribo_friction::FrictionLaw;

const CASES: [&str; 4] = ["e-drive", "e-drive-superfinished", "fzg-c", "table2"];

/// Equations of the film laws, of which each run uses those of one.
const FILM: [(FilmLaw, &[&str]); 5] = [
    (
        FilmLaw::Steady,
        &[
            "Steady-film",
            "Moes-numbers",
            "Dowson-Toyoda",
            "Dowson-Higginson",
        ],
    ),
    (
        FilmLaw::DowsonToyoda,
        &["Dowson-Toyoda", "Dowson-Higginson"],
    ),
    (FilmLaw::Moes, &["Moes", "Dowson-Higginson"]),
    (FilmLaw::ErtelGrubin, &["Ertel-Grubin", "Dowson-Higginson"]),
    (FilmLaw::HamrockDowson, &["P13", "P14"]),
];
const THERMAL: [(ThermalLaw, &[&str]); 2] =
    [(ThermalLaw::Gupta, &["P10"]), (ThermalLaw::None, &[])];
static FRICTION: [(FilmFrictionInput, &[&str]); 7] = [
    (
        FilmFrictionInput::Film(ShearLawName::Eyring),
        &["Film-friction", "Surface-heat"],
    ),
    (FilmFrictionInput::Published(FrictionLaw::Xu), &["P7"]),
    (
        FilmFrictionInput::Published(FrictionLaw::BenedictKelley),
        &["Benedict-Kelley"],
    ),
    (
        FilmFrictionInput::Published(FrictionLaw::Iso14179Part2),
        &["Schlenk"],
    ),
    (
        FilmFrictionInput::Published(FrictionLaw::Doleschel),
        &["Doleschel", "Doleschel-share", "Eyring"],
    ),
    (
        FilmFrictionInput::Published(FrictionLaw::Matsumoto),
        &["Matsumoto", "Matsumoto-share", "Eyring"],
    ),
    (
        FilmFrictionInput::Published(FrictionLaw::Eyring),
        &["Eyring"],
    ),
];
const SHARE: [(LoadShareName, &[&str]); 3] = [
    (LoadShareName::LambdaStar, &["Film-share"]),
    (LoadShareName::ZhuHu, &["Zhu-Hu"]),
    (LoadShareName::MasjediKhonsari, &["Masjedi-Khonsari"]),
];

/// A shipped case with few positions and offsets.
fn shipped(name: &str, formulation: FormulationChoice) -> LoadedCase {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases");
    let few = |input: &mut CaseInput| {
        input.formulation = Some(formulation);
        if formulation == FormulationChoice::default() {
            (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        }
    };
    load_with(&folder.join(format!("{name}.toml")), &few).unwrap()
}

/// Tags as their rows have them.
fn tags(equations: &[EquationUse]) -> BTreeSet<&'static str> {
    let rows = equations
        .iter()
        .map(|used| asperity::equations::find(&used.tag).unwrap());
    rows.map(|equation| equation.tag).collect()
}

fn used(loaded: &LoadedCase) -> BTreeSet<&'static str> {
    tags(
        &asperity::Run::new(loaded)
            .execute()
            .unwrap()
            .into_only()
            .unwrap()
            .result
            .equations,
    )
}

/// Every shipped case in both formulations with its run, made once.
fn runs() -> &'static [(&'static str, LoadedCase, MeshOutcome)] {
    static RUNS: OnceLock<Vec<(&str, LoadedCase, MeshOutcome)>> = OnceLock::new();
    RUNS.get_or_init(|| {
        let both = [
            FormulationChoice::default(),
            asperity_paper_2022::register(),
        ];
        let of = |name| {
            both.map(|formulation| {
                let loaded = shipped(name, formulation);
                let run = asperity::Run::new(&loaded)
                    .execute()
                    .unwrap()
                    .into_only()
                    .unwrap();
                (name, loaded, run)
            })
        };
        CASES.into_iter().flat_map(of).collect()
    })
}

/// Tags of losses with `change` made to the case.
fn used_by_losses(
    loaded: &LoadedCase,
    change: impl FnOnce(&mut CaseInput),
) -> BTreeSet<&'static str> {
    let loaded = loaded.with(change).unwrap();
    tags(&asperity_tests::losses(&loaded).unwrap().equations)
}

/// Of all tags of `laws` those of the law in use are named, and no other.
fn assert_only<L: PartialEq + std::fmt::Debug>(
    what: &str,
    tags: &BTreeSet<&str>,
    laws: &[(L, &[&'static str])],
    chosen: &L,
) {
    let all: BTreeSet<&str> = laws.iter().flat_map(|law| law.1).copied().collect();
    let (_, expected) = laws.iter().find(|law| law.0 == *chosen).unwrap();
    let named: BTreeSet<&str> = tags.intersection(&all).copied().collect();
    let expected: BTreeSet<&str> = expected.iter().copied().collect();
    assert_eq!(named, expected, "{what} {chosen:?}");
}

/// The tags without the film law of the touching spots, which every solved load share takes.
fn without_spots(tags: &BTreeSet<&'static str>, case: &Case) -> BTreeSet<&'static str> {
    let solves = case.share_law().contact().is_some();
    let is_of_spots = |tag: &str| solves && case.model.film != FilmLaw::Moes && tag == "Moes";
    let others = tags.iter().filter(|tag| !is_of_spots(tag));
    others.copied().collect()
}

#[test]
fn a_run_names_the_laws_that_it_uses_and_not_the_others() {
    for (name, loaded, run) in runs() {
        let (tags, model) = (tags(&run.result.equations), &loaded.case.model);
        assert_only(
            name,
            &without_spots(&tags, &loaded.case),
            &FILM,
            &model.film,
        );
        assert_only(name, &tags, &THERMAL, &model.thermal);
        assert_only(name, &tags, &FRICTION, &model.film_friction);
        let formulation = loaded.case.formulation;
        let printed = formulation == asperity_paper_2022::register();
        assert_eq!(tags.contains("P19"), printed, "{name} {formulation:?}");
        for always in ["E-star", "Hertz-1", "P8", "P11", "P17", "P18", "P20", "P21"] {
            assert!(tags.contains(always), "{name} {formulation:?}: {always}");
        }
        // The traces were filtered and the oil described before the run.
        for prepared in ["Gauss-4", "Rk-1", "Prep-1"] {
            assert!(tags.contains(prepared), "{name}: {prepared}");
        }
    }
}

#[test]
fn only_a_rough_contact_names_the_equations_of_plastic_flow() {
    let touching = shipped("e-drive", FormulationChoice::default());
    assert!(used(&touching).contains("Plastic-1"));
    let by_parameters =
        |input: &mut CaseInput| input.model.load_share = Some(LoadShareName::LambdaStar);
    assert!(!used_by_losses(&touching, by_parameters).contains("Plastic-1"));
}

#[test]
fn another_law_changes_its_own_equations_alone() {
    let loaded = shipped("e-drive", FormulationChoice::default());
    // Laws that add nothing of the rough contact.
    let loaded = loaded.with(|input| {
        input.model.film_friction = Some(FrictionLaw::Xu.into());
        input.model.load_share = Some(LoadShareName::LambdaStar);
    });
    let loaded = loaded.unwrap();
    let changed = |change: &dyn Fn(&mut CaseInput)| used_by_losses(&loaded, change);
    let differ = |a: &BTreeSet<&'static str>, b: &BTreeSet<&'static str>| -> BTreeSet<&str> {
        a.symmetric_difference(b).copied().collect()
    };
    let own = |a: &[&'static str], b: &[&'static str]| -> BTreeSet<&str> {
        let (a, b): (BTreeSet<_>, BTreeSet<_>) = (a.iter().collect(), b.iter().collect());
        a.symmetric_difference(&b).map(|tag| **tag).collect()
    };
    let film: Vec<_> = FILM
        .iter()
        .map(|law| changed(&|input| input.model.film = Some(law.0)))
        .collect();
    let friction: Vec<_> = FRICTION
        .iter()
        .map(|law| changed(&|input| input.model.film_friction = Some(law.0.clone())))
        .collect();
    let thermal: Vec<_> = THERMAL
        .iter()
        .map(|law| changed(&|input| input.model.thermal = Some(law.0)))
        .collect();
    let share: Vec<_> = SHARE
        .iter()
        .map(|law| changed(&|input| input.model.load_share = Some(law.0)))
        .collect();
    // The first is a film alone with more tags than its own.
    for k in 2..FRICTION.len() {
        assert_eq!(
            differ(&friction[1], &friction[k]),
            own(FRICTION[1].1, FRICTION[k].1)
        );
    }
    for k in 1..4 {
        // All four are line contacts with the same groups.
        assert_eq!(differ(&film[0], &film[k]), own(FILM[0].1, FILM[k].1));
    }
    for k in 1..THERMAL.len() {
        let difference = differ(&thermal[0], &thermal[k]);
        assert_eq!(difference, own(THERMAL[0].1, THERMAL[k].1));
    }
    for k in 1..SHARE.len() {
        assert_eq!(differ(&share[0], &share[k]), own(SHARE[0].1, SHARE[k].1));
    }
}

#[test]
fn losses_contacts_and_a_whole_run_agree_to_the_last_digit() {
    for (name, loaded, whole) in runs() {
        let contacts = asperity::Run::new(loaded)
            .pictures(Kept::NoPictures)
            .execute();
        let contacts = contacts.unwrap().into_only().unwrap();
        let losses = asperity_tests::losses(loaded).unwrap();
        assert_eq!(whole.offsets, contacts.offsets, "{name}");
        assert_eq!(whole.offsets, losses.offsets, "{name}");
        assert_eq!(whole.result.summary, contacts.result.summary, "{name}");
        assert_eq!(whole.result.running_in, contacts.result.running_in);
        assert!(contacts.fields.is_empty());
        let (a, b) = (&whole.result.summary, &losses.summary);
        assert_eq!((a.efficiency, a.loss_w), (b.efficiency, b.loss_w), "{name}");
        for (a, b) in whole.result.path.iter().zip(&losses.path) {
            assert_eq!((a.mu, a.flash_k), (b.mu, b.flash_k), "{name}");
            assert_eq!(a.lambda_star, b.lambda_star, "{name}");
        }
    }
}

#[test]
fn a_law_given_by_hand_is_the_law_named() {
    let named = |change: &dyn Fn(&mut CaseInput)| {
        let loaded = shipped("e-drive", FormulationChoice::default());
        asperity_tests::losses(&loaded.with(change).unwrap()).unwrap()
    };
    let own = |change: &dyn Fn(&mut Laws)| {
        let loaded = shipped("e-drive", FormulationChoice::default());
        asperity_tests::losses(&loaded.with_laws(change)).unwrap()
    };
    let plain = named(&|_| ());
    let film = named(&|input| input.model.film = Some(FilmLaw::Moes));
    let share = named(&|input| input.model.load_share = Some(LoadShareName::ZhuHu));
    assert_ne!(plain.offsets, film.offsets);
    assert_ne!(plain.offsets, share.offsets);
    let by_hand = own(&|laws| laws.film = Some(Arc::new(FilmLaw::Moes)));
    assert_eq!(film.offsets, by_hand.offsets);
    let by_hand = own(&|laws| laws.load_share = Some(Arc::new(LoadShareLaw::ZhuHu)));
    assert_eq!(share.offsets, by_hand.offsets);
    let law = LoadLaw::MinPotential;
    let sharing = |laws: &mut Laws| laws.load_distribution = Some(Arc::new(law.clone()));
    let map = named(&|input| input.model.load_distribution = Some(law.clone()));
    assert_ne!(plain.offsets, map.offsets);
    assert_eq!(map.offsets, own(&sharing).offsets);
}

/// A load distribution without load.
#[derive(Debug)]
struct Unloaded;

impl LoadDistribution for Unloaded {
    fn name(&self) -> &str {
        "unloaded"
    }

    fn load_map(&self, mesh: &LoadConditions<'_>) -> Result<LoadMap, GearError> {
        LoadMap::of_line_loads(mesh, |places| {
            Ok(vec![LineLoad::from_si(0.0); places.len()])
        })
    }
}

#[test]
fn a_load_distribution_without_load_is_refused_by_its_name() {
    let loaded = shipped("e-drive", FormulationChoice::default());
    let loaded = loaded.with_laws(|laws| laws.load_distribution = Some(Arc::new(Unloaded)));
    let refused = asperity_tests::losses(&loaded).unwrap_err();
    let says = "the load distribution \"unloaded\" returns no load at any position";
    assert!(refused.to_string().contains(says), "{refused}");
    assert_eq!(refused.code(), "E305");
}

#[test]
fn the_fingerprint_of_a_case_includes_its_user_defined_laws() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let loaded = load(&file, None).unwrap();
    let with = |change: &dyn Fn(&mut Laws)| {
        let loaded = loaded.with_laws(change);
        // A changed case keeps the laws.
        let hotter = loaded
            .with_key("operation.bulk_temperature", "91 °C")
            .unwrap();
        assert_ne!(loaded.fingerprint(), hotter.fingerprint());
        let back = hotter
            .with_key("operation.bulk_temperature", "90 °C")
            .unwrap();
        assert_eq!(loaded.fingerprint(), back.fingerprint());
        loaded.fingerprint()
    };
    let friction = loaded.at_stated().unwrap().film_friction();
    let laws: [&dyn Fn(&mut Laws); 6] = [
        &|_| (),
        &|laws| laws.film = Some(Arc::new(FilmLaw::Moes)),
        &|laws| laws.film = Some(Arc::new(FilmLaw::HamrockDowson)),
        &|laws| laws.friction = Some(Arc::clone(&friction)),
        &|laws| laws.load_share = Some(Arc::new(LoadShareLaw::ZhuHu)),
        &|laws| laws.load_distribution = Some(Arc::new(LoadLaw::MinPotential)),
    ];
    let distinct: BTreeSet<String> = laws.iter().map(|change| with(*change)).collect();
    assert_eq!(distinct.len(), laws.len());
}

#[test]
fn the_spacing_of_the_traces_is_named_also_of_a_changed_case() {
    for (name, _, outcome) in runs() {
        let used = tags(&outcome.result.equations);
        assert!(used.contains("Common-spacing"), "{name}");
    }
    // Cases are changed in one way.
    let mut of_stated_bulk = runs()
        .iter()
        .filter(|(_, loaded, _)| loaded.case.bulk.is_none());
    let (name, loaded, _) = of_stated_bulk.next().unwrap();
    let hotter = loaded
        .with_key("operation.bulk_temperature", "91 °C")
        .unwrap();
    let used = tags(&asperity_tests::losses(&hotter).unwrap().equations);
    assert!(used.contains("Common-spacing"), "{name}");
}
