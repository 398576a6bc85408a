"""Who proposes by a name, and that what marks never loads fcl."""

import ast
import json
import subprocess
import sys

import pytest

from tests.places import ROOT
from vrts.marking.proposer.by_name import ALONE, ENGINES, by_name

SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
MARKS = """
import json, sys
from pathlib import Path
from vrts.marking.submission.marker import Marker, read_marks
from vrts.marking.submission.one import Order, Wanted
from vrts.marking.submission.setting import Place
from tempfile import TemporaryDirectory
said = []
solution = Path(sys.argv[1])
for engine in (None, "fcl", "own"):
    marker = Marker(Place(str(solution.parent / "task.toml")), Wanted(engine=engine, pages=False))
    with TemporaryDirectory() as folder:
        marks = read_marks(marker.work(Order("one", "one", solution.read_bytes()), Path(folder)))
    said.append((marks.staff.mark, marks.staff.versions.engine))
loaded = sorted(name for name in sys.modules if name.partition(".")[0] == "fcl")
print(json.dumps([said, loaded]))
"""


@pytest.mark.parametrize("name", [None, *ENGINES])
def test_all_names_are_known(name: str | None) -> None:
    with by_name(name) as by:
        assert by.proposer is not None
        assert by.proposer.name == (name or "coal")
        assert (by.second is None) == (name == "fcl")


def test_nobody_is_started_where_nothing_is_asked() -> None:
    with by_name("fcl", asked=False) as by:
        assert by == ALONE


@pytest.mark.thorough
def test_a_process_that_marks_never_loads_fcl_and_the_mark_is_the_same() -> None:
    called = [sys.executable, "-c", MARKS, str(SOLUTION)]
    done = subprocess.run(called, capture_output=True, text=True, check=True, cwd=ROOT)
    said, loaded = json.loads(done.stdout)
    assert loaded == []
    assert said == [[10.0, "coal"], [10.0, "fcl"], [10.0, "own"]]


@pytest.mark.thorough
def test_only_the_child_imports_fcl() -> None:
    imports = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "vrts").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module == "vrts.geometry.fcl_engine"
    }
    assert imports == {"vrts/marking/proposer/child.py"}
