"""Limit of a roughness parameter on the drawing, and traces to inspect, for a stated loss."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

from ._case import CaseLike
from ._progress import Progress
from ._quantity import Quantity, stated
from ._record import Table
from ._study import Study, of_case

if TYPE_CHECKING:
    import pandas

    from .keys import RoughnessParameter


class CallOut(Study):
    """Call-out of a finish: ``parameter``, ``traces`` to inspect, ``limits`` of their mean, ``wavelengths_um``, ``mean_loss_w``
    at the limit, ``smooth_loss_w``.

    A lot whose inspected mean is at the limit meets the loss with the stated confidence.
    """

    @property
    def limits(self) -> Table:
        """One row per limit: of both flanks, or of pinion and wheel."""
        return Table(self._values["limits"])

    @property
    def parameters(self) -> Table:
        """One row per parameter: its traces, its limit over the recipe, and how well it predicts the loss."""
        return Table(self._values["parameters"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per limit."""
        return self.limits.to_pandas()

    def __repr__(self) -> str:
        limits = ", ".join(f"{row['parameter']} {row['limit']:.3g} {row['unit']}".strip() for row in self.limits)
        return f"<CallOut {self._values['title']!r}: {limits}, mean of {self._values['traces']} traces>"


def callout(
    case: CaseLike,
    loss: Quantity,
    *,
    confidence: float = 0.9,
    scatter: float = 0.1,
    parameter: Optional[RoughnessParameter] = None,
    traces: Optional[int] = None,
    lots: int = 200,
    seed: int = 1,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> CallOut:
    """Limit of Rpk, Rq or Rdq on the drawing, and the number of traces to inspect, at which lots of flanks meet a loss.

    Args:
        case: the case, with traces of the recipe.
        loss: loss of the mesh that a lot has to meet, the mean over 16 pairs of its flanks.
        confidence: share of the lots at the limit that meet the loss.
        scatter: standard deviation of the logarithms of heights, wavelengths and peaks about the median of their lot.
        parameter: by default the one that predicts the loss best.
        traces: number of traces to inspect; by default as many as further ones change the limit by 2 %.
        lots: number of simulated lots.
        seed: of the random numbers.
        threads, progress: as in `Case.run`.
    """
    settings = {
        "loss": f"{stated(loss, 'Power', 'loss')!r} W", "confidence": confidence, "scatter": scatter, "parameter": parameter,
        "traces": traces, "lots": lots, "seed": seed,
    }
    return CallOut(of_case("callout", case, settings, threads, progress, "lots"))
