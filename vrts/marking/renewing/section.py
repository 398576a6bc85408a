"""The section "From your graders" of a page about a submission: made, put in, replaced, taken out.

Pages are written before anybody decides anything, so the section is put into them afterwards,
between two marks that nothing foreign can contain: whatever is foreign in a page is escaped.
"""

from collections.abc import Iterator
from fractions import Fraction

from vrts.marking.by_hand.decisions.words import due_words, signed
from vrts.marking.exports.feedback import SAID
from vrts.marking.row import Decided, Given, Told
from vrts.report.page.buttons import watch_button
from vrts.report.page.html import Child, Markup, element
from vrts.report.plain import one_line
from vrts.report.quantities import seconds

BEGIN, END = b"<!--from-graders-->", b"<!--/from-graders-->"
NAVIGATION = b'<nav aria-label="On this page">'
END_OF_NAVIGATION = b"</nav>"
REPLAY = b'id="replay"'


def with_section(page: bytes, decided: Decided | None, *, staff: bool, final: str = "") -> bytes:
    """Return a page with the section of these decisions, and no other.

    Args:
        page: As marking wrote it, or as this has returned it.
        decided: About the submission; None: nothing.
        staff: Whether it is for those who mark: they also see what is in conflict or has lapsed.
        final: The final mark, told where graders changed the computed one; "": there is none.
    """
    plain = _without(page)
    section = "" if decided is None else _section(_Page(plain), decided, final, staff=staff)
    if not section:
        return plain
    place = plain.find(NAVIGATION)
    place = plain.find(END_OF_NAVIGATION, place) + len(END_OF_NAVIGATION) if place >= 0 else -1
    if place < 0:
        place = max(plain.rfind(b"<footer>"), 0)
    return b"".join((plain[:place], BEGIN, section.encode(), END, plain[place:]))


def _without(page: bytes) -> bytes:
    first = page.find(BEGIN)
    last = page.find(END, first)
    return page if first < 0 or last < 0 else page[:first] + page[last + len(END) :]


class _Page:
    """What a page has to be linked to."""

    def __init__(self, page: bytes) -> None:
        self._page = page
        self._replay = REPLAY in page

    def place(self, line: int | None, time_s: float | None) -> Markup | None:
        """Return where something belongs: `report/comments_read.js` shows it there, too."""
        if line is None and time_s is None:
            return None
        told = None if time_s is None else seconds(time_s)
        return element(
            "span", *self._links(line, time_s), class_="place", data_line=line, data_t=told
        )

    def _links(self, line: int | None, time_s: float | None) -> Iterator[Child]:
        """Yield a line, linked to the program, and a moment, linked to the replay."""
        if line is not None:
            there = f'id="L{line}"'.encode() in self._page
            words = f"line {line}"
            yield element("a", words, href=f"#L{line}") if there else element("span", words)
            yield " "
        if time_s is not None:
            yield watch_button(time_s) if self._replay else element("span", f"{time_s:.1f} s")
            yield " "


def _section(page: _Page, decided: Decided, final: str, *, staff: bool) -> Markup | str:
    items = [_item(page, item) for item in decided.items]
    items += [_comment(page, comment) for comment in decided.comments]
    if decided.excused:
        items.append(element("li", "Excused: ", element("bdi", one_line(decided.excused))))
    if decided.due:
        items.append(element("li", f"Time until {due_words(decided.due)}"))
    if final and decided.steps:
        items.append(element("li", element("b", f"Final mark: {final}")))
    if staff:
        again = (decided.again,) if decided.again else ()
        told = (*decided.conflicts, *decided.lapsed, *again)
        items += [
            element("li", element("b", "Not settled: "), element("bdi", one_line(text)))
            for text in told
        ]
    if not items:
        return ""
    heading = element("h2", SAID, id="graders-head")
    listed = element("ul", *items)
    return element("section", heading, listed, id="graders", aria_labelledby="graders-head")


def _item(page: _Page, item: Given) -> Markup:
    places = [page.place(*place) for place in item.places]
    points = element("b", signed(Fraction(item.points)), class_="points")
    words = element("span", one_line(item.title), class_="words", dir="auto")
    return element("li", points, " ", words, " ", *places, _who(item.who))


def _comment(page: _Page, comment: Told) -> Markup:
    lines = comment.text.splitlines() or [""]
    text: list[Child] = []
    for number, line in enumerate(lines):
        text += [element("br")] if number else []
        text.append(one_line(line))
    place = page.place(comment.line, comment.time_s)
    words = element("span", *text, class_="words", dir="auto")
    return element("li", place, words, " ", _who(comment.who))


def _who(name: str) -> Markup:
    return element("small", one_line(name), dir="auto")
