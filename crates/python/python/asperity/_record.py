"""Results as objects: named attributes, arrays, dictionaries."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._errors import AsperityError, Code, warn
from ._fixed import Fixed, UnknownName, unknown
from ._html import page

if TYPE_CHECKING:
    import pandas
    import xarray


def plain(value: Any) -> Any:
    """The value in Python's own types."""
    if isinstance(value, (Values, Rows)):
        return value.to_dict()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return value


def wrapped(value: Any) -> Any:
    """The value of a JSON text with named attributes: objects as records, their lists as tables, numbers as arrays; lists are copies."""
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list) and value:
        if all(isinstance(item, dict) for item in value):
            return Table(value)
        if all(isinstance(item, (int, float)) and not isinstance(item, bool) for item in value):
            return np.array(value, dtype=np.float64)
    return plain(value) if isinstance(value, list) else value


def held(value: Any) -> Any:
    """The value as a result holds it: an array cannot be written through it."""
    if isinstance(value, np.ndarray):
        value = value.view()
        value.flags.writeable = False
    return value


def same(one: Any, other: Any) -> bool:
    """Whether values in Python's own types are equal; NaN, which stands for a value that there is not, is equal to NaN."""
    return bool(one == other) or _sorted(one) == _sorted(other)


def _sorted(value: Any) -> str:
    return json.dumps(value, sort_keys=True, default=repr)


class Values(Fixed, Mapping[str, Any]):
    """Values by name, as attributes and as items."""

    _kinds: ClassVar[Mapping[str, Callable[[Any], Any]]] = {}
    """Classes of the values that are objects or lists of objects."""
    _absent: ClassVar[Mapping[str, Any]] = {}
    """Values that are left out where they are these."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = {name: held(value) for name, value in values.items()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        # The arrays of a pickle can be written.
        self.__dict__.update(state, _values={name: held(value) for name, value in state["_values"].items()})

    if not TYPE_CHECKING:  # Attributes that a subclass declares are the only ones that it has.

        def __getattr__(self, name: str) -> Any:
            try:
                return self.__dict__["_values"][name] if name == "_values" else self[name]
            except KeyError:
                if name in self._absent:
                    return self._made(name, self._absent[name])
                own = {*dir(type(self))} - {*dir(Mapping)}
                raise AttributeError(unknown(type(self).__name__, name, self.__dict__.get("_values", ()), sorted(own))) from None

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            if isinstance(getattr(type(self), str(name), None), property):
                raise UnknownName(f"{type(self).__name__} has no item {name!r}: it is an attribute, .{name}")
            raise UnknownName(unknown(type(self).__name__, name, self._values))
        return self._made(name, self._values[name])

    def _made(self, name: str, value: Any) -> Any:
        """A value in the class of its name."""
        kind = self._kinds.get(name)
        if kind is not None and value is not None:
            return kind(value)
        # An array of a list is new at each access: what is written into it would be lost.
        return held(wrapped(value)) if isinstance(value, list) else wrapped(value)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._values})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Values):
            return NotImplemented
        return same(self.to_dict(), other.to_dict())

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> dict[str, Any]:
        """The values in Python's own types, as `json.dumps` takes them."""
        return {name: plain(value) for name, value in self._values.items()}

    def __repr__(self) -> str:
        lines = [f"  {name} = {value}" for name, value in _shown(self._values)]
        return "\n".join([type(self).__name__, *lines])

    def _repr_html_(self) -> str:
        return page(type(self).__name__, [*_shown(self._values)], None)


class Record(Values):
    """Values by name, as attributes and as items; the names depend on the result."""

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...


V = TypeVar("V", bound=Values)


def warned(result: V, known: Iterable[Mapping[str, Any]] = ()) -> V:
    """The result, after a warning of each of its ``warnings`` that is not known yet."""
    warn(result._values.get("warnings", ()), known)
    return result


def _shown(values: Mapping[str, Any], within: str = "") -> Iterator[tuple[str, str]]:
    """Values as they are printed, those of short dictionaries by their paths."""
    for name, value in values.items():
        if isinstance(value, dict) and 0 < len(value) <= 8:
            yield from _shown(value, f"{within}{name}.")
        else:
            yield f"{within}{name}", _short(value)


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"array of {' x '.join(map(str, value.shape))}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        is_plain = len(value) <= 4 and not any(isinstance(item, (dict, list)) for item in value)
        return f"[{', '.join(map(_short, value))}]" if is_plain else f"{len(value)} values"
    if isinstance(value, dict):
        return f"{len(value)} entries"
    return str(value)


