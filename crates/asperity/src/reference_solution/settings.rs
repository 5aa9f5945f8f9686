//! From a case and a place on its path to the rough contact of the reference solution.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::numerics::GOLDEN_SECTION;
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, Profile};
use asperity_ehl::{
    CELL_MULTIPLE, FrictionLaw, LineContact, MovingProfile, Oil, PlasticCeiling, RecordHeat,
    RecordSettings, RoughContact, Scales, Window,
};
use asperity_ehl_regime::inlet_flow::CentralFilm;
use asperity_ehl_regime::{
    Attenuation, FilmConditions, FilmLaw, GapLaw, MoesNumbers, TraceSpectrum,
};
use asperity_oil::{DensityLaw, FilmRheology, PressureViscosityLaw, ShearLaw, TractionConstants};
use asperity_roughness::gaussian_filter::{Ends, mean_line};

use super::error::ReferenceError;
use crate::contacts::running_in::run_in;
use crate::mesh::{MeshPosition, position_at};
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::Texture;

/// Attenuated roughness over the smooth film beyond which the contact is not a reference, because oil cannot leak along the ridges:
/// compared with gear tests, gap and friction are off from about 3 on.
pub const LARGEST_ROUGHNESS: f64 = 3.0;
/// Roelands' exponent of the film; one that follows from α and η₀ moves the shares by some 2 %.
const ROELANDS: f64 = 0.6;
/// Shortest wavelength in the traces unless one is stated. Ten records solved again with waves down to 2.5 µm have up to 4 %
/// more friction (one 13 %) and up to 11 % more load below 20 nm (one 27 %), half of it by their finer grid.
const SHORTEST_WAVE: Length = Length::from_si(8e-6);
/// Cells that the shortest wave spans at least.
const CELLS_A_WAVE: f64 = 8.0;
/// Part of a trace over which its end fades into its beginning.
const OVERLAP: f64 = 0.1;
/// Parts of the traces at which a record begins: the pairs of a record are unrelated.
const OFFSETS: [f64; 2] = [0.07, 0.44];

/// Parts of the traces between one record and the next: multiples of them, minus their whole parts, fill the
/// traces evenly and never the same pairs.
const OFFSET_STEPS: [f64; 2] = [GOLDEN_SECTION, 0.414_213_562_373_095];

/// Choices of the reference solution.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceSettings {
    /// Grid, length and films of the record; the case gives its law of friction, heat and ceiling.
    pub record: RecordSettings,
    /// Eyring stress that replaces the value of the base oil.
    pub eyring_stress: Option<Pressure>,
    /// Whether the friction also has the heat of film and surfaces.
    pub with_heat: bool,
    /// Number of the pair of places on the traces at which the record begins, from 0.
    pub beginning: usize,
    /// Shortest wavelength in the traces, with at least the cells that it needs; by default 8 µm, or longer if that spans fewer
    /// than 8 cells.
    pub shortest_wave: Option<Length>,
    /// Begin of the window.
    pub inlet: Inlet,
}

/// Begin of the window of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Inlet {
    /// As the record states it.
    Stated,
    /// Where the inlet is flooded.
    Flooded,
    /// Flooded at light load, as stated elsewhere.
    #[default]
    ByLoad,
}

impl Inlet {
    /// Inlet over that of the tabulated window, whose film is flooded to 0.2 %: at .3 GPa and 9000 1/min, where a window from −2.5
    /// half-widths on shears a smooth film 70 % harder, this one shears it 1 % harder.
    const FLOODED: f64 = 0.65;
    /// Moes' M below which the load is light: a window from −2.5 half-widths on changes the friction by 9 % at 5, by 4 % at 9 and by
    /// 1 % at 15.
    const LIGHT: f64 = 8.0;

    /// Widens the window of `record`, of a contact with these scales, with cells as wide as before.
    pub fn apply(self, record: &mut RecordSettings, scales: &Scales) {
        let is_flooded = match self {
            Self::Stated => false,
            Self::Flooded => true,
            Self::ByLoad => scales.moes_load < Self::LIGHT,
        };
        if !is_flooded {
            return;
        }
        let Window { inlet, outlet } = Window::tabulated(scales);
        let flooded = Window {
            inlet: (Self::FLOODED * inlet).min(record.window.inlet),
            outlet,
        };
        let length = |window: &Window| window.outlet - window.inlet;
        let cells = record.cells as f64 * length(&flooded) / length(&record.window);
        record.cells = (cells.ceil() as usize).next_multiple_of(CELL_MULTIPLE);
        record.window = flooded;
    }
}

