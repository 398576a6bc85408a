"""`vrts support`."""

from difflib import get_close_matches
from typing import NoReturn

import click

from vrts.cli.shared.console import fail, guarded, out, say
from vrts.cli.shared.options import form_option

KINDS = (
    *("instruction", "qualifier", "operator", "function"),
    *("constant", "switch", "parameter", "command"),
)
MOST_FOUND = 3  # words that are shown for what is none
EPILOG = """\b
Examples:
  vrts support
  vrts support MOVES
  vrts support straight
  vrts support "close the gripper"
  vrts support --kind function
  vrts support --dialect as --json
"""


@click.command(name="support", epilog=EPILOG)
@click.argument("word", nargs=-1)
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
def command(word: tuple[str, ...], kind: str | None, dialect: str | None, form: str) -> None:
    """Show the words of the language and how far vrts supports them: all, or one WORD.

    WORD may also be a word of another robot language, or what you want to do in your own words.
    """
    from vrts.lang.dialect import DIALECTS
    from vrts.report.formats.json_text import json_text
    from vrts.report.screen.support_text import as_json, card, overview, table
    from vrts.report.support import entries

    language = DIALECTS[dialect] if dialect else None
    asked = " ".join(word).strip()
    found = entries(language, kind, asked.upper() or None)
    if not found and not asked:
        fail(f"{dialect} has no word of the kind {kind}", ("`vrts support` lists all words",))
    if not found:
        words = _meant(asked)
        found = tuple(e for name in words for e in entries(language, kind, name))[:MOST_FOUND]
        if not found:
            _fail_at(asked)
        say(f"`{asked}` is no word of the language; what may be meant:\n")
    if form == "json":
        out(json_text(as_json(found)))
    elif asked:
        out("\n\n".join(card(entry) for entry in found))
    elif kind is None and dialect is None:
        out(f"{overview(found)}\n\n{table(found)}")
    else:
        out(table(found))


def _meant(asked: str) -> tuple[str, ...]:
    """Return the words that somebody may mean who asks in other words, the likeliest first."""
    from vrts.ask.manual import words_for

    return words_for(asked)


def _fail_at(asked: str) -> NoReturn:
    from vrts.ask.words import facts

    near = get_close_matches(asked.upper(), facts(), 1)
    hint = f"did you mean `{near[0]}`?" if near else "`vrts support` lists all words"
    fail(f"there is no word `{asked[:80]}`", (hint,))
