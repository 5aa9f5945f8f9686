"""Values of results by name.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from typing import Any, Literal, NoReturn, Optional

from numpy.typing import NDArray

from ._quantity import Floats
from ._record import TableOf, Values


ParameterName = Literal[
    "ra_um", "rq_um", "rz_um", "rp_um", "rv_um", "rt_um", "rsk", "rku", "rk_um", "rpk_um", "rvk_um", "rc_um", "rdq",
    "rsm_um", "rz1max_um", "sections", "mr1_percent", "mr2_percent", "bandwidth", "m0_um2", "m2", "m4_per_um2",
    "section_um",
]


class UncertaintyPart(Values):
    """Values of `UncertaintyPart` in Rust."""

    _absent = {"name": "", "about": None, "remedy": ""}
    name: str
    about: Optional[Literal["pressure-viscosity", "tip-relief", "fast-model", "sampling", "lay", "oil"]]
    sd_ln: float
    p05_w: float
    p95_w: float
    remedy: str


class UncertaintyPartTable(TableOf[UncertaintyPart, Literal["sd_ln", "p05_w", "p95_w"], Literal["name", "about", "remedy"]]):
    _row = UncertaintyPart
    name: NDArray[Any]; about: NDArray[Any]; sd_ln: Floats; p05_w: Floats; p95_w: Floats; remedy: NDArray[Any]


class LossDistribution(Values):
    """Values of `LossDistribution` in Rust."""

    _kinds = {"parts": UncertaintyPartTable}
    _absent = {"parts": []}
    median_w: float
    quantiles_w: Floats
    sd_ln: float
    parts: UncertaintyPartTable


class DrawnConstant(Values):
    """Values of `DrawnConstant` in Rust."""

    _absent = {"name": "", "unit": "", "is_calibrated": False}
    name: str
    value: float
    low: float
    high: float
    unit: str
    is_calibrated: bool


class DrawnConstantTable(TableOf[DrawnConstant, Literal["value", "low", "high"], Literal["name", "unit", "is_calibrated"]]):
    _row = DrawnConstant
    name: NDArray[Any]; value: Floats; low: Floats; high: Floats; unit: NDArray[Any]; is_calibrated: NDArray[Any]


class AlternativeRow(Values):
    """Values of `AlternativeRow` in Rust."""

    _absent = {"name": "", "loss_w": None, "refuted_by": ""}
    name: str
    loss_w: Optional[float]
    refuted_by: str


class AlternativeRowTable(TableOf[AlternativeRow, Literal["loss_w"], Literal["name", "refuted_by"]]):
    _row = AlternativeRow
    name: NDArray[Any]; loss_w: Floats; refuted_by: NDArray[Any]


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


class EvidenceRowTable(TableOf[EvidenceRow, Literal["hours", "low_w", "high_w", "sd_ln", "width"], Literal["key", "measurement"]]):
    _row = EvidenceRow
    key: NDArray[Any]; measurement: NDArray[Any]; hours: Floats; low_w: Floats; high_w: Floats; sd_ln: Floats
    width: Floats


class Uncertainty(Values):
    """Values of `Uncertainty` in Rust."""

    _kinds = {"loss": LossDistribution, "constants": DrawnConstantTable, "structures": AlternativeRowTable, "other_models": AlternativeRowTable, "evidence": EvidenceRowTable}
    _absent = {"constants": [], "held": [], "roughness_over_film": None, "boundary_w": None, "structures": [], "other_models": [], "with_traces_w": None, "path_sliding_w_per_m": [], "evidence": []}
    loss: LossDistribution
    efficiency_median: float
    efficiency_quantiles: Floats
    constants: DrawnConstantTable
    held: list[str]
    draws: int
    beyond_power: int
    evaluations: int
    interpolation_error: float
    roughness_over_film: Optional[float]
    sampling: Any
    boundary_w: Optional[Floats]
    structures: AlternativeRowTable
    other_models: AlternativeRowTable
    trust: Literal["solved-contact", "share-formula", "surrogates", "roughness-values"]
    with_traces_w: Optional[Floats]
    path_sliding_w_per_m: list[Any]
    evidence: EvidenceRowTable


class SummaryValues(Values):
    """Values of `Summary` in Rust."""

    _absent = {"gearbox_efficiency": None, "gearbox_loss_w": None, "efficiency_deviation": None, "loss_at_medians_w": None, "asperity_share_standard_error": None}
    scope: Literal["mesh", "gearbox"]
    gearbox_efficiency: Optional[float]
    gearbox_loss_w: Optional[float]
    efficiency: float
    efficiency_deviation: Optional[float]
    offsets: int
    power_in_w: float
    torque_out_nm: float
    loss_w: float
    loss_at_medians_w: Optional[float]
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
    loss_factor_ohlendorf: float
    loss_factor_local: float
    mixed_share: float
    regime: Literal["full-film", "mixed", "boundary"]
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
    _absent = {"lambda_star": None, "film_ratio": None, "film_share_standard_error": None, "boundary_of_asperities": None, "mean_gap_um": None, "roughness_over_film": None, "full_film": None, "sliding_deviation_w_per_m": None, "sliding_standard_error_w_per_m": None, "sliding_error_freedom": None, "face_zone": None, "contact_fraction": None, "p_max_mpa": None, "plastic_work_j_per_m": None, "von_mises_max_mpa": None, "von_mises_depth_um": None, "yield_depth_um": None, "yield_share": None}
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
    flash_max_k: float
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


class PathRowTable(TableOf[PathRow, Literal["s_mm", "path_fraction", "weight_m", "line_load_n_per_mm", "sliding_load_n_per_mm", "load_share", "radius_mm", "u1_m_per_s", "u2_m_per_s", "sliding_m_per_s", "entrainment_m_per_s", "slide_to_roll", "half_width_um", "hertz_pressure_mpa", "thermal_reduction", "film_central_um", "film_minimum_um", "lambda_star", "film_ratio", "mixed_share", "film_share", "film_share_standard_error", "boundary_of_asperities", "boundary_share", "mean_gap_um", "roughness_over_film", "mu_film", "mu", "flash_k", "flash_max_k", "sliding_w_per_m", "sliding_deviation_w_per_m", "sliding_standard_error_w_per_m", "sliding_error_freedom", "film_w_per_m", "lubricated_asperity_w_per_m", "boundary_w_per_m", "rolling_w_per_m", "contact_fraction", "p_max_mpa", "plastic_work_j_per_m", "von_mises_max_mpa", "von_mises_depth_um", "yield_depth_um", "yield_share", "load_error"], Literal["position", "regime", "full_film", "face_zone", "iterations"]]):
    _row = PathRow
    position: NDArray[Any]; s_mm: Floats; path_fraction: Floats; weight_m: Floats; line_load_n_per_mm: Floats
    sliding_load_n_per_mm: Floats; load_share: Floats; radius_mm: Floats; u1_m_per_s: Floats; u2_m_per_s: Floats
    sliding_m_per_s: Floats; entrainment_m_per_s: Floats; slide_to_roll: Floats; half_width_um: Floats
    hertz_pressure_mpa: Floats; thermal_reduction: Floats; film_central_um: Floats; film_minimum_um: Floats
    lambda_star: Floats; film_ratio: Floats; mixed_share: Floats; regime: NDArray[Any]; film_share: Floats
    film_share_standard_error: Floats; boundary_of_asperities: Floats; boundary_share: Floats; mean_gap_um: Floats
    roughness_over_film: Floats; full_film: NDArray[Any]; mu_film: Floats; mu: Floats; flash_k: Floats
    flash_max_k: Floats; sliding_w_per_m: Floats; sliding_deviation_w_per_m: Floats
    sliding_standard_error_w_per_m: Floats; sliding_error_freedom: Floats; face_zone: NDArray[Any]
    film_w_per_m: Floats; lubricated_asperity_w_per_m: Floats; boundary_w_per_m: Floats; rolling_w_per_m: Floats
    contact_fraction: Floats; p_max_mpa: Floats; plastic_work_j_per_m: Floats; von_mises_max_mpa: Floats
    von_mises_depth_um: Floats; yield_depth_um: Floats; yield_share: Floats; iterations: NDArray[Any]
    load_error: Floats


class ContactCertificate(Values):
    """Values of `ContactCertificate` in Rust."""

    duality_gap: float
    penetration: float
    load_error: float
    reference_gap_m: float


class Note(Values):
    """Values of `ContactNote` in Rust."""

    _absent = {"code": "", "text": ""}
    code: str
    text: str


class NoteTable(TableOf[Note, NoReturn, Literal["code", "text"]]):
    _row = Note
    code: NDArray[Any]; text: NDArray[Any]


class RunningInCycle(Values):
    """Values of `RunningInCycle` in Rust."""

    plastic_energy_j_per_m: float
    largest_flow_m: float
    contact_fraction: float
    rq_first_m: float
    rq_second_m: float
    peak_first_m: float
    peak_second_m: float


class RunningInCycleTable(TableOf[RunningInCycle, Literal["plastic_energy_j_per_m", "largest_flow_m", "contact_fraction", "rq_first_m", "rq_second_m", "peak_first_m", "peak_second_m"], NoReturn]):
    _row = RunningInCycle
    plastic_energy_j_per_m: Floats; largest_flow_m: Floats; contact_fraction: Floats; rq_first_m: Floats
    rq_second_m: Floats; peak_first_m: Floats; peak_second_m: Floats


class ContactNumbers(Values):
    """Values of `ContactNumbers` in Rust."""

    _kinds = {"certificate": ContactCertificate, "warnings": NoteTable, "running_in": RunningInCycleTable}
    _absent = {"rows": None, "lead_spacing_m": None, "warnings": [], "path_fraction": None, "hertz_p_max_pa": None, "hertz_half_width_m": None, "running_in": None}
    points: int
    spacing_m: float
    rows: Optional[int]
    lead_spacing_m: Optional[float]
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
    warnings: NoteTable
    path_fraction: Optional[float]
    hertz_p_max_pa: Optional[float]
    hertz_half_width_m: Optional[float]
    running_in: Optional[RunningInCycleTable]


class ComparisonFinishDifferenceCommon(Values):
    name: str
    belongs_to: str
    correlation: float


class ComparisonFinishDifferenceCommonTable(TableOf[ComparisonFinishDifferenceCommon, Literal["correlation"], Literal["name", "belongs_to"]]):
    _row = ComparisonFinishDifferenceCommon
    name: NDArray[Any]; belongs_to: NDArray[Any]; correlation: Floats


class ComparisonFinishDifference(Values):
    _kinds = {"models": AlternativeRowTable, "common": ComparisonFinishDifferenceCommonTable}
    at_medians_w: float
    median_w: float
    quantiles_w: Floats
    median_share: float
    share_quantiles: Floats
    probability: float
    models: AlternativeRowTable
    verdict: str
    common: ComparisonFinishDifferenceCommonTable


class ComparisonFinishDeciding(Values):
    measurement: str
    of: list[Any]
    is_common: bool
    p05_w: float
    p95_w: float
    width: float


class ComparisonFinishDecidingTable(TableOf[ComparisonFinishDeciding, Literal["p05_w", "p95_w", "width"], Literal["measurement", "of", "is_common"]]):
    _row = ComparisonFinishDeciding
    measurement: NDArray[Any]; of: NDArray[Any]; is_common: NDArray[Any]; p05_w: Floats; p95_w: Floats; width: Floats


class ComparisonFinishChange(Values):
    key: str
    first: str
    value: str


class ComparisonFinishChangeTable(TableOf[ComparisonFinishChange, NoReturn, Literal["key", "first", "value"]]):
    _row = ComparisonFinishChange
    key: NDArray[Any]; first: NDArray[Any]; value: NDArray[Any]


class ComparisonFinishMesh(Values):
    _kinds = {"difference": ComparisonFinishDifference}
    _absent = {"loss_at_medians_w": None, "difference": None}
    mesh: str
    count: int
    loss_w: float
    loss_at_medians_w: Optional[float]
    loss_p05_w: float
    loss_p95_w: float
    difference: Optional[ComparisonFinishDifference]
    mixed_share: float
    regime: str


class ComparisonFinishMeshTable(TableOf[ComparisonFinishMesh, Literal["loss_w", "loss_at_medians_w", "loss_p05_w", "loss_p95_w", "mixed_share"], Literal["mesh", "count", "difference", "regime"]]):
    _row = ComparisonFinishMesh
    mesh: NDArray[Any]; count: NDArray[Any]; loss_w: Floats; loss_at_medians_w: Floats; loss_p05_w: Floats
    loss_p95_w: Floats; difference: NDArray[Any]; mixed_share: Floats; regime: NDArray[Any]


class ComparisonFinish(Values):
    _kinds = {"uncertainty": Uncertainty, "difference": ComparisonFinishDifference, "deciding": ComparisonFinishDecidingTable, "changes": ComparisonFinishChangeTable, "loss_distribution": LossDistribution, "meshes": ComparisonFinishMeshTable}
    _absent = {"loss_at_medians_w": None, "uncertainty": None, "difference": None, "mixed_share": None, "regime": None, "deciding": None, "changes": None, "loss_distribution": None, "meshes": None}
    name: str
    files: list[Any]
    efficiency: float
    power_in_w: float
    loss_w: float
    loss_at_medians_w: Optional[float]
    uncertainty: Optional[Uncertainty]
    difference: Optional[ComparisonFinishDifference]
    mixed_share: Optional[float]
    regime: Optional[str]
    base_oil: str
    viscosity_mm2_per_s: float
    warnings: list[str]
    deciding: Optional[ComparisonFinishDecidingTable]
    changes: Optional[ComparisonFinishChangeTable]
    loss_distribution: Optional[LossDistribution]
    meshes: Optional[ComparisonFinishMeshTable]


class ComparisonFinishTable(TableOf[ComparisonFinish, Literal["efficiency", "power_in_w", "loss_w", "loss_at_medians_w", "mixed_share", "viscosity_mm2_per_s"], Literal["name", "files", "uncertainty", "difference", "regime", "base_oil", "warnings", "deciding", "changes", "loss_distribution", "meshes"]]):
    _row = ComparisonFinish
    name: NDArray[Any]; files: NDArray[Any]; efficiency: Floats; power_in_w: Floats; loss_w: Floats
    loss_at_medians_w: Floats; uncertainty: NDArray[Any]; difference: NDArray[Any]; mixed_share: Floats
    regime: NDArray[Any]; base_oil: NDArray[Any]; viscosity_mm2_per_s: Floats; warnings: NDArray[Any]
    deciding: NDArray[Any]; changes: NDArray[Any]; loss_distribution: NDArray[Any]; meshes: NDArray[Any]


class ComparisonCorrelation(Values):
    parameter: str
    with_loss: float
    within_finishes: float


class ComparisonCorrelationTable(TableOf[ComparisonCorrelation, Literal["with_loss", "within_finishes"], Literal["parameter"]]):
    _row = ComparisonCorrelation
    parameter: NDArray[Any]; with_loss: Floats; within_finishes: Floats


class ComparisonValues(Values):
    _kinds = {"finishes": ComparisonFinishTable, "correlations": ComparisonCorrelationTable}
    program: str
    title: str
    scope: str
    power_in_w: float
    windows: int


class MapFinishDifference(Values):
    value: float
    low: float
    high: float


class MapFinish(Values):
    _kinds = {"difference_w": MapFinishDifference}
    _absent = {"draws": None, "difference_w": None}
    name: str
    fingerprint: str
    files: list[Any]
    resolved_from_nm: Floats
    draws: Any
    difference_w: Optional[MapFinishDifference]


class MapFinishTable(TableOf[MapFinish, NoReturn, Literal["name", "fingerprint", "files", "resolved_from_nm", "draws", "difference_w"]]):
    _row = MapFinish
    name: NDArray[Any]; fingerprint: NDArray[Any]; files: NDArray[Any]; resolved_from_nm: NDArray[Any]
    draws: NDArray[Any]; difference_w: NDArray[Any]


class MapWarning(Values):
    text: str
    finish: str
    count: int
    points: str


class MapWarningTable(TableOf[MapWarning, NoReturn, Literal["text", "finish", "count", "points"]]):
    _row = MapWarning
    text: NDArray[Any]; finish: NDArray[Any]; count: NDArray[Any]; points: NDArray[Any]


class MapRow(Values):
    _absent = {"code": None}
    finish: str
    temperature_c: float
    torque_nm: float
    speed_rpm: float
    loss_w: float
    loss_p05_w: float
    loss_p95_w: float
    loss_at_medians_w: float
    loss_torque_nm: float
    loss_torque_deviation_nm: float
    efficiency: float
    efficiency_deviation: float
    sliding_w: float
    film_w: float
    lubricated_asperity_w: float
    boundary_w: float
    rolling_w: float
    deformation_w: float
    mu_equivalent: float
    mixed_share: float
    extended: bool
    code: Optional[str]
    regime: str


class MapRowTable(TableOf[MapRow, Literal["temperature_c", "torque_nm", "speed_rpm", "loss_w", "loss_p05_w", "loss_p95_w", "loss_at_medians_w", "loss_torque_nm", "loss_torque_deviation_nm", "efficiency", "efficiency_deviation", "sliding_w", "film_w", "lubricated_asperity_w", "boundary_w", "rolling_w", "deformation_w", "mu_equivalent", "mixed_share"], Literal["finish", "extended", "code", "regime"]]):
    _row = MapRow
    finish: NDArray[Any]; temperature_c: Floats; torque_nm: Floats; speed_rpm: Floats; loss_w: Floats
    loss_p05_w: Floats; loss_p95_w: Floats; loss_at_medians_w: Floats; loss_torque_nm: Floats
    loss_torque_deviation_nm: Floats; efficiency: Floats; efficiency_deviation: Floats; sliding_w: Floats
    film_w: Floats; lubricated_asperity_w: Floats; boundary_w: Floats; rolling_w: Floats; deformation_w: Floats
    mu_equivalent: Floats; mixed_share: Floats; extended: NDArray[Any]; code: NDArray[Any]; regime: NDArray[Any]


class MapValues(Values):
    _kinds = {"finishes": MapFinishTable, "warnings": MapWarningTable, "rows": MapRowTable}
    _absent = {"axes": None, "input": None, "defaults": None, "are_variants": None}
    schema_version: int
    program: str
    title: str
    scope: str
    axes: Any
    ratio: float
    operating_point: Floats
    operating_temperature_c: float
    input: Any
    defaults: Any
    are_variants: Optional[bool]


class CycleFinish(Values):
    _absent = {"lost_at_medians_wh": None, "wh_per_100_km": None, "difference_wh": None, "difference_p05_wh": None, "difference_p95_wh": None}
    name: str
    lost_wh: float
    lost_p05_wh: float
    lost_p95_wh: float
    lost_at_medians_wh: Optional[float]
    lost_drive_wh: float
    lost_coast_wh: float
    share_of_drive: float
    drive_efficiency: float
    wh_per_100_km: Optional[float]
    difference_wh: Optional[float]
    difference_p05_wh: Optional[float]
    difference_p95_wh: Optional[float]


class CycleFinishTable(TableOf[CycleFinish, Literal["lost_wh", "lost_p05_wh", "lost_p95_wh", "lost_at_medians_wh", "lost_drive_wh", "lost_coast_wh", "share_of_drive", "drive_efficiency", "wh_per_100_km", "difference_wh", "difference_p05_wh", "difference_p95_wh"], Literal["name"]]):
    _row = CycleFinish
    name: NDArray[Any]; lost_wh: Floats; lost_p05_wh: Floats; lost_p95_wh: Floats; lost_at_medians_wh: Floats
    lost_drive_wh: Floats; lost_coast_wh: Floats; share_of_drive: Floats; drive_efficiency: Floats
    wh_per_100_km: Floats; difference_wh: Floats; difference_p05_wh: Floats; difference_p95_wh: Floats


class CycleValues(Values):
    _kinds = {"finishes": CycleFinishTable, "warnings": NoteTable}
    _absent = {"distance_km": None, "warnings": None}
    program: str
    title: str
    cycle: str
    scope: str
    temperature_c: float
    duration_s: float
    distance_km: Optional[float]
    drive_wh: float
    coast_wh: float
    outside_energy_share: float
    outside_share: float
    extended_share: float
    warnings: Optional[NoteTable]


class SensitivityRow(Values):
    _absent = {"sampling_p05_w": None, "sampling_p95_w": None, "code": None}
    group: str
    what: str
    to: str
    difference_w: float
    change: float
    sampling_p05_w: Optional[float]
    sampling_p95_w: Optional[float]
    film_w: float
    lubricated_asperity_w: float
    boundary_w: float
    rolling_w: float
    code: Optional[str]
    p05_w: float
    p95_w: float


class SensitivityRowTable(TableOf[SensitivityRow, Literal["difference_w", "change", "sampling_p05_w", "sampling_p95_w", "film_w", "lubricated_asperity_w", "boundary_w", "rolling_w", "p05_w", "p95_w"], Literal["group", "what", "to", "code"]]):
    _row = SensitivityRow
    group: NDArray[Any]; what: NDArray[Any]; to: NDArray[Any]; difference_w: Floats; change: Floats
    sampling_p05_w: Floats; sampling_p95_w: Floats; film_w: Floats; lubricated_asperity_w: Floats; boundary_w: Floats
    rolling_w: Floats; code: NDArray[Any]; p05_w: Floats; p95_w: Floats


class SensitivityValues(Values):
    _kinds = {"rows": SensitivityRowTable}
    _absent = {"loss_at_medians_w": None}
    title: str
    conditions: str
    loss_w: float
    loss_at_medians_w: Optional[float]
    efficiency: float


class RidgesRow(Values):
    flank: str
    place_mm: float
    width_um: float
    height_um: float
    first_order_w: float
    measured_first_order_w: float
    mean_gradient_w: float
    low_w: float
    high_w: float
    first_point: int
    last_point: int


class RidgesRowTable(TableOf[RidgesRow, Literal["place_mm", "width_um", "height_um", "first_order_w", "measured_first_order_w", "mean_gradient_w", "low_w", "high_w"], Literal["flank", "first_point", "last_point"]]):
    _row = RidgesRow
    flank: NDArray[Any]; place_mm: Floats; width_um: Floats; height_um: Floats; first_order_w: Floats
    measured_first_order_w: Floats; mean_gradient_w: Floats; low_w: Floats; high_w: Floats; first_point: NDArray[Any]
    last_point: NDArray[Any]


class RidgesOctave(Values):
    _absent = {"to_um": None}
    from_um: float
    to_um: Optional[float]
    pinion_w: float
    wheel_w: float


class RidgesOctaveTable(TableOf[RidgesOctave, Literal["from_um", "to_um", "pinion_w", "wheel_w"], NoReturn]):
    _row = RidgesOctave
    from_um: Floats; to_um: Floats; pinion_w: Floats; wheel_w: Floats


class RidgesValues(Values):
    _kinds = {"rows": RidgesRowTable, "octaves": RidgesOctaveTable}
    _absent = {"kinks": None, "along": None, "near": None}
    title: str
    conditions: str
    loss_at_medians_w: float
    pressed_at_medians_w: float
    sampling_quantiles_w: Floats
    saving_quantiles_w: Floats
    by_log_height_w: float
    heat_balance: float
    unresolved_w: float
    without_gearbox: bool
    kinks: Any
    along: Any
    near: Any


class CallOutLimit(Values):
    flank: str
    parameter: str
    unit: str
    limit: float
    standard_error: float
    recipe: float


class CallOutLimitTable(TableOf[CallOutLimit, Literal["limit", "standard_error", "recipe"], Literal["flank", "parameter", "unit"]]):
    _row = CallOutLimit
    flank: NDArray[Any]; parameter: NDArray[Any]; unit: NDArray[Any]; limit: Floats; standard_error: Floats
    recipe: Floats


class CallOutParameter(Values):
    parameter: str
    traces: int
    limit_over_recipe: float
    deviation: float
    of_traces: float


class CallOutParameterTable(TableOf[CallOutParameter, Literal["limit_over_recipe", "deviation", "of_traces"], Literal["parameter", "traces"]]):
    _row = CallOutParameter
    parameter: NDArray[Any]; traces: NDArray[Any]; limit_over_recipe: Floats; deviation: Floats; of_traces: Floats


class CallOutValues(Values):
    _kinds = {"limits": CallOutLimitTable, "parameters": CallOutParameterTable}
    _absent = {"by_traces": None, "curve": None}
    title: str
    loss_w: float
    confidence: float
    scatter: float
    parameter: str
    traces: int
    wavelengths_um: Floats
    mean_loss_w: float
    recipe_loss_w: float
    smooth_loss_w: float
    by_traces: Any
    curve: Any
    lots: int
    seed: int


class EvidenceValues(Values):
    _kinds = {"loss": LossDistribution, "rows": EvidenceRowTable}
    program: str
    title: str
    conditions: str
    power_in_w: float
    loss: LossDistribution
    is_temperature_drawn: bool


class DesignLimits(Values):
    torques_nm: Floats
    speeds_rpm: Floats
    temperatures_c: Floats
    hours: float
    minutes_per_point: float
    sigma: float
    assemblies: int


class DesignPoint(Values):
    torque_nm: float
    speed_rpm: float
    temperature_c: float
    repeats: int
    loss_w: float
    lambda_star: float


class DesignPointTable(TableOf[DesignPoint, Literal["torque_nm", "speed_rpm", "temperature_c", "loss_w", "lambda_star"], Literal["repeats"]]):
    _row = DesignPoint
    torque_nm: Floats; speed_rpm: Floats; temperature_c: Floats; repeats: NDArray[Any]; loss_w: Floats
    lambda_star: Floats


class DesignParameter(Values):
    key: str
    name: str
    unit: str
    deviation: float
    prior: float
    verdict: str
    value: float
    range_low: float
    range_high: float
    default_range_low: float
    default_range_high: float


class DesignParameterTable(TableOf[DesignParameter, Literal["deviation", "prior", "value", "range_low", "range_high", "default_range_low", "default_range_high"], Literal["key", "name", "unit", "verdict"]]):
    _row = DesignParameter
    key: NDArray[Any]; name: NDArray[Any]; unit: NDArray[Any]; deviation: Floats; prior: Floats; verdict: NDArray[Any]
    value: Floats; range_low: Floats; range_high: Floats; default_range_low: Floats; default_range_high: Floats


class DesignValues(Values):
    _kinds = {"limits": DesignLimits, "points": DesignPointTable, "parameters": DesignParameterTable, "warnings": NoteTable}
    schema_version: int
    program: str
    title: str
    settings: str
    limits: DesignLimits
    lambda_star: Floats
    candidates: int
    warnings: NoteTable


class CalibrationParameter(Values):
    key: str
    name: str
    unit: str
    value: float
    range_low: float
    range_high: float
    band_low: float
    band_high: float
    profile_range_low: float
    profile_range_high: float
    is_open: list[Any]
    profile: list[Any]
    bootstrap_low: float
    bootstrap_high: float
    default: float
    default_range_low: float
    default_range_high: float
    deviation: float
    verdict: str


class CalibrationParameterTable(TableOf[CalibrationParameter, Literal["value", "range_low", "range_high", "band_low", "band_high", "profile_range_low", "profile_range_high", "bootstrap_low", "bootstrap_high", "default", "default_range_low", "default_range_high", "deviation"], Literal["key", "name", "unit", "is_open", "profile", "verdict"]]):
    _row = CalibrationParameter
    key: NDArray[Any]; name: NDArray[Any]; unit: NDArray[Any]; value: Floats; range_low: Floats; range_high: Floats
    band_low: Floats; band_high: Floats; profile_range_low: Floats; profile_range_high: Floats; is_open: NDArray[Any]
    profile: NDArray[Any]; bootstrap_low: Floats; bootstrap_high: Floats; default: Floats; default_range_low: Floats
    default_range_high: Floats; deviation: Floats; verdict: NDArray[Any]


class CalibrationPoint(Values):
    line: int
    assembly: str
    torque_nm: float
    speed_rpm: float
    temperature_c: float
    measured_w: float
    sigma_w: float
    fitted_w: float
    default_w: float
    calibrated_w: float
    residual_sigma: float
    lambda_star: float
    boundary_share: float


class CalibrationPointTable(TableOf[CalibrationPoint, Literal["torque_nm", "speed_rpm", "temperature_c", "measured_w", "sigma_w", "fitted_w", "default_w", "calibrated_w", "residual_sigma", "lambda_star", "boundary_share"], Literal["line", "assembly"]]):
    _row = CalibrationPoint
    line: NDArray[Any]; assembly: NDArray[Any]; torque_nm: Floats; speed_rpm: Floats; temperature_c: Floats
    measured_w: Floats; sigma_w: Floats; fitted_w: Floats; default_w: Floats; calibrated_w: Floats
    residual_sigma: Floats; lambda_star: Floats; boundary_share: Floats


class CalibrationValues(Values):
    _kinds = {"parameters": CalibrationParameterTable, "points": CalibrationPointTable, "warnings": NoteTable}
    _absent = {"identifiability": None, "stages": None, "nuisance": None, "held_out": None, "evidence": None}
    schema_version: int
    program: str
    title: str
    table: str
    sha256: str
    is_simulated: bool
    assemblies: list[str]
    identifiability: Any
    stages: Any
    correlations: list[Any]
    nuisance: Any
    chi_squared: float
    freedom: int
    birge_ratio: float
    held_out: Any
    evidence: Any
    warnings: NoteTable
    block: str


class TractionOverSlide(Values):
    load_n: float
    mean_speed_m_s: float
    slide_roll_percent: float
    temperature_c: float
    traction: float
    traction_p05: float
    traction_p95: float
    film_nm: float
    film_ratio: float
    surface_rise_k: float
    film_rise_k: float


class TractionOverSlideTable(TableOf[TractionOverSlide, Literal["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction", "traction_p05", "traction_p95", "film_nm", "film_ratio", "surface_rise_k", "film_rise_k"], NoReturn]):
    _row = TractionOverSlide
    load_n: Floats; mean_speed_m_s: Floats; slide_roll_percent: Floats; temperature_c: Floats; traction: Floats
    traction_p05: Floats; traction_p95: Floats; film_nm: Floats; film_ratio: Floats; surface_rise_k: Floats
    film_rise_k: Floats


class TractionValues(Values):
    _kinds = {"over_slide": TractionOverSlideTable, "over_speed": TractionOverSlideTable}
    program: str
    title: str
    pressure_law: str
    max_pressure_gpa: float
    load_n: float
    mean_speed_m_s: float
    slide_roll_percent: float
    roughness_nm: float
    boundary_friction: float
    deviations: Floats
    over_slide: TractionOverSlideTable
    over_speed: TractionOverSlideTable


class ProfileChangeMean(Values):
    removed_nm: float
    removed_quantiles_nm: Floats
    lost_nm: float
    lost_quantiles_nm: Floats
    gained_nm: float
    gained_quantiles_nm: Floats


class ProfileChangePair(Values):
    _absent = {"bow_um": None, "bow_p05_um": None, "bow_p95_um": None}
    before: str
    after: str
    shift_um: float
    shift_p05_um: float
    shift_p95_um: float
    stretch_percent: float
    stretch_p05_percent: float
    stretch_p95_percent: float
    height_um: float
    height_p05_um: float
    height_p95_um: float
    tilt_um_per_mm: float
    tilt_p05_um_per_mm: float
    tilt_p95_um_per_mm: float
    bow_um: Optional[float]
    bow_p05_um: Optional[float]
    bow_p95_um: Optional[float]
    correlation: float
    elsewhere: float
    matched_percent: float
    noise_nm: float
    overlap_mm: float
    removed_um2: float
    removed_nm: float
    removed_p05_nm: float
    removed_p95_nm: float
    lost_nm: float
    lost_p05_nm: float
    lost_p95_nm: float
    gained_nm: float
    gained_p05_nm: float
    gained_p95_nm: float


class ProfileChangePairTable(TableOf[ProfileChangePair, Literal["shift_um", "shift_p05_um", "shift_p95_um", "stretch_percent", "stretch_p05_percent", "stretch_p95_percent", "height_um", "height_p05_um", "height_p95_um", "tilt_um_per_mm", "tilt_p05_um_per_mm", "tilt_p95_um_per_mm", "bow_um", "bow_p05_um", "bow_p95_um", "correlation", "elsewhere", "matched_percent", "noise_nm", "overlap_mm", "removed_um2", "removed_nm", "removed_p05_nm", "removed_p95_nm", "lost_nm", "lost_p05_nm", "lost_p95_nm", "gained_nm", "gained_p05_nm", "gained_p95_nm"], Literal["before", "after"]]):
    _row = ProfileChangePair
    before: NDArray[Any]; after: NDArray[Any]; shift_um: Floats; shift_p05_um: Floats; shift_p95_um: Floats
    stretch_percent: Floats; stretch_p05_percent: Floats; stretch_p95_percent: Floats; height_um: Floats
    height_p05_um: Floats; height_p95_um: Floats; tilt_um_per_mm: Floats; tilt_p05_um_per_mm: Floats
    tilt_p95_um_per_mm: Floats; bow_um: Floats; bow_p05_um: Floats; bow_p95_um: Floats; correlation: Floats
    elsewhere: Floats; matched_percent: Floats; noise_nm: Floats; overlap_mm: Floats; removed_um2: Floats
    removed_nm: Floats; removed_p05_nm: Floats; removed_p95_nm: Floats; lost_nm: Floats; lost_p05_nm: Floats
    lost_p95_nm: Floats; gained_nm: Floats; gained_p05_nm: Floats; gained_p95_nm: Floats


class ProfileChangeParameter(Values):
    parameter: str
    before_um: float
    after_um: float
    change_um: float
    floor_um: float


class ProfileChangeParameterTable(TableOf[ProfileChangeParameter, Literal["before_um", "after_um", "change_um", "floor_um"], Literal["parameter"]]):
    _row = ProfileChangeParameter
    parameter: NDArray[Any]; before_um: Floats; after_um: Floats; change_um: Floats; floor_um: Floats


class ProfileChangeMaterialRatio(Values):
    material_ratio_percent: float
    before_um: float
    after_um: float
    change_um: float
    floor_um: float


class ProfileChangeMaterialRatioTable(TableOf[ProfileChangeMaterialRatio, Literal["material_ratio_percent", "before_um", "after_um", "change_um", "floor_um"], NoReturn]):
    _row = ProfileChangeMaterialRatio
    material_ratio_percent: Floats; before_um: Floats; after_um: Floats; change_um: Floats; floor_um: Floats


class ProfileChangeInCaseFlank(Values):
    _absent = {"engagements": None, "sliding_m": None, "k_mm3_per_n_m": None, "k_p05_mm3_per_n_m": None, "k_p95_mm3_per_n_m": None, "k_at_most_mm3_per_n_m": None, "k_times_hardness": None, "run_in_rq_um": None, "run_in_rpk_um": None}
    flank: str
    pairs: int
    is_placed: bool
    removed_nm: float
    removed_p05_nm: float
    removed_p95_nm: float
    sliding_um: float
    sliding_p05_um: float
    sliding_p95_um: float
    engagements: Optional[float]
    sliding_m: Optional[float]
    k_mm3_per_n_m: Optional[float]
    k_p05_mm3_per_n_m: Optional[float]
    k_p95_mm3_per_n_m: Optional[float]
    k_at_most_mm3_per_n_m: Optional[float]
    k_times_hardness: Optional[float]
    before_rq_um: float
    after_rq_um: float
    run_in_rq_um: Optional[float]
    before_rpk_um: float
    after_rpk_um: float
    run_in_rpk_um: Optional[float]


class ProfileChangeInCaseFlankTable(TableOf[ProfileChangeInCaseFlank, Literal["removed_nm", "removed_p05_nm", "removed_p95_nm", "sliding_um", "sliding_p05_um", "sliding_p95_um", "engagements", "sliding_m", "k_mm3_per_n_m", "k_p05_mm3_per_n_m", "k_p95_mm3_per_n_m", "k_at_most_mm3_per_n_m", "k_times_hardness", "before_rq_um", "after_rq_um", "run_in_rq_um", "before_rpk_um", "after_rpk_um", "run_in_rpk_um"], Literal["flank", "pairs", "is_placed"]]):
    _row = ProfileChangeInCaseFlank
    flank: NDArray[Any]; pairs: NDArray[Any]; is_placed: NDArray[Any]; removed_nm: Floats; removed_p05_nm: Floats
    removed_p95_nm: Floats; sliding_um: Floats; sliding_p05_um: Floats; sliding_p95_um: Floats; engagements: Floats
    sliding_m: Floats; k_mm3_per_n_m: Floats; k_p05_mm3_per_n_m: Floats; k_p95_mm3_per_n_m: Floats
    k_at_most_mm3_per_n_m: Floats; k_times_hardness: Floats; before_rq_um: Floats; after_rq_um: Floats
    run_in_rq_um: Floats; before_rpk_um: Floats; after_rpk_um: Floats; run_in_rpk_um: Floats


class ProfileChangeInCaseState(Values):
    _absent = {"loss_p05_w": None, "loss_p95_w": None, "loss_at_medians_w": None}
    state: str
    loss_w: float
    loss_p05_w: Optional[float]
    loss_p95_w: Optional[float]
    loss_at_medians_w: Optional[float]


class ProfileChangeInCaseStateTable(TableOf[ProfileChangeInCaseState, Literal["loss_w", "loss_p05_w", "loss_p95_w", "loss_at_medians_w"], Literal["state"]]):
    _row = ProfileChangeInCaseState
    state: NDArray[Any]; loss_w: Floats; loss_p05_w: Floats; loss_p95_w: Floats; loss_at_medians_w: Floats


class ProfileChangeInCaseWarning(Values):
    _absent = {"code": None, "about": None}
    code: Optional[str]
    text: str
    about: Optional[str]


class ProfileChangeInCaseWarningTable(TableOf[ProfileChangeInCaseWarning, NoReturn, Literal["code", "text", "about"]]):
    _row = ProfileChangeInCaseWarning
    code: NDArray[Any]; text: NDArray[Any]; about: NDArray[Any]


class ProfileChangeInCase(Values):
    _kinds = {"flanks": ProfileChangeInCaseFlankTable, "states": ProfileChangeInCaseStateTable, "difference": ComparisonFinishDifference, "warnings": ProfileChangeInCaseWarningTable}
    _absent = {"difference": None, "no_run_in": None}
    case: str
    conditions: str
    flanks: ProfileChangeInCaseFlankTable
    states: ProfileChangeInCaseStateTable
    difference: Optional[ComparisonFinishDifference]
    no_run_in: Optional[str]
    warnings: ProfileChangeInCaseWarningTable


class ProfileChangeValues(Values):
    _kinds = {"mean": ProfileChangeMean, "pairs": ProfileChangePairTable, "parameters": ProfileChangeParameterTable, "material_ratio": ProfileChangeMaterialRatioTable, "mean_with_bow": ProfileChangeMean, "in_case": ProfileChangeInCase}
    _absent = {"scatter_nm": None, "mean_with_bow": None, "in_case": None}
    title: str
    mean: ProfileChangeMean
    scatter_nm: Optional[float]
    warnings: list[Any]
    mean_with_bow: Optional[ProfileChangeMean]
    in_case: Optional[ProfileChangeInCase]


class RunningInTest(Values):
    _absent = {"k_mm3_per_n_m": None, "k_quantiles_mm3_per_n_m": None}
    flank: str
    engagements: float
    rq_ratio: float
    rq_ratio_quantiles: Floats
    plastic_rq_ratio: float
    k_mm3_per_n_m: Optional[float]
    k_quantiles_mm3_per_n_m: Optional[Floats]


class RunningInCourseRow(Values):
    engagements: float
    hours: float
    pinion_rq_um: float
    pinion_rq_p05_um: float
    pinion_rq_p95_um: float
    wheel_rq_um: float
    wheel_rq_p05_um: float
    wheel_rq_p95_um: float
    pinion_rpk_um: float
    pinion_rpk_p05_um: float
    pinion_rpk_p95_um: float
    wheel_rpk_um: float
    wheel_rpk_p05_um: float
    wheel_rpk_p95_um: float
    pinion_removed_nm: float
    pinion_removed_p05_nm: float
    pinion_removed_p95_nm: float
    wheel_removed_nm: float
    wheel_removed_p05_nm: float
    wheel_removed_p95_nm: float
    asperity_share: float
    asperity_share_p05: float
    asperity_share_p95: float
    film_ratio: float
    film_ratio_p05: float
    film_ratio_p95: float
    loss_w: float
    loss_p05_w: float
    loss_p95_w: float


class RunningInCourseRowTable(TableOf[RunningInCourseRow, Literal["engagements", "hours", "pinion_rq_um", "pinion_rq_p05_um", "pinion_rq_p95_um", "wheel_rq_um", "wheel_rq_p05_um", "wheel_rq_p95_um", "pinion_rpk_um", "pinion_rpk_p05_um", "pinion_rpk_p95_um", "wheel_rpk_um", "wheel_rpk_p05_um", "wheel_rpk_p95_um", "pinion_removed_nm", "pinion_removed_p05_nm", "pinion_removed_p95_nm", "wheel_removed_nm", "wheel_removed_p05_nm", "wheel_removed_p95_nm", "asperity_share", "asperity_share_p05", "asperity_share_p95", "film_ratio", "film_ratio_p05", "film_ratio_p95", "loss_w", "loss_p05_w", "loss_p95_w"], NoReturn]):
    _row = RunningInCourseRow
    engagements: Floats; hours: Floats; pinion_rq_um: Floats; pinion_rq_p05_um: Floats; pinion_rq_p95_um: Floats
    wheel_rq_um: Floats; wheel_rq_p05_um: Floats; wheel_rq_p95_um: Floats; pinion_rpk_um: Floats
    pinion_rpk_p05_um: Floats; pinion_rpk_p95_um: Floats; wheel_rpk_um: Floats; wheel_rpk_p05_um: Floats
    wheel_rpk_p95_um: Floats; pinion_removed_nm: Floats; pinion_removed_p05_nm: Floats; pinion_removed_p95_nm: Floats
    wheel_removed_nm: Floats; wheel_removed_p05_nm: Floats; wheel_removed_p95_nm: Floats; asperity_share: Floats
    asperity_share_p05: Floats; asperity_share_p95: Floats; film_ratio: Floats; film_ratio_p05: Floats
    film_ratio_p95: Floats; loss_w: Floats; loss_p05_w: Floats; loss_p95_w: Floats


class RunningInCourse(Values):
    _kinds = {"rows": RunningInCourseRowTable}
    _absent = {"done_engagements": None, "done_hours": None, "ends_at": None}
    torque_nm: float
    plastic_engagements: float
    is_settled: bool
    done_engagements: Optional[float]
    done_hours: Optional[float]
    factor: float
    factor_p05: float
    factor_p95: float
    removed_mg: Floats
    ends_at: Optional[float]
    rows: RunningInCourseRowTable


class RunningInCourseTable(TableOf[RunningInCourse, Literal["torque_nm", "plastic_engagements", "done_engagements", "done_hours", "factor", "factor_p05", "factor_p95", "ends_at"], Literal["is_settled", "removed_mg", "rows"]]):
    _row = RunningInCourse
    torque_nm: Floats; plastic_engagements: Floats; is_settled: NDArray[Any]; done_engagements: Floats
    done_hours: Floats; factor: Floats; factor_p05: Floats; factor_p95: Floats; removed_mg: NDArray[Any]
    ends_at: Floats; rows: NDArray[Any]


class RunningInValues(Values):
    _kinds = {"test": RunningInTest, "courses": RunningInCourseTable, "warnings": ProfileChangeInCaseWarningTable}
    _absent = {"loss_quantiles_w": None, "test": None}
    title: str
    engagements: float
    of_wheel: float
    loss_w: float
    loss_quantiles_w: Optional[Floats]
    test: Optional[RunningInTest]
    warnings: ProfileChangeInCaseWarningTable


class OilPlanPoint(Values):
    _absent = {"simulated_traction": None}
    load_n: float
    mean_speed_m_s: float
    slide_roll_percent: float
    temperature_c: float
    expected_traction: float
    film_ratio: float
    simulated_traction: Optional[float]


class OilPlanPointTable(TableOf[OilPlanPoint, Literal["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "expected_traction", "film_ratio", "simulated_traction"], NoReturn]):
    _row = OilPlanPoint
    load_n: Floats; mean_speed_m_s: Floats; slide_roll_percent: Floats; temperature_c: Floats
    expected_traction: Floats; film_ratio: Floats; simulated_traction: Floats


class OilPlanValues(Values):
    _kinds = {"points": OilPlanPointTable, "chosen": OilPlanPointTable}
    _absent = {"case": None, "curves": None, "loss_slopes": None, "remaining_width": None}
    program: str
    title: str
    oil: str
    case: Optional[str]
    roughness_nm: float
    radius_mm: float
    curves: Any
    points: OilPlanPointTable
    chosen: OilPlanPointTable
    loss_slopes: Optional[Floats]
    remaining_width: Optional[float]


class OilFitConstant(Values):
    _absent = {"would_help": None}
    key: str
    name: str
    unit: str
    value: float
    range_low: float
    range_high: float
    band_low: float
    band_high: float
    prior: float
    prior_range_low: float
    prior_range_high: float
    expected: float
    posterior: float
    is_identified: bool
    would_help: Optional[str]


class OilFitConstantTable(TableOf[OilFitConstant, Literal["value", "range_low", "range_high", "band_low", "band_high", "prior", "prior_range_low", "prior_range_high", "expected", "posterior"], Literal["key", "name", "unit", "is_identified", "would_help"]]):
    _row = OilFitConstant
    key: NDArray[Any]; name: NDArray[Any]; unit: NDArray[Any]; value: Floats; range_low: Floats; range_high: Floats
    band_low: Floats; band_high: Floats; prior: Floats; prior_range_low: Floats; prior_range_high: Floats
    expected: Floats; posterior: Floats; is_identified: NDArray[Any]; would_help: NDArray[Any]


class OilFitPoint(Values):
    _absent = {"dropped": None}
    file: str
    line: int
    curve: int
    load_n: float
    mean_speed_m_s: float
    slide_roll_percent: float
    temperature_c: float
    readings: int
    pressure_gpa: float
    film_ratio: float
    traction: float
    has_measured_film: bool
    fitted: float
    residual_sigma: float
    dropped: Optional[str]


class OilFitPointTable(TableOf[OilFitPoint, Literal["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "pressure_gpa", "film_ratio", "traction", "fitted", "residual_sigma"], Literal["file", "line", "curve", "readings", "has_measured_film", "dropped"]]):
    _row = OilFitPoint
    file: NDArray[Any]; line: NDArray[Any]; curve: NDArray[Any]; load_n: Floats; mean_speed_m_s: Floats
    slide_roll_percent: Floats; temperature_c: Floats; readings: NDArray[Any]; pressure_gpa: Floats; film_ratio: Floats
    traction: Floats; has_measured_film: NDArray[Any]; fitted: Floats; residual_sigma: Floats; dropped: NDArray[Any]


class OilFitValues(Values):
    _kinds = {"constants": OilFitConstantTable, "points": OilFitPointTable, "warnings": NoteTable}
    _absent = {"lubricant": None, "other_law": None, "nuisance": None}
    program: str
    title: str
    lubricant: Any
    sources: list[Any]
    pressure_law: str
    is_law_decided: bool
    is_law_decided_by_points: bool
    total_squared: Floats
    squares_per_point: float
    law_error: float
    counts: Floats
    temperatures_c: Floats
    pressure_max_gpa: float
    correlations: list[Any]
    combinations: list[Any]
    other_law: Any
    nuisance: Any
    points: OilFitPointTable
    warnings: NoteTable


class StribeckState(Values):
    rubbing_s: float
    points: int
    boundary_friction: float
    scatter: float
    slope_per_decade: float


class StribeckStateTable(TableOf[StribeckState, Literal["rubbing_s", "boundary_friction", "scatter", "slope_per_decade"], Literal["points"]]):
    _row = StribeckState
    rubbing_s: Floats; points: NDArray[Any]; boundary_friction: Floats; scatter: Floats; slope_per_decade: Floats


class StribeckPoint(Values):
    file: str
    line: int
    load_n: float
    mean_speed_m_s: float
    slide_roll_percent: float
    temperature_c: float
    rubbing_s: float
    readings: int
    film_ratio: float
    traction: float
    is_boundary: bool


class StribeckPointTable(TableOf[StribeckPoint, Literal["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "rubbing_s", "film_ratio", "traction"], Literal["file", "line", "readings", "is_boundary"]]):
    _row = StribeckPoint
    file: NDArray[Any]; line: NDArray[Any]; load_n: Floats; mean_speed_m_s: Floats; slide_roll_percent: Floats
    temperature_c: Floats; rubbing_s: Floats; readings: NDArray[Any]; film_ratio: Floats; traction: Floats
    is_boundary: NDArray[Any]


class StribeckValues(Values):
    _kinds = {"states": StribeckStateTable, "points": StribeckPointTable}
    program: str
    title: str
    sources: list[Any]
    roughness_nm: float
    boundary_friction: float
    range: Floats
    deviation: float
    band: Floats
    states: StribeckStateTable
    temperatures_c: Floats
    points: StribeckPointTable
    warnings: list[Any]


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
    mesh: Any
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
    scans: Any
    no_scans: Any
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
    loss_p05_w: NDArray[Any]
    loss_p95_w: NDArray[Any]
    loss_at_medians_w: NDArray[Any]
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
