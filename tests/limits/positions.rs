//! Many positions, few positions, one position.

use asperity::case::Alternative;
use asperity::core::task::on_threads;
use asperity::mixed_film::SpotSpeed;
use asperity::result::Summary;
use asperity_tests::{assert_close, constant, table_2};

fn with(positions: i64) -> Summary {
    table_2()
        .with("model.positions", positions)
        .run()
        .result
        .summary
}

#[test]
fn the_losses_have_converged_to_the_promised_digits_with_sixteen_cells() {
    let fine = with(512);
    // One contact in each cell, where the power is: the error falls with the square of the width.
    for (positions, tolerance) in [(8, 5e-3), (16, 1.5e-3), (32, 5e-4), (64, 2e-4)] {
        let coarse = with(positions);
        assert_close("sliding", coarse.sliding_w, fine.sliding_w, tolerance);
        assert_close("rolling", coarse.rolling_w, fine.rolling_w, tolerance);
    }
}

#[test]
fn a_position_a_segment_is_enough_for_what_does_not_change_along_the_path() {
    let coarse = table_2().with("model.positions", 2).run().result;
    let length: f64 = coarse.path.iter().map(|row| row.weight_m).sum();
    assert_close("contact length", length, 82.286_440e-3, 1e-8);
    // The sliding power of a cell is that of all its points when friction is constant.
    let constant = |positions: i64| {
        table_2()
            .with("model.film_friction", constant(0.05))
            .with("model.positions", positions)
            .run()
            .result
            .summary
            .sliding_w
    };
    assert_close("sliding", constant(2), constant(64), 1e-12);
}

#[test]
fn the_number_of_threads_does_not_change_a_digit() {
    let loaded = table_2().load();
    let on = |threads: usize| {
        let outcome = on_threads(threads, || asperity_tests::run(&loaded)).unwrap();
        serde_json::to_string(&outcome.result).unwrap()
    };
    assert_eq!(on(1), on(4));
}

#[test]
fn the_points_of_the_path_are_solved_as_its_positions_are() {
    let file = "../fixtures/cases/e-drive.toml".as_ref();
    let by = |speed: SpotSpeed| {
        let loaded = asperity::case::load_with(file, &|input| {
            (input.model.positions, input.model.offsets) = (Some(24), Some(2));
        });
        let spots = Some(Alternative::SpotSpeed(speed));
        let loaded = loaded.unwrap().overridden(|over| over.alternative = spots);
        asperity_tests::run(&loaded.unwrap()).result
    };
    let [carried, entrainment] = [SpotSpeed::Carried, SpotSpeed::Entrainment].map(by);
    for (result, is_carried) in [(&carried, true), (&entrainment, false)] {
        let names: Vec<&str> = result.points.iter().map(|point| &*point.point).collect();
        assert_eq!(names, ["A", "B", "C", "D", "E"]);
        for point in &result.points {
            let (name, row) = (&point.point, &point.row);
            assert!(row.mean_gap_um.is_some(), "{name} has no solved contact");
            if *name == "C" && is_carried {
                // Nothing slides at the pitch point, and all spots keep the film of the inlet.
                let other = entrainment.points.iter().find(|other| other.point == *name);
                let off = row.boundary_share / other.unwrap().row.boundary_share - 1.0;
                assert!(off.abs() < 1e-6, "{off}");
                continue;
            }
            let distance = |other: &&asperity::result::PositionRow| (other.s_mm - row.s_mm).abs();
            let mut near: Vec<_> = result.path.iter().collect();
            near.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
            let shares = near[..2].iter().map(|other| other.boundary_share);
            let (low, high) = (
                shares.clone().fold(1.0, f64::min),
                shares.fold(0.0, f64::max),
            );
            // Two offsets scatter by a quarter between neighbouring positions.
            let within = 0.7 * low..1.3 * high;
            assert!(
                within.contains(&row.boundary_share),
                "{name}: {} beside {within:?}",
                row.boundary_share
            );
        }
    }
}
