//! Properties of every format, hostile files included.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_profile_io::read::{Metadata, ReadOptions, TraceLine, read_bytes, read_surface_bytes};
use asperity_profile_io::write::{WrittenFormat, write};
use proptest::prelude::*;

use super::areal_files;
use super::samples::*;

#[test]
fn hostile_archives_and_counts_are_refused() {
    let refused = |name: &str, bytes: &[u8]| {
        read_bytes(name, bytes, &ReadOptions::default())
            .unwrap_err()
            .code()
    };
    // A hundred million zeros pack to some hundred kilobytes.
    let bomb = zip(&[("main.xml", &vec![b' '; 100_000_000])]);
    assert!(bomb.len() < 300_000);
    assert_eq!(refused("a.x3p", &bomb), "E118");
    let data = [0_u8; 8 * POINTS];
    let xml = main_xml(true, "PRF", "D", 1.0, 1, &link(&data, ""));
    for size in ["18446744073709551615", "99999999999", "0", "-1"] {
        let xml = xml.replace(&format!("<SizeX>{POINTS}"), &format!("<SizeX>{size}"));
        let code = refused(
            "a.x3p",
            &zip(&[("main.xml", xml.as_bytes()), ("bindata/data.bin", &data)]),
        );
        assert!(["E117", "E118"].contains(&code.as_str()), "{size} {code}");
    }
    let deep = "<a>".repeat(100_000);
    assert_eq!(
        refused("a.x3p", &zip(&[("main.xml", deep.as_bytes())])),
        "E117"
    );
    assert_eq!(refused("a.x3p", b"PK\x03\x04 and no more"), "E117");
    let many = sdf(1).replace(
        &format!("NumPoints   = {POINTS}"),
        "NumPoints   = 18446744073709551615",
    );
    assert_eq!(refused("a.sdf", many.as_bytes()), "E117");
    let many = smd_with_blanks().replace(&format!("CZ A {POINTS}"), "CZ A 1e300");
    assert_eq!(refused("a.smd", many.as_bytes()), "E117");
    let far = sig().replace("SPACING_UM: 0.50000", "SPACING_UM: 1e300");
    assert_eq!(refused("a.sig", far.as_bytes()), "E116");
}

#[test]
#[ignore = "writes the seeds of the fuzz targets into the source tree"]
fn write_seeds() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds");
    let csv = rows(|z| format!("{z:.4}\n"));
    let numbered = csv.lines().enumerate();
    let csv: String = numbered
        .map(|(i, z)| format!("{:.1};{z}\n", 0.5 * i as f64))
        .collect();
    let mut all = vec![
        ("delimited", format!("x [um];z [um]\n{csv}").into_bytes()),
        ("workbook", workbook()),
    ];
    let targets = [
        "x3p",
        "smd",
        "smd",
        "sigmasurf",
        "sdf",
        "mahr",
        "taylor_hobson",
        "ptb",
        "surfcom",
        "npl_xml",
        "workbook",
        "workbook",
    ];
    all.extend(
        targets
            .into_iter()
            .zip(seeds().into_iter().map(|(_, bytes)| bytes)),
    );
    let areal = [
        "sur",
        "sur",
        "al3d",
        "vk",
        "vk",
        "plu",
        "plux",
        "metropro",
        "zygo_text",
        "zygo_text",
        "wyko_text",
        "opd",
        "sdf_binary",
        "sdf_binary",
        "opdx",
        "mat",
        "nid",
        "ibw",
        "gwy",
        "gsf",
    ];
    let areal = areal.into_iter().zip(areal_files::all());
    all.extend(areal.map(|(target, (_, bytes))| (target, bytes)));
    all.push(("codev", areal_files::code_v()));
    for (at, (target, bytes)) in all.into_iter().enumerate() {
        std::fs::create_dir_all(folder.join(target)).unwrap();
        std::fs::write(folder.join(target).join(format!("{at:02}")), bytes).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_is_written_reads_back_to_the_last_bit_or_the_one_before(
        heights in prop::collection::vec(-1e-4..1e-4_f64, 100..200),
        dx in 1e-8..1e-5_f64,
    ) {
        let profile = Profile::new(Length::from_si(dx), heights).unwrap();
        let metadata = Metadata { title: Some("a <b> & \"c\"".into()), date: Some("2026-11-20".into()), ..Metadata::default() };
        for (name, format) in [("a.csv", WrittenFormat::Csv), ("a.x3p", WrittenFormat::X3p), ("a.smd", WrittenFormat::Smd)] {
            let bytes = write(&profile, &metadata, format).unwrap();
            let reading = read_bytes(name, &bytes, &ReadOptions::default()).unwrap();
            // Micrometres of text reach 19 of 20 numbers of metres, and the one before of the others.
            let most = if format == WrittenFormat::Csv { f64::EPSILON } else { 0.0 };
            let both = reading.profile.heights().iter().zip(profile.heights());
            prop_assert!(both.into_iter().all(|(again, z)| (again - z).abs() <= most * z.abs()));
            prop_assert_eq!((reading.points, reading.profile.spacing()), (profile.len(), profile.spacing()));
            prop_assert_eq!(reading.metadata.date.as_deref(), Some("2026-11-20"));
            // White noise of 0.1 mm is as steep as no flank.
            let others = reading.warnings.iter().filter(|warning| warning.code() != "W124");
            prop_assert!(others.count() == 0, "{:?}", reading.warnings);
        }
    }

    #[test]
    fn a_damaged_instrument_file_is_read_or_refused(
        seed in 0..12_usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 1..12),
    ) {
        let (name, mut bytes) = seeds().swap_remove(seed);
        for (at, byte, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => bytes.truncate(at.max(bytes.len() / 2)),
            }
        }
        match read_bytes(name, &bytes, &ReadOptions::default()) {
            Ok(reading) => {
                prop_assert!(reading.points >= 100);
                prop_assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
            }
            Err(error) => prop_assert!(error.to_string().starts_with(name)),
        }
    }

    #[test]
    fn a_damaged_surface_is_read_or_refused(
        seed in 0..16_usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4_u8), 1..12),
    ) {
        let (name, mut bytes) = areal_files::all().swap_remove(seed);
        for (at, byte, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                // Most of a file is heights; its header is what can mislead.
                1 => {
                    let head = at % bytes.len().min(600);
                    bytes[head] = byte;
                }
                2 => bytes.insert(at, byte),
                _ => bytes.truncate(at.max(bytes.len() / 2)),
            }
        }
        let options = ReadOptions { z_unit: "um".parse().ok(), ..ReadOptions::default() };
        match read_surface_bytes(name, &bytes, &options) {
            Ok(surface) => {
                prop_assert_eq!(surface.z.len(), surface.columns * surface.rows);
                prop_assert!(surface.z.iter().zip(&surface.mask).all(|(z, known)| z.is_finite() == *known));
            }
            Err(error) => prop_assert!(error.to_string().starts_with(name)),
        }
        let mean = ReadOptions { line: TraceLine::Mean, dx: "0.5 um".parse().ok(), ..options };
        match read_bytes(name, &bytes, &mean) {
            Ok(reading) => prop_assert!(reading.profile.heights().iter().all(|z| z.is_finite())),
            Err(error) => prop_assert!(error.to_string().starts_with(name)),
        }
    }
}
