//! Windows of two traces as the inlet of a contact leaves them.
//!
//! A trace is attenuated as a whole by one transform, from which all windows of a contact are cut. Of a trace that is much
//! longer than its windows only a piece around each window is transformed: its cost does not depend on the length of the
//! trace. The straight line between the ends of a piece, a wave that is too long to be left in any contact, is subtracted
//! first, so that the piece repeats without a jump.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::Profile;
use asperity_core::noted::Noted;
use asperity_core::profile::mirrored_window;
use asperity_ehl_regime::{PairSpectrum, TraceSpectrum};

use crate::attenuated_traces::AttenuatedTraces;
use crate::error::LoadShareError;
use crate::window_roughness::{Flattening, WindowRoughness};

/// Number of pieces that are transformed at less cost than a whole trace of as many points: the windows of a contact are
/// usually 16.
const PIECES: usize = 16;

/// Spectra of two traces and of their pieces, each made when it is first needed.
#[derive(Debug, Default)]
pub struct TraceSpectra {
    whole: Noted<[TraceSpectrum; 2]>,
    pair: Noted<PairSpectrum>,
    /// By trace, first point and number of points.
    pieces: Mutex<BTreeMap<(usize, isize, usize), Arc<TraceSpectrum>>>,
}

impl TraceSpectra {
    /// Variance of both whole traces by wavelength.
    ///
    /// # Errors
    /// When a trace has fewer than two points.
    pub fn pair(&self, traces: [&Profile; 2]) -> Result<&PairSpectrum, LoadShareError> {
        self.pair
            .get_or_make(|| Ok(PairSpectrum::from_traces(self.of_whole(traces)?.each_ref())))
    }

    /// Roughness of two windows of `points` points together that begin at `starts`, flattened by `flattening`;
    /// `whole` holds the attenuated traces once they were needed.
    ///
    /// # Errors
    /// When a window is empty.
    pub fn window(
        &self,
        traces: [&Profile; 2],
        (starts, points): ([isize; 2], usize),
        flattening: &Flattening,
        whole: &mut Option<AttenuatedTraces>,
    ) -> Result<WindowRoughness, LoadShareError> {
        let piece = SpectrumPiece::around(points);
        let longest = traces.map(Profile::len).into_iter().fold(0, usize::max);
        if longest > PIECES * piece.points {
            return self.of_pieces(traces, starts, points, piece, flattening);
        }
        if let Some(attenuated) = whole {
            return attenuated.mirrored(starts, points);
        }
        let attenuated = AttenuatedTraces::new(self.of_whole(traces)?.each_ref(), flattening);
        whole.insert(attenuated).mirrored(starts, points)
    }

    /// Spectra of both whole traces.
    ///
    /// # Errors
    /// When a trace has fewer than two points.
    pub fn of_whole(&self, traces: [&Profile; 2]) -> Result<&[TraceSpectrum; 2], LoadShareError> {
        self.whole.get_or_make(|| {
            let spectrum = |trace: &Profile| TraceSpectrum::new(trace.heights(), trace.spacing());
            let [first, second] = traces.map(spectrum);
            Ok([first?, second?])
        })
    }

    fn of_pieces(
        &self,
        traces: [&Profile; 2],
        starts: [isize; 2],
        points: usize,
        piece: SpectrumPiece,
        flattening: &Flattening,
    ) -> Result<WindowRoughness, LoadShareError> {
        let begins = starts.map(|start| piece.begin(start));
        let of = |body: usize| self.of_piece(body, traces[body], begins[body], piece.points);
        let (first, second) = (of(0)?, of(1)?);
        let attenuated = AttenuatedTraces::new([&*first, &*second], flattening);
        let from = [0, 1].map(|body: usize| (starts[body] - begins[body]) as usize);
        attenuated.window(from, points)
    }

