"""`vrts editor`."""

from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, out, say, write_file
from vrts.cli.shared.options import file_option, overwrite_option

EPILOG = """\b
Examples:
  vrts editor
  vrts editor vscode -o vrts.vsix && code --install-extension vrts.vsix
  vrts editor neovim >> ~/.config/nvim/init.lua
  vrts editor helix >> ~/.config/helix/languages.toml
  vrts editor kate -o vrts-kate
"""
EDITORS = ("vscode", "neovim", "nvim-dap", "emacs", "helix", "kate", "zed")


@click.command(name="editor", epilog=EPILOG)
@click.argument("editor", type=click.Choice(EDITORS), required=False)
@file_option(
    "-o",
    "--output",
    help="File of the extension for VS Code (vrts.vsix), folder for Kate and Zed (vrts-kate).",
)
@overwrite_option("Replace files that exist already.")
@guarded
def command(editor: str | None, output: Path | None, overwrite: bool) -> None:
    """Set an editor up for VAL-II: write its extension or files, or print the lines of a set-up.

    Without EDITOR it lists editors, and what to do for each.
    """
    from vrts.editors.set_up import SET_UPS, listed, printed

    if editor is None:
        out(listed())
    elif SET_UPS[editor].printed:
        out(printed(editor), end=False)
    elif editor == "vscode":
        _extension(output or Path("vrts.vsix"), overwrite=overwrite)
    else:
        _folder(editor, output or Path(f"vrts-{editor}"), overwrite=overwrite)


def _extension(output: Path, *, overwrite: bool) -> None:
    from vrts.editors.vsix import vsix

    if output.exists() and not overwrite:
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    write_file(output, vsix())
    say(f"wrote {output}; install it with `code --install-extension {output}`")


def _folder(editor: str, output: Path, *, overwrite: bool) -> None:
    from vrts.editors.set_up import written

    found = written(editor)
    there = [name for name in found if (output / name).exists()]
    if there and not overwrite:
        hints = ("give another folder, or `--overwrite`",)
        fail(f"`{output / there[0]}` is there already", hints)
    for name, data in found.items():
        (output / name).parent.mkdir(parents=True, exist_ok=True)
        write_file(output / name, data)
    say(f"wrote {len(found)} files to {output}; {output / 'README.txt'} says what to do")
