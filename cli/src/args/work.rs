//! Limits of estimated time and memory.

use clap::Args;

/// Limits of estimated time and memory, above which nothing is started.
#[derive(Debug, Clone, Copy, Args)]
pub struct WorkArgs {
    /// Refuse to start if the estimated time is longer
    #[arg(long, value_name = "HOURS", default_value_t = 2.0)]
    pub max_hours: f64,
    /// Refuse to start if the estimated memory is larger
    #[arg(long, value_name = "GB", default_value_t = 8.0)]
    pub max_gb: f64,
}
