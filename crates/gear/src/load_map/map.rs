//! The load map, solved at the phases of a mesh cycle.

use std::sync::Arc;

use super::coupled::{self, ContactLine, CoupledProblem, Tails};
use super::grid::LoadGrid;
use super::law::{LoadLaw, LoadMapSettings};
use super::line_load_table::LineLoadTable;
use super::phases::{MeshPhase, phases};
use super::rigid::{LinePoint, RigidLaw};
use crate::edge_contact::TipGaps;
use crate::error::GearError;
use crate::pair::GearPair;
use crate::pair_compliance::{PairCompliance, StiffnessSource};
use crate::relief::{MicroGeometry, Separation};
use asperity_core::material::Material;
use asperity_core::noted::Noted;
use asperity_core::quantity::{Length, LineLoad, Torque};
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

/// Overlap ratio below which a pair is sampled and divided into cells like a spur pair: about the width of a cell.
pub(super) const NARROW_OVERLAP: f64 = 0.1;

/// A point of a line of contact with its load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadSample {
    /// Mesh phase of the contact, 0 to 1.
    pub phase: f64,
    /// Profile coordinate in base pitches from A.
    pub xi: f64,
    /// Position across the face.
    pub y: Length,
    /// Load per length of contact line; zero if relief separates the flanks.
    pub load: LineLoad,
    /// Weight in a mean over the mesh cycle: the length of contact line that the point represents.
    pub weight: Length,
}

/// Convergence and assumptions of a load map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoadMapEvidence {
    /// Source of the tooth stiffness; `None` for laws without deflections.
    pub stiffness: Option<StiffnessSource>,
    /// Number of phases.
    pub phases: usize,
    /// Cells across the face; 0 for laws without deflections.
    pub cells: usize,
    /// Iterations of the active set, summed over all phases.
    pub rounds: usize,
    /// Maximum number of iterations at a phase.
    pub most_rounds: usize,
    /// Whether every phase converged; otherwise results need a warning.
    pub converged: bool,
    /// Largest load change in a final iteration, divided by the mean load.
    pub residual: f64,
    /// Mean approach of the teeth, normal to the flank; `None` for laws without deflections.
    pub mean_approach: Option<Length>,
    /// Profile shifts assumed for the form of the teeth if only their sum is known.
    pub assumed_profile_shift: Option<[f64; 2]>,
}

impl LoadMapEvidence {
    /// Evidence of a law without deflections, which needs no solution.
    pub(super) fn of_a_rigid_law() -> Self {
        Self {
            stiffness: None,
            phases: 0,
            cells: 0,
            rounds: 0,
            most_rounds: 0,
            converged: true,
            residual: 0.0,
            mean_approach: None,
            assumed_profile_shift: None,
        }
    }
}

/// The load over the flanks of a pair under one torque.
#[derive(Debug, Clone)]
pub struct LoadMap {
    pub(super) pair: GearPair,
    pub(super) torque: f64,
    pub(super) force: f64,
    /// `None` for a user-defined law.
    pub(super) law: Option<LoadLaw>,
    pub(super) micro: MicroGeometry,
    pub(super) materials: [Material; 2],
    pub(super) settings: LoadMapSettings,
    pub(super) model: LoadModel,
    pub(super) marks: Vec<f64>,
    pub(super) samples: Vec<LoadSample>,
    pub(super) loss_factor: f64,
    pub(super) evidence: LoadMapEvidence,
    /// Loss factor with contact of the tip edges, computed at most once for a map and its clones.
    pub(crate) edge_contact: Arc<Noted<Option<f64>>>,
}

#[derive(Debug, Clone)]
pub(super) enum LoadModel {
    Elastic(Box<LoadGrid>, Tails),
    Rigid(RigidLaw),
    Table(LineLoadTable),
}

