//! `report.html`: one page with the full result that needs no network.
//!
//! The page is drawn only from the result and its tables, so its numbers agree with them. Every chart is complete
//! without scripts.

mod along;
mod band;
mod contact;
mod facing;
mod flanks;
mod gearbox;
mod inputs;
mod load;
mod losses;
mod lubricated;
mod mesh;
mod micropitting;
mod overview;
mod page;
mod pairs;
mod path;
mod policy;
mod relief;
mod temperatures;

pub use contact::drawings as drawings_of_contact;
pub use lubricated::{
    FilmAndPressure, FilmFrame, LubricatedContact, SharePoint, lubricated_contact,
};
pub use page::{figure, page};
pub use policy::{policy, source};

use asperity::case::Formulation;
use asperity::result::RunResult;

use crate::error::ReportError;
use crate::page_tables::PageTables;

/// Renders the page of `result`, with the flanks and the mesh position of `tables`.
///
/// # Errors
/// When the result lacks a value that the page shows.
pub fn render(result: &RunResult, tables: &PageTables) -> Result<String, ReportError> {
    let sections = [
        ("Summary", overview::section(result)),
        ("In mesh", facing::section(result, tables)),
        ("Along the path of contact", path::section(result, tables)),
        ("In the contact", contact::section(result, tables)?),
        ("Flanks", flanks::section(result, tables)),
        ("Inputs", inputs::section(result)?),
    ];
    let formulation = match result.formulation {
        Formulation::Paper => "paper",
        _ => "corrected",
    };
    let subtitle = format!("{} · formulation {formulation}", result.program);
    Ok(page(&result.title, &subtitle, &sections))
}
