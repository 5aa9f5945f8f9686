//! Energy lost in a mesh over a cycle, from its map.
//!
//! The cycle is torque and speed of the pinion over time, or the speed of a vehicle, whose forces then make both.
//! Loss torque is interpolated, never efficiency.
//!
//! ```text
//! T = F r_w/i,   ω = v i/r_w,   F = m λ dv/dt + ½ ρ c_d A v² + m g (f_r cos γ + sin γ)
//! E = Σ L(T, ω) ω Δt
//! ```
//!
//! Outside the map loss over torque is held, as [`Surface`](crate::map::Surface) has it; a cycle with more than 5 % of its
//! energy there is refused unless that is accepted.
//!
//! The torque of a vehicle is that of its resistances: the losses of the drive itself are left out of it.

mod coverage;
mod energy;
mod page;
mod summary;
mod trace;
mod write;

pub use coverage::{Coverage, Uncovered};
pub use energy::{CycleFinish, CycleResult, EnergyError, evaluate};
pub use summary::summary;
pub use trace::{Cycle, CycleError, CyclePoint, cycle};
pub use write::{check_place, write};
