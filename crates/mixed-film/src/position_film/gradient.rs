//! Gradient of the friction of a window over its heights, with the contact sets held.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | heights of the composite window | m |
//! | μ | friction coefficient, its film part scaled by s | - |
//! | g(φ), g_j | mean gap, at the shares of the table | m |
//! | h̄ | gap supplied | m |
//! | B | friction of the asperities (1 − β) μ_a + β μ_b, between two rows of the table with weights w_r | - |
//! | F | part of the film (1 − φ) μ_f in the friction, at the pressure of its share and of its ripple | - |
//! | L_j, P_j, Y_j | length of a part of the window, the pressure that flattens it, its height in the contact | -, Pa, m |
//! | c | rise of the surface temperature per friction coefficient | K |
//!
//! The friction follows from the heights in three ways: through the rough contact, whose gaps decide the share and whose
//! spots decide B, through σ_d and the height ȳ of the middle, which decide the supply, and through the ripple of the film.
//!
//! ```text
//! dφ = (dh̄ − Σ (∂g/∂g_j) dg_j)/(g′(φ) − h̄′(φ))
//! dμ = φ (1 + κ) Σ w_r dB_r + M dφ + (s + κ) [∂F/∂h̄ dh̄ + Σ_j (∂F/∂L_j dL_j + ∂F/∂P_j dP_j + ∂F/∂Y_j dY_j)]
//! M = (1 + κ) (B + φ Σ w_r′ B_r) + (s + κ) ∂F/∂φ
//! κ = c [s ∂F/∂T + φ ∂B/∂T]/(1 − c [∂F/∂T + φ ∂B/∂T])
//! dh̄/dσ_d = ∂h̄/∂(h_g Ψ) h_g Ψ (Ψ² − 1)/(Ψ² σ_d)
//! ```
//!
//! Each dg_j and dB_r is a linear function of the pressures of one contact, whose sets are held:
//! [`RoughContact`] returns its gradient from one factored system.

use std::ops::AddAssign;

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;
use asperity_tribo_friction::FilmHeat;
use serde::{Deserialize, Serialize};

use super::PositionFilm;
use crate::contact_table::{AtShare, ContactTable};
use crate::error::LoadShareError;
use crate::load_share_settings::InletSupply;
use crate::rough_contact::RoughContact;
use crate::spots::SpotConditions;
use crate::window_gap::gap_under;
use crate::window_roughness::WindowRoughness;

/// Slopes of the friction over gaps and spots of a contact.
struct RowScales {
    of_gap: f64,
    of_spots: f64,
    /// Rise of the surface temperature \[K\].
    rise: f64,
}

/// Step of the difference quotient of the friction over the surface temperature \[K\].
const TEMPERATURE_STEP: f64 = 0.02;
/// Relative step of the difference quotient of the supply over the share.
const SHARE_STEP: f64 = 1e-5;
/// Step of the difference quotients of the film's part over its share of the load.
const FILM_SHARE_STEP: f64 = 1e-4;
/// Step of those over the length of a part in its length, over gap and heights in the gap, and over the pressure that flattens
/// a part in Hertz pressures.
const RIPPLE_STEP: f64 = 1e-4;

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
    /// Over σ_d and the height of the middle of the window, through the supply \[1/m\].
    pub by_supply: [f64; 2],
    /// Over length, pressure \[1/Pa\] and height \[1/m\] of each part of the window's ripple.
    pub by_parts: Vec<[f64; 3]>,
}

