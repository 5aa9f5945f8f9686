//! The film law alone, and a published law alone, over the temperature of an e-fluid.

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{Length, Speed, Temperature};
use asperity_oil::{BaseOil, FilmRheology, LubricantInput, ViscosityLaw};
use asperity_tribo_friction::xu::{XuConditions, XuLaw};
use asperity_tribo_friction::{FilmLineContact, FilmSettings, film_friction};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let steel = Material {
        young: "210 GPa".parse()?,
        poisson: 0.3,
        elastic_limit: "1500 MPa".parse()?,
        density: "7830 kg/m3".parse()?,
        conductivity: "45 W/(m K)".parse()?,
        heat_capacity: "465 J/(kg K)".parse()?,
    };
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: "30.8 mm2/s".parse()?,
            at_100: "5.9 mm2/s".parse()?,
        }),
        density: Some("845 kg/m3".parse()?),
        base_oil: Some(BaseOil::Pao),
        ..LubricantInput::default()
    }
    .resolve("90 °C".parse()?)?;
    let rheology = FilmRheology::new(&oil, BaseOil::Pao)?;
    println!("  °C   film law     K  | Xu, asperities included");
    for celsius in [-20.0, 20.0, 60.0, 90.0, 120.0] {
        let temperature = Temperature::from_celsius(celsius);
        let speeds = [Speed::from_si(8.125), Speed::from_si(4.875)];
        let contact = FilmLineContact {
            line: LineContact {
                load: "144 N/mm".parse()?,
                radius: "4.5 mm".parse()?,
                modulus: "115.385 GPa".parse()?,
                speeds,
                bodies: [steel, steel],
            },
            film: Length::from_si(0.15e-6),
            temperature,
        };
        let film = film_friction::solve(&rheology, &contact, FilmSettings::default())?.value;
        let xu = XuLaw::default().coefficient(&XuConditions {
            slide_to_roll: 0.5,
            max_pressure: film.max_pressure,
            viscosity: rheology.state(temperature)?.viscosity,
            entrainment: Speed::from_si(6.5),
            radius: contact.line.radius,
            combined_roughness: Length::from_si(0.1e-6),
        })?;
        let note = if xu.outside.is_empty() {
            ""
        } else {
            " (outside its range)"
        };
        println!(
            "{celsius:5.0}   {:.4}   {:5.1}  | {:.4}{note}",
            film.coefficient, film.surface_rise, xu.value
        );
    }
    Ok(())
}
