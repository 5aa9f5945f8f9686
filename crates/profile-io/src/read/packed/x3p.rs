//! X3P, the zip and XML format of ISO 25178-72 (formerly ISO 5436-2).
//!
//! `main.xml` describes the axes (record 1), the measurement (record 2) and the matrix (record 3); the heights are text
//! or in a binary member. A height is value · increment + offset in metres. Profiles (`PRF`), even or with an x at each
//! point, and even surfaces (`SUR`) are read. An extra folder in the archive and a missing namespace are accepted. A
//! different checksum is a warning, because writers disagree on its scope.

use std::io::Read;
use std::ops::Range;

use super::archive::Archive;
use super::hashed::Hashed;
use super::xml::{Leaf, walk};
use crate::read::areal::trace::{Areal, ArealHeights};
use crate::read::damage::{damaged, miscounted, not_a_number};
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::found::Found;
use crate::read::grid::{SpacingSource, chosen_row};
use crate::read::lengths::Lengths;
use crate::read::metadata::{self, Metadata};
use crate::read::options::{LengthUnit, ReadOptions};
use crate::read::text::Stream;
use crate::warning::Warning;

const FORMAT: Format = Format::X3p;

/// Storage of the numbers of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
enum DataType {
    Int16,
    Int32,
    Float32,
    #[default]
    Float64,
}

impl DataType {
    fn width(self) -> usize {
        match self {
            Self::Int16 => 2,
            Self::Int32 | Self::Float32 => 4,
            Self::Float64 => 8,
        }
    }

    fn value(self, bytes: &[u8]) -> Option<f64> {
        Some(match self {
            Self::Int16 => i16::from_le_bytes(bytes.try_into().ok()?).into(),
            Self::Int32 => i32::from_le_bytes(bytes.try_into().ok()?).into(),
            Self::Float32 => f32::from_le_bytes(bytes.try_into().ok()?).into(),
            Self::Float64 => f64::from_le_bytes(bytes.try_into().ok()?),
        })
    }
}

/// One axis of record 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct X3pAxis {
    absolute: bool,
    data: DataType,
    increment: Option<f64>,
    offset: f64,
}

impl X3pAxis {
    fn metres(&self, value: f64) -> f64 {
        value * self.increment.unwrap_or(1.0) + self.offset
    }
}

/// Content of `main.xml`.
#[derive(Debug, Default)]
struct Main {
    feature: String,
    axes: [X3pAxis; 3],
    size: [Option<u64>; 3],
    list: Option<u64>,
    point_data: Option<String>,
    point_checksum: Option<String>,
    mask: Option<String>,
    /// Text data of the requested row: heights, and individual positions if the points have them.
    text: X3pPoints,
    text_count: u64,
    broken_text: Option<String>,
    metadata: Metadata,
}

/// Heights \[m\] and individual x \[m\], if the points have them.
#[derive(Debug, Default)]
struct X3pPoints {
    x: Option<Vec<f64>>,
    z: Vec<f64>,
}

impl Main {
    /// Whether the points of a profile have individual x.
    fn has_own_x(&self) -> bool {
        self.axes[0].absolute && self.feature == "PRF"
    }

    fn points(&self) -> Option<u64> {
        self.size[0].or(self.list)
    }

    fn rows(&self) -> Option<u64> {
        let size = |axis: usize| self.size[axis].unwrap_or(1);
        size(1).checked_mul(size(2))
    }
}

/// Rows that are read.
#[derive(Clone, Copy, PartialEq)]
enum Wanted {
    /// The row with this number, from 1, or the only row.
    Row(Option<usize>),
    FirstLayer,
}

/// Reads the profile of an X3P file.
pub(super) fn read(
    stream: &mut dyn Stream,
    size: u64,
    options: &ReadOptions,
) -> Result<Found, ReadFault> {
    let found = matrix(stream, size, Wanted::Row(options.row))?;
    let [dx, _] = found.spacings();
    Ok(Found {
        x: found.points.x.map(|x| Lengths::new(x, LengthUnit::Metre)),
        spacing: dx.map(|dx| (Lengths::new(dx, LengthUnit::Metre), SpacingSource::Header)),
        metadata: found.main.metadata,
        warnings: found.warnings,
        ..Found::new(FORMAT, Lengths::new(found.points.z, LengthUnit::Metre))
    })
}

