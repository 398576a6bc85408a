"""Assessments made by hand from the records, for tests of reports."""

from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, error
from vrts.base.pose import translation
from vrts.base.source import SourceFile, Span
from vrts.base.units import DEG
from vrts.check.mark.grade import Grade, Loss, Status
from vrts.check.rules.scheme import MarkScheme
from vrts.check.task.goals import Goal
from vrts.check.task.task import Task
from vrts.ir.module import Module
from vrts.report.assessment import Assessment

HOSTILE = "</script><img src=x onerror=alert(1)>\"'&\u2028\u2029\u202e\x1b[31m\x00`<!--]]>"

SYNTAX = Rule("V101", "syntax")

SOURCE = SourceFile(
    "submission-07.v2",
    '.PROGRAM sort()\n\tMOVES base2_put\n\tTYPE "done" ; all of it\n.END\n',
)

TASK = Task(
    name="cans-on-bases",
    title="Two cans on two bases",
    scene="cans-on-bases",
    program=None,
    goals=(Goal("can1", translation(1, 0, 0), 0.01, 5 * DEG, Fraction(1), "can1 on base2", None),),
    vias=(),
    ordered=True,
    t_par=20.0,
    t_max=40.0,
    mark=MarkScheme(),
    digest="0" * 64,
)


def span(text: str, source: SourceFile = SOURCE) -> Span:
    """Return the span of the first occurrence of a text."""
    start = source.text.index(text)
    return Span(source, start, start + len(text))


def grade(*losses: Loss, status: Status = Status.GRADED, ready: bool = False) -> Grade:
    """Return the grade that some losses leave, parts of the mark at nothing."""
    nothing = Fraction(0)
    mark = Fraction(10) - sum((loss.points for loss in losses), nothing)
    return Grade(mark, status, nothing, nothing, nothing, nothing, losses, ready, (), 13.4)


def contact_loss(points: Fraction = Fraction(3, 2)) -> Loss:
    """Return the loss of the example in the issue."""
    moment = Moment(12.4, (0.0, -90 * DEG, 90 * DEG, 0.0, 0.0, 0.0, 0.06), ("can1", "base1"))
    return Loss(
        points,
        "contact",
        "at 12.4 s, line 2 `MOVES base2_put`, the held can1 hits base1",
        "how high is the underside of the can on its way?",
        span("MOVES base2_put"),
        moment,
    )


def compiled(assessed: Grade | None = None) -> Assessment:
    """Return a program that compiles, with a grade but no run."""
    return Assessment(
        "submission-07", "submission-07.v2", SOURCE, (), Module({}, ()), None, TASK, grade=assessed
    )


def broken(*diagnostics: Diagnostic, title: str = "broken.v2") -> Assessment:
    """Return a program that does not compile."""
    found = diagnostics or (
        error(SYNTAX, "unexpected `THEN`", Label(span("TYPE"), "here"), help=("begin with IF",)),
    )
    loss = Loss(Fraction(10), "program", "the program does not compile", "", None, None)
    return Assessment(
        "broken",
        title,
        SOURCE,
        found,
        task=TASK,
        grade=grade(loss, status=Status.DOES_NOT_COMPILE),
    )
