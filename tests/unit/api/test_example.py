"""The example for Python: a notebook that runs from top to bottom in a real kernel."""

import json
import re
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import vrts
from tests.places import ROOT

FOLDER = ROOT / "examples" / "06-notebook"
NOTEBOOK = FOLDER / "from-python.ipynb"


def _cells() -> list[dict[str, Any]]:
    return json.loads(NOTEBOOK.read_text("utf-8"))["cells"]


def _code() -> str:
    return "\n".join("".join(c["source"]) for c in _cells() if c["cell_type"] == "code")


def test_it_is_kept_without_outputs() -> None:
    for cell in _cells():
        assert set(cell) >= {"id", "metadata", "source"}
        if cell["cell_type"] == "code":
            assert cell["outputs"] == []
            assert cell["execution_count"] is None


def test_it_uses_what_there_is() -> None:
    words = (FOLDER / "README.md").read_text("utf-8")
    used = set(re.findall(r"\bvrts\.([A-Za-z]\w*)", _code() + words))
    assert used - {"v2"} <= set(vrts.__all__)
    assert used >= {"scene", "compile", "run", "verify", "why", "certificate", "prove"}


@pytest.mark.thorough
def test_it_runs_in_a_real_kernel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("IPYTHONDIR", "JUPYTER_RUNTIME_DIR", "JUPYTER_DATA_DIR", "JUPYTER_CONFIG_DIR"):
        monkeypatch.setenv(name, str(tmp_path / name))
    nbformat: Any = import_module("nbformat")  # without types
    NotebookClient: Any = import_module("nbclient").NotebookClient
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute(cwd=str(FOLDER))
    shown: list[dict[str, Any]] = [
        output for cell in notebook.cells for output in cell.get("outputs", ())
    ]
    assert not [one for one in shown if one["output_type"] == "error"]
    html = [one["data"]["text/html"] for one in shown if "text/html" in one.get("data", {})]
    starts = ["".join(text)[:8].lstrip() for text in html]
    assert starts == ["<svg xml", "<div cla", "<iframe "]
    said = "".join("".join(one["text"]) for one in shown if one["output_type"] == "stream")
    assert "line 10: can1 hits base1, 37 mm deep" in said
    assert re.search(r"^ +140 +0 +2\.9 +4\.3$", said, re.M)
    assert "run.cert holds: for every instant" in said
    assert "every future: violated" in said
