//! Traction curves of a machine with a contact at a point, such as ball and disc, and the oil constants behind them.
//!
//! | step | file |
//! |---|---|
//! | the oil with the distribution of its constants in the family | `base` |
//! | the machine | `machine` |
//! | traction over slide-to-roll ratio and speed | `traction` |
//! | readings of a machine, as table or export | `table`, `pcs_text`, `text`, `reading` |
//! | selection, fit, verdicts, further settings | [`selection`], [`problem`], [`fit`], `oil_fit`, `combination`, `helpful` |
//! | plan of measurements, for a case by its loss, and their simulation | `plan`, `grid`, `case_loss`, `simulate` |
//! | boundary friction from Stribeck curves | `stribeck` |
//! | the oil file | `written` |
//! | settings of the studies | `studies` |

mod base;
mod case_loss;
mod combination;
mod curves_report;
pub mod error;
pub mod fit;
mod fit_report;
mod grid;
mod helpful;
mod machine;
mod oil_fit;
mod pcs_text;
mod plan;
mod plan_report;
mod plan_study;
pub mod problem;
mod reading;
pub mod selection;
mod simulate;
mod stribeck;
mod stribeck_report;
mod studies;
mod table;
mod text;
mod traction;
mod written;

pub use base::{ConstantsOf, OilBase};
pub use combination::Combination;
pub use machine::{Machine, Setting};
pub use oil_fit::{FitSettings, FittedConstant, NuisanceTerm, OilFit, TractionPointRow};
pub use pcs_text::{Probe, is_pcs, read_pcs};
pub(crate) use plan::stages_of_case;
pub use plan::{ExpectedError, OilPlan, PlanSettings, PlannedCurve, PlannedPoint, Stage};
pub use reading::{Reading, SetPoint, set_points};
pub use simulate::simulated;
pub use stribeck::{BoundaryState, Stribeck, StribeckPoint};
pub use studies::{
    Curves, MeasuredOil, OfOil, OilFitSettings, OilOfCase, OilPlanSettings, PriorSettings,
    Specimens, StribeckSettings, TractionSettings,
};
pub use table::read_table;
pub use text::Readings;
pub(crate) use text::is_simulated_source;
pub use traction::{PredictedPoint, TractionCurves, TractionRange};
