"""The mutants of `tests/data/mutants`: programs with one mistake or two, and how large each is.

How the files are written stands in the README beside them.
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.mutants.hunks import Hunk, applied
from tests.mutants.originals import FOLDER, Original, originals

Lines = list[str]


@dataclass(frozen=True, slots=True)
class Mutant:
    """A program with a mistake or two that costs points."""

    id: str  # no other has it
    original: Original  # the program without the mistake, and the folder of its task
    kinds: tuple[str, ...]  # of its mistakes: one or two keys of `KINDS`
    seeds: tuple[int, ...]  # of its mistakes, in the same order
    edits: tuple[Hunk, ...]  # lines of the original, and what stands there instead
    size: int  # nodes of the syntax that differ from the original: `measure.size`
    mark: float  # what the program earns in its task: less than the full mark

    @property
    def text(self) -> str:
        """The program with the mistake."""
        return applied(self.original.text, self.edits)

    @property
    def task(self) -> Path:
        """The file of the task in which it loses points."""
        return self.original.example / "task.toml"


def mutants(folder: Path = FOLDER) -> list[Mutant]:
    """Return every mutant of a folder, in the order of the originals."""
    return [
        _mutant(original, json.loads(line))
        for name, original in originals().items()
        if (path := folder / f"{name}.jsonl").exists()
        for line in path.read_text(encoding="utf-8").splitlines()
    ]


def written(found: Iterable[Mutant]) -> str:
    """Return the file of the mutants of one original: a row of JSON each."""
    return "".join(f"{json.dumps(_row(mutant), ensure_ascii=False)}\n" for mutant in found)


def _row(mutant: Mutant) -> dict[str, object]:
    return {
        "id": mutant.id,
        "kinds": mutant.kinds,
        "seeds": mutant.seeds,
        "size": mutant.size,
        "mark": mutant.mark,
        "edits": mutant.edits,
    }


def _mutant(original: Original, row: dict[str, Any]) -> Mutant:
    edits = tuple(Hunk(line, tuple(old), tuple(new)) for line, old, new in row["edits"])
    return Mutant(
        row["id"],
        original,
        tuple(row["kinds"]),
        tuple(row["seeds"]),
        edits,
        row["size"],
        row["mark"],
    )
