"""`vrts help`."""

import click

EPILOG = """\b
Examples:
  vrts help
  vrts help verify
  vrts help grade export
"""


@click.command(name="help", epilog=EPILOG)
@click.argument("words", metavar="[COMMAND]...", nargs=-1)
@click.pass_context
def command(ctx: click.Context, words: tuple[str, ...]) -> None:
    """Show the help of a COMMAND, as `vrts COMMAND --help` does."""
    root = ctx.find_root()
    assert isinstance(root.command, click.Group)
    with root.command.make_context(root.info_name, [*words, "--help"]) as asked:
        root.command.invoke(asked)
