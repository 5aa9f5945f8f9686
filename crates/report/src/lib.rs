//! Output of results: a folder of files, a page, and a summary for the terminal.
//!
//! It is used by `studies`, `calibration`, `paper-2022` and the programs. It does not know which studies exist, and runs nothing.
//!
//! All output is made from a [`RunResult`](asperity::result::RunResult) and its tables; nothing here runs the
//! pipeline.
//!
//! | to | use |
//! |---|---|
//! | write the folder of a run | [`write_folder`] |
//! | get its files in memory | [`texts`] |
//! | read a result back | [`read_result`] |
//! | draw its page | [`html::render`], [`redraw`] |
//! | print it in 80 columns | [`summary`] |
//! | say what a study found, for terminal, page and folder | [`Report`] |
//! | make a table of it | [`columns!`] |
//! | state the settings of a study once for all faces | [`settings!`], [`StudySettings`] |
//!
#![doc = include_str!("../README.md")]

pub mod axis;
mod blocks;
pub mod chart;
mod columns;
mod described;
mod error;
mod folder;
pub mod html;
pub mod library;
mod other_models;
mod page_tables;
mod printed;
pub mod profile_json;
mod results;
pub mod ridges;
mod scan_report;
pub mod scans;
mod settings;
mod study;
mod summary;
pub mod tables;
mod terms;
mod thin;
mod tiles;
pub mod units;
mod whole;
mod wrap;

pub use axis::Nodes;
pub use blocks::{LeftOut, OF_MESHES, Report};
pub use columns::{Cell, Column, Kind, Number, Table, Value};
pub use described::{Described, Input, StudySettings, Watch, Work, schema_of_settings};
pub use folder::{
    Fields, PAGE, make_folder, parse_result, read_result, read_whole, redraw, title_of,
    write_bytes, write_json, write_text, write_unsolved,
};
pub use page_tables::PageTables;
pub use printed::{duration, parts_of, stated, stated_parts};
pub use results::{Results, check_place, texts, write_folder, write_load_points};
pub use scan_report::with_scans;
pub use settings::{SchemaOf, Setting, Settings, Stated, schema_of, taken};
pub use study::StudyResult;
pub use summary::{
    besides_the_mesh, brief, headline, models, published_laws, summary, summary_within,
};
pub use terms::{TERMS, Term};
pub use thin::thin;
pub use tiles::{Tile, TileKind, tiles};
pub use wrap::{COLUMNS, wrapped, wrapped_within};
