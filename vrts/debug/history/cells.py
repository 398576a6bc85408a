"""Changes of variables, array elements, arguments, and of what TOOL and BASE have set."""

from collections.abc import Iterator

from vrts.debug.history.track import Moment, Track, joined
from vrts.debug.passages import instant_of
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Content
from vrts.engine.run import Run


def of_bound(run: Run, bound: Bound, name: str) -> Track:
    """Return the changes of a variable, or of any element of an array."""
    if isinstance(bound, Cell):
        return Track(run, f"`{name}`", lambda at: bound.at(at.finished), list(writes(run, bound)))
    cells = list(bound.elements.values())
    moments = joined(moment for cell in cells for moment in writes(run, cell))
    return Track(run, f"`{name}[]`", lambda at: _newest(bound, at.finished), moments)


def writes(run: Run, cell: Cell) -> Iterator[Moment]:
    """Yield the changes of a cell: a value written again is none."""
    before: Content = UNDEFINED
    for since in dict.fromkeys(cell.since):
        if since > run.statements:
            return
        value = cell.at(since)
        if value != before:
            instant = instant_of(run, since)
            yield Moment(instant, instant.time_s, since)
        before = value


def _newest(array: Array, finished: int) -> str:
    """Return the element that was written last, with its value."""
    newest, found = -1, "no elements"
    for cell in array.elements.values():
        numbers = [since for since in cell.since if since <= finished]
        if numbers and numbers[-1] >= newest:
            newest = numbers[-1]
            found = f"{cell.name} = {cell.at(finished)}"
    return found
