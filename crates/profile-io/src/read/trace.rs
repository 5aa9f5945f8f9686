//! A measured trace as stored in its file, with points that may be uneven.

use std::borrow::Cow;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

use super::cut::TraceCut;
use super::error::{ReadError, ReadFault};
use super::format::Format;
use super::grid::{self, SpacingSource, Unevenness};
use super::header::FilterState;
use super::layout::TableLayout;
use super::metadata::Metadata;
use super::options::{Abscissa, Encoding, LengthUnit, TraceRange, Uneven};
use super::reading::{Reading, ReadingRecord};
use super::resample::{self, Between, Resampled};
use crate::warning::Warning;

/// Maximum step in mean steps; longer steps mean missing points.
const LONGEST_STEP: f64 = 10.0;
/// Maximum ratio of the points of an even grid to the points of the file.
const MOST_REFINED: f64 = 8.0;
/// Relative rounding error of the length of a trace.
const ROUNDING: f64 = 1e-9;

/// Positions of the points of a trace.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Positions {
    /// Evenly spaced, or off an even grid by no more than rounding or 2 % of a spacing.
    Even {
        /// Distance between points.
        spacing: Length,
    },
    /// Individual position of each point.
    Own {
        /// Positions \[m\] along the trace in ascending order, with the origin of the file.
        #[serde(skip)]
        x: Vec<f64>,
        /// Deviation from an even grid.
        unevenness: Unevenness,
    },
}

/// A measured trace as stored in its file, whose points may be uneven. The points are not serialised.
///
/// [`resampled`](Self::resampled) interpolates it onto an even grid and reports the change; [`reading`](Self::reading)
/// converts it to the result of [`read`](super::read()).
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, Uneven, read_bytes, read_trace_bytes};
/// let x = |i: u32| 0.5 * f64::from(i) + 0.2 * f64::from(i).sin();
/// let row = |i: u32| format!("{:.4};{:.4}\n", x(i), (0.1 * x(i)).sin());
/// let file = format!("x [um];z [um]\n{}", (0..200).map(row).collect::<String>());
/// let trace = read_trace_bytes("a.csv", file.as_bytes(), &ReadOptions::default())?;
/// assert!(!trace.is_even() && (trace.x()[1] - 0.6683e-6).abs() < 1e-18);
/// let even = trace.resampled("0.25 um".parse()?)?;
/// assert_eq!(even.profile.spacing(), "0.25 um".parse()?);
/// assert!(even.most < "10 nm".parse()?);
/// // Uneven points are resampled only on request.
/// assert!(read_bytes("a.csv", file.as_bytes(), &ReadOptions::default()).is_err());
/// assert_eq!(trace.reading(Uneven::Resample)?.points, 200);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Trace {
    /// Name of the file.
    pub name: String,
    /// Positions of the points.
    pub positions: Positions,
    /// Heights \[m\] out of the material, as in the file (no offset, form or tilt removed).
    #[serde(skip)]
    pub heights: Vec<f64>,
    /// Format of the file.
    pub format: Format,
    /// Character encoding; `None` for binary formats.
    pub encoding: Option<Encoding>,
    /// Dialect of the table; `None` for formats without a table.
    pub table: Option<TableLayout>,
    /// Unit of x; `None` if the spacing was stated.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights in the file.
    pub z_unit: LengthUnit,
    /// Origin of the spacing.
    pub spacing_source: SpacingSource,
    /// Filter state according to the file.
    pub filter_state: FilterState,
    /// Number of missing points that were interpolated, or omitted from an uneven trace, on request.
    pub gaps_filled: usize,
    /// Record of the cut, if only a part of the trace is used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cut: Option<TraceCut>,
    /// Metadata of the file.
    pub metadata: Metadata,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Whether the header of the file scales the heights.
    #[serde(skip)]
    pub(super) scaled: bool,
    /// Original meaning of x and base radius, if x was converted to the distance along an involute.
    #[serde(skip)]
    pub(super) roll: Option<(Abscissa, Length)>,
}

impl Trace {
    /// Whether the points are evenly spaced.
    pub fn is_even(&self) -> bool {
        matches!(self.positions, Positions::Even { .. })
    }

