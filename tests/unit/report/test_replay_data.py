"""What the browser gets of a run: polynomials, placements, lines and events, not samples."""

import base64
import json
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
from vrts.report.replay_data import run_data
from vrts.report.text import assessment_text

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
    return array(kind, base64.b64decode(text))


def test_the_segments_give_back_every_configuration(run: Run) -> None:
    segments = json.loads(json.dumps(run_data(run, PROGRAM)))["segments"]
    starts = numbers(segments["starts"], "d")
    ends = numbers(segments["ends"], "d")
    coefficients = numbers(segments["coefficients"], "f")
    assert len(coefficients) == 28 * len(starts)
    assert list(starts[1:]) == list(ends[:-1]), "gaps"
    assert ends[-1] == run.horizon_s
    for k in range(101):
        t = run.horizon_s * k / 100
        at = bisect_right(starts, t) - 1
        u = min(t, ends[at]) - starts[at]
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
