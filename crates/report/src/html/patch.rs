//! The contact of a patch: pressure and loss over rolling and lead.

use maud::{Markup, html};

use crate::chart::{Axis, Contour, Drawing};
use crate::tables::PatchTable;

/// Width of the box of a chart in units of the drawing, about.
const BOX: f64 = 480.0;
/// Least and largest height of the box.
const HEIGHTS: [f64; 2] = [120.0, 420.0];
/// Bands of the losses of spots.
const BANDS: i32 = 7;

/// Explanation of the pictures of a patch.
pub(super) fn words(patch: &PatchTable) -> Markup {
    let [wide, long] = extents(patch);
    html! {
        p {
            "Patches of the scans are in contact, of which " (format!("{wide:.0} by {long:.0}")) " µm are shown. An asperity contact is a peak of \
             the pressure of the asperities; where the flanks stay apart, the picture of the contacts is blank. The costliest tenth of \
             the " (patch.spots) " contacts makes " (format!("{:.0}", 100.0 * patch.costliest_tenth)) " % of the loss of all. The other \
             charts of this section are of the middle row of each scan, solved as a line."
        }
    }
}

/// Largest pressure on the patch \[MPa\].
pub(super) fn largest_pressure(patch: &PatchTable) -> f64 {
    largest(&patch.pressure_mpa)
}

/// Pressure on the patch, and its spots coloured by their loss.
pub(super) fn drawings(patch: &PatchTable, source: &str) -> Vec<Drawing> {
    let losses = patch.spot_loss_mw.iter();
    let losses = losses.map(|loss| if *loss > 0.0 { *loss } else { f64::NAN });
    let field = |[id, title, value]: [&str; 3], values: Vec<f64>, levels| {
        let [wide, long] = extents(patch);
        Drawing::Contour(Contour {
            id: id.to_owned(),
            title: title.to_owned(),
            source: source.to_owned(),
            x: Axis::new("along rolling, from the middle of the contact", "µm"),
            y: Axis::new("along the lead", "µm"),
            value: value.to_owned(),
            columns: patch.x_um.clone(),
            rows: patch.lead_um.clone(),
            values,
            levels,
            height: (BOX * long / wide).clamp(HEIGHTS[0], HEIGHTS[1]),
            is_of_cells: true,
            ..Contour::default()
        })
    };
    vec![
        field(
            [
                "patch-pressure",
                "Pressure on the patch, asperities and film",
                "pressure [MPa]",
            ],
            patch.pressure_mpa.clone(),
            None,
        ),
        field(
            [
                "patch-losses",
                "Asperity contacts of the patch, coloured by the loss of each",
                "loss of the contact [mW]",
            ],
            losses.collect(),
            Some(levels(largest(&patch.spot_loss_mw))),
        ),
    ]
}

/// Extents of the cells along rolling and along the lead \[µm\].
fn extents(patch: &PatchTable) -> [f64; 2] {
    [&patch.x_um, &patch.lead_um].map(|places| match (&places[..], places.last()) {
        ([first, .., before, _], Some(last)) => 2.0 * last - first - before,
        _ => 1.0,
    })
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// Edges of the bands: zero and round numbers, each about a third of the next, up to the largest value.
fn levels(largest: f64) -> Vec<f64> {
    if largest <= 0.0 {
        return vec![0.0];
    }
    // 1, 3, 10, 30, ...; a quotient of whole numbers is the nearest to a decimal fraction.
    let number = |k: i32| {
        let (lead, power) = (
            if k.rem_euclid(2) == 0 { 1.0 } else { 3.0 },
            k.div_euclid(2),
        );
        if power < 0 {
            lead / 10_f64.powi(-power)
        } else {
            lead * 10_f64.powi(power)
        }
    };
    let mut last = (2.0 * largest.log10()).ceil() as i32;
    while number(last) > largest {
        last -= 1;
    }
    let edges = (last + 2 - BANDS..=last).map(number);
    std::iter::once(0.0).chain(edges).collect()
}

#[cfg(test)]
mod tests {
    use super::levels;

    #[test]
    fn bands_of_losses_end_below_the_largest() {
        assert_eq!(levels(40.0), [0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0]);
        assert_eq!(levels(0.3)[6], 0.3);
        assert_eq!(levels(0.0), [0.0]);
    }
}
