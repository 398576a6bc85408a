"""What functions of the language ask of the machine itself, as it changed from time to time.

It changes seldom; each change is noted where it is made, so that what SPEED, DEST, RANDOM and
others would have told at any instant can be looked up, as the values of variables are.
"""

from array import array
from collections.abc import Callable, Mapping
from typing import NamedTuple, cast

from vrts.base.pose import Pose
from vrts.engine.memory.shorter import Columns
from vrts.engine.memory.track import Track
from vrts.robots.kinematics.choice import Request
from vrts.robots.model import ArmBranch, Configuration


class Aim(NamedTuple):
    """Where the arm will be when all motions so far are done, and how the next one begins."""

    dest: Configuration
    X_BT: Pose  # of the tool at the destination
    configuration: Configuration
    branch: ArmBranch
    request: Request


class Executed(NamedTuple):
    """What a program in execution tells others of itself."""

    program: str = ""  # the one run last
    running: bool = False
    kept: bool = False  # it stopped where it may go on
    priority: int = 0
    error: int = 0  # number of its last run-time error; 0: none


def _begin() -> tuple[float, int]:
    return 0.0, 0


class Facts:
    """All changes of one machine; copies share them until `cut` parts them."""

    def __init__(self) -> None:
        """Know nothing yet."""
        self.now: Callable[[], tuple[float, int]] = _begin  # time [s], statements begun
        self.drawn: Track[int] = Track(array("I"))  # states of chance after each RANDOM
        self.left: Track[int] = Track([])  # numbers still to draw before the seed decides
        self.aims: Track[Aim] = Track([])
        self.ends: Track[float] = Track(array("d"))  # of the last motion's path, or of DELAY [s]
        self.stops: Track[float] = Track(array("d"))  # when a stop under way is complete [s]
        self.rates: Track[float] = Track(array("d"))  # monitor speeds as shares
        self.speeds: Track[float] = Track(array("d"))  # SPEED(2) [%]
        self.next_speeds: Track[float] = Track(array("d"))  # SPEED(3) [%]
        self.turns: Track[bool] = Track([])  # joints 4 and 6 may go beyond half a turn
        self.robot: Track[Executed] = Track([])
        self.process: Track[Executed] = Track([])
        # when each, if it is blocked amid a step, is looked at again [s]
        self.robot_wakes: Track[float] = Track(array("d"))
        self.process_wakes: Track[float] = Track(array("d"))
        self.programs: Track[Mapping[str, int]] = Track([])  # those in memory
        self.sizes: Track[int] = Track([])  # of memory: variables that are no arrays
        self.timers: dict[int, Track[float]] = {}  # time at which each stood at zero [s]

    # --- noting -------------------------------------------------------------------------------

    def aim(self, aim: Aim, rate: float) -> None:
        """Note where the arm is to go, and the monitor speed as a share of full speed."""
        now = self.now()
        self.aims.turn(*now, aim)
        self.rates.turn(*now, rate)

    def end(self, time_s: float, braking_until_s: float) -> None:
        """Note when the path, or a DELAY, ends, and when a stop is complete [s]."""
        time, number = self.now()
        ends = self.ends
        if not ends.values or ends.values[-1] != time_s:
            ends.note(time, number, time_s)
        if braking_until_s:
            self.stops.turn(time, number, braking_until_s)

    def speed(self, always: float, following: float, *, turns: bool) -> None:
        """Note speeds [%], for all motions and for the next one, and what joints 4 and 6 may."""
        known, following_known, turns_known = self.speeds, self.next_speeds, self.turns
        if not known.values:
            known.note(0.0, 0, always)
            following_known.note(0.0, 0, following)
            turns_known.note(0.0, 0, turns)
            return
        time, number = self.now()
        if known.values[-1] != always:
            known.note(time, number, always)
        if following_known.values[-1] != following:
            following_known.note(time, number, following)
        if turns_known.values[-1] is not turns:
            turns_known.note(time, number, turns)

    def executes(self, told: Executed, *, robot: bool) -> None:
        """Note what a program tells of itself; it is looked at again."""
        (self.robot if robot else self.process).turn(*self.now(), told)
        self.looked(robot=robot)

    def looked(self, *, robot: bool) -> None:
        """Note that a program is looked at now."""
        wakes = self.robot_wakes if robot else self.process_wakes
        if wakes.values and wakes.values[-1]:
            wakes.note(*self.now(), 0.0)

    def timer(self, number: int) -> Track[float]:
        """Return where it is noted at which times a timer stood at zero [s]."""
        track = self.timers.get(number)
        if track is None:
            track = self.timers[number] = Track(array("d"))
        return track

    # --- versions -----------------------------------------------------------------------------

    def copy(self) -> "Facts":
        """Return facts that share the past."""
        other = Facts.__new__(Facts)
        other.__dict__.update(self.__dict__)
        return other

    def cut(self, time_s: float) -> None:
        """Have tracks of its own, without what came later than a time [s]."""
        self._change(lambda track: track.cut(time_s))

    def forget(self, before_s: float, columns: Columns) -> None:
        """Forget what no longer holds at a time [s]."""
        self._change(lambda track: track.shorter(before_s, columns))

    def _change(self, changed: "Callable[[Track[object]], Track[object]]") -> None:
        for name, track in self.__dict__.items():
            if isinstance(track, Track):
                self.__dict__[name] = changed(cast("Track[object]", track))
        self.timers = {number: changed(track) for number, track in self.timers.items()}  # type: ignore[misc, arg-type]
