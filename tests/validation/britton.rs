//! The rig of Britton 2000 (gate T3): friction of superfinished discs over ground ones.

use std::sync::OnceLock;

use asperity::flanks::Texture;
use asperity::mixed_film::{
    AttenuatedTraces, ContactTable, LoadShareSettings, PositionFilm, RoughContact, RoughWindow,
};
use asperity::oil::{BaseOil, FilmRheology, LubricantInput, ViscosityLaw};
use asperity::uncertainty::independent_windows;
use asperity_contact::SolverSettings;
use asperity_core::Profile;
use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{
    Density, KinematicViscosity, Length, LineLoad, PerKelvin, Pressure, Speed, Temperature,
};
use asperity_ehl_regime::{Lay, PairSpectrum, TraceSpectrum};

use crate::gate::Estimate;
use crate::load_share::shipped;

/// Pairs of windows. Three gave changes 5 points larger.
const WINDOWS: usize = 72;
/// Golden section: pinion and wheel never pair the same places twice.
const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
/// Load \[N/m\] and radius \[m\] of the discs.
const LOAD: f64 = 250e3;
const RADIUS: f64 = 9e-3;

/// The rig at one temperature.
#[derive(Debug, Clone, Copy)]
pub struct Britton {
    /// Smooth film over Rq of the ground flanks.
    pub film_ratio: f64,
    /// Relative change of the friction by superfinishing.
    pub change: Estimate,
}

/// Contacts of the flanks of one finish, which serve every temperature.
struct Windows {
    flanks: [Profile; 2],
    /// Starts of the windows on both flanks, and their contacts.
    contacts: Vec<([usize; 2], ContactTable)>,
    points: usize,
    /// Windows that count as independent.
    effective: f64,
    /// Rq of both flanks together over the windows \[m\].
    rq: f64,
}

/// Ground and superfinished.
fn windows() -> &'static [Windows; 2] {
    static FOUND: OnceLock<[Windows; 2]> = OnceLock::new();
    FOUND.get_or_init(|| {
        let ground = shipped("e-drive").surfaces.clone();
        let ground = ground.with_heights_times(0.4 / 0.24).unwrap();
        let fine = shipped("e-drive-superfinished").surfaces.clone();
        [ground, fine].map(|surfaces| {
            Windows::new(surfaces.textures().clone().map(|texture| match texture {
                Texture::Trace(profile) => profile,
                _ => panic!("a fixture has traces"),
            }))
        })
    })
}

fn line_contact() -> LineContact {
    LineContact {
        load: LineLoad::from_si(LOAD),
        radius: Length::from_si(RADIUS),
        modulus: Pressure::from_si(210e9 / 2.0 / 0.91),
        speeds: [8.0, 12.0].map(Speed::from_si),
        bodies: shipped("e-drive").case.materials,
    }
}

impl Windows {
    fn new(flanks: [Profile; 2]) -> Self {
        let contact = line_contact();
        let spacing = flanks[0].spacing();
        let half_width =
            (4.0 * LOAD * RADIUS / (std::f64::consts::PI * contact.modulus.si())).sqrt();
        let points = 2 * (3.0 * half_width / spacing.si()).ceil() as usize + 1;
        let (mut contacts, mut square) = (Vec::new(), 0.0);
        for k in 0..WINDOWS {
            let start =
                |flank: usize, part: f64| (part * (flanks[flank].len() - points) as f64) as usize;
            let starts = [
                start(0, (k as f64 + 0.5) / WINDOWS as f64),
                start(1, (0.5 + k as f64 * GOLDEN_SECTION).fract()),
            ];
            let at = |flank: usize, i: usize| flanks[flank].heights()[starts[flank] + i];
            let composite: Vec<f64> = (0..points).map(|i| at(0, i) + at(1, i)).collect();
            let mut rough = RoughContact::new(&RoughWindow {
                composite: &composite,
                spacing,
                load: contact.load,
                radius: contact.radius,
                modulus: contact.modulus,
                flow_pressure: Pressure::from_si(7e9),
                settings: SolverSettings::default(),
            })
            .unwrap();
            contacts.push((starts, ContactTable::build(&mut rough).unwrap()));
            let n = points as f64;
            let middle = composite.iter().sum::<f64>() / n;
            square += composite.iter().map(|z| (z - middle).powi(2)).sum::<f64>() / n;
        }
        let free = flanks.iter().map(Profile::len).min().unwrap() - points;
        let free = Length::from_si(free as f64 * spacing.si());
        let effective = independent_windows(free, Length::from_si(half_width));
        Self {
            flanks,
            contacts,
            points,
            effective,
            rq: (square / WINDOWS as f64).sqrt(),
        }
    }
}

