//! Plastic flow of the flanks in their first engagements.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z₁, z₂ | heights of pinion and wheel | m |
//! | w | plastic displacement of a contact | m |
//! | s₁, s₂ | its shares | - |
//! | p_s | limit of the pressure | Pa |

use asperity_contact::{Boundary, Solver};
use asperity_core::cite;
use asperity_core::quantity::Pressure;
use asperity_core::task::par_map;

use super::track::{ENGAGEMENTS, Pass, Track};
use crate::contacts::displacements::flow_shares;
use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Contacts that are solved at once at most.
const AT_ONCE: usize = 8;

/// Tracks whose flanks flow.
pub(crate) struct RunInFlow<'a> {
    case: &'a Case,
    tracks: Vec<Track<'a>>,
    /// Contacts made on each track.
    made: Vec<usize>,
    /// Solvers of contacts that are solved at once, of the size of the last track.
    solvers: Vec<Solver>,
    limit: Pressure,
    shares: [f64; 2],
}

impl<'a> RunInFlow<'a> {
    /// Flanks of a case that flow at `limit`.
    pub fn new(
        case: &'a Case,
        tracks: Vec<Track<'a>>,
        limit: Pressure,
    ) -> Result<Self, PositionError> {
        Ok(Self {
            case,
            made: vec![0; tracks.len()],
            solvers: Vec::new(),
            tracks,
            limit,
            shares: flow_shares(&case.materials, case.flow_pressure)?,
        })
    }

    /// Goes on to a number of engagements of a tooth of the pinion; returns the mean plastic work of a contact \[J/m\].
    ///
    /// ```text
    /// zᵢ ← zᵢ − sᵢ w under each contact, p ≤ p_s                                              [Run-in]
    /// ```
    ///
    /// # Errors
    /// When a contact has no solution.
    pub fn advance(&mut self, engagements: f64) -> Result<f64, PositionError> {
        cite!("Run-in");
        let (mut work, mut count) = (0.0, 0);
        for (track, made) in self.tracks.iter_mut().zip(&mut self.made) {
            let until = (track.passes * engagements / ENGAGEMENTS).round() as usize;
            let solvers = &mut self.solvers;
            if solvers
                .first()
                .is_none_or(|of| of.shape().points != track.points)
            {
                let anew = (0..AT_ONCE).map(|_| Solver::new(track.points, Boundary::FreeEnds));
                *solvers = anew.collect::<Result<Vec<_>, _>>()?;
            }
            while *made < until {
                let passes = apart(track, *made, until);
                let solve = |(solver, pass): (&mut Solver, &Pass)| {
                    let load = track.positions[pass.position].load;
                    track.press(solver, self.case, pass, load, None, self.limit)
                };
                let solved = par_map((solvers.as_mut_slice(), &passes), solve);
                for (pass, contact) in passes.iter().zip(solved) {
                    let contact = contact?;
                    work += contact.dissipated.si();
                    for body in 0..2 {
                        let flow = contact.plastic_displacement.iter();
                        track.lower(body, pass, flow.map(|w| self.shares[body] * w));
                    }
                }
                *made += passes.len();
                count += passes.len();
            }
        }
        Ok(work / count.max(1) as f64)
    }

    /// The tracks as they are now.
    pub fn tracks(&self) -> &[Track<'a>] {
        &self.tracks
    }

    /// The tracks, for wear to go on from.
    pub(crate) fn into_tracks(self) -> Vec<Track<'a>> {
        self.tracks
    }
}

/// The next contacts of a track that have no point in common, so that their order changes nothing.
fn apart(track: &Track<'_>, from: usize, until: usize) -> Vec<Pass> {
    let mut passes: Vec<Pass> = Vec::with_capacity(AT_ONCE);
    for number in from..until.min(from + AT_ONCE) {
        let pass = track.pass(number);
        if passes.iter().any(|other| track.overlap(other, &pass)) {
            break;
        }
        passes.push(pass);
    }
    passes
}
