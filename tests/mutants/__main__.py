"""Mutants of the examples' solutions: `python -m tests.mutants` prints how many there are.

python -m tests.mutants                     the table of those in `tests/data/mutants`
python -m tests.mutants make                makes them anew: the same, unless marks have changed
python -m tests.mutants make FOLDER SEED    makes others, of seeds from SEED on, in another folder
python -m tests.mutants show ID ...         the lines that a mutant changes
python -m tests.mutants score FILE [N]      mends those (N of them) that FILE has no row of yet;
                                            with `--of FOLDER` at the end, those of another folder
"""

import sys
from collections.abc import Iterable
from pathlib import Path

from tests.mutants.choosing import one_mistake, two_mistakes
from tests.mutants.given import mutants, written
from tests.mutants.hunks import Hunk
from tests.mutants.originals import FOLDER, Original, originals
from tests.mutants.scoring import score, scores
from tests.mutants.table import table

NUMBERS = {True: (84, 22), False: (30, 7)}  # with one mistake and two: of solutions, of others


def main(words: list[str]) -> int:
    """Do what the words say and return the exit status."""
    match words:
        case []:
            print(table(mutants()))
        case ["make"]:
            make(FOLDER, 0)
        case ["make", folder, seed] if seed.isdecimal():
            make(Path(folder), int(seed))
        case ["score", file, *rest]:
            return _score(Path(file), rest)
        case ["show", *names]:
            for mutant in mutants():
                if mutant.id in names:
                    show(mutant.edits)
        case _:
            print(__doc__)
            return 2
    return 0


def make(folder: Path, first_seed: int) -> None:
    """Write the mutants of every original to a folder, and print the table."""
    folder.mkdir(parents=True, exist_ok=True)
    for original in originals().values():
        one, two = NUMBERS[is_solution(original)]
        found = (
            *one_mistake(original, one, first_seed),
            *two_mistakes(original, two, first_seed),
        )
        (folder / f"{original.name}.jsonl").write_text(written(found), encoding="utf-8")
        print(f"{original.name}: {len(found)} mutants", flush=True)
    print(table(mutants(folder)))


def is_solution(original: Original) -> bool:
    """Return whether a right program is the solution of an example."""
    return original.program.parent == original.example


def _score(file: Path, rest: list[str]) -> int:
    """Mend mutants, and print the table of what became of them."""
    match rest:
        case [*count, "--of", folder] if len(count) < 2:
            given = mutants(Path(folder))
        case [] | [_]:
            count, given = rest, mutants()
        case _:
            count, given = ["?"], []
    if not all(word.isdecimal() for word in count):
        print(__doc__)
        return 2
    print(scores(score(given, file, *map(int, count))))
    return 0


def show(edits: Iterable[Hunk]) -> None:
    """Print what an edit takes away and what it writes instead."""
    for line, before, after in edits:
        print(f"line {line}")
        print("".join(f"- {text}\n" for text in before) + "".join(f"+ {text}\n" for text in after))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
