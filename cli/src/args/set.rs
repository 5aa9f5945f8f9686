//! Keys of a case set on the command line.

use clap::Args;

/// Keys of a case set on the command line.
#[derive(Debug, Clone, Args)]
pub struct SetArgs {
    /// Set a key of the case, e.g. operation.torque="200 N m"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub keys: Vec<SetArg>,
    /// Take only this mesh of a gear train or planetary set, at its torque and speed
    #[arg(long, value_name = "NAME")]
    pub mesh: Option<String>,
}

/// A key of a case and its value.
#[derive(Debug, Clone)]
pub struct SetArg {
    /// Path of the key.
    pub key: String,
    /// The value as in a case file; text needs no quotation marks.
    pub value: String,
}

impl std::str::FromStr for SetArg {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.split_once('=') {
            Some((key, value)) if !key.trim().is_empty() => Ok(Self {
                key: key.trim().to_owned(),
                value: value.trim().to_owned(),
            }),
            _ => Err("must be a key and its value, e.g. operation.torque=\"200 N m\""),
        }
    }
}
