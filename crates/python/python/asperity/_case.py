"""Cases: what is to be computed."""

from __future__ import annotations

import functools
import json
import os
from collections.abc import Mapping
from os import PathLike, fspath
from typing import IO, Any, Optional, Union

import numpy as np

from . import _asperity
from ._choices import Detail, Formulation
from ._contact import Contact
from ._errors import AsperityError, Code, checked_or_none, json_text, warn, wrong_kind
from ._files import is_read, text_of
from ._fixed import Fixed
from ._html import page
from ._keys import Schema, Traces, changes, kind_of, may_name_a_profile, written
from ._own_laws import Called, Law, exponent_of, name_of
from ._profile import Profile
from ._progress import Progress, Steps
from ._quantity import BY_TEXT, OPERATING, as_keys, in_numbers, refuse_misspelt
from ._record import Record, Table, warned
from ._result import Regime, RunResult
from ._typing import Unpack
from .keys import CaseKeys, CaseTables

Laws = dict[str, Called]
"""Laws in Python by what they replace."""


class Case(Fixed):
    """A gear pair, gear train or planetary set with its load, oil and flanks, checked.

    The keys are those of a case file (docs/CASE_FILE.md). A quantity is text with a unit or a quantity of pint; the
    operating point can be given by the numbers ``torque_nm``, ``speed_rpm`` and ``temperature_c`` (of the flanks), or by
    text with a unit as ``torque``, ``speed`` and ``temperature``. A
    flank, or its ``file``, can be a `Profile`. Files are relative to ``folder``, by default the working directory or
    the folder of the case file.

    Parameters:
        case: file, object that is read like one, or tables; tables as keywords win over them.
        formulation: ``"corrected"`` or ``"paper"``, over that of the case.
        folder: folder that files are relative to.

    Example:
        >>> case = asperity.Case(gears={"teeth": [23, 68], "module": "1.8 mm", "face_width": "32 mm"},
        ...                      torque_nm=145, speed_rpm=9000, temperature="90 °C",
        ...                      lubricant={"oil": "m100"}, surface={"pinion": {"rq": "0.4 um"}})
        >>> case == asperity.Case(case.to_dict())
        True
    """

    _raw: _asperity.Case
    _laws: Laws

    def __init__(
        self,
        case: Union[str, PathLike[str], IO[str], IO[bytes], Mapping[str, Any], None] = None,
        /,
        *,
        formulation: Optional[Formulation] = None,
        folder: Optional[Union[str, PathLike[str]]] = None,
        **tables: Unpack[CaseTables],
    ) -> None:
        if isinstance(case, (str, PathLike)) and (folder is None or not os.path.isfile(case)):
            made = Case.load(case, tables, formulation=formulation)
        else:
            of = os.path.abspath(fspath(folder or "."))
            if isinstance(case, (str, PathLike)):
                with open(case, "rb") as file:
                    text = text_of(file)
                made = Case._of(_asperity.Case.from_text(os.path.basename(case), text, of, [], formulation))
                made = made._with(tables) if tables else made
            elif is_read(case):
                made = Case._of(_asperity.Case.from_text("case.toml", text_of(case), of, [], formulation))
                made = made._with(tables) if tables else made
            elif case is not None and not isinstance(case, Mapping):
                raise wrong_kind("case", case, "the path of a case file, the tables of one, or an object that is read like one")
            else:
                given = tables_of({**(case or {}), **tables})
                traces: Traces = []
                values = written(given, Schema(kind_of(given)), traces)
                text = json_text(values, indent=1)
                made = Case._of(_asperity.Case.from_text("case.json", text, of, traces, formulation))
        self._raw, self._laws = made._raw, {}

    @functools.cached_property
    def _about(self) -> dict[str, Any]:
        about: dict[str, Any] = json.loads(self._raw.about)
        return about

    @classmethod
    def _of(cls, raw: _asperity.Case, laws: Optional[Laws] = None, before: Optional[_asperity.Case] = None) -> Case:
        """The case of the compiled part, after the warnings that the case before it does not have."""
        made = cls.__new__(cls)
        made._raw, made._laws = raw, laws or {}
        warn(json.loads(raw.warnings), () if before is None else json.loads(before.warnings))
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return Case._unpickled, (self._raw.content(), self._raw.fingerprint, self._laws)

    @classmethod
    def _unpickled(cls, content: dict[str, Any], fingerprint: str, laws: Laws) -> Case:
        """The case of its content: no file on disk is read, and another case is an error."""
        raw = _asperity.Case.from_content(content)
        if raw.fingerprint != fingerprint:
            text = f"{content['name']}: the pickled case is another one in this version of the program"
            raise AsperityError(text, Code.E140, "Read the case again.")
        made = cls.__new__(cls)
        made._raw, made._laws = raw, {}
        for called in laws.values():
            made = made._with_law(called)
        return made

    def __copy__(self) -> Case:
        return self

    def __deepcopy__(self, memo: Any) -> Case:
        return self

    def __dask_tokenize__(self) -> Any:
        from dask.base import normalize_token

        return normalize_token(("asperity.Case", self._raw.fingerprint, list(self._laws.values())))

    @classmethod
    def load(
        cls,
        path: Union[str, PathLike[str]],
        keys: Optional[Mapping[str, Any]] = None,
        *,
        formulation: Optional[Formulation] = None,
    ) -> Case:
        """The case in a TOML or JSON file, with ``keys`` set past its text: ``{"operation.torque": "20 N m"}``.

        Parameters:
            path: the case file.
            keys: keys that are set past its text.
            formulation: ``"corrected"`` or ``"paper"``, over that of the file.

        Returns:
            The `Case`.

        Raises:
            AsperityError: the file cannot be read (E201, E202), or a key or value of it is not valid (E203 to E212).

        Example:
            >>> case = asperity.Case.load(asperity.demo(), {"operation.torque": "20 N m"})
            >>> case.inputs.operation.torque
            '20 N m'
        """
        if not keys:
            return cls._of(_asperity.Case.load(fspath(path), [], formulation))
        traces: Traces = []
        keys = as_keys(keys)
        found = changes(keys, kind_of(keys), traces)
        set_keys = [(key, value) for key, value in found if value is not None]
        if traces or len(set_keys) < len(found):
            return cls.load(path, formulation=formulation)._with(keys)
        return cls._of(_asperity.Case.load(fspath(path), set_keys, formulation))

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
        ``case.replace(operation={"torque": "20 N m"})``, whose other keys stay, or by the operating point,
        ``case.replace(torque_nm=20)``, ``case.replace(torque="20 N m")``. None takes a key away, so that its default holds again.
        An oil, ``lubricant.oil`` or ``lubricant.oil_file``, replaces all numbers of the oil of the case, and its calibration.

        A flank takes a `Profile` or the name of a file, which replaces all keys of that flank: ``mirrored``, ``range`` and roughness
        values of the trace before do not stay. Its ``file`` takes both, too, and the other keys stay:
        ``case.replace({"surface.wheel.file": flank})`` reads the flank from its other end where the case has ``mirrored``. A flank
        has one of ``file``, ``traces``, ``like`` and roughness values; in a table, as in a variant, None takes away the one that it had:
        ``case.replace({"surface.pinion": {"file": None, "like": "ground_*.csv"}})``. ``rows`` goes with ``file``.

        Parameters:
            changed: keys by their paths, or tables.
            formulation: ``"corrected"`` or ``"paper"``.
            more: tables, or the operating point.

        Returns:
            Another `Case`; this one does not change.

        Raises:
            AsperityError: a key that no case has (E203), or a value that it cannot have (E204 to E212).

        Example:
            >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
            >>> lighter = case.replace({"lubricant.oil": "n100"}, torque="20 N m")
            >>> lighter.run("losses").loss_w < case.run("losses").loss_w
            True
        """
        if changed is not None and not isinstance(changed, Mapping):
            raise wrong_kind("changed", changed, "keys of a case with their values")
        other = {} if formulation is None else {"formulation": formulation}
        return self._with({**(changed or {}), **other, **more})

    def _with(self, keys: Mapping[str, Any]) -> Case:
        """The case with other keys, whose names need not be known before the program runs."""
        traces: Traces = []
        found = changes(as_keys(keys), self._raw.gears_table, traces)
        return Case._of(self._raw.replace(found, traces), self._laws, self._raw)

    def with_laws(
        self,
        *,
        film_friction: Optional[Law] = None,
        film_thickness: Optional[Law] = None,
        load_share: Optional[Law] = None,
        load_distribution: Optional[Law] = None,
    ) -> Case:
        """The case with laws written in Python instead of its own.

        A law is a function of one argument or an object with ``__call__``: a `Record` of arrays in SI units, over the
        offsets of the traces at a mesh position. It returns an array or a number, or a dictionary of them. Results name
        a law by its ``name``, or by the name of its function or class. It is called from several threads, one at a time.

        Parameters:
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
                path_fraction (0 at A, 1 at E), torque, ``uniform`` (the load if all lines of contact share equally, as ``"mean-length"`` of a case).

        An exception of a law ends the run and is raised with its traceback.

        Returns:
            Another `Case`, with these laws.

        Raises:
            AsperityError: a law that is not callable, or a film thickness without ``speed_exponent`` (E205); in a run what a law
                returns is not valid (E209).

        Example:
            >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
            >>> own = case.with_laws(film_friction=lambda at: 0.03)
            >>> own.run("losses").loss_w != case.run("losses").loss_w
            True
        """
        made = self
        for kind, law in (
            ("film-friction", film_friction),
            ("film-thickness", film_thickness),
            ("load-share", load_share),
            ("load-distribution", load_distribution),
        ):
            if law is not None:
                made = made._with_law(Called(kind, law))
        return made

    def _with_law(self, called: Called) -> Case:
        kind, law = called
        raw = self._raw.with_law(kind, name_of(law), exponent_of(kind, law), called.__call__)
        return Case._of(raw, {**self._laws, kind: called}, self._raw)

    def _varied(self, called: str, keys: Mapping[str, Any]) -> Case:
        """The case as its variant with other values of some keys."""
        traces: Traces = []
        found = changes(as_keys(keys), self._raw.gears_table, traces)
        return Case._of(self._raw.varied(called, found, traces), self._laws, self._raw)

    def _on_finish(self, called: str, finish: Any) -> Case:
        """The case on the traces of a finish: one for both flanks, or those of pinion and wheel."""
        traces: Traces = []
        pair = finish if isinstance(finish, (tuple, list)) else (finish,)
        if not 1 <= len(pair) <= 2:
            raise AsperityError("a finish has one trace or two", Code.E205, "Give a profile, or those of pinion and wheel.")

        def name(trace: Any) -> str:
            if isinstance(trace, (str, PathLike)):
                return os.path.abspath(fspath(trace))
            if not isinstance(trace, Profile):
                raise wrong_kind(f"finishes[{called!r}]", trace, "a profile, the path of one, a pair of them or a case")
            named: str = written(trace, Schema(), traces)["file"]
            return named

        names = [name(trace) for trace in pair]
        wheel = names[1] if len(names) == 2 else None
        return Case._of(self._raw.on_finish(names[0], wheel, traces), self._laws, self._raw)

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
        return Table(self._about["defaults"], ["key", "value", "source"])

    @property
    def warnings(self) -> Table:
        """All warnings that need no run, as ``asperity check`` lists them: code and text. If a run cannot begin, those about the files alone."""
        return Table(json.loads(self._raw.checked), ["code", "text"])

    @property
    def meshes(self) -> list[str]:
        """Names of the meshes of a gear train or planetary set; empty for a pair of gears."""
        return self._raw.meshes

    def mesh(self, name: str) -> Case:
        """The mesh of a gear train or planetary set as a case of its own, at its torque and speed."""
        return Case._of(self._raw.mesh(name), self._laws, self._raw)

    @property
    def is_planetary(self) -> bool:
        """Whether the case is a planetary set."""
        return self._raw.gears_table == "planetary"

    def run(
        self,
        detail: Detail = "fields",
        *,
        band: Optional[bool] = None,
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
    ) -> RunResult:
        """Computes losses, and with more detail contacts and fields; the losses are the same to the last digit.

        Parameters:
            detail: ``"losses"`` (a fraction of the time; of several meshes as ``"contacts"``), ``"contacts"`` (the rough contacts at every offset), or
                ``"fields"`` (as the command: fields and stress below the surface, too).
            band: whether the uncertainty of the loss is computed; default with ``"fields"`` only. Not with ``"losses"``.
            threads: number of threads; default, and -1, all cores.
            progress: ``f(done, total)``, ``tqdm``, or a bar of it.

        Ctrl-C ends the run.

        Returns:
            A `RunResult`.

        Raises:
            AsperityError: what cannot be computed, by its code, or an interval of ``"losses"`` (E205).
            KeyboardInterrupt: Ctrl-C.

        Example:
            >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
            >>> result = case.run()
            >>> result.uncertainty is not None and bool(result.uncertainty.loss.quantiles_w[0] < result.loss_w)
            True
        """
        with Steps(progress, self.title) as steps:
            found = RunResult._of(self._raw.run(detail, checked_or_none("band", band, bool), checked_or_none("threads", threads, int), steps))
        warn(found._doubts(), self._about["warnings"])
        return found

    def regime(self, *, threads: Optional[int] = None) -> Regime:
        """Film thickness, Λ* and regime along the path of contact; of several meshes, the first."""
        meshes = json.loads(self._raw.regime(checked_or_none("threads", threads, int)))
        return Regime(meshes)

    def contact(self, position: Optional[float] = None) -> Contact:
        """The flanks pressed dry against each other at a place of the path, 0 at A and 1 at E; default the pitch point."""
        return warned(Contact(*self._raw.contact(checked_or_none("position", position, float))))

    def film(self, position: Optional[float] = None) -> Record:
        """Pressure difference across films from 1 nm to 1 mm at a place of the path; default the pitch point: ``rows`` (thickness_m,
        reynolds_cross_pa ...), with ``path_fraction``, ``hertz_pressure_pa`` and ``film_central_m``."""
        return Record(json.loads(self._raw.film(checked_or_none("position", position, float))))

    def gear(self) -> Record:
        """Geometry (``gears``), loss factors and transmission error of the gears under their load, without a run.

        ``loss_factor_local`` with its ``band``, and ``loss_factor_ohlendorf``, as in the summary of a run; ``loss_factors`` of every ``law`` of
        the load over the teeth; ``edge_contact``, ``face_load_factor``, ``transmission_error`` (``mean_um``, ``peak_to_peak_um``,
        ``mesh_stiffness_n_per_mm_um``, and ``curve`` over the phase), ``iso_mesh_stiffness_n_per_mm_um``,
        ``normal_force_n``.
        """
        found: dict[str, Any] = json.loads(self._raw.gear())
        if error := found["transmission_error"]:
            error["curve"] = [{"phase": phase, "transmission_error": value} for phase, value in error["curve"]]
            error["mesh_stiffness_n_per_mm_um"] = error.pop("mesh_stiffness") * 1e-9
        return Record(in_numbers(found))

    def to_dict(self) -> dict[str, Any]:
        """The case as given; ``Case(case.to_dict())``, with the ``folder`` of its files, is the same case where its traces are files."""
        inputs: dict[str, Any] = json.loads(json.dumps(self._about["inputs"]))
        return inputs

    def to_toml(self, folder: Optional[Union[str, PathLike[str]]] = None) -> str:
        """The case as the text of a case file, without laws in Python.

        Parameters:
            folder: existing folder of the case file; default that of the files of the case. Profiles in memory are written into it,
                and names of files become relative to it.

        Returns:
            The text.

        Raises:
            AsperityError: profiles in memory without a folder (E205), or a folder that cannot be written (E401).

        Example:
            >>> flank = asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1)
            >>> case = asperity.Case(asperity.demo(), surface={"pinion": flank}, model={"positions": 4, "offsets": 2})
            >>> with open("demo/own.toml", "w", encoding="utf-8") as file:
            ...     _ = file.write(case.to_toml("demo"))
            >>> asperity.Case("demo/own.toml").run("losses").loss_w == case.run("losses").loss_w
            True
        """
        text = self._raw.to_toml()
        # Only names of profiles in memory look like theirs; what they are is in the content.
        if folder is None and not may_name_a_profile(text):
            return text
        # At its first need: it takes time to import.
        import re

        content = self._raw.content()
        if folder is None:
            if not content["traces"]:
                return text
            names = ", ".join(fspath(name) for name, *_ in content["traces"])
            raise AsperityError(f"profiles in memory: {names}; no file has them", Code.E205, "Name the folder that they are written into: to_toml(folder).")
        place, before = os.path.abspath(folder), fspath(content["folder"])
        renamed: dict[str, str] = {}
        for name, spacing, heights, stated in content["traces"]:
            own = os.path.basename(fspath(name))
            renamed[fspath(name)] = file = f"{re.sub(r'[^a-zA-Z0-9.-]+', '_', own).strip('_')}.csv"
            _asperity.Trace.of_case(np.frombuffer(heights), spacing, stated).write(os.path.join(place, file))
        files = {os.path.normpath(os.path.join(before, name)) for name, _ in content["files"]}

        def moved(value: Any) -> Any:
            if isinstance(value, dict):
                return {key: moved(item) for key, item in value.items()}
            if isinstance(value, list):
                return [moved(item) for item in value]
            if not isinstance(value, str) or value in renamed:
                return renamed.get(value, value)
            file = os.path.normpath(os.path.join(before, value))
            return os.path.relpath(file, place) if file in files and not os.path.isabs(value) else value

        text = json.dumps(moved(self.to_dict()), ensure_ascii=False)
        return _asperity.Case.from_text("case.json", text, place, [], None).to_toml()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self._raw.fingerprint == other._raw.fingerprint and self._laws == other._laws

    def __hash__(self) -> int:
        return hash(self._raw.fingerprint)

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


CaseLike = Union[Case, str, PathLike[str], Mapping[str, Any]]
"""A case, the file of one, or the tables of one."""


def tables_of(given: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of a case, its operating point among its keys."""
    of_point = {name: value for name, value in given.items() if name in OPERATING or name in BY_TEXT}
    tables = {name: value for name, value in given.items() if name not in of_point}
    for name in tables:
        refuse_misspelt(name)
    for path, value in as_keys(of_point).items():
        name, key = path.split(".")
        tables[name] = {**tables.get(name, {}), key: value}
    return tables


def as_case(case: CaseLike, name: str = "case") -> Case:
    """The case that is meant; `name` is the argument."""
    if isinstance(case, Case):
        return case
    if not isinstance(case, (str, PathLike, Mapping)) and not is_read(case):
        raise wrong_kind(name, case, "a Case, the path of a case file or the tables of one")
    return Case(case)
