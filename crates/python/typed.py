"""Writes what follows from the lists of the compiled part into python/asperity: _choices.py, texts that arguments take and names of
columns; keys.py, types of case keys; _values.py, classes of the values of results; _studies.py, the studies with their settings, and
_study_names.py, their names.

    python crates/python/typed.py          # after building the module
"""

import inspect
import json
import keyword
import os
import re
import sys
import tempfile
import textwrap
import warnings
from pathlib import Path
from typing import NamedTuple

import asperity
from asperity import _asperity
from asperity._quantity import BY_TEXT, OPERATING
from asperity._record import ends_of
from asperity._study import Study

FOLDER = Path(__file__).parent / "python" / "asperity"
RESULTS = {
    "calibrate": "Calibration", "callout": "CallOut", "compare": "Comparison", "cycle": "Cycle", "design": "Design", "evidence": "Evidence", "map": "Map", "oil_fit": "OilFit", "oil_plan": "OilPlan", "oil_traction": "Traction", "profile_change": "ProfileChange", "ridges": "Ridges", "running_in": "RunningIn",
    "sensitivity": "Sensitivity", "stribeck": "Stribeck",
}
"""Classes of the results of studies that have attributes of their own."""
SMALL = 'case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})'
"""A case that is quickly run, for the examples."""
EXAMPLES = {
    "compare": [SMALL, 'finishes = {"ground": "demo/ground_pinion.csv", "fine": "demo/superfinished_pinion.csv"}', "found = asperity.compare(case, finishes)",
                ("found.names", "['ground', 'fine']"), ("bool(found.finishes.loss_w[1] < found.finishes.loss_w[0])", "True"),
                ('asperity.compare(case, {"pao": {"lubricant.oil": "pao100"}, "mineral": {"lubricant.oil": "m100"}}).names', "['pao', 'mineral']")],
    "map": [SMALL, 'losses = asperity.map(case, torque_nm=[50, 145], speed="1000..9000:3 1/min", band="none")', ("losses.loss_w.shape", "(1, 1, 2, 4)"),
            ("float(losses.loss_torque(torque_nm=100, speed_rpm=4000)) > 0", "True")],
    "cycle": [SMALL, 'losses = asperity.map(case, torque_nm=[-200, -60, -20, 20, 60, 200], speed_rpm=[500, 4000, 16000])',
              'energies = asperity.cycle(losses, "demo/urban.csv")', ("bool(energies.finishes.lost_wh[0] > 0)", "True")],
    "sensitivity": [SMALL, "found = asperity.sensitivity(case)", ("len(found.rows) > 5", "True")],
    "ridges": [SMALL, "found = asperity.ridges(case)", ("found.pressed_at_medians_w < found.loss_at_medians_w", "True")],
    "callout": ['case = asperity.Case(asperity.demo(), model={"positions": 2, "offsets": 2})',
                'found = asperity.callout(case, "600 W", parameter="rq", traces=3, lots=20, confidence=0.8)', ("found.limits.parameter[0]", "'Rq'")],
    "evidence": [SMALL, "table = asperity.evidence(case).rows", ("bool(table.width[0] <= table.width[-1])", "True")],
    "design": [SMALL, "plan = asperity.design(case, hours=4, temperature_c=[40, 90])", ("len(plan.points) > 5", "True")],
    "calibrate": ['case = asperity.Case(asperity.demo(gears="fzg-c"), model={"positions": 4, "offsets": 2})',
                  'plan = asperity.design(case, torque_nm=[60, 183], speed="25..4400:7:log 1/min", simulate=4)', 'plan.write("rig")',
                  'found = asperity.calibrate("rig/simulated.csv", case)', ("found.is_simulated, found.parameters.key[0]", "(True, 'boundary_friction')"),
                  "calibrated = found.apply(case)"],
    "oil_traction": ['curves = asperity.oil_traction("m100", temperature_c=[40, 100])', ("bool(curves.over_slide.traction.max() < 0.2)", "True")],
    "profile_change": ['demo = asperity.demo()', 'before = asperity.read_profile("demo/ground_pinion.csv").prepare()', 'heights = before.heights.clip(max=0.3e-6)[200:]',
                       'found = asperity.profile_change(before, asperity.Profile(heights, before.spacing, name="after"))',
                       ('bool(found.pairs.removed_nm[0] > 10)', "True"), ('round(found.pairs.shift_um[0])', "100")],
    "running_in": [SMALL, "found = asperity.running_in(case, engagements=100)", ("bool(found.courses.factor[0] < 1)", "True"),
                   ("bool(found.courses[0].rows.pinion_rq_um[-1] < found.courses[0].rows.pinion_rq_um[0])", "True")],
    "oil_plan": ['plan = asperity.oil_plan("m100")', ("len(plan.stages) > 2", "True")],
    "oil_fit": ['curves = asperity.oil_traction("m100").over_slide',
                'columns = ["load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction"]',
                'found = asperity.oil_fit(curves[columns], "m100")', ("found.pressure_law", "'barus'")],
    "stribeck": ['speeds = [0.002, 0.003, 0.004, 0.005]',
                 'curve = {"mean_speed_m_s": speeds, "load_n": [50.0] * 4, "slide_roll_percent": [50.0] * 4,',
                 '         "temperature_c": [120.0] * 4, "traction": [0.117] * 4, "rubbing_s": [7200.0] * 4}',
                 'found = asperity.stribeck(curve, "m100")', ("0.1 < found.boundary_friction < 0.13", "True")],
}
"""An example of each study: lines, each alone or with what it prints."""
MORE = [
    ['case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 6})',
     'of = {"a": "demo/ground_pinion.csv", "b": "demo/superfinished_pinion.csv", "c": ("demo/ground_pinion.csv", "demo/superfinished_pinion.csv")}',
     "asperity.compare(case, of)", "losses = asperity.map(case, finishes=of, torque_nm=[-200, -60, 60, 200], speed_rpm=[500, 4000, 16000])",
     'asperity.map(case, finishes={"pao": {"lubricant.oil": "pao100"}}, torque_nm=[60, 200], speed_rpm=[4000, 16000])',
     'asperity.cycle(losses, "demo/urban.csv")', 'trace = {"time_s": [0, 60, 120], "torque_nm": [60, 190, 205], "speed_rpm": [900, 4000, 9000], "gear": [1, 1, 1]}',
     "asperity.cycle(asperity.map(case.replace({'vehicle': None}), torque_nm=[-60, 60], speed_rpm=[500, 9000]), trace, allow_outside=True)"],
    [SMALL, 'asperity.oil_plan("m100", case, simulate=1)'],
    [SMALL, 'asperity.oil_plan(case)'],
    ['flank = asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1)', 'asperity.profile_change([flank[:6000], flank[1000:]], [flank[100:5000], flank[1200:6000]])'],
    ['flank = asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=2)',
     'heights = [z + 0.5e-6 * (k / 4000 - 1) ** 2 for k, z in enumerate(flank.heights.clip(max=0.3e-6))]', 'bowed = asperity.Profile(heights, flank.spacing)',
     'asperity.profile_change(flank, bowed)', 'asperity.profile_change(flank, bowed, form="poly2")'],
    [SMALL, 'before = asperity.read_profile("demo/ground_pinion.csv").prepare()', 'worn = asperity.Profile(before.heights.clip(max=0.3e-6)[200:], before.spacing, name="worn")',
     'settings = {"flank": "pinion", "engagements": 1e6}', 'asperity.profile_change(before, worn, case, **settings)', 'asperity.profile_change(before, before, case, **settings)',
     'asperity.profile_change([before, before], [worn, before], case.replace({"formulation": "paper"}), flank="pinion")'],
    [SMALL, 'before = asperity.read_profile("demo/ground_pinion.csv").prepare()', 'before.write("before.csv")',
     'asperity.Profile(before.heights.clip(max=0.1e-6), before.spacing).write("after.csv")',
     'asperity.running_in(case, before="before.csv", after="after.csv", test_engagements=100, engagements=100)'],
    ['gears = {"teeth": [23, 68], "module": "2 mm", "face_width": "25 mm"}',
     'meshes = {"a": {"shafts": ["in", "b"], "gears": gears}, "z": {"shafts": ["b", "out"], "gears": gears}}',
     'case = asperity.Case(train={"input": "in"}, mesh=meshes, surface={"pinion": {"rq": "0.4 um"}}, torque_nm=60, speed_rpm=3000, temperature_c=80,',
     '                     lubricant={"oil": "m100"}, model={"positions": 4, "offsets": 2})',
     'asperity.compare(case, {"rough": case, "fine": case.replace({"surface.pinion.rq": "0.2 um"})})'],
]
"""Examples whose results have what those of the first ones leave out."""
OPEN = (
    "along", "axes", "by_traces", "curve", "curves", "defaults", "draws", "evidence", "helpful", "held_out", "identifiability", "input", "kinks", "lubricant", "near", "nuisance", "other_law", "stages",
)
"""Values that are keys of a case, or how a result was found; they stay without a class."""
STATED = {
    "code": "Optional[str]", "dropped": "Optional[str]", "would_help": "Optional[str]", "OilFitPoint.curve": "int",
    # Of flanks that change, of a test that the wear of the model does not reach, and of one that plastic flow does not explain.
    **dict.fromkeys(
        ("RunningInCourse.done_engagements", "RunningInCourse.done_hours", "RunningInCourse.ends_at", "RunningInTest.k_mm3_per_n_m"), "Optional[float]"
    ),
    "RunningInTest.k_quantiles_mm3_per_n_m": "Optional[Floats]",
    # Of cases with draws only.
    "RunningIn.loss_quantiles_w": "Optional[Floats]",
    **dict.fromkeys(
        ("ComparisonFinish.loss_at_medians_w", "ComparisonFinishMesh.loss_at_medians_w", "CycleFinish.lost_at_medians_wh", "Sensitivity.loss_at_medians_w"),
        "Optional[float]",
    ),
    # Of changes without draws in common.
    **dict.fromkeys(("SensitivityRow.sampling_p05_w", "SensitivityRow.sampling_p95_w"), "Optional[float]"),
}
"""Types of columns that are empty in the examples, or left open elsewhere."""
LISTS = {"float": "Floats", "int": "Floats", "str": "list[str]"}
"""Types of lists, by the type of what they hold."""
KINDS = ("gears", "mesh")
ROOTS = {"Uncertainty": "Uncertainty", "Summary": "SummaryValues", "PositionRow": "PathRow", "ContactNumbers": "ContactNumbers"}
"""Classes of values of which others are parts, by the name of the type in Rust."""
RENAMED = {**ROOTS, "ContactNote": "Note"}
"""Classes with another name than the type in Rust; a note of a contact is as those of all results."""
QUANTITIES = {name for name, _ in _asperity.si_units()}
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}
HEAD_OF_CHOICES = '''"""Choices of arguments and names of columns.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from typing import Literal
'''
HEAD = '''"""Keys of a case and choices of arguments, for type checkers and completion.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Literal, Optional, TypedDict, Union

from ._choices import *
from ._profile import Profile
from ._quantity import PintLike, Quantity
'''
HEAD_OF_VALUES = '''"""Values of results by name.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from typing import Any, Literal, NoReturn, Optional

from numpy.typing import NDArray

from ._quantity import Floats
from ._record import TableOf, Values
'''


