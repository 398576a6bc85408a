"""`vrts support`."""

from difflib import get_close_matches

import click

from vrts.cli.shared.console import fail, guarded, out
from vrts.cli.shared.options import form_option

KINDS = (
    *("instruction", "qualifier", "operator", "function"),
    *("constant", "switch", "parameter", "command"),
)
EPILOG = """\b
Examples:
  vrts support
  vrts support MOVE
  vrts support --kind function
  vrts support --dialect as --json
"""


@click.command(name="support", epilog=EPILOG)
@click.argument("word", required=False)
@click.option(
    "--kind",
    type=click.Choice(KINDS),
    help="Only words of one kind.",
)
@click.option(
    "--dialect",
    type=click.Choice(["val2", "val2+", "val", "vplus", "as"]),
    help="Only words of one language of the family.",
)
@form_option("full", "json")
@guarded
def command(word: str | None, kind: str | None, dialect: str | None, form: str) -> None:
    """Show the words of the language and how far vrts goes with them; all, or one WORD."""
    from vrts.lang.dialect import DIALECTS
    from vrts.report.formats.json_text import json_text
    from vrts.report.screen.support_text import as_json, card, table
    from vrts.report.support import entries

    found = entries(DIALECTS[dialect] if dialect else None, kind)
    if not found:
        fail(f"{dialect} has no word of the kind {kind}", ("`vrts support` lists all words",))
    if word is not None:
        names = {entry.word for entry in found}
        found = tuple(entry for entry in found if entry.word == word.upper())
        if not found:
            near = get_close_matches(word.upper(), names, 1)
            hint = f"did you mean `{near[0]}`?" if near else "`vrts support` lists all words"
            fail(f"there is no word `{word}`", (hint,))
    if form == "json":
        out(json_text(as_json(found)))
    elif word is not None:
        out("\n\n".join(card(entry) for entry in found))
    else:
        out(table(found))
