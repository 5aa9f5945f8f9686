"""Studies by their settings.

Written by crates/python/typed.py from the settings of the compiled part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import Any, Optional, Union

from ._calibration import Calibration, Design, Evidence
from ._callout import CallOut
from ._case import CaseLike, as_case
from ._choices import Band, CalibratedParameter, ExportFormat, RoughnessParameter, TemperatureColumn, TraceForm, WornFlank, Zero
from ._columns import Columns, table_of
from ._compare import Comparison, Variant, cases_of
from ._errors import Code
from ._files import Paths, paths
from ._keys import vehicle_keys
from ._map import Cycle, Map, map_of
from ._oil import OilFit, OilLike, OilPlan, Stribeck, Traction, raw_oil, tables_of_curves
from ._profile import Traces
from ._profile_change import ProfileChange, raw_traces
from ._progress import Progress
from ._quantity import Numbers, Quantities, Quantity, nodes, number, written
from ._ridges import Ridges
from ._running_in import RunningIn
from ._sensitivity import Sensitivity
from ._study import ran

# As in _study_names.py; type checkers read a list that is written here only.
__all__ = [
    "calibrate",
    "callout",
    "compare",
    "cycle",
    "design",
    "evidence",
    "oil_fit",
    "oil_plan",
    "oil_traction",
    "profile_change",
    "ridges",
    "running_in",
    "sensitivity",
    "stribeck",
]


def compare(
    case: CaseLike,
    finishes: Mapping[str, Variant],
    *,
    offsets: Optional[int] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Comparison:
    """Compare finishes, oils, gears and other variants of a case, with paired differences.

    The first is the reference for the others. Two variants have the samples of a constant in common where the thing
    that it belongs to is the same in both, as the Eyring stress of one oil. Where it differs each has samples of its
    own. A variant that names an oil leaves out all other numbers of the oil of the case, and its calibration.

    Parameters:
        case: the case, whose traces are replaced by the traces of each finish; the finishes of a gear train are cases.
        finishes: by name a profile or file for both flanks (mirrored for the wheel), a pair of pinion and wheel, other
            values of keys, or a case; a single one that is no trace is compared with the case, as is.
        offsets: number of offsets along the traces at which the flanks are paired [default: those that each finish
            needs].
        threads, progress: as in `Case.run`.

    Returns:
        Comparison: Variants side by side; the first is the one that the others are compared with.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> finishes = {"ground": "demo/ground_pinion.csv", "fine": "demo/superfinished_pinion.csv"}
        >>> found = asperity.compare(case, finishes)
        >>> found.names
        ['ground', 'fine']
        >>> bool(found.finishes.loss_w[1] < found.finishes.loss_w[0])
        True
        >>> asperity.compare(case, {"pao": {"lubricant.oil": "pao100"}, "mineral": {"lubricant.oil": "m100"}}).names
        ['pao', 'mineral']
    """
    settings = {
        "offsets": offsets,
    }
    return ran(Comparison, "compare", (cases_of(case, finishes),), settings, threads, progress)


def map(
    case: CaseLike,
    *,
    finishes: Optional[Mapping[str, Variant]] = None,
    torque_nm: Optional[Numbers] = None,
    torque: Optional[Quantities] = None,
    speed_rpm: Optional[Numbers] = None,
    speed: Optional[Quantities] = None,
    temperature_c: Optional[Numbers] = None,
    temperature: Optional[Quantities] = None,
    band: Band = "nodes",
    cycle: Optional[Union[str, PathLike[str]]] = None,
    export: Sequence[ExportFormat] = (),
    add_loss: Optional[Union[str, PathLike[str]]] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Map:
    """Losses over torque, speed and temperature, in both directions of the power.

    The losses are of the mesh only, without bearings, seals and churning. Every point is the run at this torque,
    speed and temperature; the median of its loss and the quantiles (loss_p05_w, loss_p95_w) are from samples at three
    torques and three speeds. Flanks with operation.running_in run in once, at its torque, and the whole map is
    theirs.

    Parameters:
        case: the case.
        finishes: finishes or other variants by name, as in `compare` [default: the case itself].
        torque_nm, torque: torques at the pinion, numbers or text as ``"10..100:5 N m"`` [default: 0 and 12 from 1 % of
            the largest, both signs]; 0 is added between both signs.
        speed_rpm, speed: speeds of the pinion, numbers or text as ``"10..100:5 1/min"`` [default: 0, 1 and 16 more,
            closer at low speed]; 0 is added.
        temperature_c, temperature: temperatures of the flanks, numbers or text as ``"10..100:5 °C"`` [default: the
            temperature of the case].
        band: whether the loss has median, 5 and 95 % quantiles, as in asperity run.
        cycle: cycle whose points are drawn over the map, in the format of asperity cycle.
        export: also write the map for these programs, into the folder of the map.
        add_loss: table with the loss torque of bearings, seals and churning, added to the exports as a separate part:
            columns torque_nm, speed_rpm, loss_torque_nm (and temperature_c).
        threads, progress: as in `Case.run`.

    Returns:
        Map: A map of losses.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> losses = asperity.map(case, torque_nm=[50, 145], speed="1000..9000:3 1/min", band="none")
        >>> losses.loss_w.shape
        (1, 1, 2, 4)
        >>> float(losses.loss_torque(torque_nm=100, speed_rpm=4000)) > 0
        True
    """
    settings = {
        "torque": nodes("torque_nm", torque_nm, torque, None),
        "speed": nodes("speed_rpm", speed_rpm, speed, None),
        "temperature": nodes("temperature_c", temperature_c, temperature, None),
        "band": band,
        "cycle": None if cycle is None else fspath(cycle),
        "export": list(export),
        "add_loss": None if add_loss is None else fspath(add_loss),
    }
    return ran(Map, "map", (cases_of(case, finishes),), settings, threads, progress)


def cycle(
    map: Map,
    trace: Columns,
    *,
    vehicle: Optional[Mapping[str, Any]] = None,
    temperature_c: Optional[float] = None,
    temperature: Optional[Quantity] = None,
    columns: Sequence[str] = (),
    allow_outside: bool = False,
    threads: Optional[int] = None,
) -> Cycle:
    """Energy lost over a driving cycle, from a map.

    The loss torque is interpolated between the points of the map; its interval follows from the samples of the map.

    Parameters:
        map: the map.
        trace: file, frame or columns: time_s, and torque_nm with speed_rpm at the pinion, or speed_km_h.
        vehicle: keys of `[vehicle]`, ``{"mass": "1600 kg"}``, instead of those of the case.
        temperature_c, temperature: temperature of the flanks in °C, one of the map [default: next to the temperature of
            the case].
        columns: names of the columns of a cycle without names, or instead of its own, e.g. time_s,speed_km_h; - leaves
            one out.
        allow_outside: permit more than 5 % of the energy of the cycle outside of the map, where the ratio of loss to
            torque is constant.
        threads: as in `Case.run`.

    Returns:
        Cycle: Energy lost over a cycle.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> losses = asperity.map(case, torque_nm=[-200, -60, -20, 20, 60, 200], speed_rpm=[500, 4000, 16000])
        >>> energies = asperity.cycle(losses, "demo/urban.csv")
        >>> bool(energies.finishes.lost_wh[0] > 0)
        True
    """
    settings = {
        "temperature_c": number("temperature_c", temperature_c, temperature),
        "columns": list(columns),
        "allow_outside": allow_outside,
    }
    return ran(Cycle, "cycle", (map_of(map), table_of(trace, "cycle", Code.E101), vehicle_keys(vehicle)), settings, threads)


def sensitivity(
    case: CaseLike,
    *,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Sensitivity:
    """Sensitivity of the loss to single changes: heights, wavelengths, boundary layer, oil, tip relief.

    Each row is a run of the model with one thing changed, at the same windows of the traces. To vary keys of your own
    choice, with distributions, see the command sweep.

    Parameters:
        case: the case.
        threads, progress: as in `Case.run`.

    Returns:
        Sensitivity: Changes of a loss, one thing changed at a time.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> found = asperity.sensitivity(case)
        >>> len(found.rows) > 5
        True
    """
    return ran(Sensitivity, "sensitivity", (as_case(case)._raw,), {}, threads, progress)


def ridges(
    case: CaseLike,
    *,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Ridges:
    """Ridges of both flanks that cost most, and the loss by wavelength.

    The gradient of the loss over every height of both traces, by ridge and by octave of wavelength, and a run with
    the twenty costliest ridges removed down to the mean line.

    Parameters:
        case: the case.
        threads, progress: as in `Case.run`.

    Returns:
        Ridges: Costliest ridges.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> found = asperity.ridges(case)
        >>> found.pressed_at_medians_w < found.loss_at_medians_w
        True
    """
    return ran(Ridges, "ridges", (as_case(case)._raw,), {}, threads, progress)


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

    Parameters:
        case: the case.
        loss: largest loss of the mesh of a lot, the mean over 16 pairs of its flanks: a power, or a change of the loss
            of flanks like these, as "-10 %" or "10 % less".
        confidence: share of the lots at the limit that meet the loss.
        scatter: standard deviation of heights, wavelengths and peaks about the median of their lot.
        parameter: roughness parameter on the drawing: rpk, rq or rdq [default: the one that predicts the loss best].
        traces: number of traces to inspect [default: as many as further ones change the limit by 2 %].
        lots: number of simulated lots.
        seed: seed of the random numbers.
        threads, progress: as in `Case.run`.

    Returns:
        CallOut: Call-out of a finish.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 2, "offsets": 2})
        >>> found = asperity.callout(case, "600 W", parameter="rq", traces=3, lots=20, confidence=0.8)
        >>> found.limits.parameter[0]
        'Rq'
    """
    settings = {
        "loss": loss if isinstance(loss, str) else written(loss, "Power", "loss"),
        "confidence": confidence,
        "scatter": scatter,
        "parameter": parameter,
        "traces": traces,
        "lots": lots,
        "seed": seed,
    }
    return ran(CallOut, "callout", (as_case(case)._raw,), settings, threads, progress)