def union(parts):
    """One type of several, without None: texts that are choices together as one."""
    literals = [text for part in parts if part.startswith("Literal[") for text in part[8:-1].split(", ")]
    others = [part for part in dict.fromkeys(parts) if part != "None" and not part.startswith("Literal[")]
    every = ([f"Literal[{', '.join(dict.fromkeys(literals))}]"] if literals else []) + others
    return every[0] if len(every) == 1 else f"Union[{', '.join(every)}]"


class Tables:
    """Types of the tables of a case.

    A table that has other keys or types in a case of another kind is another class there, as `BearingInput` and
    `MeshBearingInput`.
    """

    def __init__(self):
        self.schemas = {kind: json.loads(_asperity.schema(kind)) for kind in KINDS}
        self.kind = KINDS[0]
        self.classes = {}
        self._names = {}

    def _definition(self, name):
        """The definition of this name in cases of the current kind."""
        return self.schemas[self.kind]["$defs"][name]

    def _whole(self, node, above=()):
        """The node with the definitions that it refers to, without descriptions."""
        if isinstance(node, list):
            return [self._whole(item, above) for item in node]
        if not isinstance(node, dict):
            return node
        name = node.get("$ref", "").rsplit("/", 1)[-1]
        if name:
            return name if name in QUANTITIES or name in above else self._whole(self._definition(name), (*above, name))
        return {key: self._whole(item, above) for key, item in node.items() if key not in ("description", "named")}

    def _class_of(self, name, node):
        """Name of the class of a table: the name of its definition, after the kind if other kinds have another table."""
        known = self._names.setdefault(name, {})
        return known.setdefault(json.dumps(self._whole(node), sort_keys=True), f"{self.kind.title()}{name}" if known else name)

    def type_of(self, node, key=""):
        """The type of a node of the schema as text, without None."""
        return union(self._parts(node, key))

    def _parts(self, node, key):
        if node is True:
            return ["object"]
        if "$ref" in node:
            name = node["$ref"].rsplit("/", 1)[-1]
            if name in QUANTITIES:
                return ["Quantity"]
            parts = self._parts({**self._definition(name), "named": name}, key)
            return [*parts, "str", "PathLike[str]", "Profile"] if name in ("FlankInput", "TraceInput") else parts
        for kind in ("anyOf", "oneOf"):
            if kind in node:
                return [part for item in node[kind] for part in self._parts(item, key)]
        if "enum" in node or "const" in node:
            values = node.get("enum", [node.get("const")])
            return [f"Literal[{', '.join(json.dumps(value) for value in values)}]"]
        kinds = node.get("type", "object")
        found = []
        for kind in [kinds] if isinstance(kinds, str) else kinds:
            if kind == "array":
                items = [*node.get("prefixItems", []), *([node["items"]] if isinstance(node.get("items"), dict) else [])]
                inner = list(dict.fromkeys(self.type_of(item) for item in items))
                found.append(f"Sequence[{inner[0] if len(inner) == 1 else 'Union[' + ', '.join(inner) + ']'}]")
            elif kind == "object":
                found.append(self._table(node, key))
            else:
                found += ["str", "PathLike[str]", "Profile"] if key == "file" and kind == "string" else [PLAIN[kind]]
        return found

    def _table(self, node, key):
        if isinstance(node.get("additionalProperties"), dict):
            return f"Mapping[str, {self.type_of(node['additionalProperties'])}]"
        if "properties" not in node:
            return "Mapping[str, object]"
        # Tables that are alternatives of one key are told apart by the value that only one of them takes.
        only = [item["const"] for item in node["properties"].values() if "const" in item]
        name = self._class_of(node.get("named") or "".join(part.title() for part in "_".join([key, *only]).replace("-", "_").split("_")), node)
        if name not in self.classes:
            self.classes[name] = None
            rows = {key: f"Optional[{self.type_of(item, key)}]" for key, item in node["properties"].items()}
            self.classes[name] = (node.get("description", ""), rows)
        return name

    def top(self):
        """Types of the tables of all kinds of cases."""
        found = {}
        for self.kind, schema in self.schemas.items():
            for key, node in schema["properties"].items():
                found.setdefault(key, []).extend(self._parts(node, key))
        return {**{key: f"Optional[{union(parts)}]" for key, parts in found.items()}, **dict.fromkeys(OPERATING, "Optional[float]"), **dict.fromkeys(BY_TEXT, "Optional[Quantity]")}

    def paths(self):
        """Types of single keys by their paths."""
        found = {}

        def nodes(node):
            yield node
            if "$ref" in node and node["$ref"].rsplit("/", 1)[-1] not in QUANTITIES:
                yield from nodes(self._definition(node["$ref"].rsplit("/", 1)[-1]))
            for kind in ("anyOf", "oneOf"):
                for item in node.get(kind, []):
                    yield from nodes(item)

        def add(path, node, key, above):
            found.setdefault(path, []).extend(self._parts(node, key))
            for one in nodes(node):
                named = one.get("$ref")
                for number, item in enumerate(one.get("prefixItems", [one["items"]] * one["maxItems"] if isinstance(one.get("items"), dict) and "maxItems" in one else [])):
                    add(f"{path}.{number}", item, key, above)
                for below, item in one.get("properties", {}).items():
                    if named not in above or named is None:
                        add(f"{path}.{below}", item, below, above | {named} - {None})

        for self.kind in KINDS:
            for key, node in self.schemas[self.kind]["properties"].items():
                add(key, node, key, frozenset())
        return {path: f"Optional[{union(parts)}]" for path, parts in found.items()}


