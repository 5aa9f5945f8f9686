//! The load share against an independent program (`references/load_share.py` computes its windows again), and
//! what must hold whatever the numbers: single windows here, drawn ones in `properties`.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

mod gradient;
mod patch;
mod point_contact;
mod properties;

use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity_contact::{Boundary, PeriodicKernel, Solver, SolverSettings};
use asperity_core::Profile;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, KinematicViscosity, Length, LineLoad, PerKelvin, Pressure, PressureViscosity,
    SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_ehl_regime::light_load::LightLoad;
use asperity_ehl_regime::{
    Attenuation, FilmConditions, FilmLaw, GapLaw, MoesNumbers, PairSpectrum, Patch, PatchPair,
    PatchSpectrum, Ripples, ThermalLaw, TraceSpectrum,
};
use asperity_mixed_film::{
    AttenuatedTraces, ContactTable, Flattening, InletSupply, Kinks, LoadShareError,
    LoadShareSettings, LoadShareSolution, PatchSample, PositionFilm, RoughContact, RoughWindow,
    SmoothFilm, SpotSpeed, TABLE_SHARES, WindowRoughness,
};
use asperity_oil::{BaseOil, FilmRheology, LubricantInput, TractionConstants, ViscosityLaw};
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_tribo_friction::film_friction::LoadedFilm;
use asperity_tribo_friction::{FilmFrictionSolution, FilmLineContact, FilmSettings};
use serde_json::Value;

const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(1.5e9),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(45.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};
const SPACING: Length = Length::from_si(0.5e-6);
const FLOW: f64 = 7e9;

/// One decimal number; the superfinished traces have decimal commas.
fn number(text: &str) -> Option<f64> {
    text.trim().replace(',', ".").parse().ok()
}

/// Prepared heights \[m\] of a fixture: λs 2.5 um, λc 0.25 mm.
fn prepared(file: &str, mirrored: bool) -> Vec<f64> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../fixtures/profiles")
        .join(file);
    let text = std::fs::read_to_string(path).unwrap();
    let heights = text
        .lines()
        .filter_map(|line| {
            let (_, z) = line.split_once(';').or_else(|| line.split_once(','))?;
            number(z)
        })
        .map(|z| z * 1e-6)
        .collect();
    let profile = Profile::new(SPACING, heights).unwrap();
    let profile = if mirrored {
        profile.mirrored()
    } else {
        profile
    };
    let recipe = Preparation {
        lambda_c: Some(Length::from_si(0.25e-3)),
        ..Preparation::default()
    };
    prepare(&profile, &recipe)
        .unwrap()
        .profile
        .heights()
        .to_vec()
}

/// Prepared traces of pinion and wheel with their spectra.
struct Flanks {
    heights: [Vec<f64>; 2],
    spectra: [TraceSpectrum; 2],
}

impl Flanks {
    fn new(heights: [Vec<f64>; 2]) -> Self {
        let spectra = heights
            .each_ref()
            .map(|z| TraceSpectrum::new(z, SPACING).unwrap());
        Self { heights, spectra }
    }

    fn scaled(&self, factor: f64) -> Self {
        Self::new(
            self.heights
                .each_ref()
                .map(|z| z.iter().map(|z| factor * z).collect()),
        )
    }

    fn window(&self, starts: [usize; 2], points: usize) -> Vec<f64> {
        let [first, second] = &self.heights;
        (0..points)
            .map(|i| first[starts[0] + i] + second[starts[1] + i])
            .collect()
    }
}

fn ground() -> &'static Flanks {
    static GROUND: OnceLock<Flanks> = OnceLock::new();
    GROUND.get_or_init(|| {
        Flanks::new([
            prepared("ground_pinion.csv", false),
            prepared("ground_wheel.csv", true),
        ])
    })
}

fn superfinished() -> &'static Flanks {
    static SUPERFINISHED: OnceLock<Flanks> = OnceLock::new();
    SUPERFINISHED.get_or_init(|| {
        Flanks::new([
            prepared("superfinished.csv", false),
            prepared("superfinished_wheel.csv", true),
        ])
    })
}

/// An oil of the reference values, with the Eyring stress and the conductivity that they have.
fn oil(name: &str) -> FilmRheology {
    let (nu, density, family, eyring) = match name {
        "M100" => ([96.0, 10.6], 882.0, BaseOil::Mineral, 5e6),
        _ => ([30.8, 5.9], 845.0, BaseOil::Pao, 4e6),
    };
    let mut constants = TractionConstants {
        eyring_stress: Pressure::from_si(eyring),
        ..TractionConstants::from_family(family).unwrap()
    };
    if family == BaseOil::Mineral {
        constants.conductivity = ThermalConductivity::from_si(0.137);
        (constants.conductivity_rise, constants.conductivity_bend) = (1.72, 0.54);
    }
    let lubricant = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(nu[0] * 1e-6),
            at_100: KinematicViscosity::from_si(nu[1] * 1e-6),
        }),
        density: Some(Density::from_si(density)),
        thermal_expansion: Some(PerKelvin::from_si(0.63 / density)),
        pressure_viscosity: Some(PressureViscosity::from_si(1e-8)),
        ..LubricantInput::default()
    }
    .resolve(celsius(90.0))
    .unwrap();
    let rheology = FilmRheology::new(&lubricant, family).unwrap();
    rheology.with_constants(constants).unwrap()
}

