"""Boundary layer and film traction from the losses of a rig."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._columns import Columns, table_text
from ._errors import Code
from ._progress import Progress, Steps
from ._record import Table, warned
from ._study import RawStudy, Study, as_json

if TYPE_CHECKING:
    import pandas


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


def designed(
    case: CaseLike, settings: Mapping[str, Any], threads: Optional[int], progress: Optional[Progress]
) -> Design:
    """The design of measurements by its settings."""
    with Steps(progress, _asperity.steps("design")) as steps:
        return warned(Design(_asperity.design(as_case(case)._raw, as_json(settings), threads, steps)))


class Evidence(Study):
    """Intervals of a loss that measurements would leave: ``rows`` (key, measurement, hours, width ...)."""

    @property
    def rows(self) -> Table:
        """One row per measurement, the one that narrows the interval most first."""
        return Table(self._values["rows"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per measurement."""
        return self.rows.to_pandas()


def calibrated(
    rig: Columns,
    case: Optional[CaseLike],
    cases: Optional[Mapping[str, CaseLike]],
    settings: Mapping[str, Any],
    threads: Optional[int],
    progress: Optional[Progress],
) -> Calibration:
    """The calibration on the table of a rig by its settings."""
    folder, text = "", None
    if isinstance(rig, (str, PathLike)):
        name = fspath(rig)
        folder = os.path.dirname(name)
    else:
        name, text = "rig", table_text(rig, "rig", Code.E134)
    beside = None if case is None else as_case(case)._raw
    named = [(key, as_case(one)._raw) for key, one in (cases or {}).items()]
    with Steps(progress, _asperity.steps("calibrate")) as steps:
        return warned(Calibration(_asperity.calibrate(name, text, folder, beside, named, as_json(settings), threads, steps)))
