//! Messages about case files: code, line, key, what was seen, what was expected, what to do.

use crate::bench::{Bench, E_DRIVE, line_of, with_line};

/// A line of the small case as it should not be.
struct Bad {
    /// How the good line starts.
    key: &'static str,
    /// Text found instead.
    line: &'static str,
    code: &'static str,
    /// Message without its place.
    says: &'static [&'static str],
    /// Whether the message is about this line, or about the line of its table.
    table: Option<&'static str>,
}

const fn bad(
    key: &'static str,
    line: &'static str,
    code: &'static str,
    says: &'static [&'static str],
) -> Bad {
    Bad {
        key,
        line,
        code,
        says,
        table: None,
    }
}

const fn about_table(
    key: &'static str,
    line: &'static str,
    code: &'static str,
    says: &'static [&'static str],
    table: &'static str,
) -> Bad {
    Bad {
        key,
        line,
        code,
        says,
        table: Some(table),
    }
}

/// E202, E203: text and keys.
#[rustfmt::skip]
const SPELLING: &[Bad] = &[
    bad("module", "module 1.8 mm", "E202", &["expected"]),
    bad("module", "module = 1.8 mm", "E202", &["expected"]),
    bad("helix", "module = \"1 mm\"", "E202", &["duplicate key"]),
    bad("module", "modul = \"1.8 mm\"", "E203", &["\"gears.modul\"", "Did you mean \"module\"?"]),
    bad("module", "torque = \"145 N m\"", "E203", &["\"gears.torque\"", "Did you mean \"operation.torque\"?"]),
    bad("torque", "density = \"880 kg/m3\"", "E203", &["\"operation.density\"", "Did you mean \"lubricant.density\"?"]),
    bad("cutoff", "boundary_friction = 0.1", "E203", &["Did you mean \"model.boundary_friction\"?"]),
    bad("[operation]", "[operations]", "E203", &["\"operations\"", "Did you mean \"operation\"?"]),
    bad("title", "colour = \"red\"", "E203", &["unknown key \"colour\""]),
    bad("viscosity", "viscosity = { law = \"vogel\", at_4 = \"3 mm2/s\" }", "E203", &["Did you mean \"at_40\"?"]),
];

/// E204: values that cannot be read.
#[rustfmt::skip]
const VALUES: &[Bad] = &[
    bad("module", "module = 1.8", "E204", &["gears.module", "1.8 has no unit", "mm, um, micron, micrometer, micrometre, nm, m, cm", "(as \"1.8 mm\")"]),
    bad("pinion", "pinion = { ra = \"0.1\" }", "E204", &["surface.pinion.ra: 0.1 has no unit", "(as \"0.1 um\")"]),
    bad("module", "module = \"1.8\"", "E204", &["gears.module", "1.8 has no unit"]),
    bad("module", "module = \"1,8 mm\"", "E204", &["gears.module", "\"1,8 mm\"", "decimal sign as a point"]),
    bad("module", "module = \"nan mm\"", "E204", &["gears.module", "must start with a number"]),
    bad("module", "module = \"1e999 mm\"", "E204", &["gears.module", "1e999 mm"]),
    bad("torque", "torque = \"145 N\"", "E204", &["operation.torque", "\"N\" is not a unit of torque", "N m, kN m, N mm"]),
    bad("bulk_temperature", "bulk_temperature = \"-300 °C\"", "E204", &["operation.bulk_temperature", "not a possible temperature"]),
    bad("teeth", "teeth = \"many\"", "E204", &["gears.teeth", "string \"many\"", "expected two values"]),
    bad("teeth", "teeth = [23]", "E204", &["gears.teeth", "1 value does not fit", "expected two values"]),
    bad("teeth", "teeth = [-23, 68]", "E205", &["gears.teeth", "only the wheel may be a ring"]),
    bad("helix", "helix = 18", "E204", &["gears.helix", "18 has no unit; an angle needs one of"]),
    bad("face_width", "face_width = 35", "E204", &["gears.face_width", "35 has no unit", "mm, um"]),
    bad("face_width", "face_width = \"35 cm2\"", "E204", &["gears.face_width", "\"cm2\" is not a unit of length"]),
    bad("base_oil", "base_oil = \"olive\"", "E204", &["lubricant.base_oil", "unknown choice `olive`", "`mineral`"]),
    bad("viscosity", "viscosity = 3", "E204", &["lubricant.viscosity", "integer `3`", "a table"]),
    bad("offsets", "offsets = 1.5", "E204", &["model.offsets", "`1.5`", "whole number"]),
    bad("title", "paper.position = \"F\"", "E204", &["paper.position", "`F`", "`A`, `B`, `C`, `D`, `E`", "0 at A, 1 at E"]),
    bad("pinion", "pinion = 3", "E204", &["surface.pinion", "a table, e.g. { key = value }"]),
    about_table("bulk_temperature", "", "E204", &["operation: missing key \"bulk_temperature\"", "or `oil_temperature`"], "[operation]"),
    about_table("module", "", "E204", &["gears: missing key \"module\"", "length with a unit: mm"], "[gears]"),
    about_table("pinion", "", "E204", &["surface: missing key \"pinion\"", "Trace of the pinion's flank"], "[surface]"),
    bad("viscosity", "viscosity = { law = \"astm-d341\", at_100 = \"6 mm2/s\" }", "E204", &["missing key \"at_40\"", "kinematic viscosity with a unit: mm2/s"]),
];