fn celsius(value: f64) -> Temperature {
    Temperature::from_si(value + 273.15)
}

fn line_contact(load: f64, radius: f64, speeds: [f64; 2]) -> LineContact {
    LineContact {
        load: LineLoad::from_si(load),
        radius: Length::from_si(radius),
        modulus: Pressure::from_si(210e9 / 2.0 / 0.91),
        speeds: speeds.map(Speed::from_si),
        bodies: [STEEL, STEEL],
    }
}

/// First position of the ground e-drive pair.
fn e_drive() -> LineContact {
    line_contact(
        1.4379302065e5,
        3.6272968270e-3,
        [3.5865118774, 9.2742971144],
    )
}

/// Points of the window of three half widths to each side.
fn points(contact: &LineContact) -> usize {
    let product = 4.0 * contact.load.si() * contact.radius.si();
    let a = (product / (std::f64::consts::PI * contact.modulus.si())).sqrt();
    2 * (3.0 * a / SPACING.si()).ceil() as usize + 1
}

fn rough(
    contact: &LineContact,
    composite: &[f64],
    flow: f64,
) -> Result<RoughContact, LoadShareError> {
    RoughContact::new(&RoughWindow {
        composite,
        spacing: SPACING,
        load: contact.load,
        radius: contact.radius,
        modulus: contact.modulus,
        flow_pressure: Pressure::from_si(flow),
        settings: SolverSettings::default(),
    })
}

fn table(contact: &LineContact, flanks: &Flanks, starts: [usize; 2], flow: f64) -> ContactTable {
    let composite = flanks.window(starts, points(contact));
    ContactTable::build(&mut rough(contact, &composite, flow).unwrap()).unwrap()
}

/// The share of a window, from its table.
fn share(
    contact: &LineContact,
    flanks: &Flanks,
    table: &ContactTable,
    starts: [usize; 2],
    temperature: f64,
    settings: &LoadShareSettings,
) -> LoadShareSolution {
    share_of(
        contact,
        flanks,
        (table, starts),
        (temperature, settings),
        |of| of,
    )
}

/// The same with a changed flattening.
fn share_of(
    contact: &LineContact,
    flanks: &Flanks,
    (table, starts): (&ContactTable, [usize; 2]),
    (temperature, settings): (f64, &LoadShareSettings),
    changed: impl Fn(Flattening) -> Flattening,
) -> LoadShareSolution {
    let rheology = oil("e-fluid");
    let mut film = PositionFilm::new(&rheology, contact, celsius(temperature), settings).unwrap();
    let [first, second] = &flanks.spectra;
    let pair = PairSpectrum::from_traces([first, second]);
    let flattening = changed(film.flattening(&pair).unwrap());
    let traces = AttenuatedTraces::new([first, second], &flattening);
    let window = traces.window(starts, points(contact)).unwrap();
    film.share(table, &window).unwrap().value
}

/// All heights in the supply, and a film without ripple: what the independent program has.
fn of_all_heights(flattening: Flattening) -> Flattening {
    Flattening {
        peak_weight: 0.0,
        ..without_ripple(flattening)
    }
}

fn without_ripple(flattening: Flattening) -> Flattening {
    Flattening {
        ripple: None,
        ..flattening
    }
}

const STARTS: [usize; 2] = [3000, 1200];

/// Table of the ground pair's window at the first position.
fn ground_table() -> &'static ContactTable {
    static TABLE: OnceLock<ContactTable> = OnceLock::new();
    TABLE.get_or_init(|| table(&e_drive(), ground(), STARTS, FLOW))
}

/// Laws that the independent program has: the film of a formula, all spots with the film of the entrainment speed.
fn independent() -> LoadShareSettings {
    LoadShareSettings {
        film_law: FilmLaw::DowsonToyoda,
        supply: InletSupply::Grubin,
        spot_speed: SpotSpeed::Entrainment,
        ..LoadShareSettings::default()
    }
}

fn at(settings: &LoadShareSettings) -> LoadShareSolution {
    share(&e_drive(), ground(), ground_table(), STARTS, 90.0, settings)
}

/// Where the contact grows by a cell, the mean gap neither jumps nor turns: by whole cells, and by the Hertz pressure in the
/// middle of each, its second differences over these steps are 6e-4 of it.
#[test]
fn the_mean_gap_is_steady_over_the_load() {
    let flanks = ground();
    // As many points for all loads, over which the half-width grows by two cells.
    let composite = flanks.window([500, 2500], 1001);
    let gap = |k: u32| {
        let load = 143_793.0 * (1.0 + 4e-4 * f64::from(k));
        let contact = line_contact(load, 0.003_627, [3.59, 9.27]);
        let rough = rough(&contact, &composite, FLOW).unwrap();
        rough.first_touch_gap().si()
    };
    let gaps: Vec<f64> = (0..40).map(gap).collect();
    let bends = gaps
        .windows(3)
        .map(|of| (of[0] - 2.0 * of[1] + of[2]).abs() / of[1]);
    let most = bends.fold(0.0, f64::max);
    assert!(most < 3e-5, "{most:e}");
}

