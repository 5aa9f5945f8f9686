//! Viscosity grade and viscosity index: the two viscosities of an oil from the words of its data sheet.
//!
//! Source: ISO 3448 (grades), ASTM D2270 (index). The coefficients of L and H agree to 0.1 % with the table of L and H in
//! the Python library `chemicals` 1.5.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | U, Y | kinematic viscosity at 40 and 100 °C | mm²/s |
//! | L, H | U of oils with this Y and the index 0 and 100 | mm²/s |
//! | VI | viscosity index | - |

use asperity_core::quantity::KinematicViscosity;
use asperity_core::{DomainError, cite};

/// Midpoints of ISO 3448 at 40 °C \[mm²/s\]: the numbers of the grades, where the smallest are rounded.
const GRADES: [(f64, f64); 20] = [
    (2.0, 2.2),
    (3.0, 3.2),
    (5.0, 4.6),
    (7.0, 6.8),
    (10.0, 10.0),
    (15.0, 15.0),
    (22.0, 22.0),
    (32.0, 32.0),
    (46.0, 46.0),
    (68.0, 68.0),
    (100.0, 100.0),
    (150.0, 150.0),
    (220.0, 220.0),
    (320.0, 320.0),
    (460.0, 460.0),
    (680.0, 680.0),
    (1000.0, 1000.0),
    (1500.0, 1500.0),
    (2200.0, 2200.0),
    (3200.0, 3200.0),
];

/// Least Y of a row, and the coefficients of L = a Y² + b Y + c and H = d Y² + e Y + f (ASTM D2270, appendix X2).
const ROWS: [(f64, [f64; 3], [f64; 3]); 16] = [
    (2.0, [1.14673, 1.7576, -0.109], [0.84155, 1.5521, -0.077]),
    (3.8, [3.38095, -15.4952, 33.196], [0.78571, 1.7929, -0.183]),
    (4.4, [2.5, -7.2143, 13.812], [0.82143, 1.5679, 0.119]),
    (5.0, [0.101, 16.635, -45.469], [0.04985, 9.1613, -18.557]),
    (6.4, [3.35714, -23.5643, 78.466], [0.22619, 7.7369, -16.656]),
    (7.0, [0.01191, 21.475, -72.87], [0.79762, -0.7321, 14.61]),
    (7.7, [0.41858, 16.1558, -56.04], [0.05794, 10.5156, -28.24]),
    (9.0, [0.88779, 7.5527, -16.6], [0.26665, 6.7015, -10.81]),
    (12.0, [0.7672, 10.7972, -38.18], [0.20073, 8.4658, -22.49]),
    (15.0, [0.97305, 5.3135, -2.2], [0.28889, 5.9741, -4.93]),
    (18.0, [0.97256, 5.25, -0.98], [0.24504, 7.416, -16.73]),
    (22.0, [0.91413, 7.4759, -21.82], [0.20323, 9.1267, -34.23]),
    (28.0, [0.87031, 9.7157, -50.77], [0.18411, 10.1015, -46.75]),
    (
        40.0,
        [0.84703, 12.6752, -133.31],
        [0.17029, 11.4866, -80.62],
    ),
    (55.0, [0.85921, 11.1009, -83.19], [0.1713, 11.368, -76.94]),
    (
        70.0,
        [0.83531, 14.6731, -216.246],
        [0.16841, 11.8493, -96.947],
    ),
];

/// mm²/s in a m²/s.
const MM2_PER_M2: f64 = 1e6;

/// Viscosity of an ISO VG grade at 40 °C, the middle of its range.
///
/// # Errors
/// When ISO 3448 has no such grade.
///
/// ```
/// use asperity_oil::viscosity_index::grade;
/// assert_eq!(grade(100.0)?, "100 mm2/s".parse()?);
/// assert!(grade(90.0).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn grade(number: f64) -> Result<KinematicViscosity, DomainError> {
    let grade = GRADES.iter().find(|(grade, _)| *grade == number);
    let rule =
        "must be a grade of ISO 3448: 10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460 and so on";
    DomainError::require(grade.is_some(), "ISO VG grade", number, "-", rule)?;
    let middle = grade.map_or(f64::NAN, |(_, middle)| *middle);
    Ok(KinematicViscosity::from_si(middle / MM2_PER_M2))
}

