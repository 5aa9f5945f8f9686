//! Published friction laws, each applied as a whole for comparison with the result.

use std::collections::BTreeSet;

use asperity_core::OutOfRange;
use asperity_core::numerics::mean;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Power;
use asperity_efficiency::LossKind;
use asperity_efficiency::output_torque::power_flow;
use asperity_tribo_friction::{FilmFriction, FrictionLaw, NamedFriction};

use super::cycle::{efficiency_at, operation};
use super::solved::Solved;
use crate::lubrication::{LubricatedPosition, SmoothPosition, film_contact};
use crate::result::{PublishedLawRow, PublishedOutcome};
use asperity_case::error::PositionError;

/// Rows of the published laws. Their equations are not those that the result rests on and are left out of its
/// list.
pub(crate) fn published_laws(solved: &Solved<'_>) -> Result<Vec<PublishedLawRow>, PositionError> {
    let whole = FrictionLaw::ALL
        .iter()
        .filter(|law| law.published().is_whole);
    whole.map(|law| row(solved, *law)).collect()
}

fn row(solved: &Solved<'_>, law: FrictionLaw) -> Result<PublishedLawRow, PositionError> {
    let about = law.published();
    let temperature = solved.loaded.temperature();
    let mut outside: BTreeSet<String> = about
        .outside(temperature)?
        .iter()
        .map(ToString::to_string)
        .collect();
    for position in &solved.positions {
        let notes = about.outside_pressure(position.at.hertz.max_pressure)?;
        let named = |note: &OutOfRange| format!("{} of {}", note.name, note.correlation);
        outside.extend(notes.iter().map(named));
    }
    let outcome = match Provenance::new().collect(|| applied(solved, law, &mut outside)) {
        Ok(outcome) => outcome,
        // A law that refuses these conditions must not stop the run: it was not asked for.
        Err(error) => PublishedOutcome::Refused(error.to_string()),
    };
    Ok(PublishedLawRow {
        law: law.name().to_owned(),
        includes_asperities: about.includes_asperities(),
        excludes_rolling: about.excludes_rolling,
        fitted_to: about.fitted_to.to_owned(),
        inside_its_range: outside.is_empty(),
        outside: outside.into_iter().collect(),
        outcome,
    })
}

/// The law's coefficient times the load at every position and offset. A law made with the rolling loss in
/// it has none added.
fn applied(
    solved: &Solved<'_>,
    law: FrictionLaw,
    outside: &mut BTreeSet<String>,
) -> Result<PublishedOutcome, PositionError> {
    let (case, positions) = (solved.loaded, &solved.positions);
    let settings = case.model.friction_settings;
    let named = NamedFriction { law, settings };
    let mut forces = Vec::with_capacity(positions.len());
    for position in positions {
        let mut of_offsets = Vec::with_capacity(position.offsets.len());
        for offset in &position.offsets {
            let smooth = SmoothPosition {
                at: &position.at,
                film: &position.film,
            };
            let contact = film_contact(case, smooth, &offset.roughness, case.oil())?;
            let found = named.traction(&contact)?;
            for note in &found.outside {
                outside.insert(format!("{} of {}", note.name, note.correlation));
            }
            of_offsets.push(found.value.coefficient * position.at.load.si());
        }
        forces.push(of_offsets);
    }
    let rolling: Vec<f64> = if law.published().excludes_rolling {
        solved.rolling.clone()
    } else {
        vec![0.0; solved.rolling.len()]
    };
    let number = |position: &LubricatedPosition| position.at.number - 1;
    let mut meshes = Vec::with_capacity(solved.meshes.len());
    for k in 0..solved.meshes.len() {
        let force = |position: &LubricatedPosition, k: usize| forces[number(position)][k];
        meshes.push(efficiency_at(case, positions, &rolling, k, force)?);
    }
    let sliding =
        |mesh: &asperity_efficiency::MeshEfficiency| mesh.breakdown.power(LossKind::Sliding).si();
    let loss = mean(meshes.iter().map(|mesh| mesh.flow.loss.si()));
    Ok(PublishedOutcome::Applied {
        loss_w: loss,
        sliding_w: mean(meshes.iter().map(sliding)),
        efficiency: power_flow(&operation(case), Power::from_si(loss))?.efficiency,
    })
}
