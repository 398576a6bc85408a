"""`vrts grade decisions`."""

import shlex
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import color_option, form_option

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from vrts.marking.by_hand.decisions.ledger import Ledger
    from vrts.marking.by_hand.decisions.listing import Listing
    from vrts.marking.by_hand.decisions.records import Decision
    from vrts.marking.by_hand.decisions.state import State

EPILOG = """\b
Examples:
  vrts grade decisions out
  vrts grade decisions out --format json
  vrts grade decisions out --undo r-huber:12 --who "A. Lang" --reason "wrong student"
  vrts grade decisions out --keep r-huber:12 --who "A. Lang" --reason "as agreed"
"""

MOST_NAMES = 5  # of students in a line


@click.command(name="decisions", epilog=EPILOG)
@click.argument("folder", metavar="OUT", type=click.Path(path_type=Path))
@click.option("--undo", multiple=True, metavar="NAME", help="Undo a decision. Repeatable.")
@click.option(
    "--keep", multiple=True, metavar="NAME", help="Decide a conflict: this decision counts."
)
@click.option(
    "--student",
    multiple=True,
    metavar="ID",
    help="With `--keep`: for this student only. Repeatable.",
)
@click.option("--who", help="Who decides that; needed with `--undo` and `--keep`.")
@click.option("--reason", default="", help="Why; needed with `--keep`.")
@form_option("full", "json")
@color_option
@guarded
def command(
    folder: Path,
    undo: tuple[str, ...],
    keep: tuple[str, ...],
    student: tuple[str, ...],
    who: str | None,
    reason: str,
    form: str,
    color: str,
) -> None:
    """List what graders decided in OUT, and bring lists, feedback and pages up to date with it.

    Every grader has a file in OUT/staff/decisions, to which is only ever added. You may copy files
    of other graders into it. A decision is named after its file and number, such as r-huber:12.
    What graders decided differently is a conflict: none of it counts, and the mark is unsafe until
    somebody decides it with --keep, or undoes one of the decisions with --undo. Both are decisions
    themselves, and can be undone. Nothing is deleted. --keep decides it for all who share the
    conflict now, or for each --student; --undo undoes a decision for all whom it is about.

    A decision about a program does not count for another one. It is listed, and the mark is unsafe
    until it is undone and decided again. Exit status 1 while there are conflicts.
    """
    from vrts.marking.by_hand.by_hand import programs_of
    from vrts.marking.by_hand.decisions.listing import listing, with_file
    from vrts.marking.by_hand.decisions.state import state_of
    from vrts.marking.layout import Layout
    from vrts.marking.renewing.renewed import renewed

    layout = Layout(folder)
    if student and not keep:
        fail("`--student` is for `--keep`")
    if undo or keep:
        _decide(layout.root, undo, keep, student, who, reason)
    elif who or reason:
        fail("`--who` and `--reason` are for `--undo` and `--keep`")
    found = renewed(layout)
    show_diagnostics(found.diagnostics, color)
    ledger = found.by_hand.ledger
    told = listing(ledger, state_of(ledger, programs_of(found.rows.rows)))
    told = with_file(told, found.rows.rows)
    out(_json(told) if form == "json" else "\n".join(_lines(told, folder)))
    if found.changed:
        rows = "1 row" if len(found.changed) == 1 else f"{len(found.changed)} rows"
        say(f"brought {rows} up to date in {layout.root}")
    sys.exit(WRONG if told.conflicts else HOLDS)


def _decide(
    folder: Path,
    undo: "Sequence[str]",
    keep: "Sequence[str]",
    students: "Sequence[str]",
    who: str | None,
    reason: str,
) -> None:
    """Write down what is undone and what is decided, all of it or nothing."""
    from vrts.marking.appeals.written import read_written
    from vrts.marking.by_hand.by_hand import programs_of
    from vrts.marking.by_hand.decisions.files import add_decisions
    from vrts.marking.by_hand.decisions.records import Decide, Undo
    from vrts.marking.by_hand.decisions.state import state_of, students_of

    if not who:
        fail("say who decides that", ('`--who`, such as `--who "R. Huber"`',))
    written = read_written(folder)
    by_hand = written.by_hand()
    ledger = by_hand.ledger
    state = state_of(ledger, programs_of(written.rows.rows))
    said: list[Decision] = []
    if undo:
        _require_there(ledger, undo)
        said.append(Undo(0, "", tuple(dict.fromkeys(undo)), reason))
    if keep and not reason.strip():
        fail("`--keep` needs `--reason`: a student may ask")
    said += [_kept(state, name, students, reason) for name in dict.fromkeys(keep)]
    added = add_decisions(written.layout.decisions, who, said, datetime.now(UTC))
    say(f"wrote {', '.join(one.name for one in added.records)}")
    for one in said:
        if isinstance(one, Decide) and one.students:
            say(f"{one.keep} counts for {_named(one.students)}")
    for name in undo:
        whom = [who for one in ledger.records if one.name == name for who in students_of(one.said)]
        if len(whom) > 1:
            say(f"{name} is undone for {_named(whom)}")


