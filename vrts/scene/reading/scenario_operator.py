"""Reads `[[operator]]`, `[random]`, `[programs]` of a scenario: deeds, draws, whose turn it is."""

from vrts.base.toml.reading import Table
from vrts.scene.model import Act, Deed, Parts
from vrts.scene.reading.scenario_signals import LATEST_S, MOST_ENTRIES, check_count

MOST_DRAWS = 10_000
LARGEST_DRAW = 1.0  # of RANDOM
MOST_TURNS = 10_000


def read_operator(top: Table) -> tuple[Act, ...]:
    """Return what the operator of a scenario does, by time."""
    tables = top.tables("operator")
    span = top.span_of("operator")
    few = check_count(top.problems, len(tables), MOST_ENTRIES, "acts of the operator", span)
    found = [_act(table) for table in (tables if few else ())]
    return tuple(sorted((act for act in found if act is not None), key=_time))


def read_draws(section: Table | None) -> tuple[float, ...]:
    """Return what RANDOM draws first."""
    if section is None:
        return ()
    draws = section.numbers("draws", (), minimum=0.0, maximum=LARGEST_DRAW) or ()
    section.finish()
    span = section.span_of("draws")
    few = check_count(section.problems, len(draws), MOST_DRAWS, "random numbers", span)
    return draws if few else ()


def read_turns(section: Table | None) -> tuple[float, ...]:
    """Return when the process control program has its turn first [s], by time."""
    if section is None:
        return ()
    times = section.numbers("process_first_s", (), minimum=0.0, maximum=LATEST_S) or ()
    section.finish()
    span = section.span_of("process_first_s")
    few = check_count(section.problems, len(times), MOST_TURNS, "turns of programs", span)
    return tuple(sorted(times)) if few else ()


def _act(table: Table) -> Act | None:
    time_s = table.number("time_s", minimum=0.0, maximum=LATEST_S, required=True)
    word = table.string("does", choices=[deed.value for deed in Deed], required=True)
    parts = Parts.LEFT
    if word is None or word == Deed.EXECUTE.value:
        said = table.string("parts", Parts.LEFT.value, choices=[one.value for one in Parts])
        parts = Parts(said)
    table.finish()
    return None if time_s is None or word is None else Act(time_s, Deed(word), parts)


def _time(act: Act) -> float:
    return act.time_s
