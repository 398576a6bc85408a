"""Via points as effects: which motion, how far off, by which setting."""

from collections.abc import Iterator

from vrts.base.pose import distance, subtract
from vrts.check.mark.reasons import PROGRAM_ENDS
from vrts.check.verdicts.vias import Lack, Passed, Visits
from vrts.ir.motion import Break
from vrts.why.chain import Link
from vrts.why.left_out import no_use, places_at, skipped, uses_of
from vrts.why.shown import length, offset, point
from vrts.why.slicing.executed import MOTIONS, Steps
from vrts.why.stopped import last_error
from vrts.why.ways import decided, leads, speed_of

FAR = 0.1  # [m] from a point: a motion that ends there is meant for something else [assumed]


def missed_point(steps: Steps, visits: Visits, lack: Lack, points: Passed) -> Iterator[Link]:
    """Yield why the tool did not pass a via point as it was asked for."""
    run, via = steps.run, visits.via
    if lack is Lack.ORDER:
        yield from _order(steps, visits, points)
        return
    time_s = min(visits.best_s, run.horizon_s)
    number = steps.motion_at(time_s)
    stop = last_error(run)
    if stop is not None and run.ending not in PROGRAM_ENDS and stop.cause is not None:
        says = f"the program stops here, before the tool comes to `{via.name}`"
        yield Link(stop.time_s, stop.cause.span, says)
        return
    if number is None:
        return
    motion = run.motions[number]
    at = run.at(time_s).X_WT.translation
    says = f"the tool comes nearest to `{via.name}` at {point(at)}"
    toward, amount = "", ""
    if lack is Lack.PLACE:
        direction, how_far = offset(subtract(at, via.point))
        toward = direction
        within = f"within {length(via.radius)} mm counts"
        amount = f"{how_far}; `{via.name}` is at {point(via.point)}, {within}"
    yield Link(time_s, motion.cause.span, says, toward, amount)
    for beside in (number, number - 1):
        if not 0 <= beside < len(run.motions):
            continue
        one = run.motions[beside]
        if one.blended and distance(one.X_WT.translation, via.point) <= via.radius:
            says = "this motion would come to it, but its end is rounded into the next motion"
            yield Link(one.start_s, one.cause.span, says)
            yield from _not_stopped(steps, beside)
            return
    if lack in {Lack.TOO_FAST, Lack.TOO_SLOW}:
        link = speed_of(steps, number)
        if link is not None:
            yield link
        return
    unused = [c for c in places_at(steps, via.point, via.radius) if not any(uses_of(steps, c))]
    if unused:
        yield from no_use(steps, unused[0])
        return
    nearest = min(
        (n for n in (number - 1, number, number + 1) if 0 <= n < len(run.motions)),
        key=lambda n: distance(run.motions[n].X_WT.translation, via.point),
    )
    link = leads(steps, nearest)
    if _nothing_leads_there(steps, visits):
        yield link._replace(says=f"{link.says}, and no step leads to `{via.name}`")
        return
    yield link
    yield from decided(steps, nearest)


def _not_stopped(steps: Steps, motion: int) -> Iterator[Link]:
    """Yield the BREAK behind a motion that would have stopped the arm, and why it was left out."""
    step = steps.of_motion(motion)
    if step is None:
        return
    program, within = steps.program_of(step.at)
    base = step.at - within
    for k in range(within + 1, len(program.instructions)):
        one = program.instructions[k]
        if isinstance(one, MOTIONS):
            return
        if isinstance(one, Break):
            following = steps.of_motion(motion + 1)
            until = steps.history.finished if following is None else following.number
            if any(step.number < n < until for n in steps.times(base + k)):
                return
            says = "this step would stop the arm there, and is not executed then"
            yield Link(None, program.origins[k].span, says)
            yield from skipped(steps, program, base, k, until)
            return


def _nothing_leads_there(steps: Steps, visits: Visits) -> bool:
    """Return whether no motion ends near a point, and no location has its name."""
    via = visits.via
    ends = (distance(m.X_WT.translation, via.point) for m in steps.run.motions)
    return min(ends, default=FAR) >= FAR and via.name.lower() not in steps.named


def _order(steps: Steps, visits: Visits, points: Passed) -> Iterator[Link]:
    """Yield when the tool passed a point, and which it passed first that comes after it."""
    mine = points.visits.index(visits)
    for start, _ in visits.intervals[:1]:
        yield from _passes(steps, start, f"the tool passes `{visits.via.name}` here")
        for k, other in enumerate(points.visits):
            for begin, _ in other.intervals[:1]:
                if k > mine and begin < start:
                    says = f"it has passed `{other.via.name}` here already, which comes after it"
                    yield from _passes(steps, begin, says)
                elif k < mine and begin > start:
                    says = f"it passes `{other.via.name}` here only, which comes before it"
                    yield from _passes(steps, begin, says)


def _passes(steps: Steps, time_s: float, says: str) -> Iterator[Link]:
    number = steps.motion_at(time_s)
    if number is not None:
        yield Link(time_s, steps.run.motions[number].cause.span, says)
