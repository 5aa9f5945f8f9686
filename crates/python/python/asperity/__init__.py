"""Mesh efficiency of gears from measured roughness.

A number has the unit that its name states, in arguments (``torque_nm=145``) and results (``loss_w``, ``film_minimum_um``);
a name without a unit takes text with a unit (``torque="145 N m"``) or a quantity of pint. Arrays of profiles, contacts and
laws are in SI units. Errors are `AsperityError`, warnings `AsperityWarning`, with ``code`` and ``help``.

    import asperity
    case = asperity.Case("case.toml", torque_nm=145)
    result = case.run()
    result.loss_w, result.path.lambda_star, result.to_pandas()
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional

from . import _asperity, _study_names
from ._asperity import __version__

if TYPE_CHECKING:
    from ._calibration import Calibration, Design, Evidence
    from ._callout import CallOut
    from ._case import Case
    from ._compare import Comparison
    from ._contact import Contact, Stress, press_flanks, solve_contact, subsurface_stress
    from ._ehl import EhlRecord, ehl
    from ._errors import AsperityError, AsperityWarning, Place
    from ._html import Chart
    from ._laws import film_thickness, friction_coefficient, hertz, thermal_reduction
    from ._library import RexsCase, demo, from_rexs, gears, oils, rexs_contents, steels
    from ._map import Cycle, Map, read_map
    from ._oil import OilFit, OilPlan, Stribeck, Traction
    from ._profile import Parameters, Parts, Profile, generate, generate_like, read_profile
    from ._record import Record, Table
    from ._result import Fields, Path, Regime, RunResult, Summary
    from ._profile_change import ProfileChange
    from ._ridges import Ridges
    from ._running_in import RunningIn
    from ._sensitivity import Sensitivity
    from ._stored import read_result
    from ._studies import *
    from ._studies import map as map
    from ._sweep import Sweep, sweep
    from ._versions import show_versions
else:
    _HOMES = {
        "_calibration": "Calibration Design Evidence",
        "_callout": "CallOut",
        "_case": "Case",
        "_compare": "Comparison",
        "_contact": "Contact Stress press_flanks solve_contact subsurface_stress",
        "_ehl": "EhlRecord ehl",
        "_errors": "AsperityError AsperityWarning Place",
        "_html": "Chart",
        "_laws": "film_thickness friction_coefficient hertz thermal_reduction",
        "_library": "RexsCase demo from_rexs gears oils rexs_contents steels",
        "_map": "Cycle Map read_map",
        "_oil": "OilFit OilPlan Stribeck Traction",
        "_profile": "Parameters Parts Profile generate generate_like read_profile",
        "_record": "Record Table",
        "_result": "Fields Path Regime RunResult Summary",
        "_profile_change": "ProfileChange",
        "_ridges": "Ridges",
        "_running_in": "RunningIn",
        "_sensitivity": "Sensitivity",
        "_stored": "read_result",
        "_studies": " ".join(["map", *_study_names.__all__]),
        "_sweep": "Sweep sweep",
        "_versions": "show_versions",
    }
    _HOME = {name: module for module, names in _HOMES.items() for name in names.split()}

    def __getattr__(name: str) -> object:
        """A name of a module that is imported at its first use, which keeps the import of the package short."""
        if name not in _HOME:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        found = getattr(__import__(f"{__name__}.{_HOME[name]}", fromlist=[name]), name)
        globals()[name] = found
        return found

    def __dir__() -> list[str]:
        return sorted({*globals(), *_HOME})


# All that is public but `map`: `from asperity import *` must not replace the built-in function.
__all__ = [
    "AsperityError",
    "AsperityWarning",
    "Calibration",
    "CallOut",
    "Case",
    "Chart",
    "Comparison",
    "Contact",
    "Cycle",
    "Design",
    "EhlRecord",
    "Evidence",
    "Explanation",
    "Fields",
    "Map",
    "OilFit",
    "OilPlan",
    "Parameters",
    "Parts",
    "Path",
    "Place",
    "Profile",
    "ProfileChange",
    "Record",
    "Regime",
    "RexsCase",
    "Ridges",
    "RunResult",
    "RunningIn",
    "Sensitivity",
    "Stress",
    "Stribeck",
    "Summary",
    "Sweep",
    "Table",
    "Traction",
    "__version__",
    "demo",
    "ehl",
    "explain",
    "film_thickness",
    "friction_coefficient",
    "from_rexs",
    "gears",
    "generate",
    "generate_like",
    "hertz",
    "oils",
    "press_flanks",
    "read_map",
    "read_profile",
    "read_result",
    "rexs_contents",
    "schema",
    "show_versions",
    "solve_contact",
    "steels",
    "subsurface_stress",
    "sweep",
    "thermal_reduction",
]
__all__ += _study_names.__all__
if TYPE_CHECKING:
    # To type checkers a name that is not listed is private.
    __all__ += ["map"]


class Explanation(NamedTuple):
    """Title, meaning and remedy of a message code."""

    title: str
    meaning: str
    remedy: str


def schema(kind: Literal["gears", "mesh", "settings"] = "gears") -> dict[str, Any]:
    """JSON schema of a case with this table of gears, or of the settings of the studies, each by the name of its function.

    Parameters:
        kind: ``"gears"``, ``"mesh"`` (which has the meshes of a gear train by name) or ``"settings"``.

    Returns:
        The schema as a dictionary.

    Raises:
        AsperityError: another kind (E204), or the schema cannot be written, which is a fault of the program (E501).

    Example:
        >>> "gears" in asperity.schema()["properties"]
        True
    """
    if kind not in ("gears", "mesh", "settings"):
        from ._errors import AsperityError, Code

        raise AsperityError(f'kind: {kind!r} is not one of "gears", "mesh", "settings"', Code.E204, "Give one of these names.")
    # At its first need: it is not part of a run.
    import json

    found: dict[str, Any] = json.loads(_asperity.schema(kind))
    return found


def explain(code: str) -> Optional[Explanation]:
    """Title, cause and remedy of a code such as ``E301``; none of a code that does not exist.

    Parameters:
        code: the code of an error or a warning.

    Returns:
        An `Explanation`, or None.

    Raises:
        TypeError: the code is not a string.

    Example:
        >>> try:
        ...     asperity.read_profile("missing.csv")
        ... except asperity.AsperityError as error:
        ...     explained = asperity.explain(error.code)
        ...     print(explained.title if explained else "no such code")
        a file cannot be opened
    """
    found = _asperity.explain(code)
    return None if found is None else Explanation(*found)
