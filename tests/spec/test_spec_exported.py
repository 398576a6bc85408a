"""Every program of the execution chapters, in other languages: refused with a reason, or the same.

The same is: every motion, signal and program event at the same time, and the same text typed.
"""

from collections import Counter

import pytest

from tests.spec.test_spec_run import Case, cases, compiled_case, happened, ran, ran_module, typed
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.dispatch.posts.export import LANGUAGES
from vrts.dispatch.posts.expressions_anew import Settled
from vrts.dispatch.posts.same_motion import difference
from vrts.dispatch.posts.written import Written, written
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.scene.default import robot_alone

CASES = [case for case in cases() if case.dialect.name in LANGUAGES]
REFUSED = {"val2": 17, "vplus": 24, "as": 56}  # cases, at most; each reason has a test of its own
# and beside these, exactly, what the manuals of these languages do not have or leave to the cell
LACKING = {
    "val2": {},
    "vplus": {"GRASP": 2},
    "as": {"GRASP": 2, "SCALE": 1, "WAIT without a condition": 6},
}


def exported(case: Case, target: str) -> Written:
    """Return a program in another language, or what it was refused for."""
    ready = robot_alone(case.robot).robot.arm.ready
    found = written(compiled_case(case), target, Settled(tuple(map(deg, ready))))
    errors = [d for d in found.diagnostics if d.is_error]
    assert all(d.primary is not None and d.help for d in errors)
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("target", sorted(REFUSED))
def test_programs_are_the_same_in_another_language(target: str) -> None:
    refused, lacking = 0, Counter[str]()
    for case in CASES:
        text, told = exported(case, target)
        errors = [d.headline.partition("nothing that means ")[2] for d in told if d.is_error]
        if errors and errors[0] in LACKING[target]:
            lacking[errors[0]] += 1
            continue
        if errors:
            refused += 1
            continue
        again = compile_source(SourceFile("other", text), Options(DIALECTS[target]))
        assert again.module is not None, (case.name, text, again.diagnostics[0].headline)
        one, other = ran(case), ran_module(case, again.module)
        apart = difference(one, other)
        if told and not apart.is_none:  # what was left out mattered here, and so it is found
            refused += 1
            continue
        assert apart.is_none, (case.name, text)
        if "GRASP" in case.program and "error" in case.expected:
            continue  # where the hand is empty the program says so itself, and halts
        assert typed(one) == typed(other), (case.name, text)
        assert happened(one) == happened(other), (case.name, text)
    print(f"{target}: {refused} of {len(CASES)} refused")
    assert refused <= REFUSED[target]
    assert lacking == LACKING[target]
