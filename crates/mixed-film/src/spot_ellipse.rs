//! The elliptical Hertz contact with the load and the spreads of a spot of a patch, also where it reaches along the whole lead.
//!
//! The pressure p₀ √(1 − (2x/b)² − (2y/l)²) is cut off at half of the lead Λ to both sides of its middle. For l ≤ Λ this is an ellipse,
//! and for l → ∞ a line.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p₀ | largest pressure | Pa |
//! | b, l | axes along rolling and along the lead | m |
//! | v | part of the axis l/2 that the lead holds, min(1, Λ/l) | - |
//! | Y | half of the extent along the lead, v l/2 | m |
//! | F, Q | load ∫ p dA and ∫ p² dA | N, Pa²·m² |
//! | σ_x, ϱ | standard deviation along rolling, and concentration around the lead, of the places of the pressure | m, - |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::numerics::find_root;

/// Part v below which its functions equal a line to twelve digits.
const LEAST_PART: f64 = 1e-6;

/// Spot of a patch as it was found.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeasuredSpot {
    /// F²/Q \[m²\].
    pub(crate) load_over_squares: f64,
    /// F \[N\].
    pub(crate) force: f64,
    /// σ_x \[m\].
    pub(crate) deviation: f64,
    /// ϱ
    pub(crate) concentration: f64,
    /// Λ \[m\].
    pub(crate) lead: f64,
}

/// Contact of a spot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpotEllipse {
    /// Mean pressure times the axis along rolling \[N/m\].
    pub(crate) mean_load: f64,
    /// Load through the middle π p₀ b/4 \[N/m\].
    pub(crate) middle_load: f64,
    /// b, l \[m\].
    pub(crate) axes: [f64; 2],
}

impl SpotEllipse {
    /// The ellipse with the F²/Q of a spot, whose axes have the ratio of the axes by its spreads; `None` of a ridge that is even along
    /// the lead.
    ///
    /// ```text
    /// (l/b)_σ = l_ϱ/b_σ,  b_σ = 4 σ_x √((1 − v²/3)/(1 − 2v²/3 + v⁴/5)),
    /// ϱ = 3 (sin u − u cos u)/u³ for u = π l_ϱ/Λ ≤ π, else 2 v²/(π² (1 − v²/3)),
    /// F²/Q = (3 π²/16) b Y I²/J,  middle load over mean load M/I,
    /// I = 1 − v²/3,  J = ∫₀^v (1 − t²)^(3/2) dt/v,  M = ∫₀^v √(1 − t²) dt/v                   [Spot-axes]
    /// ```
    pub(crate) fn from_spot(spot: &MeasuredSpot) -> Option<Self> {
        cite!("Spot-axes");
        let half_lead = 0.5 * spot.lead;
        let by_spread = half_length(spot.concentration, half_lead)?;
        let part = (half_lead / by_spread).min(1.0);
        let square = part * part;
        let along = (1.0 - square / 3.0) / (1.0 - square * (2.0 / 3.0 - square / 5.0));
        let ratio = by_spread / (2.0 * spot.deviation * along.sqrt());
        // a Y I²/J with the half axes a and r a.
        let wanted = 8.0 * spot.load_over_squares / (3.0 * PI * PI);
        let whole = (wanted / (ratio * shape(1.0))).sqrt();
        let (a, part) = if ratio * whole <= half_lead {
            (whole, 1.0)
        } else {
            let of_part = |v: f64| half_lead * half_lead * shape(v) / (ratio * v) - wanted;
            let found = find_root(of_part, LEAST_PART, 1.0, 1e-14).ok()?.value;
            (half_lead / (ratio * found), found)
        };
        let half_length = ratio * a;
        let load = load(part);
        let middle = 0.5 * spot.force / (half_length.min(half_lead) * load);
        Some(Self {
            mean_load: middle * load / area(part),
            middle_load: middle,
            axes: [2.0 * a, 2.0 * half_length],
        })
    }
}

/// I
fn load(part: f64) -> f64 {
    1.0 - part * part / 3.0
}

/// I²/J
fn shape(part: f64) -> f64 {
    let rest = (1.0 - part * part).max(0.0).sqrt();
    let arc = part.asin() / part;
    let squares = ((5.0 - 2.0 * part * part) * rest + 3.0 * arc) / 8.0;
    load(part).powi(2) / squares
}

/// M
fn area(part: f64) -> f64 {
    0.5 * ((1.0 - part * part).max(0.0).sqrt() + part.asin() / part)
}

/// l_ϱ/2 \[m\] of the concentration ϱ; `None` without one.
fn half_length(concentration: f64, half_lead: f64) -> Option<f64> {
    const AS_LONG_AS_THE_LEAD: f64 = 3.0 / (PI * PI);
    if concentration <= AS_LONG_AS_THE_LEAD {
        let square = concentration / (2.0 / (PI * PI) + concentration / 3.0);
        let part = square.sqrt();
        return (part > LEAST_PART).then(|| half_lead / part);
    }
    let excess = |u: f64| around(u) - concentration;
    let u = find_root(excess, 0.0, PI, 1e-14).ok()?.value;
    Some(half_lead * u / PI)
}

