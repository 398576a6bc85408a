"""Classes of a generator that knows nothing of how copies are found, marked as a teacher would.

    SEEDS=0,1,2 nice -n 10 python -m pytest tests/bench/test_bench_likeness_judge.py -s -p no:xdist

For each seed and each of two tasks: a class with ten copies, a class without, and a class with ten
copies of programs of the class before it. `KEEP=folder` leaves programs and outputs there. A class
takes some two minutes. `of what can be known` counts the copies that share more with their source
than any two honest people share, by all that the generator knows: no detector can do much better.
"""

import os
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.support_judge.classes import COPIES, TASKS, Class, a_class
from tests.support_judge.judging import Judged, judged
from tests.support_judge.knowing import known

SEEDS = [int(seed) for seed in os.environ.get("SEEDS", "0").split(",")]
INNOCENT = 2  # innocent groups that may stand above the last copy
PLACES = {"cans": "easy", "project": ROOT / "examples" / "04-final-project"}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("task", TASKS)
def test_copies_in_the_first_groups(task: str, seed: int, tmp_path: Path) -> None:
    """Ten copies in the first twelve groups, at most two innocent groups above the last."""
    one = a_class(TASKS[task], seed, COPIES)
    said = _marked(f"{task}-{seed}", task, one, tmp_path)
    sure = sum(copy.innocent == 0 for copy in known(one))
    print(f"\n{said.said()}; of what can be known: {sure} of {COPIES} above all honest pairs")
    assert not said.missed
    assert len(said.above) <= INNOCENT


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("task", TASKS)
def test_honest_classes_and_earlier_years(task: str, seed: int, tmp_path: Path) -> None:
    """Prints the groups of a class without copies, then those of one that copies from it."""
    before = a_class(TASKS[task], seed)
    honest = _marked(f"{task}-{seed}-honest", task, before, tmp_path)
    print(f"\n{honest.said()}")
    later = a_class(TASKS[task], seed + 1000, COPIES, before)
    corpus = _folder(tmp_path) / f"{task}-{seed}-honest-out"
    said = _marked(f"{task}-{seed}-later", task, later, tmp_path, "--corpus", corpus)
    print(said.said())
    assert not said.missed
    assert len(said.above) <= INNOCENT


def _folder(tmp_path: Path) -> Path:
    return Path(os.environ.get("KEEP", tmp_path))


def _marked(name: str, task: str, one: Class, tmp_path: Path, *words: object) -> Judged:
    """Mark a class as a teacher would, without what costs time and says nothing of likeness."""
    folder = _folder(tmp_path)
    place = PLACES[task]
    if place == "easy":
        place = tmp_path / "easy"
        if not place.exists():
            vrts_text("new", "task", place, "--from", "cans-on-bases", cwd=tmp_path)
    one.write(folder / name)
    out = folder / f"{name}-out"
    cheap = ("--no-collisions", "--no-pages", "-q")
    found = vrts_text("grade", place, folder / name, "-o", out, *cheap, *words, cwd=tmp_path)
    assert (out / "staff" / "similarity.json").exists(), found.stderr
    return judged(name, out, one)
