//! Tables as CSV, a row type each; every header carries its unit.

mod contact;
mod csv_table;
mod flanks;
mod losses;
mod thin;

pub use contact::{
    ContactTables, ConvergenceRow, SubsurfaceRow, SurfaceRow, convergence, folder_of,
};
pub use csv_table::{Row, read, write};
pub use flanks::{BODIES, FlankTables, MaterialRatioRow, SpectrumRow, TraceRow, files_of};
pub use losses::{FrictionLawRow, LossRow, friction_laws, losses};
