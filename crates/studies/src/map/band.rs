//! Points of a map with a band of the loss.

use std::collections::BTreeSet;

use super::axes::Axes;

/// Points at which the band of the loss is computed: uncertain parameters and sampling of the flanks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MapBand {
    /// No points.
    None,
    /// Lowest, middle and highest torque and speed, at every temperature.
    #[default]
    Nodes,
    /// All points at which the traces resolve the contact: about twenty times the work of the map.
    Full,
}

/// Torques and speeds with a band, among those with resolved contacts and rotation.
pub(super) struct Banded {
    torques: BTreeSet<u64>,
    speeds: BTreeSet<u64>,
}

impl Banded {
    /// Points of `axes` on the side of a map whose smallest resolved torque is `from`.
    pub(super) fn of(band: MapBand, axes: &Axes, from: f64, is_side: impl Fn(f64) -> bool) -> Self {
        let torques = axes.torque_nm.iter().filter(|torque| is_side(**torque));
        let torques = torques.map(|torque| torque.abs());
        let torques = torques.filter(|torque| *torque > 0.0 && *torque >= from);
        let speeds = axes.speed_rpm.iter().copied().filter(|speed| *speed > 0.0);
        Self {
            torques: chosen(band, torques),
            speeds: chosen(band, speeds),
        }
    }

    pub(super) fn has(&self, torque: f64, speed: f64) -> bool {
        self.torques.contains(&torque.to_bits()) && self.speeds.contains(&speed.to_bits())
    }
}

fn chosen(band: MapBand, values: impl Iterator<Item = f64>) -> BTreeSet<u64> {
    // The bits of positive numbers have the order of the numbers.
    let all: BTreeSet<u64> = values.map(f64::to_bits).collect();
    let places = match (band, all.len()) {
        (MapBand::None, _) | (_, 0) => return BTreeSet::new(),
        (MapBand::Full, _) => return all,
        (MapBand::Nodes, count) => [0, (count - 1) / 2, count - 1],
    };
    let at = |place: usize| all.iter().nth(place).copied();
    places.into_iter().filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_by_three_points_are_the_lowest_the_middle_and_the_highest() {
        let axes = Axes::new(
            &[-100.0, -50.0, 0.0, 1.0, 20.0, 50.0, 80.0, 100.0],
            &[0.0, 1.0, 10.0, 100.0],
            &[90.0],
        );
        let axes = axes.unwrap();
        let of = |band| Banded::of(band, &axes, 10.0, |torque| torque >= 0.0);
        let nodes = of(MapBand::Nodes);
        let torques = [20.0, 50.0, 100.0];
        for torque in [1.0, 20.0, 50.0, 80.0, 100.0] {
            for speed in [0.0, 1.0, 10.0, 100.0] {
                let wanted = torques.contains(&torque) && speed > 0.0;
                assert_eq!(nodes.has(torque, speed), wanted, "{torque} {speed}");
            }
        }
        let full = of(MapBand::Full);
        assert!(full.has(80.0, 10.0) && !full.has(1.0, 10.0) && !full.has(80.0, 0.0));
        assert!(!of(MapBand::None).has(20.0, 10.0));
    }
}
