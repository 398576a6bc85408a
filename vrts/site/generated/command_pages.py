"""Every command of the terminal, made of what `--help` says."""

import re
from collections.abc import Iterator
from typing import NamedTuple

import click

from vrts.cli.main import STATUSES, vrts
from vrts.site.generated.markdown import anchor, block, code, contents, text


class Called(NamedTuple):
    """A command and how it is called."""

    path: tuple[str, ...]
    command: click.Command
    context: click.Context

    @property
    def name(self) -> str:
        """The words in front of its arguments."""
        return " ".join(self.path)


def command_pages() -> dict[str, str]:
    """Return a page for each command, by their names in `look-up/commands`."""
    pages = {called.path[1]: _page(called) for called in top_commands()}
    return {**pages, "index": _index()}


def top_commands() -> tuple[Called, ...]:
    """Return the commands below `vrts`."""
    context = click.Context(vrts, info_name="vrts", help_option_names=["-h", "--help"])
    return tuple(_below(vrts, context, ("vrts",)))


def _below(group: click.Group, context: click.Context, path: tuple[str, ...]) -> Iterator[Called]:
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if command is not None and not command.hidden:
            yield Called((*path, name), command, click.Context(command, context, name))


def _page(called: Called) -> str:
    return "\n".join(_sections(called, 1))


def _sections(called: Called, depth: int) -> Iterator[str]:
    command, context = called.command, called.context
    label = anchor("command", *called.path[1:])
    yield f"({label})=\n{'#' * depth} {called.name}\n"
    yield block("text", command.get_usage(context).removeprefix("Usage: "))
    yield prose(command.help or "")
    options = [found for p in command.get_params(context) if (found := p.get_help_record(context))]
    told = [(names, says) for names, says in options if says]  # the others stand in the first line
    if told:
        yield "\n".join(f"{code(names)}\n: {text(says)}\n" for names, says in told)
    above = context.parent.command.epilog if context.parent is not None else None
    if command.epilog and command.epilog != above:
        yield epilog(command.epilog)
    if isinstance(command, click.Group):
        for below in _below(command, context, called.path):
            yield from _sections(below, depth + 1)


def says(called: Called) -> str:
    """Return what a command does, in one sentence."""
    return called.command.get_short_help_str(200)


def prose(words: str) -> str:
    """Return the help of a command as Markdown: paragraphs, and as it stands what is set off."""
    pieces: list[str] = []
    for paragraph in re.split(r"\n\s*\n", re.sub(r"(?m)^[ \t]+(?=\S)", "", _dedented(words))):
        if paragraph.startswith("\b"):
            pieces.append(block("text", paragraph.removeprefix("\b").strip("\n")))
        elif paragraph.strip():
            pieces.append(text(paragraph) + "\n")
    return "\n".join(pieces)


def epilog(words: str) -> str:
    """Return the examples at the end of a command's help."""
    title, _, lines = words.replace("\b", "").strip().partition("\n")
    if not title.endswith(":"):
        return prose(words)
    return f"{title}\n\n{block('console', _dedented(lines))}"


def _dedented(words: str) -> str:
    lines = words.splitlines()
    margin = min((len(x) - len(x.lstrip()) for x in lines[1:] if x.strip()), default=0)
    return "\n".join([lines[0].lstrip() if lines else "", *(line[margin:] for line in lines[1:])])


def _index() -> str:
    rows = "".join(
        f"{code(called.name)}\n: [{text(says(called))}]({called.path[1]}.md)\n\n"
        for called in top_commands()
    )
    return (
        "# Commands\n\nWhat you type in a terminal. `vrts COMMAND --help` prints the same.\n\n"
        f"{rows}\n{STATUSES}\n\n{contents((c.path[1] for c in top_commands()), hidden=True)}"
    )
