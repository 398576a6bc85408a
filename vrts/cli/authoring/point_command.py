"""`vrts point`."""

import sys
from pathlib import Path

import click

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import Pose
from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    WRONG_CALL,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.options import color_option, lab_option

EPILOG = """\b
Examples:
  vrts point cans-on-bases 800 -450 -225 --down
  vrts point cans-on-bases 800 -450 -225 --down --turn 90
  vrts point cans-on-bases 800 -450 -225 90 90 0
  vrts point cans-on-bases 900 30 100 --down --save above prog.v2
"""


@click.command(
    name="point",
    epilog=EPILOG,
    context_settings={"ignore_unknown_options": True},  # negative numbers
)
@click.argument("scene")
@click.argument("numbers", nargs=-1, required=True)
@click.option("--down", is_flag=True, help="Hand straight down.")
@click.option("--turn", type=float, help="Turn of the hand about the vertical, degrees.")
@click.option("--save", nargs=2, help="NAME FILE: append the location to a program.")
@lab_option
@color_option
@guarded
def command(
    scene: str,
    numbers: tuple[str, ...],
    down: bool,
    turn: float | None,
    save: tuple[str, str] | None,
    lab: Path | None,
    color: str,
) -> None:
    """Say whether the tool reaches X Y Z (mm) [O A T (degrees)] in SCENE, and how.

    A place that no program can MOVE to is not saved.
    """
    from vrts.assignments.point_tried import how_to_get_there
    from vrts.base.oat import pose_from_components
    from vrts.pipeline.scenes import load_scene
    from vrts.report.screen.scene_text import point_text
    from vrts.scene.handling.places import down_pose
    from vrts.scene.reach import reach

    values = _numbers(numbers, down=down)
    setting = load_scene(scene, lab=lab).scene
    x, y, z = values[:3]
    X_WT = down_pose(x, y, z, turn or 0.0) if down else pose_from_components(*values)
    found = reach(setting, X_WT)
    out(point_text(setting, X_WT, found))
    told = how_to_get_there(setting, X_WT, found) if found.reachable else None
    if told is not None:
        out(f"tried: {told}")
    if save is not None and not found.reachable:
        fail(f"`{save[0]}` is not saved: no program can move there", status=WRONG)
    if save is not None:
        _save(save[0], Path(save[1]), X_WT, color)
    sys.exit(HOLDS if found.reachable else WRONG)


def _numbers(words: tuple[str, ...], *, down: bool) -> tuple[float, ...]:
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        fail(
            "X, Y, Z and O, A, T are numbers",
            ("example: vrts point cans-on-bases 800 0 -200 --down",),
        )
    if any(abs(value) > 1e6 or value != value for value in values):
        fail("a number is too large")
    if len(values) == 3 and down:
        return values
    if len(values) == 6 and not down:
        return values
    return fail("give X Y Z with --down, or all six numbers X Y Z O A T")


def _save(name: str, path: Path, X_WT: Pose, color: str) -> None:
    from vrts.lang.reading.decoding import decode
    from vrts.scene.save import with_location

    text = ""
    if path.exists():
        source = decode(path.read_bytes(), str(path))
        if isinstance(source, Diagnostic):
            show_diagnostics((source,), color)
            sys.exit(WRONG)
        text = source.text
    changed = with_location(text, name, X_WT)
    if isinstance(changed, Diagnostic):
        show_diagnostics((changed,), color)
        sys.exit(WRONG_CALL)
    write_file(path, changed.encode())
    say(f"saved `{name}` in {path}")
