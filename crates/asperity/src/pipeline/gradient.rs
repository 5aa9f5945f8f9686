//! Gradient of the loss of a mesh over the heights of both traces.
//!
//! The heights act through the rough contacts and through the roughness that the inlets leave
//! ([`PositionFilm::gradient`](asperity_mixed_film::PositionFilm::gradient)). Contact sets, places of the windows, and the
//! relief are held. Kinks of the loss, where the gradient is one-sided: a cell that enters or leaves a contact, another cell
//! that becomes the highest of a peak of the pressure or the lowest between two peaks, two such valleys of equal pressure, the
//! first touch, a share at a row of the table, a slope of the gap that is held, a film at its floor.

use asperity_core::cite;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Temperature;
use rayon::prelude::*;

use super::bulk_temperature::rise_exponent;
use super::stages::{Stages, losses_with, numbered, sampled, warmed};
use crate::contacts::Contacts;
use crate::parameters::at_temperature;
use crate::result::Losses;
use asperity_case::case::{Formulation, LoadShareName, LoadedCase};
use asperity_case::error::{Error, PositionError};

/// Step of the difference quotient of the loss over the bulk temperature \[K\].
const TEMPERATURE_STEP: f64 = 0.1;

/// Gradient of the loss of a mesh over the heights of both traces.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LossGradient {
    /// Derivative of the loss over the height of each point of both prepared traces \[W/m\].
    pub by_height: [Vec<f64>; 2],
    /// The same of the loss at each offset of the traces: their mean is `by_height` \[W/m\].
    pub by_offset: Vec<[Vec<f64>; 2]>,
    /// The losses, from exact contacts.
    pub losses: Losses,
    /// Change of the loss with the equilibrium bulk temperature over its change at a held temperature; 1 with a stated
    /// temperature.
    pub heat_balance: f64,
    /// Sliding loss at positions whose contact the traces do not resolve \[W\]: it is left out of the gradient.
    pub unresolved_w: f64,
    /// The case with exact contacts and its number of offsets stated, at the bulk temperature as the case states it: its
    /// losses with other traces can be compared.
    pub case: LoadedCase,
    /// Its contacts.
    pub contacts: Contacts,
}

/// Gradient of the loss of a case over the heights of both prepared traces.
///
/// ```text
/// dP/dz = Σ_i w_i V_s,i f_i (1/K) Σ_k dμ_ik/dz / (1 − n (∂P/∂T) (T_b − T_oil)/P)      [Loss-gradient]
/// ```
///
/// The last factor belongs to a bulk temperature that follows from the loss, of which its rise is the power n.
///
/// # Errors
/// As [`losses`](super::losses), and when the loss is not from the default load share and film friction, or a flank has no
/// trace or several.
pub fn gradient(loaded: &LoadedCase) -> Result<LossGradient, Error> {
    gradient_of(loaded, None)
}

/// Gradient of the loss of a case with exact contacts that were computed before, for a case that differs in oil, speed,
/// temperature or constants only.
///
/// # Errors
/// As [`gradient`], and when the contacts belong to other flanks, gears or loads.
pub fn gradient_with(contacts: &Contacts, loaded: &LoadedCase) -> Result<LossGradient, Error> {
    gradient_of(loaded, Some(contacts))
}

fn gradient_of(loaded: &LoadedCase, known: Option<&Contacts>) -> Result<LossGradient, Error> {
    refuse(loaded).map_err(Box::new)?;
    let mut exact = loaded.clone();
    exact.case.laws.exact_contacts = true;
    let used = Provenance::new();
    let (sampled, contacts) = used.collect(|| sampled(&exact, known, &[]))?;
    let warm = warmed(&sampled, &contacts)?;
    let stages = Stages::of(&warm, &contacts, &|_, _| {}, used)?;
    let positions = stages.lubricated()?;
    let lubrication = stages.lubrication();
    let of_position = |at| {
        let row = stages.contacts.at(at)?;
        match row.iter().any(|contact| contact.window.is_some()) {
            true => lubrication.gradient(at, row).map(Some),
            false => Ok(None),
        }
    };
    let found: Vec<_> = stages.mesh.positions.par_iter().map(of_position).collect();
    let found = numbered(found)?;
    let unresolved = stages.mesh.positions.iter().zip(&positions).zip(&found);
    let unresolved_w = unresolved
        .filter(|(_, gradient)| gradient.is_none())
        .map(|((at, position), _)| {
            let forces = position.offsets.iter().map(|offset| offset.friction_force);
            at.weight * at.mean_sliding() * crate::assembly::mean(forces)
        })
        .sum();
    let losses = stages.summed(|| stages.solved(positions)?.losses())?;
    cite!("Loss-gradient");
    let heat_balance = heat_balance((&sampled, &warm), &contacts, &losses)?;
    let traces = warm.surfaces.traces().map_err(Box::new)?;
    let none = traces.map(|trace| vec![0.0; trace.len()]);
    let mut by_offset = vec![none.clone(); warm.case.model.offsets];
    for gradient in found.iter().flatten() {
        let of_all = by_offset.iter_mut().flatten().flatten();
        for (sum, one) in of_all.zip(gradient.iter().flatten().flatten()) {
            *sum += heat_balance * one;
        }
    }
    let mut by_height = none;
    for of_offset in &by_offset {
        let of_both = by_height.iter_mut().flatten();
        for (sum, one) in of_both.zip(of_offset.iter().flatten()) {
            *sum += one / by_offset.len() as f64;
        }
    }
    drop(stages);
    drop(warm);
    let contacts = contacts.into_owned();
    let mut case = sampled.into_owned();
    case.case.input.model.offsets = Some(case.case.model.offsets);
    Ok(LossGradient {
        by_height,
        by_offset,
        losses,
        heat_balance,
        unresolved_w,
        case,
        contacts,
    })
}

