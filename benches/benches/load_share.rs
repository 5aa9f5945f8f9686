//! Cost of a load share: the contact table of a window, then film and share at one temperature.
use std::hint::black_box;

use asperity_contact::SolverSettings;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, Length, LineLoad, Pressure, SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use asperity_ehl_regime::{PairSpectrum, TraceSpectrum};
use asperity_mixed_film::{
    AttenuatedTraces, ContactTable, LoadShareSettings, PositionFilm, RoughContact, RoughWindow,
};
use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
use asperity_roughness::generate::Ground;
use criterion::{Criterion, criterion_group, criterion_main};

/// Points of a trace and of the window, half a micrometre apart.
const TRACE: usize = 5501;
const WINDOW: usize = 913;

fn benches(criterion: &mut Criterion) {
    let spacing = Length::from_si(0.5e-6);
    let trace = |seed| {
        let recipe = Ground {
            points: TRACE,
            spacing,
            rq: Length::from_si(0.3e-6),
            grit_spacing: Length::from_si(12e-6),
            grit_radius: Length::from_si(60e-6),
            grit_protrusion: Length::from_si(1e-6),
            seed,
        };
        recipe.generate().expect("a ground trace")
    };
    let traces = [trace(1), trace(2)];
    let spectra = [0, 1]
        .map(|k: usize| TraceSpectrum::new(traces[k].heights(), spacing).expect("finite heights"));
    let starts = [1000, 3000];
    let composite: Vec<f64> = (0..WINDOW)
        .map(|i| traces[0].heights()[starts[0] + i] + traces[1].heights()[starts[1] + i])
        .collect();
    let steel = Material {
        young: Pressure::from_si(210e9),
        poisson: 0.3,
        elastic_limit: Pressure::from_si(1.5e9),
        density: Density::from_si(7830.0),
        conductivity: ThermalConductivity::from_si(45.0),
        heat_capacity: SpecificHeat::from_si(465.0),
    };
    let contact = LineContact {
        load: LineLoad::from_si(144e3),
        radius: Length::from_si(3.63e-3),
        modulus: Pressure::from_si(115.385e9),
        speeds: [Speed::from_si(3.59), Speed::from_si(9.27)],
        bodies: [steel, steel],
    };
    let window = RoughWindow {
        composite: &composite,
        spacing,
        load: contact.load,
        radius: contact.radius,
        modulus: contact.modulus,
        flow_pressure: Pressure::from_si(7e9),
        settings: SolverSettings::default(),
    };
    let build = || {
        let mut rough = RoughContact::new(&window).expect("a window");
        ContactTable::build(&mut rough).expect("a solved contact")
    };
    criterion.bench_function("contact table of a window", |bencher| bencher.iter(build));

    let oil = LubricantInput {
        oil: Some("m100".to_owned()),
        base_oil: Some(BaseOil::Mineral),
        ..LubricantInput::default()
    }
    .resolve(Temperature::from_si(363.15))
    .expect("an oil of the library");
    let rheology = FilmRheology::new(&oil, BaseOil::Mineral).expect("its rheology");
    let settings = LoadShareSettings::default();
    let bulk = Temperature::from_si(363.15);
    let film = || PositionFilm::new(&rheology, &contact, black_box(bulk), &settings);
    let pair = PairSpectrum::from_traces(spectra.each_ref());
    let attenuate = || {
        let flattening = film().expect("a film").flattening(&pair);
        AttenuatedTraces::new(spectra.each_ref(), &flattening.expect("an inlet"))
    };
    criterion.bench_function("film and attenuation of a position", |bencher| {
        bencher.iter(attenuate);
    });
    let table = build();
    let attenuated = attenuate();
    let mut position = film().expect("a film");
    criterion.bench_function("load share of a window by its table", |bencher| {
        bencher.iter(|| {
            let roughness = attenuated.window(starts, WINDOW).expect("a window");
            position.share(&table, &roughness)
        });
    });
}

criterion_group!(load_share, benches);
criterion_main!(load_share);
