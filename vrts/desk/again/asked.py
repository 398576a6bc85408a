"""What is needed to mark again: known from what the marking wrote about itself."""

from argparse import ArgumentParser
from datetime import datetime, tzinfo
from pathlib import Path
from typing import NamedTuple
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from vrts.base.diagnostic import Rule, error
from vrts.marking.about import About
from vrts.marking.layout import Layout
from vrts.marking.privacy.pseudonyms import KEY
from vrts.marking.submission.submissions import of_example
from vrts.marking.whole_class import HowTo
from vrts.pipeline.refused import Refused

MOVED = Rule("V854", "marking-moved")


class Again(NamedTuple):
    """How a class was marked, and is marked again."""

    submissions: Path | list[Path]
    how: HowTo
    corpora: tuple[Path, ...] = ()  # what the programs are compared with beside each other


def again(about: About, layout: Layout, jobs: int) -> Again:
    """Return how to mark a class again, as it was marked.

    Args:
        about: Of the marking.
        layout: Of its output.
        jobs: Programs at a time.

    Raises:
        Refused: The task, the submissions or a table are not where they were.
    """
    given = _given(about)
    zone = _zone(given.zone)
    how = HowTo(
        jobs,
        again=True,
        table=given.table,
        roster=given.roster,
        zone=zone,
        variants_key=given.variants_key,
        pseudonyms=(layout.staff / KEY).is_file(),
    )
    task = Path(about.place.task)
    paths = [Path(text) for text in about.submissions]
    asked = (task, *paths, *(path for path in (given.table, given.roster) if path is not None))
    asked = (*asked, *given.corpora)
    lacking = next((path for path in asked if not path.exists()), None)
    if lacking is not None:
        raise _moved(lacking, task=lacking == task)
    if not paths:
        return Again(of_example(task.parent), how, given.corpora)
    alone = len(paths) == 1 and (paths[0].is_dir() or paths[0].suffix.lower() == ".zip")
    return Again(paths[0] if alone else paths, how, given.corpora)


class _Given(NamedTuple):
    table: Path | None
    roster: Path | None
    variants_key: Path | None
    zone: str
    corpora: tuple[Path, ...]


def _given(about: About) -> _Given:
    """Return what the command of then said, beyond what else is written about the marking."""
    parser = ArgumentParser(add_help=False, allow_abbrev=False, exit_on_error=False)
    parser.add_argument("--intake", type=Path)
    parser.add_argument("--roster", type=Path)
    parser.add_argument("--key", type=Path)
    parser.add_argument("--zone", default="")
    parser.add_argument("--corpus", type=Path, action="append", default=[])
    found, _ = parser.parse_known_args(list(about.command))
    return _Given(found.intake, found.roster, found.key, found.zone, tuple(found.corpus))


def _zone(name: str) -> tzinfo | None:
    if not name:
        return None
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError):
        return datetime.strptime(name, "%z").tzinfo  # an offset, such as +01:00


def _moved(place: Path, *, task: bool) -> Refused:
    what = "the task" if task else "what was handed in"
    headline = f"{what} is not where it was when the class was marked: `{place}`"
    remedies = (
        "start the desk in the folder in which `vrts grade` was called",
        "or mark the class with `vrts grade`, from where things are now, into the same folder",
    )
    return Refused((error(MOVED, headline, help=remedies),))
