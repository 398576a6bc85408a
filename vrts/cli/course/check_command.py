"""`vrts course check`."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import WRONG, fail, guarded, out, show_diagnostics
from vrts.cli.shared.options import color_option

if TYPE_CHECKING:
    from vrts.course.course import Course
    from vrts.course.people.sources import Read

EPILOG = """\b
Examples:
  vrts course check robotics-2026
"""


@click.command(name="check", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@color_option
@guarded
def command(folder: Path, color: str) -> None:
    """Show all faults of the files of a course, and what `vrts serve FOLDER` will serve.

    Nothing is changed, and no provider is asked.
    """
    from vrts.course.people.sources import read_people

    read = read_people(folder)
    show_diagnostics(read.found, color)
    if read.missing:
        fail(read.missing, ("`vrts course new FOLDER` writes a course",))
    if read.course is None:
        raise SystemExit(WRONG)
    for line in served(read):
        out(line)
    if not read.good:
        raise SystemExit(WRONG)


def served(read: "Read") -> list[str]:
    """Return what will be served, in lines."""
    from vrts.course.places import places_of_course
    from vrts.live.session.setting import has_variants
    from vrts.pipeline.files import TASK_FILE

    course = read.course
    assert course is not None, "was looked at"
    ranks = [one.rank for one in read.people]
    counted = [
        f"{ranks.count(rank)} {rank}{'' if ranks.count(rank) == 1 else 's'}"
        for rank in ("teacher", "assistant", "student")
    ]
    lines = [
        f"{course.title}",
        f"  people       {', '.join(counted)}",
        f"  guests       {'come in by the class code' if course.guests else 'do not come in'}",
        f"  log-in       {'password' if course.login is None else course.login.issuer}",
        f"  rooms        {', '.join(course.rooms)}",
        f"  scenes       {', '.join(place.id for place in places_of_course(course)) or 'none'}",
    ]
    for one in course.assignments:
        opens = "open" if one.opens is None else f"opens {one.opens:%Y-%m-%d %H:%M %z}".rstrip()
        attempts = "" if one.attempts is None else f", {one.attempts} attempts"
        lines.append(
            f"  assignment   {one.id}: {opens}{attempts}{', by teams' if one.team else ''}"
        )
        if has_variants(one.task / TASK_FILE):
            each = "team" if one.team else "student"
            lines.append(
                f"               another variant for each {each}: {_fair(one.task, course)}"
            )
    return lines


def _fair(task: Path, course: "Course") -> str:
    """Return which command tells whether variants are fair; nobody has one without a list."""
    if course.roster is None:
        return "nobody gets one without `roster`"
    words = (str(task), "--roster", str(course.roster))
    return f"`vrts task check {shlex.join(words)}` tells whether they are fair"