    /// Positions \[m\] of the points in ascending order; even points start at 0.
    pub fn x(&self) -> Cow<'_, [f64]> {
        match &self.positions {
            Positions::Own { x, .. } => Cow::Borrowed(x),
            Positions::Even { spacing } => {
                let x = |i: usize| spacing.si() * i as f64;
                Cow::Owned((0..self.heights.len()).map(x).collect())
            }
        }
    }

    /// Distance from the first point to the last.
    pub fn length(&self) -> Length {
        let steps = (self.heights.len().max(1) - 1) as f64;
        match &self.positions {
            Positions::Even { spacing } => *spacing * steps,
            Positions::Own { x, .. } => match x[..] {
                [first, .., last] => Length::from_si(last - first),
                _ => Length::from_si(0.0),
            },
        }
    }

    /// Mean distance between points.
    pub fn spacing(&self) -> Length {
        match &self.positions {
            Positions::Even { spacing } => *spacing,
            Positions::Own { .. } => self.length() * (1.0 / (self.heights.len().max(2) - 1) as f64),
        }
    }

    /// The trace in even steps from its first point: interpolated linearly, or by a natural cubic spline if roll
    /// lengths were converted. An even trace with the same step is returned unchanged.
    ///
    /// # Errors
    /// When the step is not positive, longer than the trace or shorter than an eighth of the mean step; when two
    /// neighbours of an uneven trace are more than ten mean steps apart: points are missing between them.
    pub fn resampled(&self, step: Length) -> Result<Resampled, ReadError> {
        self.at_step(step)
            .map_err(|fault| fault.in_file(&self.name))
    }

    fn at_step(&self, step: Length) -> Result<Resampled, ReadFault> {
        let whole = self.length() / step * (1.0 + ROUNDING);
        let most = MOST_REFINED * self.heights.len() as f64;
        if !(step.si() > 0.0 && (1.0..=most).contains(&whole)) {
            return Err(self.impossible("the step to resample to", step.si()));
        }
        if let Positions::Even { spacing } = &self.positions
            && *spacing == step
        {
            return Ok(Resampled {
                profile: self.profile(*spacing, self.heights.clone())?,
                rms: Length::from_si(0.0),
                most: Length::from_si(0.0),
            });
        }
        self.in_steps(step.si(), whole as usize)
    }

    fn in_steps(&self, step: f64, intervals: usize) -> Result<Resampled, ReadFault> {
        let x = self.x();
        self.check_gaps(&x)?;
        let between = match self.roll {
            None => Between::Lines,
            Some(_) => Between::Spline,
        };
        let heights = resample::on_grid(&x, &self.heights, step, intervals, between);
        let (rms, most) = resample::change(&x, &self.heights, step, &heights);
        Ok(Resampled {
            profile: self.profile(Length::from_si(step), heights)?,
            rms: Length::from_si(rms),
            most: Length::from_si(most),
        })
    }

    /// The part of the trace in `range`.
    pub(super) fn within(mut self, range: TraceRange) -> Result<Self, ReadFault> {
        let (points, cut) = TraceCut::cut(&self.x(), range)?;
        self.positions = match (self.positions, self.roll) {
            (Positions::Own { x, unevenness }, roll) => {
                let x = x[points.clone()].to_vec();
                match (grid::unevenness(&x), roll) {
                    (None, None) => Positions::Even {
                        spacing: Length::from_si((x[x.len() - 1] - x[0]) / (x.len() - 1) as f64),
                    },
                    _ => own(x, unevenness),
                }
            }
            (even, _) => even,
        };
        self.heights = self.heights[points].to_vec();
        self.metadata.arc_from_base = self.metadata.arc_from_base.map(|arc| arc + cut.start);
        self.cut = Some(cut);
        Ok(self)
    }

    /// Returns an error for steps that are so long that points must be missing.
    fn check_gaps(&self, x: &[f64]) -> Result<(), ReadFault> {
        let mean = self.spacing().si();
        let gap = x
            .windows(2)
            .find(|pair| pair[1] - pair[0] > LONGEST_STEP * mean);
        gap.map_or(Ok(()), |pair| {
            Err(ReadFault::gap_in_positions(
                [pair[0], pair[1]].map(Length::from_si),
                (pair[1] - pair[0]) / mean,
            ))
        })
    }

    /// The trace on an even grid. Converted roll lengths are always resampled; other uneven points are resampled on
    /// request, to the same number of points between the same ends.
    ///
    /// # Errors
    /// When the points are more than a quarter of a spacing off an even grid and `uneven` does not request resampling,
    /// or when points are missing between them.
    pub fn reading(mut self, uneven: Uneven) -> Result<Reading, ReadError> {
        match self.even_profile(uneven) {
            Ok(profile) => Ok(self.with(profile)),
            Err(fault) => Err(fault.in_file(&self.name)),
        }
    }

    fn even_profile(&mut self, uneven: Uneven) -> Result<Profile, ReadFault> {
        let spacing = self.spacing();
        let profile = match (&self.positions, self.roll) {
            (Positions::Even { .. }, _) => {
                let heights = std::mem::take(&mut self.heights);
                self.profile(spacing, heights)?
            }
            (Positions::Own { x, .. }, Some((abscissa, base_radius))) => {
                let steps = x.windows(2).map(|pair| pair[1] - pair[0]);
                let finest = steps.fold(f64::INFINITY, f64::min);
                // The finest step preserves the short waves of the whole trace.
                let length = self.length().si();
                let intervals = (length / finest).ceil().min(MOST_REFINED * x.len() as f64);
                let even = self.in_steps(length / intervals, intervals as usize)?;
                self.warnings.push(Warning::RollLengthConverted {
                    abscissa,
                    base_radius,
                    spacing: even.profile.spacing(),
                });
                even.profile
            }
            (Positions::Own { unevenness, .. }, None) if uneven == Uneven::Resample => {
                let off = unevenness.off;
                let even = self.in_steps(spacing.si(), self.heights.len() - 1)?;
                self.warnings.push(Warning::Resampled {
                    off,
                    spacing,
                    rms: even.rms,
                    most: even.most,
                });
                even.profile
            }
            (Positions::Own { x, unevenness }, None) => {
                let unevenness = *unevenness;
                if !unevenness.is_slight() {
                    self.check_gaps(x)?;
                    return Err(self.too_uneven(unevenness));
                }
                self.warnings.push(Warning::UnevenSpacing {
                    off: unevenness.off,
                    slopes: unevenness.slopes,
                });
                let heights = std::mem::take(&mut self.heights);
                self.profile(spacing, heights)?
            }
        };
        grid::enough(profile.len())?;
        Ok(profile)
    }

    /// Error for a trace that must be even.
    fn too_uneven(&self, found: Unevenness) -> ReadFault {
        ReadFault::uneven_spacing(found.line, found.x, found.off, self.spacing())
    }

    fn impossible(&self, what: &'static str, value: f64) -> ReadFault {
        ReadFault::impossible(what, value, LengthUnit::Metre)
    }

    fn profile(&self, spacing: Length, heights: Vec<f64>) -> Result<Profile, ReadFault> {
        Profile::new(spacing, heights).map_err(|error| self.impossible(error.name, error.value))
    }

    fn with(self, profile: Profile) -> Reading {
        let record = ReadingRecord {
            name: self.name,
            format: self.format,
            encoding: self.encoding,
            table: self.table,
            x_unit: self.x_unit,
            z_unit: self.z_unit,
            spacing: profile.spacing(),
            spacing_source: self.spacing_source,
            length: profile.length(),
            filter_state: self.filter_state,
            points: profile.len(),
            gaps_filled: self.gaps_filled,
            cut: self.cut,
            metadata: self.metadata,
            warnings: self.warnings,
        };
        Reading {
            profile,
            record,
            is_scaled: self.scaled,
        }
        .checked()
    }
}

/// Individual positions \[m\]; after the omission of points they are more uneven than the whole column.
pub(super) fn own(x: Vec<f64>, unevenness: Unevenness) -> Positions {
    let unevenness = match grid::unevenness(&x) {
        Some((_, actual)) => Unevenness {
            off: actual.off,
            slopes: actual.slopes,
            lost_rows: actual.lost_rows,
            ..unevenness
        },
        None => unevenness,
    };
    Positions::Own { x, unevenness }
}
