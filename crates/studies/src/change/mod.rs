//! Traces of one place before and after a test: what was removed, what moved, and which parameters changed.
//!
//! ```
//! use asperity::core::{Profile, quantity::Length};
//! use asperity_report::{Settings, StudySettings, Watch};
//! use asperity_roughness::generate::{SelfAffine, truncated};
//! use asperity_studies::change::{ChangeSettings, TracePair, TracePairs};
//! let before = SelfAffine {
//!     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
//!     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
//! }.generate()?;
//! let after = truncated(&before, 0.1)?.0;
//! let pair = TracePair::new(["before.csv", "after.csv"], [before, after]);
//! let found = ChangeSettings::usual()?.run(TracePairs::new(vec![pair]), &Watch::SILENT)?;
//! assert!(found.mean.removed_nm.low > 5.0);
//! # Ok::<(), asperity::message::Fault>(())
//! ```

pub(crate) mod digits;
mod in_case;
mod pairs;
mod report;
mod study;
mod wear;
mod worth;

pub use in_case::{ChangeInCase, FlankChange, StateLoss, WornFlank};
pub use pairs::{TracePair, TracePairs};
pub use study::{ChangeSettings, CurveRow, Heights, PairRow, ParameterRow, TraceChange};
