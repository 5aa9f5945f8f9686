//! Devices, pipes, folders and unreadable files instead of a file: every argument of every command that is a path, and
//! every file that a case, a study, a map or a result names, is refused within a second, with a code.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::bench::{Bench, E_DRIVE, program};

/// A refusal takes less. The fastest of some tries counts: a busy machine may stop any process for a while.
const LIMIT: Duration = Duration::from_secs(1);
const TRIES: usize = 4;
/// Times of starting the program that are added to the limit, so that busy machines pass.
const START_UPS: u32 = 5;
/// A process that reads on and on is ended after this.
const PATIENCE: Duration = Duration::from_secs(60);

/// Role of a path on the command line.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// A file or folder that is read.
    Read,
    /// A file or folder that is written.
    Written,
    /// A name that is passed on and not opened, or a folder that may not be there yet.
    Named,
}
use Role::{Named, Read, Written};

/// Every path of the command line: the command, the argument, its role, and a command line whose other files are there,
/// with the
/// path as `@` and `~` for a blank within an argument.
const PATHS: &[(&str, &str, Role, &str)] = &[
    ("run", "case", Read, "@ --no-output"),
    ("run", "output", Written, "case.toml -o @"),
    ("report", "result", Read, "@"),
    ("check", "case", Read, "@"),
    ("case from-rexs", "file", Read, "@"),
    ("case from-rexs", "pinion", Named, ""),
    ("case from-rexs", "wheel", Named, ""),
    ("case from-rexs", "output", Written, "box.rexs -o @"),
    (
        "compare",
        "case",
        Read,
        "@ --finish a=pinion.csv --finish b=wheel.csv",
    ),
    (
        "compare",
        "finishes",
        Read,
        "case.toml --finish a=@ --finish b=wheel.csv",
    ),
    ("compare", "variants", Read, "case.toml --variant a=@"),
    (
        "compare",
        "output",
        Written,
        "case.toml --finish a=pinion.csv --finish b=wheel.csv -o @",
    ),
    ("map", "case", Read, "@"),
    ("map", "finishes", Read, "case.toml --finish a=@"),
    ("map", "variants", Read, "case.toml --variant a=@"),
    ("map", "cycle", Read, "case.toml --cycle @ -o new"),
    (
        "map",
        "add_loss",
        Read,
        "case.toml --torque 50,100 --speed 1000,2000 --export csv --add-loss @ -o new",
    ),
    ("map", "output", Written, "case.toml -o @"),
    ("cycle", "map", Read, "@ cycle.csv"),
    ("cycle", "trace", Read, "map @"),
    ("cycle", "output", Written, "map cycle.csv -o @"),
    ("sensitivity", "case", Read, "@"),
    ("sensitivity", "output", Written, "case.toml -o @"),
    ("ridges", "case", Read, "@"),
    ("ridges", "output", Written, "case.toml -o @"),
    ("running-in", "case", Read, "@"),
    (
        "running-in",
        "before",
        Read,
        "case.toml --before @ --after wheel.csv --test-engagements 1e6",
    ),
    (
        "running-in",
        "after",
        Read,
        "case.toml --before pinion.csv --after @ --test-engagements 1e6",
    ),
    ("running-in", "output", Written, "case.toml -o @"),
    ("callout", "case", Read, "@ --loss 600~W"),
    ("callout", "output", Written, "case.toml --loss 600~W -o @"),
    ("evidence", "case", Read, "@"),
    ("evidence", "output", Written, "case.toml -o @"),
    ("sweep run", "study", Read, "@"),
    ("sweep run", "parts", Written, "study.toml --parts @"),
    ("sweep merge", "study", Read, "@"),
    ("sweep merge", "parts", Named, ""),
    ("sweep merge", "output", Written, "study.toml -o @"),
    ("calibrate", "rig", Read, "@ case.toml -o new"),
    ("calibrate", "case", Read, "rig.csv @ -o new"),
    ("calibrate", "output", Written, "rig.csv case.toml -o @"),
    ("design", "case", Read, "@"),
    ("design", "output", Written, "case.toml -o @"),
    ("figures", "case", Read, "@ -o new"),
    ("figures", "output", Written, "case.toml -o @"),
    ("gear", "case", Read, "@"),
    ("contact", "case", Read, "@"),
    ("contact", "stress", Written, "case.toml --stress @"),
    ("contact", "output", Written, "case.toml -o @"),
    ("ehl", "case", Read, "@"),
    (
        "ehl",
        "output",
        Written,
        "case.toml --smooth --cells 256 -o @",
    ),
    (
        "ehl",
        "report",
        Written,
        "case.toml --smooth --cells 256 --report @",
    ),
    ("film", "case", Read, "@"),
    ("profile info", "files", Read, "@"),
    ("oil traction", "output", Written, "m100 -o @"),
    ("oil fit", "curves", Read, "@ --oil m100 -o new"),
    ("oil fit", "output", Written, "curves.csv --oil m100 -o @"),
    ("oil plan", "case", Read, "--oil m100 --case @ -o new"),
    ("oil plan", "output", Written, "--oil m100 -o @"),
    (
        "oil stribeck",
        "curves",
        Read,
        "@ --oil m100 --rubbing 2~h -o new",
    ),
    (
        "oil stribeck",
        "output",
        Written,
        "curves.csv --oil m100 --rubbing 2~h -o @",
    ),
    ("profile change", "before", Read, "@ pinion.csv -o new"),
    (
        "profile change",
        "case",
        Read,
        "pinion.csv pinion.csv --case @ -o new",
    ),
    ("profile change", "after", Read, "pinion.csv @ -o new"),
    (
        "profile change",
        "more",
        Read,
        "pinion.csv pinion.csv @ wheel.csv -o new",
    ),
    (
        "profile change",
        "output",
        Written,
        "pinion.csv pinion.csv -o @",
    ),
    ("profile compare", "files", Read, "pinion.csv @"),
    ("profile plot", "file", Read, "@"),
    ("profile plot", "output", Written, "pinion.csv -o @"),
    ("profile convert", "file", Read, "@ new.csv"),
    ("profile convert", "output", Written, "pinion.csv @"),
    ("profile filter", "file", Read, "@ new.csv"),
    ("profile filter", "output", Written, "pinion.csv @"),
    ("profile generate", "like", Read, "--like @ -o new.csv"),
    (
        "profile generate",
        "after",
        Read,
        "--like pinion.csv --after @ -o new.csv",
    ),
    ("profile generate", "output", Written, "-o @"),
    ("demo", "folder", Written, "@"),
    ("new", "output", Written, "@"),
];

