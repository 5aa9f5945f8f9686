//! Rough line contact of elastic half-planes: boundary elements, plasticity, subsurface stress.

pub mod equations;
pub mod error;
pub mod hertz_line;
pub mod subsurface;

pub use error::ContactError;
