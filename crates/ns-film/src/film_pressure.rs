//! Pressure along the film of any gap, from Reynolds' equation at constant viscosity.
//!
//! Finite volumes between the points balance the flow through the middles of the intervals; the error is
//! of second order in the spacing. A film under tension ruptures: Reynolds' condition (Swift, Stieber)
//! is a complementarity of pressure and flow deficit. In one dimension it is a convex-hull problem, which
//! is solved directly, also for rough gaps with many ruptures.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, h | position, gap | m |
//! | U = u₁ + u₂ | sum of the speeds of the walls | m/s |
//! | η | viscosity | Pa s |
//! | p | pressure above ambient, zero at both ends | Pa |
//! | q | flow per unit width | m²/s |

use asperity_core::DomainError;
use asperity_core::numerics::trapezoid;
use asperity_core::quantity::{DynamicViscosity, LineLoad, Speed};
use serde::{Deserialize, Serialize};

use crate::FilmError;

/// Treatment of tension in the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Rupture {
    /// The film ruptures where pressure and its gradient vanish (Swift, Stieber); conserves flow.
    #[default]
    Reynolds,
    /// Negative pressures of the full film are set to zero; does not conserve flow.
    HalfSommerfeld,
    /// The film sustains tension; an antisymmetric gap then carries no load.
    FullSommerfeld,
}

/// Pressure along a film, with its flow and load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FilmPressure {
    /// Pressure at every point \[Pa\].
    pub pressure: Vec<f64>,
    /// Flow per unit width into the film, at the first point \[m²/s\].
    pub flow: f64,
    /// Load, the integral of the pressure.
    pub load: LineLoad,
    /// Number of points at which the film has ruptured.
    pub ruptured: usize,
    /// Largest imbalance of flow at a point of the film, relative to the entrained flow.
    pub residual: f64,
}

/// d/dx(h³/(12·η)·dp/dx) = (U/2)·dh/dx,  p = 0 at both ends                    [Reynolds-2]
///
/// `position` and `gap` are in \[m\]; positions increase in the direction of motion.
///
/// # Errors
/// When there are fewer than three points, the arrays differ in length, positions do not rise, a
/// gap is not positive, or the speed or the viscosity is not positive.
///
/// ```
/// use asperity_ns_film::film_pressure::{Rupture, film_pressure};
/// // A wedge from 2 um to 1 um over 1 mm: the textbook load is 6·η·U·L²/Δh²·(ln 2 − 2/3).
/// let x: Vec<f64> = (0..=1000).map(|i| i as f64 * 1e-6).collect();
/// let h: Vec<f64> = x.iter().map(|x| 2e-6 - 1e-3 * x).collect();
/// let film = film_pressure(&x, &h, "2 m/s".parse()?, "10 mPa s".parse()?, Rupture::Reynolds)?;
/// let textbook = 6.0 * 0.01 * 2.0 * 1e6 * (2f64.ln() - 2.0 / 3.0);
/// assert!((film.load.si() / textbook - 1.0).abs() < 1e-5 && film.ruptured == 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn film_pressure(
    position: &[f64],
    gap: &[f64],
    speed_sum: Speed,
    viscosity: DynamicViscosity,
    rupture: Rupture,
) -> Result<FilmPressure, FilmError> {
    asperity_core::cite!("Reynolds-2");
    check(position, gap)?;
    let u = DomainError::positive("sum of the wall speeds", speed_sum)?;
    let eta = DomainError::positive("viscosity", viscosity)?;
    let balance = Balance::new(position, gap, u, eta);
    let mut film = vec![true; balance.drag.len()];
    let mut pressure = balance.pressure(&film);
    if rupture == Rupture::Reynolds {
        film = balance.unruptured(&pressure);
        pressure = balance.pressure(&film);
    }
    let residual = balance.imbalance(&pressure, &film) * 2.0 / (u * smallest(gap));
    if rupture != Rupture::FullSommerfeld {
        // With Reynolds' condition only round-off at the edge of the film is negative.
        pressure.iter_mut().for_each(|p| *p = p.max(0.0));
    }
    let ruptured = match rupture {
        Rupture::FullSommerfeld => 0,
        _ => pressure[1..pressure.len() - 1]
            .iter()
            .filter(|p| **p <= 0.0)
            .count(),
    };
    let drag = 0.25 * u * (gap[0] + gap[1]);
    Ok(FilmPressure {
        flow: drag - balance.conductance[0] * (pressure[1] - pressure[0]),
        load: LineLoad::from_si(trapezoid(position, &pressure)),
        pressure,
        ruptured,
        residual,
    })
}

fn smallest(gap: &[f64]) -> f64 {
    gap.iter().copied().fold(f64::INFINITY, f64::min)
}

