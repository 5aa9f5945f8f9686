//! Loss torque between the nodes of a map.

/// Loss torque over torque and speed, bilinear between the nodes, held at the edges.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Torques \[N m\], rising.
    pub torque_nm: Vec<f64>,
    /// Speeds \[1/min\], rising.
    pub speed_rpm: Vec<f64>,
    /// Loss torques \[N m\], torque by torque.
    pub loss_torque_nm: Vec<f64>,
    /// Their standard deviations over the offsets of the traces \[N m\].
    pub deviation_nm: Vec<f64>,
}

/// A value between the nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpolated {
    /// Loss torque \[N m\].
    pub value: f64,
    /// Its standard deviation over the offsets \[N m\].
    pub deviation: f64,
    /// Whether the place is outside the nodes, so that the edge stands for it.
    pub is_outside: bool,
}

impl Surface {
    /// (1−a)((1−b) L_ij + b L_i,j+1) + a((1−b) L_i+1,j + b L_i+1,j+1): the loss torque at a torque \[N m\] and a
    /// speed \[1/min\]; a speed counts without its sign.
    #[must_use]
    pub fn loss_torque(&self, torque_nm: f64, speed_rpm: f64) -> Interpolated {
        let (i, a) = cell(&self.torque_nm, torque_nm);
        let (j, b) = cell(&self.speed_rpm, speed_rpm.abs());
        let across = self.speed_rpm.len();
        let of = |values: &[f64]| {
            let at = |i: usize, j: usize| {
                let (i, j) = (
                    i.min(self.torque_nm.len() - 1),
                    j.min(self.speed_rpm.len() - 1),
                );
                values[i * across + j]
            };
            (1.0 - a) * ((1.0 - b) * at(i, j) + b * at(i, j + 1))
                + a * ((1.0 - b) * at(i + 1, j) + b * at(i + 1, j + 1))
        };
        Interpolated {
            value: of(&self.loss_torque_nm),
            deviation: of(&self.deviation_nm),
            is_outside: !reaches(&self.torque_nm, torque_nm)
                || !reaches(&self.speed_rpm, speed_rpm.abs()),
        }
    }
}

/// The node below `value` and how far it is to the next, 0 to 1; the ends are held.
fn cell(nodes: &[f64], value: f64) -> (usize, f64) {
    let after = nodes.partition_point(|node| *node <= value);
    let i = after.saturating_sub(1).min(nodes.len().saturating_sub(2));
    match nodes.get(i + 1) {
        Some(next) => (i, ((value - nodes[i]) / (next - nodes[i])).clamp(0.0, 1.0)),
        None => (i, 0.0),
    }
}

fn reaches(nodes: &[f64], value: f64) -> bool {
    let (Some(low), Some(high)) = (nodes.first(), nodes.last()) else {
        return false;
    };
    (*low..=*high).contains(&value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_met_and_edges_are_held() {
        let surface = Surface {
            torque_nm: vec![-10.0, 0.0, 20.0],
            speed_rpm: vec![0.0, 100.0],
            loss_torque_nm: vec![3.0, 4.0, 1.0, 2.0, 5.0, 7.0],
            deviation_nm: vec![0.0; 6],
        };
        assert_eq!(surface.loss_torque(0.0, 100.0).value, 2.0);
        assert_eq!(surface.loss_torque(20.0, -100.0).value, 7.0);
        assert_eq!(surface.loss_torque(10.0, 50.0).value, 0.5 * (1.5 + 6.0));
        let beyond = surface.loss_torque(30.0, 200.0);
        assert!(beyond.is_outside && beyond.value == 7.0);
    }
}
