"""Several variants of a case."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union, cast

import numpy as np

from . import _asperity
from ._case import Case, CaseLike, as_case
from ._errors import of_several, wrong_kind
from ._profile import Trace
from ._record import Table, variable, with_ends
from ._result import OF_OFFSETS
from ._study import RawStudy, Study
from ._values import ComparisonCorrelationTable, ComparisonFinishTable, ComparisonValues
from .keys import CaseKeys

if TYPE_CHECKING:
    import pandas
    import xarray

Finish = Union[Trace, tuple[Trace, Trace], Case]
"""A trace for both flanks, those of pinion and wheel, or a case."""

Variant = Union[Finish, CaseKeys]
"""A finish, other values of keys or tables of the case, or another case."""


def _quantiles(finish: Mapping[str, Any]) -> Any:
    """5 and 95 % quantiles of the loss of a finish, of a pair of gears or a gear train; None without samples."""
    uncertainty = finish.get("uncertainty")
    found = uncertainty["loss"] if uncertainty else finish.get("loss_distribution")
    return found and found["quantiles_w"]


def cases_of(case: CaseLike, finishes: Optional[Mapping[str, Variant]]) -> list[tuple[str, _asperity.Case]]:
    """The case as each variant, or as it is. A single one with other keys comes behind the case itself, "as is"."""
    base = as_case(case)
    if finishes is not None and not isinstance(finishes, Mapping):
        raise wrong_kind("finishes", finishes, "profiles, files or cases by name")
    if not finishes:
        return [(base.title or "case", base._raw)]

    def made(name: str, of: Variant) -> Case:
        if isinstance(of, Mapping):
            return base._varied(name, of)
        return of if isinstance(of, Case) else base._on_finish(name, of)

    found = [(name, made(name, of)._raw) for name, of in finishes.items()]
    is_single = len(found) == 1 and isinstance(next(iter(finishes.values())), Mapping)
    return [("as is", base._raw), *found] if is_single else found


class Comparison(Study, ComparisonValues):
    """Variants side by side; the first is the one that the others are compared with.

    ``finishes`` (name, loss_w, uncertainty, difference ...; of a gear train loss_distribution and meshes instead of
    uncertainty), ``correlations`` (parameter, with_loss, within_finishes). The ``difference`` of a finish is taken draw by draw: ``median_w``, ``quantiles_w`` (5 and 95 %),
    ``probability`` of its sign, ``models``, ``common`` (the components whose samples both have in common), and ``verdict``: ``"equal"``, ``"holds"``, ``"undecided"``, or ``except`` with
    the models that have the other sign. ``deciding`` has the measurements that narrow it, and ``changes`` the keys that differ.
    """

    def __init__(self, raw: RawStudy, more: Optional[tuple[str, list[str]]] = None) -> None:
        super().__init__(raw)
        self._more = more or cast("_asperity.Study", raw).compared()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (*super().__reduce__()[1], self._more)

    def _doubts(self) -> Iterable[Any]:
        finishes = self._values["finishes"]
        return of_several(((warning, finish["name"]) for finish in finishes for warning in finish["warnings"]), len(finishes))

    @property
    def names(self) -> list[str]:
        """Names of the finishes."""
        return [str(finish["name"]) for finish in self._values["finishes"]]

    @property
    def finishes(self) -> ComparisonFinishTable:
        """One row per finish."""
        return ComparisonFinishTable(self._values["finishes"])

    @property
    def verdicts(self) -> list[str]:
        """What the difference of every finish but the first decides, in words."""
        return list(self._more[1])

    @property
    def correlations(self) -> ComparisonCorrelationTable:
        """Rank correlation of roughness parameters with the computed loss, the closest first; empty of
        fewer than three finishes, of fewer than five offsets, and of a gear train."""
        return ComparisonCorrelationTable(self._values["correlations"])

    @property
    def offsets(self) -> dict[str, Table]:
        """Efficiency and losses at each offset, by the name of the finish; empty of a gear train."""
        return {name: Table(rows, declared=OF_OFFSETS) for name, rows in zip(self.names, json.loads(self._more[0]))}

    def to_pandas(self) -> pandas.DataFrame:
        """One row per finish, by its name: loss and its quantiles, difference to the first with its quantiles and verdict."""
        rows = []
        for finish in self._values["finishes"]:
            row = {key: finish.get(key) for key in ("name", "efficiency", "power_in_w", "loss_w", "loss_at_medians_w", "mixed_share", "regime")}
            difference = finish.get("difference") or {}
            row["loss_p05_w"], row["loss_p95_w"] = _quantiles(finish) or (None, None)
            row["difference_median_w"] = difference.get("median_w")
            row["difference_p05_w"], row["difference_p95_w"] = difference.get("quantiles_w", (None, None))
            row["difference_median_share"] = difference.get("median_share")
            row["difference_p05_share"], row["difference_p95_share"] = difference.get("share_quantiles", (None, None))
            row["difference_probability"] = difference.get("probability")
            verdict = difference.get("verdict")
            row["difference_verdict"] = verdict if isinstance(verdict, (str, type(None))) else "except"
            rows.append(row)
        texts = dict.fromkeys(("name", "regime", "difference_verdict"), "Optional[str]")
        return Table(rows, declared={**dict.fromkeys(rows[0], "float"), **texts}).to_pandas().set_index("name")

    def to_xarray(self) -> xarray.Dataset:
        """Losses over finish and offset as an `xarray.Dataset`; NaN beyond the offsets of a finish that has fewer."""
        import xarray

        offsets = self.offsets
        most = max(map(len, offsets.values()))

        def of(finish: str, name: str) -> Any:
            values = offsets[finish][name]
            return values if len(values) == most else np.pad(values.astype(float), (0, most - len(values)), constant_values=np.nan)

        names = [name for name in next(iter(offsets.values())).columns if name != "offset"]
        stacked = {name: variable(("finish", "offset"), name, [of(finish, name) for finish in self.names]) for name in names}
        return xarray.Dataset(stacked, coords={"finish": self.names}, attrs={"title": str(self._values["title"])})

    def __repr__(self) -> str:
        losses = ", ".join(f"{name} {loss}" for name, loss in self._losses())
        return f"<Comparison {self._values['title']!r}: {losses}>"

    def _losses(self) -> list[tuple[str, str]]:
        return [(str(of["name"]), with_ends(of["loss_w"], _quantiles(of))) for of in self._values["finishes"]]

    def _rows(self) -> list[tuple[str, str]]:
        return [*self._losses(), *(("", verdict) for verdict in self.verdicts)]
