"""What the commands that talk to a controller share: its port, its profile, the transcript."""

import time
from collections.abc import Generator
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import fail, say

if TYPE_CHECKING:
    from vrts.dispatch.profile import Profile
    from vrts.dispatch.transfer.talk import Talk

LOG, COPY = ".log", ".before.v2"  # ends of names: the transcript, what was replaced

port_option = click.option(
    "--port", required=True, help="Serial port of the controller: /dev/ttyUSB0, COM3."
)
transcript_option = click.option(
    "--transcript",
    type=click.Path(path_type=Path),
    help="Write everything that goes over the line to this file, with times.",
)


def dated(path: Path) -> Path:
    """Return a file beside another, the time in its name, that nothing of another call is beside.

    That is neither a transcript nor a copy of what was replaced.
    """
    name = f"{path.name}.{datetime.now():%Y%m%d-%H%M%S}"
    free, number = path.with_name(name), 1
    while any(free.with_name(f"{free.name}{end}").exists() for end in (LOG, COPY)):
        number += 1
        free = path.with_name(f"{name}-{number}")
    return free


def refuse_present(path: Path) -> None:
    """End where a file is there already: nothing is overwritten."""
    if path.exists():
        fail(f"`{path}` is there already", ("name another file, or move it away",))


def write_new(path: Path, text: str) -> None:
    """Write a file that is not there yet."""
    refuse_present(path)
    with path.open("x", encoding="utf-8", newline="\n") as file:
        file.write(text)


@contextmanager
def connected(port: str, profile: "Profile", transcript: Path) -> Generator["Talk"]:
    """Open a port and its transcript, and close both in the end."""
    from vrts.dispatch.transfer.port import Port
    from vrts.dispatch.transfer.talk import Talk
    from vrts.dispatch.transfer.transcript import Transcript

    if profile.warning:
        say(f"note: {profile.warning}")
    refuse_present(transcript)
    wire = Port(port, profile.serial, profile.patience.hold_s)
    with transcript.open("x", encoding="utf-8") as file:
        written = Transcript(file, datetime.now)
        written.remark(f"{port}, profile {profile.name} {profile.digest}")
        try:
            yield Talk(wire, profile, written, time.sleep)
        finally:
            written.finish()
            wire.close()
            say(f"transcript: {transcript}")
