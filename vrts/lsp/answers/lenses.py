"""What can be done with a program, shown above it: run, debug, verify."""

from typing import NamedTuple

from vrts.lsp.documents.documents import Document

RUN, DEBUG, VERIFY = "vrts.run", "vrts.debug", "vrts.verify"  # commands of the editor
COMMANDS = (RUN, VERIFY, DEBUG)


class Lens(NamedTuple):
    """A command above the header of a program."""

    start: int
    end: int
    title: str
    command: str
    entry: str  # name of the program to execute


def lenses(document: Document) -> list[Lens]:
    """Return the commands of the programs that can be executed: those without formals."""
    found: list[Lens] = []
    for program in document.names.programs:
        if not program.name or program.formals:
            continue
        commands = [("run", RUN), ("debug", DEBUG), ("verify", VERIFY)]
        place = (program.name_start, program.name_end)
        found += [Lens(*place, title, command, program.name) for title, command in commands]
    return found
