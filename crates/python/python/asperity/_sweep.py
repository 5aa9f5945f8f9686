"""Many cases of one study."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, Union

import numpy as np

from . import _asperity
from ._case import Case, CaseLike, Laws, as_case
from ._errors import AsperityError, Code, checked_or_none, json_text, warn, wrong_kind
from ._fixed import Fixed
from ._keys import Schema, Traces, kind_of, written
from ._progress import Progress, Steps
from ._quantity import BY_TEXT, OPERATING, SI_UNITS, as_keys, is_pint, refuse_misspelt, si
from ._record import Record, Table, in_names, is_text, variable
from ._values import SummaryValues

if TYPE_CHECKING:
    import pandas
    import xarray

_AT_ONCE = 16

Source = Union[str, tuple[Case, str, str]]
"""A study file; or a case, the other keys of a study as JSON, and the folder of its files."""


class _Input(NamedTuple):
    """An input of a study in rows and tables: a number whose unit is in its name where its values have one."""

    name: str
    read: Callable[[str], Any]
    declared: str


def _input(key: str, texts: Sequence[str]) -> _Input:
    """The input of a key, whose values are these texts."""
    own = next((own for own, of in OPERATING.items() if of.key == key), None)
    if own is not None:
        return _Input(own, lambda text: OPERATING[own].number(text, key), "float")
    quantity = _schema(key).quantity
    if quantity is None:
        if not texts:
            return _Input(key, _value, "")
        is_number = all(isinstance(_value(text), float) for text in texts)
        return _Input(key, _value, "float") if is_number else _Input(key, _text, "Optional[str]")
    try:
        for text in texts:
            si(text, quantity)
    except AsperityError:
        # A list of quantities, as of both face widths.
        return _Input(key, _text, "Optional[str]")
    return _Input(f"{key}_{in_names(SI_UNITS[quantity])}", lambda text: si(text, quantity), "float")


def _text(cell: str) -> Optional[str]:
    """The text of a cell; `None` of an empty one."""
    return cell or None


def _value(text: str) -> Any:
    """A cell: a number where it is one, none where it is empty."""
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


def _title(code: str) -> str:
    """What a code is about."""
    explained = _asperity.explain(code)
    return explained[0] if explained else ""


class Sweep(Fixed, Iterator[Record]):
    """The cases of a study, run as they are asked for: an iterator of rows.

    A row has ``case`` (its number), ``id``, the inputs, the results, ``outside``, the codes of warnings about inputs
    outside of their ranges, and ``code``, the code of the error of a case that has no result. An input with a unit is a
    number in the unit of its name: ``torque_nm``, ``speed_rpm``, ``temperature_c``, ``gears.module_m``. Every value of an
    axis, and every file that it names, is read before the first case is run. The first case with a warning raises it. Cases that share their contacts
    solve them once. Iterating again runs nothing twice. In another process the rows that were run are there, and
    ``progress`` is not called.
    """

    def __init__(
        self,
        source: Source,
        threads: Optional[int],
        progress: Optional[Progress] = None,
        rows: Optional[list[dict[str, Any]]] = None,
        study: Optional[str] = None,
    ) -> None:
        if isinstance(source, str):
            self._raw = _asperity.Cases.load(source)
        else:
            case, *keys = source
            self._raw = _asperity.Cases.of(case._raw, *keys)
        if study not in (None, self._raw.study):
            text = "the pickled study is another one: a file that it reads, or the version of the program, has changed"
            raise AsperityError(text, Code.E140, "Read the study again.")
        self._raw.check_values()
        self._source = source
        self._threads = checked_or_none("threads", threads, int)
        self._steps = Steps(progress, "cases")
        self._rows = rows or []
        self._given = 0
        self._axes = [(_input(key, texts), texts) for key, texts in self._raw.axes]
        inputs = [one for one, _ in self._axes] + [_input(key, ()) for key in self._raw.sampled]
        self._inputs = dict(zip(self._raw.header[2:], inputs))
        self._header = [self._inputs[name].name if name in self._inputs else name for name in self._raw.header]
        summary = SummaryValues.__annotations__
        of_results = {name: summary.get(name.split(".")[-1], "float") for name in self._raw.header if name not in self._inputs}
        self._declared = {
            **{name: declared if is_text(declared) else "float" for name, declared in of_results.items()},
            **{one.name: one.declared for one in self._inputs.values()},
            **{"case": "int", "id": "str", "outside": "str", "code": "Optional[str]"},
        }

    def __reduce__(self) -> tuple[Any, ...]:
        return Sweep, (self._source, self._threads, None, self._rows, self._raw.study)

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._header)

    def __len__(self) -> int:
        return len(self._raw)

    def __iter__(self) -> Sweep:
        self._given = 0
        return self

    def __next__(self) -> Record:
        if self._given == len(self._raw):
            raise StopIteration
        if self._given == len(self._rows):
            self._advance()
        self._given += 1
        return Record(self._rows[self._given - 1])

    def _advance(self) -> None:
        first = len(self._rows)
        known = {code for row in self._rows for code in row["outside"].split()}
        for cells in self._raw.rows(first, first + _AT_ONCE, self._threads):
            row = dict(zip(self._raw.header, cells))
            texts = {"id": row["id"], "outside": row["outside"], "code": row["code"] or None, "case": int(row["case"])}
            read = {name: self._inputs[name].read if name in self._inputs else _value for name in row}
            values = [texts[name] if name in texts else read[name](cell) for name, cell in row.items()]
            self._rows.append(dict(zip(self._header, values)))
        if self._steps.call is not None:
            self._steps.call(len(self._rows), len(self._raw))
        if len(self._rows) == len(self._raw):
            self._steps.__exit__()
        firsts = {code: row["case"] for row in reversed(self._rows[first:]) for code in row["outside"].split()}
        warn(
            f"{code} {_title(code)}, first in case {case}; the column outside shows which cases have it"
            for code, case in sorted(firsts.items())
            if code not in known
        )

    def run(self) -> Table:
        """All rows as a table."""
        while len(self._rows) < len(self._raw):
            self._advance()
        return Table(self._rows, self._header, self._declared)

    def to_dict(self) -> list[dict[str, Any]]:
        """All rows in Python's own types."""
        return self.run().to_dict()

    def to_pandas(self) -> pandas.DataFrame:
        """All rows as a `pandas.DataFrame` with the numbers of the cases as index."""
        return self.run().to_pandas().set_index("case")

    def to_xarray(self) -> xarray.Dataset:
        """All rows as an `xarray.Dataset` over the axes, and over ``sample`` where the study has a sample."""
        import xarray

        table = self.run()
        nodes = {one.name: [one.read(text) for text in texts] for one, texts in self._axes}
        sampled = [one.name for one in self._inputs.values() if one.name not in nodes]
        sizes = {name: len(values) for name, values in nodes.items()}
        points = len(table) // math.prod(sizes.values())
        if sampled or points > 1:
            sizes["sample"] = points
        shape, dimensions = tuple(sizes.values()), tuple(sizes)
        names = [name for name in self._header if name not in nodes]
        data = {name: variable(dimensions, name, table[name].reshape(shape)) for name in names}
        return xarray.Dataset(data, coords={name: variable(name, name, values) for name, values in nodes.items()})

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """All rows for programs that read Arrow, as those of a `Table`."""
        return self.run().__arrow_c_stream__(requested_schema)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Sweep):
            return NotImplemented
        return self._raw.study == other._raw.study and self._header == other._header and self._laws == other._laws

    def __hash__(self) -> int:
        return hash(self._raw.study)

    @property
    def _laws(self) -> Laws:
        """Laws in Python, of which the compiled part knows the names alone."""
        return {} if isinstance(self._source, str) else self._source[0]._laws

    def __repr__(self) -> str:
        return f"<Sweep: {len(self._rows)} of {len(self)} cases run>"

    def _repr_html_(self) -> str:
        found: str = Table(self._rows, self._header, self._declared)._repr_html_()
        return f"<div><strong>{len(self._rows)} of {len(self)} cases run</strong>{found}</div>"


