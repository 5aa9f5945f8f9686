//! Flanks of gears as measured: traces read, prepared and placed, and the windows in contact at a mesh position.
//!
//! | module | holds |
//! |---|---|
//! | [`trace`] | one trace: read, turned, placed, filtered ([`trace_filters`], [`read_place`], [`flank_form`]), with what is stated of it ([`statements`]) |
//! | [`meeting`] | the traces of both flanks: common spacing, pairs of teeth ([`trace_sites`]) |
//! | [`surrogates`] | generated flanks where only roughness values are known |
//! | [`sheets`] | both flanks as surfaces, from which patches are cut |
//! | [`surface_lay`], [`flank_lay`] | lay of a surface, and what is known of the lay of a flank |
//! | [`surfaces`] | both flanks as a run uses them, and as a result reports them |
//! | [`placement`] | where traces lie on their flanks |
//! | [`mesh_position`] | a position of the mesh without roughness and oil: motion, load, Hertz contact |
//! | [`error`] | why a mesh position has no result |
//!
#![doc = include_str!("../README.md")]

pub mod error;
pub mod flank_form;
pub mod flank_lay;
pub mod generated_record;
pub mod local_roughness;
pub mod meeting;
pub mod mesh_position;
pub mod placement;
pub mod read_place;
pub mod scan;
pub mod sheets;
pub mod statements;
pub mod surface_lay;
pub mod surfaces;
pub mod surrogate_record;
pub mod surrogates;
pub mod trace;
pub mod trace_filters;
pub mod trace_pairs;
pub mod trace_sites;
mod window_pair;

pub use local_roughness::Roughness;
pub use sheets::{PatchPlace, Sheets};
pub use surfaces::{Surfaces, Texture};
pub use window_pair::{
    AVERAGING_WIDTH, LEAST_POINTS_PER_HALF_WIDTH, OffsetIndex, Window, WindowPair, is_substituted,
    row_place, window_places,
};
