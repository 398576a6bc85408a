"""`vrts editor`."""

from importlib.resources import files
from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, out, say, write_file
from vrts.cli.shared.options import file_option, overwrite_option

EPILOG = """\b
Examples:
  vrts editor vscode -o vrts.vsix && code --install-extension vrts.vsix
  vrts editor neovim >> ~/.config/nvim/init.lua
  vrts editor helix >> ~/.config/helix/languages.toml
"""
SETUP = {"neovim": "neovim.lua", "emacs": "emacs.el", "helix": "helix.toml"}  # in vrts.editors


@click.command(name="editor", epilog=EPILOG)
@click.argument("editor", type=click.Choice(["vscode", "neovim", "emacs", "helix"]))
@file_option(
    "-o",
    "--output",
    default=Path("vrts.vsix"),
    show_default=True,
    help="File of the extension for VS Code.",
)
@overwrite_option("Replace the file if it exists already.")
@guarded
def command(editor: str, output: Path, overwrite: bool) -> None:
    """Set an editor up for VAL-II: write VS Code's extension, or print the lines of a set-up."""
    if editor != "vscode":
        out(files("vrts.editors").joinpath(SETUP[editor]).read_text("utf-8"), end=False)
        return
    from vrts.editors.vsix import vsix

    if output.exists() and not overwrite:
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    write_file(output, vsix())
    say(f"wrote {output}; install it with `code --install-extension {output}`")
