//! The micropitting rating, and the measured flanks at the same positions.

use asperity::result::MicropittingReport;
use maud::{Markup, html};

/// The smallest specific film and all positions.
pub(super) fn section(report: &MicropittingReport) -> Markup {
    let [pinion, wheel] = report.ra_um;
    let text = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
    };
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
            "In addition, from the measured flanks at the same positions, which Ra does not describe: λ over the Rq of wavelengths below 0.08 mm, the load \
            on touching asperities, and at the first offset the pressure that 99 % of the touching points stay below and the share of the \
            nominal contact at the flow pressure. The columns do not combine to one rating."
        }
        div.scroll { table {
            thead { tr {
                th.number { "path [%]" } th.number { "p [MPa]" } th.number { "flash [K]" } th.number { "h [µm]" } th.number { "λ_GF" }
                th.number { "λ, Rq below 0.08 mm" } th.number { "on asperities [%]" } th.number { "99 % pressure [MPa]" }
                th.number { "flowing [%]" }
            } }
            tbody { @for cell in &report.cells { tr {
                td.number { (format!("{:.1}", 100.0 * cell.path_fraction)) }
                td.number { (format!("{:.0}", cell.pressure_mpa)) }
                td.number { (format!("{:.1}", cell.flash_k)) }
                td.number { (format!("{:.4}", cell.film_um)) }
                td.number { (format!("{:.3}", cell.lambda)) }
                td.number { (text(cell.lambda_short, 3)) }
                td.number { (text(Some(100.0 * cell.solid_share), 1)) }
                td.number { (text(cell.solid_pressure_99_mpa, 0)) }
                td.number { (text(cell.flowing_area.map(|area| 100.0 * area), 2)) }
            } } }
        } }
    }
}
