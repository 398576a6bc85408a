"""`vrts dispatch fetch`."""

from pathlib import Path

import click

from vrts.cli.dispatch.serial_line import (
    connected,
    dated,
    port_option,
    refuse_present,
    transcript_option,
    write_new,
)
from vrts.cli.shared.console import guarded, out, say
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts dispatch fetch --port /dev/ttyUSB0 --profile mark2-val2 -o backup.v2
  vrts dispatch fetch pick place --port /dev/ttyUSB0 --profile mark2-val2
"""


@click.command(name="fetch", epilog=EPILOG)
@click.argument("names", metavar="[PROGRAM]...", nargs=-1)
@port_option
@click.option("--profile", required=True, help="Name of a profile, or a file NAME.toml.")
@file_option("-o", "--output", help="File to write; without it stdout.")
@transcript_option
@color_option
@guarded
def command(
    names: tuple[str, ...],
    port: str,
    profile: str,
    output: Path | None,
    transcript: Path | None,
    color: str,
) -> None:
    """Fetch programs and locations from a controller into a file that vrts reads.

    Without PROGRAM it fetches all programs. It always fetches all locations, with the decimals that
    the controller prints. Everything is listed twice, and both lists have to agree. Nothing is
    changed on the controller. The transcript goes beside the output unless --transcript names
    another place.
    """
    from vrts.dispatch.profile import find_profile
    from vrts.dispatch.transfer.held.fetch import fetch, fetched_text
    from vrts.report.plain import visible

    known = find_profile(profile)
    if output is not None:
        refuse_present(output)
    log = transcript or Path(f"{dated(output or Path('fetched'))}.log")
    with connected(port, known, log) as talk:
        found = fetch(talk, known, [name.lower() for name in names])
    text = fetched_text(found, known.language)
    if output is None:
        out(visible(text), end=False)
    else:
        write_new(output, text)
    say(f"fetched: {', '.join(p.name for p in found.programs) or 'no program'}")
    say(f"locations: {', '.join(place.name for place in found.places) or 'none'}")
