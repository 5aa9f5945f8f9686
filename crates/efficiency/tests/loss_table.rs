//! Loss torque from a user's table, over torque, speed and temperature.

use asperity_core::{Code, Fault};
use asperity_efficiency::loss_table::{LossRow, LossTable};

fn row(torque: f64, speed: f64, temperature: f64, loss: f64) -> LossRow {
    LossRow {
        torque_nm: Some(torque),
        speed_rpm: speed,
        temperature_c: Some(temperature),
        loss_torque_nm: loss,
    }
}

/// 1 + torque/10 + speed/1000 + temperature/100, which no linear interpolation bends.
fn linear() -> Vec<LossRow> {
    let mut rows = Vec::new();
    for temperature in [90.0, 40.0, 60.0] {
        for torque in [-20.0, 0.0, 50.0] {
            for speed in [3000.0, 0.0] {
                let loss = 5.0 + torque / 10.0 + speed / 1000.0 + temperature / 100.0;
                rows.push(row(torque, speed, temperature, loss));
            }
        }
    }
    rows
}

#[test]
fn a_linear_table_is_met_at_its_nodes_and_between_them() {
    let table = LossTable::new(&linear()).unwrap();
    for (torque, speed, temperature) in [
        (-20.0, 0.0, 40.0),
        (50.0, 3000.0, 90.0),
        (12.5, -750.0, 77.0),
        (-3.0, 2999.0, 41.0),
    ] {
        let expected = 5.0 + torque / 10.0 + f64::abs(speed) / 1000.0 + temperature / 100.0;
        let found = table.loss_torque(torque, speed, temperature).unwrap();
        assert!((found - expected).abs() < 1e-13, "{torque} {speed} {found}");
    }
}

#[test]
fn rows_of_a_speed_may_have_torques_of_their_own() {
    let row = |torque, speed, loss| LossRow {
        temperature_c: None,
        ..row(torque, speed, 0.0, loss)
    };
    // As in a loss map of VECTO: a kink at another torque for each speed, and a row twice.
    let rows = [
        row(-100.0, 0.0, 10.0),
        row(-20.0, 0.0, 2.0),
        row(100.0, 0.0, 14.0),
        row(-100.0, 50.0, 12.0),
        row(40.0, 50.0, 5.0),
        row(100.0, 50.0, 11.0),
        row(100.0, 50.0, 11.0),
    ];
    let table = LossTable::new(&rows).unwrap();
    for (torque, speed, expected) in [
        (-60.0, 0.0, 6.0),
        (40.0, 0.0, 8.0),
        (-20.0, 50.0, 8.0),
        (70.0, 50.0, 8.0),
        (40.0, 25.0, 6.5),
    ] {
        let found = table.loss_torque(torque, speed, 90.0).unwrap();
        assert!((found - expected).abs() < 1e-12, "{torque} {speed} {found}");
    }
}

#[test]
fn nothing_is_told_beyond_the_nodes_of_any_axis() {
    let table = LossTable::new(&linear()).unwrap();
    for (torque, speed, temperature) in [
        (50.1, 0.0, 60.0),
        (-20.1, 0.0, 60.0),
        (0.0, 3000.1, 60.0),
        (0.0, 0.0, 39.9),
        (0.0, 0.0, 90.1),
        (f64::NAN, 0.0, 60.0),
    ] {
        let error = table.loss_torque(torque, speed, temperature).unwrap_err();
        assert_eq!(Fault::from(error).code(), Code::E313);
    }
}

#[test]
fn rows_that_are_no_grid_and_losses_that_are_none_are_refused() {
    let mut holed = linear();
    holed.pop();
    let mut double = linear();
    double.push(LossRow {
        loss_torque_nm: 9.0,
        ..double[0]
    });
    let mut mixed = linear();
    mixed[0].temperature_c = None;
    let mut without_torque = linear();
    without_torque[0].torque_nm = None;
    let error = LossTable::new(&holed).unwrap_err();
    let expected = "no row at 50 N m, 0 1/min, where rows at other speeds have this torque";
    assert!(error.to_string().starts_with(expected), "{error}");
    for rows in [double, mixed, without_torque, Vec::new()] {
        let error = LossTable::new(&rows).unwrap_err();
        let error = Fault::from(error);
        assert_eq!(error.code(), Code::E138);
        assert!(error.message().contains("do not form a grid"), "{error}");
    }
    for loss in [-0.1, f64::NAN, f64::INFINITY] {
        let mut rows = linear();
        rows[3].loss_torque_nm = loss;
        let error = LossTable::new(&rows).unwrap_err();
        let error = Fault::from(error);
        assert_eq!(error.code(), Code::E138);
        assert!(
            error.message().starts_with("loss_torque_nm, or loss_w"),
            "{error}"
        );
    }
    let mut rows = linear();
    rows[3].speed_rpm = f64::NAN;
    assert!(LossTable::new(&rows).is_err());
}
