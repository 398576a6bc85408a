"""No line is better than a wrong one: what an object that is not in place is put down to."""

import pytest

from tests.places import ROOT
from tests.support_programs import cans, compiled
from vrts.check.collision.in_words import verdict as in_words
from vrts.check.mark.reasons import reasons
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.formats.json_form import assessment_json
from vrts.report.screen.assessment_text import assessment_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
FIRST, SECOND = (
    "        CALL carry(can1_grip, base2_put)\n",
    "        CALL carry(can2_grip, base1_put)\n",
)
BODIES = ("can1", "can2")


def run_of(*changes: tuple[str, str]) -> Run:
    text = SOLUTION
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return execute(compiled(text), cans())


def lines(run: Run) -> dict[str, int]:
    """Return the lines that objects are put down to; 0 where there is none."""
    found = reasons(run, BODIES)
    return {body: event.cause.span.line if event.cause else 0 for body, event in found.items()}


def marked(text: str) -> Assessment:
    return assess(Request(ProgramFile(text.encode(), "a.v2"), load_task(EXAMPLE)))


@pytest.mark.parametrize("y", ["-250.00", "-380.00"])
def test_a_can_that_was_never_attempted_is_not_put_down_to_the_grip_of_another(y: str) -> None:
    run = run_of(
        (SECOND, ""), ("can1_grip         800.00  -450.00", f"can1_grip         800.00  {y}")
    )
    assert list(lines(run)) == ["can1"]


def test_nothing_is_said_of_a_can_that_nobody_attempts() -> None:
    assert lines(run_of((SECOND, ""))) == {}
    (loss, _) = marked(SOLUTION.replace(SECOND, "")).grade.losses  # type: ignore[union-attr]
    assert loss.sentence.startswith("`can2` was never picked up")
    assert loss.span is None


def test_closing_twice_at_one_place_is_one_attempt() -> None:
    far = "can1_grip         -500.00  -700.00"
    run = run_of((SECOND, FIRST), ("can1_grip         800.00  -450.00", far))
    assert "can2" not in lines(run)


def test_two_attempts_far_from_both_cans_are_theirs_in_turn() -> None:
    text = (EXAMPLE / "submissions" / "x-and-y-swapped.v2").read_text("utf-8")
    assert lines(execute(compiled(text), cans())) == {"can1": 8, "can2": 16}


def test_what_was_mended_later_is_no_reason() -> None:
    """Missed by the pads once, then grasped, and put down beside the base: the miss is over."""
    again = "        CALL carry(beside, base2_put)\n" + FIRST
    run = run_of(
        (FIRST, again),
        (
            ".LOCATIONS\n",
            ".LOCATIONS\nbeside            800.00  -432.00  -225.00    90.00    90.00     0.00\n",
        ),
        ("1100.00   230.00", "1115.00   230.00"),
    )
    assert "can1" not in lines(run)


def test_what_a_held_can_hits_is_not_told_as_the_robots() -> None:
    a = marked(SOLUTION.replace("DEPARTS 200  ", "DEPARTS 20  "))
    assert a.judgement is not None
    report = a.judgement.collisions
    assert report is not None
    held = [c for c in report.contacts if c.held is not None and c.parts[0] == c.held]
    assert held
    for finding, contact in zip(in_words(report).findings, report.contacts, strict=False):
        assert finding.moment is not None
        if contact in held:
            assert finding.headline.startswith("the held `can")
            assert finding.moment.bodies == (contact.held, contact.second)
    told: list[list[str]] = [
        c["bodies"]
        for c in assessment_json(a)["collisions"]["contacts"]  # type: ignore[index,union-attr]
    ]
    assert [bodies[0] for bodies in told] == [
        c.held if c in held else c.first for c in report.contacts
    ]
    text = assessment_text(a, color=False)
    for block in text.split("error[V400")[1:]:
        if block.startswith(" contact]: the held `can1` hits"):
            assert "robot and" not in block.split("error[")[0]


def test_a_goal_that_was_reached_needs_no_reason() -> None:
    found = marked(SOLUTION)
    assert found.judgement is not None
    assert all(v.answer is Answer.HOLDS for v in found.judgement.verdicts)
