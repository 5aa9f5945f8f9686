//! Arguments of `asperity oil`.

use std::path::PathBuf;

use clap::Args;

use super::study::KeyGroup;

/// `asperity oil`
#[derive(Debug)]
pub struct Oils;

impl KeyGroup for Oils {
    const NAME: &'static str = "oil ";
}

/// An oil.
#[derive(Debug, Args)]
pub struct GivenOil {
    /// Oil of the library, or a case, an oil file, or a file with the table [lubricant] only
    pub oil: String,
}

/// An oil, and a case that runs with it.
#[derive(Debug, Args)]
pub struct GivenOilOfCase {
    /// Oil of the library, or a case, an oil file, or a file with the table [lubricant] only
    #[arg(long)]
    pub oil: String,
    /// Case whose loss is to be narrowed [default: the case of --oil]
    #[arg(long)]
    pub case: Option<PathBuf>,
}

/// Measured curves, and their oil.
#[derive(Debug, Args)]
pub struct GivenCurves {
    /// Tables or text exports of measured curves
    #[arg(required = true, value_name = "FILE")]
    pub curves: Vec<PathBuf>,
    /// Oil of the library with the viscosity and family, or a case, an oil file, or a file with the table [lubricant] only
    #[arg(long)]
    pub oil: String,
}

/// Limits of studies that take seconds: none.
#[derive(Debug, Args)]
pub struct NoLimits {}
