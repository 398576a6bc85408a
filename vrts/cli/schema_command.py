"""`vrts schema`."""

import click

from vrts.cli.shared.console import guarded, out

EPILOG = """\b
Examples:
  vrts schema result
  vrts schema class > class.schema.json
"""


@click.command(name="schema", epilog=EPILOG)
@click.argument("what", type=click.Choice(["result", "class", "similarity", "futures"]))
@guarded
def command(what: str) -> None:
    """Print the JSON Schema of the files that marking writes, and of what `vrts prove` tells.

    `result` is students/ID/result.json, one marked submission; `class` is staff/results.json,
    all rows with names, deductions and final marks; `similarity` is staff/similarity.json, which
    programs share what few others have; `futures` is what `vrts prove --format json` prints.
    """
    from vrts.marking.schemas import schema
    from vrts.report.formats.json_text import json_text

    out(json_text(schema(what)))
