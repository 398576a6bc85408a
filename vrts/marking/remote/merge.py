"""Puts results from other machines where marking at home puts them, under the names of home.

Nothing is taken on trust that home can find out by itself; see `signed` and `recounted`. What
cannot be taken of one submission leaves the others as they are.
"""

from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.layout import LOST, RESULT, Layout, write_atomically
from vrts.marking.marking import take_files, write_marks
from vrts.marking.remote.marked import MarkedRow, MarkedShard, NotTaken, no_results
from vrts.marking.remote.names import Naming, page_at_home, result_at_home
from vrts.marking.remote.plan import Expected, Home, Key, Sent
from vrts.marking.remote.recounted import contradiction
from vrts.marking.remote.signed import secret_of_shard
from vrts.marking.result import Damaged, Kind, Result, from_bytes
from vrts.marking.submission.marker import STAFF, Marks
from vrts.marking.supervise.staging import remove_unused, staging_folder
from vrts.pipeline.refused import Refused

FOREIGN = Rule("V724", "foreign-results")
UNFIT = Rule("V725", "results-that-do-not-fit")
INCOMPLETE = Rule("V726", "results-missing")
CHANGED = Rule("V730", "changed-results")
UNSIGNED = Rule("V731", "unsigned-results")

NO_MARK = (Kind.RESOURCE, Kind.FAULT)  # never take the place of anything better
MOST_NAMED = 20  # of what is missing

Said = tuple[tuple[object, ...], ...]


class HomeRow(NamedTuple):
    """A submission that was marked elsewhere, as home knows it."""

    naming: Naming
    marks: Marks
    seconds: float
    peak: int  # bytes of memory in use


class Taken(NamedTuple):
    """What was taken of one shard."""

    rows: list[HomeRow]
    findings: list[Diagnostic]  # why the rest was not


class Merged(NamedTuple):
    """What came of merging."""

    rows: tuple[HomeRow, ...]
    findings: tuple[Diagnostic, ...]  # why some results were not taken
    missing: tuple[str, ...]  # identifiers of what has no result yet


def merge(key: Key, sources: Sequence[Path], layout: Layout, *, unsigned: bool = False) -> Merged:
    """Write all results that belong to a plan; what is there already may come again.

    Args:
        key: Of the plan.
        sources: The zips that `run_shard` made.
        layout: Where the results go.
        unsigned: Whether to take results of a plan of before, which are not signed.

    Raises:
        Refused: The plan is one of before, and its results are not to be taken.
    """
    require_secret(key, unsigned=unsigned)
    remove_unused(layout.staging)
    for other in key.others:
        _write(other.marks, other.files, layout)
    rows: dict[str, HomeRow] = {}
    files = [path for path in sources if not _is_device(path)]
    odds = dict(_at_odds(files, key))
    findings = list(odds.values())
    findings += [no_results(path.name, "it is no file") for path in sources if path not in files]
    for path in files:
        try:
            file = path.open("rb")
        except OSError as problem:
            findings.append(no_results(path.name, (problem.strerror or "unreadable").lower()))
            continue
        with file:
            try:
                taken = take(MarkedShard(file, path.name), key, layout, odds, kept=True)
            except Refused as refused:
                findings += refused.diagnostics
                continue
        rows |= {row.naming.identifier: row for row in taken.rows}
        findings += taken.findings
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