/// E205 to E209: what is well written and cannot be.
#[rustfmt::skip]
const DOMAINS: &[Bad] = &[
    bad("pinion", "pinion = { file = \"pinion.csv\", rq = \"1 um\" }", "E205", &["surface.pinion", "either file or rq"]),
    bad("pinion", "pinion = { }", "E205", &["surface.pinion", "give file", "or rq"]),
    bad("bulk_temperature", "oil_temperature = \"80 °C\"\nbulk_temperature = \"90 °C\"", "E205", &["operation.oil_temperature", "leave one of the two out"]),
    bad("bulk_temperature", "temperature = \"80 °C\"", "E203", &["operation.temperature", "bulk_temperature"]),
    bad("bulk_temperature", "bulk = { law = \"iso\", lubrication = \"jet\" }\nbulk_temperature = \"90 °C\"", "E205", &["operation.bulk", "state operation.oil_temperature instead"]),
    bad("bulk_temperature", "oil_temperature = \"90 °C\"", "E205", &["operation.oil_temperature", "needs a law by which", "bulk = { law = \"iso\", lubrication = \"dip\" }", "\"network\"", "unconfirmed"]),
    bad("depths", "film_friction = \"constant\"", "E205", &["model.film_friction", "needs its coefficient", "{ constant = 0.05 }"]),
    bad("depths", "film_friction = { constnt = 0.05 }", "E203", &["model.film_friction.constnt", "\"constant\""]),
    bad("depths", "film_friction = { constant = 0.05, xu = \"xu.json\" }", "E204", &["model.film_friction", "one law only"]),
    about_table("helix", "profile_shift = [5, 5]", "E206", &["tooth of the pinion is pointed"], "[gears]"),
    about_table("helix", "centre_distance = \"10 mm\"", "E206", &["10 mm", "base radii"], "[gears]"),
    bad("base_oil", "pressure_viscosity = \"2e-8 mm2/N\"", "E207", &["lubricant.pressure_viscosity = \"2e-8 mm2/N\"", "10^6 below any oil", "Did you mean 2e-8 m2/N?"]),
    about_table("base_oil", "", "E208", &["no pressure-viscosity coefficient", "base_oil (mineral, naphthenic"], "[lubricant]"),
    about_table("density", "", "E208", &["no density"], "[lubricant]"),
    about_table("viscosity", "oil = \"olive\"", "E208", &["no oil \"olive\"", "m100"], "[lubricant]"),
    about_table("viscosity", "oil = \"ISO VG 100\"", "E208", &["no oil \"ISO VG 100\"", "viscosity = { grade = \"ISO VG 100\", viscosity_index"], "[lubricant]"),
    about_table("viscosity", "viscosity = { law = \"given\", dynamic_viscosity = \"97.5 mPa s\" }", "E208", &["no temperature coefficient", "0.02 to 0.06 1/K"], "[lubricant]"),
    bad("teeth", "teeth = [0, 0]", "E209", &["gears.teeth = [0, 0]", "at least 1"]),
    bad("module", "module = \"-1.8 mm\"", "E209", &["gears.module = \"-1.8 mm\"", "greater than zero"]),
    bad("module", "module = \"1e300 mm\"", "E212", &["gears.module = \"1e300 mm\"", "beyond physical sense", "usual is 0.3 to 40 mm"]),
    bad("module", "module = \"1.8 m\"", "E212", &["gears.module = \"1.8 m\": 1800 mm is beyond physical sense"]),
    bad("speed", "speed = \"1e9 1/min\"", "E212", &["operation.speed", "usual is 1 to 60000 1/min"]),
    bad("torque", "torque = \"1e9 N m\"", "E212", &["operation.torque", "usual is 0.01 to 1000000 N m"]),
    bad("bulk_temperature", "bulk_temperature = \"-60 °C\"", "E212", &["operation.bulk_temperature", "Pa s there", "usual is 0.001 to 10 Pa s"]),
    bad("density", "density = \"845000 kg/m3\"", "E212", &["lubricant.density", "usual is 700 to 1200 kg/m3"]),
    bad("elastic_limit", "elastic_limit = \"1500 GPa\"", "E212", &["material.pinion.elastic_limit", "usual is 150 to 4000 MPa"]),
    bad("viscosity", "viscosity = { law = \"astm-d341\", at_40 = \"30.8 m2/s\", at_100 = \"5.9 m2/s\" }", "E212", &["lubricant.viscosity.at_40", "usual is 5 to 2000 mm2/s"]),
    bad("offsets", "tolerance = 1e-2", "E211", &["model.tolerance = 1e-2", "1e-16 to 1e-4"]),
    bad("helix", "helix = \"95 deg\"", "E209", &["gears.helix = \"95 deg\"", "within 60 deg"]),
    bad("torque", "torque = \"0 N m\"", "E209", &["operation.torque = \"0 N m\"", "not zero"]),
    bad("speed", "speed = \"0 rpm\"", "E209", &["operation.speed = \"0 rpm\"", "greater than zero"]),
    bad("elastic_limit", "elastic_limit = \"-3 MPa\"", "E209", &["material.pinion.elastic_limit = \"-3 MPa\"", "greater than zero"]),
    bad("elastic_limit", "poisson = 0.7", "E209", &["material.pinion.poisson = 0.7", "not above 0.5"]),
    bad("density", "density = \"0 kg/m3\"", "E209", &["lubricant.density = \"0 kg/m3\"", "greater than zero"]),
    bad("cutoff", "cutoff = \"-1 mm\"", "E209", &["surface.cutoff = \"-1 mm\"", "not negative"]),
    bad("pinion", "pinion = { rq = \"-1 um\" }", "E209", &["surface.pinion.rq = \"-1 um\"", "greater than zero"]),
    bad("helix", "wheel.tip_chamfer = \"-1 mm\"", "E209", &["gears.wheel.tip_chamfer = \"-1 mm\"", "not negative"]),
    bad("positions", "positions = 0", "E209", &["model.positions = 0", "1 to 10000"]),
    bad("positions", "positions = 1", "E209", &["model.positions", "1 mesh positions were requested", "needs 2 to"]),
    bad("offsets", "offsets = 0", "E209", &["model.offsets = 0", "1 to 10000"]),
    bad("offsets", "window = nan", "E209", &["model.window = nan", "1.5 to 100"]),
    bad("offsets", "tolerance = 1e-30", "E209", &["model.tolerance = 1e-30", "1e-16 to 1e-4"]),
    bad("offsets", "load_distribution = \"trapezoid\"", "E209", &["model.load_distribution", "for spur pairs"]),
];

