"""Studies by their settings.

Written by crates/python/typed.py from the settings of the compiled part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Optional, Union

if TYPE_CHECKING:
    from ._calibration import Evidence
    from ._callout import CallOut
    from ._case import CaseLike
    from ._columns import Columns
    from ._oil import OilFit, OilLike, OilPlan, Stribeck, Traction
    from ._progress import Progress
    from ._quantity import Numbers, Quantities, Quantity
    from ._ridges import Ridges
    from ._sensitivity import Sensitivity
    from .keys import RoughnessParameter, TemperatureColumn, Zero

__all__ = [
    "callout",
    "evidence",
    "oil_fit",
    "oil_plan",
    "oil_traction",
    "ridges",
    "sensitivity",
    "stribeck",
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
    from ._case import as_case
    from ._record import warned
    from ._sensitivity import Sensitivity
    from ._study import run_study

    return warned(Sensitivity(run_study("sensitivity", (as_case(case)._raw,), {}, threads, progress)))


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
    from ._case import as_case
    from ._record import warned
    from ._ridges import Ridges
    from ._study import run_study

    return warned(Ridges(run_study("ridges", (as_case(case)._raw,), {}, threads, progress)))


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
    from ._case import as_case
    from ._quantity import written
    from ._record import warned
    from ._study import run_study

    settings = {
        "loss": written(loss, "Power", "loss"),
        "confidence": confidence,
        "scatter": scatter,
        "parameter": parameter,
        "traces": traces,
        "lots": lots,
        "seed": seed,
    }
    return warned(CallOut(run_study("callout", (as_case(case)._raw,), settings, threads, progress)))


def evidence(
    case: CaseLike,
    *,
    hours: Optional[Mapping[str, float]] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Evidence:
    """Measurements that would narrow the interval of the loss most, with their hours.

    Each row is the interval that the measurement alone is expected to leave. What the case states or has measured has
    no row.

    Args:
        case: the case.
        hours: hours of a measurement by its name in evidence.csv, ``{"traction-plan": 3}``.
        threads, progress: as in `Case.run`.
    """
    from ._calibration import Evidence
    from ._case import as_case
    from ._record import warned
    from ._study import run_study

    settings = {
        "hours": [f"{key}={value}" for key, value in (hours or {}).items()],
    }
    return warned(Evidence(run_study("evidence", (as_case(case)._raw,), settings, threads, progress)))


def oil_traction(
    oil: OilLike,
    *,
    load: Quantity = "30 N",
    speed: Quantity = "2 m/s",
    slide_to_roll: Union[float, str] = "5 %",
    temperature_c: Optional[Numbers] = None,
    temperature: Optional[Quantities] = None,
    boundary_friction: Optional[float] = None,
    rq: Quantity = "15 nm",
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    threads: Optional[int] = None,
) -> Traction:
    """Traction of the film between ball and disc, over slide-to-roll ratio and speed.

    Predicted where the film is at least three times as thick as the roughness. The specimens are of through-hardened
    steel (21 W/(m K)). The tables have the columns of a measured traction curve.

    Args:
        oil: the oil.
        load: load.
        speed: mean speed of the curves over the slide-to-roll ratio.
        slide_to_roll: slide-to-roll ratio of the curves over the speed.
        temperature_c, temperature: temperatures of the oil bath, numbers or text with a unit [default: 40,80,120 °C].
        boundary_friction: boundary friction to which the dashed guide of the chart leads [default: that of the model].
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        threads: as in `Case.run`.
    """
    from ._oil import Traction, raw_oil
    from ._quantity import nodes, written
    from ._record import warned
    from ._study import run_study

    settings = {
        "load": written(load, "Force", "load"),
        "speed": written(speed, "Speed", "speed"),
        "slide_to_roll": slide_to_roll,
        "temperature": nodes("temperature_c", temperature_c, temperature, "40,80,120"),
        "boundary_friction": boundary_friction,
        "rq": written(rq, "Length", "rq"),
        "ball_radius": written(ball_radius, "Length", "ball_radius"),
        "second_radius": None if second_radius is None else written(second_radius, "Length", "second_radius"),
    }
    return warned(Traction(run_study("oil_traction", (raw_oil(oil),), settings, threads)))


def oil_fit(
    curves: Union[Columns, Sequence[Columns]],
    oil: OilLike,
    *,
    temperature_column: TemperatureColumn = "lube",
    force: bool = False,
    rq: Quantity = "15 nm",
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    wide: bool = False,
    zero: Zero = "curve",
    point_sd: Union[float, str] = "1.5 %",
    point_floor: float = 0.0003,
    threads: Optional[int] = None,
) -> OilFit:
    """Constants of an oil from measured traction curves of ball and disc, with their bands.

    A table has the columns load_n, mean_speed_m_s, slide_roll_percent (200 is pure sliding), temperature_c and
    traction, and where known sigma, group, set_temperature_c, film_nm and the specimens; a text export of a PCS
    machine is read as it is. oil.toml in the result is the oil file that a case names by lubricant.oil_file.

    Args:
        curves: one or several files, frames or columns, with the columns of the command.
        oil: the oil, for viscosity and family.
        temperature_column: probe of the temperature in a text export.
        force: accept constants of no known oil.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        wide: leave the constants to the points, with wide priors in place of the family.
        zero: zeros of the friction.
        point_sd: standard deviation of points without sigma, relative to the friction.
        point_floor: least standard deviation of the friction coefficient of such points.
        threads: as in `Case.run`.
    """
    from ._oil import OilFit, raw_oil, tables_of_curves
    from ._quantity import written
    from ._record import warned
    from ._study import run_study

    settings = {
        "temperature_column": temperature_column,
        "force": force,
        "rq": written(rq, "Length", "rq"),
        "ball_radius": written(ball_radius, "Length", "ball_radius"),
        "second_radius": None if second_radius is None else written(second_radius, "Length", "second_radius"),
        "wide": wide,
        "zero": zero,
        "point_sd": point_sd,
        "point_floor": point_floor,
    }
    return warned(OilFit(run_study("oil_fit", (tables_of_curves(curves, "curves"), raw_oil(oil)), settings, threads)))


def oil_plan(
    oil: OilLike,
    case: Optional[CaseLike] = None,
    *,
    simulate: Optional[int] = None,
    rq: Quantity = "15 nm",
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    wide: bool = False,
    zero: Zero = "curve",
    point_sd: Union[float, str] = "1.5 %",
    point_floor: float = 0.0003,
    threads: Optional[int] = None,
) -> OilPlan:
    """Traction measurements that would determine the constants of an oil, with the errors they would leave.

    plan.csv in the result is the table to fill in for asperity oil fit. With a case, the error of its loss by the
    constants is listed too, and the points are chosen that narrow it most.

    Args:
        oil: the oil.
        case: the case whose loss is to be narrowed [default: the case of the oil if it is of one].
        simulate: write simulated.csv with simulated friction of the minimal plan, with this seed.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        wide: leave the constants to the points, with wide priors in place of the family.
        zero: zeros of the friction.
        point_sd: standard deviation of points without sigma, relative to the friction.
        point_floor: least standard deviation of the friction coefficient of such points.
        threads: as in `Case.run`.
    """
    from ._case import as_case
    from ._oil import OilPlan, raw_oil
    from ._quantity import written
    from ._record import warned
    from ._study import run_study

    settings = {
        "simulate": simulate,
        "rq": written(rq, "Length", "rq"),
        "ball_radius": written(ball_radius, "Length", "ball_radius"),
        "second_radius": None if second_radius is None else written(second_radius, "Length", "second_radius"),
        "wide": wide,
        "zero": zero,
        "point_sd": point_sd,
        "point_floor": point_floor,
    }
    return warned(OilPlan(run_study("oil_plan", (raw_oil(oil), None if case is None else as_case(case)._raw), settings, threads)))


def stribeck(
    curves: Union[Columns, Sequence[Columns]],
    oil: OilLike,
    *,
    rubbing: Sequence[Quantity] = (),
    temperature_column: TemperatureColumn = "lube",
    rq: Quantity = "15 nm",
    ball_radius: Quantity = "9.525 mm",
    second_radius: Optional[Quantity] = None,
    threads: Optional[int] = None,
) -> Stribeck:
    """Boundary friction from Stribeck curves of ball and disc, with its band.

    The files have the columns of a traction curve, and rubbing_s, the time for which the specimens have rubbed
    before. Points with a film of at most a fifth of the roughness count. How much of the load of gears the layer
    carries does not follow from them: model.inner_boundary is drawn.

    Args:
        curves: one or several files, frames or columns, with the columns of the command.
        oil: the oil, for viscosity and family.
        rubbing: time of rubbing before each file, 0 s for new specimens, unless a row states it.
        temperature_column: probe of the temperature in a text export.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        threads: as in `Case.run`.
    """
    from ._oil import Stribeck, raw_oil, tables_of_curves
    from ._quantity import written
    from ._record import warned
    from ._study import run_study

    settings = {
        "rubbing": [written(one, "Time", "rubbing") for one in rubbing],
        "temperature_column": temperature_column,
        "rq": written(rq, "Length", "rq"),
        "ball_radius": written(ball_radius, "Length", "ball_radius"),
        "second_radius": None if second_radius is None else written(second_radius, "Length", "second_radius"),
    }
    return warned(Stribeck(run_study("stribeck", (tables_of_curves(curves, "curves"), raw_oil(oil)), settings, threads)))
