"""A command as it is spoken: what every command has, whoever wrote it, and its old names."""

from copy import copy
from typing import Any

import click

from vrts.cli.grammar.old_names import VALUES, options_before, tell
from vrts.cli.grammar.outputs import require_outputs
from vrts.cli.grammar.values import completed
from vrts.cli.shared.console import ASIDE, COLOR, QUIET
from vrts.cli.shared.options import color_option

FORM, JSON = "--format", "--json"


class Command(click.Command):
    """A command that takes old names of its options, too, and says what they are now."""

    def make_parser(self, ctx: click.Context) -> Any:
        """Return a parser that knows the old names."""
        parser = super().make_parser(ctx)
        for param in self._old():
            param.add_to_parser(parser, ctx)
        return parser

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Say which names are old, once each, and read the arguments."""
        old = {option for param in self._old() for option in param.opts}
        if not ctx.resilient_parsing and any(word.split("=")[0] in old for word in args):
            renamed = {one.old: one for one in self._renamed()}
            for used in self.make_parser(ctx).parse_args(args=list(args))[2]:
                for option in used.opts:
                    if option in renamed:
                        tell(renamed.pop(option))
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Carry out the command, if what it is to write can be written."""
        ctx.meta[ASIDE] = require_outputs(self, ctx.params)
        return super().invoke(ctx)

    def _renamed(self) -> tuple[Any, ...]:
        options = [p for p in self.params if isinstance(p, click.Option)]
        return options_before(self.name or "", {name for p in options for name in p.opts})

    def _old(self) -> list[click.Option]:
        """Return options by their old names."""
        found: list[click.Option] = []
        for one in self._renamed():
            for param in self.params:
                if isinstance(param, click.Option) and one.new in param.opts:
                    before = copy(param)
                    before.opts = [one.old]
                    before.secondary_opts = []
                    found.append(before)
        return found


class Form(click.Choice[str]):
    """The forms of `--format`, and what they were called before."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the form."""
        for one in VALUES:
            if value == one.old and one.old not in self.choices and one.new in self.choices:
                tell(one)
                value = one.new
        return super().convert(value, param, ctx)


def spoken(command: click.Command) -> click.Command:
    """Return a command with what every command has; a group stays as it is."""
    if isinstance(command, Command | click.Group):
        return command
    return Command(
        name=command.name,
        context_settings=command.context_settings,
        callback=command.callback,
        params=_params(command),
        help=command.help,
        epilog=command.epilog,
        short_help=command.short_help,
        options_metavar=command.options_metavar,
        add_help_option=command.add_help_option,
        no_args_is_help=command.no_args_is_help,
        hidden=command.hidden,
        deprecated=command.deprecated,
    )


def _params(command: click.Command) -> list[click.Parameter]:
    """Return the parameters of a command, and those that all have."""
    names = {name for param in command.params for name in param.opts}
    found: list[click.Parameter] = []
    for param in command.params:
        found.append(completed(param, command.name or ""))
        if FORM in param.opts and isinstance(param.type, click.Choice):
            forms = [str(form) for form in param.type.choices]
            param.type = Form(forms)
            if "json" in forms and JSON not in names:
                found.append(_json(param.name or ""))
    if "--color" not in names:
        found.append(_color())
    if "--quiet" not in names:
        found.append(_quiet())
    return found


def _json(name: str) -> click.Option:
    """Return the short way to say `--format json`: it answers for the same parameter."""
    return click.Option(
        [JSON, name],
        is_flag=True,
        flag_value="json",
        expose_value=False,
        help="The same as `--format json`.",
    )


def _quiet() -> click.Option:
    def keep(ctx: click.Context, _param: click.Parameter, value: bool) -> None:
        ctx.meta[QUIET] = value

    return click.Option(
        ["-q", "--quiet"],
        is_flag=True,
        expose_value=False,
        is_eager=True,
        callback=keep,
        help="On stderr, print only problems.",
    )


def _color() -> click.Option:
    """Return `--color` for a command that asks nobody about it."""

    def keep(ctx: click.Context, _param: click.Parameter, value: str) -> None:
        ctx.meta[COLOR] = value

    @color_option
    @click.command()
    def carrier() -> None:
        """Carry the option."""

    option = carrier.params[0]
    option.expose_value = False
    option.callback = keep
    return option  # type: ignore[return-value]
