//! Damaged texts for every parser of ours, by a generator with a fixed seed: the deterministic twin of the fuzz targets
//! in `fuzz/`, which call the same functions.

use asperity_tests::parsers;

use crate::bench::E_DRIVE;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }
}

/// Pieces that trip parsers.
const NASTY: &[&str] = &[
    "",
    "0",
    "-",
    "-0",
    "1e308",
    "1e-320",
    "nan",
    "inf",
    "-inf",
    "18446744073709551616",
    "0x1",
    "1_0",
    "\"",
    "'",
    "\u{feff}",
    "\0",
    "µm",
    "°C",
    "1/min",
    "[",
    "]",
    "{",
    "}",
    "=",
    ",",
    ";",
    "\n",
    "\r",
    "\t",
    "%",
    "é",
    "\u{202e}",
];

/// One to four damages: a piece put in, cut, repeated, exchanged, or a byte changed.
fn damaged(seed: &str, random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.as_bytes().to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(12)).min(bytes.len());
        let piece = NASTY[random.below(NASTY.len())].as_bytes();
        match random.below(6) {
            0 => drop(bytes.splice(at..at, piece.iter().copied())),
            1 => drop(bytes.splice(at..end, piece.iter().copied())),
            2 => drop(bytes.drain(at..end)),
            3 => {
                let copy = bytes[at..end].to_vec();
                drop(bytes.splice(at..at, copy));
            }
            4 => bytes.truncate(bytes.len() - random.below(bytes.len() / 4 + 1)),
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
    }
    bytes
}

/// Damages each seed `count` times; both outcomes must have been seen.
fn hold(seeds: &[&str], count: usize, parse: impl Fn(&[u8]) -> bool) {
    let mut random = Random(20_261_120);
    let mut seen = [0, 0];
    for seed in seeds {
        assert!(parse(seed.as_bytes()), "the seed itself: {seed}");
        for _ in 0..count {
            seen[usize::from(parse(&damaged(seed, &mut random)))] += 1;
        }
    }
    assert!(
        seen.iter().all(|times| *times > 0),
        "refused, read: {seen:?}"
    );
}

fn text(parse: impl Fn(&str) -> bool) -> impl Fn(&[u8]) -> bool {
    move |bytes| parse(&String::from_utf8_lossy(bytes))
}

#[test]
fn damaged_quantities_are_read_or_refused() {
    let seeds = [
        "1.3 mm",
        "97.5 mPa s",
        "9000 1/min",
        "-12.5 °C",
        "2e-8 1/Pa",
        "285 N m",
        "0.84 g/cm3",
        "23.4 deg",
    ];
    hold(&seeds, 2000, text(parsers::units));
}

#[test]
fn damaged_planetary_cases_are_read_or_refused() {
    let seed = r#"
        planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] }
        operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
        lubricant = { oil = "m100" }
        surface = { sun = { rq = "0.3 um" }, planet = { rq = "0.3 um" }, ring = { rq = "0.3 um" } }
    "#;
    hold(&[seed], 150, text(parsers::planetary_case));
}

#[test]
fn damaged_cases_with_their_traces_are_read_or_refused() {
    let unit = "file = \"pinion.csv\", dx = \"0.5 um\", z_unit = \"um\"";
    // Half of the text is a remark, so that some damage does no harm.
    let remark = format!("# {}\n", "a small case of an electric drive, ".repeat(24));
    let seed = (remark + E_DRIVE)
        .replace("file = \"pinion.csv\"", unit)
        .replace("file = \"wheel.csv\"", &unit.replace("pinion", "wheel"));
    hold(&[&seed], 150, text(|text| parsers::case("case.toml", text)));
}

#[test]
fn damaged_tables_of_a_rig_are_read_or_refused() {
    let commas = "# SIMULATED\ntorque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes,assembly,order,case\n\
                  183.4,2166,90,300,9,mesh,A,1,a.toml\n60,25,40,2.5,0.1,mesh+bearings,B,2,\n";
    let semicolons = "Torque_Nm;Speed_rpm;Temperature_C;torque_loss_nm;sigma_w;includes\n\
                      183,4;3000;90;1,5;12;mesh\n60;2,5e1;-4,0;0,9;0,1;mesh\n";
    hold(
        &[commas, semicolons],
        4000,
        text(asperity_cli::fuzzing::rig_table),
    );
}

#[test]
fn damaged_gearbox_files_are_read_or_refused() {
    let folder = crate::bench::root().join("crates/rexs/tests/gearboxes");
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let seeds = [text("chain.rexs"), text("planetary.rexs")];
    let seeds: Vec<&str> = seeds.iter().map(String::as_str).collect();
    hold(&seeds, 1500, asperity_cli::fuzzing::rexs);
}

#[test]
fn damaged_command_lines_are_read_or_refused() {
    let seeds = [
        "compare\ncase.toml\n--finish\nground=a.csv,b.csv\n--finish\nhoned=c.csv\n--offsets\n8",
        "run\ncase.toml\n--set\noperation.torque=200 N m\n--fields\n1,5\n--max-hours\n3",
        "contact\ncase.toml\n--elastic-limit\n1.2 GPa\n--stress\nstress.csv\n--tolerance\n1e-8",
        "profile\ninfo\na.csv\n--lambda-c\n0.25mm\n--dx\n0.5um\n--z-unit\num",
    ];
    hold(&seeds, 400, text(asperity_cli::fuzzing::arguments));
}

