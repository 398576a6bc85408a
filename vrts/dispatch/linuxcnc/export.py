"""A verified program and its robot as a folder for LinuxCNC."""

import csv
import io
from importlib.resources import files
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.source import SourceFile
from vrts.base.units import MM, deg
from vrts.controllers.model import CornerShape, LineTurn, WristChoice
from vrts.dispatch.linuxcnc.levels import LIBRARY
from vrts.dispatch.linuxcnc.machine import (
    Robot,
    acceleration_text,
    hal_text,
    ini_text,
    setup_text,
)
from vrts.dispatch.linuxcnc.program_text import said
from vrts.dispatch.linuxcnc.sheet import sheet_text
from vrts.dispatch.saying.signals import used_signals
from vrts.dispatch.saying.table import TABLE, Table, read_table, table_text, usual
from vrts.dispatch.verified import NotVerified, Verified, verified
from vrts.engine.run import Run
from vrts.lang.compiler import resolve_source
from vrts.pipeline.request import Request
from vrts.robots.model import SphericalWristArm
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import simulate

OTHER_ROBOT = Rule("V872", "linuxcnc-robot")

PINS = ("digital pin of LinuxCNC", "NN of motion.digital-{}-NN")
PROGRAM, RUN, MOTIONS = "program.ngc", "expected.vrun", "expected.csv"
INI, HAL, ACCELERATION, SHEET = "machine.ini", "machine.hal", "acceleration.hal", "sheet.md"
SETUP = f"{LIBRARY}/v_setup.ngc"
EMPTY = ("parameters.var", "tool.tbl")


class Folder(NamedTuple):
    """The files of a folder by name, or why there is none."""

    files: dict[str, bytes] | None
    diagnostics: tuple[Diagnostic, ...]


def exported_folder(request: Request, table: SourceFile | None) -> Folder:
    """Verify a program and say it to LinuxCNC.

    Args:
        request: The program, and where it is verified.
        table: The file that says which pin is which signal; None: pins in the order of signals.

    Raises:
        Refused: The table has errors, or the run cannot be saved.
    """
    found = verified(request)
    if isinstance(found, NotVerified):
        return Folder(None, found.diagnostics)
    run = found.run
    other = _other_robot(run)
    if other is not None:
        return Folder(None, (*found.compilation.diagnostics, other))
    inputs, outputs = used_signals(found.module, found.entry)
    pins = usual(inputs, outputs) if table is None else read_table(table)
    return _written(request, found, pins)


def _written(request: Request, found: Verified, table: Table) -> Folder:
    compilation, run = found.compilation, found.run
    assert compilation.source is not None
    resolved = resolve_source(compilation.source, compilation.dialect)
    assert resolved is not None
    told = said(resolved, found.module, found.entry, table)
    if told.diagnostics:
        return Folder(None, told.diagnostics)
    arm = run.scene.robot.arm
    assert isinstance(arm, SphericalWristArm)
    robot = Robot(arm, run, table)
    texts = {
        PROGRAM: told.text,
        INI: ini_text(robot, PROGRAM),
        HAL: hal_text(robot),
        ACCELERATION: acceleration_text(),
        TABLE: table_text(table, *PINS),
        SHEET: sheet_text(robot, request.program.name, told.text),
        MOTIONS: motions_text(run),
        SETUP: setup_text(robot),
        **dict.fromkeys(EMPTY, ""),
    }
    data = {name: text.encode() for name, text in texts.items()}
    for source in files("vrts.dispatch.linuxcnc").joinpath(LIBRARY).iterdir():
        data[f"{LIBRARY}/{source.name}"] = source.read_bytes()
    data[RUN] = saved_bytes(simulate(request))
    return Folder(data, compilation.diagnostics)


def motions_text(run: Run) -> str:
    """Return the motions of a run as a table: what LinuxCNC is expected to do."""
    out = io.StringIO()
    rows = csv.writer(out, lineterminator="\n")
    joints = [f"jt{k}_deg" for k in range(1, 7)]
    names = ("motion", "program", "step", "kind", "rounded", "start_s", "end_s")
    rows.writerow([*names, *joints, "x_mm", "y_mm", "z_mm"])
    for number, motion in enumerate(run.motions, start=1):
        rows.writerow(
            [
                number,
                motion.cause.program,
                motion.cause.step,
                motion.interpolation.value,
                int(motion.blended),
                f"{motion.start_s:.3f}",
                f"{motion.end_s:.3f}",
                *(f"{deg(joint) + 0.0:.4f}" for joint in motion.goal),
                *(f"{part / MM + 0.0:.3f}" for part in motion.X_WT.translation),
            ]
        )
    return out.getvalue()


def _other_robot(run: Run) -> Diagnostic | None:
    """Return why LinuxCNC's kinematics or the library do not carry out what was verified."""
    scene, scenario = run.scene, run.scenario
    model = scene.controller
    reason = ""
    if not isinstance(scene.robot.arm, SphericalWristArm):
        reason = f"the {scene.robot.arm.title} has no wrist of the PUMA family"
    elif (
        model.corners.shape is not CornerShape.QUARTIC
        or model.lines.turn is not LineTurn.TWO_TURNS
        or model.branches.wrist is not WristChoice.NEAREST
    ):
        reason = f"the controller model `{model.name}` rounds corners or turns the hand otherwise"
    elif scenario.monitor_speed != 100.0:
        reason = "the operator's speed is not 100 % in the scenario"
    elif scenario.operator or scenario.faults:
        reason = "the scenario has an operator's deeds or faults"
    elif scenario.parameters:
        reason = "the scenario sets parameters of the controller"
    if not reason:
        return None
    return error(
        OTHER_ROBOT,
        f"this is not said to LinuxCNC: {reason}",
        help=("use a scene with a PUMA, under the controller model `val2`, at full speed",),
    )
