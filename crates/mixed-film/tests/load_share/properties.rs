//! Invariants of the load share on drawn windows, loads, speeds and temperatures.
//!
//! | what must hold | test |
//! |---|---|
//! | φ and β within 0 and 1, parts of load, friction and power add up, Ψ ≥ 1, residuals at exit | `shares_are_shares_and_parts_add_up` |
//! | g(φ) never rises | `the_gap_falls_as_the_asperities_take_load` |
//! | φ = 0 and μ = μ_f for z = 0, bitwise | `smooth_flanks_of_any_contact_have_the_film_friction_alone` |
//! | φ rises with height and temperature, falls with speed at a fixed thermal factor | `the_share_follows_height_temperature_and_speed` |
//! | bodies that change places rub alike | `bodies_may_change_places` |
//! | the flow pressure acts where pressures reach it, and only there | `the_flow_pressure_acts_where_it_is_reached` |
//! | h_b → 0 gives μ_a, h_b → ∞ gives μ_b, V_e → 0 tends to μ_b | `the_boundary_layer_has_both_its_limits` |
//! | units do not matter | `other_units_give_the_same_share` |
//!
//! Those of the film alone are in `film_friction` of asperity-tribo-friction, those of Ψ and supply in
//! `rough_inlet` of asperity-ehl-regime.

use asperity_contact::hertz_line::max_pressure;
use asperity_core::quantity::DynamicViscosity;
use asperity_mixed_film::TableRow;
use asperity_oil::TractionConstants;
use proptest::prelude::*;
use proptest::test_runner::Config;

use super::*;

/// A window of the ground traces with what it runs at.
#[derive(Debug, Clone, Copy)]
struct Drawn {
    contact: LineContact,
    /// Place of both windows, 0 to 1.
    place: [f64; 2],
    /// Factor on the heights.
    height: f64,
    temperature: f64,
}

impl Drawn {
    fn flanks(&self) -> Flanks {
        ground().scaled(self.height)
    }

    fn starts(&self) -> [usize; 2] {
        let n = points(&self.contact);
        [0, 1].map(|k: usize| (self.place[k] * (ground().heights[k].len() - n) as f64) as usize)
    }

    fn table(&self, flanks: &Flanks, flow: f64) -> ContactTable {
        table(&self.contact, flanks, self.starts(), flow)
    }

    fn share(
        &self,
        flanks: &Flanks,
        table: &ContactTable,
        settings: &LoadShareSettings,
    ) -> LoadShareSolution {
        share(
            &self.contact,
            flanks,
            table,
            self.starts(),
            self.temperature,
            settings,
        )
    }
}

prop_compose! {
    fn drawn()(
        load in 6e4..2.5e5_f64,
        radius in 3.5e-3..9e-3_f64,
        entrainment in 1.0..15.0_f64,
        slide_to_roll in 0.02..1.2_f64,
        place in [0.0..1.0_f64, 0.0..1.0_f64],
        height in 0.3..1.3_f64,
        temperature in 40.0..120.0_f64,
    ) -> Drawn {
        let speeds = [1.0, -1.0].map(|sign: f64| entrainment * (1.0 + 0.5 * sign * slide_to_roll));
        Drawn { contact: line_contact(load, radius, speeds), place, height, temperature }
    }
}

/// Without thermal reduction, where a monotone answer needs it.
fn isothermal_film() -> LoadShareSettings {
    LoadShareSettings {
        thermal: ThermalLaw::None,
        ..LoadShareSettings::default()
    }
}