/// VI = 100·(L − U)/(L − H), above 100  VI = 100 + (10^N − 1)/0.00715,  N = log(H/U)/log Y     [VI-1]
///
/// # Errors
/// When a viscosity is not positive, or that at 100 °C is below 2 mm²/s, where the table begins.
///
/// ```
/// use asperity_oil::viscosity_index::viscosity_index;
/// // The two examples of ASTM D2270: 73.30 and 8.86 mm²/s, 22.83 and 5.05 mm²/s.
/// assert_eq!(viscosity_index("73.3 mm2/s".parse()?, "8.86 mm2/s".parse()?)?.round(), 92.0);
/// assert_eq!(viscosity_index("22.83 mm2/s".parse()?, "5.05 mm2/s".parse()?)?.round(), 156.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn viscosity_index(
    at_40: KinematicViscosity,
    at_100: KinematicViscosity,
) -> Result<f64, DomainError> {
    cite!("VI-1");
    let u = DomainError::positive("viscosity at 40 °C", at_40)? * MM2_PER_M2;
    let y = DomainError::positive("viscosity at 100 °C", at_100)? * MM2_PER_M2;
    let row = ROWS.iter().rev().find(|(least, ..)| *least <= y);
    let rule = "must be 2 mm2/s at least, where the table of ASTM D2270 begins";
    DomainError::require(row.is_some(), "viscosity at 100 °C", y, "mm2/s", rule)?;
    let (_, of_l, of_h) = row.unwrap_or(&ROWS[0]);
    let [l, h] = [of_l, of_h].map(|[a, b, c]| (a * y + b) * y + c);
    Ok(if u >= h {
        100.0 * (l - u) / (l - h)
    } else {
        100.0 + (10.0_f64.powf((h / u).log10() / y.log10()) - 1.0) / 0.00715
    })
}

/// Viscosity at 100 °C of an oil with this viscosity at 40 °C and viscosity index, by bisection of [`viscosity_index`].
///
/// # Errors
/// When no viscosity at 100 °C from 2 mm²/s on has this index.
///
/// ```
/// use asperity_oil::viscosity_index::{viscosity_at_100, viscosity_index};
/// let cold = "100 mm2/s".parse()?;
/// let hot = viscosity_at_100(cold, 95.0)?;
/// assert!((hot.si() - 11.1e-6).abs() < 0.1e-6);
/// assert!((viscosity_index(cold, hot)? - 95.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn viscosity_at_100(
    at_40: KinematicViscosity,
    index: f64,
) -> Result<KinematicViscosity, DomainError> {
    const STEPS: usize = 100;
    let [mut low, mut high] = [KinematicViscosity::from_si(ROWS[0].0 / MM2_PER_M2), at_40];
    let is_held = low < high
        && viscosity_index(at_40, low)? <= index
        && index <= viscosity_index(at_40, high)?;
    let rule = "has no viscosity at 100 °C from 2 mm2/s on";
    DomainError::require(is_held, "viscosity index", index, "-", rule)?;
    // The index rises with the viscosity at 100 °C.
    for _ in 0..STEPS {
        let middle = (low + high) / 2.0;
        if viscosity_index(at_40, middle)? < index {
            low = middle
        } else {
            high = middle
        }
    }
    Ok(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: [(f64, f64, f64); 8] = [
        (2.5, 11.45, 9.063),
        (4.7, 35.13, 25.63),
        (7.3, 84.53, 51.78),
        (10.0, 147.7, 82.87),
        (16.0, 331.9, 164.6),
        (25.0, 736.5, 320.9),
        (50.0, 2618.0, 919.6),
        (70.0, 4905.0, 1558.0),
    ];

    /// Y, L and H of the table of ASTM D2270, quoted from the library `chemicals` 1.5.
    #[test]
    fn the_index_is_0_and_100_at_the_ends_of_the_table() {
        for (y, l, h) in TABLE {
            let index = |u: f64| {
                let [u, y] = [u, y].map(|value| KinematicViscosity::from_si(value / MM2_PER_M2));
                viscosity_index(u, y).unwrap()
            };
            // The coefficients give L and H to 0.1 %.
            let tolerance = 100.0 * 1e-3 * l / (l - h);
            assert!(index(l).abs() < tolerance, "{y} {}", index(l));
            assert!((index(h) - 100.0).abs() < tolerance, "{y} {}", index(h));
        }
    }

    #[test]
    fn every_grade_has_a_viscosity_at_100_degrees() {
        for (number, _) in GRADES.into_iter().filter(|(number, _)| *number >= 10.0) {
            let cold = grade(number).unwrap();
            let hot =
                [50.0, 95.0, 140.0, 180.0].map(|index| viscosity_at_100(cold, index).unwrap());
            assert!(
                hot.windows(2).all(|pair| pair[0] < pair[1]),
                "{number} {hot:?}"
            );
        }
        let cold = grade(100.0).unwrap();
        assert!(viscosity_at_100(cold, -1e4).is_err() && viscosity_at_100(cold, f64::NAN).is_err());
    }
}
