//! Scans that are used whole: patches of flanks without a strong lay, rows of ridged flanks.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use std::f64::consts::TAU;

use asperity::case::{LoadedCase, from_text};
use asperity::core::Code;
use asperity::core::quantity::Length;
use asperity::{Error, losses};

const COLUMNS: usize = 1500;
const ROWS: usize = 24;

/// A scan in the text format of ISO 25178-71, points 1 um and rows 2 um apart. Its name is the length of its waves along the lead over
/// their length along rolling, its height in nm, and a seed.
fn scan(name: &str) -> Vec<u8> {
    if let Some(tilt) = name.strip_prefix("oblique ") {
        let tilt: f64 = tilt.parse().unwrap();
        let height = |x: f64, y: f64| {
            let missing = tilt > 0.0 && (x, y) == (200.0, 10.0);
            if missing {
                f64::NAN
            } else {
                100.0 * (TAU * (x / 40.0 + tilt * y / 60.0)).cos()
            }
        };
        return file(height);
    }
    let mut numbers = name.split('-').map(|number| number.parse::<f64>().unwrap());
    let [ratio, height, seed] = [0; 3].map(|_| numbers.next().unwrap());
    let waves: Vec<[f64; 4]> = (0..60)
        .map(|k| {
            let part = |by: f64| ((f64::from(k) + seed) * by).fract();
            let (length, angle) = (7.0 * 6.0_f64.powf(part(0.618_034)), TAU * part(0.754_878));
            let [x, y] = [angle.cos() / length, angle.sin() / length / ratio];
            [
                x,
                y,
                TAU * part(0.569_84),
                height / 1.3e2_f64.sqrt() * length.sqrt(),
            ]
        })
        .collect();
    file(|x, y| {
        let wave =
            |[kx, ky, phase, size]: &[f64; 4]| size * (TAU * (kx * x + ky * y) + phase).cos();
        waves.iter().map(wave).sum()
    })
}

/// A scan of heights \[nm\]; values that are not numbers are missing.
fn file(height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    let mut text = format!(
        "aISO-1.0\nManufacID   = made\nCreateDate  = 271120260000\nModDate     = 271120260000\nNumPoints   = {COLUMNS}\n\
         NumProfiles = {ROWS}\nXscale      = 1E-06\nYscale      = 2E-06\nZscale      = 1E-09\nZresolution = -1\n\
         Compression = 0\nDataType    = 7\nCheckType   = 0\n*\n"
    );
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let (x, y) = (column as f64, 2.0 * row as f64);
            let z = height(x, y);
            text += &match z.is_finite() {
                true => format!("{z:.3} "),
                false => "BAD ".to_owned(),
            };
        }
        text.push('\n');
    }
    (text + "*\n").into_bytes()
}

fn case(names: [&str; 2], keys: &str) -> Result<LoadedCase, Error> {
    case_of(names.map(|name| format!("file = \"{name}\"")), keys)
}

fn case_of(flanks: [String; 2], keys: &str) -> Result<LoadedCase, Error> {
    let [pinion, wheel] = flanks;
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\" }}\n\
         material.pinion = {{ elastic_limit = \"1500 MPa\", flow_pressure = \"7 GPa\" }}\n\
         operation = {{ torque = \"30 N m\", speed = \"6000 1/min\", bulk_temperature = \"90 degC\" }}\n\
         lubricant = {{ viscosity = {{ law = \"astm-d341\", at_40 = \"30.8 mm2/s\", at_100 = \"5.9 mm2/s\" }}, density = \"845 kg/m3\", base_oil = \"pao\" }}\n\
         model = {{ positions = 2, offsets = 1, depths = 0 }}\n\
         [surface]\ncutoff = \"0.08 mm\"\n{keys}\npinion = {{ {pinion} }}\nwheel = {{ {wheel} }}\n"
    );
    from_text("case.toml", &text, &|name| Ok(scan(name)))
}

fn loss(names: [&str; 2], keys: &str) -> f64 {
    losses(&case(names, keys).unwrap()).unwrap().summary.loss_w
}

