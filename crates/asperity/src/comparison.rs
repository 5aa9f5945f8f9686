//! The mesh with other friction laws in the film.

use asperity_core::provenance::Provenance;
use asperity_tribo_friction::{FilmFriction, FrictionLaw, NamedFriction};

use crate::error::PositionError;
use crate::friction;
use crate::losses::efficiency_at;
use crate::position::Position;
use crate::result::{ComparisonOutcome, FrictionComparison};
use crate::solved::{Solved, mean};

/// Laws that are compared with the one in use.
const COMPARED: [FrictionLaw; 3] = [
    FrictionLaw::Xu,
    FrictionLaw::Iso14179Part2,
    FrictionLaw::BenedictKelley,
];

/// Efficiency with other laws in the film, everything else equal. Their equations are not those that the
/// result rests on and are left out of its list.
pub(crate) fn friction_laws(
    solved: &Solved<'_>,
    own: f64,
) -> Result<Vec<FrictionComparison>, PositionError> {
    let used = solved.laws.friction.name();
    let mut laws = vec![FrictionComparison {
        law: used.to_owned(),
        outcome: ComparisonOutcome::Efficiency(own),
    }];
    for law in COMPARED.into_iter().filter(|law| law.name() != used) {
        let other = NamedFriction {
            law,
            settings: solved.loaded.case.model.friction_settings,
        };
        let outcome = match Provenance::new().collect(|| with_law(solved, &other)) {
            Ok(value) => ComparisonOutcome::Efficiency(value),
            // A law that refuses these conditions must not stop the run: it was not asked for.
            Err(error) => ComparisonOutcome::Refused(error.to_string()),
        };
        laws.push(FrictionComparison {
            law: law.name().to_owned(),
            outcome,
        });
    }
    Ok(laws)
}

fn with_law(solved: &Solved<'_>, law: &dyn FilmFriction) -> Result<f64, PositionError> {
    let (case, positions) = (&solved.loaded.case, &solved.positions);
    let mut forces = Vec::with_capacity(positions.len());
    for position in positions {
        let mut of_offsets = Vec::with_capacity(position.offsets.len());
        for offset in &position.offsets {
            let found = friction::in_film(case, law, &position.station, &offset.roughness)?;
            of_offsets.push(offset.rubbing.force(found.mu));
        }
        forces.push(of_offsets);
    }
    let number = |position: &Position| position.station.number - 1;
    let efficiencies = (0..solved.meshes.len())
        .map(|k| {
            let force = |position: &Position, k: usize| forces[number(position)][k];
            let mesh = efficiency_at(case, positions, &solved.rolling, k, force)?;
            Ok(mesh.flow.efficiency)
        })
        .collect::<Result<Vec<_>, PositionError>>()?;
    Ok(mean(efficiencies.into_iter()))
}
