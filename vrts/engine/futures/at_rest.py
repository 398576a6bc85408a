"""Numbers of arm and hand while they stand still: found by the very objects that they are made of.

What stands still is asked about again and again. Objects are kept lest the id of one that is gone
is given to another.
"""

from vrts.engine.futures.named import Named
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.arm import arm
from vrts.engine.machine.states.nearly import from_now
from vrts.engine.machine.states.state import outside
from vrts.engine.memory.records import Lie


class AtRest:
    """Remembers what it was asked about."""

    def __init__(self, named: Named) -> None:
        """Give numbers as `named` does."""
        self._named = named
        self._known: dict[tuple[object, ...], tuple[int, object]] = {}

    def arm(self, machine: Machine, now: float) -> int:
        """Return the number of what the arm is doing."""
        planner = machine.system.planner
        end_s = planner.path_end
        moves = (
            planner.pending is not None
            or end_s > now
            or planner.braking_until > now
            or planner.scale.knots[-1].time_s > now
            or planner.settings.next
        )
        if moves:
            return self._named.number(arm(machine, now, self._named))
        parts = (
            *(planner.configuration, planner.dest, planner.tool_at_dest, planner.branch),
            *(planner.ghost, planner.given.stayed, planner.request, planner.settings.always),
            *(planner.tool, planner.base),
        )
        settles_s, held_s = end_s + planner.settling_s, planner.hold_until
        waits = (from_now(settles_s, now), from_now(held_s, now))  # a DELAY holds the arm
        key = ("arm", *waits, planner.scale.rate, planner.overdue, *map(id, parts))
        known = self._known.get(key)
        if known is None:
            number = self._named.number(arm(machine, now, self._named))
            known = self._known[key] = (number, parts)
        return known[0]

    def outside(self, machine: Machine, now: float) -> int:
        """Return the number of what hand, objects and controller are doing."""
        system, hand = machine.system, machine.system.hand
        lie = [track[-1] for track in hand.placements.values()]
        moves = (
            hand.closing is not None
            or (bool(hand.strokes) and hand.strokes[-1].end_s > now)
            or bool(system.scheduled)
            or len(system.answers) > system.answers_read
            or any(one.lie is Lie.FALLING or one.start_s > now for one in lie)
        )
        if moves:
            return self._named.number(outside(machine, now, self._named))
        parts = (*hand.strokes[-1:], *lie)
        key = (
            *("outside", hand.held, hand.slips, hand.misses, system.powered, system.warned),
            *(system.draws, *map(id, parts)),
            *sorted(system.switches.items()),
            *[(cell.name, cell.value) for cell in system.cells()],
            *sorted(system.analog.items()),
        )
        known = self._known.get(key)
        if known is None:
            number = self._named.number(outside(machine, now, self._named))
            known = self._known[key] = (number, parts)
        return known[0]
