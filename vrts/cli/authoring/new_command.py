"""`vrts new`."""

import re
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import WRONG, fail, guarded, say, show_diagnostics, write_file
from vrts.cli.shared.options import Language, color_option, file_option, language_options

if TYPE_CHECKING:
    from vrts.cli.shared.programs import Given
    from vrts.ir.module import Module
    from vrts.pipeline.setting import Setting
    from vrts.scene.model import Scene

EPILOG = """\b
Examples:
  vrts new scene lab1
  vrts new task lab1 --from cans-on-bases
  vrts new task lab2 --from 02-dish-on-stand
  vrts new program mine.v2 --from cans-on-bases
  vrts new lab lab.toml
  vrts new environment prog.v2
  vrts new scenario prog.v2
"""

from_option = click.option(
    "--from", "origin", metavar="SCENE", help="Begin with this scene, or with that of an example."
)


@click.group(name="new", epilog=EPILOG)
def command() -> None:
    """Write a scene, a task, a program, a lab, an environment or a scenario; replace nothing."""


@command.command(name="scene", epilog=EPILOG)
@click.argument("name", type=click.Path(path_type=Path))
@from_option
@color_option
@guarded
def scene(name: Path, origin: str | None, color: str) -> None:
    """Write the folder NAME with a scene in it."""
    _write(name, scene_files(name, origin))
    say(f"look at it with `vrts scene show {name}`, check it with `vrts scene check {name}`")


@command.command(name="program", epilog=EPILOG)
@click.argument("name", type=click.Path(path_type=Path))
@from_option
@color_option
@guarded
def program(name: Path, origin: str | None, color: str) -> None:
    """Write the program NAME with all locations of a scene, or of the scene of a task."""
    from vrts.assignments.new_files import new_program

    file = name if name.suffix else name.with_suffix(".v2")
    taken = origin or "cans-on-bases"
    text = new_program(f"vrts verify {file.name} --scene {taken}", _tried(_setting_of(taken)))
    _write(file.parent, {file.name: text.encode()})
    say(f"check it with `vrts verify {file} --scene {taken}`")


@command.command(name="lab", epilog=EPILOG)
@click.argument("name", type=click.Path(path_type=Path))
@color_option
@guarded
def lab(name: Path, color: str) -> None:
    """Write the file NAME with the measures of a robot, a hand and a table.

    With `--lab NAME`, or `lab = "NAME"` in a task, its numbers replace those of the scene. So you
    can use any scene with the measures of your own laboratory.
    """
    from vrts.assignments.new_lab import LAB

    file = name if name.suffix else name.with_suffix(".toml")
    _write(file.parent, {file.name: LAB.encode()})
    say(f"write your measures into it; `vrts scene check cans-on-bases --lab {file}` looks at them")


def _module(given: "Given", language: Language, color: str) -> "Module":
    """Return the programs of a file; end where it does not compile."""
    from vrts.cli.shared.programs import reading_of
    from vrts.pipeline.compiling.programs import compile_bytes

    found = compile_bytes(given.program.data, given.program.name, reading_of(language))
    module = None if found.compilation is None else found.compilation.module
    if module is None:
        show_diagnostics([d for d in found.diagnostics if d.is_error], color)
        sys.exit(WRONG)
    return module


@command.command(name="environment", epilog=EPILOG)
@click.argument("program")
@file_option(
    "-o", "--output", "target", help="File to write; without it environment.toml beside PROGRAM."
)
@color_option
@language_options
@guarded
def environment(program: str, target: Path | None, color: str, language: Language) -> None:
    """Write a file that says what may come from outside into PROGRAM, for `vrts prove`.

    It names every input that the program reads, and leaves all of them free. Change it to fit your
    cell.
    """
    from vrts.assignments.new_environment import new_environment
    from vrts.cli.shared.programs import given_program

    given = given_program(program)
    module = _module(given, language, color)
    file = target or (given.folder or Path()) / "environment.toml"
    name = given.program.name if given.path is None else given.path.name
    _write(file.parent, {file.name: new_environment(name, module).encode()})
    say(f"try it with `vrts prove {given.program.name} --environment {file}`")


@command.command(name="scenario", epilog=EPILOG)
@click.argument("program")
@file_option(
    "-o", "--output", "target", help="File to write; without it NAME-scenario.toml beside PROGRAM."
)
@color_option
@language_options
@guarded
def scenario(program: str, target: Path | None, color: str, language: Language) -> None:
    """Write a file that says what happens in a run of PROGRAM, for `--scenario`.

    It names every input and every question of the program, each with an example, and what may go
    wrong. Change it as you like.
    """
    from vrts.assignments.new_scenario import new_scenario
    from vrts.cli.shared.programs import given_program

    given = given_program(program)
    module = _module(given, language, color)
    name, stem = given.program.name, "program"
    if given.path is not None:
        name, stem = given.path.name, given.path.stem
    file = target or (given.folder or Path()) / f"{stem}-scenario.toml"
    _write(file.parent, {file.name: new_scenario(name, module, file.name).encode()})
    say(f"try it with `vrts run {given.program.name} --scenario {file}`")