#[test]
fn text_and_keys_that_mean_nothing_are_pointed_at() {
    each_is_refused_with_its_line(SPELLING);
}

#[test]
fn values_that_cannot_be_read_name_key_and_expectation() {
    each_is_refused_with_its_line(VALUES);
}

#[test]
fn values_that_cannot_be_name_what_is_written_and_the_rule() {
    each_is_refused_with_its_line(DOMAINS);
}

fn each_is_refused_with_its_line(table: &[Bad]) {
    let bench = Bench::new();
    bench.write_flanks();
    for entry in table {
        bench.write("case.toml", with_line(entry.key, entry.line));
        let before = bench.listing();
        let said = bench.run(&["run", "case.toml", "-o", "out"]);
        let line = line_of(entry.table.unwrap_or(entry.key));
        let place = format!("case.toml:{line}: ");
        let says: Vec<&str> = std::iter::once(place.as_str())
            .chain(entry.says.iter().copied())
            .collect();
        said.refused(2, entry.code, &says);
        assert_eq!(bench.listing(), before, "nothing is left behind");
    }
}

#[test]
fn a_case_that_is_no_file_of_text_is_told_so() {
    let bench = Bench::new();
    bench.write("empty.toml", "");
    bench.write("latin.toml", b"title = \"a\"\ntitel = \"caf\xe9\"\n");
    bench.write("half.json", "{ \"gears\": {\n");
    bench.write("json.toml", "{ \"gears\": {} }");
    bench.write("trace.csv", "x_um,z_um\n0.0,0.1\n");
    std::fs::create_dir(bench.path("folder")).unwrap();
    for (name, code, says) in [
        ("nosuch.toml", "E201", "nosuch.toml: cannot be opened"),
        (
            "folder",
            "E201",
            "folder: is a folder; name the case file in it",
        ),
        ("empty.toml", "E204", "empty.toml: missing key \"gears\""),
        ("latin.toml", "E202", "latin.toml:2: is not text in UTF-8"),
        ("half.json", "E202", "half.json:2: EOF"),
        ("json.toml", "E202", "JSON goes into a file named .json"),
        ("trace.csv", "E202", "it names a trace as file of"),
    ] {
        bench.run(&["run", name]).refused(2, code, &[says]);
    }
    assert!(!bench.listing().contains(&"results".to_owned()));
}

