//! Lay of the surface that a trace was taken from.

use asperity_core::quantity::Length;
use asperity_profile_io::read::{Surface, TraceLine};
use asperity_roughness::lay::{RowLay, lay_of_rows};
use asperity_roughness::preparation::PreparationRecord;

/// The lay of `surface`, whose lines in the direction `line` have points `along` apart and were prepared as recorded; `None` of a
/// single line.
///
/// # Errors
/// With the reason, when the surface does not show its lay.
#[must_use]
pub fn lay_of_surface(
    surface: &Surface,
    line: TraceLine,
    along: Length,
    preparation: Option<&PreparationRecord>,
) -> Option<Result<RowLay, String>> {
    if surface.rows < 2 || surface.columns < 2 {
        return None;
    }
    Some(match line {
        TraceLine::Column | TraceLine::MeanColumn => {
            let spacings = [Some(along), surface.dx];
            of_lines(&surface.by_columns(), surface.rows, spacings, preparation)
        }
        _ => {
            let spacings = [Some(along), surface.dy];
            of_lines(&surface.z, surface.columns, spacings, preparation)
        }
    })
}

fn of_lines(
    z: &[f64],
    points: usize,
    spacings: [Option<Length>; 2],
    preparation: Option<&PreparationRecord>,
) -> Result<RowLay, String> {
    let [Some(along), Some(across)] = spacings else {
        return Err("no distance of its rows (dy) was found in it".to_owned());
    };
    let Some(record) = preparation else {
        return Err("its rows are not prepared".to_owned());
    };
    match lay_of_rows(z, points, [along, across], &record.recipe, record.filter) {
        Ok(Ok(lay)) => Ok(lay),
        Ok(Err(unknown)) => Err(unknown.to_string()),
        Err(error) => Err(error.to_string()),
    }
}
