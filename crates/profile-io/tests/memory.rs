//! Memory of reading: the columns that are read and a buffer, not the file.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, clippy::panic)]

use std::io::{Read, Result, Seek, SeekFrom};

use asperity_profile_io::read::{ReadOptions, read_stream};

const ROWS: u64 = 300_000;
/// Bytes of a row: x, height and eight columns that are not read.
const WIDTH: u64 = 100;

/// A table that is made as it is read.
struct Made {
    at: u64,
}

impl Made {
    fn row(number: u64) -> String {
        if number == 0 {
            return format!("{:<99}\n", "x [um];z [um];a;b;c;d;e;f;g;h");
        }
        let others = ";0.1234567".repeat(8);
        format!(
            "{:09.1};{:.4}{others:<83}\n",
            0.5 * number as f64,
            1.0 + (number % 7) as f64
        )
    }
}

impl Read for Made {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let row = Self::row(self.at / WIDTH);
        if self.at / WIDTH > ROWS || buffer.is_empty() {
            return Ok(0);
        }
        let rest = &row.as_bytes()[(self.at % WIDTH) as usize..];
        let count = rest.len().min(buffer.len());
        buffer[..count].copy_from_slice(&rest[..count]);
        self.at += count as u64;
        Ok(count)
    }
}

impl Seek for Made {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.at = match to {
            SeekFrom::Start(at) => at,
            SeekFrom::End(by) => (WIDTH * (ROWS + 1)).saturating_add_signed(by),
            SeekFrom::Current(by) => self.at.saturating_add_signed(by),
        };
        Ok(self.at)
    }
}

/// Most memory this process had at any time, in bytes; where the system tells.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kibibytes << 10)
}

#[test]
fn a_file_of_thirty_megabytes_takes_the_memory_of_its_points() {
    assert_eq!(Made::row(1).len() as u64, WIDTH);
    let before = peak();
    let reading = read_stream("a.csv", Made { at: 0 }, &ReadOptions::default()).unwrap();
    assert_eq!(reading.points as u64, ROWS);
    let (Some(before), Some(after)) = (before, peak()) else {
        return;
    };
    // x and z take 16 bytes a point, and up to half as much again while a column grows; the head of
    // the file, its lines and the buffers take less than 4 MiB.
    let taken = after - before;
    assert!(taken < 24 * ROWS + (4 << 20), "{} MB", taken / 1_000_000);
}
