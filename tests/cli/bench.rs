//! A folder to work in, and the program to run in it.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

/// Root of the workspace.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The program, which Cargo builds with the tests of this package.
pub fn program() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_asperity-tested"))
}

fn said(output: Output) -> Said {
    Said {
        status: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Output of the program and its exit status.
#[derive(Debug)]
pub struct Said {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Said {
    /// The same, if it went well.
    #[track_caller]
    pub fn well(self) -> Self {
        assert_eq!(self.status, 0, "{}", self.err);
        assert_eq!(self.err, "");
        self
    }

    /// Checks an error: exit status, code, and what the message must say; plain text, no panic.
    #[track_caller]
    pub fn refused(&self, status: i32, code: &str, says: &[&str]) {
        assert_eq!(self.out, "", "an error goes to standard error");
        self.failed(status, code, says);
    }

    /// A trace was read and its facts shown, but it has no parameters, for the reason on standard error.
    pub fn informed(&self, code: &str, says: &[&str]) {
        for part in [
            "heights from",
            "filter state",
            "No parameters",
            "pinion = { file =",
        ] {
            assert!(self.out.contains(part), "{part:?} is not in {}", self.out);
        }
        self.failed(2, code, says);
    }

    /// A surface was read and its facts shown, but no trace of it was chosen.
    pub fn surveyed(&self, says: &[&str]) {
        for part in [
            "rows of",
            "are missing",
            "areal parameters",
            "pinion = { file =",
        ] {
            let is_shown =
                self.out.contains(part) || part == "areal parameters" && self.out.contains("Sdq");
            assert!(is_shown, "{part:?} is not in {}", self.out);
        }
        self.failed(2, "E119", says);
    }

    pub fn failed(&self, status: i32, code: &str, says: &[&str]) {
        assert_eq!(self.status, status, "{self:?}");
        assert!(self.err.starts_with(&format!("{code} ")), "{}", self.err);
        let message = self.err.lines().next().unwrap();
        for part in says {
            assert!(message.contains(part), "{part:?} is not in {message:?}");
        }
        assert!(self.err.contains("\n  help: "), "{}", self.err);
        assert!(!self.err.contains("panicked"), "{}", self.err);
        assert!(!self.err.contains('\u{1b}'), "no colours in a pipe");
    }

    /// Checks an error that a command with `--json` tells: its code, and what its message must say.
    #[track_caller]
    pub fn refused_json(&self, code: &str, says: &str) {
        assert_ne!(self.status, 0, "{self:?}");
        let error = &self.json()["error"];
        assert_eq!(error["code"], code, "{error:#}");
        assert!(
            error["message"].as_str().unwrap().contains(says),
            "{error:#}"
        );
    }

    /// Standard output with lines that were broken for the terminal in one piece.
    pub fn unwrapped(&self) -> String {
        let whole = |text: String, line: &str| match line.strip_prefix("    ") {
            Some(rest) => text.trim_end().to_owned() + " " + rest.trim_start() + "\n",
            None => text + line + "\n",
        };
        self.out.lines().fold(String::new(), whole)
    }

    /// Standard output as JSON.
    #[track_caller]
    pub fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).unwrap()
    }
}

/// A folder of its own for one test.
pub struct Bench(TempDir);

impl Bench {
    /// An empty folder.
    pub fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// A file or folder in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    /// Writes the ground flanks that go with [`E_DRIVE`].
    pub fn write_flanks(&self) {
        for (file, name) in [("ground_pinion", "pinion"), ("ground_wheel", "wheel")] {
            let trace = root().join(format!("fixtures/profiles/{file}.csv"));
            fs::copy(trace, self.path(&format!("{name}.csv"))).unwrap();
        }
    }

    /// Leaves 1.25 mm of both flanks, from which flanks like them are generated sooner.
    pub fn shorten_flanks(&self) {
        for name in ["pinion.csv", "wheel.csv"] {
            let text = fs::read_to_string(self.path(name)).unwrap();
            let rows: Vec<&str> = text.lines().take(1 + 2500).collect();
            self.write(name, rows.join("\n"));
        }
    }

    /// Writes the trace `from` after a test as `to`, from 150 um on and 2 um higher: everything more than 0.3 um above the mean of
    /// 0.25 mm around it is removed. Returns the mean height removed \[nm\].
    pub fn write_worn(&self, from: &str, to: &str) -> f64 {
        const SHIFT: usize = 300;
        const AROUND: usize = 250;
        const LEVEL: f64 = 0.3;
        const RAISED: f64 = 2.0;
        let text = fs::read_to_string(self.path(from)).unwrap();
        let (header, rows) = text.split_once('\n').unwrap();
        let rows: Vec<(&str, &str)> = rows.lines().filter_map(|row| row.split_once(',')).collect();
        let heights = rows.iter().map(|(_, z)| z.trim().parse::<f64>().unwrap());
        let heights: Vec<f64> = heights.collect();
        let (mut worn, mut removed) = (format!("{header}\n"), Vec::new());
        for (i, (x, _)) in (SHIFT..heights.len()).zip(&rows) {
            let around = &heights[i - AROUND..heights.len().min(i + AROUND + 1)];
            let most = around.iter().sum::<f64>() / around.len() as f64 + LEVEL;
            worn += &format!("{x},{:.5}\n", heights[i].min(most) + RAISED);
            removed.push(1e3 * (heights[i] - heights[i].min(most)));
        }
        self.write(to, worn);
        removed.iter().sum::<f64>() / removed.len() as f64
    }

    /// Runs the program in the folder, a command with a report with all that it prints.
    pub fn run(&self, arguments: &[&str]) -> Said {
        const REPORTED: [&str; 16] = [
            "calibrate",
            "callout",
            "check",
            "compare",
            "contact",
            "cycle",
            "design",
            "ehl",
            "evidence",
            "film",
            "gear",
            "map",
            "oil",
            "profile",
            "ridges",
            "sensitivity",
        ];
        let is_reported = arguments
            .first()
            .is_some_and(|name| REPORTED.contains(name));
        let notes: &[&str] = if is_reported { &["--notes"] } else { &[] };
        self.first_screen(&[arguments, notes].concat())
    }

    /// Runs the program in the folder with these arguments only.
    pub fn first_screen(&self, arguments: &[&str]) -> Said {
        self.run_with(arguments, &[])
    }

    /// Runs the program in the folder with environment variables.
    pub fn run_with(&self, arguments: &[&str], environment: &[(&str, &str)]) -> Said {
        let output = Command::new(program())
            .args(arguments)
            .current_dir(self.0.path())
            .env_remove("NO_COLOR")
            .envs(environment.iter().copied())
            .output()
            .unwrap();
        said(output)
    }

    /// Runs the program in the folder with `input` on its standard input.
    pub fn run_with_input(&self, arguments: &[&str], input: &str) -> Said {
        let mut child = Command::new(program())
            .args(arguments)
            .current_dir(self.0.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut pipe = child.stdin.take().unwrap();
        // The program may have its answers and end before it has read all of them.
        let _ = pipe.write_all(input.as_bytes());
        drop(pipe);
        said(child.wait_with_output().unwrap())
    }

    /// Names of everything in the folder, hidden files too.
    pub fn listing(&self) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.0.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

/// The lines of [`E_DRIVE`] that state its tip relief; a key alone names a flank under `[surface]`.
pub const NO_RELIEF: &str = " pinion.tip_relief = \"none\"\n wheel.tip_relief = \"none\"\n";

/// An oil file of the oil of [`E_DRIVE`].
pub const OIL_FILE: &str = r#"schema = "asperity-oil-1"

[lubricant]
viscosity = { law = "astm-d341", at_40 = "30.8 mm2/s", at_100 = "5.9 mm2/s" }
density = "845 kg/m3"
base_oil = "pao"

[film_friction]
pressure_law = "barus"
eyring_stress = { value = "4.8 MPa", low = "4.4 MPa", high = "5.2 MPa" }
limiting_shear = { value = 0.035, low = 0.031, high = 0.040 }
limiting_shear_temperature = { value = 0.0001, low = -0.002, high = 0.0022 }
pressure_viscosity_factor = { value = 0.95, low = 0.92, high = 0.98 }
correlations = [{ between = ["eyring_stress", "pressure_viscosity_factor"], value = -0.66 }]
temperatures = ["40 °C", "120 °C"]
pressure_max = "1.19 GPa"
fit = { points = 100, chi2_per_point = 0.76, other_law = 309.0, this_law = 78.0 }
source = "curves.csv"
"#;

/// A small case of an electric drive: few positions and offsets, so that a run takes no time.
pub const E_DRIVE: &str = r#"title = "small case"

[gears]
teeth = [23, 68]
module = "1.8 mm"
helix = "23.4 deg"
face_width = ["35 mm", "32 mm"]
 pinion.tip_relief = "none"
 wheel.tip_relief = "none"

[material.pinion]
elastic_limit = "1500 MPa"
flow_pressure = "7 GPa"

[operation]
torque = "145 N m"
speed = "9000 1/min"
bulk_temperature = "90 °C"

[lubricant]
viscosity = { law = "astm-d341", at_40 = "30.8 mm2/s", at_100 = "5.9 mm2/s" }
density = "845 kg/m3"
base_oil = "pao"

[surface]
cutoff = "0.25 mm"
pinion = { file = "pinion.csv" }
wheel = { file = "wheel.csv", mirrored = true }

[model]
positions = 2
offsets = 2
depths = 0
"#;

/// [`E_DRIVE`] with the line that starts with `key` replaced; an empty line leaves the key out.
pub fn with_line(key: &str, line: &str) -> String {
    let mut replaced = 0;
    let lines: Vec<&str> = E_DRIVE
        .lines()
        .map(|old| {
            if old.starts_with(key) {
                replaced += 1;
                line
            } else {
                old
            }
        })
        .collect();
    assert_eq!(replaced, 1, "{key:?} starts {replaced} lines");
    lines.join("\n") + "\n"
}

/// Number of the line of [`E_DRIVE`] that starts with `key`.
pub fn line_of(key: &str) -> usize {
    1 + E_DRIVE
        .lines()
        .position(|line| line.starts_with(key))
        .unwrap()
}

/// Heights [µm] of a rough trace without chance: three waves that share no period.
pub fn heights(points: usize) -> Vec<f64> {
    let wave = |i: usize, period: f64| (std::f64::consts::TAU * i as f64 / period).sin();
    (0..points)
        .map(|i| 0.3 * wave(i, 101.0) + 0.2 * wave(i, 37.7) + 0.1 * wave(i, 13.3))
        .collect()
}

/// Rows `x;z` of a trace, `cells` making the text of both from index and height.
pub fn rows(points: usize, cells: impl Fn(usize, f64) -> String) -> String {
    let heights = heights(points);
    let rows = heights.iter().enumerate().map(|(i, z)| cells(i, *z) + "\n");
    rows.collect()
}

/// A trace in micrometres, half a micrometre apart, with the header given.
pub fn trace(header: &str, points: usize) -> String {
    let table = rows(points, |i, z| format!("{:.1},{z:.5}", 0.5 * i as f64));
    format!("{header}\n{table}")
}
