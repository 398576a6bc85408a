"""Steps that may be missing anywhere: usual ones, those that stand elsewhere, those one lacks."""

import re
from collections import Counter
from collections.abc import Iterator
from itertools import permutations

from vrts.check.task.demands import Keeps
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.lang.syntax.statements import (
    CallStatement,
    Case,
    Declare,
    For,
    If,
    SetLocation,
    Simple,
    SpeedStatement,
    Statement,
    Structure,
    Until,
    ValueGroup,
    While,
)
from vrts.repair.nodes import nodes_of_step, operands, parts
from vrts.repair.table.asked import Asked, names_in, target_of, written_number
from vrts.repair.table.forgotten import forgotten
from vrts.repair.written import WrittenStep

BLOCKS = (For, If, While, Until, Case, ValueGroup, Structure, Declare)
PLAIN = ("OPENI", "CLOSEI", "BREAK", "READY", "SPEED 100 ALWAYS")
DEPARTURES = (60, 100, 120, 150, 200)
UNSET_HEIGHTS = (100.0, 120.0, 60.0, 150.0, 200.0)  # that a number without a value may be worth
UNSET_SPEEDS = (100.0, 50.0, 30.0)
UNSET_COUNTS = (2.0, 3.0, 1.0, 4.0)
FOR_ALL = 0.6  # what speaks against a call of all elements of arrays, but for its size
ALIAS = 0.6  # what a teacher says against another name for a location that is taught
SAYS_NOTHING = frozenset({"TYPE"})  # steps that move nothing: not copied elsewhere


class Wanted:
    """A step that may be missing."""

    def __init__(
        self, text: str, size: int, unusual: float, trust: float = 2.2, doubt: float = 0.0
    ) -> None:
        """Take its text, how many nodes it has, and what speaks against it."""
        self.text, self.size, self.unusual, self.trust = text, size, unusual, trust
        self.doubt = doubt

    @property
    def is_number(self) -> bool:
        """Whether it gives a name a number as it stands."""
        words = self.text.split()
        return words[1:2] == ["="] and words[2].replace(".", "").isdecimal()


def movable(statement: Statement) -> bool:
    """Return whether a step can stand elsewhere without breaking a block."""
    return not isinstance(statement, BLOCKS)


def wanted_steps(asked: Asked) -> Iterator[Wanted]:
    """Yield the steps that may be missing anywhere: usual ones, and those that stand elsewhere."""
    seen: set[str] = set()
    for k, text in enumerate(PLAIN):
        seen.add(text)
        unusual = 0.05 * k + (0.4 if k > 2 else 0.0)
        yield Wanted(text, 3 if " " in text else 1, unusual, 1.3 if k < 3 else 2.2)
    for step in asked.written.steps:
        word = getattr(step.statement, "word", "")
        if not movable(step.statement) or word in SAYS_NOTHING or step.text in seen:
            continue
        seen.add(step.text)
        yield Wanted(step.text, nodes_of_step(step.statement), 0.3)
        for other in _next_in_series(step.text):
            if other not in seen:
                seen.add(other)
                if any(re.search(rf"\b{re.escape(name)}\b", other) for name in asked.idle):
                    yield Wanted(other, nodes_of_step(step.statement), -0.6, 1.0)
                else:
                    yield Wanted(other, nodes_of_step(step.statement), 0.3)
        for other in _of_idle(asked, step):
            if other not in seen:
                seen.add(other)
                yield Wanted(other, nodes_of_step(step.statement), -0.5, 1.2)
    for text, size, unusual, trust in forgotten(asked):
        if text not in seen:
            seen.add(text)
            yield Wanted(text, size, unusual, trust)
    for text, size in _calls_of_arrays(asked):
        yield Wanted(text, size, FOR_ALL - 0.3 * size, 0.5)
    for name, values in _unset(asked).items():
        for k, value in enumerate(values):
            yield Wanted(f"{name} = {written_number(value)}", 3, -0.5 + 0.1 * k, 0.2)
    for name in sorted(asked.undefined - asked.arrays):
        for one in sorted(asked.idle):
            yield Wanted(f"SET {name} = {one}", 3, -0.5, 0.2, ALIAS)
            for other in sorted(asked.idle - {one}):
                yield Wanted(f"SET {name} = {one}:{other}", 5, -0.5, 0.2)
    for counter in _uncounted(asked):
        yield Wanted(f"{counter} = {counter}+1", 4, -0.6, 0.3)
    for program in asked.written.programs[1:]:
        text = f"CALL {program.name}"
        if not program.formals and text not in seen:
            seen.add(text)
            called = program.name in asked.called
            yield Wanted(text, 2, 0.4 if called else -0.6, 2.2 if called else 0.8)
    for demand in asked.task.demands:
        if demand.keeps is Keeps.USES and demand.word == "SIGNAL" and "SIGNAL 1" not in seen:
            yield Wanted("SIGNAL 1", 2, 0.0)
    for height in DEPARTURES:
        for word in ("DEPARTS", "DEPART"):
            text = f"{word} {height}"
            if text not in seen:
                seen.add(text)
                yield Wanted(text, 2, 0.5)


