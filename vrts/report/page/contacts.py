"""The contacts of a page: a picture and every fact of each, then what was only close."""

import base64
from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.check.verdict import CollisionReport, ContactEvent
from vrts.engine.memory.events import Cause
from vrts.report.assessment import Assessment
from vrts.report.page.buttons import watch_button
from vrts.report.page.html import Markup, element, joined
from vrts.report.page.replay_data import contact_sentence, near_sentence
from vrts.report.page.replay_lanes import line_of
from vrts.report.page.stills import contact_name, contacts_of, worst_first
from vrts.report.plain import one_line
from vrts.report.quantities import MINUS, millimetres, seconds

MOST_CARDS = 12
MOST_CLOSE = 60  # rows of what was only close


def contacts_section(a: Assessment, stills: Mapping[str, bytes]) -> Markup | None:
    """Return a card for each of the deepest contacts and a table of close calls.

    Args:
        a: What was found.
        stills: PNG pictures by `contact_name`; the page's viewer draws the others.
    """
    worst = worst_first(contacts_of(a))
    cards = [_card(a, number, c, stills) for number, c in worst[:MOST_CARDS]]
    more = len(worst) - len(cards)
    rest = element("p", f"{more} more contacts are in the list of events.") if more > 0 else None
    close = _close_calls(a)
    if not cards and close is None:
        return None
    return element(
        "section",
        element("h2", "Contacts and close calls"),
        element("div", *cards, class_="cards") if cards else None,
        rest,
        close,
        id="contacts",
    )


def _card(a: Assessment, number: int, c: ContactEvent, stills: Mapping[str, bytes]) -> Markup:
    sentence = contact_sentence(c)
    x, y, z = (millimetres(value) for value in c.point)
    line = line_of(c.cause.span if c.cause else None, a.source)
    facts = [
        ("From", f"{seconds(c.start_s):.3f} to {seconds(c.end_s):.3f} s"),
        ("Deepest", f"{millimetres(c.depth_m):.2f} mm at {seconds(c.deepest_s):.3f} s"),
        ("Where", f"{x:.0f}, {y:.0f}, {z:.0f} mm".replace("-", MINUS)),
        ("Held", one_line(c.held) if c.held else "nothing"),
    ]
    pairs = [element("div", element("dt", name), element("dd", text)) for name, text in facts]
    if line:
        link = element("a", f"line {line}", href=f"#L{line}")
        pairs.append(element("div", element("dt", "Program"), element("dd", link)))
    return element(
        "article",
        _picture(number, sentence, stills.get(contact_name(number))),
        element("h3", sentence),
        element("dl", *pairs),
        element("p", watch_button(c.start_s, f"Watch at {c.start_s:.1f} s"), class_="act"),
        class_="card",
    )


def _picture(number: int, sentence: str, still: bytes | None) -> Markup:
    if still is not None:
        source = "data:image/png;base64," + base64.b64encode(still).decode("ascii")
        return element("img", src=source, alt=f"Picture: {sentence}", class_="still")
    label = f"Picture: {sentence}"
    return element(
        "canvas",
        width=480,
        height=360,
        role="img",
        aria_label=label,
        class_="still",
        hidden=True,
        data_contact=number,
    )


class Close(NamedTuple):
    """A row of the table of what was only close."""

    time_s: float
    what: str
    words: str
    cause: Cause | None


def _close_calls(a: Assessment) -> Markup | None:
    """Return near misses, touches too shallow to count, and what is too close to tell."""
    report = a.judgement.collisions if a.judgement else None
    if report is None:
        return None
    found = [Close(m.nearest_s, "near miss", near_sentence(m), m.cause) for m in report.near_misses]
    found += [
        Close(c.deepest_s, what, contact_sentence(c), c.cause)
        for what, contacts in (
            ("graze, costs nothing", report.grazes),
            ("too close to tell", report.undetermined),
        )
        for c in contacts
    ]
    if not found:
        return None
    found.sort(key=lambda row: row.time_s)
    heads = ("Time", "What", "Between", "Line")
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    body = [_close_row(row, a.source) for row in found[:MOST_CLOSE]]
    table = element("table", element("thead", head), element("tbody", *body), class_="close")
    more = len(found) - MOST_CLOSE
    rest = element("p", f"{more} more are in the list of events.") if more > 0 else None
    return joined([element("h3", "Close calls"), table, rest, _threshold(report)])


def _threshold(report: CollisionReport) -> Markup | None:
    if not report.near_misses or report.near_miss_m is None:
        return None
    said = "assumed, since the task names none" if report.near_miss_assumed else "as the task says"
    words = f"A near miss is nearer than {millimetres(report.near_miss_m):g} mm: {said}."
    return element("p", words, class_="when")


def _close_row(row: Close, source: SourceFile | None) -> Markup:
    line = line_of(row.cause.span if row.cause else None, source)
    return element(
        "tr",
        element("td", watch_button(row.time_s), class_="act"),
        element("td", row.what),
        element("td", row.words),
        element("td", element("a", str(line), href=f"#L{line}") if line else "–"),
    )
