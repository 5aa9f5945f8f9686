//! Other laws and formulations, printed next to the interval and never in it.

use asperity_core::quantity::Length;
use asperity_oil::PressureLaw;

use crate::case::{LoadShareName, LoadedCase};
use asperity_mixed_film::SpotSpeed;

/// Upper end of the boundary layer.
const THICK_LAYER: Length = Length::from_si(20e-9);
/// Factor on the share of the asperities.
const HALF: f64 = 0.5;

/// An alternative: its name and the case changed to it.
pub(crate) type Alternative = (&'static str, LoadedCase);

/// Every alternative that changes something of the case.
pub(crate) fn alternatives(loaded: &LoadedCase) -> Vec<Alternative> {
    let case = &loaded.case;
    let own = &case.laws;
    let solves = own.load_share.is_none()
        && case.model.load_share == LoadShareName::Solved
        && loaded.surfaces.are_measured();
    let mut found = Vec::new();
    if solves {
        let mut half = loaded.clone();
        half.case.model.asperity_share_factor *= HALF;
        found.push(("asperity share halved", half));
        let mut thick = loaded.clone();
        thick.case.model.boundary_layer = THICK_LAYER;
        found.push(("boundary layer 20 nm", thick));
        let mut slow = loaded.clone();
        slow.case.model.spot_speed = SpotSpeed::HalfSliding;
        found.push(("spots fed at half the sliding speed", slow));
        let mut formula = loaded.clone();
        formula.case.model.load_share = LoadShareName::LambdaStar;
        found.push(("load share by Lambda*, dry asperities", formula));
    }
    let shear = case.model.film_friction.shear_law();
    let barus = case.model.film_pressure_law == PressureLaw::Barus;
    if let (Some(rheology), Some(shear), true, true) =
        (&case.rheology, shear, barus, own.friction.is_none())
    {
        let mut other = loaded.clone();
        other.case.model.film_pressure_law = PressureLaw::Roelands;
        let rheology = rheology.clone().with_laws(shear, PressureLaw::Roelands);
        other.case.rheology = Some(rheology);
        found.push(("viscosity by Roelands in the film", other));
    }
    // What the case has chosen is no alternative to it.
    found.retain(|(_, other)| other.case.model != case.model);
    found
}
