"""Code lenses, and times of motions from runs in the background."""

import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_lsp import PATIENCE, Client
from tests.unit.lsp.begun import Begun
from vrts.lsp.answers.lenses import lenses
from vrts.lsp.channel.timing import Timing, hint
from vrts.lsp.channel.verification import Asked
from vrts.lsp.documents.documents import Document
from vrts.lsp.runs.verifying import verify
from vrts.pipeline.assess import assess
from vrts.pipeline.request import NO_CHECKS
from vrts.pipeline.requesting import request_for

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
LOOP = """.PROGRAM main
        READY
        FOR k = 1 TO 5
            DRIVE 1, 10, 50
            DRIVE 1, -10, 50
        END
.END
"""
ENDLESS = """.PROGRAM main
10      DRIVE 1, 10, 100
        DRIVE 1, -10, 100
        GOTO 10
.END
"""
NOWHERE = "/nowhere/a.v2"
WHOLE = {"start": {"line": 0, "character": 0}, "end": {"line": 999, "character": 0}}


def test_programs_that_can_be_executed_have_lenses() -> None:
    text = ".PROGRAM main\n.END\n.PROGRAM put(n)\n.END\n.PROGRAM other\n.END\n"
    found = [(lens.title, lens.command, lens.entry) for lens in lenses(Document("/c/a.v2", text))]
    assert found == [
        ("run", "vrts.run", "main"),
        ("debug", "vrts.debug", "main"),
        ("verify", "vrts.verify", "main"),
        ("run", "vrts.run", "other"),
        ("debug", "vrts.debug", "other"),
        ("verify", "vrts.verify", "other"),
    ]


def timings(path: str, text: str, *others: tuple[str, str]) -> tuple[Timing, ...]:
    return verify(Asked(path, text, others)).timings


def test_times_are_those_of_the_run() -> None:
    path = EXAMPLE / "solution.v2"
    found = timings(str(path), path.read_text("utf-8"))
    run = assess(request_for(path, checks=NO_CHECKS)).run
    assert run is not None
    last = max(run.motions, key=lambda motion: motion.end_s)
    assert sum(timing.times for timing in found) == len(run.motions)
    by_line = {timing.line: timing for timing in found}
    told = by_line[last.cause.span.line]
    if told.times <= len(told.ends_s):
        assert told.ends_s[-1] == pytest.approx(last.end_s - run.started_s)
    judgement = assess(request_for(path)).judgement
    assert judgement is not None
    near = [timing.clearance_mm for timing in found if timing.clearance_mm is not None]
    collisions = judgement.collisions
    assert collisions is not None
    assert collisions.clearance is not None
    certified = collisions.clearance
    assert min(near) >= 1000 * (certified.distance_m - certified.tolerance_m)
    assert min(near) <= 1000 * certified.distance_m + 5  # and samples come near to it
    assert hint(Timing(3, (4.1,), 1.0, 1, 12.4)) == "4.1 s, 12 mm"


def test_repeated_motions_tell_the_first_times() -> None:
    ready, there, back = timings(NOWHERE, LOOP)
    assert (ready.line, ready.times) == (2, 1)
    assert (there.times, back.times) == (5, 5)
    assert len(there.ends_s) == 3
    assert ready.ends_s[0] <= there.ends_s[0] <= back.ends_s[0] <= there.ends_s[1]
    assert hint(Timing(2, (1.0, 2.25), 1.0, 2)) == "1.0, 2.2 s"
    assert hint(there).endswith(" ... s")


@pytest.mark.parametrize("text", ["", ".PROGRAM main\n        MOVEE a\n.END\n", "nonsense"])
def test_what_does_not_compile_has_no_times(text: str) -> None:
    assert timings(NOWHERE, text) == ()


def test_programs_of_other_files_are_called() -> None:
    text = ".PROGRAM main\n        CALL put\n        READY\n.END\n"
    other = ".PROGRAM put\n        DRIVE 1, 10, 50\n.END\n"
    (found,) = timings(NOWHERE, text, ("/nowhere/b.v2", other))
    assert found.line == 3


def hints(client: Client, name: str) -> list[dict[str, Any]]:
    return client.about("inlayHint", name, range=WHOLE)


def refreshed(client: Client, name: str) -> list[dict[str, Any]]:
    """Return the hints of a buffer as soon as the server says that there are some."""
    while not (found := hints(client, name)):
        client.said_next("workspace/inlayHint/refresh")
    return found


@pytest.mark.thorough
def test_over_the_protocol(tmp_path: Path) -> None:
    shutil.copy(EXAMPLE / "solution.v2", tmp_path / "a.v2")
    with Client(tmp_path) as client:
        client.open("a.v2", LOOP)  # not what the file on disk holds
        assert hints(client, "a.v2") == []  # not yet: answers never wait
        found = refreshed(client, "a.v2")
        assert [h["position"] for h in found] == [
            {"line": line, "character": len(LOOP.split("\n")[line])} for line in (1, 3, 4)
        ]
        assert found[1]["label"] == hint(timings(NOWHERE, LOOP)[1])
        assert "moves the arm 5 times" in found[1]["tooltip"]

        found = client.about("codeLens", "a.v2")
        assert found[0]["command"] == {
            "title": "run",
            "command": "vrts.run",
            "arguments": [client.uri("a.v2"), "main"],
        }

        client.change("a.v2", ENDLESS)
        assert hints(client, "a.v2") == []
        assert client.about("hover", "a.v2", (1, 10))["contents"]["value"]  # while it runs
        assert len(refreshed(client, "a.v2")) == 2


@pytest.mark.thorough
def test_no_run_outlives_its_client(tmp_path: Path) -> None:
    with Begun(tmp_path / "begun") as begun:
        client = Client(tmp_path, server=begun.server)
        client.open("a.v2", ENDLESS)
        hints(client, "a.v2")
        run = begun.next()
        client.gone()
        run.wait(PATIENCE)