#[test]
fn load_share_of_the_reference_windows() {
    let golden: Value = serde_json::from_str(include_str!("../golden/load_share.json")).unwrap();
    let windows = golden["windows"].as_array().unwrap();
    assert_eq!(windows.len(), 18);
    for row in windows {
        let of = |key: &str| row[key].as_f64().unwrap();
        let starts = [0, 1].map(|k| row["starts"][k].as_u64().unwrap() as usize);
        let name = format!("{} {starts:?} w {}", row["profile"], row["w"]);
        let near = |what: &str, seen: f64, expected: f64, tolerance: f64| {
            assert!(
                (seen - expected).abs() <= tolerance,
                "{name} {what}: {seen:e} for {expected:e}"
            );
        };
        let flanks = if row["profile"] == "ground" {
            ground()
        } else {
            superfinished()
        };
        let contact = line_contact(of("w"), of("R"), [of("u1"), of("u2")]);
        let n = points(&contact);
        let rheology = oil(row["oil"].as_str().unwrap());
        let mut settings = LoadShareSettings {
            boundary_friction: of("mu_b"),
            lay: Lay::ACROSS,
            supply: InletSupply::Starved,
            ..independent()
        };
        settings.film.nodes = std::num::NonZeroUsize::new(32).unwrap();
        let mut film = PositionFilm::new(&rheology, &contact, celsius(90.0), &settings).unwrap();
        near(
            "smooth film",
            film.smooth_film() / Length::from_si(of("hc")),
            1.0,
            1e-8,
        );
        let [first, second] = &flanks.spectra;
        let pair = PairSpectrum::from_traces([first, second]);
        let flattening = of_all_heights(film.flattening(&pair).unwrap());
        let traces = AttenuatedTraces::new([first, second], &flattening);
        let window = &traces.window(starts, n).unwrap();
        let rms = window.deviation;
        near("attenuated rms", rms.si() / of("Sqd"), 1.0, 1e-8);
        let composite = flanks.window(starts, n);
        let mut rough = rough(&contact, &composite, FLOW).unwrap();
        let (solution, state) = film.share_by_direct_solves(&mut rough, window).unwrap();
        let solution = solution.value;
        near("inlet factor", solution.inlet_factor / of("psi"), 1.0, 1e-8);
        // The reference's own tolerances.
        near("share", solution.asperity_share, of("phi"), 1e-4);
        // Its film shears at the Hertz pressure of the whole load, and heats the surfaces by this friction.
        let line = FilmLineContact {
            line: contact,
            film: film.smooth_film(),
            temperature: celsius(90.0),
        };
        let mut at_hertz = LoadedFilm::new(&rheology, &line, settings.film).unwrap();
        let rise = at_hertz.surface_rise(of("mu"));
        let [sheared, _] = at_hertz.friction_at(rise).unwrap();
        near("film friction", sheared, of("mu_f"), 2e-6);
        let spots = state.as_ref().map_or(&[][..], |state| &state.spots);
        let hot = LoadShareSolution {
            surface_rise: rise,
            ..solution
        };
        // Friction of the spots with and without that of the boundary layer.
        let [wet, rubbing] = [0.0, of("mu_b")].map(|boundary_friction| {
            let settings = LoadShareSettings {
                boundary_friction,
                ..settings
            };
            let film = PositionFilm::new(&rheology, &contact, celsius(90.0), &settings).unwrap();
            let losses = film.losses_of_spots(spots, &hot).unwrap();
            let force = contact.load.si() * (of("u2") - of("u1")).abs();
            losses.iter().sum::<f64>() / force
        });
        let phi = solution.asperity_share;
        near("friction", (1.0 - phi) * sheared + rubbing, of("mu"), 2e-5);
        if phi > 0.0 {
            let boundary = (rubbing - wet) / (phi * of("mu_b"));
            near("boundary", boundary, of("beta"), 2e-3);
            near(
                "asperity friction",
                wet / (phi * (1.0 - boundary)),
                of("mu_a"),
                1e-4,
            );
        }
        near("area", solution.area, of("area"), 2e-3);
        assert_eq!(state.is_some(), of("phi") > 0.0, "{name}");
        if let Some(state) = state {
            // The parts of the load: asperities phi w, the film the rest.
            let carried: f64 = state.spots.iter().map(|spot| spot.load.si()).sum();
            near(
                "load",
                carried / (solution.asperity_share * of("w")),
                1.0,
                1e-9,
            );
            assert!(solution.evidence.share.residual.abs() < 1e-5, "{name}");
            let supplied = rms.si() / of("hc");
            let gap = of("hc")
                * (1.0 + 2.342 * supplied * supplied).sqrt()
                * (1.0 - solution.asperity_share).powf(-0.16);
            near("gap", solution.mean_gap.si() / gap, 1.0, 1e-6);
        }
        // The table instead of direct solves.
        let table = ContactTable::build(&mut rough).unwrap();
        let quick = film.share(&table, window).unwrap().value;
        near(
            "share by table",
            quick.asperity_share,
            solution.asperity_share,
            TABLE_SHARE,
        );
        near(
            "friction by table",
            quick.coefficient / solution.coefficient,
            1.0,
            TABLE_FRICTION,
        );
    }
}

/// Error that twelve rows leave in the share and of the coefficient of one window: 0.0053 and 0.6 % at most in these
/// windows; over the path of the e-drive pair it averages out to 4e-5 of the loss.
const TABLE_SHARE: f64 = 0.01;
const TABLE_FRICTION: f64 = 0.01;