/// Reads all rows of the first layer of an X3P file.
pub(super) fn surface(stream: &mut dyn Stream, size: u64) -> Result<Areal, ReadFault> {
    let found = matrix(stream, size, Wanted::FirstLayer)?;
    let spacings = found.spacings();
    let heights = ArealHeights::Values {
        columns: found.main.points().unwrap_or(0) as usize,
        values: found.points.z,
    };
    Ok(Areal {
        spacings: spacings.map(|step| step.map(|step| Lengths::new(step, LengthUnit::Metre))),
        metadata: found.main.metadata,
        warnings: found.warnings,
        ..Areal::from_heights(FORMAT, Lengths::new(heights, LengthUnit::Metre))
    })
}

/// Points of the requested rows.
struct X3pMatrix {
    main: Main,
    points: X3pPoints,
    warnings: Vec<Warning>,
}

impl X3pMatrix {
    /// Positive increments along x and y; `None` for absolute axes.
    fn spacings(&self) -> [Option<f64>; 2] {
        [0, 1].map(|axis| {
            let found = self.main.axes[axis];
            let increment = found.increment.filter(|_| !found.absolute);
            increment.filter(|dx| *dx > 0.0 && dx.is_finite())
        })
    }
}

fn matrix(stream: &mut dyn Stream, size: u64, wanted: Wanted) -> Result<X3pMatrix, ReadFault> {
    let mut archive = Archive::open(FORMAT, stream, size)?;
    let name = archive.find("main.xml");
    let name = name.ok_or_else(|| damaged(FORMAT, "it holds no main.xml", ""))?;
    let (mut main, found) = archive.read(&name, |stream| {
        let mut hashed = Hashed::new(stream);
        let mut main = Main::default();
        if !walk(&mut hashed, |leaf| take(&mut main, &leaf, wanted)) {
            return Err(damaged(FORMAT, "main.xml is not sound XML", ""));
        }
        Ok((main, hashed.finish()))
    })?;
    let folder = name[..name.len() - "main.xml".len()].to_owned();
    let mut warnings = Vec::new();
    main_checksum(&mut archive, &folder, &found, &mut warnings)?;
    let rows = chosen_rows(&main, wanted)?;
    let points = match main.point_data.clone() {
        Some(link) => binary(&mut archive, &folder, &link, &main, rows, &mut warnings)?,
        None => text(&mut main, rows)?,
    };
    Ok(X3pMatrix {
        main,
        points,
        warnings,
    })
}

/// Stores the content of an element of `main.xml`.
fn take(main: &mut Main, leaf: &Leaf<'_>, wanted: Wanted) -> bool {
    let text = leaf.text;
    let axis = match leaf.parent() {
        "CX" => Some(0),
        "CY" => Some(1),
        "CZ" => Some(2),
        _ => None,
    };
    if let Some(axis) = axis.map(|at| &mut main.axes[at]) {
        match leaf.name() {
            "AxisType" => axis.absolute = text == "A",
            "DataType" => {
                axis.data = match text {
                    "I" => DataType::Int16,
                    "L" => DataType::Int32,
                    "F" => DataType::Float32,
                    _ => DataType::Float64,
                }
            }
            "Increment" => axis.increment = metadata::number(text),
            "Offset" => axis.offset = metadata::number(text).unwrap_or(0.0),
            _ => {}
        }
        return true;
    }
    match leaf.name() {
        "FeatureType" => main.feature = text.to_owned(),
        "SizeX" => main.size[0] = text.parse().ok(),
        "SizeY" => main.size[1] = text.parse().ok(),
        "SizeZ" => main.size[2] = text.parse().ok(),
        "ListDimension" => main.list = text.parse().ok(),
        "PointDataLink" => main.point_data = Some(text.to_owned()),
        "MD5ChecksumPointData" => main.point_checksum = Some(text.to_lowercase()),
        "ValidPointsLink" => main.mask = Some(text.to_owned()),
        "Datum" => datum(main, text, wanted),
        "Date" => main.metadata.date = metadata::short(text),
        "Comment" => main.metadata.title = metadata::short(text),
        "Manufacturer" => main.metadata.instrument = metadata::short(text),
        "Model" => {
            let before = main.metadata.instrument.take().unwrap_or_default();
            main.metadata.instrument = metadata::short(&format!("{before} {text}"));
        }
        _ => {}
    }
    true
}

