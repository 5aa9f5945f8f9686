//! Relocation of a trace that was measured after a test on the trace of the same place before it.
//!
//! Wear takes the peaks and spares the valleys, so the traces are matched by their valleys. First their correlation is searched over all shifts
//! and stretches within bounds; then shift, stretch, height and tilt are fitted to the valleys by robust least squares. Heights are
//! therefore relative to the valleys: a removal that takes valleys and peaks alike does not show. The intervals contain the noise of the
//! match, the choice of the valleys, and what valleys that rose may hide.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z_b, z_a | heights before and after | m |
//! | r_b, r_a | heights above the mean lines of λ_c | m |
//! | x | place on the second trace from its middle | m |
//! | s | place of the middle of the second trace on the first | m |
//! | e | stretch of the second trace | - |
//! | h, t, b | height, tilt and parabola to add to the second trace | m, -, 1/m |
//! | γ_k | autocovariance of the residuals in the valleys | m² |

mod changes;
mod fit;
mod noise;
mod placed;
mod relocated;
mod rise;
mod search;
mod traces;

pub use changes::Change;
pub use relocated::{Bounds, Relocation, relocate};