#[test]
fn every_path_of_every_command_is_in_the_table() {
    let listed: BTreeSet<(String, String)> = PATHS
        .iter()
        .map(|(command, argument, ..)| ((*command).to_owned(), (*argument).to_owned()))
        .collect();
    assert_eq!(listed.len(), PATHS.len());
    let all: BTreeSet<(String, String)> = asperity_cli::fuzzing::paths().into_iter().collect();
    assert_eq!(all, listed);
}

/// The files that the command lines of the table name.
fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.write(
        "study.toml",
        "case = \"case.toml\"\n[[axis]]\nkey = \"operation.torque\"\nfrom = \"100 N m\"\nto = \"120 N m\"\ncount = 2\n",
    );
    bench.write(
        "cycle.csv",
        "time_s,torque_nm,speed_rpm\n0,100,2000\n1,100,2000\n",
    );
    bench.write(
        "rig.csv",
        "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n100,2000,90,300,9,mesh\n",
    );
    let curves = "crates/calibration/tests/golden/traction_mineral.csv";
    std::fs::copy(crate::bench::root().join(curves), bench.path("curves.csv")).unwrap();
    let rexs = crate::bench::root().join("crates/rexs/tests/gearboxes/chain.rexs");
    std::fs::copy(rexs, bench.path("box.rexs")).unwrap();
    bench
        .run(&["run", "case.toml", "-o", "out", "-q", "--no-band"])
        .well();
    bench.run(&["sweep", "run", "study.toml", "-q"]).well();
    let map = [
        "map",
        "case.toml",
        "--torque",
        "100,145",
        "--speed",
        "2000,9000",
        "--band",
        "none",
        "-o",
        "map",
        "-q",
    ];
    assert_eq!(bench.run(&map).status, 0);
    bench
}

