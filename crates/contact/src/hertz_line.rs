//! Hertz line contact of two parallel cylinders.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | w | load per length of contact line | N/m |
//! | R | relative radius of curvature | m |
//! | E* | reduced modulus | Pa |
//! | b | half width of the contact | m |
//! | p₀ | largest pressure | Pa |
