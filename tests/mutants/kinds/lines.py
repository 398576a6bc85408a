"""Mistakes of whole steps: forgotten, superfluous, in the wrong order."""

from collections.abc import Callable
from random import Random

from tests.mutants.kinds.sites import BLOCKS, Kind, known_places, of, steps, with_lines
from tests.mutants.reading import Written, WrittenStep

HAND = ("OPENI", "CLOSEI", "OPEN", "CLOSE")


def missing_hand(written: Written, chance: Random) -> str | None:
    """A step of the hand forgotten."""
    return _without(written, chance, lambda word: word in HAND)


def missing_motion(written: Written, chance: Random) -> str | None:
    """A motion forgotten: an approach, a departure, a way round."""
    return _without(written, chance, lambda word: word.startswith(("MOVE", "APPRO", "DEPART")))


def missing_setting(written: Written, chance: Random) -> str | None:
    """A step forgotten that sets something or waits: SPEED, BREAK, SIGNAL, SET, DELAY."""
    words = ("SPEED", "BREAK", "SIGNAL", "SET", "DELAY", "READY", "TOOL")
    return _without(written, chance, lambda word: word in words or "=" in word)


def missing_call(written: Written, chance: Random) -> str | None:
    """A CALL forgotten."""
    return _without(written, chance, lambda word: word == "CALL")


def superfluous(written: Written, chance: Random) -> str | None:
    """A step that should not be there."""
    found = of(chance, [pair for pair in steps(written) if _plain(pair[1])])
    if found is None:
        return None
    program, step = found
    place = chance.choice(known_places(written, program))
    typed = (
        *("OPENI", "CLOSEI", "OPEN", "CLOSE", "READY", "RETURN", "STOP"),
        *("DELAY 2", "DELAY 5", "DELAY 10", "SPEED 10", "SPEED 5 ALWAYS", "SPEED 10 ALWAYS"),
        *("DEPARTS 50", "DEPARTS -20", "DEPART 100", "DRIVE 1, 20, 50", "DRIVE 6, 90, 50"),
        *("BASE 0, 0, 50", "TOOL", f"MOVE {place}", f"MOVES {place}", f"APPRO {place}, 50"),
        *("SINGLE ALWAYS", "READY"),
    )
    lines = written.lines
    lines.insert(step.line, _indent(lines[step.line - 1]) + chance.choice(typed))
    return with_lines(lines)


def repeated(written: Written, chance: Random) -> str | None:
    """A step written once more, beside itself or some lines on, as copying leaves it."""
    found = of(chance, [pair for pair in steps(written) if _plain(pair[1])])
    if found is None:
        return None
    program, step = found
    last = program.steps[-1].line
    lines = written.lines
    at = min(step.line + chance.choice((0, 1, 2, 3)), last)
    lines.insert(at, _indent(lines[step.line - 1]) + step.text)
    return with_lines(lines)


def exchanged(written: Written, chance: Random) -> str | None:
    """Two steps one after the other exchanged."""
    pairs = [
        (one.line, two.line)
        for program in written.programs
        for one, two in zip(program.steps, program.steps[1:], strict=False)
        if _plain(one) and _plain(two) and one.text != two.text
    ]
    pair = of(chance, pairs)
    if pair is None:
        return None
    one, two = pair
    lines = written.lines
    lines[one - 1], lines[two - 1] = lines[two - 1], lines[one - 1]
    return with_lines(lines)


def moved(written: Written, chance: Random) -> str | None:
    """A step that stands two to four steps too early or too late."""
    sites = [
        (program, k, k + far)
        for program in written.programs
        for k, step in enumerate(program.steps)
        for far in (-4, -3, -2, 2, 3, 4)
        if _plain(step, blocks=True) and 0 <= k + far < len(program.steps)
    ]
    site = of(chance, sites)
    if site is None:
        return None
    program, k, target = site
    lines = written.lines
    line = lines.pop(program.steps[k].line - 1)
    lines.insert(program.steps[target].line - 1, line)
    return with_lines(lines)


def _without(written: Written, chance: Random, wanted: Callable[[str], bool]) -> str | None:
    sites = [step for _, step in steps(written) if _plain(step) and wanted(_word(step))]
    step = of(chance, sites)
    if step is None:
        return None
    lines = written.lines
    del lines[step.line - 1]
    return with_lines(lines)


def _word(step: WrittenStep) -> str:
    first, _, rest = step.text.partition(" ")
    return "=" if rest.startswith("=") else first.upper()


def _plain(step: WrittenStep, *, blocks: bool = False) -> bool:
    """Return whether a step is an instruction, or, where asked, the word of a block."""
    return blocks or type(step.step.statement).__name__ not in BLOCKS


def _indent(line: str) -> str:
    return line[: len(line) - len(line.lstrip())]


LINES: dict[str, Kind] = {
    "missing-hand": missing_hand,
    "missing-motion": missing_motion,
    "missing-setting": missing_setting,
    "missing-call": missing_call,
    "superfluous-step": superfluous,
    "repeated-step": repeated,
    "exchanged-steps": exchanged,
    "moved-step": moved,
}