def first_line(text):
    """The first sentence of a description."""
    text = " ".join(text.replace("\\[", "[").replace("\\]", "]").split()).replace("\\", "").replace('"', "'")
    return text.split(". ")[0].rstrip(".") + "."


def literal(name, values):
    lines, line = [], "   "
    for value in values:
        word = f' "{value}",'
        if len(line) + len(word) > 118:
            lines.append(line)
            line = "   "
        line += word
    return f"{name} = Literal[\n" + "\n".join([*lines, line]) + "\n]\n"


def table(name, about, rows):
    """A table as a class, or by a call where a key is no name of Python."""
    if all(key.isidentifier() and not keyword.iskeyword(key) for key in rows):
        body = "".join(f"    {key}: {kind}\n" for key, kind in rows.items())
        return f'class {name}(TypedDict, total=False):\n    """{first_line(about)}"""\n\n{body}'
    body = "".join(f"        {json.dumps(key)}: {json.dumps(kind) if chr(34) not in kind else repr(kind)},\n" for key, kind in rows.items())
    return f'{name} = TypedDict(\n    "{name}",\n    {{\n{body}    }},\n    total=False,\n)\n"""{first_line(about)}"""\n'


def declared(result):
    """Names that the class of a result declares itself."""
    return {key for one in result.__mro__ for key in vars(one)}


