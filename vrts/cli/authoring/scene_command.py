"""`vrts scene`."""

import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    INTERRUPTED,
    WRONG,
    guarded,
    out,
    say,
    show_diagnostics,
    warn,
    write_file,
)
from vrts.cli.shared.options import color_option, file_option, lab_option

if TYPE_CHECKING:
    from vrts.pipeline.setting import Setting
    from vrts.scene.model import Scene

EPILOG = """\b
Examples:
  vrts scene list
  vrts scene show cans-on-bases
  vrts scene show cans-on-bases --svg map.svg
  vrts scene check lab1
  vrts scene check lab1 --lab lab.toml
  vrts scene check lab1 --write --png pieces.png
  vrts scene watch lab1 --svg map.svg
"""


@click.group(name="scene", epilog=EPILOG)
def command() -> None:
    """List the scenes; show where things are in one; find mistakes; redraw while you edit."""


@command.command(name="list")
@guarded
def list_scenes() -> None:
    """List the scenes that come with vrts."""
    from vrts.pipeline.files import scene_names
    from vrts.pipeline.scenes import load_scene

    for name in scene_names():
        out(f"{name:<20} {load_scene(name).scene.title}")


@command.command(name="show", epilog=EPILOG)
@click.argument("name")
@file_option("--svg", help="Write a drawing, top and side view.")
@lab_option
@color_option
@guarded
def show(name: str, svg: Path | None, lab: Path | None, color: str) -> None:
    """Print every object of scene NAME, and its locations ready to paste into a program.

    If NAME is the folder of a task, its goals are reached with these locations: each was tried by
    running a program that carries the object with it.
    """
    scene, text = _shown(_setting(name, lab, staff=False))
    out(text)
    if svg is not None:
        from vrts.report.scene_drawing import scene_svg

        write_file(svg, scene_svg(scene).encode())
        say(f"wrote {svg}")


@command.command(name="check", epilog=EPILOG)
@click.argument("name")
@click.option("--write", is_flag=True, help="First make the convex pieces of meshes (vrts[mesh]).")
@click.option(
    "--closeness",
    type=click.FloatRange(0.01, 1.0),
    help="With --write: how hollow a piece may be; smaller gives more and nearer pieces.",
)
@click.option("--most", type=click.IntRange(1, 64), help="With --write: pieces of a mesh at most.")
@file_option("--png", help="Write a picture of the meshes, each piece in a colour of its own.")
@lab_option
@color_option
@guarded
def check(
    name: str,
    write: bool,
    closeness: float | None,
    most: int | None,
    png: Path | None,
    lab: Path | None,
    color: str,
) -> None:
    """Look for mistakes in scene NAME, or in the folder of a task.

    It finds overlaps, floating objects, objects too wide for the hand, objects and locations out of
    reach on every arm branch, and locations inside bodies. In a task it also finds goals out of
    reach, in the air or inside bodies, and via points out of reach. Exit status 1 when there is an
    error; warnings do not count.

    Objects of kind "mesh" stand in the scene as convex pieces. --write makes the pieces and writes
    them beside the mesh; every check proves again that they hold the whole mesh, and tells by how
    much they stand out of it.
    """
    from vrts.check.task.feasible import task_findings
    from vrts.cli.authoring.mesh_pieces import drawn_pieces, told_pieces, write_pieces
    from vrts.pipeline.files import read_toml_source
    from vrts.pipeline.pieces.in_scene import Asked
    from vrts.report.plain import one_line
    from vrts.scene.checks import scene_findings, without_repeats

    if not write and (closeness is not None or most is not None):
        raise click.UsageError("--closeness and --most are for --write")
    place = _scene_file(name)
    if write and place is None:
        raise click.UsageError("--write needs a scene in a folder, not one from standard input")
    if write and place is not None:
        refused = write_pieces(place, Asked(closeness, most))
        if refused:
            show_diagnostics(refused, color)
            sys.exit(WRONG)
    setting = _setting(name, lab)
    scene, task = setting.scene, setting.task
    found = list(without_repeats(setting.diagnostics, scene_findings(scene)))
    if task is not None:
        found += task_findings(scene, task)
    told: list[str] = []
    if any(body.kind == "mesh" for body in scene.bodies) and place is not None:
        told, wrong = told_pieces(read_toml_source(place), place.parent)
        found += wrong
    show_diagnostics(found, color)
    for line in told:
        out(line)
    if png is not None:
        write_file(png, drawn_pieces(scene))
        say(f"wrote {png}")
    counts = [("object", len(scene.bodies) - 1), ("location", len(scene.locations))]
    counts += [("goal", len(task.goals))] if task is not None else []
    what = ", ".join(f"{n} {word}{'' if n == 1 else 's'}" for word, n in counts)
    out(f"{one_line(scene.title)}: {what}: " + ("see above" if found else "nothing found"))
    sys.exit(WRONG if any(d.is_error for d in found) else HOLDS)


