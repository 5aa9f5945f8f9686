//! Mild wear of flanks that have run in plastically, by Archard's law from the pressure of the asperities.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | height of a flank at one of its points | m |
//! | N | engagements of a tooth of the pinion | - |
//! | k | wear coefficient | 1/Pa |
//! | p_a | pressure of asperities under a film that carries its share of the load | Pa |
//! | V_s, u | sliding speed; speed of this flank through the contact | m/s |
//! | β_b | base helix angle | rad |
//! | X | place of the contact on the flank | m |
//! | T_i | length of all traces of gear i, other teeth included | m |
//! | z₁, z₂ | numbers of teeth | - |

use asperity_contact::{Boundary, Solver};
use asperity_core::cite;
use asperity_core::quantity::{LineLoad, Pressure};
use asperity_core::task::try_par_map;

use super::track::{Pass, Track};
use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Contacts by which the wear of a package is found, as a multiple of the contacts of a cycle: more change Rq after 1e6 engagements
/// by less than 1 %.
const SAMPLES: f64 = 2.0;
/// Asperity share below which a position does not wear.
const NO_SHARE: f64 = 1e-6;

/// Wear of every point of a track over k and engagements of the pinion \[m Pa\], gear by gear and tooth by tooth.
pub(crate) type WearRates = [Vec<Vec<f64>>; 2];

/// Wear of a track by its next contacts from number `from`, with the asperity share of each mesh position.
///
/// ```text
/// dz/dN = −k ∫ p_a |V_s|/(u cos β_b) dX,  of the wheel times z₁/z₂                             [Wear-1]
/// ```
///
/// The integral over one engagement is T_i times the mean over contacts whose places fill T_i evenly. Film wears nothing.
///
/// # Errors
/// When a contact has no solution.
pub(crate) fn rates(
    case: &Case,
    limit: Pressure,
    track: &Track<'_>,
    shares: &[f64],
    from: usize,
) -> Result<(WearRates, usize), PositionError> {
    cite!("Wear-1");
    let count = (SAMPLES * track.passes).ceil() as usize;
    let passes: Vec<Pass> = (from..from + count).map(|k| track.pass(k)).collect();
    let press = |solver: &mut Solver, pass: &Pass| -> Result<Option<Vec<f64>>, PositionError> {
        let (at, share) = (track.positions[pass.position], shares[pass.position]);
        if share < NO_SHARE {
            return Ok(None);
        }
        let places: Vec<f64> = track.places().collect();
        let film = at.hertz_pressure(&places, 1.0 - share)?;
        let load = LineLoad::from_si(share * at.load.si());
        let contact = track.press(solver, case, pass, load, Some(&film), limit)?;
        Ok(Some(contact.pressure))
    };
    let solver = || Solver::new(track.points, Boundary::FreeEnds);
    let chunk = passes.len().div_ceil(16).max(1);
    let chunks: Vec<&[Pass]> = passes.chunks(chunk).collect();
    let pressures = try_par_map(chunks, |passes| -> Result<Vec<_>, PositionError> {
        let mut solver = solver()?;
        passes.iter().map(|pass| press(&mut solver, pass)).collect()
    })?;
    let mut rates = [track.zeros(0), track.zeros(1)];
    let cosine = case.gears.base_helix.si().cos();
    let teeth = case.gears.teeth.map(f64::from);
    for (pass, pressure) in passes.iter().zip(pressures.into_iter().flatten()) {
        let Some(pressure) = pressure else { continue };
        let motion = &track.positions[pass.position].motion;
        for (body, fields) in rates.iter_mut().enumerate() {
            let speed = [motion.u1, motion.u2][body].si().abs();
            let slip = motion.sliding.si().abs() / (speed * cosine);
            let oftener = teeth[0] / teeth[body];
            let factor = track.way(body) / count as f64 * slip * oftener;
            track.add((body, fields), pass, pressure.iter().map(|p| factor * p));
        }
    }
    Ok((rates, count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contacts::running_in::limits;
    use crate::mesh::Mesh;
    use asperity_case::case::load_with;
    use asperity_case::flanks::{Surfaces, Texture};
    use asperity_core::Profile;
    use asperity_core::numerics::mean;
    use asperity_core::quantity::Length;

    #[test]
    fn wear_of_a_smooth_contact_is_archards() {
        let file = std::path::Path::new("../../fixtures/cases/fzg-c.toml");
        let case = load_with(file, &|input| input.model.positions = Some(8))
            .unwrap()
            .case
            .clone();
        let mesh = Mesh::new(&case).unwrap();
        let smooth = || {
            let spacing = Length::from_si(0.5e-6);
            Texture::Trace(Profile::new(spacing, vec![0.0; 6000]).unwrap())
        };
        let surfaces = Surfaces::new([smooth(), smooth()], None, false);
        let track = Track::new(&case, &surfaces, 0, &mesh.positions)
            .unwrap()
            .unwrap();
        let [_, limit, _] = limits(&case).unwrap();
        let wear = |share: f64| {
            let shares = vec![share; track.positions.len()];
            rates(&case, limit, &track, &shares, 0).unwrap().0
        };
        let (whole, half) = (wear(1.0), wear(0.5));
        for body in 0..2 {
            // Archard: load times slip, as mean over the flank, and of the wheel two thirds as often.
            let oftener = [1.0, 16.0 / 24.0][body];
            let expected = track.positions.iter().map(|at| {
                let speed = [at.motion.u1, at.motion.u2][body].si();
                oftener * at.load.si() * (at.motion.sliding.si() / speed).abs()
            });
            let of = |fields: &[Vec<f64>]| mean(fields[0].iter().copied());
            let found = of(&whole[body]) / mean(expected);
            assert!((found - 1.0).abs() < 0.1, "{body}: {found}");
            let ratio = of(&half[body]) / of(&whole[body]);
            assert!((ratio - 0.5).abs() < 0.01, "{body}: {ratio}");
        }
        assert!(
            wear(0.0)
                .iter()
                .flatten()
                .flatten()
                .all(|rate| *rate == 0.0)
        );
    }
}
