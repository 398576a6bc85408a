"""Mistakes in one instruction: its keyword, its distance, its speed, its signal, its time."""

from random import Random

from tests.mutants.kinds.sites import (
    Constant,
    Kind,
    constants,
    keyword,
    of,
    parts,
    put,
    simple,
    steps,
)
from tests.mutants.reading import Written
from vrts.lang.syntax.expressions import Application
from vrts.lang.syntax.statements import Simple, SpeedStatement

STRAIGHT = {
    "MOVE": "MOVES", "MOVES": "MOVE", "APPRO": "APPROS", "APPROS": "APPRO",
    "DEPART": "DEPARTS", "DEPARTS": "DEPART",
}  # fmt: skip
WAITING = {"OPENI": "OPEN", "CLOSEI": "CLOSE", "OPEN": "OPENI", "CLOSE": "CLOSEI"}
SENSE = {"OPENI": "CLOSEI", "CLOSEI": "OPENI", "OPEN": "CLOSE", "CLOSE": "OPEN"}


def straight(written: Written, chance: Random) -> str | None:
    """MOVE for MOVES, and their like."""
    return _other_word(written, chance, STRAIGHT)


def waiting(written: Written, chance: Random) -> str | None:
    """OPEN for OPENI, CLOSE for CLOSEI: the hand moves with the next motion."""
    return _other_word(written, chance, WAITING)


def sense(written: Written, chance: Random) -> str | None:
    """OPENI for CLOSEI, or the other way."""
    return _other_word(written, chance, SENSE)


def approach(written: Written, chance: Random) -> str | None:
    """A location approached that should be reached, or reached that should be approached."""
    found = of(chance, simple(written, "MOVE", "MOVES", "APPRO", "APPROS"))
    if found is None:
        return None
    node = found[1]
    straight = "S" * node.word.endswith("S")
    end = _operand(node, 0)[1]
    if node.word.startswith("MOVE"):
        far = chance.choice((20, 30, 50, 80, 100, 120))
        word = f"APPRO{straight}"
        return put(written.text, keyword(written.text, node, word), (end, end, f", {far}"))
    word = f"MOVE{straight}"
    return put(written.text, keyword(written.text, node, word), (end, node.end, ""))


def departure(written: Written, chance: Random) -> str | None:
    """APPRO for DEPART or the other way, and MOVES to a location for a departure."""
    sites = [
        (node, "APPROS" if node.word.endswith("S") else "APPRO", place)
        for program, node in simple(written, "DEPART", "DEPARTS")
        for other in program.steps
        if isinstance(motion := other.step.statement, Simple)
        and motion.word in ("MOVE", "MOVES")
        and motion.start < node.start
        and (place := written.text[slice(*_operand(motion, 0))])
    ]
    site = of(chance, sites)
    if site is None:
        return None
    node, word, place = site
    start = _operand(node, 0)[0]
    return put(written.text, keyword(written.text, node, word), (start, start, f"{place}, "))


def distance(written: Written, chance: Random) -> str | None:
    """A wrong distance of APPRO or DEPART: too small, too large, below instead of above."""
    sites = [
        number
        for _, node in simple(written, "APPRO", "APPROS", "DEPART", "DEPARTS")
        for number in constants(node.operands[-1])
    ]
    return _wrong(written, chance, sites, (-1, 0.05, 0.1, 0.2, 0.3, 0.5, 3, 4, 5, 10, 1 / 25.4))


def speed(written: Written, chance: Random) -> str | None:
    """SPEED too slow: a per cent for a percentage, a creeping arm."""
    sites = [number for node in _speeds(written) for number in constants(node.levels)]
    return _wrong(written, chance, sites, (0.01, 0.02, 0.03, 0.05, 0.08, 0.1, 0.15, 0.2, 0.3))


def always(written: Written, chance: Random) -> str | None:
    """ALWAYS forgotten, or written where one motion is meant."""
    node = of(chance, _speeds(written))
    if node is None:
        return None
    last = node.levels[-1].end
    return put(written.text, (last, node.end, "" if node.always else " ALWAYS"))


def shift(written: Written, chance: Random) -> str | None:
    """A wrong number of SHIFT, or two of its axes exchanged."""
    calls = [
        node for _, step in steps(written) for node in _applications(step.step.statement, "SHIFT")
    ]
    node = of(chance, calls)
    if node is None:
        return None
    numbers = constants(node.arguments)
    if chance.random() < 0.5:
        one, two = chance.sample(numbers, 2)
        return put(written.text, (*one[1:], f"{two.value:g}"), (*two[1:], f"{one.value:g}"))
    if chance.random() < 0.5:
        one = chance.choice(numbers)
        off = chance.choice((-100, -50, -30, 30, 50, 100))
        return put(written.text, (*one[1:], f"{one.value + off:g}"))
    return _wrong(written, chance, [n for n in numbers if n.value], (-1, 0.1, 10, 0.5, 1 / 25.4))


def signal(written: Written, chance: Random) -> str | None:
    """A wrong signal, or one switched off instead of on."""
    sites = [n for _, node in simple(written, "SIGNAL", "WAIT") for n in constants(node.operands)]
    return _wrong(written, chance, sites, (-1, 2, 3, 10))


def delay(written: Written, chance: Random) -> str | None:
    """A time in another unit."""
    sites = [n for _, node in simple(written, "DELAY") for n in constants(node.operands)]
    return _wrong(written, chance, sites, (0.01, 10, 60, 100))


def _speeds(written: Written) -> list[SpeedStatement]:
    return [
        node
        for _, step in steps(written)
        if isinstance(node := step.step.statement, SpeedStatement)
    ]


def _applications(statement: object, name: str) -> list[Application]:
    return [
        node
        for node in parts(statement)
        if isinstance(node, Application) and node.name.text.upper() == name
    ]


def _operand(node: Simple, k: int) -> tuple[int, int]:
    """Return where an operand stands."""
    found = node.operands[k]
    assert found is not None
    return found.start, found.end


def _wrong(
    written: Written, chance: Random, sites: list[Constant], factors: tuple[float, ...]
) -> str | None:
    """Return the text with one number times one of several factors."""
    site = of(chance, sites)
    if site is None:
        return None
    value = round(site.value * chance.choice(factors), 1)
    return put(written.text, (site.start, site.end, f"{value:g}"))


def _other_word(written: Written, chance: Random, other: dict[str, str]) -> str | None:
    found = of(chance, simple(written, *other))
    if found is None:
        return None
    node = found[1]
    return put(written.text, keyword(written.text, node, other[node.word]))


WORDS: dict[str, Kind] = {
    "straight": straight,
    "waiting": waiting,
    "sense": sense,
    "approach": approach,
    "departure": departure,
    "distance": distance,
    "speed": speed,
    "always": always,
    "shift": shift,
    "signal": signal,
    "delay": delay,
}
