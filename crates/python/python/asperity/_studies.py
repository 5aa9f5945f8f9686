"""Studies of one case.

Written by crates/python/typed.py from the settings of the compiled part.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Union

if TYPE_CHECKING:
    from ._callout import CallOut
    from ._case import CaseLike
    from ._progress import Progress
    from ._quantity import Quantity
    from ._ridges import Ridges
    from ._sensitivity import Sensitivity
    from .keys import RoughnessParameter

__all__ = [
    "callout",
    "ridges",
    "sensitivity",
]


def sensitivity(
    case: CaseLike,
    *,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Sensitivity:
    """Sensitivity of the loss to single changes: heights, wavelengths, boundary layer, oil, tip relief.

    Each row is a run of the model with one thing changed, at the same windows of the traces. To vary keys of your own
    choice, with distributions, see the command sweep.

    Args:
        case: the case.
        threads, progress: as in `Case.run`.
    """
    from ._sensitivity import Sensitivity
    from ._study import of_case

    return Sensitivity(of_case("sensitivity", case, {}, threads, progress, "changes"))


def ridges(
    case: CaseLike,
    *,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Ridges:
    """Ridges of both flanks that cost most, and the loss by wavelength.

    The gradient of the loss over every height of both traces, by ridge and by octave of wavelength, and a run with
    the twenty costliest ridges pressed to the mean line.

    Args:
        case: the case.
        threads, progress: as in `Case.run`.
    """
    from ._ridges import Ridges
    from ._study import of_case

    return Ridges(of_case("ridges", case, {}, threads, progress, "gradients"))


def callout(
    case: CaseLike,
    loss: Quantity,
    *,
    confidence: Union[float, str] = "90 %",
    scatter: Union[float, str] = "10 %",
    parameter: Optional[RoughnessParameter] = None,
    traces: Optional[int] = None,
    lots: int = 200,
    seed: int = 1,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> CallOut:
    """Limit of Rpk, Rq or Rdq on the drawing, and traces to inspect, for a stated loss.

    Lots of flanks like the traces of the case are simulated, inspected and run. A lot whose inspected mean is at the
    limit meets the loss with the confidence.

    Args:
        case: the case.
        loss: loss of the mesh that a lot has to meet, the mean over 16 pairs of its flanks.
        confidence: share of the lots at the limit that meet the loss.
        scatter: standard deviation of heights, wavelengths and peaks about the median of their lot.
        parameter: roughness parameter on the drawing: rpk, rq or rdq [default: the one that predicts the loss best].
        traces: number of traces to inspect [default: as many as further ones change the limit by 2 %].
        lots: number of simulated lots.
        seed: seed of the random numbers.
        threads, progress: as in `Case.run`.
    """
    from ._callout import CallOut
    from ._quantity import written
    from ._study import of_case

    settings = {
        "loss": written(loss, "Power", "loss"),
        "confidence": confidence,
        "scatter": scatter,
        "parameter": parameter,
        "traces": traces,
        "lots": lots,
        "seed": seed,
    }
    return CallOut(of_case("callout", case, settings, threads, progress, "lots"))
