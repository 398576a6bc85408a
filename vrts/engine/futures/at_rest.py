"""Numbers of arm and hand while they stand still: found by the very objects that they are made of.

What stands still is asked about again and again. Objects are kept lest the id of one that is gone
is given to another.
"""

from typing import Any

from vrts.engine.futures.named import Named
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.arm import arm
from vrts.engine.machine.states.nearly import DIGITS
from vrts.engine.machine.states.state import outside
from vrts.engine.memory.records import Lie, Placement

MOST_KEPT = 256  # quiet arms and hands


class AtRest:
    """Remembers what it was asked about."""

    def __init__(self, named: Named) -> None:
        """Give numbers as `named` does."""
        self._named = named
        self._arms: dict[tuple[object, ...], tuple[int, object]] = {}
        self._parts: tuple[object, ...] = (None,) * 10  # of the arm that was asked about last
        self._ids: tuple[int, ...] = ()  # of these
        self._known: dict[tuple[object, ...], tuple[int, object]] = {}
        # of quiet machines, which share what does not change: by that
        self._quiet_arms: dict[tuple[int, float], tuple[object, int]] = {}
        self._quiet_hands: dict[tuple[object, ...], tuple[object, int]] = {}

    def arm(self, machine: Machine, now: float) -> int:
        """Return the number of what the arm is doing."""
        system, planner = machine.system, machine.system.planner
        if system.parts is None or planner.settings.next:
            return self._arm(machine, now)
        held_s, given = planner.hold_until, planner.given
        key = (id(given), round(held_s - now, DIGITS) if held_s > now else 0.0)
        known = self._quiet_arms.get(key)
        if known is None:
            _keep_few(self._quiet_arms)
            known = self._quiet_arms[key] = (given, self._arm(machine, now))
        return known[1]

    def _arm(self, machine: Machine, now: float) -> int:
        planner = machine.system.planner
        given, scale, settings = planner.given, planner.scale, planner.settings
        end_s = scale.time(given.end_s)
        moves = (
            planner.pending is not None
            or end_s > now
            or planner.braking_until > now
            or scale.knots[-1].time_s > now
            or settings.next
        )
        if moves:
            return self._named.number(arm(machine, now, self._named))
        settles_s, held_s = end_s + planner.settling_s, planner.hold_until
        parts = self._parts
        if (
            planner.configuration is not parts[0]
            or planner.dest is not parts[1]
            or planner.tool_at_dest is not parts[2]
            or planner.branch is not parts[3]
            or planner.ghost is not parts[4]
            or given.stayed is not parts[5]
            or planner.request is not parts[6]
            or settings.always is not parts[7]
            or planner.tool is not parts[8]
            or planner.base is not parts[9]
        ):
            parts = (
                *(planner.configuration, planner.dest, planner.tool_at_dest, planner.branch),
                *(planner.ghost, given.stayed, planner.request, settings.always),
                *(planner.tool, planner.base),
            )
            self._parts, self._ids = parts, tuple(map(id, parts))
        key = (
            round(settles_s - now, DIGITS) if settles_s > now else 0.0,
            round(held_s - now, DIGITS) if held_s > now else 0.0,  # a DELAY holds the arm
            scale.rate,
            planner.overdue,
            self._ids,
        )
        known = self._arms.get(key)
        if known is None:
            number = self._named.number(arm(machine, now, self._named))
            known = self._arms[key] = (number, parts)
        return known[0]

    def outside(self, machine: Machine, now: float) -> int:
        """Return the number of what hand, objects and controller are doing."""
        system = machine.system
        if system.parts is None:
            return self._outside(machine, now)
        key = (id(system.hand), system.draws, system.warned)
        known = self._quiet_hands.get(key)
        if known is None:
            _keep_few(self._quiet_hands)
            known = self._quiet_hands[key] = (system.hand, self._outside(machine, now))
        return known[1]

    def _outside(self, machine: Machine, now: float) -> int:
        system, hand = machine.system, machine.system.hand
        lie = [track[-1] for track in hand.placements.values()]
        moves = (
            hand.closing is not None
            or (bool(hand.strokes) and hand.strokes[-1].end_s > now)
            or bool(system.scheduled)
            or len(system.answers) > system.answers_read
            or _falls(lie, now)
        )
        if moves:
            return self._named.number(outside(machine, now, self._named))
        parts = (*hand.strokes[-1:], *lie) if hand.strokes else tuple(lie)
        more = None
        if system.switches or system.parameters or system.analog:
            cells = [(cell.name, cell.value) for cell in system.parameters.values()]
            more = (*sorted(system.switches.items()), *cells, *sorted(system.analog.items()))
        key = (
            *(hand.held, hand.slips, hand.misses, system.powered, system.warned, system.draws),
            *(system.held_tool.value, system.held_base.value, more, *map(id, parts)),
        )
        known = self._known.get(key)
        if known is None:
            number = self._named.number(outside(machine, now, self._named))
            known = self._known[key] = (number, parts)
        return known[0]


def _keep_few(known: dict[Any, tuple[object, int]]) -> None:
    """Forget what is long over: what is kept there keeps whole motions."""
    if len(known) >= MOST_KEPT:
        known.clear()


def _falls(lie: list[Placement], now: float) -> bool:
    """Return whether something falls, or has not come to lie yet."""
    for one in lie:  # noqa: SIM110 -- half the time of `any`
        if one.start_s > now or one.lie is Lie.FALLING:
            return True
    return False
