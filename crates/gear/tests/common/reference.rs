//! The reference pairs of the load map and their values.

#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each test and bench uses a part, and may panic"
)]

use asperity_core::material::Material;
use asperity_core::quantity::{
    Angle, Density, Length, Pressure, SpecificHeat, ThermalConductivity, Torque,
};
use asperity_gear::{
    AmountDirection, GearPair, GearPairInput, LoadLaw, LoadMap, LoadMapSettings, MicroGeometry,
    ReliefShape,
};
use serde_json::Value;

/// The steel of the reference values.
pub fn steel() -> Material {
    Material {
        young: Pressure::from_si(206e9),
        poisson: 0.3,
        elastic_limit: Pressure::from_si(1e9),
        density: Density::from_si(7850.0),
        conductivity: ThermalConductivity::from_si(45.0),
        heat_capacity: SpecificHeat::from_si(460.0),
    }
}

/// `tests/golden/load_map.json`.
pub struct Golden(Value);

pub fn golden() -> Golden {
    Golden(serde_json::from_str(include_str!("../golden/load_map.json")).unwrap())
}

impl Golden {
    pub fn rows(&self, key: &str) -> Vec<Row> {
        let rows = self.0[key].as_array().unwrap();
        rows.iter().cloned().map(Row).collect()
    }

    pub fn cases(&self) -> Vec<Case> {
        self.rows("cases").into_iter().map(Case::new).collect()
    }

    pub fn rings(&self) -> Vec<Case> {
        self.rows("ring").into_iter().map(Case::new).collect()
    }

    pub fn case(&self, name: &str) -> Case {
        self.cases()
            .into_iter()
            .find(|case| case.name == name)
            .unwrap()
    }
}

/// A row of values by name or place.
#[derive(Clone)]
pub struct Row(pub Value);

impl Row {
    pub fn number(&self, key: &str) -> f64 {
        self.0[key].as_f64().unwrap()
    }

    pub fn at(&self, index: usize) -> f64 {
        self.0[index].as_f64().unwrap()
    }

    pub fn text(&self, index: usize) -> &str {
        self.0[index].as_str().unwrap()
    }

    pub fn numbers(&self, key: &str) -> Vec<f64> {
        let values = self.0[key].as_array().unwrap();
        values.iter().map(|value| value.as_f64().unwrap()).collect()
    }
}

/// A reference pair.
#[derive(Clone)]
pub struct Case {
    pub name: String,
    pub input: GearPairInput,
    pub internal: bool,
    pub torque: f64,
    pub row: Row,
}

impl Case {
    fn new(row: Row) -> Self {
        let optional = |key: &str| row.0[key].as_array().is_some();
        let pair = |key: &str| -> [f64; 2] { row.numbers(key).try_into().unwrap() };
        let number = |key: &str, default: f64| row.0[key].as_f64().unwrap_or(default);
        let input = GearPairInput {
            profile_shift: Some(if optional("shift") {
                pair("shift")
            } else {
                [0.0; 2]
            }),
            tip_radius: optional("tip_radius").then(|| pair("tip_radius").map(Length::from_si)),
            ..GearPairInput::standard(
                pair("teeth").map(|z| z as u32),
                Length::from_si(number("module", 1.5e-3)),
                Angle::from_si(row.number("helix").to_radians()),
                Length::from_si(number("width", 20e-3)),
            )
        };
        Self {
            name: row.0["name"].as_str().unwrap().to_owned(),
            input,
            internal: row.0["internal"].as_bool().unwrap_or(false),
            torque: number("torque", 40.0),
            row,
        }
    }

    pub fn pair(&self) -> GearPair {
        if self.internal {
            GearPair::internal(&self.input).unwrap()
        } else {
            GearPair::new(&self.input).unwrap()
        }
    }

    pub fn torque(&self) -> Torque {
        Torque::from_si(self.torque)
    }

    pub fn map(&self, law: &LoadLaw, micro: &MicroGeometry, settings: &LoadMapSettings) -> LoadMap {
        map(&self.pair(), self.torque, law, micro, settings)
    }

    pub fn elastic(&self, micro: &MicroGeometry) -> LoadMap {
        self.map(&LoadLaw::Elastic, micro, &LoadMapSettings::default())
    }

    /// Roll length of the double contact of a spur pair with this ε_α.
    pub fn double_contact(&self) -> f64 {
        let pair = self.pair();
        (pair.path().eps_alpha - 1.0) * pair.path().base_pitch.si()
    }
}

pub fn map(
    pair: &GearPair,
    torque: f64,
    law: &LoadLaw,
    micro: &MicroGeometry,
    settings: &LoadMapSettings,
) -> LoadMap {
    let torque = Torque::from_si(torque);
    LoadMap::new(pair, torque, law, micro, &[steel(); 2], settings).unwrap()
}

/// Tip relief of both gears with the amount normal to the flank, as in the reference values.
pub fn relief(amount: f64, length: f64, squared: bool) -> MicroGeometry {
    let shape = if squared {
        ReliefShape::Parabolic
    } else {
        ReliefShape::Linear
    };
    MicroGeometry {
        direction: AmountDirection::Normal,
        ..MicroGeometry::tip_relief(Length::from_si(amount), Length::from_si(length), shape)
    }
}

pub fn unmodified() -> MicroGeometry {
    MicroGeometry::default()
}

pub fn cells(count: usize) -> LoadMapSettings {
    LoadMapSettings {
        cells: Some(count),
        ..LoadMapSettings::default()
    }
}