/// Friction of a film at light load.
fn film_alone(
    rheology: &FilmRheology,
    contact: &LineContact,
    temperature: Temperature,
    film: Length,
) -> FilmFrictionSolution {
    let state = rheology.state(temperature).unwrap();
    let conditions = FilmConditions {
        entrainment: (contact.speeds[0] + contact.speeds[1]) * 0.5,
        radius: contact.radius,
        load: contact.load,
        modulus: contact.modulus,
        viscosity: state.viscosity,
        pressure_viscosity: state.pressure_viscosity,
        contact_length: None,
    };
    let numbers = MoesNumbers::from_groups(&conditions.line_groups().unwrap()).unwrap();
    let line = FilmLineContact {
        line: *contact,
        film,
        temperature,
    };
    let mut alone = LoadedFilm::new(rheology, &line, FilmSettings::default()).unwrap();
    let LightLoad { excess, inlet } = LightLoad::new(&numbers);
    alone.reach_beyond(&excess, inlet).unwrap();
    alone.solve().unwrap().value
}

#[test]
fn smooth_flanks_have_the_film_friction_alone() {
    let contact = e_drive();
    let n = points(&contact);
    let mut smooth = rough(&contact, &vec![0.0; n], FLOW).unwrap();
    let table = ContactTable::build(&mut smooth).unwrap();
    let rheology = oil("e-fluid");
    let settings = LoadShareSettings::default();
    let mut film = PositionFilm::new(&rheology, &contact, celsius(90.0), &settings).unwrap();
    let even = WindowRoughness::even(Length::from_si(0.0));
    let by_table = film.share(&table, &even).unwrap().value;
    let (direct, state) = film.share_by_direct_solves(&mut smooth, &even).unwrap();
    let alone = film_alone(&rheology, &contact, celsius(90.0), film.sheared_film());
    assert!(state.is_none());
    for solution in [by_table, direct.value] {
        assert_eq!(solution.asperity_share, 0.0);
        assert_eq!(solution.inlet_factor, 1.0);
        assert_eq!(solution.coefficient.to_bits(), alone.coefficient.to_bits());
        assert_eq!(solution.boundary_share, 0.0);
    }
}

#[test]
fn the_gap_never_rises_with_the_share() {
    for (flanks, starts) in [
        (ground(), STARTS),
        (ground(), [500, 2500]),
        (superfinished(), [900, 100]),
    ] {
        let table = table(&e_drive(), flanks, starts, FLOW);
        let mut before = table.first_touch_gap();
        for k in 1..=400 {
            let gap = table
                .mean_gap(0.99 * (f64::from(k) / 400.0).powi(3))
                .unwrap();
            assert!(gap <= before, "{k}");
            before = gap;
        }
        let last = table.rows().last().unwrap();
        let end = table.mean_gap(last.asperity_share).unwrap() / last.mean_gap;
        assert!((end - 1.0).abs() < 1e-12, "{end}");
    }
}

#[test]
fn a_row_is_the_same_whichever_others_are_solved() {
    let (contact, rheology) = (e_drive(), oil("e-fluid"));
    let settings = LoadShareSettings::default();
    let composite = ground().window(STARTS, points(&contact));
    let window = || rough(&contact, &composite, FLOW);
    let whole = ground_table();
    let shares =
        |table: &ContactTable| -> Vec<f64> { table.rows().map(|row| row.asperity_share).collect() };
    assert_eq!(shares(whole), TABLE_SHARES);
    // Cold oil first, then hot, and the other way round; each time with a new window.
    for temperatures in [[40.0, 150.0], [150.0, 40.0]] {
        let table = ContactTable::new(&window().unwrap());
        let mut before = 0;
        for temperature in temperatures {
            let bulk = celsius(temperature);
            let film = || PositionFilm::new(&rheology, &contact, bulk, &settings).unwrap();
            let rms = &WindowRoughness::even(Length::from_si(0.2e-6));
            let (mut of_whole, mut film) = (film(), film());
            let needed = film.share(&table, rms).unwrap_err();
            let start = "the rough contact at asperity share ";
            assert!(needed.to_string().starts_with(start), "{needed}");
            film.solve_rows(&table, rms, window).unwrap();
            let known = table.rows().count();
            assert!(known > before && known < TABLE_SHARES.len(), "{known}");
            before = known;
            let share = film.share(&table, rms).unwrap().value;
            assert_eq!(share, of_whole.share(whole, rms).unwrap().value);
            // A known row asks for no window.
            let none = || -> Result<RoughContact, LoadShareError> { panic!("no row is missing") };
            film.solve_rows(&table, rms, none).unwrap();
        }
        for row in table.rows() {
            assert!(whole.rows().any(|other| other == row));
        }
    }
}

