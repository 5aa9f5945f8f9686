//! Kills and signals at any moment: no half file, no lost result, nothing left behind.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::bench::{Bench, E_DRIVE, program, trace};

/// Kills of each command; `ASPERITY_KILLS` asks for more, as 200.
fn kills() -> u64 {
    const FEW: u64 = 3;
    let wanted = std::env::var("ASPERITY_KILLS").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(FEW)
}

fn start(bench: &Bench, arguments: &[&str]) -> Child {
    Command::new(program())
        .args(arguments)
        .current_dir(bench.path(""))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Hidden entries in `place`, a folder of the bench.
fn drafts_in(bench: &Bench, place: &str) -> Vec<String> {
    let entries = fs::read_dir(bench.path(place)).into_iter().flatten();
    let names = entries.flatten().map(|entry| entry.file_name());
    names
        .map(|name| name.to_string_lossy().into_owned())
        .filter(|name| name.starts_with(".asperity-"))
        .collect()
}

/// Lets `child` work until it has a draft in `place`; false where it ended before one was seen.
fn caught_writing(child: &mut Child, bench: &Bench, place: &str) -> bool {
    loop {
        if !drafts_in(bench, place).is_empty() {
            return true;
        }
        if !matches!(child.try_wait(), Ok(None)) {
            return false;
        }
        std::thread::sleep(Duration::from_micros(200));
    }
}

const RUN: [&str; 6] = ["run", "case.toml", "-o", "out", "-q", "--no-band"];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench
}

/// A command that is killed, and where it has its drafts.
struct Killed<'a> {
    arguments: &'a [&'a str],
    place: &'a str,
}

/// Kills a command again and again, every other time while it writes and else at moments spread over
/// the time of a whole run, and checks with `whole` what is there after each.
fn kill(bench: &Bench, killed: &Killed<'_>, whole: impl Fn()) {
    let Killed { arguments, place } = *killed;
    let begin = std::time::Instant::now();
    bench.run(arguments).well();
    let time = begin.elapsed().as_micros() as u64;
    let (count, mut caught) = (kills(), 0);
    for k in 0..count {
        let mut child = start(bench, arguments);
        if k % 2 == 0 {
            caught += u64::from(caught_writing(&mut child, bench, place));
        } else {
            // The golden ratio spreads any number of moments evenly; the last part writes.
            let share = (0.618_034 * (k + 1) as f64).fract().sqrt();
            std::thread::sleep(Duration::from_micros((share * time as f64) as u64));
        }
        let _ = child.kill();
        child.wait().unwrap();
        whole();
    }
    // The next start clears up, and works; a draft that was killed before it had its lock is taken for
    // one that is being made for some seconds.
    bench.run(arguments).well();
    if !drafts_in(bench, place).is_empty() {
        std::thread::sleep(Duration::from_secs(6));
        bench.run(arguments).well();
    }
    assert_eq!(drafts_in(bench, place), Vec::<String>::new());
    whole();
    println!("{arguments:?}: {count} kills, {caught} seen to hit a draft");
}

fn is_json(file: &Path) {
    let text = fs::read_to_string(file).unwrap();
    serde_json::from_str::<serde_json::Value>(&text).unwrap();
}

fn is_page(file: &Path) {
    assert!(fs::read_to_string(file).unwrap().ends_with("</html>"));
}

#[test]
fn a_killed_run_leaves_the_older_result() {
    let bench = bench();
    let run = Killed {
        arguments: &RUN,
        place: "",
    };
    kill(&bench, &run, || {
        // The name is never lost, not even for a moment: the system exchanges two names at once.
        if cfg!(target_os = "linux") {
            is_json(&bench.path("out/result.json"));
            is_page(&bench.path("out/report.html"));
        }
    });
}

#[test]
fn a_killed_report_leaves_a_whole_page() {
    let bench = bench();
    bench.run(&RUN).well();
    let report = Killed {
        arguments: &["report", "out"],
        place: "out",
    };
    kill(&bench, &report, || is_page(&bench.path("out/report.html")));
}

