//! The command as its users meet it: every message, every transcript of the documents, every promise
//! about files and threads. All through the real program, in a folder of its own.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests may panic"
)]

#[cfg(unix)]
mod archive;
mod bench;

mod bulk;
mod calibrate;
mod callout;
mod case_commands;
mod case_messages;
mod change;
mod changed_digit;
mod codes;
mod contact;
mod dialects;
mod doubtful_traces;
mod ehl;
mod evidence;
mod faces;
mod file_messages;
mod first_screens;
mod fuzz;
mod gallery;
mod gear;
mod gearbox;
mod instrument_files;
mod kills;
mod map;
mod micropitting;
mod mutated;
mod new_case;
#[cfg(unix)]
mod odd_files;
mod oil;
mod oil_file;
mod other_programs;
mod outside;
mod pages;
mod presets;
mod profile_reports;
mod ranges;
mod relief;
mod result_messages;
mod results;
mod review_cases;
mod rexs;
mod ridges;
mod same_case;
mod sensitivity;
mod several_traces;
mod single_modules;
mod stale;
mod storage;
mod surfaces;
mod sweep;
mod threads;
mod transcripts;
mod variants;
