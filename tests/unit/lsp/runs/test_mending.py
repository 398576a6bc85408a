"""A change that earns the full mark is looked for when it is asked for, and shown beforehand."""

from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_lsp import Client, where
from vrts.lsp.channel.mend import NOTHING, Mend, line_of_mend, mend_of
from vrts.lsp.channel.verification import Asked
from vrts.lsp.runs.mending import mend
from vrts.lsp.server.searching import SEARCH

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
TEXT = (EXAMPLE / "submissions" / "forgets-openi.v2").read_text("utf-8")
TASK = (EXAMPLE / "task.toml").read_text("utf-8")
LINE = "        CLOSEI"


def with_hints(folder: Path, level: str) -> Path:
    (folder / "task.toml").write_text(f'{TASK}\n[hints]\nlevel = "{level}"\n')
    return folder / "prog.v2"


def test_what_was_found_comes_back_from_its_line() -> None:
    found = mend_of(line_of_mend(Mend("said", "future", ())))
    assert found == Mend("said", "future", ())
    assert mend_of(b"") == NOTHING


def test_where_there_is_no_task_nothing_is_looked_for(tmp_path: Path) -> None:
    assert mend(Asked(str(tmp_path / "prog.v2"), TEXT)) == NOTHING


@pytest.mark.thorough
def test_the_change_is_told_with_what_comes_of_it() -> None:
    found = mend(Asked(str(EXAMPLE / "prog.v2"), TEXT))
    assert found.future.startswith("10 of 10 instead of 2.8, in ")
    assert "mm from everything" in found.future
    assert [edit.text.strip() for edit in found.edits] == ["OPENI"]


@pytest.mark.thorough
@pytest.mark.parametrize("level", ["nothing", "place", "direction", "number"])
def test_a_task_that_allows_less_gets_no_edit(tmp_path: Path, level: str) -> None:
    found = mend(Asked(str(with_hints(tmp_path, level)), TEXT))
    assert found.edits == ()
    assert found.future == ""
    assert "OPENI" not in found.said


def offered(client: Client) -> list[dict[str, Any]]:
    line, _ = where(TEXT, LINE)
    span = {"start": {"line": line, "character": 8}, "end": {"line": line, "character": 9}}
    found = client.about("codeAction", "prog.v2", range=span, context={"diagnostics": []})
    return [action for action in found if action["title"] == SEARCH]


def lenses(client: Client) -> list[str]:
    return [lens["command"]["title"] for lens in client.about("codeLens", "prog.v2")]


@pytest.mark.thorough
def test_an_action_has_its_edit_when_it_was_chosen_and_shown(tmp_path: Path) -> None:
    (tmp_path / "task.toml").write_text(TASK)
    with Client(tmp_path) as client:
        client.open("prog.v2", TEXT)
        client.said_next("workspace/inlayHint/refresh")
        while not (found := offered(client)):
            client.said_next("workspace/inlayHint/refresh")
        (action,) = found
        assert action.get("edit") is None, "nothing is worked out before it is chosen"
        assert any(title.startswith("why -") and "OPENI" not in title for title in lenses(client))
        made = client.do("codeAction/resolve", **action)
        shown = client.said_next("window/showMessageRequest")
        assert shown["message"].startswith("10 of 10 instead of 2.8, in ")
        (edits,) = made["edit"]["changes"].values()
        assert [edit["newText"].strip() for edit in edits] == ["OPENI"]


@pytest.mark.thorough
def test_a_task_without_hints_has_neither_action_nor_lens(tmp_path: Path) -> None:
    with_hints(tmp_path, "nothing")
    with Client(tmp_path) as client:
        client.open("prog.v2", TEXT)
        for _ in range(3):  # times, contacts, all
            client.said_next("workspace/inlayHint/refresh")
        assert offered(client) == []
        assert not any(title.startswith("why") for title in lenses(client))
