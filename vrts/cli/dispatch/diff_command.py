"""`vrts dispatch diff`."""

import sys
from pathlib import Path

import click

from vrts.cli.dispatch.serial_line import connected, dated, port_option, transcript_option
from vrts.cli.shared.console import HOLDS, WRONG, guarded, out, say
from vrts.cli.shared.options import color_option

EPILOG = """\b
Example:
  vrts dispatch diff pick.bundle --port /dev/ttyUSB0
"""


@click.command(name="diff", epilog=EPILOG)
@click.argument("bundle", type=click.Path(path_type=Path))
@port_option
@click.option("--profile", help="A corrected copy of the bundle's profile: a file NAME.toml.")
@transcript_option
@color_option
@guarded
def command(
    bundle: Path, port: str, profile: str | None, transcript: Path | None, color: str
) -> None:
    """Compare what a controller holds with a BUNDLE.

    Programs are compared step by step, locations and values as the controller prints them. Nothing
    is changed on the controller. The transcript goes beside the bundle unless --transcript names
    another place. Exit status 1 when something differs.
    """
    from vrts.dispatch.bundle import read_bundle
    from vrts.dispatch.profile import find_profile
    from vrts.dispatch.transfer.cargo import cargo_of
    from vrts.dispatch.transfer.held.diff import differences
    from vrts.pipeline.files import read_bytes
    from vrts.report.plain import plain_text

    read = read_bundle(read_bytes(bundle))
    known = find_profile(profile or read.profile)
    cargo = cargo_of(read, known)
    log = transcript or bundle.with_name(f"{dated(bundle).name}.log")
    with connected(port, known, log) as talk:
        found = differences(talk, known, cargo)
    out(plain_text("".join(f"{row}\n" for row in found)), end=False)
    if not found:
        say("the controller holds what is in the bundle")
    sys.exit(WRONG if found else HOLDS)
