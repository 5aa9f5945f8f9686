//! Interval of a planetary set, from the losses of its two kinds of meshes.

use asperity_core::cite;

use super::drawn_losses::DrawnLosses;
use super::mixture::{Drawn, five_to_ninety_five};

/// 5 % and 95 % quantiles of the loss of `planets` meshes of each kind \[W\].
///
/// ```text
/// P_j = n (P₁(θ_j) + P₂(θ_j)),  SE_j² = n² (SE₁² + SE₂²)                              [Set-band]
/// ```
///
/// Both kinds have the same draws of oil and boundary layer. All planets stand on the same traces, so that the sampling
/// error does not fall with their number; those of the two kinds of meshes are taken as independent. Traces that are placed add
/// what their misplacement does, each with each.
pub(crate) fn quantiles_of_set(kinds: [&DrawnLosses; 2], planets: u32) -> [f64; 2] {
    cite!("Set-band");
    let n = f64::from(planets);
    let [first, second] = kinds;
    let moves = first.places().into_iter().flat_map(|one| {
        let others = second.places().into_iter();
        others.map(move |other| n * (one + other))
    });
    let moves: Vec<f64> = moves.collect();
    let pairs = first.draws().iter().zip(second.draws());
    let drawn = pairs.flat_map(|(a, b)| {
        let of_both = sum(first.drawn(a), second.drawn(b), n);
        let moved = |change: &f64| Drawn {
            value: of_both.value + change,
            ..of_both
        };
        moves.iter().map(moved).collect::<Vec<_>>()
    });
    five_to_ninety_five(&drawn.collect::<Vec<_>>())
}

/// n times the sum of both; the degrees of freedom by Welch and Satterthwaite.
fn sum(a: Drawn, b: Drawn, n: f64) -> Drawn {
    let value = n * (a.value + b.value);
    let squares = [a, b].map(|drawn| drawn.standard_error.powi(2));
    let together = squares[0] + squares[1];
    if together == 0.0 {
        return Drawn::exact(value);
    }
    let each = squares[0].powi(2) / a.freedom + squares[1].powi(2) / b.freedom;
    Drawn {
        value,
        standard_error: n * together.sqrt(),
        freedom: together.powi(2) / each,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_two_meshes_add_in_squares() {
        let drawn = |value, standard_error, freedom| Drawn {
            value,
            standard_error,
            freedom,
        };
        let both = sum(drawn(10.0, 3.0, 8.0), drawn(5.0, 4.0, 8.0), 3.0);
        assert_eq!((both.value, both.standard_error), (45.0, 15.0));
        // (9 + 16)²/(81/8 + 256/8)
        assert!((both.freedom - 625.0 / (337.0 / 8.0)).abs() < 1e-12);
        let alone = sum(drawn(10.0, 3.0, 8.0), Drawn::exact(5.0), 1.0);
        assert_eq!((alone.standard_error, alone.freedom), (3.0, 8.0));
        assert_eq!(
            sum(Drawn::exact(1.0), Drawn::exact(2.0), 2.0),
            Drawn::exact(6.0)
        );
    }
}
