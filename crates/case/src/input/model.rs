//! Choices of the model: one row for each key, with its default by formulation and its check.

use asperity_contact::SolverSettings;
use asperity_core::DomainError;
use asperity_core::quantity::{Length, Ratio};
use asperity_efficiency::swept::HYSTERESIS;
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_ehl_regime::{FilmLaw, ThermalLaw};
use asperity_flanks::error::NARROWEST_WINDOW;
use asperity_gear::{GearPair, LoadLaw, LoadMapSettings};
use asperity_ns_film::FluidModel;
use asperity_oil::{PressureLaw, ShearLawName};
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION, BOUNDARY_LAYER, INNER_BOUNDARY};
use asperity_tribo_friction::{FrictionLaw, FrictionSettings, RoughnessReading};
use serde::Serialize;

use super::film_friction_input::FilmFrictionInput;
use super::law_names::{FullFilmName, LoadShareName};
use super::one_or_two::OneOrTwo;
use super::path_point::{NamedPoint, PathPoint, Positions};
use super::rows::{OPEN, StatedRow, choices};
use crate::source::case_error::{CaseError, LOOSEST_TOLERANCE};
use crate::source::defaults::Defaults;
use crate::source::section::{Section, domain};
use crate::source::source_text::Source;

/// Offsets of a case that states none, at least.
pub const LEAST_OFFSETS: usize = 16;

