"""The mixed lubricated contact of a case in time."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Optional

from . import _asperity
from ._case import CaseLike, as_case
from ._errors import checked_or_none, json_text
from ._html import Chart, page, shown
from ._progress import Progress, Steps
from ._quantity import Floats, Quantity, stated_or_none
from ._record import Record, variable, warned

if TYPE_CHECKING:
    import xarray


class EhlRecord(Record):
    """A record of transient mixed lubrication: means with standard errors, mean pressure and film along the contact.

    ``solid_share`` and ``solid_share_standard_error``, ``mean_film_um``, ``central_film_um`` (smooth), ``friction``
    (``shifted``: boundary friction with the weight min(1, exp(-(h - H_b)/h_b)), ``graded``: exp(-h/h_b),
    ``stepped``, ``film_alone``), ``with_heat`` (the same ``friction`` with the heat of film and surfaces, and their rises in K), ``load_below``, ``max_pressure_pa``; ``x`` (m), ``mean_pressure`` (Pa), ``mean_film``
    (m) of shape (n,).
    """

    @property
    def x(self) -> Floats:
        """Positions along the contact, m."""
        x: Floats = self._values["x"]
        return x

    def plot(self, ax: Any = None) -> Any:
        """Mean pressure in MPa over x in µm, on axes of matplotlib or as a `Chart`."""
        pressure = (self._values["mean_pressure"] * 1e-6).tolist()
        return shown(Chart("Mean pressure", (self.x * 1e6).tolist(), [("pressure", pressure)], ("x in µm", "MPa")), ax)

    def to_xarray(self) -> xarray.Dataset:
        """Mean pressure and film over x, the numbers as attributes."""
        import xarray

        units = {"mean_pressure": "Pa", "mean_film": "m"}
        arrays = {name: variable("x", name, self._values[name], unit) for name, unit in units.items()}
        numbers = {name: value for name, value in self._values.items() if isinstance(value, (int, float))}
        return xarray.Dataset(arrays, coords={"x": variable("x", "x", self.x, "m")}, attrs=numbers)

    def __repr__(self) -> str:
        of = self._values
        return f"<EhlRecord: solid share {of['solid_share']:.4g}, mean film {of['mean_film_um']:.4g} µm>"

    def _repr_html_(self) -> str:
        of = self._values
        rows = [
            ("load on films below 20 nm", f"{100 * of['solid_share']:.4g} %"),
            ("mean film", f"{of['mean_film_um']:.4g} µm"),
            ("smooth central film", f"{of['central_film_um']:.4g} µm"),
            ("largest pressure", f"{of['max_pressure_pa'] * 1e-9:.4g} GPa"),
        ]
        return page("Mixed lubrication", rows, str(self.plot()))


def ehl(
    case: CaseLike,
    position: Optional[float] = None,
    *,
    cells: int = 512,
    half_widths: float = 20.0,
    start: float = 3.0,
    records: int = 1,
    eyring_stress: Optional[Quantity] = None,
    compare: bool = False,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> EhlRecord:
    """Solves the mixed lubricated contact of a case at one place in time, the reference of the faster laws.

    Parameters:
        case: the case, both of whose flanks have traces.
        position: place on the path, 0 at A and 1 at E; default that of the case.
        cells: cells across the film, a multiple of 64.
        half_widths: travel of a reference solution in Hertz half-widths.
        start: travel before the record begins.
        records: records from other places of the traces, whose mean is given.
        eyring_stress: Eyring stress instead of the one of the base oil, ``"5 MPa"``.
        compare: whether the laws of load sharing are set beside it (``comparison``).
        threads, progress: as in `Case.run`. Ctrl-C ends the work.

    Returns:
        An `EhlRecord`.

    Raises:
        AsperityError: a flank has no trace (E205), or the film cannot be solved (E307), among others.

    Example:
        >>> case = asperity.Case(asperity.demo())
        >>> record = asperity.ehl(case, 0.25, cells=128, half_widths=2, start=0)
        >>> 0 <= record.solid_share <= 1
        True
    """
    asked = {
        "position": position,
        "cells": cells,
        "half_widths": half_widths,
        "start": start,
        "records": records,
        "eyring_stress": stated_or_none(eyring_stress, "Pressure", "eyring_stress"),
        "compare": compare,
    }
    with Steps(progress, "half-widths travelled") as steps:
        text, arrays = _asperity.ehl(as_case(case)._raw, json_text(asked), checked_or_none("threads", threads, int), steps)
    return warned(EhlRecord({**json.loads(text), **arrays}))