def attributes(name, about, names, kind, result):
    """Attributes of a result that the class `result` does not declare itself."""
    body = "".join(f"    {key}: {kind}\n" for key in names if key not in declared(result))
    return f'class {name}:\n    """{about}"""\n\n{body}'


class Registry:
    """Types of the values of results, from a registry of serde-reflection."""

    def __init__(self):
        self.registry = json.loads(_asperity.values())

    def name_of(self, name):
        return RENAMED.get(name, name)

    def type_of(self, form):
        """The type of a value as text, and its class where it is an object or a list of objects."""
        if isinstance(form, str):
            return {"STR": "str", "BOOL": "bool", "F64": "float", "F32": "float"}.get(form, "int" if form[0] in "IU" and form != "UNIT" else "Any"), None
        (kind, of), = form.items()
        if kind == "TYPENAME":
            container = self.registry[of]
            if "STRUCT" in container:
                return self.name_of(of), self.name_of(of)
            if "NEWTYPESTRUCT" in container:
                return self.type_of(container["NEWTYPESTRUCT"])
            variants = [one for one in container.get("ENUM", {}).values()]
            plain = variants and all(list(one.values()) == ["UNIT"] for one in variants)
            return (f"Literal[{', '.join(json.dumps(next(iter(one))) for one in variants)}]" if plain else "Any"), None
        if kind == "OPTION":
            inner, made = self.type_of(of)
            return inner if inner == "Any" else f"Optional[{inner}]", made
        if kind in ("SEQ", "TUPLE", "TUPLEARRAY"):
            inner = self.type_of(of if kind == "SEQ" else of[0] if kind == "TUPLE" else of["CONTENT"])
            if inner[1]:
                return f"{inner[1]}Table", f"{inner[1]}Table"
            return LISTS.get(inner[0], "list[Any]"), None
        return "Any", None

    def absent(self, kind):
        """The value, if any, at which serde leaves out a value of this type."""
        if kind.startswith("Optional["):
            return [None]
        return [[]] if kind.endswith("Table") else {"str": [""], "bool": [False], "list[str]": [[]], "list[Any]": [[]]}.get(kind, [])

    def structures(self):
        """Types of the values of all structures that the roots have, those that others need first, and names of those that are rows."""
        found, rows = {}, set()

        def add(name):
            if self.name_of(name) in found:
                return
            fields = [next(iter(field.items())) for field in self.registry[name]["STRUCT"]]
            for part in re.findall(r"'TYPENAME': '(\w+)'", repr(fields)):
                if "STRUCT" in self.registry[part]:
                    add(part)
            types = {key: self.type_of(form) for key, form in fields}
            rows.update(made.removesuffix("Table") for _, made in types.values() if made and made.endswith("Table"))
            absent = {key: value for key, (kind, _) in types.items() for value in self.absent(kind)}
            found[self.name_of(name)] = Structure(f"Values of `{name}` in Rust.", types, absent)

        for name in ROOTS:
            add(name)
        return found, {*rows, "PathRow"}