#[test]
fn a_result_whose_report_was_killed_is_replaced_by_the_next_run() {
    let bench = bench();
    bench.run(&RUN).well();
    for _ in 0..kills() {
        let mut child = start(&bench, &["report", "out"]);
        caught_writing(&mut child, &bench, "out");
        let _ = child.kill();
        child.wait().unwrap();
        // A draft that was killed before it had its lock is taken for one that is being made for some seconds.
        if bench.run(&RUN).status != 0 {
            std::thread::sleep(Duration::from_secs(6));
            bench.run(&RUN).well();
        }
    }
    // What a report that is killed while it writes always leaves: a draft whose lock nobody holds.
    std::fs::create_dir_all(bench.path("out/.asperity-abc123/new")).unwrap();
    bench.write("out/.asperity-abc123/lock", "asperity draft of process 1\n");
    bench.run(&RUN).well();
    assert_eq!(drafts_in(&bench, "out"), Vec::<String>::new());
}

#[test]
fn a_killed_comparison_leaves_the_older_one() {
    let bench = bench();
    let arguments = [
        "compare",
        "case.toml",
        "--finish",
        "a=pinion.csv",
        "--finish",
        "b=wheel.csv",
        "--offsets",
        "2",
        "-o",
        "out",
    ];
    let compare = Killed {
        arguments: &arguments,
        place: "",
    };
    kill(&bench, &compare, || {
        if cfg!(target_os = "linux") {
            is_json(&bench.path("out/compare.json"));
            is_page(&bench.path("out/compare.html"));
        }
    });
}

/// Drawings and tables of `figures`, and the manifest.
const FIGURES: usize = 32;

#[test]
fn killed_first_figures_are_all_there_or_none() {
    let bench = bench();
    bench.write("case.toml", E_DRIVE.replace("depths = 0", "depths = 8"));
    let figures = ["figures", "case.toml", "-o", "out", "-q"];
    for k in 0..kills() {
        let mut child = start(&bench, &figures);
        // Its draft, wherever that is, or every other time its folder.
        while (k % 2 == 1 || drafts_in(&bench, "").is_empty())
            && !bench.path("out").exists()
            && matches!(child.try_wait(), Ok(None))
        {
            std::thread::sleep(Duration::from_micros(200));
        }
        std::thread::sleep(Duration::from_millis(2));
        let _ = child.kill();
        child.wait().unwrap();
        if let Ok(entries) = fs::read_dir(bench.path("out")) {
            assert_eq!(entries.count(), FIGURES);
            fs::remove_dir_all(bench.path("out")).unwrap();
        }
    }
}

#[test]
fn killed_figures_are_whole_or_the_older_ones_and_leave_files_of_the_user() {
    let bench = bench();
    // The stress below the surface is one of the figures.
    bench.write("case.toml", E_DRIVE.replace("depths = 0", "depths = 8"));
    let figures = Killed {
        arguments: &["figures", "case.toml", "-o", "out"],
        place: "",
    };
    kill(&bench, &figures, || {
        let Ok(entries) = fs::read_dir(bench.path("out")) else {
            // Two renames may leave the name to nobody for a moment.
            assert_ne!(std::env::consts::OS, "linux");
            return;
        };
        let paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        assert_eq!(paths.len(), FIGURES);
        for path in paths {
            match path.extension().and_then(|ending| ending.to_str()) {
                Some("svg") => {
                    let text = fs::read_to_string(&path).unwrap();
                    assert!(text.trim_end().ends_with("</svg>"), "{path:?}");
                }
                Some("csv") => assert!(fs::read(&path).unwrap().ends_with(b"\n"), "{path:?}"),
                Some("json") => is_json(&path),
                _ => {}
            }
        }
    });
    // Files of the user stay among them.
    bench.write("out/notes.txt", "mine");
    bench.run(figures.arguments).well();
    assert_eq!(fs::read(bench.path("out/notes.txt")).unwrap(), b"mine");
    assert_eq!(
        fs::read_dir(bench.path("out")).unwrap().count(),
        FIGURES + 1
    );
}

/// A trace so long that writing it takes a while, converted to `out.csv`.
const CONVERT: [&str; 4] = ["profile", "convert", "long.csv", "out.csv"];

fn with_a_long_trace() -> Bench {
    let bench = Bench::new();
    bench.write("long.csv", trace("x_um,z_um", 100_000));
    bench
}

