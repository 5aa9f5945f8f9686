//! Pixels of a PNG as browsers write it: 8 bits a sample, not interlaced.

use std::io::Read as _;

/// Width of the picture, and its pixels row by row.
pub fn pixels(bytes: &[u8]) -> (usize, Vec<[u8; 3]>) {
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
    let mut above = vec![0; width * samples];
    let mut rgb = Vec::new();
    for row in filtered.chunks_exact(1 + width * samples) {
        let mut line = row[1..].to_vec();
        for k in 0..line.len() {
            let before = |of: &[u8]| k.checked_sub(samples).map_or(0, |k| of[k]);
            let (a, b, c) = (before(&line), above[k], before(&above));
            let predicted = match row[0] {
                0 => 0,
                1 => a,
                2 => b,
                3 => u16::midpoint(a.into(), b.into()) as u8,
                4 => paeth(a, b, c),
                other => panic!("no filter {other}"),
            };
            line[k] = line[k].wrapping_add(predicted);
        }
        rgb.extend(
            line.chunks_exact(samples)
                .map(|rgb| [rgb[0], rgb[1], rgb[2]]),
        );
        above = line;
    }
    (width, rgb)
}

/// Of the left, the upper and the upper left sample the one next to left + upper - upper left.
fn paeth(a: u8, b: u8, c: u8) -> u8 {
    let [x, y, z] = [a, b, c].map(i16::from);
    let guess = x + y - z;
    let far = |value: i16| (guess - value).abs();
    if far(x) <= far(y) && far(x) <= far(z) {
        a
    } else if far(y) <= far(z) {
        b
    } else {
        c
    }
}
