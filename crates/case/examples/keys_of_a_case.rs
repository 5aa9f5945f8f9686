//! Reads a case file without running it, and prints every default that it uses with its reason.
//!
//! ```text
//! cargo run -p asperity-case --example keys_of_a_case -- fixtures/cases/e-drive.toml
//! ```

use std::path::Path;

use asperity_case::case;
use asperity_case::error::Error;

fn main() -> Result<(), Error> {
    let file = std::env::args().nth(1);
    let file = file.unwrap_or_else(|| "fixtures/cases/e-drive.toml".to_owned());
    let loaded = case::load(Path::new(&file), None)?;
    for default in &loaded.case.defaults {
        let source = default.source.as_deref().unwrap_or("-");
        println!("{} = {}  ({source})", default.key, default.value);
    }
    Ok(())
}
