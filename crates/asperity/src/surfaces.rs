//! The two flanks as used by the pipeline and as reported in the result.

use std::sync::{Arc, OnceLock};

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_ehl_regime::TraceSpectrum;
use asperity_profile_io::read::Reading;
use asperity_roughness::Parameters;
use asperity_roughness::preparation::PreparationRecord;
use asperity_roughness::section_heights::section_heights;
use serde::Serialize;

use crate::error::PositionError;
use crate::local_roughness::{Roughness, peaks};
use crate::placement::Placement;
use crate::station::Station;

/// λs at which summits are measured when no noise filter was asked for: the usual stylus filter.
const SUMMIT_WINDOW: Length = Length::from_si(2.5e-6);

/// Surface of one flank: measured, or known by its roughness values.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Texture {
    /// A prepared trace.
    Trace(Profile),
    /// Roughness values alone.
    Values {
        /// Rq \[m\].
        rq: f64,
        /// Ra \[m\].
        ra: f64,
        /// Rz \[m\].
        rz: f64,
        /// Rpk \[m\].
        rpk: Option<f64>,
        /// Mean radius of the asperities.
        asperity_radius: Option<Length>,
    },
}

impl PartialEq for Surfaces {
    fn eq(&self, other: &Self) -> bool {
        self.textures == other.textures
            && self.noise_cutoff == other.noise_cutoff
            && self.rz == other.rz
            && self.placement == other.placement
            && self.same_trace == other.same_trace
    }
}

/// Both flanks on a common spacing.
#[derive(Debug, Clone)]
pub struct Surfaces {
    textures: [Texture; 2],
    /// Spectra of both traces, made at first need.
    spectra: Arc<OnceLock<Option<[TraceSpectrum; 2]>>>,
    noise_cutoff: Option<Length>,
    /// Rz of the traces as roughness parameters; where it is not known, windows have the range of their heights.
    rz: [Option<Length>; 2],
    /// Where the traces lie on their flanks; none where that is not known of both.
    placement: Option<Placement>,
    /// Both flanks come from the same trace.
    pub same_trace: bool,
}

impl Surfaces {
    /// Pinion and wheel; two traces must share their spacing. `noise_cutoff` is the λs that was
    /// applied to the traces.
    pub fn new(textures: [Texture; 2], noise_cutoff: Option<Length>, same_trace: bool) -> Self {
        Self {
            textures,
            spectra: Arc::new(OnceLock::new()),
            noise_cutoff,
            rz: [None; 2],
            placement: None,
            same_trace,
        }
    }

    /// The same with Rz of pinion and wheel, each the mean over the sections of its trace: laws that take Rz
    /// mean that, and no range of a window.
    #[must_use]
    pub fn with_rz(self, rz: [Option<Length>; 2]) -> Self {
        Self { rz, ..self }
    }

    /// The same with the traces at their places on the flanks.
    #[must_use]
    pub fn placed(self, placement: Option<Placement>) -> Self {
        Self { placement, ..self }
    }

    /// Where the traces lie on their flanks; none where that is not known of both.
    #[must_use]
    pub fn placement(&self) -> Option<&Placement> {
        self.placement.as_ref()
    }

