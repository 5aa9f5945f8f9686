//! Power losses, their breakdown and the efficiency of a gear mesh
