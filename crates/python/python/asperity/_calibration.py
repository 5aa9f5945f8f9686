"""Boundary layer and film traction from the losses of a rig."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._keys import Schema
from ._quantity import SI_UNITS
from ._record import Table, with_ends
from ._study import Study, files_of
from ._values import CalibrationParameterTable, CalibrationPointTable, CalibrationValues, DesignParameterTable, DesignPointTable, DesignValues, EvidenceRowTable, EvidenceValues

if TYPE_CHECKING:
    import pandas


def with_units(parameters: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows of parameters with the units of their values."""

    def unit(key: str) -> str:
        quantity = Schema().at("calibration").at(key).at("value").quantity
        return SI_UNITS[quantity] if quantity else ""

    return [{"key": row["key"], "name": row["name"], "unit": unit(row["key"]), **row} for row in parameters]


class Calibration(Study, CalibrationValues):
    """Constants of boundary layer and film that no data sheet holds, fitted to measured losses, with their bands.

    ``parameters`` (key, name, value, range of 5 to 95 %, default, verdict ...; values in SI units), ``points`` (measured_w,
    fitted_w, residual_sigma ...), ``nuisance``, ``correlations``, ``held_out``, ``identifiability``, ``block`` to
    paste into a case file.
    """

    @property
    def parameters(self) -> CalibrationParameterTable:
        """One row per parameter that is fitted, in its ``unit``, an SI unit: a thickness in m, a stress in Pa."""
        return CalibrationParameterTable(with_units(self._values["parameters"]))

    @property
    def points(self) -> CalibrationPointTable:
        """One row per measurement, with its fitted value."""
        return CalibrationPointTable(self._values["points"])

    def apply(self, case: CaseLike) -> Case:
        """The case with the parameters found, whose bands go into the band of its losses."""
        return as_case(case)._with(json.loads(_asperity.keys_of(self._values["block"])))

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


class Design(Study, DesignValues):
    """Measurements on a rig that would narrow the calibrated constants: ``points``, ``limits``, ``parameters`` ..."""

    @property
    def table(self) -> Table:
        """The points as measurements that `calibrate` takes: to fill in, or with ``simulate`` their simulated losses, which the column
        ``simulated`` marks, as in the file ``simulated.csv``."""
        import csv

        files = files_of(self._raw)
        name = "simulated.csv" if "simulated.csv" in files else "design.csv"
        lines = [line for line in files[name].decode().splitlines() if not line.startswith("#")]
        texts = ("includes", "flank_state")
        rows = [
            {key: cell if key in texts else float(cell) if cell else None for key, cell in row.items() if key != "simulated"}
            | {"simulated": name == "simulated.csv"}
            for row in csv.DictReader(lines)
        ]
        return Table(rows, declared={key: "str" if key in texts else "bool" if key == "simulated" else "Optional[float]" for key in rows[0]})

    @property
    def points(self) -> DesignPointTable:
        """One row per point to measure, by temperature."""
        return DesignPointTable(self._values["points"])

    @property
    def parameters(self) -> DesignParameterTable:
        """One row per parameter, as the points would determine it, in its ``unit``."""
        return DesignParameterTable(with_units(self._values["parameters"]))

    def to_pandas(self) -> pandas.DataFrame:
        """One row per point to measure."""
        return self.points.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        expected = [(one["name"], f"{one['value']:.4g} ({one['range_low']:.4g}..{one['range_high']:.4g}) {one['unit']}".strip()) for one in self.parameters]
        return [("points", str(len(self._values["points"]))), *expected]


class Evidence(Study, EvidenceValues):
    """Intervals of a loss that measurements would leave: ``rows`` (key, measurement, hours, width ...)."""

    @property
    def rows(self) -> EvidenceRowTable:
        """One row per measurement, the one that narrows the interval most first."""
        return EvidenceRowTable(self._values["rows"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per measurement."""
        return self.rows.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        left = [(one["measurement"], f"{one['low_w']:.4g}..{one['high_w']:.4g} W") for one in self._values["rows"]]
        loss = self._values["loss"]
        return [("loss", with_ends(loss["median_w"], loss["quantiles_w"])), *left]
