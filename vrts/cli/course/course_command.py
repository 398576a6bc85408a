"""`vrts course`: a group whose subcommands are loaded when they are called."""

import click

from vrts.cli.grammar.group import LazyGroup

SUBCOMMANDS = {
    "mark": "mark what was handed in for an assignment",
    "publish": "let students see final marks and what graders say",
}
SECTIONS = {"Commands": SUBCOMMANDS}


class CourseGroup(LazyGroup):
    """The subcommands in the order of use."""

    folder = "vrts.cli.course"
    sections = SECTIONS


@click.group(name="course", cls=CourseGroup)
def command() -> None:
    """Run a course: a term on the live server, with the list of a class.

    `vrts serve FOLDER` serves it.
    """
