//! The enumeration of all charts.

use super::bars::{BarChart, Tornado};
use super::contour::Contour;
use super::dress::Dress;
use super::facing::Facing;
use super::mesh::MeshPicture;
use super::strip::Strip;
use super::symbol::TextureSymbol;
use super::xy::Chart;

/// Chart of any kind.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawing {
    /// Curves.
    Curves(Chart),
    /// Bars.
    Bars(BarChart),
    /// Intervals about a middle.
    Tornado(Tornado),
    /// Shares along the path.
    Strip(Strip),
    /// A field.
    Contour(Contour),
    /// Two gears in mesh.
    Mesh(MeshPicture),
    /// Two flanks in contact.
    Facing(Facing),
    /// A symbol of surface texture.
    Symbol(TextureSymbol),
}

impl Drawing {
    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        match self {
            Self::Curves(chart) => chart.svg(dress),
            Self::Bars(chart) => chart.svg(dress),
            Self::Tornado(chart) => chart.svg(dress),
            Self::Strip(chart) => chart.svg(dress),
            Self::Contour(chart) => chart.svg(dress),
            Self::Mesh(chart) => chart.svg(dress),
            Self::Facing(chart) => chart.svg(dress),
            Self::Symbol(symbol) => symbol.svg(dress),
        }
    }

    /// CSS class of the drawing and of the samples in its legend; styles apply per kind.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Curves(_) => Chart::KIND,
            Self::Bars(_) => BarChart::KIND,
            Self::Tornado(_) => Tornado::KIND,
            Self::Strip(_) => Strip::KIND,
            Self::Contour(_) => Contour::KIND,
            Self::Mesh(_) => MeshPicture::KIND,
            Self::Facing(_) => Facing::KIND,
            Self::Symbol(_) => TextureSymbol::KIND,
        }
    }

    /// Identifier for links.
    pub fn id(&self) -> &str {
        match self {
            Self::Curves(chart) => &chart.id,
            Self::Bars(chart) => &chart.id,
            Self::Tornado(chart) => &chart.id,
            Self::Strip(chart) => &chart.id,
            Self::Contour(chart) => &chart.id,
            Self::Mesh(chart) => &chart.id,
            Self::Facing(chart) => &chart.id,
            Self::Symbol(symbol) => &symbol.id,
        }
    }

    /// Title of the drawing.
    pub fn title(&self) -> &str {
        match self {
            Self::Curves(chart) => &chart.title,
            Self::Bars(chart) => &chart.title,
            Self::Tornado(chart) => &chart.title,
            Self::Strip(chart) => &chart.title,
            Self::Contour(chart) => &chart.title,
            Self::Mesh(chart) => &chart.title,
            Self::Facing(chart) => &chart.title,
            Self::Symbol(symbol) => &symbol.title,
        }
    }

    /// Name of its data file.
    pub fn source(&self) -> &str {
        match self {
            Self::Curves(chart) => &chart.source,
            Self::Bars(chart) => &chart.source,
            Self::Tornado(chart) => &chart.source,
            Self::Strip(chart) => &chart.source,
            Self::Contour(chart) => &chart.source,
            Self::Mesh(chart) => &chart.source,
            Self::Facing(chart) => &chart.source,
            Self::Symbol(symbol) => &symbol.source,
        }
    }

    /// Data for zoom and read-off by the script; `None` for charts without them.
    pub fn data(&self) -> Option<serde_json::Value> {
        match self {
            Self::Curves(chart) => Some(chart.data()),
            Self::Contour(chart) => Some(chart.data()),
            _ => None,
        }
    }

    /// Names of the curves with their CSS classes.
    pub fn legend(&self) -> Vec<(String, String)> {
        match self {
            Self::Curves(chart) => chart.legend(),
            Self::Mesh(picture) => picture.legend(),
            Self::Facing(_) => Facing::legend(),
            _ => Vec::new(),
        }
    }
}
