//! Pixels of a PNG as browsers write it: 8 bits a sample, not interlaced.

use std::io::Read as _;

/// The samples of a picture, row by row.
pub struct Pixels {
    width: usize,
    samples: usize,
    all: Vec<u8>,
}

impl Pixels {
    /// Red, green and blue at a place; `None` outside of the picture.
    pub fn at(&self, x: i64, y: i64) -> Option<[u8; 3]> {
        let [x, y] = [usize::try_from(x).ok()?, usize::try_from(y).ok()?];
        let first = (y * self.width + x) * self.samples;
        let rgb = self.all.get(first..first + 3)?;
        (x < self.width).then(|| [rgb[0], rgb[1], rgb[2]])
    }
}

/// The pixels of a picture.
pub fn pixels(bytes: &[u8]) -> Pixels {
    let word = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let (mut packed, mut at, mut width, mut samples) = (Vec::new(), 8, 0, 0);
    while at < bytes.len() {
        let (length, data) = (word(at), at + 8);
        match &bytes[at + 4..data] {
            b"IHDR" => {
                width = word(data);
                let [depth, kind, .., interlaced] = bytes[data + 8..data + 13] else {
                    unreachable!()
                };
                samples = [0, 0, 3, 0, 0, 0, 4][usize::from(kind)];
                assert_eq!((depth, samples > 0, interlaced), (8, true, 0));
            }
            b"IDAT" => packed.extend_from_slice(&bytes[data..data + length]),
            _ => (),
        }
        at = data + length + 4;
    }
    let mut filtered = Vec::new();
    flate2::read::ZlibDecoder::new(packed.as_slice())
        .read_to_end(&mut filtered)
        .unwrap();
    // Not optimised in tests, and some ten million pixels: plain loops over slices.
    let length = width * samples;
    let mut all = vec![0; filtered.len() / (1 + length) * length];
    let mut above: &[u8] = &vec![0; length];
    for (row, line) in filtered
        .chunks_exact(1 + length)
        .zip(all.chunks_exact_mut(length))
    {
        let (filter, row) = (row[0], &row[1..]);
        line.copy_from_slice(row);
        let mut k = if filter == 1 { samples } else { 0 };
        while k < length && filter != 0 {
            let before = k >= samples;
            let a = if before { line[k - samples] } else { 0 };
            let predicted = match filter {
                1 => a,
                2 => above[k],
                3 => u16::midpoint(a.into(), above[k].into()) as u8,
                4 => paeth(a, above[k], if before { above[k - samples] } else { 0 }),
                other => panic!("no filter {other}"),
            };
            line[k] = line[k].wrapping_add(predicted);
            k += 1;
        }
        above = line;
    }
    Pixels {
        width,
        samples,
        all,
    }
}

/// Of the left, the upper and the upper left sample the one next to left + upper - upper left.
fn paeth(a: u8, b: u8, c: u8) -> u8 {
    // Plain arithmetic, as it is not optimised: |guess - value| of the three.
    let (up, left) = (i32::from(b) - i32::from(c), i32::from(a) - i32::from(c));
    let far = |way: i32| if way < 0 { -way } else { way };
    let (x, y, z) = (far(up), far(left), far(up + left));
    if x <= y && x <= z {
        a
    } else if y <= z {
        b
    } else {
        c
    }
}
