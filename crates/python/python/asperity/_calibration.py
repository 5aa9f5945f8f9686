"""Boundary layer and film traction from the losses of a rig."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._columns import Columns, table_text
from ._errors import AsperityError, Code
from ._progress import Progress, Told
from ._quantity import Numbers, axis_of, flat, operating
from ._record import Table, warned
from ._study import RawStudy, Study

if TYPE_CHECKING:
    import pandas

    from .keys import CalibratedParameter


class Calibration(Study):
    """Constants of boundary layer and film that no data sheet holds, fitted to measured losses, with their bands.

    ``parameters`` (key, name, value, band, default, verdict ...; values in SI units), ``points`` (measured_w,
    fitted_w, residual_sigma ...), ``nuisance``, ``correlations``, ``held_out``, ``identifiability``, ``block`` to
    paste into a case file.
    """

    def __init__(self, raw: RawStudy, keys: Optional[str] = None) -> None:
        super().__init__(raw)
        self._keys = raw.keys() if isinstance(raw, _asperity.Calibration) else keys

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (*super().__reduce__()[1], self._keys)

    @property
    def parameters(self) -> Table:
        """One row per parameter."""
        return Table(self._values["parameters"])

    @property
    def points(self) -> Table:
        """One row per measurement beside the fit."""
        return Table(self._values["points"])

    def apply(self, case: CaseLike) -> Case:
        """The case with the parameters found, whose bands go into the band of its losses."""
        return as_case(case)._with(json.loads(self._keys or "{}"))

    def to_pandas(self) -> pandas.DataFrame:
        """One row per measurement: where, measured, fitted, residual."""
        return self.points.to_pandas()

    def __repr__(self) -> str:
        parameters = ", ".join(f"{one['name']} {one['verdict']}" for one in self._values["parameters"])
        return f"<Calibration {self._values['title']!r}: {parameters}>"

    def _rows(self) -> list[tuple[str, str]]:
        return [
            (str(one["name"]), f"{one['value']:.4g} ({one['band'][0]:.4g}..{one['band'][1]:.4g}), {one['verdict']}")
            for one in self._values["parameters"]
        ]


class Design(Study):
    """Measurements on a rig that would narrow the calibrated constants: ``points``, ``limits``, ``parameters`` ..."""

    @property
    def points(self) -> Table:
        """One row per point to measure, by temperature."""
        return Table(self._values["points"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per point to measure."""
        return self.points.to_pandas()


def design(
    case: CaseLike,
    *,
    torque_max_nm: Optional[float] = None,
    speed_max_rpm: Optional[float] = None,
    torque_nm: Optional[Numbers] = None,
    speed_rpm: Optional[Numbers] = None,
    temperature_c: Optional[Numbers] = None,
    hours: Optional[float] = None,
    minutes_per_point: Optional[float] = None,
    sigma: Optional[float] = None,
    assemblies: Optional[int] = None,
    hold: Sequence[CalibratedParameter] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Design:
    """Plans the points of a rig whose losses determine the calibrated constants best, as ``asperity calibrate --design``.

    Args:
        case: the gears and flanks on the rig.
        torque_max_nm, speed_max_rpm: reach of the rig; default the largest of the case's map.
        torque_nm, speed_rpm, temperature_c: torques, speeds and oil temperatures to choose from; default within the reach.
        hours, minutes_per_point: measuring time without heating; default 8 hours at 15 minutes a point.
        sigma: standard deviation of a point over its loss; default 0.03.
        assemblies: number of assemblies; default 2.
        hold: as in `calibrate`.
        threads, progress: as in `Case.run`.
    """

    def nodes(own: str, given: Optional[Numbers]) -> Optional[list[float]]:
        found = operating(own, given, None)
        return None if found is None else axis_of(flat(found, own), own)

    positive = {
        "torque_max_nm": torque_max_nm,
        "speed_max_rpm": speed_max_rpm,
        "hours": hours,
        "minutes_per_point": minutes_per_point,
        "sigma": sigma,
    }
    for name, value in positive.items():
        if value is not None and not 0.0 < value < math.inf:
            raise AsperityError(f"{name} = {value}: must be positive", Code.E209, "Correct the limit of the rig.")
    limits = {
        **positive,
        "torque_nm": nodes("torque_nm", torque_nm),
        "speed_rpm": nodes("speed_rpm", speed_rpm),
        "temperature_c": nodes("temperature_c", temperature_c),
        "assemblies": assemblies,
    }
    with Told(progress, "evaluations") as told:
        return warned(Design(_asperity.design(as_case(case)._raw, json.dumps(limits), list(hold), threads, told)))


class Evidence(Study):
    """Intervals of a loss that measurements would leave: ``rows`` (key, measurement, hours, width ...)."""

    @property
    def rows(self) -> Table:
        """One row per measurement, the one that narrows the interval most first."""
        return Table(self._values["rows"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per measurement."""
        return self.rows.to_pandas()


def calibrate(
    rig: Columns,
    case: Optional[CaseLike] = None,
    *,
    cases: Optional[Mapping[str, CaseLike]] = None,
    hold: Sequence[CalibratedParameter] = (),
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Calibration:
    """Fits boundary friction, boundary layer, limiting shear and Eyring stress to the losses of a rig.

    Args:
        rig: the measurements, with the columns of ``asperity calibrate``: torque_nm, speed_rpm, temperature_c, loss_w
            (or torque_loss_nm), sigma_w, includes, and where they are known assembly, run, order, flank_state, case.
            A frame or columns may say in a column ``simulated`` that their losses are simulated.
        case: the case of rows that name none.
        cases: cases by the names in the column ``case``; others are files relative to the table, or to the working
            directory.
        hold: parameters that stay at the value of the case, by their keys: ``["boundary_friction"]``.
        threads, progress: as in `Case.run`.
    """
    folder, text = "", None
    if isinstance(rig, (str, PathLike)):
        name = fspath(rig)
        folder = os.path.dirname(name)
    else:
        name, text = "rig", table_text(rig, "rig", Code.E134)
    beside = None if case is None else as_case(case)._raw
    named = [(key, as_case(one)._raw) for key, one in (cases or {}).items()]
    with Told(progress, "evaluations") as told:
        found = Calibration(_asperity.calibrate(name, text, folder, beside, named, list(hold), threads, told))
    return warned(found)
