//! Pictures of one rough contact, computed after the losses: its fields, the stress below it, the flanks facing each
//! other.

use std::sync::Arc;

use asperity_contact::ContactWarning;
use asperity_contact::plasticity::plastic_stress;
use asperity_contact::subsurface::{Peak, graded_depths, subsurface_stress};
use asperity_core::quantity::Length;

use crate::contacts::{Displacements, Pressing, WindowContact, pressing_history};
use crate::lubrication::{LubricatedMesh, LubricatedPosition, RoughFilm, SmoothPosition, doubts};
use crate::mesh::MeshPosition;
use crate::result::{ContactView, HistoryRow, PatchFields, PositionFields, SubsurfaceFields};
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{OffsetIndex, WindowPair};
use asperity_case::window_pressures::{LoadStep, Pressed};

/// The contact of one position at its first offset.
#[derive(Debug, Clone)]
pub(crate) struct Picture {
    /// Fields along the contact, if they are requested.
    pub fields: Option<PositionFields>,
    /// Summary of the stress below the contact, if that was computed.
    pub stress: Option<StressBelow>,
    /// The flanks facing each other.
    pub view: ContactView,
    /// Doubts about the rough contact.
    pub doubts: Vec<ContactWarning>,
}

/// Summary of the stress below a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StressBelow {
    /// Largest von Mises stress.
    pub largest: Peak,
    /// Greatest depth at which the von Mises stress exceeds the elastic limit; zero if it does so nowhere.
    pub yield_depth: Length,
    /// Share in which it does so, of the section as wide as the Hertz contact and half as deep.
    pub yield_share: f64,
}

impl Picture {
    /// The contact of `position` in its first window, with its fields and the history of its load if these are
    /// requested; `None` where no window is resolved.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn new(
        lubrication: &LubricatedMesh<'_>,
        position: &LubricatedPosition,
        contacts: &[Arc<WindowContact>],
        with_fields: bool,
    ) -> Result<Option<Self>, PositionError> {
        let case = lubrication.case;
        let Some(first) = contacts.first() else {
            return Ok(None);
        };
        let offset = OffsetIndex {
            k: 0,
            count: contacts.len(),
        };
        let Some(pair) = lubrication.pair(&position.at, first, offset)? else {
            return Ok(None);
        };
        let mut pressed = match &position.pressed {
            Some(pressed) => pressed.clone(),
            None => lubrication.pressed(position, 0, &pair)?,
        };
        let doubts = doubts(&pressed);
        // A law of the pressures records its history; the others solve for the load at once.
        if with_fields && position.pressed.is_none() {
            let pressing = Pressing {
                case,
                position: &position.at,
                pair: &pair,
                film_share: position.offsets[0].film_share,
            };
            pressed.history = pressing_history(&pressing, &pressed)
                .map_err(|error| error.keeping(&pair.x, &pair.gap))?;
        }
        let (mut fields, stress) = fields(case, position, &pair, pressed)?;
        if with_fields {
            fields.patch = patch(lubrication, position, first, contacts.len())?;
        }
        Ok(Some(Self {
            view: view(&fields, &position.at),
            fields: with_fields.then_some(fields),
            stress,
            doubts,
        }))
    }
}

/// The first patch of a position, of `count` windows; `None` of lines, and where the flanks do not touch.
fn patch(
    lubrication: &LubricatedMesh<'_>,
    position: &LubricatedPosition,
    contact: &WindowContact,
    count: usize,
) -> Result<Option<PatchFields>, PositionError> {
    let Some(share) = position.offsets[0].solved else {
        return Ok(None);
    };
    if share.asperity_share == 0.0 {
        return Ok(None);
    }
    let (of_pair, ..) = lubrication.surfaces.met(position.at.zone, 0, count);
    let of_position = SmoothPosition {
        at: &position.at,
        film: &position.film,
    };
    let film = RoughFilm::at(lubrication.case, lubrication.laws, of_pair, of_position)?;
    film.map_or(Ok(None), |film| film.patch(&position.at, contact, &share))
}

