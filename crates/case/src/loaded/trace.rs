//! Traces in memory for a case: heights, bytes, or a file.

use std::path::PathBuf;
use std::sync::Arc;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_profile_io::read::{LengthUnit, ReadFault, ReadOptions};

use crate::error::Error;
use crate::input::case_input::FlankInput;
use crate::input::files::Content;
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

/// Least number of points of a trace, as for one that is read from a file.
const FEWEST_POINTS: usize = 100;
/// Spacings of styluses and optical instruments \[m\]; others indicate a wrong unit.
const SPACINGS: std::ops::RangeInclusive<f64> = 1e-11..=1e-2;

/// The trace of a flank.
///
/// ```
/// use asperity_case::case::Trace;
/// use asperity_core::quantity::Length;
/// let heights: Vec<f64> = (0..8000).map(|i| 1e-7 * (f64::from(i) * 0.7).sin()).collect();
/// let trace = Trace::from_heights(&heights, Length::from_si(0.5e-6))?.mirrored();
/// assert!(Trace::from_heights(&heights[..50], Length::from_si(0.5e-6)).is_err());
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    pub(crate) content: Option<Content>,
    pub(crate) name: Option<PathBuf>,
    options: ReadOptions,
    mirrored: bool,
}

impl Trace {
    /// A trace of heights \[m\], positive out of the material, with this spacing.
    ///
    /// # Errors
    /// When there are fewer than 100 heights, one is not finite, or no instrument has the spacing.
    pub fn from_heights(heights: &[f64], spacing: Length) -> Result<Self, Error> {
        let impossible = |what, value| ReadFault::impossible(what, value, LengthUnit::Metre);
        if heights.len() < FEWEST_POINTS {
            return Err(refused(ReadFault::too_few_points(heights.len())));
        }
        if !SPACINGS.contains(&spacing.si()) {
            return Err(refused(impossible("the spacing", spacing.si())));
        }
        let profile = Profile::new(spacing, heights.to_vec())
            .map_err(|error| refused(impossible(error.name, error.value)))?;
        Ok(Self::new(
            Some(Content::Heights(Arc::new(profile.into()))),
            None,
        ))
    }

    /// The content of the file `name`, read with `options` when the case is built.
    pub fn from_bytes(
        name: impl Into<PathBuf>,
        bytes: impl Into<Vec<u8>>,
        options: ReadOptions,
    ) -> Self {
        let bytes: Vec<u8> = bytes.into();
        let trace = Self::new(Some(Content::Bytes(bytes.into())), Some(name.into()));
        Self { options, ..trace }
    }

    /// A file, relative to the working directory, read with `options` when the case is built.
    pub fn from_file(path: impl Into<PathBuf>, options: ReadOptions) -> Self {
        let trace = Self::new(None, Some(path.into()));
        Self { options, ..trace }
    }

    /// The trace from its other end, since flanks face each other.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self {
            mirrored: !self.mirrored,
            ..self
        }
    }

    fn new(content: Option<Content>, name: Option<PathBuf>) -> Self {
        Self {
            content,
            name,
            options: ReadOptions::default(),
            mirrored: false,
        }
    }

    /// The keys of a flank with this trace under this name.
    pub(crate) fn into_input(self, name: PathBuf) -> FlankInput {
        let ReadOptions {
            x_unit,
            z_unit,
            dx,
            dy,
            columns,
            decimal,
            separator,
            encoding,
            gaps,
            row,
            line,
            abscissa,
            base_radius,
            uneven,
            range,
            invert,
        } = self.options;
        FlankInput {
            file: Some(name),
            mirrored: self.mirrored.then_some(true),
            x_unit,
            z_unit,
            dx,
            dy,
            columns,
            decimal,
            separator,
            encoding,
            gaps: Some(gaps).filter(|gaps| *gaps != Default::default()),
            row,
            line: Some(line).filter(|line| *line != Default::default()),
            abscissa,
            base_radius,
            uneven: Some(uneven).filter(|uneven| *uneven != Default::default()),
            range,
            invert,
            ..FlankInput::default()
        }
    }
}

fn refused(fault: ReadFault) -> Error {
    CaseError::profile(
        Source::in_memory().place_of("surface"),
        &fault.in_file("heights"),
    )
    .into()
}

/// A flank: measured, or known by roughness values.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Flank {
    /// A trace.
    Trace(Trace),
    /// Keys of a flank, as `rq` and `rpk`.
    Keys(Box<FlankInput>),
}

impl From<Trace> for Flank {
    fn from(trace: Trace) -> Self {
        Self::Trace(trace)
    }
}

impl From<FlankInput> for Flank {
    fn from(keys: FlankInput) -> Self {
        Self::Keys(Box::new(keys))
    }
}
