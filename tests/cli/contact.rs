//! The contact alone: the stress below it.

use std::f64::consts::PI;

use serde_json::Value;

use crate::bench::{Bench, E_DRIVE};

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn the_stress_below_smooth_flanks_is_that_of_hertz() {
    let bench = Bench::new();
    let rows: String = (0..6000)
        .map(|i| format!("{:.1},0\n", 0.5 * f64::from(i)))
        .collect();
    for name in ["pinion.csv", "wheel.csv"] {
        bench.write(name, format!("x_um,z_um\n{rows}"));
    }
    bench.write("case.toml", E_DRIVE);
    let options = [
        "contact",
        "case.toml",
        "--stress",
        "stress.csv",
        "--elastic-limit",
        "300 MPa",
    ];
    let run = |more: &[&str]| bench.run(&[&options[..], more].concat());
    let found = run(&["--json"]).well().json();
    let p0 = number(&found["hertz_p_max_pa"]);
    let b = 2.0 * number(&found["load_n_per_m"]) / (PI * p0);
    let stress = &found["stress"];
    let (shear, mises) = (&stress["shear_max"], &stress["von_mises_max"]);
    // Johnson 1985: 0.30028 p0 at 0.786 b; von Mises 0.5575 p0. The depths are 5 % apart.
    assert!((number(&shear["value_pa"]) / (0.30028 * p0) - 1.0).abs() < 2e-3);
    assert!((number(&shear["z_m"]) / (0.786 * b) - 1.0).abs() < 0.1);
    assert!((number(&mises["value_pa"]) / (0.5575 * p0) - 1.0).abs() < 2e-3);
    let zone = &stress["yield_zone"];
    assert!(number(&zone["shallowest_m"]) < 0.786 * b && number(&zone["deepest_m"]) > 0.786 * b);
    let file = std::fs::read_to_string(bench.path("stress.csv")).unwrap();
    let lines: Vec<&str> = file.lines().collect();
    assert_eq!(
        lines[0],
        "x_m,z_m,sigma_xx_pa,sigma_zz_pa,tau_xz_pa,von_mises_pa"
    );
    let points = found["points"].as_u64().unwrap() as usize;
    assert_eq!((lines.len() - 1) % points, 0);
    // Sliding brings the largest shear nearer to the surface, and makes it larger.
    let sliding = &run(&["--friction", "0.3", "--json"]).well().json()["stress"]["shear_max"];
    assert!(number(&sliding["value_pa"]) > 1.05 * number(&shear["value_pa"]));
    assert!(number(&sliding["z_m"]) < number(&shear["z_m"]));
    let said = run(&[]).well().out;
    assert!(
        said.contains("Largest von Mises stress") && said.contains("Elastic limit exceeded from")
    );
    run(&["--poisson", "0.7"]).refused(2, "E209", &["Poisson"]);
}
