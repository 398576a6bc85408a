"""Steps that were surely meant: an element between others, a call of what nobody calls."""

from collections import Counter
from collections.abc import Iterator
from itertools import product

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.lang.syntax.statements import Assignment, For, SetLocation, Simple
from vrts.repair.table.asked import MOVES_TO, Asked, target_of

GAP = -0.7  # what speaks for an element without a value, between others, of a location unused
BEYOND = -0.3  # and for one beside the first or the last
FORGOTTEN = -0.6  # and for a call of a program that nobody calls
TRUSTED = 0.8  # what it costs that no line beside is to blame
MOST = 24  # calls of a program proposed

Step = tuple[str, int, float, float]  # text, nodes, what speaks against it, trust


def forgotten(asked: Asked) -> Iterator[Step]:
    """Yield steps with how many nodes they have, how unusual they are, and how blame counts."""
    yield from _elements(asked)
    yield from _calls(asked)


def _elements(asked: Asked) -> Iterator[Step]:
    """Yield values of elements that an array lacks: of locations that no step names."""
    numbers: dict[str, list[int]] = {}
    for step in asked.written.steps:
        target = target_of(step)
        if not isinstance(step.statement, SetLocation) or not isinstance(target, Element):
            continue
        given = [each.value for each in target.subscripts if isinstance(each, Number)]
        if len(given) == len(target.subscripts) == 1:
            numbers.setdefault(target.name.text, []).append(round(given[0]))
    for name, taken in numbers.items():
        for k in range(max(min(taken) - 1, 0), max(taken) + 2):
            if k in taken:
                continue
            unusual = GAP if min(taken) < k < max(taken) else BEYOND
            for idle in sorted(asked.idle):
                yield f"SET {name}[{k}] = {idle}", 4, unusual, TRUSTED


def _calls(asked: Asked) -> Iterator[Step]:
    """Yield calls of programs that nobody calls, with names of what their arguments are."""
    for number, program in enumerate(asked.written.programs):
        formals = [each for each in program.formals if each]
        if not number or program.name in asked.called or not formals:
            continue
        given = [_like(asked, number, key(formal.name.text)) for formal in formals]
        for n, names in enumerate(product(*given)):
            if n < MOST and len(set(names)) == len(names):
                text = f"CALL {program.name}({', '.join(names)})"
                yield text, 2 + len(names), FORGOTTEN, TRUSTED


def _like(asked: Asked, number: int, formal: str) -> list[str]:
    """Return the names outside of a program that it may be given: locations, or numbers.

    Of numbers first those that are given a value most often: they count.
    """
    goes_to = {
        key(step.statement.operands[0].text)
        for step in asked.written.steps
        if step.program == number
        and isinstance(step.statement, Simple)
        and step.statement.word in MOVES_TO
        and isinstance(step.statement.operands[0], Name)
    }
    if formal in goes_to:
        return sorted(asked.idle or asked.locations)
    found = Counter(
        key(step.statement.target.text)
        for step in asked.written.steps
        if step.program != number
        and isinstance(step.statement, Assignment | For)
        and isinstance(step.statement.target, Name)
    )
    return [name for name, _ in found.most_common()]
