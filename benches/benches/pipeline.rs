//! Time of the main job: one position, and whole runs of the paper's Table 2 in both formulations.
use std::hint::black_box;
use std::path::Path;

use asperity::Run;
use asperity::case::{LoadedCase, load};
use asperity::contacts::dry_contact::dry_contact;
use asperity::formulation::FormulationChoice;
use asperity_benches::WORKSPACE;
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

fn one_position(criterion: &mut Criterion) {
    let loaded = case("table2.toml", FormulationChoice::default());
    let place = loaded.case.paper.position;
    criterion.bench_function("position/table2 dry contact of both flanks", |bencher| {
        bencher.iter(|| dry_contact(black_box(&loaded), place).expect("the contact is solved"));
    });
    let few = loaded.with(|input| {
        (input.model.positions, input.model.offsets) = (Some(2), Some(1));
    });
    let single = few.expect("the case is complete");
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
    targets = reading, one_position, whole_runs
}
criterion_main!(benches);
