"""In which order an operator begins: measured, sent, raised, slow, and only then at speed."""

from collections.abc import Iterator, Sequence

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.dispatch.bundle import Bundle, rows
from vrts.dispatch.planning.beside.dry_run import DryRun, base_command
from vrts.dispatch.planning.beside.stops import typed_after
from vrts.dispatch.planning.beside.trials import FIRST_SPEED

MOST_BY_HAND = 8  # values that are typed
MOST_NAMES = 6


def order(bundle: Bundle, raised: DryRun, X_FT: Pose, again: Sequence[str]) -> list[str]:
    """Return what is to be done, in sentences with commands between backticks.

    Args:
        bundle: What is sent.
        raised: How high the dry run is.
        X_FT: The tool that has to be set before the program begins.
        again: Names of data that a run leaves with other values.
    """
    entry = bundle.manifest.entry
    tool = ", ".join(f"{round(number, 3) + 0.0:g}" for number in components(X_FT))
    steps = [
        "Scene measured and ticked; nobody within reach; air on; the stop tried.",
        "`vrts dispatch send`: it says that everything was read back and is the same.",
        *_by_hand(bundle),
        f"`BASE` all zero, `TOOL` {tool}; `SPEED {FIRST_SPEED:g}`.",
        "Arm at the start position: `WHERE` as above.",
        *_dry_run(raised, entry),
        f"With parts: `SPEED {FIRST_SPEED:g}`, `EXECUTE {entry}`, hand on the stop.",
        "Then faster in steps: `SPEED 25`, `50`, `100`; parts put back and measured each time.",
    ]
    steps += _after_a_stop(bundle, entry)
    if again:
        names = ", ".join(f"`{name}`" for name in again[:MOST_NAMES])
        steps.append(f"The program changes {names}: send the data again before another run.")
    return steps


def _by_hand(bundle: Bundle) -> Iterator[str]:
    values = (*rows(bundle.reals), *rows(bundle.strings))
    typed = [f"`DO {name} = {value}`" for name, value in values]
    if typed:
        more = len(typed) - MOST_BY_HAND
        shown = ", ".join(typed[:MOST_BY_HAND]) + (f" and {more} more" if more > 0 else "")
        yield f"Enter by hand: {shown}; `LISTR` and `LISTS` show them."


def _after_a_stop(bundle: Bundle, entry: str) -> Iterator[str]:
    """Yield what may be typed after a stop in whatever tick."""
    found = [(typed_after(m), m) for m in bundle.manifest.margins if typed_after(m)]
    bad = {typed: m for typed, m in found if m.answer != "holds"}
    safe = list(dict.fromkeys(typed for typed, _ in found if typed not in bad))
    if not found:
        return
    if safe:
        yield f"After a stop: {' or '.join(f'`{typed}`' for typed in safe)} may be typed."
    for typed, margin in bad.items():
        yield f"After a stop never `{typed}`: {margin.sentence}."
    if not safe:
        yield f"Instead: free the arm by hand, `READY`, parts put back, `EXECUTE {entry}`."


def _dry_run(raised: DryRun, entry: str) -> Iterator[str]:
    if raised.height_mm == 0:
        yield f"No dry run above the table: {raised.problem}. Go step by step with `NEXT` first."
        return
    height = raised.height_mm
    lower = f" (not higher: {raised.problem})" if raised.problem else ""
    yield (
        f"Dry run {height} mm above the table{lower}: take away all that can be carried; "
        f"`{base_command(height)}`; `WHERE` has to show Z {height} mm less than before, or "
        "stop here: the sign is the other one."
    )
    kept = f" Not raised: {', '.join(raised.level[:3])}." if raised.level else ""
    near = "" if raised.clearance_mm is None else f" (nearest {raised.clearance_mm:.0f} mm)"
    yield (
        f"`EXECUTE {entry}`{near}; the hand closes on nothing.{kept} "
        "Then `BASE`; `WHERE` as before."
    )