#[test]
fn a_case_in_json_is_read_and_its_faults_are_placed() {
    let bench = Bench::new();
    bench.write_flanks();
    let case: toml::Value = toml::from_str(E_DRIVE).unwrap();
    let good = serde_json::to_string_pretty(&case).unwrap();
    bench.write("case.json", &good);
    bench.write("case.toml", E_DRIVE);
    let result = |name| {
        bench
            .run(&["run", name, "--no-output", "--json"])
            .well()
            .json()
    };
    assert_eq!(
        result("case.json")["summary"],
        result("case.toml")["summary"]
    );
    let line = 1 + good
        .lines()
        .position(|line| line.contains("\"module\""))
        .unwrap();
    let at = format!("bad.json:{line}");
    for (from, to, code, says) in [
        (
            "\"module\"",
            "\"modul\"",
            "E203",
            "Did you mean \"module\"?",
        ),
        ("\"1.8 mm\"", "1.8", "E204", "gears.module: 1.8 has no unit"),
        (
            "\"1.8 mm\"",
            "\"-1 mm\"",
            "E209",
            "gears.module = \"-1 mm\"",
        ),
    ] {
        bench.write("bad.json", good.replace(from, to));
        bench
            .run(&["run", "bad.json"])
            .refused(2, code, &[&at, says]);
    }
    // The parser of JSON places a missing key at the end of its table.
    for (from, to, says) in [
        (
            "\"module\": \"1.8 mm\",",
            "",
            "gears: missing key \"module\"",
        ),
        (
            "\"mirrored\": true",
            "\"mirrored\": 1",
            "surface.wheel.mirrored: integer `1`",
        ),
        ("    23,", "    \"many\",", "gears.teeth: string \"many\""),
    ] {
        assert!(good.contains(from), "{from} is not in {good}");
        bench.write("bad.json", good.replace(from, to));
        let said = bench.run(&["run", "bad.json"]);
        said.refused(2, "E204", &["bad.json:", says]);
    }
}

