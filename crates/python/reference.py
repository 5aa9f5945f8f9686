"""Prints the page of the module for the book: everything public with its signature and doc string.

    python crates/python/reference.py          # after building the module; `just book` does it
"""

import ast
import inspect
import re
import sys

import asperity
import columns
from asperity import _asperity, _case, _columns, _compare, _files, _oil, _own_laws, _profile, _progress, _quantity, _studies, _values

HEAD = """# Python API

<!-- Written by crates/python/reference.py from signatures and doc strings. -->

Everything public of the module `asperity`; [PYTHON.md](PYTHON.md) has rules, examples and laws written in Python.
[Types](#types) are written as in Python.
"""
TOPICS = {
    "Cases": "Case read_result demo from_rexs rexs_contents RexsCase",
    "Results of a case": "RunResult Summary Path Fields Regime",
    "Profiles": "read_profile generate generate_like Profile Parts Parameters profile_change ProfileChange",
    "Contacts": "solve_contact press_flanks subsurface_stress Contact Stress ehl EhlRecord",
    "Laws over arrays": "hertz film_thickness thermal_reduction friction_coefficient",
    "Studies": "compare Comparison map read_map Map cycle Cycle sensitivity Sensitivity ridges Ridges running_in RunningIn callout CallOut sweep Sweep",
    "Measurements": "calibrate Calibration design Design evidence Evidence",
    "Oils": "oil_traction Traction oil_plan OilPlan oil_fit OilFit stribeck Stribeck",
    "The library": "gears steels oils schema",
    "Errors and warnings": "AsperityError AsperityWarning Place explain Explanation show_versions",
    "Tables and charts": "Record Table Chart",
}
TYPES = {
    _case: "CaseLike", _profile: "Trace Traces", _compare: "Finish Variant", _columns: "Columns FrameLike", _files: "Paths", _oil: "OilLike", _own_laws: "Law", _progress: "Progress",
    _quantity: "Scalar Values Quantity Quantities Numbers Floats PintLike", asperity.keys: "CaseTables CaseKeys",
}
"""Types of arguments and results by the module that has them."""
OF_PYTHON = "ArrayLike IO PathLike Unpack Any Optional Union Mapping Sequence Literal None False True".split()
# Columns are listed in FILE_FORMATS.md, kinds of laws are keywords.
NOT_LISTED = ("ResultName", "SummaryName", "PathColumn", "MapName", "LawOf")
NAMED = set()
"""Names in the types of the signatures that were written."""


def noted(annotation):
    """A type as text, whose names are added to `NAMED`."""
    NAMED.update(re.findall(r"(?<![.\w])[A-Z]\w+", re.sub("[\"'][^\"']*[\"']", "", str(annotation))))
    return annotation


def signature(name, function, begin=""):
    """The call of a function with the types of its arguments, on lines of at most 100 letters."""
    given = inspect.signature(function)
    parts, kinds = [], inspect.Parameter
    before = None
    for one in given.parameters.values():
        if one.name in ("self", "cls"):
            continue
        if before == kinds.POSITIONAL_ONLY != one.kind:
            parts.append("/")
        if one.kind == kinds.KEYWORD_ONLY and before not in (kinds.KEYWORD_ONLY, kinds.VAR_POSITIONAL):
            parts.append("*")
        star = {kinds.VAR_POSITIONAL: "*", kinds.VAR_KEYWORD: "**"}.get(one.kind, "")
        kind = "" if one.annotation is one.empty else f": {noted(one.annotation)}"
        default = "" if one.default is one.empty else f" = {one.default!r}"
        parts.append(f"{star}{one.name}{kind}{default}")
        before = one.kind
    back = "" if given.return_annotation is given.empty or given.return_annotation == "None" else f" -> {noted(given.return_annotation)}"
    line = f"{begin}{name}({', '.join(parts)}){back}"
    if len(line) <= 100:
        return line
    body = "".join(f"    {part},\n" for part in parts)
    return f"{begin}{name}(\n{body}){back}"


