//! Traction curves of a machine with a contact at a point, such as ball and disc, and the oil constants behind them.
//!
//! | step | file |
//! |---|---|
//! | the oil with the distribution of its constants in the family | `base` |
//! | the machine | `machine` |
//! | traction over slide-to-roll ratio and speed | `traction` |

mod base;
mod error;
mod machine;
mod page;
mod traction;

pub use base::OilBase;
pub use error::OilError;
pub use machine::{Machine, Setting};
pub use traction::{PredictedPoint, TractionCurves, TractionRange};
