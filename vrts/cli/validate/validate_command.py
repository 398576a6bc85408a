"""`vrts validate`: comparing with a log is what it does unless the first word says otherwise."""

import importlib

import click

SUBCOMMANDS = {
    "simulate": "write the log of a simulated robot with errors: synthetic",
    "camera": "draw the simulated robot over the frames of a real camera",
}
LOG = "log"
CAMERA = "camera"


class ValidateGroup(click.Group):
    """Takes a first word that is no subcommand for the program."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put in the name of the subcommand that is left out."""
        if not args or (args[0] not in SUBCOMMANDS and args[0] != LOG):
            seen = any(word.split("=")[0] == f"--{CAMERA}" for word in args)
            args = [CAMERA if seen and CAMERA in SUBCOMMANDS else LOG, *args]
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all subcommands."""
        return [LOG, *SUBCOMMANDS]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return a subcommand."""
        if cmd_name != LOG and cmd_name not in SUBCOMMANDS:
            return None
        module = importlib.import_module(f"vrts.cli.validate.{cmd_name}_command")
        return module.command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the subcommand; `log` is named as it is called, without a name of its own."""
        name, found, rest = super().resolve_command(ctx, args)
        return ("" if name == LOG else name), found, rest


@click.group(name="validate", cls=ValidateGroup)
def command() -> None:
    """Compare a real robot with the run of its program."""
