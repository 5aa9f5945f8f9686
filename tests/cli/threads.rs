//! The same result to the last byte on any number of threads.

use std::fs;
use std::path::Path;

use crate::bench::{Bench, E_DRIVE, root};

#[test]
fn every_shipped_case_gives_the_same_result_on_one_thread_and_on_two() {
    let bench = Bench::new();
    // One case chooses its offsets, the others have few: more would be more of the same.
    let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
    for (name, more) in [
        ("e-drive", &few[..]),
        ("e-drive-superfinished", &["--set", "model.positions=2"][..]),
        ("fzg-c", &few),
        ("table2", &few),
    ] {
        let case = root().join(format!("fixtures/cases/{name}.toml"));
        for formulation in ["corrected", "paper"] {
            let on = |threads: &str| {
                let run = ["run", case.to_str().unwrap(), "--no-output", "--json"];
                let how = ["--formulation", formulation, "--threads", threads];
                bench.run(&[&run, &how, more].concat()).well().out
            };
            assert_eq!(on("1"), on("2"), "{name} {formulation}");
        }
    }
}

#[test]
fn every_file_of_a_result_is_the_same_on_one_thread_and_on_three() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE.replace("depths = 0", "depths = 6"));
    for threads in ["1", "3"] {
        bench
            .run(&[
                "run",
                "case.toml",
                "-q",
                "--fields",
                "all",
                "-o",
                threads,
                "--threads",
                threads,
            ])
            .well();
    }
    let compared = same(&bench.path("1"), &bench.path("3"));
    // Two positions with two files each, and the tables of the whole.
    assert!(compared >= 12, "{compared}");
}

/// Number of files that two folders have alike.
fn same(one: &Path, other: &Path) -> usize {
    let mut compared = 0;
    for entry in fs::read_dir(one).unwrap() {
        let path = entry.unwrap().path();
        let partner = other.join(path.file_name().unwrap());
        if path.is_dir() {
            compared += same(&path, &partner);
        } else {
            assert!(
                fs::read(&path).unwrap() == fs::read(&partner).unwrap(),
                "{}",
                path.display()
            );
            compared += 1;
        }
    }
    assert_eq!(
        fs::read_dir(one).unwrap().count(),
        fs::read_dir(other).unwrap().count()
    );
    compared
}
