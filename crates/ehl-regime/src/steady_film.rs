//! Smooth film of a line contact from steady solutions: the formula of Dowson and Toyoda and that of Dowson and Higginson, each with a
//! factor that depends on Moes' numbers.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | M, L | Moes' load and material number | - |
//! | h̄, h_m | mean film in the middle .8 of the Hertz contact, and minimum film | m |
//! | h_DT, h_DH | films of Dowson and Toyoda and of Dowson and Higginson | m |
//! | ρ̄ | density under Hertz's largest pressure over the ambient one | - |
//! | K, K_m | h̄ ρ̄/h_DT and h_m/h_DH | - |
//!
//! Source: 194 steady solutions of this project's own solver (flooded, isothermal, Newtonian, Roelands' viscosity with the exponent 0.6,
//! Dowson and Higginson's density, α = 16/GPa, 2048 cells) for M from 0.1 to 1000 and L from 1 to 22, where the Hertz pressure is
//! below 3.5 GPa; beyond, K is that of the largest L below it. With α = 12 or 20/GPa K is within 1.3 % from M = 1 on and 2.1 % below, K_m
//! within 1.6 %. Gears at full load have M from 7 to 75 and L from 3 to 10, where K is 0.97 to 1.12 and K_m 0.94 to 1.04. Below M = 1 the
//! formulas, which are powers, are up to 12 % too thick at large L and give half the film at small L.

use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::attenuation::MoesNumbers;
use crate::dimensionless::FilmGroups;
use crate::error::RegimeError;
use crate::film_line;
use crate::light_load::cubic;

