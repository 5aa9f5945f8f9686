//! Table 2 of the 2022 paper against an independent evaluation of the same equations, in Python with
//! double precision: geometry, speeds, contact, films, friction, losses.

use asperity::case::Case;
use asperity::lubrication::formula_film;
use asperity::mesh::position_at;
use asperity::result::PositionRow;
use asperity_core::quantity::Length;
use asperity_gear::LoadSharing;
use asperity_tests::{CaseText, table_2};

use crate::comparison::{Comparison, Table};

/// Reference numbers are given to six digits.
const SIX_DIGITS: f64 = 1e-6;

pub fn geometry() -> Table {
    let result = table_2().run().result;
    let (gears, summary) = (&result.gears, &result.summary);
    let path = gears.path();
    let forces = gears.forces("285 N m".parse().unwrap()).unwrap();
    let row = |quantity: &str, unit, expected, actual| {
        Comparison::new(quantity, unit, expected, actual, SIX_DIGITS)
    };
    let averaged = gears.loss_factors(&LoadSharing::Uniform).unwrap();
    Table {
        name: "table-2-geometry",
        test: "the_reference_case_has_its_geometry_from_the_case_file_on",
        rows: vec![
            row("d₁", "mm", 75.055_535, gears.reference_radius[0].si() * 2e3),
            row(
                "d₂",
                "mm",
                180.133_284,
                gears.reference_radius[1].si() * 2e3,
            ),
            row("a", "mm", 127.594_409, gears.centre_distance.si() * 1e3),
            row("ε_α", "-", 1.452_764, path.eps_alpha),
            row("ε_β", "-", 6.121_344, path.eps_beta),
            row("P_in", "W", 89_535.391, summary.power_in_w),
            row("F_bn", "N", 9_332.020_5, forces.normal_base.si()),
            row(
                "l, mean length of the contact lines",
                "mm",
                82.286_44,
                result.path.iter().map(|row| row.weight_m * 1e3).sum(),
            ),
            row("f", "N/mm", 113.408_97, result.path[0].line_load_n_per_mm),
            row(
                "H_V, Ohlendorf",
                "-",
                0.060_808_148,
                summary.loss_factor_ohlendorf,
            ),
            row(
                "H_V, local, at the mean contact length",
                "-",
                0.073_282_754,
                summary.loss_factor_local,
            ),
            // Averaged over 400 phases there, by Gauss points here.
            Comparison::new(
                "H_V, local, at the contact length of each instant",
                "-",
                0.073_278_72,
                averaged.local_phase_averaged,
                1e-5,
            ),
        ],
    }
}

#[test]
fn the_reference_case_has_its_geometry_from_the_case_file_on() {
    geometry().hold();
}

/// At A, C and E: R mm, V_s m/s, V_e m/s, SRR, a_H µm, p₀ MPa.
#[rustfmt::skip]
const POINTS: [(&str, [f64; 6]); 3] = [
    ("A", [9.881_144, -1.437_544, 4.271_944, -0.336_508_1, 111.200_9, 649.260_7]),
    ("C", [11.626_876, 0.0, 4.567_909, 0.0, 120.624_7, 598.537_3]),
    ("E", [12.848_112, 1.373_417, 4.850_671, 0.283_139_7, 126.801_5, 569.381_1]),
];

/// The places of [`POINTS`].
fn places(case: &Case) -> [Length; 3] {
    let path = case.gears.path();
    [path.a, path.c, path.e]
}

pub fn points() -> Table {
    let case = table_2().load().case.clone();
    let mut rows = Vec::new();
    for ((name, expected), s) in POINTS.into_iter().zip(places(&case)) {
        let station = position_at(&case, s).unwrap();
        let motion = station.motion;
        let actual = [
            ("R", "mm", motion.radius.si() * 1e3),
            ("V_s", "m/s", motion.sliding.si()),
            ("V_e", "m/s", motion.entrainment.si()),
            ("SRR", "-", motion.slide_to_roll),
            ("a_H", "µm", station.hertz.half_width.si() * 1e6),
            ("p₀", "MPa", station.hertz.max_pressure.si() * 1e-6),
        ];
        for ((quantity, unit, actual), expected) in actual.into_iter().zip(expected) {
            if expected == 0.0 {
                assert!(actual.abs() < 1e-12, "{quantity} at {name} is {actual}");
                continue;
            }
            let name = format!("{quantity} at {name}");
            rows.push(Comparison::new(name, unit, expected, actual, SIX_DIGITS));
        }
    }
    Table {
        name: "table-2-points",
        test: "the_reference_case_moves_and_presses_as_computed_elsewhere",
        rows,
    }
}

#[test]
fn the_reference_case_moves_and_presses_as_computed_elsewhere() {
    points().hold();
}

/// Central and minimum film at C in µm, without thermal reduction.
const FILMS: [(&str, &str, f64, Option<f64>); 4] = [
    ("dowson-toyoda", "Dowson-Toyoda", 1.960_632, Some(1.549_020)),
    ("moes", "Moes", 1.952_143, None),
    ("ertel-grubin", "Ertel-Grubin", 2.019_964, None),
    (
        "hamrock-dowson",
        "Hamrock-Dowson, k → ∞, W = F/(E′R²)",
        1.365_565_19,
        Some(1.105_457_87),
    ),
];

