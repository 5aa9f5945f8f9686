//! Page of a study of ridges: the costliest ridges, both traces coloured by the loss, and the loss by wavelength.

use asperity::result::ridges::Ridges;
use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::html::ridges::{charts, table};
use asperity_report::html::{figure, page};
use asperity_report::ridges::{NOTE, notes, saving, watts};
use maud::html;

use super::summary::{headline, wavelengths};

pub(super) fn render(study: &Ridges) -> String {
    let costliest = html! {
        p { strong { (saving(study)) "." } }
        p { (NOTE) }
        @for note in notes(study) { p { (note) } }
        div.charts { (figure(&ridge_chart(study))) }
        (table(&study.rows))
    };
    let traces = charts(study, None);
    let octaves = html! { div.charts { (figure(&octave_chart(study))) } };
    let sections = [
        ("Ridges with the largest loss", costliest),
        ("Where the loss is made", traces),
        ("By wavelength", octaves),
    ];
    page(
        &study.title,
        &format!("ridges · {}", headline(study)),
        &sections,
    )
}

fn ridge_chart(study: &Ridges) -> Drawing {
    let bars = study.rows.iter().map(|row| Bar {
        name: format!("{} at {:.3} mm", row.flank, row.place_mm),
        value: Some(row.first_order_w),
        spread: None,
        text: format!("{} W", watts(row.first_order_w)),
    });
    Drawing::Bars(BarChart {
        id: "ridges".to_owned(),
        title: "Saving by each ridge, first order of the gradient".to_owned(),
        source: "ridges.csv".to_owned(),
        axis: Axis::new("saving", "W"),
        bars: bars.collect(),
    })
}

fn octave_chart(study: &Ridges) -> Drawing {
    let bars = study.octaves.iter().map(|octave| {
        let both = octave.pinion_w + octave.wheel_w;
        Bar {
            name: format!("{} µm", wavelengths(octave)),
            value: Some(both),
            spread: None,
            text: format!("{} W", watts(both)),
        }
    });
    Drawing::Bars(BarChart {
        id: "octaves".to_owned(),
        title: "Loss over the logarithm of the heights, both flanks".to_owned(),
        source: "octaves.csv".to_owned(),
        axis: Axis::new("d(loss)/d ln(height)", "W"),
        bars: bars.collect(),
    })
}
