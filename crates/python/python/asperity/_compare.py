"""Several finishes on one case."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._errors import AsperityError, Code, warn
from ._profile import Profile
from ._progress import Progress, Steps
from ._record import Table, drawn, variable
from ._study import RawStudy, Study, as_json

if TYPE_CHECKING:
    import pandas
    import xarray

Trace = Union[Profile, str, PathLike[str]]
Finish = Union[Trace, tuple[Trace, Trace], Case]
"""A trace for both flanks, those of pinion and wheel, or a case."""


def _loss(finish: Mapping[str, Any]) -> Any:
    """Median and quantiles of the loss of a finish, of a pair of gears or a gear train; None without draws."""
    uncertainty = finish.get("uncertainty")
    return uncertainty["loss"] if uncertainty else finish.get("loss_distribution")


def cases_of(case: CaseLike, finishes: Mapping[str, Finish], offsets: Optional[int]) -> list[tuple[str, _asperity.Case]]:
    """The case on each finish."""
    base = as_case(case)
    found = []
    for name, finish in finishes.items():
        made = finish if isinstance(finish, Case) else base._on_finish(finish, offsets)
        found.append((name, made._raw))
    return found


class Comparison(Study):
    """Finishes side by side; the first is the one that the others are compared with.

    ``finishes`` (name, loss_w, uncertainty, difference ...; of a gear train loss_distribution and meshes in place of
    uncertainty), ``correlations`` (parameter, with_loss, within_finishes). The ``difference`` of a finish is taken draw by draw: ``median_w``, ``quantiles_w`` (5 and 95 %),
    ``probability`` of its sign, ``models``, and ``verdict``: ``"equal"``, ``"holds"``, ``"undecided"``, or ``except`` with
    the models that have the other sign.
    """

    def __init__(self, raw: RawStudy, offsets: str, verdicts: list[str]) -> None:
        super().__init__(raw)
        self._offsets: list[list[dict[str, Any]]] = json.loads(offsets)
        self._verdicts = verdicts

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (*super().__reduce__()[1], json.dumps(self._offsets), self._verdicts)

    @property
    def names(self) -> list[str]:
        """Names of the finishes."""
        return [str(finish["name"]) for finish in self._values["finishes"]]

    @property
    def finishes(self) -> Table:
        """One row per finish."""
        return Table(self._values["finishes"])

    @property
    def verdicts(self) -> list[str]:
        """What the difference of every finish but the first decides, in words."""
        return list(self._verdicts)

    @property
    def correlations(self) -> Table:
        """Rank correlation of roughness parameters with the computed loss, the closest first."""
        return Table(self._values["correlations"], ["parameter", "with_loss", "within_finishes"])

    @property
    def offsets(self) -> dict[str, Table]:
        """Efficiency and losses at each offset, by the name of the finish; empty of a gear train."""
        return {name: Table(rows) for name, rows in zip(self.names, self._offsets)}

    def to_pandas(self) -> pandas.DataFrame:
        """One row per finish: loss, its median and quantiles, difference to the first with its quantiles and verdict."""
        import pandas

        rows = []
        for finish in self._values["finishes"]:
            row = {key: value for key, value in finish.items() if isinstance(value, (int, float, str))}
            if loss := _loss(finish):
                row["loss_median_w"] = loss["median_w"]
                row["loss_p05_w"], row["loss_p95_w"] = loss["quantiles_w"]
            if difference := finish.get("difference"):
                row["difference_median_w"] = difference["median_w"]
                row["difference_p05_w"], row["difference_p95_w"] = difference["quantiles_w"]
                row["difference_median_share"] = difference["median_share"]
                row["difference_p05_share"], row["difference_p95_share"] = difference["share_quantiles"]
                row["difference_probability"] = difference["probability"]
                verdict = difference["verdict"]
                row["difference_verdict"] = verdict if isinstance(verdict, str) else "except"
            rows.append(row)
        return pandas.DataFrame(rows).set_index("name")

    def to_xarray(self) -> xarray.Dataset:
        """Losses over finish and offset as an `xarray.Dataset`."""
        import xarray

        offsets = self.offsets
        names = [name for name in next(iter(offsets.values())).columns if name != "offset"]
        stacked = {
            name: variable(("finish", "offset"), name, [offsets[finish][name] for finish in self.names]) for name in names
        }
        return xarray.Dataset(stacked, coords={"finish": self.names}, attrs={"title": str(self._values["title"])})

    def __repr__(self) -> str:
        losses = ", ".join(f"{name} {loss}" for name, loss in self._losses())
        return f"<Comparison {self._values['title']!r}: {losses}>"

    def _losses(self) -> list[tuple[str, str]]:
        finishes = self._values["finishes"]
        losses = [drawn({"loss": _loss(of)}) if _loss(of) else f"{of['loss_w']:.4g} W" for of in finishes]
        return [*zip(self.names, losses)]

    def _rows(self) -> list[tuple[str, str]]:
        return [*self._losses(), *(("", verdict) for verdict in self.verdicts)]


def compared(
    case: CaseLike,
    finishes: Mapping[str, Finish],
    settings: Mapping[str, Any],
    threads: Optional[int],
    progress: Optional[Progress],
) -> Comparison:
    """The comparison of finishes by its settings."""
    if len(finishes) < 2:
        raise AsperityError("one finish cannot be compared", Code.E205, "Give at least two finishes.")
    with Steps(progress, _asperity.steps("compare")) as steps:
        cases = cases_of(case, finishes, settings["offsets"])
        raw, found, verdicts = _asperity.compare(cases, as_json(settings), threads, steps)
    comparison = Comparison(raw, found, verdicts)
    known = [warning for finish in finishes.values() if isinstance(finish, Case) for warning in finish._about["warnings"]]
    rows = [warning for finish in comparison._values["finishes"] for warning in finish["warnings"]]
    warn(dict.fromkeys(rows), [*as_case(case)._about["warnings"], *known])
    return comparison