proptest! {
    // A window costs some ten milliseconds.
    #![proptest_config(Config::with_cases(24))]

    #[test]
    fn shares_are_shares_and_parts_add_up(drawn in drawn()) {
        let flanks = drawn.flanks();
        let table = drawn.table(&flanks, FLOW);
        for row in table.rows() {
            // Both parts carry the load: the film 1 - phi by its pressure, the spots phi.
            let spots: f64 = row.spots.iter().map(|spot| spot.load.si()).sum();
            prop_assert!((spots / (row.asperity_share * drawn.contact.load.si()) - 1.0).abs() < 1e-9);
        }
        let found = drawn.share(&flanks, &table, &LoadShareSettings::default());
        prop_assert!((0.0..=1.0).contains(&found.asperity_share));
        prop_assert!((0.0..=1.0).contains(&found.boundary_of_asperities));
        prop_assert!(found.inlet_factor >= 1.0);
        prop_assert_eq!(found.boundary_share, found.asperity_share * found.boundary_of_asperities);
        prop_assert!((found.parts.total() / found.coefficient - 1.0).abs() < 1e-8);
        let [u1, u2] = drawn.contact.speeds.map(Speed::si);
        let power = found.coefficient * drawn.contact.load.si() * (u1 - u2).abs();
        prop_assert!((found.losses.total() / power - 1.0).abs() < 1e-8);
        prop_assert!(found.evidence.friction.residual.abs() < 1e-9);
        if found.asperity_share < 0.99 {
            prop_assert!(found.evidence.share.residual.abs() < 1e-9, "{:?}", found.evidence);
        }
    }

    #[test]
    fn the_gap_falls_as_the_asperities_take_load(drawn in drawn()) {
        let table = drawn.table(&drawn.flanks(), FLOW);
        let mut before = table.first_touch_gap();
        for k in 1..=100 {
            let gap = table.mean_gap(0.99 * (f64::from(k) / 100.0).powi(3)).unwrap();
            prop_assert!(gap <= before);
            before = gap;
        }
    }

    #[test]
    fn smooth_flanks_of_any_contact_have_the_film_friction_alone(drawn in drawn()) {
        let contact = &drawn.contact;
        let mut smooth = rough(contact, &vec![0.0; points(contact)], FLOW).unwrap();
        let table = ContactTable::build(&mut smooth).unwrap();
        let rheology = oil("e-fluid");
        let bulk = celsius(drawn.temperature);
        let mut film = PositionFilm::new(&rheology, contact, bulk, &LoadShareSettings::default()).unwrap();
        let even = WindowRoughness::even(Length::from_si(0.0));
        let found = film.share(&table, &even).unwrap().value;
        let alone = film_alone(&rheology, contact, bulk, film.sheared_film());
        prop_assert_eq!((found.asperity_share, found.inlet_factor), (0.0, 1.0));
        prop_assert_eq!(found.coefficient.to_bits(), alone.coefficient.to_bits());
    }

    #[test]
    fn the_share_follows_height_temperature_and_speed(drawn in drawn(), more in 1.1..1.6_f64) {
        let settings = isothermal_film();
        let flanks = drawn.flanks();
        let table = drawn.table(&flanks, FLOW);
        let phi = drawn.share(&flanks, &table, &settings).asperity_share;
        // What twelve rows leave of a share.
        let at_least = |other: f64| other > phi - TABLE_SHARE;
        let higher = Drawn { height: more * drawn.height, ..drawn };
        let rougher = higher.flanks();
        let on_rougher = higher.share(&rougher, &higher.table(&rougher, FLOW), &settings);
        prop_assert!(at_least(on_rougher.asperity_share));
        let hotter = Drawn { temperature: drawn.temperature + 20.0, ..drawn };
        prop_assert!(hotter.share(&flanks, &table, &settings).asperity_share >= phi);
        let slower = LineContact { speeds: drawn.contact.speeds.map(|u| u / more), ..drawn.contact };
        let slower = Drawn { contact: slower, ..drawn };
        prop_assert!(slower.share(&flanks, &table, &settings).asperity_share >= phi);
    }

    #[test]
    fn bodies_may_change_places(drawn in drawn()) {
        let flanks = drawn.flanks();
        let n = points(&drawn.contact);
        let mirrored = |z: &[f64]| z.iter().rev().copied().collect::<Vec<f64>>();
        let turned = Flanks::new([mirrored(&flanks.heights[1]), mirrored(&flanks.heights[0])]);
        let starts = [1, 0].map(|k: usize| flanks.heights[k].len() - n - drawn.starts()[k]);
        let [u1, u2] = drawn.contact.speeds;
        let swapped = LineContact { speeds: [u2, u1], ..drawn.contact };
        let settings = LoadShareSettings::default();
        let one = drawn.share(&flanks, &drawn.table(&flanks, FLOW), &settings);
        let other = table(&swapped, &turned, starts, FLOW);
        let other = share(&swapped, &turned, &other, starts, drawn.temperature, &settings);
        // The contact's certificate of 1e-8 leaves 1e-5 of a share; a spot may end a cell sooner.
        prop_assert!((other.asperity_share - one.asperity_share).abs() < 1e-4);
        prop_assert!((other.coefficient / one.coefficient - 1.0).abs() < 1e-3);
    }

    #[test]
    fn the_flow_pressure_acts_where_it_is_reached(drawn in drawn()) {
        let flanks = drawn.flanks();
        let settings = LoadShareSettings::default();
        let elastic = drawn.table(&flanks, 1e12);
        // Asperities carry at most the flow pressure less the largest pressure of the film, (1 − φ) p₀, wherever they stand.
        let contact = &drawn.contact;
        let hertz = max_pressure(contact.load, contact.radius, contact.modulus).unwrap().si();
        let needed = |row: &TableRow| row.max_pressure.si() + (1.0 - row.asperity_share) * hertz;
        let highest = elastic.rows().map(needed).fold(0.0, f64::max);
        let free = drawn.share(&flanks, &elastic, &settings);
        let above = drawn.share(&flanks, &drawn.table(&flanks, 1.01 * highest), &settings);
        prop_assert!((above.coefficient / free.coefficient - 1.0).abs() < 1e-7);
        let p0 = elastic.rows().next().unwrap().max_pressure.si().min(2e9);
        let soft = (0.4 * free.max_pressure.si()).max(1.6 * p0);
        if free.asperity_share > 0.05 && soft < 0.6 * free.max_pressure.si() {
            let yielding = drawn.share(&flanks, &drawn.table(&flanks, soft), &settings);
            prop_assert!(yielding.max_pressure.si() <= soft * (1.0 + 1e-12));
            prop_assert!((yielding.coefficient / free.coefficient - 1.0).abs() > 1e-4);
        }
    }

    #[test]
    fn the_boundary_layer_has_both_its_limits(drawn in drawn()) {
        let flanks = drawn.flanks();
        let table = drawn.table(&flanks, FLOW);
        let layer = |height: f64| LoadShareSettings {
            boundary_layer: Length::from_si(height),
            ..LoadShareSettings::default()
        };
        let [none, usual, all] = [0.0, 1e-8, 1.0].map(|h| drawn.share(&flanks, &table, &layer(h)));
        let phi = none.asperity_share;
        prop_assert_eq!((none.boundary_of_asperities, usual.asperity_share), (0.0, phi));
        let lubricated = (1.0 - phi) * none.film_coefficient + phi * none.asperity_coefficient;
        prop_assert!((none.coefficient / lubricated - 1.0).abs() < 1e-8);
        let boundary = (1.0 - phi) * all.film_coefficient + phi * BOUNDARY_FRICTION;
        prop_assert!((all.coefficient / boundary - 1.0).abs() < 1e-5);
        // At a crawl nothing but the boundary layer is left.
        let crawl = LineContact { speeds: drawn.contact.speeds.map(|u| u * 1e-6), ..drawn.contact };
        let crawl = Drawn { contact: crawl, height: 1.0, ..drawn };
        let slow = crawl.share(ground(), &crawl.table(ground(), FLOW), &isothermal_film());
        prop_assert!(slow.coefficient > 0.07 && slow.coefficient <= BOUNDARY_FRICTION + 1e-9, "{}", slow.coefficient);
    }

    #[test]
    fn other_units_give_the_same_share(
        drawn in drawn(), length in -1..2_i32, time in -1..2_i32,
    ) {
        let power = |of: i32| 2f64.powi(of);
        // The density of the gap has constants in pascals.
        let units = Units { length: power(length), time: power(time), mass: power(length + 2 * time) };
        for supply in [InletSupply::Starved, InletSupply::Rough] {
            let one = in_units(&drawn, supply, &Units { length: 1.0, time: 1.0, mass: 1.0 });
            let other = in_units(&drawn, supply, &units);
            // Round-off alone, which the certificate of the contact carries to 1e-6.
            prop_assert!((other.asperity_share - one.asperity_share).abs() < 1e-6);
            prop_assert!((other.coefficient / one.coefficient - 1.0).abs() < 1e-6);
        }
    }
}

