"""results.json of Gradescope: what an autograder answers about one submission.

Checks that students see come from their own result, at points of their own; what hidden checks make
of the mark is in tests that are hidden, so Gradescope hides the total as well until marks are
published. Nothing of another student is in the file, and nothing that names a machine.
"""

from fractions import Fraction

from vrts.marking.exports.given import Given, Options, Product, Returned, returned
from vrts.marking.exports.numbers import number, points
from vrts.marking.exports.steps import NOTHING, steps
from vrts.marking.result import Check, Kind
from vrts.report.json_text import json_text
from vrts.report.plain import capital, one_line, visible

NAMES_OF_UNSEEN = "difference made by hidden checks and scenes"
LONGEST = 200  # characters of a name
SAID = {
    "holds": "as it has to be",
    "violated": "not as it has to be",
    "undetermined": "too close to call",
    "not reached": "not reached",
}
COULD_NOT = frozenset({Kind.RESOURCE, Kind.FAULT, Kind.AMBIGUOUS})

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
    tests = [_test(check, hidden=False) for check in public.checks]
    tests += [_test(check, hidden=True) for check in row.result.checks if check.hidden]
    shown = sum((points(check.points) for check in public.checks), NOTHING)
    shown += sum((points(check.points) for check in row.result.checks if check.hidden), NOTHING)
    unseen = (row.result.exact_mark or NOTHING) - shown
    if abs(unseen) > Fraction(1, 10_000):
        tests.append(_change(NAMES_OF_UNSEEN, unseen, "", hidden=True))
    tests += [_change(step.title, step.points, step.sentence) for step in steps(row)]
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


def _test(check: Check, *, hidden: bool) -> Json:
    return {
        "name": _name(check.title),
        "score": number(points(check.points)),
        "max_score": number(points(check.most)),
        "status": "passed" if check.answer == "holds" else "failed",
        "output": capital(said(check)),
        "visibility": "hidden" if hidden else "visible",
    }


def _change(title: str, value: Fraction, sentence: str, *, hidden: bool = False) -> Json:
    return {
        "name": _name(title),
        "score": number(value),
        "max_score": 0,
        "status": "failed" if value < 0 else "passed",
        "output": visible(sentence),
        "visibility": "hidden" if hidden else "visible",
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
    return visible("\n".join(lines))
