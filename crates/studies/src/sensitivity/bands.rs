//! Wavelength bands of a trace.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::RoughnessError;
use asperity_roughness::gaussian_filter::{Ends, mean_line};

/// Bands per decade of wavelengths.
const STEPS_OF_A_DECADE: f64 = 2.0;

/// Edges of the bands from `shortest` to `longest`, about two bands per decade.
pub(super) fn edges([shortest, longest]: [Length; 2]) -> Vec<Length> {
    let decades = (longest.si() / shortest.si()).log10();
    let count = (STEPS_OF_A_DECADE * decades).round().max(1.0);
    (0..=count as usize)
        .map(|k| Length::from_si(shortest.si() * 10f64.powf(decades * k as f64 / count)))
        .collect()
}

/// Parts of a trace between the wavelengths `edges`, shortest first: differences of the mean lines of Gaussian filters,
/// which add up to the trace. The first part includes all shorter wavelengths, the last all longer ones.
///
/// # Errors
/// When an edge between two bands is shorter than the spacing or longer than the trace.
pub fn wavelength_bands(
    trace: &Profile,
    edges: &[Length],
) -> Result<Vec<Vec<f64>>, RoughnessError> {
    let mut parts = Vec::new();
    let mut remainder = trace.heights().to_vec();
    let inner = edges.get(1..edges.len().saturating_sub(1)).unwrap_or(&[]);
    for edge in inner {
        let line = mean_line(trace, *edge, Ends::Reflect)?;
        parts.push(remainder.iter().zip(&line).map(|(z, w)| z - w).collect());
        remainder = line;
    }
    parts.push(remainder);
    Ok(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn um(value: f64) -> Length {
        Length::from_si(value * 1e-6)
    }

    #[test]
    fn bands_add_up_and_hold_their_own_waves() {
        let wave = |i: usize, length: f64| (std::f64::consts::TAU * i as f64 * 0.5 / length).sin();
        let heights: Vec<f64> = (0..4000)
            .map(|i| 1e-7 * wave(i, 5.0) + 3e-7 * wave(i, 120.0))
            .collect();
        let trace = Profile::new(um(0.5), heights.clone()).unwrap();
        let edges = edges([um(2.5), um(250.0)]);
        assert_eq!(edges.len(), 5);
        assert!((edges[1].si() / edges[0].si() - 10f64.sqrt()).abs() < 1e-12);
        let parts = wavelength_bands(&trace, &edges).unwrap();
        assert_eq!(parts.len(), 4);
        let rms = |values: &[f64]| {
            // Away from the ends, where the filters mirror the trace.
            let inner = &values[600..3400];
            (inner.iter().map(|z| z * z).sum::<f64>() / inner.len() as f64).sqrt()
        };
        for i in 0..heights.len() {
            let sum: f64 = parts.iter().map(|part| part[i]).sum();
            assert!((sum - heights[i]).abs() < 1e-18);
        }
        // Half of a wave passes a Gaussian filter at its cut-off: 5 um lies a factor 1.6 within its band, 120 um within
        // its own.
        assert!(rms(&parts[0]) > 0.8 * 1e-7 / 2f64.sqrt());
        assert!(rms(&parts[3]) > 0.7 * 3e-7 / 2f64.sqrt());
        assert!(rms(&parts[1]) < 0.25 * 1e-7);
    }

    #[test]
    fn a_narrow_range_is_one_band() {
        let narrow = edges([um(80.0), um(100.0)]);
        assert_eq!(narrow.len(), 2);
        let trace = Profile::new(um(1.0), vec![1e-7, -1e-7, 2e-7]).unwrap();
        let parts = wavelength_bands(&trace, &narrow).unwrap();
        assert_eq!(parts, [trace.heights().to_vec()]);
    }
}