#[test]
fn the_share_rises_with_height_and_temperature_and_falls_with_speed() {
    let settings = LoadShareSettings {
        thermal: ThermalLaw::None,
        ..LoadShareSettings::default()
    };
    let contact = e_drive();
    let mut before = -1.0;
    for factor in [0.3, 0.6, 1.0, 1.5] {
        let flanks = ground().scaled(factor);
        let table = table(&contact, &flanks, STARTS, FLOW);
        let phi = share(&contact, &flanks, &table, STARTS, 90.0, &settings).asperity_share;
        assert!(phi > before, "{factor}");
        before = phi;
    }
    let by_temperature = |t| share(&contact, ground(), ground_table(), STARTS, t, &settings);
    let phi = [40.0, 60.0, 90.0, 120.0].map(|t| by_temperature(t).asperity_share);
    assert!(phi.is_sorted() && phi[0] < phi[3], "{phi:?}");
    let by_speed = |factor: f64| {
        let faster = LineContact {
            speeds: contact.speeds.map(|u| u * factor),
            ..contact
        };
        share(&faster, ground(), ground_table(), STARTS, 90.0, &settings)
    };
    let slow = [0.01, 0.1, 0.5, 1.0, 3.0].map(by_speed);
    assert!(
        slow.windows(2)
            .all(|pair| pair[1].asperity_share <= pair[0].asperity_share)
    );
    // Without film everything rubs on the boundary layer.
    let crawling = by_speed(1e-4);
    assert!(
        crawling.coefficient > 0.07 && crawling.coefficient <= BOUNDARY_FRICTION + 1e-12,
        "{crawling:?}"
    );
}

#[test]
fn bodies_that_change_places_have_the_same_friction() {
    let contact = e_drive();
    let n = points(&contact);
    let mirrored = |z: &[f64]| z.iter().rev().copied().collect::<Vec<f64>>();
    let flanks = Flanks::new([
        mirrored(&ground().heights[1]),
        mirrored(&ground().heights[0]),
    ]);
    let starts = [1, 0].map(|k: usize| ground().heights[k].len() - n - STARTS[k]);
    let [u1, u2] = contact.speeds;
    let swapped = LineContact {
        speeds: [u2, u1],
        ..contact
    };
    let table = table(&contact, &flanks, starts, FLOW);
    let settings = LoadShareSettings::default();
    let one = at(&settings);
    let other = share(&swapped, &flanks, &table, starts, 90.0, &settings);
    // The contact solver's tolerance is 1e-8; spots at the edge of a cell may differ by one cell.
    assert!((other.asperity_share - one.asperity_share).abs() < 1e-5);
    assert!((other.coefficient / one.coefficient - 1.0).abs() < 1e-4);
}

#[test]
fn flow_pressure_matters_and_is_refused_where_the_film_alone_reaches_it() {
    let contact = e_drive();
    let settings = LoadShareSettings::default();
    let with = |flow| {
        let table = table(&contact, ground(), STARTS, flow);
        share(&contact, ground(), &table, STARTS, 90.0, &settings)
    };
    let (soft, hard) = (with(2.5e9), with(20e9));
    assert!(
        (soft.coefficient / hard.coefficient - 1.0).abs() > 0.02,
        "{soft:?} {hard:?}"
    );
    assert!(soft.max_pressure.si() <= 2.5e9 * (1.0 + 1e-12));
    let composite = ground().window(STARTS, points(&contact));
    let refused = rough(&contact, &composite, 1.4 * 1.2066e9).err();
    assert!(matches!(
        refused,
        Some(LoadShareError::FlowPressureTooLow { .. })
    ));
}

#[test]
fn the_boundary_layer_runs_from_lubricated_to_boundary_friction() {
    let with = |nm: f64| {
        at(&LoadShareSettings {
            boundary_layer: Length::from_si(nm * 1e-9),
            ..LoadShareSettings::default()
        })
    };
    let (none, usual, all) = (with(0.0), with(10.0), with(1e9));
    let phi = none.asperity_share;
    let expected = (1.0 - phi) * none.film_coefficient + phi * none.asperity_coefficient;
    assert_eq!(none.boundary_of_asperities, 0.0);
    assert!((none.coefficient - expected).abs() < 1e-12);
    let expected = (1.0 - phi) * all.film_coefficient + phi * BOUNDARY_FRICTION;
    assert!((all.coefficient / expected - 1.0).abs() < 1e-5);
    assert!(none.coefficient < usual.coefficient && usual.coefficient < all.coefficient);
    assert!(usual.boundary_of_asperities > 0.0 && usual.boundary_of_asperities < 1.0);
}

#[test]
fn friction_solves_its_equation_where_heat_raises_it() {
    // A window with much contact: warmer spots have thinner films, so that friction exceeds its cold value.
    // Share by an independent program, 0.76373 (`references/load_share.py`).
    let starts = [2867, 3377];
    let table = table(&e_drive(), ground(), starts, FLOW);
    let settings = LoadShareSettings {
        boundary_friction: 0.08,
        lay: Lay::ACROSS,
        supply: InletSupply::Starved,
        ..independent()
    };
    let of_table = (&table, starts);
    let hot = share_of(
        &e_drive(),
        ground(),
        of_table,
        (90.0, &settings),
        of_all_heights,
    );
    assert!((hot.asperity_share - 0.76373).abs() < 0.002, "{hot:?}");
    assert!((hot.parts.total() / hot.coefficient - 1.0).abs() < 1e-10);
}