choices! {
    /// Choices of the model.
    ModelInput =>
    /// Choices of the model, all made.
    Model in "model" by Choices<'_>;

    with {
        /// Choices that the friction laws leave open.
        friction_settings: FrictionSettings = film_friction.settings();
    }

    /// Number of cells along the path of contact, with one contact evaluated in each; default 16 (`paper`:
    /// one position).
    positions: usize = of_path(16) usual "" [1.0, 1000.0],
        check("positions", |n| (1.0..=10_000.0).contains(&n), "must be 1 to 10000");
    /// Number of offsets along the traces at which the flanks meet; default 16, and up to 256 where the contacts
    /// differ from offset to offset; 4 of each pair of surrogates (`paper`: 1).
    offsets: usize = default(LEAST_OFFSETS) usual "" [1.0, 1000.0],
        check("offsets", |n| (1.0..=10_000.0).contains(&n), "must be 1 to 10000");
    /// Half-width of the contact window, in Hertz half-widths; default 3.
    window: f64 = default(3.0) usual "" [1.5, 50.0],
        check("window", |w| (NARROWEST_WINDOW..=100.0).contains(&w), "must be 1.5 to 100 Hertz half-widths");
    /// Law of the load distribution over the teeth in contact; default `elastic` (`paper`: `mean-length`).
    load_distribution: LoadLaw = default(LoadLaw::Elastic) => table;
    /// Correction factor C_M of the tooth stiffness, theoretical to measured; default 0.8.
    #[serde(skip_serializing_if = "Option::is_none")]
    stiffness_factor: f64 =
        listed_if(load_distribution.is_elastic(), LoadMapSettings::default().stiffness_factor) usual "" [0.5, 1.5],
        check("stiffness factor", |k| (0.05..=20.0).contains(&k), "must be 0.05 to 20");
    /// Length over which a tooth spreads a load along its face width, in modules; default 1.55.
    #[serde(skip_serializing_if = "Option::is_none")]
    face_coupling: f64 =
        listed_if(load_distribution.is_elastic(), LoadMapSettings::default().face_coupling) usual "" [0.5, 5.0],
        check("face coupling", |l| (0.05..=20.0).contains(&l), "must be 0.05 to 20 modules");
    /// Include contact of tip edges outside the path of contact; default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    edge_contact: bool = listed_if(load_distribution.is_elastic(), false);
    /// Friction law of the film; default `eyring` (`paper`: `xu`). `eyring`, `carreau` and `newton` describe
    /// the film alone; the others are published laws, most of which include asperity friction in their
    /// coefficient. With settings: `{ constant = 0.05 }`, its coefficient; `{ iso-14179-2 = 0.9 }`, the lubricant factor X_L
    /// (default 1, mineral oil); `{ xu = "file.json" }`, coefficients from your own calibration.
    film_friction: FilmFrictionInput = film_friction() => table;
    /// Law of viscosity against pressure for the film friction laws `eyring`, `carreau` and `newton`; default
    /// `barus`.
    film_pressure_law: PressureLaw = default(PressureLaw::default());
    /// Factor on the friction coefficient of the film (lubricant factor); default 1.
    friction_scale: f64 = default(1.0) usual "" [0.2, 3.0],
        check("friction scale", |k| k > 0.0 && k <= 10.0, "must be positive and at most 10");
    /// Coefficient of boundary friction μ_b; default 0.09 (`paper`: 0.3, metal on metal).
    boundary_friction: f64 = default(BOUNDARY_FRICTION) usual "" [0.02, 0.5],
        check("boundary friction", |mu| (0.0..=2.0).contains(&mu), "must be 0 to 2");
    /// Thickness of the boundary layer on touching asperities; default 10 nm, which applies to λs = 2.5 um.
    boundary_layer: Length = default(BOUNDARY_LAYER) usual "nm" [0.5, 200.0],
        check("boundary layer", |h| (0.0..=1e-6).contains(&h), "must be 0 to 1 um");
    /// Lay γ of the roughness, one value for both flanks or `[pinion, wheel]`: from 0 or `across`, ridges
    /// across the whole face width, to 1 or `isotropic`; default as measured on the surface of the traces, otherwise 1/12,
    /// the middle of measured ground flanks.
    lay: OneOrTwo<Lay> => [Lay; 2] = default(OneOrTwo::One(Lay::GROUND)) usual "" [0.0, 1.0];
    /// Least share on the boundary layer of asperities that come into contact past the inlet; default 0.75, sampled from 0.6 to 0.9.
    #[serde(skip_serializing_if = "Option::is_none")]
    inner_boundary: f64 = default(INNER_BOUNDARY) usual "" [0.05, 1.0],
        check("inner boundary", |b| (0.0..=1.0).contains(&b), "must be 0 to 1");
    /// Film thickness law; default `steady` (`paper`: `hamrock-dowson`).
    film: FilmLaw = default(FilmLaw::Steady);
    /// Thermal reduction of the film and of rolling; default `gupta` (`paper`: `none`).
    thermal: ThermalLaw = default(ThermalLaw::Gupta);
    /// Feed the flash temperature back into the viscosity of the friction law; default false.
    flash_feedback: bool = default(false);
    /// Share of the load carried by the film: `solved` (default; `paper`: `lambda-star`) from the rough contact; with `lambda-star`,
    /// `zhu-hu`, `masjedi-khonsari` and `jgp` all load on asperities rubs with the boundary coefficient;
    /// `ehl` computes shares and friction from transient reference solutions, which need a minute or
    /// more.
    (crate) load_share: LoadShareName = default(LoadShareName::Solved);
    /// Source of a film that carries the whole load: `formulas` (default), `ehl`, the steady
    /// elastohydrodynamic solution of smooth flanks, or `ehl-transient`, transient solutions with both traces.
    #[serde(skip_serializing_if = "Option::is_none")]
    full_film: FullFilmName = listed_if(false, FullFilmName::Formulas);
    /// Thickness of the oil layers of both flanks together ahead of the contact, where an oil jet does not flood the inlet;
    /// default flooded. The film is starved, and thickens as the asperities take load off it: with a layer that is thick enough the ground e-drive
    /// loses 2 % more than flooded. The rolling resistance is left as flooded.
    #[serde(skip_serializing_if = "Option::is_none")]
    inlet_layer: Length => Option<Length> = starved_inlet(load_share, full_film) usual "um" [0.01, 1000.0];
    /// The elastohydrodynamic solutions of `load_share = "ehl"` and `full_film`.
    #[serde(skip_serializing_if = "Option::is_none")]
    ehl: EhlInput => EhlChoices = ehl_solutions(load_share, full_film) => table;
    /// Tolerance of the contact solver's certificate on lines; of patches a thousand times as much; default 1e-8.
    tolerance: f64 = default(1e-8) usual "" [1e-10, 1e-6],
        check("tolerance", |t| (1e-16..=LOOSEST_TOLERANCE).contains(&t), "must be 1e-16 to 1e-4");
    /// Fraction of the elastic energy lost in hysteresis, part of rolling; default 0.5 % (`paper`: 0).
    hysteresis: Ratio => f64 = default(Ratio::new(HYSTERESIS)) usual "%" [0.01, 5.0],
        check("hysteresis", |h| (0.0..=1.0).contains(&h), "must be 0 to 1");
    /// Number of depths at which subsurface stress is computed; default 24.
    depths: usize = default(24) usual "" [1.0, 1000.0], check("depths", |n| n <= 1000.0, "must be at most 1000");
}

