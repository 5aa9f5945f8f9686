//! Pressure in and across a thin lubricating film between two cylinders
