//! Errors of a call-out.

use asperity::result::loss_band::rounded;
use asperity_core::{Code, Fault};
use asperity_roughness::RoughnessError;

/// Uncertainty of a printed loss over it: the lots of the curve.
const CURVE_ERROR: f64 = 0.01;

/// A loss with the digits that the number of simulated pairs leaves.
pub(super) fn watts(loss_w: f64) -> String {
    format!("{} W", rounded(loss_w, CURVE_ERROR * loss_w))
}

/// Smooth flanks lose more than the stated loss.
pub(crate) fn below_smooth(loss_w: f64, smooth_w: f64) -> Fault {
    Fault::new(
        Code::E323,
        format!(
            "no finish reaches {}: smooth flanks (Ra 0.01 um) lose {}. State a higher loss, or change oil, speed or gears",
            watts(loss_w),
            watts(smooth_w)
        ),
    )
}

/// The roughest flanks lose less than the stated loss.
pub(crate) fn above_rough(loss_w: f64, rough_w: f64, ra_um: f64, smooth_w: f64) -> Fault {
    Fault::new(
        Code::E323,
        format!(
            "no limit is needed for {}: flanks of this recipe with Ra {:.1} um, the roughest considered, lose {}, and smooth ones {}. \
         State a loss between these",
            watts(loss_w),
            ra_um,
            watts(rough_w),
            watts(smooth_w)
        ),
    )
}

/// No recipe can be fitted to the traces, or a flank of it has no parameter.
pub(crate) fn of_recipe(error: RoughnessError) -> Fault {
    Fault::from_cause(Code::E120, error).about("the recipe of the flanks")
}