choices! {
    /// Choices of the formulation `paper`.
    PaperInput =>
    /// Choices of the formulation `paper`, all made.
    PaperChoices in "paper" by Choices<'_>;

    with {}

    /// The single position: 0 at A, 1 at E, or `A` … `E`; default `C`.
    position: PathPoint => f64 = point_of_path() usual "" [0.0, 1.0],
        check("position", |s| (0.0..=1.0).contains(&s), "must be A to E, or 0 to 1");
    /// Model of the fluid pressure across the film; default `paper`.
    fluid_pressure: FluidModel = of_single_position(FluidModel::Paper);
    /// Step by which the surfaces are lowered into each other; default 80 nm.
    delta_step: Length = of_single_position(Length::from_si(80e-9)) usual "nm" [1.0, 1000.0],
        check("step", |d| d > 0.0 && d < 1e-3, "must be positive and below 1 mm");
    /// Load error at which the marching stops; default 1 %.
    numerical_error: Ratio => f64 = of_single_position(Ratio::new(0.01)) usual "%" [0.01, 20.0],
        check("numerical error", |e| e > 0.0 && e <= 0.2, "must be above 0 and at most 20 %");
}

choices! {
    /// Grid and length of the elastohydrodynamic solutions, and where reference solutions are stored.
    EhlInput =>
    /// Choices of the elastohydrodynamic solutions.
    EhlChoices in "model.ehl" by Choices<'_>;

    with {}

    /// Number of reference solutions along the path of contact; default 8. Shares and friction are interpolated between
    /// them.
    records: usize = of_records(8) usual "" [2.0, 64.0],
        check("reference solutions along the path", |n| (2.0..=64.0).contains(&n), "must be 2 to 64");
    /// Number of cells along the contact, a multiple of 64; default 512.
    cells: usize = of_solutions(512) usual "" [64.0, 8192.0], check(
        "cells across the film",
        |n| n % 64.0 == 0.0 && (64.0..=8192.0).contains(&n),
        "must be a multiple of 64, 64 to 8192"
    );
    /// Travel of a reference solution in half-widths of the contact; default 20.
    travel: f64 = of_records(20.0) usual "" [2.0, 1000.0],
        check("travel of a reference solution", |a| (2.0..=1000.0).contains(&a), "must be 2 to 1000 half-widths");
    /// Cache folder for reference solutions, so that none is solved twice: `user` (default), the cache folder of the user
    /// (`asperity` in `$XDG_CACHE_HOME`, `~/.cache` or `%LOCALAPPDATA%`), a folder relative to the case file,
    /// or `off`.
    cache: String = of_records("user".to_owned());
}

impl Model {
    /// Settings of the solver of rough contacts.
    #[must_use]
    pub fn contact_settings(&self) -> SolverSettings {
        SolverSettings {
            tolerance: self.tolerance,
            ..SolverSettings::default()
        }
    }

    /// Whether load share or full film need the oil's rheology, whatever the law of film friction.
    pub(crate) fn shears_its_film(&self) -> bool {
        use LoadShareName::{Ehl, Jgp, Solved};
        matches!(self.load_share, Solved | Jgp | Ehl) || self.full_film != FullFilmName::Formulas
    }
}

/// Statements of a formulation about the choices.
pub(crate) struct OfFormulation {
    /// Defaults that differ.
    pub defaults: ModelInput,
    /// Keys whose defaults are not listed.
    pub unused_keys: &'static [&'static str],
    /// Places of the path that represent the mesh.
    pub positions: Positions,
    /// Roughness in Xu's law.
    pub xu_roughness: RoughnessReading,
}

/// Makes every choice that the case leaves open.
pub(crate) fn model(
    stated: &ModelInput,
    of_paper: &PaperInput,
    formulation: &OfFormulation,
    gears: &GearPair,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<(Model, PaperChoices), CaseError> {
    let mut choices = Choices {
        formulation,
        gears,
        source,
        defaults,
        has_solutions: false,
        has_records: false,
    };
    let mut model = Model::from_input(stated, &formulation.defaults, &mut choices)?;
    model.friction_settings.xu.roughness = formulation.xu_roughness;
    let paper = PaperChoices::from_input(of_paper, &PaperInput::default(), &mut choices)?;
    Ok((model, paper))
}

/// Choice of one value after the other: the methods are the ways in which a row states its default.
struct Choices<'a> {
    formulation: &'a OfFormulation,
    gears: &'a GearPair,
    source: &'a Source,
    defaults: &'a mut Defaults,
    /// Whether elastohydrodynamic solutions are needed.
    has_solutions: bool,
    /// Whether records of them along the path are needed.
    has_records: bool,
}

type Key = &'static str;
type OpenChoice<T> = Result<T, CaseError>;

