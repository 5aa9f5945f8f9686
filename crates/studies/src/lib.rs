//! Studies that run the gear mesh many times: [`compare`] sets finishes side by side, [`map`] spreads the losses over
//! torque, speed and temperature, [`cycle`] drives on it, [`export`] writes it for other programs, [`sensitivity`] changes
//! one thing at a time, [`sweep`] runs studies in shards, [`figures`] makes the figures of the 2022 paper.

pub mod compare;
pub mod cycle;
pub mod diff;
pub mod estimate;
pub mod export;
pub mod figures;
pub mod map;
pub mod sensitivity;
pub mod sweep;
