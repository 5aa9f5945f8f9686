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
//! | C | (h̄_σ/h̄)² − 1, where h̄_σ is the mean film between ridges across the flow with the standard deviation σ = h̄ | - |
//!
//! Source: 194 steady solutions of this project's own solver (flooded, isothermal, Newtonian, Roelands' viscosity with the exponent 0.6,
//! Dowson and Higginson's density, α = 16/GPa, 2048 cells) for M from 0.1 to 1000 and L from 1 to 22, where the Hertz pressure is
//! below 3.5 GPa; beyond, K is that of the largest L below it. With α = 12 or 20/GPa K is within 1.3 % from M = 1 on and 2.1 % below, K_m
//! within 1.6 %, C within 2 %. Gears at full load have M from 7 to 75 and L from 3 to 10, where K is 0.97 to 1.12 and K_m 0.94 to 1.04. Below M = 1 the
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
/// Powers of 1/M of the factors below the lowest M: the contact is rigid there, with a film in proportion to 1/M.
const RIGID: [f64; 3] = [0.9, 0.87, 0.0];
/// Powers of 1/M of the factors above the highest M, as between the last solutions.
const HEAVY: [f64; 3] = [0.09, 0.07, 0.05];
/// C at which the rise is by Grubin's inlet: with it the mean gap of 60 recorded gear meshes is right in the mean.
const FULL_LOAD: f64 = 1.073;
/// K, K_m and C of the solutions, by M, then by L.
#[allow(
    clippy::approx_constant,
    reason = "solutions, some of which are near a constant"
)]
pub const FACTORS: [[[f64; 3]; MATERIALS.len()]; LOADS.len()] = [
    [
        [10.3001, 11.1147, 1.1413],
        [7.0385, 7.6665, 1.1419],
        [5.6497, 6.1768, 1.1425],
        [4.8434, 5.3033, 1.1431],
        [4.3045, 4.7148, 1.1437],
        [3.9135, 4.2850, 1.1443],
        [3.4889, 3.8150, 1.1452],
        [3.0965, 3.3771, 1.1464],
        [2.7599, 2.9980, 1.1479],
        [2.4063, 2.5958, 1.1502],
        [2.0820, 2.2226, 1.1536],
    ],
    [
        [6.4705, 7.0692, 1.1441],
        [4.4426, 4.8930, 1.1454],
        [3.5826, 3.9558, 1.1467],
        [3.0852, 3.4081, 1.1480],
        [2.7541, 3.0402, 1.1493],
        [2.5148, 2.7723, 1.1506],
        [2.2561, 2.4805, 1.1525],
        [2.0188, 2.2103, 1.1549],
        [1.8171, 1.9782, 1.1579],
        [1.6080, 1.7346, 1.1626],
        [1.4205, 1.5128, 1.1693],
    ],
    [
        [4.0215, 4.4265, 1.1525],
        [2.7883, 3.0887, 1.1553],
        [2.2700, 2.5170, 1.1582],
        [1.9714, 2.1855, 1.1607],
        [1.7758, 1.9646, 1.1633],
        [1.6359, 1.8052, 1.1660],
        [1.4867, 1.6333, 1.1699],
        [1.3512, 1.4766, 1.1746],
        [1.2402, 1.3447, 1.1806],
        [1.1290, 1.2110, 1.1892],
        [1.0369, 1.0959, 1.2009],
    ],
    [
        [2.7500, 3.0082, 1.1707],
        [1.9389, 2.1296, 1.1760],
        [1.6015, 1.7598, 1.1807],
        [1.4116, 1.5488, 1.1852],
        [1.2908, 1.4106, 1.1899],
        [1.2045, 1.3126, 1.1941],
        [1.1156, 1.2095, 1.2002],
        [1.0380, 1.1189, 1.2074],
        [0.9800, 1.0469, 1.2161],
        [0.9274, 0.9803, 1.2275],
        [0.8959, 0.9337, 1.2410],
    ],
    [
        [2.2565, 2.4147, 1.1917],
        [1.6119, 1.7348, 1.1980],
        [1.3531, 1.4538, 1.2044],
        [1.2081, 1.2965, 1.2100],
        [1.1187, 1.1958, 1.2156],
        [1.0553, 1.1261, 1.2203],
        [0.9937, 1.0552, 1.2273],
        [0.9453, 0.9964, 1.2355],
        [0.9112, 0.9540, 1.2438],
        [0.8892, 0.9220, 1.2530],
        [0.8905, 0.9112, 1.2567],
    ],
    [
        [1.9516, 2.0013, 1.2172],
        [1.4213, 1.4675, 1.2243],
        [1.2141, 1.2531, 1.2309],
        [1.1032, 1.1371, 1.2367],
        [1.0382, 1.0657, 1.2418],
        [0.9927, 1.0187, 1.2459],
        [0.9538, 0.9742, 1.2510],
        [0.9266, 0.9420, 1.2550],
        [0.9150, 0.9243, 1.2552],
        [0.9209, 0.9193, 1.2424],
        [0.9376, 0.9269, 1.2111],
    ],
    [
        [1.8109, 1.7631, 1.2352],
        [1.3481, 1.3220, 1.2407],
        [1.1736, 1.1516, 1.2449],
        [1.0861, 1.0637, 1.2473],
        [1.0353, 1.0126, 1.2481],
        [1.0026, 0.9813, 1.2472],
        [0.9795, 0.9548, 1.2418],
        [0.9670, 0.9390, 1.2286],
        [0.9645, 0.9327, 1.2072],
        [0.9677, 0.9325, 1.1806],
        [0.9800, 0.9411, 1.1523],
    ],
    [
        [1.7486, 1.6198, 1.2414],
        [1.3318, 1.2443, 1.2405],
        [1.1808, 1.1055, 1.2361],
        [1.1055, 1.0373, 1.2286],
        [1.0657, 0.9994, 1.2181],
        [1.0407, 0.9767, 1.2062],
        [1.0196, 0.9571, 1.1890],
        [1.0041, 0.9444, 1.1717],
        [0.9985, 0.9393, 1.1542],
        [0.9998, 0.9423, 1.1304],
        [1.0137, 0.9549, 1.1006],
    ],
    [
        [1.7022, 1.5417, 1.2372],
        [1.3220, 1.2066, 1.2253],
        [1.1834, 1.0850, 1.2106],
        [1.1159, 1.0251, 1.1958],
        [1.0754, 0.9913, 1.1832],
        [1.0516, 0.9710, 1.1719],
        [1.0311, 0.9544, 1.1567],
        [1.0198, 0.9456, 1.1379],
        [1.0169, 0.9445, 1.1173],
        [1.0220, 0.9516, 1.0908],
        [1.0382, 0.9680, 1.0591],
    ],
    [
        [1.6336, 1.4787, 1.2308],
        [1.2863, 1.1728, 1.2115],
        [1.1621, 1.0631, 1.1933],
        [1.1025, 1.0103, 1.1764],
        [1.0701, 0.9817, 1.1606],
        [1.0519, 0.9654, 1.1461],
        [1.0366, 0.9532, 1.1272],
        [1.0299, 0.9485, 1.1050],
        [1.0296, 0.9508, 1.0824],
        [1.0386, 0.9616, 1.0538],
        [1.0578, 0.9817, 1.0210],
    ],
    [
        [1.5649, 1.4292, 1.2274],
        [1.2498, 1.1464, 1.2018],
        [1.1409, 1.0468, 1.1783],
        [1.0896, 1.0000, 1.1574],
        [1.0629, 0.9755, 1.1385],
        [1.0477, 0.9622, 1.1221],
        [1.0379, 0.9534, 1.1000],
        [1.0349, 0.9518, 1.0761],
        [1.0388, 0.9570, 1.0507],
        [1.0507, 0.9709, 1.0204],
        [1.0719, 0.9943, 0.9884],
    ],
    [
        [1.4974, 1.3870, 1.2225],
        [1.2140, 1.1239, 1.1896],
        [1.1187, 1.0331, 1.1609],
        [1.0754, 0.9915, 1.1362],
        [1.0537, 0.9705, 1.1148],
        [1.0428, 0.9600, 1.0957],
        [1.0359, 0.9542, 1.0717],
        [1.0362, 0.9555, 1.0457],
        [1.0427, 0.9633, 1.0203],
        [1.0578, 0.9803, 0.9898],
        [1.0818, 1.0071, 0.9597],
    ],
    [
        [1.4301, 1.3471, 1.2149],
        [1.1762, 1.1025, 1.1738],
        [1.0931, 1.0200, 1.1399],
        [1.0569, 0.9834, 1.1119],
        [1.0399, 0.9660, 1.0883],
        [1.0320, 0.9580, 1.0687],
        [1.0287, 0.9552, 1.0444],
        [1.0320, 0.9595, 1.0189],
        [1.0414, 0.9699, 0.9945],
        [1.0597, 0.9899, 0.9664],
        [1.0873, 1.0202, 0.9389],
    ],
    [
        [1.3588, 1.3048, 1.2020],
        [1.1342, 1.0796, 1.1516],
        [1.0631, 1.0058, 1.1131],
        [1.0339, 0.9745, 1.0830],
        [1.0213, 0.9608, 1.0588],
        [1.0166, 0.9557, 1.0388],
        [1.0172, 0.9561, 1.0147],
        [1.0241, 0.9635, 0.9902],
        [1.0366, 0.9769, 0.9675],
        [1.0583, 1.0005, 0.9421],
        [1.0897, 1.0341, 0.9180],
    ],
    [
        [1.2951, 1.2650, 1.1834],
        [1.0950, 1.0576, 1.1240],
        [1.0340, 0.9918, 1.0821],
        [1.0104, 0.9655, 1.0510],
        [1.0015, 0.9553, 1.0268],
        [0.9996, 0.9528, 1.0075],
        [1.0031, 0.9562, 0.9849],
        [1.0129, 0.9665, 0.9626],
        [1.0280, 0.9827, 0.9424],
        [1.0531, 1.0095, 0.9205],
        [1.0879, 1.0471, 0.9000],
    ],
    [
        [1.2280, 1.2213, 1.1543],
        [1.0514, 1.0329, 1.0865],
        [1.0001, 0.9757, 1.0430],
        [0.9818, 0.9547, 1.0127],
        [0.9765, 0.9481, 0.9902],
        [0.9771, 0.9483, 0.9728],
        [0.9835, 0.9548, 0.9529],
        [0.9961, 0.9682, 0.9339],
        [1.0138, 0.9870, 0.9171],
        [1.0420, 1.0169, 0.8993],
        [1.0420, 1.0169, 0.8993],
    ],
    [
        [1.1609, 1.1771, 1.1163],
        [1.0056, 1.0067, 1.0437],
        [0.9628, 0.9582, 1.0019],
        [0.9494, 0.9421, 0.9745],
        [0.9474, 0.9392, 0.9550],
        [0.9505, 0.9420, 0.9403],
        [0.9596, 0.9515, 0.9240],
        [0.9748, 0.9676, 0.9087],
        [0.9748, 0.9676, 0.9087],
        [0.9748, 0.9676, 0.9087],
        [0.9748, 0.9676, 0.9087],
    ],
    [
        [1.0882, 1.1222, 1.0683],
        [0.9537, 0.9781, 0.9969],
        [0.9196, 0.9372, 0.9602],
        [0.9113, 0.9255, 0.9376],
        [0.9127, 0.9262, 0.9221],
        [0.9183, 0.9314, 0.9107],
        [0.9300, 0.9427, 0.8983],
        [0.9300, 0.9427, 0.8983],
        [0.9300, 0.9427, 0.8983],
        [0.9300, 0.9427, 0.8983],
        [0.9300, 0.9427, 0.8983],
    ],
    [
        [0.9780, 1.0406, 0.9971],
        [0.8730, 0.9221, 0.9368],
        [0.8521, 0.8952, 0.9101],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
        [0.8517, 0.8911, 0.8948],
    ],
];