def take(
    marked: MarkedShard,
    key: Key,
    layout: Layout | None,
    without: Collection[str] = (),
    *,
    kept: bool = False,
) -> Taken:
    """Write the results of one shard, as far as they are what the plan expects, and return them.

    Args:
        marked: The results.
        key: Of the plan.
        layout: Where they go; None: nowhere.
        without: Identifiers of those that are left out, without a word.
        kept: Whether what is there already stays where these tell something else.

    Raises:
        Refused: The whole is damaged, was changed, or belongs to something else.
    """
    sent = _sent(marked, key)
    expected = {entry.naming.pseudonym: entry for entry in sent.entries}
    rows: list[HomeRow] = []
    findings: list[Diagnostic] = []
    for used in marked.contents.rows:
        entry = expected.pop(used.pseudonym, None)
        if entry is None:
            why = f"`{used.pseudonym}` is not of this shard"
            findings.append(_unfit(marked, sent, why))
            continue
        naming = entry.naming
        if naming.identifier in without:
            continue
        try:
            row = marked.row(used)
            _check(row, entry, key)
            if kept and layout is not None:
                _require_same(row, entry, layout)
        except NotTaken as problem:
            why = f"the result of `{naming.identifier}` is not taken: {problem}"
            findings.append(_unfit(marked, sent, why))
            continue
        homes = entry.homes or (key.staff, key.student)
        marks = Marks(_home(row.staff, naming, homes[0]), _home(row.student, naming, homes[1]))
        if layout is not None:
            _write_marked(marks, row.files, entry, layout)
        rows.append(HomeRow(naming, marks, row.seconds, row.peak))
    for entry in expected.values():
        why = f"there is no result of `{entry.naming.identifier}` in it"
        findings.append(_unfit(marked, sent, why))
    return Taken(rows, findings)


def _sent(marked: MarkedShard, key: Key) -> Sent:
    """Return the shard of a plan that results are of, if nobody has changed them."""
    contents = marked.contents
    sent = next((sent for sent in key.shards if sent.number == contents.number), None)
    if contents.plan != key.plan or sent is None:
        raise _foreign(f"`{marked.name}` holds results of another plan")
    if contents.shard != sent.sha256:
        raise _foreign(f"`{marked.name}` holds results of a shard that was changed")
    if key.secret is not None:
        secret = secret_of_shard(key.secret, key.plan, sent.number)
        if not marked.is_signed(secret):
            raise _changed(marked, sent)
    return sent


def _check(row: MarkedRow, entry: Expected, key: Key) -> None:
    """Check that results are about the program, task and vrts that were sent, and add up.

    Raises:
        NotTaken: They are not, or do not.
    """
    staff, student = entry.homes or (key.staff, key.student)
    for result, home, expected in (
        (row.staff, staff, entry.staff),
        (row.student, student, entry.student),
    ):
        if result.id != entry.naming.pseudonym:
            raise NotTaken("it is of another submission")
        if (result.task.sha256, result.scene.sha256) != (home.task.sha256, home.scene.sha256):
            raise NotTaken("it is of another task or scene")
        if home.total is not None and result.total != home.total:
            raise NotTaken(f"it is out of {result.total:g} points, and the task of {home.total:g}")
        program = result.program
        if program is None and result.kind is not Kind.RESOURCE:
            raise NotTaken("it does not tell of which program it is")
        planned = (entry.program, entry.naming.label)
        if program is not None and (program.sha256, program.name) != planned:
            raise NotTaken("it is of another program")
        if result.key != expected:
            raise NotTaken("it was made with another vrts, or with other options")
        why = contradiction(result)
        if why is not None:
            raise NotTaken(why)


def _require_same(row: MarkedRow, entry: Expected, layout: Layout) -> None:
    """Require that results tell the same as those that are there already.

    Raises:
        NotTaken: They do not.
    """
    before = _there(layout, entry)
    kinds = () if before is None else (before.staff.kind, row.staff.kind)
    if before is None or any(kind in NO_MARK for kind in kinds):
        return
    if _said(before.staff, before.student) != _said(row.staff, row.student):
        place = layout.grader(entry.naming.identifier)
        raise NotTaken(f"`{place}` tells something else; delete the one that is wrong")


def _home(result: Result, naming: Naming, home: Home) -> Result:
    named = result_at_home(result, naming)
    return msgspec.structs.replace(named, task=home.task, scene=home.scene)


def _write_marked(marks: Marks, files: dict[str, bytes], entry: Expected, layout: Layout) -> None:
    """Write what came back about one submission, with its title in place of its pseudonym."""
    before = _there(layout, entry)
    if marks.staff.kind in NO_MARK and before is not None and before.staff.kind not in NO_MARK:
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
    with staging_folder(layout.staging) as staging:
        for name, data in files.items():
            write_atomically(staging / name, data)
        take_files(staging, layout, identifier)
    place = layout.grader(identifier) / LOST
    if lost is None:
        place.unlink(missing_ok=True)
    else:
        write_atomically(place, lost)
    write_marks(marks, layout)


