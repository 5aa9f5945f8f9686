//! Workbooks, points, matrices with a header, and values that headers state.

use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    FilterState, Format, Gaps, LengthUnit, ReadOptions, Reading, SpacingSource, TraceLine,
    read_bytes, read_surface_bytes,
};

use super::samples::*;

fn refused(name: &str, text: &str) -> String {
    let error = read_bytes(name, text.as_bytes(), &ReadOptions::default()).unwrap_err();
    format!("{} {error}. {}", error.code(), error.remedy())
}

fn row(row: usize) -> ReadOptions {
    ReadOptions {
        row: Some(row),
        ..ReadOptions::default()
    }
}

fn heights(line: impl Fn(f64) -> String) -> String {
    rows(|z| line(z) + "\n")
}

fn pairs(line: impl Fn(f64, f64) -> String) -> String {
    (0..POINTS)
        .map(|i| line(0.5 * i as f64, height(i)) + "\n")
        .collect()
}

fn is_near(reading: &Reading, factor: f64) {
    let exact = |i: usize| factor * height(i);
    for (i, z) in reading.profile.heights().iter().enumerate() {
        assert!((z * 1e6 - exact(i)).abs() < 1e-6, "{i}");
    }
}

#[test]
fn a_workbook_is_read_by_its_labels() {
    let remarks = ["Part|flank 7", "Sampling interval|0.5|um"];
    let lines = || (0..POINTS).map(|i| vec![0.0005 * i as f64, height(i), 20.0]);
    let labels = ["Position (mm)", "Height (µm)", "Temperature"];
    let book = xlsx(&[sheet_xml(&remarks, &labels, lines())]);
    let reading = read_as("a.xlsx", &book);
    check(&reading, Format::Excel, 9);
    assert_eq!(reading.x_unit, Some(LengthUnit::Millimetre));
    let unread = vec!["Temperature".to_owned()];
    assert_eq!(
        reading.warnings,
        [Warning::ColumnsNotRead { columns: unread }]
    );
    // The names of the columns decide, not their order.
    let labels = ["Z [um]", "T", "X [mm]"];
    let lines = (0..POINTS).map(|i| vec![height(i), 20.0, 0.0005 * i as f64]);
    let reading = read_as("a.xlsx", &xlsx(&[sheet_xml(&[], &labels, lines)]));
    check(&reading, Format::Excel, 9);
    // Heights alone use the interval above them.
    let lines = (0..POINTS).map(|i| vec![height(i)]);
    let reading = read_as("a.xlsx", &xlsx(&[sheet_xml(&remarks, &["Z [um]"], lines)]));
    check(&reading, Format::Excel, 9);
    assert_eq!(reading.spacing_source, SpacingSource::Header);
    check(&read_as("a.ods", &ods()), Format::Excel, 9);
}

#[test]
fn of_several_sheets_one_is_asked_for() {
    let sheet = |factor: f64| {
        let lines = (0..POINTS).map(move |i| vec![0.5 * i as f64, factor * height(i)]);
        sheet_xml(&[], &["x [um]", "z [um]"], lines)
    };
    let short = sheet_xml(&["no table"], &["n"], (0..9).map(|i| vec![f64::from(i)]));
    let one = xlsx(&[short.clone(), sheet(1.0)]);
    check(&read_as("a.xlsx", &one), Format::Excel, 9);
    let second = read_bytes("a.xlsx", &one, &row(2)).unwrap_err();
    assert_eq!(second.code(), "E119");
    let two = xlsx(&[sheet(1.0), short, sheet(2.0)]);
    let error = read_bytes("a.xlsx", &two, &ReadOptions::default()).unwrap_err();
    assert!(
        error.to_string().contains("2 profiles of 240 points"),
        "{error}"
    );
    is_near(&read_bytes("a.xlsx", &two, &row(2)).unwrap(), 2.0);
    let none = read_bytes(
        "a.xlsx",
        &xlsx(&[sheet_xml(&["a"], &["b"], [].into_iter())]),
        &row(1),
    );
    assert_eq!(none.unwrap_err().code(), "E320");
    let old = read_bytes(
        "a.xls",
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and so on",
        &row(1),
    );
    assert_eq!(old.unwrap_err().code(), "E117");
}

#[test]
fn an_xml_profile_has_the_spacing_and_unit_of_its_header() {
    let reading = read_as("sine.xml", npl_xml().as_bytes());
    check(&reading, Format::NplXml, 6);
    assert_eq!(reading.metadata.title.as_deref(), Some("flank 7"));
    let fewer = npl_xml().replace("<NUMPOINTS>240", "<NUMPOINTS>241");
    assert!(refused("a.xml", &fewer).starts_with("E117"));
    let volts = npl_xml().replace("<UNITS>um", "<UNITS>mV");
    assert!(refused("a.xml", &volts).starts_with("E114"));
}

