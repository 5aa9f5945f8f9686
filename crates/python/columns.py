"""What each column of a table of a study means: the text of its field in Rust, from which the page, the files and the module take it."""

import inspect
import re
from pathlib import Path

from asperity import _values
from asperity._record import TableOf

ROOT = Path(__file__).resolve().parents[2]
ONLY_HERE = {
    "code": "code of the error, if there is one",
    "finish": "name of the finish",
    "temperature_c": "temperature of the flanks [°C]",
    "torque_nm": "torque at the pinion [N m]",
    "speed_rpm": "speed of the pinion [1/min]",
    "unit": "unit of the values of the row; none of a pure number",
    "CycleFinish.lost_p05_wh": "5 % quantile of the energy lost [Wh]",
    "CycleFinish.lost_p95_wh": "95 % quantile of the same [Wh]",
    "CycleFinish.difference_p05_wh": "5 % quantile of the difference from the first finish [Wh]",
    "CycleFinish.difference_p95_wh": "95 % quantile of the same [Wh]",
    "ComparisonFinishDeciding.p05_w": "5 % quantile of the difference about its present median [W]",
    "ComparisonFinishDeciding.p95_w": "95 % quantile of the same [W]",
    "UncertaintyPart.p05_w": "5 % quantile of the loss where only this component is drawn [W]",
    "UncertaintyPart.p95_w": "95 % quantile of the same [W]",
    "ProfileChangePair.removed_nm": "height that the test removed, mean over the overlap [nm]",
    "ProfileChangePair.lost_nm": "part of it where the second trace is lower [nm]",
    "ProfileChangePair.gained_nm": "height gained where the second trace is higher [nm]",
    "ProfileChangeInCaseState.state": "state of the flanks: before the test, after it, or run in by the model",
    "ProfileChangeInCaseState.loss_p05_w": "5 % quantile of the loss [W]",
    "ProfileChangeInCaseState.loss_p95_w": "95 % quantile of the loss [W]",
    "MapRow.extended": "whether the torque is below the smallest one whose contacts the traces resolve",
    "MapRow.regime": "lubrication regime",
    "SensitivityRow.group": "group of changes: what the user can change, or what is not known well",
    "SensitivityRow.what": "what is changed",
    "SensitivityRow.to": "value or choice that it is changed to",
    "CalibrationParameter.bootstrap": "5 to 95 % of the bootstrap over assemblies",
    "CalibrationParameter.profile_range": "5 to 95 % by the profile likelihood",
    "CalibrationParameter.value": "value that was fitted",
    "CalibrationParameter.range": "range of 5 to 95 %",
    "CalibrationParameter.band": "2.5 to 97.5 %, as a case file states them",
    "CalibrationParameter.default_range": "range of a case without calibration",
    "DesignParameter.value": "value that losses like those of the model would give",
    "DesignParameter.range": "range of 5 to 95 % that the points would leave",
    "DesignParameter.default_range": "range of a case without calibration",
    "OilFitConstant.value": "value that was fitted",
    "OilFitConstant.range": "range of 5 to 95 %",
    "OilFitConstant.band": "2.5 to 97.5 %, as files state them",
    "OilFitConstant.prior_range": "range of 5 to 95 % of the prior",
}
"""Columns that the module makes, or whose fields hold several."""


def fields():
    """Texts of the fields of each structure in Rust."""
    found = {}
    for file in sorted(ROOT.glob("crates/*/src/**/*.rs")):
        for name, body in re.findall(r"struct (\w+)(?:<[^>]*>)?\s*\{(.*?)\n\s*\}", file.read_text(encoding="utf-8"), re.S):
            texts = re.findall(r"((?:^\s*///[^\n]*\n)+)(?:\s*#\[[^\n]*\n)*\s*(?:pub(?:\([^)]*\))? )?(\w+):", body, re.M)
            found[file, name] = {field: " ".join(re.sub(r"^\s*///", "", line).strip() for line in text.strip().splitlines()) for text, field in texts}
    return found


def plainly(text):
    """The first sentence of a text of Rust as Markdown."""
    text = re.sub(r"\[(`[^`]*`)\](?:\([^)]*\))?", r"\1", text.replace("\\[", "[").replace("\\]", "]")).split(". ")[0].rstrip(".")
    is_word = text[1:2].islower() and not re.match(r"R(?:q|pk)\b", text)
    return text[:1].lower() + text[1:] if is_word else text


def meaning(row, column, texts):
    """The text of a column of rows of a class; texts are those of its structure."""
    if alone := ONLY_HERE.get(f"{row}.{column}"):
        return plainly(alone)
    stem, end = column, ""
    for mark, words in (("_p05", "5 % quantile: "), ("_p95", "95 % quantile: "), ("_low", "lower end: "), ("_high", "upper end: ")):
        if mark in f"_{column}" and column not in texts:
            stem, end = f"_{column}".replace(mark, "").strip("_"), words
            break
    stems = [stem, *(stem.replace(f"_{unit}", f"_quantiles_{unit}") for unit in ("w", "nm", "um")), f"{stem}_quantiles", "quantiles_w"]
    if text := ONLY_HERE.get(f"{row}.{stem}") or next((texts[key] for key in (stems if end else [stem]) if key in texts), ONLY_HERE.get(stem)):
        # An end of an interval is not the median.
        return end + plainly(text).split(": the median", 1)[0] if end else plainly(text)
    raise ValueError(f"{row}.{column}: no text says what it is; describe its field in Rust, or add it to columns.py")


def tables():
    """Classes of rows of all tables by their names, with the meaning of each column."""
    every, found = fields(), {}
    for name, table in inspect.getmembers(_values, inspect.isclass):
        if issubclass(table, TableOf) and table is not TableOf:
            row, columns = table._row.__name__, [key for key in table._row.__annotations__ if not key.startswith("_")]
            # A structure that flattens another one, or has its columns written by another one, shares them with it.
            first, second, *_ = sorted(every, key=lambda one: (len({*every[one]} & {*columns}), one[1] == row), reverse=True)
            found[name] = {column: meaning(row, column, {**every[second], **every[first]}) for column in columns}
    summary = next(texts for (_, name), texts in every.items() if name == "Summary" and "loss_factor_local" in texts)
    names = [key for key in _values.SummaryValues.__annotations__ if key in summary]
    found["SummaryValues"] = {name: meaning("Summary", name, summary) for name in names}
    return found
