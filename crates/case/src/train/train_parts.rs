//! A gear train from the inputs of its meshes, with the loads from the operating point.

use std::sync::Arc;

use asperity_core::quantity::Length;
use asperity_gear::GearError;
use asperity_gear::gear_train::GearTrain;

use crate::input::case_input::CaseInput;
use crate::input::files::FileSums;
use crate::input::train_heat_input::HeatInput;
use crate::resolved::gearbox::Gearbox;
use crate::resolved::resolve::title_by_gears;
use crate::resolved::shafting::{Shafting, StageKind};
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::source_text::{MeshKeys, Source};
use asperity_core::message::Warning;

/// A gear train with the inputs of its meshes, before their traces are read.
pub(crate) struct TrainParts {
    pub heat: Option<HeatInput>,
    pub gearbox: Option<Gearbox>,
    /// Sums of the tables of the gearbox.
    pub sums: FileSums,
    pub title: String,
    pub train: Shafting,
    pub stages: Vec<StageParts>,
    /// Warnings about the train as a whole.
    pub warnings: Vec<Warning>,
}

/// Input of the meshes of a stage.
pub(crate) struct StageParts {
    pub name: Option<String>,
    pub kind: StageKind,
    /// Tooth numbers of the gears on shafts, the second negative if it turns in the direction of the first.
    pub teeth: [f64; 2],
    pub meshes: Vec<MeshParts>,
    pub defaults: Vec<DefaultUsed>,
}

/// Input of a mesh.
pub(crate) struct MeshParts {
    pub name: String,
    pub keys: Arc<MeshKeys>,
    pub case: CaseInput,
}

/// Result folder of a mesh: its name as one word, `sun_planet` of "sun and planet". Those of a train differ.
///
/// ```
/// use asperity_case::case::train::mesh_folder;
/// assert_eq!(mesh_folder("second, sun and planet"), "second_sun_planet");
/// ```
#[must_use]
pub fn mesh_folder(mesh: &str) -> String {
    mesh.replace(" and ", "_").replace(", ", "_")
}

impl TrainParts {
    /// The meshes of `stages` on `shafts`, with the loads that follow from the operating point.
    pub fn new(
        title: Option<String>,
        shafts: GearTrain,
        passes_losses: bool,
        stages: Vec<StageParts>,
    ) -> Result<Self, GearError> {
        let train = Shafting {
            shafts,
            kinds: stages.iter().map(|stage| stage.kind.clone()).collect(),
            passes_losses,
        };
        let gears = || {
            stages
                .iter()
                .flat_map(|stage| &stage.meshes)
                .map(|mesh| &mesh.case.gears)
        };
        let module = gears().map(|gears| gears.module).next();
        let title = title.unwrap_or_else(|| {
            let mut teeth: Vec<u32> = Vec::new();
            for pair in gears().map(|gears| gears.teeth.map(i32::unsigned_abs)) {
                // A planet is in two meshes.
                let is_planet = teeth.last() == pair.first() && stages.len() == 1;
                teeth.extend(&pair[usize::from(is_planet)..]);
            }
            title_by_gears(&teeth, module.unwrap_or(Length::from_si(0.0)))
        });
        let mut stages = stages;
        let flow = train.flow(&[])?;
        for (stage, loads) in stages.iter_mut().zip(&flow.loads) {
            for (mesh, load) in stage.meshes.iter_mut().zip(loads) {
                mesh.case.operation.set_load(load.torque, load.speed);
                mesh.case.title = Some(format!("{title}: {}", mesh.name));
            }
        }
        Ok(Self {
            heat: None,
            gearbox: None,
            sums: FileSums::new(),
            title,
            train,
            stages,
            warnings: Vec::new(),
        })
    }

    pub fn meshes(&self) -> impl Iterator<Item = &MeshParts> {
        self.stages.iter().flat_map(|stage| &stage.meshes)
    }
}

/// A train that does not turn, or gears that cannot mesh, at `key`.
pub(crate) fn refused<'a>(
    source: &'a Source,
    key: &str,
) -> impl Fn(GearError) -> CaseError + use<'a> {
    let place = source.place_of_key(key);
    move |error| CaseError::gears(place.clone(), error)
}

/// Keys of a train that exclude or need each other, at `key`.
pub(crate) fn conflict(source: &Source, key: String, rule: &'static str) -> CaseError {
    CaseError::Conflict {
        place: source.place_of(&key),
        key: key.into(),
        rule,
    }
}
