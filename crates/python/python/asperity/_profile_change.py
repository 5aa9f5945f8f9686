"""Traces of the same places before and after a test."""

from __future__ import annotations

from os import PathLike, fspath
from typing import TYPE_CHECKING

from . import _asperity
from ._profile import Traces, listed_profiles
from ._study import Study
from ._values import ProfileChangeMaterialRatioTable, ProfileChangePairTable, ProfileChangeParameterTable, ProfileChangeValues

if TYPE_CHECKING:
    import pandas


def raw_traces(traces: Traces) -> list[tuple[str, _asperity.Trace]]:
    """Names and traces as the compiled part takes them."""
    found = []
    for number, (given, profile) in enumerate(listed_profiles("traces", traces), 1):
        name = fspath(given) if isinstance(given, (str, PathLike)) else profile.name or f"trace {number}"
        found.append((name, profile._raw))
    return found


class ProfileChange(Study, ProfileChangeValues):
    """Traces after a test on the traces before it: ``mean`` (removed_nm, lost_nm, gained_nm, each with quantiles of 5 and
    95 %), ``mean_with_bow``, the same with a bow, where the traces are undecided without one, ``scatter_nm`` from pair to pair; ``in_case``, with a case, has the flanks (sliding, Archard's coefficient), the losses
    of their states before and after the test, and the difference."""

    @property
    def pairs(self) -> ProfileChangePairTable:
        """One row per pair: place of the second trace on the first, and what it lost."""
        return ProfileChangePairTable(self._values["pairs"])

    @property
    def parameters(self) -> ProfileChangeParameterTable:
        """One row per roughness parameter: before, after, change, noise floor."""
        return ProfileChangeParameterTable(self._values["parameters"])

    @property
    def material_ratio(self) -> ProfileChangeMaterialRatioTable:
        """One row per material ratio: level before, after, change, noise floor."""
        return ProfileChangeMaterialRatioTable(self._values["material_ratio"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per pair."""
        return self.pairs.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        mean = self._values["mean"]
        low, high = mean["removed_quantiles_nm"]
        rows = [("removed", f"{mean['removed_nm']:.1f} nm ({low:.1f}..{high:.1f})")]
        if of := self._values.get("in_case"):
            rows += [(f"loss {state['state']}", f"{state['loss_w']:.1f} W") for state in of["states"]]
        return rows