#[test]
fn damaged_results_are_drawn_or_refused() {
    let bench = crate::bench::Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.run(&["run", "case.toml", "-o", "out", "-q"]).well();
    let seed = std::fs::read_to_string(bench.path("out/result.json")).unwrap();
    hold(&[&seed], 250, parsers::result);
}

#[test]
fn damaged_tables_of_a_page_are_drawn_or_refused() {
    hold(&[&parsers::page_seed()], 400, parsers::page);
}

#[test]
fn tables_of_a_page_that_are_no_field_are_refused() {
    let seed: serde_json::Value = serde_json::from_str(&parsers::page_seed()).unwrap();
    let changed = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut page = seed.clone();
        change(&mut page);
        page.to_string()
    };
    let rows = |page: &mut serde_json::Value, table: &str| -> Vec<serde_json::Value> {
        page.pointer_mut(table)
            .unwrap()
            .as_array_mut()
            .unwrap()
            .drain(1..2)
            .collect()
    };
    assert!(parsers::page(changed(&|_| ()).as_bytes()));
    for table in ["/load_map", "/contact/subsurface"] {
        assert!(
            !parsers::page(changed(&|page| drop(rows(page, table))).as_bytes()),
            "{table}"
        );
    }
    let without_a_point = changed(&|page| drop(rows(page, "/views/0/x_um")));
    assert!(!parsers::page(without_a_point.as_bytes()));
    let not_a_number = changed(&|page| page["contact"]["subsurface"][0]["depth_um"] = "nan".into());
    assert!(!parsers::page(not_a_number.as_bytes()));
}

#[test]
fn damaged_maps_are_read_or_refused() {
    hold(&[&parsers::map_seed()], 150, parsers::map_json);
}

#[test]
fn damaged_studies_are_read_or_refused() {
    let seeds = [
        "columns = [\"loss_w\"]\n[[axis]]\nkey = \"operation.speed\"\nfrom = \"500 1/min\"\nto = \"16000 1/min\"\n\
         count = 8\nspacing = \"log\"\n[[axis]]\nname = \"oil\"\nchoice.thin = { \"lubricant.oil\" = \"m100\" }\n",
        "[sample]\nmethod = \"sobol\"\ncount = 64\nseed = 3\nindices = true\n\
         vary.\"operation.torque\" = { uniform = [\"100 N m\", \"200 N m\"] }\n\
         vary.\"operation.speed\" = { log-uniform = [\"100 1/min\", \"9000 1/min\"] }\n",
        "[sample]\nmethod = \"list\"\nfile = \"list.csv\"\n",
    ];
    hold(&seeds, 600, text(parsers::study));
}

#[test]
fn a_study_of_more_cases_than_any_machine_runs_is_refused() {
    let axis = |key: &str, count: &str| {
        format!("[[axis]]\nkey = \"{key}\"\nfrom = 1.0\nto = 2.0\ncount = {count}\n")
    };
    assert!(parsers::study(&axis("operation.torque", "1000")));
    assert!(!parsers::study(&axis("operation.torque", "1000000000000")));
    let crossed: String = (0..8).map(|k| axis(&format!("key{k}"), "1000")).collect();
    assert!(!parsers::study(&crossed));
    let sampled = "[sample]\nmethod = \"latin-hypercube\"\ncount = 9000000000000000000\n\
                   vary.\"operation.torque\" = { uniform = [1.0, 2.0] }\n";
    assert!(!parsers::study(sampled));
}

#[test]
fn damaged_recipes_are_generated_or_refused() {
    let seeds = [
        r#"{"surface": {"self-affine": {"points": 600, "spacing": "0.5 um", "rq": "0.3 um", "hurst": 0.8,
            "roll-off": "100 um", "short-cut": "5 um", "seed": 1}},
            "pores": {"porosity": 0.08, "diameter": "20 um", "depth-ratio": 0.25, "seed": 2}, "mirrored": true}"#,
    ];
    hold(&seeds, 1500, parsers::recipe);
}

/// SHA-256 of `mine`, which every file around the folder of a manifest holds.
const SUM_OF_MINE: &str = "3fd30542fe3f61b14bd4a4b2dc0b6fb30fa6f63ebce52dd1778aaa8c4dc02cff";

#[test]
fn damaged_manifests_change_nothing_outside_of_their_folder() {
    let of = |names: &[&str]| {
        let sums: Vec<String> = names
            .iter()
            .map(|name| format!("{name:?}: [{SUM_OF_MINE:?}]"))
            .collect();
        let sums = sums.join(", ");
        format!("{{\"written_by\": \"asperity 0.1.0\", \"sha256\": {{{sums}}}}}")
    };
    let seed = of(&["a.txt"]);
    hold(&[&seed], 400, parsers::manifest);
    for name in [
        "../victim.txt",
        "../../victim.txt",
        "link/a.txt",
        "../precious/a.txt",
        "sub/../../victim.txt",
    ] {
        parsers::manifest(of(&["a.txt", name]).as_bytes());
        let mut random = Random(7);
        for _ in 0..40 {
            parsers::manifest(&damaged(&of(&["a.txt", name]), &mut random));
        }
    }
}

#[test]
fn damaged_journals_change_nothing_outside_of_their_draft() {
    let seeds = ["result", "moved"];
    hold(&seeds, 400, parsers::journal);
    for journal in [
        "../victim.txt",
        "../moved",
        "/",
        "..",
        ".",
        "",
        "sub",
        "precious/moved",
    ] {
        assert!(!parsers::journal(journal.as_bytes()), "{journal:?}");
    }
}
