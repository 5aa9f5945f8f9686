//! MAT-files of level 5, not compressed. MATLAB, Simulink, Octave, scipy and the Modelica Standard Library read them.

use asperity_core::Fault;

use super::field::Field;
use super::given::ExportGiven;
use crate::map::efficiency;

/// Types of data elements.
mod element {
    pub(super) const INT8: u32 = 1;
    pub(super) const UINT16: u32 = 4;
    pub(super) const INT32: u32 = 5;
    pub(super) const UINT32: u32 = 6;
    pub(super) const DOUBLE: u32 = 9;
    pub(super) const MATRIX: u32 = 14;
}

/// Classes of arrays.
mod class {
    pub(super) const CHARACTERS: u32 = 4;
    pub(super) const DOUBLE: u32 = 6;
}

/// MAT-file of level 5 under construction.
#[derive(Debug, Clone, PartialEq)]
pub struct Mat5 {
    bytes: Vec<u8>,
}

impl Mat5 {
    /// Length of the text at the beginning.
    const TEXT: usize = 116;

    /// An empty file with a description, which is cut where the head is full.
    #[must_use]
    pub fn new(description: &str) -> Self {
        let mut bytes = format!("MATLAB 5.0 MAT-file, {description}").into_bytes();
        // The text is of ASCII and padded with blanks.
        for byte in &mut bytes {
            if !byte.is_ascii() {
                *byte = b'?';
            }
        }
        bytes.resize(Self::TEXT, b' ');
        // No data of a subsystem; version 1, little endian.
        bytes.extend([0; 8]);
        bytes.extend(0x0100_u16.to_le_bytes());
        bytes.extend(b"IM");
        Self { bytes }
    }

    /// Adds an array; of `values` the first index runs fastest.
    #[must_use]
    pub fn with(self, name: &str, sizes: &[usize], values: &[f64]) -> Self {
        let data = values.iter().flat_map(|value| value.to_le_bytes());
        self.array(
            name,
            class::DOUBLE,
            sizes,
            (element::DOUBLE, data.collect()),
        )
    }

    /// Adds a text.
    #[must_use]
    pub(crate) fn with_text(self, name: &str, text: &str) -> Self {
        let units: Vec<u16> = text.encode_utf16().collect();
        let data = units.iter().flat_map(|unit| unit.to_le_bytes());
        let data = (element::UINT16, data.collect());
        self.array(name, class::CHARACTERS, &[1, units.len()], data)
    }

    fn array(
        mut self,
        name: &str,
        class: u32,
        sizes: &[usize],
        (kind, data): (u32, Vec<u8>),
    ) -> Self {
        // A map has fewer than 2³¹ nodes.
        let sizes = sizes
            .iter()
            .map(|size| i32::try_from(*size).unwrap_or(i32::MAX));
        let mut array = Vec::new();
        let flags = [class, 0].into_iter().flat_map(u32::to_le_bytes);
        push(&mut array, element::UINT32, &flags.collect::<Vec<u8>>());
        let sizes = sizes.flat_map(i32::to_le_bytes);
        push(&mut array, element::INT32, &sizes.collect::<Vec<u8>>());
        push(&mut array, element::INT8, name.as_bytes());
        push(&mut array, kind, &data);
        push(&mut self.bytes, element::MATRIX, &array);
        self
    }

    /// The bytes of the file.
    #[must_use]
    pub fn bytes(self) -> Vec<u8> {
        self.bytes
    }
}

/// A data element: type, length and data, filled up to a multiple of eight bytes.
fn push(bytes: &mut Vec<u8>, kind: u32, data: &[u8]) {
    bytes.extend(kind.to_le_bytes());
    bytes.extend(u32::try_from(data.len()).unwrap_or(u32::MAX).to_le_bytes());
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
}

/// Rule for places where the efficiency has no number.
const FILLED: &str = "efficiency at torque 0: that of the next torque, the positive one first, and 0 without one; where the loss exceeds the torque: 0. No other value is filled in; at speed 0 the loss torque is that at 1 1/min";

/// Fields of a finish: arrays over torque, speed and, of several, temperature.
pub(super) fn of_fields(given: &ExportGiven<'_>) -> Result<Option<Vec<u8>>, Fault> {
    let fields = given.fields;
    let Some(first) = fields.first() else {
        return Ok(None);
    };
    let temperatures: Vec<f64> = fields.iter().map(|field| field.temperature_c).collect();
    let (torques, speeds) = (first.torque_nm.len(), first.speed_rpm.len());
    // An array of one temperature is a matrix.
    let sizes = [torques, speeds, temperatures.len()];
    let sizes = if temperatures.len() == 1 {
        &sizes[..2]
    } else {
        &sizes[..]
    };
    let array = |of: &dyn Fn(&Field) -> Vec<f64>| -> Vec<f64> {
        let columns = |values: Vec<f64>| {
            let at = move |k: usize| values[k % torques * speeds + k / torques];
            (0..torques * speeds).map(at)
        };
        fields.iter().flat_map(|field| columns(of(field))).collect()
    };
    let loss = |field: &Field| {
        let omega = field.omega();
        let total = field.total_nm().into_iter().enumerate();
        total.map(|(k, nm)| nm * omega[k % speeds]).collect()
    };
    // Programs read the text of such a file as ASCII.
    let head = Field::head_of(fields).replace("°C", "degC");
    let mut file = Mat5::new(&head)
        .with_text("scope", &first.scope)
        .with_text(
            "units",
            "torque N m, speed 1/min and rad/s, temperature degC, loss W, loss torque N m",
        )
        .with_text("head", &head)
        .with_text("beyond", Field::BEYOND)
        .with_text("filled", FILLED)
        .with("torque_nm", &[torques, 1], &first.torque_nm)
        .with("speed_rpm", &[1, speeds], &first.speed_rpm)
        .with("omega_rad_s", &[1, speeds], &first.omega())
        .with("temperature_c", &[1, temperatures.len()], &temperatures)
        .with("loss_torque_nm", sizes, &array(&Field::total_nm))
        .with("loss_w", sizes, &array(&loss))
        .with("efficiency", sizes, &array(&efficiencies));
    if first.added_nm.is_some() {
        let mesh = |field: &Field| field.mesh_nm.clone();
        let added = |field: &Field| field.added_nm.clone().unwrap_or_default();
        file = file.with("mesh_loss_torque_nm", sizes, &array(&mesh)).with(
            "added_loss_torque_nm",
            sizes,
            &array(&added),
        );
    }
    Ok(Some(file.bytes()))
}

/// Efficiency at the nodes, torque by torque, filled as [`FILLED`] says.
fn efficiencies(field: &Field) -> Vec<f64> {
    let (total, across) = (field.total_nm(), field.speed_rpm.len());
    let torques = &field.torque_nm;
    let next = |k: usize| match torques[k] == 0.0 {
        true if k + 1 < torques.len() => k + 1,
        true => k.saturating_sub(1),
        false => k,
    };
    let of = |index: usize| {
        let k = next(index / across);
        let (torque, loss) = (torques[k], total[k * across + index % across]);
        efficiency(torque, loss).unwrap_or(0.0)
    };
    (0..total.len()).map(of).collect()
}
