"""[[never]] and [[always]]: on runs whose moments are known, and on inputs that nobody decides."""

import pytest

from tests.support_programs import compiled
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.prove.environment.environment import Property
from vrts.prove.environment.reading import read_environment
from vrts.prove.properties.moments import Moment
from vrts.prove.properties.monitor import Broken, Monitor
from vrts.prove.properties.of_run import BrokenAt, first_broken
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

TICK = 0.028
PROGRAM = """\
.PROGRAM main()
  OPENI
  SIGNAL 3
  READY
  CLOSEI
  SIGNAL -3
  DRIVE 1, 30, 100
  SIGNAL 4
  DELAY 1
.END
"""


def properties(text: str) -> tuple[Property, ...]:
    found, said = read_environment(SourceFile("environment.toml", text))
    assert found is not None, said
    return found.properties


def broken(text: str, program: str = PROGRAM) -> BrokenAt | None:
    run = execute(compiled(program), robot_alone(), Scenario(), "main")
    return first_broken(run, properties(text), run.horizon_s)


@pytest.mark.parametrize(
    "text",
    [
        "[[never]]\nsignals = [3, 4]",
        '[[never]]\nsignals = [3]\nhand = "holding"',
        "[[always]]\nafter = 4\nwithin_s = 0.2\nstill = true",
        "[[always]]\nafter = -3\nwithin_s = 2\nstill = true",
        '[[always]]\nafter = 3\nwithin_s = 1\nhand = "closed"',
        "[[never]]\nstep = 'other:1'",
        "[[never]]\nregion_mm = { from = [0, 0, 5000], to = [1, 1, 5001] }",
    ],
)
def test_what_a_run_keeps(text: str) -> None:
    assert broken(text) is None


@pytest.mark.parametrize(
    "text",
    [
        '[[never]]\nsignals = [3]\nhand = "not closed"',
        "[[never]]\nsignals = [-3, 4]",
        "[[always]]\nsignals = [-3]",
        '[[always]]\nhand = "closed"',
        "[[never]]\nstill = false",
        "[[never]]\nsignals = [-3]\nstep = 'main:8'\nstill = false",
        "[[always]]\nafter = 3\nwithin_s = 0.1\nsignals = [-3]",
        "[[never]]\nregion_mm = { from = [-5000, -5000, -5000], to = [5000, 5000, 5000] }",
    ],
)
def test_what_a_run_breaks(text: str) -> None:
    assert broken(text) is not None


def test_the_first_that_is_broken_is_told_with_its_time() -> None:
    text = "[[never]]\nsignals = [4]\n[[never]]\nsignals = [3]\n"
    found = broken(text)
    assert found is not None
    assert found.number == 1
    opened = execute(compiled(PROGRAM), robot_alone(), Scenario(), "main")
    on = next(e.time_s for e in opened.events if getattr(e, "signal", None) == 3)
    assert on <= found.time_s < on + TICK


def moment(tick: int, signals: dict[int, bool], *, still: bool) -> Moment:
    """A moment in which an input that is not named was not decided."""
    return Moment(tick * TICK, signals.get, 0.0, False, (0.0, 0.0, 0.0), still, None)


def monitor(text: str) -> Monitor:
    return Monitor(properties(text), robot_alone().robot.gripper, TICK)


def test_an_input_that_nobody_decides_is_what_breaks_the_property() -> None:
    watch = monitor("[[never]]\nsignals = [1001, -1002]\nstill = false")
    _, found = watch.follow(watch.begin(), moment(1, {}, still=False))
    assert found == Broken(0, ((1001, True), (1002, False)))
    assert watch.follow((), moment(1, {1002: True}, still=False))[1] is None
    assert watch.follow((), moment(1, {}, still=True))[1] is None
    always = monitor("[[always]]\nsignals = [1001, 1002]")
    assert always.follow((), moment(1, {1001: True}, still=True))[1] == Broken(0, ((1002, False),))


def test_what_is_due_is_counted_from_when_a_signal_goes_on() -> None:
    watch = monitor("[[always]]\nafter = 1001\nwithin_s = 0.056\nstill = true")
    memory = watch.begin()
    answers: list[bool] = []
    for tick, on in enumerate([False, True, True, True, True]):
        memory, found = watch.follow(memory, moment(tick, {1001: on}, still=False))
        answers.append(found is not None)
    assert answers == [False, False, False, True, False]  # once, not again while it stays on


def test_an_undecided_signal_may_go_on_at_any_tick() -> None:
    watch = monitor("[[always]]\nafter = 1001\nwithin_s = 0.028\nstill = true")
    memory, found = watch.follow(watch.begin(), moment(0, {}, still=False))
    assert found is None
    told = Broken(0, (), began=(1001, True, 1))
    assert watch.follow(memory, moment(1, {}, still=False))[1] == told
    assert watch.follow(memory, moment(1, {}, still=True))[1] is None


def test_nothing_is_remembered_of_what_is_not_due() -> None:
    watch = monitor("[[always]]\nafter = 3\nwithin_s = 1\nstill = true\n[[never]]\nsignals = [5]")
    assert watch.begin() == ((False, None),)
    signals = {3: True, 5: False}
    memory, _ = watch.follow(watch.begin(), moment(0, signals, still=True))
    assert memory == ((True, None),)
