"""What a student is told about a mark, in plain words: as text, and as HTML for a comment.

Everything but the final mark, lateness and changes by hand is of the student's own result, in which
nothing hidden is.
"""

from fractions import Fraction
from typing import NamedTuple

from msgspec.structs import replace

from vrts.check.task.manifest import IN_HIDDEN_SCENE
from vrts.marking.by_hand.decisions.words import due_words
from vrts.marking.exports.given import Returned
from vrts.marking.exports.numbers import decimal
from vrts.marking.exports.steps import steps
from vrts.marking.result import Kind
from vrts.marking.row import BEST_OF, OF_SEVERAL, Decided, Row
from vrts.marking.unsafe import Reason
from vrts.report.page.html import element, joined, prose
from vrts.report.plain import one_line, plain_text

NAME = "feedback.txt"
FINAL = "Final mark:"  # begins every comment
MOST_LOSSES = 20
SAID = "From your graders"
NOT_SHOWN = "checks that are not shown here"
OF_STUDENTS = frozenset({Reason.LATE, Reason.UNCHECKED, Reason.HIDDEN})  # in these words
LOOKED_AT = "A person will look at this mark: it may still change."  # why may be hidden


class Line(NamedTuple):
    """Points, why, and a hint."""

    points: str  # signed
    sentence: str
    hint: str = ""


class Words(NamedTuple):
    """Everything there is to say."""

    title: str
    mark: str  # a sentence
    made_of: tuple[Line, ...]  # how the mark came to be; empty where it is as computed
    losses: tuple[Line, ...]
    said: tuple[str, ...]  # by graders
    remarks: tuple[str, ...]


def feedback_text(told: Returned) -> bytes:
    """Return the words for a text file."""
    words = words_for(told)
    lines = [words.title, words.mark]
    if words.made_of:
        lines += ["", "How the mark came to be:", *_listed(words.made_of)]
    if words.losses:
        lines += ["", "What cost points:", *_listed(words.losses)]
    if words.said:
        lines += ["", f"{SAID}:", *(f"  {text}" for text in words.said)]
    if words.remarks:
        lines += ["", *words.remarks]
    return (plain_text("\n".join(lines)) + "\n").encode()


def feedback_html(told: Returned) -> str:
    """Return the words as HTML on one line; what is foreign in them is escaped."""
    words = words_for(told)
    parts = [element("p", words.mark)]
    for heading, listed in (
        ("How the mark came to be:", words.made_of),
        ("What cost points:", words.losses),
    ):
        if listed:
            items = (element("li", *_item(line)) for line in listed)
            parts += [element("p", heading), element("ul", *items)]
    if words.said:
        parts += [element("p", f"{SAID}:"), element("ul", *(element("li", t) for t in words.said))]
    parts += [element("p", prose(remark)) for remark in words.remarks]
    return joined(parts).replace("\n", " ").replace("\r", " ")


def unsure(row: Row) -> list[str]:
    """Return why a mark is unsafe, as far as that is for the student to know."""
    told = [
        f"This mark is not sure yet: {one_line(doubt.sentence)}."
        for doubt in row.unsafe
        if doubt.reason in OF_STUDENTS
    ]
    if any(doubt.reason not in OF_STUDENTS for doubt in row.unsafe):
        told.append(LOOKED_AT)
    return told


def which_counts(row: Row) -> list[str]:
    """Return which of several hand-ins counts, and why others do not; nothing for a single one."""
    why = row.handed_in.why
    several = why.startswith(BEST_OF) or OF_SEVERAL in why
    return [f"What counts: {one_line(why)}."] if several else []


