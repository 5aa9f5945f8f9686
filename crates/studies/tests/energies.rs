//! Energies of a cycle from draws interpolated between nodes of a map, against draws at every point; quantiles of a sweep.

#![allow(clippy::unwrap_used, reason = "helpers of tests may panic")]

use asperity::pipeline::Kept;
use asperity_core::Estimate;
use std::path::Path;

use asperity::uncertainty::{Quantiles, predictive};
use asperity::{LoadedCase, Run};
use asperity_studies::compare::Finish;
use asperity_studies::cycle::{Cycle, CycleResult, cycle, evaluate};
use asperity_studies::map::{Axes, MapBand, map};
use asperity_studies::sweep::{Cases, Study};

/// Torque N m and speed 1/min of a cycle: part load, full load, slow and fast.
const POINTS: [[u32; 2]; 4] = [[30, 5000], [60, 3000], [145, 9000], [10, 9000]];

fn through(points: &[[u32; 2]]) -> Cycle {
    let mut text = "time_s,torque_nm,speed_rpm\n".to_owned();
    for (time, [torque, speed]) in points.iter().enumerate() {
        text.push_str(&format!("{time},{torque},{speed}\n"));
    }
    cycle(&text, None).unwrap()
}

fn ground(positions: usize, offsets: usize) -> LoadedCase {
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let case = asperity::case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(positions), Some(offsets));
    });
    case.unwrap()
}

/// Energies over a map whose axes hold every point of the cycle, so that the losses at the medians are exact.
fn energies(finishes: &[(&str, &LoadedCase)], points: &[[u32; 2]]) -> CycleResult {
    let finishes: Vec<Finish> = finishes
        .iter()
        .map(|(name, case)| Finish {
            name: (*name).to_owned(),
            case: (*case).clone(),
        })
        .collect();
    let of = |k: usize| {
        points
            .iter()
            .map(|point| f64::from(point[k]))
            .collect::<Vec<_>>()
    };
    let (torques, speeds) = (of(0), of(1));
    let axes = Axes::new(&torques, &speeds, &[90.0]).unwrap();
    let found = map(&finishes, &axes, MapBand::Nodes, &|_, _| {}).unwrap();
    if points == POINTS {
        let draws = &found.finishes[0].draws[0];
        assert_eq!(draws.torque_nm, [10.0, 30.0, 145.0]);
        assert_eq!(draws.speed_rpm, [3000.0, 5000.0, 9000.0]);
    }
    evaluate(&found.into(), 0, &through(points), "points", false).unwrap()
}

#[test]
fn quantiles_of_an_energy_from_nine_nodes_are_those_of_draws_at_every_point() {
    let case = ground(4, 8);
    let result = energies(&[("ground", &case)], &POINTS);
    let mut direct = Vec::new();
    for point in &through(&POINTS).points {
        let there = case.with(|input| {
            input.operation.torque = format!("{} N m", point.torque_nm).parse().unwrap();
            input.operation.speed = format!("{} 1/min", point.speed_rpm).parse().unwrap();
        });
        let there = there.unwrap();
        let tables = Run::new(&there).contacts().unwrap();
        let losses = Run::new(&there).known(&tables).losses().unwrap();
        let losses = losses.into_only().unwrap();
        let drawn = predictive(&there, &losses, tables.first())
            .unwrap()
            .unwrap();
        let draws = drawn.draws_of_sum_w(0, 0.75);
        direct.resize(draws.len(), 0.0);
        for (sum, loss) in direct.iter_mut().zip(draws) {
            *sum += loss * point.weight_s / 3600.0;
        }
    }
    let direct = Quantiles::from_draws(&direct);
    let finish = &result.finishes[0];
    let [low, high] = finish.lost_drawn_wh().unwrap().ends();
    let found = [low, finish.lost_drawn_wh().unwrap().value, high];
    let expected = [direct.drawn.low, direct.drawn.value, direct.drawn.high];
    println!("{found:?} {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 0.015, "{found} {expected}");
    }
    // At a node the quantiles are those of the node: 145 N m at 9000 1/min.
    let Estimate { value, low, high } = finish.drawn_w[2];
    assert!(low < value && value < high && finish.loss_w[2] > low);
}

#[test]
fn equal_finishes_differ_by_nothing_over_a_cycle() {
    let case = ground(3, 2);
    let smooth = case.with_key("surface.pinion.file", "../profiles/superfinished.csv");
    let finishes = [
        ("ground", &case),
        ("again", &case),
        ("smoother", &smooth.unwrap()),
    ];
    let result = energies(&finishes, &[[30, 5000], [60, 5000]]);
    let again = &result.finishes[1];
    assert_eq!(
        again.difference_drawn_wh(),
        Some(Estimate::new(0.0, [0.0; 2]))
    );
    let smoother = &result.finishes[2];
    let [low, high] = smoother.difference_drawn_wh().unwrap().ends();
    let median = smoother.difference_drawn_wh().unwrap().value;
    assert!(median < 0.0 && low < median && median < high);
}

#[test]
fn columns_of_a_sweep_hold_the_quantiles_of_runs() {
    let case = ground(3, 2);
    let loss = Run::new(&case)
        .pictures(Kept::NoPictures)
        .interval(true)
        .execute();
    let only = loss.unwrap().into_only().unwrap();
    let loss = only.result.uncertainty.unwrap().loss;
    let expected = [
        loss.drawn().value,
        loss.drawn().ends()[0],
        loss.drawn().ends()[1],
    ];
    for detail in ["losses", "contacts"] {
        let text = format!(
            r#"{{ "axis": [{{ "key": "operation.bulk_temperature", "values": ["90 °C", "60 °C"] }}], "detail": "{detail}",
            "columns": ["loss_w", "loss_p05_w", "loss_p95_w"] }}"#
        );
        let cases = Cases::new(Study::of_case(case.clone(), &text, ".".as_ref()).unwrap()).unwrap();
        let rows = cases.rows(0..2).unwrap();
        let numbers = |row: &[String]| {
            let of = |k: usize| row[k].parse::<f64>().unwrap();
            [of(3), of(4), of(5)]
        };
        assert_eq!(numbers(&rows[0]), expected, "{detail}");
        assert!(numbers(&rows[1]) != expected, "{detail}");
    }
}
