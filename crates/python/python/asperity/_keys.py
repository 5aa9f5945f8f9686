"""Keys of a case: quantities of pint become text with the unit of the schema, profiles get a name."""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike, fspath
from typing import Any, Optional

import numpy as np

from . import _asperity
from ._errors import not_finite, wrong_kind
from ._profile import Profile
from ._quantity import SI_UNITS, is_pint, si

Traces = list[tuple[str, _asperity.Trace]]


@functools.cache
def _schema(kind: str) -> dict[str, Any]:
    schema: dict[str, Any] = json.loads(_asperity.schema(kind))
    return schema


class Schema:
    """A node of the schema of a case file."""

    def __init__(self, kind: str = "gears", nodes: Optional[list[dict[str, Any]]] = None) -> None:
        self._root = _schema(kind)
        self._kind = kind
        self._nodes = list(self._through([self._root] if nodes is None else nodes))

    def _through(self, nodes: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
        """The nodes with all that they refer to."""
        for node in nodes:
            yield node
            if "$ref" in node:
                name = node["$ref"].rsplit("/", 1)[-1]
                yield from self._through([{"quantity": name} if name in SI_UNITS else self._root["$defs"][name]])
            for kind in ("anyOf", "oneOf", "allOf"):
                yield from self._through(node.get(kind, []))

    def at(self, key: str) -> Schema:
        """The node of a key below."""
        found = [node["properties"][key] for node in self._nodes if key in node.get("properties", {})]
        # The meshes of a gear train have names of the user's choice.
        named = (node.get("additionalProperties") for node in self._nodes)
        return Schema(self._kind, found or [node for node in named if isinstance(node, dict)])

    def has(self, key: str) -> bool:
        """Whether a key of this name is below."""
        return any(key in node.get("properties", {}) for node in self._nodes)

    def item(self) -> Schema:
        """The node of the items of a list."""
        found: list[dict[str, Any]] = []
        for node in self._nodes:
            items = node.get("items")
            if isinstance(items, dict):
                found.append(items)
            found.extend(node.get("prefixItems", []))
        return Schema(self._kind, found)

    @property
    def quantity(self) -> Optional[str]:
        """The quantity that stands here."""
        return next((node["quantity"] for node in self._nodes if "quantity" in node), None)

    @property
    def is_table(self) -> bool:
        """Whether a table of single keys stands here: not one of several alternatives, nor one that needs all its keys."""
        tables = [node for node in self._nodes if "properties" in node]
        optional = any(set(node["properties"]) > set(node.get("required", ())) for node in tables)
        return optional and not any("oneOf" in node for node in self._nodes)


def kind_of(keys: Iterable[str]) -> str:
    """The table of the gears among the keys of a case, ``gears`` unless there is another."""
    tables = {key.split(".")[0] for key in keys}
    return next((kind for kind in ("planetary", "mesh") if kind in tables), "gears")


def named(profile: Profile) -> str:
    """A name of a profile that no other heights have, nor the same ones with other statements of their file."""
    # At its first need: it takes longer to import than the package.
    import hashlib

    content = profile.heights.tobytes() + np.float64(profile.spacing).tobytes() + profile._raw.statements_json.encode()
    digest = hashlib.sha256(content).hexdigest()[:12]
    return f"{profile.name or 'heights'} ({digest})"


def may_name_a_profile(text: str) -> bool:
    """Whether a text may have a name of `named`."""
    import re

    return re.search(r" \([0-9a-f]{12}\)", text) is not None


def written(value: Any, schema: Schema, traces: Traces, name: str = "case") -> Any:
    """The value of a key called `name` as JSON has it in a case file."""
    if isinstance(value, (float, np.floating)) and not np.isfinite(value):
        raise not_finite(name, float(value))
    is_array = hasattr(value, "__array__") and not isinstance(value, (Profile, np.generic)) and not is_pint(value)
    if is_array or isinstance(value, (list, tuple)):
        if schema.is_table and schema.has("file"):
            raise wrong_kind(name, value, "a profile, the path of one, or a table")
        if name.endswith(".file"):
            raise wrong_kind(name, value, "a profile or the path of one")
        if is_array and np.ndim(value) < 2:
            # An array, or a column of a frame.
            value = np.asarray(value).tolist()
    if isinstance(value, Profile):
        name = named(value)
        traces.append((name, value._raw))
        return {"file": name}
    if isinstance(value, Mapping):
        kept = {key: item for key, item in value.items() if item is not None}
        if isinstance(kept.get("file"), Profile):
            kept.update(written(kept["file"], schema, traces))
        above = "" if name == "case" else f"{name}."
        return {key: written(item, schema.at(key), traces, f"{above}{key}") for key, item in kept.items()}
    if is_pint(value):
        quantity = schema.quantity or schema.item().quantity
        if quantity is not None:
            magnitude = np.asarray(value.magnitude)
            parts = [value] if magnitude.ndim == 0 else list(value)
            texts = [_text(part, quantity) for part in parts]
            return texts[0] if magnitude.ndim == 0 else texts
        value = value.to("").magnitude
    if isinstance(value, (list, tuple, np.ndarray)):
        below = schema.item()
        return [written(item, below, traces, name) for item in value]
    if isinstance(value, PathLike):
        return fspath(value)
    value = value.item() if isinstance(value, np.generic) else value
    if value is not None and not isinstance(value, (str, int, float)):
        raise wrong_kind(name, value, "a number, a text, a list or a table")
    return value


def _text(value: Any, quantity: str) -> str:
    """A quantity of pint as text: in its unit where a case file has that, else in SI units."""
    found = si(value, quantity)
    try:
        text = f"{float(value.magnitude)!r} {value.units:~}"
        is_same = math.isclose(_asperity.to_si(quantity, text, ""), found, rel_tol=1e-12)
    except (AttributeError, TypeError, ValueError):
        text, is_same = "", False
    return text.replace(".0 ", " ") if is_same else f"{repr(found).removesuffix('.0')} {SI_UNITS[quantity]}"


def is_toml(value: Any) -> bool:
    """Whether the value is the text of a table or list."""
    return isinstance(value, str) and value.lstrip().startswith(("{", "["))


def as_toml(value: Any) -> str:
    """A JSON value in the form of a case file; text stands as it is."""
    return value if isinstance(value, str) else _inline(value)


def _inline(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(key)} = {_inline(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def vehicle_keys(vehicle: Optional[Mapping[str, Any]]) -> list[tuple[str, Optional[str]]]:
    """Keys of a vehicle instead of those of a case."""
    return changes({"vehicle": dict(vehicle)} if vehicle else {}, "gears", [])


def changes(
    given: Mapping[str, Any], kind: str, traces: Traces
) -> list[tuple[str, Optional[str]]]:
    """Keys by their paths with the text of their values, none where a key is taken away."""
    found: list[tuple[str, Optional[str]]] = []

    def add(path: str, value: Any, schema: Schema) -> None:
        if value is None:
            found.append((path, None))
        elif isinstance(value, Profile) and path.endswith(".file"):
            found.append((path, written(value, schema, traces)["file"]))
        elif isinstance(value, (Profile, str, PathLike)) and schema.is_table and schema.has("file") and not is_toml(value):
            # A trace by itself is a flank without other keys.
            found.append((path, as_toml(written({"file": value}, schema, traces))))
        elif isinstance(value, Mapping) and schema.is_table:
            for key, item in value.items():
                add(f"{path}.{key}", item, schema.at(key))
        else:
            found.append((path, as_toml(written(value, schema, traces, path))))

    for path, value in given.items():
        schema = Schema(kind)
        for part in path.split("."):
            schema = schema.at(part)
        add(path, value, schema)
    return found
