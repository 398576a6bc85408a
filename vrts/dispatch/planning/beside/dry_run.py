"""The dry run: the same program 100 mm higher, with nothing on the table that it could carry.

The operator types `BASE ,,-100`: the controller then takes the robot to stand 100 mm lower than it
does, so every location comes out 100 mm higher, whatever it is computed from. So what is executed
is what was verified, byte for byte; no second file of locations can be left behind in the
controller, and who forgets to take BASE back moves too high, not too low. No manual tells the sign
of BASE, so the sheet has it checked with WHERE before anything moves. The dry run is executed and
checked here, too; where it would hit something, it is made lower.
"""

from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.base.units import MM, mm
from vrts.check.judge import judge
from vrts.dispatch.planning.beside.worlds import World, without_parts
from vrts.dispatch.planning.reasons.proof import Case, obstacles
from vrts.engine.controller import advance, start
from vrts.engine.run import Run
from vrts.ir.commands import Do, Execute, TimedCommand
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import Dialect
from vrts.robots.kinematics.kinematics import forward

HEIGHTS_MM = (100, 50, 25)
_NEAR = 0.1 * MM  # [m] to which motions are to be higher by what was asked
_BEGIN = 1.0  # [s] of EXECUTE, after BASE


class DryRun(NamedTuple):
    """How high the program can be tried."""

    height_mm: int  # 0: at no height
    problem: str  # what is wrong higher up; "" at the first height
    level: tuple[str, ...]  # steps that are not raised: they go to joints, not to places
    clearance_mm: float | None


NO_DRY_RUN = DryRun(0, "", (), None)


def dry_run(
    module: Module, entry: str, world: World, nominal: Run, language: Dialect, asked: float
) -> DryRun:
    """Return the greatest height at which a program goes the same way and hits nothing.

    Args:
        module: The programs.
        entry: Which one is executed.
        world: In which it was verified.
        nominal: The run there.
        language: Of the controller, which has to know BASE as VAL-II does.
        asked: Distance to keep [m].
    """
    if language.is_as:
        return NO_DRY_RUN._replace(problem="BASE of this controller is another one")
    empty, first = without_parts(world), ""
    for height in HEIGHTS_MM:
        run = _raised(module, entry, empty, height, language)
        problem, level = _compared(run, nominal, height * MM)
        if not problem:
            judgement = judge(empty.scene, run, None)
            wrong = obstacles(Case("", run, judgement, None), parts=False)
            report = judgement.collisions
            near = None if report is None else report.clearance
            if not wrong and (near is None or near.distance_m >= asked):
                least = None if near is None else round(mm(near.distance_m), 1)
                return DryRun(height, first, level, least)
            problem = wrong[0] if wrong else ""
            if near is not None and not wrong:
                problem = f"{near.bodies[0]} comes within {mm(near.distance_m):.0f} mm of "
                problem += f"`{near.bodies[1]}`"
        first = first or problem
    return NO_DRY_RUN._replace(problem=first)


def base_command(height_mm: int) -> str:
    """Return what the operator types to raise everything."""
    return f"BASE ,,-{height_mm}"


def _raised(module: Module, entry: str, world: World, height: int, language: Dialect) -> Run:
    text = f".PROGRAM raise()\n {base_command(height)}\n.END\n"
    raising = compile_source(SourceFile("BASE", text), Options(language)).module
    assert raising is not None
    commands = [TimedCommand(0.0, Do(raising)), TimedCommand(_BEGIN, Execute(entry))]
    run = start(module, world.scene, world.scenario)
    return advance(run, world.scenario.limits.time_s + 2.0 * _BEGIN, commands, closed=True)


def _compared(run: Run, nominal: Run, height: float) -> tuple[str, tuple[str, ...]]:
    """Return how a raised run differs from another but in height, and what is not raised in it."""
    arm = run.scene.robot.arm
    level: list[str] = []
    for raised, motion in zip(run.motions, nominal.motions, strict=False):
        step = f"step {motion.cause.step} of `{motion.cause.program}`"
        if raised.cause[:2] != motion.cause[:2]:
            return f"with nothing to take it goes another way after {step}", ()
        found = forward(arm, raised.goal).translation
        as_before = forward(arm, motion.goal).translation
        x, y, z = (a - b for a, b in zip(found, as_before, strict=True))
        if max(abs(x), abs(y), abs(z)) < _NEAR:
            level.append(step)
        elif max(abs(x), abs(y), abs(z - height)) > _NEAR:
            return f"{step} goes to another place", ()
    if len(run.motions) != len(nominal.motions):
        sentence = run.findings[-1].headline if run.findings else "it goes another way"
        return f"with nothing to take, {sentence}", ()
    return "", tuple(dict.fromkeys(level))
