"""Forgets one student in markings: what is about them alone first, lists last.

Who is forgotten is written down before anything is changed. Each step leaves the same when it is
done again, so whatever interrupts this, the same call ends it.
"""

import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from datetime import UTC, datetime, timedelta
from hashlib import sha256
from pathlib import Path, PurePath, PureWindowsPath
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking import about
from vrts.marking.about import About
from vrts.marking.appeals.written import read_class, read_written
from vrts.marking.by_hand.decisions.files import LOCK, locked
from vrts.marking.by_hand.decisions.ledger import ENDING, ledger_of
from vrts.marking.class_files import write_class, write_overview
from vrts.marking.exports.write import EXPORTS, is_name
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.personal.alone import alone_in
from vrts.marking.personal.compared import (
    compare_again,
    corpora_found,
    keep_without,
    show_programs_of,
    told_lost,
)
from vrts.marking.personal.decided import without_student
from vrts.marking.personal.named import Names, files_naming
from vrts.marking.personal.overrides import without_changes
from vrts.marking.personal.tables import without_lines
from vrts.marking.personal.whom import (
    Whom,
    left_of,
    nobody,
    nobody_here,
    strike_out,
    unfinished,
    whom_in,
    write_down,
)
from vrts.marking.privacy.pseudonyms import NAMES, write_names
from vrts.marking.privacy.purge import A_LINK, State, look
from vrts.marking.renewing.renewed import brought_up_to_date
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused

STILL = Rule("V924", "still-named")
MOST = 20  # files that are told

Step = Callable[[], object]


class Job(NamedTuple):
    """What is to be done in one marking."""

    layout: Layout
    whom: Whom
    goes_on: bool = False  # an earlier call was interrupted

    @property
    def title(self) -> str:
        """The marking, in words."""
        return _about(self.layout).title


class Done(NamedTuple):
    """What became of one marking."""

    exports: tuple[str, ...]  # that named the student, and are deleted
    diagnostics: tuple[Diagnostic, ...]


def planned(folders: Sequence[Path], wanted: str) -> tuple[Job, ...]:
    """Return what is to be done to forget a student; nobody is forgotten yet.

    Pages and lists are brought up to date with what graders have decided.

    Args:
        folders: Of markings.
        wanted: Id or pseudonym of the student; or a name or an address that only one has.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A folder is no marking that has ended, a link is in the way, decisions have errors,
            or there is nobody of that id in any of them.
    """
    jobs: dict[Path, Job] = {}
    now = datetime.now(UTC)
    for folder in folders:
        layout = Layout(folder)
        if look(folder, timedelta(0), now).state is State.PURGED:
            continue
        before = unfinished(layout)
        whom = before or whom_in(folder, wanted) or left_of(folder, wanted)
        if whom is not None:
            _check_links(layout, whom)
            jobs[folder] = Job(layout, whom, before is not None)
    if not jobs:
        raise nobody(folders[0], wanted)
    for folder, job in list(jobs.items()):
        if not job.goes_on:
            brought_up_to_date(read_written(folder))
    for folder in folders:
        if folder not in jobs and show_programs_of(folder, [*jobs]):
            jobs[folder] = Job(Layout(folder), nobody_here(Layout(folder)))
    return tuple(_with_corpora(job, folders) for job in jobs.values())


def forget(jobs: Sequence[Job]) -> tuple[Done, ...]:
    """Do what is planned, and return what became of each marking.

    Raises:
        CannotRead: A file cannot be read.
        Refused: Somebody marks, or a file is damaged; the same call goes on where this has ended.
        OSError: A file cannot be written; the same.
    """
    with ExitStack() as held:
        for job in sorted(jobs, key=lambda one: str(one.layout.root.resolve())):
            held.enter_context(alone_in(job.layout))
        told: dict[Path, list[Diagnostic]] = {job.layout.root: [] for job in jobs}
        exports: dict[Path, list[str]] = {job.layout.root: [] for job in jobs}
        for step in steps(jobs, exports, told):
            step()
    return tuple(_done(job, exports[job.layout.root], told[job.layout.root]) for job in jobs)


def steps(
    jobs: Sequence[Job],
    exports: Mapping[Path, list[str]],
    told: Mapping[Path, list[Diagnostic]],
) -> Iterator[Step]:
    """Yield what is to be done, in order.

    Args:
        jobs: Of all markings.
        exports: Takes by folder the names of exports that are deleted.
        told: Takes by folder what there is to say.
    """
    for job in jobs:
        yield lambda job=job: write_down(job.whom, job.layout)
    for job in jobs:
        layout, whom = job.layout, job.whom
        if not whom.id:
            continue
        for place in (layout.student(whom.id), layout.grader(whom.id)):
            yield lambda place=place: shutil.rmtree(place) if place.is_dir() else None
        yield lambda layout=layout: _remove_drafts(layout)
        yield lambda job=job: _tables(job)
        yield lambda job=job: exports[job.layout.root].extend(_exports(job))
        yield lambda job=job: keep_without(job.layout, job.whom.ids)
        yield lambda job=job: _overrides(job)
    for job in jobs:
        if job.whom.compared:
            yield lambda job=job: told[job.layout.root].extend(_compared(job))
    for job in jobs:
        if job.whom.id:
            yield lambda job=job: _decisions(job)
            yield lambda job=job: _lists(job)
            yield lambda job=job: _variant(job)
        else:
            yield lambda job=job: _link(job.layout)
        yield lambda layout=job.layout: strike_out(layout)


