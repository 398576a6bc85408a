"""`vrts compile`."""

import sys

import click

from vrts.cli.console import (
    HOLDS,
    WRONG,
    color_option,
    guarded,
    out,
    program_bytes,
    say,
    show_diagnostics,
)

EPILOG = """\b
Examples:
  vrts compile prog.v2
  vrts compile prog.v2 --emit ir
  cat prog.v2 | vrts compile - --format json
"""


@click.command(name="compile", epilog=EPILOG)
@click.argument("program")
@click.option(
    "--emit", type=click.Choice(["nothing", "ir"]), default="nothing", help="Print the IR."
)
@click.option("--format", "form", type=click.Choice(["full", "json"]), default="full")
@color_option
@guarded
def command(program: str, emit: str, form: str, color: str) -> None:
    """Check PROGRAM (a file, or - for stdin) for mistakes, without running it."""
    from vrts.pipeline import compile_bytes

    data, name, _ = program_bytes(program)
    compiled = compile_bytes(data, name)
    module = compiled.compilation.module if compiled.compilation else None
    if form == "json":
        import json

        from vrts.report.json_form import diagnostic_json

        rows = [diagnostic_json(d) for d in compiled.diagnostics]
        out(
            json.dumps(
                {
                    "schema": "vrts.diagnostics/1",
                    "compiles": module is not None,
                    "diagnostics": rows,
                },
                indent=2,
                ensure_ascii=False,
            )
        )
    else:
        show_diagnostics(compiled.diagnostics, color)
    if module is None:
        sys.exit(WRONG)
    if emit == "ir":
        from vrts.ir.dump import dump

        out(dump(module), end=False)
    elif form == "full":
        say(f"{name}: {_contents(len(module.programs), len(module.data))}, compiles")
    sys.exit(HOLDS)


def _contents(programs: int, data: int) -> str:
    return (
        f"{programs} program{'' if programs == 1 else 's'}, {data} value{'' if data == 1 else 's'}"
    )
