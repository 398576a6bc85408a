"""What the browser gets of a run: polynomials, placements, lines and events, not samples."""

import base64
import json
import zlib
from array import array
from bisect import bisect_right
from itertools import accumulate, pairwise

import numpy as np
import pytest

from tests.places import ROOT
from tests.support_runs import scene, with_segments
from tests.support_segments import blend, sampled, segment, slowed
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import compile_source
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.page.page import page
from vrts.report.page.replay_data import MOST_EVENTS, run_data, segment_data
from vrts.report.page.viewer_data import scene_data, scene_text
from vrts.report.screen.assessment_text import assessment_text
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


def sent_rows(segments: dict[str, str]) -> "list[array[float]]":
    """Return the coefficients of every polynomial, in powers of the share that has passed."""
    coefficients = numbers(segments["coefficients"], "f")
    ends = list(accumulate(zlib.decompress(base64.b64decode(segments["counts"]))))
    assert ends[-1] == len(coefficients)
    return [coefficients[a:b] for a, b in pairwise([0, *ends])]


def test_the_segments_give_back_every_configuration(run: Run) -> None:
    segments = json.loads(json.dumps(run_data(run, PROGRAM)))["segments"]
    knots, rows = numbers(segments["knots"], "d"), sent_rows(segments)
    assert len(rows) == 7 * (len(knots) - 1)
    assert (knots[0], knots[-1]) == (0.0, run.horizon_s)
    for k in range(101):
        t = run.horizon_s * k / 100
        at = bisect_right(knots, t, hi=len(knots) - 1) - 1
        share = (t - knots[at]) / (knots[at + 1] - knots[at])
        state = run.at(t)
        expected = (*state.configuration, state.hand_opening)
        for row, value in zip(rows[7 * at : 7 * at + 7], expected, strict=True):
            assert value_at(row, share) == pytest.approx(value, abs=2e-6)


def value_at(row: "array[float]", share: float) -> float:
    return sum(c * share**power for power, c in enumerate(row))


def test_rows_have_the_coefficients_they_need() -> None:
    stopping = slowed(blend(0.3, -2.0, 1.0, 0.5), 1.0, -0.5)
    pieces = (
        segment((0.5, 0.0), (0.0, 0.0, 3.0, -2.0, 0.0)),
        segment(blend(0.3, 1.0, -2.0, 0.5), stopping, start_s=1.0, length=0.5),
    )
    segments = json.loads(json.dumps(run_data(with_segments(*pieces), None)))["segments"]
    assert segments == segment_data(pieces), "the arrays of a run say the same as its segments"
    rows = sent_rows(segments)
    assert [len(row) for row in rows] == [1, 4, *[1] * 5, 5, 9, *[1] * 5]
    for share in (0.0, 0.3, 0.8, 1.0):
        for row, k in ((rows[7], 0), (rows[8], 1)):
            u = np.array([0.5 * share])
            exact = float(sampled(pieces[1].coefficients[k], u)[0])
            assert value_at(row, share) == pytest.approx(exact, abs=1e-6)


def test_a_very_short_segment_of_degree_8_stays_within_single_precision() -> None:
    row = tuple(0.1 / 1e-5**power for power in range(9))  # up to 1e39
    segments = run_data(with_segments(segment(row, length=1e-5)), None)["segments"]
    (sent, *_) = sent_rows(json.loads(json.dumps(segments)))
    assert value_at(sent, 1.0) == pytest.approx(0.9, abs=1e-6)


def test_a_scene_that_is_kept_as_text_has_the_goals_of_the_task_that_is_asked_about() -> None:
    asked = load_task(ROOT / "examples" / "01-cans-on-bases" / "task.toml")
    assert json.loads(scene_text(asked.scene, None))["goals"] == []
    for _ in range(2):
        told = json.loads(scene_text(asked.scene, asked.task))
        assert told == json.loads(json.dumps(scene_data(asked.scene, asked.task)))
        assert told["goals"]


def test_the_line_at_work_is_that_of_the_motion(run: Run) -> None:
    lines = run_data(run, PROGRAM)["lines"]
    assert isinstance(lines, list)
    order = [line for _, line in lines]  # pyright: ignore[reportUnknownVariableType]
    assert order == [2, 4, 6]  # TYPE prints as the second motion starts


def test_lines_of_another_file_are_not_lit(run: Run) -> None:
    assert run_data(run, SourceFile("b.v2", "x"))["lines"] == []


def test_a_whole_page_is_small(run: Run) -> None:
    a = Assessment("a", "a.v2", PROGRAM, (), run.module, run.scene, None, run)
    html = page(a, {})
    assert len(html.encode()) < 2_000_000
    assert html.count("</script>") == 3
    assert assessment_text(a, color=False).startswith("a.v2: completed")


def test_a_program_that_prints_without_end_still_gives_a_short_list() -> None:
    source = SourceFile(
        "a.v2", ".PROGRAM a()\n n = 0\n10 n = n+1\n TYPE n\n WAIT\n GOTO 10\n.END\n"
    )
    compilation = compile_source(source)
    assert compilation.module is not None, compilation.diagnostics
    scenario = Scenario(limits=Limits(time_s=120.0))
    events = run_data(execute(compilation.module, scene(), scenario), source)["events"]
    assert isinstance(events, list)
    assert len(events) == MOST_EVENTS + 1  # pyright: ignore[reportUnknownArgumentType]
    assert "more events are not listed" in str(events[-1])  # pyright: ignore[reportUnknownArgumentType]
