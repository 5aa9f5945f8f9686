//! The film alone: its pressure is Hertz's and carries the whole load.

use crate::error::PositionError;
use crate::full_film::FullFilm;
use crate::station::Station;

use super::carried::Carried;

/// The film's pressure at the points `x` [m]: that of `solution`, or without one that of the smooth dry contact,
/// which a full film takes over all but its inlet and its outlet.
pub(crate) fn full_film(
    station: &Station,
    x: &[f64],
    solution: Option<&FullFilm>,
) -> Result<Carried, PositionError> {
    Ok(Carried {
        fluid: match solution {
            Some(film) => film.pressure_at(x),
            None => hertz_pressure(station, x, 1.0)?,
        },
        solids: None,
        history: Vec::new(),
    })
}

/// `share` of the Hertz pressure at the points `x` \[m\].
pub(super) fn hertz_pressure(
    station: &Station,
    x: &[f64],
    share: f64,
) -> Result<Vec<f64>, PositionError> {
    x.iter()
        .map(|&x| {
            let pressure = station
                .hertz
                .pressure(asperity_core::quantity::Length::from_si(x))?;
            Ok(share * pressure.si())
        })
        .collect()
}
