"""A class marked by `vrts grade`, and what it then calls alike."""

import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from time import monotonic
from typing import NamedTuple

from tests.support_commands import vrts_text
from tests.support_likeness.classes import Class
from tests.support_likeness.judging import Group, groups_in
from tests.support_likeness.marking import setting_of
from tests.support_likeness.scenes import JOBS, folder
from tests.support_likeness.students.years import YEARS
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.files import given
from vrts.marking.similarity.likeness import likeness
from vrts.marking.submission.sketch import sketch
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import NO_CHECKS, Request


class Alike(NamedTuple):
    """What was found in a class."""

    groups: list[Group]
    wall_s: float  # of a call when all marks are there already; 0: not measured
    processor_s: float  # of the same


def task_of(job: str, year: int, where: Path) -> Path:
    """Write the task with what a year's students were given, and return its folder."""
    shutil.copytree(folder(JOBS[job]), where, ignore=shutil.ignore_patterns("submissions", "pict*"))
    given = YEARS[year - 1].text
    (where / "start.v2").write_text(given, encoding="utf-8")
    with (where / "README.md").open("a", encoding="utf-8") as readme:
        readme.write(f"\n## What you may use\n\n```val2\n{given}```\n")
    return where


def graded(
    whole: Class,
    where: Path,
    corpus: Sequence[tuple[str, Class]] = (),
    *words: str,
    again: bool = False,
) -> Alike:
    """Mark a class and return what is alike in it.

    Args:
        whole: The class.
        where: Folder for everything.
        corpus: Other classes, by the name of their folder.
        words: More words for `vrts grade`.
        again: Whether to call it once more in a process of its own, to measure likeness alone.
    """
    task = task_of(whole.job, whole.year, where / "task")
    programs = whole.written(where / "class")
    call: list[object] = ["grade", task, programs, "-o", where / "out", "--no-pages", *words]
    for name, other in corpus:
        call += ["--corpus", other.written(where / name)]
    found = vrts_text(*call, "-q")
    assert found.returncode == 0, found.stderr[-2000:]
    wall_s, processor_s = measured(call) if again else (0.0, 0.0)
    return Alike(groups_in(where / "out" / "staff" / "similarity.json"), wall_s, processor_s)


def compared(whole: Class, corpus: Sequence[tuple[str, Class]] = ()) -> list[Group]:
    """Return what is alike in a class, as `vrts grade` finds it, in this process and unmarked.

    The corpus is as a plain folder is: nobody ran its programs.
    """
    task = folder(JOBS[whole.job])
    setting = setting_of(str(task))
    programs: dict[str, Program] = {}
    for name, text in whole.texts.items():
        file = ProgramFile(text.encode(), f"{name}.v2")
        found = assess(Request(file, setting, checks=NO_CHECKS))
        if found.run is None or found.scene is None:
            programs[name] = Program(file.data)
        else:
            programs[name] = Program(file.data, sketch(found.run, found.scene))
    beside = (*given(task, setting), YEARS[whole.year - 1].text.encode())
    corpora = {
        name: {one: Program(text.encode()) for one, text in other.texts.items()}
        for name, other in corpus
    }
    groups = likeness(programs, beside, corpora=corpora, jobs=1).groups
    return [Group(frozenset(one.members), one.score, one.strength) for one in groups]


def measured(call: list[object]) -> tuple[float, float]:
    """Return the time that a call takes, and that of all processors."""
    began, before = monotonic(), getrusage(RUSAGE_CHILDREN)
    vrts = str(Path(sys.executable).with_name("vrts"))
    subprocess.run([vrts, *map(str, call)], check=True, capture_output=True)
    after = getrusage(RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return monotonic() - began, spent
