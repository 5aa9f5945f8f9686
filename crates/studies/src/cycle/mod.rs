//! Energy lost in a mesh over a cycle, from its map.
//!
//! A cycle is torque and speed of the pinion over time, or the speed of a vehicle, from whose forces both follow. The loss
//! torque is interpolated, not the efficiency.
//!
//! ```text
//! T = F r_w/i,   ω = v i/r_w,   F = m λ dv/dt + ½ ρ c_d A v |v| + m g (f_r sgn(v) cos γ + sin γ)
//! E = Σ L(T, ω) ω Δt
//! ```
//!
//! Outside of the map the ratio of loss to torque is constant, see [`Surface`](crate::map::Surface). A cycle with more than
//! 5 % of its energy there is an error unless explicitly permitted.
//!
//! A negative speed is reverse. Driving and braking differ by the sign of the power T ω, and the map is evaluated at the same
//! power forwards.
//!
//! The torque of a vehicle follows from its resistances, without the losses of the drive.

mod coverage;
mod draws;
mod energy;
mod error;
mod report;
mod study;
mod trace;

pub use coverage::{Coverage, Uncovered};
pub use energy::{CycleFinish, CycleResult, evaluate};
pub use study::{CycleOnMap, CycleSettings};
pub use trace::{Cycle, CyclePoint, LARGEST_TABLE, cycle, named_cycle, read};
