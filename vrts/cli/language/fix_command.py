"""`vrts fix`."""

import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import click

from vrts.base.diagnostic import Diagnostic
from vrts.cli.language.changes import file_shown, print_diff
from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    out_bytes,
    say,
    show_diagnostics,
    warn,
    write_file,
)
from vrts.cli.shared.options import color_option, dialect_option, task_option
from vrts.cli.shared.programs import given_program

EPILOG = """\b
Examples:
  vrts fix prog.v2
  vrts fix --diff prog.v2
  vrts fix --write submissions/*.v2
  cat prog.v2 | vrts fix --write - > mended.v2
  vrts fix --behaviour --diff prog.v2
"""


@click.command(name="fix", epilog=EPILOG)
@click.argument("programs", metavar="PROGRAM...", nargs=-1, required=True)
@click.option("--diff", is_flag=True, help="Print what would change, and write no file.")
@click.option("--write", is_flag=True, help="Write the corrected program; stdin goes to stdout.")
@click.option(
    "--behaviour",
    is_flag=True,
    help="Look for the smallest change that earns the full mark, by running and certifying it.",
)
@task_option()
@dialect_option("Dialect of the program; auto looks at file name and content.", default="auto")
@color_option
@guarded
def command(
    programs: tuple[str, ...],
    diff: bool,
    write: bool,
    behaviour: bool,
    task: Path | None,
    dialect: str,
    color: str,
) -> None:
    """Correct the mistakes in each PROGRAM (a file, or - for stdin) that have a sure remedy.

    It lists what it would change, and writes nothing without --write. It changes only what a
    message has a sure remedy for; every other byte stays. Exit status 1 when errors are left.

    With --behaviour it mends what programs do, with one change each. The hints that the task allows
    decide how much it says: the task beside the program, or the one that you give. Exit status 1
    when a program loses points that no change wins back.
    """
    if behaviour:
        from vrts.cli.language.behaviour import mend_behaviour

        sys.exit(mend_behaviour(programs, task, dialect, show=diff, write=write))
    if task is not None:
        fail("only behaviour is mended for a task", ("add `--behaviour`",))
    from vrts.pipeline.compiling.fixing import fix_bytes
    from vrts.pipeline.compiling.reading import Reading

    status = HOLDS
    for program in programs:
        (data, name), path = given_program(program)
        found = fix_bytes(data, name, Reading(None if dialect == "auto" else dialect))
        if found.dialect is None:
            show_diagnostics(found.left, color)
            status = WRONG
            continue
        errors = sum(d.is_error for d in found.left)
        status = WRONG if errors else status
        if diff:
            print_diff(found.before, found.after, name)
        elif not write:
            for diagnostic in found.applied:
                out(_line(diagnostic))
        elif path is None:
            out_bytes(found.data)
        elif found.data != data:
            write_file(path, found.data)
            say(f"mended {file_shown(path, name)}: {_count(found.applied)}")
        if not found.applied:
            say(f"{name}: nothing to mend" + (" for certain" if errors else ""))
        if errors:
            warn(f"{name}: {_left(errors)}; `vrts compile {program}` says more")
    sys.exit(status)


def _line(diagnostic: Diagnostic) -> str:
    """Return what is wrong, and what would be written for it."""
    from vrts.report.plain import plain_text

    assert diagnostic.fix is not None
    span = diagnostic.primary.span if diagnostic.primary else diagnostic.fix.span
    where = f"{span.source.name}:{span.line}:{span.column}"
    return plain_text(f"{where}: {diagnostic.headline}: {_does(diagnostic)}")


def _does(diagnostic: Diagnostic) -> str:
    fix = diagnostic.fix
    assert fix is not None
    more = len(fix.more)
    shares = Counter((edit.span.text, edit.replacement) for edit in fix.edits)
    before, after = fix.span.text.strip(), " / ".join(fix.replacement.split("\n")).strip(" /")
    if not before:
        does = f"write `{after}`"
    elif not after:
        does = f"take `{before}` out"
    else:
        does = f"write `{after}` for `{before}`"
    if not more:
        return does
    places = "place" if more == 1 else "places"
    return f"{does}, and {'so' if len(shares) == 1 else 'change'} {more} more {places}"


def _count(applied: Sequence[Diagnostic]) -> str:
    return f"{len(applied)} mistake{'' if len(applied) == 1 else 's'}"


def _left(errors: int) -> str:
    return f"{errors} error{' is' if errors == 1 else 's are'} left"
