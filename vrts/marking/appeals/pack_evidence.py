"""Packs everything that one mark rests on."""

import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import msgspec

from vrts import __version__
from vrts.base.diagnostic import error
from vrts.base.safe_names import safe
from vrts.base.zips import packed
from vrts.check.task.manifest import sha256
from vrts.marking.about import About
from vrts.marking.appeals.evidence import (
    CHANGES,
    CONTENTS,
    DECISIONS,
    INTAKE,
    MODE,
    README,
    ROW,
    STAFF,
    STUDENT,
    SUBMISSION,
    Contents,
)
from vrts.marking.appeals.evidence_readme import readme
from vrts.marking.appeals.handed_in import handed_in, intake_row
from vrts.marking.appeals.proof import PROOF, certificate_for
from vrts.marking.appeals.task_bytes import OTHER_TASK, task_files
from vrts.marking.appeals.unpacked import unpacked_place
from vrts.marking.appeals.written import Written, no_marking
from vrts.marking.by_hand.by_hand import with_by_hand
from vrts.marking.by_hand.decisions.about_one import about_student
from vrts.marking.by_hand.graded import undecided
from vrts.marking.by_hand.override_text import override_text
from vrts.marking.layout import LOST, RESULT
from vrts.marking.result import SCORING, Damaged, Result, from_bytes
from vrts.marking.row import Row
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.report_files import FAULT, RECORDING, REPORT
from vrts.marking.supervise.scratch import scratch_folder
from vrts.marking.variants.marker import variant_place
from vrts.pipeline.refused import Refused

LIBRARIES = ("numpy", "coal", "python-fcl", "pin", "msgspec", "rerun-sdk")
SUBMISSIONS = "SUBMISSIONS"  # in place of the names of files, which may be names of others


def pack_evidence(
    written: Written, student: str, *, task: Path | None = None, download: Path | None = None
) -> tuple[Row, bytes]:
    """Return the row of a student, and the zip with everything that the mark rests on.

    Args:
        written: The marking.
        student: An id, or a name that only one has.
        task: Where the task is now; None: where it was.
        download: Where the download is now; None: where it was.

    Raises:
        CannotRead: A file is not there.
        Refused: There is no such student, or task or program are not those that were marked.
    """
    by_hand = written.by_hand()
    row = undecided(written.row(student))
    files = _results(written, row)
    own = variant_place(written.about.place, written.layout, row.result)
    place = own or written.about.place
    if task is not None and own is None:
        place = msgspec.structs.replace(place, task=str(task))
    inside, of_task = task_files(place, row.result)
    files.update(of_task)
    data = handed_in(written, row, download)
    program = None
    if data is not None:
        named = row.result.program.name if row.result.program else row.handed_in.file
        program = f"{SUBMISSION}/{safe(named.rsplit('/', 1)[-1].rsplit('!', 1)[-1])}"
        files[program] = data
    if row.result.program is not None and data is not None:
        with scratch_folder() as folder:
            marker = Marker(unpacked_place(inside, of_task, folder), written.about.wanted)
        _require_same_task(marker, row.result, data)
        title = row.result.program.name
        proof = certificate_for(marker.whole, title, data) if marker.wanted.collisions else None
        if proof is not None:
            files[PROOF] = proof
    line = intake_row(written, row)
    if line is not None:
        files[INTAKE] = line
    made = by_hand.overrides.changes.get(row.id, ())
    if made:
        files[CHANGES] = "\n".join(map(override_text, made)).encode()
    said = about_student(by_hand.ledger, row.id)
    if said:
        files[DECISIONS] = said
    row = with_by_hand(row, by_hand)
    files[ROW] = msgspec.json.format(msgspec.json.encode(row), indent=1) + b"\n"
    about = written.about
    contents = Contents(
        "vrts.evidence/1",
        row.id,
        row.result.program.name if row.result.program else "",
        program,
        inside,
        about.wanted,
        about.when.isoformat(),
        _command(about),
        versions(),
        {},
    )
    files[README] = readme(row, contents).encode()
    digests = {name: sha256(files[name]) for name in sorted(files)}
    whole = msgspec.structs.replace(contents, sha256=digests)
    ordered = {
        CONTENTS: msgspec.json.format(msgspec.json.encode(whole), indent=1) + b"\n",
        **{name: files[name] for name in sorted(files)},
    }
    return row, packed(ordered, MODE)


def versions() -> dict[str, str]:
    """Return the versions of everything here that a result may depend on."""
    found = {
        "vrts": __version__,
        "scoring": str(SCORING),
        "python": platform.python_version(),
        "platform": f"{sys.platform} {platform.machine()}",
    }
    for library in LIBRARIES:
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            continue  # not needed here
    return found


def _results(written: Written, row: Row) -> dict[str, bytes]:
    """Return what was written about a student, for both readers."""
    layout = written.layout
    homes = {STAFF: layout.grader(row.id), STUDENT: layout.student(row.id)}
    files: dict[str, bytes] = {}
    for who, home in homes.items():
        for name in (RESULT, REPORT, RECORDING, FAULT, LOST):
            place = home / name
            if place.is_file() and not place.is_symlink():
                files[f"{who}/{name}"] = place.read_bytes()
    for who in homes:
        _require_result(written, row, files.get(f"{who}/{RESULT}", b""), staff=who == STAFF)
    return files


def _require_result(written: Written, row: Row, data: bytes, *, staff: bool) -> None:
    """Refuse a result that is not the one in the list of marks."""
    try:
        found = from_bytes(data)
    except Damaged as problem:
        why = f"the result of `{row.id}` is missing or damaged"
        raise no_marking(written.layout.root, why) from problem
    if staff and found != row.result:
        why = f"the result of `{row.id}` is newer than the list of marks"
        raise no_marking(written.layout.root, why)


def _require_same_task(marker: Marker, result: Result, data: bytes) -> None:
    """Refuse a task by which another result would be made."""
    task = marker.whole.task
    assert task is not None
    same = task.digest == result.task.sha256 and marker.whole.scene.digest == result.scene.sha256
    if marker.whole.variants:  # the lowest mark may be that of another scene
        digests = {v.scene.digest for v in (marker.whole, *marker.whole.variants)}
        same = task.digest == result.task.sha256 and result.scene.sha256 in digests
    if result.versions.vrts == __version__ and result.versions.scoring == SCORING:
        same = marker.key(data) == result.key
    if not same:
        headline = "the task is not the one by which this was marked"
        notes = ("task, scene, lab, scenario or hidden checks were changed since",)
        remedy = (
            "name the task as it was with `--task`, or mark again and compare: `vrts grade diff`"
        )
        raise Refused((error(OTHER_TASK, headline, notes=notes, help=(remedy,)),))


def _command(about: About) -> tuple[str, ...]:
    """Return the command of a marking, without names of files that were handed in."""
    if not about.command:
        return ()
    words: list[str] = [Path(about.command[0]).name]
    for word in about.command[1:]:
        if word not in about.submissions:
            words.append(word)
        elif SUBMISSIONS not in words:
            words.append(SUBMISSIONS)
    return tuple(words)