def prose(text):
    """A doc string as Markdown: sections of arguments as lists, examples as code."""
    lines, found, in_list, in_code = inspect.cleandoc(text).splitlines(), [], False, False
    for line in lines:
        code = line.strip() if line.startswith(" " * 4) else line
        is_code = code.startswith((">>> ", "... ")) or (in_code and code != "" and line[:1] in (" ", *"[({'"))
        if is_code != in_code:
            found += ["```" if in_code else "```python"]
            in_code = is_code
        if is_code:
            shown = code[4:] if code.startswith((">>> ", "... ")) else f"# {code}"
            found.append(re.sub(r"\s*# doctest:.*", "", shown))
            continue
        line = line.replace("``", "`")
        if line in ("Parameters:", "Attributes:", "Returns:", "Raises:", "Example:"):
            in_list = True
            # Parameters and attributes follow the text without a title.
            found += ["", f"{line[:-1]}:", ""] if line[0] in "RE" else [""]
        elif in_list and (entry := re.match(r"    (\w[\w, *]*): (.*)", line)):
            names = ", ".join(f"`{name.strip()}`" for name in entry[1].split(","))
            found.append(f"- {names}: {entry[2]}")
        elif in_list and line.startswith("        "):
            found.append(f"  {line.strip()}")
        elif in_list and line.startswith("    "):
            found.append(line.strip())
        else:
            in_list = in_list and not line
            found.append(line)
    return "\n".join([*found, "```"] if in_code else found)


def first(text):
    """The first paragraph of a doc string on one line."""
    return " ".join(inspect.cleandoc(text).replace("``", "`").split("\n\n")[0].split())


def documented_fields(kind):
    """Fields of a named tuple with their types and the texts that follow them in the source."""
    (node,) = ast.parse(inspect.getsource(kind)).body
    for field, after in zip(node.body, [*node.body[1:], None]):
        if isinstance(field, ast.AnnAssign):
            is_text = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
            text = f": {first(after.value.value)}" if is_text else ""
            yield f"- `{field.target.id}: {ast.unparse(field.annotation)}`{text}"


def members(kind):
    """Public members of a class by name, with the members of bases that have no entry of their own."""
    found = {}
    for base in reversed(kind.__mro__):
        is_own = base is kind or (base.__module__.startswith("asperity._") and base.__name__ not in asperity.__all__)
        if is_own:
            found.update({key: member for key, member in vars(base).items() if not key.startswith("_")})
    return sorted(found.items())


def of_class(name, kind):
    """A class with its bases, its call where users make it, and its members."""
    text = [f"### {name}", ""]
    if "Parameters:" in kind.__doc__:
        text += ["```python", signature(name, kind.__init__, "class "), "```", ""]
    text += [prose(kind.__doc__), ""]
    bases = [base.__name__ for base in kind.__mro__[1:] if base.__name__ in (*asperity.__all__, "ValueError", "UserWarning")]
    if bases:
        text += [f"Base: `{bases[0]}`.", ""]
    if issubclass(kind, tuple):
        return "\n".join([*text, *documented_fields(kind)])
    for key, member in members(kind):
        member = member.__func__ if isinstance(member, (classmethod, staticmethod)) else member
        getter = getattr(member, "fget", None) or getattr(member, "func", None)
        if getter is not None:
            text.append(f"- `.{key}: {noted(inspect.signature(getter).return_annotation)}`: {first(getter.__doc__)}")
        elif inspect.isfunction(member):
            call = signature(f".{key}", member)
            is_short = "\n" not in call and "\n\n" not in inspect.cleandoc(member.__doc__)
            long = f"\n```python\n{call}\n```\n\n{prose(member.__doc__)}\n"
            text.append(f"- `{call}`: {first(member.__doc__)}" if is_short else long)
    return "\n".join(text)


def of_function(name, function):
    """A function with its call."""
    return f"### {name}\n\n```python\n{signature(name, function)}\n```\n\n{prose(function.__doc__)}"


