"""Where the arm is and which way it is on, as plain values, with times told from now on."""

from bisect import bisect_right
from collections.abc import Sequence

from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.nearly import DIGITS, NEARLY, Nearly, from_now
from vrts.engine.memory.records import ArmPiece
from vrts.engine.motion.corner import Leg
from vrts.engine.motion.pending import Pending
from vrts.engine.motion.planner import Planner

OVER = 1e-7  # [s] what lasts no longer is over


def arm(machine: Machine, now: float, named: Nearly = NEARLY) -> tuple[object, ...]:
    """Return where the arm is, the way that it is on, and all that is set for it.

    Args:
        machine: The machine.
        now: The time [s].
        named: What stands for joints, poses and polynomials.
    """
    planner = machine.system.planner
    scale, settings = planner.scale, planner.settings
    path_s = scale.path(now)
    return (
        _ahead(planner.given.pieces, path_s, named),
        _last(planner, path_s, named) if planner.given.end_s > path_s + OVER else None,
        _pending(planner.pending, path_s, named),
        from_now(planner.settled_at, now),
        from_now(planner.motion_end, now),
        from_now(planner.braking_until, now),
        (named(planner.configuration), named(planner.dest), named(planner.tool_at_dest)),
        (planner.branch, named(planner.ghost), named(planner.given.stayed), planner.overdue),
        (
            planner.request,
            settings.always,
            tuple(sorted(settings.next.items(), key=_name)),
        ),
        (named(planner.tool), named(planner.base)),
        scale.rate,
        tuple(
            [
                (from_now(knot.time_s, now), knot.rate, knot.slope)
                for knot in scale.knots
                if knot.time_s > now
            ]
        ),
        round(scale.rate_at(now), DIGITS),
    )


def _ahead(pieces: Sequence[ArmPiece], path_s: float, named: Nearly) -> object:
    """Return what is left of the path, and how far the arm has come on it."""
    if not pieces or pieces[-1].end_s <= path_s + OVER:
        return None
    first = bisect_right(pieces, path_s + OVER, key=_end)
    return named.chain(pieces, first), round(pieces[first].start_s - path_s, DIGITS)


def _last(planner: Planner, path_s: float, named: Nearly) -> tuple[object, ...]:
    """Return what is still asked of the motion under way: a corner is made of it."""
    motion = planner.given.motions[-1]
    shape = (motion.interpolation, motion.X_FT, motion.speed_fraction)
    begun = round(motion.start_s - path_s, DIGITS) if motion.start_s > path_s else 0.0
    ends = (named(motion.start), named(motion.goal))
    return (shape, ends, begun, motion.cut, _leg(planner.leg, path_s, named))


def _leg(leg: Leg | None, path_s: float, named: Nearly) -> tuple[object, ...] | None:
    if leg is None:
        return None
    return (named(leg.path), leg.profile, round(leg.departure - path_s, DIGITS), leg.deceleration)


def _pending(pending: Pending | None, path_s: float, named: Nearly) -> tuple[object, ...] | None:
    if pending is None:
        return None
    corner = pending.corner
    return (
        round(pending.start_s - path_s, DIGITS),
        (named(corner.goal), corner.branch, _leg(corner.leg, path_s, named)),
        (named(pending.target), pending.intent.settings, pending.intent.keeps_request),
        _ahead(pending.replaced.pieces, path_s, named),
    )


def _name(setting: tuple[str, object]) -> str:
    return setting[0]


def _end(piece: ArmPiece) -> float:
    return piece.end_s
