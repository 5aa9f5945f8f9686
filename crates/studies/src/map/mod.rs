//! Losses of a mesh, or of all meshes of a gear train, over torque, speed and temperature.
//!
//! Every point is identical to a run of the case at its torque, speed and temperature. The rough contact of a torque is
//! solved once for all speeds and temperatures, and once for meshes with equal windows under equal load; torques are
//! independent. Torque and speed are at the pinion, or at the input shaft of a gear train. The losses of a torque apply to the negative
//! torque as well, unless the case states coast flanks.
//!
//! | point | rule |
//! |---|---|
//! | torque 0 | only rolling: sliding loss vanishes with the torque |
//! | torque below the smallest resolved by the traces | sliding loss at that torque, scaled; marked `extended` |
//! | speed 0 | loss torque at 1 1/min |
//!
//! Median and quantiles of the loss come from draws at three torques and three speeds, see [`DrawnNodes`].
//!
//! ```
//! use asperity::case;
//! use asperity_studies::compare::Finish;
//! use asperity_studies::map::{Axes, MapBand, map};
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
//! })?;
//! let axes = Axes::new(&[-100.0, 100.0], &[1000.0, 9000.0], &[90.0])?;
//! let found = map(&[Finish { name: "ground".to_owned(), case }], &axes, MapBand::None, &|_, _| {})?;
//! // A node at no torque and one at standstill are added.
//! assert_eq!(found.axes.torque_nm, [-100.0, 0.0, 100.0]);
//! assert_eq!(found.axes.speed_rpm, [0.0, 1000.0, 9000.0]);
//! let surface = found.finishes[0].surface(&found.axes, 0).ok_or("a point has no result")?;
//! assert!(surface.loss_torque(50.0, 3000.0).value > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axes;
mod draws;
mod efficiency;
mod evaluation;
mod grid;
mod page;
mod point;
mod read;
mod report;
mod study;
mod summary;
mod surface;
mod table;

pub use axes::Axes;
pub(crate) use draws::{Beside, MapPlace};
pub use draws::{Drawn, DrawnNodes, MapBand};
pub(crate) use efficiency::efficiency;
pub use grid::map;
pub use page::loss_fields;
pub(crate) use page::{HELPFUL, are_extrapolated, marks, round_step};
pub use point::{
    EXTENDED, FinishMap, Map, MapGearbox, MapWarning, MeshPart, Numbers, Point, ranges,
};
pub use read::read;
pub use study::{CaseOrFinishes, MapSettings, MapStudy};
pub(crate) use summary::{against, banded, in_words, loss_with};
pub use surface::{Interpolated, Surface, forwards};
