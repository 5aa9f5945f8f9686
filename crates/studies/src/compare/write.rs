//! Output of a comparison: `compare.json`, tables, page and summary.

use std::path::Path;

use asperity::result::Regime;
use asperity_core::Fault;
use asperity_report::StudyResult;
use asperity_report::tables::{BODIES, FlankTables, write as write_table};
use serde::Serialize;

use super::comparison::{Comparison, FinishResult};
use super::page;
use super::summary::summary;
use super::windows::WindowRoughness;

impl StudyResult for Comparison {
    const KIND: &'static str = "comparison";
    const NAME: &'static str = "compare";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(self)
    }

    fn page(&self, (): ()) -> String {
        page::render(self)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        finishes(self, &folder.join("compare.csv"))?;
        if self.finishes.iter().any(|finish| finish.pair.is_none()) {
            return write_table(&folder.join("meshes.csv"), meshes(self));
        }
        offsets(self, &folder.join("offsets.csv"))?;
        write_table(&folder.join("path.csv"), path(self))?;
        write_table(&folder.join("traces.csv"), traces(self))?;
        write_table(&folder.join("spectra.csv"), spectra(self))?;
        if self.correlations.is_empty() {
            return Ok(());
        }
        write_table(&folder.join("parameters.csv"), self.correlations.iter())
    }
}

fn finishes(comparison: &Comparison, file: &Path) -> Result<(), Fault> {
    #[derive(Serialize)]
    struct FinishRow<'a> {
        finish: &'a str,
        efficiency_percent: f64,
        loss_w: f64,
        loss_median_w: Option<f64>,
        loss_p05_w: Option<f64>,
        loss_p95_w: Option<f64>,
        difference_w: Option<f64>,
        difference_p05_w: Option<f64>,
        difference_p95_w: Option<f64>,
        change_percent: Option<f64>,
        change_p05_percent: Option<f64>,
        change_p95_percent: Option<f64>,
        mixed_share_percent: Option<f64>,
        regime: Option<&'static str>,
        gearbox_efficiency_percent: Option<f64>,
        gearbox_loss_w: Option<f64>,
        outside: String,
    }
    write_table(
        file,
        comparison.finishes.iter().map(|finish| {
            let loss = finish.drawn_w();
            let difference = finish.difference.as_ref();
            let first = comparison.first_w(finish);
            let of_runs = first.map(|first| [finish.loss_w - first, finish.loss_w / first - 1.0]);
            FinishRow {
                finish: &finish.name,
                efficiency_percent: 100.0 * finish.efficiency,
                loss_w: finish.loss_w,
                loss_median_w: loss.map(|(median, _)| median),
                loss_p05_w: loss.map(|(_, quantiles)| quantiles[0]),
                loss_p95_w: loss.map(|(_, quantiles)| quantiles[1]),
                difference_w: difference
                    .map(|of| of.median_w)
                    .or(of_runs.map(|[watts, _]| watts)),
                difference_p05_w: difference.map(|difference| difference.quantiles_w[0]),
                difference_p95_w: difference.map(|difference| difference.quantiles_w[1]),
                change_percent: difference
                    .map(|of| of.median_share)
                    .or(of_runs.map(|[_, share]| share))
                    .map(|share| 100.0 * share),
                change_p05_percent: difference
                    .map(|difference| 100.0 * difference.share_quantiles[0]),
                change_p95_percent: difference
                    .map(|difference| 100.0 * difference.share_quantiles[1]),
                mixed_share_percent: finish.mixed_share.map(|share| 100.0 * share),
                regime: finish.regime.map(Regime::name),
                gearbox_efficiency_percent: finish.gearbox.as_ref().map(|g| 100.0 * g.efficiency),
                gearbox_loss_w: finish.gearbox.as_ref().map(|g| g.loss_w),
                outside: finish.outside(),
            }
        }),
    )
}

/// Row of `meshes.csv`: a mesh of a gear train with a finish, or one of its equal meshes.
#[derive(Serialize)]
struct MeshRow<'a> {
    finish: &'a str,
    mesh: &'a str,
    count: u32,
    loss_w: f64,
    loss_median_w: Option<f64>,
    loss_p05_w: Option<f64>,
    loss_p95_w: Option<f64>,
    difference_w: Option<f64>,
    difference_p05_w: Option<f64>,
    difference_p95_w: Option<f64>,
    mixed_share_percent: f64,
    regime: &'static str,
}

fn meshes(comparison: &Comparison) -> impl Iterator<Item = MeshRow<'_>> {
    comparison.finishes.iter().flat_map(|finish| {
        finish.meshes.iter().map(|mesh| {
            let difference = mesh.difference.as_ref();
            MeshRow {
                finish: &finish.name,
                mesh: &mesh.mesh,
                count: mesh.count,
                loss_w: mesh.loss_w,
                loss_median_w: mesh.loss_median_w,
                loss_p05_w: mesh.loss_quantiles_w.map(|ends| ends[0]),
                loss_p95_w: mesh.loss_quantiles_w.map(|ends| ends[1]),
                difference_w: difference.map(|difference| difference.median_w),
                difference_p05_w: difference.map(|difference| difference.quantiles_w[0]),
                difference_p95_w: difference.map(|difference| difference.quantiles_w[1]),
                mixed_share_percent: 100.0 * mesh.mixed_share,
                regime: mesh.regime.name(),
            }
        })
    })
}

/// Row of `path.csv`: the local loss of a finish.
#[derive(Serialize)]
struct PathRow<'a> {
    finish: &'a str,
    s_mm: f64,
    loss_w_per_m: f64,
    loss_p05_w_per_m: Option<f64>,
    loss_p95_w_per_m: Option<f64>,
}

fn path(comparison: &Comparison) -> impl Iterator<Item = PathRow<'_>> {
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

/// Row of `traces.csv`: a point of the roughness of a flank.
#[derive(Serialize)]
struct TracePoint<'a> {
    finish: &'a str,
    flank: &'static str,
    x_um: f64,
    roughness_um: f64,
}

fn traces(comparison: &Comparison) -> impl Iterator<Item = TracePoint<'_>> {
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
struct SpectrumBand<'a> {
    finish: &'a str,
    flank: &'static str,
    wavelength_um: f64,
    density_um3: f64,
}

fn spectra(comparison: &Comparison) -> impl Iterator<Item = SpectrumBand<'_>> {
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

fn offsets(comparison: &Comparison, file: &Path) -> Result<(), Fault> {
    #[derive(Serialize)]
    struct OffsetRow<'a> {
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
    let rows = comparison.finishes.iter().flat_map(|finish| {
        let both = finish.offsets.iter().zip(finish.roughness());
        both.map(|(row, window): (_, &WindowRoughness)| OffsetRow {
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
    });
    write_table(file, rows)
}