#[test]
fn an_error_is_json_on_request() {
    let bench = Bench::new();
    bench.write("case.toml", with_line("module", "module = 1.8"));
    let said = bench.run(&["run", "case.toml", "--json"]);
    assert_eq!(said.status, 2);
    let error = &said.json()["error"];
    assert_eq!(error["code"], "E204");
    assert_eq!(error["exit_status"], 2);
    assert!(
        error["message"]
            .as_str()
            .unwrap()
            .contains("case.toml:5: gears.module")
    );
    assert!(
        error["remedy"]
            .as_str()
            .unwrap()
            .contains("asperity schema")
    );
}

#[test]
fn options_that_make_no_sense_are_refused_before_any_work() {
    let bench = Bench::new();
    bench.write("case.toml", E_DRIVE);
    bench.write_flanks();
    for (arguments, code, says) in [
        (
            &["contact", "case.toml", "--position", "7"][..],
            "E209",
            "--position 7: must be A to E",
        ),
        (
            &["film", "case.toml", "--position", "-1"],
            "E209",
            "--position -1",
        ),
        (
            &["contact", "case.toml", "--tolerance", "1"],
            "E211",
            "at most 1e-4",
        ),
        (
            &["contact", "case.toml", "--tolerance", "nan"],
            "E209",
            "--tolerance NaN",
        ),
        (
            &["compare", "case.toml", "--finish", "a=pinion.csv"][..],
            "E205",
            "give at least two",
        ),
        (
            &[
                "compare",
                "case.toml",
                "--finish",
                "a=pinion.csv",
                "--finish",
                "a=wheel.csv",
            ],
            "E205",
            "two finishes have this name",
        ),
        (
            &[
                "compare",
                "case.toml",
                "--finish",
                "a=pinion.csv",
                "--finish",
                "b=wheel.csv",
                "--offsets",
                "1",
            ],
            "E209",
            "--offsets = 1: must be at least 2",
        ),
        (
            &["equations", "P99"],
            "E210",
            "no equation has the tag \"P99\"",
        ),
        (&["explain", "X1"], "E210", "no message has the code \"X1\""),
    ] {
        bench.run(arguments).refused(2, code, &[says]);
    }
    for (arguments, says) in [
        (&["run"][..], "<CASE>"),
        (&["frobnicate"], "unrecognized subcommand"),
        (&["run", "case.toml", "--threads", "0"], "0 is not in 1.."),
        (&["contact"], "<CASE>"),
        (
            &["film", "case.toml", "--position", "F"],
            "expected one of `A`",
        ),
        (
            &["profile", "info", "pinion.csv", "--z-unit", "parsec"],
            "m, mm, um, nm",
        ),
    ] {
        let said = bench.run(arguments);
        said.refused(2, "E213", &[says]);
        assert!(said.err.contains("--help"), "{}", said.err);
    }
    let said = bench.run(&["run", "case.toml", "--json", "--ofsets", "2"]);
    said.refused_json("E213", "'--ofsets'");
    let remedy = said.json()["error"]["remedy"].clone();
    assert!(remedy.as_str().unwrap().contains("Usage: asperity run"));
}

#[test]
fn a_value_that_was_set_is_quoted_and_not_the_one_of_the_file() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let table = "gears={ teeth = [23, 68], module = \"-1 mm\", face_width = \"32 mm\" }";
    let said = bench.run(&["run", "case.toml", "--no-output", "--set", table]);
    assert_eq!(said.status, 2);
    let message = said.err.lines().next().unwrap();
    assert!(
        message.starts_with("E209 case.toml (changed): gears.module = \"-1 mm\""),
        "{message}"
    );
    assert!(!message.contains("1.8 mm"), "{message}");
}

/// The longest run of digits in a text.
fn longest_number(text: &str) -> usize {
    let runs = text.split(|c: char| !c.is_ascii_digit());
    runs.map(str::len).max().unwrap_or(0)
}

