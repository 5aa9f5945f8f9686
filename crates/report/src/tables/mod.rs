//! Tables as CSV with one row type each; every header includes the unit.

mod contact;
mod csv_table;
mod flanks;
mod load;
mod losses;
mod patch;
mod views;

pub(crate) use contact::{CONVERGENCE, NEAR, PATCH};
pub use contact::{
    ContactTables, ConvergenceRow, SubsurfaceRow, SurfaceRow, convergence, folder_of,
};
pub(crate) use csv_table::check_field;
pub use csv_table::{read, text, text_of_cells, write};
pub use flanks::{BODIES, FlankTables, MaterialRatioRow, SpectrumRow, TraceRow, files_of};
pub use load::{LoadMapRow, LoadPointRow, load_map, load_points};
pub use losses::{FrictionLawRow, LossRow, friction_laws, losses};
pub use patch::{PatchRow, PatchTable};
pub(crate) use views::thinned_views;
