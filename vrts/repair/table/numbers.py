"""Other numbers in steps: mistyped, asked for by geometry, or said elsewhere."""

from collections.abc import Iterator
from enum import Enum
from statistics import median_high

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application, Element, Infix, Item, Name, Number, Prefix
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    If,
    Simple,
    SpeedStatement,
    Statement,
    Until,
    While,
)
from vrts.repair.edit import FARTHEST, Candidate, Does, replacement
from vrts.repair.nodes import operands, parts
from vrts.repair.table.asked import Asked, names_in, written_number
from vrts.repair.written import WrittenStep

FACTORS = (-1.0, 10.0, 0.1, 25.4, 1 / 25.4, 100.0, 0.01, 1000.0, 0.001)
LADDER = (40, 60, 80, 100, 120, 150, 200, 250, 300)
SPEEDS = (100.0, 50.0, 30.0, 20.0, 80.0, 40.0, 10.0)
FULL = 100.0  # per cent
FAST = 0.5  # what it speaks against a speed above it
BESIDE = (20, 40, 80, 150, 10, 250, 400)
SMALL = 12  # a whole number up to this may count something
COUNTED = 1.3  # what it speaks against a number that counts that its line is not to blame
FROM_ONE = -0.3  # what speaks for a loop that begins at 1
BY_ONE = -0.3  # and for a number that counts by 1
PACED = 1.0  # what it costs that a speed is not to blame, where nothing is lost but time
SLOWED = 0.5  # what speaks against a smaller speed where nothing is lost but time
BACKWARD = -0.6  # what speaks for the other sign of a distance that a program is given to leave by
SHIFTED = 0.3  # what a teacher says against a shift along an axis along which there was none
BEYOND = 1000.0  # [mm] no step goes farther: surely mistyped
TOGETHER = 1.8  # what it speaks against a number that stands in many places that none is to blame
FAR = 5000.0  # [mm] no distance is longer


AWAY = frozenset({"APPRO", "APPROS", "DEPART", "DEPARTS"})
ODD = 0.5  # of the usual distance: a smaller one is likely mistyped
FAR_AWAY = 0.4  # what a teacher says against a distance far beyond all others


class Role(Enum):
    """What a number in a step is."""

    DISTANCE = "distance"
    SPEED = "speed"
    COUNT = "count"
    EITHER = "either"  # in an assignment or a sum


def other_numbers(asked: Asked) -> Iterator[Candidate]:
    """Yield every step with another number, and steps that are alike with another one together."""
    alike: dict[tuple[str, str, float], list[tuple[WrittenStep, Item]]] = {}
    usual = _usual(asked)
    elsewhere = _elsewhere(asked)
    for step in asked.steps:
        for item, role in numbers_of(step.statement):
            value = value_of(item)
            word = word_of(step.statement)
            backward = value < 0 and any(item is each for each in _away(asked, step.statement))
            alike.setdefault((word, role.value, value), []).append((step, item))
            for unusual, other in _others(asked, value, role, word, elsewhere):
                odd, doubt = 0.0, 0.0
                if role is Role.DISTANCE and abs(value) > BEYOND:
                    odd = -0.5
                if backward and other == -value:
                    odd = BACKWARD
                if value == 0 and role is Role.DISTANCE and word == "SetLocation":
                    doubt = SHIFTED
                if role is Role.SPEED and asked.blame.slow:
                    odd = SLOWED if other < value else 0.0
                if word in AWAY and usual:
                    odd = -0.5 if value <= ODD * usual or value > FARTHEST else 0.0
                    doubt = FAR_AWAY if other > max(250.0, 2.0 * usual) else 0.0
                yield asked.instead(
                    Does.NUMBER,
                    step.line,
                    item,
                    written_number(other),
                    unusual=unusual + odd,
                    doubt=doubt,
                    trust=_trust(asked, value, role),
                )
            if role is Role.COUNT and word != "For":
                beside = {key(name.text) for name in names_in(step)} & asked.numbers
                for name in sorted(asked.numbers):
                    unusual = -0.4 if name in beside else 0.2
                    yield asked.instead(
                        Does.NAME, step.line, item, name, unusual=unusual, trust=COUNTED
                    )
            if isinstance(step.statement, For) and item is step.statement.first and value != 1:
                yield asked.instead(
                    Does.NUMBER, step.line, item, "1", unusual=FROM_ONE, trust=COUNTED
                )
            if isinstance(step.statement, For) and item is step.statement.increment:
                yield asked.instead(Does.NUMBER, step.line, item, "1", trust=COUNTED)
        yield from _counting(asked, step)
    for (word, role, value), places in alike.items():
        if len(places) > 1:
            kind = Role(role)
            odd = -0.5 if word in AWAY and 0.0 < value <= ODD * usual else 0.0
            for unusual, other in _others(asked, value, kind, word, elsewhere):
                doubt = FAR_AWAY if word in AWAY and other > max(250.0, 2.0 * usual) else 0.0
                together = _together(asked, places, other, unusual + odd + doubt)
                yield together._replace(doubt=doubt)