/// 1/(1 − n (∂P/∂T) (T_b − T_oil)/P) of a case as stated and at its bulk temperature.
fn heat_balance(
    (stated, warm): (&LoadedCase, &LoadedCase),
    contacts: &Contacts,
    losses: &Losses,
) -> Result<f64, Error> {
    let (Some(found), Some(law)) = (&warm.case.found_bulk, stated.case.bulk) else {
        return Ok(1.0);
    };
    let loss = |step: f64| {
        let bulk = Temperature::from_si(warm.case.temperature.si() + step);
        let losses = losses_with(contacts, &at_temperature(warm, bulk)?)?;
        Ok::<f64, Error>(losses.summary.loss_w)
    };
    let slope = (loss(TEMPERATURE_STEP)? - loss(-TEMPERATURE_STEP)?) / (2.0 * TEMPERATURE_STEP);
    let rise = rise_exponent(law) * (found.report.bulk_c - found.report.oil_c);
    Ok(1.0 / (1.0 - slope * rise / losses.summary.loss_w))
}

/// Refuses a loss that is not from the solved load share with the friction of its film.
///
/// # Errors
/// When [`gradient`] refuses the case.
pub fn refuse(loaded: &LoadedCase) -> Result<(), PositionError> {
    let (case, surfaces) = (&loaded.case, &loaded.surfaces);
    surfaces.check_one_pair()?;
    surfaces.traces()?;
    let model = &case.model;
    check_heights(loaded)?;
    let differs = if case.laws.is_any() {
        "a user-defined law"
    } else if case.model.load_share != LoadShareName::Solved {
        "model.load_share"
    } else if model.film_friction.shear_law().is_none() {
        "model.film_friction"
    } else if model.include_running_in {
        "model.include_running_in"
    } else {
        return Ok(());
    };
    Err(PositionError::NoGradient { differs })
}

