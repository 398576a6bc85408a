"""`vrts validate`: comparing with a log is what it does unless the first word says otherwise."""

import click

from vrts.cli.grammar.group import LazyGroup

SUBCOMMANDS = {
    "simulate": "write the log of a simulated robot with errors: synthetic",
    "camera": "draw the simulated robot over the frames of a real camera",
}
LOG = "log"
CAMERA = "camera"
SECTIONS = {
    "Commands": {LOG: "compare the log of a real robot with the run of its program", **SUBCOMMANDS}
}


class ValidateGroup(LazyGroup):
    """Takes a first word that is no subcommand for the program."""

    folder = "vrts.cli.validate"
    sections = SECTIONS

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put in the name of the subcommand that is left out."""
        if ctx.resilient_parsing and not args:  # a shell asks what may be typed
            return super().parse_args(ctx, args)
        if not args or (args[0] not in SUBCOMMANDS and args[0] != LOG):
            seen = any(word.split("=")[0] == f"--{CAMERA}" for word in args)
            args = [CAMERA if seen and CAMERA in SUBCOMMANDS else LOG, *args]
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the subcommand; `log` is named as it is called, without a name of its own."""
        name, found, rest = super().resolve_command(ctx, args)
        return ("" if name == LOG else name), found, rest


@click.group(name="validate", cls=ValidateGroup)
def command() -> None:
    """Compare a real robot with the run of its program."""
