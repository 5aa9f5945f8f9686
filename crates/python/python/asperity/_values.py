"""Values of results by name.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Optional

from numpy.typing import NDArray

from ._quantity import Floats
from ._record import Rows, Table, Values

if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Union, overload


ParameterName = Literal[
    "ra_um", "rq_um", "rz_um", "rp_um", "rv_um", "rt_um", "rsk", "rku", "rk_um", "rpk_um", "rvk_um", "rc_um", "rdq",
    "rsm_um", "rz1max_um", "sections", "mr1_percent", "mr2_percent", "bandwidth", "m0_um2", "m2", "m4_per_um2",
    "section_um",
]


class UncertaintyPart(Values):
    """Values of `UncertaintyPart` in Rust."""

    _absent = {"name": "", "about": None, "remedy": ""}
    name: str
    about: Optional[Literal["pressure-viscosity", "tip-relief", "fast-model", "sampling", "lay"]]
    sd_ln: float
    quantiles_w: Floats
    remedy: str


class LossDistribution(Values):
    """Values of `LossDistribution` in Rust."""

    _kinds = {"parts": Table}
    _absent = {"parts": []}
    median_w: float
    quantiles_w: Floats
    sd_ln: float
    parts: Table


class DrawnConstant(Values):
    """Values of `DrawnConstant` in Rust."""

    _absent = {"name": "", "unit": "", "is_calibrated": False}
    name: str
    value: float
    low: float
    high: float
    unit: str
    is_calibrated: bool


class AlternativeRow(Values):
    """Values of `AlternativeRow` in Rust."""

    _absent = {"name": "", "loss_w": None, "refuted_by": ""}
    name: str
    loss_w: Optional[float]
    refuted_by: str


class EvidenceRow(Values):
    """Values of `EvidenceRow` in Rust."""

    _absent = {"key": "", "measurement": ""}
    key: str
    measurement: str
    hours: float
    low_w: float
    high_w: float
    sd_ln: float
    width: float


class Uncertainty(Values):
    """Values of `Uncertainty` in Rust."""

    _kinds = {"loss": LossDistribution, "constants": Table, "structures": Table, "other_models": Table, "evidence": Table}
    _absent = {"constants": [], "held": [], "roughness_over_film": None, "boundary_w": None, "structures": [], "other_models": [], "with_traces_w": None, "path_sliding_w_per_m": [], "evidence": []}
    loss: LossDistribution
    at_medians_w: float
    efficiency_median: float
    efficiency_quantiles: Floats
    constants: Table
    held: list[str]
    draws: int
    beyond_power: int
    evaluations: int
    interpolation_error: float
    roughness_over_film: Optional[float]
    sampling: Any
    boundary_w: Optional[Floats]
    structures: Table
    other_models: Table
    trust: Literal["solved-contact", "share-formula", "surrogates", "roughness-values"]
    with_traces_w: Optional[Floats]
    path_sliding_w_per_m: list[Any]
    evidence: Table


class SummaryValues(Values):
    """Values of `Summary` in Rust."""

    _absent = {"gearbox_efficiency": None, "gearbox_loss_w": None, "efficiency_deviation": None, "asperity_share_standard_error": None, "regime": None}
    scope: Literal["mesh", "gearbox"]
    gearbox_efficiency: Optional[float]
    gearbox_loss_w: Optional[float]
    efficiency: float
    efficiency_deviation: Optional[float]
    offsets: int
    power_in_w: float
    torque_out_nm: float
    loss_w: float
    sliding_w: float
    film_w: float
    lubricated_asperity_w: float
    boundary_w: float
    rolling_w: float
    deformation_w: Floats
    deformation_in_contact_w: Floats
    hysteresis_w: float
    elastic_cycling_w: float
    asperity_share: float
    asperity_share_standard_error: Optional[float]
    boundary_share: float
    mu_equivalent: float
    loss_factor: float
    loss_factor_local: float
    mixed_share: float
    regime: Optional[Literal["full-film", "mixed", "boundary"]]
    positions: int
    worst_load_error: float
    worst_duality_gap: float


class FullFilmRow(Values):
    """Values of `FullFilmRow` in Rust."""

    _absent = {"mu": None, "mu_deviation": None}
    film_central_um: float
    film_minimum_um: float
    p_max_mpa: float
    mu: Optional[float]
    film_central_deviation: float
    film_minimum_deviation: float
    mu_deviation: Optional[float]


class PathRow(Values):
    """Values of `PositionRow` in Rust."""

    _kinds = {"full_film": FullFilmRow}
    _absent = {"lambda_star": None, "film_ratio": None, "film_share_standard_error": None, "boundary_of_asperities": None, "mean_gap_um": None, "roughness_over_film": None, "full_film": None, "flash_max_k": None, "sliding_deviation_w_per_m": None, "sliding_standard_error_w_per_m": None, "sliding_error_freedom": None, "face_zone": None, "contact_fraction": None, "p_max_mpa": None, "plastic_work_j_per_m": None, "von_mises_max_mpa": None, "von_mises_depth_um": None, "yield_depth_um": None, "yield_share": None}
    position: int
    s_mm: float
    path_fraction: float
    weight_m: float
    line_load_n_per_mm: float
    sliding_load_n_per_mm: float
    load_share: float
    radius_mm: float
    u1_m_per_s: float
    u2_m_per_s: float
    sliding_m_per_s: float
    entrainment_m_per_s: float
    slide_to_roll: float
    half_width_um: float
    hertz_pressure_mpa: float
    thermal_reduction: float
    film_central_um: float
    film_minimum_um: float
    lambda_star: Optional[float]
    film_ratio: Optional[float]
    mixed_share: float
    regime: Literal["full-film", "mixed", "boundary"]
    film_share: float
    film_share_standard_error: Optional[float]
    boundary_of_asperities: Optional[float]
    boundary_share: float
    mean_gap_um: Optional[float]
    roughness_over_film: Optional[float]
    full_film: Optional[FullFilmRow]
    mu_film: float
    mu: float
    flash_k: float
    flash_max_k: Optional[float]
    sliding_w_per_m: float
    sliding_deviation_w_per_m: Optional[float]
    sliding_standard_error_w_per_m: Optional[float]
    sliding_error_freedom: Optional[float]
    face_zone: Optional[int]
    film_w_per_m: float
    lubricated_asperity_w_per_m: float
    boundary_w_per_m: float
    rolling_w_per_m: float
    contact_fraction: Optional[float]
    p_max_mpa: Optional[float]
    plastic_work_j_per_m: Optional[float]
    von_mises_max_mpa: Optional[float]
    von_mises_depth_um: Optional[float]
    yield_depth_um: Optional[float]
    yield_share: Optional[float]
    iterations: int
    load_error: float


class ContactCertificate(Values):
    """Values of `ContactCertificate` in Rust."""

    duality_gap: float
    penetration: float
    load_error: float
    reference_gap_m: float


class ContactNote(Values):
    """Values of `ContactNote` in Rust."""

    _absent = {"code": "", "text": ""}
    code: str
    text: str


class RunningInCycle(Values):
    """Values of `RunningInCycle` in Rust."""

    plastic_energy_j_per_m: float
    largest_flow_m: float
    contact_fraction: float
    rq_first_m: float
    rq_second_m: float
    peak_first_m: float
    peak_second_m: float


class ContactNumbers(Values):
    """Values of `ContactNumbers` in Rust."""

    _kinds = {"certificate": ContactCertificate, "warnings": Table, "running_in": Table}
    _absent = {"warnings": [], "path_fraction": None, "hertz_p_max_pa": None, "hertz_half_width_m": None, "running_in": None}
    points: int
    spacing_m: float
    load_n_per_m: float
    approach_m: float
    approach_datum_m: float
    contact_fraction: float
    p_max_pa: float
    p_end_pa: float
    plastic_energy_j_per_m: float
    elastic_energy_j_per_m: float
    iterations: int
    certificate: ContactCertificate
    warnings: Table
    path_fraction: Optional[float]
    hertz_p_max_pa: Optional[float]
    hertz_half_width_m: Optional[float]
    running_in: Optional[Table]


class PathArrays(Rows):
    """Columns along the path of contact."""

    _row = PathRow
    position: NDArray[Any]
    s_mm: Floats
    path_fraction: Floats
    weight_m: Floats
    line_load_n_per_mm: Floats
    sliding_load_n_per_mm: Floats
    load_share: Floats
    radius_mm: Floats
    u1_m_per_s: Floats
    u2_m_per_s: Floats
    sliding_m_per_s: Floats
    entrainment_m_per_s: Floats
    slide_to_roll: Floats
    half_width_um: Floats
    hertz_pressure_mpa: Floats
    thermal_reduction: Floats
    film_central_um: Floats
    film_minimum_um: Floats
    lambda_star: Floats
    film_ratio: Floats
    mixed_share: Floats
    regime: NDArray[Any]
    film_share: Floats
    film_share_standard_error: Floats
    boundary_of_asperities: Floats
    boundary_share: Floats
    mean_gap_um: Floats
    roughness_over_film: Floats
    full_film: NDArray[Any]
    mu_film: Floats
    mu: Floats
    flash_k: Floats
    flash_max_k: Floats
    sliding_w_per_m: Floats
    sliding_deviation_w_per_m: Floats
    sliding_standard_error_w_per_m: Floats
    sliding_error_freedom: Floats
    face_zone: NDArray[Any]
    film_w_per_m: Floats
    lubricated_asperity_w_per_m: Floats
    boundary_w_per_m: Floats
    rolling_w_per_m: Floats
    contact_fraction: Floats
    p_max_mpa: Floats
    plastic_work_j_per_m: Floats
    von_mises_max_mpa: Floats
    von_mises_depth_um: Floats
    yield_depth_um: Floats
    yield_share: Floats
    iterations: NDArray[Any]
    load_error: Floats

    if TYPE_CHECKING:

        @overload
        def __getitem__(self, key: Literal["s_mm", "path_fraction", "weight_m", "line_load_n_per_mm", "sliding_load_n_per_mm", "load_share", "radius_mm", "u1_m_per_s", "u2_m_per_s", "sliding_m_per_s", "entrainment_m_per_s", "slide_to_roll", "half_width_um", "hertz_pressure_mpa", "thermal_reduction", "film_central_um", "film_minimum_um", "lambda_star", "film_ratio", "mixed_share", "film_share", "film_share_standard_error", "boundary_of_asperities", "boundary_share", "mean_gap_um", "roughness_over_film", "mu_film", "mu", "flash_k", "flash_max_k", "sliding_w_per_m", "sliding_deviation_w_per_m", "sliding_standard_error_w_per_m", "sliding_error_freedom", "film_w_per_m", "lubricated_asperity_w_per_m", "boundary_w_per_m", "rolling_w_per_m", "contact_fraction", "p_max_mpa", "plastic_work_j_per_m", "von_mises_max_mpa", "von_mises_depth_um", "yield_depth_um", "yield_share", "load_error"]) -> Floats: ...
        @overload
        def __getitem__(self, key: Literal["position", "regime", "full_film", "face_zone", "iterations"]) -> NDArray[Any]: ...
        @overload
        def __getitem__(self, key: int) -> PathRow: ...
        @overload
        def __getitem__(self, key: Union[slice, list[str], list[int], NDArray[Any]]) -> Table: ...
        def __getitem__(self, key: Any) -> Any: ...
        def __iter__(self) -> Iterator[PathRow]: ...


class ParameterValues:
    """Roughness parameters."""

    ra_um: float
    rq_um: float
    rz_um: float
    rp_um: float
    rv_um: float
    rt_um: float
    rsk: float
    rku: float
    rk_um: float
    rpk_um: float
    rvk_um: float
    rc_um: float
    rdq: float
    rsm_um: float
    rz1max_um: float
    sections: float
    mr1_percent: float
    mr2_percent: float
    bandwidth: float
    m0_um2: float
    m2: float
    m4_per_um2: float
    section_um: float


class ResultValues:
    """Values of a result."""

    schema_version: Any
    program: Any
    case_file: Any
    formulation: Any
    published_laws: Any
    load: Any
    points: Any
    records: Any
    bulk: Any
    gearbox: Any
    micropitting: Any
    running_in: Any
    run_in: Any
    ridges: Any
    no_ridges: Any
    flanks: Any
    pairs: Any
    gears: Any
    lubricant: Any
    film_constants: Any
    inputs: Any
    defaults: Any
    equations: Any
    references: Any


class MapArrays:
    """Arrays of a map."""

    loss_w: NDArray[Any]
    loss_median_w: NDArray[Any]
    loss_p05_w: NDArray[Any]
    loss_p95_w: NDArray[Any]
    loss_torque_nm: NDArray[Any]
    loss_torque_deviation_nm: NDArray[Any]
    efficiency: NDArray[Any]
    efficiency_deviation: NDArray[Any]
    sliding_w: NDArray[Any]
    film_w: NDArray[Any]
    lubricated_asperity_w: NDArray[Any]
    boundary_w: NDArray[Any]
    rolling_w: NDArray[Any]
    deformation_w: NDArray[Any]
    mu_equivalent: NDArray[Any]
    mixed_share: NDArray[Any]
    extended: NDArray[Any]
    code: NDArray[Any]
    regime: NDArray[Any]
