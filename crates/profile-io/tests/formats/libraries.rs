//! Files that libraries of others have written (references/library_files.py): HDF5 and xls.

use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Format, ReadError, ReadOptions, Surface, TraceLine, read_bytes, read_surface_bytes,
};

const OWN: &[u8] = include_bytes!("../made/own.h5");
const MATLAB: &[u8] = include_bytes!("../made/level_7_3.mat");
const NANOMETRES: &[u8] = include_bytes!("../made/nanometres.datx");
const FRINGES: &[u8] = include_bytes!("../made/fringes.datx");
const WORKBOOK: &[u8] = include_bytes!("../made/workbook.xls");
const FURLONGS: &[u8] = include_bytes!("../made/furlongs.datx");
const SIZE: (usize, usize) = (120, 6);

fn stated() -> ReadOptions {
    ReadOptions {
        z_unit: "nm".parse().ok(),
        dx: "0.5 um".parse().ok(),
        ..ReadOptions::default()
    }
}

/// Checks the height of every point but the one that `is_hole` names.
fn compare(found: &Surface, is_hole: impl Fn(usize, usize) -> bool) {
    assert_eq!((found.columns, found.rows), SIZE);
    for row in 0..found.rows {
        for column in 0..found.columns {
            let at = row * found.columns + column;
            assert_eq!(found.mask[at], !is_hole(column, row), "{column} {row}");
            let exact = (column as f64 + 100.0 * row as f64) * 1e-9;
            let off = (found.z[at] - exact).abs();
            assert!(
                !found.mask[at] || off <= 1e-15 * (1.0 + exact),
                "{column} {row}: {off}"
            );
        }
    }
}

fn refused(name: &str, bytes: &[u8]) -> ReadError {
    read_surface_bytes(name, bytes, &stated()).unwrap_err()
}

#[test]
fn matrices_of_matlab_and_of_own_programs_have_each_height_at_its_place() {
    for (name, bytes, format, title) in [
        ("a.mat", MATLAB, Format::Matlab, "Z"),
        ("a.h5", OWN, Format::Hdf5, "flank/z"),
    ] {
        let found = read_surface_bytes(name, bytes, &stated()).unwrap();
        assert_eq!(
            (found.format, found.metadata.title.as_deref()),
            (format, Some(title))
        );
        compare(&found, |_, _| false);
        let bare = read_surface_bytes(name, bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(bare.code(), "E104", "{name}");
    }
}

#[test]
fn a_surface_of_zygo_has_its_unit_spacing_and_missing_point() {
    for bytes in [NANOMETRES, FRINGES] {
        let found = read_surface_bytes("a.datx", bytes, &ReadOptions::default()).unwrap();
        assert_eq!(found.format, Format::ZygoDatx);
        compare(&found, |column, row| (column, row) == (2, 3));
        let [dx, dy] = [found.dx, found.dy].map(|spacing| spacing.unwrap().si());
        assert!((dx / 0.5e-6 - 1.0).abs() < 1e-12 && (dy / 2e-6 - 1.0).abs() < 1e-12);
    }
    let row = ReadOptions {
        line: TraceLine::Row,
        row: Some(5),
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.datx", NANOMETRES, &row).unwrap();
    assert_eq!(
        (reading.points, reading.spacing),
        (120, "0.5 um".parse().unwrap())
    );
}

#[test]
fn hdf5_without_heights_and_damaged_hdf5_is_refused() {
    let unknown = refused("a.datx", FURLONGS);
    assert_eq!(unknown.code(), "E117");
    assert!(unknown.to_string().contains("Furlongs"), "{unknown}");
    // The name decides what a file is; neither file holds the layout of the other.
    assert_eq!(refused("a.datx", OWN).code(), "E117");
    for (name, bytes) in [("a.h5", OWN), ("a.mat", MATLAB), ("a.datx", NANOMETRES)] {
        let whole = read_surface_bytes(name, bytes, &stated()).unwrap();
        let codes = (600..bytes.len()).step_by(97).map(|end| {
            match read_surface_bytes(name, &bytes[..end], &stated()) {
                // What is cut off are other arrays, or nothing that is used.
                Ok(found) => {
                    assert!(
                        found
                            .z
                            .iter()
                            .zip(&whole.z)
                            .all(|(a, b)| a.to_bits() == b.to_bits())
                    );
                    "read"
                }
                Err(error) => error.code().as_str(),
            }
        });
        let codes: Vec<&str> = codes.collect();
        assert!(
            codes
                .iter()
                .all(|code| ["read", "E117", "E320", "E321"].contains(code))
        );
        assert_eq!(codes[0], "E117");
    }
}

#[test]
fn a_workbook_before_2007_is_read_by_its_labels() {
    let reading = read_bytes("a.xls", WORKBOOK, &ReadOptions::default()).unwrap();
    assert_eq!(reading.format, Format::ExcelBinary);
    assert_eq!(
        (reading.points, reading.spacing),
        (200, "0.5 um".parse().unwrap())
    );
    assert_eq!(reading.z_unit, "um".parse().unwrap());
    for (i, z) in reading.profile.heights().iter().enumerate() {
        let exact = (0.1 * (i % 7) as f64 + 0.025 * (i % 3) as f64) * 1e-6;
        assert!((z - exact).abs() < 1e-15, "{i}: {z}");
    }
    let unread = vec!["Temperature".to_owned()];
    assert_eq!(
        reading.warnings,
        [Warning::ColumnsNotRead { columns: unread }]
    );
    // The second of two sheets at the place of the first.
    let records = |bytes: &[u8]| bytes.starts_with(&[0x85, 0, 15, 0]);
    let sheets: Vec<usize> = (0..WORKBOOK.len())
        .filter(|at| records(&WORKBOOK[*at..]))
        .collect();
    assert_eq!(sheets.len(), 2);
    let mut twice = WORKBOOK.to_vec();
    twice.copy_within(sheets[0] + 4..sheets[0] + 8, sheets[1] + 4);
    let refused = read_bytes("a.xls", &twice, &ReadOptions::default()).unwrap_err();
    assert!(refused.to_string().contains("the same place"), "{refused}");
    for end in (0..WORKBOOK.len()).step_by(501) {
        // The rest of a compound file is its directory; without it nothing is found.
        assert!(read_bytes("a.xls", &WORKBOOK[..end], &ReadOptions::default()).is_err());
    }
}
