//! Every kind of page, made once with small cases.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::Run;
use asperity::case::{CaseInput, ContactName, LoadedCase, load_with};
use asperity::pipeline::Kept;
use asperity::result::MeshOutcome;
use asperity_report::{Fields, write_folder};
use asperity_studies::ridges::add_ridges;
use asperity_tests::planetary_set;

use crate::bench::{Bench, E_DRIVE};

/// A page in the folder of its tables.
pub struct Page {
    /// What it is of.
    pub name: String,
    pub folder: PathBuf,
    /// The page itself.
    pub text: String,
}

/// The pages, and the folder that they are in while the tests run.
struct Pages {
    all: Vec<Page>,
    _bench: Bench,
}

/// Every kind of page.
pub fn all() -> &'static [Page] {
    static PAGES: OnceLock<Pages> = OnceLock::new();
    &PAGES.get_or_init(make).all
}

fn page(name: &str, file: &Path) -> Page {
    Page {
        name: name.to_owned(),
        folder: file.parent().unwrap().to_owned(),
        text: std::fs::read_to_string(file).unwrap(),
    }
}

pub fn shipped(case: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(case)
}

/// A small e-drive, changed.
fn small_e_drive(change: &dyn Fn(&mut CaseInput)) -> LoadedCase {
    let small = |input: &mut CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        change(input);
    };
    load_with(&shipped("e-drive.toml"), &small).unwrap()
}

/// A small e-drive, changed and run, with the fields of the position that its page shows.
pub fn e_drive(change: &dyn Fn(&mut CaseInput)) -> MeshOutcome {
    Run::new(&small_e_drive(change))
        .pictures(Kept::Highest)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
}

/// The reference case in the paper's formulation.
pub fn paper() -> MeshOutcome {
    let paper = asperity_paper_2022::register();
    let loaded = asperity::case::load(&shipped("table2.toml"), Some(paper)).unwrap();
    asperity::Run::new(&loaded)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
}

/// Points of a row, and rows, of a made scan.
const SCAN: [usize; 2] = [1500, 24];

/// A scan of summits without a lay as text of ISO 25178-71, points 1 µm and rows 2 µm apart.
fn scan(seed: f64) -> String {
    let [points, rows] = SCAN;
    let wave = |k: u32| {
        let part = |by: f64| ((f64::from(k) + seed) * by).fract();
        let length = 7.0 * 6.0_f64.powf(part(0.618_034));
        let angle = TAU * part(0.754_878);
        let [x, y] = [angle.cos(), angle.sin()].map(|of| TAU * of / length);
        [x, y, TAU * part(0.569_84), 0.5 * length.sqrt()]
    };
    let waves: Vec<[f64; 4]> = (0..60).map(wave).collect();
    let height = |i: usize, j: usize| -> f64 {
        let at = |[x, y, phase, size]: &[f64; 4]| {
            size * (x * i as f64 + 2.0 * y * j as f64 + phase).cos()
        };
        waves.iter().map(at).sum()
    };
    let row = |j: usize| -> String {
        let heights = (0..points).map(|i| format!("{:.3} ", height(i, j)));
        heights.collect::<String>() + "\n"
    };
    format!(
        "aISO-1.0\nManufacID   = made\nCreateDate  = 271120260000\nModDate     = 271120260000\nNumPoints   = {points}\n\
         NumProfiles = {rows}\nXscale      = 1E-06\nYscale      = 2E-06\nZscale      = 1E-08\nZresolution = -1\n\
         Compression = 0\nDataType    = 7\nCheckType   = 0\n*\n{}*\n",
        (0..rows).map(row).collect::<String>()
    )
}

/// A small e-drive with a scan of each flank.
fn scanned(bench: &Bench, contact: ContactName) -> MeshOutcome {
    let files = [1.0, 9.0].map(|seed| {
        let file = bench.path(&format!("scan_{seed}.sdf"));
        std::fs::write(&file, scan(seed)).unwrap();
        file
    });
    e_drive(&|input| {
        (input.model.positions, input.model.offsets) = (Some(2), Some(1));
        input.operation.torque = "30 N m".parse().unwrap();
        input.surface.cutoff = Some("0.08 mm".parse().unwrap());
        input.surface.contact = Some(contact);
        let flanks = [
            Some(&mut input.surface.pinion),
            input.surface.wheel.as_mut(),
        ];
        for (flank, file) in flanks.into_iter().flatten().zip(&files) {
            flank.file = Some(file.clone());
        }
    })
}