def profile_change(
    before: Traces,
    after: Traces,
    case: Optional[CaseLike] = None,
    *,
    max_shift: Quantity = "0.5 mm",
    max_stretch: Union[float, str] = "0.3 %",
    form: TraceForm = "level",
    engagements: Optional[float] = None,
    flank: Optional[WornFlank] = None,
    leave_out: bool = False,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> ProfileChange:
    """Height that a test removed from traces of the same places, and the change of their parameters.

    The second trace is placed on the first by the valleys, which wear spares: shift, stretch, height and tilt, and a
    bow with form = poly2. All places are compared at which half of the shorter trace overlaps, also those beyond the
    bound of the shift. Heights are relative to the valleys, so that a loss of valleys and peaks alike does not show.
    Intervals are from 5 to 95 %. They contain the noise of the match and the choice of the valleys. Where parts of
    the trace rose, other valleys may have risen as well: the height gained is then also a standard deviation of the
    height removed. Parameters follow ISO 4287 with sections of 0.25 mm over the common length. A noise floor is the
    change that noise makes in one of twenty comparisons. With a case, its flanks are the traces over the common
    length, before and after the test. Each pair is a tooth. Both runs share all samples except two. The errors of the
    model are correlated by the concordance of the changed heights. The sampling error follows from the differences of
    the windows. A trace without a stated place lies at any place of the flank, and the interval of the wear
    coefficient contains this. operation.running_in presses the flanks before the test into each other and removes
    nothing by wear.

    Parameters:
        before: one or several traces before the test.
        after: the traces of the same places after it.
        case: case of the gears, whose loss before and after the test is then compared.
        max_shift: largest shift of the second trace, to either side.
        max_stretch: largest stretch of the second trace, to either side.
        form: form by which the second trace may differ: level (height and tilt), or poly2 (a bow as well).
        engagements: engagements of a tooth of the pinion in the test, for Archard's wear coefficient.
        flank: flank that changed, pinion or wheel, where the case does not have the traces before the test.
        leave_out: leave out pairs that are not of one place or match at several places alike, and name them.
        threads, progress: as in `Case.run`.

    Returns:
        ProfileChange: Traces after a test on the traces before it.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> demo = asperity.demo()
        >>> before = asperity.read_profile("demo/ground_pinion.csv").prepare()
        >>> heights = before.heights.clip(max=0.3e-6)[200:]
        >>> found = asperity.profile_change(before, asperity.Profile(heights, before.spacing, name="after"))
        >>> bool(found.pairs.removed_nm[0] > 10)
        True
        >>> round(found.pairs.shift_um[0])
        100
    """
    settings = {
        "max_shift": written(max_shift, "Length", "max_shift"),
        "max_stretch": max_stretch,
        "form": form,
        "engagements": engagements,
        "flank": flank,
        "leave_out": leave_out,
    }
    return ran(ProfileChange, "profile_change", (raw_traces(before), raw_traces(after), None if case is None else as_case(case)._raw), settings, threads, progress)


def running_in(
    case: CaseLike,
    *,
    torque_nm: Optional[Numbers] = None,
    torque: Optional[Quantities] = None,
    engagements: float = 1000000.0,
    before: Paths = (),
    after: Paths = (),
    test_engagements: Optional[float] = None,
    flank: WornFlank = "pinion",
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> RunningIn:
    """How flanks run in: roughness, film and loss over engagements, and at which torque.

    First the flanks flow: windows of both are pressed together under the whole load, without a film, at places that
    fill traces and path evenly, and what flows at the shakedown limit stays off. Traces are periodic. This ends where
    a doubling of the engagements changes Rq by less than 0.5 %. Then they wear by Archard's law from the pressure of
    the asperities, whose share of the load follows from the film. A tooth of the wheel engages less often, by the
    numbers of teeth. Intervals are from 5 to 95 %: by the pressure at which asperities flow and by the wear. Without
    traces of a test the wear coefficient is 3e-10 mm³/(N m) within a factor of ten each way, a level from handbooks.
    Between traces before and after a test Rq falls with the logarithm of the engagements, which lost least on made
    pairs of three kinds of running-in; the interval contains wear in proportion to the engagements too. Growth of a
    surface film is not modelled: it can raise the boundary friction by up to 1.4 times, and friction that rises again
    late is missed.

    Parameters:
        case: the case.
        torque_nm, torque: torques at the pinion at which the flanks run in, side by side [default: the torque of
            operation.running_in, else of the case].
        engagements: engagements of a tooth of the pinion to which the history goes.
        before: traces of a flank before a test on these gears with this oil, at the first torque.
        after: the traces of the same places after the test.
        test_engagements: engagements of a tooth of the pinion in the test.
        flank: flank of the traces, pinion or wheel.
        threads, progress: as in `Case.run`.

    Returns:
        RunningIn: Running-in of the flanks.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> found = asperity.running_in(case, engagements=100)
        >>> bool(found.courses.factor[0] < 1)
        True
        >>> bool(found.courses[0].rows.pinion_rq_um[-1] < found.courses[0].rows.pinion_rq_um[0])
        True
    """
    settings = {
        "torque": [f"{one!r} N m" for one in nodes("torque_nm", torque_nm, torque, None) or ()],
        "engagements": engagements,
        "before": paths(before, "before"),
        "after": paths(after, "after"),
        "test_engagements": test_engagements,
        "flank": flank,
    }
    return ran(RunningIn, "running_in", (as_case(case)._raw,), settings, threads, progress)


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

    Parameters:
        case: the case.
        hours: hours of a measurement by its name in evidence.csv, ``{"traction-plan": 3}``.
        threads, progress: as in `Case.run`.

    Returns:
        Evidence: Intervals of a loss that measurements would leave.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> table = asperity.evidence(case).rows
        >>> bool(table.width[0] <= table.width[-1])
        True
    """
    settings = {
        "hours": [f"{key}={value}" for key, value in (hours or {}).items()],
    }
    return ran(Evidence, "evidence", (as_case(case)._raw,), settings, threads, progress)


def calibrate(
    rig: Columns,
    case: Optional[CaseLike] = None,
    *,
    cases: Optional[Mapping[str, CaseLike]] = None,
    hold: Sequence[CalibratedParameter] = (),
    torque_max_nm: Optional[float] = None,
    speed_max_rpm: Optional[float] = None,
    temperature_c: Optional[Numbers] = None,
    temperature: Optional[Quantities] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Calibration:
    """Boundary friction, boundary layer and film traction from losses measured on a rig.

    The table has one row per measured point: torque_nm, speed_rpm, temperature_c, loss_w (or torque_loss_nm),
    sigma_w, includes (mesh or mesh+bearings), and where known assembly, run, order, flank_state, case. The result
    says what the points can identify. calibration.toml in it holds the table [calibration] for the case.

    Parameters:
        rig: the measurements, with the columns of the command; a column simulated may say that their losses are.
        case: the case of rows that name none.
        cases: cases by the names in the column case; others are files relative to the table, or to the working
            directory.
        hold: hold a parameter at the value of the case instead of fitting it.
        torque_max_nm: largest torque of the rig at the pinion in N m [default: the largest of the table; of a design
            map.torque_max of the case, or its torque].
        speed_max_rpm: largest speed of the rig at the pinion in 1/min [default: the largest of the table; of a design
            map.speed_max of the case, or its speed].
        temperature_c, temperature: oil temperatures of the rig, numbers or text as ``"10..100:5 °C"`` [default: lowest,
            middle and highest of the table; of a design 40,65,90, extended to the temperature of the case].
        threads, progress: as in `Case.run`.

    Returns:
        Calibration: Constants of boundary layer and film that no data sheet holds, fitted to measured losses, with
            their bands.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(gears="fzg-c"), model={"positions": 4, "offsets": 2})
        >>> plan = asperity.design(case, torque_nm=[60, 183], speed="25..4400:7:log 1/min", simulate=4)
        >>> plan.write("rig")
        >>> found = asperity.calibrate("rig/simulated.csv", case)
        >>> found.is_simulated, found.parameters.key[0]
        (True, 'boundary_friction')
        >>> calibrated = found.apply(case)
    """
    settings = {
        "hold": list(hold),
        "torque_max_nm": torque_max_nm,
        "speed_max_rpm": speed_max_rpm,
        "temperature": nodes("temperature_c", temperature_c, temperature, None),
    }
    return ran(Calibration, "calibrate", (table_of(rig, "rig", Code.E134), None if case is None else as_case(case)._raw, [(key, as_case(one)._raw) for key, one in (cases or {}).items()]), settings, threads, progress)


def design(
    case: CaseLike,
    *,
    torque_nm: Optional[Numbers] = None,
    torque: Optional[Quantities] = None,
    speed_rpm: Optional[Numbers] = None,
    speed: Optional[Quantities] = None,
    hours: float = 8,
    minutes_per_point: float = 15,
    sigma: Union[float, str] = "3 %",
    assemblies: int = 2,
    simulate: Optional[int] = None,
    hold: Sequence[CalibratedParameter] = (),
    torque_max_nm: Optional[float] = None,
    speed_max_rpm: Optional[float] = None,
    temperature_c: Optional[Numbers] = None,
    temperature: Optional[Quantities] = None,
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Design:
    """Points of a rig whose losses determine the calibrated constants best.

    Points within the limits are chosen that narrow the constants most, the gears and flanks of the case being on the
    rig. design.csv in the result is the table to fill in for asperity calibrate.

    Parameters:
        case: the case.
        torque_nm, torque: torques to choose from, numbers or text as ``"10..100:5 N m"`` [default: a third of the
            largest, and the largest].
        speed_rpm, speed: speeds to choose from, numbers or text as ``"10..100:5 1/min"`` [default: 8 speeds from a
            fiftieth of the largest up to it].
        hours: measuring time in hours, without heating.
        minutes_per_point: minutes per point.
        sigma: standard deviation of a point relative to its loss.
        assemblies: number of assemblies; each measures all points.
        simulate: also write simulated.csv: losses at these points, simulated with the case and random errors of this
            seed, to test a calibration.
        hold: hold a parameter at the value of the case instead of fitting it.
        torque_max_nm: largest torque of the rig at the pinion in N m [default: the largest of the table; of a design
            map.torque_max of the case, or its torque].
        speed_max_rpm: largest speed of the rig at the pinion in 1/min [default: the largest of the table; of a design
            map.speed_max of the case, or its speed].
        temperature_c, temperature: oil temperatures of the rig, numbers or text as ``"10..100:5 °C"`` [default: lowest,
            middle and highest of the table; of a design 40,65,90, extended to the temperature of the case].
        threads, progress: as in `Case.run`.

    Returns:
        Design: Measurements on a rig that would narrow the calibrated constants.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> plan = asperity.design(case, hours=4, temperature_c=[40, 90])
        >>> len(plan.points) > 5
        True
    """
    settings = {
        "torque": nodes("torque_nm", torque_nm, torque, None),
        "speed": nodes("speed_rpm", speed_rpm, speed, None),
        "hours": hours,
        "minutes_per_point": minutes_per_point,
        "sigma": sigma,
        "assemblies": assemblies,
        "simulate": simulate,
        "hold": list(hold),
        "torque_max_nm": torque_max_nm,
        "speed_max_rpm": speed_max_rpm,
        "temperature": nodes("temperature_c", temperature_c, temperature, None),
    }
    return ran(Design, "design", (as_case(case)._raw,), settings, threads, progress)


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

    Parameters:
        oil: the oil.
        load: load.
        speed: mean speed of the curves over the slide-to-roll ratio.
        slide_to_roll: slide-to-roll ratio of the curves over the speed.
        temperature_c, temperature: temperatures of the oil bath, numbers or text as ``"10..100:5 °C"`` [default:
            40,80,120 °C].
        boundary_friction: boundary friction to which the dashed guide of the chart leads [default: the value of the
            model].
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        threads: as in `Case.run`.

    Returns:
        Traction: Predicted traction.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> curves = asperity.oil_traction("m100", temperature_c=[40, 100])
        >>> bool(curves.over_slide.traction.max() < 0.2)
        True
    """
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
    return ran(Traction, "oil_traction", (raw_oil(oil),), settings, threads)


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
    """Constants of an oil from measured traction curves of ball and disc, with their intervals.

    A table has the columns load_n, mean_speed_m_s, slide_roll_percent (200 is pure sliding), temperature_c and
    traction, and where known sigma, group, set_temperature_c, film_nm and the specimens; a text export of a PCS
    machine is read as it is. oil.toml in the result is the oil file that a case names by lubricant.oil_file.

    Parameters:
        curves: one or several files, frames or columns, with the columns of the command.
        oil: the oil, for viscosity and family.
        temperature_column: probe of the temperature in a text export.
        force: accept constants of no known oil.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        wide: leave the constants to the points, with wide priors instead of the family.
        zero: zeros of the friction.
        point_sd: standard deviation of points without sigma, relative to the friction.
        point_floor: least standard deviation of the friction coefficient of such points.
        threads: as in `Case.run`.

    Returns:
        OilFit: Constants of an oil fitted to traction curves.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> curves = asperity.oil_traction("m100").over_slide
        >>> columns = ["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction"]
        >>> found = asperity.oil_fit(curves[columns], "m100")
        >>> found.pressure_law
        'barus'
    """
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
    return ran(OilFit, "oil_fit", (tables_of_curves(curves, "curves"), raw_oil(oil)), settings, threads)


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

    Parameters:
        oil: the oil.
        case: the case whose loss is to be narrowed [default: the case of the oil if it is of one].
        simulate: write simulated.csv with simulated friction of the standard plan, with this seed.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        wide: leave the constants to the points, with wide priors instead of the family.
        zero: zeros of the friction.
        point_sd: standard deviation of points without sigma, relative to the friction.
        point_floor: least standard deviation of the friction coefficient of such points.
        threads: as in `Case.run`.

    Returns:
        OilPlan: Traction measurements to make.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> plan = asperity.oil_plan("m100")
        >>> len(plan.stages) > 2
        True
    """
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
    return ran(OilPlan, "oil_plan", (raw_oil(oil), None if case is None else as_case(case)._raw), settings, threads)


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
    """Boundary friction from Stribeck curves of ball and disc, with its interval.

    The files have the columns of a traction curve, and rubbing_s, the time for which the specimens have rubbed
    before. Points with a film of at most a fifth of the roughness count. How much of the load of gears the layer
    carries does not follow from them: model.inner_boundary is drawn.

    Parameters:
        curves: one or several files, frames or columns, with the columns of the command.
        oil: the oil, for viscosity and family.
        rubbing: time of rubbing before each file, 0 s for new specimens, unless a row states it.
        temperature_column: probe of the temperature in a text export.
        rq: root mean square roughness of both specimens together.
        ball_radius: radius of the ball, unless a row states it.
        second_radius: radius of the second body, unless a row states it [default: a flat disc].
        threads: as in `Case.run`.

    Returns:
        Stribeck: Boundary friction of rubbed specimens.

    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
        >>> speeds = [0.002, 0.003, 0.004, 0.005]
        >>> curve = {"mean_speed_m_s": speeds, "load_n": [50.0] * 4, "slide_roll_percent": [50.0] * 4,
        ...          "temperature_c": [120.0] * 4, "traction": [0.117] * 4, "rubbing_s": [7200.0] * 4}
        >>> found = asperity.stribeck(curve, "m100")
        >>> 0.1 < found.boundary_friction < 0.13
        True
    """
    settings = {
        "rubbing": [written(one, "Time", "rubbing") for one in rubbing],
        "temperature_column": temperature_column,
        "rq": written(rq, "Length", "rq"),
        "ball_radius": written(ball_radius, "Length", "ball_radius"),
        "second_radius": None if second_radius is None else written(second_radius, "Length", "second_radius"),
    }
    return ran(Stribeck, "stribeck", (tables_of_curves(curves, "curves"), raw_oil(oil)), settings, threads)
