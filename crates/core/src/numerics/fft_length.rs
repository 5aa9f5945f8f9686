//! Lengths at which a fast Fourier transform is fast.

/// The smallest even number 2^a·3^b·5^c (a ≥ 1) that is not below `at_least`.
///
/// ```
/// use asperity_core::numerics::good_fft_length;
/// assert_eq!(good_fft_length(1), 2);
/// assert_eq!(good_fft_length(19_999), 20_000);
/// ```
pub fn good_fft_length(at_least: usize) -> usize {
    let at_least = at_least.max(2);
    let mut best = at_least.next_power_of_two();
    let mut fives = 1;
    while fives < best {
        let mut odd = fives;
        while odd < best {
            let twos = at_least.div_ceil(odd).next_power_of_two().max(2);
            best = best.min(odd * twos);
            odd *= 3;
        }
        fives *= 5;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_length_is_the_smallest_that_is_smooth_and_even() {
        let smooth = |mut n: usize| {
            for p in [2, 3, 5] {
                while n.is_multiple_of(p) {
                    n /= p;
                }
            }
            n == 1
        };
        for n in 1..3000 {
            let computed = good_fft_length(n);
            let expected = (n.max(2)..)
                .find(|m| m.is_multiple_of(2) && smooth(*m))
                .unwrap();
            assert_eq!(computed, expected, "for {n}");
        }
    }
}
