//! Feasible pressures: within their bounds and carrying the load.

use crate::convolution::{Lanes, vectorised};

/// Points that are shifted and summed at a time: 8 KB, which stay in the first-level cache between both.
const BLOCK: usize = 1 << 10;
/// Most uniform shifts. Each moves the points that reach a bound out of the next, so a few are enough;
/// a contact that needs more is projected.
const MAX_SHIFTS: usize = 50;
/// Halvings that bring any bracket of double-precision numbers below round-off.
const MAX_HALVINGS: usize = 100;
/// Relative load error that a shift cannot reduce: round-off of a sum, which grows with √n.
const ROUND_OFF: f64 = 4e-16;
/// Relative load error that is accepted when no interior point is left to shift.
const ACCEPTED: f64 = 1e-12;

/// Sum of the pressure, and number of points between the bounds.
struct LoadCount {
    sum: f64,
    interior: f64,
}

/// Moves the interior points by `shift`, clips all points to 0..`limit`, and sums and counts them.
fn shift_and_clip(pressure: &mut [f64], shift: f64, limit: f64) -> LoadCount {
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
    LoadCount { sum, interior }
}

/// Difference of loads that is within round-off.
fn load_round_off(points: usize, sum: f64) -> f64 {
    ROUND_OFF * sum * (0.1 * (points as f64).sqrt()).max(1.0)
}

/// Clips `pressure` to 0..`limit` and restores Σp = `sum` by shifting the points between the bounds.
///
/// Points at the limit are left there: if they were shifted too, the iteration would never converge.
pub(crate) fn restore_load(pressure: &mut [f64], sum: f64, limit: f64) {
    let points = pressure.len();
    if !shift_load(pressure, points, sum, limit) {
        project(pressure, sum, limit);
    }
}

/// Clips and shifts as [`restore_load`]. False if the load is not restored, because all points in contact are at the limit. Points
/// without pressure may be missing from `pressure`; `points` is the number of all, on which the round-off depends.
pub(crate) fn shift_load(pressure: &mut [f64], points: usize, sum: f64, limit: f64) -> bool {
    let round_off = load_round_off(points, sum);
    let mut count = shift_and_clip(pressure, 0.0, limit);
    for _ in 0..MAX_SHIFTS {
        let missing = sum - count.sum;
        if missing.abs() <= round_off {
            return true;
        }
        if count.interior == 0.0 {
            break;
        }
        count = shift_and_clip(pressure, missing / count.interior, limit);
    }
    (count.sum - sum).abs() <= ACCEPTED * sum
}

/// Projects `pressure` onto the pressures within 0..`limit` with Σp = `sum`: all points are shifted by
/// the same amount and clipped.
///
/// The load is a piecewise linear function of the shift. Its root is found by Newton's method within a
/// bracket, with a bisection where a Newton step leaves the bracket.
pub(crate) fn project(pressure: &mut [f64], sum: f64, limit: f64) {
    let round_off = load_round_off(pressure.len(), sum);
    let least = pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let most = pressure.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // At one end no point carries pressure; at the other the lowest point alone carries the load.
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
        if (carried - sum).abs() <= round_off {
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
    fn blocks_of_points_without_pressure_may_be_left_out() {
        // Pressure in the second and the fifth of six blocks of 64 points, which are shifted alone and among all.
        let loaded = |i: usize| matches!(i / 64, 1 | 4).then(|| (0.37 * i as f64).sin().max(0.0));
        let mut all: Vec<f64> = (0..384).map(|i| loaded(i).unwrap_or(0.0)).collect();
        let mut parts: Vec<f64> = (0..384).filter_map(loaded).collect();
        assert!(shift_load(&mut parts, 384, 30.0, 0.9));
        restore_load(&mut all, 30.0, 0.9);
        let expected: Vec<f64> = [&all[64..128], &all[256..320]].concat();
        assert_eq!(parts, expected);
        assert!((total(&all) - 30.0).abs() < 1e-12);
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
