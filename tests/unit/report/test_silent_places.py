"""Where a task allows no hints, debugger, rehearsal and marked session tell no remedy either."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.unit.live.rehearsing.support import Questions
from vrts.debug.alarms import Filter
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.seeing import SEEING
from vrts.debug.dap.session import Session
from vrts.debug.opening import Asked, opened
from vrts.live.logs.session_marker import assessed, entries_to_bytes
from vrts.live.rehearsing.told import Ready, Refused
from vrts.marking.proposer.by_name import ALONE
from vrts.marking.submission.one import Order, Wanted
from vrts.pipeline.settings import load_task
from vrts.pipeline.where import Where

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
WRONG = EXAMPLE / "submissions" / "undefined-location.v2"  # compiles, and stops with an error
UNREAD = ".PROGRAM main()\n  MOOVE a\n.END\n"


@pytest.fixture(params=["nothing", "edit"])
def task(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Path, bool]:
    """Return a task, and whether it allows hints."""
    shutil.copytree(EXAMPLE, tmp_path / "lab", ignore=shutil.ignore_patterns("submissions"))
    path = tmp_path / "lab" / "task.toml"
    with path.open("a", encoding="utf-8") as file:
        file.write(f'\n[hints]\nlevel = "{request.param}"\n')
    return path, request.param == "edit"


def test_the_debugger_of_an_editor(task: tuple[Path, bool]) -> None:
    found = opened(Asked(WRONG, Where(task=task[0])))
    assert found.debugger is not None
    assert found.console is not None
    session = Session(found.debugger, found.console, found.files)
    session.debugger.wishes.filters = frozenset({Filter.ERROR})
    session.debugger.go_on()
    told = SEEING["exceptionInfo"](session, Fields({})).body
    assert ("help:" in told["details"]["stackTrace"]) == task[1]
    assert told["details"]["message"]


def test_a_rehearsal(task: tuple[Path, bool]) -> None:
    questions = Questions(task[0])
    ready = questions.rehearse(WRONG.read_text("utf-8"))
    assert isinstance(ready, Ready)
    refused = questions.rehearse(UNREAD)
    assert isinstance(refused, Refused)
    for rows in (ready.problems, refused.problems):
        assert rows
        assert any(row.help for row in rows) == task[1]


def test_a_marked_session(task: tuple[Path, bool]) -> None:
    order = Order("s", "s", entries_to_bytes(()))
    found = assessed(order, load_task(task[0]), Wanted(pages=False), ALONE)
    assert found.grade is not None
    assert any(loss.hint for loss in found.grade.losses) == task[1]
    assert found.grade.losses
