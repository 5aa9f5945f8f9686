//! Marks of missing heights in SDF, as text and binary.

/// Smallest and largest number by the number of the type.
const RANGES: [[f64; 2]; 8] = [
    [0.0, u8::MAX as f64],
    [0.0, u16::MAX as f64],
    [0.0, u32::MAX as f64],
    [f32::MIN as f64, 3.4e38],
    [i8::MIN as f64, i8::MAX as f64],
    [i16::MIN as f64, i16::MAX as f64],
    [i32::MIN as f64, i32::MAX as f64],
    [f64::MIN, 1.7e308],
];

/// Numbers of a type between which its heights are. The smallest number of a signed type is a missing height in ISO 25178-71,
/// the largest number of each type in the proposal BCR before the standard; no instrument measures the other one.
pub(super) fn between(kind: usize, is_proposal: bool) -> [f64; 2] {
    let Some([smallest, largest]) = RANGES.get(kind) else {
        return [f64::NEG_INFINITY, f64::INFINITY];
    };
    let below = if *smallest < 0.0 {
        *smallest
    } else {
        f64::NEG_INFINITY
    };
    let above = if is_proposal { *largest } else { f64::INFINITY };
    [below, above]
}
