"""`vrts manual`."""

import webbrowser
from importlib.resources import files
from pathlib import Path

import click

from vrts.cli.shared.console import WRONG, fail, guarded, out, say

SITE = Path(str(files("vrts"))) / "site" / "built"
NOT_BUILT = (
    "the manual's pages were not built when vrts was installed",
    (
        "type `python -m pip install -e .` in the folder with pyproject.toml: it builds them",
        "or read the same texts as they are written, in `vrts/manual`",
    ),
)
EPILOG = """\b
Examples:
  vrts manual
  vrts manual --path
"""


@click.command(name="manual", epilog=EPILOG)
@click.option("--path", is_flag=True, help="Only print where the manual is; open nothing.")
@guarded
def command(path: bool) -> None:
    """Open the manual in the browser. It is on this machine: no network is needed."""
    first = first_page()
    if first is None:
        fail(*NOT_BUILT, status=WRONG)
    out(str(first))
    if not path and not webbrowser.open(first.as_uri()):
        say("no browser could be opened: open this file in one")


def first_page() -> Path | None:
    """Return the manual's first page; None where it was not built."""
    first = SITE / "index.html"
    return first if first.is_file() else None
