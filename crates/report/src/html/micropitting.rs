//! The micropitting rating, and the measured flanks at the same positions.

use asperity::result::MicropittingReport;
use asperity_core::by_size;
use maud::{Markup, html};

use crate::{Cell, columns};

/// The smallest specific film and all positions.
pub(super) fn section(report: &MicropittingReport) -> Markup {
    let [pinion, wheel] = report.ra_um;
    html! {
        h3 { "Micropitting: specific film" }
        p {
            "Smallest λ_GF " (format!("{:.3}", report.lambda_min)) " at " (format!("{:.0} %", 100.0 * report.path_fraction))
            " of the path, " (report.place) ". Film and flash temperature by the form of ISO/TS 6336-22, as quoted by others; pressure, \
            speeds and friction from this run. Load factor " (format!("{:.2}", report.load_factor)) ", Ra "
            (format!("{pinion:.3} and {wheel:.3} µm")) ". "
            @match (report.permissible, report.safety) {
                (Some(permissible), Some(safety)) => {
                    "Over the user's permissible value " (format!("{permissible:.3}")) ": S_λ " (format!("{safety:.2}")) "."
                }
                _ => "No permissible value is stated, so there is no safety factor.",
            }
        }
        @if !report.outside.is_empty() {
            p { "Outside of the scope of the specification, so not a rating by it: " (report.outside.join("; ")) "." }
        }
        p {
            "The measured flanks give four more columns at the same positions, which Ra does not describe. They are λ over the Rq of \
            wavelengths below 0.08 mm, and the load on touching asperities. Two are of the first offset: 99 % of the touching points \
            stay below the pressure, and the share of the nominal contact is at the flow pressure. The columns do not combine to one \
            rating."
        }
        (columns! { cell in &report.cells;
            number path "path" "%" "{:.1}" = 100.0 * cell.path_fraction;
            number pressure_mpa "p" "MPa" "{:.0}";
            number flash_k "flash" "K" "{:.1}";
            number film_um "h" "µm" = Cell::number(cell.film_um, |um| by_size(um, 4));
            number lambda "λ_GF" "" "{:.3}";
            number lambda_short "λ, Rq below 0.08 mm" "" "{:.3}";
            number solid_share "on asperities" "%" "{:.1}" = 100.0 * cell.solid_share;
            number solid_pressure_99_mpa "99 % pressure" "MPa" "{:.0}";
            number flowing_area "flowing" "%" "{:.2}" = cell.flowing_area.map(|area| 100.0 * area);
        })
    }
}
