//! Wear after a number of engagements: by a wear coefficient, or between traces before and after a test.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | N, N_p | engagements of a tooth of the pinion, and at the end of the test | - |
//! | N₁ | engagements at which the logarithm begins to count, 1000 | - |
//! | k | wear coefficient | 1/Pa |
//! | q | Rq over Rq before | - |
//! | q₀, q_p | the same after plastic flow without wear, and after the test | - |

use asperity_core::numerics::interpolate;
use asperity_core::{Estimate, cite};

/// Wear coefficient without a test, with a factor of ten each way from 5 to 95 % \[1/Pa\].
pub(super) const USUAL: f64 = 3e-19;
/// The factor.
const USUAL_FACTOR: f64 = 10.0;
/// Least factor each way of a wear coefficient from one pair of traces.
const LEAST_FACTOR: f64 = 1.5;
/// N₁.
pub(super) const BEGIN: f64 = 1e3;
/// Half width of the interval, from 5 to 95 %, of the fall by plastic flow from tooth to tooth, over this fall.
const OF_TOOTH: f64 = 0.03;

/// ln(1 + N/N₁).
fn logarithm(engagements: f64) -> f64 {
    (engagements / BEGIN).ln_1p()
}

/// Rq over Rq before of a flank as a function of the wear, falling until a first minimum.
#[derive(Debug, Clone)]
pub(super) struct Fall(Vec<(f64, f64)>);

impl Fall {
    /// The part of the points of wear and Rq ratio up to the first minimum.
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let mut kept: Vec<(f64, f64)> = Vec::new();
        for point in points {
            if kept.last().is_some_and(|last| point.1 >= last.1) {
                break;
            }
            kept.push(point);
        }
        Self(kept)
    }

    /// Rq ratio after wear `worn`.
    pub fn at(&self, worn: f64) -> f64 {
        interpolate(&self.0, worn)
    }

    /// Wear at which the Rq ratio is reached: none above the first point, the last beyond the minimum.
    pub fn worn(&self, ratio: f64) -> f64 {
        let reversed: Vec<(f64, f64)> = self.0.iter().rev().map(|(w, q)| (*q, *w)).collect();
        interpolate(&reversed, ratio)
    }

    /// Whether the Rq ratio is reached.
    pub fn reaches(&self, ratio: f64) -> bool {
        self.0.last().is_some_and(|(_, least)| *least <= ratio)
    }
}

/// Wear over engagements, with its interval from 5 to 95 %.
#[derive(Debug, Clone)]
pub(super) enum Clock {
    /// By a wear coefficient.
    Coefficient(Estimate),
    /// Between the traces of a test.
    Test(Tested),
}

/// Traces before and after a test on a flank.
#[derive(Debug, Clone)]
pub(super) struct Tested {
    /// Pinion or wheel, 0 or 1.
    pub flank: usize,
    pub fall: Fall,
    /// Engagements of the pinion in the test.
    pub engagements: f64,
    /// q₀.
    pub plastic: f64,
    /// q_p, with its interval.
    pub measured: Estimate,
}

impl Clock {
    /// The wear coefficient without a test.
    pub fn usual() -> Self {
        let ends = [USUAL / USUAL_FACTOR, USUAL * USUAL_FACTOR];
        Self::Coefficient(Estimate::new(USUAL, ends))
    }

    /// Wear after `engagements` in the wear stage \[1/Pa\]: between the traces of a test that at which their Rq ratio is reached.
    pub fn worn(&self, engagements: f64) -> Estimate {
        match self {
            Self::Coefficient(k) => k.map(|k| k * engagements),
            Self::Test(of) => of.worn(engagements),
        }
    }
}

impl Tested {
    /// Part of the logarithm of the test that is over.
    fn part(&self, engagements: f64) -> f64 {
        logarithm(engagements) / logarithm(self.engagements)
    }

    /// Half width of the interval of the fall that was measured: by the measurement, and by the flow of the teeth that were not traced.
    fn half_width(&self) -> f64 {
        self.measured
            .half_width()
            .hypot(OF_TOOTH * (1.0 - self.plastic))
    }

