"""The mutator: a program with one mistake, made from a kind of mistake and a seed.

The same program, kind and seed always give the same mistake. A mistake may cost no point or not
compile: `choosing` drops those.
"""

from random import Random

from tests.mutants.hunks import Hunk, hunks
from tests.mutants.kinds.lines import LINES
from tests.mutants.kinds.names import NAMES
from tests.mutants.kinds.rows import ROWS
from tests.mutants.kinds.sites import Kind
from tests.mutants.kinds.words import WORDS
from tests.mutants.reading import read

KINDS: dict[str, Kind] = {**NAMES, **LINES, **WORDS, **ROWS}


def mutated(text: str, kind: str, seed: int) -> tuple[Hunk, ...]:
    """Return a mistake as an edit of a program; empty where the program has no place for it.

    Args:
        text: The program, right.
        kind: A key of `KINDS`.
        seed: Chooses place and mistake.
    """
    wrong = KINDS[kind](read(text), Random(f"{kind} {seed}"))
    return () if wrong is None else hunks(text.splitlines(), wrong.splitlines())