/// K, K_m and C.
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
/// // Roughness widens the gap most where a contact begins to be elastic.
/// assert!(at(1.4, 6.0)[2] > at(0.2, 6.0)[2] && at(1.4, 6.0)[2] > at(10.0, 6.0)[2]);
/// ```
#[must_use]
pub fn factors(numbers: &MoesNumbers) -> [f64; 3] {
    let (loads, materials) = (LOADS.map(f64::ln), MATERIALS.map(f64::ln));
    let within = |at: f64, nodes: &[f64]| at.ln().clamp(nodes[0], nodes[nodes.len() - 1]);
    let load = within(numbers.load, &loads);
    let material = within(numbers.material, &materials);
    let [below, above] = [LOADS[0], LOADS[LOADS.len() - 1]].map(|end| end / numbers.load);
    std::array::from_fn(|k| {
        let of_row = |row: &[[f64; 3]; MATERIALS.len()]| {
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
    let [middle, least, _] = factors(&MoesNumbers::from_groups(groups)?);
    Ok([
        film_line::dowson_toyoda(groups, radius)? * middle,
        film_line::dowson_higginson(groups, radius)? * least,
    ])
}

/// Square of the rise of the mean gap with roughness across the flow, over that at full load.
///
/// ```text
/// f = C(M, L)/1.073,  Ψ by σ_d √f                                          [Flow-rise]
/// ```
///
/// Ridges raise the gap by the flow ⟨h⁻³⟩ = h⁻³ (1 + 6 σ²/h²). Where they do so only in an inlet before a stiff contact, which Grubin's Ψ
/// describes, it is less than where oil is still displaced inside of the contact: f is 1.18 at M = 1, 1.07 in the rigid contact and .87
/// to 1.08 at full load. For a small σ the solutions range from 1.6 to 2.9 for Grubin's 2.34. But Ψ is needed for σ_d of .5 to 3 times
/// the film, where the solutions rise less than the records: C is for σ = h̄, and only its ratio is taken.
///
/// ```
/// use asperity_ehl_regime::{MoesNumbers, steady_film::flow_rise};
/// let at = |load, material| flow_rise(&MoesNumbers { load, material });
/// assert!((at(1.2, 5.0) - 1.17).abs() < 0.01 && (at(15.0, 7.0) - 0.98).abs() < 0.02);
/// ```
#[must_use]
pub fn flow_rise(numbers: &MoesNumbers) -> f64 {
    cite!("Flow-rise");
    factors(numbers)[2] / FULL_LOAD
}
