"""What would mend the submissions of the examples, and whether it blames the lines that are wrong.

Run by hand: `python -m pytest tests/bench/test_bench_submissions.py -s -p no:xdist`.

The lines that are wrong were written down by a person who read each program. A submission that does
not compile is mended by `vrts fix`, and not looked at here.
"""

import time
from collections.abc import Mapping

from tests.golden.examples import EXAMPLES
from vrts.check.rules.hints import Hints
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.repair.ranking import standing_out
from vrts.repair.telling import sentence

WRONG: Mapping[str, frozenset[int]] = {  # beside a step that is missing both lines
    "01/endless-loop": frozenset({5, *range(6, 13)}),
    "01/forgets-openi": frozenset({3, 4, 5}),
    "01/hits-base": frozenset({10}),
    "01/inches": frozenset(range(25, 30)),
    "01/missing-break": frozenset({3, 7, 11, 15, 19}),
    "01/moves-out-of-ready": frozenset({5}),
    "01/negative-approach": frozenset({5}),
    "01/releases-in-air": frozenset({13, 14, 21, 22}),
    "01/slow": frozenset({3}),
    "01/undefined-location": frozenset({14, 16, 32}),
    "01/unreachable-target": frozenset({23}),
    "01/wrong-orientation": frozenset({31}),
    "01/x-and-y-swapped": frozenset({26, 27, 28, 29}),
    "02/grips-the-middle": frozenset({2, 21}),
    "02/hand-stays-down": frozenset({2, 23}),
    "02/leaves-sideways": frozenset({6, 16}),
    "02/lets-go-too-early": frozenset({13, 23}),
    "02/slow": frozenset({3}),
    "03/backwards": frozenset(range(9, 17)),
    "03/corners-rounded": frozenset({11, 14}),
    "03/cuts-corner": frozenset({12, 13}),
    "03/forgot-a-point": frozenset({16, 21, 22}),  # its row is missing
    "03/hits-post": frozenset({12}),
    "03/over-the-walls": frozenset({8, 9}),
    "04/cold-oven": frozenset(range(2, 11)),
    "04/counts-from-zero": frozenset({6}),
    "04/down-into-the-oven": frozenset({50}),
    "04/four-copies": frozenset(range(2, 80)),
    "04/hand-stays-down": frozenset({63}),
    "04/loop-variable-lost": frozenset({8, 26}),
    "04/one-height": frozenset({20, 21}),
    "04/salami-slides": frozenset({48, 49}),
    "04/slow-all-the-way": frozenset({4}),
    "04/straight-across": frozenset({24, 29}),
}


def test_the_submissions_of_the_examples() -> None:
    told = right = full = 0
    print()
    for name, wrong in WRONG.items():
        number, submission = name.split("/")
        folder = next(each for each in EXAMPLES if each.name.startswith(number))
        path = folder / "submissions" / f"{submission}.v2"
        request = Request(
            ProgramFile(path.read_bytes(), path.name), load_task(folder / "task.toml")
        )
        began = time.process_time()
        found = mended(request, hints=Hints.EDIT)
        took = time.process_time() - began
        stands = standing_out(found.repairs) is not None
        lines = {part.line for each in found.repairs[:1] for part in each.change.each}
        blames = bool(lines) and lines <= wrong
        full += bool(found.repairs)
        told += stands
        right += stands and blames
        said = sentence(found.repairs, Hints.EDIT) or "nothing earns the full mark"
        sign = " " if not lines else "=" if blames else "!"
        print(f"{sign} {name:24}{took:6.2f} s {found.executions:4}  {said}")
    print(f"{len(WRONG)} programs: {full} mended, {told} told, {right} of these blame the lines")
    assert right == told