fn reports(bench: &Bench) -> Vec<Page> {
    let spur = |input: &mut CaseInput| input.gears.helix = None;
    let mut with_ridges = e_drive(&spur);
    add_ridges(&mut with_ridges.result, &small_e_drive(&spur), &|_, _| {}).unwrap();
    let cases: [(&str, MeshOutcome); 7] = [
        ("spur", with_ridges),
        ("helical", e_drive(&|_| {})),
        (
            "ring",
            e_drive(&|input| {
                spur(input);
                input.gears.teeth = [24, -75];
            }),
        ),
        ("paper", paper()),
        (
            "full-film",
            e_drive(&|input| {
                input
                    .operation
                    .set_bulk_temperature("20 °C".parse().unwrap());
                let flanks = [
                    Some(&mut input.surface.pinion),
                    input.surface.wheel.as_mut(),
                ];
                for (flank, name) in flanks.into_iter().flatten().zip(["", "_wheel"]) {
                    let file = shipped(&format!("../profiles/superfinished{name}.csv"));
                    flank.file = Some(file.canonicalize().unwrap());
                }
            }),
        ),
        ("patches", scanned(bench, ContactName::Patch)),
        ("rows", scanned(bench, ContactName::Lines)),
    ];
    assert_eq!(cases[4].1.result.summary.mixed_share, 0.0, "a full film");
    let mut pages: Vec<Page> = cases
        .iter()
        .map(|(name, outcome)| {
            let folder = bench.path(name);
            write_folder(outcome, &folder, &Fields::All).unwrap();
            page(&format!("report, {name}"), &folder.join("report.html"))
        })
        .collect();
    let set = Run::new(planetary_set())
        .pictures(Kept::Highest)
        .interval(true)
        .execute()
        .unwrap();
    let folder = bench.path("set");
    write_folder(&set, &folder, &Fields::Page).unwrap();
    for (name, file) in [("set", "report.html"), ("mesh", "planet_ring/report.html")] {
        pages.push(page(&format!("planetary, {name}"), &folder.join(file)));
    }
    assert!(pages[0].text.contains("Ridges with the largest loss"));
    pages
}

/// A cycle with a coast and a stop.
const CYCLE: &str = "time_s,torque_nm,speed_rpm\n0,0,0\n1,60,1500\n2,60,3000\n3,-30,3000\n4,0,0\n";

const STUDY: &str = r#"case = "case.toml"
columns = ["loss_w", "efficiency"]

[[axis]]
key = "operation.torque"
values = ["60 N m", "140 N m"]

[sample]
method = "latin-hypercube"
count = 12
vary."model.boundary_friction" = { uniform = [0.06, 0.10] }
vary."lubricant.viscosity.at_100" = { normal = ["5.9 mm2/s", "0.15 mm2/s"] }
"#;

/// Options of the commands that make the other pages, and the pages.
const COMMANDS: [(&[&str], &[&str]); 16] = [
    (
        &[
            "compare",
            "case.toml",
            "--finish",
            "ground=pinion.csv,wheel.csv",
            "--finish",
            "superfinished=smooth.csv,smooth_wheel.csv",
            "--finish",
            "again=pinion.csv,wheel.csv",
            "--offsets",
            "4",
            "-o",
            "compared",
        ],
        &["compared/compare.html"],
    ),
    (
        // At rest and without torque there is no efficiency.
        &[
            "map",
            "case.toml",
            "--torque=-100,0,40,100",
            "--speed=0,500,9000",
            "--temperature=90",
            "-o",
            "map",
        ],
        &["map/map.html"],
    ),
    (
        &[
            "cycle",
            "map",
            "cycle.csv",
            "--temperature",
            "90",
            "-o",
            "driven",
        ],
        &["driven/cycle.html"],
    ),
    (
        &["sensitivity", "case.toml", "-o", "changed"],
        &["changed/sensitivity.html"],
    ),
    (
        &["ridges", "case.toml", "-o", "pressed"],
        &["pressed/ridges.html"],
    ),
    (
        &[
            "callout",
            "case.toml",
            "--loss",
            "600 W",
            "--lots",
            "20",
            "--set",
            "model.positions=2",
            // A law without contacts: the page draws the same.
            "--set",
            "model.load_share=zhu-hu",
            "-o",
            "limited",
        ],
        &["limited/callout.html"],
    ),
    (&["sweep", "run", "study.toml", "--parts", "parts"], &[]),
    (
        &[
            "sweep",
            "merge",
            "study.toml",
            "--parts",
            "parts",
            "-o",
            "swept",
        ],
        &["swept/sweep.html"],
    ),
    (
        &[
            "design",
            "case.toml",
            "--simulate",
            "4",
            "--torque",
            "60,145",
            "--speed",
            "25..30000:7:log",
            "-o",
            "design",
        ],
        &["design/design.html"],
    ),
    (
        &[
            "calibrate",
            "design/simulated.csv",
            "case.toml",
            "--hold",
            "boundary-layer",
            "-o",
            "found",
        ],
        &["found/calibration.html"],
    ),
    (
        &[
            "profile",
            "change",
            "pinion.csv",
            "worn.csv",
            "-o",
            "change",
        ],
        &["change/change.html"],
    ),
    (
        &["oil", "traction", "m100", "-o", "traction"],
        &["traction/traction.html"],
    ),
    (
        &[
            "oil",
            "fit",
            "traction/traction_over_slide_to_roll.csv",
            "--oil",
            "m100",
            "-o",
            "oil",
        ],
        &["oil/oil_fit.html"],
    ),
    (
        &["evidence", "case.toml", "-o", "measure"],
        &["measure/evidence.html"],
    ),
    (
        &["oil", "plan", "--oil", "m100", "-o", "planned"],
        &["planned/oil_plan.html"],
    ),
    (
        &[
            "oil",
            "stribeck",
            "stribeck.csv",
            "--oil",
            "m100",
            "-o",
            "rubbed",
        ],
        &["rubbed/stribeck.html"],
    ),
];

