//! One solved mesh position, as data.

use asperity_contact::ContactWarning;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::Regime;

use crate::contact_tables::KeptContact;
use crate::contact_view::ContactView;
use crate::friction::{InFilm, Rubbing};
use crate::full_film::FullFilm;
use crate::local_roughness::Roughness;
use crate::records::RecordedShare;
use crate::result::PositionFields;
use crate::station::Station;
use asperity_mixed_film::LoadShareSolution;

/// A mesh position with everything that varies over the offsets.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    pub station: Station,
    pub offsets: Vec<Offset>,
    /// Fields of the first offset, where they were asked for.
    pub fields: Option<PositionFields>,
    /// The flanks facing each other at the first offset, where fields were asked for.
    pub view: Option<ContactView>,
    /// The full film by its elastohydrodynamic solution, where the case asks for it and an offset has one.
    pub full_film: Option<FullFilm>,
    /// Largest von Mises stress below the first offset's contact, and its depth.
    pub von_mises: Option<(Pressure, Length)>,
    /// Doubts about the rough contacts that were solved.
    pub doubts: Vec<ContactWarning>,
    /// Contacts of the offsets, where they are kept.
    pub kept: Vec<KeptContact>,
}

impl Position {
    /// Largest pressure of the rough contact, as a mean over the offsets where the flanks touch \[MPa\]; none
    /// where they don't.
    pub fn rough_pressure(&self) -> Option<f64> {
        let contacts = self.offsets.iter().filter_map(|offset| offset.contact);
        let pressures: Vec<f64> = contacts.map(|contact| contact.p_max * 1e-6).collect();
        let sum = || {
            pressures
                .iter()
                .fold(0.0, |sum: f64, pressure| sum + pressure)
        };
        (!pressures.is_empty()).then(|| sum() / pressures.len() as f64)
    }

    /// The same, or the Hertz pressure where the flanks don't touch: a report shows the position where it is
    /// highest.
    pub fn shown_pressure(&self) -> f64 {
        let hertz = self.station.hertz.max_pressure.si() * 1e-6;
        self.rough_pressure().unwrap_or(hertz)
    }
}

/// One offset of the traces at a mesh position.
#[derive(Debug, Clone)]
pub(crate) struct Offset {
    pub roughness: Roughness,
    /// Λ*; none when the peaks of the flanks are not known or there are none.
    pub lambda_star: Option<f64>,
    /// h_min/S.
    pub film_ratio: f64,
    pub regime: Regime,
    /// Share of the load that the film carries.
    pub film_share: f64,
    /// Share of the asperities' load that rubs with the boundary coefficient.
    pub boundary_part: f64,
    /// The rough contact at its share, where the law of the load share looks at it.
    pub solved: Option<LoadShareSolution>,
    /// Shares and friction of the records beside the position, where the law of the load share asks for them.
    pub recorded: Option<RecordedShare>,
    /// Friction in the film.
    pub friction: InFilm,
    /// Contributions of asperities and film to the friction force.
    pub rubbing: Rubbing,
    /// Friction force per metre of contact line \[N/m\].
    pub friction_force: f64,
    /// Flash temperature of film and asperities together \[K\].
    pub flash: f64,
    /// Numbers of the rough contact, where it was asked for and the flanks touch.
    pub contact: Option<ContactNumbers>,
    /// Deformation loss of the paper's reading.
    pub deformation: PrintedDeformation,
}

/// Deformation loss of one position in the paper's reading \[W\], each of pinion and wheel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PrintedDeformation {
    /// In contact: elastic and plastic displacement.
    pub in_contact: [f64; 2],
    /// After contact: plastic displacement alone.
    pub after_contact: [f64; 2],
}

/// Numbers kept of a rough contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactNumbers {
    pub contact_fraction: f64,
    pub p_max: f64,
    /// Plastic work \[J/m\].
    pub plastic_work: f64,
    pub iterations: usize,
    pub load_error: f64,
    pub duality_gap: f64,
}
