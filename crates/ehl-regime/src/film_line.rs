//! Smooth isothermal film thickness of a line contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | G, U, W | groups of [`dimensionless`](crate::dimensionless), W = w/(E′R) | - |
//! | R | relative radius of curvature | m |
//! | h_c | central film thickness | m |
//! | h_m | minimum film thickness | m |
//!
//! Sources: D. Dowson and G. R. Higginson, Elasto-hydrodynamic Lubrication (1977), for the
//! minimum; D. Dowson and A. Toyoda (1979) for the centre; H. Moes (2000) for the form that
//! covers all four asymptotes; A. N. Grubin (1949) for the inlet solution. The first two are
//! fits to piezoviscous elastic solutions of flooded, smooth, isothermal contacts. Their printed
//! tables of cases were not available, so no range of G, U, W is checked here. Outside this regime compare with
//! Moes' form, which has the right limits.

use asperity_core::numerics::elementary::{exp, ln};
use asperity_core::numerics::vectorised;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::dimensionless::FilmGroups;
use crate::error::RegimeError;

/// A film law that is a product of powers: h = c U^u G^g W^w R.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerLaw {
    pub(crate) factor: f64,
    pub(crate) speed: f64,
    pub(crate) material: f64,
    pub(crate) load: f64,
}

impl PowerLaw {
    pub(crate) fn film(&self, groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
        let (g, u, w) = checked(groups)?;
        let r = DomainError::positive("radius", radius)?;
        Ok(Length::from_si(
            self.factor * u.powf(self.speed) * g.powf(self.material) * w.powf(self.load) * r,
        ))
    }
}

/// Dowson and Toyoda 1979, central film.
pub(crate) const DOWSON_TOYODA: PowerLaw = PowerLaw {
    factor: 3.06,
    speed: 0.69,
    material: 0.56,
    load: -0.10,
};

/// Dowson and Higginson 1977, minimum film.
pub(crate) const DOWSON_HIGGINSON: PowerLaw = PowerLaw {
    factor: 2.65,
    speed: 0.70,
    material: 0.54,
    load: -0.13,
};

/// Grubin 1949 (Ertel), film at the end of the inlet.
pub(crate) const ERTEL_GRUBIN: PowerLaw = PowerLaw {
    factor: 1.95,
    speed: 8.0 / 11.0,
    material: 8.0 / 11.0,
    load: -1.0 / 11.0,
};

/// Moes 2000: the asymptotes as (factor, exponent of M, exponent of L).
const RIGID_ISOVISCOUS: (f64, f64, f64) = (3.0, -1.0, 0.0);
const ELASTIC_ISOVISCOUS: (f64, f64, f64) = (2.621, -1.0 / 5.0, 0.0);
const RIGID_PIEZOVISCOUS: (f64, f64, f64) = (1.287, 0.0, 2.0 / 3.0);
const ELASTIC_PIEZOVISCOUS: (f64, f64, f64) = (1.311, -1.0 / 8.0, 3.0 / 4.0);

pub(crate) fn checked(groups: &FilmGroups) -> Result<(f64, f64, f64), DomainError> {
    let rule = "must be finite and greater than zero";
    let positive = |name, value: f64| {
        DomainError::require(value.is_finite() && value > 0.0, name, value, "-", rule)
    };
    Ok((
        positive("material group G", groups.material)?,
        positive("speed group U", groups.speed)?,
        positive("load group W", groups.load)?,
    ))
}

/// Central film of a line contact by Dowson and Toyoda.
///
/// ```text
/// h_c = 3.06 U^0.69 G^0.56 W^−0.10 R                                    [Dowson-Toyoda]
/// ```
///
/// # Errors
/// When a group or the radius is not finite and positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::dowson_toyoda};
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-5 };
/// let film = dowson_toyoda(&groups, Length::from_si(11.6269e-3))?;
/// assert!((film.si() - 1.961e-6).abs() < 1e-9);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn dowson_toyoda(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    cite!("Dowson-Toyoda");
    DOWSON_TOYODA.film(groups, radius)
}

/// Minimum film of a line contact by Dowson and Higginson.
///
/// ```text
/// h_m = 2.65 U^0.70 G^0.54 W^−0.13 R                                 [Dowson-Higginson]
/// ```
///
/// # Errors
/// When a group or the radius is not finite and positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::dowson_higginson};
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-5 };
/// let film = dowson_higginson(&groups, Length::from_si(11.6269e-3))?;
/// assert!((film.si() - 1.549e-6).abs() < 1e-9);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn dowson_higginson(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    cite!("Dowson-Higginson");
    DOWSON_HIGGINSON.film(groups, radius)
}

