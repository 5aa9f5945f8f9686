//! A unit is applied to lengths once, wherever it is stated.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Axis, LengthUnit, Metadata, ReadOptions, TraceLine, read_bytes, read_surface_bytes,
    read_with_conditions,
};

use asperity_profile_io::write::{WrittenFormat, write};

use super::samples::*;

/// Lines of points and rows of a matrix.
const LINES: usize = 3;

/// A file with its units.
struct Stated {
    name: &'static str,
    bytes: Vec<u8>,
    x_unit: LengthUnit,
    z_unit: LengthUnit,
    /// Number of profiles.
    lines: usize,
}

fn points(unit: &str, micrometres: f64) -> Vec<u8> {
    let line = |k: usize| {
        let point = move |i: usize| {
            let [x, y, z] = [0.5 * i as f64, 2.0 * k as f64, height(i) * (1.0 + k as f64)];
            let [x, y, z] = [x, y, z].map(|length| length / micrometres);
            format!("{x:.12},{y:.12},{z:.12}\n")
        };
        (0..POINTS).map(point).collect::<String>()
    };
    let lines: String = (0..LINES).map(line).collect();
    format!("x [{unit}],y [{unit}],z [{unit}]\n{lines}").into_bytes()
}

fn profile(unit: &str, micrometres: f64) -> Vec<u8> {
    let row = |i: usize| {
        let [x, z] = [0.5 * i as f64, height(i)].map(|length| length / micrometres);
        format!("{x:.12};{z:.12}\n")
    };
    let rows: String = (0..POINTS).map(row).collect();
    format!("x [{unit}];z [{unit}]\n{rows}").into_bytes()
}

fn matrix(unit: &str, micrometres: f64) -> Vec<u8> {
    let row = |k: usize| {
        let heights =
            (0..POINTS).map(|i| format!("{:.12e}", height(i) * (1.0 + k as f64) / micrometres));
        heights.collect::<Vec<_>>().join("\t") + "\n"
    };
    let rows: String = (0..LINES).map(row).collect();
    format!("# Width: 120 µm\n# Height: 6 µm\n# Value units: {unit}\n{rows}").into_bytes()
}

fn x3p() -> Vec<u8> {
    let heights = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
    write(&profile, &Metadata::default(), WrittenFormat::X3p).unwrap()
}

fn all() -> Vec<Stated> {
    use LengthUnit::{Inch, Metre, Micrometre, Mil, Millimetre, Nanometre};
    let of = |name, bytes, x_unit, z_unit, lines| Stated {
        name,
        bytes,
        x_unit,
        z_unit,
        lines,
    };
    let both = |name, bytes, unit, lines| of(name, bytes, unit, unit, lines);
    vec![
        both("mm.xyz", points("mm", 1e3), Millimetre, LINES),
        both("um.xyz", points("um", 1.0), Micrometre, LINES),
        both("mil.xyz", points("mil", 25.4), Mil, LINES),
        both("inch.xyz", points("inch", 25.4e3), Inch, LINES),
        of("mm.txt", matrix("mm", 1e3), Micrometre, Millimetre, LINES),
        of("nm.txt", matrix("nm", 1e-3), Micrometre, Nanometre, LINES),
        of("mil.txt", matrix("mil", 25.4), Micrometre, Mil, LINES),
        both("mm.csv", profile("mm", 1e3), Millimetre, 1),
        both("mil.csv", profile("mil", 25.4), Mil, 1),
        both("a.mahr", windows(&mahr()), Millimetre, 1),
        both("a.sig", sig().into_bytes(), Micrometre, 1),
        of("a.pr", windows(&pr(true)), Millimetre, Micrometre, 1),
        both("a.sdf", sdf(1).into_bytes(), Micrometre, 1),
        of("a.xlsx", workbook(), Millimetre, Micrometre, 1),
        both("a.x3p", x3p(), Metre, 1),
    ]
}

/// Options that state no unit, either, or both.
fn statements(file: &Stated) -> [ReadOptions; 4] {
    let (x, z) = (Some(file.x_unit), Some(file.z_unit));
    [(None, None), (x, None), (None, z), (x, z)].map(|(x_unit, z_unit)| ReadOptions {
        x_unit,
        z_unit,
        ..ReadOptions::default()
    })
}

