"""`vrts fmt`."""

import sys
from collections.abc import Sequence

import click

from vrts.cli.language.changes import file_shown, print_diff
from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    guarded,
    out_bytes,
    say,
    show_diagnostics,
    warn,
    write_file,
)
from vrts.cli.shared.options import color_option, dialect_option
from vrts.cli.shared.programs import given_program

LINES_SHOWN = 5

EPILOG = """\b
Examples:
  vrts fmt prog.v2
  vrts fmt --check submissions/*.v2
  vrts fmt --diff prog.v2
  cat prog.v2 | vrts fmt -
"""


@click.command(name="fmt", epilog=EPILOG)
@click.argument("programs", metavar="PROGRAM...", nargs=-1, required=True)
@click.option("--check", is_flag=True, help="Write nothing; exit status 1 if a file would change.")
@click.option("--diff", is_flag=True, help="Print what would change, and write no file.")
@dialect_option("Dialect of the program; auto looks at file name and content.", default="auto")
@color_option
@guarded
def command(programs: tuple[str, ...], check: bool, diff: bool, dialect: str, color: str) -> None:
    """Write each PROGRAM (a file, or - for stdin) in the standard layout.

    Keywords become upper case, names lower case, and structures are indented. Comments, blank
    lines, the numbers of the steps, encoding and line ends stay, and the program means the same. A
    line that cannot be read stays as it is; the exit status is 1 then.
    """
    from vrts.pipeline.compiling.formatting import format_bytes

    status = HOLDS
    for program in programs:
        (data, name), path = given_program(program)
        found = format_bytes(data, name, None if dialect == "auto" else dialect)
        if found.diagnostic is not None:
            show_diagnostics([found.diagnostic], color)
            status = WRONG
            continue
        if diff:
            print_diff(found.before, found.after, name)
            status = WRONG if found.changed and check else status
        elif check:
            if found.changed:
                say(f"would change {name}")
                status = WRONG
        elif path is None:
            out_bytes(found.data)
        elif found.changed:
            write_file(path, found.data)
            say(f"changed {file_shown(path, name)}")
        if found.unread:
            warn(f"{name}: {_unread(found.unread)}; `vrts compile {program}` says why")
            status = WRONG
    sys.exit(status)


def _unread(lines: Sequence[int]) -> str:
    first = ", ".join(map(str, lines[:LINES_SHOWN]))
    if len(lines) == 1:
        return f"line {first} cannot be read and stays as it is"
    more = f" and {len(lines) - LINES_SHOWN} more" if len(lines) > LINES_SHOWN else ""
    return f"lines {first}{more} cannot be read and stay as they are"
