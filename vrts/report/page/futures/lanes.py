"""Where the nodes of a tree of decisions are drawn: one lane for each, time goes right."""

from collections.abc import Sequence

from vrts.report.page.futures.folding import Node


def lanes(nodes: Sequence[Node]) -> tuple[int, ...]:
    """Return the lane of each node, from the top.

    What parts from a node later is nearer to it, so that no line crosses another one.
    """
    children: list[list[int]] = [[] for _ in nodes]
    waiting: list[int] = []
    for number, node in enumerate(nodes):
        (waiting if node.parent is None else children[node.parent]).append(number)
    waiting.reverse()
    found = [0] * len(nodes)
    lane = 0
    while waiting:
        number = waiting.pop()
        found[number] = lane
        lane += 1
        # the last one in is the next one out: what begins last is next to its parent
        waiting += sorted(children[number], key=lambda child: (nodes[child].start_s, -child))
    return tuple(found)