/// Fields along a contact with a summary of the stress below it.
fn fields(
    case: &OperatingCase,
    position: &LubricatedPosition,
    pair: &WindowPair,
    pressed: Pressed,
) -> Result<(PositionFields, Option<StressBelow>), PositionError> {
    let (at, offset) = (&position.at, &position.offsets[0]);
    let n = pair.x.len();
    let displacements = match &pressed.solids {
        Some(solids) => Displacements::new(&case.materials, case.flow_pressure, solids)?,
        None => Displacements::none(n),
    };
    let solid = match &pressed.solids {
        Some(solids) => solids.pressure.clone(),
        None => vec![0.0; n],
    };
    let gap = match (&pressed.solids, &position.full_film) {
        (Some(solids), _) => solids.gap.clone(),
        (None, Some(film)) => film.gap_at(&pair.x, at.motion.radius),
        (None, None) => vec![position.film.shown.central.si(); n],
    };
    let shear = offset.shear(case, at, &pressed);
    let sums = solid.iter().zip(&pressed.fluid).map(|(s, f)| s + f);
    let total: Vec<f64> = sums.collect();
    let (subsurface, stress) = stress_below(case, at, pair, &total, &shear)?.unzip();
    let displacement = |body: usize| {
        let pairs = displacements.elastic[body]
            .iter()
            .zip(&displacements.plastic[body]);
        pairs.map(|(e, p)| e + p).collect()
    };
    let fields = PositionFields {
        position: at.number,
        x: pair.x.clone(),
        height_pinion: pair.heights[0].clone(),
        height_wheel: pair.heights[1].clone(),
        displacement_pinion: displacement(0),
        displacement_wheel: displacement(1),
        plastic_pinion: displacements.plastic[0].clone(),
        plastic_wheel: displacements.plastic[1].clone(),
        gap,
        pressure_solid: solid,
        pressure_fluid: pressed.fluid,
        shear,
        subsurface,
        history: pressed
            .history
            .iter()
            .enumerate()
            .map(|(index, step)| history_row(index, step))
            .collect(),
        patch: None,
    };
    Ok((fields, stress.flatten()))
}

fn history_row(index: usize, step: &LoadStep) -> HistoryRow {
    HistoryRow {
        step: index + 1,
        approach: step.approach,
        load_solid: step.load_solid,
        load_fluid: step.load_fluid,
        load_error: step.load_error,
    }
}

/// The flanks of `fields` facing each other.
///
/// The pinion's flank is z₁ = −κ₁ x²/2 + h₁ − δ₁ with its curvature κ₁ = (1/R) ρ₂/(ρ₁ + ρ₂), the wheel's lies the
/// gap above it; δ is the displacement.
fn view(fields: &PositionFields, position: &MeshPosition) -> ContactView {
    let motion = &position.motion;
    let curvature = motion.rho2 / (motion.rho1 + motion.rho2) / motion.radius.si();
    let half_width = position.hertz.half_width.si();
    let height = |i: usize| {
        let form = 0.5 * curvature * fields.x[i] * fields.x[i];
        fields.height_pinion[i] - fields.displacement_pinion[i] - form
    };
    let within = |reach: f64| (0..fields.x.len()).filter(move |&i| fields.x[i].abs() <= reach);
    let (sum, count) =
        within(half_width).fold((0.0, 0.0), |(sum, count), i| (sum + height(i), count + 1.0));
    let level = if count > 0.0 { sum / count } else { 0.0 };
    let column = |value: &dyn Fn(usize) -> f64| -> Vec<f64> {
        within(ContactView::REACH * half_width).map(value).collect()
    };
    let pinion = |i: usize| height(i) - level;
    ContactView::new(
        fields.position,
        column(&|i| fields.x[i] * 1e6),
        [
            column(&|i| pinion(i) * 1e6),
            column(&|i| (pinion(i) + fields.gap[i]) * 1e6),
            column(&|i| fields.pressure_solid[i] * 1e-6),
            column(&|i| fields.pressure_fluid[i] * 1e-6),
        ],
    )
}

fn stress_below(
    case: &OperatingCase,
    position: &MeshPosition,
    pair: &WindowPair,
    pressure: &[f64],
    shear: &[f64],
) -> Result<Option<(SubsurfaceFields, Option<StressBelow>)>, PositionError> {
    let spacing = pair.spacing;
    if case.model.depths < 2 {
        return Ok(None);
    }
    let half_width = position.hertz.half_width;
    let depths = graded_depths(spacing, half_width, case.model.depths)?;
    let field = subsurface_stress(pressure, Some(shear), spacing, &depths)?;
    let von_mises = field.von_mises(case.materials[0].poisson)?;
    let plastic = plastic_stress(&von_mises, case.elastic_limit())?;
    let yield_depth = field.yield_zone(&plastic).map(|zone| zone.deepest);
    let middle = Length::from_si(-pair.x.first().copied().unwrap_or_default());
    let stress = field.peak(&von_mises).map(|largest| StressBelow {
        largest,
        yield_depth: yield_depth.unwrap_or_default(),
        yield_share: field.yield_share(&plastic, middle, half_width),
    });
    let fields = SubsurfaceFields {
        depths,
        sigma_xx: field.sigma_xx,
        sigma_zz: field.sigma_zz,
        tau_xz: field.tau_xz,
        von_mises,
        plastic_stress: plastic,
    };
    Ok(Some((fields, stress)))
}