fn ended(mut child: Child) -> Option<Output> {
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begin.elapsed() > PATIENCE {
            child.kill().unwrap();
            child.wait().unwrap();
            return None;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    Some(child.wait_with_output().unwrap())
}

/// Time that the program takes to start and end just now: where other processes are busy, it is not that of an idle
/// machine.
fn start_up() -> Duration {
    let begin = Instant::now();
    let version = Command::new(program()).arg("--version").output();
    assert!(version.unwrap().status.success());
    begin.elapsed()
}

/// Fault in the refusal of a command; `None` if it refuses with its code within a second of its start.
fn fault(bench: &Bench, arguments: &[&str]) -> Option<String> {
    let mut fastest = PATIENCE;
    for _ in 0..TRIES {
        let begin = Instant::now();
        let child = Command::new(program())
            .args(arguments)
            .current_dir(bench.path(""))
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn();
        let Some(output) = ended(child.unwrap()) else {
            return Some(format!("still at work after {PATIENCE:?}"));
        };
        fastest = fastest.min(begin.elapsed());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let code: String = said.chars().take(5).collect();
        let is_helped = said.contains("\n  help: ");
        let is_coded = code.starts_with('E') && code.ends_with(' ') && is_helped;
        if output.status.code() != Some(2) || !is_coded {
            return Some(format!("status {:?}: {said}", output.status.code()));
        }
        if fastest < LIMIT || fastest < LIMIT + START_UPS * start_up() {
            return None;
        }
    }
    Some(format!("takes {fastest:?}"))
}

/// Puts something odd at `path`.
type Odd = (&'static str, fn(&Path));

const ODD: &[Odd] = &[
    ("device", |path| {
        std::os::unix::fs::symlink("/dev/zero", path).unwrap();
    }),
    ("pipe", |path| {
        let made = Command::new("mkfifo").arg(path).status();
        assert!(made.unwrap().success());
    }),
    ("folder", |path| std::fs::create_dir(path).unwrap()),
    ("unreadable", |path| {
        use std::os::unix::fs::PermissionsExt;
        std::fs::write(path, "x").unwrap();
        std::fs::set_permissions(path, std::fs::Permissions::from_mode(0o000)).unwrap();
    }),
];

/// Whether this process may read what nobody may read, as root may.
fn is_root() -> bool {
    let file = tempfile::NamedTempFile::new().unwrap();
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(file.path(), std::fs::Permissions::from_mode(0o000)).unwrap();
    std::fs::File::open(file.path()).is_ok()
}

fn remove(path: &Path) {
    let _ = std::fs::remove_dir(path);
    let _ = std::fs::remove_file(path);
}

#[test]
fn every_command_refuses_a_device_a_pipe_a_folder_and_an_unreadable_file_within_a_second() {
    let bench = bench();
    let mut faults = Vec::new();
    let root = is_root();
    if root {
        println!("NOTICE: root reads every file; unreadable files are not tried");
    }
    for (command, argument, role, line) in PATHS {
        for (kind, make) in ODD {
            let is_tried = match *role {
                Read => *kind != "unreadable" || !root,
                // A folder is a place to write to, and a file may be replaced.
                Written => matches!(*kind, "device" | "pipe"),
                Named => false,
            };
            if !is_tried {
                continue;
            }
            let odd = bench.path("odd.csv");
            make(&odd);
            let line = format!("{command} {line}").replace('@', "odd.csv");
            let arguments: Vec<String> = line
                .split_whitespace()
                .map(|word| word.replace('~', " "))
                .collect();
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            if let Some(fault) = fault(&bench, &arguments) {
                faults.push(format!("{command} {argument}, {kind}: {fault}"));
            }
            remove(&odd);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A file that another file names or that belongs to a folder, and a command that reads it.
const NAMED_IN_FILES: &[(&str, &str)] = &[
    ("pinion.csv", "run case.toml --no-output"),
    ("wheel.csv", "regime case.toml"),
    ("case.toml", "sweep run study.toml"),
    ("table.csv", "run gearbox.toml --no-output"),
    ("xu.json", "run xu.toml --no-output"),
    ("oil.toml", "run oiled.toml --no-output"),
    ("list.csv", "sweep run list.toml"),
    ("out/result.json", "report out"),
    ("out/page.json", "report out"),
    ("out/manifest.json", "run case.toml -o out"),
    ("map/map.json", "cycle map cycle.csv --no-output"),
    ("map/map.csv", "cycle map cycle.csv --no-output"),
];

#[test]
fn every_file_that_is_named_in_another_is_refused_where_it_is_none() {
    let bench = bench();
    let case = |more: &str| E_DRIVE.replace("[model]\n", more);
    bench.write(
        "gearbox.toml",
        case("[gearbox]\nloss_table = \"table.csv\"\n\n[model]\n"),
    );
    bench.write("xu.toml", case("[model]\nxu_coefficients = \"xu.json\"\n"));
    let oiled = E_DRIVE.replacen("[lubricant]\n", "[lubricant]\noil_file = \"oil.toml\"\n", 1);
    bench.write("oiled.toml", oiled);
    bench.write(
        "list.toml",
        "case = \"case.toml\"\n[sample]\nmethod = \"list\"\nfile = \"list.csv\"\n",
    );
    let mut faults = Vec::new();
    let root = is_root();
    for (file, line) in NAMED_IN_FILES {
        let path = bench.path(file);
        let before = std::fs::read(&path).ok();
        for (kind, make) in ODD {
            if *kind == "unreadable" && root {
                continue;
            }
            remove(&path);
            make(&path);
            let arguments: Vec<&str> = line.split_whitespace().collect();
            if let Some(fault) = fault(&bench, &arguments) {
                faults.push(format!("{file}, {kind}, {line}: {fault}"));
            }
        }
        remove(&path);
        if let Some(bytes) = before {
            std::fs::write(&path, bytes).unwrap();
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
