//! Profiles as X3P (ISO 25178-72): XML description, binary heights, checksums.

use std::io::{Cursor, Write};

use asperity_storage::hex;
use md5::{Digest, Md5};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::error::WriteError;
use super::field::field;
use super::places::Places;
use crate::read::metadata::Metadata;

const DATA: &str = "bindata/data.bin";

/// Writes an archive with `main.xml`, its checksum and the heights as binary64 metres, each after its x if the points
/// have individual x. The heights are row by row, `across` being the number of rows and their distance \[m\]; `None` for a
/// profile.
pub(super) fn write(
    places: Places<'_>,
    heights: &[f64],
    across: Option<(usize, f64)>,
    metadata: &Metadata,
) -> Result<Vec<u8>, WriteError> {
    let data: Vec<u8> = match places {
        Places::Even(_) => heights.iter().flat_map(|z| z.to_le_bytes()).collect(),
        Places::Own(x) => {
            let numbers = x.iter().zip(heights).flat_map(|(x, z)| [x, z]);
            numbers.flat_map(|number| number.to_le_bytes()).collect()
        }
    };
    let points = heights.len() / across.map_or(1, |(rows, _)| rows.max(1));
    let xml = main_xml(places, points, across, metadata, &checksum(&data));
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    // The default date is constant, so that the same profile gives the same bytes.
    let options = SimpleFileOptions::default();
    let checksum_file = format!("{} *main.xml\n", checksum(xml.as_bytes()));
    let members = [
        ("main.xml", xml.as_bytes()),
        ("md5checksum.hex", checksum_file.as_bytes()),
        (DATA, &data),
    ];
    for (name, bytes) in members {
        let failed = |step| move |_| WriteError::archive(step);
        zip.start_file(name, options).map_err(failed(name))?;
        zip.write_all(bytes)
            .map_err(|_| WriteError::archive(name))?;
    }
    let done = zip.finish();
    let done = done.map_err(|_| WriteError::archive("the directory"))?;
    Ok(done.into_inner())
}

fn checksum(bytes: &[u8]) -> String {
    hex(&Md5::digest(bytes))
}

fn main_xml(
    places: Places<'_>,
    points: usize,
    across: Option<(usize, f64)>,
    metadata: &Metadata,
    data_checksum: &str,
) -> String {
    let text =
        |value: &Option<String>, otherwise: &str| field(value.as_deref().unwrap_or(otherwise));
    let axis = |name: &str, kind: &str, increment: f64| {
        format!(
            "<{name}><AxisType>{kind}</AxisType><DataType>D</DataType>\
             <Increment>{increment:e}</Increment><Offset>0</Offset></{name}>"
        )
    };
    let (kind, dx) = match places {
        Places::Even(dx) => ("I", dx),
        Places::Own(_) => ("A", 1.0),
    };
    // A profile has one row, so the increment of CY has no meaning.
    let (feature, rows, dy) = match across {
        Some((rows, dy)) => ("SUR", rows, dy),
        None => ("PRF", 1, dx),
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\
         <Record1><Revision>ISO5436 - 2000</Revision><FeatureType>{feature}</FeatureType><Axes>{}{}{}</Axes></Record1>\
         <Record2><Date>{}</Date><Instrument><Manufacturer>{}</Manufacturer><Model/><Serial/><Version/></Instrument>\
         <CalibrationDate/><ProbingSystem><Type>Contacting</Type><Identification/></ProbingSystem>\
         <Comment>{}</Comment></Record2>\
         <Record3><MatrixDimension><SizeX>{}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension>\
         <DataLink><PointDataLink>{DATA}</PointDataLink>\
         <MD5ChecksumPointData>{data_checksum}</MD5ChecksumPointData></DataLink></Record3>\
         <Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>\n",
        axis("CX", kind, dx),
        axis("CY", "I", dy),
        axis("CZ", "A", 1.0),
        text(&metadata.date, ""),
        text(&metadata.instrument, ""),
        text(&metadata.title, ""),
        points,
    )
}
