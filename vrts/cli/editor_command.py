"""`vrts editor`."""

from pathlib import Path

import click

from vrts.cli.console import fail, guarded, out, say, write_file

EPILOG = """\b
Examples:
  vrts editor vscode -o vrts.vsix && code --install-extension vrts.vsix
  vrts editor neovim >> ~/.config/nvim/init.lua
"""
NEOVIM = """\
vim.filetype.add({ extension = { v2 = "val2", pg = "val2", lc = "val2" } })
vim.api.nvim_create_autocmd("FileType", { pattern = "val2", callback = function()
  vim.lsp.start({ name = "vrts", cmd = { "vrts", "lsp" }, root_dir = vim.fn.getcwd() }) end })
"""
EMACS = """\
(define-derived-mode val2-mode prog-mode "VAL-II" (setq-local comment-start ";"))
(add-to-list 'auto-mode-alist '("\\\\.\\\\(v2\\\\|pg\\\\|lc\\\\)\\\\'" . val2-mode))
(with-eval-after-load 'eglot (add-to-list 'eglot-server-programs '(val2-mode "vrts" "lsp")))
"""


@click.command(name="editor", epilog=EPILOG)
@click.argument("editor", type=click.Choice(["vscode", "neovim", "emacs"]))
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    default=Path("vrts.vsix"),
    show_default=True,
    help="File of the extension for VS Code.",
)
@click.option("--overwrite", is_flag=True, help="Replace the file if it is there.")
@guarded
def command(editor: str, output: Path, overwrite: bool) -> None:
    """Set an editor up for VAL-II: write VS Code's extension, or print the lines of a set-up."""
    if editor != "vscode":
        out(NEOVIM if editor == "neovim" else EMACS, end=False)
        return
    from vrts.editors.vsix import vsix

    if output.exists() and not overwrite:
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    write_file(output, vsix())
    say(f"wrote {output}; install it with `code --install-extension {output}`")