def words_for(told: Returned) -> Words:
    """Return everything there is to say to a student."""
    row, public = told
    final = row.exact_final
    mark = (
        f"{FINAL} {decimal(final, least=1)} of {decimal(row.result.exact_total)}"
        if final is not None
        else "No mark yet"
    )
    losses = tuple(
        Line(_signed(-Fraction(loss.points_exact)), one_line(loss.sentence), loss.hint or "")
        for loss in public.losses
    )
    more = len(losses) - MOST_LOSSES
    remarks = which_counts(row)
    if more > 0:
        losses = losses[:MOST_LOSSES]
        remarks.append(f"{more} more losses are in the report.")
    if not losses and public.kind is not Kind.GRADED:
        remarks.append(f"{one_line(public.cause)}.")
        if public.hint:
            remarks.append(f"Hint: {one_line(public.hint)}")
    if losses and told.row.result.exact_mark != public.exact_mark:
        remarks.append("These are the losses in what you can see.")
    if public.review:
        remarks.append(LOOKED_AT)
    remarks += [text for text in unsure(row) if text not in remarks]
    remarks += [f"This mark does not count: {one_line(stamp)}." for stamp in public.stamps]
    title = one_line(public.task.title)
    return Words(title, mark, _made_of(told), losses, said_by_graders(row), tuple(remarks))


def said_by_graders(row: Row) -> tuple[str, ...]:
    """Return what graders have written for a student: comments, items with their places, a date."""
    decided = for_student(row)
    if decided is None:
        return ()
    found = [f"{place_of(c.line, c.time_s)}{one_line(c.text)} ({c.who})" for c in decided.comments]
    for item in decided.items:
        places = [place_of(line, time_s).removesuffix(": ") for line, time_s in item.places]
        where = f" ({'; '.join(places)})" if places else ""
        found.append(f"{one_line(item.title)}: {_signed(Fraction(item.points))} points{where}")
    if decided.due:
        found.append(f"You had time until {due_words(decided.due)}.")
    return tuple(found)


def for_student(row: Row) -> Decided | None:
    """Return what is decided about a row as its student may know it.

    Moments are of the run that graders see. Where that was in a hidden scene, students see another
    run, in which they would be wrong, and might tell what is hidden.
    """
    decided = row.decided
    if decided is None:
        return None
    result = decided.result or row.result
    if not any(stamp.startswith(IN_HIDDEN_SCENE) for stamp in result.stamps):
        return decided
    comments = tuple(replace(one, time_s=None) for one in decided.comments)
    items = tuple(
        replace(
            item,
            places=tuple(dict.fromkeys((line, None) for line, _ in item.places if line)),
        )
        for item in decided.items
    )
    return replace(decided, comments=comments, items=items)


def place_of(line: int | None, time_s: float | None) -> str:
    """Return where a comment belongs, before what it says; "" where it is about the whole."""
    found = [] if line is None else [f"line {line}"]
    found += [] if time_s is None else [f"at {time_s:.2f} s"]
    return f"{', '.join(found)}: " if found else ""


def _made_of(told: Returned) -> tuple[Line, ...]:
    row, public = told
    if row.exact_final is None:
        return ()
    computed, seen = row.result.exact_mark, public.exact_mark
    changes = [Line(_signed(s.points), _titled(s.title, s.sentence)) for s in steps(row)]
    if computed is not None and seen is not None and computed != seen:
        changes.insert(0, Line(_signed(computed - seen), NOT_SHOWN))
        computed = seen
    if not changes:
        return ()
    start = Line(decimal(computed or Fraction(0), least=1), "computed from what you can see")
    if changes[0].sentence != NOT_SHOWN:
        start = start._replace(sentence="computed" if computed is not None else "no computed mark")
    return (start, *changes)


def _titled(title: str, sentence: str) -> str:
    return f"{title}: {one_line(sentence)}" if sentence else title


def _signed(value: Fraction) -> str:
    return ("+" if value > 0 else "") + decimal(value, least=1, most=2)


def _listed(lines: tuple[Line, ...]) -> list[str]:
    found: list[str] = []
    for line in lines:
        found.append(f"  {line.points:>5}  {line.sentence}")
        if line.hint:
            found.append(f"         Hint: {one_line(line.hint)}")
    return found


def _item(line: Line) -> tuple[str, ...]:
    hint = f" Hint: {one_line(line.hint)}" if line.hint else ""
    return (f"{line.points} ", prose(line.sentence), prose(hint))
