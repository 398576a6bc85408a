"""FOR loops that never run, and such that never count."""

from vrts.base.diagnostic import Rule
from vrts.lang.findings.values.evaluate import Known, evaluate
from vrts.lang.findings.values.intervals import point
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Number
from vrts.lang.syntax.statements import For

IDLE_LOOP = Rule("V233", "idle-loop")


def check_loop(problems: Problems, node: For, known: Known) -> bool:
    """Warn of a loop that makes no pass or never ends; return whether there is one."""
    first, last = evaluate(node.first, known), evaluate(node.last, known)
    by = evaluate(node.increment, known) if node.increment is not None else point(1.0)
    start, end = node.start, node.end
    if node.increment is not None and by == (0.0, 0.0):
        if first[0] > last[1]:
            return False
        problems.warning(
            IDLE_LOOP,
            "this loop never ends: its step is 0",
            node.increment.start,
            node.increment.end,
            help=("write a STEP other than 0",),
        )
        return True
    up, down = by[0] > 0.0, by[1] < 0.0
    if not (up and first[0] > last[1]) and not (down and first[1] < last[0]):
        return False
    counts = isinstance(node.first, Number) and node.increment is None
    problems.warning(
        IDLE_LOOP,
        "this loop makes no pass: it never runs",
        start,
        end,
        f"it counts {'up' if up else 'down'} from {first[0]:g}, and {last[0]:g} is "
        f"{'below' if up else 'above'}",
        help=("write `STEP -1` to count down",)
        if up and node.increment is None
        else ("turn the sign of STEP round, or swap the two ends",),
        fix=problems.replace(end, end, " STEP -1") if counts else None,
    )
    return True
