"""A chain of causes: links from what went wrong back to the step that is to blame."""

from typing import NamedTuple

from vrts.base.source import Span
from vrts.check.rules.hints import Hints

MOST = 5  # links of a chain [manual understand/why#short]


class Link(NamedTuple):
    """One cause. What it says holds of the run; how far that is from right is told apart.

    The three texts belong to the levels of a task's `[hints]` [manual understand/why#levels].
    """

    time_s: float | None  # when it happened; None: before the run, as data
    span: Span | None  # the step, or the line of data
    says: str  # what happened there, with the values that the program had
    toward: str = ""  # in which direction that is wrong: "too low"
    amount: str = ""  # how far, in place of the direction: "40 mm too low: ..."
    minor: bool = False  # left out first where a chain is too long, or its place is told already


class Chain(NamedTuple):
    """What went wrong, and why: what came last comes first."""

    effect: str  # one sentence, lower case, without a full stop
    links: tuple[Link, ...]  # at most MOST
    kind: str = ""  # of the loss; "" where none is meant

    @property
    def blamed(self) -> Link | None:
        """The last link: the step, or the number, that the rest came from."""
        return self.links[-1] if self.links else None


def words(link: Link, hints: Hints = Hints.EDIT) -> str:
    """Return a link as far as it may be told, after its place; "" where nothing may be."""
    if hints is Hints.NOTHING:
        return ""
    more = link.amount if link.amount and hints >= Hints.NUMBER else link.toward
    return link.says if not more or hints < Hints.DIRECTION else f"{link.says}: {more}"


def place(link: Link) -> str:
    """Return when and where a link is: "at 6.2 s, line 14 `CLOSEI`"."""
    parts = [] if link.time_s is None else [f"at {link.time_s:.1f} s"]
    if link.span is not None:
        parts.append(f"line {link.span.line} `{' '.join(link.span.text.split())}`")
    return ", ".join(parts)


def line(link: Link, hints: Hints = Hints.EDIT) -> str:
    """Return a link as one line: its place, then its words."""
    where, said = place(link), words(link, hints)
    return f"{where}: {said}" if where and said else said or where


def shortened(effect: str, links: list[Link], kind: str = "") -> Chain:
    """Return a chain of what tells most: each place once, the first links and the last."""
    kept: list[Link] = []
    for link in links:
        again = [o for o in kept if (o.span, o.time_s) == (link.span, link.time_s) and o.span]
        if not again or not (link.minor or any(o.says == link.says for o in again)):
            kept.append(link)
    while len(kept) > MOST and any(link.minor for link in kept):
        kept.remove(next(link for link in reversed(kept) if link.minor))
    if len(kept) > MOST:
        kept = [*kept[: MOST - 1], kept[-1]]
    return Chain(effect, tuple(kept), kind)