def sweep(
    case: Union[CaseLike, None] = None,
    axes: Optional[Mapping[str, Any]] = None,
    *,
    sample: Optional[Mapping[str, Any]] = None,
    columns: Optional[Sequence[str]] = None,
    detail: Literal["losses", "contacts"] = "losses",
    study: Optional[Union[str, PathLike[str]]] = None,
    folder: Union[str, PathLike[str]] = ".",
    threads: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Sweep:
    """The cases of a study, an iterator that runs them as it goes.

    Parameters:
        case: the case that all others are made from.
        axes: crossed axes: by key the values, ``{"operation.torque": ["20 N m", "150 N m"]}``, for the operating point
            also by number, ``{"torque_nm": [20, 150]}``; or as text as in `map`, ``"10..100:5 N m"``; or
            ``{"from": .., "to": .., "count": .., "spacing": "log"}``; by any other name choices of several keys,
            ``{"finish": {"ground": {"surface.pinion.file": "g.csv"}}}``. Values and choices stay in the order in which they are given; one that is given twice counts once.
        sample: ``method`` (``"sobol"``, ``"latin-hypercube"``, ``"random"``, ``"list"``), ``count``, ``seed``,
            ``vary`` (by key, or as in axes by the operating point, ``{"uniform": [a, b]}``, ``"normal"``, ``"log-uniform"``, ``"triangular"``), ``indices``.
        columns: results of the summary, of a mesh of a gear train ``mesh.NAME.loss_w``; default efficiency, losses,
            equivalent friction, mixed share. ``loss_p05_w``, ``loss_p95_w`` and ``loss_at_medians_w`` draw the interval;
            ``loss_w`` is then the median of the samples.
        detail: ``"losses"`` or ``"contacts"``.
        study: a study file instead of all these (docs/FILE_FORMATS.md).
        folder: folder that files of the sample are relative to.
        threads, progress: as in `Case.run`.

    Returns:
        A `Sweep`, an iterator of rows.

    Raises:
        AsperityError: a key that no case has (E203), a value that it cannot have (E204), or a file that cannot be read (E101
            to E116, as E103 of a wrong path), before the first case is run.

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> cases = asperity.sweep(case, {"torque": "50..100:3 N m", "lubricant.oil": ["m100", "n100"]})
        >>> [row.torque_nm for row in cases][:3]
        [50.0, 50.0, 75.0]
        >>> table = cases.run()
        >>> table[table["lubricant.oil"] == "m100"].loss_w.shape
        (3,)
    """
    if study is not None:
        return Sweep(os.path.abspath(fspath(study)), threads, progress)
    if case is None:
        raise AsperityError("a sweep needs a case or a study", Code.E205, "Give a case with axes, or a study file.")
    for name, given in (("axes", axes), ("sample", sample)):
        if given is not None and not isinstance(given, Mapping):
            raise wrong_kind(name, given, "keys with their values" if name == "axes" else "the settings of a sample by name")
    base = as_case(case)
    text: dict[str, Any] = {"axis": [_axis(name, values) for name, values in (axes or {}).items()], "detail": detail}
    if columns is not None:
        text["columns"] = list(columns)
    if sample is not None:
        vary = dict(_varied(name, law) for name, law in sample.get("vary", {}).items())
        text["sample"] = {**sample, "vary": vary}
    source = (base, json_text(text), os.path.abspath(fspath(folder)))
    return Sweep(source, threads, progress)


def _schema(key: str) -> Schema:
    schema = Schema(kind_of([key]))
    for part in key.split("."):
        schema = schema.item() if part.isdigit() else schema.at(part)
    return schema


def _stated(value: Any, key: str) -> Any:
    """The value of a key as a study has it, which names files."""
    traces: Traces = []
    stated = written(value, _schema(key), traces, key)
    if traces:
        text = f"{key}: {traces[0][0]} is a profile in memory, and a sweep reads files"
        raise AsperityError(text, Code.E204, "Write the profile to a file and name that, or take compare or map, whose finishes can be profiles.")
    return stated


def _stated_as(name: str, value: Any) -> Any:
    """The value of a key, or of the operating point by a name of it, as a study has it."""
    own = name in OPERATING or name in BY_TEXT
    return _stated(as_keys({name: value})[_key(name)] if own else value, _key(name))


def _key(name: str) -> str:
    """The key that a name means."""
    own = OPERATING.get(BY_TEXT.get(name, name))
    return own.key if own else name


def _varied(name: str, law: Any) -> tuple[str, dict[str, Any]]:
    """Key and distribution of a sampled value."""
    if not isinstance(law, Mapping) or not all(isinstance(values, (list, tuple, np.ndarray)) for values in law.values()):
        raise wrong_kind(f"sample['vary'][{name!r}]", law, 'a distribution as {"uniform": [a, b]}')
    refuse_misspelt(_key(name))
    return _key(name), {of: [_stated_as(name, value) for value in values] for of, values in law.items()}


def _axis(name: str, values: Any) -> dict[str, Any]:
    if isinstance(values, str) and ".." in values and name not in OPERATING:
        return {"key": _key(name), "values": values}
    if is_pint(values) and np.ndim(values.magnitude) == 1:
        values = list(values)
    if not isinstance(values, (str, Mapping, Sequence)) and not is_pint(values) and hasattr(values, "__array__"):
        values = np.asarray(values)
    if not isinstance(values, (Mapping, Sequence, np.ndarray)) or isinstance(values, str):
        raise wrong_kind(f"axes[{name!r}]", values, "a list of values, a range or choices")
    if name in OPERATING or name in BY_TEXT:
        key = _key(name)
        every = values if not isinstance(values, Mapping) else [values["from"], values["to"]]
        texts = [_stated_as(name, value) for value in every]
        if isinstance(values, Mapping):
            return {"key": key, **values, "from": texts[0], "to": texts[1]}
        return {"key": key, "values": texts}
    if not isinstance(values, Mapping) or "from" in values:
        refuse_misspelt(name)
    if not isinstance(values, Mapping):
        return {"key": name, "values": [_stated(value, name) for value in values]}
    if "from" in values and "to" in values:
        ends = {end: _stated(values[end], name) for end in ("from", "to")}
        return {"key": name, **values, **ends}
    choice = {of: {key: _stated(value, key) for key, value in keys.items()} for of, keys in values.items()}
    return {"name": name, "choice": choice}
