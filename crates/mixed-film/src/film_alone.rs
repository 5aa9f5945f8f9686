//! Friction of a film without asperities, as a friction law.

use asperity_core::Checked;
use asperity_core::line_contact::LineContact;
use asperity_oil::FilmRheology;
use asperity_tribo_friction::{
    FilmContact, FilmFriction, FilmLineContact, FilmSettings, FilmTraction, FrictionError,
    LoadedFilm,
};

/// Friction of a film of the oil of a case: shear law, limiting shear stress, heat of film and surfaces.
#[derive(Debug, Clone)]
pub struct FilmAlone {
    rheology: FilmRheology,
}

impl FilmAlone {
    /// The law of an oil with `rheology`.
    #[must_use]
    pub fn new(rheology: &FilmRheology) -> Self {
        Self {
            rheology: rheology.clone(),
        }
    }
}

impl FilmFriction for FilmAlone {
    fn name(&self) -> &str {
        self.rheology.laws().0.name()
    }

    fn traction(&self, at: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
        let contact = FilmLineContact {
            line: LineContact {
                load: at.position.load,
                radius: at.position.radius,
                modulus: at.modulus,
                speeds: at.surface_speeds,
                bodies: at.materials,
            },
            film: at.position.central_film,
            temperature: at.bulk_temperature,
        };
        let mut film = LoadedFilm::new(&self.rheology, &contact, FilmSettings::default())?;
        film.carry(at.film_share)?;
        Ok(film.solve()?.map(|solution| {
            FilmTraction::from_coefficient(solution.coefficient)
                .with_rises(solution.surface_rise, solution.largest_film_rise)
        }))
    }
}
