"""Puts results from other machines where marking at home puts them, under the names of home."""

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.layout import LOST, RESULT, Layout, write_atomically
from vrts.marking.marking import take_files, write_marks
from vrts.marking.remote.marked import MarkedRow, MarkedShard
from vrts.marking.remote.names import Naming, page_at_home, result_at_home
from vrts.marking.remote.plan import Expected, Home, Key, Sent
from vrts.marking.result import Damaged, Kind, Result, from_bytes
from vrts.marking.submission.marker import STAFF, Marks
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

FOREIGN = Rule("V724", "foreign-results")
UNFIT = Rule("V725", "results-that-do-not-fit")
INCOMPLETE = Rule("V726", "results-missing")

NO_MARK = (Kind.RESOURCE, Kind.FAULT)  # never take the place of anything better
MOST_NAMED = 20  # of what is missing


class HomeRow(NamedTuple):
    """A submission that was marked elsewhere, as home knows it."""

    naming: Naming
    marks: Marks
    seconds: float
    peak: int  # bytes of memory in use


class Merged(NamedTuple):
    """What came of merging."""

    rows: tuple[HomeRow, ...]
    findings: tuple[Diagnostic, ...]  # why some results were not taken
    missing: tuple[str, ...]  # identifiers of what has no result yet


def merge(key: Key, sources: Sequence[Path], layout: Layout) -> Merged:
    """Write all results that belong to a plan; what is there already may come again.

    Args:
        key: Of the plan.
        sources: The zips that `run_shard` made.
        layout: Where the results go.

    Raises:
        CannotRead: A file cannot be read.
    """
    for other in key.others:
        _write(other.marks, other.files, layout)
    rows: dict[str, HomeRow] = {}
    findings: list[Diagnostic] = []
    for path in sources:
        try:
            with path.open("rb") as file:
                for row in take(MarkedShard(file, path.name), key, layout):
                    rows[row.naming.identifier] = row
        except Refused as refused:
            findings += refused.diagnostics
        except OSError as problem:
            reason = (problem.strerror or "unreadable").lower()
            raise CannotRead(f"cannot read `{path}`: {reason}") from problem
    missing = [
        (sent, entry)
        for sent in key.shards
        for entry in sent.entries
        if _there(layout, entry) is None
    ]
    if missing:
        findings.append(_incomplete(key, missing))
    absent = tuple(entry.naming.identifier for _, entry in missing)
    return Merged(tuple(rows.values()), tuple(findings), absent)


def take(marked: MarkedShard, key: Key, layout: Layout | None) -> list[HomeRow]:
    """Write the results of one shard, if they are what the plan expects, and return them.

    Raises:
        Refused: They are damaged, or belong to something else.
    """
    expected = _expected(marked, key)
    pairs = [(row, expected[row.pseudonym]) for row in marked.rows()]
    for row, entry in pairs:
        _check(marked, row, entry, key)
    taken: list[HomeRow] = []
    for row, entry in pairs:
        naming = entry.naming
        marks = Marks(_home(row.staff, naming, key.staff), _home(row.student, naming, key.student))
        if layout is not None:
            _write_marked(marks, marked.files(row.pseudonym), entry, layout)
        taken.append(HomeRow(naming, marks, row.seconds, row.peak))
    return taken


def _expected(marked: MarkedShard, key: Key) -> dict[str, Expected]:
    """Return what a plan expects of a shard, by pseudonym."""
    contents = marked.contents
    sent = next((sent for sent in key.shards if sent.number == contents.number), None)
    if contents.plan != key.plan or sent is None:
        raise _foreign(f"`{marked.name}` holds results of another plan")
    if contents.shard != sent.sha256:
        raise _foreign(f"`{marked.name}` holds results of a shard that was changed")
    expected = {entry.naming.pseudonym: entry for entry in sent.entries}
    if expected.keys() != {row.pseudonym for row in contents.rows}:
        raise _unfit(f"`{marked.name}` does not hold the submissions of its shard")
    return expected


def _check(marked: MarkedShard, row: MarkedRow, entry: Expected, key: Key) -> None:
    """Refuse results that are not about the program, task and vrts that were sent."""
    for result, home, expected in (
        (row.staff, key.staff, entry.staff),
        (row.student, key.student, entry.student),
    ):
        about = result.id == entry.naming.pseudonym and result.key == expected
        same = (result.task.sha256, result.scene.sha256) == (home.task.sha256, home.scene.sha256)
        program = result.program
        its = program is None or (program.sha256, program.name) == (
            entry.program,
            entry.naming.label,
        )
        if not (about and same and its):
            raise _unfit(f"`{marked.name}` holds a result that does not fit its submission")


def _home(result: Result, naming: Naming, home: Home) -> Result:
    named = result_at_home(result, naming)
    return msgspec.structs.replace(named, task=home.task, scene=home.scene)


def _write_marked(marks: Marks, files: dict[str, bytes], entry: Expected, layout: Layout) -> None:
    """Write what came back about one submission, with its title in place of its pseudonym."""
    before = _there(layout, entry)
    if marks.staff.kind in NO_MARK and before is not None and before.kind not in NO_MARK:
        return
    at_home = {
        name: page_at_home(data, entry.naming) if name.endswith(".html") else data
        for name, data in files.items()
    }
    _write(marks, at_home, layout)


def _write(marks: Marks, files: dict[str, bytes], layout: Layout) -> None:
    """Write what is about one submission, the results last."""
    identifier = marks.staff.id
    lost = files.pop(f"{STAFF}/{LOST}", None)
    layout.staging.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(dir=layout.staging) as staging:
        for name, data in files.items():
            write_atomically(Path(staging) / name, data)
        take_files(Path(staging), layout, identifier)
    place = layout.grader(identifier) / LOST
    if lost is None:
        place.unlink(missing_ok=True)
    else:
        write_atomically(place, lost)
    write_marks(marks, layout)


def _there(layout: Layout, entry: Expected) -> Result | None:
    """Return the result that is there already, if it is the one that a plan expects."""
    try:
        data = (layout.grader(entry.naming.identifier) / RESULT).read_bytes()
        result = from_bytes(data)
    except (OSError, Damaged):
        return None
    return result if result.key == entry.staff else None


def _incomplete(key: Key, missing: list[tuple[Sent, Expected]]) -> Diagnostic:
    names = [f"`{entry.naming.identifier}`" for _, entry in missing]
    numbers = sorted({sent.number for sent, _ in missing})
    more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    total = sum(len(sent.entries) for sent in key.shards)
    which = ", ".join(str(number) for number in numbers)
    return warning(
        INCOMPLETE,
        f"{len(names)} of {total} submissions have no result yet",
        notes=(
            f"missing: {', '.join(names[:MOST_NAMED])}{more}",
            f"they are in shard{'' if len(numbers) == 1 else 's'} {which}",
        ),
        help=("run these shards, and merge again: what is there already stays",),
        data={"shards": tuple(numbers), "missing": len(names)},
    )


def _foreign(headline: str) -> Refused:
    remedy = "merge the results of every plan with its own key"
    return Refused((error(FOREIGN, headline, help=(remedy,)),))


def _unfit(headline: str) -> Refused:
    remedy = "run the shard again, with the vrts that made the plan"
    return Refused((error(UNFIT, headline, help=(remedy,)),))
