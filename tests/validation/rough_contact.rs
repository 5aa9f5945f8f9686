//! Two traces pressed together by the orchestrator, against Hertz.

use asperity::contacts::dry_contact::{DryContact, dry_contact};
use asperity_tests::{table_2, trace_csv};

use crate::comparison::{Comparison, Table};

/// Table 2 dry at A, between flanks measured as perfectly smooth, 1 µm apart.
fn smooth_contact() -> DryContact {
    let folder = tempfile::tempdir().unwrap();
    let zeros = vec![0.0; 4001];
    std::fs::write(folder.path().join("flat.csv"), trace_csv(0.5e-6, &zeros)).unwrap();
    let case = table_2()
        .with("material.pinion.flow_pressure", "7 GPa")
        .with("surface.cutoff", "0 mm")
        .with("surface.noise_cutoff", "0 um")
        .with("surface.pinion", toml::toml! { file = "flat.csv" })
        .with("surface.wheel", toml::toml! { file = "flat.csv" });
    dry_contact(&case.load_in(folder.path()), 0.0).unwrap()
}

pub fn smooth_flanks() -> Table {
    let dry = smooth_contact();
    let dx = dry.x[1] - dry.x[0];
    let p_max = dry.solution.pressure.iter().copied().fold(0.0, f64::max);
    let touching = dry.solution.pressure.iter().filter(|p| **p > 0.0).count();
    Table {
        name: "smooth-flanks",
        test: "smooth_traces_meet_in_a_hertz_contact",
        rows: vec![
            // 222 points to a half width; the pressure falls off beside the middle by (dx/a)²/2.
            Comparison::new("largest pressure", "MPa", 649.260_67, p_max * 1e-6, 1e-3),
            // A point more or less at each edge.
            Comparison::new(
                "half width",
                "µm",
                111.200_93,
                0.5 * touching as f64 * dx * 1e6,
                dx / 111.200_93e-6,
            ),
            Comparison::new(
                "load",
                "N/mm",
                113.408_97,
                dry.solution.load.si() * 1e-3,
                1e-6,
            ),
        ],
    }
}

#[test]
fn smooth_traces_meet_in_a_hertz_contact() {
    smooth_flanks().hold();
    // Point by point, away from the edge where Hertz's slope is infinite.
    let dry = smooth_contact();
    let (a, p0) = (dry.hertz.half_width.si(), dry.hertz.max_pressure.si());
    for (x, p) in dry.x.iter().zip(&dry.solution.pressure) {
        let inside = 1.0 - (x / a).powi(2);
        if inside > 0.05 {
            assert!((p / p0 - inside.sqrt()).abs() < 1e-3, "{p} at {x}");
        }
        if inside < -0.05 {
            assert_eq!(*p, 0.0, "at {x}");
        }
    }
}