#[test]
fn friction_does_not_depend_on_the_windows_before() {
    let (contact, rheology) = (e_drive(), oil("e-fluid"));
    let settings = LoadShareSettings::default();
    let [first, second] = &ground().spectra;
    let pair = PairSpectrum::from_traces([first, second]);
    let fresh = || PositionFilm::new(&rheology, &contact, celsius(90.0), &settings).unwrap();
    let (mut film, mut largest) = (fresh(), 0.0_f64);
    let traces = AttenuatedTraces::new([first, second], &film.flattening(&pair).unwrap());
    for starts in [STARTS, [2867, 3377], [900, 2100], [1500, 300]] {
        let table = table(&contact, ground(), starts, FLOW);
        let window = traces.window(starts, points(&contact)).unwrap();
        let coefficient = |film: &mut PositionFilm<'_>| {
            let found = film.share(&table, &window).unwrap().value;
            found.coefficient
        };
        let off = coefficient(&mut film) / coefficient(&mut fresh()) - 1.0;
        largest = largest.max(off.abs());
    }
    println!("{largest:.1e}");
    assert!(largest < 1e-7, "{largest:.1e}");
}

#[test]
fn patches_are_fed_by_their_computed_flow_and_lines_as_before() {
    let (contact, rheology) = (e_drive(), oil("e-fluid"));
    let settings = LoadShareSettings::default();
    let fresh = |settings| PositionFilm::new(&rheology, &contact, celsius(90.0), settings).unwrap();
    let [first, second] = &ground().spectra;
    let lines = PairSpectrum::from_traces([first, second]);
    let of_lines = fresh(&settings).flattening(&lines).unwrap();
    // Patches that are constant along the lead.
    let untouched = Attenuation::new(GapLaw::Inlet, 0.0).unwrap();
    let spectra = [first, second].map(|trace| {
        let row = trace.attenuated(&untouched);
        let (size, heights) = ([row.len(), 2], row.repeat(2));
        PatchSpectrum::new(&Patch::new(heights, size, [SPACING; 2]).unwrap())
    });
    let patches = PatchPair::new(spectra.clone(), 1).unwrap();
    let same =
        patches.waves().roughness(&of_lines.attenuation) / lines.roughness(&of_lines.attenuation);
    assert!((same - 1.0).abs() < 1e-9);

    let mut film = fresh(&settings);
    let flattening = film.patch_flattening(&patches).unwrap();
    assert_eq!(flattening.peak_weight, 0.0);
    assert_eq!(flattening.ripple, of_lines.ripple);
    let traces = AttenuatedTraces::new([first, second], &flattening);
    let window = traces.window(STARTS, points(&contact)).unwrap();
    let found = film.share(ground_table(), &window).unwrap().value;
    let flow = patches.flow(&flattening.attenuation).unwrap();
    let factor = flow
        .inlet_factor(window.deviation, film.roughness_film())
        .unwrap();
    assert_eq!(found.inlet_factor, factor);
    // The highest ridge of the whole length closes the gap that the second order keeps open.
    let by_lines = of_window(&mut fresh(&settings), &lines);
    assert!(found.inlet_factor > 1.05 * by_lines.inlet_factor);
    assert!(found.asperity_share < by_lines.asperity_share);
    // The film of lines that had patches before is the one of lines.
    let again = of_window(&mut film, &lines);
    assert_eq!(again.inlet_factor, by_lines.inlet_factor);
    assert_eq!(again.asperity_share, by_lines.asperity_share);

    // A window of a patch is the window of its trace.
    let attenuation = &flattening.attenuation;
    let both = |of: [Vec<f64>; 2]| -> Vec<f64> {
        let cut = |k: usize| of[k][STARTS[k]..][..points(&contact)].iter();
        let sums = cut(0).zip(cut(1)).map(|(a, b)| a + b);
        sums.collect::<Vec<f64>>().repeat(2)
    };
    let left = both(
        spectra
            .each_ref()
            .map(|of| of.attenuated(attenuation).heights().to_vec()),
    );
    let [one, other] = spectra
        .each_ref()
        .map(|of| of.ripple(attenuation, contact.modulus));
    let ripples = Ripples {
        pressures: both([one.pressures, other.pressures]),
        heights: both([one.heights, other.heights]),
    };
    let ripples = ripples.each(Vec::as_slice);
    let columns = points(&contact);
    let reach = flattening.reach / SPACING;
    let piece = PatchSample::new(&left, columns, Some(ripples), reach).unwrap();
    let of_piece = PatchSample::between(&[(Arc::new(piece), 1.0)]);
    assert!((of_piece.deviation / window.deviation - 1.0).abs() < 1e-9);
    assert!((of_piece.middle / window.middle - 1.0).abs() < 1e-9);
    assert_eq!(of_piece.ripple.len(), window.ripple.len());
    for (pressures, heights) in [(&[0.0][..], ripples.heights), (ripples.pressures, &[0.0])] {
        let ripples = Ripples { pressures, heights };
        assert!(PatchSample::new(&left, columns, Some(ripples), reach).is_err());
    }
    assert!(PatchSample::new(&left, columns - 1, None, reach).is_err());

    let starved = LoadShareSettings {
        supply: InletSupply::Starved,
        ..settings
    };
    let refused = fresh(&starved).patch_flattening(&patches).unwrap_err();
    assert!(refused.to_string().contains("gap law"), "{refused}");
}

/// The share of the ground pair's window after the flattening of lines.
fn of_window(film: &mut PositionFilm<'_>, lines: &PairSpectrum) -> LoadShareSolution {
    let flattening = film.flattening(lines).unwrap();
    let spectra = &ground().spectra;
    let traces = AttenuatedTraces::new(spectra.each_ref(), &flattening);
    let window = traces.window(STARTS, points(&e_drive())).unwrap();
    film.share(ground_table(), &window).unwrap().value
}

