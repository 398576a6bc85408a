"""The first screen as HTML."""

import base64
from fractions import Fraction

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.because import because
from vrts.report.first_screen import FirstScreen
from vrts.report.page.buttons import moment_button, watch_button
from vrts.report.page.causes import causes_fold
from vrts.report.page.html import Markup, element, prose
from vrts.report.plain import capital, one_line, yes_no
from vrts.report.quantities import full, lost, mark, when

HIGH, MIDDLE = Fraction(8, 10), Fraction(5, 10)  # shares of the total from which a mark is so


def first_screen_section(
    a: Assessment,
    screen: FirstScreen,
    picture: bytes | None,
    *,
    review: bool = False,
    more: int = 0,
    level: Hints = Hints.EDIT,
) -> Markup:
    """Return the head of the page.

    Args:
        a: What was found.
        screen: What of it is shown first.
        picture: A PNG of the moment.
        review: Whether a person has to look at the run.
        more: How many further checks there will be at marking.
        level: How much of what led to the losses may be told.
    """
    task = f"{a.task.title} · " if a.task else ""
    scene = f"scene {a.scene.name}" if a.scene else ""
    where = element("p", f"{task}{scene}", class_="where") if task or scene else None
    answer = element(
        "div",
        mark_badge(screen),
        element(
            "p",
            "Ready for the real robot: ",
            element("b", yes_no(screen.ready)),
            f", in {screen.ready_in}" if screen.ready else None,
            f": {screen.why_not}" if screen.why_not else None,
            class_="ready " + yes_no(screen.ready),
        ),
        element("p", "To be reviewed by a person", class_="ready maybe") if review else None,
        class_="answer",
    )
    parts = element(
        "div",
        element("h1", one_line(a.title)),
        where,
        answer,
        element("h2", prose(screen.cause), class_="cause"),
        _hint(screen.hint) if screen.hint else None,
        _loss_table(a, screen, level) if screen.losses else _verdict_table(screen),
        _more(screen, more) if more else None,
        class_="words",
    )
    return element("header", parts, _picture(screen, picture), class_="first-screen")


def _hint(text: str) -> Markup:
    return element("p", element("b", "Hint: "), prose(text), class_="hint")


def _more(screen: FirstScreen, more: int) -> Markup:
    passed = "All public checks passed" if screen.ready else "Not all public checks passed"
    return element("p", f"{passed}; {more} more at marking.", class_="more")


def mark_badge(screen: FirstScreen) -> Markup:
    """Return the mark, or the status where there is none."""
    if screen.mark is None:
        return element("p", element("b", screen.status), class_="mark word")
    share = screen.mark / screen.total
    level = "high" if share >= HIGH else "middle" if share >= MIDDLE else "low"
    status = element("span", screen.status, class_="status") if screen.status != "graded" else None
    return element(
        "p",
        element("b", mark(screen.mark)),
        element("span", f"/ {full(screen.total)}"),
        status,
        class_=f"mark {level}",
    )


def _loss_table(a: Assessment, screen: FirstScreen, level: Hints) -> Markup:
    assert screen.mark is not None
    chains = because(a) if level is not Hints.NOTHING else ()
    folds = [causes_fold(chain, level, unfolded=k == 0) for k, chain in enumerate(chains)]
    folds += [None] * (len(screen.losses) - len(folds))
    rows: list[Markup] = []
    for loss, fold in zip(screen.losses, folds, strict=True):
        button = moment_button(loss.moment) if loss.moment else None
        cells = (
            element("td", lost(loss.points), class_="number"),
            element("td", prose(capital(one_line(loss.sentence)))),
            element("td", button, class_="act"),
        )
        rows.append(element("tr", *cells))
        if fold is not None:
            rows.append(element("tr", element("td", fold, colspan=3), class_="causes"))
    total = element(
        "tr",
        element("td", mark(screen.mark), class_="number"),
        element("th", f"Mark, of {full(screen.total)}", scope="row", colspan=2),
        class_="total",
    )
    head = element("tr", *(element("th", t, scope="col") for t in ("Points", "Lost by", "Moment")))
    return element(
        "table",
        element("thead", head),
        element("tbody", *rows, total),
        class_="losses",
        aria_label="Points lost, costliest first",
    )


def _verdict_table(screen: FirstScreen) -> Markup | None:
    if not screen.verdicts:
        return None
    rows = [
        element(
            "tr",
            element("td", v.answer.value, class_=f"answer-{v.answer.value}"),
            element("td", one_line(v.check)),
            element("td", prose(one_line(v.summary))),
        )
        for v in screen.verdicts
    ]
    head = element("tr", *(element("th", t, scope="col") for t in ("Answer", "Check", "Because")))
    return element("table", element("thead", head), element("tbody", *rows), class_="losses")


def _picture(screen: FirstScreen, picture: bytes | None) -> Markup | None:
    if picture is None:
        return None
    caption = capital(when(screen.moment)) if screen.moment else "The scene"
    source = "data:image/png;base64," + base64.b64encode(picture).decode("ascii")
    image = element("img", src=source, alt=f"{caption}. {screen.cause}", class_="still")
    button = watch_button(screen.moment.time_s, "Watch this moment") if screen.moment else None
    return element("figure", image, element("figcaption", caption + " ", button), class_="moment")
