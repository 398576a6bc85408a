"""Right programs that mutants are made from, and what programs earn in their tasks."""

from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.golden.examples import EXAMPLES
from tests.places import TESTS
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task

FOLDER = TESTS / "data" / "mutants"


class Original(NamedTuple):
    """A program with the full mark."""

    name: str  # "04" for the solution of the example, "04-lists" for another right program
    program: Path
    example: Path  # the folder of its task

    @property
    def text(self) -> str:
        """The program."""
        return self.program.read_text(encoding="utf-8")


class Worth(NamedTuple):
    """What a program that compiles earns."""

    mark: Fraction
    full: bool  # nothing is lost


def originals() -> dict[str, Original]:
    """Return the solutions of the examples, then the right programs beside the mutants, by name."""
    of_number = {example.name[:2]: example for example in EXAMPLES}
    solutions = [Original(n, e / "solution.v2", e) for n, e in of_number.items()]
    others = [
        Original(path.stem, path, of_number[path.stem[:2]])
        for path in sorted((FOLDER / "solutions").glob("*.v2"))
    ]
    return {original.name: original for original in (*solutions, *others)}


def worth(text: str, example: Path) -> Worth | None:
    """Return what a program earns in the task of an example; None where it does not compile."""
    a = assess(Request(ProgramFile(text.encode(), "program.v2"), _setting(example)))
    if a.module is None or a.grade is None:
        return None
    return Worth(a.grade.mark, a.grade.mark == a.grade.total)


@cache
def _setting(example: Path) -> Setting:
    return load_task(example / "task.toml")