/// Film of a line contact from the inlet, by Ertel and Grubin.
///
/// ```text
/// h_c = 1.95 (G U)^(8/11) W^(−1/11) R                                    [Ertel-Grubin]
/// ```
///
/// # Errors
/// When a group or the radius is not finite and positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::ertel_grubin};
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-5 };
/// let film = ertel_grubin(&groups, Length::from_si(11.6269e-3))?;
/// assert!((film.si() - 2.020e-6).abs() < 1e-9);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn ertel_grubin(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    cite!("Ertel-Grubin");
    ERTEL_GRUBIN.film(groups, radius)
}

/// Central film of a line contact by Moes, for all four regimes.
///
/// ```text
/// h_c = R √U_Σ [ (H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(−7/2) + H_EP^(−7/2))^(−2s/7) ]^(1/s),
/// s = (7 + 8 e^(−2 H_EI/H_RI))/5,
/// H_RI = 3/M, H_EI = 2.621 M^(−1/5), H_RP = 1.287 L^(2/3), H_EP = 1.311 M^(−1/8) L^(3/4),
/// M = W/√U_Σ, L = G U_Σ^(1/4), U_Σ = η₀ (u₁ + u₂)/(E′ R) = 2 U                  [Moes]
/// ```
///
/// The subscripts are rigid/elastic and isoviscous/piezoviscous; the form is right in each of
/// the four limits. It uses the *sum* of the surface speeds.
///
/// # Errors
/// When a group or the radius is not finite and positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::moes};
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-5 };
/// let film = moes(&groups, Length::from_si(11.6269e-3))?;
/// assert!((film.si() - 1.952e-6).abs() < 1e-9);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn moes(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    cite!("Moes");
    let (g, u, w) = checked(groups)?;
    let r = DomainError::positive("radius", radius)?;
    Ok(Length::from_si(film_of_moes([g, u, w, r])))
}

/// [`moes`] of the first `count` of many contacts, in vector lanes: material, speed and load number, and radius \[m\]. Inputs are not
/// checked: a film is positive and finite only if they are.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::{moes, moes_of_each}};
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-5 };
/// let film = moes(&groups, Length::from_si(11.6269e-3))?;
/// let each = moes_of_each([[4615.38; 4], [1.6599e-10; 4], [4.22675e-5; 4], [11.6269e-3; 4]], 3);
/// assert_eq!(each, [film.si(), film.si(), film.si(), 0.0]);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
#[must_use]
pub fn moes_of_each<const N: usize>(
    [material, speed, load, radius]: [[f64; N]; 4],
    count: usize,
) -> [f64; N] {
    cite!("Moes");
    vectorised(
        #[inline(always)]
        || {
            let mut films = [0.0; N];
            // A loop of a known few passes would be unrolled before it is compiled to vectors.
            for k in 0..count.min(N) {
                films[k] = film_of_moes([material[k], speed[k], load[k], radius[k]]);
            }
            films
        },
    )
}

/// h_c of G, U, W and R, in logarithms: a load share requires thousands of films of touching asperities, and powers would cost most of it.
#[inline(always)]
fn film_of_moes([g, u, w, r]: [f64; 4]) -> f64 {
    let u_sum = 2.0 * u;
    let (m, l) = (ln(w / u_sum.sqrt()), ln(g * u_sum.sqrt().sqrt()));
    let asymptote =
        |(factor, load, material): (f64, f64, f64)| factor.ln() + load * m + material * l;
    let h_ri = asymptote(RIGID_ISOVISCOUS);
    let h_ei = asymptote(ELASTIC_ISOVISCOUS);
    let h_rp = asymptote(RIGID_PIEZOVISCOUS);
    let h_ep = asymptote(ELASTIC_PIEZOVISCOUS);
    let s = (7.0 + 8.0 * exp(-2.0 * exp(h_ei - h_ri))) / 5.0;
    let isoviscous = exp(7.0 / 3.0 * h_ri) + exp(7.0 / 3.0 * h_ei);
    let piezoviscous = exp(-3.5 * h_rp) + exp(-3.5 * h_ep);
    let sum = exp(3.0 * s / 7.0 * ln(isoviscous)) + exp(-2.0 * s / 7.0 * ln(piezoviscous));
    exp(ln(sum) / s) * u_sum.sqrt() * r
}
