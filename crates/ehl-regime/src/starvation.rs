//! Film of a contact whose inlet is not flooded, as behind a sparse oil jet.
//!
//! The flanks carry layers of oil into the contact. Across a line contact no oil leaves sideways, so that the film cannot carry
//! more than the layers bring; where they bring more than the flooded film takes, the inlet fills and the film is the flooded one.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h, h_c | central film, starved and flooded, as mass flow | m |
//! | h_l | oil layers of both surfaces together ahead of the contact | m |
//! | γ | resistance of the inlet to side flow | - |
//!
//! Source: Damiens, Venner, Cann, Lubrecht 2004, as printed in a summary of Lugt 2013, eq. 9.73: γ is about 3 for circular
//! contacts and up to 15 for wide elliptical ones. The rolling resistance of the inlet, which starvation lowers, is left as
//! flooded.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::RegimeError;

/// γ of the widest elliptical contacts, used for line contacts.
const SIDE_FLOW: f64 = 15.0;

/// Starved over flooded film.
///
/// ```text
/// h/h_c = r/(1 + r^γ)^(1/γ),  r = h_l/h_c,  γ = 15                                   [Starved-1]
/// ```
///
/// # Errors
/// When film or layer is not positive.
///
/// ```
/// use asperity_ehl_regime::starvation::starved;
/// let film = "0.2 um".parse()?;
/// assert!((starved(film, "0.1 um".parse()?)? - 0.5).abs() < 1e-5);
/// assert!((starved(film, "0.4 um".parse()?)? - 1.0).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn starved(flooded: Length, layer: Length) -> Result<f64, RegimeError> {
    cite!("Starved-1");
    let film = DomainError::positive("film thickness", flooded)?;
    let layer = DomainError::positive("oil layer", layer)?;
    let ratio = layer / film;
    // Written so that neither a thick nor a thin layer overflows.
    let [less, more] = [ratio.min(1.0), ratio.min(1.0 / ratio)];
    Ok(less / (1.0 + more.powf(SIDE_FLOW)).powf(1.0 / SIDE_FLOW))
}
