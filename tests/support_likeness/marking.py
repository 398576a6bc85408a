"""Marks programs in this process, as `vrts grade` marks them."""

from collections import Counter
from functools import cache, lru_cache
from typing import NamedTuple

from tests.support_likeness.scenes import Job, folder
from vrts.marking.submission.setting import Place, load
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.setting import Setting


class Mark(NamedTuple):
    """What became of a program."""

    points: float  # of ten
    status: str
    found: tuple[str, ...]  # the costliest losses and errors, in words


@cache
def setting_of(task: str) -> Setting:
    """Return the setting of a task's folder."""
    return load(Place(task), staff=True)


@lru_cache(maxsize=4096)
def mark(text: str, job: Job) -> Mark:
    """Return the mark of a program."""
    found = assess(
        Request(ProgramFile(text.encode(), "p.v2"), setting_of(str(folder(job))), checks=Checks())
    )
    grade = found.grade
    assert grade is not None
    words = [loss.sentence for loss in grade.losses][:3]
    words += [d.headline for d in found.diagnostics if d.severity.name == "ERROR"][:2]
    return Mark(float(grade.mark), grade.status.value, tuple(words))


def spread(marks: list[Mark]) -> str:
    """Return how marks are spread, in one line."""
    counts = Counter(int(one.points) for one in marks)
    statuses = Counter(one.status for one in marks)
    bars = " ".join(f"{points}:{counts[points]}" for points in range(11))
    return f"{bars}  ({', '.join(f'{n} {status}' for status, n in statuses.most_common())})"