    /// Share of the loss at places that both traces cover; none where they are not placed.
    pub(crate) fn coverage<'a>(&self, stations: impl Iterator<Item = &'a Station>) -> Option<f64> {
        let [Texture::Trace(first), Texture::Trace(second)] = &self.textures else {
            return None;
        };
        let points = [first.len(), second.len()];
        let placement = self.placement.as_ref()?;
        Some(placement.coverage(stations, points, first.spacing()))
    }

    fn rz_of(&self, body: usize, window: Length) -> f64 {
        self.rz[body].unwrap_or(window).si()
    }

    /// The same flanks with other traces.
    pub(crate) fn with_traces(&self, traces: [Profile; 2]) -> Self {
        Self::new(
            traces.map(Texture::Trace),
            self.noise_cutoff,
            self.same_trace,
        )
        .placed(self.placement)
    }

    /// Pinion and wheel.
    pub fn textures(&self) -> &[Texture; 2] {
        &self.textures
    }

    /// Spectra of both traces; none where a flank was not measured.
    pub(crate) fn spectra_of_traces(&self) -> Option<&[TraceSpectrum; 2]> {
        let spectrum = |texture: &Texture| match texture {
            Texture::Trace(profile) => {
                TraceSpectrum::new(profile.heights(), profile.spacing()).ok()
            }
            Texture::Values { .. } => None,
        };
        let [first, second] = &self.textures;
        self.spectra
            .get_or_init(|| Some([spectrum(first)?, spectrum(second)?]))
            .as_ref()
    }

    /// Whether both flanks were measured.
    pub fn are_measured(&self) -> bool {
        self.textures
            .iter()
            .all(|texture| matches!(texture, Texture::Trace(_)))
    }

    /// Number of offsets computed when `wanted` are requested: one where a flank was not measured, or where the windows
    /// follow from the mesh.
    pub(crate) fn offsets(&self, wanted: usize) -> usize {
        match self.are_measured() && self.placement.is_none() {
            true => wanted,
            false => 1,
        }
    }

    /// Roughness of the windows that meet.
    pub(crate) fn roughness_of(&self, windows: &[Profile; 2]) -> Result<Roughness, PositionError> {
        let (peak, summits) = peaks(windows, self.noise_cutoff.unwrap_or(SUMMIT_WINDOW))?;
        let [first, second] = [
            section_heights(windows[0].heights())?,
            section_heights(windows[1].heights())?,
        ];
        Ok(Roughness {
            rq: [first.rq.si(), second.rq.si()],
            ra: [first.ra.si(), second.ra.si()],
            rz: [self.rz_of(0, first.rz), self.rz_of(1, second.rz)],
            reduced_peak: Some(peak),
            asperities: summits.map_or(0, |found| found.count),
            asperity_radius: summits.map(|found| found.radius),
        })
    }

    /// Roughness of the flanks as a whole: of both traces, or from values.
    pub(crate) fn roughness_as_a_whole(&self) -> Result<Roughness, PositionError> {
        let [Texture::Trace(first), Texture::Trace(second)] = &self.textures else {
            return self.roughness_of_values();
        };
        let common = first.len().min(second.len());
        let begin =
            |trace: &Profile| Profile::new(trace.spacing(), trace.heights()[..common].to_vec());
        self.roughness_of(&[begin(first)?, begin(second)?])
    }

    /// Roughness from values, where a flank has no trace; a trace counts with its whole length.
    pub(crate) fn roughness_of_values(&self) -> Result<Roughness, PositionError> {
        let each = |body: usize| -> Result<_, PositionError> {
            Ok(match &self.textures[body] {
                Texture::Trace(profile) => {
                    let found = section_heights(profile.heights())?;
                    let rz = self.rz_of(body, found.rz);
                    (found.rq.si(), found.ra.si(), rz, None, None)
                }
                Texture::Values {
                    rq,
                    ra,
                    rz,
                    rpk,
                    asperity_radius,
                } => (*rq, *ra, *rz, *rpk, *asperity_radius),
            })
        };
        let (a, b) = (each(0)?, each(1)?);
        Ok(Roughness {
            rq: [a.0, b.0],
            ra: [a.1, b.1],
            rz: [a.2, b.2],
            // Peaks of uncorrelated flanks add like their Rq.
            reduced_peak: a.3.zip(b.3).map(|(p, q)| p.hypot(q)),
            asperities: 0,
            // Curvatures of uncorrelated flanks add like their Rq, too.
            asperity_radius: a
                .4
                .zip(b.4)
                .map(|(p, q)| Length::from_si(1.0 / (1.0 / p.si()).hypot(1.0 / q.si()))),
        })
    }
}

/// A flank as the result reports it.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct FlankReport {
    /// File of the trace as the case names it; none for roughness values.
    pub file: Option<String>,
    /// SHA-256 of the file.
    pub sha256: Option<String>,
    /// Details of the reading of the file.
    pub reading: Option<Reading>,
    /// The trace as it was measured, in its own direction.
    #[serde(skip)]
    pub trace: Option<Profile>,
    /// Whether the trace was read from its other end.
    pub mirrored: bool,
    /// Record of the preparation of the trace.
    pub preparation: Option<PreparationRecord>,
    /// Parameters of the prepared trace.
    pub parameters: Option<Parameters>,
    /// Roll lengths of the first and the last point of the prepared trace, where its place on the flank is known.
    #[serde(skip)]
    pub roll_lengths: Option<[Length; 2]>,
}