@command.command(name="task", epilog=EPILOG)
@click.argument("name", type=click.Path(path_type=Path))
@from_option
@click.option("--title", help="Title of the task; without it its name.")
@color_option
@guarded
def task(name: Path, origin: str | None, title: str | None, color: str) -> None:
    """Write the folder NAME with a task, its scene and its reference solution.

    If NAME holds a scene.toml already, that is the scene. With `--from` an example, you also get
    its task. With `--from` a scene, or without `--from`, the task is to carry every can to a base.
    """
    from vrts.assignments.new_files import new_program, new_readme, new_staff_task
    from vrts.assignments.task_copy import copied_reference, copied_task, example_folder
    from vrts.pipeline.files import SCENE_FILE, STAFF, TASK_FILE
    from vrts.pipeline.scenes import load_scene
    from vrts.pipeline.settings import load_task

    made: dict[str, bytes] = {}
    if not (name / SCENE_FILE).is_file():
        made = scene_files(name, origin)
    elif origin is not None:
        fail(f"`{name / SCENE_FILE}` is there already", ("leave out `--from`",))
    _refuse_existing(name, (TASK_FILE, "start.v2", "README.md", f"{STAFF}/solution.v2"))
    _write(name, made)
    scene = load_scene(SCENE_FILE, name)
    show_diagnostics(scene.diagnostics, color)
    example = example_folder(origin)
    if example is None:
        task_text, solution = _carrying(name, scene, title or _words(name))
    else:
        task_text, solution = copied_task(example, title), copied_reference(example)
    _write(name, {TASK_FILE: task_text})
    setting = load_task(name)
    task = setting.task
    assert task is not None
    label = name.resolve().name
    started = new_program(f"vrts grade {label}-student.zip start.v2", _tried(setting))
    _write(
        name,
        {
            "README.md": new_readme(label, task, setting.scene).encode(),
            "start.v2": started.encode(),
            f"{STAFF}/solution.v2": solution,
            f"{STAFF}/{TASK_FILE}": new_staff_task(scene.scene).encode(),
        },
    )
    say(f"check it with `vrts task check {name}`")


def _carrying(name: Path, setting: "Setting", title: str) -> tuple[bytes, bytes]:
    """Return a task in which everything is carried to a base, and the program that does it."""
    from vrts.assignments.first_task import first_task

    found = first_task(title, name.resolve().name, setting)
    if found is None:
        fail(
            "the scene has nothing to carry to a base",
            ("give it a can and a base within reach", f"see `vrts scene check {name}`"),
        )
    return found.task.encode(), found.solution.encode()


def _setting_of(origin: str) -> "Setting":
    """Return the task of an example or of a folder, or a scene as it is."""
    from vrts.pipeline.files import TASK_FILE, find_example
    from vrts.pipeline.scenes import load_scene
    from vrts.pipeline.settings import load_task

    folder = find_example(origin) or Path(origin)
    return load_task(folder) if (folder / TASK_FILE).is_file() else load_scene(origin)


def _tried(setting: "Setting") -> "Scene":
    """Return a scene with the locations that were tried in its task."""
    from vrts.assignments.suggested import suggested

    return replace(setting.scene, locations=suggested(setting).locations)


def scene_files(name: Path, origin: str | None) -> dict[str, bytes]:
    """Return the files of a new scene: a simple one, or a copy."""
    from vrts.assignments.new_scene import new_scene
    from vrts.pipeline.files import (
        SCENE_FILE,
        asked_scene,
        member_bytes,
        read_bytes,
        read_toml_source,
    )
    from vrts.pipeline.pieces.named import pieces_files

    if origin is None:
        return {SCENE_FILE: new_scene(name.resolve().name, _words(name)).encode()}
    place = asked_scene(_scene_of(origin))
    found = {SCENE_FILE: read_bytes(place)}
    for path in sorted(place.parent.iterdir()):
        if path.suffix.lower() in (".urdf", ".stl", ".obj", ".dae"):
            found[path.name] = member_bytes(path)
    return found | dict(pieces_files(read_toml_source(place), place.parent))


def _scene_of(origin: str) -> str:
    """Return the scene of an example, or a scene as it is."""
    from vrts.check.task.task_places import scene_name
    from vrts.pipeline.files import TASK_FILE, find_example, find_scene, read_toml_source

    folder = find_example(origin)
    if folder is None or not (folder / TASK_FILE).is_file():
        return origin
    named, _ = scene_name(read_toml_source(folder / TASK_FILE))
    return origin if named is None else str(find_scene(named, folder).resolve())


def _words(name: Path) -> str:
    """Return a name in words: "cans-on-bases" is "Cans on bases"."""
    words = re.sub(r"[^\w]+|_+", " ", name.resolve().name).strip() or "A task"
    return words[:1].upper() + words[1:]


def _refuse_existing(folder: Path, names: "tuple[str, ...] | Mapping[str, bytes]") -> None:
    for name in names:
        if (folder / name).exists():
            fail(f"`{folder / name}` is there already", ("give another name, or move it away",))


def _write(folder: Path, files: Mapping[str, bytes]) -> None:
    _refuse_existing(folder, files)
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        write_file(path, data)
        say(f"wrote {path}")
