"""JUnit XML: one suite for each submission, one case for each check, for those who mark.

There is no standard: this is the part that Jenkins, GitLab and GitHub's actions all read. A check
that does not hold is a `failure`, a fault of ours or of the machine an `error`, and what was not
reached is `skipped`.
"""

from xml.etree.ElementTree import Element, SubElement, indent, tostring

from vrts.marking.exports.feedback import said_by_graders
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.exports.numbers import decimal, points
from vrts.marking.result import Check, Kind
from vrts.marking.row import Row
from vrts.report.plain import bare_name, one_line, visible

NAME = "junit.xml"
PROGRAM = "program"  # the case about the submission as such
BECAUSE = {
    Kind.DOES_NOT_COMPILE: "failure",
    Kind.STOPPED: "failure",
    Kind.LIMIT: "failure",
    Kind.UNREADABLE: "failure",
    Kind.RESOURCE: "error",
    Kind.AMBIGUOUS: "error",
    Kind.UNREAD: "error",
    Kind.FAULT: "error",
    Kind.MISSING: "skipped",
    Kind.EXCUSED: "skipped",
}


def junit(given: Given, options: Options) -> Product:
    """Return the document of a class."""
    del options
    root = Element("testsuites", name=one_line(given.whole.title))
    suites = [_suite(root, row) for row in given.whole.rows]
    for count in ("tests", "failures", "errors", "skipped"):
        root.set(count, str(sum(int(suite.get(count, "0")) for suite in suites)))
    indent(root)
    return Product([(NAME, tostring(root, "utf-8", xml_declaration=True) + b"\n")])


def _suite(root: Element, row: Row) -> Element:
    result = row.result
    suite = SubElement(root, "testsuite", name=one_line(row.id))
    properties = SubElement(suite, "properties")
    final = row.exact_final
    for name, value in (
        ("final mark", "" if final is None else decimal(final, least=1)),
        ("status", result.kind.value),
        ("file", "" if result.program is None else one_line(bare_name(result.program.name))),
        ("key", result.key),
        ("unsafe", ", ".join(dict.fromkeys(doubt.reason.value for doubt in row.unsafe))),
        ("graders", "; ".join(said_by_graders(row))),
    ):
        SubElement(properties, "property", name=name, value=value)
    took = result.metrics.duration_s
    if result.kind is not Kind.GRADED:
        _say(_case(suite, row, PROGRAM), BECAUSE[result.kind], result.kind.value, result.cause)
    for check in result.checks:
        if check.kind != "rounding":
            _checked(suite, row, check)
    cases = suite.findall("testcase")
    suite.set("tests", str(len(cases)))
    for count, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped")):
        suite.set(count, str(sum(case.find(tag) is not None for case in cases)))
    suite.set("time", "0" if took is None else repr(took))
    return suite


def _checked(suite: Element, row: Row, check: Check) -> None:
    case = _case(suite, row, check.title)
    earned = f"{decimal(points(check.points))} of {decimal(points(check.most))} points"
    match check.answer:
        case "holds":
            return
        case "not reached":
            _say(case, "skipped", "not reached", check.message)
        case "violated":
            _say(case, "failure", check.kind, f"{check.message} ({earned})".strip())
        case "undetermined":
            _say(case, "failure", "undetermined", f"{check.message} ({earned})".strip())


def _case(suite: Element, row: Row, title: str) -> Element:
    name = one_line(title) or "check"
    return SubElement(suite, "testcase", classname=one_line(row.id), name=name, time="0")


def _say(case: Element, tag: str, kind: str, text: str) -> None:
    message = one_line(text)
    if tag == "skipped":
        SubElement(case, tag, message=message)
    else:
        SubElement(case, tag, message=message, type=kind).text = visible(text)
