"""What state a future is in, as a short key: futures with the same key go on alike.

Parts of a state come again far more often than states: each is kept once, under a number.
"""

from collections.abc import Collection, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias, cast

from vrts.engine.code.values.operands import number_of
from vrts.engine.code.values.volatile import CLOCKS
from vrts.engine.futures.ahead import Ahead
from vrts.engine.futures.at_rest import AtRest
from vrts.engine.futures.named import Named
from vrts.engine.futures.regions import Numbers, compared_only, region
from vrts.engine.futures.since import Held
from vrts.engine.futures.timers import most_compared, timers_read
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.engine.machine.machine import Machine, in_turn, statement_under_way
from vrts.engine.machine.states.nearly import DIGITS, from_now
from vrts.engine.machine.states.state import programs, waits_for
from vrts.engine.memory.cells import UNDEFINED, Array, Bound
from vrts.engine.memory.records import Ending
from vrts.engine.programs.context import Context
from vrts.engine.programs.outside import FreeSignals
from vrts.ir.expressions import Apply, Function
from vrts.ir.module import Module

Key: TypeAlias = tuple[Any, ...]
NOTHING: Collection[int] = frozenset()
NOBODY: Mapping[str, Held] = MappingProxyType({})


class Clocks(NamedTuple):
    """Which clocks the programs of a module read."""

    timers: frozenset[int | None]  # None: one whose number is computed
    day: bool  # TIME and the like: no two times are alike
    random: bool
    most_s: float  # all readings of timers beyond this are alike; inf: no two are

    @classmethod
    def of(cls, module: Module, since: Collection[str] = ()) -> "Clocks":
        """Go through the programs.

        Args:
            module: The programs.
            since: Variables that hold readings, of which only the time that has passed is asked.
        """
        reads = [
            node
            for program in module.programs.values()
            for instruction in program.instructions
            for top in tops(instruction)
            for node in all_nodes(top)
            if isinstance(node, Apply) and node.function in CLOCKS
        ]
        read = {node.function for node in reads}
        return cls(
            frozenset(number_of(timer.arguments[0]) for timer in timers_read(module, since)),
            bool(read - {Function.TIMER, Function.RANDOM}),
            Function.RANDOM in read,
            most_compared(module, since),
        )

    def reads_since_start(self, machine: Machine) -> bool:
        """Return whether something may be read that counts from the controller's start."""
        return self.day or any(timer not in machine.system.timers for timer in self.timers)


