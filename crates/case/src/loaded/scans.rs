//! Scans of flanks: each is read once, and its rows are traces.

use std::borrow::Cow;
use std::cell::RefCell;
use std::path::Path;
use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_flanks::scan::{middle, without_spikes};
use asperity_flanks::sheets::LEAST_ROWS;
use asperity_profile_io::read::{ReadOptions, Surface, TraceRange, read_surface_bytes};

use crate::input::files::{Content, Reader};
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

/// Scans that were read for a case.
#[derive(Debug, Default)]
pub(crate) struct Scans(RefCell<Vec<(ReadOptions, Scan)>>);

/// A scan as it was read.
#[derive(Debug, Clone)]
pub(crate) struct Scan {
    pub surface: Arc<Surface>,
    /// Sum of its file.
    pub sum: Arc<str>,
    /// Spikes that were replaced, where the case has them replaced.
    pub spikes: Option<Warning>,
}

impl Scans {
    /// The scan in `file`, which is named at `key`, with spikes beyond `outliers` deviations replaced; `None` of heights in memory.
    pub(crate) fn read(
        &self,
        file: &Path,
        key: Cow<'static, str>,
        options: ReadOptions,
        outliers: Option<f64>,
        files: &Reader<'_>,
        source: &Source,
    ) -> Result<Option<Scan>, CaseError> {
        let name = file.display().to_string();
        let known = self.0.borrow();
        let same = |(of, scan): &&(ReadOptions, Scan)| scan.surface.name == name && *of == options;
        if let Some((_, scan)) = known.iter().find(same) {
            return Ok(Some(scan.clone()));
        }
        drop(known);
        let (content, sum) = files.open(file, source, key.clone())?;
        let Content::Bytes(bytes) = content else {
            return Ok(None);
        };
        let surface = read_surface_bytes(&name, &bytes, &options);
        let place = || source.place_of(&key);
        let mut surface = surface.map_err(|error| CaseError::profile(place(), &error))?;
        let mut spikes = None;
        if let (Some(deviations), Some(dx)) = (outliers, surface.dx) {
            let found = without_spikes(&mut surface.z, surface.columns, dx, deviations);
            let found = found.map_err(|error| CaseError::preparation(&name, error))?;
            spikes = found.map(|found| Warning::new(found.code(), format!("{name}: {found}")));
        }
        let scan = Scan {
            surface: surface.into(),
            sum: sum.into(),
            spikes,
        };
        self.0.borrow_mut().push((options, scan.clone()));
        Ok(Some(scan))
    }
}

impl Scan {
    /// Distance of its rows; `None` of few profiles, or of profiles at unknown places.
    pub(crate) fn apart(&self) -> Option<Length> {
        let surface = &self.surface;
        surface.dy.filter(|_| surface.rows >= LEAST_ROWS)
    }

    /// Share of its points in a range without a height.
    pub(crate) fn missing(&self, range: Option<TraceRange>) -> f64 {
        let points = self.surface.points_in(range);
        let all = (points.len() * self.surface.rows).max(1);
        1.0 - self.surface.measured_in(points).sum::<usize>() as f64 / all as f64
    }

    /// The row, from 1, in part `k` of `count` equal parts that lacks the fewest heights in a range, the nearest to its middle.
    pub(crate) fn row_of_part(&self, k: usize, count: usize, range: Option<TraceRange>) -> usize {
        let surface = &self.surface;
        let wanted = middle(k, count, surface.rows);
        let points = surface.points_in(range);
        let known: Vec<usize> = surface.measured_in(points).collect();
        let part = k * surface.rows / count..(k + 1) * surface.rows / count;
        let best = part.max_by_key(|row| (known[*row], std::cmp::Reverse(row.abs_diff(wanted))));
        best.unwrap_or(wanted) + 1
    }
}