/// Friction of the fixtures' flanks brought to Ra 0.4 um against superfinished ones, in a jet ester of
/// 5.1 mm²/s at 100 °C: 250 N/mm on 9 mm radius at 8 and 12 m/s, with the constants of the default model.
pub fn britton(celsius: f64) -> Britton {
    let [(on_ground, film_ratio), (on_fine, _)] = windows()
        .each_ref()
        .map(|windows| friction(celsius, windows));
    Britton {
        film_ratio,
        change: on_fine.change_to(on_ground),
    }
}

/// Mean friction over the windows, and the smooth film over their Rq.
fn friction(celsius: f64, windows: &Windows) -> (Estimate, f64) {
    let model = shipped("e-drive").case.model.clone();
    let flanks = windows.flanks.each_ref();
    let rq = |trace: &Profile| {
        let square = trace.heights().iter().map(|z| z * z).sum::<f64>() / trace.len() as f64;
        Length::from_si(square.sqrt())
    };
    let settings = LoadShareSettings {
        boundary_friction: model.boundary_friction,
        boundary_layer: model.boundary_layer,
        lay: Lay::of_pair(model.lay, flanks.map(rq)).unwrap(),
        ..LoadShareSettings::default()
    };
    let (oil, contact) = (jet_ester(), line_contact());
    let bulk = Temperature::from_si(celsius + 273.15);
    let mut film = PositionFilm::new(&oil, &contact, bulk, &settings).unwrap();
    let spectra = flanks.map(|z| TraceSpectrum::new(z.heights(), z.spacing()).unwrap());
    let attenuation = film.flattening(&PairSpectrum::from_traces(spectra.each_ref()));
    let attenuated = AttenuatedTraces::new(spectra.each_ref(), &attenuation.unwrap());
    let coefficients = windows.contacts.iter().map(|(starts, table)| {
        let roughness = attenuated.window(*starts, windows.points).unwrap();
        film.share(table, &roughness).unwrap().value.coefficient
    });
    let coefficients: Vec<f64> = coefficients.collect();
    let value = coefficients.iter().sum::<f64>() / WINDOWS as f64;
    let squares: f64 = coefficients.iter().map(|one| (one - value).powi(2)).sum();
    // Windows of one trace scatter about the mean of the trace, which is itself off the mean of the flank.
    let variance = squares / (WINDOWS as f64 - 1.0) / (1.0 - 1.0 / windows.effective);
    let found = Estimate {
        value,
        standard_error: (variance / windows.effective).sqrt(),
    };
    (found, film.smooth_film().si() / windows.rq)
}

fn jet_ester() -> FilmRheology {
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(26e-6),
            at_100: KinematicViscosity::from_si(5.1e-6),
        }),
        density: Some(Density::from_si(1000.0)),
        thermal_expansion: Some(PerKelvin::from_si(0.63e-3)),
        base_oil: Some(BaseOil::Ester),
        ..LubricantInput::default()
    };
    let oil = oil.resolve(Temperature::from_si(363.15)).unwrap();
    FilmRheology::new(&oil, BaseOil::Ester).unwrap()
}