/// Stores a point of text data if it is in a requested row; an empty point is missing.
fn datum(main: &mut Main, text: &str, wanted: Wanted) {
    let at = main.text_count;
    main.text_count += 1;
    let points = main.points().unwrap_or(u64::MAX).max(1);
    let is_wanted = match wanted {
        Wanted::Row(row) => at / points == row.unwrap_or(1).max(1) as u64 - 1,
        Wanted::FirstLayer => at / points < main.size[1].unwrap_or(1),
    };
    if !is_wanted {
        return;
    }
    let last = text.rsplit(';').next().unwrap_or_default();
    let z = coordinate(main, 2, last);
    main.text.z.push(z);
    if main.has_own_x() {
        let first = text.split(';').next().unwrap_or_default();
        let x = coordinate(main, 0, first);
        if x.is_nan() {
            main.broken_text.get_or_insert_with(|| text.to_owned());
        }
        main.text.x.get_or_insert_default().push(x);
    }
}

/// A coordinate \[m\] of a point in text data; NaN if it is empty.
fn coordinate(main: &mut Main, axis: usize, text: &str) -> f64 {
    let value = match text.trim() {
        "" => f64::NAN,
        text => match text.parse::<f64>() {
            Ok(value) => value,
            Err(_) => {
                main.broken_text.get_or_insert_with(|| text.to_owned());
                f64::NAN
            }
        },
    };
    main.axes[axis].metres(value)
}

/// The rows to read, counted from 0.
fn chosen_rows(main: &Main, wanted: Wanted) -> Result<Range<u64>, ReadFault> {
    if main.axes[0].absolute && !(main.has_own_x() && wanted != Wanted::FirstLayer) {
        return Err(ReadFault::no_heights(
            FORMAT,
            "points with an x of their own, and only profiles of such are read",
        ));
    }
    let points = main.points();
    let size = points
        .zip(main.rows())
        .filter(|(points, rows)| *points > 0 && *rows > 0);
    let (points, rows) = size.ok_or_else(|| damaged(FORMAT, "the matrix has no size", ""))?;
    let Wanted::Row(row) = wanted else {
        // Further layers are not rows of the first.
        return Ok(0..main.size[1].unwrap_or(1));
    };
    let row = chosen_row(row, rows as usize, points as usize)? as u64;
    Ok(row..row + 1)
}

fn text(main: &mut Main, rows: Range<u64>) -> Result<X3pPoints, ReadFault> {
    if let Some(seen) = &main.broken_text {
        return Err(not_a_number(FORMAT, seen));
    }
    let points = std::mem::take(&mut main.text);
    let stated = main
        .points()
        .unwrap_or(0)
        .saturating_mul(rows.end - rows.start);
    if points.z.len() as u64 != stated {
        return Err(miscounted(FORMAT, points.z.len(), stated));
    }
    Ok(points)
}

