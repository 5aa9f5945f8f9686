//! Text files of instruments that name themselves, and the ends of their blocks.

use asperity_core::Code;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Axis, Format, LengthUnit, ReadOptions, Surface, TraceLine, read_bytes, read_surface_bytes,
};

use super::areal_files::{self, COLUMNS, HOLE, ROWS, is_hole, nanometres};

/// The heights in micrometres between tabs, a line each row.
fn rows() -> String {
    let row = |y| (0..COLUMNS).map(move |x| format!("{:.3}", areal_files::um(x, y)));
    (0..ROWS)
        .map(|y| row(y).collect::<Vec<_>>().join("\t") + "\n")
        .collect()
}

fn surface(name: &str, bytes: &[u8]) -> Surface {
    read_surface_bytes(name, bytes, &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// All heights, and spacings of 0.5 and `dy` micrometres.
fn is_right(about: &str, found: &Surface, dy: f64) {
    assert_eq!((found.columns, found.rows), (COLUMNS, ROWS), "{about}");
    let spacings = [found.dx, found.dy].map(|step| step.map(|step| step.si() * 1e6));
    for (step, expected) in spacings.into_iter().zip([0.5, dy]) {
        let step = step.unwrap_or_else(|| panic!("{about}"));
        assert!((step / expected - 1.0).abs() < 1e-9, "{about}: {step}");
    }
    for (at, z) in found.z.iter().enumerate() {
        let (x, y) = (at % COLUMNS, at / COLUMNS);
        let exact = 1e-9 * f64::from(nanometres(x, y));
        assert!(
            is_hole(x, y) == z.is_nan() && (z.is_nan() || (z - exact).abs() < 1e-12),
            "{about} {x} {y}"
        );
    }
}

fn refused(name: &str, bytes: &[u8]) -> (Code, String) {
    let options = ReadOptions {
        row: Some(1),
        ..ReadOptions::default()
    };
    let profile = read_bytes(name, bytes, &options).unwrap_err();
    let surface = read_surface_bytes(name, bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!(profile.to_string(), surface.to_string());
    (profile.code(), format!("{profile}. {}", profile.remedy()))
}

#[test]
fn wyko_ascii_has_its_unit_spacing_and_missing_points_and_its_intensities_are_no_heights() {
    for in_nanometres in [true, false] {
        let bytes = areal_files::wyko_text(in_nanometres);
        is_right("wyko", &surface("a.asc", &bytes), 2.0);
        let text = String::from_utf8(bytes).unwrap();
        let marked = format!("\u{feff}{text}");
        is_right(
            "with a mark of UTF-8",
            &surface("a.txt", marked.as_bytes()),
            2.0,
        );
        let words = marked.encode_utf16().flat_map(u16::to_le_bytes);
        is_right(
            "in UTF-16",
            &surface("a.txt", &words.collect::<Vec<u8>>()),
            2.0,
        );
        let cut = &text[..text.find("Intensity").unwrap() - 200];
        assert!(
            refused("a.asc", cut.as_bytes())
                .1
                .contains("not a valid Wyko ASCII file: the number of heights")
        );
    }
    // The lines of the file are columns of the surface.
    let column = ReadOptions {
        line: TraceLine::Column,
        row: Some(HOLE.0 + 2),
        ..ReadOptions::default()
    };
    let refused = read_bytes("a.asc", &areal_files::wyko_text(true), &column).unwrap_err();
    assert_eq!(
        (
            refused.code(),
            refused.remedy().to_string().contains("line to row")
        ),
        (Code::E106, true)
    );
}

#[test]
fn a_grid_of_code_v_is_read_and_has_no_spacing() {
    let bytes = areal_files::code_v();
    let options = ReadOptions {
        dx: "0.5 um".parse().ok(),
        dy: "2 um".parse().ok(),
        ..ReadOptions::default()
    };
    is_right(
        "code v",
        &read_surface_bytes("a.int", &bytes, &options).unwrap(),
        2.0,
    );
    assert_eq!(surface("a.int", &bytes).dx, None);
    let filter = String::from_utf8(bytes).unwrap().replace(" SUR ", " FIL ");
    assert_eq!(refused("a.int", filter.as_bytes()).0, "E320");
}

/// Headers of matrices that state their size, their spacings or sides, and the unit of their heights.
#[test]
fn matrices_with_a_header_of_their_instrument_are_read_without_an_option() {
    let (x, y) = (500 * COLUMNS, 2000 * ROWS);
    let spip = format!(
        "# File Format = ASCII\r\n# Created by SPIP 6.7.9 2020-03-04\n# Original file: flank.plu\n# forcecurve = 0\n# x-pixels = {COLUMNS}\n# y-pixels = {ROWS}\n# x-length = {x}\n# y-length = {y}\n# x-offset = 0\n# z-unit = um\n# voidpixels =1\n# description =\nOperator: \n# Start of Data:\n"
    );
    let nova = format!(
        "File Format = ASCII\nCreated by Nova 1.1.0\nNX = {COLUMNS}\nNY = {ROWS}\nScale X = 0.5\nScale Y = 2.0\nUnit X = um\nUnit Y = um\nUnit Data = um\nStart of Data :\n"
    );
    let japanese = "\"機種\"\t\"VK-X1000 Series\"\n\"XYキャリブレーション\"\t\"0.5\"\t\"μm\"\n\"横\"\t\"120\"\n\"単位\"\t\"μm\"\n\n\"高さ\"\n";
    // A holographic microscope, whose numbers are angles, and SPIP without a unit.
    let hologram = format!(
        "h={ROWS} w={COLUMNS}\npixel size=5e-007 m\ndata unit=rad\nheight conversion factor (-> m)=1e-006\n"
    );
    let bits = spip.replace("# z-unit = um", "# Bit2nm = 1000");
    let profilm =
        format!("numCols\tnumRows\tpixelSize (um)\n{COLUMNS}\t{ROWS}\t0.5\nZ-data (um)\n");
    for (header, dy) in [
        (spip.as_str(), 2.0),
        (&nova, 2.0),
        (&hologram, 0.5),
        (&bits, 2.0),
        (japanese, 0.5),
        (&profilm, 0.5),
    ] {
        is_right(
            header,
            &surface("a.txt", (header.to_owned() + &rows()).as_bytes()),
            dy,
        );
        // The numbers of the stated size may be on lines of any length.
        let one_line = header.to_owned() + &rows().replace('\n', "\t");
        if header.contains("120") && !header.contains("横") {
            is_right(header, &surface("a.txt", one_line.as_bytes()), dy);
            let short = &one_line[..one_line.trim_end().rfind('\t').unwrap()];
            assert!(
                read_surface_bytes("a.txt", short.as_bytes(), &ReadOptions::default()).is_err()
            );
        }
    }
    // One number to a line, and points x y z under the size of their grid.
    let column = format!(
        "NX = {COLUMNS}\nNY = {ROWS}\nScale X = 0.5\nScale Y = 2\nUnit X = um\nUnit Data = um\n"
    );
    is_right(
        "column",
        &surface("a.txt", (column + &rows().replace('\t', "\n")).as_bytes()),
        2.0,
    );
    let point = |(y, line): (usize, &str)| -> String {
        let points = line.split('\t').enumerate();
        points
            .map(|(x, z)| format!("{:.1}\t{y}\t{z}\n", 0.5 * x as f64))
            .collect()
    };
    let points: String = rows()
        .lines()
        .enumerate()
        .map(|(y, line)| point((2 * y, line)))
        .collect();
    let text = format!("NX = {COLUMNS}\nNY = {ROWS}\nx [um]\ty [um]\tz [um]\n{points}");
    is_right("points", &surface("a.txt", text.as_bytes()), 2.0);
    // Columns that are named by numbers, after the number of the line.
    let names: Vec<String> = (0..COLUMNS).map(|x| format!("POS = {x}")).collect();
    let line = |(y, row): (usize, &str)| format!("{y}\t{row}\n");
    let numbered: String = rows().lines().enumerate().map(line).collect();
    let text = format!(
        "X Resolution[um]\t0.5\nY Resolution[um]\t2\nZ unit\tum\nDataLine\t{}\n{numbered}",
        names.join("\t")
    );
    is_right("olympus", &surface("a.csv", text.as_bytes()), 2.0);
}

/// Wyko and Zygo scale their numbers themselves, whatever unit is stated; SPIP has any unit in its head.
#[test]
fn a_unit_stated_beside_a_named_file_changes_no_height() {
    use LengthUnit::{Inch, Metre, Micrometre, Mil, Millimetre, Nanometre};
    let (x, y) = (500 * COLUMNS, 2000 * ROWS);
    for unit in [Millimetre, Micrometre, Nanometre, Mil, Inch, Metre] {
        let height = |x, y| areal_files::um(x, y) / (1e6 * unit.metres(1.0));
        let row = |y| (0..COLUMNS).map(move |x| format!("{:.12e}", height(x, y)));
        let rows: String = (0..ROWS)
            .map(|y| row(y).collect::<Vec<_>>().join("\t") + "\n")
            .collect();
        let spip = format!(
            "# File Format = ASCII\n# x-pixels = {COLUMNS}\n# y-pixels = {ROWS}\n# x-length = {x}\n# y-length = {y}\n# z-unit = {unit}\n# Start of Data:\n{rows}"
        );
        is_right("spip", &surface("a.asc", spip.as_bytes()), 2.0);
        let files = [
            spip.into_bytes(),
            areal_files::wyko_text(true),
            areal_files::wyko_text(false),
            areal_files::zygo_text(),
            areal_files::zygo_xyz(),
        ];
        for (number, bytes) in files.iter().enumerate() {
            let read = |x_unit, z_unit| {
                let options = ReadOptions {
                    x_unit,
                    z_unit,
                    row: Some(ROWS),
                    ..ReadOptions::default()
                };
                let surface = read_surface_bytes("a.asc", bytes, &options).unwrap();
                let heights: Vec<u64> = surface.z.iter().map(|z| z.to_bits()).collect();
                let profile = read_bytes("a.asc", bytes, &options).unwrap().profile;
                (heights, surface.dx, surface.dy, profile)
            };
            let (plain, stated) = (read(None, None), Some(unit));
            for units in [(stated, None), (None, stated), (stated, stated)] {
                assert_eq!(read(units.0, units.1), plain, "{number} {units:?}");
            }
        }
    }
}

/// The scale of a header is applied once, and what it is of is not a unit.
#[test]
fn numbers_with_a_scale_are_metres_and_a_matrix_with_its_size_may_be_narrow() {
    let header = |more: &str| format!("h=5 w=12\npixel size=5e-007 m\ndata unit=rad\n{more}");
    let row = |y: u32| (0..12).map(move |x| format!("{}.5", x * y));
    let rows: String = (0..5)
        .map(|y| row(y).collect::<Vec<_>>().join(" ") + "\n")
        .collect();
    let scaled = header("height conversion factor (-> m)=2.5e-008\n") + &rows;
    let found = surface("a.txt", scaled.as_bytes());
    assert_eq!((found.columns, found.rows), (12, 5));
    assert!((found.z[4 * 12 + 11] - 44.5 * 2.5e-8).abs() < 1e-18);
    assert!((found.dy.unwrap().si() - 0.5e-6).abs() < 1e-15);
    // A stated unit changes nothing, and says so.
    let stated = ReadOptions {
        z_unit: "um".parse().ok(),
        ..ReadOptions::default()
    };
    let again = read_surface_bytes("a.txt", scaled.as_bytes(), &stated).unwrap();
    assert_eq!(again.z, found.z);
    let (axis, unit) = (Axis::Height, LengthUnit::Micrometre);
    assert!(
        again
            .warnings
            .contains(&Warning::UnitNotUsed { axis, stated: unit })
    );
    let row = ReadOptions {
        row: Some(1),
        ..ReadOptions::default()
    };
    let short = read_bytes("a.txt", scaled.as_bytes(), &row).unwrap_err();
    assert_eq!(short.code(), Code::E106, "{short}");
    // Angles without a scale are no heights.
    assert_eq!(
        refused("a.txt", (header("") + &rows).as_bytes()).0,
        Code::E114
    );
}

#[test]
fn a_line_of_text_ends_a_block_of_numbers() {
    let two = format!("{}Intensity\t3\t9\n{}", rows(), rows());
    let options = ReadOptions {
        z_unit: "um".parse().ok(),
        ..ReadOptions::default()
    };
    let refused = read_surface_bytes("a.txt", two.as_bytes(), &options).unwrap_err();
    let said = format!("{refused}. {}", refused.remedy());
    assert!(
        said.contains(":4:") && said.contains("another table seems to begin here"),
        "{said}"
    );
    assert!(
        said.ends_with("Export one table to a file, or delete the others"),
        "{said}"
    );
    // So it is for a row that does not need the lines after it.
    let row = ReadOptions {
        row: Some(1),
        ..options
    };
    assert_eq!(
        read_bytes("a.txt", two.as_bytes(), &row)
            .unwrap_err()
            .to_string(),
        refused.to_string()
    );
}

#[test]
fn formats_that_are_not_read_are_named_by_their_first_line_with_a_way_out() {
    for (start, format, way) in [
        (
            "Gwyddion XYZ Field 1.0\nNPoints = 9\n\0\0",
            Format::GwyddionPoints,
            "Rasterise the points in Gwyddion and save the image as gwy or gsf",
        ),
        (
            "Binary TrueMap Data File v2.0\r\n\0",
            Format::TrueMap,
            "Open it in Gwyddion and save it as gwy or gsf",
        ),
        (
            "ISO/TC 201 SPM data transfer format\ngeneral information\n1\n2\n3\n",
            Format::Iso28600,
            "Open it in Gwyddion and save it as gwy or gsf",
        ),
        (
            "Precitec Optronik - FSS Explorer v2.749 - SCAN PATH DATA;\n1;2\n2;3\n",
            Format::Precitec,
            "Write its columns X Pos, Y Pos",
        ),
    ] {
        let (code, said) = refused("a.bin", start.as_bytes());
        assert_eq!(code, "E108");
        assert!(
            said.starts_with(&format!(
                "a.bin: {format} is not read by this version. {way}"
            )),
            "{said}"
        );
    }
    // The way out of Precitec.
    let point = |k: usize| {
        let (x, y) = (k % COLUMNS, k / COLUMNS);
        // There and back again.
        let x = if y % 2 == 1 { COLUMNS - 1 - x } else { x };
        format!(
            "1;{:.4};3.99;{:.4};{:.4}\n",
            areal_files::um(x, y),
            -44.6 + 5e-4 * x as f64,
            -43.3 + 2e-3 * y as f64
        )
    };
    let points: String = (0..COLUMNS * ROWS).map(point).collect();
    let text = format!("Encoder;z [um];Intensity;x [mm];y [mm]\n{points}");
    is_right("precitec", &surface("a.csv", text.as_bytes()), 2.0);
}
