"""A folder for an arm of Universal Robots: the program, the table of signals, a sheet."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.pose import distance
from vrts.base.source import SourceFile
from vrts.dispatch.saying.signals import used_signals
from vrts.dispatch.saying.table import TABLE, Table, read_table, table_text, usual
from vrts.dispatch.urscript.program_text import Arm, said
from vrts.dispatch.urscript.sheet import sheet_text
from vrts.dispatch.verified import NotVerified, verified
from vrts.engine.run import Run
from vrts.lang.compiler import resolve_source
from vrts.pipeline.request import Request
from vrts.robots.urdf.universal import names

OTHER_ROBOT = Rule("V878", "urscript-robot")
PROGRAM, SHEET = "program.script", "sheet.md"
PINS = ("standard digital input or output", "standard digital {}put, 0 to 7")
HIGHEST = 7  # of the standard digital inputs and outputs
CORNER = 0.4  # of the shorter motion beside a corner that its radius takes at most


class Folder(NamedTuple):
    """The files of a folder by name, or why there is none."""

    files: dict[str, bytes] | None
    diagnostics: tuple[Diagnostic, ...]


def exported_script(request: Request, table: SourceFile | None) -> Folder:
    """Verify a program and write it in URScript.

    Args:
        request: The program, and where it is verified.
        table: The file that says which pin is which signal; None: pins in the order of signals.

    Raises:
        Refused: The table has errors.
    """
    found = verified(request)
    if isinstance(found, NotVerified):
        return Folder(None, found.diagnostics)
    compilation, run = found.compilation, found.run
    usual_pins = usual(*used_signals(found.module, found.entry))
    pins = usual_pins if table is None else read_table(table, payloads=True)
    other = _other(run, pins)
    if other is not None:
        return Folder(None, (*compilation.diagnostics, other))
    assert compilation.source is not None
    resolved = resolve_source(compilation.source, compilation.dialect)
    assert resolved is not None
    scene = run.scene
    arm, controller = scene.robot.arm, scene.controller
    hand_s = controller.programs.hand_s or scene.robot.gripper.stroke_time
    told = said(
        resolved,
        found.module,
        found.entry,
        pins,
        Arm(
            scene.X_FT,
            arm.ready,
            min(arm.speed),
            arm.linear_speed,
            arm.acceleration_time,
            controller.pace.brake_accelerations * arm.acceleration_time,
            hand_s,
        ),
        radii(run),
    )
    if told.diagnostics:
        return Folder(None, told.diagnostics)
    texts = {
        PROGRAM: told.text,
        TABLE: table_text(pins, *PINS),
        SHEET: sheet_text(run, request.program.name, pins, told.text),
    }
    return Folder({k: text.encode() for k, text in texts.items()}, compilation.diagnostics)


def radii(run: Run) -> dict[tuple[str, int], float]:
    """Return the blend radius of every step that always ends in a rounded corner [m]."""
    found: dict[tuple[str, int], float] = {}
    for number, motion in enumerate(run.motions):
        following = run.motions[number + 1] if number + 1 < len(run.motions) else None
        step = (motion.cause.program, motion.cause.step)
        radius = 0.0
        if motion.blended and following is not None:
            before = _length(run, motion.start_s, motion.end_s)
            behind = _length(run, following.start_s, following.end_s)
            arm = run.scene.robot.arm
            reach = motion.speed_fraction * arm.linear_speed * arm.acceleration_time
            radius = min(CORNER * before, CORNER * behind, reach)
        found[step] = min(found.get(step, radius), radius)
    return found


def _length(run: Run, start_s: float, end_s: float) -> float:
    return distance(run.at(start_s).X_WT.translation, run.at(end_s).X_WT.translation)


def _other(run: Run, table: Table) -> Diagnostic | None:
    scene, scenario = run.scene, run.scenario
    pins = (*table.inputs.values(), *table.outputs.values(), table.hand_open, table.hand_close)
    reason = ""
    if scene.robot.arm.name not in names():
        reason = f"the {scene.robot.arm.title} is no arm of Universal Robots"
    elif max(pins) > HIGHEST:
        reason = f"inputs and outputs are numbered 0 to {HIGHEST}"
    elif scenario.monitor_speed != 100.0 or scenario.faults or scenario.parameters:
        reason = "the scenario has another speed, faults, or parameters of the controller"
    if not reason:
        return None
    help_ = ("use a scene with a UR arm, at full speed, with at most eight inputs and outputs",)
    return error(OTHER_ROBOT, f"this is not written in URScript: {reason}", help=help_)
