//! HDF5: MATLAB data of level 7.3, surfaces of Zygo Mx (datx), and arrays that other programs wrote.
//!
//! Layout of datx: reader and test of SurfaceTopography (`DATX.py`, `test_datx.py`), which follow Gwyddion's
//! `datxfile.c`. `/Data/Surface` holds the heights, row by row. Attributes of the heights: `Unit`, `No Data`, and for each
//! axis a converter (category, unit, parameters): parameter 1 of X and Y is the spacing in metres; parameters 1 to 3 of Z
//! are wavelength, scale and obliquity factor, whose product is the height of a fringe in metres. MATLAB stores a matrix
//! with its sizes in reverse order, and states the class of each array.

use std::collections::BTreeSet;

use hdf5_reader::error::Error;
use hdf5_reader::group::Group;
use hdf5_reader::messages::datatype::Datatype;
use hdf5_reader::{Attribute, Dataset, Hdf5File, OpenOptions};

use super::bytes::{PlainBytes, part};
use super::chosen::chosen;
use super::held::most_unpacked;
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header::is_depth;
use crate::read::lengths::Lengths;
use crate::read::metadata::short;
use crate::warning::Warning;

/// Maximum number of groups, and so of their depth.
const MOST_GROUPS: usize = 100;
/// Maximum number of arrays; a file of lab data has some dozens.
const MOST_ARRAYS: usize = 10_000;
/// Maximum number of heights: 1 GiB as doubles.
const MOST_HEIGHTS: u64 = 1 << 27;
/// Classes of MATLAB that hold real numbers.
const NUMERIC: [&str; 10] = [
    "double", "single", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64",
];

/// Reads the heights of a file of MATLAB or of another program; they have neither unit nor spacing.
pub(super) fn arrays(bytes: &[u8], format: Format) -> Result<Areal, ReadFault> {
    let is_matlab = format == Format::Matlab;
    let fault = |error: Error| damaged(format, "HDF5", &error.to_string());
    let root = opened(bytes).map_err(fault)?;
    let mut all = Vec::new();
    collect(&root, "", &mut BTreeSet::new(), &mut all).map_err(fault)?;
    all.retain(|(_, dataset)| is_heights(dataset, is_matlab));
    let (name, dataset) = chosen(format, all)?;
    let values = numbers(&dataset).map_err(fault)?;
    let [rows, columns] = size(&dataset);
    // MATLAB stores a matrix column by column, and states its sizes in reverse order. A vector is a profile.
    let (values, columns) = match rows == 1 || columns == 1 {
        true => (values, rows.max(columns)),
        false if is_matlab => {
            let transposed =
                (0..columns).flat_map(|row| (0..rows).map(move |column| (row, column)));
            let height =
                |(row, column): (usize, usize)| values.get(column * columns + row).copied();
            (transposed.filter_map(height).collect(), rows)
        }
        false => (values, columns),
    };
    let numbers = Lengths::Numbers(ArealHeights::Values { values, columns }, None);
    let mut found = Areal::from_heights(format, numbers);
    let last = name.rsplit('/').next().unwrap_or_default();
    found
        .warnings
        .extend(is_depth(last).then_some(Warning::DepthsTurned));
    found.metadata.title = short(&name);
    Ok(found)
}

