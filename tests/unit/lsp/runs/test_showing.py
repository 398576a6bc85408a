"""What is shown beside the text: the mark in short, its reasons, and the run to replay."""

import json
from pathlib import Path

from tests.places import ROOT
from vrts.lsp.channel.verification import Answer, Asked, answer_of, line_of
from vrts.lsp.runs.verifying import verify

EXAMPLE = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"


def shown(text: str, path: Path = EXAMPLE) -> Answer:
    told: list[Answer] = []
    verify(Asked(str(path), text, is_shown=True), told.append)
    return next(answer for answer in told if answer.shown is not None)


def test_the_mark_and_the_run_are_shown_and_come_through_the_pipe() -> None:
    answer = shown(EXAMPLE.read_text())
    assert answer_of(line_of(answer)) == answer
    found = answer.shown
    assert found is not None
    assert found.mark == "10.0 / 10"
    assert found.is_ready
    assert found.reasons == ()
    recording = json.loads(found.recording)
    assert recording["run"]["horizon"] > 5.0
    assert {row[1] for row in recording["run"]["lines"]} >= {5, 20}
    assert recording["scene"]["goals"]


def test_what_is_wrong_is_told_with_its_line() -> None:
    found = shown((EXAMPLE.parent / "submissions" / "hits-base.v2").read_text()).shown
    assert found is not None
    assert not found.is_ready
    assert found.reasons
    assert found.mark != "10.0 / 10"
    assert found.line > 0
    assert json.loads(found.recording)["contacts"]


def test_who_shows_nothing_gets_nothing() -> None:
    told: list[Answer] = []
    verify(Asked(str(EXAMPLE), EXAMPLE.read_text()), told.append)
    assert all(answer.shown is None for answer in told)
