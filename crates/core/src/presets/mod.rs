//! Gears and steels that come with the program, each number with its certainty and its source.
//!
//! The numbers are in `data/presets`: `gears.json`, `planetary.json`, `steels.json`, and `sources.json` with the full reference of
//! every source. A number without certainty, or with a source that is not in the list, is refused when the files
//! are read.

mod error;
mod figure;
mod gears;
mod planetary;
mod sources;
mod steels;

pub use error::PresetError;
pub use figure::{Certainty, Figure, FigureRow};
pub use gears::{GearFigures, GearPreset, OperationFigures, gear, gears, read_gears, trains};
pub use planetary::{PlanetaryPreset, planetary_sets};
pub use sources::{OWN_CHOICE, PresetSource, sources};
pub use steels::{POWDER_METAL, SteelPreset, read_steels, steel, steels};
