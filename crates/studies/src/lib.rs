//! Studies that run the gear mesh many times: [`compare`] compares finishes, [`callout`] limits the roughness of one, [`change`] relocates traces after a test on traces before it, [`running_in`] follows flanks over their engagements, [`map`] computes losses over torque, speed and
//! temperature, [`cycle`] integrates them over a driving cycle, [`export`] writes maps for other programs, [`sensitivity`]
//! changes one input at a time, [`sweep`] runs many cases in shards.
//!
//! It is used by the programs: `cli`, `python` and `web`. It does not know options of a command.
//!
#![doc = include_str!("../README.md")]

pub mod callout;
pub mod change;
pub mod compare;
pub mod cycle;
pub mod diff;
pub mod estimate;
pub mod export;
pub mod map;
mod registry;
pub mod ridges;
pub mod running_in;
pub mod sensitivity;
pub mod sweep;
