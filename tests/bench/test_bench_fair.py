"""Variants checked for a class of 300 on two cores, and what copied values earn in two tasks.

Every student has the reference solution with the places of the own variant. In each pair of
students one hands in what the other one has. The bound for the check of a class is 120 s.
"""

import resource
import shutil
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import pytest

from tests.bench.usual import scaled, slowness
from tests.places import ROOT
from vrts.assignments.fair.copied import HALF, copied
from vrts.assignments.fair.fairness import fairness
from vrts.assignments.fair.in_words import fair_lines
from vrts.assignments.fair.trial import tried
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.base.workers import Workers
from vrts.check.variants.drawn import drawn
from vrts.check.variants.model import Combination

STUDENTS = 300
CORES = 2
PAIRS = 1000
LONGEST = 120.0  # [s]
KEY = b"a teacher's key, 32 bytes long.."
DISH = """
[variants]
assignment = "dish"
staff_names = ["dish_grip", "stand_mid"]
[[variants.vary]]
name = "dish_x"
set = ["scene.objects.dish.at_mm.x", "scene.locations.dish_grip.x"]
from = 800
to = 880
step = 20
[[variants.vary]]
name = "dish_y"
set = ["scene.objects.dish.at_mm.y", "scene.locations.dish_grip.y"]
from = -380
to = -280
step = 20
plus = [0, 103]
[[variants.vary]]
name = "stand_x"
set = ["scene.objects.stand.at_mm.x", "scene.locations.stand_mid.x"]
from = 940
to = 1020
step = 20
plus = [0, -17.1]
[[variants.vary]]
name = "stand_y"
set = ["scene.objects.stand.at_mm.y", "scene.locations.stand_mid.y"]
from = 290
to = 370
step = 20
"""


def cans(_: Path) -> VariedTask:
    """Return the example with variants: two cans onto two bases."""
    return load_varied(ROOT / "examples" / "08-own-numbers" / "lab1")


def dish(home: Path) -> VariedTask:
    """Return variants of another example: a dish on a tilted stand."""
    folder = home / "dish"
    shutil.copytree(ROOT / "examples" / "02-dish-on-stand", folder)
    with (folder / "task.toml").open("a", encoding="utf-8") as file:
        file.write(DISH)
    return load_varied(folder)


def of_class(varied: VariedTask) -> dict[str, Combination]:
    names = (f"student{k:03d}@school.example" for k in range(STUDENTS))
    return {name: drawn(varied.variants, KEY, name).combination for name in names}


def spent() -> float:
    """Return the processor time of this process and of those that it has waited for [s]."""
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(found.ru_utime + found.ru_stime for found in map(resource.getrusage, who))


@pytest.mark.parametrize("task", [cans, dish])
def test_variants_of_a_class_are_checked(
    task: Callable[[Path], VariedTask], tmp_path: Path
) -> None:
    varied = task(tmp_path)
    class_ = of_class(varied)
    tried(varied, next(iter(class_.values())))  # as `vrts task check` does before: all is loaded
    before = slowness()
    begin, cpu = perf_counter(), spent()
    found = fairness(varied, class_, Workers(CORES))
    took, used = perf_counter() - begin, spent() - cpu
    slow = before, slowness()
    print("", *fair_lines(varied.variants, found), sep="\n")
    print(
        f"{STUDENTS} students, {len(found.trials)} variants: {took:.1f} s on {CORES} cores, "
        f"{used:.1f} s of processor time"
    )
    print(scaled(f"{STUDENTS} checked on {CORES} free cores", used / CORES, LONGEST, slow))
    assert found.fair


@pytest.mark.parametrize("task", [cans, dish])
def test_copied_values_do_not_pay(task: Callable[[Path], VariedTask], tmp_path: Path) -> None:
    varied = task(tmp_path)
    class_ = of_class(varied)
    programs = {
        one: program
        for one in dict.fromkeys(class_.values())
        if (program := varied.reference(one)) is not None
    }
    found = copied(varied, tuple(class_.values()), programs, Workers(CORES), most=PAIRS)
    share = 100 * (found.pairs - found.paid) / found.pairs
    print(
        f"\n{found.pairs} pairs of {STUDENTS} students ({len(programs)} different variants): "
        f"{found.paid} copies earn more than {float(HALF):.0%} of the mark, {share:.1f} % do not"
    )
    assert not found.pays
