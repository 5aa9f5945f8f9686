//! Charts as SVG: complete without scripts, every axis with its unit, every chart with the name of its data file.
//!
//! A [`Chart`] holds curves over an axis, a [`BarChart`] bars from zero, a [`Tornado`] intervals about a middle,
//! a [`Strip`] shares along the path of contact, a [`Contour`] a field, a [`MeshPicture`] two gears in mesh, a [`Facing`] two
//! flanks in contact at one of several positions, a [`TextureSymbol`] the call-out of a drawing. Each is drawn for a page, which adds
//! title and legend as text, or as a separate file.

mod axis;
mod bars;
mod canvas;
mod contour;
mod drawing;
mod dress;
mod facing;
mod frame;
mod mesh;
mod spread;
mod stacked;
mod steps;
mod strip;
mod symbol;
mod text_width;
mod xy;

pub(crate) use axis::round_ticks;
pub use axis::{Axis, Scale};
pub use bars::{Bar, BarChart, Interval, Tornado};
pub use contour::Contour;
pub use drawing::Drawing;
pub use dress::{Dress, STYLE};
pub use facing::{Facing, FacingFrame};
pub(crate) use mesh::ASPECT;
pub use mesh::{MeshBody, MeshPicture, MeshPoint, MeshTrace};
pub use stacked::stacked;
pub use strip::Strip;
pub use symbol::TextureSymbol;
pub use xy::{Chart, Level, Line, Mark, Series};