#[test]
fn messages_about_absurd_numbers_are_short() {
    let bench = Bench::new();
    bench.write("case.toml", E_DRIVE);
    bench.write_flanks();
    let keys = [
        ("operation.torque", "N m"),
        ("operation.speed", "1/min"),
        ("operation.bulk_temperature", "K"),
        ("gears.module", "mm"),
        ("gears.face_width", "mm"),
        ("gears.centre_distance", "mm"),
        ("material.pinion.young", "GPa"),
        ("lubricant.density", "kg/m3"),
        ("surface.cutoff", "mm"),
        ("model.boundary_friction", ""),
        ("model.window", ""),
        ("model.tolerance", ""),
    ];
    for (key, unit) in keys {
        for number in [
            "1e300",
            "1.2345678901234567e9",
            "-1e-300",
            "0.1234567890123456",
        ] {
            let set = format!("{key}={number} {unit}");
            let said = bench.run(&["check", "case.toml", "--set", set.trim()]);
            // The value itself is shown as it is written.
            let message = (said.out + &said.err).replace(number, "");
            assert!(longest_number(&message) < 12, "{set}: {message}");
        }
    }
    // A number that the program computed.
    let seal = r#"gearbox={ seals = [{ shaft = "pinion", diameter = "900 mm" }] }"#;
    let run = ["run", "case.toml", "--set", "operation.torque=40 N m"];
    let said = bench.run(&[&run[..], &["--set", seal]].concat());
    assert!(
        said.err.contains("are not below the input power"),
        "{}",
        said.err
    );
    assert!(longest_number(&said.err) < 6, "{}", said.err);
}

#[test]
fn help_fits_the_fault() {
    let bench = Bench::new();
    bench.write("case.toml", E_DRIVE);
    bench.write_flanks();
    let cases: [(&[&str], &str, &str, &str); 6] = [
        (
            &["evidence", "case.toml", "--hours", "x=1e308"],
            "E209",
            "no measurement is called \"x\"",
            "one of the names traction-curve, ",
        ),
        (
            &["evidence", "case.toml", "--hours", "rig-day=1e308"],
            "E209",
            "the hours must be a number from 0 to below 1e6",
            "",
        ),
        (
            &[
                "callout",
                "case.toml",
                "--loss",
                "500 W",
                "--confidence",
                "90",
            ],
            "E209",
            "confidence = 9000 %",
            "write 0.9 or \"90 %\"",
        ),
        (
            &["callout", "case.toml", "--loss=-5 W"],
            "E209",
            "loss = -5 W: must be positive",
            "",
        ),
        (
            &["callout", "case.toml", "--loss", "-5 W"],
            "E209",
            "loss = -5 W: must be positive",
            "",
        ),
        (
            &["run", "case.toml", "--threads", "-5 W"],
            "E213",
            "unexpected argument '-5",
            "a negative value follows an equals sign, as --option=\"-5",
        ),
    ];
    for (arguments, code, says, help) in cases {
        let said = bench.run(arguments);
        assert!(said.err.starts_with(code), "{}", said.err);
        let (message, advice) = said.err.split_once("\n  help: ").unwrap();
        assert!(message.contains(says), "{message}");
        assert!(advice.contains(help), "{advice}");
    }
    if cfg!(target_os = "linux") {
        let full = std::fs::File::create("/dev/full").unwrap();
        let oils = std::process::Command::new(crate::bench::program())
            .args(["list", "oils"])
            .stdout(full)
            .output()
            .unwrap();
        let err = String::from_utf8(oils.stderr).unwrap();
        assert!(err.starts_with("E401 standard output: "), "{err}");
        assert!(err.contains("help: Redirect the output"), "{err}");
    }
}

#[test]
fn flanks_without_traces_do_not_run_in_and_their_case_is_named_once() {
    let bench = Bench::new();
    let known = r#"{ rq = "0.3 um", rpk = "0.1 um" }"#;
    let case = E_DRIVE
        .replace(r#"{ file = "pinion.csv" }"#, known)
        .replace(r#"{ file = "wheel.csv", mirrored = true }"#, known);
    bench.write("case.toml", case);
    let said = bench.run(&["running-in", "case.toml", "--no-output"]);
    let says = "needs the traces of both flanks, files of surface.pinion and surface.wheel";
    said.refused(2, "E205", &["operation.running_in", says]);
    assert_eq!(said.err.matches("case.toml").count(), 1, "{}", said.err);
}