    /// Rq ratio after a number of engagements.
    ///
    /// ```text
    /// q = q₀ − (q₀ − q_p) ln(1 + N/N₁)/ln(1 + N_p/N₁)                                      [Running-in-clock]
    /// ```
    ///
    /// The interval contains as well wear in proportion to N.
    pub fn ratio(&self, engagements: f64) -> Estimate {
        cite!("Running-in-clock");
        let part = self.part(engagements);
        let fall = (self.plastic - self.measured.value).max(0.0);
        let middle = self.plastic - fall * part;
        let worn = self.fall.worn(self.measured.value.min(self.plastic));
        let in_proportion = self.fall.at(worn * engagements / self.engagements);
        let half = self.half_width();
        let ends = [
            middle.min(in_proportion) - half,
            middle.max(in_proportion) + half,
        ];
        Estimate::new(middle, ends)
    }

    fn worn(&self, engagements: f64) -> Estimate {
        self.ratio(engagements)
            .map(|q| self.fall.worn(q.min(self.plastic)))
    }

    /// k by the test, never narrower than a factor of 1.5 each way; `None` where plastic flow explains the fall.
    ///
    /// ```text
    /// k = W(q_p)/N_p                                                             [Wear-by-test]
    /// ```
    ///
    /// W: wear at which the Rq ratio is reached \[1/Pa\].
    pub fn coefficient(&self) -> Option<Estimate> {
        cite!("Wear-by-test");
        let of = |q: f64| self.fall.worn(q.min(self.plastic)) / self.engagements;
        let (q, half) = (self.measured.value, self.half_width());
        let [k, low, high] = [q, q + half, q - half].map(of);
        (k > 0.0).then(|| Estimate::new(k, [low.min(k / LEAST_FACTOR), high.max(k * LEAST_FACTOR)]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tested(measured: [f64; 3]) -> Tested {
        let [low, value, high] = measured;
        Tested {
            flank: 0,
            // Wear of 1e-12 takes a tenth off Rq, twice as much two tenths; then it rises.
            fall: Fall::new([(0.0, 0.9), (1e-12, 0.8), (2e-12, 0.7), (3e-12, 0.75)]),
            engagements: 1e6,
            plastic: 0.9,
            measured: Estimate::new(value, [low, high]),
        }
    }

    #[test]
    fn the_history_passes_through_the_traces_of_the_test() {
        let clock = Clock::Test(tested([0.79, 0.8, 0.81]));
        let at_end = clock.worn(1e6);
        assert!((at_end.value / 1e-12 - 1.0).abs() < 1e-9, "{at_end:?}");
        assert!(at_end.low < 0.9e-12 && at_end.high > 1.1e-12);
        assert!(clock.worn(0.0).value == 0.0);
        // Half of the logarithm is half of the fall; in proportion hardly anything has worn then.
        let middle = clock.worn(1e3 * (1001.0_f64.sqrt() - 1.0));
        assert!((middle.value / 0.5e-12 - 1.0).abs() < 1e-9);
        assert!(middle.low == 0.0 && (0.55e-12..0.65e-12).contains(&middle.high));
        let more = [1e4, 1e5, 1e6, 1e7].map(|n| clock.worn(n).value);
        assert!(more.is_sorted() && more[3] < 2e-12);
    }

    #[test]
    fn the_coefficient_is_the_wear_over_the_engagements() {
        let k = tested([0.795, 0.8, 0.805]).coefficient().unwrap();
        assert!((k.value / 1e-18 - 1.0).abs() < 1e-9);
        assert!(
            (k.low / k.value - 1.0 / 1.5).abs() < 1e-9 && (k.high / k.value - 1.5).abs() < 1e-9
        );
        let wide = tested([0.7, 0.8, 0.9]).coefficient().unwrap();
        assert!(wide.low == 0.0 && (wide.high / 2e-18 - 1.0).abs() < 1e-9);
        assert!(tested([0.9, 0.91, 0.92]).coefficient().is_none());
        assert!(tested([0.7, 0.7, 0.7]).fall.reaches(0.7) && !tested([0.7; 3]).fall.reaches(0.69));
    }

    #[test]
    fn without_a_test_the_coefficient_is_known_to_a_factor_of_ten() {
        let worn = Clock::usual().worn(1e6);
        assert!((worn.value / 3e-13 - 1.0).abs() < 1e-12);
        assert!((worn.high / worn.low - 100.0).abs() < 1e-9);
    }
}