fn check(position: &[f64], gap: &[f64]) -> Result<(), FilmError> {
    const LEAST: usize = 3;
    let points = position.len();
    if points < LEAST {
        return Err(FilmError::too_few_points(points, LEAST));
    }
    if gap.len() != points {
        return Err(FilmError::wrong_length("gap", points, gap.len()));
    }
    let bad_element = |name, values: &[f64], index: usize, rule| {
        FilmError::bad_element(name, index, values[index], rule)
    };
    let is_gap = |h: &f64| h.is_finite() && *h > 0.0;
    if let Some(index) = gap.iter().position(|h| !is_gap(h)) {
        let rule = "must be finite and greater than zero";
        return Err(bad_element("gap", gap, index, rule));
    }
    if let Some(index) = position.iter().position(|x| !x.is_finite()) {
        return Err(bad_element("position", position, index, "must be finite"));
    }
    match position.windows(2).position(|x| x[1] <= x[0]) {
        None => Ok(()),
        Some(index) => Err(bad_element("position", position, index + 1, "must rise")),
    }
}

/// Balance of flow at the inner points: a tridiagonal system.
struct Balance {
    /// h³/(12·η·Δx) of every interval.
    conductance: Vec<f64>,
    /// Net entrained flow out of every inner point, (U/2)·Δh.
    drag: Vec<f64>,
}

impl Balance {
    fn new(position: &[f64], gap: &[f64], u: f64, eta: f64) -> Self {
        let middle: Vec<f64> = gap.windows(2).map(|h| 0.5 * (h[0] + h[1])).collect();
        let conductance = position
            .windows(2)
            .zip(&middle)
            .map(|(x, h)| h * h * h / (12.0 * eta * (x[1] - x[0])))
            .collect();
        let drag = middle.windows(2).map(|h| 0.5 * u * (h[1] - h[0])).collect();
        Self { conductance, drag }
    }

    /// Pressure that balances the flow in the film; zero where the film has ruptured.
    fn pressure(&self, film: &[bool]) -> Vec<f64> {
        let inner = film.len();
        // Elimination with the conductance `ground` from a point to p = 0 upstream. It adds and multiplies
        // positive numbers; the difference in Thomas' algorithm would cancel in a wide gap.
        let (mut share, mut source) = (vec![0.0; inner], vec![0.0; inner]);
        let (mut ground, mut carried) = (self.conductance[0], 0.0);
        for i in 0..inner {
            let east = self.conductance[i + 1];
            if !film[i] {
                (ground, carried) = (east, 0.0);
                continue;
            }
            let pivot = ground + east;
            share[i] = east / pivot;
            source[i] = (carried - self.drag[i]) / pivot;
            (ground, carried) = (ground * share[i], east * source[i]);
        }
        let mut pressure = vec![0.0; inner + 2];
        for i in (0..inner).rev() {
            pressure[i + 1] = source[i] + share[i] * pressure[i + 2];
        }
        pressure
    }

    /// Net flow out of inner point `i`: zero in the film, positive where the film lacks oil.
    fn flow_deficit(&self, pressure: &[f64], i: usize) -> f64 {
        let west = self.conductance[i] * (pressure[i + 1] - pressure[i]);
        let east = self.conductance[i + 1] * (pressure[i + 2] - pressure[i + 1]);
        self.drag[i] + west - east
    }

    fn imbalance(&self, pressure: &[f64], film: &[bool]) -> f64 {
        (0..film.len()).filter(|&i| film[i]).fold(0.0, |worst, i| {
            self.flow_deficit(pressure, i).abs().max(worst)
        })
    }

    /// Marks the points of the film for which p ≥ 0, deficit ≥ 0 and p·deficit = 0.
    ///
    /// As a function of the resistance s = Σ 1/conductance, p minus the pressure of the full film is
    /// linear in the film and concave where the film lacks oil. It is therefore the least concave
    /// majorant of the negative full pressure, computed as an upper convex hull. The film has ruptured at
    /// the points of the hull.
    fn unruptured(&self, full: &[f64]) -> Vec<bool> {
        let resistance: Vec<f64> = std::iter::once(0.0)
            .chain(self.conductance.iter().scan(0.0, |sum, k| {
                *sum += 1.0 / k;
                Some(*sum)
            }))
            .collect();
        let mut hull: Vec<usize> = Vec::new();
        for c in 0..full.len() {
            while let [.., a, b] = hull[..] {
                let (rise_ab, rise_bc) = (full[a] - full[b], full[b] - full[c]);
                let (run_ab, run_bc) =
                    (resistance[b] - resistance[a], resistance[c] - resistance[b]);
                if rise_ab * run_bc > rise_bc * run_ab {
                    break;
                }
                hull.pop();
            }
            hull.push(c);
        }
        let mut film = vec![true; self.drag.len()];
        for vertex in hull {
            if (1..=film.len()).contains(&vertex) {
                film[vertex - 1] = false;
            }
        }
        film
    }
}
