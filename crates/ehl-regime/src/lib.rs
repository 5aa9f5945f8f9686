//! Elastohydrodynamic film thickness, thermal reduction and the lubrication regime
