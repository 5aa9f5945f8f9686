//! A first look at a profile file, as soon as it is chosen.

use asperity::core::Profile;
use asperity::profile_io::read::{LengthUnit, ReadOptions, read_bytes};
use asperity::quantity::Length;
use asperity_report::chart::{Axis, Chart, Dress, Line};
use asperity_report::html::on_flank;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;

/// Statements of the form about a file.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Stated {
    /// Spacing of the points.
    pub dx: Option<Length>,
    /// Unit of the heights.
    pub z_unit: Option<LengthUnit>,
    /// Whether the trace is read from its other end.
    pub mirrored: bool,
}

/// What a profile file holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Look {
    /// Number of points.
    pub points: usize,
    /// Distance between points \[µm\].
    pub spacing_um: f64,
    /// Length of the trace \[mm\].
    pub length_mm: f64,
    /// Unit of the heights in the file.
    pub z_unit: String,
    /// Doubts about the file, with their codes.
    pub warnings: Vec<String>,
    /// The trace as SVG.
    pub svg: String,
}

/// Height of the drawn trace in units of the drawing.
const HEIGHT: f64 = 110.0;

/// The trace in the direction in which it is read, its mean at 0.
fn drawing(profile: &Profile, flank: &str, is_mirrored: bool) -> Chart {
    let profile = if is_mirrored { &profile.mirrored() } else { profile };
    let heights = profile.heights();
    let mean = heights.iter().sum::<f64>() / heights.len() as f64;
    let z: Vec<f64> = heights.iter().map(|z| (z - mean) / 1e-6).collect();
    let dx = profile.spacing().si() / 1e-3;
    let x: Vec<f64> = (0..z.len()).map(|i| dx * i as f64).collect();
    // The identifiers of both drawings are in the same page.
    let chart = Chart::new(
        &format!("trace-{}", flank.replace('.', "-")),
        "The trace as read",
        "",
        on_flank(usize::from(flank.contains("wheel")), is_mirrored),
        Axis::new("height", "µm"),
    );
    Chart {
        height: HEIGHT,
        ..chart.curve("height", Line::Solid, &x, &z)
    }
}

/// Reads `bytes`, the content of the file `name` of the flank at `flank` of the case.
///
/// # Errors
/// When it is no profile, or something must be stated about it.
///
/// ```
/// use asperity_web::{Stated, look};
/// let heights: String = (0..200).map(|i| format!("0.{}\n", i % 7)).collect();
/// let stated = Stated { dx: Some("0.5 um".parse()?), z_unit: Some("um".parse()?), ..Stated::default() };
/// let found = look("flank.txt", heights.as_bytes(), "surface.pinion", &stated).unwrap();
/// assert_eq!((found.points, found.spacing_um, found.z_unit.as_str()), (200, 0.5, "um"));
/// let refused = look("flank.txt", heights.as_bytes(), "surface.wheel", &Stated::default()).unwrap_err();
/// assert!(refused.message.ends_with("in surface.wheel"), "{}", refused.message);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn look(name: &str, bytes: &[u8], flank: &str, stated: &Stated) -> Result<Look, Failure> {
    let options = ReadOptions {
        dx: stated.dx,
        z_unit: stated.z_unit,
        ..ReadOptions::default()
    };
    let refused = |error| Failure::of_reading(&error, flank);
    let reading = read_bytes(name, bytes, &options).map_err(refused)?;
    reading.check_heights().map_err(refused)?;
    Ok(Look {
        points: reading.points,
        spacing_um: reading.spacing.si() / 1e-6,
        length_mm: reading.length.si() / 1e-3,
        z_unit: reading.z_unit.to_string(),
        warnings: reading
            .warnings
            .iter()
            .map(|warning| format!("{} {warning}", warning.code()))
            .collect(),
        svg: drawing(&reading.profile, flank, stated.mirrored).svg(Dress::Page),
    })
}
