"""What properties ask of an instant, of a machine that goes on or of a run."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.pose import Vector
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Cause
from vrts.engine.programs.cycles import place
from vrts.engine.programs.outside import FreeSignals, as_known
from vrts.engine.run import Run
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.robots.model import Configuration

LITTLE = 1e-9  # [rad] a joint that turns no more in a tick stands still


def _looked(_number: int) -> bool:
    return True


class Moment(NamedTuple):
    """A machine or a run at an instant, at the end of its tick."""

    time_s: float
    # whether a signal is on; None: an input that nobody has decided, so either
    signal: Callable[[int], bool | None]
    opening_m: float  # of the hand
    held: bool  # the hand holds something
    tool: Vector  # in W [m]
    still: bool  # the arm does not move
    step: tuple[str, int] | None  # program and step that the robot program has come to
    # whether a program has looked at a signal, or set it: what it is needs no telling
    looked: Callable[[int], bool] = _looked


def of_machine(machine: Machine, tick: int) -> Moment:
    """Return a machine at a tick, not before its last one and before its next one.

    Between these two no program does anything, so only arm and hand are different.
    """
    system = machine.system
    planner, hand = system.planner, system.hand
    time_s = tick * machine.tick
    q = planner.configuration_at(time_s)
    before = planner.configuration_at(max(time_s - machine.tick, 0.0))
    signals = system.signals.on

    def signal(number: int) -> bool | None:
        if isinstance(signals, FreeSignals) and number in signals.free:
            return as_known(signals, number) if tick == machine.last_tick else None
        return number in signals

    return Moment(
        time_s,
        signal,
        hand.opening(time_s),
        hand.held is not None,
        (hand_pose(planner.arm, q) @ planner.tool).translation,
        _still(before, q),
        _step(place(machine.robot)),
    )


def of_run(run: Run, tick: int) -> Moment:
    """Return a run at a tick."""
    length = run.scene.robot.arm.tick
    time_s = tick * length
    state, before = run.at(time_s), run.at(max(time_s - length, 0.0))
    robot = state.robot
    on = state.signals

    def signal(number: int) -> bool | None:
        return number in on

    return Moment(
        time_s,
        signal,
        state.hand_opening,
        state.held is not None,
        (state.X_WF @ state.X_FT).translation,
        _still(before.configuration, state.configuration),
        _step(None if robot is None else robot.cause),
    )


def _still(before: Configuration, now: Configuration) -> bool:
    return all(abs(a - b) < LITTLE for a, b in zip(before, now, strict=True))


def _step(cause: Cause | None) -> tuple[str, int] | None:
    return None if cause is None else (cause.program, cause.step)