/// φ after Gupta at A, C and E.
const REDUCTIONS: [f64; 3] = [0.751_983_8, 0.832_604_2, 0.735_662_1];

pub fn films() -> Table {
    let mut rows = Vec::new();
    let mut push = |quantity, unit, expected, actual| {
        let row = Comparison::new(quantity, unit, expected, actual, SIX_DIGITS);
        rows.push(row);
    };
    for (law, name, central, minimum) in FILMS {
        let case = table_2()
            .with("model.film", law)
            .with("model.thermal", "none");
        let case = case.load().at_stated().unwrap();
        let station = position_at(&case, case.gears.path().c).unwrap();
        let film = formula_film(&case, &station).unwrap().film;
        let quantity = format!("central film at C, {name}");
        push(quantity, "µm", central, film.central.si() * 1e6);
        if let Some(minimum) = minimum {
            let quantity = format!("minimum film at C, {name}");
            push(quantity, "µm", minimum, film.minimum.si() * 1e6);
        }
    }
    let case = table_2().load().at_stated().unwrap();
    for (((name, _), s), expected) in POINTS.into_iter().zip(places(&case)).zip(REDUCTIONS) {
        let position = position_at(&case, s).unwrap();
        let reduction = formula_film(&case, &position).unwrap().thermal_reduction;
        let quantity = format!("thermal reduction φ at {name}, Gupta");
        push(quantity, "-", expected, reduction);
    }
    Table {
        name: "table-2-films",
        test: "the_reference_case_has_its_films_from_the_case_file_on",
        rows,
    }
}

#[test]
fn the_reference_case_has_its_films_from_the_case_file_on() {
    films().hold();
}

/// Digits of the numbers compared with.
const NEXT_TO: f64 = 2e-5;

/// The rows at A, C and E.
fn rows_at_points(case: CaseText) -> [PositionRow; 3] {
    let points = case.run().result.points;
    ["A", "C", "E"].map(|name| {
        let mut rows = points.iter();
        rows.find(|row| row.point == name).unwrap().row.clone()
    })
}

pub fn friction() -> Table {
    let [a, _, e] = rows_at_points(table_2());
    let [_, c, _] = rows_at_points(table_2().with("model.thermal", "none"));
    let rolling = c.rolling_w_per_m / (2.0 * c.entrainment_m_per_s);
    let by = |law: &str| {
        let ra = |case: CaseText, flank| case.with(&format!("surface.{flank}.ra"), "0.25 um");
        rows_at_points(ra(ra(table_2(), "pinion"), "wheel").with("model.film_friction", law))
    };
    let [at_a, _, at_e] = by("benedict-kelley");
    let [mesh, _, _] = by("iso-14179-2");
    let rows = [
        ("μ at A, Xu, S 0.424 µm", "-", 0.062_703_68, a.mu_film),
        ("μ at E, Xu", "-", 0.052_903_71, e.mu_film),
        ("flash temperature at A", "K", 14.431_53, a.flash_k),
        ("flash temperature at E", "K", 10.212_54, e.flash_k),
        (
            "μ at A, Benedict-Kelley, Ra 0.25 µm",
            "-",
            0.041_054_74,
            at_a.mu_film,
        ),
        ("μ at E, Benedict-Kelley", "-", 0.039_578_31, at_e.mu_film),
        (
            "μ, ISO/TR 14179-2, Ra 0.25 µm, X_L 1",
            "-",
            0.029_471_51,
            mesh.mu_film,
        ),
        (
            "F_r at C, isothermal, one surface",
            "N/m",
            209.153_7,
            rolling,
        ),
    ];
    let rows = rows.into_iter();
    let row = |(quantity, unit, expected, actual): (&str, _, _, _)| {
        Comparison::new(quantity, unit, expected, actual, NEXT_TO)
    };
    Table {
        name: "table-2-friction",
        test: "the_reference_case_rubs_and_heats_as_computed_elsewhere",
        rows: rows.map(row).collect(),
    }
}

#[test]
fn the_reference_case_rubs_and_heats_as_computed_elsewhere() {
    friction().hold();
}

/// S_pk 0.3 µm on both flanks together, ridges of 0.1 mm radius, films as in the paper.
pub fn film_parameter() -> Table {
    let case = table_2()
        .with("surface.pinion.rpk", "0.21213203 um")
        .with("surface.wheel.rpk", "0.21213203 um")
        .with("surface.pinion.asperity_radius", "141.42136 um")
        .with("surface.wheel.asperity_radius", "141.42136 um")
        .with("model.film", "hamrock-dowson")
        .with("model.thermal", "none");
    let expected = [3.742_708, 4.185_835, 4.542_895];
    let points = POINTS.into_iter().zip(rows_at_points(case)).zip(expected);
    let row = |(((name, _), row), expected): (((&str, _), PositionRow), f64)| {
        let quantity = format!("Λ\\* at {name}");
        Comparison::new(quantity, "-", expected, row.lambda_star.unwrap(), NEXT_TO)
    };
    Table {
        name: "table-2-film-parameter",
        test: "the_reference_case_has_its_film_parameter_from_the_case_file_on",
        rows: points.map(row).collect(),
    }
}

#[test]
fn the_reference_case_has_its_film_parameter_from_the_case_file_on() {
    film_parameter().hold();
}
