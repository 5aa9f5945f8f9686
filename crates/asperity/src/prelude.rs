//! Items that most programs that embed the orchestrator use.

pub use crate::result::{MeshOutcome, RunResult};
pub use crate::run::Run;
pub use crate::train::Outcome;
pub use asperity_case::case::{
    BodyInput, Case, CaseBuilder, CaseInput, FlankInput, GearsInput, LoadedCase, MaterialInput,
    ModelInput, OneOrTwo, OperationInput, SurfaceInput, Trace,
};
pub use asperity_case::error::Error;
pub use asperity_case::formulation::FormulationChoice;
pub use asperity_core::material::Material;
pub use asperity_core::quantity::{
    Angle, AngularSpeed, Density, DynamicViscosity, KinematicViscosity, Length, LineLoad,
    PerKelvin, Pressure, PressureViscosity, Quantity, Ratio, SpecificHeat, Speed, Temperature,
    ThermalConductivity, Torque,
};
pub use asperity_core::remedy::{Action, Remedy, Setting};
pub use asperity_oil::{BaseOil, FilmRheology, LubricantInput, ViscosityLaw};
pub use asperity_profile_io::read::ReadOptions;
