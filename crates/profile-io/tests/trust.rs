//! Files that must not be read to an absurd profile in silence.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::TAU;

use asperity_core::Code;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::steepness::Suspicion;
use asperity_profile_io::read::{
    Format, Gaps, LengthUnit, ReadError, ReadOptions, Reading, Uneven, read, read_bytes,
    read_surface_bytes,
};

const POINTS: usize = 2000;
const DX_UM: f64 = 0.5;

/// A rough flank [um] at the distance `x` [um]: Rq 0.21 um, Rdq 0.05.
fn flank(x: f64) -> f64 {
    0.25 * (TAU * x / 31.0).sin() + 0.15 * (TAU * x / 170.0).cos()
}

/// Lines of x and z under a header.
fn table(header: &str, x: impl Fn(usize) -> f64, z: impl Fn(usize) -> f64) -> String {
    let rows = (0..POINTS).map(|i| format!("{:.9e};{:.9e}\n", x(i), z(i)));
    format!("{header}\n{}", rows.collect::<String>())
}

fn um(header: &str, z: impl Fn(usize) -> f64) -> String {
    table(header, |i| DX_UM * i as f64, z)
}

fn opened(text: &str, options: &ReadOptions) -> Result<Reading, ReadError> {
    read_bytes("flank.csv", text.as_bytes(), options)
}

fn codes(reading: &Reading) -> Vec<&'static str> {
    reading
        .warnings
        .iter()
        .map(|warning| warning.code().as_str())
        .collect()
}

#[test]
fn heights_in_millimetres_that_are_nanometres_are_named_and_refused() {
    let text = um("x [um];z [mm]", |i| 1e3 * flank(DX_UM * i as f64));
    let reading = opened(&text, &ReadOptions::default()).unwrap();
    assert_eq!(codes(&reading), ["W124"]);
    let refused = reading.check_heights().unwrap_err();
    assert_eq!(refused.code(), "E131");
    assert!(
        refused.remedy().to_string() == "Set z_unit to nm",
        "{refused}"
    );
    let options = ReadOptions {
        z_unit: Some(LengthUnit::Nanometre),
        ..ReadOptions::default()
    };
    let right = opened(&text, &options).unwrap();
    assert!(right.check_heights().is_ok());
    assert_eq!(codes(&right), ["W322"]);
}

#[test]
fn stated_units_that_differ_from_the_header_are_used_and_told() {
    let text = um("x [um];z [um]", |i| flank(DX_UM * i as f64));
    let stated = |x, z| {
        let options = ReadOptions {
            x_unit: Some(x),
            z_unit: Some(z),
            ..ReadOptions::default()
        };
        opened(&text, &options).unwrap()
    };
    let same = stated(LengthUnit::Micrometre, LengthUnit::Micrometre);
    assert_eq!(codes(&same), [""; 0]);
    let other = stated(LengthUnit::Millimetre, LengthUnit::Nanometre);
    assert_eq!(codes(&other)[..2], ["W322", "W322"]);
    assert!((other.spacing / same.spacing - 1e3).abs() < 1e-9);
    let says = "nm was stated for the heights, the file says um; the stated unit is used";
    assert_eq!(other.warnings[0].to_string(), says);
}

#[test]
fn sentinels_are_named_with_their_value() {
    for mark in [-9999.0, 1e9] {
        let text = um("x [um];z [um]", |i| match i {
            500..=503 => mark,
            i => flank(DX_UM * i as f64),
        });
        let reading = opened(&text, &ReadOptions::default()).unwrap();
        let Some(Warning::ImplausibleHeights { steepness }) = reading.warnings.first() else {
            panic!("{:?}", reading.warnings);
        };
        let Suspicion::Sentinel { value, points, .. } = steepness.suspicion else {
            panic!("{steepness:?}");
        };
        assert!((value / mark - 1.0).abs() < 1e-12 && points == 4);
        assert!(reading.check_heights().is_err());
    }
}

