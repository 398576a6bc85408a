"""Changes of where a thing is, and of what the hand holds."""

from collections.abc import Iterator

from vrts.debug.history.arm import motions
from vrts.debug.history.track import Moment, Track, joined
from vrts.debug.passages import Instant, at_time
from vrts.engine.memory.events import Cause, Grasped, Landed, Released, Toppled
from vrts.engine.memory.records import INSTANT, Lie
from vrts.engine.run import Run

_SAYS = {
    Lie.HELD: "it is gripped",
    Lie.FALLING: "it falls",
    Lie.RESTING: "it comes to rest",
    Lie.TOPPLED: "it cannot stand",
}


def of_thing(run: Run, name: str) -> Track:
    """Return the changes of a thing's place: grips, motions of the arm with it, falls, rests."""

    def read(at: Instant) -> object:
        state = run.at(at.time_s)
        placement = state.placements[name]
        return state.poses[name], placement.lie.value, placement.support

    return Track(run, f"the place of {name}", read, joined(_moves(run, name)))


def of_held(run: Run) -> Track:
    """Return when the hand takes hold of something, or lets it go."""
    found: list[Moment] = []
    for name, track in run.placements.items():
        held = False
        for placement in track:
            now = placement.lie is Lie.HELD and placement.support is None
            if now is not held and 0.0 < placement.start_s <= run.horizon_s:
                by, cause = _by(run, name, placement.start_s)
                says = by or ("it is gripped" if now else "it is let go")
                instant = at_time(run, placement.start_s)
                found.append(Moment(instant, placement.start_s, None, cause, says))
            held = now
    return Track(run, "what is held", lambda at: run.at(at.time_s).held, joined(found))


def _moves(run: Run, name: str) -> Iterator[Moment]:
    arm = motions(run)
    for k, placement in enumerate(run.placements[name]):
        start, end = placement.start_s, min(placement.end_s, run.horizon_s)
        if start > run.horizon_s:
            return
        if k:
            settled = end if placement.lie is Lie.FALLING else start
            _, cause = _by(run, name, start)
            yield Moment(at_time(run, start), settled, None, cause, _SAYS[placement.lie])
        if placement.lie is not Lie.HELD:
            continue
        for moment in arm:
            begun, over = moment.instant.time_s, moment.settled_s
            if over > start + INSTANT and begun < end - INSTANT:
                at = moment.instant if begun > start else at_time(run, start)
                yield moment._replace(instant=at, settled_s=min(over, end), by="the arm carries it")


def _by(run: Run, body: str, time_s: float) -> tuple[str, Cause | None]:
    """Return by which step a thing lies otherwise from a time on."""
    for event in run.events:
        if (
            isinstance(event, Grasped | Released | Landed | Toppled)
            and event.body == body
            and abs(event.time_s - time_s) < INSTANT
        ):
            return "", event.cause
    return "", None
