//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::material::JOHNSON_1985;
use asperity_core::{Equation, Reference};

use crate::hertz_line;

/// The paper that the model follows.
const VICTORIA_2022: Reference = Reference {
    key: "victoria_rodriguez_2022",
    text: "I. Victoria Rodríguez, Modelling of gear surface roughness impact on gear meshing efficiency, manuscript, 2022",
};
/// The contact with a limit of the pressure, and its plastic displacement.
const ALMQVIST_2007: Reference = Reference {
    key: "almqvist_2007",
    text: "A. Almqvist, F. Sahlin, R. Larsson, S. Glavatskih, On the dry elasto-plastic contact of nominally flat surfaces, Tribology International 40 (2007) 574-579, doi:10.1016/j.triboint.2005.11.008",
};
/// Conjugate gradients for rough contacts.
const POLONSKY_1999: Reference = Reference {
    key: "polonsky_1999",
    text: "I. A. Polonsky, L. M. Keer, A numerical method for solving rough contact problems based on the multi-level multi-summation and conjugate gradient techniques, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1",
};
/// The wavy half-plane.
const WESTERGAARD_1939: Reference = Reference {
    key: "westergaard_1939",
    text: "H. M. Westergaard, Bearing pressures and cracks, Journal of Applied Mechanics 6 (1939) A49-A53",
};
/// Hardness and yield stress.
const TABOR_1951: Reference = Reference {
    key: "tabor_1951",
    text: "D. Tabor, The Hardness of Metals, Clarendon Press, Oxford, 1951",
};

/// Equations of this crate but those of the Hertz contact and of the subsurface, which list their
/// own.
pub const EQUATIONS: &[Equation] = &[];

/// Every equation of this crate.
pub fn equations() -> impl Iterator<Item = &'static Equation> {
    EQUATIONS.iter().chain(hertz_line::EQUATIONS)
}
