"""`vrts course`: a group whose subcommands are loaded when they are called."""

import click

from vrts.cli.grammar.group import LazyGroup

SUBCOMMANDS = {
    "new": "write the files of a course to begin with",
    "check": "show all faults of a course's files, and what will be served",
    "people": "list who is in a course, and who was here last",
    "letters": "write a personal link for everybody who comes in for the first time",
    "mark": "mark what was handed in for an assignment",
    "publish": "let students see final marks and what graders say",
    "export": "pack all that a course keeps of a person",
    "purge": "forget a person in a course",
}
SECTIONS = {"Commands": SUBCOMMANDS}


class CourseGroup(LazyGroup):
    """The subcommands in the order of use."""

    folder = "vrts.cli.course"
    sections = SECTIONS


@click.group(name="course", cls=CourseGroup)
def command() -> None:
    """Run a course: a term on the live server, with the list of a class.

    `vrts serve FOLDER` serves it. `vrts manual run-a-course` shows all steps.
    """