/// Size of the units of length, time and mass.
struct Units {
    length: f64,
    time: f64,
    mass: f64,
}

/// The share with every number in other units, for an oil whose viscosity falls exponentially.
fn in_units(drawn: &Drawn, supply: InletSupply, units: &Units) -> LoadShareSolution {
    let Units { length, time, mass } = *units;
    let pressure = mass / (length * time * time);
    let conductivity = mass * length / time.powi(3);
    let density = mass / length.powi(3);
    let heat = (length / time).powi(2);
    let lubricant = LubricantInput {
        viscosity: Some(ViscosityLaw::Given {
            dynamic_viscosity: DynamicViscosity::from_si(0.01),
            temperature: Some(celsius(90.0)),
        }),
        temperature_coefficient: Some(PerKelvin::from_si(0.03)),
        density: Some(Density::from_si(850.0)),
        thermal_expansion: Some(PerKelvin::from_si(7e-4)),
        pressure_viscosity: Some(PressureViscosity::from_si(1e-8)),
        ..LubricantInput::default()
    };
    let mut lubricant = lubricant;
    if let Some(ViscosityLaw::Given {
        dynamic_viscosity, ..
    }) = &mut lubricant.viscosity
    {
        *dynamic_viscosity = *dynamic_viscosity * (pressure * time);
    }
    lubricant.density = Some(Density::from_si(850.0 * density));
    let lubricant = lubricant.resolve(celsius(90.0)).unwrap();
    let family = TractionConstants::from_family(BaseOil::Pao).unwrap();
    let constants = TractionConstants {
        ambient_limit: family.ambient_limit * pressure,
        eyring_stress: family.eyring_stress * pressure,
        conductivity: family.conductivity * conductivity,
        conductivity_rise: family.conductivity_rise / pressure,
        conductivity_bend: family.conductivity_bend / pressure,
        ..family
    };
    let alpha = PressureViscosity::from_si(1e-8 / pressure);
    let rheology = FilmRheology::with_alpha(&lubricant, constants, alpha, celsius(90.0)).unwrap();
    let steel = Material {
        young: STEEL.young * pressure,
        conductivity: STEEL.conductivity * conductivity,
        density: STEEL.density * density,
        heat_capacity: STEEL.heat_capacity * heat,
        ..STEEL
    };
    let of = &drawn.contact;
    let contact = LineContact {
        load: of.load * (pressure * length),
        radius: of.radius * length,
        modulus: of.modulus * pressure,
        speeds: of.speeds.map(|u| u * (length / time)),
        bodies: [steel, steel],
    };
    let settings = LoadShareSettings::default();
    let settings = LoadShareSettings {
        boundary_layer: settings.boundary_layer * length,
        supply,
        // The thinnest film of a spot whose shear rate is computed is a length that is no input: slow spots inside the contact reach it.
        spot_speed: SpotSpeed::Entrainment,
        ..settings
    };
    let (starts, n) = (drawn.starts(), points(of));
    let composite: Vec<f64> = drawn
        .flanks()
        .window(starts, n)
        .iter()
        .map(|z| z * length)
        .collect();
    let mut rough = RoughContact::new(&RoughWindow {
        composite: &composite,
        spacing: SPACING * length,
        load: contact.load,
        radius: contact.radius,
        modulus: contact.modulus,
        flow_pressure: Pressure::from_si(FLOW * pressure),
        settings: SolverSettings::default(),
    })
    .unwrap();
    let table = ContactTable::build(&mut rough).unwrap();
    let mut film =
        PositionFilm::new(&rheology, &contact, celsius(drawn.temperature), &settings).unwrap();
    let spectra = drawn.flanks().heights.map(|z| {
        let z: Vec<f64> = z.iter().map(|z| z * length).collect();
        TraceSpectrum::new(&z, SPACING * length).unwrap()
    });
    let attenuation = film.flattening(&PairSpectrum::from_traces(spectra.each_ref()));
    let traces = AttenuatedTraces::new(spectra.each_ref(), &attenuation.unwrap());
    let window = traces.window(starts, n).unwrap();
    film.share(&table, &window).unwrap().value
}
