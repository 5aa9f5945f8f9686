//! Cost of one film friction: isothermal, heated, and the set-up of an oil.

use std::hint::black_box;

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, Length, LineLoad, Pressure, SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
use asperity_tribo_friction::{FilmHeat, FilmLineContact, FilmSettings, film_friction};
use criterion::{Criterion, criterion_group, criterion_main};

fn film(criterion: &mut Criterion) {
    let steel = Material {
        young: Pressure::from_si(210e9),
        poisson: 0.3,
        elastic_limit: Pressure::from_si(1.5e9),
        density: Density::from_si(7830.0),
        conductivity: ThermalConductivity::from_si(45.0),
        heat_capacity: SpecificHeat::from_si(465.0),
    };
    let input = LubricantInput {
        oil: Some("m100".to_owned()),
        base_oil: Some(BaseOil::Mineral),
        ..LubricantInput::default()
    };
    let Ok(oil) = input.resolve(Temperature::from_si(363.15)) else {
        return;
    };
    let Ok(rheology) = FilmRheology::new(&oil, BaseOil::Mineral) else {
        return;
    };
    let contact = FilmLineContact {
        line: LineContact {
            load: LineLoad::from_si(300e3),
            radius: Length::from_si(9e-3),
            modulus: Pressure::from_si(115.385e9),
            speeds: [Speed::from_si(4.6), Speed::from_si(3.4)],
            bodies: [steel, steel],
        },
        film: Length::from_si(0.26e-6),
        temperature: Temperature::from_si(363.15),
    };
    for (name, heat) in [
        ("heated film, 16 nodes", FilmHeat::FilmAndSurfaces),
        ("isothermal film, 16 nodes", FilmHeat::Isothermal),
    ] {
        let settings = FilmSettings {
            heat,
            ..FilmSettings::default()
        };
        criterion.bench_function(name, |bencher| {
            bencher.iter(|| film_friction::solve(&rheology, black_box(&contact), settings));
        });
    }
    criterion.bench_function("rheology of an oil", |bencher| {
        bencher.iter(|| FilmRheology::new(black_box(&oil), BaseOil::Mineral));
    });
}

criterion_group!(benches, film);
criterion_main!(benches);