/// M of the solutions.
pub const LOADS: [f64; 19] = [
    0.1, 0.17, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 12.0, 20.0, 35.0, 70.0, 150.0,
    350.0, 1000.0,
];
/// L of the solutions.
pub const MATERIALS: [f64; 11] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.5, 9.5, 12.0, 16.0, 22.0];
/// Powers of 1/M of both factors below the lowest M: the contact is rigid there, with a film in proportion to 1/M.
const RIGID: [f64; 2] = [0.9, 0.87];
/// Powers of 1/M of both factors above the highest M, as between the last solutions.
const HEAVY: [f64; 2] = [0.09, 0.07];
/// K and K_m of the solutions, by M, then by L.
#[allow(
    clippy::approx_constant,
    reason = "solutions, some of which are near a constant"
)]
pub const FACTORS: [[[f64; 2]; MATERIALS.len()]; LOADS.len()] = [
    [
        [10.3001, 11.1147],
        [7.0385, 7.6665],
        [5.6497, 6.1768],
        [4.8434, 5.3033],
        [4.3045, 4.7148],
        [3.9135, 4.2850],
        [3.4889, 3.8150],
        [3.0965, 3.3771],
        [2.7599, 2.9980],
        [2.4063, 2.5958],
        [2.0820, 2.2226],
    ],
    [
        [6.4705, 7.0692],
        [4.4426, 4.8930],
        [3.5826, 3.9558],
        [3.0852, 3.4081],
        [2.7541, 3.0402],
        [2.5148, 2.7723],
        [2.2561, 2.4805],
        [2.0188, 2.2103],
        [1.8171, 1.9782],
        [1.6080, 1.7346],
        [1.4205, 1.5128],
    ],
    [
        [4.0215, 4.4265],
        [2.7883, 3.0887],
        [2.2700, 2.5170],
        [1.9714, 2.1855],
        [1.7758, 1.9646],
        [1.6359, 1.8052],
        [1.4867, 1.6333],
        [1.3512, 1.4766],
        [1.2402, 1.3447],
        [1.1290, 1.2110],
        [1.0369, 1.0959],
    ],
    [
        [2.7500, 3.0082],
        [1.9389, 2.1296],
        [1.6015, 1.7598],
        [1.4116, 1.5488],
        [1.2908, 1.4106],
        [1.2045, 1.3126],
        [1.1156, 1.2095],
        [1.0380, 1.1189],
        [0.9800, 1.0469],
        [0.9274, 0.9803],
        [0.8959, 0.9337],
    ],
    [
        [2.2565, 2.4147],
        [1.6119, 1.7348],
        [1.3531, 1.4538],
        [1.2081, 1.2965],
        [1.1187, 1.1958],
        [1.0553, 1.1261],
        [0.9937, 1.0552],
        [0.9453, 0.9964],
        [0.9112, 0.9540],
        [0.8892, 0.9220],
        [0.8905, 0.9112],
    ],
    [
        [1.9516, 2.0013],
        [1.4213, 1.4675],
        [1.2141, 1.2531],
        [1.1032, 1.1371],
        [1.0382, 1.0657],
        [0.9927, 1.0187],
        [0.9538, 0.9742],
        [0.9266, 0.9420],
        [0.9150, 0.9243],
        [0.9209, 0.9193],
        [0.9376, 0.9269],
    ],
    [
        [1.8109, 1.7631],
        [1.3481, 1.3220],
        [1.1736, 1.1516],
        [1.0861, 1.0637],
        [1.0353, 1.0126],
        [1.0026, 0.9813],
        [0.9795, 0.9548],
        [0.9670, 0.9390],
        [0.9645, 0.9327],
        [0.9677, 0.9325],
        [0.9800, 0.9411],
    ],
    [
        [1.7486, 1.6198],
        [1.3318, 1.2443],
        [1.1808, 1.1055],
        [1.1055, 1.0373],
        [1.0657, 0.9994],
        [1.0407, 0.9767],
        [1.0196, 0.9571],
        [1.0041, 0.9444],
        [0.9985, 0.9393],
        [0.9998, 0.9423],
        [1.0137, 0.9549],
    ],
    [
        [1.7022, 1.5417],
        [1.3220, 1.2066],
        [1.1834, 1.0850],
        [1.1159, 1.0251],
        [1.0754, 0.9913],
        [1.0516, 0.9710],
        [1.0311, 0.9544],
        [1.0198, 0.9456],
        [1.0169, 0.9445],
        [1.0220, 0.9516],
        [1.0382, 0.9680],
    ],
    [
        [1.6336, 1.4787],
        [1.2863, 1.1728],
        [1.1621, 1.0631],
        [1.1025, 1.0103],
        [1.0701, 0.9817],
        [1.0519, 0.9654],
        [1.0366, 0.9532],
        [1.0299, 0.9485],
        [1.0296, 0.9508],
        [1.0386, 0.9616],
        [1.0578, 0.9817],
    ],
    [
        [1.5649, 1.4292],
        [1.2498, 1.1464],
        [1.1409, 1.0468],
        [1.0896, 1.0000],
        [1.0629, 0.9755],
        [1.0477, 0.9622],
        [1.0379, 0.9534],
        [1.0349, 0.9518],
        [1.0388, 0.9570],
        [1.0507, 0.9709],
        [1.0719, 0.9943],
    ],
    [
        [1.4974, 1.3870],
        [1.2140, 1.1239],
        [1.1187, 1.0331],
        [1.0754, 0.9915],
        [1.0537, 0.9705],
        [1.0428, 0.9600],
        [1.0359, 0.9542],
        [1.0362, 0.9555],
        [1.0427, 0.9633],
        [1.0578, 0.9803],
        [1.0818, 1.0071],
    ],
    [
        [1.4301, 1.3471],
        [1.1762, 1.1025],
        [1.0931, 1.0200],
        [1.0569, 0.9834],
        [1.0399, 0.9660],
        [1.0320, 0.9580],
        [1.0287, 0.9552],
        [1.0320, 0.9595],
        [1.0414, 0.9699],
        [1.0597, 0.9899],
        [1.0873, 1.0202],
    ],
    [
        [1.3588, 1.3048],
        [1.1342, 1.0796],
        [1.0631, 1.0058],
        [1.0339, 0.9745],
        [1.0213, 0.9608],
        [1.0166, 0.9557],
        [1.0172, 0.9561],
        [1.0241, 0.9635],
        [1.0366, 0.9769],
        [1.0583, 1.0005],
        [1.0897, 1.0341],
    ],
    [
        [1.2951, 1.2650],
        [1.0950, 1.0576],
        [1.0340, 0.9918],
        [1.0104, 0.9655],
        [1.0015, 0.9553],
        [0.9996, 0.9528],
        [1.0031, 0.9562],
        [1.0129, 0.9665],
        [1.0280, 0.9827],
        [1.0531, 1.0095],
        [1.0879, 1.0471],
    ],
    [
        [1.2280, 1.2213],
        [1.0514, 1.0329],
        [1.0001, 0.9757],
        [0.9818, 0.9547],
        [0.9765, 0.9481],
        [0.9771, 0.9483],
        [0.9835, 0.9548],
        [0.9961, 0.9682],
        [1.0138, 0.9870],
        [1.0420, 1.0169],
        [1.0420, 1.0169],
    ],
    [
        [1.1609, 1.1771],
        [1.0056, 1.0067],
        [0.9628, 0.9582],
        [0.9494, 0.9421],
        [0.9474, 0.9392],
        [0.9505, 0.9420],
        [0.9596, 0.9515],
        [0.9748, 0.9676],
        [0.9748, 0.9676],
        [0.9748, 0.9676],
        [0.9748, 0.9676],
    ],
    [
        [1.0882, 1.1222],
        [0.9537, 0.9781],
        [0.9196, 0.9372],
        [0.9113, 0.9255],
        [0.9127, 0.9262],
        [0.9183, 0.9314],
        [0.9300, 0.9427],
        [0.9300, 0.9427],
        [0.9300, 0.9427],
        [0.9300, 0.9427],
        [0.9300, 0.9427],
    ],
    [
        [0.9780, 1.0406],
        [0.8730, 0.9221],
        [0.8521, 0.8952],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
        [0.8517, 0.8911],
    ],
];

