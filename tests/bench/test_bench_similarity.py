"""What the ranking of a class costs: 300 and 1000 programs of 100 lines, each with each."""

from random import Random
from time import process_time

import pytest

from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.ranking import similarity

STEPS = (
    "MOVE {n}",
    "MOVES {n}",
    "APPRO {n}, {k}",
    "DEPARTS {k}",
    "CLOSEI",
    "OPENI",
    "SPEED {k}",
    "DELAY 0.{k}",
    "CALL {n}({n}, {k})",
    "SET {n} = SHIFT({n} BY 0,0,{k})",
    "x{k} = DX({n})+{k}",
    'TYPE "at", {k}',
    "IF SIG({k}) THEN\n  SIGNAL -{k}\n  END",
)
IDIOM = "  APPRO p, 120\n  MOVES p\n  CLOSEI\n  DEPARTS 200\n  APPRO q, 100\n  MOVES q\n  OPENI\n"


def program(seed: int) -> bytes:
    """Return a program of about 100 lines, of which everybody writes some alike."""
    draw = Random(seed)
    lines = [".PROGRAM main()"]
    while len(lines) < 85:
        step = draw.choice(STEPS)
        lines.append("  " + step.format(n=draw.choice("abcdefgh"), k=draw.randrange(1, 99)))
        if draw.random() < 0.03:
            lines += IDIOM.rstrip("\n").split("\n")
    rows = [
        f"p{k} {draw.uniform(0, 900):.2f} {draw.uniform(-500, 500):.2f} 100 90 90 0"
        for k in range(10)
    ]
    return "\n".join([*lines, ".END", ".LOCATIONS", *rows, ".END", ""]).encode()


@pytest.mark.parametrize("count", [300, 1000])
def test_a_class_each_with_each(count: int) -> None:
    programs = {f"s{seed:04d}": program(seed) for seed in range(count)}
    for k in range(0, count // 10, 2):
        programs[f"copy{k}"] = programs[f"s{k:04d}"].replace(b"120", b"130")
    begin = process_time()
    ranking = similarity(programs)
    ranked = process_time()
    page = similarity_page(ranking, programs, "A class")
    shown = process_time()
    print(
        f"\n{len(programs)} programs: ranking {ranked - begin:.2f} s, page {shown - ranked:.2f} s,"
        f" {len(page) / 1e6:.1f} MB, {len(ranking.pairs)} pairs"
    )
    copies = {pair.first for pair in ranking.pairs if pair.score > 0.8}
    assert len(copies) == len(programs) - count