def _away(asked: Asked, statement: Statement) -> Iterator[Item]:
    """Yield the arguments of a CALL that are the distance of an APPRO or DEPART there."""
    if not isinstance(statement, CallStatement):
        return
    number = asked.callee(statement)
    if number is None:
        return
    distances = {
        key(step.statement.operands[-1].text)
        for step in asked.written.steps
        if step.program == number
        and isinstance(step.statement, Simple)
        and step.statement.word in AWAY
        and step.statement.operands
        and isinstance(step.statement.operands[-1], Name)
    }
    formals = asked.written.programs[number].formals
    for formal, argument in zip(formals, statement.arguments, strict=False):
        if formal and argument is not None and key(formal.name.text) in distances:
            yield argument


def _counting(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    """Yield `n = n+1` for a step that counts by another number."""
    match step.statement:
        case Assignment(Name(name), Infix("+", Name(other), Number(by) as item)) if (
            key(name) == key(other) and by != 1
        ):
            yield asked.instead(Does.NUMBER, step.line, item, "1", unusual=BY_ONE, trust=COUNTED)
        case _:
            return


def _together(
    asked: Asked, places: list[tuple[WrittenStep, Item]], other: float, unusual: float
) -> Candidate:
    text = written_number(other)
    source = asked.written.source
    edits = [replacement(source, item.start, item.end, text) for _, item in places]
    line = min((step.line for step, _ in places), key=asked.against)
    return asked.candidate(
        Does.NUMBER,
        line,
        edits,
        size=len(places),
        priced=1.6,
        unusual=unusual,
        trust=TOGETHER,
        old=asked.text_of(places[0][1]),
        new=text,
    )


def _usual(asked: Asked) -> float:
    """Return the usual distance of APPRO and DEPART in a program; 0: there is none."""
    found = [
        value
        for step in asked.written.steps
        if word_of(step.statement) in AWAY
        for value in _distances(asked, step.statement)
    ]
    return median_high(found) if len(found) > 1 else 0.0


def _distances(asked: Asked, statement: Statement) -> Iterator[float]:
    """Yield the distance that a step says, by itself or by a variable that is set once."""
    found = [value_of(item) for item, role in numbers_of(statement) if role is Role.DISTANCE]
    yield from found
    if not found:
        for item in operands(statement):
            if isinstance(item, Name) and key(item.text) in asked.constants:
                yield asked.constants[key(item.text)]


def numbers_of(statement: Statement) -> Iterator[tuple[Item, Role]]:
    """Yield the numbers of a step with what they are; a signed number is one."""
    for item in operands(statement):
        yield from _numbers(item, _role(statement))


def value_of(item: Item) -> float:
    """Return the value of a number with its sign."""
    if isinstance(item, Prefix):
        assert isinstance(item.operand, Number)
        return -item.operand.value
    assert isinstance(item, Number)
    return item.value


def word_of(statement: Statement) -> str:
    """Return the keyword of a step."""
    return str(getattr(statement, "word", type(statement).__name__))


def _numbers(item: Item, role: Role) -> Iterator[tuple[Item, Role]]:
    match item:
        case Number():
            yield item, role
        case Prefix("-", Number()):
            yield item, role
        case Element(_, subscripts):
            for each in subscripts:
                if each is not None:
                    yield from _numbers(each, Role.COUNT)
        case Application(_, arguments):
            for each in arguments:
                if each is not None:
                    yield from _numbers(each, Role.DISTANCE)
        case Prefix(_, inner):
            yield from _numbers(inner, role)
        case Infix(_, left, right):
            inside = Role.EITHER if role is Role.DISTANCE else role
            yield from _numbers(left, inside)
            yield from _numbers(right, inside)
        case _:
            for part in parts(item):
                if part is not item:
                    yield from _numbers(part, role)


def _role(statement: Statement) -> Role:
    match statement:
        case SpeedStatement():
            return Role.SPEED
        case For() | If() | While() | Until():
            return Role.COUNT
        case Simple("SIGNAL" | "WAIT" | "RESET"):
            return Role.COUNT
        case Assignment():
            return Role.EITHER
        case _:
            return Role.DISTANCE


def _elsewhere(asked: Asked) -> dict[str, list[float]]:
    """Return the numbers that steps of each keyword have."""
    found: dict[str, list[float]] = {}
    for step in asked.written.steps:
        for item, role in numbers_of(step.statement):
            known = found.setdefault(word_of(step.statement), [])
            if role is not Role.COUNT and value_of(item) not in known:
                known.append(value_of(item))
    for word in AWAY:
        known = found.setdefault(word, [])
        known += [x for x in asked.constants.values() if x not in known and x > BESIDE[0]]
    return found


def _trust(asked: Asked, value: float, role: Role) -> float | None:
    """Return what it costs that the line of a number is not to blame; None: as usual."""
    if role is Role.SPEED and asked.blame.slow:
        return PACED
    return COUNTED if role is Role.COUNT or _may_count(value, role) else None


def _may_count(value: float, role: Role) -> bool:
    return role is Role.EITHER and value == round(value) and abs(value) <= SMALL


def _others(
    asked: Asked, value: float, role: Role, word: str, elsewhere: dict[str, list[float]]
) -> list[tuple[float, float]]:
    """Return other values, each once, with how unusual the mistake would be."""
    found: dict[float, float] = {}

    def add(unusual: float, other: float) -> None:
        other = round(other, 2) + 0.0
        if other != value and abs(other) <= FAR:
            found[other] = min(unusual, found.get(other, unusual))

    counts = role is Role.COUNT or _may_count(value, role)
    if counts:
        for by, unusual in ((1, 0.0), (-1, 0.0), (2, 0.3), (-2, 0.3), (3, 0.6)):
            add(unusual, value + by)
        add(0.4 if value > 0 else 0.0, -value)  # nobody counts below nothing
    if role is Role.SPEED:
        if value < FULL:
            add(0.0, FULL)
        for k, other in enumerate((value * 10, value / 10, value * 3, value * 2, value * 5)):
            add(0.1 * k + (FAST if other > FULL else 0.0), other)
        for k, other in enumerate(SPEEDS):
            add(0.1 + 0.05 * k, other)
        for other in elsewhere.get(word, ()):
            add(0.05 + (FAST if other > FULL else 0.0), other)
        return [(unusual, other) for other, unusual in found.items() if other > 0]
    if role is Role.COUNT:
        return [(unusual, other) for other, unusual in found.items()]
    aside = 0.4 if counts else 0.0
    for k, factor in enumerate(FACTORS):
        add(aside + 0.08 * k, value * factor)
    for k, other in enumerate(elsewhere.get(word, ())):
        add(aside + 0.05 + 0.05 * k, other)
    for other in mistyped(value):
        add(aside + 0.3, other)
    for k, other in enumerate(LADDER):
        add(aside + 0.25 + 0.02 * k, other)
        add(aside + 0.6, -other)
    for residual in asked.blame.residuals:
        for x in residual:
            if abs(x) > 1.0:
                add(aside + 0.35, value + x)
                add(aside + 0.45, value - x)
    for others in elsewhere.values():
        for other in others:
            add(aside + 0.4, other)
    for k, by in enumerate(BESIDE):
        add(aside + 0.5 + 0.05 * k, value + by)
        add(aside + 0.5 + 0.05 * k, value - by)
    return [(unusual, other) for other, unusual in found.items()]


def mistyped(value: float) -> Iterator[float]:
    """Yield numbers that become a value by two digits exchanged."""
    text = written_number(abs(value))
    sign = -1.0 if value < 0 else 1.0
    for k in range(len(text) - 1):
        if text[k : k + 2].isdigit() and text[k] != text[k + 1]:
            yield sign * float(text[:k] + text[k + 1] + text[k] + text[k + 2 :])
