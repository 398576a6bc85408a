"""Whether a file has changed that says where a program is run: task, scene, lab, scenario."""

import os
from itertools import islice
from pathlib import Path
from typing import TypeAlias

from vrts.check.task.task_places import lab_name, scene_name
from vrts.lsp.documents.documents import is_program_file
from vrts.pipeline.files import CannotRead, find_scene, named_place, read_toml_source
from vrts.pipeline.finding.task_of import task_of

MOST_FILES = 500  # of a folder that are looked at
_DEPTH = 3  # of folders within the folder of a scene: its meshes

Stamp: TypeAlias = tuple[tuple[str, int, int], ...]
"""Paths, times of change [ns] and sizes."""


def setting_stamp(program: str) -> Stamp:
    """Return what is another whenever one of the files of a setting changes; empty: there is none.

    Args:
        program: Path of a program.
    """
    task = task_file(program)
    if task is None:
        return ()
    found: list[tuple[str, int, int]] = []
    for folder in _folders(task):
        files = (path for path in _files(folder, _DEPTH) if not is_program_file(path))
        found += (_stamp(path) for path in islice(files, MOST_FILES))
    return tuple(found)


def task_file(program: str) -> str | None:
    """Return the task that a program is verified by; None where there is none, or several."""
    try:
        task = task_of(Path(program))
    except CannotRead:
        return None  # the verification says why
    return None if task is None else str(task)


def _folders(task: str) -> tuple[str, ...]:
    """Return the folders that hold a task, its scene and its lab."""
    folder = Path(task).parent
    found = [folder]
    try:
        source = read_toml_source(Path(task))
        scene, lab = scene_name(source)[0], lab_name(source)
        if scene is not None:
            found.append(find_scene(scene, folder).parent)
        if lab is not None:
            found.append(named_place(folder, lab).parent)
    except CannotRead:
        pass  # whoever reads the task says so
    return tuple(dict.fromkeys(str(place.resolve()) for place in found))


def _files(folder: str, depth: int) -> list[str]:
    found: list[str] = []
    inner: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in islice(entries, MOST_FILES):
                if entry.is_file():
                    found.append(entry.path)
                elif entry.is_dir(follow_symlinks=False) and not entry.name.startswith("."):
                    inner.append(entry.path)
    except OSError:
        return []  # a folder that is not there holds nothing
    found.sort()
    for below in sorted(inner) if depth > 1 else ():
        found += _files(below, depth - 1)
    return found


def _stamp(path: str) -> tuple[str, int, int]:
    try:
        status = os.stat(path)
    except OSError:
        return path, 0, 0  # gone while it is looked at
    return path, status.st_mtime_ns, status.st_size
