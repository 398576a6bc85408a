"""`vrts course mark`."""

import shlex
from pathlib import Path

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, say
from vrts.cli.shared.options import jobs_option

EPILOG = """\b
Examples:
  vrts course mark robotics-2026 pick-and-place -o marked
  vrts grade desk marked --who "Ada Lind"
"""


@click.command(name="mark", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@click.argument("assignment")
@click.option(
    "-o",
    "--output",
    "out",
    required=True,
    type=click.Path(path_type=Path),
    help="Folder for marks and reports.",
)
@jobs_option("Programs that are marked at a time; without it, one for each core.")
@click.option("--again", is_flag=True, help="Mark also what is marked already.")
@click.pass_context
@guarded
def command(
    ctx: click.Context, folder: Path, assignment: str, out: Path, jobs: int | None, again: bool
) -> None:
    """Mark what was handed in for an ASSIGNMENT of the course in FOLDER.

    It calls `vrts grade` with the task, the hand-ins and the list of the class. Hidden checks,
    lateness and all attempts count. A second call marks only what has changed since.
    """
    from vrts.cli.grade.mark_command import command as mark
    from vrts.course.course_file import open_course

    course = open_course(folder)
    found = next((one for one in course.assignments if one.id == assignment), None)
    if found is None:
        known = ", ".join(one.id for one in course.assignments)
        fail(f"the course has no assignment `{assignment}`", (f"its assignments: {known}",))
    handed_in = course.handed_in / found.id
    if not handed_in.is_dir():
        fail(f"nothing was handed in for `{assignment}` yet", ("students do so at /course/work",))
    status = HOLDS
    try:
        ctx.invoke(
            mark,
            task=str(found.task),
            submissions=(handed_in,),
            folder=out,
            class_list=course.roster,
            jobs=jobs,
            again=again,
        )
    except SystemExit as ended:
        status = ended.code if isinstance(ended.code, int) else WRONG
    if status in (HOLDS, WRONG):
        where = shlex.quote(str(out))
        say(f"go on with `vrts grade desk {where} --who YOU`")
        typed = f"vrts course publish {shlex.quote(str(folder))} {found.id} {where}"
        say(f"students see it after `{typed}`")
    if status:
        raise SystemExit(status)
