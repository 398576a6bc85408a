"""The numbers of a robot from its logs: reading, finding the motions, fitting."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.engine.run import Run
from vrts.ir.instructions import SetAcceleration, SetDuration
from vrts.pipeline.refused import Refused
from vrts.validate.clock import clock_shift
from vrts.validate.comparison import must_move
from vrts.validate.fitted import Estimate, FittedRobot, LogRead
from vrts.validate.fitting.chains import Chain, Located, chains_of, located
from vrts.validate.fitting.model import Shared
from vrts.validate.fitting.solve import Solution, solve
from vrts.validate.fitting.speeds import Leg, speeds
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.sampling import extent_of

FIT_PROGRAM = Rule("V893", "fit-program")
FIT_MOTIONS = Rule("V894", "fit-motions")
FIT_OPEN = Rule("V895", "fit-open")

LIKELY = 2.0  # standard deviations
PASSES = 2  # the second knows how long acceleration takes


def fit_robot(run: Run, logs: Sequence[GivenLog]) -> FittedRobot:
    """Return the numbers of the robot that made logs of a program.

    Args:
        run: The program, run with the numbers that are assumed.
        logs: Each as it was given.

    Raises:
        Refused: The program or a log tells nothing.
    """
    must_move(run)
    _must_be_plain(run)
    chains, extent = chains_of(run), extent_of(run)
    read = [read_log(log, extent) for log in logs]
    told = [finding for log in read for finding in log.findings]
    arm = run.scene.robot.arm
    shared = Shared(arm.acceleration_time, 0.5 * (arm.blend_time or 2.0 * arm.acceleration_time))
    found, solution = _solved(run, chains, read, shared)
    told += _lost(len(chains) * len(read), len(found))
    logs_read = tuple(LogRead(log.name, log.sha256, log.synthetic) for log in read)
    fitted = _fitted(run, found, solution, logs_read)
    open_ = [f"JT{k + 1}" for k, speed in enumerate(fitted.speeds) if speed is None]
    if open_:
        told.append(_still_assumed(open_))
    return replace(fitted, findings=tuple(told))


def _solved(
    run: Run, chains: Sequence[Chain], logs: Sequence[RobotLog], shared: Shared
) -> tuple[list[Located], Solution]:
    """Return what was found in logs, and what fits it; looked at twice, the second time closer.

    Raises:
        Refused: The logs show nothing.
    """
    found: list[Located] = []
    solution = None
    for _ in range(PASSES):
        found = [
            one
            for log in logs
            for one in located(run, log, chains, clock_shift(run, log), shared.acceleration)
        ]
        if not found:
            break
        solution = solve(found, shared)
        shared = solution.shared
    if solution is None:
        raise Refused((_nothing_to_fit(len(chains)),))
    return found, solution


def _fitted(
    run: Run, found: Sequence[Located], solution: Solution, read: tuple[LogRead, ...]
) -> FittedRobot:
    arm = run.scene.robot.arm
    joint_legs: list[Leg] = []
    line_legs: list[Leg] = []
    for one, durations in zip(found, solution.durations, strict=True):
        chain = one.chain
        for k, duration in enumerate(durations):
            if chain.in_joints:
                ways = tuple(np.abs(chain.joint_ways[k]).tolist())
                joint_legs.append(Leg(ways, chain.fractions[k], duration))
            else:
                length = float(np.linalg.norm(chain.ways[k]))
                line_legs.append(Leg((length,), chain.fractions[k], duration))
    shared, sigma = solution.shared, solution.sigma
    shortest = 2.0 * shared.acceleration
    corners = sum(len(one.durations) - 1 for one in found)
    return FittedRobot(
        arm,
        tuple(speeds(joint_legs, arm.speed, arm.tick, shortest)),
        speeds(line_legs, (arm.linear_speed,), arm.tick, shortest)[0],
        _about(shared.acceleration, sigma[0], len(found)),
        _about(2.0 * shared.half_blend, 2.0 * sigma[1], corners) if corners else None,
        shared.lag,
        solution.residual,
        len(joint_legs) + len(line_legs),
        read,
        (),
        run.scene.controller.name,
    )


def _about(value: float, sigma: float, motions: int) -> Estimate:
    return Estimate(value, value - LIKELY * sigma, value + LIKELY * sigma, motions)


def _must_be_plain(run: Run) -> None:
    """Refuse a program whose motions follow other rules than their speed.

    Raises:
        Refused: It sets ACCEL or DURATION, or the operator's speed is not 100.
    """
    reasons: list[str] = []
    steps = [step for program in run.module.programs.values() for step in program.instructions]
    if any(isinstance(step, SetAcceleration) for step in steps):
        reasons.append("it sets ACCEL or DECEL")
    if any(isinstance(step, SetDuration) for step in steps):
        reasons.append("it sets DURATION")
    if not run.history.arm.scale.plain:
        reasons.append("the monitor speed is not 100 all the time")
    if not reasons:
        return
    raise Refused(
        (
            error(
                FIT_PROGRAM,
                "this program does not tell how fast the robot is",
                notes=(f"expected motions that only SPEED decides; {' and '.join(reasons)}",),
                help=("fit with a program such as examples/05-validation/speeds.v2",),
            ),
        )
    )


def _nothing_to_fit(chains: int) -> Diagnostic:
    came = (
        "the program has none"
        if chains == 0
        else f"none of the {chains} of the program was found in the log"
    )
    return error(
        FIT_MOTIONS,
        "there is no motion to fit",
        notes=(f"expected joint motions or straight lines from rest to rest; {came}",),
        help=("separate motions by BREAK, and log from before the first to after the last",),
    )


def _lost(expected: int, found: int) -> list[Diagnostic]:
    if found == expected:
        return []
    return [
        warning(
            FIT_MOTIONS,
            f"the logs show {found} of {expected} motions or chains of motions",
            notes=("expected all of them; those that were not found are left out",),
            data={"expected": expected, "found": found},
        )
    ]


def _still_assumed(joints: Sequence[str]) -> Diagnostic:
    return warning(
        FIT_OPEN,
        f"no motion tells how fast {', '.join(joints)} {'are' if len(joints) > 1 else 'is'}",
        notes=("what was assumed is kept",),
        help=("add a long motion of that joint alone to the program",),
        data={"joints": ", ".join(joints)},
    )