class Structure(NamedTuple):
    """A class of values."""

    about: str
    types: dict
    """Type of each value as text, and its class where it is an object or a list of objects."""
    absent: dict
    """Values where they are left out."""

    def written(self, name, own=()):
        """The class of this name, without the values that the class of a result declares itself."""
        kinds = ", ".join(f'"{key}": {made}' for key, (_, made) in self.types.items() if made)
        text = f"class {name}(Values):\n" + (f'    """{self.about}"""\n\n' if self.about else "")
        text += f"    _kinds = {{{kinds}}}\n" if kinds else ""
        text += f"    _absent = {json.dumps(self.absent).replace('null', 'None').replace('false', 'False')}\n" if self.absent else ""
        return text + "".join(f"    {key}: {kind}\n" for key, (kind, _) in self.types.items() if key not in own)

    def in_columns(self):
        """The same as a row of a table, in which an interval is two numbers."""
        types, absent = {}, {}
        for key, (kind, made) in self.types.items():
            ends = ends_of(key) if kind in ("Floats", "Optional[Floats]") else None
            types.update(dict.fromkeys(ends, (kind.replace("Floats", "float"), None)) if ends else {key: (kind, made)})
            absent.update(dict.fromkeys(ends or (key,), self.absent[key]) if key in self.absent else {})
        return Structure(self.about, types, absent)

    def rows(self, name):
        """The class of a table of such values."""
        columns = {key: "Floats" if kind in ("float", "Optional[float]") else "NDArray[Any]" for key, (kind, _) in self.types.items()}
        keys = ", ".join(union_of(columns, kind) for kind in ("Floats", "NDArray[Any]"))
        text = f'class {name}Table(TableOf[{name}, {keys}]):\n    _row = {name}\n'
        return text + textwrap.fill("; ".join(f"{key}:\0{kind}" for key, kind in columns.items()), 120, **INDENTED).replace(";\n", "\n").replace("\0", " ") + "\n"


class Seen:
    """Types of the values of studies, by what they are in results."""

    def __init__(self, structures, rows):
        self.structures, self.rows = structures, rows

    def structure(self, name, values):
        """Name of the class of these objects: one that has the same values, or else a new one of this name."""
        keys = dict.fromkeys(key for one in values for key in one)
        for known, of in self.structures.items():
            is_named = "name" in keys or "name" not in of.types
            if is_named and len(keys) > 1 and keys.keys() <= of.types.keys() and of.types.keys() - of.absent.keys() <= keys.keys():
                return known
        types = {key: self.type_of(name.removesuffix("Values"), key, [one.get(key) for one in values]) for key in keys}
        absent = {key: None for key, (kind, _) in types.items() if kind == "Any" or kind.startswith("Optional[")}
        self.structures[name] = Structure("", types, absent)
        return name

    def type_of(self, name, key, values):
        """The type of the values of one key as text, and its class."""
        there = [value for value in values if value is not None]
        kinds = {type(value) for value in there}
        inner = [item for value in there if isinstance(value, list) for item in value]
        within = {type(item) for item in inner}
        made = None
        if stated := STATED.get(f"{name}.{key}", STATED.get(key)):
            return stated, None
        if key in OPEN:
            kind = "Any"
        elif kinds == {dict}:
            kind = made = self.structure(name + key.removesuffix("_w").title().replace("_", ""), there)
        elif kinds == {list} and within == {dict}:
            row = self.structure(name + singular(key).title().replace("_", ""), inner)
            self.rows.add(row)
            kind = made = f"{row}Table"
        elif kinds == {list}:
            names = {of.__name__ for of in within}
            kind = LISTS.get(names.pop() if len(names) == 1 else "float" if names == {"int", "float"} else "", "list[Any]")
        else:
            kind = "float" if kinds == {int, float} else kinds.pop().__name__ if len(kinds) == 1 and not kinds & {dict, list} else "Any"
        return f"Optional[{kind}]" if len(there) < len(values) and kind != "Any" else kind, made