/// Reads the surface of a datx file.
pub(super) fn datx(bytes: &[u8]) -> Result<Areal, ReadFault> {
    const FORMAT: Format = Format::ZygoDatx;
    let fault = |error: Error| damaged(FORMAT, "HDF5", &error.to_string());
    let root = opened(bytes).map_err(fault)?;
    let surfaces = root.group("Data").and_then(|data| data.group("Surface"));
    let surfaces = surfaces.and_then(|group| group.datasets()).map_err(fault)?;
    let [surface] = surfaces.as_slice() else {
        let seen = surfaces.len().to_string();
        return Err(damaged(
            FORMAT,
            "the number of its surfaces is not 1",
            &seen,
        ));
    };
    let mut values = numbers(surface).map_err(fault)?;
    if let Some(mark) = attribute(surface, "No Data").and_then(|mark| number(&mark)) {
        let is_missing = |z: f64| z == mark || (mark > 0.0 && z > mark);
        for z in values.iter_mut().filter(|z| is_missing(**z)) {
            *z = f64::NAN;
        }
    }
    let [x, y, z] =
        ["X Converter", "Y Converter", "Z Converter"].map(|name| converter(surface, name));
    let unit =
        attribute(surface, "Unit").and_then(|unit| unit.read_strings().ok()?.into_iter().next());
    let unit = unit
        .or_else(|| z.as_ref().map(|z| z.unit.clone()))
        .unwrap_or_default();
    let per_metre = match unit.to_lowercase().as_str() {
        "meters" | "m" => 1.0,
        "millimeters" | "mm" => 1e3,
        "micrometers" | "microns" | "um" => 1e6,
        "nanometers" | "nm" => 1e9,
        "angstroms" => 1e10,
        "picometers" | "pm" => 1e12,
        "fringes" | "fringe" => {
            let fringe = z.map(|z| z.parameters.iter().skip(1).take(3).product::<f64>());
            1.0 / fringe.filter(|height| *height > 0.0).unwrap_or(f64::NAN)
        }
        _ => f64::NAN,
    };
    if !per_metre.is_finite() {
        return Err(damaged(
            FORMAT,
            "the unit of its heights is not known",
            &unit,
        ));
    }
    for z in &mut values {
        *z /= per_metre;
    }
    let spacing = |axis: Option<Converter>| {
        let pixels = axis.filter(|axis| axis.unit.eq_ignore_ascii_case("pixels"));
        pixels
            .and_then(|axis| axis.parameters.get(1).copied())
            .unwrap_or(f64::NAN)
    };
    let [_, columns] = size(surface);
    Ok(Areal::new(FORMAT, ArealHeights::Values { values, columns }).spaced(spacing(x), spacing(y)))
}

/// The first group of a file, opened with a limit of the size that its arrays may have.
fn opened(bytes: &[u8]) -> Result<Group, Error> {
    let most = usize::try_from(most_unpacked(bytes.len() as u64)).unwrap_or(usize::MAX);
    let options = OpenOptions::default();
    let options = options.with_max_chunk_bytes(most).with_max_read_bytes(most);
    let options = options.with_chunk_cache_bytes(0);
    Hdf5File::from_bytes_with_options(bytes, options)?.root_group()
}

/// Adds the arrays in `group` and in its groups by their path. Groups that start with # belong to MATLAB; a group that several
/// links name is read once, so that links in a circle end.
fn collect(
    group: &Group,
    path: &str,
    seen: &mut BTreeSet<u64>,
    all: &mut Vec<(String, Dataset)>,
) -> Result<(), Error> {
    let (groups, datasets) = group.members()?;
    for dataset in datasets {
        all.push((format!("{path}{}", dataset.name()), dataset));
    }
    for inner in groups {
        let name = inner.name();
        if seen.len() < MOST_GROUPS
            && all.len() < MOST_ARRAYS
            && !name.starts_with('#')
            && seen.insert(inner.address())
        {
            collect(&inner, &format!("{path}{name}/"), seen, all)?;
        }
    }
    Ok(())
}

/// Whether an array can be heights: real numbers in one or two dimensions, more than one of them. Each matrix of MATLAB has
/// two dimensions; of an empty one the file holds the sizes, in one.
fn is_heights(dataset: &Dataset, is_matlab: bool) -> bool {
    let class = || attribute(dataset, "MATLAB_class")?.read_string().ok();
    let is_real = matches!(
        dataset.dtype(),
        Datatype::FixedPoint { .. } | Datatype::FloatingPoint { size: 4 | 8, .. }
    );
    let is_numeric = !is_matlab || class().is_some_and(|class| NUMERIC.contains(&class.as_str()));
    is_real
        && is_numeric
        && (1 + usize::from(is_matlab)..=2).contains(&dataset.ndim())
        && size(dataset).iter().any(|n| *n > 1)
}

/// Rows and columns as the file stores them.
fn size(dataset: &Dataset) -> [usize; 2] {
    let length = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
    match *dataset.shape() {
        [rows, columns] => [length(rows), length(columns)],
        [columns] => [1, length(columns)],
        _ => [0, 0],
    }
}

