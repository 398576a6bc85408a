"""From session to program: whatever moved the arm or the hand, as a VAL-II program.

It is made of the run, not of what was typed or clicked, so it holds what buttons, keys, pointer,
monitor and programs did alike: every motion goes to a named location, and where the arm stopped on
the way, for panic or because a key was let go, it goes only so far.

Paths are the same within the 0.1 um and 0.0001 degrees of `.LOCATIONS`, with one exception: where a
motion that was rounded into the next one is followed by one that was stopped, the corner is that of
the shorter motion. Times are not the same: nobody wants to wait again, and panic is no instruction.
"""

import re
from bisect import bisect_right
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from vrts.base.oat import components, pose_from_components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile, Span
from vrts.base.units import DEG, deg
from vrts.engine.memory.events import HandCommanded, SignalChanged
from vrts.engine.memory.records import INSTANT, Motion
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.ir.module import Datum, Module
from vrts.ir.values import Joints
from vrts.lang.dialect import VAL2
from vrts.lang.writing.store import DECIMALS, store_text
from vrts.live.session.growing.deeds import MOST_STEPS, Deeds, moving, telling
from vrts.monitor.desk import is_name
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.kinematics.choice import Choice, choose
from vrts.robots.model import Arm, ArmBranch, Configuration

NOTHING = Deeds()
SAME_ANGLE = 1e-5  # [rad] joints this near are the same for a program
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.]*", re.ASCII)


class _Happening(NamedTuple):
    """Something the program has to do."""

    time_s: float
    rank: int  # of one instant: what goes with the next motion, the motion, what follows it
    what: Motion | str


def is_program_name(name: str) -> bool:
    """Return whether a program can have a name."""
    return _NAME.fullmatch(name) is not None and is_name(name)


def as_program(run: Run, name: str, before: Deeds = NOTHING, since_s: float = 0.0) -> str:
    """Return a program that makes the motions of a run again, with its `.LOCATIONS`.

    Args:
        run: What was done.
        name: Of the program.
        before: What was done that the run does not tell of any more.
        since_s: From when on it does [s].
    """
    writer = _Writer(run)
    happenings = sorted(_happenings(run, before, since_s), key=lambda each: each[:2])
    for this, following in zip(happenings, [*happenings[1:], None], strict=False):
        if len(writer.steps) >= MOST_STEPS:
            writer.steps.append(f"; more was done than {MOST_STEPS} steps")
            break
        writer.write(this, following)
    steps = writer.steps or ["; nothing was done"]
    text = "".join(f"    {step}\n" for step in steps)
    return f".PROGRAM {name.lower()}()\n{text}.END\n{writer.locations}"


def _happenings(run: Run, before: Deeds, since_s: float) -> Iterable[_Happening]:
    tick = run.scene.robot.arm.tick
    given = (motion for motion in run.motions if motion.start_s < run.horizon_s)
    motions = [*before.motions, *moving(given)]
    starts = [motion.start_s for motion in motions]
    for motion in motions:
        yield _Happening(motion.start_s, 1, motion)
    later = (event for event in run.events if event.time_s >= since_s)
    for event in (*before.events, *telling(later)):
        match event:
            case HandCommanded(time_s=time_s, action=action):
                k = bisect_right(starts, time_s - 0.5 * tick)
                if k < len(starts) and starts[k] < time_s + 0.5 * tick:
                    yield _Happening(starts[k], 0, action.upper())
                else:
                    yield _Happening(time_s, 2, f"{action.upper()}I")
            case SignalChanged(time_s=time_s, signal=signal, on=on):
                yield _Happening(time_s, 2, f"SIGNAL {signal if on else -signal}")
            case _:
                pass


