//! Gradient of the friction of a window over its heights, with the contact sets held.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | heights of the composite window | m |
//! | μ | friction coefficient, its film part scaled by s | - |
//! | g(φ), g_j | mean gap, at the shares of the table | m |
//! | h̄ | gap supplied | m |
//! | B | friction of the asperities (1 − β) μ_a + β μ_b, between two rows of the table with weights w_r | - |
//! | c | rise of the surface temperature per friction coefficient | K |
//!
//! The friction follows from the heights in two ways: through the rough contact, whose gaps decide the share and whose
//! spots decide B, and through σ_d, which decides the supply.
//!
//! ```text
//! dφ = (dh̄ − Σ (∂g/∂g_j) dg_j)/(g′(φ) − h̄′(φ))
//! dμ = φ (1 + κ) Σ w_r dB_r + M dφ
//! M = (1 + κ) (B + φ Σ w_r′ B_r) − (s + κ) μ_f
//! κ = c [s (1 − φ) ∂μ_f/∂T + φ ∂B/∂T]/(1 − c [(1 − φ) ∂μ_f/∂T + φ ∂B/∂T])
//! dh̄/dσ_d = h̄ (Ψ² − 1)/(Ψ² σ_d)
//! ```
//!
//! Each dg_j and dB_r is a linear function of the pressures of one contact, whose sets are held:
//! [`RoughContact`] returns its gradient from one factored system.

use std::ops::AddAssign;

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;
use asperity_ehl_regime::{Attenuation, GapLaw, PairSpectrum, TraceSpectrum};
use asperity_tribo_friction::FilmHeat;
use serde::{Deserialize, Serialize};

use super::PositionFilm;
use crate::contact_table::ContactTable;
use crate::error::LoadShareError;
use crate::rough_contact::RoughContact;
use crate::spots::SpotConditions;
use crate::window_roughness::WindowRoughness;

/// Step of the difference quotient of the friction over the surface temperature \[K\].
const TEMPERATURE_STEP: f64 = 0.02;
/// Relative step of the difference quotient of the supply over the share.
const SHARE_STEP: f64 = 1e-5;

/// Change of the mean gap that counts as next to a kink \[m\]: heights that move by 1 nm move it by 1 nm at most.
const NEXT_TO: f64 = 1e-9;

/// Numbers of windows at or next to a kink of the friction over the heights, where a gradient holds for one side only.
/// "Next to" is 1 nm of mean gap.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Kinks {
    /// All windows.
    pub windows: usize,
    /// Windows whose flanks stay apart: their friction does not depend on the heights.
    pub apart: usize,
    /// Windows next to their first touch, touching or not.
    pub first_touch: usize,
    /// Windows next to a row of the contact table, between which the friction of the spots is interpolated.
    pub rows: usize,
    /// Windows between rows where the slope of the gap is limited.
    pub limited_slopes: usize,
    /// Windows at a floor: the gap of the largest share, or a spot whose film is thinner than the thinnest whose shear rate
    /// is computed.
    pub floors: usize,
}

impl AddAssign for Kinks {
    fn add_assign(&mut self, other: Self) {
        self.windows += other.windows;
        self.apart += other.apart;
        self.first_touch += other.first_touch;
        self.rows += other.rows;
        self.limited_slopes += other.limited_slopes;
        self.floors += other.floors;
    }
}

/// Change of the friction of a window with its roughness.
#[derive(Debug, Clone, PartialEq)]
pub struct ShareGradient {
    /// Over each height of the composite window, through the rough contact \[1/m\].
    pub by_height: Vec<f64>,
    /// Over σ_d of the window, through the supply \[1/m\].
    pub by_rms: f64,
}

