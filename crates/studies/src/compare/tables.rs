//! Files of a comparison of pairs.

use asperity_report::parts_of;
use asperity_report::tables::{BODIES, FlankTables};
use serde::Serialize;

use super::comparison::{Comparison, FinishResult};
use super::windows::ComparedRoughness;

/// Row of `path.csv`: the local loss of a finish.
#[derive(Serialize)]
pub(super) struct PathRow<'a> {
    finish: &'a str,
    s_mm: f64,
    loss_w_per_m: f64,
    loss_p05_w_per_m: Option<f64>,
    loss_p95_w_per_m: Option<f64>,
}

pub(super) fn path(comparison: &Comparison) -> impl Iterator<Item = PathRow<'_>> {
    comparison.pairs().flat_map(|(finish, pair)| {
        let quantiles = pair.result.path_loss_quantiles();
        let rows = pair.result.path.iter().enumerate();
        rows.map(move |(k, row)| {
            let quantiles = quantiles.as_ref().map(|rows| rows[k]);
            PathRow {
                finish: &finish.name,
                s_mm: row.s_mm,
                loss_w_per_m: row.loss_w_per_m(),
                loss_p05_w_per_m: quantiles.map(|[low, _]| low),
                loss_p95_w_per_m: quantiles.map(|[_, high]| high),
            }
        })
    })
}

/// Row of `parts.csv`: a part of the loss of a finish.
#[derive(Serialize)]
pub(super) struct ComparedPartRow<'a> {
    finish: &'a str,
    part: &'static str,
    loss_w: f64,
}

pub(super) fn parts(comparison: &Comparison) -> impl Iterator<Item = ComparedPartRow<'_>> {
    comparison.pairs().flat_map(|(finish, pair)| {
        parts_of(&pair.result).map(|(part, loss_w, _)| ComparedPartRow {
            finish: &finish.name,
            part,
            loss_w,
        })
    })
}

/// Row of `components.csv`: a component of the uncertainty of a finish, drawn alone.
#[derive(Serialize)]
pub(super) struct ComponentRow<'a> {
    component: &'a str,
    finish: &'a str,
    loss_p05_w: f64,
    loss_p95_w: f64,
}

pub(super) fn components(comparison: &Comparison) -> impl Iterator<Item = ComponentRow<'_>> {
    comparison.finishes.iter().flat_map(|finish| {
        let uncertainty = finish.uncertainty.iter();
        uncertainty.flat_map(|of| &of.loss.parts).map(|part| {
            let [loss_p05_w, loss_p95_w] = part.quantiles_w;
            ComponentRow {
                component: &part.name,
                finish: &finish.name,
                loss_p05_w,
                loss_p95_w,
            }
        })
    })
}

/// Row of `traces.csv`: a point of the roughness of a flank.
#[derive(Serialize)]
pub(super) struct TracePoint<'a> {
    finish: &'a str,
    flank: &'static str,
    x_um: f64,
    roughness_um: f64,
}

pub(super) fn traces(comparison: &Comparison) -> impl Iterator<Item = TracePoint<'_>> {
    flanks(comparison).flat_map(|(finish, flank, tables)| {
        tables.trace.iter().filter_map(move |row| {
            Some(TracePoint {
                finish: &finish.name,
                flank,
                x_um: row.x_um,
                roughness_um: row.roughness_um?,
            })
        })
    })
}

/// Row of `spectra.csv`: a band of the spectrum of a flank.
#[derive(Serialize)]
pub(super) struct SpectrumBand<'a> {
    finish: &'a str,
    flank: &'static str,
    wavelength_um: f64,
    density_um3: f64,
}

pub(super) fn spectra(comparison: &Comparison) -> impl Iterator<Item = SpectrumBand<'_>> {
    flanks(comparison).flat_map(|(finish, flank, tables)| {
        let bands = tables.spectrum_in_bands().into_iter();
        bands.map(move |row| SpectrumBand {
            finish: &finish.name,
            flank,
            wavelength_um: 1e3 / row.frequency_per_mm,
            density_um3: row.density_um3,
        })
    })
}

/// The flanks with a trace.
fn flanks(
    comparison: &Comparison,
) -> impl Iterator<Item = (&FinishResult, &'static str, &FlankTables)> {
    comparison.pairs().flat_map(|(finish, pair)| {
        let bodies = BODIES.iter().zip(&pair.tables);
        bodies.filter_map(move |(flank, tables)| Some((finish, *flank, tables.as_ref()?)))
    })
}

/// Row of `offsets.csv`: a window with a finish.
#[derive(Serialize)]
pub(super) struct ComparedOffsetRow<'a> {
    finish: &'a str,
    offset: usize,
    loss_w: f64,
    ra_um: f64,
    rq_um: f64,
    rz_um: f64,
    rdq: f64,
    rpk_composite_um: f64,
    rk_composite_um: f64,
    rvk_composite_um: f64,
}

pub(super) fn offsets(comparison: &Comparison) -> impl Iterator<Item = ComparedOffsetRow<'_>> {
    comparison.finishes.iter().flat_map(|finish| {
        let both = finish.offsets.iter().zip(finish.roughness());
        both.map(|(row, window): (_, &ComparedRoughness)| ComparedOffsetRow {
            finish: &finish.name,
            offset: row.offset,
            loss_w: row.loss_w,
            ra_um: window.ra_um,
            rq_um: window.rq_um,
            rz_um: window.rz_um,
            rdq: window.rdq,
            rpk_composite_um: window.rpk_composite_um,
            rk_composite_um: window.rk_composite_um,
            rvk_composite_um: window.rvk_composite_um,
        })
    })
}
