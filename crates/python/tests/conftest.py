"""Shared traces, cases and the command."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import subprocess
import sys
import typing
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import asperity
from asperity._quantity import SI_UNITS, si
from asperity._record import Record, TableOf, Values
from asperity._study import Study

ROOT = Path(__file__).resolve().parents[3]
CASES = ROOT / "fixtures" / "cases"
PROFILES = ROOT / "fixtures" / "profiles"


def heights(points: int) -> np.ndarray:
    """Heights in µm of a rough trace without chance: three waves that share no period."""
    i = np.arange(points)
    return sum(a * np.sin(2 * np.pi * i / p) for a, p in ((0.3, 101.0), (0.2, 37.7), (0.1, 13.3)))


def trace(points: int = 6000) -> asperity.Profile:
    """The same as a profile, half a micrometre apart."""
    return asperity.Profile(heights(points) * 1e-6, 0.5e-6, name="waves")


def small(**changed: Any) -> dict[str, Any]:
    """A case that is quickly run, on traces in memory."""
    case: dict[str, Any] = {
        "title": "small",
        "gears": {"teeth": [23, 68], "module": "1.8 mm", "helix": "23.4 deg", "face_width": ["35 mm", "32 mm"]},
        "material": {"pinion": {"elastic_limit": "1500 MPa", "flow_pressure": "7 GPa"}},
        "operation": {"torque": "145 N m", "speed": "9000 1/min", "bulk_temperature": "90 °C"},
        "lubricant": {
            "viscosity": {"law": "astm-d341", "at_40": "30.8 mm2/s", "at_100": "5.9 mm2/s"},
            "density": "845 kg/m3",
            "base_oil": "pao",
        },
        "surface": {"cutoff": "0.25 mm", "pinion": trace(), "wheel": trace().mirrored()},
        "model": {"positions": 4, "offsets": 2},
    }
    for path, value in changed.items():
        table, *keys = path.split("__")
        if keys:
            case[table] = {**case[table], keys[0]: value}
        else:
            case[table] = value
    return case


_AT = {
    "operation": {"torque": "60 N m", "speed": "3000 1/min", "bulk_temperature": "80 °C"},
    "lubricant": {"oil": "m100"},
    "model": {"positions": 4, "offsets": 2},
}
_GEARS = {"teeth": [23, 68], "module": "2 mm", "face_width": "25 mm"}
SETS: dict[str, dict[str, Any]] = {
    "planetary": {
        "title": "set",
        "planetary": {"teeth": [24, 27, -78], "planets": 3, "module": "2 mm", "face_width": ["25 mm", "25 mm", "30 mm"]},
        "surface": {"sun": {"rq": "0.4 um"}},
        **_AT,
    },
    "train": {
        "title": "two stages",
        "train": {"input": "in"},
        "mesh": {"a": {"shafts": ["in", "b"], "gears": _GEARS}, "z": {"shafts": ["b", "out"], "gears": _GEARS}},
        "surface": {"pinion": {"rq": "0.4 um"}},
        **_AT,
    },
}
"""Cases of several meshes."""


@pytest.fixture(scope="session")
def case() -> asperity.Case:
    """The small case."""
    return asperity.Case(small())


@pytest.fixture(scope="session")
def result(case: asperity.Case) -> asperity.RunResult:
    """A run of it with fields."""
    return case.run(band=False)


@pytest.fixture(scope="session")
def command() -> str:
    """The command asperity: of ASPERITY_COMMAND, of this environment, or on the path."""
    beside = Path(sys.executable).parent / "asperity"
    found = os.environ.get("ASPERITY_COMMAND") or (str(beside) if beside.is_file() else shutil.which("asperity"))
    assert found, "the command asperity is not here"
    return found


def undeclared(values, within=""):
    """Values of a study, and of all that it holds, whose names their classes do not declare or that have another type there."""
    kinds = typing.get_type_hints(type(values))
    for name in values:
        is_property = isinstance(getattr(type(values), name, None), property)
        value, kind = getattr(values, name) if is_property else values[name], kinds.get(name)
        if kind is None and not is_property:
            yield f"{within}{type(values).__name__}.{name}"
        elif kind in (int, float, str, bool) and not isinstance(value, (kind, int) if kind is float else kind):
            yield f"{within}{type(values).__name__}.{name} = {value!r}, not {kind.__name__}"
        for one in value if isinstance(value, TableOf) else [value]:
            if isinstance(one, Values) and not isinstance(one, Record):
                yield from undeclared(one, f"{type(values).__name__}: ")


def quantities_as_text(value, within=""):
    """Paths of texts that are a number with a unit, but not what a case, a recipe or the library states."""
    if isinstance(value, dict):
        for name, item in value.items():
            if name not in ("input", "inputs", "defaults", "changes", "recipe", "preset", "from", "to", "title", "name", "names"):
                yield from quantities_as_text(item, f"{within}.{name}")
    elif isinstance(value, list):
        for item in value:
            yield from quantities_as_text(item, within)
    elif isinstance(value, str) and value[:1] in {*"-0123456789"}:
        for quantity in SI_UNITS:
            with contextlib.suppress(asperity.AsperityError):
                si(value, quantity)
                yield f"{within} = {value!r}"
                break


@pytest.fixture(autouse=True)
def every_study_has_what_its_class_declares(monkeypatch):
    """Fails where a study of a test has a value that type checkers do not know."""
    begin = Study.__init__

    def checked(self, raw):
        begin(self, raw)
        assert not [*quantities_as_text(self._values)], "numbers whose names end with their units"
        assert not [*undeclared(self)], "name an example in MORE of crates/python/typed.py that has it, and run typed.py"

    monkeypatch.setattr(Study, "__init__", checked)


def json_of(command: str, *arguments: object) -> Any:
    """What the command prints with --json."""
    run = subprocess.run([command, *map(str, arguments), "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)
