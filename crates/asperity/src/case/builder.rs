//! A case built in memory, from quantities and traces.

use std::path::{Path, PathBuf};

use asperity_oil::LubricantInput;

use super::files::{Content, Files};
use super::input::{
    CaseInput, FlankInput, Formulation, GearsInput, MaterialInput, ModelInput, OneOrTwo,
    OperationInput, SurfaceInput,
};
use super::loaded::LoadedCase;
use super::resolve::Case;
use super::trace::{Flank, Trace};
use crate::error::Error;
use asperity_core::quantity::{AngularSpeed, Length, Temperature, Torque};

/// A case in the making; [`build`](Self::build) checks it and fills in the defaults.
///
/// Every key of a case file is a field of [`CaseInput`], reached by [`change`](Self::change) or, as text,
/// by [`set`](Self::set).
#[derive(Debug, Clone)]
pub struct CaseBuilder {
    input: CaseInput,
    files: Files,
}

impl Case {
    /// Begins a case from what has no default; the flanks follow by [`CaseBuilder::pinion`].
    ///
    /// ```
    /// use asperity::case::{Case, FlankInput, GearsInput, OperationInput};
    /// use asperity::oil::LubricantInput;
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
    /// A case of which all else has its default: both flanks as that of the pinion.
    pub fn new(
        gears: GearsInput,
        operation: OperationInput,
        lubricant: LubricantInput,
        pinion: FlankInput,
    ) -> Self {
        Self {
            title: None,
            formulation: None,
            gears,
            material: MaterialInput::default(),
            operation,
            lubricant,
            surface: SurfaceInput::new(pinion),
            model: ModelInput::default(),
            calibration: None,
            map: None,
            gearbox: None,
            micropitting: None,
            vehicle: None,
        }
    }
}

impl SurfaceInput {
    /// Flanks of which all else has its default: the wheel as the pinion, mirrored.
    pub fn new(pinion: FlankInput) -> Self {
        Self {
            pinion,
            wheel: None,
            form: None,
            cutoff: None,
            noise_cutoff: None,
            ends: None,
            outliers: None,
            coast: None,
        }
    }
}

impl GearsInput {
    /// Spur gears of 20° without profile shift, addendum 1, of the same face width.
    pub fn new(teeth: [i32; 2], module: Length, face_width: Length) -> Self {
        Self {
            teeth,
            module,
            module_plane: None,
            helix: None,
            pressure_angle: None,
            face_width: OneOrTwo::One(face_width),
            profile_shift: None,
            centre_distance: None,
            tip_diameter: None,
            addendum: None,
            pinion: None,
            wheel: None,
            end_relief: None,
            pitch_deviations: None,
            amounts: None,
            relief_tolerance: None,
        }
    }
}

impl OperationInput {
    /// Torque and speed of the pinion, bulk temperature of the flanks.
    pub fn new(torque: Torque, speed: AngularSpeed, temperature: Temperature) -> Self {
        Self {
            torque,
            speed,
            temperature,
            bulk: None,
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

    /// Reading of the model.
    #[must_use]
    pub fn formulation(self, formulation: Formulation) -> Self {
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

    /// The flank of the pinion, and mirrored that of the wheel unless it has its own.
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

    /// A file that the case names, as `model.xu_coefficients` does, held in memory.
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

    /// Sets the key at `path` from text, as [`CaseInput::set`] does.
    ///
    /// # Errors
    /// When the key is not known or the value cannot be read.
    pub fn set(mut self, path: &str, value: &str) -> Result<Self, Error> {
        self.input.set(path, value)?;
        Ok(self)
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
            Flank::Keys(keys) => return keys,
            Flank::Trace(trace) => trace,
        };
        let mut name = trace.name.clone().unwrap_or_else(|| PathBuf::from(body));
        if let Some(content) = &trace.content {
            if self.files.held(&name).is_some_and(|held| held != content) {
                // Two contents under one name: that of the other flank keeps it.
                name = PathBuf::from(format!("{} ({body})", name.display()));
            }
            self.files.hold(&name, content.clone());
        }
        trace.into_input(name)
    }
}
