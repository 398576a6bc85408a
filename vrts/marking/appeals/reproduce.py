"""Marks what is in evidence again, and compares."""

from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic
from vrts.controllers.models import FIRST, MODELS
from vrts.marking.appeals.evidence import Evidence
from vrts.marking.appeals.pack_evidence import versions
from vrts.marking.appeals.proof import PROOF, checked_proof
from vrts.marking.appeals.unpacked import unpacked_place
from vrts.marking.differences import Difference, differences
from vrts.marking.marking import Entry
from vrts.marking.result import Result
from vrts.marking.sample import OTHERS, STAFF, STUDENT, mark_again
from vrts.marking.submission.marker import Marker, versions_of_scoring
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.scratch import scratch_folder
from vrts.run_files.proving import Proof

OF_VERSIONS = ("key", "versions")  # fields that say only with which vrts a result was made


class Reproduced(NamedTuple):
    """What came of marking again."""

    result: Result  # the new one, for those who mark
    first: Difference | None  # None: the same result
    whose: str  # in which of the two results of a submission the difference is
    proof: Proof | None  # the certificate in the evidence, which holds; None: there is none
    unread: (
        Diagnostic | None
    )  # why the certificate cannot be checked: its format is of another vrts
    same_points: bool  # whether mark and parts are the same, whatever is said of them
    other_vrts: bool  # whether the first result was made by another vrts, or another scoring


def reproduce(evidence: Evidence) -> Reproduced | None:
    """Mark the program of evidence again, in a process of its own; None: there is none to mark.

    Results of another version of vrts are compared in all but what names the version.

    Raises:
        Refused: The task in the evidence has errors, or its certificate does not hold; one that
            another vrts has written in another format is left unread.
    """
    data = evidence.program
    if data is None:
        return None
    contents = evidence.contents
    with scratch_folder() as folder:
        place = unpacked_place(contents.place, evidence.files, folder)
        place = _under_model_of_then(place, evidence.staff)
        marker = Marker(place, contents.wanted)
        proof: Proof | Diagnostic | None = None
        certificate = evidence.files.get(PROOF)
        if certificate is not None:
            proof = checked_proof(certificate, marker.whole, contents.title, data)
        entry = Entry(contents.id, contents.title, data)
        (done,) = mark_again(marker, [entry])
    made = evidence.staff.versions
    same_version = (made.vrts, str(made.scoring)) == versions_of_scoring()
    without = OTHERS if same_version else (*OF_VERSIONS, *OTHERS)
    if evidence.staff.controller is None:  # which results did not tell
        without = (*without, "controller")
    again = Reproduced(
        done.result,
        None,
        "",
        None if isinstance(proof, Diagnostic) else proof,
        proof if isinstance(proof, Diagnostic) else None,
        _points(done.result) == _points(evidence.staff),
        not same_version,
    )
    for whose, old, new in (
        (STAFF, evidence.staff, done.result),
        (STUDENT, evidence.student, done.student),
    ):
        first = next(differences(old, new, without), None)
        if first is not None:
            return again._replace(first=first, whose=whose)
    return again


def _points(result: Result) -> tuple[object, ...]:
    """Return what became of a program in points, without any words about it."""
    return (result.kind, result.mark, result.total, result.parts)


def _under_model_of_then(place: Place, result: Result) -> Place:
    """Return where a task is, under the controller model of a result; a lab has its own."""
    name = FIRST.name if result.controller is None else result.controller.name
    return msgspec.structs.replace(place, controller=name) if name in MODELS else place


def other_versions(evidence: Evidence) -> tuple[str, ...]:
    """Return what is here in another version than where the evidence was packed."""
    here = versions()
    there = evidence.contents.versions
    return tuple(
        f"{name}: {there.get(name, 'none')} when it was packed, {here.get(name, 'none')} here"
        for name in {**there, **here}
        if there.get(name) != here.get(name)
    )
