//! Published shares of the load on asperities, for comparison with the solved contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | L_a | share of the load on the asperities | - |
//! | W, U, G | w/(E′R), η₀ V_e/(E′R), α E′ | - |
//! | σ̄ | Sq/R | - |
//! | V | hardness over E′ | - |
//! | h̄, h_c | mean gap of the rough contact, central film of the smooth one | m |
//!
//! Sources: M. Masjedi and M. M. Khonsari, ASME J. Tribol. 134 (2012) 011503, line contact: only the abstract
//! could be read, the constants are unconfirmed; for comparison only. K. L. Johnson, J. A. Greenwood and
//! S. Y. Poon, Wear 19 (1972) 91: the film of mixed lubrication carries the share (h_c/h̄)^6.3. Both were made
//! for statistical roughness whose undeformed asperities touch at the mean gap.

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{Checked, DomainError, FittedRange, Treatment, cite};

use crate::dimensionless::FilmGroups;
use crate::error::RegimeError;
use crate::film_line;

/// Masjedi and Khonsari 2012 (unconfirmed): factor and powers of W, U, G.
const OUTER: (f64, f64, f64, f64) = (0.005, -0.408, -0.088, 0.103);
/// Masjedi and Khonsari 2012 (unconfirmed): factor and powers of σ̄, V, W, U, G.
const INNER: (f64, f64, f64, f64, f64, f64) = (4470.0, 6.015, 1.168, 0.485, -3.741, -2.898);
/// Johnson, Greenwood and Poon 1972: power of the film over the mean gap.
const FILM_POWER: f64 = 6.3;

/// The fit exceeds the whole load for thin films at low load.
const SHARE: FittedRange = FittedRange::new(
    "asperity share",
    0.0,
    1.0,
    "-",
    "Masjedi-Khonsari (held at the whole load)",
);

/// Share of the load on the asperities by Masjedi and Khonsari.
///
/// ```text
/// L_a = 0.00005 W^−0.408 U^−0.088 G^0.103
///       · ln(1 + 4470 σ̄^6.015 V^1.168 W^0.485 U^−3.741 G^−2.898)        [Masjedi-Khonsari]
/// ```
///
/// Held at 1, with a note, where the fit exceeds the load.
///
/// # Errors
/// When a group, the hardness or the modulus is not positive, or the roughness negative.
pub fn masjedi_khonsari(
    groups: &FilmGroups,
    combined_roughness: Length,
    radius: Length,
    hardness: Pressure,
    reduced_modulus: Pressure,
) -> Result<Checked<f64>, RegimeError> {
    cite!("Masjedi-Khonsari");
    let (g, u, w) = film_line::checked(groups)?;
    let sq = DomainError::non_negative("combined roughness", combined_roughness)?;
    let sigma = sq / DomainError::positive("radius", radius)?;
    let e = 2.0 * DomainError::positive("reduced modulus", reduced_modulus)?;
    let v = DomainError::positive("hardness", hardness)? / e;
    let (c, s, m, p, q, r) = INNER;
    let inner = c * sigma.powf(s) * v.powf(m) * w.powf(p) * u.powf(q) * g.powf(r);
    let (c, p, q, r) = OUTER;
    let percent = c * w.powf(p) * u.powf(q) * g.powf(r) * inner.ln_1p();
    let share = percent / 100.0;
    let mut outside = Vec::new();
    SHARE.check_as(Treatment::Held, share, &mut outside);
    Ok(Checked {
        value: share.min(1.0),
        outside,
    })
}

/// Share of the load on the film by Johnson, Greenwood and Poon.
///
/// ```text
/// c_f = (h_c/h̄)^6.3, at most 1                                        [Johnson-Greenwood-Poon]
/// ```
///
/// # Errors
/// When film or gap is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::published_shares::johnson_greenwood_poon;
/// let um = |x: f64| Length::from_si(x * 1e-6);
/// assert_eq!(johnson_greenwood_poon(um(0.2), um(0.2))?, 1.0);
/// assert!((johnson_greenwood_poon(um(0.2), um(0.25))? - 0.8f64.powf(6.3)).abs() < 1e-12);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn johnson_greenwood_poon(smooth_film: Length, mean_gap: Length) -> Result<f64, RegimeError> {
    cite!("Johnson-Greenwood-Poon");
    let h = DomainError::positive("smooth film", smooth_film)?;
    let gap = DomainError::positive("mean gap", mean_gap)?;
    Ok((h / gap).powf(FILM_POWER).min(1.0))
}
