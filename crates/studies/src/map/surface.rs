//! Loss torque between the nodes of a map.

use asperity_core::numerics::NodeInterval;

/// Loss torque over torque and speed, bilinear between the nodes.
///
/// Outside of the nodes the ratio of loss to torque is constant: the loss at the nearest edge times the ratio of the
/// torques, and the value is marked. A sign of the torque without nodes has the losses of the other sign. A negative speed
/// has the losses of the same power forwards, see [`forwards`].
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Torques \[N m\], ascending.
    pub torque_nm: Vec<f64>,
    /// Speeds \[1/min\], ascending.
    pub speed_rpm: Vec<f64>,
    /// Loss torques \[N m\], torque by torque.
    pub loss_torque_nm: Vec<f64>,
}

/// Interpolated value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpolated {
    /// Loss torque \[N m\].
    pub value: f64,
    /// Whether the point is outside of the nodes or NaN.
    pub is_outside: bool,
}

impl Surface {
    /// L(T, n) = f·((1−a)((1−b) L_ij + b L_i,j+1) + a((1−b) L_i+1,j + b L_i+1,j+1)): the loss torque at a torque
    /// T \[N m\] and a speed n \[1/min\] of either sign; f = 1 within the nodes, |T/T_edge| beyond.
    #[must_use]
    pub fn loss_torque(&self, torque_nm: f64, speed_rpm: f64) -> Interpolated {
        let [torque_nm, speed_rpm] = forwards(torque_nm, speed_rpm);
        let (at, factor) = held(&self.torque_nm, torque_nm);
        let interval =
            |nodes: &[f64], at: f64| NodeInterval::from_nodes(nodes, |node| *node, at).held();
        let across = interval(&self.speed_rpm, speed_rpm);
        let speeds = self.speed_rpm.len();
        let loss = |i: usize| across.mean(|j| self.loss_torque_nm[i * speeds + j]);
        Interpolated {
            value: factor * interval(&self.torque_nm, at).mean(loss),
            is_outside: !reaches(&self.torque_nm, torque_nm)
                || !reaches(&self.speed_rpm, speed_rpm),
        }
    }
}

/// Torque and speed of the same power with a speed that is not negative: reverse operation, mirrored. A positive torque
/// drives forwards, a negative one in reverse.
///
/// ```
/// use asperity_studies::map::forwards;
/// assert_eq!(forwards(-20.0, -500.0), [20.0, 500.0]);
/// assert_eq!(forwards(-20.0, 500.0), [-20.0, 500.0]);
/// ```
#[must_use]
pub fn forwards(torque_nm: f64, speed_rpm: f64) -> [f64; 2] {
    if speed_rpm < 0.0 {
        [-torque_nm, -speed_rpm]
    } else {
        [torque_nm, speed_rpm]
    }
}

/// Torque at which the nodes are evaluated for `torque`, and the factor on the loss.
fn held(nodes: &[f64], torque: f64) -> (f64, f64) {
    let (Some(&low), Some(&high)) = (nodes.first(), nodes.last()) else {
        return (torque, 1.0);
    };
    let edge_of = |torque: f64| match torque {
        torque if torque < low => low,
        torque if torque > high => high,
        torque => torque,
    };
    let is_other_direction = (torque < 0.0 && low >= 0.0) || (torque > 0.0 && high <= 0.0);
    let torque = if is_other_direction { -torque } else { torque };
    let edge = edge_of(torque);
    if edge == torque || edge == 0.0 {
        (edge, 1.0)
    } else {
        (edge, (torque / edge).abs())
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

    fn surface() -> Surface {
        Surface {
            torque_nm: vec![-10.0, 0.0, 20.0],
            speed_rpm: vec![0.0, 100.0],
            loss_torque_nm: vec![3.0, 4.0, 1.0, 2.0, 5.0, 7.0],
        }
    }

    #[test]
    fn nodes_are_met_and_beyond_them_loss_over_torque_is_held() {
        let surface = surface();
        assert_eq!(surface.loss_torque(0.0, 100.0).value, 2.0);
        assert_eq!(surface.loss_torque(-20.0, -100.0).value, 7.0);
        assert_eq!(surface.loss_torque(10.0, -100.0).value, 4.0);
        assert_eq!(surface.loss_torque(10.0, 50.0).value, 0.5 * (1.5 + 6.0));
        assert!(!surface.loss_torque(10.0, 50.0).is_outside);
        let beyond = surface.loss_torque(30.0, 100.0);
        assert!(beyond.is_outside && (beyond.value - 7.0 * 1.5).abs() < 1e-14);
        let beyond = surface.loss_torque(-40.0, 200.0);
        assert!(beyond.is_outside && beyond.value == 4.0 * 4.0);
        let faster = surface.loss_torque(20.0, 200.0);
        assert!(faster.is_outside && faster.value == 7.0);
    }

    #[test]
    fn a_direction_without_nodes_takes_the_losses_of_the_other() {
        let one_sided = Surface {
            torque_nm: vec![0.0, 20.0],
            loss_torque_nm: vec![1.0, 2.0, 5.0, 7.0],
            ..surface()
        };
        let back = one_sided.loss_torque(-20.0, 100.0);
        assert!(back.is_outside && back.value == 7.0);
        assert_eq!(one_sided.loss_torque(-40.0, 100.0).value, 14.0);
        assert_eq!(one_sided.loss_torque(0.0, 100.0).value, 2.0);
        assert!(!one_sided.loss_torque(0.0, 100.0).is_outside);
    }

    #[test]
    fn what_is_no_number_has_no_loss_and_is_outside() {
        for (torque, speed) in [(f64::NAN, 50.0), (10.0, f64::NAN)] {
            let found = surface().loss_torque(torque, speed);
            assert!(found.value.is_nan() && found.is_outside);
        }
        let endless = surface().loss_torque(f64::INFINITY, 50.0);
        assert!(endless.value.is_infinite() && endless.is_outside);
    }
}
