//! Student's t distribution with any number of degrees of freedom, whole or not.
//!
//! | symbol | meaning |
//! |---|---|
//! | ν | degrees of freedom |
//! | A(t \| ν) | share of the distribution between −t and t |
//! | I_x(a, b) | regularised incomplete beta function |

/// A(t | ν) = 1 − I_x(ν/2, ½),  x = ν/(ν + t²)
///
/// Not a number unless ν is positive.
///
/// ```
/// use asperity_core::numerics::student_t_within;
/// // ν = 1 is Cauchy's distribution: A = (2/π) atan t.
/// assert!((student_t_within(1.0, 1.0) - 0.5).abs() < 1e-14);
/// ```
pub fn student_t_within(t: f64, freedom: f64) -> f64 {
    if t.is_infinite() {
        return 1.0;
    }
    let x = freedom / (freedom + t * t);
    let within = 1.0 - incomplete_beta(x, 0.5 * freedom, 0.5);
    within.clamp(0.0, 1.0)
}

/// Share of the distribution below `t`.
///
/// ```
/// use asperity_core::numerics::student_t_below;
/// assert_eq!(student_t_below(0.0, 7.5), 0.5);
/// ```
pub fn student_t_below(t: f64, freedom: f64) -> f64 {
    let half = 0.5 * student_t_within(t.abs(), freedom);
    0.5 + half.copysign(t)
}

/// t with A(t | ν) = `confidence`, by bisection to the last digits.
///
/// ```
/// use asperity_core::numerics::student_t_quantile;
/// // Abramowitz and Stegun, table 26.10.
/// assert!((student_t_quantile(0.95, 4.0) - 2.776).abs() < 6e-4);
/// ```
pub fn student_t_quantile(confidence: f64, freedom: f64) -> f64 {
    /// Halvings of a bracket as wide as f64 can hold down to its last digit.
    const HALVINGS: usize = 200;
    let (mut low, mut high) = (0.0, 1.0);
    while student_t_within(high, freedom) < confidence && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            break;
        }
        if student_t_within(middle, freedom) < confidence {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// I_x(a, b) by its continued fraction (Abramowitz and Stegun 26.5.8) after Lentz.
fn incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    // The fraction converges fast on the side below the mean; on the other its mirror image does.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - incomplete_beta(1.0 - x, b, a);
    }
    let log = a * x.ln() + b * (-x).ln_1p() + log_gamma(a + b) - log_gamma(a) - log_gamma(b);
    log.exp() * beta_fraction(x, a, b) / a
}

fn beta_fraction(x: f64, a: f64, b: f64) -> f64 {
    /// Terms; some 10 suffice for all ν, more are a safeguard.
    const TERMS: usize = 400;
    const TINY: f64 = 1e-300;
    let guard = |value: f64| if value.abs() < TINY { TINY } else { value };
    let mut c = 1.0;
    let mut d = 1.0 / guard(1.0 - (a + b) * x / (a + 1.0));
    let mut sum = d;
    for term in 1..TERMS {
        let m = term as f64;
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        for factor in [even, odd] {
            d = 1.0 / guard(1.0 + factor * d);
            c = guard(1.0 + factor / c);
            sum *= c * d;
        }
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    sum
}

/// ln Γ(x), x > 0, by Lanczos' approximation with g = 7 and nine terms, good to some 1e-15 relative.
fn log_gamma(x: f64) -> f64 {
    /// Coefficients after P. Godfrey, as printed in many places.
    #[allow(clippy::excessive_precision)]
    const COEFFICIENTS: [f64; 9] = [
        0.999_999_999_999_809_93,
        676.520_368_121_885_1,
        -1_259.139_216_722_402_8,
        771.323_428_777_653_13,
        -176.615_029_162_140_59,
        12.507_343_278_686_905,
        -0.138_571_095_265_720_12,
        9.984_369_578_019_571_6e-6,
        1.505_632_735_149_311_6e-7,
    ];
    const G: f64 = 7.0;
    let x = x - 1.0;
    let mut sum = COEFFICIENTS[0];
    for (k, coefficient) in COEFFICIENTS.iter().enumerate().skip(1) {
        sum += coefficient / (x + k as f64);
    }
    let t = x + G + 0.5;
    0.5 * (2.0 * std::f64::consts::PI).ln() + (x + 0.5) * t.ln() - t + sum.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_t_has_its_tabulated_values() {
        // Abramowitz and Stegun, table 26.10; three decimals are printed there.
        for (freedom, confidence, expected) in [
            (1.0, 0.95, 12.706),
            (2.0, 0.95, 4.303),
            (3.0, 0.95, 3.182),
            (4.0, 0.95, 2.776),
            (15.0, 0.95, 2.131),
            (30.0, 0.99, 2.750),
            (120.0, 0.95, 1.980),
        ] {
            let computed = student_t_quantile(confidence, freedom);
            assert!((computed - expected).abs() < 6e-4, "{freedom} {computed}");
        }
    }

    #[test]
    fn closed_forms_of_one_and_two_degrees_of_freedom_are_met() {
        for t in [0.01_f64, 0.3, 1.0, 4.0, 60.0] {
            let cauchy = 2.0 / std::f64::consts::PI * t.atan();
            assert!((student_t_within(t, 1.0) - cauchy).abs() < 1e-13, "{t}");
            let two = t / (2.0 + t * t).sqrt();
            assert!((student_t_within(t, 2.0) - two).abs() < 1e-13, "{t}");
        }
    }

    #[test]
    fn between_whole_degrees_of_freedom_the_quantile_falls() {
        let mut before = f64::INFINITY;
        for tenth in 10..400 {
            let computed = student_t_quantile(0.95, f64::from(tenth) / 10.0);
            assert!(computed < before && computed > 1.95, "{tenth} {computed}");
            before = computed;
        }
    }

    #[test]
    fn the_ends_of_the_distribution_are_reached() {
        assert_eq!(student_t_within(0.0, 3.3), 0.0);
        assert_eq!(student_t_within(f64::INFINITY, 3.3), 1.0);
        assert!((student_t_below(-2.0, 5.0) + student_t_below(2.0, 5.0) - 1.0).abs() < 1e-15);
    }
}
