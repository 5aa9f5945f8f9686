//! Messages about files of instruments.

use crate::bench::{Bench, rows};

/// An SDF text that states `points` heights in `profiles` profiles and holds 500.
fn sdf(points: usize, profiles: usize) -> String {
    let heights = rows(500, |_, z| format!("{z:.4}"));
    format!(
        "aISO-1.0\nNumPoints = {points}\nNumProfiles = {profiles}\nXscale = 5E-07\nZscale = 1E-06\n*\n{heights}*\n"
    )
}

#[test]
fn damaged_overlarge_and_crowded_files_are_refused() {
    let bench = Bench::new();
    bench.write("cut.sdf", sdf(900, 1));
    let said = bench.run(&["profile", "info", "cut.sdf"]);
    said.refused(2, "E117", &["cut.sdf: not a sound SDF", "500 of 900"]);
    bench.write("two.sdf", sdf(250, 2));
    let said = bench.run(&["profile", "info", "two.sdf"]);
    said.refused(2, "E119", &["two.sdf: the file holds 2 profiles", "--row"]);
    let second = bench.run(&["profile", "info", "two.sdf", "--row", "2", "--level"]);
    assert_eq!(second.status, 0, "{second:?}");
    // A file with a hole in it takes no room on the disk.
    bench.write("huge.csv", "x_um,z_um\n");
    let huge = std::fs::File::options()
        .write(true)
        .open(bench.path("huge.csv"))
        .unwrap();
    huge.set_len(5 << 30).unwrap();
    let said = bench.run(&["profile", "info", "huge.csv"]);
    said.refused(2, "E118", &["huge.csv: the file has 5368709120 bytes"]);
}

#[test]
fn what_an_instrument_leaves_in_doubt_is_noted() {
    let bench = Bench::new();
    let heights = rows(500, |_, z| format!("{z:.4}"));
    let noted = |name: &str, code: &str| {
        let said = bench.run(&["profile", "info", name, "--level"]);
        assert!(said.out.contains(code), "{name}: {said:?}");
    };
    let smd = "ISO 5436 - 2000 a\nPRF 1 ISO5436\nCX I 500 mm 1.0e0 D 5.0e-4\nCZ A 500 um 1.0e0 D\n\u{3}\n\u{3}\n";
    bench.write("a.smd", format!("{smd}{heights}\u{3}\n1\n\u{3}\n"));
    noted("a.smd", "W120");
    bench.write("npl.txt", format!("0.5\n{heights}"));
    noted("npl.txt", "W122");
    bench.write("a.tx1", format!("1.00000\n500\n{heights}"));
    bench.write("a.tx3", "Evaluation length\t0.2500000mm\n");
    noted("a.tx1", "W121");
    bench.write("b.tx1", format!("0.25000\n500\n{heights}"));
    bench.write("b.tx3", "Evaluation length\t0.25mm\n");
    noted("b.tx1", "W123");
}
