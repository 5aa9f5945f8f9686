//! Profilometer files, filters and roughness parameters of measured profiles
