"""`vrts completion`."""

import click
from click.shell_completion import ShellComplete, get_completion_class

from vrts.cli.shared.console import guarded, out

VARIABLE = "_VRTS_COMPLETE"
EPILOG = """\b
Examples:
  eval "$(vrts completion bash)"                       in ~/.bashrc
  eval "$(vrts completion zsh)"                        in ~/.zshrc, after compinit
  vrts completion fish > ~/.config/fish/completions/vrts.fish
"""


@click.command(name="completion", epilog=EPILOG)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
@guarded
def command(ctx: click.Context, shell: str) -> None:
    """Print what a SHELL needs to complete files, scenes, codes, words and students at Tab.

    Bash has to be 4.4 or newer.
    """
    kind = get_completion_class(shell)
    assert kind is not None
    found = kind(ctx.find_root().command, {}, "vrts", VARIABLE)
    out(ShellComplete.source(found))  # of the base: Bash's own asks which Bash is installed here
