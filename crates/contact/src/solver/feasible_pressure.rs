//! Pressures within their bounds that carry the load.

use crate::convolution::{Lanes, vectorised};

/// Points moved before they are counted: few enough to stay in the nearest cache.
const BLOCK: usize = 1 << 10;
/// Passes of the uniform shift before another way is tried.
const MAX_SHIFTS: usize = 50;
/// Halvings that bring any bracket below round-off.
const MAX_HALVINGS: usize = 100;
/// Load error that a shift cannot improve: round-off of a sum, which grows with √n.
const ROUND_OFF: f64 = 4e-16;
/// Load error that is accepted when the shift has no interior point left to move.
const ACCEPTED: f64 = 1e-12;

struct Tally {
    sum: f64,
    interior: f64,
}

/// Moves the interior points by `shift`, clips all to 0..`limit`, and counts again.
fn shift_and_clip(pressure: &mut [f64], shift: f64, limit: f64) -> Tally {
    let mut lanes = Lanes::new([0.0; 2]);
    vectorised(
        #[inline(always)]
        || {
            for block in pressure.chunks_mut(BLOCK) {
                for p in &mut *block {
                    let inside = (*p > 0.0) & (*p < limit);
                    *p = (*p + if inside { shift } else { 0.0 }).clamp(0.0, limit);
                }
                lanes.fold([block], |[sum, interior], [p]| {
                    let inside = (p > 0.0) & (p < limit);
                    [sum + p, interior + if inside { 1.0 } else { 0.0 }]
                });
            }
        },
    );
    let [sum, interior] = lanes.total();
    Tally { sum, interior }
}

/// Difference of loads that is only round-off.
fn close(pressure: &[f64], sum: f64) -> f64 {
    let count = pressure.len() as f64;
    ROUND_OFF * sum * (0.1 * count.sqrt()).max(1.0)
}

/// Clips `pressure` to 0..`limit` and restores Σp = `sum` by moving the points between the bounds
/// only: moving points at the limit too was found never to converge.
pub(crate) fn restore_load(pressure: &mut [f64], sum: f64, limit: f64) {
    let close = close(pressure, sum);
    let mut tally = shift_and_clip(pressure, 0.0, limit);
    for _ in 0..MAX_SHIFTS {
        let missing = sum - tally.sum;
        if missing.abs() <= close {
            return;
        }
        if tally.interior == 0.0 {
            break;
        }
        tally = shift_and_clip(pressure, missing / tally.interior, limit);
    }
    if (tally.sum - sum).abs() > ACCEPTED * sum {
        // All in contact are at the limit.
        project(pressure, sum, limit);
    }
}

/// The nearest pressures within 0..`limit` with Σp = `sum`: all points moved by as much, and
/// clipped. Newton's method on the shift, whose load is piecewise linear, within a bracket.
pub(crate) fn project(pressure: &mut [f64], sum: f64, limit: f64) {
    let close = close(pressure, sum);
    let least = pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let most = pressure.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // The ends carry nothing and, on a single point, everything.
    let (mut low, mut high) = (-most, sum - least);
    let mut shift = 0.0;
    for _ in 0..MAX_SHIFTS + MAX_HALVINGS {
        let mut lanes = Lanes::new([0.0; 2]);
        vectorised(
            #[inline(always)]
            || {
                lanes.fold([&*pressure], |[carried, moved], [p]| {
                    let q = p + shift;
                    let moves = (q > 0.0) & (q < limit);
                    [
                        carried + q.clamp(0.0, limit),
                        moved + if moves { 1.0 } else { 0.0 },
                    ]
                });
            },
        );
        let [carried, moved] = lanes.total();
        if (carried - sum).abs() <= close {
            break;
        }
        if carried < sum {
            low = shift;
        } else {
            high = shift;
        }
        let newton = shift + (sum - carried) / moved;
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if next == shift || next <= low || next >= high {
            break;
        }
        shift = next;
    }
    for p in pressure {
        *p = (*p + shift).clamp(0.0, limit);
    }
}

/// Clips `pressure` to 0..`limit`.
pub(crate) fn clip(pressure: &mut [f64], limit: f64) {
    for p in pressure {
        *p = p.clamp(0.0, limit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn total(pressure: &[f64]) -> f64 {
        pressure.iter().sum()
    }

    #[test]
    fn the_shift_moves_only_points_between_the_bounds() {
        let mut pressure = [0.0, 1.0, 2.0, 5.0, -3.0];
        restore_load(&mut pressure, 9.0, 4.0);
        assert!((total(&pressure) - 9.0).abs() < 1e-14);
        assert_eq!((pressure[0], pressure[3], pressure[4]), (0.0, 4.0, 0.0));
        assert!((pressure[2] - pressure[1] - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_projection_is_the_nearest_feasible_pressure() {
        let mut pressure = [3.0, -1.0, 1.0, 9.0];
        project(&mut pressure, 5.0, 4.0);
        // A shift of −1.5 gives 1.5, 0, 0 and, at its limit, 4; of −2 the load: 1 + 4.
        let expected = [1.0, 0.0, 0.0, 4.0];
        for (p, e) in pressure.iter().zip(expected) {
            assert!((p - e).abs() < 1e-14, "{pressure:?}");
        }
    }

    #[test]
    fn a_contact_all_at_the_limit_still_gets_its_load() {
        for (start, sum) in [
            ([4.0, 4.0, 0.0, 0.0], 6.0),
            ([4.0, 4.0, 0.0, 0.0], 10.0),
            ([4.0, 4.0, 4.0, 4.0], 10.0),
            ([0.0, 0.0, 0.0, 0.0], 3.0),
        ] {
            let mut pressure = start;
            restore_load(&mut pressure, sum, 4.0);
            assert!((total(&pressure) / sum - 1.0).abs() < 1e-12, "{start:?}");
            assert!(pressure.iter().all(|p| (0.0..=4.0).contains(p)));
        }
    }
}
