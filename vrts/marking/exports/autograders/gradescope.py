"""results.json of Gradescope: what an autograder answers about one submission.

Checks that students see come from their own result, at points of their own. Hidden checks are
tests that are never shown, and give no points, as Gradescope wants it; what they make of the mark
is one test without their names, shown once marks are published. Until then Gradescope hides the
total. Nothing of another student is in the file, and nothing that names a machine.
"""

from fractions import Fraction

from vrts.marking.exports.feedback import said_by_graders, unsure
from vrts.marking.exports.given import Given, Options, Product, Returned, returned
from vrts.marking.exports.numbers import decimal, number, points
from vrts.marking.exports.steps import NOTHING, steps
from vrts.marking.result import Check, Kind
from vrts.report.formats.json_text import json_text
from vrts.report.plain import capital, one_line, visible

UNSEEN = "checks that are not shown"
NOISE = Fraction(1, 10_000)  # points are rounded where results are written
LONGEST = 200  # characters of a name
SAID = {
    "holds": "as it has to be",
    "violated": "not as it has to be",
    "undetermined": "too close to call",
    "not reached": "not reached",
}
COULD_NOT = frozenset({Kind.RESOURCE, Kind.FAULT, Kind.AMBIGUOUS, Kind.UNREAD})

Json = dict[str, object]


def gradescope(given: Given, options: Options) -> Product:
    """Return a document for each submission."""
    del options
    return Product(
        (f"gradescope/{told.row.id}.json", to_bytes(results(told))) for told in returned(given)
    )


def results(told: Returned) -> Json:
    """Return the document of one submission; its tests add up to its score."""
    row, public = told
    final = row.exact_final
    hidden = [check for check in row.result.checks if check.hidden]
    tests = [_test(check) for check in public.checks]
    tests += [_hidden(check) for check in hidden]
    shown = sum((points(check.points) for check in public.checks), NOTHING)
    unseen = (row.result.exact_mark or NOTHING) - shown
    secret = bool(hidden or public.more or abs(unseen) > NOISE)
    if secret:
        tests.append(_change(UNSEEN, unseen, "", secret=True))
    tests += [_change(s.title, s.points, s.sentence, secret=secret) for s in steps(row)]
    said: Json = {"output": _output(told), "output_format": "text"}
    if public.metrics.duration_s is not None:
        said["extra_data"] = {"duration_s": public.metrics.duration_s, "key": public.key}
    return {
        "score": number(NOTHING if final is None else final),
        **said,
        "test_output_format": "text",
        "test_name_format": "text",
        "stdout_visibility": "hidden",
        "tests": tests,
    }


def to_bytes(document: Json) -> bytes:
    """Return a document as JSON in ASCII."""
    return json_text(document).encode() + b"\n"


def said(check: Check) -> str:
    """Return what a check says, in a few words where it says nothing of its own."""
    return visible(check.message) or SAID[check.answer]


def _test(check: Check) -> Json:
    return {
        "name": _name(check.title),
        "score": number(points(check.points)),
        "max_score": number(points(check.most)),
        "status": "passed" if check.answer == "holds" else "failed",
        "output": capital(said(check)),
        "visibility": "visible",
    }


def _hidden(check: Check) -> Json:
    earned = f"{decimal(points(check.points))} of {decimal(points(check.most))} points"
    return {
        "name": _name(check.title),
        "status": "passed" if check.answer == "holds" else "failed",
        "output": f"{capital(said(check))} ({earned})",
        "visibility": "hidden",
    }


def _change(title: str, value: Fraction, sentence: str, *, secret: bool) -> Json:
    """Return points that are no check's; secret ones are shown once marks are published."""
    return {
        "name": _name(title),
        "score": number(value),
        "max_score": 0,
        "status": "failed" if value < 0 else "passed",
        "output": visible(sentence),
        "visibility": "after_published" if secret else "visible",
    }


def _name(title: str) -> str:
    return one_line(title)[:LONGEST] or "check"


def _output(told: Returned) -> str:
    row, public = told
    if row.result.kind in COULD_NOT and row.final is None:
        return "This submission could not be marked by the autograder: ask your teacher."
    lines = [f"{capital(one_line(public.cause))}."]
    if public.hint:
        lines.append(f"Hint: {one_line(public.hint)}")
    if public.more:
        lines.append(f"{public.more} more checks are made that are not shown.")
    lines += said_by_graders(row)
    lines += unsure(row)
    return visible("\n".join(lines))
