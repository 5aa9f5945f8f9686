//! Lubricated contact from numbers and profiles on the command line.

use std::path::Path;

use asperity::ehl::traction::Heat;
use asperity::ehl::{FrictionLaw, LineContact, MovingProfile, Oil, PlasticCeiling, RoughContact};
use asperity::oil::{AMBIENT_LIMIT, DensityLaw, LubricantInput, PressureViscosityLaw, ShearLaw};
use asperity::reference_solution::attenuated_roughness;
use asperity::tribo_friction::boundary::BOUNDARY_LAYER;
use asperity_core::material::Material;
use asperity_core::message::Warning;
use asperity_core::quantity::{
    Density, DynamicViscosity, Length, Pressure, PressureViscosity, SpecificHeat,
    ThermalConductivity,
};
use asperity_core::{Code, Fault, Profile};

use crate::args::{EhlArgs, ViscosityLawArg};
use crate::commands::contact::column_file;
use crate::failure::Failure;

/// Eyring stress of the friction law for a Newtonian film.
const EYRING_STRESS: Pressure = Pressure::from_si(5e6);
/// Steel of the bodies, whose heat the thermal traction needs.
const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(1500e6),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(45.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};
/// Share of a profile over which its end is blended into its beginning.
const OVERLAP: f64 = 0.1;

/// Contact from the options.
pub struct Bare {
    pub title: String,
    pub rough: RoughContact,
    pub friction: FrictionLaw,
    pub ceiling: Option<PlasticCeiling>,
    /// Thermal data of the film, for an oil of the library.
    pub heat: Option<Heat>,
    /// Attenuated roughness in the contact, of both profiles.
    pub attenuated_roughness: Length,
    /// Columns of the files of both profiles that were not read.
    pub unread: Vec<Warning>,
}

impl Bare {
    /// Whether neither surface has a profile.
    pub fn is_smooth(&self) -> bool {
        self.attenuated_roughness.si() == 0.0
    }
}

/// Reads the options and the profiles that they name.
pub fn read(args: &EhlArgs) -> Result<Bare, Failure> {
    let bare = &args.bare;
    let needed = |name| Failure::new(Code::E205, format!("give a case file, or {name}"));
    let contact = LineContact {
        radius: bare.radius.ok_or_else(|| needed("--radius"))?,
        modulus: bare.e_star.ok_or_else(|| needed("--e-star"))?,
        load: bare.load.ok_or_else(|| needed("--load"))?,
        speed_1: bare.u1.ok_or_else(|| needed("--u1"))?,
        speed_2: bare.u2.ok_or_else(|| needed("--u2"))?,
    };
    let (viscosity, pressure_viscosity, heat) = oil_state(args)?;
    let oil = Oil {
        viscosity,
        pressure_viscosity,
        viscosity_law: match bare.viscosity_law {
            ViscosityLawArg::Roelands => PressureViscosityLaw::Roelands {
                exponent: bare.roelands,
            },
            ViscosityLawArg::Barus => PressureViscosityLaw::Barus,
            ViscosityLawArg::Isoviscous => PressureViscosityLaw::Isoviscous,
        },
        density_law: match bare.viscosity_law {
            ViscosityLawArg::Roelands => DensityLaw::DowsonHigginson,
            ViscosityLawArg::Barus | ViscosityLawArg::Isoviscous => DensityLaw::Incompressible,
        },
        shear_law: match args.eyring_stress {
            Some(stress) => ShearLaw::Eyring { stress },
            None => ShearLaw::Newtonian,
        },
    };
    let title = "line contact".to_owned();
    contact
        .scales(&oil)
        .map_err(|error| Fault::from(error).about(&title))?;
    let first = surface(bare.profile1.as_deref(), bare.periodic)?;
    let second = surface(bare.profile2.as_deref(), bare.periodic)?;
    let surfaces = || [&first, &second].into_iter().flatten();
    let profiles: Vec<&Profile> = surfaces().map(|surface| &surface.profile).collect();
    let unread = surfaces().filter_map(|surface| surface.unread.clone());
    let unread: Vec<Warning> = unread.collect();
    let attenuated_roughness = match profiles[..] {
        [] => Length::from_si(0.0),
        _ => attenuated_roughness(&contact, &oil, &profiles)
            .map_err(|error| Fault::from(error).about(&title))?,
    };
    let moving = |surface: Option<Surface>| {
        surface.map_or_else(MovingProfile::smooth, |surface| surface.moving)
    };
    Ok(Bare {
        title,
        rough: RoughContact {
            contact,
            oil,
            surface_1: moving(first),
            surface_2: moving(second),
        },
        friction: FrictionLaw {
            viscosity,
            pressure_viscosity,
            eyring_stress: args.eyring_stress.unwrap_or(EYRING_STRESS),
            limiting_stress: AMBIENT_LIMIT,
            limiting_slope: bare.limiting_shear,
            boundary_friction: bare.boundary_friction,
            boundary_layer: BOUNDARY_LAYER,
        },
        ceiling: bare
            .pressure_limit
            .map(|pressure| PlasticCeiling { pressure }),
        heat,
        attenuated_roughness,
        unread,
    })
}

/// Viscosity and its pressure coefficient at the inlet, and the thermal data of an oil of the library between steel.
fn oil_state(
    args: &EhlArgs,
) -> Result<(DynamicViscosity, PressureViscosity, Option<Heat>), Failure> {
    let bare = &args.bare;
    match (&bare.oil, bare.bulk, bare.viscosity, bare.pressure_viscosity) {
        (Some(name), Some(bulk), _, _) => {
            let input = LubricantInput {
                oil: Some(name.clone()),
                ..LubricantInput::default()
            };
            let state = input
                .resolve(bulk)
                .and_then(|oil| oil.at(bulk))
                .map_err(|error| {
                    Failure::new(Code::E208, format!("--oil {name}: {error}"))
                        .advising("Name an oil of the library, or pass --viscosity and --pressure-viscosity.")
                })?
                .value;
            let heat = Heat {
                bulk,
                temperature_coefficient: state.temperature_coefficient,
                oil_conductivity: state.thermal_conductivity,
                material: STEEL,
            };
            Ok((
                state.dynamic_viscosity,
                state.pressure_viscosity,
                Some(heat),
            ))
        }
        (_, _, Some(viscosity), Some(coefficient)) => Ok((viscosity, coefficient, None)),
        _ => Err(Failure::new(
            Code::E205,
            "the oil is missing: pass --oil and --bulk, or --viscosity and --pressure-viscosity",
        )
        .advising("For example --oil m100 --bulk \"90 °C\", or --viscosity \"10 mPa s\" --pressure-viscosity \"18 1/GPa\".")),
    }
}

/// Profile of a file.
struct Surface {
    profile: Profile,
    moving: MovingProfile,
    unread: Option<Warning>,
}

fn surface(path: Option<&Path>, is_periodic: bool) -> Result<Option<Surface>, Failure> {
    let Some(path) = path else {
        return Ok(None);
    };
    let (profile, unread) = column_file::profile(path)?;
    let moving = if is_periodic {
        MovingProfile::periodic(&profile)
    } else {
        MovingProfile::blended(&profile, profile.length() * OVERLAP)
            .map_err(|error| Failure::new(Code::E209, format!("{}: {error}", path.display())))?
    };
    Ok(Some(Surface {
        profile,
        moving,
        unread,
    }))
}