    fn of_piece(
        &self,
        body: usize,
        trace: &Profile,
        begin: isize,
        points: usize,
    ) -> Result<Arc<TraceSpectrum>, LoadShareError> {
        let key = (body, begin, points);
        let known = || self.pieces.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(made) = known().get(&key) {
            return Ok(Arc::clone(made));
        }
        let mut heights = mirrored_window(trace.heights(), begin, points);
        let (from, to) = (heights[0], heights[points - 1]);
        let step = (to - from) / (points - 1) as f64;
        for (i, z) in heights.iter_mut().enumerate() {
            *z -= from + step * i as f64;
        }
        let made = Arc::new(TraceSpectrum::new(&heights, trace.spacing())?);
        known().insert(key, Arc::clone(&made));
        Ok(made)
    }
}

/// Points around a window that are transformed with it.
#[derive(Clone, Copy)]
struct SpectrumPiece {
    points: usize,
    /// Least points on either side of the window.
    margin: usize,
    /// Pieces begin at multiples of this number of points, so that neighbouring contacts share them.
    raster: isize,
}

impl SpectrumPiece {
    /// The piece around a window of `points` points: at least as many on either side.
    fn around(points: usize) -> Self {
        let margin = points;
        let raster = points.div_ceil(2).max(1);
        Self {
            points: (points + 2 * margin + raster).next_power_of_two(),
            margin,
            raster: raster as isize,
        }
    }

    fn begin(self, start: isize) -> isize {
        (start - self.margin as isize).div_euclid(self.raster) * self.raster
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::Length;
    use asperity_ehl_regime::{Attenuation, GapLaw};

    use super::*;

    /// A rough trace: waves from 4 um to 2 mm, the longer the higher.
    fn trace(points: usize, seed: f64) -> Profile {
        let dx = 0.5e-6;
        let height = |i: usize| {
            let waves = (0..60).map(|k| {
                let length = 4e-6 * 1.11_f64.powi(k);
                let phase = seed * f64::from(k * k + 1);
                let size = 0.1e-6 * (length / 100e-6).powf(0.8);
                size * (std::f64::consts::TAU * i as f64 * dx / length + phase).sin()
            });
            waves.sum()
        };
        Profile::new(Length::from_si(dx), (0..points).map(height).collect()).unwrap()
    }

    #[test]
    fn a_window_of_a_piece_has_the_deviation_of_that_of_the_whole_trace() {
        let traces = [trace(200_000, 0.37), trace(200_000, 0.71)];
        let both = [&traces[0], &traces[1]];
        let spectra = TraceSpectra::default();
        for half_width in [30e-6, 100e-6] {
            let points = (6.0 * half_width / 0.5e-6) as usize;
            for per_half_width in [2.0, 10.0, 60.0] {
                let nabla = per_half_width / half_width;
                let attenuation = Attenuation::new(GapLaw::Power, nabla).unwrap().into();
                let [first, second] = spectra.of_whole(both).unwrap();
                let whole = AttenuatedTraces::new([first, second], &attenuation);
                for starts in [[50_000, 90_001], [123_457, 20_000]] {
                    let exact = whole.mirrored(starts, points).unwrap().deviation;
                    let mut unused = None;
                    let of_piece =
                        spectra.window(both, (starts, points), &attenuation, &mut unused);
                    let off = of_piece.unwrap().deviation / exact - 1.0;
                    assert!(unused.is_none());
                    // Waves as long as the piece are cut at its ends; 7e-5 were seen where the longest waves are left.
                    assert!(off.abs() < 2e-4, "{half_width} {per_half_width}: {off}");
                }
            }
        }
    }

    #[test]
    fn a_trace_that_is_not_much_longer_than_its_windows_is_transformed_as_a_whole() {
        let traces = [trace(8000, 0.37), trace(8000, 0.71)];
        let both = [&traces[0], &traces[1]];
        let spectra = TraceSpectra::default();
        let mut whole = None;
        let attenuation = Attenuation::new(GapLaw::Power, 1e5).unwrap().into();
        let found = spectra.window(both, ([100, 300], 1200), &attenuation, &mut whole);
        let [first, second] = spectra.of_whole(both).unwrap();
        let exact = AttenuatedTraces::new([first, second], &attenuation);
        assert_eq!(found.unwrap(), exact.window([100, 300], 1200).unwrap());
        assert!(whole.is_some());
    }
}
