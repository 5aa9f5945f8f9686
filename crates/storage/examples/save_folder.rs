//! Writes a folder, writes it again, and is refused once it holds a file of the user's.
//!
//! `cargo run -p asperity-storage --example save_folder`

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use std::path::Path;

use asperity_storage::{StorageError, replace_folder};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let place = tempfile::tempdir()?;
    let target = place.path().join("result");
    let fill = |text: &'static str| {
        move |folder: &Path| -> Result<(), StorageError> {
            asperity_storage::save(&folder.join("value.txt"), text.as_bytes())
        }
    };
    replace_folder(&target, "result", fill("first"))?;
    replace_folder(&target, "result", fill("second"))?;
    println!("{}", std::fs::read_to_string(target.join("value.txt"))?);
    std::fs::write(target.join("notes.txt"), "mine")?;
    match replace_folder(&target, "result", fill("third")) {
        Ok(()) => println!("replaced"),
        Err(refused) => println!("{refused}"),
    }
    Ok(())
}
