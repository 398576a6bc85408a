"""What never ends, whatever comes from outside: read off the graph of states."""

from collections.abc import Iterator, Sequence

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Cause
from vrts.ir import instructions as ir
from vrts.prove.graph.graph import Graph, Place, Visit
from vrts.prove.graph.suspects import Suspect
from vrts.prove.proof import Wrong

ENDLESS = "this loop never ends, whatever comes from outside"
STUCK = "this wait never ends, whatever comes from outside"


def places(machine: Machine) -> tuple[Place, bool]:
    """Return where the robot program is, and whether it waits there until something changes."""
    robot = machine.robot
    place = tuple([(frame.program, frame.index) for frame in robot.frames])
    if not place:
        return place, False
    program, index = place[-1]
    code = machine.system.programs.loaded[program].program.instructions
    match code[min(index, len(code) - 1)]:
        case ir.Wait(condition=condition):
            return place, condition is not None
        case ir.Prompt():
            return place, True
        case _:
            return place, False


def for_ever(graph: Graph) -> list[list[Visit]]:
    """Return how the states were come to that futures come round to for ever, set by set."""
    return [[graph.visits[state] for state in states] for states in graph.closed()]


def never_left(closed: Sequence[Sequence[Visit]], machine: Machine) -> Iterator[str]:
    """Yield where a program goes round that looks at something outside, whatever that decides.

    A program that serves a machine does so, and one that asks for the wrong thing, too.
    """
    for visits in closed:
        cause = _cause(machine, min(visits, key=_soonest).place)
        if cause is not None and any(visit.asks for visit in visits):
            yield f"going round for ever at step {cause.step} of `{cause.program}` is meant"


def never_ending(
    graph: Graph, closed: Sequence[Sequence[Visit]], machine: Machine
) -> Iterator[Suspect]:
    """Yield loops and waits that never end, each by the state that is come to first.

    Args:
        graph: The states of all futures.
        closed: What futures come round to `for_ever`.
        machine: One that has their programs in memory.
    """
    for visits in closed:
        if not any(visit.asks for visit in visits) and not all(visit.waits for visit in visits):
            yield _suspect(Wrong.ENDLESS, ENDLESS, visits, machine)
    stuck: dict[Place, list[Visit]] = {}
    for state in graph.staying():
        visit = graph.visits[state]
        stuck.setdefault(visit.place, []).append(visit)
    for visits in stuck.values():
        yield _suspect(Wrong.DEADLOCK, STUCK, visits, machine)


def _suspect(wrong: Wrong, headline: str, visits: Sequence[Visit], machine: Machine) -> Suspect:
    first = min(visits, key=_soonest)
    causes = [_cause(machine, visit.place) for visit in visits]
    steps = frozenset((one.program, one.step) for one in causes if one is not None)
    cause, time_s = _cause(machine, first.place), first.tick * machine.tick
    return Suspect(wrong, (), headline, time_s, cause, first.past, first.cost, steps)


def _soonest(visit: Visit) -> tuple[int, int]:
    return visit.cost, visit.tick


def _cause(machine: Machine, place: Place) -> Cause | None:
    """Return the step of the innermost program of a place."""
    if not place:
        return None
    program, index = place[-1]
    causes = machine.system.programs.loaded[program].causes
    return causes[min(index, len(causes) - 1)]
