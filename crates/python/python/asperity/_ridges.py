"""The ridges of the flanks that cost most, from the gradient of the loss over the heights of the traces."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._study import Study
from ._values import RidgesOctaveTable, RidgesRowTable, RidgesValues

if TYPE_CHECKING:
    import pandas


class Ridges(Study, RidgesValues):
    """Costliest ridges: ``loss_at_medians_w``, ``pressed_at_medians_w`` of a run with all of them removed down to the mean line,
    ``by_log_height_w``, with every constant at its median.

    The gradient holds windows and sets of the contacts; running-in is not in it.
    """

    @property
    def rows(self) -> RidgesRowTable:
        """One row per ridge, the one that costs most first."""
        return RidgesRowTable(self._values["rows"])

    @property
    def octaves(self) -> RidgesOctaveTable:
        """One row per octave of wavelength: d(loss)/d ln(height) of its waves, by flank."""
        return RidgesOctaveTable(self._values["octaves"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per ridge."""
        return self.rows.to_pandas()

    def __repr__(self) -> str:
        saved = self._values["loss_at_medians_w"] - self._values["pressed_at_medians_w"]
        return f"<Ridges {self._values['title']!r}: removing {len(self._values['rows'])} ridges saves {saved:.3g} W>"