impl Choices<'_> {
    /// A default, which is listed unless the formulation does not use the key.
    fn default<T: Serialize>(
        &mut self,
        key: Key,
        stated: StatedRow<T>,
        default: T,
    ) -> OpenChoice<T> {
        let is_used = !self.formulation.unused_keys.contains(&key);
        self.listed_if(key, stated, is_used, default)
    }

    /// A default of elastohydrodynamic solutions.
    fn of_solutions<T: Serialize>(
        &mut self,
        key: Key,
        stated: StatedRow<T>,
        default: T,
    ) -> OpenChoice<T> {
        self.listed_if(key, stated, self.has_solutions, default)
    }

    /// A default of reference solutions along the path.
    fn of_records<T: Serialize>(
        &mut self,
        key: Key,
        stated: StatedRow<T>,
        default: T,
    ) -> OpenChoice<T> {
        self.listed_if(key, stated, self.has_records, default)
    }

    /// A default that is listed only if the run uses the value.
    fn listed_if<T: Serialize>(
        &mut self,
        key: Key,
        stated: StatedRow<T>,
        is_used: bool,
        default: T,
    ) -> OpenChoice<T> {
        let default = stated.by_formulation.unwrap_or(default);
        Ok(if is_used {
            self.defaults.take(key, stated.by_case, default)
        } else {
            stated.by_case.unwrap_or(default)
        })
    }

    /// The layers of a starved inlet, which solutions with a flooded one do not have.
    fn starved_inlet(
        &mut self,
        key: Key,
        stated: StatedRow<Length>,
        share: LoadShareName,
        film: FullFilmName,
    ) -> OpenChoice<Option<Length>> {
        let Some(layer) = stated.value() else {
            return Ok(None);
        };
        let is_flooded = share == LoadShareName::Ehl || film != FullFilmName::Formulas;
        if is_flooded {
            let rule = "starves the film of the formulas in the corrected formulation; leave it out or choose these";
            return Err(Section::new(self.source, key).conflict("", rule));
        }
        let rule = "must be above 0 and at most 1 mm";
        let holds = layer.si() > 0.0 && layer.si() <= 1e-3;
        DomainError::require(holds, "oil layer", layer.si(), "m", rule)
            .map_err(domain(self.source, key))?;
        Ok(Some(layer))
    }

    /// A number of positions; one if a single position represents the mesh.
    fn of_path(&mut self, key: Key, stated: StatedRow<usize>, default: usize) -> OpenChoice<usize> {
        match self.formulation.positions {
            Positions::AlongPath => self.default(key, stated, default),
            Positions::Single => Ok(1),
        }
    }

    /// The pitch point by default; the middle of a path that does not contain it.
    fn point_of_path(&mut self, key: Key, stated: StatedRow<PathPoint>) -> OpenChoice<f64> {
        let path = self.gears.path();
        let pitch = PathPoint::Named(NamedPoint::C);
        let has_pitch = (0.0..=1.0).contains(&pitch.fraction_of(path));
        let point = match (self.formulation.positions, stated.value()) {
            (Positions::Single, None) if !has_pitch => {
                let rule = "the pitch point lies outside the path of contact, so paper.position needs a value from 0 (A) to 1 (E)";
                return Err(Section::new(self.source, "gears").conflict("", rule));
            }
            (Positions::AlongPath, None) if !has_pitch => PathPoint::Fraction(0.5),
            (Positions::Single, stated) => self.defaults.take(key, stated, pitch),
            (Positions::AlongPath, stated) => stated.unwrap_or(pitch),
        };
        Ok(point.fraction_of(path))
    }

    /// A default of a formulation with a single position, which no other uses.
    fn of_single_position<T: Serialize>(
        &mut self,
        key: Key,
        stated: StatedRow<T>,
        default: T,
    ) -> OpenChoice<T> {
        let is_used = self.formulation.positions == Positions::Single;
        self.listed_if(key, stated, is_used, default)
    }

    /// The friction law of the film, with settings that it can have.
    fn film_friction(
        &mut self,
        key: Key,
        stated: StatedRow<FilmFrictionInput>,
    ) -> OpenChoice<FilmFrictionInput> {
        let eyring = FilmFrictionInput::Film(ShearLawName::Eyring);
        let chosen = self.default(key, stated, eyring)?;
        if chosen == FrictionLaw::Constant.into() {
            let rule = "needs its coefficient, as { constant = 0.05 }";
            return Err(Section::new(self.source, key).conflict("", rule));
        }
        chosen.check().map_err(domain(self.source, key))?;
        Ok(chosen)
    }

    /// The choices of the solutions that load share and full film need.
    fn ehl_solutions(
        &mut self,
        _: Key,
        stated: StatedRow<EhlInput>,
        share: LoadShareName,
        film: FullFilmName,
    ) -> OpenChoice<EhlChoices> {
        self.has_records = share == LoadShareName::Ehl || film == FullFilmName::EhlTransient;
        self.has_solutions = self.has_records || film == FullFilmName::Ehl;
        let by_formulation = stated.by_formulation.unwrap_or_default();
        EhlChoices::from_input(&stated.by_case.unwrap_or_default(), &by_formulation, self)
    }
}
