"""The value that would do is told at its place, and no more of it than the task allows."""

from pathlib import Path

import pytest

from tests.places import ROOT
from tests.unit.debug.editing.test_text import opened_session
from tests.unit.debug.scripted.test_commands import refused, said, session
from vrts.debug.conditions.hearing import Interrupted
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.editing import EDITING
from vrts.debug.dap.session import Session as Client
from vrts.debug.files import Files
from vrts.debug.scripted.session import Session

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"


def mistaken(folder: Path, hints: str = "") -> Session:
    """Return a session of a program with a slip in the row of `base2_put`."""
    for file in EXAMPLE.iterdir():
        if file.is_file():
            (folder / file.name).write_bytes(file.read_bytes())
    if hints:
        task = folder / "task.toml"
        text = task.read_text(encoding="utf-8")
        task.write_text(f'{text}\n[hints]\nlevel = "{hints}"\n', encoding="utf-8")
    path = folder / "solution.v2"
    text = path.read_text(encoding="utf-8")
    assert "1100.00   230.00" in text
    path.write_text(text.replace("1100.00   230.00", "1100.00   203.00"), encoding="utf-8")
    return opened_session(path)


def test_the_value_is_found_at_its_place_and_at_no_other(tmp_path: Path) -> None:
    s = mistaken(tmp_path)
    assert said(s, "would base2_put") == "one change away: 10 with line 28: `230` for `203.00`"
    client = Client(s.debugger, s.console, Files([]))
    answer = EDITING["vrts/would"](client, Fields({"line": 19}))
    assert "no other value in line 19 alone" in answer.body["said"]


def test_what_is_no_literal_is_refused(tmp_path: Path) -> None:
    s = mistaken(tmp_path, "nothing")
    assert "no literal gives" in refused(s, "would nosuch")
    assert "takes a name, or a line" in refused(s, "would")
    assert refused(s, "would base2_put") == "the task allows no hints"
    assert "saved run" in refused(session(tmp_path), "would n")


@pytest.mark.thorough
@pytest.mark.parametrize("hints", ["place", "direction", "number"])
def test_no_more_is_told_than_the_task_allows(tmp_path: Path, hints: str) -> None:
    s = mistaken(tmp_path, hints)  # two digits of a row changed places: that has no direction
    assert said(s, "would base2_put") == "look at line 28"


def test_a_search_is_ended_by_who_wants_no_answer_any_more(tmp_path: Path) -> None:
    s = mistaken(tmp_path)
    before = s.debugger.run, s.debugger.at
    heard: list[int] = []

    def hear() -> None:
        heard.append(1)
        if len(heard) == 3:
            raise Interrupted

    s.debugger.hear = hear
    with pytest.raises(Interrupted):
        EDITING["vrts/would"](Client(s.debugger, s.console, Files([])), Fields({"line": 19}))
    assert len(heard) == 3
    assert (s.debugger.run, s.debugger.at) == before
