//! Sensitivity of the loss of a case to the constants of its oil.

use asperity::uncertainty::few_offsets_of;
use asperity::{Contacts, LoadedCase, Run, TrainLosses};
use asperity_core::Fault;
use asperity_core::task::try_par_map;
use nalgebra::DVector;

use super::base::{ConstantsOf, OilBase};
use super::problem::{CONSTANTS, Priors, TractionProblem, Zero};

/// Step of a constant, in standard deviations of its prior.
const STEP: f64 = 0.1;

/// Derivatives of the logarithm of the loss of `case` by the constants of its oil, in standard deviations of `priors`, with its
/// contacts if they are known.
///
/// # Errors
/// When the film friction of the case has no shear stress, or a contact has no solution.
pub(super) fn loss_slopes(
    case: &LoadedCase,
    known: Option<&Contacts>,
    priors: Priors,
) -> Result<[f64; CONSTANTS], Fault> {
    let oil = OilBase::of_case(case, ConstantsOf::File)?;
    let named = |source: asperity::Error| Fault::from(source).about(&oil.name);
    // Losses of a mesh with new flanks.
    let case = case.with(|input| (input.operation.running_in, input.gearbox) = (None, None));
    let case = case.map_err(named)?;
    let contacts = match known {
        Some(known) => known.clone(),
        None => Run::new(&case).contacts().map_err(named)?.swap_remove(0),
    };
    // A slope of ln loss needs fewer windows than a loss: those of a change. On e-drive, fzg-c and table2 all windows move the intervals
    // expected of traction curves by at most 3e-4 of themselves.
    let (case, contacts) = &few_offsets_of(&case, &contacts).map_err(named)?;
    let law = oil.rheology.laws().1;
    let problem = TractionProblem::new(&oil, law, priors, Zero::None, &[]);
    let log_loss = |k: usize, step: f64| -> Result<f64, Fault> {
        let mut x = DVector::zeros(problem.variables());
        x[k] = step;
        let constants = *problem.rheology(&x)?.constants();
        let moved = case.overridden(|over| over.film_constants = Some(constants));
        let moved = moved.map_err(named)?;
        let run = Run::new(&moved).known([contacts]).coldest();
        let losses = run.losses().and_then(TrainLosses::into_only);
        let summary = losses.map_err(named)?.summary;
        Ok((summary.sliding_w + summary.rolling_w).ln())
    };
    let slope = |k: usize| -> Result<f64, Fault> {
        Ok((log_loss(k, STEP)? - log_loss(k, -STEP)?) / (2.0 * STEP))
    };
    let slopes = try_par_map(0..CONSTANTS, slope)?;
    Ok(std::array::from_fn(|k| slopes[k]))
}