def singular(key):
    """The name of one of several."""
    return key.removesuffix("es") if key.endswith("shes") else key.removesuffix("s")


def results_of_examples():
    """Values of the results of studies in their examples, by their classes."""
    found, begin, here = {}, Study.__init__, os.getcwd()

    def noted(self, raw):
        begin(self, raw)
        found.setdefault(type(self), []).append(self)

    Study.__init__ = noted
    try:
        for lines in (*EXAMPLES.values(), *MORE):
            with tempfile.TemporaryDirectory() as place, warnings.catch_warnings():
                warnings.simplefilter("ignore")
                os.chdir(place)
                exec("\n".join(line if isinstance(line, str) else line[0] for line in lines), {"asperity": asperity})
    finally:
        Study.__init__ = begin
        os.chdir(here)
    return {kind: [values_of(one) for one in many] for kind, many in found.items()}


def values_of(study):
    """What a study has under its names, its own tables as their rows; a table whose columns depend on the case is left out."""
    values = dict(study._values)
    for name, of in inspect.getmembers(type(study), lambda member: isinstance(member, property)):
        kind = of.fget.__annotations__["return"]
        if kind == "Table":
            values.pop(name, None)
        elif kind.endswith("Table"):
            values[name] = getattr(study, name)._rows
    return values


def choices_written():
    """The text of the choices."""
    lists = {name: values for name, _, values in _asperity.choices()}
    return "\n\n".join([HEAD_OF_CHOICES, *(literal(name, values) for name, values in lists.items())])


def values_written():
    """The text of the values of results."""
    registry, lists = Registry(), {name: values for name, _, values in _asperity.choices()}
    parameters = asperity.generate(points=2000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=20e-6, short_cut=2e-6, seed=1).parameters()
    seen, own = Seen(*registry.structures()), {}
    for kind, values in results_of_examples().items():
        own[seen.structure(f"{kind.__name__}Values", values)] = kind
    blocks = [HEAD_OF_VALUES, literal("ParameterName", list(parameters))]
    for name, of in seen.structures.items():
        of = of.in_columns() if name in seen.rows else of
        blocks.append(of.written(name, declared(own[name]) if name in own else ()))
        blocks += [of.rows(name)] if name in seen.rows else []
    blocks.append(attributes("ParameterValues", "Roughness parameters.", list(parameters), "float", object))
    blocks.append(attributes("ResultValues", "Values of a result.", lists["ResultName"], "Any", asperity.RunResult))
    blocks.append(attributes("MapArrays", "Arrays of a map.", lists["MapName"], "NDArray[Any]", asperity.Map))
    return "\n\n".join(blocks)


def union_of(columns, kind):
    """The names of the columns of this type."""
    names = ", ".join(json.dumps(key) for key, of in columns.items() if of == kind)
    return f"Literal[{names}]" if names else "NoReturn"


def written():
    """The text of the keys."""
    tables = Tables()
    top, paths = tables.top(), tables.paths()
    blocks = [HEAD, *(table(name, about, rows) for name, (about, rows) in tables.classes.items())]
    # The formulation is a keyword of its own.
    tables_of_case = {key: kind for key, kind in top.items() if key != "formulation"}
    blocks.append(table("CaseTables", "Tables of a case, and its operating point as numbers or text", tables_of_case))
    blocks.append(table("CaseKeys", "Tables of a case and single keys by their paths", {**top, **paths}))
    return "\n\n".join(blocks)


