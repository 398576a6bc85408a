"""What one student gets: the zip of a variant, with its README, its pictures and its `start.v2`."""

import re
from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from vrts.assignments.handed.facts import facts_of
from vrts.assignments.handed.prose import contradictions
from vrts.assignments.handed.readme import NAME as README
from vrts.assignments.handed.readme import written
from vrts.assignments.handed.task_words import task_words
from vrts.assignments.new_files import new_program
from vrts.assignments.pack import student_zip
from vrts.assignments.variants.of_task import START, VariedTask
from vrts.assignments.variants.your_numbers import MAP, tag_line, with_part, your_numbers
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.variants.drawn import Variant
from vrts.pipeline.files import TASK_FILE
from vrts.pipeline.setting import Setting
from vrts.report.scene_drawing import scene_svg
from vrts.scene.model import Scene

PICTURES = "pictures/"
ZIP_OF_ALL = re.compile(rb"[^\s`'\"/]+-student\.zip\b")  # of `vrts task pack`: here nobody has it
_TAG = re.compile(
    rb"^[^\r\n;]*;[^\r\n]*\bvariant[ \t]+([b-z]{4}-[b-z]{4})\b", re.MULTILINE | re.IGNORECASE
)


class HandedOut(NamedTuple):
    """What one student gets."""

    variant: Variant
    data: bytes  # the zip
    told: tuple[Diagnostic, ...]  # where the teacher's words do not fit this variant


class Pictures(NamedTuple):
    """Pictures of the folder that `vrts scene show --svg` drew: each variant has its own."""

    drawn: tuple[str, ...]
    kept: tuple[str, ...]  # others, which are the same for all


def handed_out(
    varied: VariedTask, variant: Variant, pictures: Pictures, versions: tuple[str, ...] = ()
) -> HandedOut:
    """Return what a student gets.

    Args:
        varied: The task.
        variant: The student's.
        pictures: Of the folder.
        versions: Of vrts that may mark; none: this one.

    Raises:
        Refused: The variant is no sound task.
    """
    combination, names = variant.combination, varied.variants.staff_names
    whole = varied.setting(combination)
    public = whole if not whole.hidden else varied.setting(combination, staff=False)
    assert public.task is not None
    files = dict(varied.for_students(combination))
    scene = public.scene
    given = replace(scene, locations={n: p for n, p in scene.locations.items() if n not in names})
    svg = scene_svg(given).encode()
    for name in (*pictures.drawn, MAP):
        files[name] = svg
    page = files.get(README, b"").decode("utf-8-sig").replace("\r\n", "\n")
    told = tuple(contradictions(SourceFile(README, page), facts_of(public.task, scene)))
    if not page:
        page = f"# {public.task.title}\n\n{public.task.description}\n"
    page = written(page, task_words(public.task, scene, hidden=varied.base.hidden > 0))
    files[README] = _for_the_folder(
        with_part(page, your_numbers(scene, variant.tag, names)).encode()
    )
    files[START] = _start(varied, public, given, variant.tag)
    varied.check_readable(files)
    data = student_zip(varied.files._replace(public=files), varied.base.hidden, versions)
    return HandedOut(variant, data, told)


def pictures_of(varied: VariedTask) -> Pictures:
    """Return which pictures of a task are drawings of its scene as it is written."""
    svg = scene_svg(varied.base.scene).encode()
    names = [name for name in sorted(varied.files.public) if name.startswith(PICTURES)]
    drawn = tuple(name for name in names if varied.files.public[name] == svg)
    return Pictures(drawn, tuple(name for name in names if name not in drawn))


def tags_in(program: bytes) -> tuple[str, ...]:
    """Return the variants that the comments of a program name, each once."""
    found = (match[1].decode().lower() for match in _TAG.finditer(program))
    return tuple(dict.fromkeys(found))


def told_once(handed: Iterable[HandedOut]) -> tuple[Diagnostic, ...]:
    """Return what the teacher's words do not fit in some variant, each place and sentence once."""
    return tuple({(d.headline, str(d.primary)): d for one in handed for d in one.told}.values())


def _start(varied: VariedTask, public: Setting, given: Scene, tag: str) -> bytes:
    """Return the program that a student begins with; its first line tells the variant."""
    own = varied.start(public)
    if own is None:
        own = new_program("vrts verify mine.v2", given).encode()
    line = b"\r\n" if b"\r\n" in own else b"\n"
    return tag_line(tag).encode() + line + _for_the_folder(own)


def _for_the_folder(text: bytes) -> bytes:
    """Return a text that names the task in the folder, whatever its zip was called."""
    return ZIP_OF_ALL.sub(TASK_FILE.encode(), text)
