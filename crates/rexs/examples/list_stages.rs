//! Lists the stages of a REXS file with their operating points.

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use asperity_rexs::{Model, operating_points, stages};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: list_stages FILE")?;
    let model = Model::read(&std::fs::read(path)?)?;
    println!("REXS {} by {}", model.version, model.program);
    for stage in stages(&model)? {
        println!("{} {}: {:?}", stage.number, stage.name, stage.kind);
        for point in operating_points(&model, &stage)? {
            println!("  {point:?}");
        }
    }
    Ok(())
}