HEAD_OF_STUDIES = '''"""Studies by their settings.

Written by crates/python/typed.py from the settings of the compiled part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import Any, Optional, Union

%s
# As in _study_names.py; type checkers read a list that is written here only.
__all__ = %s
'''
HEAD_OF_NAMES = '''"""Names of the studies.

Written by crates/python/typed.py from the settings of the compiled part.
"""

__all__ = %s
'''
TYPES = {"usize": "int", "u64": "int", "f64": "float", "bool": "bool", "String": "str", "Ratio": "Union[float, str]", "PathBuf": "Union[str, PathLike[str]]"}
INPUTS = {
    "Case": ("CaseLike", None, "as_case({0})._raw"),
    "Option<Case>": ("Optional[CaseLike]", "None", "None if {0} is None else as_case({0})._raw"),
    "Oil": ("OilLike", None, "raw_oil({0})"),
    "CaseOfFinishes": ("CaseLike", None, None),
    "Finishes": ("Mapping[str, Variant]", None, "cases_of(case, {0})"),
    "Option<Finishes>": ("Optional[Mapping[str, Variant]]", "None", "cases_of(case, {0})"),
    "Option<Cases>": ("Optional[Mapping[str, CaseLike]]", "None", "[(key, as_case(one)._raw) for key, one in ({0} or {{}}).items()]"),
    "Rig": ("Columns", None, 'table_of({0}, "rig", Code.E134)'),
    "Map": ("Map", None, "map_of({0})"),
    "Cycle": ("Columns", None, 'table_of({0}, "cycle", Code.E101)'),
    "Option<Vehicle>": ("Optional[Mapping[str, Any]]", "None", "vehicle_keys({0})"),
    "Vec<Trace>": ("Traces", None, "raw_traces({0})"),
    "Vec<Curves>": ("Union[Columns, Sequence[Columns]]", None, 'tables_of_curves({0}, "{0}")'),
}
"""Arguments of what a study is about: type, default and value for the compiled part, none of an argument that another one takes."""
BY_NAME = ("Option<Cases>", "Option<Finishes>", "Option<Vehicle>")
"""Those that are given by name only."""
HOMES = {
    "CaseLike": "_case", "Code": "_errors", "Columns": "_columns", "Finish": "_compare", "Numbers": "_quantity", "OilLike": "_oil", "Progress": "_progress",
    "Quantities": "_quantity", "Quantity": "_quantity", "Study": "_study", "as_case": "_case", "cases_of": "_compare", "map_of": "_map", "nodes": "_quantity", "number": "_quantity",
    "Paths": "_files", "Traces": "_profile", "Variant": "_compare", "paths": "_files", "ran": "_study", "raw_oil": "_oil", "raw_traces": "_profile_change", "table_of": "_columns", "tables_of_curves": "_oil", "vehicle_keys": "_keys", "written": "_quantity",
}
"""Modules of the names that the functions use."""


def unit_of(name):
    """The name of an operating quantity as a number, `temperature_c`, and its unit."""
    return next((own, of.unit) for own, of in OPERATING.items() if own.rsplit("_", 1)[0] == name)


def one(kind, name):
    """Type of a value of a setting, and the value for the compiled part."""
    if kind in QUANTITIES:
        return "Quantity", f'written({name}, "{kind}", "{name}")'
    if kind == "LossTarget":
        return "Quantity", f'{name} if isinstance({name}, str) else written({name}, "Power", "{name}")'
    if kind == "PathBuf":
        return TYPES[kind], f"fspath({name})"
    choices = {rust: python for python, rust, _ in _asperity.choices()}
    return choices.get(kind) or TYPES[kind], name


def argument(setting):
    """Arguments of a setting, each its name, type and default, and its value for the compiled part."""
    name, kind, default = setting["name"], setting["kind"].replace(" ", ""), setting["default"]
    is_axis = kind.removeprefix("Option<").removesuffix(">") == "Nodes"
    if is_axis or kind.startswith("Vec<") and name in BY_TEXT:
        own, unit = unit_of(name)
        rows = [(own, "Optional[Numbers]", "None"), (name, "Optional[Quantities]", "None")]
        value = f'nodes("{own}", {own}, {name}, {json.dumps(default if is_axis else None)})'.replace("null", "None")
        return rows, value if is_axis else f'[f"{{one!r}} {unit}" for one in {value} or ()]'
    if name in OPERATING:
        of = name.rsplit("_", 1)[0]
        return [(name, "Optional[float]", "None"), (of, "Optional[Quantity]", "None")], f'number("{name}", {name}, {of})'
    if kind == "Vec<NamedHours>":
        return [(name, "Optional[Mapping[str, float]]", "None")], f'[f"{{key}}={{value}}" for key, value in ({name} or {{}}).items()]'
    if kind == "Vec<PathBuf>":
        return [(name, "Paths", "()")], f'paths({name}, "{name}")'
    if kind.startswith("Vec<"):
        of, value = one(kind.removeprefix("Vec<").removesuffix(">"), "one")
        value = f"list({name})" if value == "one" else f"[{value} for one in {name}]".replace('"one"', f'"{name}"')
        return [(name, f"Sequence[{of}]", "()")], value
    if kind.startswith("Option<"):
        of, value = one(kind.removeprefix("Option<").removesuffix(">"), name)
        return [(name, f"Optional[{of}]", "None")], value if value == name else f"None if {name} is None else {value}"
    of, value = one(kind, name)
    stated = "False" if kind == "bool" else None if default is None else json.dumps(default, ensure_ascii=False)
    return [(name, of, stated)], value


def described(setting):
    """The lines of a setting in the text of a function."""
    names = ", ".join(name for name, *_ in argument(setting)[0])
    about = setting["about"].removesuffix("; repeat for several")
    about = re.sub(r"e\.g\. ([\w-]+)=(\w+); may be repeated", r'``{"\1": \2}``', about)
    if "Nodes" in setting["kind"]:
        what, usual, more = re.fullmatch(r"(.*?) in .*?(?: \[default: (.*)\](.*))?", about).groups()
        unit = unit_of(setting["name"])[1]
        about = f'{what}, numbers or text as ``"10..100:5 {unit}"`` [default: {usual or setting["default"] + " " + unit}]{more or ""}'
    return wrapped(f"{names}: {about[0].lower()}{about[1:]}.")


