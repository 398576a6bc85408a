"""Every command that vrts has, as it is spoken."""

from collections.abc import Iterator

import click

from vrts.cli.main import vrts


def every_command() -> dict[str, click.Command]:
    """Return all commands that are no groups, by the words that are typed after `vrts`."""
    return dict(_below(vrts, ()))


def options_of(command: click.Command) -> dict[str, click.Option]:
    """Return the options of a command by each of their names."""
    options = [param for param in command.params if isinstance(param, click.Option)]
    return {name: option for option in options for name in (*option.opts, *option.secondary_opts)}


def _below(group: click.Group, path: tuple[str, ...]) -> Iterator[tuple[str, click.Command]]:
    context = click.Context(group, info_name="vrts")
    for name in group.list_commands(context):
        found = group.get_command(context, name)
        assert found is not None, name
        if isinstance(found, click.Group):
            yield from _below(found, (*path, name))
        else:
            yield " ".join((*path, name)), found
