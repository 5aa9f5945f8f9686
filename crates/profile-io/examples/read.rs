//! Reads profile files and does nothing else, to measure time and memory of reading:
//! `/usr/bin/time -v target/release/examples/read flank.csv`.

use std::path::Path;
use std::time::Instant;

use asperity_profile_io::read::{ReadError, ReadOptions, read};

fn main() -> Result<(), ReadError> {
    for file in std::env::args().skip(1) {
        let start = Instant::now();
        let reading = read(Path::new(&file), &ReadOptions::default())?;
        let milliseconds = start.elapsed().as_secs_f64() * 1e3;
        println!("{file}: {} points in {milliseconds:.0} ms", reading.points);
    }
    Ok(())
}
