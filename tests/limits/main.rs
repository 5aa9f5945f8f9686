//! Limits in which the whole program must give what a simpler statement says.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod band;
mod bulk;
mod cancelling;
mod cold_oil;
mod constant_friction;
mod equations_used;
mod friction_laws;
mod gear_train;
mod overrides;
mod placement;
mod positions;
mod regime;
mod sampling;
mod threads;
mod traces;
