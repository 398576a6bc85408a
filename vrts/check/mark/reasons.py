"""Why an object is not where it should be: the engine's finding that tells best, if there is one.

No line is better than a wrong one: a hand that closed on nothing tells something of an object only
where it was at it, or where nothing else can be meant.
"""

from collections.abc import Sequence

from vrts.base.pose import Vector, distance
from vrts.base.units import MM
from vrts.engine.hand.told import CLOSED_ON_NOTHING, DROPPED, OFF_CENTRE, TOPPLED
from vrts.engine.memory.events import Found, Grasped
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run, pose_of
from vrts.geometry.support import bounds

PROGRAM_ENDS = (Ending.COMPLETED, Ending.HALTED)

NEAR = 100 * MM  # from the point between the pads to an object that is meant [assumed]
MUCH = 0.5  # of the distance of the next object: so much nearer is meant [assumed]
SAME = 20 * MM  # closing twice here is one attempt [assumed]


def reasons(run: Run, bodies: Sequence[str]) -> dict[str, Found]:
    """Return why objects are not where they should be, by name; not all have a reason.

    Args:
        run: What happened.
        bodies: The objects of which something is asked, whether it is done or not.
    """
    found: dict[str, Found] = {}
    for body in bodies:
        event = _told_of(run, body)
        if event is not None:
            found[body] = event
    if run.ending in PROGRAM_ENDS:
        never = [body for body in bodies if body not in found and not was_grasped(run, body)]
        found |= _closed_on_nothing(run, never)
    return found


def was_grasped(run: Run, body: str, since_s: float = 0.0) -> bool:
    """Return whether an object was in the hand."""
    return any(
        isinstance(event, Grasped) and event.body == body and event.time_s >= since_s
        for event in run.events
    )


def _told_of(run: Run, body: str) -> Found | None:
    """Return what was said of an object itself, if it was not taken up again after that."""
    said = [
        event
        for event in run.events
        if isinstance(event, Found)
        and event.diagnostic.data.get("body") == body
        and not was_grasped(run, body, event.time_s)
    ]
    for rule in (TOPPLED, DROPPED, OFF_CENTRE):
        for event in said:
            if event.diagnostic.rule == rule:
                return event
    return None


def _closed_on_nothing(run: Run, bodies: Sequence[str]) -> dict[str, Found]:
    """Return where the hand closed on nothing instead of taking objects that it never held.

    First whatever it closed at, or much nearer to than to any other object. Of what is left, as
    many attempts as there are objects are for these in turn; with fewer, nobody can tell which
    were meant.
    """
    attempts: list[tuple[Found, Vector]] = []
    for event in run.events:
        if isinstance(event, Found) and event.diagnostic.rule == CLOSED_ON_NOTHING:
            place = _between_pads(run, event.time_s)
            if all(distance(place, other) > SAME for _, other in attempts):
                attempts.append((event, place))
    found: dict[str, Found] = {}
    apart: list[Found] = []
    for event, place in attempts:
        nearest = _meant(run, event.time_s, place)
        if nearest is None:
            apart.append(event)
        elif nearest in bodies:
            found.setdefault(nearest, event)
    left = [body for body in bodies if body not in found]
    if len(apart) >= len(left):
        found |= dict(zip(left, apart, strict=False))
    return found


def _between_pads(run: Run, time_s: float) -> Vector:
    """Return the point between the pads, in W [m]."""
    X_WP = run.at(time_s).X_WF @ run.scene.robot.gripper.X_FP
    return X_WP.translation


def _meant(run: Run, time_s: float, place: Vector) -> str | None:
    """Return the object that a hand closed at, or much nearer to than to others; None: neither."""
    state = run.at(time_s)
    X_WF = state.X_WF
    gaps: dict[str, float] = {}
    for name, placement in state.placements.items():
        X_WO = pose_of(placement, time_s, X_WF)
        box = bounds(run.scene.body(name).pieces, X_WO)
        nearest = tuple(
            min(max(x, low), high) for x, low, high in zip(place, box.lower, box.upper, strict=True)
        )
        gaps[name] = distance(place, (nearest[0], nearest[1], nearest[2]))
    by_gap = sorted(gaps, key=lambda body: gaps[body])
    if not by_gap:
        return None
    first = by_gap[0]
    near = gaps[first] <= NEAR
    much_nearer = len(by_gap) > 1 and gaps[first] <= MUCH * gaps[by_gap[1]]
    return first if near or much_nearer else None
