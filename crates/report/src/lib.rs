//! Output of results: a folder of files, a page, and a summary for the terminal.
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

pub mod chart;
mod error;
mod folder;
mod gear_train;
pub mod html;
pub mod library;
mod page_tables;
mod printed;
pub mod profile_json;
pub mod ridges;
mod study;
mod summary;
pub mod tables;
mod thin;
mod tiles;
pub mod units;
mod wrap;

pub use folder::{
    Fields, FileText, PAGE, check_place, make_folder, parse_result, read_result, redraw, texts,
    title_of, write_bytes, write_folder, write_json, write_load_points, write_text, write_unsolved,
};
pub use gear_train::{
    brief_of_train, check_train_place, summary_of_train, tables_of_train, texts_of_train,
    tiles_of_train, write_load_points_of_train, write_train,
};
pub use page_tables::PageTables;
pub use printed::{stated, stated_parts};
pub use study::StudyResult;
pub use summary::{
    besides_the_mesh, brief, headline, models, published_laws, summary, summary_within,
};
pub use thin::thin;
pub use tiles::{Tile, TileKind, tiles};
pub use wrap::{COLUMNS, wrapped, wrapped_within};
