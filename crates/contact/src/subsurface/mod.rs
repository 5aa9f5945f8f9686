//! Plane-strain stress under a loaded surface.
//!
//! Sources: K. L. Johnson, *Contact Mechanics* (1985), sections 2.5 and 4.2; E. McEwen (1949) for
//! the closed form under a Hertz contact. The bodies are elastic half-planes: valid if the contact is
//! narrow compared with the radii and nothing yields. The zone in which the von Mises stress exceeds
//! the elastic limit is reported, not modelled.
//!
//! Tension is positive, z points into the body, pressure p > 0 presses on it and traction q > 0
//! pulls its surface towards +x. In plane strain σ_yy = ν·(σ_xx + σ_zz).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, z | position along the surface, depth | m |
//! | a | half width of a uniformly loaded strip | m |
//! | b, p₀ | half width and largest pressure of a Hertz contact | m, Pa |
//! | p, q | pressure and traction on the surface | Pa |
//! | σ_xx, σ_zz, τ_xz | stresses in the plane | Pa |
//! | τ₁ | largest shear stress in the plane | Pa |
//! | σ_M, σ_T | equivalent stress of von Mises, of Tresca | Pa |
//! | ν | Poisson's ratio | - |

mod axis;
mod field;
mod hertz_stress;
mod point;
mod strip;
#[cfg(test)]
mod tests;

pub use axis::{HERTZ_SHEAR_DEPTH, hertz_axis_shear, strip_axis_shear};
pub use field::{Peak, StressField, YieldZone, graded_depths, subsurface_stress};
pub use hertz_stress::hertz_stress;
pub use point::PlaneStress;
pub use strip::{StripStress, strip_unit};
