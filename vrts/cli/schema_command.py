"""`vrts schema`."""

import click

from vrts.cli.shared.console import guarded, out
from vrts.schemas import KINDS, input_schema

EPILOG = """\b
Examples:
  vrts schema scene > scene.schema.json
  vrts schema result
"""

RESULTS = (
    "result",
    "class",
    "similarity",
    "decisions",
    "decided",
    "futures",
    "debug",
    "identified",
)


@click.command(name="schema", epilog=EPILOG)
@click.argument("what", type=click.Choice((*KINDS, *RESULTS)))
@guarded
def command(what: str) -> None:
    """Print the JSON Schema of a file that you write, or of an answer that vrts gives.

    You write `scene` (scene.toml), `lab`, `task` (task.toml), `scenario`, `environment`, and
    `columns`, which says what the columns of a robot's log hold. Each key comes with what it means
    and its unit. Editors of TOML check and complete files by these schemas: `vrts editor vscode`
    sets VS Code up; for others, write `#:schema ./scene.schema.json` at the top of your file.

    vrts gives `result`, students/ID/result.json, one marked submission; `class`,
    staff/results.json, all rows with names, deductions and final marks; `similarity`,
    staff/similarity.json, which programs share what few others have; `decisions`, one line of a
    grader's file in staff/decisions; `decided`, what `vrts grade decisions --format json` prints;
    `futures`, what `vrts prove --format json` prints; `debug`, one line of what `vrts debug --json`
    prints, and `identified`, what `vrts validate --identify --json` prints of one log.
    """
    if what in KINDS:
        out(input_schema(what))
        return
    from vrts.report.formats.json_text import json_text

    if what == "identified":
        from vrts.validate.reports.identified_json import identified_schema

        out(json_text(identified_schema()))
        return
    from vrts.marking.schemas import schema

    out(json_text(schema(what)))
