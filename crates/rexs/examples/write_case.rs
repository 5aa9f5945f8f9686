//! Writes the case of a stage of a REXS file.

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use asperity_rexs::{Flanks, Model, case_text};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("usage: write_case FILE [STAGE]")?;
    let stage: usize = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let model = Model::read(&std::fs::read(&path)?)?;
    let case = case_text(&model, &path, stage, 1, &Flanks::default())?;
    print!("{}", case.toml);
    for note in case.notes {
        println!("# note: {note}");
    }
    Ok(())
}
