//! From two measured tooth flanks to the efficiency of a gear mesh
