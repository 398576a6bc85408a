"""The tree of decisions as a picture in SVG: every line is a future, every fork a decision."""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

from vrts.report.page.futures.folding import Node
from vrts.report.page.futures.lanes import lanes
from vrts.report.page.html import Markup, element
from vrts.report.plain import one_line
from vrts.report.proof_words import decision

WIDE, LEFT, RIGHT = 1150, 18, 60  # of the picture, and beside its lines
ROW, TOP, BOTTOM = 30, 40, 14  # heights
BEND = 9  # of corners
LONGEST = 46  # characters of a label
LABEL, BOLD = 7.0, 7.6  # width of a character
STEPS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600)  # [s] between two lines of time
MOST_STEPS = 12
Across: TypeAlias = Callable[[float], float]  # of a time [s]
Down: TypeAlias = Callable[[int], float]  # of a node

GOOD = ("completed", "halted")


def tree(nodes: Sequence[Node]) -> Markup:
    """Return the picture of a tree; ids of nodes are `node-1` and so on."""
    rows = lanes(nodes)
    end_s = max([0.0, *(node.end_s for node in nodes), *(node.last_s for node in nodes)]) or 1.0
    height = TOP + ROW * len(nodes) + BOTTOM

    def x(time_s: float) -> float:
        return round(LEFT + (WIDE - LEFT - RIGHT) * time_s / end_s, 1)

    def y(number: int) -> float:
        return TOP + ROW * (rows[number] + 0.5)

    drawing = _Drawing(nodes, x, y)
    return element(
        "svg",
        element("g", *_ruler(end_s, x, height), class_="ruler"),
        element("g", *drawing.spans(), class_="spans"),
        element("g", *drawing.joins(), class_="joins"),
        element("g", *drawing.lines(), class_="ways"),
        element("g", *drawing.nodes(), class_="nodes"),
        viewBox=f"0 0 {WIDE} {height}",
        width=WIDE,
        height=height,
        role="group",
        aria_label="The tree of decisions. Time goes right; every line is a future.",
        class_="tree",
    )


class _Drawing:
    """Parts of one picture."""

    def __init__(self, nodes: Sequence[Node], x: Across, y: Down) -> None:
        self._nodes, self._x, self._y = nodes, x, y
        leads = {k for k, node in enumerate(nodes) if node.marks}
        for k in range(len(nodes) - 1, -1, -1):  # parents come before their children
            parent = nodes[k].parent
            if k in leads and parent is not None:
                leads.add(parent)
        self._bad = leads

    def spans(self) -> Iterator[Markup]:
        """Yield where futures begin that are alike: on the line of their parent."""
        for node in self._nodes:
            if node.parent is not None and node.many > 1:
                y = self._y(node.parent)
                yield element("line", x1=self._x(node.start_s), x2=self._x(node.last_s), y1=y, y2=y)

    def joins(self) -> Iterator[Markup]:
        """Yield lines from futures that meet another one to that one."""
        for k, node in enumerate(self._nodes):
            if not node.is_merged or node.into is None:
                continue
            into = self._nodes[node.into]
            x, y = self._x(node.end_s), self._y(k)
            y_to = self._y(node.into)
            x_to = min(max(x + 2 * BEND, self._x(into.start_s)), self._x(into.end_s))
            middle = round((y + y_to) / 2, 1)
            yield element("path", d=f"M{x} {y}C{x + 26} {y} {x_to + 8} {middle} {x_to} {y_to}")

    def lines(self) -> Iterator[Markup]:
        """Yield the line of every node, with the way to it from that of its parent."""
        for k, node in enumerate(self._nodes):
            x, y, end = self._x(node.start_s), self._y(k), self._x(node.end_s)
            path = f"M{x} {y}H{end}"
            if node.parent is not None:
                y_from = self._y(node.parent)
                path = f"M{x} {y_from}V{y - BEND}Q{x} {y} {x + BEND} {y}H{max(end, x + BEND)}"
            yield element("path", d=path, class_="bad" if k in self._bad else None)

    def nodes(self) -> Iterator[Markup]:
        """Yield what can be chosen: every node with its label and its end; on top what is wrong."""
        for k in sorted(
            range(len(self._nodes)), key=lambda number: bool(self._nodes[number].marks)
        ):
            node = self._nodes[k]
            words = words_of(node)
            label = words if len(words) <= LONGEST else f"{words[: LONGEST - 1]}…"
            x, y = self._x(node.start_s), self._y(k)
            end = max(self._x(node.end_s), x + BEND) if node.parent is not None else x
            length = (BOLD if k in self._bad else LABEL) * len(label)
            turned = x + 16 + length > WIDE - 4
            shapes = [
                element(
                    "rect",
                    x=round(x - length - 14 if turned else x - 8, 1),
                    y=y - 19,
                    width=round(length + 26, 1),
                    height=27,
                    rx=6,
                    class_="hit",
                ),
                element("circle", cx=x, cy=self._from(node, k), r=3.5, class_="fork"),
                element(
                    "text",
                    label,
                    x=x - 8 if turned else x + 13,
                    y=y - 6,
                    text_anchor="end" if turned else None,
                ),
                *self._ends(node, max(end, self._x(node.end_s)), y),
            ]
            yield element(
                "a",
                element("title", f"{node.start_s:.3f} s: {words}"),
                *shapes,
                *(self._mark(mark.number, mark.time_s, y) for mark in node.marks),
                href="#chosen",
                id=f"node-{k + 1}",
                data_node=k,
                class_="bad" if k in self._bad else None,
            )

    def _from(self, node: Node, k: int) -> float:
        return self._y(k) if node.parent is None else self._y(node.parent)

    def _ends(self, node: Node, x: float, y: float) -> Iterator[Markup]:
        if node.left:
            yield element("text", f"+{node.left:,}", x=x + 10, y=y + 4, class_="left")
        if node.ends == "merged":
            yield element("circle", cx=x, cy=y, r=4, class_="merged")
        elif node.ends in GOOD:
            yield element("circle", cx=x, cy=y, r=4.5, class_="good")
        elif node.ends == "open":
            dots = (element("circle", cx=x + 5 * k, cy=y, r=1.5) for k in range(3))
            yield element("g", *dots, class_="open")
        elif node.ends:
            yield element("rect", x=x - 4, y=y - 4, width=8, height=8, class_="stopped")

    def _mark(self, number: int, time_s: float, y: float) -> Markup:
        x = self._x(time_s)
        return element(
            "g",
            element("path", d=f"M{x} {y - 11}l11 11l-11 11l-11 -11z"),
            element("text", str(number), x=x, y=y + 4),
            class_="wrong",
        )


def words_of(node: Node) -> str:
    """Return what was decided, and how many futures are alike."""
    if node.decided is None:
        return "EXECUTE"
    words = one_line(decision(node.decided))
    return f"{words} ×{node.many:,}" if node.many > 1 else words


def _ruler(end_s: float, x: Across, height: float) -> Iterator[Markup]:
    step = next((step for step in STEPS if end_s / step <= MOST_STEPS), end_s / MOST_STEPS)
    for k in range(math.floor(end_s / step) + 1):
        at = x(k * step)
        yield element("line", x1=at, x2=at, y1=TOP - 14, y2=height - 4)
        yield element("text", f"{k * step:g} s", x=at, y=TOP - 20)
