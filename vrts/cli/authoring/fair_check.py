"""What `vrts task check` says of a task with variants."""

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from vrts.cli.shared.console import out, say, show_diagnostics
from vrts.cli.shared.cores import workers_of
from vrts.cli.shared.progress import Progress

if TYPE_CHECKING:
    from vrts.assignments.variants.of_task import VariedTask
    from vrts.check.variants.drawn import Variant
    from vrts.check.variants.model import Combination
    from vrts.marking.variants.class_list import ClassList
    from vrts.marking.variants.handed import Students


class HowTo(NamedTuple):
    """How the variants of a task are checked."""

    reference: Path | None  # the solution; None: that of the folder
    members: "ClassList | None"  # the class; None: only a covering set is tried
    key: Path | None  # by which variants are drawn; None: that beside the task
    jobs: int | None  # variants that are tried at a time; None: one a core
    color: str


def check_variants(folder: Path, how: HowTo) -> bool:
    """Try the variants of a task, say what was found, and return whether all can be handed out.

    Raises:
        CannotRead: A file is not there.
        Refused: The list, the key or a path of `[variants]` is wrong, or the task has not the
            variants any more that were handed out.
    """
    from vrts.assignments.fair.fairness import fairness
    from vrts.assignments.fair.in_words import fair_findings, fair_lines
    from vrts.assignments.variants.key import key_of, place_of_key
    from vrts.assignments.variants.of_task import load_varied
    from vrts.pipeline.files import read_bytes
    from vrts.report.plain import plain_text

    varied = load_varied(folder)
    if how.reference is not None:
        varied = replace(varied, solution=read_bytes(how.reference))
    varied.as_written()  # which students could not read, it says
    students: dict[str, Combination] = {}
    place = how.key or place_of_key(folder)
    if how.members is not None:
        varied, students = _drawn(varied, how.members, place, how.color)
    elif how.key is not None or os.path.lexists(place):
        _handed(varied, key_of(place), place, how.color)
    progress = Progress()
    found = fairness(varied, students, workers_of(how.jobs), progress.advance)
    progress.clear()
    out("")
    show_diagnostics(fair_findings(varied.variants, found), how.color)
    out(plain_text("\n".join(fair_lines(varied.variants, found))))
    return found.fair


def members_of(roster: Path | None) -> "ClassList | None":
    """Return who is in a class; None where there is no list.

    Raises:
        CannotRead: The list is not there, or is none.
        Refused: Two in it cannot be told apart.
    """
    if roster is None:
        return None
    from vrts.marking.intake.tables.roster import read_roster
    from vrts.marking.variants.class_list import class_list
    from vrts.pipeline.files import read_bytes

    return class_list(read_roster(read_bytes(roster), roster.name, None), roster.name)


def _drawn(
    varied: "VariedTask", members: "ClassList", place: Path, color: str
) -> "tuple[VariedTask, dict[str, Combination]]":
    """Return the task with the key, and which variant each student of a class has."""
    from vrts.assignments.variants.key import key_made
    from vrts.marking.variants.handed import changed, variants_of

    secret, made = key_made(place)
    if made:
        say(f"made the key {place}: keep a copy, and give it to no student")
    handed = _handed(varied, secret, place, color)
    given = variants_of(varied, members, secret, handed)
    if given.gone:
        raise changed(given.gone, place)
    return varied.with_key(secret), by_name(members, given.variants)


def _handed(varied: "VariedTask", secret: bytes, place: Path, color: str) -> "Students":
    """Return what was handed out by a key, and say so where that is not known, or is past."""
    from vrts.marking.variants.handed import changed_since, read_handed, record_gone

    assignment = varied.variants.assignment
    handed = read_handed(place, secret, assignment)
    show_diagnostics(record_gone(place, assignment, handed), color)
    show_diagnostics(changed_since(place, secret, varied), color)
    return handed


def by_name(members: "ClassList", variants: "Mapping[str, Variant]") -> "dict[str, Combination]":
    """Return which variant each student of a class has, by a name that tells who it is."""
    found: dict[str, Combination] = {}
    for member in members.members:
        name = member.student.name or member.number
        if name in found:
            name = f"{name} ({member.number})"
        found[name] = variants[member.number].combination
    return found
