"""`[late]` and `[submissions]` of a task: what is read, and what is wrong where it stands."""

from datetime import datetime, timedelta, timezone
from fractions import Fraction

import pytest

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.rules.hints import Hints
from vrts.check.task.late_file import read_exam, read_keep, read_late
from vrts.check.task.late_rules import Keep, LateRules, LateStep
from vrts.check.task.staff import read_whole_task
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.pipeline.scenes import load_scene

CET = timezone(timedelta(hours=1))
DUE = datetime(2026, 11, 30, 23, 59, tzinfo=CET)
START = "[late]\ndue = 2026-11-30T23:59:00+01:00\n"


def read(text: str) -> tuple[LateRules | None, list[str], list[str]]:
    """Return the rules, the codes of what is wrong, and the texts there."""
    top, problems = read_toml(SourceFile("task.toml", text))
    assert top is not None
    rules = read_late(top, problems)
    top.finish()
    places = [d.primary.span.text if d.primary else "" for d in problems.found]
    return rules, [d.rule.code for d in problems.found], places


def test_lateness_is_off_by_default() -> None:
    assert read("") == (None, [], [])


def test_points_by_the_day() -> None:
    rules, codes, _ = read(
        START + "grace_min = 10\nper_day = 0.1\nmost = 5\nclosed = 2026-12-07T23:59:00+01:00\n"
    )
    assert codes == []
    closed = DUE + timedelta(days=7)
    grace = timedelta(minutes=10)
    assert rules == LateRules(DUE, grace, Fraction(1, 10), (), Fraction(5), closed)


def test_points_in_steps() -> None:
    step = "[[late.step]]\nafter_h = {}\npoints = {}\n"
    rules, codes, _ = read(START + step.format(0, 1) + step.format(24.5, 3))
    assert codes == []
    assert rules is not None
    assert rules.steps == (
        LateStep(timedelta(0), Fraction(1)),
        LateStep(timedelta(hours=24, minutes=30), Fraction(3)),
    )


STEP = "[[late.step]]\nafter_h = 2\npoints = 1\n"


@pytest.mark.parametrize(
    ("text", "code", "place"),
    [
        ("[late]\nper_day = 1\n", "V603", "[late]"),
        ('[late]\ndue = "tomorrow"\nper_day = 1\n', "V604", '"tomorrow"'),
        ("[late]\ndue = 2026-11-30\nper_day = 1\n", "V604", "2026-11-30"),
        ("[late]\ndue = 2026-11-30T23:59:00\nper_day = 1\n", "V604", "2026-11-30T23:59:00"),
        (START + "per_day = -1\n", "V605", "-1"),
        (START + "per_day = 1\nper_hour = 1\n", "V602", "per_hour"),
        (START, "V710", "[late]"),
        (START + "per_day = 1\n" + STEP, "V710", "per_day"),
        (START + STEP + STEP, "V710", "[[late.step]]"),
        (START + STEP + STEP.replace("2", "3").replace("1", "0.5"), "V710", "[[late.step]]"),
        (START + "closed = 2026-11-30T23:58:00+01:00\n", "V710", "2026-11-30T23:58:00+01:00"),
    ],
)
def test_what_is_wrong_is_told_where_it_stands(text: str, code: str, place: str) -> None:
    _, codes, places = read(text)
    assert (codes, places) == ([code], [place])


def test_which_of_several_hand_ins_counts() -> None:
    for text, keep in (
        ("", Keep.LATEST),
        ('[submissions]\nkeep = "latest"\n', Keep.LATEST),
        ('[submissions]\nkeep = "best"\n', Keep.BEST),
    ):
        top, problems = read_toml(SourceFile("task.toml", text))
        assert top is not None
        assert read_keep(top) is keep
        assert problems.found == []


def test_another_word_for_what_counts_is_told() -> None:
    top, problems = read_toml(SourceFile("task.toml", '[submissions]\nkeep = "first"\n'))
    assert top is not None
    assert read_keep(top) is Keep.LATEST
    assert [d.rule.code for d in problems.found] == ["V606"]


