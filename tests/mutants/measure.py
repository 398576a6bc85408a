"""How large an edit is: how many nodes of the syntax two programs differ in.

`size(before, after)` is the least number of nodes that are changed, added or removed to make the
one program of the other. It is symmetric, and 0 for programs that differ in nothing that counts.

What counts one node each:

- a number with its sign (`-120` is one node), a text in quotes, a name;
- an operator (`+`, `:`, `AND`, `<=`), a pair of parentheses, a function (its arguments apart);
- an array (its subscripts apart), so `from[i]` is two nodes;
- the keyword of a step (`APPRO`, `SET`, the `=` of an assignment, `IF ... THEN`, `FOR ... TO`,
  `END`), a label before a step, ALWAYS, a unit such as MMPS, BY;
- the name of a program in its first line and each of its formal arguments;
- the name of a row of data and each of its numbers.

So one wrong number, name, keyword or operator is an edit of size 1. X and Y exchanged is 2, and so
are the two arguments of a CALL; a row in inches is 3. A step that is added or removed counts all
its nodes (`BREAK` 1, `MOVE safe` 2, `APPRO start, 120` 3), and so does a row (`safe` with six
numbers: 7). A step that stands elsewhere is removed there and added here: twice its nodes.
`APPRO p, 50` in place of `MOVE p` is 2: the keyword is changed and a number is added.

What costs nothing: layout, case, comments, blank lines, how a number is written (`120`, `120.00`),
letters of a name that the controller does not keep, the order of the rows of data (of those with
the same name the last one counts), and the order of the programs in the file.

How it is computed: programs and rows are paired by name, those left over by the cheapest alignment
in their order. Or all of them are aligned in their order, where that is less: so two names
exchanged count 2. Within a program the steps are aligned in their order, so that the sum is least:
a step is removed or added with all its nodes, or becomes another one by the tree edit distance
between the two (a node changed 1, added 1, removed 1). A step that is no VAL-II counts its words.
"""

from collections.abc import Callable, Hashable, Sequence
from functools import lru_cache
from typing import TypeVar

from tests.mutants.reading import Written, WrittenProgram, read
from tests.mutants.trees import (
    Forest,
    Tree,
    header_forest,
    nodes,
    row_forest,
    step_forest,
    weight,
)

T = TypeVar("T")
K = TypeVar("K", bound=Hashable)


def size(before: str, after: str) -> int:
    """Return how many nodes of the syntax two programs differ in.

    Args:
        before: The text of a VAL-II file.
        after: The text of another one.
    """
    return size_of(read(before), read(after))


def size_of(before: Written, after: Written) -> int:
    """Return how many nodes two programs differ in that are read already."""
    steps = _paired(
        [(program.name, program) for program in before.programs],
        [(program.name, program) for program in after.programs],
        _program_nodes,
        _program_distance,
    )
    rows = _paired(_rows(before), _rows(after), nodes, forest_distance)
    return steps + rows


def aligned(
    a: Sequence[T], b: Sequence[T], whole: Callable[[T], int], changed: Callable[[T, T], int]
) -> int:
    """Return the least cost of making one sequence of another.

    Args:
        a: What there is.
        b: What is to be.
        whole: What it costs to add or remove an item.
        changed: What it costs to make one item of another.
    """
    row = [0]
    for item in b:
        row.append(row[-1] + whole(item))
    for old in a:
        above, row = row, [row[0] + whole(old)]
        for j, new in enumerate(b):
            kept = above[j] + changed(old, new)
            row.append(min(kept, above[j + 1] + whole(old), row[j] + whole(new)))
    return row[-1]


@lru_cache(maxsize=1 << 16)
def forest_distance(a: Forest, b: Forest) -> int:
    """Return the tree edit distance: nodes changed, added or removed; what is below them stays."""
    if a == b:
        return 0
    if not a or not b:
        return nodes(a or b)
    (*rest_a, last_a), (*rest_b, last_b) = a, b
    before_a, before_b = tuple(rest_a), tuple(rest_b)
    return min(
        forest_distance((*before_a, *last_a.children), b) + weight(last_a),
        forest_distance(a, (*before_b, *last_b.children)) + weight(last_b),
        forest_distance(before_a, before_b)
        + forest_distance(last_a.children, last_b.children)
        + _relabelled(last_a, last_b),
    )


def _relabelled(a: Tree, b: Tree) -> int:
    return 0 if a.label == b.label else max(weight(a), weight(b))


def _paired(
    a: Sequence[tuple[K, T]],
    b: Sequence[tuple[K, T]],
    whole: Callable[[T], int],
    changed: Callable[[T, T], int],
) -> int:
    """Return the cost of items that have names: paired by them or in order, whichever is less.

    The last item of a name is the one that is meant.
    """
    first, second = dict(a), dict(b)
    both = first.keys() & second.keys()
    total = sum(changed(first[name], second[name]) for name in both)
    left = [item for name, item in a if name not in both or item is not first[name]]
    right = [item for name, item in b if name not in both or item is not second[name]]
    by_name = total + aligned(left, right, whole, changed)
    in_order = aligned([item for _, item in a], [item for _, item in b], whole, changed)
    return min(by_name, in_order)


def _rows(written: Written) -> list[tuple[tuple[str, Forest], Forest]]:
    found = [(row.kind, row_forest(row)) for row in written.rows]
    return [((kind, forest[:1]), forest) for kind, forest in found]


def _program_nodes(program: WrittenProgram) -> int:
    return nodes(header_forest(program)) + sum(nodes(step_forest(s)) for s in program.steps)


def _program_distance(a: WrittenProgram, b: WrittenProgram) -> int:
    header = forest_distance(header_forest(a), header_forest(b))
    steps = aligned(_forests(a), _forests(b), nodes, forest_distance)
    return header + steps


def _forests(program: WrittenProgram) -> list[Forest]:
    return [step_forest(step) for step in program.steps]