#[test]
fn parts_of_friction_and_loss_add_up() {
    let solution = at(&LoadShareSettings::default());
    let total = solution.parts.total();
    assert!((total / solution.coefficient - 1.0).abs() < 1e-11);
    let contact = e_drive();
    let loss =
        solution.coefficient * contact.load.si() * (contact.speeds[1] - contact.speeds[0]).si();
    assert!((solution.losses.total() / loss - 1.0).abs() < 1e-11);
    let product = solution.asperity_share * solution.boundary_of_asperities;
    assert_eq!(solution.boundary_share, product);
    assert!(
        solution.evidence.friction.iterations <= 8,
        "{:?}",
        solution.evidence
    );
}

#[test]
fn without_sliding_only_the_boundary_layer_rubs_and_no_power_is_lost() {
    let contact = LineContact {
        speeds: [Speed::from_si(6.0); 2],
        ..e_drive()
    };
    let solution = share(
        &contact,
        ground(),
        ground_table(),
        STARTS,
        90.0,
        &LoadShareSettings::default(),
    );
    assert!((solution.coefficient - BOUNDARY_FRICTION * solution.boundary_share).abs() < 1e-15);
    assert_eq!((solution.losses.total(), solution.surface_rise), (0.0, 0.0));
}

#[test]
fn structural_choices_move_the_friction_the_way_they_say() {
    let base = LoadShareSettings::default();
    let usual = at(&base);
    let half = at(&LoadShareSettings {
        share_factor: 0.5,
        ..base
    });
    assert_eq!(half.asperity_share, 0.5 * usual.asperity_share);
    let fed = |spot_speed| at(&LoadShareSettings { spot_speed, ..base });
    let [entrainment, half_sliding] = [SpotSpeed::Entrainment, SpotSpeed::HalfSliding].map(fed);
    for [thin, thick] in [[&half_sliding, &entrainment], [&usual, &half_sliding]] {
        assert!(thin.coefficient > thick.coefficient && thin.spot_film < thick.spot_film);
    }
    let poon = at(&LoadShareSettings {
        supply: InletSupply::Smooth,
        ..base
    });
    assert!(poon.asperity_share > usual.asperity_share && poon.inlet_factor == 1.0);
    let isotropic = at(&LoadShareSettings {
        lay: Lay::ISOTROPIC,
        ..base
    });
    assert!(isotropic.asperity_share > usual.asperity_share);
    let rheology = oil("e-fluid");
    let refused = PositionFilm::new(
        &rheology,
        &e_drive(),
        celsius(90.0),
        &LoadShareSettings {
            share_factor: 0.0,
            ..base
        },
    );
    assert!(refused.is_err());
}

#[test]
fn spots_keep_the_film_of_the_inlet_without_sliding() {
    let contact = line_contact(1.4379302065e5, 3.6272968270e-3, [6.4, 6.4]);
    let by = |spot_speed| {
        let settings = LoadShareSettings {
            spot_speed,
            ..independent()
        };
        share(&contact, ground(), ground_table(), STARTS, 90.0, &settings)
    };
    assert_eq!(by(SpotSpeed::Carried), by(SpotSpeed::Entrainment));
}

#[test]
fn the_share_of_carried_spots_on_the_boundary_layer_is_between_its_ends() {
    let with = |settings: LoadShareSettings| at(&settings).boundary_of_asperities;
    let inner = |inner_boundary| {
        with(LoadShareSettings {
            spot_speed: SpotSpeed::Carried,
            inner_boundary,
            ..independent()
        })
    };
    let fed = |spot_speed| {
        with(LoadShareSettings {
            spot_speed,
            ..independent()
        })
    };
    let (carried, flowing) = (fed(SpotSpeed::Entrainment), fed(SpotSpeed::HalfSliding));
    // Without a least share, spots that form inside have the film of half the sliding speed.
    let shares = [
        carried,
        inner(0.0),
        inner(0.6),
        inner(0.75),
        inner(0.9),
        inner(1.0),
    ];
    assert!(shares.is_sorted() && shares[0] < shares[1], "{shares:?}");
    assert!(inner(0.0) < flowing && inner(1.0) < 1.0);
    // β = k β(u_m) + (1 − k) β_i is a line in β_i where β_i is above the share of the film that flows.
    let line = (inner(0.9) - inner(0.75)) / (inner(1.0) - inner(0.9));
    assert!((line - 1.5).abs() < 0.02, "{line}");
    // Without a boundary layer nothing rubs on it.
    let none = LoadShareSettings {
        spot_speed: SpotSpeed::Carried,
        boundary_layer: Length::from_si(0.0),
        ..independent()
    };
    assert_eq!(with(none), 0.0);
    let refused = LoadShareSettings {
        inner_boundary: 1.1,
        ..independent()
    };
    let rheology = oil("e-fluid");
    assert!(PositionFilm::new(&rheology, &e_drive(), celsius(90.0), &refused).is_err());
}

