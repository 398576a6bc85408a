"""A fault in LinuxCNC's own configuration is found from its log, and its lab explains the log."""

import numpy as np
import pytest

from tests.unit.dispatch.rehearsing.faulty import CASES, Case, carried_out, log_of
from tests.unit.dispatch.rehearsing.test_rehearsals import required
from vrts.base.source import SourceFile
from vrts.base.units import DEG
from vrts.engine.controller import execute
from vrts.engine.memory.events import ProgramStarted
from vrts.pipeline.files import CHECKOUT
from vrts.scene.reading.scene_file import read_scene_in_lab
from vrts.validate.identified_files import identified_lab
from vrts.validate.identify.identify import identify_log
from vrts.validate.reports.identified_text import sentence

NAMES = ("zero of joint 3", "link d4")  # in HAL; in the library and genserkins' parameters


def case_named(name: str) -> Case:
    (found,) = [case for case in CASES if case.name == name]
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("name", NAMES)
def test_it_is_named_first_and_the_lab_explains_the_log(name: str) -> None:
    required()
    case = case_named(name)
    run, samples = carried_out(case)
    log = log_of(samples, 3)
    found = identify_log(run, log)
    first = found.numbers[0]
    assert first.cause == case.cause, sentence(found)
    assert abs(first.value - case.true) <= 2.0 * max(first.half, 1e-9)
    assert found.fits
    scene = CHECKOUT / "scenes" / "one-can-puma560" / "scene.toml"
    laid, told, _ = read_scene_in_lab(
        SourceFile("scene.toml", scene.read_text()),
        SourceFile("lab.toml", identified_lab(found)),
        scene.parent,
        None,
    )
    assert laid is not None, told
    started = next(e for e in run.events if isinstance(e, ProgramStarted) and not e.process)
    other = execute(run.module, laid, run.scenario, started.program)
    again = identify_log(other, log)
    assert [n.cause for n in again.numbers if n.cause == case.cause] == []
    before, after = (
        float(np.sqrt(sum(r.before**2 for r in one.remaining))) / DEG for one in (found, again)
    )
    print(f"{name}: {before:.4f} deg of all joints without the lab, {after:.4f} with it")
    assert after < 0.5 * before
