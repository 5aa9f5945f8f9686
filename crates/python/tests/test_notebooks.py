"""The notebooks of the documentation run from top to bottom and show the outputs that they are stored with.

ASPERITY_WRITE=1 stores the outputs anew.
"""

import os
import re
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")
pytest.importorskip("pandas")
pytest.importorskip("xarray")

NOTEBOOKS = sorted((Path(__file__).parents[3] / "docs" / "notebooks").glob("*.ipynb"))
LARGEST = 70_000
"""Most bytes of a notebook with its outputs."""
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def test_there_are_notebooks():
    assert [file.stem for file in NOTEBOOKS] == ["contact_of_a_bearing", "finishes_compared", "own_flank_to_loss"]


def cleaned(output):
    """An output without what differs from run to run: the file that a cell was, and its time."""
    output = nbformat.from_dict({key: value for key, value in output.items() if key != "metadata"})
    if output.output_type == "stream":
        output.text = re.sub(r"\S*ipykernel_\d+/\d+\.py:\d+: ", "", output.text)
    elif "data" in output:
        output["metadata"] = {}
        # Tables of pandas bring a style sheet of their own.
        for kind, text in output.data.items():
            output.data[kind] = re.sub(r"<style scoped>.*?</style>\n?", "", text, flags=re.DOTALL)
    return output


def texts(notebook):
    """Texts that the cells of a notebook show, by the number of the cell."""
    found = []
    for number, cell in enumerate(notebook.cells):
        for output in cell.get("outputs", []):
            text = output["text"] if output.output_type == "stream" else output["data"]["text/plain"]
            found.append((number, sorted(output.get("data", ["stream"])), text))
    return found


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_notebook_runs_and_shows_its_outputs(file, tmp_path):
    stored = nbformat.read(file, as_version=4)
    notebook = nbformat.read(file, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    for cell in notebook.cells:
        cell["metadata"] = {}
        if "outputs" in cell:
            cell["outputs"] = [cleaned(output) for output in cell.outputs]
    notebook["metadata"] = stored.metadata
    if os.environ.get("ASPERITY_WRITE"):
        nbformat.write(notebook, file)
        stored = notebook
    assert file.stat().st_size < LARGEST
    for (cell, kinds, now), (_, stored_kinds, before) in zip(texts(notebook), texts(stored), strict=True):
        assert kinds == stored_kinds, cell
        # Widths of columns follow from digits, which differ between processors.
        assert NUMBER.sub("#", now).split() == NUMBER.sub("#", before).split(), cell
        for one, other in zip(NUMBER.findall(now), NUMBER.findall(before)):
            assert float(one) == pytest.approx(float(other), rel=1e-2, abs=1e-9), cell
    pages = [output["data"]["text/html"] for cell in notebook.cells for output in cell.get("outputs", []) if "text/html" in output.get("data", {})]
    assert any("<svg" in page for page in pages) or any("<table" in page for page in pages)
