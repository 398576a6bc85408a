"""results.json of PrairieLearn: what an external grader answers about one submission.

The score counts everything; tests are those that the student may see, for there are no hidden ones.
What does not compile is no attempt: it is `not gradable`, with what is wrong as format errors.
"""

import re

from vrts.base.diagnostic import Severity
from vrts.marking.exports.autograders.gradescope import said, to_bytes
from vrts.marking.exports.feedback import feedback_text
from vrts.marking.exports.given import Given, Options, Page, Product, Returned, returned
from vrts.marking.exports.numbers import number, points
from vrts.marking.exports.steps import NOTHING
from vrts.marking.result import Check, Kind
from vrts.marking.submission.report_files import REPORT
from vrts.report.plain import capital, one_line, visible

LARGEST = 1_000_000  # bytes of the document; PrairieLearn takes no more
SPARE = 20_000  # bytes that are left free
MOST_IMAGES = 3
MOST_ERRORS = 20
LONGEST = 2_000  # characters of one text
NOT_GRADABLE = frozenset(
    {Kind.DOES_NOT_COMPILE, Kind.UNREADABLE, Kind.MISSING, Kind.AMBIGUOUS, Kind.UNREAD}
)

_PICTURE = re.compile(rb'src="(data:image/png;base64,[A-Za-z0-9+/]+={0,2})"')

Json = dict[str, object]


def prairielearn(given: Given, options: Options) -> Product:
    """Return a document for each submission."""
    return Product(
        (
            f"prairielearn/{told.row.id}.json",
            to_bytes(results(told, given.pages(told.row.id) if options.pages else ())),
        )
        for told in returned(given)
    )


def results(told: Returned, pages: tuple[Page, ...] = ()) -> Json:
    """Return the document of one submission, at most `LARGEST` bytes as JSON.

    Args:
        told: The row, and the student's own result.
        pages: What is there for the student; pictures are taken from the report.
    """
    row, public = told
    gradable = row.exact_final is not None and public.kind not in NOT_GRADABLE
    gradable = gradable or row.change is not None
    score = (row.exact_final or NOTHING) / row.result.exact_total
    document: Json = {
        "gradable": gradable,
        "score": number(score if gradable else NOTHING),
        "message": _text(capital(public.cause)),
        "output": _text(feedback_text(told).decode()),
    }
    if not gradable:
        document["format_errors"] = _errors(told)
        return document
    document["tests"] = [_test(check) for check in public.checks if check.kind != "rounding"]
    images = _images(pages, LARGEST - SPARE - len(to_bytes(document)))
    if images:
        document["images"] = images
    return document


def _test(check: Check) -> Json:
    return {
        "name": _text(one_line(check.title)),
        "points": number(points(check.points)),
        "max_points": number(points(check.most)),
        "message": _text(capital(said(check))),
    }


def _errors(told: Returned) -> list[str]:
    _, public = told
    found = [
        f"line {finding.line}: {one_line(finding.headline)}"
        if finding.line is not None
        else one_line(finding.headline)
        for finding in public.findings
        if finding.severity is Severity.ERROR
    ]
    texts = found[:MOST_ERRORS] or [one_line(public.cause)]
    return [_text(text) for text in texts]


def _images(pages: tuple[Page, ...], room: int) -> list[Json]:
    """Return pictures of the student's report, as many as there is room for."""
    images: list[Json] = []
    for page in pages:
        if page.name != REPORT:
            continue
        for match in _PICTURE.finditer(page.data):
            url = match[1].decode("ascii")
            room -= len(url) + 200
            if room < 0 or len(images) == MOST_IMAGES:
                return images
            images.append({"label": f"Picture {len(images) + 1} of the run", "url": url})
    return images


def _text(text: str) -> str:
    return visible(text)[:LONGEST]
