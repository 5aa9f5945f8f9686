//! A table in any dialect, made in memory.

use asperity_profile_io::read::{ReadError, ReadOptions, Reading, read_bytes};

pub const POINTS: usize = 240;

/// Height of point `i` in um: twelve um of span, not periodic in the rows.
pub fn height(i: usize) -> f64 {
    6.0 * (0.037 * i as f64).sin() + 0.01 * i as f64
}

/// A file of x and height: header, line end, separator, decimal sign, scale of x and z to um.
pub struct Dialect {
    pub header: &'static str,
    pub end: &'static str,
    pub between: &'static str,
    pub after: &'static str,
    pub decimal: char,
    pub x_per_um: f64,
    pub z_per_um: f64,
}

pub const PLAIN: Dialect = Dialect {
    header: "x in um,z in um",
    end: "\n",
    between: ",",
    after: "",
    decimal: '.',
    x_per_um: 1.0,
    z_per_um: 1.0,
};

impl Dialect {
    pub fn text(&self) -> String {
        let number = |value: f64| format!("{value:.9}").replace('.', &self.decimal.to_string());
        let mut text = String::new();
        if !self.header.is_empty() {
            text += &format!("{}{}", self.header, self.end);
        }
        for i in 0..POINTS {
            let (x, z) = (0.5 * i as f64 * self.x_per_um, height(i) * self.z_per_um);
            text += &format!(
                "{}{}{}{}{}",
                number(x),
                self.between,
                number(z),
                self.after,
                self.end
            );
        }
        text
    }
}

pub fn check(reading: &Reading) {
    assert_eq!(reading.points, POINTS);
    assert!(
        (reading.spacing.si() - 0.5e-6).abs() < 1e-15,
        "{}",
        reading.spacing
    );
    for (i, z) in reading.profile.heights().iter().enumerate() {
        // Nine decimals of a millimetre are a picometre.
        assert!((z - height(i) * 1e-6).abs() < 1e-12, "{i}");
    }
}

pub fn read_text(text: &str) -> Result<Reading, ReadError> {
    read_bytes("flank.csv", text.as_bytes(), &ReadOptions::default())
}
