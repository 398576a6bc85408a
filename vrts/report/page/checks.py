"""The checks of a page: every answer, how the mark is made, and what a person has to look at."""

from collections.abc import Collection, Sequence
from fractions import Fraction

from vrts import __version__
from vrts.check.mark.grade import Grade
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.demand_check import DEMAND
from vrts.controllers.values import digest
from vrts.report.assessment import Assessment
from vrts.report.audience import needs_review
from vrts.report.page.buttons import watch_button
from vrts.report.page.html import Markup, element, prose
from vrts.report.page.replay_data import contact_sentence
from vrts.report.plain import capital, one_line
from vrts.report.quantities import MINUS, full, mark, points

HIDDEN, REVIEWED = "hidden", "review"


def checks_section(a: Assessment, hidden: Collection[str]) -> Markup | None:
    """Return every answer, the sum of the mark, and why a program is not ready.

    Args:
        a: What was found.
        hidden: Names of the checks that students do not see.
    """
    if a.judgement is None:
        return None
    head = element("tr", *(element("th", t, scope="col") for t in ("Check", "Answer", "Because")))
    rows = [_check_row(a, v, hidden) for v in a.judgement.verdicts]
    table = element("table", element("thead", head), element("tbody", *rows), class_="checks")
    return element(
        "section",
        element("h2", "Checks"),
        element("div", table, _sum(a), class_="pair"),
        _obstacles(a.grade),
        id="checks",
    )


def _check_row(a: Assessment, v: Verdict, hidden: Collection[str]) -> Markup:
    assert a.judgement is not None
    report = a.judgement.collisions
    disputed = v.check == "collision" and report is not None and bool(report.disagreements)
    tags = [HIDDEN] if v.check in hidden else []
    tags += [REVIEWED] if disputed or v.answer is Answer.UNDETERMINED else []
    worth = v.evidence.get("points", 0.0) if v.check.startswith(DEMAND) else 0.0
    cost = f" (worth {worth:.1f})" if isinstance(worth, float) and worth else None
    return element(
        "tr",
        element("th", one_line(v.check), *map(_tag, tags), scope="row"),
        element("td", v.answer.value, class_=f"answer-{v.answer.value}"),
        element("td", prose(capital(one_line(v.summary))), cost),
    )


def _tag(word: str) -> Markup:
    return element("span", word, class_=f"tag {word}")


def _sum(a: Assessment) -> Markup | None:
    """Return the parts that add up to the mark."""
    task, grade = a.task, a.grade
    if task is None or grade is None or grade.shown is None:
        return None
    shown, most = grade.shown, grade.shown.most
    name = "Goals" if task.targets else "Coming to the end"
    parts = [(name, shown.targets, f"of {points(most.targets)}")] if most.targets else []
    parts += [("Via points", shown.vias, f"of {points(most.vias)}")] if task.vias else []
    parts += [("Limits of the robot", -shown.limits, "")] if shown.limits else []
    parts += [("Contacts and drops", -shown.contacts, f"at most {_signed(-task.mark.contact_cap)}")]
    parts += [("Demands", -shown.demands, "")] if task.costs else []
    parts += [("Time", shown.time, f"of {points(most.time)}")]
    rows = [
        element(
            "tr",
            element("th", name, scope="row"),
            element("td", _signed(value), class_="number"),
            element("td", most, class_="of"),
        )
        for name, value, most in parts
    ]
    total = element(
        "tr",
        element("th", "Mark", scope="row"),
        element("td", mark(grade.mark), class_="number"),
        element("td", f"of {full(grade.total)}", class_="of"),
        class_="total",
    )
    caption = element("caption", "How the mark adds up")
    return element("table", caption, element("tbody", *rows, total), class_="sum")


def _signed(value: Fraction) -> str:
    return (MINUS if value < 0 else "") + points(abs(value))


def _obstacles(grade: Grade | None) -> Markup | None:
    if grade is None or not grade.obstacles:
        return None
    items = [element("li", prose(capital(one_line(o)))) for o in grade.obstacles]
    return element(
        "div",
        element("h3", "Why it is not ready for the real robot"),
        element("ul", *items),
        class_="obstacles",
    )


def review_section(a: Assessment) -> Markup | None:
    """Return what those who mark have to decide; None when nothing is open."""
    if not needs_review(a):
        return None
    report = a.judgement.collisions if a.judgement else None
    doubtful = [
        element("li", contact_sentence(c), " ", watch_button(c.deepest_s))
        for c in (report.undetermined if report else ())
    ]
    doubtful += [
        element("li", prose(capital(one_line(d.headline))), " ", watch_button(d.moment.time_s))
        for v in (a.judgement.verdicts if a.judgement else ())
        if v.answer is Answer.UNDETERMINED and v.check != "collision"
        for d in v.findings
        if d.moment is not None
    ]
    disputed = [
        element("li", one_line(words)) for words in (report.disagreements if report else ())
    ]
    return element(
        "section",
        element("h2", "To be reviewed"),
        _range(a.grade),
        _list("Too close to tell; no points were taken", doubtful),
        _list("The second engine disagrees; the verdict stands until reviewed", disputed),
        id="review",
        class_="box review-box",
    )


def _range(grade: Grade | None) -> Markup | None:
    """Return the lowest and the highest mark, and a bar of them from 0 to the total."""
    if grade is None or grade.lowest is None:
        return None
    low, high = grade.lowest, grade.mark
    left, right = (100 * float(end / grade.total) for end in (low, high))
    bar = element("i", style=f"left:{left:.0f}%;right:{100 - right:.0f}%")
    return element(
        "p",
        "Lowest mark ",
        element("b", mark(low)),
        ", if every open point counts against the program; highest mark ",
        element("b", mark(high)),
        ", the one that is given.",
        element("span", bar, class_="range", aria_hidden="true"),
    )


def _list(title: str, items: Sequence[Markup]) -> Markup | None:
    return element("div", element("h3", title), element("ul", *items)) if items else None


def facts_section(a: Assessment) -> Markup:
    """Return what an appeal asks for: methods, engines, numbers of the search, versions, hashes."""
    rows: list[tuple[str, str]] = [("vrts", __version__)]
    report = a.judgement.collisions if a.judgement else None
    if report is not None:
        rows += [("distances", f"proven; proposed by {report.engine}")]
        rows += [(name, f"{count:,}") for name, count in report.statistics.items()]
        rows += [("second engine disagrees", str(len(report.disagreements)))]
    for v in a.judgement.verdicts if a.judgement else ():
        method = v.evidence.get("method")
        rows += [(v.check, str(method))] if method is not None else []
    if a.run is not None:
        rows += [("motions", str(len(a.run.motions)))]
        rows += [("pieces of motion", str(len(a.run.timeline.segments)))]
    rows += [("scene sha256", a.scene.digest)] if a.scene else []
    if a.scene is not None:
        model = a.scene.controller
        rows += [("controller model", model.name), ("controller sha256", digest(model))]
    rows += [("task sha256", a.task.digest)] if a.task else []
    pairs = [
        element("div", element("dt", one_line(name)), element("dd", one_line(value)))
        for name, value in rows
    ]
    return element(
        "section", element("h2", "Facts for an appeal"), element("dl", *pairs), id="facts"
    )
