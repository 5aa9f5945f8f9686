"""Cases: what is to be computed."""

from __future__ import annotations

import functools
import json
import os
from collections.abc import Mapping
from os import PathLike, fspath
from typing import IO, TYPE_CHECKING, Any, Optional, Union, cast

from . import _asperity
from ._contact import Contact
from ._errors import AsperityError, warn
from ._files import is_read, text_of
from ._html import page
from ._keys import Schema, Traces, changes, kind_of, written
from ._own_laws import Called, Law, exponent_of, name_of
from ._progress import Progress, Told
from ._quantity import OPERATING, as_keys
from ._record import Record, Table, warned
from ._result import Regime, RunResult

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .keys import CaseKeys, CaseTables, Detail, Formulation

Steps = tuple[tuple[str, tuple[Any, ...]], ...]
"""What a case was made by: methods of the compiled part with their arguments."""

CaseLike = Union["Case", str, PathLike[str], Mapping[str, Any]]
"""A case, the file of one, or the tables of one."""


class Case:
    """A gear pair, gear train or planetary set with its load, oil and flanks, checked.

    The keys are those of a case file (docs/CASE_FILE.md). A quantity is text with a unit or a quantity of pint; the
    operating point can be given by the numbers ``torque_nm``, ``speed_rpm`` and ``temperature_c`` (of the flanks). A
    flank, or its ``file``, can be a `Profile`. Files are relative to ``folder``, by default the working directory or
    the folder of the case file.

    >>> case = Case("case.toml")                                    # doctest: +SKIP
    >>> case = Case(gears={"teeth": [23, 68], "module": "1.8 mm", "face_width": "32 mm"},
    ...             torque_nm=145, speed_rpm=9000, temperature_c=90,
    ...             lubricant={"oil": "m100"}, surface={"pinion": {"rq": "0.4 um"}})

    Args:
        case: file, object that is read like one, or tables; tables as keywords win over them.
        formulation: ``"corrected"`` or ``"paper"``, over that of the case.
        folder: folder that files are relative to.
    """

    _raw: _asperity.Case
    _steps: Steps

    def __init__(
        self,
        case: Union[str, PathLike[str], IO[str], IO[bytes], Mapping[str, Any], None] = None,
        /,
        *,
        formulation: Optional[Formulation] = None,
        folder: Optional[Union[str, PathLike[str]]] = None,
        **tables: Unpack[CaseTables],
    ) -> None:
        if isinstance(case, (str, PathLike)):
            self._take(Case.load(case, tables, formulation=formulation)._steps)
        elif is_read(case):
            step: tuple[str, tuple[Any, ...]] = ("from_text", ("case.toml", text_of(case), os.path.abspath(fspath(folder or ".")), [], formulation))
            whole = Case._of((step,))
            self._take((whole._with(tables) if tables else whole)._steps)
        else:
            given = tables_of({**(cast("Mapping[str, Any]", case) or {}), **tables})
            traces: Traces = []
            values = written(given, Schema(kind_of(given)), traces)
            text = json.dumps(values, ensure_ascii=False, indent=1)
            self._take((("from_text", ("case.json", text, os.path.abspath(fspath(folder or ".")), traces, formulation)),))

    def _take(self, steps: Steps, before: Optional[_asperity.Case] = None) -> None:
        """Makes the case by steps, the last of them from the case before it where that is at hand."""
        raw: Any = _asperity.Case if before is None else before
        for method, arguments in steps if before is None else steps[-1:]:
            raw = getattr(raw, method)(*arguments)
        self._raw = raw
        self._steps = steps
        warn(json.loads(self._raw.warnings), () if before is None else json.loads(before.warnings))

    @functools.cached_property
    def _about(self) -> dict[str, Any]:
        about: dict[str, Any] = json.loads(self._raw.about)
        return about

    @classmethod
    def _of(cls, steps: Steps, before: Optional[_asperity.Case] = None) -> Case:
        made = cls.__new__(cls)
        made._take(steps, before)
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        (method, arguments), *others = self._steps
        if method == "load":
            arguments = (os.path.abspath(arguments[0]), *arguments[1:])
        return Case._of, (((method, arguments), *others),)

    @classmethod
    def load(
        cls,
        path: Union[str, PathLike[str]],
        keys: Optional[Mapping[str, Any]] = None,
        *,
        formulation: Optional[Formulation] = None,
    ) -> Case:
        """The case in a TOML or JSON file, with ``keys`` set past its text: ``{"operation.torque": "20 N m"}``."""
        if not keys:
            return cls._of((("load", (fspath(path), [], formulation)),))
        traces: Traces = []
        keys = as_keys(keys)
        found = changes(keys, kind_of(keys), traces)
        set_keys = [(key, value) for key, value in found if value is not None]
        if traces or len(set_keys) < len(found):
            return cls.load(path, formulation=formulation)._with(keys)
        return cls._of((("load", (fspath(path), set_keys, formulation)),))

    def replace(
        self,
        changed: Optional[CaseKeys] = None,
        /,
        *,
        formulation: Optional[Formulation] = None,
        **more: Unpack[CaseTables],
    ) -> Case:
        """The same case with other values, rechecked; traces are read again only where they change.

        Keys are given by their paths, ``case.replace({"operation.torque": "20 N m"})``, by tables,
        ``case.replace(operation={"torque": "20 N m"})``, whose other keys stay, or by the numbers of the operating point,
        ``case.replace(torque_nm=20)``. None takes a key away, so that its default holds again. A flank takes a `Profile`.
        """
        other = {} if formulation is None else {"formulation": formulation}
        return self._with({**(changed or {}), **other, **more})

    def _with(self, keys: Mapping[str, Any]) -> Case:
        """The case with other keys, whose names need not be known before the program runs."""
        traces: Traces = []
        found = changes(as_keys(keys), self._raw.gears_table, traces)
        return self._then("replace", found, traces)

    def with_laws(
        self,
        *,
        film_friction: Optional[Law] = None,
        film_thickness: Optional[Law] = None,
        load_share: Optional[Law] = None,
        load_distribution: Optional[Law] = None,
    ) -> Case:
        """The case with laws written in Python in place of its own.

        A law is a function of one argument or an object with ``__call__``: a `Record` of arrays in SI units, over the
        offsets of the traces at a mesh position. It returns an array or a number, or a dictionary of them. Results name
        a law by its ``name``, or by the name of its function or class. It is called from several threads, one at a time.

        Args:
            film_friction: the friction coefficient of the film. Conditions: load, radius, entrainment, sliding,
                max_pressure, viscosity, contact_viscosity, kinematic_viscosity, pressure_viscosity, central_film,
                minimum_film, combined_roughness, mean_ra, sum_rz, boundary_coefficient, modulus, half_width,
                bulk_temperature.
            film_thickness: the smooth isothermal film, ``central`` and ``minimum`` (or one for both), of entrainment,
                radius, load, modulus, viscosity, pressure_viscosity; with an attribute ``speed_exponent``.
            load_share: ``film_share``, and if the asperities are lubricated ``boundary_part`` (default 1) and
                ``lubricated_coefficient``. Conditions: those of film friction, lambda_star (NaN if unknown), film_ratio,
                reduced_peak, flow_pressure.
            load_distribution: the load per length of contact line, N/m, of ``s`` (place on the line of action, m),
                path_fraction (0 at A, 1 at E), torque, ``uniform`` (the load if all lines of contact share equally).

        An exception of a law ends the run and is raised with its traceback.
        """
        made = self
        for kind, law in (
            ("film-friction", film_friction),
            ("film-thickness", film_thickness),
            ("load-share", load_share),
            ("load-distribution", load_distribution),
        ):
            if law is not None:
                made = made._then("with_law", kind, name_of(law), exponent_of(kind, law), Called(kind, law))
        return made

    def _then(self, method: str, *arguments: Any) -> Case:
        """The case after one more step; changes of keys in a row are one step of the case in another process."""
        steps = (*self._steps, (method, arguments))
        made = Case._of(steps, self._raw)
        if method == "replace" and self._steps[-1][0] == "replace":
            keys, traces = self._steps[-1][1]
            changed = {key for key, _ in arguments[0]}
            joined = [*((key, value) for key, value in keys if key not in changed), *arguments[0]]
            made._steps = (*self._steps[:-1], ("replace", (joined, [*traces, *arguments[1]])))
        return made

    def _on_finish(self, finish: Any, offsets: Optional[int]) -> Case:
        """The case on the traces of a finish: one for both flanks, or those of pinion and wheel."""
        traces: Traces = []
        pair = finish if isinstance(finish, (tuple, list)) else (finish,)
        if not 1 <= len(pair) <= 2:
            raise AsperityError("a finish has one trace or two", "E205", "Give a profile, or those of pinion and wheel.")

        def name(trace: Any) -> str:
            if isinstance(trace, (str, PathLike)):
                return os.path.abspath(fspath(trace))
            named: str = written(trace, Schema(), traces)["file"]
            return named

        names = [name(trace) for trace in pair]
        wheel = names[1] if len(names) == 2 else None
        return self._then("on_finish", names[0], wheel, traces, offsets)

    @property
    def title(self) -> str:
        """Title of the case."""
        return str(self._about["title"])

    @property
    def inputs(self) -> Record:
        """The case as given, quantities as text."""
        return Record(self._about["inputs"])

    @property
    def defaults(self) -> Table:
        """Every default that a run uses: key, value, source."""
        return Table(self._about["defaults"])

    @property
    def warnings(self) -> Table:
        """Warnings about the files: code and text."""
        return Table(self._about["warnings"], ["code", "text"])

    @property
    def meshes(self) -> list[str]:
        """Names of the meshes of a gear train or planetary set; empty for a pair of gears."""
        return self._raw.meshes

    def mesh(self, name: str) -> Case:
        """The mesh of a gear train or planetary set as a case of its own, at its torque and speed."""
        return self._then("mesh", name)

    @property
    def is_planetary(self) -> bool:
        """Whether the case is a planetary set."""
        return self._raw.gears_table == "planetary"

    def run(
        self,
        detail: Detail = "fields",
        *,
        band: bool = True,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> RunResult:
        """Computes losses, and with more detail contacts and fields; the losses are the same to the last digit.

        Args:
            detail: ``"losses"`` (a fraction of the time), ``"contacts"`` (the rough contacts at every offset), or
                ``"fields"`` (as the command: fields and stress below the surface, too).
            band: whether the uncertainty of the loss is computed with ``"fields"``.
            threads: number of threads; default, and -1, all cores.
            progress: ``f(done, total)``, ``tqdm``, or a bar of it.

        Ctrl-C ends the run.
        """
        with Told(progress, self.title) as told:
            found = RunResult._of(self._raw.run(detail, band, threads, told))
        return warned(found, self._about["warnings"])

    def regime(self, *, threads: Optional[int] = None) -> Regime:
        """Film thickness, Λ* and regime along the path of contact; of several meshes, the first."""
        meshes = json.loads(self._raw.regime(threads))
        return Regime(meshes)

    def contact(self, position: Optional[float] = None) -> Contact:
        """The flanks pressed dry against each other at a place of the path, 0 at A and 1 at E."""
        return warned(Contact(*self._raw.contact(position)))

    def film(self, position: Optional[float] = None) -> Record:
        """Pressure difference across films from 1 nm to 1 mm at a place of the path; default the pitch point."""
        return Record(json.loads(self._raw.film(position)))

    def gear(self) -> Record:
        """Geometry, contact ratios, stiffness, transmission error, loss factors of every load distribution."""
        return Record(json.loads(self._raw.gear()))

    def to_dict(self) -> dict[str, Any]:
        """The case as given; ``Case(case.to_dict())`` is the same case where its traces are files."""
        inputs: dict[str, Any] = json.loads(json.dumps(self._about["inputs"]))
        return inputs

    def to_toml(self) -> str:
        """The case as the text of a case file."""
        return self._raw.to_toml()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self.to_dict() == other.to_dict() and self._laws() == other._laws()

    __hash__ = None  # type: ignore[assignment]

    def _laws(self) -> dict[str, Any]:
        """Laws in Python by what they replace."""
        return {arguments[0]: arguments[3] for method, arguments in self._steps if method == "with_law"}

    def __repr__(self) -> str:
        return f"<Case {self.title!r}>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, str]] = []

        def add(path: str, value: Any) -> None:
            if isinstance(value, dict):
                for key, item in value.items():
                    add(f"{path}.{key}" if path else key, item)
            elif value is not None and path != "title":
                rows.append((path, str(value)))

        add("", self._about["inputs"])
        return page(self.title, rows, None)


def tables_of(given: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of a case, the numbers of its operating point among its keys."""
    tables = {name: value for name, value in given.items() if name not in OPERATING}
    for path, text in as_keys({name: value for name, value in given.items() if name in OPERATING}).items():
        name, key = path.split(".")
        tables[name] = {**tables.get(name, {}), key: text}
    return tables


def as_case(case: CaseLike) -> Case:
    """The case that is meant."""
    return case if isinstance(case, Case) else Case(case)
