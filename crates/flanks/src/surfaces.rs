//! The two flanks as used by the pipeline and as reported in the result.

use std::sync::Arc;

use asperity_core::noted::Noted;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use asperity_profile_io::read::Reading;
use asperity_roughness::Parameters;
use asperity_roughness::outliers::OutlierRecord;
use asperity_roughness::preparation::PreparationRecord;
use asperity_roughness::section_heights::section_heights;
use serde::Serialize;

use crate::error::PositionError;
use crate::flank_form::FlankForm;
use crate::generated_record::GeneratedRecord;
use crate::local_roughness::{Roughness, peaks};
use crate::mesh_position::MeshPosition;
use crate::placement::Placement;
use crate::sheets::{MadeSheet, Sheets};
use crate::surrogate_record::SurrogateRecord;
use asperity_ehl_regime::{Lay, PairSpectrum, TraceSpectrum};
use asperity_mixed_film::TraceSpectra;
use asperity_mixed_film::{AttenuatedTraces, Flattening, WindowRoughness};

/// λs at which summits are measured without a noise filter: the usual stylus filter.
const SUMMIT_WINDOW: Length = Length::from_si(2.5e-6);

/// Surface of one flank: measured, or known by its roughness values.
#[derive(Debug, Clone, PartialEq)]
pub enum Texture {
    /// A prepared trace.
    Trace(Profile),
    /// Roughness values without a trace.
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
            && self.sample == other.sample
            && self.like == other.like
            && self.has_sheets_of(other)
    }
}

/// All pairs of several teeth, of which traces were measured, or pairs of surrogates.
#[derive(Debug, Clone, PartialEq)]
pub struct PairsOfTeeth {
    /// Teeth of pinion and wheel; `None` of surrogates, each of which is in one pair.
    pub teeth: Option<[usize; 2]>,
    /// The traces in contact in each zone of the face, pair by pair: a tooth of the pinion on all teeth of
    /// the wheel, then the next tooth.
    pub met: Vec<Vec<Surfaces>>,
}

/// Flanks that were generated like measured traces, a sample of their finish.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LikeMeasured {
    /// Whether pinion and wheel were.
    pub flanks: [bool; 2],
    /// Whether both are like the same traces.
    pub is_same: bool,
}

/// Both flanks on a common spacing.
#[derive(Debug, Clone)]
pub struct Surfaces {
    textures: Arc<[Texture; 2]>,
    /// Spectra of both traces, made at first need.
    spectra: Arc<TraceSpectra>,
    /// Roughness of the whole traces, made at first need.
    whole: Arc<Noted<Result<Roughness, PositionError>>>,
    noise_cutoff: Option<Length>,
    /// Rz of the traces as roughness parameters; where it is not known, windows have the range of their heights.
    rz: [Option<Length>; 2],
    /// Lengths of the traces with the ends that filtering dropped, where they are known.
    whole_lengths: [Option<Length>; 2],
    /// Places of the traces on their flanks; `None` unless both are known.
    placement: Option<Placement>,
    /// Several pairs, of which this is the first; none of one trace for each flank.
    sample: Option<Arc<PairsOfTeeth>>,
    /// Both flanks as surfaces, where the contact is that of patches; the traces are then rows of them.
    sheets: Option<Arc<Sheets>>,
    like: LikeMeasured,
    /// Both flanks come from the same trace.
    pub same_trace: bool,
}

impl Surfaces {
    /// Pinion and wheel; two traces must share their spacing. `noise_cutoff` is the λs that was
    /// applied to the traces.
    pub fn new(textures: [Texture; 2], noise_cutoff: Option<Length>, same_trace: bool) -> Self {
        Self {
            textures: Arc::new(textures),
            spectra: Arc::default(),
            whole: Arc::default(),
            noise_cutoff,
            rz: [None; 2],
            whole_lengths: [None; 2],
            placement: None,
            sample: None,
            sheets: None,
            like: LikeMeasured::default(),
            same_trace,
        }
    }

    /// Sets Rz of pinion and wheel, each the mean over the sections of its trace: laws that take Rz
    /// mean that, and no range of a window.
    #[must_use]
    pub fn with_rz(self, rz: [Option<Length>; 2]) -> Self {
        Self {
            rz,
            whole: Arc::default(),
            ..self
        }
    }

    /// Sets the lengths of the traces with the ends that filtering dropped.
    #[must_use]
    pub fn with_whole_lengths(self, whole_lengths: [Option<Length>; 2]) -> Self {
        Self {
            whole_lengths,
            ..self
        }
    }

