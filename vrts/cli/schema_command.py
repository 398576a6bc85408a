"""`vrts schema`."""

import click

from vrts.cli.shared.console import guarded, out

EPILOG = """\b
Examples:
  vrts schema result
  vrts schema class > class.schema.json
"""


NAMES = ("result", "class", "similarity", "futures", "identified")


@click.command(name="schema", epilog=EPILOG)
@click.argument("what", type=click.Choice(NAMES))
@guarded
def command(what: str) -> None:
    """Print the JSON Schema of the files that marking writes, and of other answers.

    `result` is students/ID/result.json, one marked submission; `class` is staff/results.json,
    all rows with names, deductions and final marks; `similarity` is staff/similarity.json, which
    programs share what few others have; `futures` is what `vrts prove --format json` prints,
    `identified` what `vrts validate --identify --json` prints of one log.
    """
    from vrts.report.formats.json_text import json_text

    if what == "identified":
        from vrts.validate.reports.identified_json import identified_schema

        out(json_text(identified_schema()))
        return
    from vrts.marking.schemas import schema

    out(json_text(schema(what)))
