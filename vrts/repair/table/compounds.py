"""Compounds of locations: turned round, a part left out or more, and INVERSE; what motions name."""

import re
from collections.abc import Iterator

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application, Element, Infix, Item, Name, Parenthesised
from vrts.lang.syntax.statements import CallNamed, CallStatement, SetLocation, Simple
from vrts.repair.edit import Candidate, Does
from vrts.repair.nodes import nodes, operands, parts
from vrts.repair.table.asked import MOVES_TO, Asked
from vrts.repair.written import WrittenStep

UNFINISHED = -0.2  # what speaks for a part more behind INVERSE: seen from there something is meant
AKIN = 0.4  # and for one whose name has a word of it: `pizza_grip`, seen from `pizza`
WORDS = re.compile("[a-z]+")
NEAR = 3  # steps between two motions that belong together


def compounds(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    """Yield compounds turned round, without a part, with a part more, and INVERSE more or less."""
    seen: set[int] = set()
    for item in operands(step.statement):
        for part in parts(item):
            match part:
                case Infix(":", left, right):
                    seen |= {left.start, right.start}
                    yield from _compound(asked, step, part, left, right)
                case Application(name, (inner,)) if key(name.text) == "inverse" and inner:
                    text = asked.text_of(inner)
                    yield asked.instead(Does.WORD, step.line, part, text, unusual=0.2)
                case _:
                    pass
    for item in location_operands(step):
        yield from _longer(asked, step, item)
        yield from _seen_from(asked, step, item)
        for part in _leaves(item):
            text = asked.text_of(part)
            if part.start in seen or isinstance(step.statement, SetLocation):
                inverse = f"INVERSE({text})"
                yield asked.instead(Does.WORD, step.line, part, inverse, unusual=0.2)
            for other in sorted(asked.locations - {key(text)}):
                unusual = 0.1 if isinstance(step.statement, SetLocation) else 0.4
                unusual -= 0.5 if other in asked.idle else 0.0
                both = f"{text}:{other}"
                yield asked.instead(Does.NAME, step.line, part, both, size=2, unusual=unusual)
                both = f"{other}:{text}"
                yield asked.instead(Does.NAME, step.line, part, both, size=2, unusual=unusual)


def _longer(asked: Asked, step: WrittenStep, whole: Item) -> Iterator[Candidate]:
    """Yield a compound with a part more at its end, behind INVERSE."""
    last = whole.right if isinstance(whole, Infix) else whole
    if not isinstance(last, Application) or key(last.name.text) != "inverse":
        return  # as a part that is made a compound itself
    text = asked.text_of(whole)
    inner = set(WORDS.findall(asked.text_of(last).lower()))
    for other in sorted(asked.locations):
        longer = f"{text}:{other}"
        unusual = UNFINISHED - (AKIN if inner & set(WORDS.findall(other)) else 0.0)
        made = asked.instead(Does.NAME, step.line, whole, longer, size=2, unusual=unusual)
        yield made._replace(group=(Does.NAME.value, -whole.end))


def _seen_from(asked: Asked, step: WrittenStep, whole: Item) -> Iterator[Candidate]:
    """Yield a compound that begins with INVERSE with a part more before it."""
    first = whole
    while isinstance(first, Infix):
        first = first.left
    if not isinstance(first, Application) or key(first.name.text) != "inverse":
        return
    for other in sorted(asked.locations):
        longer = f"{other}:{asked.text_of(whole)}"
        unusual = UNFINISHED - (AKIN if other in asked.idle else 0.0)
        made = asked.instead(Does.NAME, step.line, whole, longer, size=2, unusual=unusual)
        yield made._replace(group=(Does.NAME.value, -whole.start))


def _compound(
    asked: Asked, step: WrittenStep, whole: Item, left: Item, right: Item
) -> Iterator[Candidate]:
    one, other = asked.text_of(left), asked.text_of(right)
    size = min(nodes(left) + nodes(right), 2 * min(nodes(left), nodes(right)))
    turned = f"{other}:{one}"
    approached = one in _approached(asked, step)
    yield asked.instead(Does.ORDER, step.line, whole, turned, size=size, unusual=-0.2)
    yield asked.instead(
        Does.NAME,
        step.line,
        whole,
        one,
        size=1 + nodes(right),
        unusual=-0.3 if approached else 0.4,
    )
    yield asked.instead(Does.NAME, step.line, whole, other, size=1 + nodes(left), unusual=0.4)


def _approached(asked: Asked, step: WrittenStep) -> set[str]:
    """Return the location, as it is written, that a motion's approach goes near."""
    k = asked.written.steps.index(step)
    before = [each for each in asked.written.steps[max(k - NEAR, 0) : k] if approaches(each)]
    near = [next(location_operands(each), None) for each in before[-1:]]
    return {asked.text_of(each) for each in near if each is not None}


def location_operands(step: WrittenStep) -> Iterator[Item]:
    """Yield the operands of a step that are locations."""
    statement = step.statement
    match statement:
        case SetLocation():
            yield statement.value
        case Simple(word, (first, *_)) if word in MOVES_TO and first is not None:
            yield first
        case CallStatement() | CallNamed():
            yield from (each for each in statement.arguments if isinstance(each, Name | Element))
        case _:
            return


def _leaves(item: Item) -> Iterator[Item]:
    """Yield the names and elements that a location is made of."""
    match item:
        case Infix(_, left, right):
            yield from _leaves(left)
            yield from _leaves(right)
        case Parenthesised(inner):
            yield from _leaves(inner)
        case Application(name, (first, *_)) if first is not None and key(name.text) == "shift":
            yield from _leaves(first)
        case Name() | Element():
            yield item
        case _:
            return


def approaches(step: WrittenStep) -> bool:
    """Return whether a step goes near a location."""
    return isinstance(step.statement, Simple) and step.statement.word.startswith("APPRO")


def visits(step: WrittenStep) -> bool:
    """Return whether a step goes to a location, or near it."""
    return isinstance(step.statement, Simple) and step.statement.word in MOVES_TO
