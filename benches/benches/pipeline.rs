//! Time of the main job: one position, and whole runs of the paper's Table 2 in both formulations.
use std::hint::black_box;
use std::path::Path;

use asperity::Run;
use asperity::case::{FilmFrictionLaw, LoadShareName, LoadedCase, load};
use asperity::contacts::dry_contact::dry_contact;
use asperity::formulation::FormulationChoice;
use asperity_benches::WORKSPACE;
use asperity_gear::load_map::LoadLaw;
use criterion::{Criterion, criterion_group, criterion_main};

fn case(name: &str, formulation: FormulationChoice) -> LoadedCase {
    let path = Path::new(WORKSPACE).join("fixtures/cases").join(name);
    match load(&path, Some(formulation)) {
        Ok(loaded) => loaded,
        Err(error) => panic!("{error}"),
    }
}

fn whole_runs(criterion: &mut Criterion) {
    for (name, file, formulation) in [
        (
            "table2 corrected, 32 positions x 16 offsets",
            "table2.toml",
            FormulationChoice::default(),
        ),
        (
            "table2 paper, marching at one position",
            "table2.toml",
            asperity_paper_2022::register(),
        ),
        (
            "e-drive corrected, 32 positions x 16 offsets",
            "e-drive.toml",
            FormulationChoice::default(),
        ),
    ] {
        let loaded = case(file, formulation);
        criterion.bench_function(&format!("run/{name}"), |bencher| {
            bencher.iter(|| {
                Run::new(black_box(&loaded))
                    .execute()
                    .expect("the case runs")
            });
        });
    }
}

fn first_version(criterion: &mut Criterion) {
    let place = |loaded: &LoadedCase| loaded.case.model.position;
    let whole = of_the_first_version(case("table2.toml", FormulationChoice::default()));
    criterion.bench_function("first version's laws/dry contact", |bencher| {
        bencher.iter(|| dry_contact(black_box(&whole), place(&whole)).expect("it is solved"));
    });
    criterion.bench_function("first version's laws/whole run", |bencher| {
        bencher.iter(|| {
            Run::new(black_box(&whole))
                .execute()
                .expect("the case runs")
        });
    });
    let mut single = whole.clone();
    single.case.model.positions = 2;
    single.case.model.offsets = 1;
    criterion.bench_function("first version's laws/two positions", |bencher| {
        bencher.iter(|| {
            Run::new(black_box(&single))
                .execute()
                .expect("the case runs")
        });
    });
}

fn one_position(criterion: &mut Criterion) {
    let loaded = case("table2.toml", FormulationChoice::default());
    let place = loaded.case.model.position;
    criterion.bench_function("position/table2 dry contact of both flanks", |bencher| {
        bencher.iter(|| dry_contact(black_box(&loaded), place).expect("the contact is solved"));
    });
    let mut single = case("table2.toml", FormulationChoice::default());
    single.case.model.positions = 2;
    single.case.model.offsets = 1;
    criterion.bench_function(
        "position/table2 corrected, two positions, one offset, with fields",
        |bencher| {
            bencher.iter(|| {
                Run::new(black_box(&single))
                    .execute()
                    .expect("the case runs")
            });
        },
    );
}

/// `loaded` with the laws of the first version, to hold its times beside these.
fn of_the_first_version(mut loaded: LoadedCase) -> LoadedCase {
    let model = &mut loaded.case.model;
    model.positions = 32;
    model.load_distribution = LoadLaw::MeanLength;
    model.load_share = LoadShareName::LambdaStar;
    model.film_friction = FilmFrictionLaw::Xu;
    loaded
}

fn reading(criterion: &mut Criterion) {
    criterion.bench_function(
        "case/table2 read, resolved, traces read and prepared",
        |bencher| {
            bencher.iter(|| case("table2.toml", FormulationChoice::default()));
        },
    );
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = reading, one_position, whole_runs, first_version
}
criterion_main!(benches);
