//! Rough line contact of elastic half-planes: boundary elements, plasticity, subsurface stress.
//!
//! It is used by `ehl`, `mixed-film`, `case` and `asperity`. It does not know oil, gears or cases.
//!
//! Plane strain, pressures and loads per metre of face width. [`solve`] solves one problem, a [`Solver`]
//! many problems of one size, a [`Path`] a series of loads or positions. Every solution has a [`Certificate`]; a solution
//! outside of its tolerance is a [`ContactError`] that holds the certificate reached.
//!
//! | for | see |
//! |---|---|
//! | two measured profiles | [`two_flanks`] |
//! | a patch: a window with an extent along the lead | [`Lead`] |
//! | plastic flow of the surface, running-in | [`plasticity`], [`running_in`] |
//! | stress below the surface | [`subsurface`] |
//! | closed forms | [`hertz_line`], [`hertz_point`], [`westergaard`], [`flat_punch`] |
//! | the kernel and its fast product | [`strip_kernel`], [`half_plane`] |
//! | the dense solver, exact to round-off, and its gradient | `dense_reference` |
//! | files | [`array_file`] |
//!
#![doc = include_str!("../README.md")]

pub mod array_file;
pub mod boundary;
mod cells;
pub mod certificate;
mod convolution;
pub mod dense_reference;
pub mod error;
mod exact_sets;
pub mod flat_punch;
mod grid;
pub mod half_plane;
pub mod hertz_line;
pub mod hertz_point;
pub mod path;
pub mod plasticity;
pub mod problem;
mod rectangle_kernel;
pub mod running_in;
pub mod shakedown;
pub mod solver;
pub mod strip_kernel;
pub mod subsurface;
pub mod two_flanks;
pub mod westergaard;

pub use boundary::{Boundary, PeriodicKernel};
pub use cells::Lead;
pub use certificate::Certificate;
pub use error::{ContactError, SolverShape};
pub use path::Path;
pub use problem::{
    ContactProblem, ContactSolution, ContactWarning, Control, SUSPECT_GAP, SolverSettings,
};
pub use solver::{Solver, solve};