impl PositionFilm<'_> {
    /// Kinks at or next to which a window is, known by its table.
    ///
    /// # Errors
    /// When σ_d is negative, a row of the table is needed and not solved, a spot has no film or an iteration does not end.
    pub fn kinks(
        &mut self,
        table: &ContactTable,
        window: &WindowRoughness,
    ) -> Result<Kinks, LoadShareError> {
        let supply = self.supply_of(self.inlet_factor(window.deviation)?, window)?;
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
    /// dμ/dz = Σ_r (∂μ/∂g_r ∂g_r/∂z + ∂μ/∂B_r ∂B_r/∂z) + ∂μ/∂h̄ (∂h̄/∂σ_d ∂σ_d/∂z + ∂h̄/∂ȳ ∂ȳ/∂z) + Σ_j ∂μ/∂(L_j, P_j, Y_j) ∂(L_j, P_j, Y_j)/∂z          [Share-gradient]
    /// ```
    ///
    /// The last sum, over the parts of the window, is in the coefficients of [`ShareGradient::by_parts`].
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
            by_supply: [0.0; 2],
            by_parts: Vec::new(),
        };
        let attenuated_rms = window.deviation;
        let psi = self.inlet_factor(attenuated_rms)?;
        let supply = self.supply_of(psi, window)?;
        let supply_slopes = self.supply_slopes(psi, window)?;
        let at = table.at_supply(&supply)?;
        let coefficient = self.share(table, window)?.value.coefficient;
        let c = if self.film.heat() == FilmHeat::Isothermal {
            0.0
        } else {
            self.film.surface_rise(1.0)
        };
        let rise = c * coefficient;
        let Some(at) = at else {
            let (share, gap) = (1.0, supply(0.0));
            let state = FilmState { share, gap, rise };
            let [_, slope] = self.film_part(window, state)?;
            let scale = film_scale + c * film_scale * slope / (1.0 - c * slope);
            let (by_gap, by_parts) = self.ripple_slopes(window, state, scale)?;
            gradient.by_supply = supply_slopes(0.0).map(|slope| by_gap * slope);
            gradient.by_parts = by_parts;
            return Ok(gradient);
        };
        let root = at.share.value;
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
        let state = FilmState {
            share: 1.0 - phi,
            gap: at.mean_gap().si(),
            rise,
        };
        let mut with_share = |step: f64| -> Result<f64, LoadShareError> {
            let share = (state.share + step).min(1.0);
            Ok(self.film_part(window, FilmState { share, ..state })?[0])
        };
        let step = FILM_SHARE_STEP.min(0.5 * phi).min(0.5 * (1.0 - phi));
        let by_film_share = (with_share(step)? - with_share(-step)?) / (2.0 * step);
        let [_, film_slope] = self.film_part(window, state)?;
        let mut heated = 0.0;
        if c > 0.0 {
            let at = |rise| Ok::<_, LoadShareError>(mean(asperities(&self.spot_conditions(rise))?));
            let step = TEMPERATURE_STEP;
            heated = (at(rise + step)? - at(rise - step)?) / (2.0 * step);
        }
        let slope = |film_scale: f64| film_scale * film_slope + phi * heated;
        let kappa = c * slope(film_scale) / (1.0 - c * slope(1.0));

        let by_asperities = phi * (1.0 + kappa);
        let (by_supply, by_parts) = self.ripple_slopes(window, state, film_scale + kappa)?;
        gradient.by_parts = by_parts;
        let by_share = (1.0 + kappa) * mean(of_rows) - (film_scale + kappa) * by_film_share;
        let mut m = factor * by_share + by_asperities * at.slope * spread;
        let (gap_slope, ..) = at.gap_slopes();
        // The share is held at its largest; the film is as thick as the gap there.
        let mut by_gap = -by_supply;
        if root < LARGEST_SHARE {
            let step = SHARE_STEP * root;
            let supply_slope = (supply(root + step) - supply(root - step)) / (2.0 * step);
            m += by_supply * supply_slope;
            by_gap = m / (gap_slope - supply_slope);
            let by_both = by_gap + by_supply;
            gradient.by_supply = supply_slopes(root).map(|slope| by_both * slope);
        }
        let scales = RowScales {
            of_gap: -by_gap,
            of_spots: by_asperities,
            rise,
        };
        self.add_rows(contact, &at, &scales, &mut gradient.by_height)?;
        Ok(gradient)
    }

    /// Slopes of the gap supplied to a window over its σ_d and the height of its middle, at a share.
    fn supply_slopes(
        &self,
        psi: f64,
        window: &WindowRoughness,
    ) -> Result<impl Fn(f64) -> [f64; 2] + use<>, LoadShareError> {
        let relative = self.inlet_slope(window.deviation, psi)?;
        let of_trace = self.supply_of(psi, &WindowRoughness::even(window.deviation))?;
        let middle = self.middle(window);
        let has_gap_of_middle = self.settings.supply == InletSupply::Rough;
        Ok(move |phi: f64| {
            let gap = of_trace(phi);
            let (_, [by_gap, by_middle]) = gap_under(gap, middle);
            [
                by_gap * gap * relative,
                if has_gap_of_middle { by_middle } else { 0.0 },
            ]
        })
    }

    /// Adds the gradients of the rows of the table over the heights: of their gaps, dg_j, and of their spots, dB_r.
    fn add_rows(
        &self,
        contact: &mut RoughContact,
        at: &AtShare<'_>,
        scales: &RowScales,
        by_height: &mut [f64],
    ) -> Result<(), LoadShareError> {
        let mut add = |heights: Vec<f64>| {
            for (sum, height) in by_height.iter_mut().zip(heights) {
                *sum += height;
            }
        };
        let (_, by_first_touch, by_rows) = at.gap_slopes();
        if scales.of_gap * by_first_touch != 0.0 {
            add(contact.first_touch_gradient(scales.of_gap * by_first_touch));
        }
        for (row, by_row) in by_rows {
            let of_gap = scales.of_gap * by_row;
            let pairs = at.rows.iter();
            let weight: f64 = pairs
                .filter(|(other, _)| std::ptr::eq(*other, row))
                .map(|(_, weight)| weight)
                .sum();
            if of_gap == 0.0 && weight == 0.0 {
                continue;
            }
            let state = row.of(contact)?;
            let conditions = self.spot_conditions(scales.rise);
            let mut of_spots = conditions.slopes(&state.spots, self.settings.boundary_friction)?;
            for slope in of_spots.iter_mut().flatten() {
                *slope *= scales.of_spots * weight;
            }
            add(contact.height_gradient(&state, of_gap, &of_spots)?);
        }
        Ok(())
    }

    /// Part of the film in the friction, and its slope over the surface temperature \[1/K\].
    fn film_part(
        &mut self,
        window: &WindowRoughness,
        state: FilmState,
    ) -> Result<[f64; 2], LoadShareError> {
        self.load_film(state.share, window, Length::from_si(state.gap))?;
        let friction = self.film.friction_at(state.rise)?;
        Ok(friction.map(|value| state.share * value))
    }

    /// Slopes of `scale` times the part of the film over the mean gap \[1/m\], and over length, pressure and height of each part
    /// of the ripple; zero of a film that does not ripple.
    fn ripple_slopes(
        &mut self,
        window: &WindowRoughness,
        state: FilmState,
        scale: f64,
    ) -> Result<(f64, Vec<[f64; 3]>), LoadShareError> {
        if !window.is_rippled() {
            return Ok((0.0, Vec::new()));
        }
        let steps = [
            RIPPLE_STEP * self.hertz.max_pressure.si(),
            RIPPLE_STEP * state.gap,
        ];
        let mut by_gap = 0.0;
        for side in [1.0, -1.0] {
            let gap = state.gap + side * steps[1];
            by_gap += side * self.film_part(window, FilmState { gap, ..state })?[0];
        }
        let mut moved = window.clone();
        let mut by_parts = Vec::with_capacity(window.ripple.len());
        for part in 0..window.ripple.len() {
            let mut slopes = [0.0; 3];
            let steps = [RIPPLE_STEP * window.ripple[part].length, steps[0], steps[1]];
            for (which, (slope, step)) in slopes.iter_mut().zip(steps).enumerate() {
                for side in [1.0, -1.0] {
                    let moved_part = &mut moved.ripple[part];
                    *match which {
                        0 => &mut moved_part.length,
                        1 => &mut moved_part.pressure,
                        _ => &mut moved_part.height,
                    } += side * step;
                    *slope += side * self.film_part(&moved, state)?[0];
                    moved.ripple[part] = window.ripple[part];
                }
                *slope *= scale / (2.0 * step);
            }
            by_parts.push(slopes);
        }
        Ok((scale * by_gap / (2.0 * steps[1]), by_parts))
    }
}

/// State of a film.
#[derive(Debug, Clone, Copy)]
struct FilmState {
    /// Share of the load.
    share: f64,
    /// Mean gap \[m\].
    gap: f64,
    /// Rise of the surface temperature \[K\].
    rise: f64,
}