#[test]
fn scans_are_taken_by_their_lay() {
    // Ridges across the face: rows of each scan, in pairs.
    let ridged = case(["60-200-1", "60-200-9"], "").unwrap();
    assert!(ridged.surfaces.sheets().is_none());
    assert_eq!(ridged.surfaces.pairs(), 16);
    let sampled = ridged.sampled.as_ref().unwrap();
    let row = sampled.traces[1][3].row.unwrap();
    assert_eq!(
        (row.number, row.along_lead),
        (22, Some(Length::from_si(42e-6)))
    );
    let isotropic = case(["1-200-1", "1-200-9"], "").unwrap();
    let sheets = isotropic.surfaces.sheets().unwrap();
    assert_eq!(
        (sheets.rows(), isotropic.surfaces.pairs()),
        (ROWS - ROWS / 8, 1)
    );
    let by_hand = case(["1-200-1", "1-200-9"], "contact = \"lines\"").unwrap();
    assert_eq!(by_hand.surfaces.pairs(), 16);
    let by_hand = case(["60-200-1", "60-200-9"], "contact = \"patch\"").unwrap();
    assert!(by_hand.surfaces.sheets().is_some());
}

#[test]
fn summits_carry_more_in_a_patch_than_in_its_rows() {
    let names = ["1-25-1", "1-25-9"];
    let [patch, lines] =
        ["patch", "lines"].map(|contact| loss(names, &format!("contact = \"{contact}\"")));
    assert!(patch > 1.1 * lines, "{patch} W, {lines} W");
    // Heights of some nanometres lose what smooth flanks lose.
    let smooth = ["1-0.1-1", "1-0.1-9"];
    let [patch, lines] =
        ["patch", "lines"].map(|contact| loss(smooth, &format!("contact = \"{contact}\"")));
    assert!((patch / lines - 1.0).abs() < 1e-3, "{patch} W, {lines} W");
}

#[test]
fn a_patch_of_some_rows_is_refused() {
    let flanks = ["1-200-1", "1-200-9"].map(|name| format!("file = \"{name}\", rows = 3"));
    let error = case_of(flanks, "contact = \"patch\"")
        .map(|_| ())
        .unwrap_err();
    assert_eq!(error.code(), Code::E205);
    assert!(
        error.to_string().contains("one scan of each flank"),
        "{error}"
    );
}

#[test]
fn ridges_of_both_scans_meet_as_in_the_gears() {
    // The step along rolling from one row to the next at which its heights return.
    let step = |rows: &[f64], columns: usize| {
        let [first, second] = [10, 11].map(|row: usize| &rows[row * columns..][..columns]);
        let product = |step: i32| -> f64 {
            let pairs = (100..1000_i32).map(|x| first[x as usize] * second[(x + step) as usize]);
            pairs.sum()
        };
        (-9..=9)
            .max_by(|a, b| product(*a).total_cmp(&product(*b)))
            .unwrap()
    };
    // Seen from outside of its material, the wheel has the mirror image of ridges that are parallel in contact.
    for mirrored in [false, true] {
        let wheel = format!("file = \"oblique -1\", mirrored = {mirrored}");
        let case = case_of(
            ["file = \"oblique 1\"".to_owned(), wheel],
            "contact = \"patch\"",
        )
        .unwrap();
        let sheets = case.surfaces.sheets().unwrap();
        let [pinion, wheel] = [0, 1].map(|body| {
            let (rows, columns) = sheets.of_body(body);
            step(rows, columns)
        });
        assert_eq!(pinion, -1, "{mirrored}");
        assert_eq!(wheel, pinion, "{mirrored}");
        let told = |code| case.warnings.iter().any(|warning| warning.code == code);
        assert!(told(Code::W459));
        let said = case
            .warnings
            .iter()
            .find(|warning| warning.code == Code::W460);
        assert!(said.is_some_and(|said| said.to_string().contains("0.0 %")));
    }
}