def _with_corpora(job: Job, folders: Sequence[Path]) -> Job:
    if job.goes_on or not job.whom.compared:
        return job
    found = corpora_found(job.layout.root, folders)
    corpora = tuple(str(one) for one in found.folders)
    return job._replace(whom=msgspec.structs.replace(job.whom, corpora=corpora, lost=found.lost))


def _check_links(layout: Layout, whom: Whom) -> None:
    """Refuse a student's folder that is a link, or whose name leads elsewhere."""
    for place in (layout.student(whom.id), layout.grader(whom.id)) if whom.id else ():
        if not is_name(whom.id) or place.is_symlink():
            headline = f"`{place}` is a link: nobody is forgotten"
            remedy = "delete by hand the link, and what it leads to"
            raise Refused((error(A_LINK, headline, help=(remedy,)),))


def _about(layout: Layout) -> About:
    return about.from_bytes(read_bytes(layout.staff / about.NAME))


def _remove_drafts(layout: Layout) -> None:
    """Remove what killed markings have left: none goes on."""
    if layout.staging.is_dir() and not layout.staging.is_symlink():
        shutil.rmtree(layout.staging)


def _tables(job: Job) -> None:
    layout, ids = job.layout, set(job.whom.ids)
    for place in (layout.intake, layout.staff / NAMES):
        if place.is_file() and not place.is_symlink():
            before = read_bytes(place)
            after = without_lines(before, place.name, ids)
            if after != before and place.name == NAMES:
                write_names(layout.staff, after)
            elif after != before:
                write_atomically(place, after)


def _exports(job: Job) -> Iterator[str]:
    """Delete the exports that name the student, and yield their names."""
    home = job.layout.staff / EXPORTS
    if not home.is_dir() or home.is_symlink():
        return
    for path in list(files_naming(home, Names(job.whom.names))):
        path.unlink()
        yield path.relative_to(job.layout.root).as_posix()
    for folder in sorted((one for one in home.rglob("*") if one.is_dir()), reverse=True):
        if not folder.is_symlink() and not any(folder.iterdir()):
            folder.rmdir()


def _overrides(job: Job) -> None:
    place = job.layout.overrides
    if place.is_file():
        before = read_bytes(place)
        after = without_changes(before, place.name, set(job.whom.ids))
        if after != before:
            write_atomically(place, after)


def _decisions(job: Job) -> None:
    folder = job.layout.decisions
    if not folder.is_dir():
        return
    with locked(folder, LOCK):
        for name, data in without_student(_files(folder), set(job.whom.ids)).items():
            write_atomically(folder / name, data)


def _files(folder: Path) -> dict[str, bytes]:
    places = sorted(folder.glob(f"*{ENDING}"))
    return {one.name: read_bytes(one) for one in places if one.is_file() and not one.is_symlink()}


def _lists(job: Job) -> None:
    layout, whom = job.layout, job.whom
    rows = read_class(layout.results)
    counts = ledger_of(_files(layout.decisions) if layout.decisions.is_dir() else {}).counts
    left = tuple(row for row in rows.rows if row.id not in whom.ids)
    marked = _about(layout)
    now = sha256(read_bytes(layout.staff / whom.table)).hexdigest() if whom.table else ""
    marked = msgspec.structs.replace(
        marked,
        submissions=tuple(text for text in marked.submissions if not _is_of(text, whom)),
        command=tuple(word for word in marked.command if not _is_of(word, whom)),
        intake_sha256=now if whom.table else marked.intake_sha256,
    )
    write_class(msgspec.structs.replace(rows, rows=left, decisions=counts), marked, layout)


def _is_of(text: str, whom: Whom) -> bool:
    """Return whether a word of a command names the file that a student handed in."""
    name = PureWindowsPath(text).name
    mine = whom.file and name == PurePath(whom.file).name
    return bool(mine) or PurePath(name).stem in whom.ids


def _variant(job: Job) -> None:
    """Delete the variant of a student, where nobody else has it."""
    tag = job.whom.tag
    rows = read_class(job.layout.results).rows
    tags = {row.result.variant.tag for row in rows if row.result.variant is not None}
    if tag and is_name(tag) and tag not in tags:
        (job.layout.variants / f"{tag}.zip").unlink(missing_ok=True)


def _compared(job: Job) -> tuple[Diagnostic, ...]:
    return compare_again(job.layout, job.whom.corpora)


def _link(layout: Layout) -> None:
    write_overview(read_class(layout.results), _about(layout), layout)


def _done(job: Job, exports: Sequence[str], told: Sequence[Diagnostic]) -> Done:
    layout, whom = job.layout, job.whom
    still = files_naming(layout.root, Names(whom.names)) if whom.id else ()
    named = [path.relative_to(layout.root).as_posix() for path in still]
    return Done(tuple(exports), (*told, *told_lost(layout, whom.lost), *_still(layout, named)))


def _still(layout: Layout, named: Sequence[str]) -> Iterator[Diagnostic]:
    if named:
        more = f"and {len(named) - MOST} more" if len(named) > MOST else ""
        notes = (*(f"`{name}`" for name in named[:MOST]), *((more,) if more else ()))
        one = "1 file" if len(named) == 1 else f"{len(named)} files"
        headline = f"{one} in `{layout.root}` still may name the student, and stay"
        remedies = (
            "look into them: they are about others, or vrts has not written them",
            "mend or delete by hand what has to go",
        )
        yield warning(STILL, headline, notes=notes, help=remedies)