#[test]
fn a_unit_that_is_stated_again_changes_no_trace() {
    for file in all() {
        let lines = match file.lines {
            1 => vec![(TraceLine::Row, None)],
            _ => vec![
                (TraceLine::Row, Some(2)),
                (TraceLine::Mean, None),
                (TraceLine::MeanColumn, None),
            ],
        };
        for (line, row) in lines {
            let read = |options: ReadOptions| {
                let options = ReadOptions {
                    line,
                    row,
                    ..options
                };
                let reading = read_bytes(file.name, &file.bytes, &options);
                reading
                    .map(|reading| reading.profile)
                    .map_err(|error| error.to_string())
            };
            let [plain, stated @ ..] = statements(&file);
            let plain = read(plain);
            assert!(
                plain.is_ok() || line == TraceLine::MeanColumn,
                "{} {plain:?}",
                file.name
            );
            for options in stated {
                assert_eq!(
                    read(options.clone()),
                    plain,
                    "{} {line} {options:?}",
                    file.name
                );
            }
        }
    }
}

#[test]
fn a_unit_that_is_stated_again_changes_no_surface_and_no_row_of_it() {
    for file in all().iter().filter(|file| file.lines > 1) {
        let [plain, stated @ ..] = statements(file);
        let read = |options: &ReadOptions| {
            read_surface_bytes(file.name, &file.bytes, options)
                .unwrap_or_else(|error| panic!("{error}"))
        };
        let whole = read(&plain);
        assert!(
            (whole.dx.unwrap().si() / 0.5e-6 - 1.0).abs() < 1e-9,
            "{}",
            file.name
        );
        assert!(
            (whole.dy.unwrap().si() / 2e-6 - 1.0).abs() < 1e-9,
            "{}",
            file.name
        );
        assert!(
            (whole.z[POINTS + 5] - 2e-6 * height(5)).abs() < 1e-12,
            "{}",
            file.name
        );
        let row_of = |options: &ReadOptions| {
            let row = ReadOptions {
                row: Some(2),
                ..options.clone()
            };
            read(options).reading(&row).unwrap().profile
        };
        for options in stated {
            let found = read(&options);
            assert_eq!(
                (&found.z, found.dx, found.dy),
                (&whole.z, whole.dx, whole.dy),
                "{}",
                file.name
            );
            assert_eq!(
                row_of(&options),
                row_of(&plain),
                "{} {options:?}",
                file.name
            );
        }
    }
}

