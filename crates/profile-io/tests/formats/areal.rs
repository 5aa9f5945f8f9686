//! Surfaces of instruments: every point, the spacing, and the traces that are taken from them.

use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Format, Gaps, ReadError, ReadOptions, Reading, Surface, TraceLine, read_bytes,
    read_surface_bytes,
};

use super::areal_files::*;

fn surface(name: &str, bytes: &[u8]) -> Surface {
    let options = ReadOptions {
        z_unit: name.ends_with(".mat").then(|| "um".parse().unwrap()),
        ..ReadOptions::default()
    };
    read_surface_bytes(name, bytes, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn options(line: TraceLine, row: Option<usize>) -> ReadOptions {
    ReadOptions {
        line,
        row,
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    }
}

fn trace(
    name: &str,
    bytes: &[u8],
    line: TraceLine,
    row: Option<usize>,
) -> Result<Reading, ReadError> {
    read_bytes(name, bytes, &options(line, row))
}

#[test]
fn every_point_of_every_areal_format_is_where_it_was_written() {
    let formats = [
        Format::DigitalSurf,
        Format::DigitalSurf,
        Format::AliconaAl3d,
        Format::KeyenceVk,
        Format::KeyenceVk,
        Format::SensofarPlu,
        Format::SensofarPlux,
        Format::MetroPro,
        Format::ZygoXyz,
        Format::ZygoText,
        Format::WykoText,
        Format::Opd,
        Format::SdfBinary,
        Format::SdfBinary,
        Format::Opdx,
        Format::Matlab,
        Format::NanosurfNid,
        Format::IgorWave,
        Format::Gwyddion,
        Format::GwyddionSimple,
    ];
    for ((name, bytes), format) in all().into_iter().zip(formats) {
        let found = surface(name, &bytes);
        let rows = if format == Format::Opdx { 1 } else { ROWS };
        assert_eq!(
            (found.format, found.columns, found.rows),
            (format, COLUMNS, rows),
            "{name}"
        );
        // Keyence counts from below and has no mark for a missing point.
        let (level, holes) = match format {
            Format::KeyenceVk => (3000.0, false),
            _ => (0.0, true),
        };
        for row in 0..rows {
            for column in 0..COLUMNS {
                let at = row * COLUMNS + column;
                let hole = holes && is_hole(column, row);
                assert_eq!(found.mask[at], !hole, "{name} {column} {row}");
                let exact = (f64::from(nanometres(column, row)) + level) * 1e-9;
                // Floats of some formats hold seven digits.
                let off = (found.z[at] - exact).abs();
                assert!(
                    hole || off <= 2e-7 * exact.abs(),
                    "{name} {column} {row}: {off}"
                );
            }
        }
        assert_eq!(
            found.measured(),
            COLUMNS * rows - usize::from(holes && rows > 1)
        );
        if format != Format::Matlab {
            let dx = found.dx.unwrap().si();
            assert!((dx / 0.5e-6 - 1.0).abs() < 1e-6, "{name}: {dx}");
        }
        if ![
            Format::Matlab,
            Format::Opdx,
            Format::MetroPro,
            Format::ZygoXyz,
            Format::ZygoText,
        ]
        .contains(&format)
        {
            let dy = found.dy.unwrap().si();
            assert!((dy / 2e-6 - 1.0).abs() < 1e-6, "{name}: {dy}");
        }
    }
}

#[test]
fn rows_columns_and_means_are_traces() {
    for (name, bytes) in all().into_iter().filter(|(name, _)| !name.ends_with("mat")) {
        let row = match name {
            "a.opdx" => 1,
            _ => 3,
        };
        let reading = trace(name, &bytes, TraceLine::Row, Some(row)).unwrap();
        assert_eq!(reading.points, COLUMNS, "{name}");
        let whole = surface(name, &bytes);
        assert_eq!(
            reading.profile.heights(),
            whole.row(row - 1).unwrap(),
            "{name}"
        );
        if row == 1 {
            continue;
        }
        let refused = trace(name, &bytes, TraceLine::Row, None).unwrap_err();
        assert_eq!(refused.code(), "E119", "{name}");
        let remedy = "Set row to 1 .. 3, or set rows to 3 for several of them";
        assert_eq!(refused.remedy().to_string(), remedy);
        assert_eq!(
            trace(name, &bytes, TraceLine::Row, Some(4))
                .unwrap_err()
                .code(),
            "E119"
        );
        // Three points of a column are no profile.
        assert_eq!(
            trace(name, &bytes, TraceLine::Column, Some(1))
                .unwrap_err()
                .code(),
            "E106"
        );
        let reading = trace(name, &bytes, TraceLine::Mean, None).unwrap();
        for (column, z) in reading.profile.heights().iter().enumerate() {
            let known = (0..ROWS)
                .map(|row| whole.row(row).unwrap()[column])
                .filter(|z| z.is_finite());
            let known: Vec<f64> = known.collect();
            let mean = known.iter().sum::<f64>() / known.len() as f64;
            assert!((z - mean).abs() <= 1e-15, "{name} {column}");
        }
        assert!(
            reading
                .warnings
                .contains(&Warning::MeanLine { lines: ROWS }),
            "{name}"
        );
    }
}

#[test]
fn a_missing_point_of_a_row_is_refused_or_filled() {
    let refused = read_bytes(
        "a.sur",
        &sur(2, false),
        &ReadOptions {
            row: Some(HOLE.1 + 1),
            ..ReadOptions::default()
        },
    );
    assert_eq!(refused.unwrap_err().code(), "E107");
    let reading = trace("a.sur", &sur(2, false), TraceLine::Row, Some(HOLE.1 + 1)).unwrap();
    assert_eq!((reading.points, reading.gaps_filled), (COLUMNS, 1));
}

#[test]
fn a_column_is_read_along_y_with_its_own_spacing() {
    // 120 rows of three points: the transposed matrix.
    let bytes = mat(&[mat_array("z", COLUMNS, ROWS, |x, y| um(y, x))], false);
    let read = |options: &ReadOptions| read_bytes("a.mat", &bytes, options).unwrap();
    let reading = read(&ReadOptions {
        z_unit: "um".parse().ok(),
        dx: "2 um".parse().ok(),
        ..options(TraceLine::Column, Some(3))
    });
    assert_eq!(reading.spacing, "2 um".parse().unwrap());
    let exact: Vec<f64> = (0..COLUMNS).map(|i| um(i, 2) / 1e6).collect();
    assert_eq!(reading.profile.heights(), exact);
}

#[test]
fn a_unit_stated_for_a_file_that_scales_its_heights_changes_nothing_and_is_told() {
    let text = ("text.sdf", super::samples::sdf(1).into_bytes());
    for (name, bytes) in all().into_iter().chain([text]) {
        let stated = ReadOptions {
            x_unit: "mm".parse().ok(),
            z_unit: "um".parse().ok(),
            ..options(TraceLine::Row, Some(1))
        };
        if name.ends_with(".mat") {
            continue;
        }
        let plain = trace(name, &bytes, TraceLine::Row, Some(1)).unwrap();
        let found = read_bytes(name, &bytes, &stated).unwrap();
        assert_eq!(found.profile, plain.profile, "{name}");
        let codes: Vec<_> = found.warnings.iter().map(Warning::code).collect();
        let not_used = codes.iter().filter(|code| **code == "W323").count();
        assert_eq!(not_used, 2, "{name} {codes:?}");
        let whole = read_surface_bytes(name, &bytes, &stated).unwrap();
        assert!(whole.warnings.iter().any(|note| note.code() == "W323"));
        let height = |surface: &Surface| surface.z.iter().copied().fold(0.0, f64::max);
        assert_eq!(height(&whole), height(&surface(name, &bytes)), "{name}");
    }
}

#[test]
fn a_vector_of_matlab_is_a_profile_and_needs_its_unit_and_spacing() {
    for (rows, columns) in [(COLUMNS, 1), (1, COLUMNS)] {
        let vector = mat_array("z", rows, columns, |x, y| um(x.max(y), 0));
        let noise = mat_array("t", 1, 1, |_, _| 1.0);
        let bytes = mat(&[noise, vector], true);
        let bare = read_bytes("a.mat", &bytes, &ReadOptions::default());
        assert_eq!(bare.unwrap_err().code(), "E110");
        let options = ReadOptions {
            z_unit: "um".parse().ok(),
            dx: "0.5 um".parse().ok(),
            ..ReadOptions::default()
        };
        let reading = read_bytes("a.mat", &bytes, &options).unwrap();
        let exact: Vec<f64> = (0..COLUMNS).map(|i| um(i, 0) / 1e6).collect();
        assert_eq!(reading.profile.heights(), exact);
    }
    let several = mat(&[mat_array("a", 3, 3, um), mat_array("b", 3, 3, um)], false);
    let refused = read_surface_bytes("a.mat", &several, &ReadOptions::default()).unwrap_err();
    assert_eq!(
        (
            refused.code().as_str(),
            refused.to_string().ends_with("a, b")
        ),
        ("E321", true)
    );
}

#[test]
fn a_profile_of_digital_surf_has_one_row() {
    let reading = trace("a.pro", &sur(1, true), TraceLine::Row, None).unwrap();
    assert_eq!(
        (reading.points, reading.format),
        (COLUMNS, Format::DigitalSurf)
    );
    assert_eq!(reading.metadata.date.as_deref(), Some("2026-11-20"));
    assert_eq!(reading.metadata.title.as_deref(), Some("flank 7"));
}

#[test]
fn contents_without_heights_and_replicas_are_told() {
    let refused = read_bytes("a.sur", &sur(12, false), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E320");
    assert!(
        refused.to_string().ends_with("holds a colour image"),
        "{refused}"
    );
    let mut replica = sur(2, false);
    replica[288] = 1;
    assert!(
        surface("a.sur", &replica)
            .warnings
            .contains(&Warning::Replica)
    );
    let mut arbitrary = sur(2, false);
    arbitrary[212..216].copy_from_slice(b"a.u.");
    let refused = read_bytes("a.sur", &arbitrary, &options(TraceLine::Mean, None)).unwrap_err();
    assert_eq!(refused.code(), "E114");
    let mut picture = plu();
    picture[428] = 0;
    let refused = read_bytes("a.plu", &picture, &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E320");
}

#[test]
fn a_file_that_does_not_start_as_its_name_says_is_damaged() {
    for name in ["a.sur", "a.plu", "a.opd", "a.x3p", "a.mat"] {
        let bytes = [0, 1, 2, 255, 0, 7];
        let refused = read_bytes(name, &bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E117", "{refused}");
        let refused = read_surface_bytes(name, &bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E117", "{refused}");
    }
    // A title that starts as the mark of a binary file.
    let text: String = (0..200).map(|i| format!("{};{}.5\n", i, i % 7)).collect();
    let text = format!("VK6 trace of flank 7\nx [um];z [um]\n{text}");
    assert_eq!(
        read_bytes("a.csv", text.as_bytes(), &ReadOptions::default())
            .unwrap()
            .points,
        200
    );
}

#[test]
fn the_sign_of_metropro_turns_the_heights_round() {
    let [plain, turned] = [0, 1].map(|sign| surface("a.dat", &metropro(sign)));
    let pairs = plain.z.iter().zip(&turned.z).filter(|(z, _)| z.is_finite());
    assert!(pairs.clone().count() > 300);
    for (z, other) in pairs {
        assert_eq!(*z, -other);
    }
}

#[test]
fn headers_that_promise_more_than_the_file_holds_are_refused() {
    // Places of a count in the header, and what is written there.
    let huge = u32::MAX.to_le_bytes();
    let cases: [(&str, Vec<u8>, usize); 6] = [
        ("a.sur", sur(2, false), 108),
        ("b.sur", sur(2, true), 112),
        ("a.vk4", vk4(), 404),
        ("a.plu", plu(), 500),
        ("b.sdf", sdf_binary(true), 42),
        ("a.dat", metropro(0), 6),
    ];
    for (name, mut bytes, at) in cases {
        bytes[at..at + 4].copy_from_slice(&huge);
        let refused = read_surface_bytes(name, &bytes, &ReadOptions::default()).unwrap_err();
        assert!(
            ["E117", "E118"].contains(&refused.code().as_str()),
            "{name}: {refused}"
        );
    }
    let rows = "Rows\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0";
    let mut bytes = al3d();
    let at = bytes
        .windows(20)
        .position(|tag| tag == rows.as_bytes())
        .unwrap()
        + 20;
    bytes[at..at + 10].copy_from_slice(b"4000000000");
    let refused = read_surface_bytes("a.al3d", &bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E117");
    // A hundred million zeros in a stream of a hundred kilobytes.
    let bomb = zlib(&vec![0; 100_000_000]);
    let bytes = [
        mat(&[], false),
        [15, bomb.len() as u32].map(u32::to_le_bytes).concat(),
        bomb,
    ]
    .concat();
    let refused = read_surface_bytes("a.mat", &bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E117");
}

#[test]
fn formats_without_a_public_layout_are_refused_by_the_name_of_their_maker() {
    let junk = |mark: &[u8]| [mark, &[0, 1, 2, 255, 0, 7][..]].concat();
    let ole = junk(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1");
    for (name, bytes, maker, instead) in [
        ("a.fts", junk(b""), "Taylor Hobson", "prf"),
        ("a.mod", junk(b""), "Taylor Hobson", "prf"),
        ("a.hwp", junk(b""), "Hommel", "hfm"),
        ("a.pcd", junk(b""), "Mahr", "MarWin"),
        ("a.mnt", ole, "MountainsMap", "sur"),
        ("a.nms", junk(b""), "NanoFocus", "X3P"),
        ("a.lext", junk(b"II*\0"), "Olympus", "X3P"),
    ] {
        let refused = read_bytes(name, &bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E108", "{name}");
        assert!(refused.to_string().contains(maker), "{refused}");
        assert!(
            refused.remedy().to_string().contains(instead),
            "{}",
            refused.remedy()
        );
    }
}
