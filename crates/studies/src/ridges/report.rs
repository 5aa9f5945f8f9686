//! Report of a study of ridges: the saving, the costliest ridges, both traces coloured by the loss, and the loss by wavelength.

use asperity::result::loss_band::{rounded, without_interval};
use asperity::result::ridges::{FlankWatts, Kinks, OctaveRow, Ridges};
use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::html::ridges::{charts, table};
use asperity_report::ridges::{NOTE, certain, notes, saving_of, verdict, watts};
use asperity_report::tables::BODIES;
use asperity_report::{Report, StudyResult, Table, columns};
use serde::Serialize;

use super::study::RidgeStudy;

/// Table of the ridges.
const TABLE: &str = "ridges.csv";
/// Table of the octaves of wavelength.
const OCTAVES: &str = "octaves.csv";

impl StudyResult for RidgeStudy {
    const KIND: &'static str = "study of ridges";
    const NAME: &'static str = "ridges";

    fn report(&self) -> Report<'_> {
        let study = &self.found;
        let mut report = Report::new(&study.title, "ridges")
            .section("Where the loss is made")
            .verdict([verdict(study)])
            .verdict(certain(study))
            .markup(|| charts(study, None))
            .text([headline(study)])
            .at(&study.conditions)
            .section("Ridges with the largest loss")
            .figures(|| [ridge_chart(study)])
            .table(table((1..).zip(&study.rows)).of_file(TABLE))
            .section("By wavelength")
            .figures(|| [octave_chart(study)])
            .text([OF_WAVELENGTHS])
            .heading("d(loss)/d ln(height) by wavelength")
            .table(octaves(study))
            .method([NOTE])
            .method(notes(study))
            .method(kinks(&study.kinks))
            .rows(TABLE, || &study.rows)
            .rows(OCTAVES, || &study.octaves);
        for (name, flank) in BODIES.iter().zip(&self.flanks) {
            report = report.rows(format!("{name}.csv"), || points(flank));
        }
        for (name, flank) in BODIES.iter().zip(&self.measured) {
            if let Some(flank) = flank {
                report = report.rows(format!("{name}_measured.csv"), || measured_points(flank));
            }
        }
        report
    }
}

/// Meaning of the loss by wavelength.
const OF_WAVELENGTHS: &str =
    "A value of 100 W means: 1 % more height of both flanks at these wavelengths adds 1 W.";

fn ridge_chart(study: &Ridges) -> Drawing {
    let mut rows: Vec<_> = study.rows.iter().enumerate().collect();
    rows.sort_by(|(_, a), (_, b)| b.mean_gradient_w.total_cmp(&a.mean_gradient_w));
    let bars = rows.into_iter().map(|(k, row)| Bar {
        name: format!("{}: {} at {:.3} mm", k + 1, row.flank, row.place_mm),
        value: Some(row.mean_gradient_w),
        spread: row.low_w.zip(row.high_w).map(|(low, high)| [low, high]),
        text: format!("{} W", saving_of(row)),
    });
    Drawing::Bars(BarChart {
        id: "ridges".to_owned(),
        title: "Saving by each ridge, pressed with all others".to_owned(),
        source: TABLE.to_owned(),
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
        title: "Change of the loss over the relative change of the heights, both flanks".to_owned(),
        source: OCTAVES.to_owned(),
        axis: Axis::new("d(loss)/d ln(height)", "W"),
        bars: bars.collect(),
    })
}

fn octaves(study: &Ridges) -> Table {
    let table = columns! { octave in &study.octaves;
        shown wavelengths "wavelengths" "µm" = wavelengths(octave);
        number pinion_w "pinion" "W" = watts(octave.pinion_w);
        number wheel_w "wheel" "W" = watts(octave.wheel_w);
    };
    table.of_file(OCTAVES)
}

/// The line about kinks of the loss; `None` if the windows were not counted.
fn kinks(kinks: &Kinks) -> Option<String> {
    let Kinks {
        windows,
        apart,
        first_touch,
        rows,
        limited_slopes,
        floors,
    } = kinks;
    (*windows > 0).then(|| {
        format!(
            "Kinks of the loss, of {windows} windows, each a position with an offset: {apart} are apart, {first_touch} next to first touch, {rows} next to a row of \
            the contact table. With a limited slope of the gap: {limited_slopes}; at a floor: {floors}. Next to means within 1 nm of \
            mean gap."
        )
    })
}

fn headline(study: &Ridges) -> String {
    let loss = without_interval(study.loss_at_medians_w);
    let of_percent = rounded(
        0.01 * study.by_log_height_w,
        0.001 * study.by_log_height_w.abs(),
    );
    format!(
        "Loss {loss} W at the medians of all constants; 1 % more height of both flanks adds {of_percent} W."
    )
}

fn wavelengths(octave: &OctaveRow) -> String {
    match octave.to_um {
        Some(to) => format!("{} to {}", short(octave.from_um), short(to)),
        None => format!("above {}", short(octave.from_um)),
    }
}

fn short(um: f64) -> String {
    format!("{um:.1}").trim_end_matches(".0").to_owned()
}

/// A point of a measured trace.
#[derive(Serialize)]
struct MeasuredRow {
    x_mm: f64,
    height_um: f64,
    /// d(loss)/d(height) per length of the trace.
    loss_w_per_um_mm: f64,
}

fn measured_points(flank: &FlankWatts) -> impl Iterator<Item = MeasuredRow> {
    let dx = flank.trace.spacing().si();
    let both = flank.trace.heights().iter().zip(&flank.by_height);
    both.enumerate()
        .map(move |(i, (z, by_height))| MeasuredRow {
            x_mm: 1e3 * dx * i as f64,
            height_um: 1e6 * z,
            loss_w_per_um_mm: 1e-9 * by_height / dx,
        })
}

/// A point of a prepared trace.
#[derive(Serialize)]
struct RidgePointRow {
    x_mm: f64,
    height_um: f64,
    /// d(loss)/d(height) per length of the trace.
    loss_w_per_um_mm: f64,
    /// Height above the mean line times it.
    loss_w_per_mm: f64,
}

fn points(flank: &FlankWatts) -> impl Iterator<Item = RidgePointRow> {
    let dx = flank.trace.spacing().si();
    let both = flank.trace.heights().iter().zip(&flank.by_height);
    let both = both.zip(flank.watts_per_length()).enumerate();
    both.map(move |(i, ((z, by_height), watts))| RidgePointRow {
        x_mm: 1e3 * dx * i as f64,
        height_um: 1e6 * z,
        loss_w_per_um_mm: 1e-9 * by_height / dx,
        loss_w_per_mm: 1e-3 * watts,
    })
}
