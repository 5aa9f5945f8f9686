//! A pair of helical gears (module 1.3 mm, 50/120 teeth, 285 N m, 3000 1/min, oil of 97.5 mPa s)
//! at four positions of the path of contact: its start A, midway to the pitch point, the pitch
//! point C and its end E. The numbers were computed independently
//! by `references/table_2.py`.

use asperity_core::quantity::{
    DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, Speed,
};
use asperity_ehl_regime::FilmConditions;

/// One position of the reference case.
pub struct Position {
    pub radius_mm: f64,
    pub entrainment: f64,
    pub slide_to_roll: f64,
    pub max_pressure_mpa: f64,
    pub speed_group: f64,
    pub load_group: f64,
    /// Dowson–Toyoda, Dowson–Higginson, Ertel–Grubin, Moes [um].
    pub line_films: [f64; 4],
    /// Hamrock–Dowson central and minimum with W = F/(E′R²), then with W = w/(E′R) [um].
    pub hamrock_dowson: [f64; 4],
    pub loading: f64,
    pub gupta: f64,
    pub film_factor: f64,
    pub effective_film: f64,
    pub lambda_star: f64,
    pub film_ratio: f64,
}

pub const POSITIONS: [Position; 4] = [
    Position {
        radius_mm: 9.88114442093857,
        entrainment: 4.27194395222793,
        slide_to_roll: -0.3365081109091261,
        max_pressure_mpa: 649.2606732949997,
        speed_group: 1.826606557831143e-10,
        load_group: 4.973501567089581e-05,
        line_films: [
            1.7512733104048184,
            1.3781954153501685,
            1.8133968650235743,
            1.7519754254019875,
        ],
        hamrock_dowson: [
            1.2107001470499321,
            0.979115947578053,
            1.3496324133497786,
            1.1021431495065106,
        ],
        loading: 0.5931089167567454,
        gupta: 0.751983751105238,
        film_factor: 0.11868871760134664,
        effective_film: 1.122812395431171,
        lambda_star: 3.74270798477057,
        film_ratio: 2.8536476132085244,
    },
    Position {
        radius_mm: 10.813777298688333,
        entrainment: 4.419926401123771,
        slide_to_roll: -0.16262078356196025,
        max_pressure_mpa: 620.6317804397543,
        speed_group: 1.726888628177412e-10,
        load_group: 4.544562543204713e-05,
        line_films: [
            1.8604519148646188,
            1.4672584523318013,
            1.920846029689943,
            1.8563516931535418,
        ],
        hamrock_dowson: [
            1.2915776329782156,
            1.045067350369874,
            1.4311165975468483,
            1.1686615037921646,
        ],
        loading: 0.6349118552189051,
        gupta: 0.7841148370500348,
        film_factor: 0.113824165896474,
        effective_film: 1.1920800971341616,
        lambda_star: 3.973600323780539,
        film_ratio: 3.0442776756925536,
    },
    Position {
        radius_mm: 11.626875546138667,
        entrainment: 4.567908850019612,
        slide_to_roll: 0.0,
        max_pressure_mpa: 598.5372850278331,
        speed_group: 1.6598969185442323e-10,
        load_group: 4.226749230019696e-05,
        line_films: [
            1.9606324979656662,
            1.549020278111008,
            2.019963879366083,
            1.9521425571875857,
        ],
        hamrock_dowson: [
            1.3655651893545255,
            1.1054578724655595,
            1.5057657171300651,
            1.2296689485439773,
        ],
        loading: 0.6781382160178435,
        gupta: 0.8326042429690769,
        film_factor: 0.11005889723157815,
        effective_film: 1.2557504713037497,
        lambda_star: 4.185834904345833,
        film_ratio: 3.218668018482923,
    },
    Position {
        radius_mm: 12.848111791664245,
        entrainment: 4.850671269098024,
        slide_to_roll: 0.2831396703472197,
        max_pressure_mpa: 569.3811272200243,
        speed_group: 1.5951049029037528e-10,
        load_group: 3.824989076921064e-05,
        line_films: [
            2.1290149873146325,
            1.6864287395793196,
            2.1882013436588763,
            2.1132984934288515,
        ],
        hamrock_dowson: [
            1.489071632186425,
            1.2064044940215657,
            1.6310014488928328,
            1.332209380268191,
        ],
        loading: 0.7646928822277236,
        gupta: 0.7356620904650241,
        film_factor: 0.10507479749004248,
        effective_film: 1.3628683942217212,
        lambda_star: 4.5428946474057375,
        film_ratio: 3.5097754959718053,
    },
];

/// E* of steel on steel (210 GPa, 0.3).
pub const MODULUS: Pressure = Pressure::from_si(210e9 / (2.0 * 0.91));
pub const OIL: DynamicViscosity = DynamicViscosity::from_si(0.0975);

pub fn conditions(position: &Position) -> FilmConditions {
    FilmConditions {
        entrainment: Speed::from_si(position.entrainment),
        radius: Length::from_si(position.radius_mm * 1e-3),
        load: LineLoad::from_si(113_408.970_605_022_6),
        modulus: MODULUS,
        viscosity: OIL,
        pressure_viscosity: PressureViscosity::from_si(2e-8),
        contact_length: Some(Length::from_si(0.05)),
    }
}
