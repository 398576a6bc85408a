"""`vrts compile`."""

import sys
from typing import TYPE_CHECKING

import click

from vrts.cli.language.problems import FORMS, Form, render
from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    use_color,
)
from vrts.cli.shared.options import Language, color_option, language_options
from vrts.cli.shared.programs import given_program, reading_of
from vrts.report.formats.checked import Checked

if TYPE_CHECKING:
    from vrts.pipeline.compiling.programs import Compiled

EPILOG = """\b
Examples:
  vrts compile prog.v2
  vrts compile prog.v2 --emit ir
  vrts compile main.v2 --with points.lc --dialect val2+
  vrts compile *.v2 --format concise
  cat prog.v2 | vrts compile - --format sarif
"""


@click.command(name="compile", epilog=EPILOG)
@click.argument("programs", metavar="PROGRAM...", nargs=-1, required=True)
@click.option(
    "--emit",
    type=click.Choice(["nothing", "ir", "store"]),
    default="nothing",
    help="Print the compiled form (IR), or what STORE writes.",
)
@click.option("--exact", is_flag=True, help="With --emit store: locations with all their digits.")
@click.option(
    "--format",
    "form",
    type=click.Choice(FORMS),
    default="full",
    show_default=True,
    help="How to print problems: full goes to stderr, all others to stdout.",
)
@language_options
@color_option
@guarded
def command(
    programs: tuple[str, ...],
    emit: str,
    exact: bool,
    form: Form,
    language: Language,
    color: str,
) -> None:
    """Check each PROGRAM (a file, or - for stdin) for mistakes, without running it."""
    from vrts.pipeline.compiling.programs import compile_bytes

    if emit != "nothing" and form != "full":
        fail(
            f"`--emit {emit}` and `--format {form}` both write to stdout", ("ask for one of them",)
        )
    given = [given_program(name).program for name in programs]
    reading = reading_of(language)
    compiled = [(file.name, compile_bytes(file.data, file.name, reading)) for file in given]
    if form == "full":
        for name, found in compiled:
            _show(name, found, emit, color, exact=exact)
    else:
        checked = [Checked(name, c.diagnostics, _compiles(c)) for name, c in compiled]
        text = render(checked, form, color=use_color(color))
        if text:
            out(text)
    sys.exit(HOLDS if all(_compiles(found) for _, found in compiled) else WRONG)


def _show(name: str, found: "Compiled", emit: str, color: str, *, exact: bool) -> None:
    """Write what was found in one file to stderr, and what was asked for to stdout."""
    show_diagnostics(found.diagnostics, color)
    module = found.compilation.module if found.compilation else None
    if module is None:
        return
    if emit == "ir":
        from vrts.ir.dump import dump

        out(dump(module), end=False)
    elif emit == "store":
        from vrts.pipeline.compiling.storing import store

        assert found.compilation is not None
        out(store(found.compilation, exact=exact), end=False)
    else:
        say(f"{name}: {_contents(len(module.programs), len(module.data))}, compiles")


def _compiles(found: "Compiled") -> bool:
    return found.compilation is not None and found.compilation.module is not None


def _contents(programs: int, data: int) -> str:
    return (
        f"{programs} program{'' if programs == 1 else 's'}, {data} value{'' if data == 1 else 's'}"
    )