def first_sentence(kind):
    """The first sentence of the text of a class, without what it lists."""
    text = " ".join(kind.__doc__.split("\n\n")[0].split())
    return re.split(r"[.:](?: |$)", text)[0] + "."


def example(name):
    """The example of a study as lines of a docstring."""
    lines = []
    for line in EXAMPLES[name]:
        code, printed = line if isinstance(line, tuple) else (line, None)
        lines += [f"{'...' if code.startswith(' ') else '>>>'} {code}"] + ([printed] if printed else [])
    return "".join(f"        {line}\n" for line in lines)


INDENTED = {"initial_indent": "    ", "subsequent_indent": "    "}


def wrapped(text):
    return textwrap.fill(text, 120, initial_indent=" " * 8, subsequent_indent=" " * 12) + "\n"


def imports(text, indent):
    """Imports of the names in a text, on lines with this indent."""
    homes, text = {}, re.sub('"[^"]*"', "", text)
    choices = [python for python, *_ in _asperity.choices()]
    results = {name: getattr(asperity, name).__module__.split(".")[-1] for name in RESULTS.values()}
    for name, home in {**dict.fromkeys(choices, "_choices"), **results, **HOMES}.items():
        if re.search(rf"\b{name}\b", text):
            homes.setdefault(home, []).append(name)
    return "".join(f"{indent}from .{home} import {', '.join(sorted(names))}\n" for home, names in sorted(homes.items()))


def study(found):
    """Signature and body of the function of a study."""
    name, result = found["function"], RESULTS.get(found["function"], "Study")
    given = [(one["name"], *INPUTS[one["kind"]], one["kind"] in BY_NAME) for one in found["input"]]
    rows = [(setting["name"], *argument(setting)) for setting in found["settings"]]
    every = [row for _, arguments, _ in rows for row in arguments]
    threads = [("threads", "Optional[int]", "None")] + ([("progress", "Optional[Progress]", "None")] if found["steps"] else [])
    first = [row[:3] for row in given if not row[4]] + [row for row in every if row[2] is None]
    every = [row[:3] for row in given if row[4]] + every
    lines = [f"    {name}: {kind}{'' if default is None else f' = {default}'},\n" for name, kind, default in first]
    lines += ["    *,\n"] + [f"    {name}: {kind} = {default},\n" for name, kind, default in every + threads if default is not None]
    signature = f"def {name}(\n{''.join(lines)}) -> {result}:\n"
    about = "".join(wrapped(f"{one['name']}: {one['about'][0].lower()}{one['about'][1:]}.") for one in found["input"])
    about += "".join(map(described, found["settings"]))
    values = "".join(f'        "{name}": {value},\n' for name, _, value in rows)
    settings = f"    settings = {{\n{values}    }}\n" if values else ""
    passed = ["settings" if values else "{}", *(name for name, *_ in threads)]
    raws = ", ".join(row[3].format(row[0]) for row in given if row[3])
    alone = sum(row[3] is not None for row in given) == 1
    call = ", ".join([result, f'"{name}"', f"({raws},)" if alone else f"({raws})", *passed])
    body = f"{settings}    return ran({call})\n"
    return signature, f'''    """{found["about"]}.

{textwrap.fill(found["method"], 118, **INDENTED)}

    Parameters:
{about}        {", ".join(name for name, *_ in threads)}: as in `Case.run`.

    Returns:
{wrapped(f"{result}: {first_sentence(getattr(asperity, result))}")}
    Raises:
        AsperityError: an argument that is not valid, or a case that cannot be run, by its code.

    Example:
{example(name)}    """
''', body


def studies():
    """The text of the studies."""
    every = [study(found) for found in json.loads(_asperity.studies())]
    imported = imports("".join(signature + body for signature, _, body in every), "")
    return HEAD_OF_STUDIES % (imported, list_of_studies()) + "\n" + "\n".join(f"\n{''.join(parts)}" for parts in every)


def list_of_studies():
    """The names of the studies as a list."""
    # `from asperity import *` must not replace the built-in function map.
    names = sorted(found["function"] for found in json.loads(_asperity.studies()) if found["function"] != "map")
    return "[\n" + "".join(f'    "{name}",\n' for name in names) + "]"


def names_of_studies():
    """The text of the names of the studies."""
    return HEAD_OF_NAMES % list_of_studies()


FILES = {
    FOLDER / "_choices.py": choices_written, FOLDER / "_values.py": values_written, FOLDER / "keys.py": written,
    FOLDER / "_study_names.py": names_of_studies, FOLDER / "_studies.py": studies,
}
"""Each file with the function that makes its text."""

if __name__ == "__main__":
    for file, text in FILES.items():
        file.write_text(text(), encoding="utf-8")
    sys.exit()
