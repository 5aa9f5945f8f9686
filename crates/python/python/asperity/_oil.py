"""Oils: traction of ball and disc, constants from traction curves, plans, boundary friction."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _asperity
from ._errors import Code
from ._case import Case, CaseLike, as_case
from ._columns import Columns, table_text
from ._quantity import Numbers, Quantities, Quantity, operating, stated, stated_or_none
from ._record import Table, warned
from ._study import Study

if TYPE_CHECKING:
    import pandas

    from .keys import TemperatureColumn, Zero

OilLike = Union[str, CaseLike]
"""Name of an oil of the library, or a case whose oil is taken."""


class Traction(Study):
    """Predicted traction: ``over_slide``, ``over_speed`` (load_n, mean_speed_m_s, slide_roll_percent, temperature_c,
    traction, traction_p05, traction_p95, film_nm, film_ratio)."""

    def to_pandas(self) -> pandas.DataFrame:
        """One row per slide-to-roll ratio and temperature."""
        return Table(self._values["over_slide"]).to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [("largest Hertz pressure", f"{self._values['max_pressure_gpa']:.2f} GPa")]


class OilFit(Study):
    """Constants of an oil fitted to traction curves: ``constants`` (key, value, range of 5 to 95 %, is_identified ...),
    ``combinations``, ``nuisance``, ``points``, ``pressure_law``, ``other_law``, ``warnings``."""

    @property
    def constants(self) -> Table:
        """One row per constant."""
        return Table(self._values["constants"])

    def apply(self, case: CaseLike, folder: Union[str, PathLike[str]]) -> Case:
        """The case with the oil of this fit: its constants, whose band goes into the band of its losses.

        Args:
            case: the case.
            folder: folder of the fit, written if it does not exist; the case reads its ``oil.toml``.
        """
        if not os.path.exists(folder):
            self.write(folder)
        case = as_case(case)
        stated = [key for key, value in case.to_dict()["lubricant"].items() if value is not None]
        # What the case states of its oil would come before the constants of the fit.
        keys = {"oil_file": os.path.abspath(os.path.join(folder, "oil.toml")), **dict.fromkeys(stated)}
        return case._with({f"lubricant.{key}": value for key, value in keys.items()})

    def to_pandas(self) -> pandas.DataFrame:
        """One row per set point: where, measured, fitted, residual, the rule that drops it."""
        return Table(self._values["points"]).to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [
            (str(one["name"]), f"{one['value']:.4g} ({one['range'][0]:.4g}..{one['range'][1]:.4g}) {one['unit']}")
            for one in self._values["constants"]
        ]


class OilPlan(Study):
    """Traction measurements to make: ``curves``, ``points``, ``chosen``, ``stages`` with the errors they leave."""

    @property
    def stages(self) -> Table:
        """One row per amount of measurement: points, minutes, standard deviation of each constant and of the loss."""
        return Table(
            [
                {
                    **{name: stage[name] for name in ("name", "points", "minutes")},
                    **{one["key"]: one["deviation"] for one in stage["constants"]},
                    "loss": stage["loss_deviation"],
                }
                for stage in self._values["stages"]
            ]
        )

    def to_pandas(self) -> pandas.DataFrame:
        """One row per point of the minimal plan."""
        return Table(self._values["points"]).to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [(str(stage["name"]), f"{stage['points']} points, {stage['minutes']:.0f} min") for stage in self._values["stages"]]


class Stribeck(Study):
    """Boundary friction of rubbed specimens: ``boundary_friction``, ``range`` of 5 to 95 %, ``states`` before and after
    rubbing, ``points``."""

    def apply(self, case: CaseLike) -> Case:
        """The case with this boundary friction, whose band goes into the band of its losses."""
        low, high = self._values["band"]
        found = {"value": self._values["boundary_friction"], "low": low, "high": high}
        source = ", ".join(name for name, _ in self._values["sources"])
        return as_case(case)._with({"calibration.boundary_friction": found, "calibration.source": source})

    def to_pandas(self) -> pandas.DataFrame:
        """One row per set point."""
        return Table(self._values["points"]).to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        low, high = self._values["range"]
        return [("boundary friction", f"{self._values['boundary_friction']:.4g} ({low:.4g}..{high:.4g})")]


def oil_traction(
    oil: OilLike,
    *,
    load: Quantity = "30 N",
    speed: Quantity = "2 m/s",
    slide_to_roll: float = 0.05,
    temperature_c: Optional[Numbers] = None,
    temperature: Optional[Quantities] = None,
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    rq: Quantity = "15 nm",
    threads: Optional[int] = None,
) -> Traction:
    """Predicts the traction of ball and disc over slide-to-roll ratio and speed, where the film separates them.

    Args:
        oil: the oil.
        load, speed: of the curves over the slide-to-roll ratio.
        slide_to_roll: of the curves over the speed.
        temperature_c, temperature: of the oil bath, numbers or text with a unit; default 40, 80 and 120 °C.
        ball_radius, second_radius, rq: specimens; a flat disc by default, and the roughness of both together.
        threads: as in `Case.run`.
    """
    conditions = (stated(load, "Force", "load"), stated(speed, "Speed", "speed"), slide_to_roll)
    found = operating("temperature_c", temperature_c, temperature)
    temperatures = [40.0, 80.0, 120.0] if found is None else found.tolist()
    specimens = _specimens(ball_radius, second_radius, rq)
    return warned(Traction(_asperity.oil_traction(_oil(oil), conditions, temperatures, specimens, threads)))


def oil_fit(
    curves: Union[Columns, Sequence[Columns]],
    oil: OilLike,
    *,
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    rq: Quantity = "15 nm",
    temperature_column: TemperatureColumn = "lube",
    wide: bool = False,
    zero: Zero = "curve",
    point_sd: float = 0.015,
    point_floor: float = 3e-4,
    force: bool = False,
    threads: Optional[int] = None,
) -> OilFit:
    """Fits Eyring stress, limiting shear stress with its fall, and pressure-viscosity factor to measured traction.

    Args:
        curves: one or several files, frames or columns, with the columns of ``asperity oil fit``: load_n,
            mean_speed_m_s, slide_roll_percent, temperature_c, traction.
        oil: the oil, for viscosity and family.
        ball_radius, second_radius, rq: specimens of rows that state none.
        temperature_column: probe of an export, "lube" or "pot".
        wide: leave the constants to the points, with wide priors.
        zero: zero of each "curve", a "common" one, or "none".
        point_sd, point_floor: error of points without sigma, relative and at least.
        force: accept constants of no known oil.
        threads: as in `Case.run`.
    """
    specimens = _specimens(ball_radius, second_radius, rq)
    errors = (zero, point_sd, point_floor)
    tables = _tables(curves, "curves")
    return warned(OilFit(_asperity.oil_fit(tables, _oil(oil), specimens, temperature_column, wide, errors, force, threads)))


def oil_plan(
    oil: OilLike,
    case: Optional[CaseLike] = None,
    *,
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    rq: Quantity = "15 nm",
    wide: bool = False,
    zero: Zero = "curve",
    point_sd: float = 0.015,
    point_floor: float = 3e-4,
    threads: Optional[int] = None,
) -> OilPlan:
    """Plans the traction measurements that would determine the constants of an oil.

    Args:
        oil: the oil.
        case: the case whose loss is to be narrowed; the case of the oil if it is one.
        ball_radius, second_radius, rq, wide, zero, point_sd, point_floor, threads: as in `oil_fit`.
    """
    raw = None if case is None else as_case(case)._raw
    specimens = _specimens(ball_radius, second_radius, rq)
    return warned(OilPlan(_asperity.oil_plan(_oil(oil), raw, specimens, wide, (zero, point_sd, point_floor), threads)))


def stribeck(
    curves: Union[Columns, Sequence[Columns]],
    oil: OilLike,
    *,
    rubbing: Sequence[Quantity] = (),
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    rq: Quantity = "15 nm",
    temperature_column: TemperatureColumn = "lube",
) -> Stribeck:
    """Boundary friction of rubbed specimens from Stribeck curves.

    Args:
        curves: one or several files, frames or columns, as of `oil_fit`, with a column rubbing_s.
        oil: the oil, for the film.
        rubbing: time of rubbing before each of several curves, in place of the column.
        ball_radius, second_radius, rq, temperature_column: as in `oil_fit`.
    """
    times = [stated(one, "Time", "rubbing") for one in rubbing]
    specimens = _specimens(ball_radius, second_radius, rq)
    return warned(Stribeck(_asperity.stribeck(_tables(curves, "curves"), _oil(oil), times, specimens, temperature_column)))


def _oil(oil: OilLike) -> Union[str, _asperity.Case]:
    """The oil as the compiled part takes it: a text that does not name a file is the name of an oil."""
    if isinstance(oil, str) and not os.path.splitext(oil)[1] and not os.path.exists(oil):
        return oil.lower()
    return as_case(oil)._raw


def _specimens(ball: Quantity, second: Optional[Quantity], rq: Quantity) -> tuple[float, Optional[float], float]:
    length = "Length"
    return stated(ball, length, "ball_radius"), stated_or_none(second, length, "second_radius"), stated(rq, length, "rq")


def _tables(curves: Any, what: str) -> list[tuple[str, Optional[str]]]:
    """Names of tables, with the text of each that is not a file."""
    many = curves if isinstance(curves, (list, tuple)) else [curves]
    tables: list[tuple[str, Optional[str]]] = []
    for number, table in enumerate(many, 1):
        if isinstance(table, (str, PathLike)):
            tables.append((fspath(table), None))
        else:
            name = what if len(many) == 1 else f"{what} {number}"
            tables.append((name, table_text(table, name, Code.E317)))
    return tables
