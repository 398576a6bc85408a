"""The page of the debugger: its keys and its commands, from the tables that the debugger has."""

from collections.abc import Iterator
from itertools import groupby

from vrts.debug.scripted.table import COMMANDS, ELSE
from vrts.debug.terminal.key_table import KEYS, WHILE_TYPING
from vrts.site.generated.markdown import code, table, text

HEAD = """\
# Keys and commands of the debugger

`vrts debug PROGRAM` fills the terminal and takes keys. `:` takes a command, `vrts debug --command`
and `--commands` take the same ones, and most keys are one of them.
[How to use it](../do/debug-backward.md) shows an example.

"""


def debugger_page() -> str:
    """Return the page."""
    return HEAD + "## Keys\n\n" + "".join(_keys()) + "## Commands\n\n" + "".join(_commands())


def _keys() -> Iterator[str]:
    for group, keys in groupby(KEYS, key=lambda key: key.group):
        rows = [(code(key.shown), text(key.says), code(key.command)) for key in keys]
        yield f"### {group}\n\n" + table(("key", "what it does", "as a command"), rows) + "\n"
    yield f"{text(WHILE_TYPING)}\n\n"


def _commands() -> Iterator[str]:
    for group, entries in groupby(COMMANDS, key=lambda entry: entry.group):
        rows = [(code(entry.usage), text(entry.says)) for entry in entries]
        yield f"### {group}\n\n" + table(("command", "what it does"), rows) + "\n"
    yield f"{text(ELSE)}\n"
