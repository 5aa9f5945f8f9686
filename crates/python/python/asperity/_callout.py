"""Limit of a roughness parameter on the drawing, and traces to inspect, for a stated loss."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._study import Study
from ._values import CallOutLimitTable, CallOutParameterTable, CallOutValues

if TYPE_CHECKING:
    import pandas


class CallOut(Study, CallOutValues):
    """Call-out of a finish: ``parameter``, ``traces`` to inspect, ``limits`` of their mean, ``wavelengths_um``, ``mean_loss_w``
    at the limit, ``smooth_loss_w``.

    A lot whose inspected mean is at the limit meets the loss with the stated confidence.
    """

    @property
    def limits(self) -> CallOutLimitTable:
        """One row per limit: of both flanks, or of pinion and wheel."""
        return CallOutLimitTable(self._values["limits"])

    @property
    def parameters(self) -> CallOutParameterTable:
        """One row per parameter: its traces, its limit over the recipe, and how well it predicts the loss."""
        return CallOutParameterTable(self._values["parameters"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per limit."""
        return self.limits.to_pandas()

    def __repr__(self) -> str:
        limits = ", ".join(f"{row['parameter']} {row['limit']:.3g} {row['unit']}".strip() for row in self.limits)
        return f"<CallOut {self._values['title']!r}: {limits}, mean of {self._values['traces']} traces>"