#[test]
fn heights_without_a_unit_that_may_be_nanometres_are_not_taken_as_micrometres() {
    // Rq 214: 214 nm of a flank, or 214 um, which no flank has.
    let text = table(
        "x in mm;z",
        |i| 1e-3 * DX_UM * i as f64,
        |i| 1e3 * flank(DX_UM * i as f64),
    );
    let refused = opened(&text, &ReadOptions::default());
    assert!(
        matches!(&refused, Err(error) if error.code() == Code::E104),
        "{refused:?}"
    );
    let text = table(
        "x in mm;z",
        |i| 1e-3 * DX_UM * i as f64,
        |i| flank(DX_UM * i as f64),
    );
    let reading = opened(&text, &ReadOptions::default()).unwrap();
    assert_eq!(reading.z_unit, LengthUnit::Micrometre);
    assert_eq!(codes(&reading), ["W111"]);
}

/// x [um] with a wobble of `share` of a spacing.
fn wobbly(share: f64) -> impl Fn(usize) -> f64 {
    move |i| {
        let wobble = match i {
            0 => 0.0,
            i if i == POINTS - 1 => 0.0,
            i => (0.7 * i as f64).sin(),
        };
        DX_UM * (i as f64 + share * wobble)
    }
}

#[test]
fn an_uneven_x_is_told_from_two_per_cent() {
    let read = |share: f64, uneven: Uneven| {
        let x = wobbly(share);
        let text = table("x [um];z [um]", &x, |i| flank(x(i)));
        let options = ReadOptions {
            uneven,
            ..ReadOptions::default()
        };
        opened(&text, &options)
    };
    assert_eq!(codes(&read(0.015, Uneven::Refuse).unwrap()), [""; 0]);
    let reading = read(0.15, Uneven::Refuse).unwrap();
    let [Warning::UnevenSpacing { off, slopes }] = reading.warnings[..] else {
        panic!("{:?}", reading.warnings);
    };
    assert!((off - 0.15).abs() < 1e-3, "{off}");
    // Steps differ by 2·sin(0.35) of the wobble.
    assert!(
        (slopes - 0.15 * 2.0 * 0.35_f64.sin()).abs() < 1e-3,
        "{slopes}"
    );
    assert!(matches!(
        read(0.45, Uneven::Refuse),
        Err(error) if error.code() == Code::E109
    ));
    for share in [0.15, 0.45] {
        let reading = read(share, Uneven::Resample).unwrap();
        assert_eq!(codes(&reading), ["W126"]);
        assert!((reading.spacing.si() / (DX_UM * 1e-6) - 1.0).abs() < 1e-9);
        for (i, z) in reading.profile.heights().iter().enumerate() {
            // Straight lines under a curvature of 0.25 (2π/31)² 1/um: h² κ/8 at steps of up to 1 um.
            assert!((z * 1e6 - flank(DX_UM * i as f64)).abs() < 2e-3, "{i}");
        }
    }
}