#[test]
fn a_killed_conversion_leaves_the_older_file() {
    let bench = with_a_long_trace();
    bench.run(&CONVERT).well();
    let older = fs::read(bench.path("out.csv")).unwrap();
    let convert = Killed {
        arguments: &CONVERT,
        place: "",
    };
    kill(&bench, &convert, || {
        assert!(fs::read(bench.path("out.csv")).unwrap() == older);
    });
}

#[test]
fn a_killed_export_leaves_nothing_in_the_folder_of_temporary_files() {
    if !cfg!(target_os = "linux") || Command::new("cc").arg("--version").output().is_err() {
        return;
    }
    let bench = bench();
    fs::create_dir(bench.path("temporary")).unwrap();
    let map = [
        "map",
        "case.toml",
        "-o",
        "out",
        "-q",
        "--band",
        "none",
        "--export",
        "fmu",
    ];
    let map = || {
        let axes = ["--torque=50,100", "--speed=3000,9000"];
        Command::new(program())
            .args([&map[..], &axes].concat())
            .current_dir(bench.path(""))
            .env("TMPDIR", bench.path("temporary"))
            .spawn()
            .unwrap()
    };
    for _ in 0..kills() {
        let mut child = map();
        caught_writing(&mut child, &bench, "");
        let _ = child.kill();
        child.wait().unwrap();
        let left = fs::read_dir(bench.path("temporary")).unwrap();
        assert_eq!(left.flatten().count(), 0);
    }
    // A compiler may outlive the killed command.
    std::thread::sleep(Duration::from_secs(6));
    assert!(map().wait().unwrap().success());
    assert_eq!(drafts_in(&bench, ""), Vec::<String>::new());
}

/// Sends a signal while the command has a draft, and checks that it goes; the times it was caught so.
#[cfg(unix)]
fn signalled_while_writing(bench: &Bench, arguments: &[&str], whole: impl Fn()) -> usize {
    /// On a busy machine a draft may come and go between two looks.
    const TRIES: usize = 12;
    const WANTED: usize = 2;
    let mut caught = 0;
    for k in 0..TRIES {
        let mut child = start(bench, arguments);
        if caught_writing(&mut child, bench, "") {
            let signal = ["-INT", "-TERM"][k % 2];
            let sent = Command::new("kill")
                .args([signal, &child.id().to_string()])
                .status();
            assert!(sent.is_ok());
            caught += 1;
        }
        child.wait().unwrap();
        assert_eq!(drafts_in(bench, ""), Vec::<String>::new());
        whole();
        if caught == WANTED {
            break;
        }
    }
    caught
}

#[cfg(unix)]
#[test]
fn a_signal_in_the_middle_of_writing_leaves_no_draft() {
    let bench = with_a_long_trace();
    bench.run(&CONVERT).well();
    let older = fs::read(bench.path("out.csv")).unwrap();
    let caught = signalled_while_writing(&bench, &CONVERT, || {
        assert!(fs::read(bench.path("out.csv")).unwrap() == older);
    });
    assert!(caught > 0);
    let bench = self::bench();
    bench.run(&RUN).well();
    let caught = signalled_while_writing(&bench, &RUN, || {
        is_json(&bench.path("out/result.json"));
        is_page(&bench.path("out/report.html"));
    });
    assert!(caught > 0);
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_nothing_behind() {
    let bench = bench();
    bench.run(&RUN).well();
    bench.write("case.toml", E_DRIVE.replace("offsets = 2", "offsets = 64"));
    let before = fs::read(bench.path("out/result.json")).unwrap();
    for (k, signal) in ["-INT", "-TERM", "-INT", "-TERM"].into_iter().enumerate() {
        let mut child = start(&bench, &RUN);
        std::thread::sleep(Duration::from_millis(40 + 45 * k as u64));
        let sent = Command::new("kill")
            .args([signal, &child.id().to_string()])
            .status();
        assert!(sent.is_ok());
        child.wait().unwrap();
        assert_eq!(drafts_in(&bench, ""), Vec::<String>::new(), "{signal}");
        assert_eq!(fs::read(bench.path("out/result.json")).unwrap(), before);
    }
}