/// Refuses the paper's formulation: away from its own case it can have no sliding loss, whatever the heights are.
///
/// # Errors
/// With the paper's formulation.
pub fn check_heights(loaded: &LoadedCase) -> Result<(), PositionError> {
    match loaded.case.formulation {
        Formulation::Corrected => Ok(()),
        Formulation::Paper => Err(PositionError::NoGradient {
            differs: "formulation = \"paper\"",
        }),
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::Profile;

    use super::gradient;
    use crate::pipeline::losses;
    use asperity_case::case::{LoadedCase, load_with};
    use asperity_case::flanks::Texture;

    /// Heights that are compared.
    const HEIGHTS: usize = 16;
    /// Points at the foot of the bumps.
    const BUMPS: [usize; 3] = [4, 7, 14];

    fn e_drive(settings: &[(&str, &str)]) -> LoadedCase {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let few = [("model.positions", "4"), ("model.offsets", "2")];
        let set = |input: &mut asperity_case::case::CaseInput| {
            for (key, value) in few.iter().chain(settings) {
                input.set(key, value).unwrap();
            }
        };
        load_with(file, &set).unwrap()
    }

    fn heights(case: &LoadedCase) -> [Vec<f64>; 2] {
        case.surfaces
            .textures()
            .each_ref()
            .map(|texture| match texture {
                Texture::Trace(trace) => trace.heights().to_vec(),
                Texture::Values { .. } => Vec::new(),
            })
    }

    /// Loss with other heights \[W\].
    fn loss(case: &LoadedCase, heights: [Vec<f64>; 2]) -> f64 {
        let [Texture::Trace(trace), _] = case.surfaces.textures() else {
            return f64::NAN;
        };
        let spacing = trace.spacing();
        let mut changed = case.clone();
        let traces = heights.map(|z| Profile::new(spacing, z).unwrap());
        changed.surfaces = changed.surfaces.with_traces(traces);
        losses(&changed).unwrap().summary.loss_w
    }

    /// Central difference of the loss along `shape` of a trace.
    fn quotient(case: &LoadedCase, body: usize, shape: &[(usize, f64)], step: f64) -> f64 {
        let at = |step: f64| {
            let mut moved = heights(case);
            for (i, one) in shape {
                moved[body][*i] += step * one;
            }
            loss(case, moved)
        };
        (at(step) - at(-step)) / (2.0 * step)
    }

    /// Relative error of `expected`, by the better of two steps: a cell that enters or leaves spoils the longer one, rounding
    /// the shorter one.
    fn error(case: &LoadedCase, body: usize, shape: &[(usize, f64)], expected: f64) -> f64 {
        let off = [1e-9, 5e-11].map(|step| quotient(case, body, shape, step) / expected - 1.0);
        off[0].abs().min(off[1].abs())
    }

    #[test]
    fn the_gradient_of_the_loss_is_its_central_difference() {
        let found = gradient(&e_drive(&[])).unwrap();
        assert_eq!((found.heat_balance, found.unresolved_w), (1.0, 0.0));
        let case = &found.case;
        let all = found.by_height.iter().flatten();
        let largest = all.fold(0.0, |m: f64, g| m.max(g.abs()));
        let mut errors = Vec::new();
        let mut k = 0_usize;
        while errors.len() < HEIGHTS {
            let body = k % 2;
            let i = (k * 7919) % found.by_height[body].len();
            k += 1;
            let expected = found.by_height[body][i];
            if expected.abs() < 0.01 * largest {
                continue;
            }
            errors.push(error(case, body, &[(i, 1.0)], expected));
        }
        errors.sort_by(f64::total_cmp);
        assert!(errors[HEIGHTS / 2] < 1e-6, "{errors:?}");
        assert!(errors[HEIGHTS - 1 - HEIGHTS / 16] < 2e-2, "{errors:?}");
        for (k, width) in BUMPS.into_iter().enumerate() {
            let body = k % 2;
            let points = found.by_height[body].len();
            let begin = (k * 104_729 + 900) % (points - width);
            let cosine = |j: usize| (std::f64::consts::TAU * j as f64 / width as f64).cos();
            let shape: Vec<(usize, f64)> = (0..=width)
                .map(|j| (begin + j, 0.5 * (1.0 - cosine(j))))
                .collect();
            let expected: f64 = shape
                .iter()
                .map(|(i, s)| found.by_height[body][*i] * s)
                .sum();
            let error = error(case, body, &shape, expected);
            assert!(error < 0.03, "{width} points from {begin}: {error}");
        }
    }

    #[test]
    fn the_gradient_includes_the_heat_balance_of_the_flanks() {
        let network = r#"{ law = "network", pinion_to_oil = "12 W/K", wheel_to_oil = "20 W/K" }"#;
        for law in [r#"{ law = "iso", lubrication = "jet" }"#, network] {
            let oil = [
                ("operation.oil_temperature", "70 °C"),
                ("operation.bulk", law),
            ];
            let found = gradient(&e_drive(&oil)).unwrap();
            assert!(
                (found.heat_balance - 1.0).abs() > 0.02,
                "{law}: {}",
                found.heat_balance
            );
            let z = heights(&found.case);
            let expected: f64 = (z.iter().flatten().zip(found.by_height.iter().flatten()))
                .map(|(z, by_height)| z * by_height)
                .sum();
            let at = |part: f64| {
                let scaled = z.clone().map(|z| z.iter().map(|z| part * z).collect());
                loss(&found.case, scaled)
            };
            let step = 2e-3;
            let quotient = (at(1.0 + step) - at(1.0 - step)) / (2.0 * step);
            // The equilibrium is iterated to 0.01 K: half of the last change of the temperature is missing.
            let error = quotient / expected - 1.0;
            assert!(error.abs() < 0.01, "{law}: {expected} W, {quotient} W");
        }
    }

    #[test]
    fn a_loss_that_is_not_of_the_default_model_has_no_gradient() {
        for (key, value) in [
            ("model.load_share", "lambda-star"),
            ("model.film_friction", "xu"),
            ("model.include_running_in", "true"),
        ] {
            let error = gradient(&e_drive(&[(key, value)])).unwrap_err();
            assert_eq!(error.code(), "E205", "{key}: {error}");
            assert!(error.to_string().contains(key), "{error}");
        }
    }
}