def _shown(setting: "Setting") -> "tuple[Scene, str]":
    """Return a scene with the locations to show, and what to print."""
    from vrts.assignments.suggested import suggested, what_came_of_it
    from vrts.report.screen.scene_text import scene_text

    found = suggested(setting)
    scene = replace(setting.scene, locations=found.locations)
    return scene, scene_text(scene, what_came_of_it(found))


def _setting(name: str, lab: Path | None, *, staff: bool = True) -> "Setting":
    """Return a scene, with the task where NAME is the folder of one."""
    from vrts.pipeline.files import TASK_FILE
    from vrts.pipeline.scenes import load_scene
    from vrts.pipeline.settings import load_task

    path = Path(name)
    if (path / TASK_FILE).is_file() or (path.name == TASK_FILE and path.is_file()):
        return load_task(path, staff=staff, lab=lab)
    return load_scene(name, lab=lab)


def _scene_file(name: str) -> Path | None:
    """Return the file of a scene, or of the scene of a task in a folder; None: standard input."""
    from vrts.base.toml.reading import read_toml
    from vrts.pipeline.files import STDIN, TASK_FILE, asked_scene, find_scene, read_toml_source

    path = Path(name)
    task = path / TASK_FILE if path.is_dir() else path
    if task.name == TASK_FILE and task.is_file():
        top, _ = read_toml(read_toml_source(task))
        named = None if top is None else top.string("scene")
        return None if named is None else find_scene(named, task.parent)
    found = asked_scene(name)
    return None if str(found) == STDIN else found


def _in_its_task(setting: "Setting", place: Path, lab: Path | None) -> "Setting":
    """Return a setting with the task in the folder of its scene, if that is set in it."""
    from vrts.pipeline.files import TASK_FILE
    from vrts.pipeline.settings import load_task

    if not (place.parent / TASK_FILE).is_file():
        return setting
    found = load_task(place.parent, lab=lab)
    return found if found.scene.digest == setting.scene.digest else setting


@command.command(name="watch", epilog=EPILOG)
@click.argument("name")
@file_option("--svg", help="Write a drawing on every change.")
@click.option("--seconds", type=float, help="End after so many seconds; without it never.")
@lab_option
@color_option
@guarded
def watch_scene(
    name: str, svg: Path | None, seconds: float | None, lab: Path | None, color: str
) -> None:
    """Show scene NAME, and again whenever you save its file or the lab. Ctrl-C ends it."""
    from vrts.cli.shared.watching import watch
    from vrts.pipeline.files import TASK_FILE, asked_scene

    place = asked_scene(name)
    task = place.parent / TASK_FILE
    until = None if seconds is None else time.monotonic() + seconds

    def redraw() -> None:
        draw(place, svg, lab, color)

    files = [place, *([task] if task.is_file() else []), *([] if lab is None else [lab])]
    try:
        watch(files, redraw, clock=time.monotonic, sleep=time.sleep, until=until)
    except KeyboardInterrupt:  # how it ends: no word about it
        sys.exit(INTERRUPTED)


def draw(place: Path, svg: Path | None, lab: Path | None, color: str) -> None:
    """Show a scene as it is now, with a drawing; or what is wrong with it."""
    from vrts.pipeline.files import CannotRead
    from vrts.pipeline.refused import Refused
    from vrts.pipeline.scenes import load_scene
    from vrts.report.scene_drawing import scene_svg
    from vrts.scene.checks import scene_findings, without_repeats

    if sys.stdout.isatty():
        click.clear()
    try:
        setting = _in_its_task(load_scene(str(place.resolve()), lab=lab), place, lab)
    except Refused as problem:
        show_diagnostics(problem.diagnostics, color)
        return
    except CannotRead as problem:  # in the middle of being saved
        warn(problem.message)
        return
    _, text = _shown(setting)
    out(text)
    findings = scene_findings(setting.scene)
    show_diagnostics(without_repeats(setting.diagnostics, findings), color)
    if svg is not None:
        write_file(svg, scene_svg(setting.scene).encode())
        say(f"wrote {svg}")
