"""What likeness costs: 300 and 1000 programs of 100 lines, and 300 with a corpus of 1000."""

import resource
from random import Random
from time import monotonic, process_time

import pytest

from tests.bench.usual import scaled, slowness
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.likeness import likeness
from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.ranking import similarity
from vrts.marking.submission.sketch import Sketch, Stop

ASKED_S = 30.0  # of 300 with a corpus of 1000

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


def sketch(seed: int) -> Sketch:
    """Return what a run of about 60 motions did."""
    draw = Random(seed)
    things = ("can1", "can2", "base1", "base2")

    def stop(line: int) -> Stop:
        x, y, z = (draw.randrange(-9000, 9000, 50) for _ in range(3))
        thing = draw.choice(things)
        hand = draw.choice(("", "", "open", "close"))
        straight, speed, held = draw.random() < 0.5, draw.randrange(5, 100, 5), ""
        at, beside = (x, y, z), (x - 500, y, z + 700)
        return Stop(line, straight, speed, at, (0, 0, -100), thing, beside, held, hand, False)

    return Sketch("vrts.motion/1", tuple(stop(line) for line in range(1, 61)))


def test_a_class_of_300_with_a_corpus_of_1000() -> None:
    programs = {f"s{k:03d}": Program(program(k), sketch(k)) for k in range(290)}
    for k in range(10):
        copied = program(k).replace(b"120", b"130").replace(b"MOVE a", b"MOVE zz")
        programs[f"copy{k}"] = Program(copied, sketch(k))
    corpus = {f"old{k:04d}": Program(program(5000 + k), sketch(5000 + k)) for k in range(1000)}
    slow = slowness()
    begin, before = monotonic(), _busy()
    found = likeness(programs, corpora={"2025": corpus}, jobs=2)
    took = monotonic() - begin
    here, workers = (now - then for now, then in zip(_busy(), before, strict=True))
    strong = [group for group in found.groups if group.strength == "strong"]
    print(
        f"\n300 programs with a corpus of 1000: {took:.1f} s on two cores; of the processor"
        f" {here:.1f} s here and {workers:.1f} s in two workers;"
        f" {len(found.groups)} groups, {len(strong)} strong"
    )
    ways = (slow, slowness())
    print(scaled("on two cores that do nothing else", here + workers / 2, ASKED_S, ways))
    assert {group.members for group in strong} == {(f"copy{k}", f"s{k:03d}") for k in range(10)}


def _busy() -> tuple[float, float]:
    """Return the time of the processor that this process and its workers have used [s]."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    here, workers = (one.ru_utime + one.ru_stime for one in used)
    return here, workers