/// The evaluation length has its own unit, and so has a spacing in the header of a table.
#[test]
fn a_stated_unit_of_positions_scales_no_length_that_has_its_own() {
    let heights: String = (0..POINTS).map(|i| format!("{:.4}\n", height(i))).collect();
    let options = ReadOptions {
        x_unit: Some(LengthUnit::Millimetre),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let profile = format!("0.12000\n{POINTS}\n{heights}");
    let conditions = "Evaluation length\t0.1200000mm\n";
    let surfcom = read_with_conditions(
        "a.tx1",
        profile.as_bytes(),
        Some(conditions.as_bytes()),
        &options,
    );
    let column = read_bytes(
        "a.txt",
        format!("# dx = 0.5 um\n{heights}").as_bytes(),
        &options,
    );
    for reading in [surfcom.unwrap(), column.unwrap()] {
        check(&reading, reading.format, 4);
        let (axis, stated) = (Axis::Trace, LengthUnit::Millimetre);
        assert_eq!(reading.warnings, [Warning::UnitNotUsed { axis, stated }]);
    }
}

/// As for a profile, the stated unit is used, and the warning names the unit of the file.
#[test]
fn another_unit_than_that_of_the_file_is_used_and_both_are_named() {
    let names_both = |warnings: &[Warning]| {
        warnings.contains(&Warning::UnitOverridden {
            axis: Axis::Height,
            stated: LengthUnit::Micrometre,
            found: LengthUnit::Millimetre,
        })
    };
    for (name, bytes, row) in [
        ("mm.csv", profile("mm", 1e3), None),
        ("mm.txt", matrix("mm", 1e3), Some(1)),
        ("mm.xyz", points("mm", 1e3), Some(1)),
    ] {
        let options = ReadOptions {
            z_unit: Some(LengthUnit::Micrometre),
            row,
            ..ReadOptions::default()
        };
        let reading = read_bytes(name, &bytes, &options).unwrap();
        assert!(
            (reading.profile.heights()[5] - 1e-9 * height(5)).abs() < 1e-15,
            "{name}"
        );
        assert!(
            names_both(&reading.warnings),
            "{name}: {:?}",
            reading.warnings
        );
        if row.is_some() {
            let surface = read_surface_bytes(name, &bytes, &options).unwrap();
            assert!((surface.z[5] - 1e-9 * height(5)).abs() < 1e-15, "{name}");
            assert!(
                names_both(&surface.warnings),
                "{name}: {:?}",
                surface.warnings
            );
            let of_scan = surface.reading(&options).unwrap();
            assert_eq!(of_scan.profile.heights(), &surface.z[..POINTS]);
            assert_eq!(of_scan.z_unit, LengthUnit::Micrometre);
        }
    }
}

#[test]
fn each_column_of_points_has_its_own_unit() {
    let text = String::from_utf8(points("um", 1.0)).unwrap();
    // y in millimetres, and heights without a unit.
    let text = text.replacen("x [um],y [um],z [um]", "x [um],y [mm],z", 1);
    let refused =
        read_surface_bytes("a.xyz", text.as_bytes(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E104");
    for (unit, factor) in [("um", 1.0), ("mil", 25.4)] {
        let options = ReadOptions {
            z_unit: unit.parse().ok(),
            row: Some(2),
            ..ReadOptions::default()
        };
        let surface = read_surface_bytes("a.xyz", text.as_bytes(), &options).unwrap();
        assert!((surface.dx.unwrap().si() / 0.5e-6 - 1.0).abs() < 1e-9);
        assert!((surface.dy.unwrap().si() / 2e-3 - 1.0).abs() < 1e-9);
        assert!(
            (surface.z[5] - factor * 1e-6 * height(5)).abs() < 1e-12,
            "{unit}"
        );
        let second = surface.reading(&options).unwrap();
        assert_eq!(
            second.profile,
            read_bytes("a.xyz", text.as_bytes(), &options)
                .unwrap()
                .profile
        );
    }
    // Positions without a unit are asked for it, and not for a spacing.
    let bare = text.replacen("x [um],y [mm],z", "x,y,z [um]", 1);
    let row = ReadOptions {
        row: Some(1),
        ..ReadOptions::default()
    };
    let scan = read_surface_bytes("a.xyz", bare.as_bytes(), &row).unwrap();
    let refused = scan.reading(&row).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("no unit found for the x values, which span 119.5"),
        "{refused}"
    );
    // A unit that is not known is an error, unless another one is stated.
    let furlongs = text.replacen("x [um],y [mm],z", "x [um],y [mm],z [furlong]", 1);
    let read = |z_unit: Option<&str>| {
        let options = ReadOptions {
            z_unit: z_unit.map(|unit| unit.parse().unwrap()),
            ..ReadOptions::default()
        };
        read_surface_bytes("a.xyz", furlongs.as_bytes(), &options)
    };
    assert_eq!(read(None).unwrap_err().code(), "E114");
    assert!(read(Some("um")).is_ok());
}

/// Heights of some 4 um, in metres, micrometres and nanometres.
#[test]
fn proposed_units_give_heights_that_instruments_measure() {
    for (micrometres, units) in [(1e6, "mm | m"), (1.0, "um | nm | mm"), (1e-3, "um | nm")] {
        let text = String::from_utf8(matrix("um", micrometres)).unwrap();
        let text = text.replacen("# Value units: um\n", "", 1);
        let refused =
            read_surface_bytes("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap_err();
        assert_eq!(
            refused.remedy().to_string(),
            format!("Set z_unit to {units}"),
            "{refused}"
        );
    }
}

#[test]
fn spacings_of_points_and_rows_are_stated_where_the_file_has_none() {
    let text = String::from_utf8(matrix("um", 1.0)).unwrap();
    let text = text.replacen("# Width: 120 µm\n# Height: 6 µm\n", "", 1);
    let bare = read_surface_bytes("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!((bare.dx, bare.dy), (None, None));
    let options = ReadOptions {
        dx: "0.5 um".parse().ok(),
        dy: "2 um".parse().ok(),
        ..ReadOptions::default()
    };
    let stated = read_surface_bytes("a.txt", text.as_bytes(), &options).unwrap();
    assert_eq!((stated.dx, stated.dy), (options.dx, options.dy));
    // A stated spacing that differs from the file's is used and named.
    let options = ReadOptions {
        dy: "3 um".parse().ok(),
        ..ReadOptions::default()
    };
    let found = read_surface_bytes("a.txt", &matrix("um", 1.0), &options).unwrap();
    assert_eq!(found.dy, options.dy);
    assert!(
        matches!(found.warnings[..], [Warning::SpacingOverridden { .. }]),
        "{:?}",
        found.warnings
    );
    // A column of points runs along y.
    let long: String = (0..POINTS)
        .map(|i| format!("{:.6}\t{:.6}\t{:.6}\n", height(i), 0.0, 1.0))
        .collect();
    let column = ReadOptions {
        line: TraceLine::Column,
        row: Some(1),
        dx: "0.5 um".parse().ok(),
        ..options
    };
    let text = format!("# Width: 3 um\n# Value units: um\n{long}");
    let reading = read_bytes("a.txt", text.as_bytes(), &column).unwrap();
    assert_eq!(Some(reading.spacing), column.dy);
    let short = ReadOptions {
        line: TraceLine::Row,
        ..column
    };
    let refused = read_bytes("a.txt", text.as_bytes(), &short).unwrap_err();
    assert_eq!(refused.code(), "E106");
}