/// The lubricated contact of a case at one place, with what was measured of its roughness.
#[derive(Debug, Clone)]
pub struct ReferenceContact {
    /// Place on the path, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// The smooth mesh position.
    pub position: MeshPosition,
    /// Bodies, oil and surfaces.
    pub rough: RoughContact,
    /// Grid, length, friction, heat and ceiling.
    pub record: RecordSettings,
    /// Both traces as the transient solution uses them: without waves too short for its cells.
    pub traces: [Profile; 2],
    /// Standard deviation of the roughness that is left in the contact, of both traces together.
    pub attenuated_roughness: Length,
}

impl ReferenceContact {
    /// The contact of `loaded` at `path_fraction`, 0 at A and 1 at E; of flanks that have run in, where the
    /// case asks
    /// for them.
    ///
    /// # Errors
    /// When an equation refuses the place, a flank has no trace, a trace is too short for the filter, or
    /// the base
    /// oil is not known.
    pub fn new(
        loaded: &OperatingCase,
        path_fraction: f64,
        settings: &ReferenceSettings,
    ) -> Result<Self, ReferenceError> {
        let case = loaded;
        let path = case.gears.path();
        let position = position_at(case, path.a + (path.e - path.a) * path_fraction)?;
        let Some(plan) = &case.running_in else {
            return Self::at(loaded, position, settings);
        };
        let ran_in = run_in(case, &loaded.surfaces, plan, &|_| {})?;
        let worn = loaded.with_surfaces(ran_in.surfaces);
        Self::at(&worn, position, settings)
    }

    /// The contact of `loaded` at a mesh position.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at(
        loaded: &OperatingCase,
        position: MeshPosition,
        settings: &ReferenceSettings,
    ) -> Result<Self, ReferenceError> {
        let case = loaded;
        let path = case.gears.path();
        let path_fraction = (position.s - path.a) / (path.e - path.a);
        loaded.surfaces.check_one_pair()?;
        let [Texture::Trace(first), Texture::Trace(second)] = loaded.surfaces.textures() else {
            return Err(PositionError::no_profile().into());
        };
        let contact = line_contact(case, &position);
        let rheology = rheology(case)?;
        let stress = (settings.eyring_stress).unwrap_or(rheology.constants().eyring_stress);
        let constants = TractionConstants {
            eyring_stress: stress,
            ..*rheology.constants()
        };
        let oil = oil_of(case, ShearLaw::Eyring { stress });
        let mut record = settings.record.clone();
        settings.inlet.apply(&mut record, &contact.scales(&oil)?);
        record.friction = Some(FrictionLaw {
            viscosity: oil.viscosity,
            pressure_viscosity: oil.pressure_viscosity * constants.pressure_viscosity_factor,
            eyring_stress: stress,
            limiting_stress: constants.ambient_limit,
            limiting_slope: constants.limiting_shear_at(case.temperature()),
            boundary_friction: case.model.boundary_friction,
            boundary_layer: case.model.boundary_layer,
        });
        record.heat = if settings.with_heat {
            Some(RecordHeat {
                rheology: rheology.with_constants(constants)?,
                bulk: case.temperature(),
                bodies: case.materials,
            })
        } else {
            None
        };
        let [pinion, wheel] = case.flow_pressure.map(Pressure::si);
        record.ceiling = Some(PlasticCeiling {
            pressure: Pressure::from_si(pinion.min(wheel)),
        });
        let window = record.window.outlet - record.window.inlet;
        let length = position.hertz.half_width * window;
        if let Some(wave) = settings.shortest_wave {
            record.cells = record.cells.max(cells_for(length, wave)?);
        }
        let cell = length.si() / record.cells.max(1) as f64;
        let wave = settings.shortest_wave.unwrap_or(SHORTEST_WAVE);
        let shortest = Length::from_si(wave.si().max(CELLS_A_WAVE * cell));
        let traces = [smoothed(first, shortest)?, smoothed(second, shortest)?];
        let begins = [0, 1].map(|surface| {
            let number = settings.beginning as f64;
            (OFFSETS[surface] + number * OFFSET_STEPS[surface]).fract()
        });
        let rough = RoughContact {
            contact,
            oil,
            surface_1: moving(&traces[0], begins[0])?,
            surface_2: moving(&traces[1], begins[1])?,
        };
        let attenuated_roughness = attenuated_roughness(&contact, &oil, &[&traces[0], &traces[1]])?;
        Ok(Self {
            path_fraction,
            position,
            rough,
            record,
            traces,
            attenuated_roughness,
        })
    }
}

/// Least number of cells over `length` of which a wave spans enough.
fn cells_for(length: Length, wave: Length) -> Result<usize, DomainError> {
    let wave = DomainError::positive("shortest wave", wave)?;
    let cells = (CELLS_A_WAVE * length.si() / wave).ceil() as usize;
    Ok(cells.next_multiple_of(CELL_MULTIPLE))
}

