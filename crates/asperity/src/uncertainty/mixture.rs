//! Quantiles of draws that each have a sampling error.

use asperity_core::numerics::student_t_below;

/// A drawn value with its standard error and the degrees of freedom of that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drawn {
    /// Mean of the draw.
    pub value: f64,
    /// Its standard error; 0 where it has none.
    pub standard_error: f64,
    /// Degrees of freedom.
    pub freedom: f64,
}

impl Drawn {
    /// A value without error.
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self {
            value,
            standard_error: 0.0,
            freedom: 1.0,
        }
    }
}

/// The value that a share `probability` of the mixture of all draws lies below: each draw is a t distribution
/// about its mean. Draws without error are interpolated between, as spreadsheets do. Not a number of no draws.
#[must_use]
pub fn quantile(draws: &[Drawn], probability: f64) -> f64 {
    /// Standard errors that a bracket reaches beyond the draws: t of the fewest degrees of freedom used.
    const REACH: f64 = 1e3;
    const HALVINGS: usize = 100;
    if draws.iter().all(|draw| draw.standard_error == 0.0) {
        return interpolated(draws, probability);
    }
    let ends = |side: f64| {
        let values = draws
            .iter()
            .map(|d| d.value + side * REACH * d.standard_error);
        values.fold(-side * f64::INFINITY, |end: f64, value| match side > 0.0 {
            true => end.max(value),
            false => end.min(value),
        })
    };
    let below = |x: f64| {
        let shares = draws.iter().map(|draw| match draw.standard_error > 0.0 {
            true => student_t_below((x - draw.value) / draw.standard_error, draw.freedom),
            false => f64::from(u8::from(x >= draw.value)),
        });
        shares.sum::<f64>() / draws.len() as f64
    };
    let (mut low, mut high) = (ends(-1.0), ends(1.0));
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if below(middle) < probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

fn interpolated(draws: &[Drawn], probability: f64) -> f64 {
    let mut values: Vec<f64> = draws.iter().map(|draw| draw.value).collect();
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else {
        return f64::NAN;
    };
    let place = probability * last as f64;
    let k = (place as usize).min(last.saturating_sub(1));
    let (low, high) = (values[k], values[(k + 1).min(last)]);
    // Equal neighbours give their value to the last digit.
    low + (place - k as f64) * (high - low)
}

/// The 5 % and 95 % quantiles.
#[must_use]
pub fn five_to_ninety_five(draws: &[Drawn]) -> [f64; 2] {
    [quantile(draws, 0.05), quantile(draws, 0.95)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_draws_have_their_interpolated_quantiles() {
        let draws: Vec<Drawn> = (0..=20).map(|k| Drawn::exact(f64::from(k))).collect();
        assert_eq!(five_to_ninety_five(&draws), [1.0, 19.0]);
        assert_eq!(five_to_ninety_five(&[Drawn::exact(0.0); 24]), [0.0, 0.0]);
    }

    #[test]
    fn one_draw_with_an_error_has_the_quantiles_of_its_distribution() {
        let draw = Drawn {
            value: 10.0,
            standard_error: 2.0,
            freedom: 4.0,
        };
        // t(4): 95 % lie below 2.1318 (Abramowitz and Stegun, table 26.10).
        let [low, high] = five_to_ninety_five(&[draw; 3]);
        assert!((low - (10.0 - 2.0 * 2.1318)).abs() < 2e-3 && (high - 14.2637).abs() < 2e-3);
    }

    #[test]
    fn an_error_widens_the_band_of_the_draws() {
        let exact: Vec<Drawn> = (0..24).map(|k| Drawn::exact(f64::from(k))).collect();
        let spread: Vec<Drawn> = exact
            .iter()
            .map(|draw| Drawn {
                standard_error: 5.0,
                freedom: 10.0,
                ..*draw
            })
            .collect();
        let (narrow, wide) = (five_to_ninety_five(&exact), five_to_ninety_five(&spread));
        assert!(wide[0] < narrow[0] && wide[1] > narrow[1]);
    }
}
