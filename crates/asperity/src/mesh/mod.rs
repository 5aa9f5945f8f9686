//! The mesh without roughness and oil: positions along the path of contact with load, speeds and Hertz contact.

mod cells;
mod inputs;

pub use asperity_case::mesh_position::{MeshPosition, Resolution};

use asperity_contact::hertz_line::HertzLine;
use asperity_core::quantity::{AngularSpeed, Length, Torque};
use asperity_gear::LoadMap;

use self::cells::CellPlace;
pub(crate) use self::inputs::MeshInputs;
use asperity_case::case::Case;
use asperity_case::error::{Error, PositionError};

/// Load over the flanks and the mesh positions that follow from it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Mesh {
    /// Load over the flanks.
    pub load: LoadMap,
    /// Positions along the path of contact.
    pub positions: Vec<MeshPosition>,
}

impl Mesh {
    /// The mesh of a case: positions along the path, or the single one of the formulation.
    ///
    /// # Errors
    /// When the gear geometry or the Hertz contact refuses the numbers at a position.
    ///
    /// ```
    /// use asperity::{case, mesh::Mesh};
    /// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    /// let mesh = Mesh::new(&case::load(file, None)?.case)?;
    /// assert!(mesh.positions.iter().all(|position| position.load.si() > 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(case: &Case) -> Result<Self, PositionError> {
        let inputs = MeshInputs::from_case(case);
        Self::under(&inputs, case.speed, inputs.load.load_map()?)
    }

    /// The mesh of a case at another torque: its gears, with the tip relief that the case states or assumes.
    ///
    /// # Errors
    /// As [`of`](Self::new).
    pub fn at_torque(case: &Case, torque: Torque) -> Result<Self, PositionError> {
        let mut inputs = MeshInputs::from_case(case);
        inputs.load = inputs.load.at(torque);
        let load = inputs.load.load_map()?;
        Self::under(&inputs, case.speed, load)
    }

    /// The mesh positions at a speed of the pinion under a load over the flanks that is known.
    pub(crate) fn under(
        inputs: &MeshInputs,
        speed: AngularSpeed,
        load: LoadMap,
    ) -> Result<Self, PositionError> {
        let places = cells::places(inputs, speed, &load)?;
        let numbered = places.iter().enumerate();
        let positions = numbered
            .map(|(index, place)| position(inputs, speed, index + 1, place))
            .collect::<Result<_, _>>()?;
        Ok(Self { load, positions })
    }

    /// The points A to E of the path under the mean load over the face, which are in no mean. Left out are points
    /// that the path does not reach and points at which relief keeps the flanks apart.
    pub(crate) fn named_points(
        &self,
        case: &Case,
    ) -> Result<Vec<(&'static str, MeshPosition)>, PositionError> {
        let path = case.gears.path();
        let inputs = MeshInputs::from_case(case);
        let mut points = Vec::new();
        let named = path.named_points().into_iter();
        for (name, s) in named.filter(|(_, s)| (path.a..=path.e).contains(s)) {
            let place = CellPlace::shown(&self.load, s, Resolution::WhereFine)?;
            if place.load.si() > 0.0 {
                points.push((
                    name,
                    position(&inputs, case.speed, points.len() + 1, &place)?,
                ));
            }
        }
        Ok(points)
    }
}

/// Values of all mesh positions, in order; an error names its position. Of traces that are too short it is the position that needs most.
pub(crate) fn numbered<T>(of_positions: Vec<Result<T, PositionError>>) -> Result<Vec<T>, Error> {
    let count = of_positions.len();
    let needed = |one: &Result<T, PositionError>| match one {
        Err(PositionError::TraceTooShort { needed_um, .. }) => Some(*needed_um),
        _ => None,
    };
    let most = of_positions.iter().filter_map(needed).fold(0.0, f64::max);
    let numbered = |(index, one): (usize, Result<T, PositionError>)| {
        one.map_err(|source| Error::Position {
            number: index + 1,
            count,
            source: Box::new(source),
        })
    };
    let is_reported =
        |one: &Result<T, PositionError>| needed(one).is_none_or(|of_one| of_one == most);
    let positions = of_positions.into_iter().enumerate();
    let reported = positions.filter(|(_, one)| is_reported(one));
    reported.map(numbered).collect()
}

/// Position `number` at a place of a mesh at a speed of the pinion.
fn position(
    inputs: &MeshInputs,
    speed: AngularSpeed,
    number: usize,
    place: &CellPlace,
) -> Result<MeshPosition, PositionError> {
    let CellPlace { s, load, .. } = *place;
    let motion = inputs.load.gears.kinematics(s, speed)?;
    Ok(MeshPosition {
        number,
        s,
        weight: place.weight.si(),
        sliding_factor: place.sliding_factor,
        resolution: place.resolution,
        cell: place.cell,
        zone: place.zone,
        motion,
        load,
        hertz: HertzLine::new(load, motion.radius, inputs.modulus)?,
    })
}

/// The position `s` of the path of contact under the mean load over the face: number 1, without weight in a mean.
///
/// # Errors
/// When an equation refuses the numbers there, as where relief keeps the flanks apart.
pub fn position_at(case: &Case, s: Length) -> Result<MeshPosition, PositionError> {
    let inputs = MeshInputs::from_case(case);
    let place = CellPlace::shown(&inputs.load.load_map()?, s, Resolution::Required)?;
    position(&inputs, case.speed, 1, &place)
}
