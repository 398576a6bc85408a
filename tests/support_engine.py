"""Runs programs under commands and scenarios, and reads what came of them."""

from itertools import pairwise
from typing import TypeVar

from tests.support_programs import ALONE, compiled
from vrts.base.pose import distance
from vrts.engine.controller import advance, execute, start
from vrts.engine.memory.events import CommandRefused, Event, Printed, Reacted
from vrts.engine.run import Run
from vrts.ir.commands import Command, Execute, TimedCommand
from vrts.scene.model import Scenario, Scene

E = TypeVar("E", bound=Event)

TICK = 0.028  # [s] of the PUMA 761
SETTLING = 3 * TICK  # at a stop, with FINE and NULL
TACC = 0.224  # [s] of the PUMA 761
PLACES = (
    ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\nc 900 0 300 90 90 0\n"
    "d 900 0 100 90 90 0\n.END\n"
)


def main(body: str, more: str = "") -> str:
    """Return a file whose first program has these lines; the places a, b, c and d are known."""
    return f".PROGRAM main\n{body}\n.END\n{more}{PLACES}"


def runs(
    body: str,
    more: str = "",
    scenario: Scenario | None = None,
    dialect: str = "val2",
    scene: Scene = ALONE,
) -> Run:
    """Run the lines of one program to their end, beside other programs of the file."""
    return execute(compiled(main(body, more), dialect), scene, scenario)


def driven(
    text: str,
    until_s: float,
    *commands: tuple[float, Command],
    scenario: Scenario | None = None,
    scene: Scene = ALONE,
) -> Run:
    """Run a file under commands, after EXECUTE main at 0 s."""
    timed = [TimedCommand(0.0, Execute("main")), *(TimedCommand(*timed) for timed in commands)]
    return advance(start(compiled(text), scene, scenario), until_s, timed)


def words(run: Run) -> list[str]:
    """Return VAL's words of the errors found."""
    notes = [d.notes[-1] for d in run.findings if d.is_error]
    return [note.removeprefix("VAL-II says *").removesuffix("*") for note in notes]


def lines(run: Run) -> list[tuple[float, str]]:
    """Return what was written, with the time [s] of every line."""
    return [(e.time_s, e.text.strip()) for e in run.events if isinstance(e, Printed)]


def refused(run: Run) -> list[str]:
    """Return why commands were refused, in VAL's words."""
    return [e.words for e in run.events if isinstance(e, CommandRefused)]


def reacted(run: Run) -> list[Reacted]:
    """Return the reactions taken."""
    return [e for e in run.events if isinstance(e, Reacted)]


def of_kind(run: Run, kind: type[E]) -> list[E]:
    """Return the events of a kind."""
    return [event for event in run.events if isinstance(event, kind)]


def tool_speed(run: Run, time_s: float) -> float:
    """Return the speed of the tool's origin [m/s], by differences."""
    h = 1e-5
    a, b = (run.at(time_s + x).X_WT.translation for x in (-h, h))
    return distance(a, b) / (2 * h)


def length_of_path(run: Run, steps: int = 2000) -> float:
    """Return how far the tool travels over a run [m]."""
    places = [run.at(k * run.horizon_s / steps).X_WT.translation for k in range(steps + 1)]
    return sum(distance(a, b) for a, b in pairwise(places))