/// The numbers of an array in the order of the file.
fn numbers(dataset: &Dataset) -> Result<Vec<f64>, Error> {
    // The reader's arrays of ten types are 0.2 MB of code.
    fn of<const N: usize>(bytes: &[u8], number: fn([u8; N]) -> f64) -> Vec<f64> {
        let (numbers, _) = bytes.as_chunks();
        numbers.iter().map(|bytes| number(*bytes)).collect()
    }
    if dataset.num_elements()? > MOST_HEIGHTS {
        return Err(Error::InvalidData("more than 2²⁷ heights".to_owned()));
    }
    let kind = match *dataset.dtype() {
        Datatype::FloatingPoint { size, .. } => (true, true, size),
        Datatype::FixedPoint { size, signed, .. } => (false, signed, size),
        _ => (false, false, 0),
    };
    let bytes = || dataset.read_native_bytes();
    Ok(match kind {
        (true, _, 8) => of(&bytes()?, f64::from_ne_bytes),
        (true, _, 4) => of(&bytes()?, |z| f32::from_ne_bytes(z).into()),
        (false, true, 1) => of(&bytes()?, |z| i8::from_ne_bytes(z).into()),
        (false, false, 1) => of(&bytes()?, |[z]| z.into()),
        (false, true, 2) => of(&bytes()?, |z| i16::from_ne_bytes(z).into()),
        (false, false, 2) => of(&bytes()?, |z| u16::from_ne_bytes(z).into()),
        (false, true, 4) => of(&bytes()?, |z| i32::from_ne_bytes(z).into()),
        (false, false, 4) => of(&bytes()?, |z| u32::from_ne_bytes(z).into()),
        // Numbers beyond 2⁵³ are rounded; no instrument has such numbers.
        (false, true, 8) => of(&bytes()?, |z| i64::from_ne_bytes(z) as f64),
        (false, false, 8) => of(&bytes()?, |z| u64::from_ne_bytes(z) as f64),
        _ => return Err(Error::InvalidData("the heights are not numbers".to_owned())),
    })
}

fn attribute(dataset: &Dataset, name: &str) -> Option<Attribute> {
    dataset.attribute(name).ok()
}

/// The first number of an attribute.
fn number(attribute: &Attribute) -> Option<f64> {
    let bytes = attribute.raw_data.as_slice();
    match attribute.datatype {
        Datatype::FloatingPoint { size: 4, .. } => f32::little(part(bytes, 0, 4)?).map(f64::from),
        Datatype::FloatingPoint { size: 8, .. } => f64::little(part(bytes, 0, 8)?),
        Datatype::FixedPoint {
            size: 4,
            signed: true,
            ..
        } => i32::little(part(bytes, 0, 4)?).map(f64::from),
        _ => None,
    }
}

/// Unit and parameters of an axis.
struct Converter {
    unit: String,
    parameters: Vec<f64>,
}

/// The converter of an axis: a compound of texts and of numbers, each of variable length.
fn converter(surface: &Dataset, name: &str) -> Option<Converter> {
    let attribute = attribute(surface, name)?;
    let Datatype::Compound { fields, .. } = &attribute.datatype else {
        return None;
    };
    let content = |name: &str, width| {
        let field = fields.iter().find(|field| field.name == name)?;
        let at = usize::try_from(field.byte_offset).ok()?;
        match field.datatype {
            Datatype::VarLen { .. } => {
                let reference = part(&attribute.raw_data, at, surface.vlen_reference_size())?;
                surface.resolve_vlen_reference_bytes(reference, width).ok()
            }
            _ => None,
        }
    };
    let unit = content("BaseUnit", 1)?;
    let parameters = content("Parameters", 8)?;
    let (parameters, _) = parameters.as_chunks::<8>();
    Some(Converter {
        unit: String::from_utf8_lossy(&unit)
            .trim_end_matches('\0')
            .to_owned(),
        parameters: parameters
            .iter()
            .map(|bytes| f64::from_le_bytes(*bytes))
            .collect(),
    })
}
