"""Steps in small pieces: each alone, two and three in a row, and what stands in expressions."""

from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from math import log2

from vrts.ir.module import Module
from vrts.marking.similarity.features.feature import Channel, Feature, counted, near
from vrts.marking.similarity.features.steps import Step, steps_of

DEEDS = ("Move", "Depart", "Draw", "Drive", "Align", "Ready", "Nest", "MoveHand", "Grasp")
HANDS = ("MoveHand", "Grasp")
NUMBER_SHARE = 0.06  # of a number: the size of a cell of its logarithm, more or less
ROWS = ((2, 8.0), (3, 10.0), (4, 12.0))  # numbers of deeds in a row, and the size of a cell
DEEDS_IN_A_ROW = (3, 5, 8, 12)
MOST_PIECES = 100_000  # of a program, before those that repeat are dropped
USUAL = frozenset({0.0, 1.0})  # numbers that tell nothing


def code_features(module: Module) -> Iterator[Feature]:
    """Yield what there is to compare of the steps of a program."""
    steps = steps_of(module)
    yield from counted(tuple(islice(_pieces(steps), MOST_PIECES)))


def _pieces(steps: Sequence[Step]) -> Iterator[Feature]:
    for step in steps:
        yield Feature(Channel.STEPS, "step", (step.shape, step.loops), step.line)
        yield Feature(Channel.STEPS, "exact", (step.exact,), step.line)
        if step.speed:
            yield Feature(Channel.MANNER, "speed", (step.name, step.speed), step.line)
        for value in step.numbers:
            if value in USUAL:
                continue
            yield Feature(Channel.NUMBERS, "number", (step.name, round(value, 3)), step.line)
            size = max(0.5, abs(value) * NUMBER_SHARE)
            size = 2.0 ** round(log2(size))
            yield from near(Channel.NUMBERS, "about", (step.name,), (value,), size, step.line)
    yield from _handling(steps)
    deeds = [step for step in steps if step.name.split(" ", 1)[0] in DEEDS]
    for length in DEEDS_IN_A_ROW:
        yield from _rows("deeds", [step.name for step in deeds], deeds, length)
    yield from _rows("with numbers", [_numbered(step) for step in deeds], deeds, 2)
    for row in _rows("with speeds", [_hasty(step) for step in deeds], deeds, 3):
        yield row._replace(channel=Channel.MANNER)
    for length in (2, 3):
        yield from _rows("steps", [step.shape for step in steps], steps, length)
    pairs = [step for step in deeds if step.numbers]
    yield from _rows("numbers", [_numbered(step) for step in pairs], pairs, 3)
    for length, size in ROWS:
        for k in range(len(pairs) - length + 1):
            row = pairs[k : k + length]
            names = tuple(step.name for step in row)
            numbers = [step.numbers[0] for step in row]
            yield from near(Channel.NUMBERS, "row", names, numbers, size, row[0].line)


def _handling(steps: Sequence[Step]) -> Iterator[Feature]:
    """Yield how the hand comes, what it is told, how long it waits, and how it leaves."""
    told: list[tuple[tuple[object, ...], int]] = []
    come, waits = "", 0.0
    leaving: Step | None = None
    for step in (*steps, None):
        word = "" if step is None else step.name.split(" ", 1)[0]
        if leaving is not None and (step is None or step.speed or word in HANDS):
            away = _hasty(step) if step is not None and step.speed else ""
            told.append(((come, leaving.name, round(waits, 2), away), leaving.line))
            leaving = None
        if step is None:
            break
        if step.speed:
            come = _hasty(step)
        elif word in HANDS:
            leaving, waits = step, 0.0
        elif word == "Delay" and step.numbers:
            waits += step.numbers[0]
    for key, line in told:
        yield Feature(Channel.MANNER, "hand", key, line)
    for (one, line), (two, _) in pairwise(told):
        yield Feature(Channel.MANNER, "two hands", (*one, *two), line)


def _rows(kind: str, words: Sequence[str], steps: Sequence[Step], length: int) -> Iterator[Feature]:
    for k in range(len(words) - length + 1):
        key = tuple(words[k : k + length])
        yield Feature(Channel.STEPS, f"{length} {kind}", key, steps[k].line)


def _numbered(step: Step) -> str:
    return f"{step.name}({';'.join(f'{n:g}' for n in step.numbers)})"


def _hasty(step: Step) -> str:
    return f"{step.name} at {step.speed}" if step.speed else step.name