/// K and K_m.
///
/// The logarithms are interpolated by cubics in ln M and ln L between the solutions. Beyond them they are powers of M, and do not depend
/// on L.
///
/// ```
/// use asperity_ehl_regime::{MoesNumbers, steady_film::factors};
/// let at = |load, material| factors(&MoesNumbers { load, material });
/// assert!((at(1.0, 1.0)[0] - 1.9516).abs() < 1e-12);
/// // Next to 1 at full load.
/// assert!(at(30.0, 6.0).iter().all(|factor| (factor - 1.0).abs() < 0.06));
/// ```
#[must_use]
pub fn factors(numbers: &MoesNumbers) -> [f64; 2] {
    let (loads, materials) = (LOADS.map(f64::ln), MATERIALS.map(f64::ln));
    let within = |at: f64, nodes: &[f64]| at.ln().clamp(nodes[0], nodes[nodes.len() - 1]);
    let load = within(numbers.load, &loads);
    let material = within(numbers.material, &materials);
    let [below, above] = [LOADS[0], LOADS[LOADS.len() - 1]].map(|end| end / numbers.load);
    std::array::from_fn(|k| {
        let of_row = |row: &[[f64; 2]; MATERIALS.len()]| {
            cubic(&materials, &row.map(|factors| factors[k].ln()), material)
        };
        let factor = cubic(&loads, &FACTORS.each_ref().map(of_row), load).exp();
        factor * below.max(1.0).powf(RIGID[k]) * above.min(1.0).powf(HEAVY[k])
    })
}

/// Film in the middle, as thick as it is before it is compressed to ρ̄, and minimum film of a line contact.
///
/// ```text
/// h_c = h̄ ρ̄ = K(M, L) h_DT,  h_m = K_m(M, L) h_DH                         [Steady-film]
/// ```
///
/// # Errors
/// When a group or the radius is not finite and positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_line::dowson_toyoda, steady_film::steady_film};
/// // M = 23, L = 19.7
/// let groups = FilmGroups { material: 4615.38, speed: 1.6599e-10, load: 4.22675e-4 };
/// let radius = Length::from_si(11.6269e-3);
/// let [middle, least] = steady_film(&groups, radius)?;
/// assert!((middle.si() / dowson_toyoda(&groups, radius)?.si() - 1.075).abs() < 0.01 && least < middle);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn steady_film(groups: &FilmGroups, radius: Length) -> Result<[Length; 2], RegimeError> {
    cite!("Steady-film");
    let [middle, least] = factors(&MoesNumbers::of(groups)?);
    Ok([
        film_line::dowson_toyoda(groups, radius)? * middle,
        film_line::dowson_higginson(groups, radius)? * least,
    ])
}
