"""Groups of commands: loaded when they are called, listed in sections, found by near misses."""

import importlib
from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import TYPE_CHECKING, ClassVar

import click

from vrts.cli.grammar.command import spoken

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


def near(word: str, known: Iterable[str]) -> str | None:
    """Return what somebody may have meant who typed a word."""
    close = get_close_matches(word.lower(), list(known), 1, 0.6)
    return close[0] if close else None


class Group(click.Group):
    """A group whose commands all speak alike."""

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return a command with what every command has."""
        found = self.load(ctx, cmd_name)
        return None if found is None else alike(found)

    def load(self, ctx: click.Context, name: str) -> click.Command | None:
        """Return a command as its file declares it."""
        return super().get_command(ctx, name)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that the first word names, or say which one is near."""
        word = args[0]
        if not word.startswith("-") and self.get_command(ctx, word) is None:
            self.no_command(ctx, word)
        return super().resolve_command(ctx, args)

    def no_command(self, ctx: click.Context, word: str) -> None:
        """Say that there is no such command."""
        if ctx.resilient_parsing:
            return
        meant = near(word, self.list_commands(ctx))
        path = ctx.command_path
        remedy = f"did you mean `{path} {meant}`?" if meant else f"`{path} --help` lists all"
        ctx.fail(f"there is no command `{word}`; {remedy}")


class LazyGroup(Group):
    """Loads a command only when it is called, so that help is instant."""

    folder: ClassVar[str]  # package of the files NAME_command.py
    sections: ClassVar[Mapping[str, Mapping[str, str]]]  # heading: name: what it does
    rooms: ClassVar[Mapping[str, str]] = {}  # of commands whose file lies a folder deeper

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all commands, section by section."""
        return [name for section in self.sections.values() for name in section]

    def load(self, ctx: click.Context, name: str) -> click.Command | None:
        """Import and return a command."""
        if name not in self.list_commands(ctx):
            return None
        place = f"{self.folder}.{self.rooms[name]}" if name in self.rooms else self.folder
        return importlib.import_module(f"{place}.{name}_command").command

    def shell_complete(self, ctx: click.Context, incomplete: str) -> "list[CompletionItem]":
        """Return the commands without importing them, and options; or leave it to files."""
        from click.shell_completion import CompletionItem

        found = [
            CompletionItem(name, help=says)
            for section in self.sections.values()
            for name, says in section.items()
            if name.startswith(incomplete)
        ]
        found += click.Command.shell_complete(self, ctx, incomplete)
        return found or [CompletionItem(incomplete, type="file")]

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the commands without importing them."""
        widest = max(map(len, self.list_commands(ctx)))
        for heading, section in self.sections.items():
            with formatter.section(heading):
                formatter.write_dl([(name.ljust(widest), says) for name, says in section.items()])


def alike(command: click.Command) -> click.Command:
    """Return a command, or a group, that speaks as all do."""
    if type(command) is not click.Group:
        return spoken(command)
    return Group(
        name=command.name,
        commands=command.commands,
        context_settings=command.context_settings,
        callback=command.callback,
        params=command.params,
        help=command.help,
        epilog=command.epilog,
        invoke_without_command=command.invoke_without_command,
        no_args_is_help=command.no_args_is_help,
    )
