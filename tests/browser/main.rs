//! The pages in a browser: every chart draws what its table holds, zoom works, numbers are those of the result, and
//! nothing is fetched. Skipped with a notice where there is no Chromium, unless `ASPERITY_BROWSER=required`.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests fail as tests do"
)]

#[path = "../cli/bench.rs"]
#[allow(
    dead_code,
    reason = "shared with the tests of the command, which use all of it"
)]
mod bench;
mod chromium;
mod compare;
mod extremes;
mod figures;
mod looks;
mod pages;
mod png;
mod report;
