"""What expressions read, as it was at an instant: it stands in for a program in execution.

The engine's closures take their values from cells, signals and the arm of a context. Here is one
whose cells hold what the histories of a run say.
"""

from bisect import bisect_left, bisect_right
from collections.abc import ItemsView, Mapping, ValuesView
from functools import cached_property

import numpy as np

from vrts.base.pose import IDENTITY, Pose
from vrts.base.source import Span
from vrts.controllers.model import ControllerModel
from vrts.debug.conditions.columns import Bools, Reals, Wholes
from vrts.debug.conditions.timers import Timers, timers_of
from vrts.engine.memory.cells import UNDEFINED, Bound, Cell, Memory
from vrts.engine.memory.events import SignalChanged, SwitchChanged
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.signals import known
from vrts.engine.run import Run
from vrts.ir.system import SWITCHES
from vrts.robots.model import Arm, Configuration, Gripper

Track = tuple[list[float], list[int], list[bool]]  # times [s], statements finished, on


class Tracks:
    """Signals and switches of a run, each with all its changes: looked up, not replayed."""

    def __init__(self, run: Run) -> None:
        """Take a run; it is gone through once."""
        self._known: dict[int | str, Track] = {}
        for event, number in zip(run.events, run.event_numbers, strict=True):
            match event:
                case SignalChanged(signal=changed, on=on) | SwitchChanged(switch=changed, on=on):
                    times, numbers, states = self._known.setdefault(changed, ([], [], []))
                    times.append(event.time_s)
                    numbers.append(number)
                    states.append(on)
                case _:
                    pass

    def at(self, name: int | str, time_s: float, finished: int) -> bool | None:
        """Return the state of a signal or switch; None where it never changed before."""
        track = self._known.get(name)
        if track is None:
            return None
        times, numbers, states = track
        k = bisect_right(times, time_s) - 1
        earlier = bisect_left(times, time_s - INSTANT)
        while k >= earlier and numbers[k] > finished:
            k -= 1
        return states[k] if k >= 0 else None

    def columns(self, name: int | str) -> "TrackColumns | None":
        """Return the track of a signal or switch as arrays; None where it never changed."""
        track = self._known.get(name)
        return None if track is None else TrackColumns(track)


class TrackColumns:
    """All changes of a signal or switch, looked up for many instants at once."""

    def __init__(self, track: Track) -> None:
        """Take the changes."""
        self._times, self._numbers, self._states = (np.array(column) for column in track)

    def states(self, times: Reals, finished: Wholes) -> Bools:
        """Return what `Tracks.at` does at each instant; off where it never changed before."""
        last = np.searchsorted(self._times, times, side="right") - 1
        earlier = np.searchsorted(self._times, times - INSTANT, side="left")
        done = np.searchsorted(self._numbers, finished, side="right") - 1
        k = np.maximum(np.minimum(last, done), earlier - 1)
        return (k >= 0) & self._states[k]


class Past:
    """A program in execution, as far as expressions look at it."""

    def __init__(self, run: Run, tracks: Tracks) -> None:
        """Begin at the first instant, without variables."""
        self._run, self._tracks = run, tracks
        self.now, self.finished = 0.0, 0
        self.memory = Memory([])
        self.slots: list[Bound] = []
        self.signals = _Signals(self)
        self.system = _System(self)
        self.planner = _Arm(self)
        self.hand = _Hand(self)

    @cached_property
    def timers(self) -> Timers | None:
        """What timers were set to; None where that was worked out, and not recorded."""
        return timers_of(self._run)

    @property
    def tracks(self) -> Tracks:
        """All changes of signals and switches."""
        return self._tracks

    @property
    def run(self) -> Run:
        """Whose past it is."""
        return self._run

    def state_of(self, name: int | str) -> bool | None:
        """Return the state of a signal or switch; None where it is as at first."""
        return self._tracks.at(name, self.now, self.finished)


class _Signals:
    """Signals: whether each is on."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @property
    def on(self) -> "_Signals":
        return self

    def __contains__(self, number: int) -> bool:
        return self._past.state_of(number) or False

    def holds(self, number: int, span: Span | None) -> bool:
        """Return what `Signals.holds` of the engine does."""
        if number == 0:
            return True
        known(number, span)
        return (abs(number) in self) is (number > 0)


class _System:
    """Switches."""

    def __init__(self, past: Past) -> None:
        self._past = past

    clock_reads = 0  # nobody counts how often somebody looks

    @property
    def timers(self) -> Mapping[int, float]:
        """The times at which timers stood at zero [s]."""
        known = self._past.timers
        return {} if known is None else known.at(self._past.finished)

    def parameter(self, name: str, otherwise: float) -> float:
        """Return what `System.parameter` of the engine does."""
        cell = self._past.run.history.memory.parameters.get(name)
        held = UNDEFINED if cell is None else cell.at(self._past.finished)
        return held if isinstance(held, float) else otherwise

    def is_on(self, switch: str) -> bool:
        """Return whether a switch is on."""
        state = self._past.state_of(switch)
        if state is None:
            first = SWITCHES.get(switch)
            return first is not None and first.on
        return state


class _Arm:
    """Where the arm is, and what TOOL and BASE have set."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @cached_property
    def arm(self) -> Arm:
        """The arm as its controller counts."""
        return self._past.run.scene.robot.arm

    @property
    def model(self) -> ControllerModel:
        """How its controller is taken to work."""
        return self._past.run.scene.controller

    @property
    def base(self) -> Pose:
        """What BASE has set."""
        held = self._past.run.history.memory.base.at(self._past.finished)
        return held if isinstance(held, Pose) else IDENTITY

    @property
    def tool(self) -> Pose:
        """What TOOL has set."""
        held = self._past.run.history.memory.tool.at(self._past.finished)
        return held if isinstance(held, Pose) else self._past.run.scene.X_FT

    def configuration_at(self, time_s: float) -> Configuration:
        """Return the positions of the joints [rad]."""
        return self._past.run.timeline.configuration(time_s)


class _Hand:
    """The hand."""

    def __init__(self, past: Past) -> None:
        self._past = past

    @property
    def gripper(self) -> Gripper:
        """What it can."""
        return self._past.run.scene.robot.gripper

    def opening(self, time_s: float) -> float:
        """Return the opening [m]."""
        return self._past.run.timeline.opening(time_s)


class Elements(dict[tuple[int, ...], Cell]):
    """Elements of an array, as they were at the instant at which they are asked for."""

    def __init__(self, past: Past) -> None:
        """Begin without elements."""
        super().__init__()
        self._past = past
        self._source: Mapping[tuple[int, ...], Cell] = {}

    def stand_for(self, source: Mapping[tuple[int, ...], Cell]) -> None:
        """Be the elements of an array with a history."""
        if source is not self._source:
            self._source = source
            self.clear()

    def get(self, key: tuple[int, ...], default: Cell | None = None) -> Cell | None:  # type: ignore[override]
        """Return an element with its value then."""
        found = self._source.get(key)
        cell = super().get(key, default)
        if found is None:
            return cell
        if cell is None:
            cell = self[key] = Cell(found.name)
        cell.value = found.at(self._past.finished)
        return cell

    def _all(self) -> dict[tuple[int, ...], Cell]:
        return {key: cell for key in self._source if (cell := self.get(key)) is not None}

    def items(self) -> ItemsView[tuple[int, ...], Cell]:  # type: ignore[override]
        """Return all elements."""
        return self._all().items()

    def values(self) -> ValuesView[Cell]:  # type: ignore[override]
        """Return all elements without their subscripts."""
        return self._all().values()
