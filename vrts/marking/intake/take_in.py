"""From a download to rows: recognise its layout, look into the files, choose, and name."""

from collections.abc import Collection, Sequence
from datetime import UTC, datetime, tzinfo
from pathlib import Path

from vrts.marking.intake.candidate import candidates
from vrts.marking.intake.choice import choose
from vrts.marking.intake.identifiers import Identifiers
from vrts.marking.intake.layouts.canvas import canvas
from vrts.marking.intake.layouts.folders import NOT_HANDED_IN, folders, is_attempt, listed
from vrts.marking.intake.layouts.gradescope import METADATA, gradescope
from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.layouts.moodle import moodle
from vrts.marking.intake.row import Attempt, Intake, Kind, Problem, Row
from vrts.marking.intake.tables.roster import Roster, enrolled
from vrts.marking.intake.tree.opening import Tree, Unreadable, open_place
from vrts.pipeline.files import CannotRead

EARLIEST = datetime.min.replace(tzinfo=UTC)


def take_in(
    place: Path | Sequence[Path],
    *,
    program: str | None,
    zone: tzinfo | None = None,
    roster: Roster | None = None,
    given: Collection[str] = (),
) -> Intake:
    """Return a row for each student, sorted by identifier: the same bytes give the same rows.

    Args:
        place: A folder, a zip file, or a list of files.
        program: Name of the program that the task runs; None: any.
        zone: Of times that a platform gives without one; None: they only tell the order.
        roster: The class; who handed in nothing gets a row too.
        given: Programs that students were given, as `essence` tells them.

    Raises:
        CannotRead: There is nothing that could be read.
    """
    with open_place(place) as tree:
        return take_in_tree(tree, program=program, zone=zone, roster=roster, given=given)


def take_in_tree(
    tree: Tree,
    *,
    program: str | None,
    zone: tzinfo | None = None,
    roster: Roster | None = None,
    given: Collection[str] = (),
) -> Intake:
    """Return the rows of what was opened."""
    layout = listed(tree.files) if tree.is_list else _layout(tree, zone)
    if roster is not None:
        layout = enrolled(layout, roster)
    students: dict[str, list[HandIn]] = {}
    for hand_in in layout.hand_ins:
        students.setdefault(hand_in.key, []).append(hand_in)
    names = Identifiers()
    rows = [
        _row(tree, students[key], program, names, canvas=layout.canvas, given=given)
        for key in sorted(students, key=lambda key: (students[key][0].words, key))
    ]
    refused = tuple(f"`{name}` {why}, and was not read" for name, why in tree.refused.items())
    rows.sort(key=lambda row: row.identifier)
    return Intake(layout.title, tuple(rows), (*layout.remarks, *refused))


def _layout(tree: Tree, zone: tzinfo | None) -> Layout:
    """Return the layout of a download; a lone folder in it is taken for the download itself."""
    tops = _tops(tree, "")
    found = _platform(tree, tops, "")
    if found is not None:
        return found
    if len(tops) == 1:
        (top,) = tops
        inside = _tops(tree, f"{top}/")
        found = _platform(tree, inside, f"{top}/")
        if found is not None:
            return found
        flat = any(list(files) == [name] for name, files in inside.items())
        if len(inside) > 1 and (tree.is_zip or not flat) and not all(map(is_attempt, inside)):
            return _moved(folders(inside, zone), f"{top}/")
    return folders(tops, zone)


def _platform(tree: Tree, tops: dict[str, list[str]], root: str) -> Layout | None:
    if tops.get(METADATA) == [METADATA]:
        try:
            metadata = tree.store.read(root + METADATA)
        except Unreadable as flaw:
            raise CannotRead(f"`{METADATA}` {flaw}") from flaw
        return _moved(gradescope(metadata, tops), root)
    for recognise in (moodle, canvas):
        found = recognise(tops)
        if found is not None:
            return _moved(found, root)
    return None


def _tops(tree: Tree, root: str) -> dict[str, list[str]]:
    """Return files, named from a root, by the entry of it that they are or are in."""
    tops: dict[str, list[str]] = {}
    for folder in tree.folders:
        if folder.startswith(root) and folder != root.rstrip("/"):
            tops.setdefault(folder[len(root) :].split("/")[0], [])
    for file in tree.files:
        if file.startswith(root):
            name = file[len(root) :]
            if name in NOT_HANDED_IN:
                continue
            tops.setdefault(name.split("/")[0], []).append(name)
    return tops


def _moved(layout: Layout, root: str) -> Layout:
    """Return a layout with names from the root of the download."""
    if not root:
        return layout
    hand_ins = tuple(
        hand_in._replace(files=tuple(root + file for file in hand_in.files))
        for hand_in in layout.hand_ins
    )
    return layout._replace(hand_ins=hand_ins)


def _row(
    tree: Tree,
    attempts: list[HandIn],
    program: str | None,
    names: Identifiers,
    *,
    canvas: bool,
    given: Collection[str],
) -> Row:
    """Return the row of one student: the latest attempt, and what can be marked of the others."""
    ordered = sorted(attempts, key=lambda a: (a.received or EARLIEST, a.order, a.files))
    latest = ordered[-1]
    choices = [
        choose(candidates(tree, attempt.files), program, canvas=canvas, given=given)
        for attempt in ordered
    ]
    choice = choices[-1]
    good = tuple(
        Attempt(file, attempt.received)
        for attempt, found in zip(ordered, choices, strict=True)
        if found.problem is None and found.file is not None
        for file in (*found.copies, found.file)
    )
    why = choice.why
    if len(ordered) > 1:
        why = f"the latest of {len(ordered)} attempts; {why}"
    earlier = tuple(file for attempt in ordered[:-1] for file in attempt.files)
    return Row(
        names.take(*latest.words),
        latest.student,
        choice.file,
        why,
        latest.received,
        latest.flagged,
        attempts=good,
        others=choice.others + earlier,
        group=latest.group,
        problem=_link(tree, latest) or choice.problem,
    )


def _link(tree: Tree, hand_in: HandIn) -> Problem | None:
    """Return what is wrong when a hand-in has nothing but what is not read, as links."""
    if hand_in.files:
        return None
    folder = hand_in.key if hand_in.key.endswith("/") else ""
    for name, why in tree.refused.items():
        if folder and name.startswith(folder):
            return Problem(Kind.UNREADABLE, f"`{name}` {why}")
    return None