/// ϱ of an ellipse with u = π l/Λ.
fn around(u: f64) -> f64 {
    /// Below it the series is exact to the last digit but one.
    const SMALL: f64 = 0.2;
    let square = u * u;
    if u < SMALL {
        1.0 - square / 10.0 * (1.0 - square / 28.0 * (1.0 - square / 54.0))
    } else {
        3.0 * (u.sin() - u * u.cos()) / (square * u)
    }
}

/// ϱ of even pressure over one of `rows` cells around the lead.
pub(crate) fn spread_over_a_cell(rows: usize) -> f64 {
    let half = PI / rows as f64;
    half.sin() / half
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use super::*;

    const LEAD: f64 = 100e-6;
    const PRESSURE: f64 = 1.3e9;

    /// The spot with the pressure of an ellipse with half axes \[m\], cut off at half of the lead, by sums.
    fn measured([a, c]: [f64; 2]) -> MeasuredSpot {
        let count = 4000;
        let y = c.min(0.5 * LEAD);
        let mut sums = [0.0; 4];
        for k in 0..count {
            let at = y * (f64::from(k) + 0.5) / f64::from(count);
            let rest = 1.0 - (at / c).powi(2);
            let width = a * rest.sqrt();
            let load = 0.5 * PI * PRESSURE * a * rest;
            sums[0] += load;
            sums[1] += 4.0 / 3.0 * PRESSURE.powi(2) * rest * width;
            sums[2] += load * 0.25 * width * width;
            sums[3] += load * (2.0 * PI * at / LEAD).cos();
        }
        let step = 2.0 * y / f64::from(count);
        MeasuredSpot {
            load_over_squares: step * sums[0] * sums[0] / sums[1],
            force: step * sums[0],
            deviation: (sums[2] / sums[0]).sqrt(),
            concentration: sums[3] / sums[0],
            lead: LEAD,
        }
    }

    #[test]
    fn an_ellipse_has_its_axes_at_every_length() {
        for c in [1e-6, 10e-6, 30e-6, 49.9e-6, 50.1e-6, 60e-6, 200e-6, 3e-3] {
            for a in [2e-6, 20e-6] {
                let found = SpotEllipse::from_spot(&measured([a, c])).unwrap();
                let close = |found: f64, expected: f64| {
                    assert!(
                        (found / expected - 1.0).abs() < 1e-5,
                        "{a} {c}: {found} {expected}"
                    );
                };
                close(found.axes[0], 2.0 * a);
                close(found.axes[1], 2.0 * c);
                close(found.middle_load, 0.5 * PI * a * PRESSURE);
                if c < 50e-6 {
                    close(found.mean_load, 2.0 / 3.0 * PRESSURE * 2.0 * a);
                }
            }
        }
    }

    #[test]
    fn a_ridge_that_becomes_even_becomes_the_line() {
        let line = measured([5e-6, 1e3]);
        let expected = 16.0 * line.load_over_squares / (3.0 * PI * PI * 0.5 * LEAD);
        let mut before = f64::INFINITY;
        for c in [1e-4, 1e-3, 1e-2, 0.1] {
            let found = SpotEllipse::from_spot(&MeasuredSpot {
                concentration: measured([5e-6, c]).concentration,
                ..line
            });
            let SpotEllipse {
                mean_load,
                middle_load,
                axes,
            } = found.unwrap();
            let off = (axes[0] / expected - 1.0).abs();
            assert!(off < before && (mean_load / middle_load - 1.0).abs() < before);
            before = off.max(1e-12);
        }
        assert!(before < 1e-6, "{before}");
        let even = MeasuredSpot {
            concentration: 0.0,
            ..line
        };
        assert_eq!(SpotEllipse::from_spot(&even), None);
        assert!((2.0 * 5e-6 / expected - 1.0).abs() < 1e-9);
    }

    #[test]
    fn nothing_jumps_where_the_spot_reaches_its_image() {
        // The place where both ends meet, approached from both sides by its concentration and by its load.
        let at = |concentration: f64, factor: f64| {
            let spot = measured([8e-6, 0.5 * LEAD]);
            let spot = MeasuredSpot {
                concentration,
                load_over_squares: factor * spot.load_over_squares,
                ..spot
            };
            SpotEllipse::from_spot(&spot).unwrap()
        };
        let meeting = 3.0 / (PI * PI);
        let values = |of: SpotEllipse| [of.mean_load, of.middle_load, of.axes[0], of.axes[1]];
        for step in [1e-4, 1e-6, 1e-8] {
            let pairs = [
                [at(meeting - step, 1.0), at(meeting + step, 1.0)],
                [at(meeting, 1.0 - step), at(meeting, 1.0 + step)],
            ];
            for [low, high] in pairs {
                for (low, high) in values(low).into_iter().zip(values(high)) {
                    assert!(
                        (low / high - 1.0).abs() < 20.0 * step,
                        "{step}: {low} {high}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_mean_pressure_is_between_those_of_ellipse_and_line() {
        let mean = |c: f64| {
            let found = SpotEllipse::from_spot(&measured([5e-6, c])).unwrap();
            found.mean_load / found.axes[0] / PRESSURE
        };
        assert!((mean(20e-6) - 2.0 / 3.0).abs() < 1e-5);
        assert!((mean(1e-2) - FRAC_PI_4).abs() < 1e-5);
        assert!(mean(60e-6) > mean(51e-6));
    }
}