_UNITS = {
    "_wh_per_100_km": "W h/(100 km)", "_w_per_m": "W/m", "_n_per_mm": "N/mm", "_n_per_m": "N/m", "_m_per_s": "m/s", "_m_s": "m/s", "_km_h": "km/h",
    "_j_per_m": "J/m", "_um_per_mm": "um/mm", "_per_um2": "1/um**2", "_per_k": "1/K", "_um2": "um**2", "_rpm": "1/min", "_mpa": "MPa", "_gpa": "GPa",
    "_pa": "Pa", "_nm": "nm", "_um": "um", "_mm": "mm", "_mg": "mg", "_km": "km", "_m": "m", "_wh": "W h", "_w": "W", "_k": "K", "_c": "degC",
    "_s": "s", "_n": "N", "_percent": "percent", "_deg": "degree", "_hours": "h", "_minutes": "min",
}
"""Units by the ends of names; a longer end stands before an end that it contains."""


def in_names(unit: str) -> str:
    """A unit as it ends names: ``w_per_m_k`` of W/(m K)."""
    known = {of: end[1:] for end, of in _UNITS.items()}
    found = "nm" if unit == "N m" else known.get(unit)
    return found or unit.replace("/", " per ").replace("(", "").replace(")", "").strip().replace("  ", " ").replace(" ", "_").lower()


def described(name: str, unit: str | None = None) -> dict[str, str]:
    """Attributes of a variable of xarray: its unit, by the end of its name, and its name in words."""
    end = next((end for end in _UNITS if f"_{name}".endswith(end)), "")
    unit = unit or ("N m" if end == "_nm" and "torque" in name else _UNITS.get(end, "1"))
    return {"units": unit, "long_name": name.removesuffix(end).replace("_", " ")}


def variable(dimensions: Any, name: str, values: Any, unit: str | None = None) -> tuple[Any, Any, dict[str, str]]:
    """A variable of xarray of a copy of the values, with unit and name if it holds numbers."""
    array = np.array(values)
    return dimensions, array, described(name, unit) if array.dtype.kind in "fi" else {"long_name": name.replace("_", " ")}


def with_ends(value: float, quantiles: Any, unit: str = "W") -> str:
    """A loss with its 5 and 95 % quantiles, if it is drawn."""
    ends = "" if quantiles is None else " ({:.4g}..{:.4g})".format(*quantiles)
    return f"{value:.4g}{ends} {unit}"


_NUMBERS = {"float": np.float64, "Optional[float]": np.float64, "Optional[int]": np.float64, "int": np.int64, "bool": np.bool_}
"""Types of arrays by the types of columns that are declared."""


def is_text(declared: str) -> bool:
    """Whether a column is declared as text."""
    return declared.removeprefix("Optional[").startswith(("str", "Literal["))


def column(values: list[Any], declared: str = "") -> Any:
    """A column of a table as an array: numbers with NaN for what is missing, or objects; of the type that is declared, which does
    not depend on the values."""
    kinds = {type(value) for value in values if value is not None}
    is_whole = None not in values
    if declared in _NUMBERS and (is_whole or declared not in ("int", "bool")):
        return np.array([np.nan if value is None else value for value in values], dtype=_NUMBERS[declared])
    if not declared and kinds and kinds <= {bool} and is_whole:
        return np.array(values, dtype=np.bool_)
    if not declared and kinds and kinds <= {int, float}:
        return np.array([np.nan if value is None else value for value in values], dtype=np.int64 if kinds == {int} and is_whole else np.float64)
    array = np.empty(len(values), dtype=object)
    array[:] = [wrapped(value) if isinstance(value, dict) else plain(value) if isinstance(value, list) else value for value in values]
    return array


def ends_of(name: str) -> Optional[tuple[str, str]]:
    """Columns of the ends of an interval that is a pair of this name in JSON, as the tables of the command name them."""
    if "quantiles" in name:
        return name.replace("quantiles", "p05"), name.replace("quantiles", "p95")
    is_band = name in ("band", "range", "bootstrap") or name.endswith(("_band", "_range"))
    return (f"{name}_low", f"{name}_high") if is_band else None


