"""`vrts dap`."""

import sys

import click

from vrts.cli.shared.console import guarded

EPILOG = """\b
An editor starts it, and sends with `launch`:
  program      file with the program
  scene        name or path of a scene, or
  task         file of a task; without it the one beside the program
  scenario, lab, entry, with, dialect, nearMiss, stopOnEntry
"""


@click.command(name="dap", epilog=EPILOG)
@guarded
def command() -> None:
    """Debug programs from an editor, forward and backward (Debug Adapter Protocol, stdio)."""
    from vrts.debug.dap.serving import serve

    incoming, outgoing = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr  # nothing but messages goes to the client
    serve(incoming, outgoing)
