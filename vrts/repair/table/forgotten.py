"""Steps that were surely meant: an element between others, a call of what nobody calls."""

from collections import Counter, deque
from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from math import isfinite

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.lang.syntax.statements import Assignment, For, SetLocation, Simple
from vrts.repair.table.asked import MOVES_TO, Asked, target_of

GAP = -0.7  # what speaks for an element without a value, between others, of a location unused
BEYOND = -0.3  # and for one beside the first or the last
FORGOTTEN = -0.6  # and for a call of a program that nobody calls
TRUSTED = 0.8  # what it costs that no line beside is to blame
MOST = 24  # calls of a program proposed, and names looked at for an argument
FORMALS = 8  # of a program at most: what more of them are given nobody guesses
WIDEST = 20  # elements that an array may lack between two
ALL = 200  # elements proposed, and calls: whatever the text

Step = tuple[str, int, float, float]  # text, nodes, what speaks against it, trust


def forgotten(asked: Asked) -> Iterator[Step]:
    """Yield steps with how many nodes they have, how unusual they are, and how blame counts."""
    yield from islice(_elements(asked), ALL)
    yield from islice(_calls(asked), ALL)


def _elements(asked: Asked) -> Iterator[Step]:
    """Yield values of elements that an array lacks: of locations that no step names."""
    numbers: dict[str, list[int]] = {}
    for step in asked.written.steps:
        target = target_of(step)
        if not isinstance(step.statement, SetLocation) or not isinstance(target, Element):
            continue
        given = [each.value for each in target.subscripts if isinstance(each, Number)]
        if len(given) == len(target.subscripts) == 1 and isfinite(given[0]):
            numbers.setdefault(target.name.text, []).append(round(given[0]))
    idle = sorted(asked.idle)
    for name, taken in numbers.items():
        for k in _lacking(sorted(set(taken))):
            unusual = GAP if min(taken) < k < max(taken) else BEYOND
            for each in idle:
                yield f"SET {name}[{k}] = {each}", 4, unusual, TRUSTED


def _lacking(taken: Sequence[int]) -> Iterator[int]:
    """Yield the subscripts between others that are near each other, and one beside each end."""
    if taken[0] > 0:
        yield taken[0] - 1
    for one, other in pairwise(taken):
        if other - one - 1 <= WIDEST:
            yield from range(one + 1, other)
    yield taken[-1] + 1


def _calls(asked: Asked) -> Iterator[Step]:
    """Yield calls of programs that nobody calls, with names of what their arguments are."""
    for number, program in enumerate(asked.written.programs):
        formals = [each for each in program.formals if each]
        if not number or program.name in asked.called or not 0 < len(formals) <= FORMALS:
            continue
        given = _like(asked, number, [key(formal.name.text) for formal in formals])
        if any(given.count(names) > len(names) for names in given):
            continue  # one of them would have to be given twice
        for names in islice(_varied(given), MOST):
            text = f"CALL {program.name}({', '.join(names)})"
            yield text, 2 + len(names), FORGOTTEN, TRUSTED


def _varied(
    given: Sequence[Sequence[str]], turn: int = 0, taken: tuple[str, ...] = ()
) -> Iterator[tuple[str, ...]]:
    """Yield different names for arguments, so that each of them gets each name about as often.

    Args:
        given: The names that each may get. Two lists are the same or share no name, and a list
            has as many names as arguments get one of it: so every beginning can be ended.
        turn: With which name of its list the next argument begins.
        taken: The names of the arguments before it.
    """
    if len(taken) == len(given):
        yield taken
        return
    names = given[len(taken)]
    begin = turn % len(names)
    waiting = deque(
        _varied(given, k, (*taken, names[k]))
        for k in (*range(begin, len(names)), *range(begin))
        if names[k] not in taken
    )
    while waiting:
        one = waiting.popleft()
        found = next(one, None)
        if found is not None:
            yield found
            waiting.append(one)


def _like(asked: Asked, number: int, formals: Sequence[str]) -> list[list[str]]:
    """Return the names outside of a program that each argument may get: locations, or numbers.

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
    found = Counter(
        key(step.statement.target.text)
        for step in asked.written.steps
        if step.program != number
        and isinstance(step.statement, Assignment | For)
        and isinstance(step.statement.target, Name)
    )
    places = sorted(asked.idle or asked.locations)
    numbers = [name for name, _ in found.most_common() if name not in places]
    return [(places if formal in goes_to else numbers)[:MOST] for formal in formals]