OF_RUNS = {"SummaryValues": "Values of Summary", "PathRowTable": "Columns of Path"}
"""Values of runs whose members are listed with the tables, with their headings."""


def types():
    """The types that the signatures above name: unions and classes by their definitions, tables by their columns."""
    rows, named = [], set()
    for home, names in TYPES.items():
        body = ast.parse(inspect.getsource(home)).body
        for node, after in zip(body, [*body[1:], None]):
            name = node.name if isinstance(node, ast.ClassDef) else getattr(node.targets[0], "id", "") if isinstance(node, ast.Assign) else ""
            if name in names.split():
                about = ast.get_docstring(node) if isinstance(node, ast.ClassDef) else after.value.value
                is_union = isinstance(node, ast.Assign) and home is not asperity.keys
                of = f"`{ast.unparse(node.value)}`".replace("|", "\\|") if is_union else "`asperity.keys`" if home is asperity.keys else "class"
                rows.append(f"| `{name}` | {of} | {first(about)} |\n")
                named.add(name)
    listed = {name for name in NAMED if getattr(getattr(_values, name, None), "__module__", "") == _values.__name__}
    rows_of = [getattr(_values, name)._row for name in listed if name.endswith("Table")]
    listed = sorted(listed | {kind.__name__ for row in rows_of for kind in row._kinds.values() if kind.__name__.endswith("Table")})
    known = {*named, *listed, *OF_PYTHON, *asperity.__all__, *(name for name, *_ in _asperity.choices())}
    if unknown := NAMED - known:
        raise ValueError(f"types that the page does not explain: {sorted(unknown)}; add them to TYPES")
    meanings = columns.tables()
    values = "".join(f"| `{name}` | {', '.join(f'`{key}`' for key in getattr(_values, name).__annotations__)} |\n" for name in listed if name not in meanings)
    tables = "".join(
        f"### {OF_RUNS.get(name, name)}\n\n| column | what it is |\n|---|---|\n{''.join(f'| `{key}` | {text} |' + chr(10) for key, text in meanings[name].items())}\n"
        for name in [*OF_RUNS, *(name for name in listed if name not in OF_RUNS)] if name in meanings
    )
    return (
        f"## Types\n\nTypes of arguments and results that the signatures name.\n\n| type | in Python | is |\n|---|---|---|\n{''.join(rows)}\n"
        f"Values whose names a type checker knows:\n\n| type | names |\n|---|---|\n{values}\n"
        f"## Tables\n\nColumns of the tables of results, whose rows have the same names. The type of a column does not depend on its values: "
        f"where a row has no such number, it holds NaN.\n\n{tables}"
    )


def written():
    """The text of the page."""
    public = {*asperity.__all__, "map"} - {"__version__"}
    topics = {topic: names.split() for topic, names in TOPICS.items()}
    # A study without results of its own needs no entry above.
    named = {name for names in topics.values() for name in names}
    topics["Studies"] += [name for name in _studies.__all__ if name not in named]
    listed = [name for names in topics.values() for name in names]
    if {*listed} != public or len(listed) != len(public):
        raise ValueError(f"names of no topic or of two: {public.symmetric_difference(listed) or listed}")
    blocks = [HEAD]
    for topic, names in topics.items():
        things = {name: getattr(asperity, name) for name in names}
        blocks.append(f"## {topic}\n")
        for name, thing in things.items():
            blocks.append((of_class if isinstance(thing, type) else of_function)(name, thing) + "\n")
    rows = "".join(
        f"| `{name}` | {', '.join(f'`{value}`' for value in values)} |\n" for name, _, values in _asperity.choices() if name not in NOT_LISTED
    )
    blocks.append(types())
    blocks.append(f"## Choices\n\nTypes of arguments that take one of these texts.\n\n| type | texts |\n|---|---|\n{rows}")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(blocks))


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    print(written(), end="")
