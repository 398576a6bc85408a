"""Who moves, for the terminal."""

from fractions import Fraction

from vrts.marking.appeals.moves import Diff, Move, points
from vrts.report.plain import one_line, width

WIDEST = 40  # of an id
MOST_NAMED = 10
WHY = 23  # characters between the id and the reasons


def diff_text(found: Diff) -> str:
    """Return what two markings have not in common."""
    lines = [one_line(sentence) for sentence in found.conditions]
    if not lines:
        lines.append("task, scene and versions are the same")
    lines.append("")
    if found.moves:
        column = min(WIDEST, max(2, *(width(one_line(move.id)) for move in found.moves)))
        lines.append(f"{'id':{column}}   old    new     by   why")
        for move in found.moves:
            lines += _lines(move, column)
        lines.append("")
    lines += _summary(found)
    return "\n".join(lines)


def _lines(move: Move, column: int) -> list[str]:
    name = one_line(move.id)
    by = "" if move.by is None else points(Fraction(move.by))
    start = (
        f"{name}{' ' * max(0, column - width(name))}  {_mark(move.old):>4}   {_mark(move.new):>4}"
    )
    first, *rest = (one_line(reason) for reason in move.reasons)
    indent = " " * (column + WHY)
    return [f"{start}  {by:>5}   {first}", *(f"{indent}{reason}" for reason in rest)]


def _summary(found: Diff) -> list[str]:
    up = [Fraction(move.by) for move in found.moves if move.rises and move.by is not None]
    down = [Fraction(move.by) for move in found.moves if move.falls and move.by is not None]
    total = found.same + len(found.moves)
    parts = [f"{len(up)} up"] if up else []
    parts += [f"{len(down)} down, by {points(-min(down)).lstrip('+')} at most"] if down else []
    unmarked = len(found.moves) - len(up) - len(down)
    parts += [f"{unmarked} between a mark and none"] if unmarked else []
    lines = [f"{len(found.moves)} of {total} move" + (f": {', '.join(parts)}" if parts else "")]
    for names, where in ((found.gone, "the old"), (found.added, "the new")):
        if names:
            shown = ", ".join(one_line(name) for name in names[:MOST_NAMED])
            more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
            lines.append(f"only in {where} marking: {shown}{more}")
    return lines


def _mark(mark: float | None) -> str:
    return "-" if mark is None else f"{mark:.1f}"
