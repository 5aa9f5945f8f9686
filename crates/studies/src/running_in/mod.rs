//! Running-in of flanks: roughness, film and loss over engagements, by plastic flow and mild wear, at one torque or several.
//!
//! ```
//! use asperity::case;
//! use asperity_report::{Settings, StudySettings, Watch};
//! use asperity_studies::running_in::RunningInSettings;
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
//! })?;
//! let settings = RunningInSettings { engagements: 1e4, ..RunningInSettings::usual()? };
//! let found = settings.run(case, &Watch::SILENT)?;
//! let course = &found.courses[0];
//! assert!(course.factor.value < 1.0 && course.rows[0].engagements == 0.0);
//! # Ok::<(), asperity::message::Fault>(())
//! ```

mod clock;
mod course;
mod flanks;
#[cfg(test)]
mod made_pairs;
mod report;
mod study;

pub use course::{Course, CourseRow};
pub use study::{RunningInFound, RunningInSettings, TestPair};
