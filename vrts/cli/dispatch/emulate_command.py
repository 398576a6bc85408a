"""`vrts dispatch emulate`."""

import sys
import time

import click

from vrts.cli.shared.console import fail, guarded, out, say, warn
from vrts.cli.shared.options import scene_option
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts dispatch emulate
  vrts dispatch emulate pick.v2 --scene cans-on-bases --profile vplus-serial --baud 38400
"""


@click.command(name="emulate", epilog=EPILOG)
@click.argument("files", metavar="[FILE]...", nargs=-1)
@scene_option()
@click.option("--profile", default="mark2-val2", show_default=True, help="A profile, or its file.")
@click.option(
    "--baud", type=click.IntRange(50), help="Speed of the line; without it the profile's."
)
@guarded
def command(files: tuple[str, ...], scene: str | None, profile: str, baud: int | None) -> None:
    """Emulate a controller at a pseudo-terminal, to practise sending; FILEs are loaded first.

    It prints the name of the port, for `vrts dispatch send`, `fetch` and `diff`, or any terminal
    program. The monitor is that of `vrts monitor`: its files are those of the working folder, and
    its memory is as large as the profile says. Ctrl-C ends it.
    """
    if sys.platform == "win32":
        fail("this needs a pseudo-terminal, which Windows has not")
    from vrts.dispatch.profile import find_profile
    from vrts.dispatch.transfer.emulator import Emulator, Machine
    from vrts.monitor.opening import opened
    from vrts.report.plain import plain_text

    known = find_profile(profile)
    dialogue, said = opened(files, Where(scene), known.dialect, asks=True)
    dialogue.monitor.desk.room = known.memory_bytes
    if said.strip():
        warn(plain_text(said).rstrip("\n"))  # what the monitor answers, errors too
    else:
        say(f"{known.title}, emulated; Ctrl-C ends it")
    emulator = Emulator(Machine(dialogue), baud or known.serial.baud, time.monotonic)
    out(emulator.port)
    sys.stdout.flush()
    try:
        emulator.serve(lambda: True)
    finally:
        emulator.close()
