//! The book and the other documents: links, words, formulas, commands, case files and pictures hold.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests may panic"
)]

mod blocks;
mod chapters;
mod generated;
mod how_it_works;
mod links;
mod numbers;
mod pictures;
mod spelling;
mod units;
