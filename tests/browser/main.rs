//! The pages in a browser: every chart draws, zoom works, numbers are those of the result, and
//! nothing is fetched. Skipped with a notice where there is no Chromium.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests fail as tests do"
)]

mod chromium;
mod compare;
mod figures;
mod report;
