"""How far a number may go: ends, gaps, whole numbers one by one, and what no teacher would take."""

from collections.abc import Collection
from fractions import Fraction

import pytest

from tests.golden.examples import EXAMPLES
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.repair.edit import Change, Does, replacement
from vrts.repair.ranking import ILLEGAL, implausible
from vrts.repair.trying import reach as module
from vrts.repair.trying.reach import MOST_WHOLE, Reach, reach
from vrts.repair.trying.trial import Place, Stage, Tried

SOURCE = SourceFile("p.v2", "MOVE a\n10 DEPARTS 40\nSPEED 20 ALWAYS\nSPEED 50 MMPS\n")


def number(old: str, new: str, at: int = 0) -> Change:
    """Return the change of a number, the first that stands so from an offset on."""
    start = SOURCE.text.index(old, at)
    edits = (replacement(SOURCE, start, start + len(old), new),)
    return Change(Does.NUMBER, edits[0].span.line, edits, 1, old, new)


class Worlds:
    """Stands for the run of a program with another number: good are those that it is told of."""

    def __init__(self, good: Collection[int], unsure: Collection[int] = ()) -> None:
        """Take the good values, and those that only the usual checks refuse."""
        self.good, self.unsure = good, unsure
        self.executed: list[float] = []

    def stage(self, text: str, refused: Collection[int] = ()) -> Tried:
        """Return how far a program comes."""
        value = float(text.split("DEPARTS ")[1].split()[0])
        self.executed.append(value)
        good = value in self.good and value not in refused
        return Tried(Stage.FULL if good else Stage.STOPS, mark=Fraction(10))


def reached(
    monkeypatch: pytest.MonkeyPatch, worlds: Worlds, new: str = "100", most: int = 600
) -> Reach:
    """Return how far the number of DEPARTS may go, where so many are good."""

    def tried(_place: Place, text: str, *_given: object, **_named: object) -> Tried:
        return worlds.stage(text)

    def verified(_place: Place, text: str) -> Tried:
        return worlds.stage(text, worlds.unsure)

    monkeypatch.setattr(module, "tried", tried)
    monkeypatch.setattr(module, "verified_text", verified)
    monkeypatch.setattr(module, "shared", nothing)
    place: Place = None  # type: ignore[assignment]  # nothing is executed
    found = reach(place, SOURCE, number("40", new), lambda change: float(change.new) <= most)
    assert found is not None
    return found


def nothing(*_: object) -> None:
    """Stand for the run that candidates go on from: there is none."""


def test_every_whole_number_of_a_range_is_executed(monkeypatch: pytest.MonkeyPatch) -> None:
    worlds = Worlds(range(72, 131))
    found = reached(monkeypatch, worlds)
    first, last = found.whole or (0, 0)
    assert found.is_certified
    assert (first, last) == (found.low, found.high)
    assert 72 <= first <= 74
    assert 128 <= last <= 130
    assert set(map(float, range(round(first), round(last) + 1))) <= {*worlds.executed, 100.0}


def test_a_gap_ends_the_range(monkeypatch: pytest.MonkeyPatch) -> None:
    """The ends are found by a few values, none of which is the bad one: all are looked at."""
    found = reached(monkeypatch, Worlds(set(range(72, 200)) - {117}))
    assert found.high == 116
    assert found.whole == (found.low, 116)


def test_a_wide_range_is_certified_in_part_and_said_to_be(monkeypatch: pytest.MonkeyPatch) -> None:
    worlds = Worlds(range(60, 5000))
    found = reached(monkeypatch, worlds)
    assert found.whole is not None
    assert not found.is_certified
    assert found.high > found.whole[1]
    assert found.high <= 600
    assert found.whole[1] - found.whole[0] <= MOST_WHOLE
    assert len(worlds.executed) < MOST_WHOLE + 20
    assert found.tried < 20


def test_ends_that_the_usual_checks_refuse_are_not_certified(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert reached(monkeypatch, Worlds(range(72, 131), range(72, 131))).whole is None


def test_of_a_number_with_a_fraction_no_whole_ones_are_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    worlds = Worlds(range(72, 131))
    assert reached(monkeypatch, worlds, new="100.5").whole is None


def test_no_teacher_takes_a_distance_below_nothing_or_a_speed_above_all() -> None:
    """What stands before the number says what it is: a label does not."""
    assert implausible(number("40", "-20")) == ILLEGAL
    assert implausible(number("40", "700")) == ILLEGAL
    assert implausible(number("40", "120")) == 0
    assert implausible(number("20", "120")) == ILLEGAL
    assert implausible(number("50", "400")) == 0  # millimetres a second


@pytest.mark.thorough
def test_a_speed_is_certified_up_to_full_speed() -> None:
    example = EXAMPLES[0]
    program = example / "submissions" / "slow.v2"
    request = Request(
        ProgramFile(program.read_bytes(), program.name), load_task(example / "task.toml")
    )
    found = mended(request, reaching=True, hints=Hints.EDIT).reach
    assert found is not None
    assert found.is_certified
    assert found.high == 100