def _there(layout: Layout, entry: Expected) -> Marks | None:
    """Return the results that are there already, if they are those that a plan expects."""
    name = entry.naming.identifier
    try:
        staff, student = (
            from_bytes((home / RESULT).read_bytes())
            for home in (layout.grader(name), layout.student(name))
        )
    except (OSError, Damaged):
        return None
    same = (staff.key, student.key) == (entry.staff, entry.student)
    return Marks(staff, student) if same else None


def _is_device(path: Path) -> bool:
    """Return whether something else than a file or a folder has a name: reading it may not end."""
    return path.exists() and not (path.is_file() or path.is_dir())


def _at_odds(sources: Sequence[Path], key: Key) -> Iterator[tuple[str, Diagnostic]]:
    """Yield submissions, and what to say of them, of which two files tell different things.

    More than its table of contents is read only of a file that is not the only one of its shard.
    """
    files: dict[int, list[Path]] = {}
    for path in dict.fromkeys(sources):
        with suppress(Refused, OSError), path.open("rb") as file:  # told when it is to be taken
            files.setdefault(MarkedShard(file, path.name).contents.number, []).append(path)
    for number, paths in sorted(files.items()):
        said: dict[str, dict[Said, Path]] = {}  # by identifier: the first file that says it
        for path in paths if len(paths) > 1 else ():
            with suppress(Refused, OSError), path.open("rb") as file:  # likewise
                for row in take(MarkedShard(file, path.name), key, None).rows:
                    if row.marks.staff.kind not in NO_MARK:
                        what = _said(row.marks.staff, row.marks.student)
                        said.setdefault(row.naming.identifier, {}).setdefault(what, path)
        for identifier, ways in said.items():
            if len(ways) > 1:
                yield identifier, _differ(identifier, number, list(ways.values()))


def _said(*results: Result) -> Said:
    """Return what results must have in common with others of the same keys."""
    return tuple(
        (
            (result.kind, result.mark, result.lowest, result.parts),
            *((check.id, check.answer, check.points, check.most) for check in result.checks),
        )
        for result in results
    )


def _differ(identifier: str, number: int, paths: Sequence[Path]) -> Diagnostic:
    names = " and ".join(f"`{path}`" for path in paths)
    headline = f"shard {number}: the result of `{identifier}` is not taken: {names} differ in it"
    remedy = f"run shard {number} again on a machine that you trust, and merge its file alone"
    return error(UNFIT, headline, help=(remedy,), data={"shard": number})


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


def _changed(marked: MarkedShard, sent: Sent) -> Refused:
    count = len(sent.entries)
    whose = "the result of 1 submission" if count == 1 else f"the results of {count} submissions"
    headline = f"`{marked.name}`, shard {sent.number}: it was changed after it was signed"
    note = f"{whose} in it {'is' if count == 1 else 'are'} not taken"
    return Refused((error(CHANGED, headline, notes=(note,), help=(_again(marked, sent),)),))


def require_secret(key: Key, *, unsigned: bool) -> None:
    """Require that a plan signs its results, or that they are to be taken as they are.

    Raises:
        Refused: It is a plan of before.
    """
    if key.secret is not None or unsigned:
        return
    headline = "the plan is of an earlier vrts: nothing shows whether its results were changed"
    remedies = (
        "plan again with `vrts grade plan --overwrite`, and run the shards again",
        "or take them as they are, with `vrts grade merge --unsigned`",
    )
    raise Refused((error(UNSIGNED, headline, help=remedies),))


def _unfit(marked: MarkedShard, sent: Sent, why: str) -> Diagnostic:
    headline = f"`{marked.name}`, shard {sent.number}: {why}"
    return error(UNFIT, headline, help=(_again(marked, sent),), data={"shard": sent.number})


def _again(marked: MarkedShard, sent: Sent) -> str:
    what = f"delete `{marked.name}` and run shard {sent.number} again"
    return f"{what} on a machine that you trust, and merge again"
