//! Scans that are used whole: patches of flanks without a strong lay, rows of ridged flanks.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use std::f64::consts::TAU;

use crate::runs::losses;
use asperity::case::{LoadedCase, from_text};
use asperity::core::Code;
use asperity::core::quantity::{Length, Torque};
use asperity::pipeline::{Kept, less_of_scans};
use asperity::roughness::form::Form;
use asperity::roughness::gaussian_filter::Ends;
use asperity::roughness::preparation::Preparation;
use asperity::roughness::surface_preparation::prepare_surface;
use asperity::{Error, Run};
use asperity_case::flanks::scan::{middle, rows_needed};

const COLUMNS: usize = 1500;
const ROWS: usize = 24;

/// A scan in the text format of ISO 25178-71, points 1 um and rows 2 um apart. Its name is the length of its waves along the lead over
/// their length along rolling, its height in nm, and a seed; before them a fault.
fn scan(name: &str) -> Vec<u8> {
    if let Some((fault, name)) = name
        .split_once(' ')
        .filter(|(fault, _)| *fault != "oblique")
    {
        let height = waves(name);
        return match fault {
            "trace" => trace(height),
            "tiny" => file_of((120, ROWS), ["1E-06", "2E-06"], height),
            "short" => file_of((420, ROWS), ["1E-06", "2E-06"], height),
            "coarse" => file_of((COLUMNS, ROWS), ["3E-06", "3E-06"], height),
            "narrow" => file_of((COLUMNS, ROWS), ["1E-06", "1E-07"], height),
            _ => file(with_fault(fault.to_owned(), height)),
        };
    }
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
    file(waves(name))
}

/// Heights \[nm\] with a fault of a measurement.
fn with_fault(fault: String, height: impl Fn(f64, f64) -> f64) -> impl Fn(f64, f64) -> f64 {
    let row_in_the_middle = ROWS as f64;
    move |x, y| {
        // Two irrational steps fill the plane evenly.
        let part = (x * 0.754_877_67 + y * 0.284_920_13).fract();
        let z = height(x, y);
        match fault.as_str() {
            "gaps" if part < 0.1 => f64::NAN,
            "holes" if part < 0.3 => f64::NAN,
            "hole" if (y, x) == (row_in_the_middle, 300.0) => f64::NAN,
            "ends" if !(40.0..1440.0).contains(&x) => f64::NAN,
            "spikes" if part < 0.002 => z + 20_000.0,
            "tilted" => z + 20.0 * x - 50.0 * y,
            "round" => z - 0.02 * (x - 700.0).powi(2),
            "step" if x > 700.0 => z + 4000.0,
            "edges" if !(400.0..1100.0).contains(&x) => f64::NAN,
            _ => z,
        }
    }
}

/// Heights \[nm\] of waves.
fn waves(name: &str) -> impl Fn(f64, f64) -> f64 {
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
    move |x, y| {
        let wave =
            |[kx, ky, phase, size]: &[f64; 4]| size * (TAU * (kx * x + ky * y) + phase).cos();
        waves.iter().map(wave).sum()
    }
}

/// The row at the beginning as a trace.
fn trace(height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    let rows = (0..COLUMNS).map(|x| format!("{x};{:.3}\n", height(x as f64, 0.0)));
    format!("x [um];z [nm]\n{}", rows.collect::<String>()).into_bytes()
}

/// A scan of heights \[nm\] with all points and rows.
fn file(height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    file_of((COLUMNS, ROWS), ["1E-06", "2E-06"], height)
}

