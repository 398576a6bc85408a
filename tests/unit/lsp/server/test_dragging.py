"""What the panel beside the text asks while a location is dragged."""

import asyncio
from pathlib import Path
from typing import Any

import pytest

from tests.unit.lsp.heard import begun
from tests.unit.lsp.in_a_cell import setting
from vrts.lsp.runs.reaching import reach_text
from vrts.pipeline.files import unwritable

TEXT = """.PROGRAM main
        MOVE a
.END
.LOCATIONS
a  900.00  0.00  0.00  90.00  90.00  0.00
#p 0 -90 90 0 45 0
.END
"""


def asked(method: str, *, runs: bool = False, program: Path | None = None, **what: Any) -> Any:
    """Return the answer to one question about the location `a` of a buffer."""
    uri = "untitled:a.v2" if program is None else program.as_uri()
    file = "untitled:a.v2" if program is None else str(program)

    async def answer() -> Any:
        heard = await begun(TEXT, uri=uri, runs=runs)
        if runs:  # without a process: this one knows an arm
            heard.session.reaching.text = reach_text  # type: ignore[method-assign]
        given = {"uri": uri, "file": file, "name": "a", "subscripts": [], "at": [900.0, 5.0, 0.0]}
        found = await heard.ask(method, given | what)
        heard.session.leave()
        return found.get("result", found.get("error"))

    return asyncio.run(answer())


def test_the_edit_is_of_one_number_and_of_the_text_as_it_is() -> None:
    found = asked("vrts/moved")
    [edit] = found["edits"]
    assert edit["newText"] == "5.00"
    start, end = edit["range"]["start"], edit["range"]["end"]
    assert (start["line"], start["character"], end["character"]) == (4, 11, 15)
    assert (found["numbers"], found["line"]) == (["900.00", "5.00", "0.00"], 5)
    assert (found["uri"], found["version"]) == ("untitled:a.v2", 1)


def test_reach_is_told_in_the_scene_of_the_task(tmp_path: Path) -> None:
    program = setting(tmp_path)
    near = asked("vrts/reach", runs=True, program=program)
    assert near["reached"] is True
    assert near["text"].startswith("reachable; ")
    far = asked("vrts/reach", runs=True, program=program, at=[2900.0, 0.0, 0.0])
    assert (far["reached"], far["text"].startswith("not reachable: ")) == (False, True)


@pytest.mark.parametrize(
    "odd",
    [
        {"at": [1, 2]},
        {"at": [1, 2, True]},
        {"at": [1, 2, "3"]},
        {"at": None},
        {"name": ""},
        {"file": 5},
        {"subscripts": ["1"]},
        {"subscripts": None},
    ],
)
def test_odd_questions_are_refused(odd: dict[str, Any]) -> None:
    assert asked("vrts/moved", **odd)["message"].startswith("`vrts/moved`: ")


def test_what_cannot_be_moved_says_why() -> None:
    assert asked("vrts/moved", name="#p")["why"] == "`#p` has no X, Y and Z"
    assert "does not belong" in asked("vrts/moved", file="/etc/passwd")["why"]
    assert asked("vrts/reach", name="b")["reached"] is None


def test_write_protected_files_are_told(tmp_path: Path) -> None:
    path = tmp_path / "a.lc"
    assert unwritable(str(path)) == ""
    path.touch()
    assert unwritable(str(path)) == ""
    path.chmod(0o444)
    assert unwritable(str(path)) == "`a.lc` is write-protected"
