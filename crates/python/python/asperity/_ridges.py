"""The ridges of the flanks that cost most, from the gradient of the loss over the heights of the traces."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._record import Table
from ._study import Study

if TYPE_CHECKING:
    import pandas


class Ridges(Study):
    """Costliest ridges: ``loss_w``, ``pressed_loss_w`` of a run with all of them pressed to the mean line, ``by_log_height_w``.

    The gradient holds windows and sets of the contacts; running-in is not in it.
    """

    @property
    def rows(self) -> Table:
        """One row per ridge, the one that costs most first."""
        return Table(self._values["rows"])

    @property
    def octaves(self) -> Table:
        """One row per octave of wavelength: d(loss)/d ln(height) of its waves, by flank."""
        return Table(self._values["octaves"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per ridge."""
        return self.rows.to_pandas()

    def __repr__(self) -> str:
        saved = self._values["loss_w"] - self._values["pressed_loss_w"]
        return f"<Ridges {self._values['title']!r}: pressing {len(self._values['rows'])} ridges saves {saved:.3g} W>"
