"""Writes what follows from the lists of the compiled part: python/asperity/keys.py, the types of case keys, choices and columns, and
python/asperity/_studies.py, the studies of one case with their settings.

    python crates/python/typed.py          # after building the module
"""

import json
import keyword
import sys
import textwrap
from pathlib import Path

import asperity
from asperity import _asperity

FOLDER = Path(__file__).parent / "python" / "asperity"
RESULTS = {"callout": "CallOut", "ridges": "Ridges", "sensitivity": "Sensitivity"}
"""Classes of the results of studies that have attributes of their own, each in the module of its study."""
KINDS = ("gears", "mesh")
QUANTITIES = {name for name, _ in _asperity.si_units()}
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}
HEAD = '''"""Keys of a case, choices of arguments and columns of results, for type checkers and completion.

Written by crates/python/typed.py; nothing of the package imports it at run time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, Optional, TypedDict, Union

from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._profile import Profile
    from ._quantity import PintLike

Quantity = Union[str, "PintLike"]
"""Text with a unit (``"1.8 mm"``) or a quantity of pint."""
'''
OWN = {"torque_nm": "torque at the pinion, N m", "speed_rpm": "speed of the pinion, 1/min",
       "temperature_c": "bulk temperature of the flanks, °C"}
"""Keys of the operating point as numbers, with their meaning."""


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
        return {**{key: f"Optional[{union(parts)}]" for key, parts in found.items()}, **dict.fromkeys(OWN, "float")}

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


def attributes(name, about, names, kind, result=None):
    """Attributes of a result that the class `result` does not declare itself."""
    own = set() if result is None else {key for one in result.__mro__ for key in vars(one)}
    body = "".join(f"    {key}: {kind}\n" for key in names if key not in own)
    return f'class {name}:\n    """{about}"""\n\n{body}'


def written():
    """The text of the file."""
    tables = Tables()
    top, paths = tables.top(), tables.paths()
    choices = dict(_asperity.choices())
    blocks = [HEAD]
    blocks += [literal(name, values) for name, values in choices.items()]
    blocks += [
        attributes("ResultValues", "Values of a result.", choices["ResultName"], "Any", asperity.RunResult),
        attributes("SummaryValues", "Numbers of a summary.", choices["SummaryName"], "Any", asperity.Summary),
        attributes("PathArrays", "Columns along the path of contact.", choices["PathColumn"], "NDArray[Any]", asperity.Path),
        attributes("MapArrays", "Arrays of a map.", choices["MapName"], "NDArray[Any]", asperity.Map),
    ]
    blocks += [table(name, about, rows) for name, (about, rows) in tables.classes.items()]
    # The formulation is a keyword of its own.
    tables_of_case = {key: kind for key, kind in top.items() if key != "formulation"}
    blocks.append(table("CaseTables", "Tables of a case, and its operating point as numbers", tables_of_case))
    blocks.append(table("CaseKeys", "Tables of a case and single keys by their paths", {**top, **paths}))
    return "\n\n".join(blocks)


HEAD_OF_STUDIES = '''"""Studies of one case.

Written by crates/python/typed.py from the settings of the compiled part.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Union

if TYPE_CHECKING:
%s
__all__ = %s
'''
TYPES = {"usize": "int", "u64": "int", "f64": "float", "bool": "bool", "String": "str", "Ratio": "Union[float, str]"}


def argument(setting):
    """Type, default and value of a setting as texts."""
    name, kind = setting["name"], setting["kind"].replace(" ", "")
    optional = kind.startswith("Option<")
    kind = kind.removeprefix("Option<").removesuffix(">") if optional else kind
    value = f'written(settled, "{kind}", "{name}")'.replace("settled", name) if kind in QUANTITIES else name
    value = f"None if {name} is None else {value}" if optional and value != name else value
    kind = TYPES.get(kind, "Quantity" if kind in QUANTITIES else kind)
    default = "None" if optional else repr(setting["default"]).replace("'", '"')
    is_stated = setting["default"] is None and not optional
    return (f"Optional[{kind}]" if optional else kind), (None if is_stated else default), value


def study(found):
    """The function of a study."""
    name, result = found["name"], RESULTS.get(found["name"], "Study")
    rows = [(setting, *argument(setting)) for setting in found["settings"]]
    stated = [f"    {setting['name']}: {kind},\n" for setting, kind, default, _ in rows if default is None]
    others = [f"    {setting['name']}: {kind} = {default},\n" for setting, kind, default, _ in rows if default is not None]
    about = "".join(
        f"        {setting['name']}: {setting['about'][0].lower()}{setting['about'][1:].split(' [default')[0]}"
        f"{' [default' + setting['about'].split(' [default')[1] if ' [default' in setting['about'] else ''}.\n" for setting, *_ in rows
    )
    values = "".join(f'        "{setting["name"]}": {value},\n' for setting, _, _, value in rows)
    settings = f"    settings = {{\n{values}    }}\n" if values else ""
    quantity = "    from ._quantity import written\n" if "written(" in values else ""
    home = f"_{name}" if name in RESULTS else "_study"
    names = ["Study", "of_case"] if result == "Study" else ["of_case"]
    imports = ([] if result == "Study" else [f"    from .{home} import {result}\n"]) + [quantity, f"    from ._study import {', '.join(names)}\n"]
    return f'''
def {name}(
    case: CaseLike,
{"".join(stated)}    *,
{"".join(others)}    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> {result}:
    """{found["about"]}.

{textwrap.fill(found["method"], 118, initial_indent="    ", subsequent_indent="    ")}

    Args:
        case: the case.
{about}        threads, progress: as in `Case.run`.
    """
{"".join(imports)}
{settings}    return {result}(of_case("{name}", case, {"settings" if values else "{}"}, threads, progress, "{found["steps"]}"))
'''


def studies():
    """The text of the studies."""
    every = json.loads(_asperity.studies())
    functions = "\n".join(study(found) for found in every)
    choices = [name for name, _ in _asperity.choices() if f"{name}]" in functions or f": {name} " in functions]
    results = {f"_{name}": RESULTS[name] for name in RESULTS}
    homes = {"_case": "CaseLike", "_progress": "Progress", "_quantity": "Quantity", "_study": "Study", "keys": ", ".join(choices), **results}
    imports = "".join(f"    from .{home} import {names}\n" for home, names in sorted(homes.items()) if any(name in functions for name in names.split(", ")) and names)
    names = "[\n" + "".join(f'    "{name}",\n' for name in sorted(found["name"] for found in every)) + "]"
    return HEAD_OF_STUDIES % (imports, names) + "\n" + functions


FILES = {FOLDER / "keys.py": written, FOLDER / "_studies.py": studies}
"""Each file with the function that makes its text."""

if __name__ == "__main__":
    for file, text in FILES.items():
        file.write_text(text(), encoding="utf-8")
    sys.exit()