    /// Lengths of the traces with the ends that filtering dropped, where they are known.
    #[must_use]
    pub fn whole_lengths(&self) -> [Option<Length>; 2] {
        self.whole_lengths
    }

    /// Sets the places of the traces on the flanks.
    #[must_use]
    pub fn placed(self, placement: Option<Placement>) -> Self {
        Self { placement, ..self }
    }

    /// Sets which flanks were generated like measured ones.
    #[must_use]
    pub fn like_measured(self, like: LikeMeasured) -> Self {
        Self { like, ..self }
    }

    /// Flanks that were generated like measured ones.
    #[must_use]
    pub fn like(&self) -> LikeMeasured {
        self.like
    }

    /// Sets the surfaces of both flanks.
    #[must_use]
    pub fn with_sheets(self, sheets: Option<Arc<Sheets>>) -> Self {
        Self { sheets, ..self }
    }

    fn has_sheets_of(&self, other: &Self) -> bool {
        match (&self.sheets, &other.sheets) {
            (Some(own), Some(other)) => Arc::ptr_eq(own, other) || own == other,
            (own, other) => own.is_none() && other.is_none(),
        }
    }

    /// Both flanks as surfaces; `None` where the contact is that of traces.
    #[must_use]
    pub fn sheets(&self) -> Option<&Arc<Sheets>> {
        self.sheets.as_ref()
    }

    /// All pairs of several teeth; functions of a single pair use the first.
    ///
    /// `None` without pairs, or if a pair has no traces.
    #[must_use]
    pub fn of_pairs(pairs: PairsOfTeeth) -> Option<Self> {
        let first = pairs.met.first()?.first()?.clone();
        let same_trace = (pairs.met.iter().flatten()).any(|met| met.same_trace);
        Some(Self {
            same_trace,
            sample: Some(Arc::new(pairs)),
            ..first
        })
    }

    /// Teeth of pinion and wheel with measured traces; `None` with one trace for each flank.
    #[must_use]
    pub fn teeth(&self) -> Option<[usize; 2]> {
        self.sample.as_ref().and_then(|sample| sample.teeth)
    }

    /// Whether a flank has no trace, so that the pairs are of surrogates.
    #[must_use]
    pub fn is_surrogate(&self) -> bool {
        self.sample
            .as_ref()
            .is_some_and(|sample| sample.teeth.is_none())
    }

    /// Only the first pair, in the first zone of the face.
    #[must_use]
    pub fn first_pair(&self) -> Self {
        Self {
            sample: None,
            ..self.clone()
        }
    }

    /// Teeth of pinion and wheel, if there are several pairs: their losses have an error of the mean.
    #[must_use]
    pub fn several_teeth(&self) -> Option<[usize; 2]> {
        self.teeth().filter(|teeth| *teeth != [1, 1])
    }