class _Writer:
    """Collects steps and locations."""

    def __init__(self, run: Run) -> None:
        self.steps: list[str] = []
        self._arm: Arm = run.scene.robot.arm
        self._tool = run.scene.X_FT
        self._rules = run.scene.controller.branches
        self._branch: ArmBranch = branch_of(
            *(self._arm, run.scenario.configuration or self._arm.ready, INITIAL_BRANCH),
            self._rules,
        )
        self._names: dict[str, str] = {}  # what STORE writes of a location, and its name
        self._values: dict[str, Pose | Joints] = {}
        self._own = _taught(run.at(run.horizon_s).variables)

    @property
    def locations(self) -> str:
        """The `.LOCATIONS` section; empty without locations."""
        span = Span(SourceFile("session", ""), 0, 0)
        data: list[Datum] = []
        for title, value in self._values.items():
            name, _, indices = title.rstrip("]").partition("[")
            subscripts = tuple(map(int, indices.split(","))) if indices else ()
            data.append(Datum(name, subscripts, value, span))
        return store_text(span.source, Module({}, tuple(data)), VAL2)

    def write(self, this: _Happening, following: _Happening | None) -> None:
        """Write the steps of one happening."""
        if isinstance(this.what, str):
            self.steps.append(this.what)
            return
        motion = this.what
        if self._tool != motion.X_FT:
            self._tool = motion.X_FT
            self.steps.append(f"TOOL {self._named(motion.X_FT, 'tool')}")
        percent = 100.0 * motion.speed_fraction
        if abs(percent - 100.0) > 1e-6:
            self.steps.append(f"SPEED {percent:.6g}")
        self.steps.append(self._motion(motion))
        self._branch = branch_of(self._arm, motion.goal, self._branch, self._rules)
        joined = motion.blended and following is not None and isinstance(following.what, Motion)
        if not joined and following is not None:
            self.steps.append("BREAK")

    def _motion(self, motion: Motion) -> str:
        if motion.interpolation is Interpolation.LINEAR:
            return f"MOVES {self._named(motion.X_WT, 'p')}"
        if _same(motion.goal, self._arm.ready):
            return "READY"
        if self._leads_to(motion):
            return f"MOVE {self._named(motion.X_WT, 'p')}"
        return f"MOVE {self._named(motion.goal, '#q')}"

    def _leads_to(self, motion: Motion) -> bool:
        """Return whether a MOVE to the pose, as it is written, takes the joints that were taken."""
        x, y, z, o, a, t = (round(n, DECIMALS) for n in components(motion.X_WT))
        X_BF = pose_from_components(x, y, z, o, a, t) @ motion.X_FT.inverse()
        found = choose(self._arm, X_BF, self._branch, motion.start)
        return isinstance(found, Choice) and _same(found.configuration, motion.goal)

    def _named(self, value: Pose | Joints, stem: str) -> str:
        """Return the name of a location; the same for the same one."""
        written = _written(value)
        known = self._names.get(written) or self._own.get(written)
        if known is None:
            number = 1
            taken = {*self._values, *self._own.values()}
            while f"{stem}{number}" in taken:
                number += 1
            known = f"{stem}{number}"
        self._names[written] = known
        self._values[known] = value
        return known


def _taught(variables: Mapping[str, object]) -> dict[str, str]:
    """Return the names of the locations that users have given, by what STORE writes of them."""
    found: dict[str, str] = {}
    for name, value in variables.items():
        if isinstance(value, tuple):
            found.setdefault(_written(value), name)  # type: ignore[arg-type]
    return found


def _written(value: Pose | Joints) -> str:
    if isinstance(value, Pose):
        return " ".join(f"{round(n, DECIMALS) + 0.0:.4f}" for n in components(value))
    return "#" + " ".join(f"{round(deg(q), DECIMALS) + 0.0:.4f}" for q in value)


def _same(a: Configuration, b: Configuration) -> bool:
    near = max(abs(p - q) for p, q in zip(a, b, strict=True))
    return near < max(SAME_ANGLE, 0.0005 * DEG, INSTANT)
