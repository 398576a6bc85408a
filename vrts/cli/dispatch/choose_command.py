"""`vrts dispatch choose`."""

import sys
from pathlib import Path

import click

from vrts.cli.shared.console import HOLDS, WRONG, guarded, out
from vrts.cli.shared.options import color_option, form_option

EPILOG = """\b
Examples:
  vrts dispatch choose out
  vrts dispatch choose out --format json
"""


@click.command(name="choose", epilog=EPILOG)
@click.argument("results", type=click.Path(path_type=Path))
@form_option("full", "json")
@color_option
@guarded
def command(results: Path, form: str, color: str) -> None:
    """List the programs of a marking that are ready for the real robot.

    RESULTS is the folder that `vrts grade` wrote with -o, or its staff/results.json. The largest
    clearance comes first; where clearances agree to 1 mm, the higher mark. If the class was marked
    with pseudonyms, nobody is named. Before you send a program, plan it with `vrts dispatch plan`.
    Exit status 1 when no program is ready.
    """
    from vrts.dispatch.planning.choose import choices, choices_text
    from vrts.marking.appeals.written import read_class
    from vrts.marking.layout import Layout
    from vrts.report.plain import plain_text

    rows = read_class(Layout(results).results if results.is_dir() else results, results)
    found = choices(rows)
    if form == "json":
        from vrts.report.formats.json_text import json_text

        listed = [choice._asdict() for choice in found]
        out(json_text({"ready": listed, "marked": len(rows.rows)}))
    else:
        out(plain_text(choices_text(found, len(rows.rows))))
    sys.exit(HOLDS if found else WRONG)