    /// Pairs of teeth, or of surrogates.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.sample.as_ref().map_or(1, |sample| sample.met.len())
    }

    /// Refuses several pairs where a single contact is solved.
    pub fn check_one_pair(&self) -> Result<(), PositionError> {
        match self.teeth() {
            None => Ok(()),
            Some(teeth) => Err(PositionError::several_traces(teeth)),
        }
    }

    /// The traces of every pair in every zone of the face.
    pub fn each(&self) -> impl Iterator<Item = &Self> {
        let sampled = self
            .sample
            .iter()
            .flat_map(|sample| sample.met.iter().flatten());
        let one = self.sample.is_none().then_some(self);
        sampled.chain(one)
    }

    /// The pair of traces in a zone of the face at offset `k` of `count` of all pairs, and its own offset of how many.
    pub fn met(&self, zone: usize, k: usize, count: usize) -> (&Self, usize, usize) {
        let Some(sample) = &self.sample else {
            return (self, k, count);
        };
        let each = (count / sample.met.len()).max(1);
        let pair = sample.met.get(k / each);
        let met = pair.and_then(|pair| pair.get(zone).or_else(|| pair.first()));
        (met.unwrap_or(self), k % each, each)
    }

    /// Whether offset `k` of `count` is the first one of a pair.
    pub fn begins_a_pair(&self, k: usize, count: usize) -> bool {
        self.met(0, k, count).1 == 0
    }

    /// Applies `change` to every pair of traces.
    fn changed<E>(&self, change: impl Fn(&Self) -> Result<Self, E>) -> Result<Self, E> {
        let Some(sample) = &self.sample else {
            return change(self);
        };
        let in_zones = |pair: &Vec<Self>| pair.iter().map(&change).collect();
        let pairs = PairsOfTeeth {
            teeth: sample.teeth,
            met: sample.met.iter().map(in_zones).collect::<Result<_, E>>()?,
        };
        Ok(Self::of_pairs(pairs).unwrap_or_else(|| self.clone()))
    }

    /// Shifts placed traces by a number of half-widths against each other; `None` if they are not placed.
    pub fn misplaced(&self, half_widths: f64) -> Option<Self> {
        self.changed(|met| {
            let placement = met.placement.ok_or(())?;
            let misplaced = Placement {
                misplaced: half_widths,
                ..placement
            };
            Ok::<_, ()>(met.clone().placed(Some(misplaced)))
        })
        .ok()
    }

    /// Places of the traces on their flanks; `None` unless both are known.
    #[must_use]
    pub fn placement(&self) -> Option<&Placement> {
        self.placement.as_ref()
    }

    /// Share of the loss at places that both traces cover, the least of all pairs; `None` if they are not placed.
    pub fn coverage<'a>(
        &self,
        stations: impl Iterator<Item = &'a MeshPosition> + Clone,
    ) -> Option<f64> {
        let of_zone = |zone: usize, met: &Self| {
            let here = stations.clone().filter(move |at| at.zone == zone);
            met.coverage_of_one(here)
        };
        let Some(sample) = &self.sample else {
            return self.coverage_of_one(stations);
        };
        let pairs = sample.met.iter().flat_map(|pair| pair.iter().enumerate());
        let least = pairs.filter_map(|(zone, met)| of_zone(zone, met));
        least.reduce(f64::min)
    }

    fn coverage_of_one<'a>(&self, stations: impl Iterator<Item = &'a MeshPosition>) -> Option<f64> {
        let [Texture::Trace(first), Texture::Trace(second)] = self.textures() else {
            return None;
        };
        let points = [first.len(), second.len()];
        let placement = self.placement.as_ref()?;
        Some(placement.coverage(stations, points, first.spacing()))
    }

    fn rz_of(&self, body: usize, window: Length) -> f64 {
        self.rz[body].unwrap_or(window).si()
    }

    /// The flanks with other traces, of one pair.
    #[must_use]
    pub fn with_traces(&self, traces: [Profile; 2]) -> Self {
        Self::new(
            traces.map(Texture::Trace),
            self.noise_cutoff,
            self.same_trace,
        )
        .placed(self.placement)
    }

    /// Zones of the face that have traces of their own, 1 without.
    #[must_use]
    pub fn zones(&self) -> usize {
        let first = self.sample.as_ref().and_then(|sample| sample.met.first());
        first.map_or(1, Vec::len)
    }

    /// The traces of a tooth of the pinion and one of the wheel in a zone of the face.
    #[must_use]
    pub fn of_teeth(&self, [pinion, wheel]: [usize; 2], zone: usize) -> &Self {
        let teeth = self.teeth().unwrap_or([1, 1]);
        let pairs = self.sample.as_ref().map(|sample| &sample.met);
        let pair = pairs.and_then(|met| met.get(pinion * teeth[1] + wheel));
        pair.and_then(|zones| zones.get(zone)).unwrap_or(self)
    }

    /// The flanks with other traces of every tooth of the pinion and of the wheel in every zone of the face.
    ///
    /// # Errors
    /// The errors of `of`.
    pub fn with_traces_of_teeth<E>(
        &self,
        of: impl Fn([usize; 2], usize) -> Result<[Profile; 2], E>,
    ) -> Result<Self, E> {
        let Some(sample) = &self.sample else {
            return Ok(self.with_traces(of([0, 0], 0)?));
        };
        let [pinions, wheels] = self.teeth().unwrap_or([1, 1]);
        let pairs = (0..pinions).flat_map(|pinion| (0..wheels).map(move |wheel| [pinion, wheel]));
        let in_zones = |teeth: [usize; 2]| {
            let zones = 0..self.zones();
            let changed =
                zones.map(|zone| Ok(self.of_teeth(teeth, zone).with_traces(of(teeth, zone)?)));
            changed.collect::<Result<Vec<Self>, E>>()
        };
        let pairs = PairsOfTeeth {
            teeth: sample.teeth,
            met: pairs.map(in_zones).collect::<Result<_, E>>()?,
        };
        Ok(Self::of_pairs(pairs).unwrap_or_else(|| self.clone()))
    }

    /// The flanks with all heights multiplied by `factor`.
    ///
    /// # Errors
    /// When heights are no longer finite.
    pub fn with_heights_times(&self, factor: f64) -> Result<Self, DomainError> {
        self.changed(|met| met.one_with_heights_times(factor))
    }

    fn one_with_heights_times(&self, factor: f64) -> Result<Self, DomainError> {
        let times = |texture: &Texture| -> Result<Texture, DomainError> {
            Ok(match texture {
                Texture::Trace(trace) => {
                    let heights = trace.heights().iter().map(|z| factor * z);
                    Texture::Trace(Profile::new(trace.spacing(), heights.collect())?)
                }
                Texture::Values {
                    rq,
                    ra,
                    rz,
                    rpk,
                    asperity_radius,
                } => Texture::Values {
                    rq: factor * rq,
                    ra: factor * ra,
                    rz: factor * rz,
                    rpk: rpk.map(|rpk| factor * rpk),
                    // Curvatures grow with the heights.
                    asperity_radius: asperity_radius.map(|radius| radius / factor),
                },
            })
        };
        let [pinion, wheel] = self.textures();
        let textures = [times(pinion)?, times(wheel)?];
        let sheets = self
            .sheets
            .as_ref()
            .map(|sheets| sheets.times(factor).into());
        Ok(Self::new(textures, self.noise_cutoff, self.same_trace)
            .with_rz(self.rz.map(|rz| rz.map(|rz| rz * factor)))
            .placed(self.placement)
            .with_sheets(sheets))
    }

    /// Changes the heights of the traces, and of every row of patches; Rz of a trace scales with its Rq.
    ///
    /// # Errors
    /// The errors of `change`.
    pub fn with_changed_traces<E: From<DomainError>>(
        &self,
        change: impl Fn(&Profile) -> Result<Profile, E>,
    ) -> Result<Self, E> {
        self.changed(|met| met.one_with_changed_traces(&change))
    }

    fn one_with_changed_traces<E: From<DomainError>>(
        &self,
        change: impl Fn(&Profile) -> Result<Profile, E>,
    ) -> Result<Self, E> {
        let changed = |body: usize| -> Result<(Texture, Option<Length>), E> {
            match &self.textures[body] {
                Texture::Trace(trace) => {
                    let other = change(trace)?;
                    let ratio = rq(&other) / rq(trace);
                    let rz = self.rz[body].map(|rz| rz * ratio);
                    Ok((Texture::Trace(other), rz))
                }
                values @ Texture::Values { .. } => Ok((values.clone(), self.rz[body])),
            }
        };
        let [(pinion, pinion_rz), (wheel, wheel_rz)] = [changed(0)?, changed(1)?];
        let sheets = self.sheets.as_ref();
        let sheets = sheets
            .map(|sheets| sheets.with_changed_rows(&change))
            .transpose()?;
        Ok(
            Self::new([pinion, wheel], self.noise_cutoff, self.same_trace)
                .with_rz([pinion_rz, wheel_rz])
                .placed(self.placement)
                .with_sheets(sheets.map(Arc::new)),
        )
    }

    /// Pinion and wheel.
    pub fn textures(&self) -> &[Texture; 2] {
        &self.textures
    }

    /// Roughness of two windows together, each its first point and their number of points, flattened by
    /// `flattening`; `whole` holds the attenuated traces once they were needed.
    pub fn window(
        &self,
        window: ([isize; 2], usize),
        flattening: &Flattening,
        whole: &mut Option<AttenuatedTraces>,
    ) -> Result<WindowRoughness, PositionError> {
        Ok((self.spectra).window(self.traces()?, window, flattening, whole)?)
    }

    /// Spectra of both whole traces.
    pub fn whole_spectra(&self) -> Result<&[TraceSpectrum; 2], PositionError> {
        Ok(self.spectra.of_whole(self.traces()?)?)
    }

    /// Variance of both traces by wavelength.
    pub fn pair_spectrum(&self) -> Result<&PairSpectrum, PositionError> {
        Ok(self.spectra.pair(self.traces()?)?)
    }

    /// Traces of both flanks.
    ///
    /// # Errors
    /// When a flank is known by roughness values only.
    pub fn traces(&self) -> Result<[&Profile; 2], PositionError> {
        match self.textures() {
            [Texture::Trace(first), Texture::Trace(second)] => Ok([first, second]),
            _ => Err(PositionError::no_profile()),
        }
    }

    /// Lay of both flanks together.
    ///
    /// # Errors
    /// When the law of two lays refuses the roughness of the flanks.
    pub fn lay(&self, lays: [Lay; 2]) -> Result<Lay, PositionError> {
        let rq = |texture: &Texture| match texture {
            Texture::Trace(profile) => {
                let z = profile.heights();
                let n = z.len() as f64;
                let mean = z.iter().sum::<f64>() / n;
                let square = z.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
                Length::from_si(square.sqrt())
            }
            Texture::Values { rq, .. } => Length::from_si(*rq),
        };
        if lays[0] == lays[1] {
            return Ok(lays[0]);
        }
        let [first, second] = self.textures();
        Ok(Lay::of_pair(lays, [rq(first), rq(second)])?)
    }

    /// Whether both flanks have the textures of `other`.
    pub fn has_textures_of(&self, other: &Self) -> bool {
        let same = Arc::ptr_eq(&self.textures, &other.textures) || self.textures == other.textures;
        same && self.has_sheets_of(other)
    }

    /// Whether both flanks have traces, measured or of surrogates.
    pub fn are_measured(&self) -> bool {
        self.textures
            .iter()
            .all(|texture| matches!(texture, Texture::Trace(_)))
    }

    /// Number of offsets computed when `wanted` are requested for each pair of traces: one where a flank was not
    /// measured, or where the windows follow from the mesh.
    #[must_use]
    pub fn offsets(&self, wanted: usize) -> usize {
        let of_a_pair = if self.are_measured() && self.placement.is_none() {
            wanted
        } else {
            1
        };
        self.pairs() * of_a_pair
    }

    /// Whether `other` has the same flanks in every pair.
    #[must_use]
    pub fn has_flanks_of(&self, other: &Self) -> bool {
        let (ours, theirs): (Vec<&Self>, Vec<&Self>) =
            (self.each().collect(), other.each().collect());
        let mut pairs = ours.iter().zip(&theirs);
        ours.len() == theirs.len() && pairs.all(|(one, other)| one.has_textures_of(other))
    }

    /// Number of the first of `flanks` that has the flanks of each.
    #[must_use]
    pub fn first_equal(flanks: &[&Self]) -> Vec<usize> {
        let first = |(k, own): (usize, &&Self)| {
            let same = flanks.iter().position(|other| other.has_flanks_of(own));
            same.unwrap_or(k)
        };
        flanks.iter().enumerate().map(first).collect()
    }

    /// Roughness of two windows in contact.
    pub fn roughness_of(&self, windows: &[Profile; 2]) -> Result<Roughness, PositionError> {
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
    pub fn roughness_as_a_whole(&self) -> Result<Roughness, PositionError> {
        let made = self.whole.get_or_init(|| self.roughness_of_whole());
        made.clone()
    }

    fn roughness_of_whole(&self) -> Result<Roughness, PositionError> {
        let [Texture::Trace(first), Texture::Trace(second)] = self.textures() else {
            return self.roughness_of_values();
        };
        let common = first.len().min(second.len());
        let begin =
            |trace: &Profile| Profile::new(trace.spacing(), trace.heights()[..common].to_vec());
        self.roughness_of(&[begin(first)?, begin(second)?])
    }

    /// Roughness from values, where a flank has no trace; a trace counts with its whole length.
    pub fn roughness_of_values(&self) -> Result<Roughness, PositionError> {
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

/// Rq of a trace as a whole.
fn rq(trace: &Profile) -> f64 {
    let n = trace.len() as f64;
    let mean = trace.heights().iter().sum::<f64>() / n;
    let squares = trace.heights().iter().map(|z| (z - mean).powi(2));
    (squares.sum::<f64>() / n).sqrt()
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
    /// Spikes that were replaced, where the case has them replaced.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outliers: Option<OutlierRecord>,
    /// Record of the preparation of the trace.
    pub preparation: Option<PreparationRecord>,
    /// Parameters of the prepared trace.
    pub parameters: Option<Parameters>,
    /// Form of the flank, where the relief of its gear is taken from the trace.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<FlankForm>,
    /// The surrogates of a flank without a trace.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surrogates: Option<SurrogateRecord>,
    /// Generation of the trace, if it was generated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub generated: Option<GeneratedRecord>,
    /// Surface that was made from the trace, where the other flank is a scan in contact as a whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub made_sheet: Option<MadeSheet>,
    /// Roll lengths of the first and the last point of the prepared trace, where its place on the flank is known.
    #[serde(skip)]
    pub roll_lengths: Option<[Length; 2]>,
}