TASK = """[task]
scene = "cans-on-bases"
[[goal]]
object = "can1"
on = "base2"
[time]
reference_s = 10
"""


def task_of(more: str, staff: str | None = None) -> tuple[Task | None, list[str]]:
    """Return the task, with a hidden part if there is one, and the codes of what is wrong."""
    scene = load_scene("cans-on-bases").scene
    source = SourceFile("lab/task.toml", TASK + more)
    if staff is None:
        task, found = read_task(source, scene)
    else:
        task, _, found = read_whole_task(source, SourceFile("lab/staff/task.toml", staff), scene)
    return task, [d.rule.code for d in found]


def test_a_task_has_the_rules() -> None:
    task, codes = task_of(START + 'per_day = 1\n[submissions]\nkeep = "best"\n')
    assert codes == []
    assert task is not None
    assert task.late == LateRules(DUE, per_day=Fraction(1))
    assert task.keep is Keep.BEST


def test_a_task_without_rules_takes_nothing_and_the_latest() -> None:
    task, _ = task_of("")
    assert task is not None
    assert (task.late, task.keep) == (None, Keep.LATEST)


def test_a_task_with_wrong_rules_is_refused() -> None:
    assert task_of(START) == (None, ["V710"])


@pytest.mark.parametrize("hidden", [START + "per_day = 1\n", '[submissions]\nkeep = "best"\n'])
def test_rules_cannot_be_hidden_from_students(hidden: str) -> None:
    assert task_of("", hidden) == (None, ["V664"])


EXAM = """[exam]
opens = 2026-12-01T09:00:00+01:00
closes = 2026-12-01T11:00:00+01:00
"""


def test_an_exam_counts_what_comes_while_it_is_open_and_gives_no_hints() -> None:
    task, codes = task_of(EXAM)
    assert codes == []
    assert task is not None
    opens = datetime(2026, 12, 1, 9, tzinfo=CET)
    closes = opens + timedelta(hours=2)
    assert task.late == LateRules(closes, closed=closes, opens=opens, attempts=1)
    assert (task.keep, task.hints, task.offline) == (Keep.LATEST, Hints.NOTHING, True)


def test_the_best_of_several_attempts_with_the_hints_of_the_task() -> None:
    more = 'attempts = 3\nhints = "task"\noffline = false\n[hints]\nlevel = "place"\n'
    task, codes = task_of(EXAM + more)
    assert codes == []
    assert task is not None
    assert task.late is not None
    assert (task.late.attempts, task.keep) == (3, Keep.BEST)
    assert (task.hints, task.offline) == (Hints.PLACE, False)


@pytest.mark.parametrize(
    ("text", "code", "place"),
    [
        ("[exam]\ncloses = 2026-12-01T11:00:00+01:00\n", "V603", "[exam]"),
        (EXAM.replace("T11:00:00+01:00", "T11:00:00"), "V604", "2026-12-01T11:00:00"),
        (EXAM.replace("T11", "T08"), "V873", "2026-12-01T08:00:00+01:00"),
        (EXAM + "attempts = 0\n", "V605", "0"),
        (EXAM + 'attempts = "one"\n', "V604", '"one"'),
        (EXAM + 'hints = "some"\n', "V606", '"some"'),
        (EXAM + "opened = true\n", "V602", "opened"),
        (EXAM + START + "per_day = 1\n", "V873", "late"),
        (EXAM + '[submissions]\nkeep = "best"\n', "V873", "submissions"),
        (EXAM + '[hints]\nlevel = "edit"\n', "V873", "hints"),
    ],
)
def test_what_is_wrong_with_an_exam_is_told_where_it_stands(
    text: str, code: str, place: str
) -> None:
    top, problems = read_toml(SourceFile("task.toml", text))
    assert top is not None
    read_exam(top, problems)
    found = [(d.rule.code, d.primary.span.text if d.primary else "") for d in problems.found]
    assert found == [(code, place)]
    assert task_of(text)[0] is None


def test_an_exam_cannot_be_hidden_from_students() -> None:
    assert task_of("", EXAM) == (None, ["V664"])
