"""Choices of arguments and names of columns.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from typing import Literal


Formulation = Literal[
    "corrected", "paper",
]


Detail = Literal[
    "losses", "contacts", "fields",
]


Band = Literal[
    "none", "nodes",
]


ExportFormat = Literal[
    "csv", "wide", "vecto", "modelica", "lossy-gear", "matlab", "fmu", "fastsim",
]


Form = Literal[
    "none", "mean", "level", "poly2", "circle", "involute",
]


TraceForm = Literal[
    "none", "mean", "level", "poly2", "circle",
]


Ends = Literal[
    "cut", "reg0", "reg1", "reflect",
]


Standard = Literal[
    "iso4287", "iso21920",
]


Boundary = Literal[
    "free", "periodic", "periodic-spectral",
]


FilmLaw = Literal[
    "steady", "dowson-toyoda", "moes", "ertel-grubin", "hamrock-dowson", "hamrock-dowson-line",
]


ThermalLaw = Literal[
    "gupta", "none",
]


FrictionLaw = Literal[
    "xu", "iso-14179-2", "iso-14179-1", "benedict-kelley", "matsumoto", "doleschel", "eyring-arana", "constant",
]


LawOf = Literal[
    "film-friction", "film-thickness", "load-share", "load-distribution",
]


Zero = Literal[
    "curve", "common", "none",
]


TemperatureColumn = Literal[
    "lube", "pot",
]


CalibratedParameter = Literal[
    "boundary_friction", "boundary_layer", "limiting_shear", "eyring_stress",
]


RoughnessParameter = Literal[
    "rpk", "rq", "rdq",
]


WornFlank = Literal[
    "pinion", "wheel",
]


SurfaceKind = Literal[
    "self-affine", "non-gaussian", "plateau-honed", "ground", "fitted",
]


LikeMethod = Literal[
    "pieces", "spectrum",
]


Amplitudes = Literal[
    "fixed", "random",
]


LengthUnit = Literal[
    "m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin",
]


DecimalSign = Literal[
    "point", "comma",
]


Separator = Literal[
    "semicolon", "tab", "comma", "blank", "none",
]


Encoding = Literal[
    "utf-8", "utf-16le", "utf-16be", "windows-1252",
]


Gaps = Literal[
    "refuse", "interpolate",
]


TraceLine = Literal[
    "row", "column", "mean", "mean-column",
]


Abscissa = Literal[
    "distance", "roll-length", "roll-degrees", "roll-radians",
]


Uneven = Literal[
    "refuse", "resample",
]


ResultName = Literal[
    "schema_version", "program", "title", "case_file", "mesh", "formulation", "summary", "published_laws", "load",
    "path", "points", "records", "uncertainty", "bulk", "gearbox", "micropitting", "running_in", "run_in", "ridges",
    "no_ridges", "scans", "no_scans", "warnings", "flanks", "pairs", "gears", "lubricant", "film_constants", "inputs",
    "defaults", "equations", "references",
]


SummaryName = Literal[
    "scope", "gearbox_efficiency", "gearbox_loss_w", "efficiency", "efficiency_deviation", "offsets", "power_in_w",
    "torque_out_nm", "loss_w", "loss_at_medians_w", "sliding_w", "film_w", "lubricated_asperity_w", "boundary_w",
    "rolling_w", "deformation_w", "deformation_in_contact_w", "hysteresis_w", "elastic_cycling_w", "asperity_share",
    "asperity_share_standard_error", "boundary_share", "mu_equivalent", "loss_factor_ohlendorf", "loss_factor_local",
    "mixed_share", "regime", "positions", "worst_load_error", "worst_duality_gap",
]


PathColumn = Literal[
    "position", "s_mm", "path_fraction", "weight_m", "line_load_n_per_mm", "sliding_load_n_per_mm", "load_share",
    "radius_mm", "u1_m_per_s", "u2_m_per_s", "sliding_m_per_s", "entrainment_m_per_s", "slide_to_roll",
    "half_width_um", "hertz_pressure_mpa", "thermal_reduction", "film_central_um", "film_minimum_um", "lambda_star",
    "film_ratio", "mixed_share", "regime", "film_share", "film_share_standard_error", "boundary_of_asperities",
    "boundary_share", "mean_gap_um", "roughness_over_film", "full_film", "mu_film", "mu", "flash_k", "flash_max_k",
    "sliding_w_per_m", "sliding_deviation_w_per_m", "sliding_standard_error_w_per_m", "sliding_error_freedom",
    "face_zone", "film_w_per_m", "lubricated_asperity_w_per_m", "boundary_w_per_m", "rolling_w_per_m",
    "contact_fraction", "p_max_mpa", "plastic_work_j_per_m", "von_mises_max_mpa", "von_mises_depth_um",
    "yield_depth_um", "yield_share", "iterations", "load_error",
]


MapName = Literal[
    "loss_w", "loss_p05_w", "loss_p95_w", "loss_at_medians_w", "loss_torque_nm", "loss_torque_deviation_nm",
    "efficiency", "efficiency_deviation", "sliding_w", "film_w", "lubricated_asperity_w", "boundary_w", "rolling_w",
    "deformation_w", "mu_equivalent", "mixed_share", "extended", "code", "regime",
]
