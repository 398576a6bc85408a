"""`vrts purge`."""

import os
import re
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import color_option

if TYPE_CHECKING:
    from vrts.marking.personal.forget import Job
    from vrts.marking.privacy.purge import Looked

EPILOG = """\b
Examples:
  vrts purge out --older-than 180d
  vrts purge 2025w/* --older-than 1y --yes --keep-statistics
  vrts purge out 2025w/* --student anna
"""

DAYS = {"d": 1, "w": 7, "y": 365}
MOST_NAMED = 5
NAME_TOO = "name {} in this call, too"


class Age(click.ParamType[timedelta]):
    """Days, weeks or years, such as 180d, 26w, 1y."""

    name = "age"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> timedelta:
        """Return the duration."""
        found = re.fullmatch(r"(\d{1,5})([dwy])", str(value).strip())
        if found is None:
            self.fail(f"`{value}` is no age: write such as 180d, 26w or 1y", param, ctx)
        return timedelta(days=int(found[1]) * DAYS[found[2]])


@click.command(name="purge", epilog=EPILOG)
@click.argument(
    "folders", metavar="OUT...", nargs=-1, required=True, type=click.Path(path_type=Path)
)
@click.option(
    "--older-than",
    type=Age(),
    metavar="AGE",
    help="Time since the marking, such as 180d, 26w or 1y; 0d for all.",
)
@click.option(
    "--student",
    metavar="ID",
    help="Forget this one student instead: id or pseudonym, or a name that only one has.",
)
@click.option(
    "--keep-statistics",
    is_flag=True,
    help="Keep the marks, sorted and without names, and how often each check was met.",
)
@click.option("-y", "--yes", is_flag=True, help="Do not ask.")
@color_option
@guarded
def command(
    folders: tuple[Path, ...],
    older_than: timedelta | None,
    student: str | None,
    keep_statistics: bool,
    yes: bool,
    color: str,
) -> None:
    """Delete what markings wrote about people into the folders OUT.

    It deletes results, reports, recordings, tables of hand-ins and of names, marks, changes by
    hand, decisions of graders, variants, exports in staff/exports, similarity and overview. It
    looks in students and staff, for the names that vrts gives these files. Any other file stays,
    and is named. Downloads, evidence, and what was exported to other places stay, too. The key of
    variants and `variants.csv` of `vrts task variants` lie elsewhere, and stay.

    The age is the time since the marking, as staff/marking.json says; the dates of files do not
    matter. Younger markings stay. A marking that was interrupted counts from its start. Folders
    without a marking are refused, also plans, which hold names and tell no age. Links are not
    followed. In a small class, sorted marks may show who had which.

    A later marking that was compared with OUT shows programs of it in its own pages. Such markings
    in the same folder as OUT are named, and stay: purge them too, or compare them again. vrts does
    not look elsewhere.

    With --student, one student is forgotten, and all others keep what they have, byte for byte:
    folders, rows, decisions of graders about them, their program among those that are kept to
    compare. Lists are written again, and programs are compared again. Exports in staff/exports that
    name the student are deleted. Whatever interrupts this, the same call ends it. A desk may run
    meanwhile, a marking may not. What still may name the student is told, and stays.
    """
    if (older_than is None) == (student is None):
        fail("say what to delete: either `--older-than AGE`, or `--student ID`")
    if student is not None:
        if keep_statistics:
            fail("`--keep-statistics` belongs to `--older-than`: the marks of all others stay")
        _forget(tuple(dict.fromkeys(folders)), student, yes, color)
        return
    assert older_than is not None
    from vrts.marking.privacy.plans import holds_plan
    from vrts.marking.privacy.purge import State, look, purge
    from vrts.marking.similarity.copies import copies_told

    now = datetime.now(UTC)
    looked = [look(folder, older_than, now) for folder in dict.fromkeys(folders)]
    due = [one for one in looked if one.state is State.DUE]
    for one in looked:
        out(_line(one))
        for name in one.left[:MOST_NAMED] if one in due else ():
            out(f"  stays: {_plain(name)}, {_what(one.folder / name)}")
        for name in one.left[MOST_NAMED:] if one in due else ():
            if holds_plan(one.folder / name):
                out(f"  stays: {_plain(name)}, {_what(one.folder / name)}")
        if one in due and len(one.left) > MOST_NAMED:
            out(f"  and {len(one.left) - MOST_NAMED} more that stay")
    if not due:
        say("nothing is deleted")
        return
    going = [one.folder for one in due]
    show_diagnostics([told for one in going for told in copies_told(one, going)], color)
    one_of = "1 folder" if len(due) == 1 else f"{len(due)} folders"
    if not yes:
        click.confirm(f"Delete this, in {one_of}, for good?", abort=True, err=True)
    for one in due:
        purge(one, keep_statistics=keep_statistics)
        kept = ", statistics are kept" if keep_statistics else ""
        out(f"deleted {_count(one)} in {_plain(str(one.folder))}{kept}")


def _forget(folders: tuple[Path, ...], student: str, yes: bool, color: str) -> None:
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.personal.forget import forget, planned
    from vrts.marking.similarity.copies import copies_told

    jobs = planned(folders, student)
    for job in jobs:
        out(_job_line(job))
    for folder in folders:
        if folder not in [job.layout.root for job in jobs]:
            out(f"{_plain(str(folder))}: nobody of that id")
    going = [job.layout.root for job in jobs]
    mine = [job.layout.root for job in jobs if job.whom.id]
    copies = [told for one in mine for told in copies_told(one, [*folders, *going], NAME_TOO)]
    show_diagnostics(copies, color)
    if not yes:
        where = "1 marking" if len(mine) == 1 else f"{len(mine)} markings"
        click.confirm(f"Forget this student, in {where}, for good?", abort=True, err=True)
    for job, done in zip(jobs, forget(jobs), strict=True):
        for name in done.exports:
            out(f"deleted {_plain(str(job.layout.root / name))}, which named the student")
        show_diagnostics(done.diagnostics, color)
        where = _plain(str(job.layout.root))
        out(f"{where}: {'forgotten' if job.whom.id else 'compared again'}")
    say("note: downloads stay: delete what they handed in there, or marking again brings it back")


def _job_line(job: "Job") -> str:
    start = f"{_plain(str(job.layout.root))}: {_plain(job.title)}"
    who = f"forget `{_plain(job.whom.id)}`" if job.whom.id else "compare programs again"
    name = next((one for one in job.whom.names if one not in job.whom.ids), "")
    called = f" ({_plain(name)})" if name and len(job.whom.ids) < 2 else ""
    return f"{start}: {'go on to ' if job.goes_on else ''}{who}{called}"


def _what(place: Path) -> str:
    """Return what a file or folder is that stays."""
    from vrts.marking.privacy.plans import holds_plan

    if holds_plan(place):
        return "a plan, which holds names: delete it by hand when its results are merged"
    return "which vrts has not written"


def _line(one: "Looked") -> str:
    where = _plain(str(one.folder))
    if one.about is None:
        return f"{where}: purged before"
    ago = "today" if one.age.days < 1 else f"{one.age.days} days ago"
    did = "begun, and not ended," if one.about.finished is None else "marked"
    start = f"{where}: {_plain(one.about.title)}, {did} {ago}"
    return f"{start}, {one.state.value}: {_count(one)}"


def _count(one: "Looked") -> str:
    files = "1 file" if one.files == 1 else f"{one.files:,} files"
    return f"{files}, {one.size / 1e6:.1f} MB"


def _plain(text: str) -> str:
    from vrts.report.plain import one_line

    return one_line(text)
