"""The words of the collision check."""

from types import MappingProxyType

import numpy as np
import pytest

from tests.collision_runs import TEXT, Line, Record, Story, down, fixed, movable, scene_of
from tests.support_segments import blend, sampled, segment, slowed
from vrts.base.diagnostic import Severity
from vrts.base.pose import IDENTITY
from vrts.base.source import Span
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.in_words import verdict
from vrts.check.verdict import Answer, Clearance, CollisionReport, ContactEvent
from vrts.engine.memory.events import Cause
from vrts.geometry.shapes import Box, Cylinder, Piece

CAUSE = Cause("main", 1, Span(TEXT, 0, 4))


def event(**changes: object) -> ContactEvent:
    known = ContactEvent(
        first="robot",
        second="base1",
        parts=("can1", "base1"),
        start_s=12.4,
        end_s=12.9,
        deepest_s=12.6,
        depth_m=0.0052,
        point=(0.9, 0.0, -0.2),
        held="can1",
        cause=CAUSE,
    )
    return known._replace(**changes)  # type: ignore[arg-type]


def report(
    contacts: tuple[ContactEvent, ...] = (),
    grazes: tuple[ContactEvent, ...] = (),
    undetermined: tuple[ContactEvent, ...] = (),
    clearance: Clearance | None = None,
) -> CollisionReport:
    return CollisionReport(
        contacts, grazes, undetermined, clearance, not undetermined, MappingProxyType({"levels": 3})
    )


@pytest.mark.parametrize(
    ("found", "code", "headline"),
    [
        (event(), "V400", "the held `can1` hits `base1`"),
        (event(parts=("palm", "can1"), second="can1"), "V400", "the palm hits `can1`"),
        (
            event(parts=("left finger", "base"), second="robot", held=None),
            "V401",
            "the left finger hits the base",
        ),
        (
            event(first="can2", parts=("can2", "base1"), held=None),
            "V402",
            "the falling `can2` hits `base1`",
        ),
    ],
)
def test_a_contact_names_both_sides(found: ContactEvent, code: str, headline: str) -> None:
    answer = verdict(report((found,)))
    assert answer.answer is Answer.VIOLATED
    (finding,) = answer.findings
    assert finding.rule.code == code
    assert finding.headline == headline
    assert finding.severity is Severity.ERROR
    assert finding.primary is not None
    assert finding.primary.span == CAUSE.span
    assert finding.primary.text == "at 12.40 s, up to 5.2 mm deep"
    assert finding.help
    assert finding.moment is not None
    assert finding.moment.time_s == 12.6
    assert finding.data["depth_mm"] == pytest.approx(5.2)


def test_without_a_cause_the_time_stands_in_a_note() -> None:
    (finding,) = verdict(report((event(cause=None),))).findings
    assert finding.primary is None
    assert finding.notes == ("at 12.40 s, up to 5.2 mm deep",)


def test_grazes_and_open_questions_cost_nothing() -> None:
    grazing = verdict(report(grazes=(event(depth_m=1e-4),)))
    assert grazing.answer is Answer.HOLDS
    assert [d.rule.code for d in grazing.findings] == ["V410"]
    assert not grazing.findings[0].is_error
    unclear = verdict(report(undetermined=(event(depth_m=2e-4),)))
    assert unclear.answer is Answer.UNDETERMINED
    assert [d.rule.code for d in unclear.findings] == ["V420"]


def test_the_summary_tells_the_nearest_miss() -> None:
    near = Clearance(0.0123, 1e-4, 3.5, ("left finger", "can1"), ((0, 0, 0), (0, 0, 0.0123)))
    answer = verdict(report(clearance=near))
    assert answer.summary == (
        "no contact at any instant; nearest 12.3 mm, left finger and can1 at 3.50 s"
    )
    assert answer.evidence["clearance_mm"] == pytest.approx(12.3)
    assert answer.evidence["levels"] == 3


def test_a_run_gives_findings_their_configuration() -> None:
    block = fixed("block", Piece(Box((0.05, 0.2, 0.05)), IDENTITY), at=(0.9, 0.0, -0.3))
    story = Story(scene_of(block), (0.0, -1.0, 1.5, 0.0, 1.0, 0.0), 0.07)
    story.q = story.solved(down(0.9, 0.0, -0.1))
    story.line(down(0.9, 0.0, -0.26))
    run = story.record()
    (finding,) = verdict(check_collisions(story.scene, run), run).findings
    assert finding.moment is not None
    assert finding.moment.configuration == pytest.approx((*story.q, 0.07), abs=1e-3)


def test_the_configuration_of_a_finding_takes_all_coefficients() -> None:
    stopping = slowed(blend(0.3, -2.0, 1.0, 1.0), 1.0, -0.5)
    pieces = (segment((0.3,)), segment(stopping, start_s=1.0))
    run = Record(Line(pieces), (), (), {})
    (finding,) = verdict(report((event(deepest_s=1.9),)), run).findings
    assert finding.moment is not None
    first, *others = finding.moment.configuration
    assert first == pytest.approx(float(sampled(stopping, np.array([0.9]))[0]), abs=1e-12)
    assert others == [0.1] * 6


def test_a_hand_that_is_too_narrow_is_told_to_look_at_the_hand() -> None:
    can = movable("can1", Piece(Cylinder(0.03, 0.05), IDENTITY), at=(0.9, 0.0, -0.25), on=None)
    story = Story(scene_of(can), (0.0, -1.0, 1.5, 0.0, 1.0, 0.0), 0.0)
    story.q = story.solved(down(0.9, 0.0, -0.1))
    story.line(down(0.9, 0.0, -0.22))
    run = story.record()
    (finding,) = verdict(check_collisions(story.scene, run), run).findings
    assert finding.help == ("look at how wide the hand is open when it gets there",)
