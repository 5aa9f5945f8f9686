//! Friction coefficients, rolling resistance, mixed friction and flash temperature of lubricated gear flanks
