"""What is put across several things: all of them are named, in events, words and saved runs."""

from typing import Any

import pytest

from tests.support_goals import results
from tests.support_programs import happened, ran
from vrts.base.source import SourceFile
from vrts.debug.alarms import Alarms
from vrts.debug.events.asking import Tables
from vrts.debug.passages import Instant
from vrts.engine.memory.events import Event, Landed, Toppled
from vrts.engine.run import Run
from vrts.engine.storage.damage import Damaged
from vrts.engine.storage.plain import Plain
from vrts.report.event_words import event_text
from vrts.scene.reading.scene_file import read_scene

SCENE = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.can]
kind = "can"
at_mm = [800, -450]
on = "table"
radius_mm = 30
height_mm = 150

[objects.left]
kind = "base"
at_mm = [950, -131]
on = "table"
size_mm = [80, 50, 150]

[objects.right]
kind = "base"
at_mm = [950, -69]
on = "table"
size_mm = [80, 50, 150]

[locations]
safe = [900, 30, 200, 90, 90, 0]
"""
PROGRAM = """
.PROGRAM main
OPENI
APPRO grip, 120
MOVES grip
CLOSEI
DEPARTS 300
APPRO put, 120
MOVES put
OPENI
.END
.LOCATIONS
grip 800 -450 -225 90 90 0
put {place} 90 90 0
.END
"""


def put(place: str) -> Run:
    scene, problems = read_scene(SourceFile("two.toml", SCENE))
    assert scene is not None, problems
    return ran(PROGRAM.format(place=place), scene)


def again(event: Event, *, last: int | None = None) -> Any:
    """Return an event written to a file and read again, perhaps without what is new in it."""
    plain = Plain(())
    kind = type(event)
    said = plain.write(kind, event._replace(cause=None))  # type: ignore[call-arg]
    return plain.read(kind, said[:last])


def test_all_that_it_stands_on_are_named() -> None:
    run = put("950 -100 -75")
    (landed,) = happened(run, Landed)
    assert isinstance(landed, Landed)
    assert {landed.support, *landed.also} == {"left", "right"}
    assert event_text(landed) == ("grasp", f"can stands on {landed.support} and {landed.also[0]}")
    assert again(landed) == landed._replace(cause=None)
    assert again(landed, last=4) == landed._replace(cause=None, also=()), "a file of before"
    with pytest.raises(Damaged):
        again(landed, last=3)


@pytest.mark.parametrize("name", ["left", "right"])
def test_the_table_of_events_finds_it_by_each_of_them(name: str) -> None:
    run = put("950 -100 -75")
    asked = f"where what = landed and body = {name}"
    found = Tables(run, Alarms(run, None)).asked("events", asked, Instant(0.0, 0))
    assert found.total == 1


@pytest.mark.parametrize(("place", "stands"), [("950 -100 -75", 1), ("950 -131 -75", 0)])
def test_a_goal_is_reached_on_each_of_them(place: str, stands: int) -> None:
    wanted = (f'[[relation]]\nobject = "can"\nstacked_on = "{on}"\n' for on in ("left", "right"))
    left, right = results(put(place), "".join(wanted))
    assert (left.share, right.share) == (1, stands)


def test_on_one_of_them_nothing_is_added() -> None:
    (landed,) = happened(put("950 -131 -75"), Landed)
    assert isinstance(landed, Landed)
    assert (landed.support, landed.also) == ("left", ())


def test_what_cannot_stand_names_all_that_it_touches() -> None:
    run = put("995 -100 -75")  # its mass is beside both
    (toppled,) = happened(run, Toppled)
    assert isinstance(toppled, Toppled)
    assert {toppled.support, *toppled.also} == {"left", "right"}
    said = run.findings[-1].headline
    assert said == (
        f"`can` cannot stand on `{toppled.support}` and `{toppled.also[0]}` as it is let go"
    )
