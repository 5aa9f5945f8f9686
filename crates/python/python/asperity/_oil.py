"""Oils: traction of ball and disc, constants from traction curves, plans, boundary friction."""

from __future__ import annotations

import os
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _asperity
from ._errors import Code
from ._case import Case, CaseLike, as_case
from ._columns import table_of
from ._record import Table
from ._study import Study
from ._values import OilFitConstantTable, OilFitValues, OilPlanValues, StribeckValues, TractionValues

if TYPE_CHECKING:
    import pandas


OilLike = Union[str, CaseLike]
"""Name of an oil of the library, path of an oil file or of a file with the table ``[lubricant]`` only, or a case whose oil is taken."""


class Traction(Study, TractionValues):
    """Predicted traction: ``over_slide``, ``over_speed`` (load_n, mean_speed_m_s, slide_roll_percent, temperature_c,
    traction, traction_p05, traction_p95, film_nm, film_ratio)."""

    def to_pandas(self) -> pandas.DataFrame:
        """One row per slide-to-roll ratio and temperature."""
        return self.over_slide.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [("largest Hertz pressure", f"{self._values['max_pressure_gpa']:.2f} GPa")]


class OilFit(Study, OilFitValues):
    """Constants of an oil fitted to traction curves: ``constants`` (key, value, range of 5 to 95 %, is_identified ...),
    ``combinations``, ``nuisance``, ``points``, ``pressure_law``, ``other_law``, ``warnings``."""

    @property
    def constants(self) -> OilFitConstantTable:
        """One row per constant."""
        return OilFitConstantTable(self._values["constants"])

    def apply(self, case: CaseLike, folder: Union[str, PathLike[str]]) -> Case:
        """The case with the oil of this fit: its constants, whose band goes into the band of its losses.

        Parameters:
            case: the case.
            folder: folder of the fit, written if it does not exist; the case reads its ``oil.toml``.

        Returns:
            Another `Case`.

        Raises:
            AsperityError: the folder cannot be written (E401), or the case is not valid with this oil.

        Example:
            >>> curves = asperity.oil_traction("m100").over_slide
            >>> columns = ["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction"]
            >>> case = asperity.oil_fit(curves[columns], "m100").apply(asperity.demo(), "fit")
            >>> case.inputs.lubricant.oil_file.endswith("oil.toml")
            True
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
        return self.points.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [
            (str(one["name"]), f"{one['value']:.4g} ({one['range'][0]:.4g}..{one['range'][1]:.4g}) {one['unit']}")
            for one in self._values["constants"]
        ]


def _sd_of(key: str) -> str:
    """Name of the standard deviation of a constant."""
    return "sd_per_k" if key.endswith("_temperature") else "sd_ln"


class OilPlan(Study, OilPlanValues):
    """Traction measurements to make: ``curves``, ``points``, ``chosen``, ``stages`` with the errors they leave."""

    @property
    def stages(self) -> Table:
        """One row per amount of measurement: ``name``, ``points``, ``minutes``, and of each constant and the loss ``sd_ln``, the standard
        deviation of its logarithm; of the temperature coefficient ``sd_per_k``, in 1/K."""
        return Table(
            [
                {
                    **{name: stage[name] for name in ("name", "points", "minutes")},
                    **{f"{one['key']}_{_sd_of(one['key'])}": one["deviation"] for one in stage["constants"]},
                    "loss_sd_ln": stage["loss_deviation"],
                }
                for stage in self._values["stages"]
            ],
            declared={
                **{"name": "str", "points": "int", "minutes": "float", "loss_sd_ln": "Optional[float]"},
                **{f"{one['key']}_{_sd_of(one['key'])}": "float" for one in self._values["stages"][0]["constants"]},
            },
        )

    def to_pandas(self) -> pandas.DataFrame:
        """One row per point of the standard plan."""
        return self.points.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        return [(str(stage["name"]), f"{stage['points']} points, {stage['minutes']:.0f} min") for stage in self._values["stages"]]


class Stribeck(Study, StribeckValues):
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
        return self.points.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        low, high = self._values["range"]
        return [("boundary friction", f"{self._values['boundary_friction']:.4g} ({low:.4g}..{high:.4g})")]


def raw_oil(oil: OilLike) -> Union[str, _asperity.Case]:
    """The oil as the compiled part takes it: a text that does not name a file is the name of an oil."""
    if isinstance(oil, str) and not os.path.splitext(oil)[1] and not os.path.exists(oil):
        return oil.lower()
    if isinstance(oil, (str, PathLike)) and _asperity.is_oil(fspath(oil)):
        return fspath(oil)
    return as_case(oil)._raw


def tables_of_curves(curves: Any, what: str) -> list[tuple[str, Optional[str]]]:
    """Names of tables, with the text of each that is not a file."""
    many = curves if isinstance(curves, (list, tuple)) else [curves]
    names = [what] if len(many) == 1 else [f"{what} {number}" for number in range(1, len(many) + 1)]
    return [table_of(table, name, Code.E317) for table, name in zip(many, names)]
