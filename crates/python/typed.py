"""Writes python/asperity/keys.py: the types of case keys, choices and columns, from the lists of the compiled part.

    python crates/python/typed.py          # after building the module
"""

import json
import keyword
import sys
from pathlib import Path

import asperity
from asperity import _asperity

FILE = Path(__file__).parent / "python" / "asperity" / "keys.py"
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


class Tables:
    """Types of the tables of a case."""

    def __init__(self):
        self.schemas = {kind: json.loads(_asperity.schema(kind)) for kind in KINDS}
        self.defs = {name: node for schema in self.schemas.values() for name, node in schema["$defs"].items()}
        self.classes = {}

    def type_of(self, node, key=""):
        """The type of a node of the schema as text, without None."""
        found = self._parts(node, key)
        literals = [text for part in found if part.startswith("Literal[") for text in part[8:-1].split(", ")]
        others = [part for part in dict.fromkeys(found) if part != "None" and not part.startswith("Literal[")]
        parts = ([f"Literal[{', '.join(dict.fromkeys(literals))}]"] if literals else []) + others
        return parts[0] if len(parts) == 1 else f"Union[{', '.join(parts)}]"

    def _parts(self, node, key):
        if node is True:
            return ["object"]
        if "$ref" in node:
            name = node["$ref"].rsplit("/", 1)[-1]
            if name in QUANTITIES:
                return ["Quantity"]
            parts = self._parts({**self.defs[name], "named": name}, key)
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
        name = node.get("named") or "".join(part.title() for part in key.split("_"))
        if name not in self.classes:
            self.classes[name] = None
            rows = {key: f"Optional[{self.type_of(item, key)}]" for key, item in node["properties"].items()}
            self.classes[name] = (node.get("description", ""), rows)
        return name

    def top(self):
        """Types of the tables of all kinds of cases."""
        found = {}
        for schema in self.schemas.values():
            for key, node in schema["properties"].items():
                kind = self.type_of(node, key)
                found.setdefault(key, [])
                if kind not in found[key]:
                    found[key].append(kind)
        joined = {key: kinds[0] if len(kinds) == 1 else f"Union[{', '.join(kinds)}]" for key, kinds in found.items()}
        return {**{key: f"Optional[{kind}]" for key, kind in joined.items()}, **dict.fromkeys(OWN, "float")}

    def paths(self):
        """Types of single keys by their paths."""
        found = {}

        def nodes(node):
            yield node
            if "$ref" in node and node["$ref"].rsplit("/", 1)[-1] not in QUANTITIES:
                yield from nodes(self.defs[node["$ref"].rsplit("/", 1)[-1]])
            for kind in ("anyOf", "oneOf"):
                for item in node.get(kind, []):
                    yield from nodes(item)

        def add(path, node, key, above):
            found.setdefault(path, f"Optional[{self.type_of(node, key)}]")
            for one in nodes(node):
                named = one.get("$ref")
                for number, item in enumerate(one.get("prefixItems", [one["items"]] * one["maxItems"] if isinstance(one.get("items"), dict) and "maxItems" in one else [])):
                    add(f"{path}.{number}", item, key, above)
                for below, item in one.get("properties", {}).items():
                    if named not in above or named is None:
                        add(f"{path}.{below}", item, below, above | {named} - {None})

        for kind in KINDS:
            for key, node in self.schemas[kind]["properties"].items():
                add(key, node, key, frozenset())
        return found


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


if __name__ == "__main__":
    FILE.write_text(written(), encoding="utf-8")
    sys.exit()
