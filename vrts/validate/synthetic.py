"""A simulated real robot: a run as a robot with the errors of a real one would log it.

Nothing of this is measured: every number is assumed, and every log says that it is synthetic. The
chain is that of the controller: set points every tick, each joint's servo going from one to the
next on a straight line and behind it by a lag, encoders that count steps, noise; then the tool as
an instrument would measure it that takes the base to be where it is not.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG, MM
from vrts.engine.batch import batch_of
from vrts.engine.run import Run
from vrts.robots.built import LINKS, shown_off
from vrts.robots.kinematics.batch import flange_frames
from vrts.validate.identify.again import Again, with_links
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.offsets import turned
from vrts.validate.sampling import tools_of

Array = npt.NDArray[np.float64]

FURTHER = (
    ("zero_deg", "deg"),
    ("link_mm", "mm"),
    ("counted_link_mm", "mm"),
    ("tool_mm", "mm"),
    ("speeds_percent", "%"),
    ("rate_percent", "%"),
)
STEPS = 32  # of a servo between two set points [FGL1987]_, from memory
BEFORE_S = AFTER_S = 0.5  # logged before and after the run


class Imperfect(NamedTuple):
    """What is wrong with the simulated robot; the whole of it is assumed."""

    lag_s: float = 0.02  # of every joint's servo, first order
    encoder_deg: float = 0.005  # a step of an encoder
    noise_deg: float = 0.01  # of every joint, one standard deviation
    base_mm: tuple[float, float, float] = (0.6, 0.8, 0.0)  # of the real base in W: 1 mm
    base_turn_deg: float = 0.0  # about the vertical
    clock_s: float = 0.0  # what its clock shows when the run begins
    seed: int = 1
    zero_deg: tuple[float, ...] = (0.0,) * 6  # by which joints stand off; encoders show it
    link_mm: tuple[float, ...] = (0.0,) * 4  # by which a2, a3, d2, d4 of the arm are longer
    counted_link_mm: tuple[float, ...] = (0.0,) * 4  # the same, of what the controller counts with
    tool_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of the real tool in T
    speeds_percent: float = 100.0  # of all speeds, of what is assumed
    rate_percent: float = 0.0  # by which the clock of the log runs fast


def synthetic_log(run: Run, robot: Imperfect, program: str) -> Iterator[str]:
    """Return a log in pieces that end with a line: one row for every set point.

    Args:
        run: What is commanded.
        robot: What is wrong with the robot.
        program: Name of the program, for the first line.
    """
    yield from _heading(robot, program)
    names = ["time_s", *(f"jt{k}_deg" for k in range(1, 7)), "x_mm", "y_mm", "z_mm"]
    yield ",".join(names) + "\n"
    times, joints, positions = logged(run, robot)
    shown = times * (1.0 + robot.rate_percent / 100.0) + robot.clock_s
    rows = np.column_stack((shown, joints / DEG, positions / MM))
    precise = "%.3f" if robot.rate_percent == 0.0 else "%.6f"
    form = ",".join([precise, *["%.4f"] * 6, *["%.3f"] * 3])
    for row in (rows + 0.0).tolist():
        yield form % tuple(row) + "\n"


def logged(run: Run, robot: Imperfect) -> tuple[Array, Array, Array]:
    """Return times [s], shape (n,), joints [rad], (n, 6), and tool positions in W [m], (n, 3)."""
    chance = np.random.default_rng(robot.seed)
    nominal, run = run.scene.robot.arm, Again(run).with_values(_counted(robot))
    tick = run.scene.robot.arm.tick
    count = round((run.horizon_s + BEFORE_S + AFTER_S) / tick)
    times: Array = tick * (np.arange(count, dtype=np.float64) - round(BEFORE_S / tick))
    shown = np.array(shown_off(nominal))
    joints = _servo(run, times, tick, robot.lag_s) + np.array(robot.zero_deg) * DEG + shown
    noise = chance.normal(0.0, robot.noise_deg * DEG, joints.shape)
    step = robot.encoder_deg * DEG
    told = joints + noise
    if step > 0.0:
        told = np.round(told / step) * step
    arm = with_links(nominal, _links(robot.link_mm, Kind.LINK), Kind.LINK)
    rotations, origins = flange_frames(arm, told - shown)
    tools = tools_of(run)
    which = np.searchsorted(tools.starts, times, side="right")
    tips = tools.origins[which] + tools.rotations[which] @ (np.array(robot.tool_mm) * MM)
    points = origins + np.einsum("nij,nj->ni", rotations, tips)
    turn = turned(np.array([0.0, 0.0, robot.base_turn_deg * DEG]))
    return times, told, points @ turn.T + np.array(robot.base_mm) * MM


def _counted(robot: Imperfect) -> dict[Cause, float]:
    """Return what the controller has otherwise."""
    speeds = {Cause(Kind.SPEEDS): robot.speeds_percent / 100.0 - 1.0}
    return {**_links(robot.counted_link_mm, Kind.COUNTED_LINK), **speeds}


def _links(longer_mm: tuple[float, ...], kind: Kind) -> dict[Cause, float]:
    pairs = zip(LINKS, longer_mm, strict=True)
    return {Cause(kind, 0, link): by * MM for link, by in pairs if by}


def _servo(run: Run, times: Array, tick: float, lag_s: float) -> Array:
    """Return joints that follow set points, on straight lines between them, behind by a lag."""
    set_points = batch_of(run.timeline).values(times)[:, :6]
    if lag_s <= 0.0:
        return set_points
    kept = np.exp(-tick / STEPS / lag_s)  # of the distance, in every step of the servo
    found = np.empty_like(set_points)
    found[0] = now = set_points[0]
    shares = np.arange(1, STEPS + 1)[:, None] / STEPS
    for k in range(1, len(times)):
        wanted = set_points[k - 1] + shares * (set_points[k] - set_points[k - 1])
        for goal in wanted:
            now = goal + kept * (now - goal)
        found[k] = now
    return found


def _heading(robot: Imperfect, program: str) -> Iterator[str]:
    yield f"# SYNTHETIC: `vrts validate simulate` made this log of {program}, no robot did.\n"
    base = " ".join(f"{value:g}" for value in robot.base_mm)
    yield (
        f"# Assumed: servo lag {1e3 * robot.lag_s:g} ms, encoder step {robot.encoder_deg:g} deg,"
        f" noise {robot.noise_deg:g} deg, base off by {base} mm"
        f" and {robot.base_turn_deg:g} deg, clock {robot.clock_s:g} s, seed {robot.seed}.\n"
    )
    usual = Imperfect()
    more = [
        f"{name.rpartition('_')[0].replace('_', ' ')} {_plain(getattr(robot, name))} {unit}"
        for name, unit in FURTHER
        if getattr(robot, name) != getattr(usual, name)
    ]
    if more:
        yield f"# Assumed, too: {', '.join(more)}.\n"


def _plain(value: float | tuple[float, ...]) -> str:
    return " ".join(f"{one:g}" for one in (value if isinstance(value, tuple) else (value,)))