/// Stribeck curves of new and of rubbed specimens at 120 °C and 50 N.
fn stribeck() -> String {
    let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,rubbing_s,traction";
    let points = [0, 3600].into_iter().flat_map(|rubbing_s| {
        (0..12).map(move |k| {
            let speed = 0.002 * 1.5_f64.powi(k);
            let friction = 0.11 - 0.02 * f64::from(rubbing_s) / 3600.0 - 0.0005 * f64::from(k);
            format!("50,{speed},50,120,{rubbing_s},{friction}")
        })
    });
    let lines = std::iter::once(head.to_owned()).chain(points);
    lines.collect::<Vec<String>>().join("\n")
}

fn studies(bench: &Bench) -> Vec<Page> {
    bench.write_flanks();
    bench.shorten_flanks();
    for (from, to) in [
        ("superfinished", "smooth"),
        ("superfinished_wheel", "smooth_wheel"),
    ] {
        let trace = shipped(&format!("../profiles/{from}.csv"));
        std::fs::copy(trace, bench.path(&format!("{to}.csv"))).unwrap();
    }
    bench.write_worn("pinion.csv", "worn.csv");
    bench.write("case.toml", E_DRIVE);
    bench.write("cycle.csv", CYCLE);
    bench.write("study.toml", STUDY);
    bench.write("stribeck.csv", stribeck());
    let mut pages = Vec::new();
    for (arguments, made) in COMMANDS {
        let said = bench.run(arguments);
        assert_eq!(said.status, 0, "{arguments:?}: {}", said.err);
        pages.extend(made.iter().map(|file| page(file, &bench.path(file))));
    }
    let film = [
        "ehl",
        "case.toml",
        "--position",
        "C",
        "--cells",
        "128",
        "--half-widths",
        "1",
        "--start",
        "1",
        "--report",
        "film.html",
        "--every",
        "0.25",
    ];
    let said = bench.run(&film);
    assert_eq!(said.status, 0, "{}", said.err);
    pages.push(page("film.html", &bench.path("film.html")));
    pages
}

/// The figures, each a file of its own, on one page.
fn figures(bench: &Bench) -> Page {
    let paper = asperity_paper_2022::register();
    let case = asperity::case::load(&shipped("table2.toml"), Some(paper)).unwrap();
    let folder = bench.path("figures");
    std::fs::create_dir(&folder).unwrap();
    let mut files = asperity_paper_2022::figures::write(&case, &folder).unwrap();
    files.push(bench.path("profile.svg"));
    let said = bench.run(&["profile", "plot", "pinion.csv", "-o", "profile.svg"]);
    assert_eq!(said.status, 0, "{}", said.err);
    let drawings = files
        .iter()
        .filter(|file| file.extension().is_some_and(|e| e == "svg"));
    let body: String = drawings
        .map(|file| {
            let name = file.file_stem().unwrap().to_string_lossy();
            let svg = std::fs::read_to_string(file).unwrap();
            svg.replacen("<svg ", &format!("<svg data-name=\"{name}\" "), 1)
        })
        .collect();
    Page {
        name: "figures".to_owned(),
        folder,
        text: format!(
            "<!doctype html><html><head><meta charset=\"utf-8\">\
             <style>@media (min-width:1000px){{body{{display:grid;grid-template-columns:1fr 1fr}}}}</style></head><body>{body}</body></html>"
        ),
    }
}

fn make() -> Pages {
    let bench = Bench::new();
    let mut all = std::thread::scope(|scope| {
        let studies = scope.spawn(|| studies(&bench));
        let mut all = reports(&bench);
        all.extend(studies.join().unwrap());
        all
    });
    all.push(figures(&bench));
    Pages { all, _bench: bench }
}
