"""A program on its way from one student to another."""

from dataclasses import dataclass
from random import Random

from tests.support_likeness.scenes import Job
from tests.support_likeness.students.authors import Author, Layout
from tests.support_likeness.students.printing import printed
from tests.support_likeness.students.program import Program, names_of


@dataclass
class Sheet:
    """A program with the looks of its text."""

    program: Program
    layout: Layout

    def copy(self) -> "Sheet":
        """Return a sheet of its own."""
        return Sheet(self.program.copy(), self.layout)

    def text(self) -> str:
        """Return it as a file."""
        return printed(self.program, self.layout)


@dataclass
class Copier:
    """One who copies: habits of their own, and how careful they are."""

    author: Author
    job: Job
    draw: Random
    strength: float = 1.0  # of changes that may break the program

    def fresh(self, program: Program, word: str) -> str:
        """Return a name that the program does not have."""
        used = {name.upper() for name in names_of(program)} | {"MAIN"}
        name, k = word, 1
        while name.upper() in used:
            k += 1
            name = f"{word}{k}"
        return name

    def said(self, about: str) -> str:
        """Return words about something, in the tongue of the one who copies."""
        text = self.draw.choice(self.author.tongue.says[about])
        return text.replace("{}", self.author.tongue.things["can"][0])