impl LoadMap {
    /// Solves for the load over a mesh cycle.
    ///
    /// `torque` acts on gear 1 and may have either sign; `materials` belong to gears 1 and 2.
    ///
    /// # Errors
    /// When the torque is zero, a number is out of its domain, the law does not hold for the pair, flanks are modified
    /// but the law has no deflections, or undercut reaches into the path of contact.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput, LoadLaw, LoadMap, LoadMapSettings, MicroGeometry};
    /// # let steel = asperity_core::material::Material {
    /// #     young: "206 GPa".parse()?, poisson: 0.3, elastic_limit: "1 GPa".parse()?,
    /// #     density: "7850 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?,
    /// #     heat_capacity: "460 J/(kg K)".parse()?,
    /// # };
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [23, 68], "1.8 mm".parse()?, "23.4 deg".parse()?, "32 mm".parse()?,
    /// ))?;
    /// let map = LoadMap::new(
    ///     &pair, "145 N m".parse()?, &LoadLaw::Elastic, &MicroGeometry::default(),
    ///     &[steel, steel], &LoadMapSettings::default(),
    /// )?;
    /// assert!((map.loss_factor() - 0.1503).abs() < 2e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        pair: &GearPair,
        torque: Torque,
        law: &LoadLaw,
        micro: &MicroGeometry,
        materials: &[Material; 2],
        settings: &LoadMapSettings,
    ) -> Result<Self, GearError> {
        let torque = DomainError::finite("torque", torque)?.abs();
        DomainError::require(torque > 0.0, "torque", torque, "N m", "must not be zero")?;
        settings.check()?;
        if !law.is_elastic() && !micro.is_unmodified() {
            return Err(GearError::modified_flanks(law.name()));
        }
        let mut evidence = LoadMapEvidence::of_a_rigid_law();
        let force = pair.forces(Torque::from_si(torque))?.normal_base.si();
        let mut marks = vec![pair.path.eps_2];
        let model = if law.is_elastic() {
            let grid = elastic(pair, force, law, micro, materials, settings, &mut evidence)?;
            marks.extend(grid.separation.knots());
            if grid.edges.is_some() {
                marks.extend([-grid.reach(), pair.path.eps_alpha + grid.reach()]);
            }
            let coupling = settings.face_coupling * pair.normal_module.si()
                / (pair.face_width.si() / grid.cells as f64);
            let tails = Tails::new(coupling, grid.cells);
            LoadModel::Elastic(Box::new(grid), tails)
        } else {
            let rigid = RigidLaw::new(law, pair)?;
            marks.extend(rigid.knots(pair)?);
            LoadModel::Rigid(rigid)
        };
        let mut map = Self {
            pair: pair.clone(),
            torque,
            force,
            law: Some(law.clone()),
            micro: micro.clone(),
            materials: *materials,
            settings: *settings,
            model,
            marks,
            samples: Vec::new(),
            loss_factor: 0.0,
            evidence,
            edge_contact: Arc::default(),
        };
        map.run()?;
        Ok(map)
    }

    fn run(&mut self) -> Result<(), GearError> {
        let (single_row, pitches) = match &self.model {
            LoadModel::Elastic(grid, _) => (grid.cells == 1, grid.separation.pitches()),
            LoadModel::Rigid(_) | LoadModel::Table(_) => (self.pair.is_spur(), 1),
        };
        // With little overlap a phase samples few positions of the path, as with one cell across the face.
        let fine = single_row || self.pair.path.eps_beta < NARROW_OVERLAP;
        let phases = phases(&self.pair, &self.marks, fine, pitches);
        let mut rows = Vec::new();
        let mut samples = Vec::new();
        let mut evidence = self.evidence.clone();
        evidence.phases = phases.len();
        let mut mean = None;
        for phase in &phases {
            let approach =
                self.solve(phase, &mut rows, &mut evidence, &mut |point: LinePoint| {
                    samples.push(LoadSample {
                        phase: phase.phase,
                        xi: point.xi,
                        y: self.pair.face_width * point.across,
                        load: LineLoad::from_si(point.load),
                        weight: Length::from_si(point.length * phase.weight),
                    });
                })?;
            if let Some(approach) = approach {
                mean = Some(mean.unwrap_or(0.0) + phase.weight * approach);
            }
        }
        evidence.mean_approach = mean.map(Length::from_si);
        (self.samples, self.evidence) = (samples, evidence);
        self.loss_factor = self.sliding_integral(|_| 1.0);
        Ok(())
    }

    /// Calls `take` with every point of the lines of contact at a phase. Returns δ for a law with deflections.
    pub(super) fn solve(
        &self,
        phase: &MeshPhase,
        rows: &mut Vec<ContactLine>,
        evidence: &mut LoadMapEvidence,
        take: &mut dyn FnMut(LinePoint),
    ) -> Result<Option<f64>, GearError> {
        let (grid, tails) = match &self.model {
            LoadModel::Rigid(rigid) => {
                let points = rigid.points(&self.pair, self.force, phase.phase, &self.marks)?;
                points.into_iter().for_each(take);
                return Ok(None);
            }
            LoadModel::Table(table) => {
                let points = table.points(&self.pair, phase.phase, &self.marks);
                points.into_iter().for_each(take);
                return Ok(None);
            }
            LoadModel::Elastic(grid, tails) => (grid, tails),
        };
        let cell_length = self.pair.contact_per_coordinate().si() / grid.cells as f64;
        grid.rows(&self.pair, phase.phase, phase.pitch, rows);
        let problem = CoupledProblem {
            force: self.force,
            cell_length,
            mean_load: grid.mean_load,
            slope: grid.compliance.slope(),
            tails,
        };
        let solved = coupled::solve(rows, &problem);
        evidence.rounds += solved.rounds;
        evidence.most_rounds = evidence.most_rounds.max(solved.rounds);
        evidence.converged &= solved.converged;
        evidence.residual = evidence.residual.max(solved.residual);
        for row in rows.iter() {
            for cell in &row.cells {
                take(LinePoint {
                    tooth: row.tooth,
                    xi: cell.xi,
                    across: cell.across,
                    length: cell.cover * cell_length,
                    load: cell.load,
                });
            }
        }
        Ok(Some(solved.approach))
    }

    /// Σ w f |V_s| g/(T₁ ω₁), V_s = ω₁ (1 + 1/u)(s − C).
    pub(super) fn sliding_integral(&self, factor: impl Fn(&LoadSample) -> f64) -> f64 {
        cite!("Loss-5");
        let sum: f64 = (self.samples.iter())
            .map(|sample| self.sliding_weight(sample) * factor(sample))
            .sum();
        sum / self.torque
    }

    /// w f |V_s|/ω₁ of a sample.
    pub(super) fn sliding_weight(&self, sample: &LoadSample) -> f64 {
        let path = &self.pair.path;
        let arm = (sample.xi - path.eps_2).abs() * path.base_pitch.si();
        sample.weight.si() * sample.load.si() * (1.0 + 1.0 / self.pair.ratio) * arm
    }

    /// H_V = (1/cos β_b)·∫∫ f |V_s| dy dξ/(T₁ ω₁)                                [Loss-5]
    pub fn loss_factor(&self) -> f64 {
        self.loss_factor
    }

    /// Mean of μ f |V_s| over the mesh cycle divided by the input power, for a coefficient of friction that depends on
    /// the sample.
    pub fn friction_loss(&self, friction: impl Fn(&LoadSample) -> f64) -> f64 {
        self.sliding_integral(friction)
    }

    /// The gears.
    pub fn gears(&self) -> &GearPair {
        &self.pair
    }

    /// The law; `None` if it is user-defined.
    pub fn law(&self) -> Option<&LoadLaw> {
        self.law.as_ref()
    }

    /// Whether the law includes deflections.
    pub fn is_elastic(&self) -> bool {
        matches!(self.model, LoadModel::Elastic(..))
    }

    /// Magnitude of the torque at gear 1.
    pub fn torque(&self) -> Torque {
        Torque::from_si(self.torque)
    }

    /// Modifications of the flanks.
    pub fn micro_geometry(&self) -> &MicroGeometry {
        &self.micro
    }

    /// All points with their loads, in the order of phase, pair of teeth and face position.
    pub fn samples(&self) -> &[LoadSample] {
        &self.samples
    }

    /// Evidence of the solution of the map.
    pub fn evidence(&self) -> &LoadMapEvidence {
        &self.evidence
    }

    /// The loads on all lines of contact at a phase, for drawings. Weights are lengths of line.
    ///
    /// # Errors
    /// When the phase is not finite.
    pub fn at_phase(&self, phase: f64) -> Result<Vec<LoadSample>, GearError> {
        DomainError::require(
            phase.is_finite(),
            "mesh phase",
            phase,
            "-",
            "must be finite",
        )?;
        let phase = phase.rem_euclid(1.0);
        Ok(self
            .points_at(phase)?
            .into_iter()
            .map(|point| LoadSample {
                phase,
                xi: point.xi,
                y: self.pair.face_width * point.across,
                load: LineLoad::from_si(point.load),
                weight: Length::from_si(point.length),
            })
            .collect())
    }

    pub(super) fn points_at(&self, phase: f64) -> Result<Vec<LinePoint>, GearError> {
        let mut points = Vec::new();
        let mut evidence = self.evidence.clone();
        let phase = MeshPhase {
            phase,
            weight: 1.0,
            pitch: 0,
        };
        self.solve(&phase, &mut Vec::new(), &mut evidence, &mut |point| {
            points.push(point)
        })?;
        Ok(points)
    }

    /// A load map of the same torque and law with other settings, flank modifications or chamfers.
    pub(crate) fn variant(
        &self,
        pair: &GearPair,
        micro: &MicroGeometry,
        settings: &LoadMapSettings,
    ) -> Result<Self, GearError> {
        let torque = Torque::from_si(self.torque);
        // Only maps with an elastic law of this crate have variants.
        let law = self.law.clone().unwrap_or_default();
        Self::new(pair, torque, &law, micro, &self.materials, settings)
    }

    pub(crate) fn settings(&self) -> &LoadMapSettings {
        &self.settings
    }
}

