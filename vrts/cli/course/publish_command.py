"""`vrts course publish`."""

from pathlib import Path

import click

from vrts.cli.grade.options import despite_option
from vrts.cli.shared.console import fail, guarded, say, show_diagnostics
from vrts.cli.shared.options import color_option

EPILOG = """\b
Examples:
  vrts course publish robotics-2026 pick-and-place marked
  vrts course publish robotics-2026 pick-and-place --withdraw
"""


@click.command(name="publish", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@click.argument("assignment")
@click.argument("out", required=False, type=click.Path(path_type=Path))
@click.option("--withdraw", is_flag=True, help="Let nobody see what was published.")
@despite_option()
@color_option
@guarded
def command(
    folder: Path,
    assignment: str,
    out: Path | None,
    withdraw: bool,
    despite: tuple[str, ...],
    color: str,
) -> None:
    """Let students see their final marks of an ASSIGNMENT, as marked in OUT.

    Each sees their own: the mark, how it came to be, what graders say about lines and moments, and
    the report. Nothing is published while marks are unsafe, unless you give `--despite`. Publish
    again after you have changed something. A server that runs shows it at once.
    """
    from vrts.course.course_file import open_course
    from vrts.course.handing import publishing

    course = open_course(folder)
    known = [one.id for one in course.assignments]
    if assignment not in known:
        hint = f"its assignments: {', '.join(known)}"
        fail(f"the course has no assignment `{assignment}`", (hint,))
    if withdraw:
        if out is not None or despite:
            fail("`--withdraw` goes alone: it takes no marking and no `--despite`")
        there = publishing.withdraw(course, assignment)
        say("withdrawn: students see no final marks" if there else "nothing was published")
        return
    if out is None:
        fail("which marking?", ("name the folder that `vrts course mark` wrote",))
    done = publishing.publish(course, assignment, out, frozenset(despite))
    show_diagnostics(done.diagnostics, color)
    count = f"{done.students} student{'' if done.students == 1 else 's'}"
    say(f"published for {count}; `--withdraw` takes it back")
