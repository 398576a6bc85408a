"""URScript beside the run: exported, carried out by the interpreter, compared motion by motion."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from tests.oracle.urscript.interpreter import Motion, Robot
from tests.oracle.urscript.poses import Matrix, Pose, nearest
from vrts.base.source import SourceFile
from vrts.base.units import MM
from vrts.dispatch.urscript.export import Folder, exported_script
from vrts.dispatch.verified import Verified, verified
from vrts.engine.memory.events import Reacted, SignalChanged
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scenario
from vrts.scene.planned import ScenarioFile

CLOSE_MM, CLOSE_RAD = 1e-4, 1e-6  # between motions of the text and of the run


def exported(
    text: str,
    on: bool = False,
    table: str | None = None,
    inputs: Mapping[int, bool] | None = None,
    dialect: str = "val2",
    changes: tuple[tuple[float, int, bool], ...] = (),
) -> tuple[Folder, Run]:
    """Return what is exported, and the run that was verified; `changes` are inputs in time."""
    place = Path("prog.v2")
    setting = setting_for(place, Where("one-can-ur5"))
    assert setting is not None
    given = {1001: on} if inputs is None else inputs
    known = tuple((0.0, signal, state) for signal, state in given.items())
    scenario = Scenario(inputs=(*known, *sorted(changes)))
    setting = replace(setting, scenario=ScenarioFile("inputs", scenario, ""))
    reading = Reading(dialect)
    request = Request(ProgramFile(text.encode(), place.name), setting, reading)
    found = verified(request)
    assert isinstance(found, Verified), found
    source = None if table is None else SourceFile("io.toml", table)
    return exported_script(request, source), found.run


def flange_of(run: Run) -> Callable[[Pose], Matrix]:
    """Return where the flange is in UR's base frame, which is opposed to the scene's."""
    arm = run.scene.robot.arm
    opposed = np.diag([-1.0, -1.0, 1.0, 1.0])

    def flange(joints: Pose) -> Matrix:
        pose = forward(arm, tuple(joints))  # type: ignore[arg-type]
        made = np.eye(4)
        made[:3, :3] = np.reshape(pose.rotation, (3, 3))
        made[:3, 3] = pose.translation
        return opposed @ made

    return flange


def carried_out(text: str, run: Run, on: Callable[[int], bool] | bool) -> list[Any]:
    """Return what the interpreter does."""

    def looked_at(pin: int) -> bool:
        return on(pin) if callable(on) else on and pin == 0

    return Robot(flange_of(run), run.scene.robot.arm.ready, looked_at).run(text)


def same(text: str, run: Run, on: bool, *, rounded: bool = True) -> None:
    """Carry a text out: it moves as the run did."""
    same_motions(carried_out(text, run, on), run, rounded=rounded)


class Off(NamedTuple):
    """How far a motion of the text ends from where the run went."""

    mm: float  # of the flange
    rad: float  # by which the flange is turned
    joints_rad: float  # between the joints nearest to where the arm stood and those of the run


def differences(done: list[Any], run: Run) -> list[Off]:
    """Return how far each motion ends from that of the run."""
    moved = [item for item in done if isinstance(item, Motion)]
    assert len(moved) == len(run.motions) > 0
    flange = flange_of(run)
    stands = np.array(run.scene.robot.arm.ready)
    found: list[Off] = []
    for motion, wanted in zip(moved, run.motions, strict=True):
        if wanted.cut:  # it was given up, and ended elsewhere
            found.append(Off(0.0, 0.0, 0.0))
            stands = np.array(wanted.goal)
            continue
        went = wanted.X_WT @ wanted.X_FT.inverse()
        x, y, z = went.translation
        turned = np.diag([-1.0, -1.0, 1.0]) @ np.reshape(went.rotation, (3, 3))
        between = motion.flange[:3, :3].T @ turned
        joints = nearest(flange, motion.flange, stands)
        found.append(
            Off(
                float(np.linalg.norm(motion.flange[:3, 3] - np.array([-x, -y, z]))) / MM,
                float(np.linalg.norm(between - between.T)) / 8.0**0.5,  # of the sine
                float(np.abs(joints - np.array(wanted.goal)).max()),
            )
        )
        stands = np.array(wanted.goal)
    return found


def same_motions(done: list[Any], run: Run, *, rounded: bool = True) -> None:
    """Motions are of the same kind and speed, and end where the run went."""
    moved = [item for item in done if isinstance(item, Motion)]
    arm = run.scene.robot.arm
    assert all(off.mm < CLOSE_MM and off.rad < CLOSE_RAD for off in differences(done, run))
    for motion, wanted in zip(moved, run.motions, strict=True):
        linear = wanted.interpolation is Interpolation.LINEAR
        assert motion.word == ("movel" if linear else "movej")
        full = arm.linear_speed if linear else min(arm.speed)
        assert motion.v == pytest.approx(wanted.speed_fraction * full)
        assert motion.a == pytest.approx(motion.v / arm.acceleration_time)
        assert not rounded or (motion.r > 0.0) <= wanted.blended


def joints_alike(done: list[Any], run: Run) -> None:
    """UR takes the joints nearest to where the arm stands: those that the run took."""
    assert max(off.joints_rad for off in differences(done, run)) < 1e-4


TICK = 0.028  # [s] VAL-II looks at its steps at ticks, so each wait may take one more
AT_REST = 3 * TICK  # that VAL-II waits at a stop; an output of a motion under way comes at once


def told_alike(done: list[Any], run: Run, pins: dict[int, int]) -> None:
    """Outputs come in the same order and at the same times, reckoned from the motion before."""
    outside = [e for e in run.events if isinstance(e, SignalChanged) and e.signal in pins]
    now, moved, waits, seen = 0.0, 0, 0, dict.fromkeys(pins.values(), False)
    found: list[tuple[float, int, int, bool]] = []
    for item in done:
        if isinstance(item, Motion):
            now, moved, waits = run.motions[moved].end_s, moved + 1, 0
        elif item[0] == "sleep":
            now, waits = now + item[1], waits + 1
        elif item[0] == "out" and item[1] in seen and seen[item[1]] != item[2]:
            seen[item[1]] = item[2]
            found.append((now, waits, item[1], item[2]))
    assert [(pin, on) for *_, pin, on in found] == [(pins[e.signal], e.on) for e in outside]
    for (at, waits, *_), event in zip(found, outside, strict=True):
        assert -1e-6 <= event.time_s - at <= AT_REST + TICK * waits + 1e-6, event


def outputs(text: str, run: Run, on: bool) -> list[tuple[int, bool]]:
    """Return the outputs that a text sets, in order."""
    return [(item[1], item[2]) for item in carried_out(text, run, on) if item[0] == "out"]


class InTime:
    """The interpreter with a clock: motions take as long as in the run, and stop as there."""

    def __init__(self, run: Run, pins: Mapping[int, int]) -> None:
        """Know the run, and the pin of each input; what the scenario says comes in time."""
        self.run, self.pins = run, pins
        self.robot = Robot(
            flange_of(run), run.scene.robot.arm.ready, self._on, self._takes, self._stops
        )

    def time_of(self, run_s: float) -> float:
        """Return when the text is as far as the run was at a time [s]: motions count."""
        begun = [k for k, motion in enumerate(self.run.motions) if motion.start_s <= run_s]
        if not begun:
            return run_s - (self.run.motions[0].start_s if self.run.motions else 0.0)
        whens = [
            when
            for item, when in zip(self.robot.done, self.robot.when, strict=True)
            if isinstance(item, Motion)
        ]
        return (
            math.inf
            if begun[-1] >= len(whens)
            else whens[begun[-1]] + (run_s - self.run.motions[begun[-1]].start_s)
        )

    def _on(self, pin: int) -> bool:
        state = False
        for at, signal, on in sorted(self.run.scenario.inputs):
            if self.pins.get(signal) == pin and self.time_of(at) <= self.robot.now + 1e-9:
                state = on
        return state

    def _takes(self, number: int) -> float:
        motion = self.run.motions[number]
        return motion.end_s - motion.start_s + (60.0 if motion.cut else 0.0)

    def _stops(self, number: int) -> tuple[float, Pose]:
        motion = self.run.motions[number]
        reacted = [e.time_s for e in self.run.events if isinstance(e, Reacted)]
        begun = max(at for at in reacted if motion.start_s <= at <= motion.end_s)
        return motion.end_s - begun, motion.goal

    def carried_out(self, text: str) -> list[Any]:
        """Return what the interpreter does."""
        return self.robot.run(text)

    def told_alike(self, pins: Mapping[int, int]) -> list[float]:
        """Compare outputs with those of the run; return how much later those of the run are [s]."""
        outside = [e for e in self.run.events if isinstance(e, SignalChanged) and e.signal in pins]
        seen = dict.fromkeys(pins.values(), False)
        found: list[tuple[float, int, bool]] = []
        for item, when in zip(self.robot.done, self.robot.when, strict=True):
            if not isinstance(item, Motion) and item[0] == "out" and item[1] in seen:
                if seen[item[1]] != item[2]:
                    found.append((when, item[1], item[2]))
                seen[item[1]] = item[2]
        assert [(pin, on) for _, pin, on in found] == [(pins[e.signal], e.on) for e in outside]
        return [
            self.time_of(event.time_s) - when
            for (when, *_), event in zip(found, outside, strict=True)
        ]