def _calls_of_arrays(asked: Asked) -> Iterator[tuple[str, int]]:
    """Yield calls that the program has, of elements of arrays that are set and that nothing reads.

    With the counter of a loop as subscript, and each with its number of nodes.
    """
    found = [target_of(step) for step in asked.written.steps]
    targets = [each.name for each in found if isinstance(each, Element)]
    times = Counter(key(name.text) for name in targets)
    unread = [name for name in times if asked.used[name] == times[name]]
    loops = [each.statement for each in asked.written.steps if isinstance(each.statement, For)]
    counters = dict.fromkeys(x.target.text for x in loops if isinstance(x.target, Name))
    for step in asked.written.steps:
        statement = step.statement
        if not unread or not isinstance(statement, CallStatement):
            continue
        given = [each for each in statement.arguments if each is not None]
        places = [k for k, each in enumerate(given) if not isinstance(each, Number)]
        if len(places) != len(unread):
            continue
        size = 2 + 2 * len(places) + (len(given) - len(places))
        for counter in counters:
            for names in permutations(unread):
                texts = [asked.text_of(each) for each in given]
                for k, name in zip(places, names, strict=True):
                    texts[k] = f"{name}[{counter}]"
                yield f"CALL {statement.program.text}({', '.join(texts)})", size
                for k in (k for k in range(len(given)) if k not in places):
                    for other in DEPARTURES:
                        others = ", ".join((*texts[:k], f"{other}", *texts[k + 1 :]))
                        yield f"CALL {statement.program.text}({others})", size


def _unset(asked: Asked) -> dict[str, tuple[float, ...]]:
    """Return the numbers that steps use and nothing sets, each with what it may be worth."""
    found: dict[str, tuple[float, ...]] = {}
    for step in asked.written.steps:
        match step.statement:
            case Simple("DEPART" | "DEPARTS", (away, *_)) | Simple("APPRO" | "APPROS", (_, away)):
                values = UNSET_HEIGHTS
            case SpeedStatement():
                away, values = next(operands(step.statement), None), UNSET_SPEEDS
            case For() | While() | If() | Until():
                away, values = None, UNSET_COUNTS
            case _:
                continue
        items = operands(step.statement) if away is None else (away,)
        for part in (part for item in items for part in parts(item)):
            if isinstance(part, Name) and key(part.text) in asked.undefined:
                found.setdefault(part.text, values)
    return found


def _uncounted(asked: Asked) -> list[str]:
    """Return the variables of conditions of WHILE that are set once, before: nobody counts."""
    targets = [target_of(step) for step in asked.written.steps]
    times = Counter(key(target.text) for target in targets if isinstance(target, Name))
    found: list[str] = []
    for step in asked.written.steps:
        if isinstance(step.statement, While):
            names = [name.text for name in names_in(step)]
            if not any(times[key(name)] > 1 for name in names):
                found += [name for name in names if times[key(name)] == 1]
    return list(dict.fromkeys(found))


def _of_idle(asked: Asked, step: WrittenStep) -> Iterator[str]:
    """Yield a step with its locations replaced by those that no step names."""
    if not asked.idle or not isinstance(step.statement, CallStatement | SetLocation | Simple):
        return
    names = [
        part
        for part in names_in(step)
        if key(part.text) in asked.locations and part is not target_of(step)
    ]
    text = asked.written.text
    if not names or len(names) > 2:
        return
    for given in permutations(sorted(asked.idle), len(names)):
        made, at = "", step.start
        for part, name in zip(names, given, strict=True):
            made += text[at : part.start] + name
            at = part.end
        yield (made + text[at : step.end]).rstrip()


def _next_in_series(text: str) -> Iterator[str]:
    """Yield a step with the subscripts and numbers of names one higher and one lower."""
    if "[" not in text and not re.search(r"[a-z]\d", text):
        return
    for by in (1, -1):
        yield re.sub(
            r"(?<=[A-Za-z\[])\d+", lambda found, by=by: str(max(0, int(found[0]) + by)), text
        )
