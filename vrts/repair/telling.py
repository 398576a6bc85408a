"""What is told of a repair: no more than a task allows, and no more than is sure."""

from collections.abc import Sequence

from vrts.check.rules.hints import Hints
from vrts.repair.edit import Change, Does
from vrts.repair.ranking import Repair, standing_out


def sentence(found: Sequence[Repair], level: Hints) -> str | None:
    """Return what may be told of ranked repairs; None: nothing."""
    if not found or level is Hints.NOTHING:
        return None
    best = standing_out(found)
    first = found[0]
    if best is None or level is Hints.PLACE:
        return f"look at line {first.change.line}"
    if level is Hints.EDIT:
        where = f"line {best.change.line}: {does(best.change)}"
        return f"one change away: {float(best.mark):g} with {where}"
    way = direction(found, best)
    if way is None:
        return f"look at line {best.change.line}"
    if level is Hints.DIRECTION:
        return f"look at line {best.change.line}: {best.change.old} is {way}"
    return (
        f"look at line {best.change.line}: {best.change.old} is {way}, {best.change.new} would do"
    )


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
        return f"`{change.new}` is missing before it"
    if change.does is Does.REMOVE:
        return f"`{change.old}` is too much"
    if change.does is Does.ORDER and change.old == change.new:
        return f"`{change.old}` stands elsewhere"
    if not change.old:
        return f"`{change.new}` is missing"
    if not change.new:
        return f"`{change.old}` is too much"
    more = len(change.edits) - 1
    if more and change.does is Does.NUMBER:
        return f"`{change.new}` for `{change.old}`, and so {more} more place{'s' * (more > 1)}"
    return f"`{change.new}` for `{change.old}`"


def _way(change: Change) -> str:
    return "too small" if float(change.new) > float(change.old) else "too large"
