"""Changes of where the arm, a joint, the tool and the fingers are: motions and strokes."""

from bisect import bisect_right

from vrts.debug.history.cells import writes
from vrts.debug.history.track import Moment, Track, joined
from vrts.debug.passages import Instant, at_time
from vrts.engine.memory.events import HandCommanded
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run


def motions(run: Run, joint: int | None = None) -> list[Moment]:
    """Return the spells in which the arm, or one joint (from 0), moves: one for each motion."""
    rows = slice(0, 6) if joint is None else slice(joint, joint + 1)
    spells: list[tuple[float, float, int]] = []
    for segment in run.timeline.segments:
        moves = any(any(row[1:]) for row in segment.coefficients[rows])
        if segment.motion is None or not moves:
            continue
        last = spells[-1] if spells else None
        if last is not None and last[2] == segment.motion:
            spells[-1] = (last[0], segment.end_s, segment.motion)
        else:
            spells.append((segment.start_s, segment.end_s, segment.motion))
    return [
        Moment(at_time(run, start), end, None, run.motions[motion].cause)
        for start, end, motion in spells
    ]


def of_joint(run: Run, joint: int) -> Track:
    """Return the motions of a joint, from 0; its position [rad]."""
    return Track(
        run,
        f"joint {joint + 1}",
        lambda at: run.at(at.time_s).configuration[joint],
        motions(run, joint),
    )


def of_arm(run: Run) -> Track:
    """Return the motions of the arm; the positions of its joints [rad]."""
    return Track(run, "the arm", lambda at: run.at(at.time_s).configuration, motions(run))


def of_here(run: Run) -> Track:
    """Return what changes HERE: motions, and what TOOL and BASE set."""
    memory = run.history.memory
    moments = [*motions(run), *writes(run, memory.tool), *writes(run, memory.base)]

    def read(at: Instant) -> object:
        state = run.at_moment(at.time_s, at.finished)
        return state.base @ state.X_WT

    return Track(run, "HERE", read, joined(moments))


def of_opening(run: Run) -> Track:
    """Return the strokes of the fingers; their opening [m]."""
    told = sorted((e for e in run.events if isinstance(e, HandCommanded)), key=_time)
    strokes, timeline = run.history.hand.strokes, run.timeline
    found: list[Moment] = []
    for k, stroke in enumerate(strokes):
        if stroke.start_s > run.horizon_s:
            break
        end = min(stroke.end_s, run.horizon_s)
        if k + 1 < len(strokes):
            end = min(end, strokes[k + 1].start_s)
        before = timeline.opening(max(stroke.start_s - INSTANT, 0.0))
        if end <= stroke.start_s or timeline.opening(end) == before:
            continue
        number = bisect_right(told, stroke.start_s + INSTANT, key=_time)
        cause = told[number - 1].cause if number else None
        by = "" if cause is not None else "a command"
        found.append(Moment(at_time(run, stroke.start_s), end, None, cause, by))
    return Track(run, "the opening", lambda at: run.timeline.opening(at.time_s), joined(found))


def _time(event: HandCommanded) -> float:
    return event.time_s