def in_columns(row: dict[str, Any]) -> dict[str, Any]:
    """A row of a table, in which an interval is two numbers."""
    found: dict[str, Any] = {}
    for name, value in row.items():
        ends = ends_of(name) if value is None or isinstance(value, (list, tuple)) and len(value) in (0, 2) else None
        found.update({name: value} if ends is None else dict(zip(ends, value or (None, None))))
    return found


T = TypeVar("T", bound="Rows")


class Rows(Fixed):
    """Rows with the same names: columns as attributes, rows by their number.

    A column is an array; where a row has no such number, it holds NaN. An interval is two columns.
    """

    _row: ClassVar[type[Values]] = Record
    """Class of a row."""

    _declared: Mapping[str, str] = {"code": "Optional[str]", "text": "str"}
    """Types of columns by their names."""

    def __init__(self, rows: list[dict[str, Any]], names: list[str] | None = None, declared: Optional[Mapping[str, str]] = None) -> None:
        self._rows = [in_columns(row) for row in rows]
        self._names = names if names is not None else list(dict.fromkeys(name for row in self._rows for name in row))
        if declared is not None:
            self._declared = declared
        self._missing = self._row._absent
        if self._row is Record:
            self._rows = [{name: row.get(name) for name in self._names} for row in self._rows]

    @classmethod
    def _of_columns(cls: type[T], columns: Mapping[str, NDArray[Any]]) -> T:
        """The table of columns of one length."""
        lists = [values.tolist() for values in columns.values()]
        return cls([dict(zip(columns, row)) for row in zip(*lists)], list(columns))

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._names)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_") or name not in self._names:
                raise AttributeError(unknown(type(self).__name__, name, self.__dict__.get("_names", ()), dir(type(self))))
            return self[name]

        def __getitem__(self, key: Union[int, str, slice, list[str], Any]) -> Any:
            return self._at(key)

    def _at(self, key: Any) -> Any:
        """A column by its name, a row by its number, or a table by a slice, a mask, or names or numbers in a list."""
        if isinstance(key, str):
            if key not in self._names:
                raise UnknownName(unknown(type(self).__name__, key, self._names))
            return held(self._column(key))
        if isinstance(key, slice):
            return self._part(self._rows[key], self._names)
        if isinstance(key, (list, tuple, np.ndarray)) or hasattr(key, "__array__") and np.ndim(key) == 1:
            return self._several(key)
        return self._row(self._rows[key])

    def _column(self, name: str) -> NDArray[Any]:
        """A column as an array of its own."""
        missing = self._missing.get(name)
        found: NDArray[Any] = column([row.get(name, missing) for row in self._rows], self._declared.get(name, ""))
        return found

    def _part(self, rows: list[dict[str, Any]], names: list[str]) -> Table:
        """A table of some of the rows or columns."""
        return Table([{name: row.get(name, self._missing.get(name)) for name in names} for row in rows], names, self._declared)

    def _several(self, keys: Any) -> Table:
        """The table of the columns or rows in a list, or of the rows where a mask is true."""
        chosen = np.asarray(keys)
        if not chosen.size and isinstance(keys, (list, tuple)):
            return self._part([], self._names)
        if chosen.dtype.kind in "UO" and all(isinstance(key, str) for key in keys):
            names = [str(key) for key in keys]
            if absent := [name for name in names if name not in self._names]:
                raise UnknownName(unknown(type(self).__name__, absent[0], self._names))
            return self._part(self._rows, names)
        if chosen.dtype.kind == "b":
            if chosen.shape != (len(self),):
                text = f"a mask of {chosen.size} values: the table has {len(self)} rows"
                raise AsperityError(text, Code.E209, "Give a mask with one value per row.")
            chosen = np.flatnonzero(chosen)
        if chosen.ndim != 1 or chosen.dtype.kind not in "iu":
            text = f"{keys!r}: names of columns, numbers of rows or a mask are expected"
            raise AsperityError(text, Code.E204, "Give a list of one kind.")
        return self._part([self._rows[number] for number in chosen.tolist()], self._names)

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Any]:
        return map(self._row, self._rows)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Rows):
            return NotImplemented
        return self._names == other._names and same(self._rows, other._rows)

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> list[dict[str, Any]]:
        """The rows in Python's own types."""
        return [{name: plain(value) for name, value in row.items()} for row in self._rows]

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a `pandas.DataFrame`."""
        import pandas

        # The type that this pandas gives to text, where a column without any would have another one.
        text = pandas.Series(["text"]).dtype
        columns = {name: self._column(name) for name in self._names}
        types = {name: values.dtype if values.dtype != object else text if self._has_text(name, values) else object for name, values in columns.items()}
        # Cells that are no numbers in Python's own types, as to_parquet and to_json of a frame take them.
        cells = {name: values if values.dtype != object else plain(list(values)) for name, values in columns.items()}
        return pandas.DataFrame({name: pandas.Series(values, dtype=types[name]) for name, values in cells.items()})

    def _has_text(self, name: str, values: NDArray[Any]) -> bool:
        """Whether a column is text, as it is declared, or as it is."""
        declared = self._declared.get(name)
        return is_text(declared) if declared else any(isinstance(value, str) for value in values)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The table for programs that read Arrow, by pyarrow: ``polars.DataFrame(table)``, ``pyarrow.table(table)``."""
        import pyarrow

        columns = {name: self._at(name) for name in self._names}
        arrays = {name: self._of_arrow(name, values) for name, values in columns.items()}
        return pyarrow.table(arrays).__arrow_c_stream__(requested_schema)

    def _of_arrow(self, name: str, values: NDArray[Any]) -> Any:
        """A column as an array of pyarrow."""
        import pyarrow

        if values.dtype != object:
            return pyarrow.array(values)
        return pyarrow.array(plain(list(values)), pyarrow.string() if self._has_text(name, values) else None)

    def to_xarray(self, dimension: str = "row") -> xarray.Dataset:
        """The columns of numbers as an `xarray.Dataset` along one dimension."""
        import xarray

        columns = {name: self._at(name) for name in self._names}
        return xarray.Dataset({name: variable(dimension, name, values) for name, values in columns.items()})

    def __repr__(self) -> str:
        return f"{type(self).__name__} of {len(self)} rows: {', '.join(self._names)}"

    def _repr_html_(self) -> str:
        from ._html import table

        return table(self._names, [[_short(row.get(name, "")) for name in self._names] for row in self._rows])


