//! `report.html`: one page with the full result that needs no network.
//!
//! The page is drawn only from the result and its tables, so its numbers agree with them. Every chart is complete
//! without scripts.

mod along;
pub(crate) mod band;
mod checks;
mod contact;
mod facing;
mod flanks;
pub(crate) mod gearbox;
mod inputs;
mod load;
mod losses;
mod lubricated;
mod mesh;
mod micropitting;
pub(crate) mod overview;
mod page;
mod pairs;
mod patch;
mod path;
mod policy;
mod relief;
pub mod ridges;
mod scans;
mod temperatures;

pub use along::{along, on_flank, points};
use asperity_core::Fault;
pub use contact::drawings as drawings_of_contact;
pub use lubricated::{
    FilmAndPressure, FilmFrame, LubricatedContact, SharePoint, lubricated_contact,
};
pub use mesh::pair_in_mesh;
pub(crate) use page::{PageSection, page_of, source as source_line};
pub use page::{figure, page};
pub use policy::{policy, source};

use asperity::result::RunResult;
use maud::{Markup, html};

use crate::page_tables::PageTables;
use crate::scans::SECTION;

/// Renders the page of `result`, with the flanks and the mesh position of `tables`.
///
/// # Errors
/// When the result lacks a value that the page shows.
pub fn render(result: &RunResult, tables: &PageTables) -> Result<String, Fault> {
    let last = html! { (inputs::section(result)?) (facing::script()) };
    let section = |name, body, is_folded| PageSection {
        name,
        body,
        is_folded,
    };
    let chosen = contact::chosen(result, tables)?;
    let sections = [
        section("Summary", overview::section(result), false),
        section("What to check", checks::section(result), false),
        section(
            "Along the path of contact",
            path::section(result, tables),
            false,
        ),
        section(SECTION, scans::section(result), false),
        section(
            "Ridges with the largest loss",
            ridges::section(result),
            false,
        ),
        section(
            "One contact",
            contact::section(result, tables)?,
            chosen.is_none(),
        ),
        section("Flanks", flanks::section(result, tables), true),
        section("Uncertainty and other models", models(result), true),
        section("Inputs", last, true),
    ];
    let formulation = result.formulation.name();
    let file = result.case_file.as_deref().map(|file| format!(" · {file}"));
    let subtitle = format!(
        "{}{} · {} · formulation {formulation}{}",
        result.program,
        file.unwrap_or_default(),
        result.inputs.operation.in_words(),
        chosen.unwrap_or_default()
    );
    Ok(page_of(&result.title, &subtitle, None, &sections))
}

/// The draws of the loss, the loss by other models, and by published laws.
fn models(result: &RunResult) -> Markup {
    html! {
        @if let Some(uncertainty) = &result.uncertainty { (band::section(uncertainty)) }
        (overview::laws(result))
    }
}