/// Heights of `rows` from the binary member, with their mask and its checksum.
fn binary(
    archive: &mut Archive<'_>,
    folder: &str,
    link: &str,
    main: &Main,
    rows: Range<u64>,
    warnings: &mut Vec<Warning>,
) -> Result<X3pPoints, ReadFault> {
    let [x, y, z] = main.axes;
    let width = main.points().unwrap_or(0);
    let points = width.saturating_mul(rows.end - rows.start);
    // An absolute x and y precede z.
    let width_of = |axis: X3pAxis| if axis.absolute { axis.data.width() } else { 0 };
    let skipped = width_of(x) + width_of(y);
    let stride = skipped + z.data.width();
    let first = rows.start.checked_mul(width);
    let start = first.and_then(|n| n.checked_mul(stride as u64));
    let length = points.checked_mul(stride as u64);
    let too_large = || ReadFault::too_large("the matrix", u64::MAX, i64::MAX as u64);
    let (start, length) = start.zip(length).ok_or_else(too_large)?;
    let name = archive_name(archive, folder, link);
    let (window, found) = archive.read(&name, |stream| {
        let mut hashed = Hashed::new(stream);
        let skipped = std::io::copy(&mut (&mut hashed).take(start), &mut std::io::sink());
        let mut window = Vec::new();
        let read = (&mut hashed).take(length).read_to_end(&mut window);
        let rest = std::io::copy(&mut hashed, &mut std::io::sink());
        let whole = skipped.is_ok() && read.is_ok() && rest.is_ok();
        if !whole || window.len() as u64 != length {
            let what = "the binary data is shorter than the matrix";
            return Err(damaged(FORMAT, what, link));
        }
        Ok((window, hashed.finish()))
    })?;
    if let Some(stated) = main
        .point_checksum
        .as_ref()
        .filter(|stated| **stated != found)
    {
        warnings.push(Warning::ChecksumDiffers {
            what: "point data".into(),
            stated: crate::read::error::shortened(stated),
            found,
        });
    }
    let first = first.unwrap_or(0);
    let mask = mask(archive, folder, main, first..first + points)?;
    let heights = window.chunks_exact(stride).enumerate().map(|(i, point)| {
        let valid = mask.as_ref().is_none_or(|mask| mask.get(i) == Some(&true));
        let value = z.data.value(&point[skipped..]).filter(|_| valid);
        value.map_or(f64::NAN, |value| z.metres(value))
    });
    let heights = heights.collect();
    let place = |point: &[u8]| Some(x.metres(x.data.value(point.get(..x.data.width())?)?));
    let x = if x.absolute {
        let places: Option<Vec<f64>> = window.chunks_exact(stride).map(place).collect();
        let finite = places.filter(|places| places.iter().all(|x| x.is_finite()));
        Some(finite.ok_or_else(|| damaged(FORMAT, "a point has no x", link))?)
    } else {
        None
    };
    Ok(X3pPoints { x, z: heights })
}

/// Full name of a linked member: links are relative to `main.xml`, and some start with "./".
fn archive_name(archive: &Archive<'_>, folder: &str, link: &str) -> String {
    let link = link.replace('\\', "/");
    let link = link.trim_start_matches("./").trim_start_matches('/');
    let relative = format!("{folder}{link}");
    if archive.holds(&relative) {
        return relative;
    }
    let last = link.rsplit('/').next().unwrap_or_default();
    archive.find(last).unwrap_or(relative)
}

/// Validity of `points`: one bit per point, lowest first, or one byte per point.
fn mask(
    archive: &mut Archive<'_>,
    folder: &str,
    main: &Main,
    points: Range<u64>,
) -> Result<Option<Vec<bool>>, ReadFault> {
    let Some(link) = main.mask.as_ref().filter(|link| !link.is_empty()) else {
        return Ok(None);
    };
    let name = archive_name(archive, folder, link);
    let width = main.points().unwrap_or(0);
    let all = width.saturating_mul(main.rows().unwrap_or(1));
    let packed = archive.read(&name, |stream| {
        let mut packed = Vec::new();
        let read = stream.take(all).read_to_end(&mut packed);
        read.map(|_| packed)
            .map_err(|_| damaged(FORMAT, "the mask cannot be unpacked", link))
    })?;
    let bytewise = packed.len() as u64 == all;
    if !bytewise && (packed.len() as u64) < all.div_ceil(8) {
        return Err(damaged(FORMAT, "the mask is shorter than the matrix", link));
    }
    let valid = |at: u64| {
        if bytewise {
            packed[at as usize] != 0
        } else {
            packed[(at / 8) as usize] >> (at % 8) & 1 == 1
        }
    };
    Ok(Some(points.map(valid).collect()))
}

/// Adds a warning if `md5checksum.hex` exists but differs from the checksum of `main.xml`, or cannot be unpacked.
fn main_checksum(
    archive: &mut Archive<'_>,
    folder: &str,
    found: &str,
    warnings: &mut Vec<Warning>,
) -> Result<(), ReadFault> {
    const DIGITS: u64 = 64;
    let name = format!("{folder}md5checksum.hex");
    if !archive.holds(&name) {
        return Ok(());
    }
    let stated = archive.read(&name, |stream| {
        let mut text = Vec::new();
        // The readable part of a damaged member depends on the size of the reads, so it is not used.
        if stream.take(DIGITS).read_to_end(&mut text).is_err() {
            text.clear();
        }
        Ok(String::from_utf8_lossy(&text).to_lowercase())
    })?;
    let stated = stated.split_whitespace().next().unwrap_or_default();
    if stated != found {
        warnings.push(Warning::ChecksumDiffers {
            what: "main.xml".into(),
            stated: crate::read::error::shortened(stated),
            found: found.to_owned(),
        });
    }
    Ok(())
}
