"""`vrts lsp`."""

import sys

import click

from vrts.cli.shared.console import fail, guarded

EPILOG = """\b
An editor starts it and talks to it over stdin and stdout. Neovim:
  vim.lsp.start({ name = "vrts", cmd = { "vrts", "lsp" } })
Needs the group [ide]: pip install "vrts[ide]"
"""


@click.command(name="lsp", epilog=EPILOG)
@click.option("--no-runs", is_flag=True, help="Run no program in the background: texts alone.")
@guarded
def command(no_runs: bool) -> None:
    """Help an editor with programs while they are written (Language Server Protocol, stdio).

    A program without errors is run in the background, in the scene of the task.toml beside it:
    contacts, limits and speeds appear where they happen, with the speed that would work.
    """
    try:
        from vrts.lsp.server.serving import serve
    except ModuleNotFoundError as missing:
        if missing.name not in ("pygls", "lsprotocol"):
            raise
        fail(f"the package {missing.name} is not installed", ('pip install "vrts[ide]"',))
    incoming, outgoing = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr  # nothing but messages goes to the client
    sys.exit(serve(incoming, outgoing, runs=not no_runs))