/// A scan of heights \[nm\]; values that are not numbers are missing.
fn file_of(
    (columns, rows): (usize, usize),
    [along, apart]: [&str; 2],
    height: impl Fn(f64, f64) -> f64,
) -> Vec<u8> {
    let mut text = format!(
        "aISO-1.0\nManufacID   = made\nCreateDate  = 271120260000\nModDate     = 271120260000\nNumPoints   = {columns}\n\
         NumProfiles = {rows}\nXscale      = {along}\nYscale      = {apart}\nZscale      = 1E-09\nZresolution = -1\n\
         Compression = 0\nDataType    = 7\nCheckType   = 0\n*\n"
    );
    for row in 0..rows {
        for column in 0..columns {
            let (x, y) = (column as f64, 2.0 * row as f64);
            let z = height(x, y);
            text += &if z.is_finite() {
                format!("{z:.3} ")
            } else {
                "BAD ".to_owned()
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
    case_with(flanks, keys, "")
}

fn case_with(flanks: [String; 2], keys: &str, model: &str) -> Result<LoadedCase, Error> {
    let [pinion, wheel] = flanks;
    let flanks = format!("pinion = {{ {pinion} }}\nwheel = {{ {wheel} }}");
    case_text(&flanks, keys, model)
}

fn case_text(flanks: &str, keys: &str, model: &str) -> Result<LoadedCase, Error> {
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\" }}\n\
         material.pinion = {{ elastic_limit = \"1500 MPa\", flow_pressure = \"7 GPa\" }}\n\
         operation = {{ torque = \"30 N m\", speed = \"6000 1/min\", bulk_temperature = \"90 degC\" }}\n\
         lubricant = {{ viscosity = {{ law = \"astm-d341\", at_40 = \"30.8 mm2/s\", at_100 = \"5.9 mm2/s\" }}, density = \"845 kg/m3\", base_oil = \"pao\" }}\n\
         model = {{ positions = 2, offsets = 1, depths = 0{model} }}\n\
         [surface]\ncutoff = \"0.08 mm\"\n{keys}\n{flanks}\n"
    );
    from_text("case.toml", &text, &|name| Ok(scan(name)))
}

fn loss(names: [&str; 2], keys: &str) -> f64 {
    losses(&case(names, keys).unwrap()).unwrap().summary.loss_w
}

#[test]
fn scans_are_taken_by_their_lay() {
    // Ridges through the whole scan: one row is all of them.
    let ridged = case(["60-200-1", "60-200-9"], "").unwrap();
    assert!(ridged.surfaces.sheets().is_none());
    assert_eq!(ridged.surfaces.pairs(), 1);
    let isotropic = case(["1-200-1", "1-200-9"], "").unwrap();
    let sheets = isotropic.surfaces.sheets().unwrap();
    assert_eq!(
        (sheets.rows(), isotropic.surfaces.pairs()),
        (ROWS - ROWS / 8, 1)
    );
    assert!(less_of_scans(&ridged).is_none());
    let less = less_of_scans(&isotropic).unwrap();
    let rows = less.case.unwrap().surfaces.clone();
    assert!(less.are_patches && rows.sheets().is_none() && rows.pairs() == 16);
    let of_one = case_text("pinion = { file = \"gaps 1-200-1\" }", "", "").unwrap();
    let less = less_of_scans(&of_one).unwrap().case.unwrap();
    assert_eq!(less.surfaces.pairs(), 16);
    let by_hand = case(["1-200-1", "1-200-9"], "contact = \"lines\"").unwrap();
    let rows = by_hand.sampled.as_ref().unwrap().traces.each_ref();
    assert!(rows.iter().all(|rows| (4..=8).contains(&rows.len())));
    let less = less_of_scans(&by_hand).unwrap();
    assert!(!less.are_patches);
    let [pinion, wheel] = rows.map(Vec::len);
    assert_eq!(less.taken, format!("{pinion} × {wheel} rows of the scans"));
    assert_eq!(less.case.unwrap().surfaces.pairs(), 1);
    let (row, rows) = (rows[1][3].row.unwrap(), rows[1].len());
    let wanted = 7 * ROWS / (2 * rows);
    assert_eq!(
        (row.number, row.along_lead),
        (wanted + 1, Some(Length::from_si(2e-6) * wanted as f64))
    );
    let by_hand = case(["60-200-1", "60-200-9"], "contact = \"patch\"").unwrap();
    assert!(by_hand.surfaces.sheets().is_some());
}

#[test]
fn rows_that_are_chosen_count_as_stated_ones() {
    let lines = "contact = \"lines\"";
    let scan = || "file = \"gaps 1-200-1\"".to_owned();
    let said = |case: &LoadedCase, code: Code| {
        let of_code = case.warnings.iter().filter(|warning| warning.code == code);
        of_code.count()
    };
    // At most 64 pairs with a list of traces.
    let traces: Vec<String> = (0..20).map(|k| format!("\"trace 1-200-{k}\"")).collect();
    let traces = format!("traces = [{}]", traces.join(", "));
    let case = case_of([scan(), traces], lines).unwrap();
    let pairs = case.surfaces.pairs();
    assert!((32..=64).contains(&pairs), "{pairs}");
    assert_eq!(
        [Code::W427, Code::W447, Code::W460].map(|code| said(&case, code)),
        [1; 3]
    );
    // Of both flanks one scan, which the case names once.
    let case = case_text("pinion = { file = \"1-200-1\" }", lines, "").unwrap();
    let rows = case
        .case
        .defaults
        .iter()
        .filter(|default| default.key.ends_with(".rows"));
    assert_eq!((rows.count(), said(&case, Code::W447)), (1, 1));
    let stated = format!("{}, rows = 2, gaps = \"interpolate\"", scan());
    let wheel = "file = \"trace 1-200-9\"".to_owned();
    let case = case_of([stated, wheel], lines).unwrap();
    assert_eq!(
        [Code::W447, Code::W460].map(|code| said(&case, code)),
        [1; 2]
    );
}

#[test]
fn middle_rows_are_of_the_loaded_flanks_and_bridge_their_gaps() {
    let drive = case_of(
        ["1-200-1", "1-200-9"].map(|name| format!("file = \"hole {name}\", rows = 4")),
        "",
    );
    let less = less_of_scans(&drive.unwrap()).unwrap();
    assert_eq!(less.case.unwrap().surfaces.pairs(), 1);
    let coast = "coast = { pinion = { file = \"1-200-1\", rows = 4 }, wheel = { file = \"1-200-9\", rows = 4 } }";
    let drive = ["1-200-1", "1-200-9"].map(|name| format!("file = \"{name}\", rows = 3"));
    let coast = case_of(drive, coast).unwrap().with(|input| {
        input.operation.torque = Torque::from_si(-30.0);
    });
    let less = less_of_scans(&coast.unwrap()).unwrap();
    assert_eq!(less.taken, "4 × 4 rows of the scans");
    assert_eq!(less.case.unwrap().surfaces.pairs(), 1);
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
fn a_run_with_patches_has_the_losses_of_their_spots_and_what_rows_would_lose() {
    let names = ["1-25-1", "1-25-9"];
    let loaded = case(names, "").unwrap();
    let run = Run::new(&loaded).pictures(Kept::Highest);
    let found = run.execute().unwrap().into_only().unwrap();
    let (fields, result) = (&found.fields[0], &found.result);
    let patch = fields.patch.as_ref().unwrap();
    let lead = patch.y[1] * patch.y.len() as f64;
    let row = &result.path[fields.position - 1];
    // Of the friction at this place, as the losses of a position are at the mean speed of its cell. The contact is at the solved
    // share, its table is taken between two shares.
    let of_spots = patch.spot_losses.iter().sum::<f64>() / lead;
    let force = 1e3 * row.mu * row.line_load_n_per_mm;
    let share = (row.lubricated_asperity_w_per_m + row.boundary_w_per_m) / row.sliding_w_per_m;
    let of_asperities = share * force * row.sliding_m_per_s.abs();
    assert!(
        (of_spots / of_asperities - 1.0).abs() < 0.02,
        "{of_spots} {of_asperities}"
    );
    let touching = patch.pressure.iter().map(|p| *p > 0.0);
    assert!(touching.eq(patch.spot.iter().map(Option::is_some)));
    let scans = result.scans.as_ref().unwrap();
    assert_eq!(scans.rows, [4, 4]);
    assert_eq!(scans.patches.loss_w, result.summary.loss_w);
    let by_rows = names.map(|name| format!("file = \"{name}\", rows = 4"));
    let by_rows = losses(&case_of(by_rows, "").unwrap()).unwrap();
    assert_eq!(scans.lines.loss_w, by_rows.summary.loss_w);
    assert_eq!(scans.position, fields.position);
    let falls = |of: &dyn Fn(usize) -> f64| (1..scans.gaps.len()).all(|k| of(k) <= of(k - 1));
    assert!(falls(&|k| scans.gaps[k].share_patch) && falls(&|k| scans.gaps[k].share_lines));
    assert!(falls(&|k| -scans.gaps[k].flow_patch) && falls(&|k| -scans.gaps[k].flow_lines));
    assert!(
        scans
            .gaps
            .iter()
            .any(|row| row.share_patch > 1.5 * row.share_lines)
    );
}

#[test]
fn scans_are_compared_where_no_asperities_touch_and_at_the_highest_pressure() {
    let loaded = case(["1-0.1-1", "1-0.1-9"], "").unwrap();
    let run = Run::new(&loaded).pictures(Kept::All);
    let result = run.execute().unwrap().into_only().unwrap().result;
    assert_eq!(result.no_scans, None);
    let pressures = result.path.iter().map(|row| {
        let pressure = row.p_max_mpa.unwrap_or(row.hertz_pressure_mpa);
        (pressure, row.position)
    });
    let highest = pressures.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    assert_eq!(result.scans.unwrap().position, highest.1);
}

#[test]
fn patches_do_not_run_in() {
    let whole = case(["1-200-1", "1-200-9"], "contact = \"patch\"").unwrap();
    let error = whole.with_key("operation.running_in", "true").unwrap_err();
    assert_eq!(error.code(), Code::E205);
    assert!(
        error.to_string().contains("operation.running_in"),
        "{error}"
    );
    whole.with_key("operation.running_in", "false").unwrap();
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

/// Root mean square of the heights of the sheet of a body \[nm\].
fn height_of(case: &LoadedCase, body: usize) -> f64 {
    let (heights, _) = case.surfaces.sheets().unwrap().of_body(body);
    1e9 * (heights.iter().map(|z| z * z).sum::<f64>() / heights.len() as f64).sqrt()
}

#[test]
fn rows_of_a_scan_err_as_the_whole_scan_does() {
    const WIDTH: usize = 400;
    const HEIGHT: usize = 40;
    let spacing = Length::from_si(1e-6);
    // Eight rows are the most: of rows that resemble each other little their error is larger.
    for (keeps, rows, wanted) in [(0.95_f64, 4, 1.095), (0.8, 8, 1.280), (0.3, 8, 2.170)] {
        let mut errors = [0.0; 2];
        let mut count = 0;
        for seed in 0..60 {
            let mut state = 7919 * seed + 1;
            let mut normal = || {
                let mut uniform = || {
                    state = u64::wrapping_mul(state, 6_364_136_223_846_793_005)
                        .wrapping_add(1_442_695_040_888_963_407);
                    (state >> 11) as f64 / (1_u64 << 53) as f64
                };
                (0..12).map(|_| uniform()).sum::<f64>() - 6.0
            };
            let mut heights: Vec<f64> = (0..WIDTH).map(|_| normal()).collect();
            for k in WIDTH..WIDTH * HEIGHT {
                heights.push(keeps * heights[k - WIDTH] + (1.0 - keeps * keeps).sqrt() * normal());
            }
            let surface = prepare_surface(
                &heights,
                WIDTH,
                [spacing; 2],
                &Preparation {
                    form: Form::None,
                    lambda_c: None,
                    lambda_s: None,
                    ..Preparation::default()
                },
            )
            .unwrap();
            count = rows_needed(&surface);
            let loss =
                |row: usize| surface.row(row).iter().map(|z| z * z).sum::<f64>() / WIDTH as f64;
            let mean = |rows: Vec<usize>| {
                let n = rows.len() as f64;
                rows.into_iter().map(loss).sum::<f64>() / n - 1.0
            };
            errors[0] += mean((0..HEIGHT).collect()).powi(2);
            errors[1] += mean((0..count).map(|k| middle(k, count, HEIGHT)).collect()).powi(2);
        }
        let ratio = (errors[1] / errors[0]).sqrt();
        assert_eq!(count, rows, "{keeps}: {ratio}");
        assert!((ratio - wanted).abs() < 0.005, "{keeps}: {ratio}");
    }
}

#[test]
fn scans_with_faults_are_used_as_without() {
    let pair = |fault: &str, keys: &str| {
        let flanks = [
            format!("file = \"{fault} 1-200-1\""),
            "file = \"1-200-9\"".to_owned(),
        ];
        case_of(flanks, keys)
    };
    let whole = height_of(&pair("sound", "").unwrap(), 0);
    let told = |case: &LoadedCase, code: Code, text: &str| {
        let mut all = case.warnings.iter();
        let found = all.any(|warning| warning.code == code && warning.to_string().contains(text));
        assert!(found, "{code:?} {text}: {:?}", case.warnings);
    };
    for (fault, keys, within) in [
        ("gaps", "", 0.02),
        ("hole", "", 1e-3),
        ("ends", "", 0.1),
        ("tilted", "", 1e-3),
        ("round", "", 0.02),
        ("spikes", "outliers = 8", 0.05),
    ] {
        let case = pair(fault, keys).unwrap();
        let found = height_of(&case, 0);
        assert!(
            (found / whole - 1.0).abs() < within,
            "{fault}: {found} nm, {whole} nm"
        );
        match fault {
            "gaps" => told(&case, Code::W460, "10.0 %"),
            "ends" => {
                told(&case, Code::W460, "6.7 %");
                // A row keeps its places in the scan.
                let reading = case.flanks[0].reading.as_ref().unwrap();
                assert_eq!((reading.points, reading.gaps_filled), (COLUMNS, 100));
            }
            "spikes" => told(&case, Code::W130, "replaced as outliers"),
            _ => {}
        }
    }
    // A step is not removed, and said to dominate the middle row.
    let step = case(["step 1-25-1", "1-25-9"], "").unwrap();
    told(&step, Code::W132, "a step");
    told(&step, Code::W467, "step");
    let refused = |fault: &str, code: Code, text: &str| {
        let made = pair(fault, "").map(|_| ());
        let error = made.expect_err(fault);
        assert!(
            error.code() == code && error.to_string().contains(text),
            "{fault}: {error}"
        );
    };
    refused("holes", Code::E107, "too many");
    refused("spikes", Code::E131, "spikes");
    refused("tiny", Code::E120, "needs at least");
    refused("edges", Code::E107, "too many");
    // Points without a height count where they are used.
    for gaps in ["", ", gaps = \"refuse\""] {
        let part = format!("range = \"0.42 mm .. 1.08 mm\"{gaps}");
        let flanks = ["edges 1-200-1", "1-200-9"].map(|name| format!("file = \"{name}\", {part}"));
        let case = case_of(flanks, "").unwrap();
        let mut warnings = case.warnings.iter();
        assert!(warnings.all(|warning| warning.code != Code::W460));
    }
    let refused = pair("gaps", "").is_ok() && {
        let flanks =
            ["gaps 1-200-1", "1-200-9"].map(|name| format!("file = \"{name}\", gaps = \"refuse\""));
        case_of(flanks, "").is_err()
    };
    assert!(refused);
}

#[test]
fn narrow_scans_are_taken_by_their_rows() {
    let case = case(["narrow 1-200-1", "1-200-9"], "").unwrap();
    assert!(case.surfaces.sheets().is_none());
    assert!(
        case.warnings
            .iter()
            .any(|warning| warning.code == Code::W464)
    );
    let error = self::case(["narrow 1-200-1", "1-200-9"], "contact = \"patch\"");
    assert!(
        error
            .map(|_| ())
            .unwrap_err()
            .to_string()
            .contains("contact = \"lines\"")
    );
}

#[test]
fn a_trace_faces_a_scan_as_a_surface() {
    let flanks = || ["1-200-1", "trace 1-200-9"].map(|name| format!("file = \"{name}\""));
    let rows_of = |case: &LoadedCase| {
        let (heights, columns) = case.surfaces.sheets().unwrap().of_body(1);
        let rows: Vec<Vec<f64>> = heights.chunks(columns).map(<[f64]>::to_vec).collect();
        rows
    };
    let across = case_of(flanks(), "").unwrap();
    let rows = rows_of(&across);
    assert!(rows.len() == ROWS - ROWS / 8 && rows.iter().all(|row| *row == rows[0]));
    let stated = || case_with(flanks(), "", ", lay = [1, 0.5]").unwrap();
    let drawn = rows_of(&stated());
    assert!(drawn != rows && drawn[0] != drawn[1] && drawn == rows_of(&stated()));
    assert!((height_of(&stated(), 1) / height_of(&across, 1) - 1.0).abs() < 0.01);
    for (case, text) in [(&across, "assumed"), (&stated(), "the stated lay 0.5")] {
        let made = case.flanks[1].made_sheet.unwrap();
        assert_eq!(made.seed.is_some(), made.lay == 0.5);
        let said = case
            .warnings
            .iter()
            .find(|warning| warning.code == Code::W458);
        assert!(said.is_some_and(|said| said.to_string().contains(text)));
    }
    // A row that is named is a trace of a flank whose lay is measured.
    let row = || "file = \"1-200-9\", row = 3".to_owned();
    let measured = case_of(["file = \"1-200-1\"".to_owned(), row()], "").unwrap();
    let made = measured.flanks[1].made_sheet.unwrap();
    assert!(made.seed.is_some() && measured.flanks[0].made_sheet.is_none());
    let across = case_with([row(), row()], "contact = \"patch\"", "").map(|_| ());
    assert!(
        across
            .unwrap_err()
            .to_string()
            .contains("a scan of at least one flank")
    );
    let slight = case_with(flanks(), "contact = \"patch\"", ", lay = [0.1, 0.1]").unwrap();
    for (case, text) in [
        (&measured, format!("the measured lay {:.2}", made.lay)),
        (
            &slight,
            "the stated lay 0.1: ridges across the face".to_owned(),
        ),
    ] {
        let said = case
            .warnings
            .iter()
            .find(|warning| warning.code == Code::W458);
        assert!(
            said.is_some_and(|said| said.to_string().contains(&text)),
            "{said:?}"
        );
    }
    // By roughness values alone there is no row to begin with.
    let flanks = [
        "file = \"1-200-1\"".to_owned(),
        "ra = \"0.2 um\"".to_owned(),
    ];
    let refused = case_of(flanks, "contact = \"patch\"")
        .map(|_| ())
        .unwrap_err();
    assert!(
        refused.to_string().contains("leave rq, ra and rz out"),
        "{refused}"
    );
}

#[test]
fn filters_that_a_case_leaves_open_follow_the_scan() {
    let told = |case: &LoadedCase, code: Code| {
        let all = case.warnings.iter();
        all.filter(|warning| warning.code == code).count()
    };
    let recipe = |case: &LoadedCase| case.flanks[0].preparation.as_ref().unwrap().recipe;
    let value = |case: &LoadedCase, key: &str| {
        let mut defaults = case.case.defaults.iter();
        defaults
            .find(|default| default.key == key)
            .unwrap()
            .value
            .clone()
    };
    // Half a cut-off at both ends would leave less than the contacts need.
    let scan = "pinion = { file = \"short 1-25-1\" }";
    let short = case_text(scan, "", "").unwrap();
    assert_eq!(recipe(&short).ends, Ends::Reg1);
    assert_eq!(
        (told(&short, Code::W465), value(&short, "surface.ends")),
        (1, "\"reg1\"".into())
    );
    assert!(short.surfaces.sheets().is_some() && losses(&short).is_ok());
    let stated = case_text(scan, "ends = \"cut\"", "").unwrap();
    assert_eq!(
        (recipe(&stated).ends, told(&stated, Code::W465)),
        (Ends::Cut, 0)
    );
    // Points 3 um apart do not show waves of 2.5 um.
    let coarse = case_text("pinion = { file = \"coarse 1-25-1\" }", "", "").unwrap();
    assert_eq!(recipe(&coarse).lambda_s, Some(Length::from_si(15e-6)));
    assert_eq!(told(&coarse, Code::W466), 1);
    assert!(value(&coarse, "surface.noise_cutoff").starts_with("\"15"));
    let stated = case_text(
        "pinion = { file = \"coarse 1-25-1\" }",
        "noise_cutoff = \"20 um\"",
        "",
    );
    let stated = stated.unwrap();
    assert_eq!(
        (recipe(&stated).lambda_s, told(&stated, Code::W466)),
        (Some(Length::from_si(20e-6)), 0)
    );
    let long = case(["1-25-1", "1-25-9"], "").unwrap();
    assert_eq!(
        (recipe(&long).ends, recipe(&long).lambda_s),
        (Ends::Cut, Preparation::default().lambda_s)
    );
}

#[test]
fn ends_are_proposed_where_they_are_long_enough() {
    let scan = "pinion = { file = \"short 1-25-1\" }";
    let remedy = |keys: &str, window: f64| {
        let model = format!(", window = {window}");
        let case = case_text(scan, keys, &model).unwrap();
        let error = losses(&case).map(|_| ()).unwrap_err();
        assert_eq!(error.code(), Code::E122);
        error.position().unwrap().remedy().to_string()
    };
    let ends = "set surface.ends to reg1";
    let window = "set model.window to ";
    let dropped = remedy("ends = \"cut\"", 4.0);
    assert!(
        dropped.contains(ends) && dropped.contains(window),
        "{dropped}"
    );
    let remaining = remedy("", 9.0);
    assert!(
        !remaining.contains(ends) && remaining.contains(window),
        "{remaining}"
    );
}

#[test]
fn ends_that_remain_change_height_and_loss_little() {
    // One part of each scan, once with half a cut-off more at both ends that is dropped, once with ends by regression.
    let cut = "ends = \"cut\"";
    let regression = "ends = \"reg1\"";
    let part = |from: f64, to: f64| format!("range = \"{from} um .. {to} um\"");
    // A line fitted at the end of a row follows its waves, so that less is left: with the transmission of such lines in both directions
    // 0.995 of Rq of these waves.
    for seed in [1, 3, 5, 7] {
        let of = |ends: &str, part: &str| {
            let flanks = [seed, seed + 8].map(|seed| format!("file = \"1-25-{seed}\", {part}"));
            let case = case_of(flanks, ends).unwrap();
            let loss = losses(&case).unwrap().summary.loss_w;
            (height_of(&case, 0), loss)
        };
        let (whole, loss) = of(cut, &part(100.0, 600.0));
        let (kept, of_kept) = of(regression, &part(140.0, 560.0));
        let ratios = [kept / whole, of_kept / loss];
        assert!((ratios[0] - 1.0).abs() < 0.005, "{seed}: {ratios:?}");
        assert!((ratios[1] - 1.0).abs() < 0.002, "{seed}: {ratios:?}");
    }
}

#[test]
fn a_stated_lay_decides_about_a_scan() {
    let names = ["1-200-1", "1-200-9"].map(|name| format!("file = \"{name}\""));
    let of = |lay: &str| case_with(names.clone(), "", &format!(", lay = {lay}")).unwrap();
    assert!(of("[0.1, 0.1]").surfaces.sheets().is_none());
    let ridged = ["60-200-1", "60-200-9"].map(|name| format!("file = \"{name}\""));
    let stated = case_with(ridged, "", ", lay = [0.8, 0.8]").unwrap();
    assert!(stated.surfaces.sheets().is_some());
    assert!(
        stated
            .warnings
            .iter()
            .all(|warning| warning.code != Code::W444)
    );
}

#[test]
fn one_scan_for_both_flanks_has_a_middle_row() {
    let case = case_text("pinion = { file = \"1-200-1\" }", "contact = \"lines\"", "").unwrap();
    assert!(case.surfaces.pairs() > 1);
    let less = less_of_scans(&case).unwrap();
    assert_eq!(less.case.unwrap().surfaces.pairs(), 1);
}
