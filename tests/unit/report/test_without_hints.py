"""Where a task allows no hints, no report tells a remedy: only what is wrong, and where."""

from dataclasses import replace

import pytest

from tests.places import ROOT
from vrts.check.rules.hints import Hints
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
CASES = ("releases-in-air", "undefined-location", "endless-loop", "syntax-error")


def assessed(name: str, hints: Hints) -> Assessment:
    setting = load_task(EXAMPLE)
    assert setting.task is not None
    setting = replace(setting, task=replace(setting.task, hints=hints))
    data = (EXAMPLE / "submissions" / f"{name}.v2").read_bytes()
    return assess(Request(ProgramFile(data, f"{name}.v2"), setting))


@pytest.mark.parametrize("name", CASES)
def test_what_is_wrong_stays_and_what_would_mend_it_goes(name: str) -> None:
    told, silent = assessed(name, Hints.EDIT), assessed(name, Hints.NOTHING)
    assert any(d.help for d in told.findings)
    assert first_screen(told).hint
    assert not any(d.help or d.fix for d in silent.findings)
    assert first_screen(silent).hint is None
    assert first_screen(silent).cause == first_screen(told).cause
    assert [d.headline for d in silent.findings] == [d.headline for d in told.findings]
    assert silent.grade is not None
    assert told.grade is not None
    assert silent.grade.mark == told.grade.mark
    assert not any(loss.hint for loss in silent.grade.losses)
