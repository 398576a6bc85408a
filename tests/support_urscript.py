"""URScript beside the run: exported, carried out by the interpreter, compared motion by motion."""

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
from vrts.engine.memory.events import SignalChanged
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
) -> tuple[Folder, Run]:
    """Return what is exported, and the run that was verified."""
    place = Path("prog.v2")
    setting = setting_for(place, Where("one-can-ur5"))
    assert setting is not None
    given = {1001: on} if inputs is None else inputs
    scenario = Scenario(inputs=tuple((0.0, signal, state) for signal, state in given.items()))
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