#[test]
fn missing_points_of_an_uneven_trace_are_left_out_of_its_lines() {
    let x = wobbly(0.4);
    let rows = (0..POINTS).map(|i| match i {
        700 | 701 => format!("{:.9e};NaN\n", x(i)),
        i => format!("{:.9e};{:.9e}\n", x(i), flank(x(i))),
    });
    let text = format!("x [um];z [um]\n{}", rows.collect::<String>());
    let options = ReadOptions {
        uneven: Uneven::Resample,
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    let reading = opened(&text, &options).unwrap();
    assert_eq!(codes(&reading), ["W115", "W126"]);
    assert_eq!((reading.gaps_filled, reading.points), (2, POINTS - 2));
    let dx = reading.spacing.si() * 1e6;
    for (i, z) in reading.profile.heights().iter().enumerate() {
        assert!((z * 1e6 - flank(dx * i as f64)).abs() < 2e-2, "{i}");
    }
}

/// Ra and Rq of heights about their mean.
fn ra_rq(heights: &[f64]) -> (f64, f64) {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    let ra = heights.iter().map(|z| (z - mean).abs()).sum::<f64>() / n;
    let square = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
    (ra, square.sqrt())
}

#[test]
fn roll_length_exports_need_the_base_radius_and_keep_the_roughness() {
    let base_radius = Length::from_si(40e-3);
    let roll = |i: usize| 8.0 + 4.0 * i as f64 / (POINTS - 1) as f64;
    let arc_um = |i: usize| 1e3 * roll(i).powi(2) / 80.0;
    let degrees = |i: usize| (roll(i) / 40.0).to_degrees();
    let files = [
        table("Roll length [mm];z [um]", roll, |i| flank(arc_um(i))),
        table("Roll angle [deg];z [um]", degrees, |i| flank(arc_um(i))),
    ];
    let length_um = arc_um(POINTS - 1) - arc_um(0);
    // The truth: the flank in even steps of 0.1 um along its involute.
    let truth: Vec<f64> = (0..(length_um * 10.0) as usize)
        .map(|i| flank(arc_um(0) + 0.1 * i as f64))
        .collect();
    let (ra, rq) = ra_rq(&truth);
    for text in files {
        let refused = opened(&text, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E130");
        assert!(
            refused.remedy().to_string().contains("base_radius"),
            "{refused}"
        );
        let options = ReadOptions {
            base_radius: Some(base_radius),
            ..ReadOptions::default()
        };
        let reading = opened(&text, &options).unwrap();
        assert_eq!(codes(&reading), ["W127"]);
        assert!((reading.length.si() / (length_um * 1e-6) - 1.0).abs() < 1e-9);
        let (found_ra, found_rq) = ra_rq(reading.profile.heights());
        assert!((found_ra * 1e6 / ra - 1.0).abs() < 0.01, "{found_ra}");
        assert!((found_rq * 1e6 / rq - 1.0).abs() < 0.01, "{found_rq}");
    }
}

/// Roll length `[mm]` of a point.
type RollLengths = Box<dyn Fn(usize) -> f64>;

#[test]
fn an_involute_export_keeps_its_roughness_whatever_its_steps() {
    let (radius, first, last) = (40.0, 8.0, 12.0);
    let arc_um = |roll: f64| 1e3 * roll * roll / (2.0 * radius);
    let even = |i: usize| i as f64 / (POINTS - 1) as f64;
    let mixed = |i: usize, seed: f64| {
        ((i as f64 * 12.9898 + seed).sin() * 43758.5453)
            .fract()
            .abs()
    };
    // Shares of the roll length: even; even along the flank; growing sixfold; two speeds; each point off by up
    // to 0.45 of a step; fewer points, five to seven to the shortest wave.
    let within = move |share: f64| first + (last - first) * share;
    let steps: [(&str, usize, RollLengths); 6] = [
        ("even", POINTS, Box::new(move |i| within(even(i)))),
        (
            "along the flank",
            POINTS,
            Box::new(move |i| (first * first + (last * last - first * first) * even(i)).sqrt()),
        ),
        (
            "growing",
            POINTS,
            Box::new(move |i| within((even(i) + 2.5 * even(i).powi(2)) / 3.5)),
        ),
        (
            "two speeds",
            POINTS,
            Box::new(move |i| {
                within(if even(i) < 0.5 {
                    0.5 * even(i)
                } else {
                    1.5 * even(i) - 0.5
                })
            }),
        ),
        (
            "jitter",
            POINTS,
            Box::new(move |i| {
                let off = if i == 0 || i == POINTS - 1 {
                    0.0
                } else {
                    0.9 * (mixed(i, 1.0) - 0.5)
                };
                within((i as f64 + off) / (POINTS - 1) as f64)
            }),
        ),
        ("coarse", 200, Box::new(move |i| within(i as f64 / 199.0))),
    ];
    let length = arc_um(last) - arc_um(first);
    let truth: Vec<f64> = (0..=(length * 10.0) as usize)
        .map(|i| flank(arc_um(first) + 0.1 * i as f64))
        .collect();
    let (ra, rq) = ra_rq(&truth);
    for (name, points, roll) in steps {
        for (header, scale) in [
            ("Roll length [mm];z [um]", 1.0),
            (
                "Roll angle [deg];z [um]",
                180.0 / std::f64::consts::PI / radius,
            ),
        ] {
            let line = |i: usize| {
                let roll = roll(i);
                format!("{:.7};{:.5}\n", roll * scale, flank(arc_um(roll)))
            };
            let text: String = (0..points).map(line).collect();
            let options = ReadOptions {
                base_radius: Some(Length::from_si(radius * 1e-3)),
                ..ReadOptions::default()
            };
            let reading = opened(&format!("{header}\n{text}"), &options);
            let reading = reading.unwrap_or_else(|error| panic!("{name}: {error}"));
            let (found_ra, found_rq) = ra_rq(reading.profile.heights());
            assert!(
                (found_ra * 1e6 / ra - 1.0).abs() < 0.01,
                "{name}: {found_ra} {ra}"
            );
            assert!(
                (found_rq * 1e6 / rq - 1.0).abs() < 0.01,
                "{name}: {found_rq} {rq}"
            );
        }
    }
}

#[test]
fn inches_and_their_parts_are_read() {
    let inch = |x: f64| x / 25.4e3;
    let text = table(
        "x [inch];z [uin]",
        |i| inch(DX_UM * i as f64),
        |i| 1e6 * inch(flank(DX_UM * i as f64)),
    );
    let reading = opened(&text, &ReadOptions::default()).unwrap();
    assert_eq!(
        (reading.x_unit, reading.z_unit),
        (Some(LengthUnit::Inch), LengthUnit::Microinch)
    );
    assert!((reading.spacing.si() / 0.5e-6 - 1.0).abs() < 1e-8);
    for (i, z) in reading.profile.heights().iter().enumerate() {
        assert!((z * 1e6 - flank(DX_UM * i as f64)).abs() < 1e-8, "{i}");
    }
    let text = um("x [um];z [furlong]", |i| flank(DX_UM * i as f64));
    let refused = opened(&text, &ReadOptions::default());
    assert!(matches!(refused, Err(error) if error.code() == Code::E114));
}

#[test]
fn a_row_of_a_matrix_of_heights_is_read() {
    let height = |row: usize, i: usize| flank(DX_UM * i as f64 + 7.0 * row as f64);
    let line = |row: usize| {
        let cells: Vec<String> = (0..300).map(|i| format!("{:.6}", height(row, i))).collect();
        cells.join("\t") + "\n"
    };
    let text: String = (1..=20).map(line).collect();
    let asked = |row, dx| ReadOptions {
        row,
        dx,
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let dx = Some(Length::from_si(0.5e-6));
    let several = "the file holds 20 profiles of 300 points";
    for (asked, code, expected) in [
        (asked(None, dx), Code::E119, several.to_owned()),
        (
            asked(Some(21), dx),
            Code::E119,
            format!("{several}, row 21 is not among them"),
        ),
        (
            asked(Some(3), None),
            Code::E110,
            "no x column and no spacing of the points was found".to_owned(),
        ),
    ] {
        let refused = opened(&text, &asked).unwrap_err();
        assert_eq!(
            (refused.code(), refused.fault.to_string()),
            (code, expected)
        );
    }
    let reading = opened(&text, &asked(Some(3), dx)).unwrap();
    assert_eq!((reading.format, reading.points), (Format::TextMatrix, 300));
    for (i, z) in reading.profile.heights().iter().enumerate() {
        assert!((z * 1e6 - height(3, i)).abs() < 1e-6);
    }
}

#[cfg(unix)]
#[test]
fn a_device_is_refused_before_it_is_read() {
    let refused = read("/dev/zero".as_ref(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E103");
    assert!(refused.to_string().contains("pass -"), "{refused}");
}

/// Stylus export of one trace of a scan: the number of the trace precedes its heights.
fn stylus_scan(points: usize, number: &str) -> String {
    let heights: String = (0..POINTS)
        .map(|i| format!("{:.4}\n", 5.0 + flank(DX_UM * i as f64)))
        .collect();
    format!("Recipe\tflank\nTraces\t1\nPoints per trace\t{points}\nTrace\n{number}{heights}")
}

#[test]
fn the_number_of_a_trace_is_not_read_as_its_first_height() {
    let options = ReadOptions {
        dx: Some(Length::from_si(DX_UM * 1e-6)),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let scan = |points, number| opened(&stylus_scan(points, number), &options);
    assert_eq!(codes(&scan(POINTS, "").unwrap()), [""; 0]);
    let refused = scan(POINTS, "21.0000\n").unwrap_err();
    assert_eq!(refused.code(), "E117");
    let says = "line 3: Points per trace2000, 2001 read";
    assert!(refused.to_string().contains(says), "{refused}");
    let aborted = scan(POINTS + 500, "").unwrap();
    assert_eq!(codes(&aborted), ["W131"]);
    assert_eq!(aborted.points, POINTS);
}

#[test]
fn the_number_of_a_trace_is_not_the_first_height_of_its_row_either() {
    let row = |number: usize| {
        let heights = (0..POINTS).map(|i| format!("\t{:.4}", flank(DX_UM * i as f64)));
        format!("{number}{}\n", heights.collect::<String>())
    };
    let text = format!(
        "Recipe\tflank\nPoints per trace\t{POINTS}\n{}{}",
        row(1),
        row(2)
    );
    let options = ReadOptions {
        dx: Some(Length::from_si(DX_UM * 1e-6)),
        z_unit: Some(LengthUnit::Micrometre),
        row: Some(2),
        ..ReadOptions::default()
    };
    let reading = opened(&text, &options).unwrap();
    let first = reading.profile.heights()[0] * 1e6;
    assert_eq!(reading.points, POINTS);
    assert!((first - flank(0.0)).abs() < 1e-4, "{first}");
    // Rows of which one has another number than its own.
    let text = text.replace("\n2\t", "\n7\t");
    assert_eq!(opened(&text, &options).unwrap_err().code(), "E117");
}

#[test]
fn a_column_named_depth_is_turned_into_heights_in_every_language_of_the_dialects() {
    let z = |i: usize| flank(DX_UM * i as f64);
    let options = ReadOptions::default();
    let heights = opened(&um("x [um];Height [um]", z), &options).unwrap();
    for name in [
        "Depth [um]",
        "z_depth (um)",
        "Profile depth [µm]",
        "depth / um",
        "Tiefe [µm]",
        "Profiltiefe [um]",
        "Profondeur (µm)",
        "profondità [um]",
        "Profundidad [um]",
        "profundidade [um]",
        "hloubka [um]",
        "深さ [um]",
        "深さ(μm)",
        "深度 [um]",
        "Глубина [um]",
    ] {
        let depths = opened(&um(&format!("x [um];{name}"), |i| -z(i)), &options).unwrap();
        assert_eq!(depths.profile, heights.profile, "{name}");
        assert_eq!(codes(&depths), ["W328"], "{name}");
        let first = format!("{name};x [um]");
        let swapped = table(&first, |i| -z(i), |i| DX_UM * i as f64);
        assert_eq!(
            opened(&swapped, &options).unwrap().profile,
            heights.profile,
            "{first}"
        );
    }
    // More words than columns, and a column of its own.
    let blanks = um("# x (um)  depth in um", |i| -z(i)).replace(';', " ");
    let depths = opened(&blanks, &options).unwrap();
    assert_eq!(codes(&depths), ["W328"]);
    assert_eq!(depths.profile.heights(), heights.profile.heights());
    // Heights under a line that states a depth.
    for line in [
        "Depth of cut;5 um",
        "Rautiefe;3.2",
        "Roughness depth Rz;3.2",
        "Penetration depth 5;um",
    ] {
        let read = opened(&um(&format!("{line}\nx [um];z [um]"), z), &options).unwrap();
        assert_eq!(read.profile, heights.profile, "{line}");
        assert_eq!(codes(&read), [""; 0], "{line}");
    }
}

#[test]
fn a_stated_sign_overrides_the_name_of_the_column() {
    let z = |i: usize| flank(DX_UM * i as f64);
    let stated = |invert| ReadOptions {
        invert: Some(invert),
        ..ReadOptions::default()
    };
    for name in ["Depth", "z"] {
        let text = um(&format!("x [um];{name} [um]"), z);
        let [as_read, turned] = [false, true].map(|invert| opened(&text, &stated(invert)).unwrap());
        assert_eq!(codes(&as_read), [""; 0]);
        assert_eq!(codes(&turned), [""; 0]);
        let back: Vec<f64> = turned.profile.heights().iter().map(|z| -z).collect();
        assert_eq!(as_read.profile.heights(), back);
        assert!((as_read.profile.heights()[10] - 1e-6 * z(10)).abs() < 1e-15);
    }
}

#[test]
fn points_with_depths_are_a_surface_of_heights() {
    let z = |x: usize, y: usize| flank(DX_UM * x as f64) + 0.01 * y as f64;
    let rows = |sign: f64| -> String {
        let point = |k: usize| {
            let (x, y) = (k % 120, k / 120);
            format!("{};{};{:.9e}\n", 0.5 * x as f64, 2 * y, sign * z(x, y))
        };
        (0..360).map(point).collect()
    };
    let surface = |name: &str, sign: f64| {
        let text = format!("x [um];y [um];{name} [um]\n{}", rows(sign));
        read_surface_bytes("points.csv", text.as_bytes(), &ReadOptions::default()).unwrap()
    };
    let (heights, depths) = (surface("z", 1.0), surface("depth", -1.0));
    assert_eq!(heights.z, depths.z);
    assert_eq!(depths.warnings, [Warning::DepthsTurned]);
}