#[test]
fn the_film_shears_less_at_its_own_pressure() {
    let (contact, starts) = (e_drive(), [100, 100]);
    let by = |temperature: f64, flanks: &Flanks| {
        let table = table(&contact, flanks, starts, FLOW);
        let at = |changed: fn(Flattening) -> Flattening| {
            let settings = (temperature, &independent());
            share_of(&contact, flanks, (&table, starts), settings, changed)
        };
        [at(|of| of), at(without_ripple)]
    };
    let rheology = oil("e-fluid");
    let alone = |temperature: f64| {
        let temperature = celsius(temperature);
        let film = PositionFilm::new(&rheology, &contact, temperature, &independent()).unwrap();
        film_alone(&rheology, &contact, temperature, film.sheared_film()).coefficient
    };
    // Without asperities its own pressure is that of the whole load.
    let [rippled, own] = by(40.0, &superfinished().scaled(0.05));
    assert_eq!((own.asperity_share, own.mean_gap), (0.0, rippled.mean_gap));
    assert_eq!(own.coefficient.to_bits(), alone(40.0).to_bits());
    let ripple = rippled.coefficient / own.coefficient - 1.0;
    assert!(ripple.abs() > 1e-6 && ripple.abs() < 0.01, "{ripple}");
    // Where asperities carry load, the film shears less at its own pressure, and more where it ripples.
    let [rippled, own] = by(120.0, ground());
    assert!(own.asperity_share > 0.1 && own.asperity_share == rippled.asperity_share);
    assert!(own.film_coefficient < 0.95 * alone(120.0));
    assert!(rippled.film_coefficient != own.film_coefficient);
}

#[test]
fn a_film_ripples_at_none_of_smooth_flanks() {
    let contact = e_drive();
    let n = points(&contact);
    let smooth = Flanks::new([vec![0.0; n], vec![0.0; n]]);
    let table = table(&contact, &smooth, [0, 0], FLOW);
    let by = |changed: fn(Flattening) -> Flattening| {
        let of_table = (&table, [0, 0]);
        share_of(&contact, &smooth, of_table, (90.0, &independent()), changed)
    };
    assert_eq!(by(|of| of), by(without_ripple));
}

#[test]
fn film_and_displacement_of_a_wave_add_in_squares() {
    let n = 480;
    let attenuation = Attenuation::new(GapLaw::Inlet, 2e5).unwrap();
    let modulus = Pressure::from_si(115e9);
    for points in [20.0, 60.0, 120.0, 240.0] {
        let wave = |i: usize| 0.2e-6 * (std::f64::consts::TAU * i as f64 / points).sin();
        let heights: Vec<f64> = (0..n).map(wave).collect();
        let spectrum = TraceSpectrum::new(&heights, SPACING).unwrap();
        let ripples = TraceSpectrum::ripple_pair([&spectrum; 2], &attenuation, modulus);
        let ([pressure, _], [film, _]) = (ripples.pressures, ripples.heights);
        let mut displacement = vec![0.0; n];
        let boundary = Boundary::Periodic(PeriodicKernel::Spectral);
        let mut solver = Solver::new(n, boundary).unwrap();
        solver
            .displacement(SPACING, None, modulus, &pressure, &mut displacement)
            .unwrap();
        // A quarter of a wave apart, film and displacement add in squares to the wave.
        for ((z, film), displacement) in heights.iter().zip(film).zip(displacement) {
            let both = film.hypot(displacement);
            assert!((both - z.abs()).abs() < 1e-15, "{points}: {both} {z}");
        }
    }
}

#[test]
fn heights_above_the_mean_line_count_up_to_a_third_of_lay() {
    let rms = |changed: fn(Flattening) -> Flattening, gamma: f64| {
        let settings = LoadShareSettings {
            lay: Lay::new(gamma).unwrap(),
            ..independent()
        };
        let of_table = (ground_table(), STARTS);
        share_of(&e_drive(), ground(), of_table, (90.0, &settings), changed).attenuated_rms
    };
    let peaks: fn(Flattening) -> Flattening = |of| of;
    let all: fn(Flattening) -> Flattening = of_all_heights;
    assert_eq!(rms(peaks, 1.0), rms(all, 1.0));
    let full = rms(peaks, 1.0 / 3.0);
    assert!((full / rms(all, 1.0 / 3.0) - 1.0).abs() > 1e-3);
    // Linear in t between t = 0.625 and 0.25: half-way t = 0.4375, γ = 3/(2 t + 1) − 1.
    let halfway = 3.0 / 1.875 - 1.0;
    let squares = |length: Length| length.si() * length.si();
    let mean = 0.5 * (squares(rms(peaks, 1.0 / 3.0)) + squares(rms(all, 1.0 / 3.0)));
    // The flattening itself follows the lay a little.
    assert!((squares(rms(peaks, halfway)) / mean - 1.0).abs() < 0.05);
}

#[test]
fn windows_beyond_their_trace_or_narrower_than_the_contact_are_refused() {
    let [first, second] = &ground().spectra;
    let attenuation = Attenuation::new(GapLaw::Power, 1e5).unwrap().into();
    let traces = AttenuatedTraces::new([first, second], &attenuation);
    assert!(traces.window([5400, 0], 200).is_err());
    assert!(traces.window([0, 0], 0).is_err());
    assert!(rough(&e_drive(), &[0.0; 100], FLOW).is_err());
    assert!(rough(&e_drive(), &vec![f64::NAN; 1001], FLOW).is_err());
}