fn elastic(
    pair: &GearPair,
    force: f64,
    law: &LoadLaw,
    micro: &MicroGeometry,
    materials: &[Material; 2],
    settings: &LoadMapSettings,
    evidence: &mut LoadMapEvidence,
) -> Result<LoadGrid, GearError> {
    let separation = Separation::new(micro, pair)?;
    let shift = match pair.profile_shift {
        Some(shift) => shift,
        None => {
            let shift = pair.likely_profile_shift();
            evidence.assumed_profile_shift = Some(shift);
            shift
        }
    };
    let mean_load = force / pair.mean_contact_length().si();
    let factor = settings.stiffness_factor;
    let compliance = if matches!(law, LoadLaw::IsoStiffness) {
        PairCompliance::iso(pair, shift, materials, factor, mean_load)?
    } else {
        PairCompliance::teeth(pair, shift, settings.root, materials, factor, mean_load)?
    };
    let cells = settings.cell_count(pair, separation.varies_across_the_face());
    evidence.stiffness = Some(compliance.source);
    evidence.cells = cells;
    let edges = if settings.edge_contact {
        Some(TipGaps::new(pair)?)
    } else {
        None
    };
    Ok(LoadGrid {
        compliance,
        separation,
        edges,
        cells,
        mean_load,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::GearPairInput;
    use asperity_core::quantity::{Angle, Density, Pressure, SpecificHeat, ThermalConductivity};

    #[test]
    fn equal_slices_are_the_uniform_law() {
        let pair = GearPair::new(&GearPairInput::standard(
            [23, 68],
            Length::from_si(1.8e-3),
            Angle::from_si(23.4f64.to_radians()),
            Length::from_si(32e-3),
        ))
        .unwrap();
        let steel = Material {
            young: Pressure::from_si(206e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(1e9),
            density: Density::from_si(7850.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(460.0),
        };
        let solve = |law| {
            let settings = LoadMapSettings {
                face_coupling: 0.0,
                cells: Some(128),
                ..LoadMapSettings::default()
            };
            let torque = Torque::from_si(145.0);
            let micro = MicroGeometry::default();
            LoadMap::new(&pair, torque, &law, &micro, &[steel; 2], &settings).unwrap()
        };
        let uniform = solve(LoadLaw::Uniform).loss_factor();
        assert!((uniform - 0.148_288).abs() < 1e-6, "{uniform}");
        let mut slices = solve(LoadLaw::Elastic);
        if let LoadModel::Elastic(grid, _) = &mut slices.model {
            grid.compliance = PairCompliance::constant(80e-12, 16e-12);
        }
        slices.run().unwrap();
        // 128 cells.
        assert!((slices.loss_factor() / uniform - 1.0).abs() < 1e-4);
    }
}