#[test]
fn points_of_one_line_are_a_profile() {
    for text in [
        pairs(|x, z| format!("{x} 7.25 {z:.6}")),
        pairs(|x, z| format!("3,{x},{z:.6}")),
        format!(
            "X [um];Y [um];Z [um]\n{}",
            pairs(|x, z| format!("{x};0;{z:.6}"))
        ),
        format!(
            "z (um)\ty (um)\tx (um)\n{}",
            pairs(|x, z| format!("{z:.6}\t0\t{x}"))
        ),
    ] {
        let options = ReadOptions {
            x_unit: Some(LengthUnit::Micrometre),
            z_unit: Some(LengthUnit::Micrometre),
            ..ReadOptions::default()
        };
        let reading = read_bytes("a.xyz", text.as_bytes(), &options).unwrap();
        check(&reading, Format::PointText, 6);
    }
}

#[test]
fn points_on_a_grid_are_the_lines_of_a_surface() {
    let lines = 3;
    let along_x = (0..lines).flat_map(|line| (0..POINTS).map(move |i| (i, line)));
    let along_y = (0..POINTS).flat_map(|i| (0..lines).map(move |line| (i, line)));
    let text = |points: &mut dyn Iterator<Item = (usize, usize)>| {
        let mut text = String::from("x [um],y [um],z [nm]\n");
        for (i, line) in points {
            let z = 1e3 * height(i) * (line + 1) as f64;
            text += &format!("{},{},{z:.3}\n", 0.5 * i as f64, 2 * line);
        }
        text
    };
    for text in [text(&mut along_x.clone()), text(&mut along_y.clone())] {
        let message = refused("a.csv", &text);
        assert!(
            message.starts_with("E119") && message.contains("3 profiles"),
            "{message}"
        );
        let second = read_bytes("a.csv", text.as_bytes(), &row(2)).unwrap();
        assert_eq!((second.format, second.points), (Format::PointText, POINTS));
        is_near(&second, 2.0);
        let mean = ReadOptions {
            line: TraceLine::Mean,
            ..ReadOptions::default()
        };
        is_near(&read_bytes("a.csv", text.as_bytes(), &mean).unwrap(), 2.0);
        let surface =
            read_surface_bytes("a.csv", text.as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!((surface.columns, surface.rows), (POINTS, lines));
        assert!((surface.dx.unwrap().si() / 0.5e-6 - 1.0).abs() < 1e-9);
        assert!((surface.dy.unwrap().si() / 2e-6 - 1.0).abs() < 1e-9);
        assert!((surface.z[POINTS + 5] - 2e-6 * height(5)).abs() < 1e-12);
    }
    // Points that a program leaves out are missing.
    let holes = [(0, 1), (5, 1), (6, 1), (9, 2)];
    let text = text(&mut along_x.clone().filter(|point| !holes.contains(point)));
    let surface = read_surface_bytes("a.csv", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!((surface.columns, surface.rows), (POINTS, lines));
    assert_eq!(surface.measured(), lines * POINTS - holes.len());
    let refused_row = read_bytes("a.csv", text.as_bytes(), &row(2)).unwrap_err();
    assert_eq!(refused_row.code(), "E107");
    let filled = ReadOptions {
        gaps: Gaps::Interpolate,
        ..row(2)
    };
    let reading = read_bytes("a.csv", text.as_bytes(), &filled).unwrap();
    assert_eq!(reading.points, POINTS - 1, "the first point is cut off");
    assert!((reading.profile.heights()[2] - 2e-6 * height(3)).abs() < 1e-12);
    // Points on no grid are refused, and not read as one line.
    let scattered = pairs(|x, z| format!("{},{},{z:.6}", (x * 37.0) % 11.0, (x * 17.0) % 13.0));
    assert!(refused("a.csv", &scattered).starts_with("E112"));
}

#[test]
fn matrices_use_the_spacing_and_unit_of_their_header() {
    let line = |factor: f64, unit: f64| {
        let heights = (0..POINTS).map(|i| format!("{:.9e}", factor * height(i) / unit));
        heights.collect::<Vec<_>>().join("\t") + "\n"
    };
    let gwyddion = "# Channel: Topography\n# Width: 120 µm\n# Height: 4.0 µm\n# Value units: m\n";
    let text = format!("{gwyddion}{}{}", line(1.0, 1e6), line(2.0, 1e6));
    let reading = read_bytes("a.txt", text.as_bytes(), &row(2)).unwrap();
    assert_eq!(reading.spacing_source, SpacingSource::Header);
    assert!((reading.spacing.si() / 0.5e-6 - 1.0).abs() < 1e-12 && reading.warnings.is_empty());
    is_near(&reading, 2.0);
    let surface = read_surface_bytes("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert!((surface.dy.unwrap().si() / 2e-6 - 1.0).abs() < 1e-12);
    let bruker = format!("\\Exported image units: nm\n{}", line(1.0, 1e-3).repeat(2));
    let options = ReadOptions {
        dx: Some(Length::from_si(0.5e-6)),
        ..row(1)
    };
    let reading = read_bytes("a.txt", bruker.as_bytes(), &options).unwrap();
    assert_eq!(
        (reading.z_unit, reading.warnings.len()),
        (LengthUnit::Nanometre, 0)
    );
    is_near(&reading, 1.0);
    let phase = format!(
        "{}{}",
        gwyddion.replace("units: m", "units: deg"),
        line(1.0, 1e6).repeat(2)
    );
    let error = read_bytes("a.txt", phase.as_bytes(), &row(1)).unwrap_err();
    assert_eq!(error.code(), "E114");
}

#[test]
fn a_spacing_in_the_header_is_used_or_contradicted() {
    for header in [
        "# dx = 0.5 um",
        "X-Resolution: 0.5 µm",
        "Sampling interval [mm]\t0.0005",
    ] {
        let text = format!("{header}\nz [um]\n{}", heights(|z| format!("{z:.6}")));
        let reading = read_as("a.txt", text.as_bytes());
        check(&reading, Format::DelimitedText, 6);
        assert_eq!(reading.spacing_source, SpacingSource::Header, "{header}");
    }
    let text = format!(
        "# dx = 0.4 um\nx [um];z [um]\n{}",
        pairs(|x, z| format!("{x};{z:.6}"))
    );
    let reading = read_as("a.csv", text.as_bytes());
    check(&reading, Format::DelimitedText, 6);
    assert!(
        matches!(&reading.warnings[..], [Warning::HeaderDisagrees { what, .. }] if what == "spacing"),
        "{:?}",
        reading.warnings
    );
}

#[test]
fn a_trace_number_is_not_a_spacing_or_a_height() {
    // Text of a 3-D stylus instrument: the number of the trace stands above its heights.
    let text = format!(
        "Recipe\tR1\nPoints per trace\t{POINTS}\nTrace\n1\n{}",
        heights(|z| format!("{:.4}", z + 20.0))
    );
    assert!(
        refused("a.txt", &text).starts_with("E110"),
        "{}",
        refused("a.txt", &text)
    );
    let options = ReadOptions {
        dx: Some(Length::from_si(0.5e-6)),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let error = read_bytes("a.txt", text.as_bytes(), &options).unwrap_err();
    assert_eq!(error.code(), "E117", "{error}");
}

#[test]
fn the_base_circle_of_the_header_converts_roll_lengths() {
    let rows = |roll: f64| {
        let row = |i: usize| format!("{},{:.6}\n", roll + 0.001 * i as f64, height(i));
        (0..POINTS).map(row).collect::<String>()
    };
    for header in [
        "# Base diameter = 100 mm\nRoll length [mm],z [um]",
        "# Base radius: 50 mm\n# Roll length in mm",
    ] {
        let text = format!("{header}\n{}", rows(10.0));
        let options = ReadOptions {
            z_unit: Some(LengthUnit::Micrometre),
            ..ReadOptions::default()
        };
        let reading = read_bytes("a.csv", text.as_bytes(), &options).unwrap();
        let arc = reading.metadata.arc_from_base.unwrap();
        assert!((arc.si() / 1e-3 - 1.0).abs() < 1e-9, "{header}: {arc}");
        let other = ReadOptions {
            base_radius: Some(Length::from_si(40e-3)),
            ..options
        };
        let reading = read_bytes("a.csv", text.as_bytes(), &other).unwrap();
        assert!(
            reading
                .warnings
                .iter()
                .any(|warning| warning.code() == "W325")
        );
    }
}

#[test]
fn marks_and_tails_of_missing_points_are_cut_on_request() {
    let table = pairs(|x, z| format!("{x};{z:.6}"));
    let with = |tail: &str| format!("x [um];z [um]\n{table}{tail}");
    let interpolated = ReadOptions {
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    for mark in ["NaN", "-2147483648", "1e30"] {
        let tail: String = (0..80)
            .map(|i| format!("{};{mark}\n", 120.0 + 0.5 * f64::from(i)))
            .collect();
        let message = refused("a.csv", &with(&tail));
        assert!(
            message.starts_with("E107") && message.contains("interpolate"),
            "{message}"
        );
        let reading = read_bytes("a.csv", with(&tail).as_bytes(), &interpolated).unwrap();
        check(&reading, Format::DelimitedText, 6);
    }
    let reading = read_as("a.csv", with(&"NaN;NaN\n".repeat(80)).as_bytes());
    check(&reading, Format::DelimitedText, 6);
    assert_eq!(reading.warnings, [Warning::EmptyRows { rows: 80 }]);
    let repeated = with("").replacen("\n5;", "\n4.5;", 1);
    let message = refused("a.csv", &repeated);
    assert!(
        message.starts_with("E105") && message.contains("x repeats 4.5"),
        "{message}"
    );
}

#[test]
fn the_filter_of_a_written_profile_is_read_back() {
    let header = "# filter: roughness, lambda_c 0.8 mm, lambda_s 2.5 um\nx [um],z [um]";
    let text = format!("{header}\n{}", pairs(|x, z| format!("{x},{z:.6}")));
    let reading = read_as("a.csv", text.as_bytes());
    assert_eq!(reading.filter_state, FilterState::Roughness);
    assert_eq!(reading.metadata.lambda_c, Some(Length::from_si(0.8e-3)));
    assert_eq!(reading.metadata.lambda_s, Some(Length::from_si(2.5e-6)));
}
