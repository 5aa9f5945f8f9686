//! Studies that run the gear mesh many times: [`compare`] sets finishes side by side, [`figures`] makes
//! the figures of the 2022 paper.

pub mod compare;
pub mod diff;
pub mod estimate;
pub mod figures;