impl PositionFilm<'_> {
    /// Gradient of a number over the heights of both whole traces, from its gradient over their heights as the inlet of this
    /// contact flattens them.
    ///
    /// ```text
    /// ∂J/∂z = A ∂J/∂z_d + (Σ ∂J/∂z_d dz_d/d ln n) d ln n/dz                 [Flattened-gradient]
    /// ```
    ///
    /// The second term is zero with the gap law `power`, whose flattening does not depend on the heights.
    ///
    /// # Errors
    /// When the film is not positive or a number is not finite.
    pub fn unflattened(
        &self,
        spectra: &[TraceSpectrum; 2],
        pair: &PairSpectrum,
        flattened: &[Vec<f64>; 2],
    ) -> Result<[Vec<f64>; 2], LoadShareError> {
        cite!("Flattened-gradient");
        let inlet = match self.gap_law {
            GapLaw::Power => None,
            GapLaw::Inlet => Some(self.inlet(pair)?),
        };
        let attenuation = match &inlet {
            Some(inlet) => inlet.attenuation,
            None => Attenuation::new(self.gap_law, self.nabla)?,
        };
        let mut by_scale = 0.0;
        let mut gradient = [Vec::new(), Vec::new()];
        for (body, of_body) in gradient.iter_mut().enumerate() {
            let spectrum = TraceSpectrum::new(&flattened[body], spectra[body].spacing())?;
            *of_body = spectrum.attenuated(&attenuation);
            let slopes = spectra[body].filtered(|wave| attenuation.slope(wave));
            by_scale += (flattened[body].iter().zip(slopes)).fold(0.0, |sum, (a, b)| sum + a * b);
        }
        if let Some(inlet) = inlet {
            let by_height = inlet.scale_gradient(pair, spectra.each_ref());
            for (of_body, by_height) in gradient.iter_mut().zip(by_height) {
                for (sum, d_log_scale) in of_body.iter_mut().zip(by_height) {
                    *sum += by_scale * d_log_scale;
                }
            }
        }
        Ok(gradient)
    }

    /// Kinks at or next to which a window is, known by its table.
    ///
    /// # Errors
    /// When σ_d is negative, a row of the table is needed and not solved, a spot has no film or an iteration does not end.
    pub fn kinks(
        &mut self,
        table: &ContactTable,
        window: &WindowRoughness,
    ) -> Result<Kinks, LoadShareError> {
        let supply = self.supply_of(self.inlet_factor(window.deviation)?)?;
        let is_next = |gap: Length, other: f64| (gap.si() - other).abs() < NEXT_TO;
        let mut kinks = Kinks {
            windows: 1,
            first_touch: usize::from(is_next(table.first_touch_gap(), supply(0.0))),
            ..Kinks::default()
        };
        let Some(at) = table.at_supply(&supply)? else {
            kinks.apart = 1;
            return Ok(kinks);
        };
        let gap = at.mean_gap();
        let mut rows = at.rows.iter();
        kinks.rows = usize::from(rows.any(|(row, _)| is_next(row.mean_gap, gap.si())));
        kinks.limited_slopes = usize::from(at.limits_a_slope());
        let rise = self.share(table, window)?.value.surface_rise;
        let conditions = self.spot_conditions(rise);
        let mut is_at_floor = at.share.value >= LARGEST_SHARE;
        for (row, _) in at.rows {
            is_at_floor |= conditions.limits_shear_rate(&row.spots)?;
        }
        kinks.floors = usize::from(is_at_floor);
        Ok(kinks)
    }

    /// Gradient of the friction coefficient over the roughness of a window, with the contact sets held; its film part is
    /// scaled by `film_scale`.
    ///
    /// ```text
    /// dμ/dz = Σ_r (∂μ/∂g_r ∂g_r/∂z + ∂μ/∂B_r ∂B_r/∂z) + ∂μ/∂h̄ ∂h̄/∂σ_d ∂σ_d/∂z          [Share-gradient]
    /// ```
    ///
    /// Zero where the flanks stay apart. `table` is the table of `contact`, whose rows next to the share are solved again.
    ///
    /// # Errors
    /// When σ_d is negative, a contact does not converge or an iteration does not end.
    pub fn gradient(
        &mut self,
        contact: &mut RoughContact,
        table: &ContactTable,
        window: &WindowRoughness,
        film_scale: f64,
    ) -> Result<ShareGradient, LoadShareError> {
        cite!("Share-gradient");
        let mut gradient = ShareGradient {
            by_height: vec![0.0; contact.points()],
            by_rms: 0.0,
        };
        let attenuated_rms = window.deviation;
        let psi = self.inlet_factor(attenuated_rms)?;
        let supply = self.supply_of(psi)?;
        let Some(at) = table.at_supply(&supply)? else {
            return Ok(gradient);
        };
        let root = at.share.value;
        let coefficient = self.share(table, window)?.value.coefficient;
        let is_isothermal = self.film.heat() == FilmHeat::Isothermal;
        let unit_rise = match is_isothermal {
            true => 0.0,
            false => self.film.surface_rise(1.0),
        };
        let rise = unit_rise * coefficient;
        let factor = self.settings.share_factor;
        let phi = factor * root;

        let boundary = self.settings.boundary_friction;
        let asperities = |conditions: &SpotConditions<'_>| -> Result<[f64; 2], LoadShareError> {
            let of = |row: usize| conditions.friction(&at.rows[row].0.spots);
            Ok([of(0)?.total(boundary), of(1)?.total(boundary)])
        };
        let weights = at.rows.map(|(_, weight)| weight);
        let mean = |of_rows: [f64; 2]| weights[0] * of_rows[0] + weights[1] * of_rows[1];
        let of_rows = asperities(&self.spot_conditions(rise))?;
        let spread = of_rows[1] - of_rows[0];
        let [film, film_slope] = self.film.friction_at(rise)?;
        let mut heated = 0.0;
        if unit_rise > 0.0 {
            let at = |rise| Ok::<_, LoadShareError>(mean(asperities(&self.spot_conditions(rise))?));
            let step = TEMPERATURE_STEP;
            heated = (at(rise + step)? - at(rise - step)?) / (2.0 * step);
        }
        let slope = |film_scale: f64| film_scale * (1.0 - phi) * film_slope + phi * heated;
        let feedback = unit_rise * slope(film_scale) / (1.0 - unit_rise * slope(1.0));

        let by_asperities = phi * (1.0 + feedback);
        let by_root = factor * ((1.0 + feedback) * mean(of_rows) - (film_scale + feedback) * film)
            + by_asperities * at.slope * spread;
        let (gap_slope, by_first_touch, by_rows) = at.gap_slopes();
        let mut by_gap = 0.0;
        if root < LARGEST_SHARE {
            let step = SHARE_STEP * root;
            let supply_slope = (supply(root + step) - supply(root - step)) / (2.0 * step);
            by_gap = by_root / (gap_slope - supply_slope);
            if attenuated_rms.si() > 0.0 {
                let part = 1.0 - 1.0 / (psi * psi);
                gradient.by_rms = by_gap * supply(root) * part / attenuated_rms.si();
            }
        }
        let mut add = |heights: Vec<f64>| {
            for (sum, height) in gradient.by_height.iter_mut().zip(heights) {
                *sum += height;
            }
        };
        if by_gap * by_first_touch != 0.0 {
            add(contact.first_touch_gradient(-by_gap * by_first_touch));
        }
        for (row, by_row) in by_rows {
            let of_gap = -by_gap * by_row;
            let pairs = at.rows.iter();
            let weight: f64 = pairs
                .filter(|(other, _)| std::ptr::eq(*other, row))
                .map(|(_, weight)| weight)
                .sum();
            if of_gap == 0.0 && weight == 0.0 {
                continue;
            }
            row.start(contact);
            let state = contact.at(row.asperity_share)?;
            let mut of_spots = self.spot_conditions(rise).slopes(&state.spots, boundary)?;
            for slope in of_spots.iter_mut().flatten() {
                *slope *= by_asperities * weight;
            }
            add(contact.height_gradient(&state, of_gap, &of_spots)?);
        }
        Ok(gradient)
    }
}
