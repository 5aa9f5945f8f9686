"""Boundary layer and film traction from the losses of a rig."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Optional, Union

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._columns import Columns, table_text
from ._html import page
from ._progress import Progress, Told
from ._record import Record, Table, warned

if TYPE_CHECKING:
    import pandas

    from .keys import CalibratedParameter


class Calibration(Record):
    """Constants of boundary layer and film that no data sheet holds, fitted to measured losses, with their bands.

    ``parameters`` (key, name, value, band, default, verdict ...; values in SI units), ``points`` (measured_w,
    fitted_w, residual_sigma ...), ``nuisance``, ``correlations``, ``held_out``, ``identifiability``, ``block`` to
    paste into a case file.
    """

    def __init__(self, raw: _asperity.Calibration) -> None:
        super().__init__(json.loads(raw.json()))
        self._raw = raw

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
        return as_case(case)._with(json.loads(self._raw.keys()))

    def write(self, folder: Union[str, PathLike[str]]) -> None:
        """Writes the folder of ``asperity calibrate``."""
        self._raw.write(fspath(folder))

    def to_pandas(self) -> pandas.DataFrame:
        """One row per measurement: where, measured, fitted, residual."""
        return self.points.to_pandas()

    def __str__(self) -> str:
        return self._raw.summary()

    def __repr__(self) -> str:
        parameters = ", ".join(f"{one['name']} {one['verdict']}" for one in self._values["parameters"])
        return f"<Calibration {self._values['title']!r}: {parameters}>"

    def _repr_html_(self) -> str:
        rows = [
            (str(one["name"]), f"{one['value']:.4g} ({one['band'][0]:.4g}..{one['band'][1]:.4g}), {one['verdict']}")
            for one in self._values["parameters"]
        ]
        return page(str(self._values["title"]), rows, None)


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
        name, text = "rig", table_text(rig, "rig", "E134")
    beside = None if case is None else as_case(case)._raw
    named = [(key, as_case(one)._raw) for key, one in (cases or {}).items()]
    with Told(progress, "evaluations") as told:
        found = Calibration(_asperity.calibrate(name, text, folder, beside, named, list(hold), threads, told))
    return warned(found)