/// Bodies and Newtonian oil of a mesh position, without its surfaces.
pub(crate) fn smooth_contact(case: &OperatingCase, position: &MeshPosition) -> (LineContact, Oil) {
    (
        line_contact(case, position),
        oil_of(case, ShearLaw::Newtonian),
    )
}

/// The oil at the temperature of the case.
fn oil_of(case: &OperatingCase, shear_law: ShearLaw) -> Oil {
    Oil {
        viscosity: case.oil().dynamic_viscosity,
        pressure_viscosity: case.oil().pressure_viscosity,
        viscosity_law: PressureViscosityLaw::Roelands { exponent: ROELANDS },
        density_law: DensityLaw::DowsonHigginson,
        shear_law,
    }
}

fn line_contact(case: &OperatingCase, position: &MeshPosition) -> LineContact {
    LineContact {
        radius: position.motion.radius,
        modulus: case.modulus,
        load: position.load,
        speed_1: position.motion.u1,
        speed_2: position.motion.u2,
    }
}

/// The oil in the film, from the case or the constants of its base oil.
pub(crate) fn rheology(case: &OperatingCase) -> Result<FilmRheology, ReferenceError> {
    match (case.rheology(), case.lubricant.base_oil()) {
        (Some(rheology), _) => Ok(rheology.clone()),
        (None, Some(base)) => Ok(FilmRheology::new(&case.lubricant, base)?),
        (None, None) => Err(ReferenceError::NoBaseOil),
    }
}

/// The trace without waves shorter than `shortest`.
fn smoothed(trace: &Profile, shortest: Length) -> Result<Profile, ReferenceError> {
    if shortest < trace.spacing() * 2.0 {
        return Ok(trace.clone());
    }
    let heights = mean_line(trace, shortest, Ends::Reg0)?;
    Ok(Profile::new(trace.spacing(), heights)?)
}

/// The trace as a surface that repeats, begun at a part of its length.
fn moving(trace: &Profile, offset: f64) -> Result<MovingProfile, DomainError> {
    let length = trace.length();
    Ok(MovingProfile::blended(trace, length * OVERLAP)?.shifted(length * offset))
}

/// Standard deviation σ_d of the roughness that rough surfaces keep in a lubricated contact: the root of the
/// sum of the mean squares of their attenuated traces, which pass each other and are unrelated. The coefficients of the
/// gap law `power` describe these solutions.
///
/// # Errors
/// When a number is outside its domain, or a height is not finite.
pub fn attenuated_roughness(
    contact: &LineContact,
    oil: &Oil,
    traces: &[&Profile],
) -> Result<Length, ReferenceError> {
    let conditions = conditions(contact, oil);
    let hertz = HertzLine::new(contact.load, contact.radius, contact.modulus)
        .map_err(PositionError::from)?;
    let numbers = MoesNumbers::from_groups(&conditions.line_groups()?)?;
    let nabla = numbers.nabla_per_length(hertz.half_width)?;
    let attenuation = Attenuation::new(GapLaw::Power, nabla)?;
    let mut squares = 0.0;
    for trace in traces {
        let left = TraceSpectrum::new(trace.heights(), trace.spacing())?.attenuated(&attenuation);
        squares += left.iter().map(|z| z * z).sum::<f64>() / left.len() as f64;
    }
    Ok(Length::from_si(squares.sqrt()))
}

/// Gap in the middle and minimum film of smooth surfaces by Dowson and Toyoda, and Dowson and Higginson; their
/// central film is a flow of mass, and the gap thinner by the density under the Hertz pressure.
///
/// # Errors
/// When a number is outside its domain.
pub fn formula_film(contact: &LineContact, oil: &Oil) -> Result<[Length; 2], ReferenceError> {
    let film = FilmLaw::DowsonToyoda.film(&conditions(contact, oil))?.value;
    let hertz = HertzLine::new(contact.load, contact.radius, contact.modulus)
        .map_err(PositionError::from)?;
    let gap = CentralFilm::Gap.thickness(film.central, hertz.max_pressure)?;
    Ok([gap, film.minimum])
}

/// Inputs of the film formulas for a contact.
fn conditions(contact: &LineContact, oil: &Oil) -> FilmConditions {
    FilmConditions {
        entrainment: (contact.speed_1 + contact.speed_2) * 0.5,
        radius: contact.radius,
        load: contact.load,
        modulus: contact.modulus,
        viscosity: oil.viscosity,
        pressure_viscosity: oil.pressure_viscosity,
        contact_length: None,
    }
}
