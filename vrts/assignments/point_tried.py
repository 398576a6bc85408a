"""A location tried by moving there, as it will be written in a file."""

from vrts.base.pose import Pose
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.execution import executed
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.robots.kinematics.branch import has_branches
from vrts.scene.block import location_block
from vrts.scene.model import Scene
from vrts.scene.reach import USUAL, Reach

PROGRAM = ".PROGRAM main()\n{words}        MOVE there\n.END\n"


def how_to_get_there(scene: Scene, X_WT: Pose, found: Reach) -> str | None:
    """Return what has to be said of moving to a location that is reachable; None: MOVE does it.

    Args:
        scene: The workspace.
        X_WT: The location.
        found: Whether and how it is reachable.
    """
    why = _failure(scene, X_WT, "")
    if why is None:
        return None
    best = found.best
    if best is not None and has_branches(scene.robot.arm):
        words = [
            part.value.upper()
            for part, usual in zip(best.branch, USUAL, strict=True)
            if part is not usual
        ]
        if words and _failure(scene, X_WT, "".join(f"        {w}\n" for w in words)) is None:
            return f"MOVE gets there only after {' and '.join(words)}"
    return f"MOVE does not get there: {why}"


def _failure(scene: Scene, X_WT: Pose, words: str) -> str | None:
    text = PROGRAM.format(words=words) + location_block({"there": X_WT})
    found = executed(Request(ProgramFile(text.encode(), "point"), Setting(scene, None, ())))
    assert found.run is not None, found.diagnostics
    return next((d.headline for d in found.run.findings if d.is_error), None)
