//! A case built in memory, from quantities and traces.

use std::path::{Path, PathBuf};

use asperity_oil::LubricantInput;

use super::loaded_case::LoadedCase;
use super::trace::{Flank, Trace};
use crate::error::Error;
use crate::input::case_input::{
    CaseInput, FlankInput, GearsInput, MaterialInput, OperationInput, SurfaceInput,
};
use crate::input::files::{Content, Files};
use crate::input::formulation::FormulationChoice;
use crate::input::gear_input::{NoRelief, TipRelief};
use crate::input::model::ModelInput;
use crate::input::one_or_two::OneOrTwo;
use crate::resolved::resolve::Case;
use asperity_core::quantity::{AngularSpeed, Length, Temperature, Torque};

/// Builder of a case; [`build`](Self::build) checks it and fills in the defaults.
///
/// Every key of a case file is a field of [`CaseInput`], reached by [`change`](Self::change) or, as text,
/// by [`set`](Self::set).
#[derive(Debug, Clone)]
pub struct CaseBuilder {
    pub(crate) input: CaseInput,
    files: Files,
}

impl Case {
    /// Begins a case with the tables that have no default; [`CaseBuilder::pinion`] adds the flanks.
    ///
    /// ```
    /// use asperity_case::case::{Case, FlankInput, GearsInput, OperationInput};
    /// use asperity_oil::LubricantInput;
    /// let loaded = Case::builder(
    ///     GearsInput::new([23, 68], "1.8 mm".parse()?, "32 mm".parse()?),
    ///     OperationInput::new("145 N m".parse()?, "9000 1/min".parse()?, "90 °C".parse()?),
    ///     LubricantInput { oil: Some("m100".to_owned()), ..LubricantInput::default() },
    /// )
    /// .pinion(FlankInput { rq: Some("0.3 um".parse()?), ..FlankInput::default() })
    /// .set("model.positions", "8")?
    /// .build()?;
    /// assert_eq!(loaded.case.model.positions, 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn builder(
        gears: GearsInput,
        operation: OperationInput,
        lubricant: LubricantInput,
    ) -> CaseBuilder {
        CaseBuilder {
            input: CaseInput::new(gears, operation, lubricant, FlankInput::default()),
            files: Files::in_folder(Path::new("")),
        }
    }
}

impl CaseInput {
    /// A case with defaults otherwise: the wheel has the flank of the pinion.
    pub fn new(
        gears: GearsInput,
        operation: OperationInput,
        lubricant: LubricantInput,
        pinion: FlankInput,
    ) -> Self {
        Self {
            gears,
            operation,
            lubricant,
            surface: SurfaceInput::new(pinion),
            ..Self::default()
        }
    }
}

impl SurfaceInput {
    /// Flanks with defaults otherwise: the wheel has the flank of the pinion, mirrored.
    pub fn new(pinion: FlankInput) -> Self {
        Self {
            pinion,
            ..Self::default()
        }
    }
}

impl GearsInput {
    /// Spur gears of 20° without profile shift, addendum 1, of the same face width.
    pub fn new(teeth: [i32; 2], module: Length, face_width: Length) -> Self {
        Self {
            teeth,
            module,
            face_width: OneOrTwo::One(face_width),
            ..Self::default()
        }
    }

    /// The case with tips that are stated to have no relief.
    #[must_use]
    pub fn unrelieved(mut self) -> Self {
        for gear in [&mut self.pinion, &mut self.wheel] {
            let stated = gear.get_or_insert_default();
            stated.tip_relief = Some(TipRelief::None(NoRelief::None));
        }
        self
    }
}

impl OperationInput {
    /// Torque and speed of the pinion, bulk temperature of the flanks.
    pub fn new(torque: Torque, speed: AngularSpeed, temperature: Temperature) -> Self {
        Self {
            torque,
            speed,
            bulk_temperature: Some(OneOrTwo::One(temperature)),
            ..Self::default()
        }
    }
}

impl CaseBuilder {
    /// Title of the case, shown in every output.
    #[must_use]
    pub fn title(self, title: impl Into<String>) -> Self {
        let title = title.into();
        self.change(|input| input.title = Some(title))
    }

    /// The formulation of the model.
    #[must_use]
    pub fn formulation(self, formulation: FormulationChoice) -> Self {
        self.change(|input| input.formulation = Some(formulation))
    }

    /// Steel of both gears.
    #[must_use]
    pub fn material(self, material: MaterialInput) -> Self {
        self.change(|input| input.material = material)
    }

    /// Choices of the model.
    #[must_use]
    pub fn model(self, model: ModelInput) -> Self {
        self.change(|input| input.model = model)
    }

    /// The flank of the pinion; also of the wheel, mirrored, unless the wheel has another one.
    #[must_use]
    pub fn pinion(mut self, flank: impl Into<Flank>) -> Self {
        self.input.surface.pinion = self.flank(flank.into(), "pinion");
        self
    }

    /// The flank of the wheel.
    #[must_use]
    pub fn wheel(mut self, flank: impl Into<Flank>) -> Self {
        self.input.surface.wheel = Some(self.flank(flank.into(), "wheel"));
        self
    }

    /// Content of a file that the case names, as in `lubricant.oil_file`.
    #[must_use]
    pub fn file(mut self, name: impl AsRef<Path>, bytes: impl Into<Vec<u8>>) -> Self {
        let bytes: Vec<u8> = bytes.into();
        self.files.hold(name.as_ref(), Content::Bytes(bytes.into()));
        self
    }

    /// Changes any key.
    #[must_use]
    pub fn change(mut self, change: impl FnOnce(&mut CaseInput)) -> Self {
        change(&mut self.input);
        self
    }

    /// The case, checked and completed with its defaults.
    ///
    /// # Errors
    /// When a number is outside its domain, the gears cannot mesh, the oil cannot be, a flank is missing, or a
    /// trace cannot be read or prepared.
    pub fn build(self) -> Result<LoadedCase, Error> {
        LoadedCase::built(self.input, self.files)
    }

    fn flank(&mut self, flank: Flank, body: &str) -> FlankInput {
        let trace: Trace = match flank {
            Flank::Keys(keys) => return *keys,
            Flank::Trace(trace) => trace,
        };
        let mut name = trace.name.clone().unwrap_or_else(|| PathBuf::from(body));
        if let Some(content) = &trace.content {
            if self.files.held(&name).is_some_and(|held| held != content) {
                // Another content has this name already.
                name = PathBuf::from(format!("{} ({body})", name.display()));
            }
            self.files.hold(&name, content.clone());
        }
        trace.into_input(name)
    }
}
