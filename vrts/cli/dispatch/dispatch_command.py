"""`vrts dispatch`: a group whose subcommands are loaded when they are called."""

import click

from vrts.cli.grammar.group import LazyGroup

SUBCOMMANDS = {
    "plan": "verify a program for a real controller, and write a bundle",
    "verify": "prove everything in a bundle again, and say who has signed it",
    "sign": "sign a bundle with a key of OpenSSH",
    "choose": "list the ready programs of a marking by clearance and mark",
    "send": "send a bundle to a controller and read everything back",
    "fetch": "fetch programs and locations from a controller",
    "diff": "compare what a controller holds with a bundle",
    "profile": "list the profiles of controllers, or print one to correct",
    "emulate": "emulate a controller at a pseudo-terminal",
    "export": "write a verified program in the language of another controller",
    "rehearse": "run an exported folder on LinuxCNC, and compare the motion",
}
SECTIONS = {"Commands": SUBCOMMANDS}


class DispatchGroup(LazyGroup):
    """The subcommands in the order of use."""

    folder = "vrts.cli.dispatch"
    sections = SECTIONS


@click.group(name="dispatch", cls=DispatchGroup)
def command() -> None:
    """Bring a verified program to a real controller.

    Nothing here executes a program, enables power or moves an arm: the operator does, at the
    controller.
    """
