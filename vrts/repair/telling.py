"""What is told of a repair: no more than a task allows, and no more than is sure."""

import re
from collections.abc import Iterable, Sequence

from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.repair.edit import Change, Does
from vrts.repair.ranking import Repair, standing_out
from vrts.repair.trying.reach import Reach

SHOWN = 2  # lines told where nothing mends a program
COUNTED = ("no", "one", "two")


def sentence(found: Sequence[Repair], level: Hints, reach: Reach | None = None) -> str | None:
    """Return what may be told of ranked repairs; None: nothing.

    Args:
        found: What earns the full mark, likeliest first.
        level: What the task allows.
        reach: Of the number that the likeliest writes: which others would do.
    """
    if not found or level is Hints.NOTHING:
        return None
    best = standing_out(found)
    if best is None or level is Hints.PLACE:
        return place(found[0].change)
    if level is Hints.EDIT:
        return f"{away(best, reach)}"
    way = direction(found, best)
    if way is None:
        return place(best.change)
    look = f"{place(best.change)}: {best.change.old} is {way}"
    if level is Hints.DIRECTION:
        return look
    return f"{look}, {best.change.new} would do{_also(reach)}"


def place(change: Change) -> str:
    """Return where a change is to be looked for, in words.

    A name that nothing gives a value is to be looked for where it is used: it may be given one
    anywhere.
    """
    return look_at(_where(part) for part in change.each)


def look_at(lines: Iterable[int]) -> str:
    """Return that lines are to be looked at, in words."""
    said = [str(line) for line in dict.fromkeys(lines)]
    return f"look at line{'s' * (len(said) > 1)} {' and '.join(said)}"


def _where(change: Change) -> int:
    """Return the line at which a change is to be looked for."""
    name = _defined(change)
    if name is None:
        return change.line
    word = re.compile(rf"(?<![\w.]){re.escape(name)}(?![\w.])", re.IGNORECASE)
    gives = re.compile(rf"\s*(?:\d+\s+)?(?:SET\s+)?{re.escape(name)}\s*(?:=|$)", re.IGNORECASE)
    lines = [line.partition(";")[0] for line in change.edits[0].span.source.lines()]
    uses = [number for number, line in enumerate(lines, 1) if word.search(line)]
    if not uses or any(gives.match(lines[number - 1]) for number in uses):
        return change.line
    return uses[0]


def _defined(change: Change) -> str | None:
    """Return the name to which a step or row that is missing gives a value; arrays apart."""
    words = change.new.split()
    if change.old or not words:
        return None
    if change.does is Does.ROW:
        return words[0]
    if change.does is Does.ADD and "=" in words[1:3]:
        name = words[1] if words[0].upper() == "SET" else words[0]
        return None if "[" in name else name
    return None


def shows(lines: Sequence[int], level: Hints) -> str | None:
    """Return where what is lost shows, where no change mends it; None: it may not be told.

    That is no guess of the mistake: only the first few lines of the run at which points go.
    """
    if not lines or level is Hints.NOTHING:
        return None
    said = [f"{line}" for line in lines[:SHOWN]]
    return f"what is lost shows at line{'s' * (len(said) > 1)} {' and '.join(said)}"


def away(repair: Repair, reach: Reach | None = None) -> str:
    """Return how far a program is from the full mark, in words."""
    parts = repair.change.each
    changes = f"{COUNTED[len(parts)]} change{'s' * (len(parts) > 1)} away"
    said = ", and ".join(f"line {part.line}: {does(part)}" for part in parts)
    return f"{changes}: {float(repair.mark):g} with {said}{_also(reach)}"


def most(repair: Repair, level: Hints) -> str | None:
    """Return which change earns most where none earns the full mark; None: it may not be told."""
    if level is not Hints.EDIT:
        return None
    said = ", and ".join(f"line {part.line}: {does(part)}" for part in repair.change.each)
    return f"most with {said}: {float(repair.mark):g}"


def _also(reach: Reach | None) -> str:
    if reach is None or reach.low == reach.high:
        return ""
    if reach.is_certified:
        return f"; every whole number from {reach.low:g} to {reach.high:g} would do, certified"
    said = f"from {reach.low:g} to {reach.high:g} would do, tried at {reach.tried} values"
    if reach.whole is None:
        return f"; {said}"
    first, last = reach.whole
    return f"; every whole number from {first:g} to {last:g} would do, certified; {said}"


def direction(found: Sequence[Repair], best: Repair) -> str | None:
    """Return whether a number is too small or too large, where all repairs of its place agree."""
    if best.change.does is not Does.NUMBER:
        return None
    place = best.change.edits[0].span.start
    same = [each.change for each in found if each.change.edits[0].span.start == place]
    ways = {_way(change) for change in same if change.does is Does.NUMBER}
    return ways.pop() if len(ways) == 1 else None


def does(change: Change) -> str:
    """Return what a change does, in words."""
    if change.does is Does.ADD:
        return f"`{change.new}` is missing {change.old or 'before it'}"
    if change.old.startswith("every "):
        return f"{change.old}: {change.new}"
    if change.does is Does.REMOVE:
        return f"`{change.old}` does not belong here"
    if change.does is Does.ORDER and change.old == change.new:
        return f"`{change.old}` stands elsewhere"
    if not change.old:
        return f"`{change.new}` is missing"
    if not change.new:
        return f"`{change.old}` does not belong here"
    more = len(change.edits) - 1
    if more and change.does is Does.NUMBER:
        return f"`{change.new}` for `{change.old}`, and so {more} more place{'s' * (more > 1)}"
    return f"`{change.new}` for `{change.old}`"


def cause(change: Change, source: SourceFile) -> str:
    """Return what is wrong in words that programs share whose authors made the same mistake."""
    words = source.line_text(change.line).split()
    step = words[0] if words else ""
    match change.does:
        case Does.ADD:
            return f"`{change.new.split()[0]}` is missing"
        case Does.REMOVE:
            return f"`{change.old.split()[0]}` does not belong here"
        case Does.ORDER:
            return "something stands in the wrong order"
        case Does.NUMBER:
            return f"a number of `{step}` is {_way(change)}"
        case Does.ROW:
            return f"the location `{step if change.old else change.new.split()[0]}` is wrong"
        case _:
            return does(change)


def _way(change: Change) -> str:
    return "too small" if float(change.new) > float(change.old) else "too large"
