//! Writers of arrays as text (`.csv`) and in the binary format of NumPy (`.npy`).
//!
//! Source: the NPY format, version 1.0, of NumPy's documentation: a magic string, a header that is
//! a Python dictionary padded to a multiple of 64 bytes, and the values in little-endian order.

use std::io::{self, Write};

use crate::problem::ContactSolution;
use crate::subsurface::StressField;

/// Magic string and version.
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
/// The header ends at a multiple of this many bytes.
const ALIGNMENT: usize = 64;

/// Writes the concatenated `parts` as one array of 64-bit numbers in C order.
///
/// # Errors
/// When the number of elements of the shape is not the number of values, or the writer fails.
///
/// ```
/// use asperity_contact::array_file::write_npy;
/// let mut file = vec![];
/// write_npy(&mut file, &[2, 3], &[&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]])?;
/// assert_eq!(file.len(), 128 + 6 * 8);
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_npy(out: &mut impl Write, shape: &[usize], parts: &[&[f64]]) -> io::Result<()> {
    let values: usize = parts.iter().map(|part| part.len()).sum();
    if shape.iter().product::<usize>() != values {
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            format!("an array of shape {shape:?} does not have {values} values"),
        ));
    }
    // A tuple of one element needs its comma.
    let shape: String = shape.iter().map(|size| format!("{size}, ")).collect();
    let shape = shape.trim_end_matches(' ');
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    let prefix = MAGIC.len() + size_of::<u16>();
    let padded = (prefix + header.len() + 1).next_multiple_of(ALIGNMENT) - prefix;
    while header.len() + 1 < padded {
        header.push(' ');
    }
    header.push('\n');
    let length = u16::try_from(header.len()).map_err(io::Error::other)?;
    out.write_all(MAGIC)?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    for value in parts.iter().copied().flatten() {
        out.write_all(&value.to_le_bytes())?;
    }
    Ok(())
}

/// Writes named columns of equal length with all digits.
///
/// # Errors
/// When the columns differ in length, or the writer fails.
///
/// ```
/// use asperity_contact::array_file::write_csv;
/// let mut file = vec![];
/// write_csv(&mut file, &[("x_m", &[0.0, 1e-6]), ("p_pa", &[0.0, 2.5e9])])?;
/// assert_eq!(String::from_utf8(file).unwrap(), "x_m,p_pa\n0e0,0e0\n1e-6,2.5e9\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_csv(out: &mut impl Write, columns: &[(&str, &[f64])]) -> io::Result<()> {
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    if let Some((name, values)) = columns.iter().find(|(_, values)| values.len() != rows) {
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            format!(
                "column {name} has {} values, the first {rows}",
                values.len()
            ),
        ));
    }
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    writeln!(out, "{}", names.join(","))?;
    for row in 0..rows {
        for (column, (_, values)) in columns.iter().enumerate() {
            let comma = if column == 0 { "" } else { "," };
            write!(out, "{comma}{:e}", values[row])?;
        }
        writeln!(out)?;
    }
    Ok(())
}

impl ContactSolution {
    /// Writes pressure, displacement, gap and plastic displacement as text, one row per point.
    ///
    /// # Errors
    /// When the writer fails.
    pub fn write_csv(&self, out: &mut impl Write) -> io::Result<()> {
        let [p, u, g, w] = self.fields();
        let columns = [
            ("pressure_pa", p),
            ("displacement_m", u),
            ("gap_m", g),
            ("plastic_displacement_m", w),
        ];
        write_csv(out, &columns)
    }

    /// Writes pressure, displacement, gap and plastic displacement as an array of shape (4, points).
    ///
    /// # Errors
    /// When the writer fails.
    pub fn write_npy(&self, out: &mut impl Write) -> io::Result<()> {
        write_npy(out, &[4, self.pressure.len()], &self.fields())
    }

    fn fields(&self) -> [&[f64]; 4] {
        [
            &self.pressure,
            &self.displacement,
            &self.gap,
            &self.plastic_displacement,
        ]
    }
}

impl StressField {
    /// Writes the position from the first point, the depth and the three stresses as text, one row per
    /// point.
    ///
    /// # Errors
    /// When the writer fails.
    pub fn write_csv(&self, out: &mut impl Write) -> io::Result<()> {
        let dx = self.spacing.si();
        let indices = 0..self.sigma_xx.len();
        let x: Vec<f64> = indices
            .clone()
            .map(|i| (i % self.points) as f64 * dx)
            .collect();
        let z: Vec<f64> = indices.map(|i| self.depths[i / self.points]).collect();
        let columns = [
            ("x_m", &x[..]),
            ("z_m", &z),
            ("sigma_xx_pa", &self.sigma_xx),
            ("sigma_zz_pa", &self.sigma_zz),
            ("tau_xz_pa", &self.tau_xz),
        ];
        write_csv(out, &columns)
    }

    /// Writes σ_xx, σ_zz and τ_xz as an array of shape (3, depths, points).
    ///
    /// # Errors
    /// When the writer fails.
    pub fn write_npy(&self, out: &mut impl Write) -> io::Result<()> {
        let shape = [3, self.depths.len(), self.points];
        write_npy(out, &shape, &[&self.sigma_xx, &self.sigma_zz, &self.tau_xz])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_array_is_what_numpy_writes() {
        // numpy.save of arange(3.0), NumPy 1.26, except for the padding, which depends on the version.
        let mut file = vec![];
        write_npy(&mut file, &[3], &[&[0.0, 1.0, 2.0]]).unwrap();
        let header =
            b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }";
        assert!(file.starts_with(header));
        assert_eq!((file[127], file.len()), (b'\n', 128 + 24));
        assert_eq!(file[136..144], 1f64.to_le_bytes());
        assert!(write_npy(&mut file, &[2], &[&[0.0]]).is_err());
    }

    #[test]
    fn columns_of_different_length_are_refused() {
        assert!(write_csv(&mut vec![], &[("a", &[1.0]), ("b", &[])]).is_err());
    }

    #[test]
    fn a_field_is_written_point_by_point() {
        let spacing = asperity_core::quantity::Length::from_si(0.5);
        let field =
            crate::subsurface::subsurface_stress(&[1.0, 0.0], None, spacing, &[1.0, 2.0, 3.0])
                .unwrap();
        let (mut text, mut array) = (vec![], vec![]);
        field.write_csv(&mut text).unwrap();
        field.write_npy(&mut array).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text.lines().count(), 1 + 6);
        assert!(text.lines().nth(4).unwrap().starts_with("5e-1,2e0,"));
        assert_eq!(array.len(), 128 + 3 * 6 * 8);
    }
}
