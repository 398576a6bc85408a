"""A class of 300 with variants: drawn, and a zip for each. Run by hand:

`python -m pytest tests/bench/test_bench_variants.py -s -p no:xdist`.
"""

import time

from tests.places import ROOT
from vrts.assignments.variants.of_task import load_varied
from vrts.marking.intake.row import Platform, Student
from vrts.marking.intake.tables.roster import Member, Roster
from vrts.marking.variants.class_list import class_list
from vrts.marking.variants.hand_out import hand_out
from vrts.marking.variants.handed import variants_of

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
COUNT = 300
MOST_S = 60.0  # of the processor, for all zips
MOST_DRAW_MS = 1.0


def test_zips_of_a_class_take_seconds() -> None:
    varied = load_varied(LAB)
    members = {str(k): Member(Student(f"N {k}", f"n{k}@b.c"), None) for k in range(COUNT)}
    listed = class_list(Roster(Platform.MOODLE, members, ()), "grades.csv")
    begin = time.process_time()
    given = variants_of(varied, listed, b"k" * 32, {})
    draw_ms = 1000 * (time.process_time() - begin) / COUNT
    begin = time.process_time()
    handed = hand_out(varied, listed, given.variants)
    spent = time.process_time() - begin
    size = sum(map(len, handed.files.values())) / 1e6
    print(f"\n{varied.variants.total:,} variants; a draw takes {draw_ms:.3f} ms")
    print(f"{COUNT} zips: {spent:.1f} s of the processor, {size:.1f} MB")
    assert len(handed.files) == COUNT
    assert draw_ms < MOST_DRAW_MS
    assert spent < MOST_S
