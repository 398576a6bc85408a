"""What the browser gets of a run: polynomials, placements, lines and events, not samples."""

import base64
import json
import zlib
from array import array
from bisect import bisect_right

import pytest

from tests.support_runs import scene
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import compile_source
from vrts.report.assessment import Assessment
from vrts.report.page import page
from vrts.report.replay_data import MOST_EVENTS, run_data
from vrts.report.text import assessment_text
from vrts.scene.model import Limits, Scenario

PROGRAM = SourceFile(
    "a.v2",
    """.PROGRAM main()
    OPENI
    SET spot = TRANS(800, -450, -100, 90, 90, 0)
    MOVE spot
    IF 1 THEN
        MOVES SHIFT(spot BY 0, 0, -50)
    END
    TYPE "</script>"
.END
""",
)


@pytest.fixture(scope="module")
def run() -> Run:
    compilation = compile_source(PROGRAM)
    assert compilation.module is not None, compilation.diagnostics
    return execute(compilation.module, scene())


def numbers(text: object, kind: str) -> "array[float]":
    assert isinstance(text, str)
    return array(kind, zlib.decompress(base64.b64decode(text)))


def test_the_segments_give_back_every_configuration(run: Run) -> None:
    segments = json.loads(json.dumps(run_data(run, PROGRAM)))["segments"]
    knots = numbers(segments["knots"], "d")
    coefficients = numbers(segments["coefficients"], "f")
    assert len(coefficients) == 28 * (len(knots) - 1)
    assert (knots[0], knots[-1]) == (0.0, run.horizon_s)
    for k in range(101):
        t = run.horizon_s * k / 100
        at = bisect_right(knots, t, hi=len(knots) - 1) - 1
        u = t - knots[at]
        state = run.at(t)
        expected = (*state.configuration, state.hand_opening)
        for row, value in enumerate(expected):
            first = 28 * at + 4 * row
            sent = sum(c * u**power for power, c in enumerate(coefficients[first : first + 4]))
            assert sent == pytest.approx(value, abs=2e-6)


def test_the_line_at_work_is_that_of_the_motion(run: Run) -> None:
    lines = run_data(run, PROGRAM)["lines"]
    assert isinstance(lines, list)
    order = [line for _, line in lines]  # pyright: ignore[reportUnknownVariableType]
    assert order == [2, 4, 6, 9]  # TYPE prints while the arm moves


def test_lines_of_another_file_are_not_lit(run: Run) -> None:
    assert run_data(run, SourceFile("b.v2", "x"))["lines"] == []


def test_a_whole_page_is_small(run: Run) -> None:
    a = Assessment("a", "a.v2", PROGRAM, (), run.module, run.scene, None, run)
    html = page(a, {})
    assert len(html.encode()) < 2_000_000
    assert html.count("</script>") == 3
    assert assessment_text(a, color=False).startswith("a.v2: completed")


def test_a_program_that_prints_without_end_still_gives_a_short_list() -> None:
    source = SourceFile("a.v2", '.PROGRAM a()\n10 TYPE "x"\n WAIT\n GOTO 10\n.END\n')
    compilation = compile_source(source)
    assert compilation.module is not None, compilation.diagnostics
    scenario = Scenario(limits=Limits(time_s=120.0))
    events = run_data(execute(compilation.module, scene(), scenario), source)["events"]
    assert isinstance(events, list)
    assert len(events) == MOST_EVENTS + 1  # pyright: ignore[reportUnknownArgumentType]
    assert "more events are not listed" in str(events[-1])  # pyright: ignore[reportUnknownArgumentType]
