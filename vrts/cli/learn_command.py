"""`vrts learn`."""

import sys
from pathlib import Path

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, out, say
from vrts.cli.shared.options import color_option, file_option

NEXT = "next"

EPILOG = """\b
Examples:
  vrts learn
  vrts learn 1
  vrts learn 1 -o robots/first
  vrts learn next
"""


@click.command(name="learn", epilog=EPILOG)
@click.argument("what", required=False, metavar="[LESSON|next]")
@file_option("-o", "--output", help="Folder to copy the lesson to; without it a new one here.")
@color_option
@guarded
def command(what: str | None, output: Path | None, color: str) -> None:
    """List the lessons, copy one, or say what to do next.

    LESSON is a number or a name: its folder is copied, and nothing is overwritten. Type `vrts learn
    next` in the folder of a lesson. It compiles and runs what is there, and names the first step
    that is not done. Exit status 1 while a step is open.
    """
    if what == NEXT:
        if output is not None:
            fail("`-o` belongs to a copy", ("leave it out, or name a lesson",))
        _next(Path())
    if what is None:
        if output is not None:
            fail("nothing says which lesson to copy", ("example: vrts learn 1 -o first",))
        from vrts.learn.library import bundled
        from vrts.learn.told import lessons_text

        out(lessons_text(bundled()))
        return
    from vrts.learn.library import copy_lesson, find_lesson

    found = find_lesson(what)
    target = output or Path(found.folder.name)
    copy_lesson(found, target)
    say(f"copied lesson {found.lesson.number}, {found.lesson.title}, to {target}")
    out(f"cd {target}\nvrts learn next")


def _next(folder: Path) -> None:
    from vrts.learn.lesson_file import load_lesson
    from vrts.learn.progress import progress
    from vrts.learn.standing import LESSON_FILE
    from vrts.learn.told import progress_text

    if not (folder / LESSON_FILE).is_file():
        fail(
            "this folder holds no lesson",
            ("`vrts learn 1` copies one into a folder here; then `cd` there",),
        )
    found = progress(load_lesson(folder), folder)
    out(progress_text(found))
    sys.exit(HOLDS if found.next is None else WRONG)
