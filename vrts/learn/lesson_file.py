"""Reads `lesson.toml`: a lesson divided into steps.

    [lesson]
    number = 1
    title = "Cans on bases"
    about = "Two cans change places with two bases."
    files = ["README.md", "pictures/*.png"]  # what `vrts learn` copies, beside this file

    [[step]]
    title = "Let it run"
    minutes = 3
    part = "5. Let it run"                  # of README.md
    does = "Close the fingers round can1."
    tries = ["vrts run mine.v2 --scene cans-on-bases"]

    [step.program]                          # what the learner's file has to do:
    file = "mine.v2"
    holds = "can1"                          # also: scene, teaches, own_places, in_place, untouched,
                                            # finds, mark

    [step.assignment]                       # or: folder, objects, task, hidden
    [step.packed]                           # or: file, program, mark
    [step.marked]                           # or: folder, rows
    [step.log]                              # or: program, log, scene, lab, within_mm, beyond_mm

Each step has one of these five tables. Names of files stay inside the lesson's folder; `scene`
may be the name of one that comes with vrts, too.
"""

from pathlib import Path, PurePosixPath

from vrts.base.diagnostic import Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Table, read_toml
from vrts.base.units import MM
from vrts.learn.lesson import (
    AssignmentWish,
    Lesson,
    LogWish,
    MarkedWish,
    PackedWish,
    ProgramWish,
    Step,
    Wish,
)
from vrts.learn.standing import LESSON_FILE
from vrts.pipeline.files import STDIN, read_toml_source
from vrts.pipeline.refused import Refused

BAD_STEP = Rule("V696", "lesson-step")

KINDS = ("program", "assignment", "packed", "marked", "log")
MOST_STEPS = 40
LONGEST_STEP = 60  # minutes


def load_lesson(folder: Path) -> Lesson:
    """Return the lesson of a folder.

    Raises:
        CannotRead: There is none.
        Refused: Its file has errors.
    """
    return read_lesson(read_toml_source(folder / LESSON_FILE))


def read_lesson(source: SourceFile) -> Lesson:
    """Return the lesson that a text describes.

    Raises:
        Refused: The text has errors.
    """
    top, problems = read_toml(source)
    if top is None:
        raise Refused(problems.in_order())
    head = top.table("lesson", required=True)
    tables = top.tables("step", required=True)
    steps = tuple(step for table in tables[:MOST_STEPS] if (step := _step(table)) is not None)
    if len(tables) > MOST_STEPS:
        first = tables[MOST_STEPS]
        problems.error(BAD_STEP, f"a lesson has at most {MOST_STEPS} steps", first.span)
    lesson = None
    if head is not None:
        lesson = Lesson(
            head.integer("number", 0, minimum=0, maximum=99),
            head.string("title", required=True) or "",
            head.string("about", ""),
            steps,
            _files(head),
        )
        head.finish()
    top.finish()
    if lesson is None or problems.any_error:
        raise Refused(problems.in_order())
    return lesson


def _step(table: Table) -> Step | None:
    title = table.string("title", required=True)
    minutes = table.integer("minutes", 5, minimum=1, maximum=LONGEST_STEP)
    does = table.string("does", required=True)
    tries = table.strings("tries")
    part = table.string("part", "")
    given = [(kind, found) for kind in KINDS if (found := table.table(kind)) is not None]
    if len(given) != 1:
        names = ", ".join(f"`[step.{kind}]`" for kind in KINDS)
        table.problems.error(BAD_STEP, f"a step has one of {names}", table.span)
        table.finish()
        return None
    (kind, found) = given[0]
    wish = _wish(kind, found)
    found.finish()
    table.finish()
    if title is None or does is None or wish is None:
        return None
    return Step(title, minutes, does, tries or (), part, wish)


def _wish(kind: str, table: Table) -> Wish | None:
    if kind == "program":
        return _program(table)
    if kind == "assignment":
        folder = _name(table, "folder")
        objects, task = table.strings("objects"), table.boolean("task", default=True)
        hidden = table.integer("hidden", 0, minimum=0)
        return None if folder is None else AssignmentWish(folder, objects or (), task, hidden)
    if kind == "packed":
        file, program = _name(table, "file"), _name(table, "program")
        mark = table.fraction("mark", required=True, minimum=0)
        if file is None or program is None or mark is None:
            return None
        return PackedWish(file, program, mark)
    if kind == "marked":
        folder, rows = _name(table, "folder"), table.integer("rows", 1, minimum=1)
        return None if folder is None else MarkedWish(folder, rows)
    program, log = _name(table, "program"), _name(table, "log")
    scene, lab = (_name(table, key, required=False) for key in ("scene", "lab"))
    within, beyond = table.number("within_mm", above=0.0), table.number("beyond_mm", above=0.0)
    if program is None or log is None:
        return None
    lengths = [None if length is None else length * MM for length in (within, beyond)]
    return LogWish(program, log, scene, lab, *lengths)


def _program(table: Table) -> ProgramWish | None:
    wish = ProgramWish(
        file=_name(table, "file") or "",
        scene=_name(table, "scene", required=False),
        teaches=table.strings("teaches") or (),
        own_places=table.integer("own_places", 0, minimum=0),
        holds=table.string("holds"),
        in_place=table.strings("in_place") or (),
        untouched=table.boolean("untouched", default=False),
        finds=table.string("finds"),
        mark=table.fraction("mark", minimum=0),
    )
    return wish if wish.file else None


def _name(table: Table, key: str, *, required: bool = True) -> str | None:
    """Return the name of a file inside the lesson's folder."""
    name = table.string(key, required=True) if required else table.string(key)
    return None if name is None or _leads_out(table, key, name) else name


def _files(table: Table) -> tuple[str, ...]:
    names = table.strings("files") or ()
    return tuple(name for name in names if not _leads_out(table, "files", name))


def _leads_out(table: Table, key: str, name: str) -> bool:
    """Return whether a name is of nothing inside the lesson's folder, and say so."""
    path = PurePosixPath(name)
    inside = path.parts and not path.is_absolute() and ".." not in path.parts
    if inside and "\\" not in name and name != STDIN:
        return False
    table.problems.error(
        BAD_STEP, f"`{key}` leads out of the lesson's folder", table.value_span(key)
    )
    return True
