//! Efficiency as drawn: closer than the points of the map next to no torque and to standstill, where it changes steeply while
//! the loss torque hardly does.

use asperity_report::chart::Contour;
use serde::Serialize;

use super::evaluation::computed_speed;
use super::point::{FinishMap, Map};

/// Largest part of the torques that stays without an efficiency at either side of no torque.
const BLANK: f64 = 1e-3;

/// Row of `efficiency.csv`.
#[derive(Debug, Serialize)]
pub(super) struct DrawnRow<'a> {
    finish: &'a str,
    temperature_c: f64,
    torque_nm: f64,
    speed_rpm: f64,
    efficiency: Option<f64>,
}

/// Rows of the efficiency in percent that `field` draws of `finish`.
pub(super) fn rows<'a>(
    map: &'a Map,
    finish: &'a FinishMap,
    temperature: usize,
    field: &Contour,
) -> Vec<DrawnRow<'a>> {
    let nodes = || {
        let speeds = field.rows.iter().copied();
        speeds.flat_map(|speed| field.columns.iter().map(move |torque| (*torque, speed)))
    };
    let row = |((torque_nm, speed_rpm), percent): ((f64, f64), &f64)| DrawnRow {
        finish: &finish.name,
        temperature_c: map.axes.temperature_c[temperature],
        torque_nm,
        speed_rpm,
        efficiency: Some(0.01 * percent).filter(|value| value.is_finite()),
    };
    nodes().zip(&field.values).map(row).collect()
}

/// The efficiency in percent at closer torques between no torque and its neighbours, and at the speed that represents
/// standstill. Between the points of the map it follows the interpolated loss torque. `field` itself if a point has no result.
pub(super) fn closer(map: &Map, finish: &FinishMap, temperature: usize, field: Contour) -> Contour {
    let Some(surface) = finish.surface(&map.axes, temperature) else {
        return field;
    };
    let columns = closer_torques(&field.columns);
    let mut rows = field.rows.clone();
    if let [0.0, next, ..] = rows[..]
        && next > computed_speed(0.0)
    {
        rows.insert(1, computed_speed(0.0));
    }
    // The point of the map at a torque and speed, or else its neighbour at no torque or at rest.
    let place = |nodes: &[f64], at: f64| match nodes.iter().position(|node| *node == at) {
        Some(place) => (place, true),
        None => (
            nodes.iter().position(|node| *node == 0.0).unwrap_or(0),
            false,
        ),
    };
    let mut values = Vec::with_capacity(columns.len() * rows.len());
    let mut hatched = Vec::with_capacity(field.hatched.len());
    for &speed in &rows {
        let (row, is_speed) = place(&field.rows, speed);
        for &torque in &columns {
            let (column, is_torque) = place(&field.columns, torque);
            let at = row * field.columns.len() + column;
            values.push(if is_speed && is_torque {
                field.values[at]
            } else {
                efficiency(torque, surface.loss_torque(torque, speed).value)
                    .map_or(f64::NAN, |efficiency| 100.0 * efficiency)
            });
            hatched.extend(field.hatched.get(at));
        }
    }
    Contour {
        columns,
        rows,
        values,
        hatched,
        ..field
    }
}

/// The torques, with halves of the smallest of each sign down to a thousandth of all if no torque is among them.
fn closer_torques(torques: &[f64]) -> Vec<f64> {
    let [Some(&low), Some(&high)] = [torques.first(), torques.last()] else {
        return Vec::new();
    };
    let least = BLANK * (high - low);
    let halves = |from: &f64| {
        let from = *from;
        (1..)
            .map(move |k| from * 0.5f64.powi(k))
            .take_while(move |torque| torque.abs() >= least)
    };
    let Some(zero) = torques.iter().position(|torque| *torque == 0.0) else {
        return torques.to_vec();
    };
    let below: Vec<f64> = zero
        .checked_sub(1)
        .map_or(Vec::new(), |k| halves(&torques[k]).collect());
    let mut above: Vec<f64> = torques
        .get(zero + 1)
        .map_or(Vec::new(), |torque| halves(torque).collect());
    above.reverse();
    [
        &torques[..zero],
        &below,
        &[0.0],
        &above,
        &torques[zero + 1..],
    ]
    .concat()
}

/// Efficiency with a loss torque \[N m\]; `None` if the loss exceeds the power in. At a negative torque the power leaves at the
/// input shaft.
pub(crate) fn efficiency(torque_nm: f64, loss_nm: f64) -> Option<f64> {
    let power_in = if torque_nm < 0.0 {
        torque_nm.abs() + loss_nm
    } else {
        torque_nm
    };
    let efficiency = 1.0 - loss_nm / power_in;
    (0.0..1.0).contains(&efficiency).then_some(efficiency)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn torques_are_halved_towards_none_and_only_there() {
        let halved = closer_torques(&[-40.0, 0.0, 0.1, 160.0]);
        let due = [
            -40.0, -20.0, -10.0, -5.0, -2.5, -1.25, -0.625, -0.3125, 0.0, 0.1, 160.0,
        ];
        assert_eq!(halved, due);
        assert_eq!(closer_torques(&[20.0, 100.0]), [20.0, 100.0]);
    }

    #[test]
    fn a_loss_beyond_the_power_has_no_efficiency() {
        assert_eq!(efficiency(10.0, 1.0), Some(0.9));
        assert_eq!(efficiency(-9.0, 1.0), Some(0.9));
        assert!(efficiency(0.5, 1.0).is_none() && efficiency(0.0, 0.0).is_none());
    }
}