class Table(Rows):
    """Rows with the same names: columns as attributes, rows by their number, tables by slices, masks and lists of names.

    A column is an array; where a row has no such number, it holds NaN. An interval is two columns: ``p05_w`` and ``p95_w``
    of what is ``quantiles_w`` in JSON, ``band_low`` and ``band_high`` of ``band``. pyarrow, polars and all else that reads Arrow
    take a table as it is, where pyarrow is installed.
    """

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...
        @overload
        def __getitem__(self, key: str) -> Any: ...
        @overload
        def __getitem__(self, key: int) -> Record: ...
        @overload
        def __getitem__(self, key: Union[slice, Sequence[str], Sequence[int], NDArray[Any]]) -> Table: ...
        def __getitem__(self, key: Any) -> Any: ...
        def __iter__(self) -> Iterator[Record]: ...


R = TypeVar("R", bound=Values)
F = TypeVar("F", bound=str)
O = TypeVar("O", bound=str)


class TableOf(Rows, Generic[R, F, O]):
    """Rows of a class, with columns of numbers and others, whose names are known."""

    def __init__(self, rows: list[dict[str, Any]], names: list[str] | None = None) -> None:
        self._declared = self._row.__annotations__
        super().__init__(rows, names if rows or names else [name for name in self._declared if not name.startswith("_")])

    if TYPE_CHECKING:

        @overload
        def __getitem__(self, key: F) -> NDArray[np.float64]: ...
        @overload
        def __getitem__(self, key: O) -> NDArray[Any]: ...
        @overload
        def __getitem__(self, key: int) -> R: ...
        @overload
        def __getitem__(self, key: Union[slice, list[str], list[int], NDArray[Any]]) -> Table: ...
        def __getitem__(self, key: Any) -> Any: ...
        def __iter__(self) -> Iterator[R]: ...
