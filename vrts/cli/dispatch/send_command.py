"""`vrts dispatch send`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.dispatch.serial_line import (
    COPY,
    LOG,
    connected,
    dated,
    transcript_option,
    write_new,
)
from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, out, say, warn
from vrts.cli.shared.options import color_option, file_option

if TYPE_CHECKING:
    from vrts.dispatch.profile import Profile
    from vrts.dispatch.transfer.cargo import Cargo
    from vrts.dispatch.transfer.held.looking import Options

EPILOG = """\b
Examples:
  vrts dispatch send pick.bundle
  vrts dispatch send pick.bundle --port /dev/ttyUSB0 --really
  vrts dispatch send pick.bundle --port /dev/ttyUSB0 --really --resume
"""


@click.command(name="send", epilog=EPILOG)
@click.argument("bundle", type=click.Path(path_type=Path))
@click.option("--port", help="Serial port of the controller: /dev/ttyUSB0, COM3.")
@click.option("--really", is_flag=True, help="Send. Without it nothing is sent: a dry run.")
@click.option("--replace", is_flag=True, help="Replace what differs; a copy is kept in a file.")
@click.option("--resume", is_flag=True, help="Go on where a transfer stopped.")
@file_option("--signers", help="File of allowed signers; one of them has to have signed.")
@click.option("--profile", help="A corrected copy of the bundle's profile: a file NAME.toml.")
@transcript_option
@color_option
@guarded
def command(
    bundle: Path,
    port: str | None,
    really: bool,
    replace: bool,
    resume: bool,
    signers: Path | None,
    profile: str | None,
    transcript: Path | None,
    color: str,
) -> None:
    """Send a BUNDLE to a controller, and read everything back.

    Without --really it prints all lines that would be typed. With it, programs are typed into the
    controller's line editor, and locations are given by POINT. Every echo is compared before
    RETURN, and every prompt is waited for. At the end everything is listed and compared. At the
    first fault it stops, leaves the editor and says what the controller holds.

    The certificates in the bundle are checked first: nothing is sent if one does not hold. With
    --signers nothing is sent unless one of them has signed it (`vrts dispatch sign`).

    It never executes anything, never enables power and never calibrates. The transcript goes beside
    the bundle unless --transcript names another place. Exit status 1 unless everything is verified.
    """
    from vrts.dispatch.bundle import read_bundle
    from vrts.dispatch.profile import find_profile
    from vrts.dispatch.proofs import check_proofs
    from vrts.dispatch.transfer.cargo import cargo_of
    from vrts.dispatch.transfer.held.looking import Options
    from vrts.dispatch.transfer.rehearsal import rehearsed
    from vrts.pipeline.files import read_bytes

    data = read_bytes(bundle)
    read = read_bundle(data)
    _look_who_signed(bundle, data, signers)
    known = find_profile(profile or read.profile)
    for note in check_proofs(read):
        say(f"note: {note}")
    cargo = cargo_of(read, known)
    for waiver in read.manifest.waivers:
        say(f"note: {waiver.code} was waived by {waiver.who}: {waiver.reason}")
    if read.manifest.profile_sha256 != known.digest:
        say("note: the profile is not, to the letter, the one that this bundle was planned with")
    if really and port is None:
        fail("to send, a port is needed", ("name it: `--port /dev/ttyUSB0`",))
    lines = rehearsed(cargo, known)  # what may not be sent is refused before anything is
    if not really or port is None:
        out("".join(f"{line.shown}\n" for line in lines if not line.looks), end=False)
        if any(line.looks for line in lines):
            say("note: RETURN alone goes before each step: the editor has to ask for it still")
        say("dry run: nothing was sent; `--port PORT --really` sends")
        return
    beside = dated(bundle)
    log = transcript or beside.with_name(f"{beside.name}{LOG}")
    copy = beside.with_name(f"{beside.name}{COPY}")
    sys.exit(_send(port, log, copy, known, cargo, Options(replace, resume)))


def _look_who_signed(bundle: Path, data: bytes, signers: Path | None) -> None:
    from vrts.dispatch.verifying.signature import Trust, beside, signature_of

    signature = beside(bundle)
    if signers is not None:
        found = signature_of(data, signature, signers)
        if found.trust is not Trust.TRUSTED:
            fail(
                f"`{bundle.name}` is not signed by an allowed signer: {found.words}",
                ("nothing was sent; `vrts dispatch verify` tells more",),
            )
        say(f"note: {found.words}")
    elif signature.exists():
        say("note: it is signed, and nobody has looked by whom: `--signers FILE` does")
    else:
        warn("note: it is unsigned: nothing shows who has made it")


def _send(
    port: str, log: Path, copy: Path, profile: "Profile", cargo: "Cargo", options: "Options"
) -> int:
    from vrts.cli.shared.progress import Progress
    from vrts.dispatch.transfer.send import Sending

    progress = Progress()

    def told(done: int, total: int, doing: str) -> None:
        progress.advance(done, total)

    def kept(text: str) -> None:
        write_new(copy, text)
        say(f"what is replaced is kept in {copy}")

    with connected(port, profile, log) as talk:
        sending = Sending(talk, profile, cargo, options, told, kept)
        try:
            sending.run()
        finally:
            progress.clear()
            out("".join(f"{name}: {state}\n" for name, state in sending.states.items()), end=False)
    for name, value in sending.missing:
        warn(f"to be entered by hand at the controller: {name} = {value}")
    if not sending.missing:
        say("the controller holds what is in the bundle; how to begin is on the operator's sheet")
    return WRONG if sending.missing else HOLDS