class Keys:
    """Gives states their keys. Equal keys are of one explorer only."""

    def __init__(
        self, module: Module, idle: Collection[int] = NOTHING, since: Mapping[str, Held] = NOBODY
    ) -> None:
        """Read what decides about the state in the programs of a module.

        Args:
            module: The programs.
            idle: Numbers of variables that decide nothing, whatever they hold.
            since: Variables that hold readings, of which only the time that has passed is asked.
        """
        self._idle, self.since = idle, since
        self._clocks = clocks = Clocks.of(module, since.keys())
        self._timeless = not (clocks.timers or clocks.day or clocks.random)
        self._ahead = Ahead(module)
        self._compared = compared_only(module)
        self._regions: dict[int, Numbers] | None = None  # the same, by number of the variable
        self._since: dict[int, Held] = {}  # those of `since`, by number
        self._named = Named()
        self._rest = AtRest(self._named)

    def of(self, machine: Machine, *more: object) -> Key:
        """Return the key of a state, at the end of a tick or within one.

        Args:
            machine: The machine.
            more: What else tells states apart.
        """
        now, signals, named = machine.now, machine.system.signals, self._named
        on: object = frozenset(signals.on) if signals.on else None
        if signals.counts:
            on = on, *sorted(signals.counts.items())
        return (
            self._programs(machine, now),
            self._rest.arm(machine, now),
            self._rest.outside(machine, now),
            self._contents(machine, self._idle),
            -1 if on is None else named.number(on),
            machine.next_tick - machine.last_tick,
            named.number((self._times(machine, now), self._within(machine), more)),
        )

    def apart(self, key: Key, machine: Machine, left_out: Collection[int]) -> Key:
        """Return the key of the same state without what some variables hold."""
        return (*key[:3], self._contents(machine, left_out), *key[4:])

    def _programs(self, machine: Machine, now: float) -> int:
        """Return the number of where programs are, and what they wait for."""
        named, process = self._named, machine.process
        if not process.frames and process.ending is Ending.NOT_STARTED:
            brief = _briefly(machine.robot, now)
            if brief is not None:
                return named.number((brief, process.program))
        return named.number(programs(machine, now, named))

    def _contents(self, machine: Machine, left_out: Collection[int]) -> int:
        """Return the number of what variables hold; of some only whether they hold anything."""
        bound, regions = machine.system.memory.bound, self._regions
        if regions is None:
            numbers = machine.executable.layout.numbers
            regions = {numbers[k]: v for k, v in self._compared.items() if k in numbers}
            self._regions = regions
            self._since = {numbers[k]: v for k, v in self.since.items() if k in numbers}
        if not (left_out or regions or self._since):
            content = self._content
            return self._named.number(
                tuple([v if type(v := item.value) is float else content(item) for item in bound])
            )
        held: list[object] = []
        for k, item in enumerate(bound):
            value = item.value
            if k in left_out:
                held.append(value is UNDEFINED)
            elif k in regions and isinstance(value, float):
                held.append(region(value, regions[k]))
            elif k in self._since and isinstance(value, float):
                held.append(self._since[k].passed(machine, value))
            else:
                held.append(self._content(item))
        return self._named.number(("but", *held) if left_out else tuple(held))

    def _times(self, machine: Machine, now: float) -> Key | None:
        system, clocks = machine.system, self._clocks
        if self._timeless and system.parts is not None and not machine.issued:
            return None
        since_start = self._since_start(machine)
        if not (since_start or clocks.timers or clocks.random or machine.issued):
            return None
        timers = sorted(system.timers.items()) if clocks.timers else []
        return (
            tuple([(n, round(min(now - t, clocks.most_s), DIGITS)) for n, t in timers]),
            since_start,
            system.random_state if clocks.random else 0,
            tuple([(from_now(at, now), repr(order)) for at, order, _ in machine.issued]),
        )

    def _since_start(self, machine: Machine) -> float:
        """Return how long it is since the controller's start, as far as that matters."""
        clocks = self._clocks
        if clocks.day or _is_told(machine):
            return machine.last_tick
        if not clocks.timers or not clocks.reads_since_start(machine):
            return 0
        return min(machine.now, clocks.most_s)

    def _within(self, machine: Machine) -> Key | None:
        """Return how far a tick has come, and what was decided that may still be looked at."""
        mid, on, outside = machine.mid, machine.system.signals.on, machine.system.outside
        if mid is None:
            return None
        assert isinstance(on, FreeSignals)
        assert outside is not None
        decided: frozenset[tuple[int, float]] | None = None
        if on.decided:
            ahead = self._ahead.of(machine)
            decided = frozenset([it for it in on.decided.items() if it[0] in ahead]) or None
        drawn = outside.draws and outside.place == statement_under_way(machine)
        draws = tuple(outside.draws) if drawn else ()
        progress = machine.finished != mid.finished
        stirred = machine.system.signals.changes != mid.changes
        steps = mid.steps
        if steps is not None:
            c = in_turn(machine)[mid.turn]
            steps = None if steps >= self._ahead.statements(c) else steps
        begun = mid.steps is not None
        order = mid.turn, mid.process_first
        return (order, begun, steps, progress, stirred, on.looked, decided, draws)

    def _content(self, bound: Bound) -> object:
        if isinstance(bound, Array):
            held = bound.elements.items()
            found = [(k, self._value(c.value)) for k, c in held if c.value is not UNDEFINED]
            return tuple(sorted(found, key=_subscripts))
        return self._value(bound.value)

    def _value(self, value: object) -> object:
        return self._named(cast("object", value)) if isinstance(value, tuple) else value


def _briefly(c: Context, now: float) -> Key | None:
    """Return where a program is that only goes on, step by step; None: there is more to it."""
    if (
        c.ending is not Ending.RUNNING
        or len(c.frames) != 1
        or c.frames[0].slots
        or c.watches
        or c.next_hand
        or c.operands is not None
        or c.fault is not None
        or c.last_error is not None
        or c.error_program is not None
        or c.kept_cycles is not None
        or c.steps_left is not None
        or c.reactions_wait
        or c.finishing
        or c.at_once
        or c.step_was_cut
    ):
        return None
    frame, wake = c.frames[0], c.wake
    inside = None
    if frame.limits or frame.cases:
        inside = (tuple(frame.limits), tuple(frame.increments), tuple(frame.cases))
    waits: object = from_now(wake, now) if wake > now else 0.0
    if c.phase:
        motions = len(c.system.planner.given.motions)
        waits = (waits, c.phase, waits_for(c, 0, c.phase, c.until, now, motions))
    at = (frame.program, frame.index, frame.kind, c.priority)
    return (*at, waits, c.program, c.cycles_left, inside)


def _is_told(machine: Machine) -> bool:
    """Return whether the scenario still tells of something that comes at a time."""
    signals, scenario = machine.system.signals, machine.scenario
    return (
        signals.next_input_s is not None
        or machine.faults_done < len(scenario.faults)
        or machine.turns_done < len(scenario.process_first)
    )


def _subscripts(item: tuple[tuple[int, ...], object]) -> tuple[int, ...]:
    return item[0]