def _require_there(ledger: "Ledger", names: "Sequence[str]") -> None:
    """Refuse to undo what is not there, or was undone already."""
    from vrts.marking.by_hand.decisions.counting import counted

    known = {one.name for one in ledger.records}
    undone = counted(ledger.records).undone
    for name in names:
        if name not in known:
            _refuse(f"there is no decision `{name}`", "without `--undo` all are listed")
        if name in undone:
            by = undone[name]
            _refuse(f"`{name}` is undone already, by `{by}`", f"to have it again, undo `{by}`")


def _kept(state: "State", name: str, students: "Sequence[str]", reason: str) -> "Decision":
    """Return the decision that one side of a conflict counts, and for whom."""
    from vrts.marking.by_hand.decisions.records import Decide

    found = [one for one in state.conflicts if name in {side.name for side in one.sides}]
    if not found:
        _refuse(f"`{name}` is in no conflict", "conflicts stand first in the list")
    for student in students:
        if student not in {one.student for one in found}:
            headline = f"`{name}` is in no conflict about `{student}`"
            _refuse(headline, "conflicts stand first in the list, with their students")
    if students:
        found = [one for one in found if one.student in students]
    over = dict.fromkeys(side.name for one in found for side in one.sides if side.name != name)
    whom = dict.fromkeys(one.student for one in found)
    return Decide(0, "", name, tuple(over), reason, () if "" in whom else tuple(whom))


def _named(students: "Sequence[str]") -> str:
    """Return names for a line: the first of many."""
    from vrts.report.plain import one_line

    more = len(students) - MOST_NAMES
    return ", ".join(map(one_line, students[:MOST_NAMES])) + (
        f" and {more} more" if more > 0 else ""
    )


def _refuse(headline: str, remedy: str) -> NoReturn:
    from vrts.base.diagnostic import error
    from vrts.marking.by_hand.decisions.files import UNSOUND
    from vrts.pipeline.refused import Refused

    raise Refused((error(UNSOUND, headline, help=(remedy,)),))


def _lines(told: "Listing", folder: Path) -> "Iterator[str]":
    """Yield the list: what is not decided first."""
    from vrts.marking.by_hand.decisions.listing import FILE
    from vrts.report.plain import one_line

    where = shlex.quote(str(folder))
    if not told.decisions:
        yield "graders have decided nothing"
        return
    if told.conflicts:
        yield "Conflicts:"
    for conflict in told.conflicts:
        about = f"{one_line(conflict.student)}: " if conflict.student else ""
        yield f"  {about}{conflict.sentence}"
        if not conflict.records:
            if conflict.about == FILE:
                remedy = "delete the one in `overrides.toml`, or undo the other with `--undo NAME`"
                yield f"      {remedy}"
            continue
        side = conflict.records[0]
        typed = f"vrts grade decisions {where} --keep {side} --who YOU --reason WHY"
        yield f"      decide it, for example: {typed}"
    if told.items:
        yield "Rubric items:"
    for item in told.items:
        count = "1 student" if len(item.students) == 1 else f"{len(item.students)} students"
        ends = ", withdrawn" if item.withdrawn else ""
        yield f"  {item.points:+g}  {one_line(item.title)} ({item.id}, {count}{ends})"
    yield "Decisions:"
    for one in told.decisions:
        names = _named(one.students)
        about = f"{names}: " if names else ""
        yield f"  {one.record}  {one.at[:16].replace('T', ' ')}  {one.who}  {about}{one.sentence}"
        if one.undone_by:
            yield f"      undone by {one.undone_by}"
        if one.lapsed:
            yield f"      about another program, and does not count: {', '.join(one.lapsed[:5])}"


def _json(told: "Listing") -> str:
    import msgspec

    return msgspec.json.format(msgspec.json.encode(told), indent=1).decode()
