"""Rules of hand-ins: when nothing is taken, who is marked next, names of folders, words."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta, timezone
from fractions import Fraction
from pathlib import Path

from vrts.check.task.late_rules import Keep, LateRules
from vrts.course.course import Assignment
from vrts.course.facts import Facts
from vrts.course.handing.names import folder_of, stamp_of, time_of
from vrts.course.handing.queue import in_order
from vrts.course.handing.standing import standing
from vrts.course.handing.words import Span, blocks_of
from vrts.live.store.course.attempts import Attempt

DUE = datetime(2026, 11, 30, 12, tzinfo=UTC)
RULES = LateRules(DUE, per_day=Fraction(1), closed=DUE + timedelta(days=2))
FACTS = Facts(Assignment("pick", Path("pick"), attempts=3), "Pick", RULES, Keep.LATEST, "")


def code(facts: Facts, used: int, at: datetime, *, due: datetime | None = None) -> str:
    refusal = standing(facts, used, at.timestamp(), due=due).refusal
    return "" if refusal is None else refusal.code


def test_attempts_run_out_and_assignments_close() -> None:
    assert code(FACTS, 2, DUE) == ""
    assert code(FACTS, 3, DUE) == "attempts"
    closed = DUE + timedelta(days=2, seconds=1)
    assert code(FACTS, 0, closed) == "closed"
    assert code(FACTS, 0, closed, due=DUE + timedelta(hours=1)) == ""  # it closes later, too
    late = standing(FACTS, 0, (DUE + timedelta(minutes=5)).timestamp()).late
    assert late == "5 min late: 1 point less"


def test_an_exam_takes_what_comes_while_it_is_open() -> None:
    rules = LateRules(DUE, opens=DUE - timedelta(hours=2), attempts=1)
    exam = FACTS._replace(rules=rules)
    assert code(exam, 0, DUE - timedelta(hours=3)) == "early"
    assert code(exam, 0, DUE) == ""
    assert code(exam, 1, DUE) == "attempts"
    assert code(exam, 0, DUE + timedelta(seconds=1)) == "closed"


def test_an_assignment_that_opens_later_is_not_there_yet() -> None:
    later = replace(FACTS.assignment, opens=DUE)
    assert code(FACTS._replace(assignment=later), 0, DUE - timedelta(seconds=1)) == "early"


def waits(account: int, at: float, digest: str, variant: str = "") -> Attempt:
    return Attempt(account, "pick", 1, at, account, digest, "waiting", variant=variant)


def test_nobody_is_kept_waiting_by_the_many_hand_ins_of_another() -> None:
    storm = [waits(1, float(k), f"a{k}") for k in range(5)]
    others = [waits(2, 3.5, "b"), waits(3, 9.0, "c")]
    order = in_order(sorted([*storm, *others], key=lambda one: one.at))
    assert [job.digest for job in order] == ["a0", "b", "c", "a1", "a2", "a3", "a4"]


def test_one_program_is_marked_once() -> None:
    assert len(in_order([waits(1, 0.0, "a"), waits(2, 1.0, "a")])) == 1
    others = [waits(1, 0.0, "a", "bcdf-ghjk"), waits(2, 1.0, "a", "lmnp-qrst")]
    assert len(in_order(others)) == 2, "but each variant is another task"


def test_folders_are_safe_and_those_of_two_people_are_two() -> None:
    assert folder_of("moodle:7", "Cy@Example.org") == "cy@example.org"
    hostile = ("../../etc", "a/b", "a\\b", ".", "..", "", "x" * 300, "con", "-", "ä/ö@x", "a\0b")
    names = [folder_of(key, "") for key in hostile]
    assert len(set(names)) == len(hostile)
    for name in names:
        assert name not in ("", ".", "..")
        assert not set(name) & set("/\\\0")
        assert len(name) <= 100


def test_times_of_folders_come_back() -> None:
    zone = timezone(timedelta(hours=1))
    assert time_of(stamp_of(1_795_780_800.0, zone), zone) == 1_795_780_800.0
    assert time_of("overrides.toml", zone) is None


def test_a_readme_becomes_blocks_and_never_markup() -> None:
    blocks = blocks_of(
        "# Pick <b>one</b>\n\nGo `MOVE a` **now**,\nor [ask](https://x.org) [me](javascript:1).\n"
        "<!-- not for you -->\n- one\n  - two\n\n```\n# no heading\n```\n"
        "| a | b |\n|---|---|\n| 1 | 2 |\n"
    )
    assert [block.kind for block in blocks] == ["heading", "text", "list", "code", "table"]
    assert blocks[0].spans == (Span("Pick <b>one</b>"),)
    assert Span("ask", "link", "https://x.org") in blocks[1].spans
    assert Span("me") in blocks[1].spans  # leads nowhere
    assert [item.depth for item in blocks[2].items] == [0, 1]
    assert blocks[3].spans[0].text == "# no heading"
    assert len(blocks[4].rows) == 2
