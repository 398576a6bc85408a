"""Reads `course.toml`: every fault is told where it stands, and all of them at once."""

from pathlib import Path
from typing import Final

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.safe_names import safe
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.course.course import COURSE_FILE, EMAIL, Assignment, Course, Rank, Staff, Team
from vrts.course.login_section import read_login
from vrts.course.robots.limits_table import read_limits
from vrts.course.slot_rules import read_slots
from vrts.live.names import display_name
from vrts.pipeline.files import TASK_FILE, read_toml_source
from vrts.pipeline.refused import Refused

COURSE: Final = Rule("V921", "course-file")
MOST_ROOMS: Final = 64
MOST_ATTEMPTS: Final = 1000


def is_course(folder: Path) -> bool:
    """Return whether a folder is that of a course."""
    return (folder / COURSE_FILE).is_file()


def open_course(folder: Path) -> Course:
    """Return the course of a folder.

    Raises:
        CannotRead: There is no such file.
        Refused: It has errors.
    """
    source = read_toml_source(folder / COURSE_FILE)
    course, diagnostics = read_course(source, folder)
    if course is None:
        raise Refused(diagnostics)
    return course


def read_course(source: SourceFile, folder: Path) -> tuple[Course | None, tuple[Diagnostic, ...]]:
    """Return the course that a file tells of, and what is to be said of it; None: it has errors.

    Args:
        source: Text of `course.toml`.
        folder: That it is in; what it names lies in there.
    """
    top, problems = read_toml(source)
    if top is None:
        return None, problems.in_order()
    course = _course(top, problems, folder)
    top.finish()
    return (None if problems.any_error else course), problems.in_order()


def _course(top: Table, problems: Problems, folder: Path) -> Course | None:
    section = top.table("course", required=True)
    if section is None:
        return None
    title = section.string("title", required=True) or ""
    roster = section.string("roster")
    guests = section.boolean("guests", default=False)
    rooms = tuple(section.strings("rooms") or ("Class",))
    scenes = tuple(section.strings("scenes") or ())
    own = section.boolean("own_robots", default=True)
    section.finish()
    for number, name in enumerate(rooms):
        if not display_name(name) or name in rooms[:number]:
            _error(problems, section, "rooms", f"`{name}` cannot be the name of one more room")
    if len(rooms) > MOST_ROOMS:
        _error(problems, section, "rooms", f"a course has at most {MOST_ROOMS} rooms")
    path = None if roster is None else _inside(problems, section, "roster", folder, roster)
    staff = (
        *_staff(top, problems, "teacher", rooms),
        *_staff(top, problems, "assistant", rooms),
    )
    teams, limits = _teams(top, problems), read_limits(top)
    assignments = _assignments(top, problems, folder)
    slots = read_slots(top, problems, COURSE, rooms)
    login = read_login(top, problems, folder)
    return Course(
        folder,
        title,
        path,
        guests,
        rooms,
        scenes,
        own,
        limits,
        staff,
        teams,
        assignments,
        slots,
        login,
    )


def _staff(
    top: Table, problems: Problems, rank: Rank, shared: tuple[str, ...]
) -> tuple[Staff, ...]:
    found: list[Staff] = []
    for table in top.tables(rank):
        name = table.string("name", required=True) or ""
        email = (table.string("email", required=True) or "").casefold()
        rooms = tuple(table.strings("rooms") or ()) if rank == "assistant" else ()
        table.finish()
        if email and not EMAIL.match(email):
            _error(problems, table, "email", f"`{email}` is no e-mail address")
        for room in rooms:
            if room not in shared:
                hint = f"rooms of this course: {', '.join(shared)}"
                _error(problems, table, "rooms", f"there is no room `{room}`", hint)
        found.append(Staff(rank, name, email, rooms))
    return tuple(found)


def _teams(top: Table, problems: Problems) -> tuple[Team, ...]:
    found: list[Team] = []
    of: dict[str, str] = {}
    for table in top.tables("team"):
        name = table.string("name", required=True) or ""
        members = tuple(one.strip().casefold() for one in table.strings("members") or ())
        table.finish()
        for member in members:
            if of.setdefault(member, name) != name:
                _error(problems, table, "members", f"`{member}` is in team `{of[member]}` already")
        found.append(Team(name, members))
    return tuple(found)


def _assignments(top: Table, problems: Problems, folder: Path) -> tuple[Assignment, ...]:
    found: list[Assignment] = []
    for table in top.tables("assignment"):
        task = table.string("task", required=True)
        id_ = table.string("id")
        opens = table.time("opens")
        attempts = table.integer("attempts", minimum=1, maximum=MOST_ATTEMPTS)
        team = table.boolean("team", default=False)
        marked = table.string("marked")
        table.finish()
        path = None if task is None else _inside(problems, table, "task", folder, task)
        if path is None:
            continue
        if not (path / TASK_FILE).is_file():
            hint = f"`vrts new task {task}` writes one"
            _error(problems, table, "task", f"there is no `{TASK_FILE}` in `{task}`", hint)
            continue
        id_ = id_ or safe(path.name)
        if safe(id_) != id_ or len(id_) > 64:
            _error(problems, table, "id", f"`{id_}` cannot name a folder and an address")
        if id_ in {one.id for one in found}:
            _error(problems, table, "id", f"there are two assignments `{id_}`")
        out = None if marked is None else _inside(problems, table, "marked", folder, marked)
        found.append(Assignment(id_, path, opens, attempts, team, out))
    return tuple(found)


def _inside(problems: Problems, table: Table, key: str, folder: Path, name: str) -> Path | None:
    """Return the path of what a key names, if it lies in the folder of the course."""
    path = folder / name
    if not path.resolve().is_relative_to(folder.resolve()):
        _error(problems, table, key, f"`{name}` lies outside of the course's folder")
        return None
    return path


def _error(problems: Problems, table: Table, key: str, text: str, *help_: str) -> None:
    problems.error(COURSE, text, table.value_span(key), help=help_)
