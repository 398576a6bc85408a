"""The page of two programs: evidence in words, both sources, and both replays side by side."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.marking.similarity.groups import Evidence, Group, Link
from vrts.marking.similarity.symbols import readable
from vrts.report.page.document import POLICY, document_parts
from vrts.report.page.html import Child, Markup, element, joined, prose, raw
from vrts.report.plain import one_line, shown
from vrts.web.assets import asset

STYLE = "report/similarity.css"
FRAMES = f"{POLICY}; frame-src file: 'self'"  # both reports stand in files beside this one
MOST_LINES = 2_000  # of a program
LONGEST_LINE = 1_000  # characters of a line
MOST_MARKS = 3  # numbers of evidence beside a line
SAYS = (
    "Two programs may be alike because of one textbook, one lab, one teacher, or help that was"
    " allowed. Read both programs, and hear both students. Likeness changes no mark."
)
CHANCE = (
    "0.50 is what one pair would reach by chance among all that were compared, other folders too"
)
KINDS = {
    "motion": "Motion",
    "steps": "Steps",
    "numbers": "Numbers",
    "words": "Words and layout",
    "text": "Text",
    "offsets": "Distances",
    "manner": "Manner",
    "lines": "Lines",
}


class Side(NamedTuple):
    """One of the two programs."""

    identifier: str
    label: str  # its student, as shown
    data: bytes
    report: str | None  # address of its report, from the page; None: there is none


def pair_page(
    link: Link, group: Group, evidence: Sequence[Evidence], sides: tuple[Side, Side], title: str
) -> str:
    """Return the page of two programs.

    Args:
        link: The pair.
        group: That it is in.
        evidence: What they share, what weighs most first.
        sides: Both programs, in the order of the link.
        title: Of the class.
    """
    first, second = (one_line(side.label) for side in sides)
    strength = f"{link.strength} ({link.score:.2f}; {CHANCE})"
    others = [one for one in group.members if one not in (link.first, link.second)]
    head = element(
        "header",
        element("h1", f"{first} and {second}"),
        element("p", f"{one_line(title)}; {strength}", class_="where"),
        element("p", element("b", "Not a verdict. "), SAYS, class_="notice"),
        _same_person(sides),
        element("p", "Others in this group: ", one_line(", ".join(others))) if others else None,
        element("p", element("a", "All groups", href="../similarity.html")),
        class_="first-screen",
    )
    marks = _marks(evidence)
    body: list[Child] = [
        head,
        _evidence(evidence),
        _replays(sides),
        _sources(sides, marks),
        element("footer", element("p", "Written by vrts")),
    ]
    scripts: list[Markup] = []
    if any(side.report for side in sides):
        scripts.append(raw("script", asset("report/pair.js")))
    parts = document_parts(f"{first} and {second}", STYLE, body, *scripts, policy=FRAMES)
    return "".join(parts)


def _same_person(sides: tuple[Side, Side]) -> Markup | None:
    first, second = (side.identifier.rpartition("/")[2] for side in sides)
    if first != second:
        return None
    return element(
        "p",
        "Both have the same identifier: perhaps it is the same person, who hands in again.",
        class_="notice",
    )


def _evidence(evidence: Sequence[Evidence]) -> Markup:
    if not evidence:
        return element(
            "section", element("h2", "What both have"), element("p", "Many small things.")
        )
    heads = ("No.", "What", "Both have", "Lines", "Others with it", "Weight")
    rows = [
        element(
            "tr",
            element("td", str(number), class_="number", id=f"e{number}"),
            element("td", KINDS.get(one.what, one.what)),
            element("td", prose(_sentence(one.words))),
            element("td", _lines(one)),
            element("td", str(one.others) if one.others else "nobody"),
            element("td", f"{one.weight:.1f}"),
        )
        for number, one in enumerate(evidence, start=1)
    ]
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    table = element("table", element("thead", head), element("tbody", *rows), class_="evidence")
    return element(
        "section",
        element("h2", "What both have", id="evidence-head"),
        element(
            "p",
            "What few others have comes first. The weight is the logarithm of how seldom it is.",
            class_="where",
        ),
        element(
            "div",
            table,
            class_="wide",
            role="region",
            tabindex="0",
            aria_labelledby="evidence-head",
        ),
    )


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:]


def _lines(one: Evidence) -> Markup | str:
    if not one.first_line or not one.second_line:
        return "–"
    return joined(
        [
            element("a", str(one.first_line), href=f"#a{one.first_line}"),
            " and ",
            element("a", str(one.second_line), href=f"#b{one.second_line}"),
        ]
    )


def _replays(sides: tuple[Side, Side]) -> Markup | None:
    if not any(side.report for side in sides):
        return None
    columns = [
        element(
            "iframe",
            src=f"{side.report}#framed=1&t=0",
            class_="replay",
            title=f"Replay of {one_line(side.label)}",
        )
        if side.report
        else element("p", "There is no replay of this program here.", class_="where")
        for side in sides
    ]
    bar = element(
        "div",
        element("button", "Play both", type="button", id="both-play"),
        element(
            "input",
            type="range",
            id="both-time",
            min="0",
            max="0",
            step="0.01",
            value="0",
            aria_label="Time of both replays in seconds",
        ),
        element("output", "0.0 s", id="both-clock"),
        id="both",
        hidden=True,
    )
    links = [
        element("p", element("a", f"Report of {one_line(side.label)}", href=side.report))
        if side.report
        else element("p", "")
        for side in sides
    ]
    return element(
        "section",
        element("h2", "Both replays"),
        bar,
        element("div", *columns, class_="sides replays"),
        element("div", *links, class_="sides"),
    )


def _marks(evidence: Sequence[Evidence]) -> tuple[dict[int, list[int]], dict[int, list[int]]]:
    """Return the numbers of evidence beside each line, of both programs."""
    found: tuple[defaultdict[int, list[int]], ...] = (defaultdict(list), defaultdict(list))
    for number, one in enumerate(evidence, start=1):
        for side, line in zip(found, (one.first_line, one.second_line), strict=True):
            if line:
                side[line].append(number)
    return dict(found[0]), dict(found[1])


def _sources(
    sides: tuple[Side, Side], marks: tuple[Mapping[int, list[int]], Mapping[int, list[int]]]
) -> Markup:
    columns = [
        _source(side, lines, letter)
        for side, lines, letter in zip(sides, marks, ("a", "b"), strict=True)
    ]
    return element(
        "section",
        element("h2", "Both programs"),
        element("p", "A number beside a line leads to what both have there.", class_="where"),
        element("div", *columns, class_="sides replays"),
    )


def _source(side: Side, marks: Mapping[int, list[int]], letter: str) -> Markup:
    file = readable(side.data, side.identifier)
    if file is None:
        return element("p", "This file is no text.")
    source: SourceFile = file.source
    texts = list(source.lines())
    rows = [
        element(
            "tr",
            element("th", str(number), class_="line", scope="row"),
            element("td", *_numbers(marks.get(number, ())), class_="marks"),
            element("td", element("code", shown(text[:LONGEST_LINE]).text)),
            id=f"{letter}{number}",
            class_="shared" if number in marks else None,
        )
        for number, text in enumerate(texts[:MOST_LINES], start=1)
    ]
    more = len(texts) - MOST_LINES
    left = element("p", f"and {more} more lines", class_="where") if more > 0 else None
    table = element("table", element("tbody", *rows), class_="code")
    name = f"Program of {one_line(side.label)}"
    whole = element("div", table, class_="whole", role="region", tabindex="0", aria_label=name)
    return element("div", element("h3", one_line(side.label)), whole, left)


def _numbers(numbers: Sequence[int]) -> list[Markup]:
    return [
        element("a", str(number), href=f"#e{number}", aria_label=f"Evidence {number}")
        for number in numbers[:MOST_MARKS]
    ]
