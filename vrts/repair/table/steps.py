"""A step more, a step less, and steps in another order."""

import re
from collections import Counter
from collections.abc import Iterator
from itertools import permutations

from vrts.base.diagnostic import Edit
from vrts.check.task.demands import Keeps
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name
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
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.nodes import nodes_of_step
from vrts.repair.table.asked import MOVES_TO, Asked, names_in, target_of
from vrts.repair.table.placing import fits, idle_hand, in_place, opens, same, there
from vrts.repair.written import WrittenStep

BLOCKS = (For, If, While, Until, Case, ValueGroup, Structure, Declare)
PLAIN = ("OPENI", "CLOSEI", "BREAK", "READY", "SPEED 100 ALWAYS")
DEPARTURES = (60, 100, 120, 150, 200)
APPROACHES = (120, 100, 60, 150)
IDLE_HAND = 0.4  # what a teacher says against a step of the hand that moves no finger
LEFT = 0.5  # what a teacher says against leaving a location that was taught and named unused
NEEDED = 0.4  # what a teacher says against a motion that is too much, unless it is there twice
EARLIER = 0.06  # of two steps that are alike the later one is too much
THERE = 0.5  # what a teacher says against a step more that stands there already, nearly
OTHERWISE = 0.6  # and against a program that nobody calls, called by another than the first
CLOSED = 0.3  # how little the first motion is to blame for a hand that nobody opened before
ORDERLY = 0.9  # what speaks for an order in which the program does all as it does elsewhere
FARTHEST = 6  # steps that a step may have to be moved by
RARE = frozenset({"BASE", "TOOL", "DRIVE", "SINGLE", "RETURN", "STOP", "HALT", "PAUSE", "DELAY"})
SAYS_NOTHING = frozenset({"TYPE"})  # steps that move nothing: not copied elsewhere


class Wanted:
    """A step that may be missing."""

    def __init__(self, text: str, size: int, unusual: float, trust: float = 2.2) -> None:
        """Take its text, how many nodes it has, and what speaks against it."""
        self.text, self.size, self.unusual, self.trust = text, size, unusual, trust


def other_steps(asked: Asked) -> Iterator[Candidate]:
    """Yield the program with a step less, more, or elsewhere."""
    steps = asked.written.steps
    for step in asked.steps:
        if not isinstance(step.statement, BLOCKS):
            yield _without(asked, step, steps)
    wanted = list(_wanted(asked))
    for k, step in enumerate(steps):
        yield from _more(asked, k, wanted)
        if not isinstance(step.statement, BLOCKS):
            yield from _elsewhere(asked, k)
    yield from _everywhere(asked)


def movable(statement: Statement) -> bool:
    """Return whether a step can stand elsewhere without breaking a block."""
    return not isinstance(statement, BLOCKS)


def _without(asked: Asked, step: WrittenStep, steps: tuple[WrittenStep, ...]) -> Candidate:
    written = asked.written
    start, end = written.line_start(step.line), written.line_start(step.line + 1)
    k = steps.index(step)
    beside = [steps[j].text for j in (k - 1, k + 1) if 0 <= j < len(steps)]
    again = any(same(step.text, text) for text in beside)
    earlier = any(
        same(step.text, each.text) for each in steps[k + 1 : k + 5] if each.program == step.program
    )
    near = steps[max(k - 4, 0) : k + 5]
    stops = step.text.strip().upper() == "BREAK"  # without it corners are rounded: that may be luck
    twice = (
        not stops
        and sum(each.program == step.program and same(step.text, each.text) for each in near) > 1
    )
    rare = step.text.split()[0].upper() in RARE
    plain = isinstance(step.statement, Simple) and not any(names_in(step))
    alone = any(
        asked.used[name] == 1 and name in asked.row_names
        for name in (key(each.text) for each in names_in(step))
    )
    return asked.candidate(
        Does.REMOVE,
        step.line,
        (replacement(written.source, start, end, ""),),
        size=nodes_of_step(step.statement),
        priced=1,
        unusual=(-0.4 if again else -0.25 if twice else -0.3 if rare else 0.25)
        + (EARLIER if earlier else 0.0),
        trust=0.8 if rare else None,
        old=step.text,
        doubt=LEFT
        if alone
        else -0.3
        if again
        else NEEDED
        if stops or not (plain or twice)
        else 0.0,
    )


def _wanted(asked: Asked) -> Iterator[Wanted]:
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
    for name in sorted(asked.undefined - asked.arrays):
        for one in sorted(asked.idle):
            yield Wanted(f"SET {name} = {one}", 3, -0.5, 0.2)
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


def _more(asked: Asked, k: int, wanted: list[Wanted]) -> Iterator[Candidate]:
    """Yield a step more before one, and behind the last of a program."""
    steps = asked.written.steps
    step = steps[k]
    before = steps[k - 1] if k and steps[k - 1].program == step.program else None
    last = k + 1 == len(steps) or steps[k + 1].program != step.program
    reached = asked.matters(step.line) or (before is not None and asked.matters(before.line))
    after = steps[k + 1] if k + 1 < len(steps) and not last else None
    near = [*wanted, *_fitting(asked, k, after)]
    if reached:
        against = asked.against(step.line)
        if before is not None:
            against = min(against, asked.against(before.line))
        first = opens(asked, k)
        for each in near:
            fit = fits(each.text, before, step) + in_place(each.text, before, step, after)
            if each.text.startswith("CALL ") and each.trust < 1.0:
                fit += OTHERWISE if step.program else 0.3 if before is not None else -0.3
            hand = first and each.text == "OPENI"  # closed when a run starts
            fit, blamed = (-0.5, min(against, CLOSED)) if hand else (fit, against)
            yield _added(asked, step.line, step, each, blamed, fit)
    if last and asked.matters(step.line):
        for each in near:
            fit = fits(each.text, step, None)
            line = step.line + 1
            yield _added(asked, line, step, each, asked.against(step.line), fit)


def _added(
    asked: Asked, line: int, beside: WrittenStep, each: Wanted, against: float, fit: float
) -> Candidate:
    written = asked.written
    at = written.line_start(line)
    text = f"{written.indent(beside.line)}{each.text}\n"
    return asked.candidate(
        Does.ADD,
        line,
        (replacement(written.source, at, at, text),),
        size=each.size,
        priced=1 + 0.3 * (each.size - 1),
        against=against,
        trust=each.trust,
        unusual=each.unusual + fit,
        new=each.text,
        doubt=0.2 * (each.size - 1)
        + (IDLE_HAND if idle_hand(asked, line, each.text) else 0.0)
        + (THERE if there(asked, beside, line, each.text) else 0.0),
        group=-at if each.size == 1 else hash_of(each.text),
    )


def hash_of(text: str) -> int:
    """Return a number for the keyword of a step: the same in every process."""
    return -sum(ord(sign) * 31**k for k, sign in enumerate(text.split()[0][:6]))


def _fitting(asked: Asked, k: int, after: WrittenStep | None) -> Iterator[Wanted]:
    """Yield motions to the places that the steps beside name, over a step of SPEED too."""
    steps = asked.written.steps
    before = [each for each in steps[max(k - 2, 0) : k] if each.program == steps[k].program]
    beside_it = before[-1:]
    if beside_it and isinstance(beside_it[0].statement, SpeedStatement):
        beside_it = before[:1]
    following = after if isinstance(steps[k].statement, SpeedStatement) else steps[k]
    for beside in (*beside_it, following):
        target = None if beside is None else _target(asked, beside)
        if target is None:
            continue
        size = target.count("[") + target.count(":") * 2 + 1
        yield Wanted(f"MOVES {target}", 1 + size, 0.0)
        yield Wanted(f"MOVE {target}", 1 + size, 0.2)
        for height in APPROACHES:
            yield Wanted(f"APPRO {target}, {height}", 2 + size, 0.2)


def _target(asked: Asked, step: WrittenStep) -> str | None:
    """Return the location that a step moves to or near."""
    match step.statement:
        case Simple(word, (Name() | Element() as target, *_)) if word in MOVES_TO:
            return asked.text_of(target)
        case _:
            return None


def _elsewhere(asked: Asked, k: int) -> Iterator[Candidate]:
    """Yield a step a few steps further down or up."""
    steps = asked.written.steps
    step = steps[k]
    written = asked.written
    size = 2 * nodes_of_step(step.statement)
    for by in (*range(-FARTHEST, 0), *range(1, FARTHEST + 1)):
        j = k + by
        if not 0 <= j < len(steps) or steps[j].program != step.program:
            continue
        passed = steps[min(k, j) : max(k, j) + 1]
        if not any(asked.matters(each.line) for each in passed):
            continue
        if by == -1 and movable(steps[j].statement):
            continue  # that one moved down is the same
        smaller = min(size, 2 * nodes_of_step(steps[j].statement)) if abs(by) == 1 else size
        against = min(asked.against(each.line) for each in passed)
        to = steps[j].line if by < 0 else steps[j].line + 1
        at = written.line_start(to)
        start, end = written.line_start(step.line), written.line_start(step.line + 1)
        text = written.text[start:end]
        blocks = any(not movable(each.statement) for each in passed if each is not step)
        habit = 0.0
        if by == 1:
            swapped = (*steps[:k], steps[j], step, *steps[j + 1 :])
            habit = max(-ORDERLY, 0.3 * min(asked.odder(swapped), 0.0))
        yield asked.candidate(
            Does.ORDER,
            step.line,
            (
                replacement(written.source, start, end, ""),
                replacement(written.source, at, at, text),
            ),
            size=smaller,
            priced=1.6 + 0.2 * (smaller / 2 - 1),
            against=against,
            unusual=0.2 + 0.1 * (abs(by) - 1) + (0.3 if blocks else 0.0) + habit,
            old=step.text,
            new=step.text,
        )


def _everywhere(asked: Asked) -> Iterator[Candidate]:
    """Yield a step more before or behind all steps of one keyword: forgotten every time."""
    places: dict[str, list[WrittenStep]] = {}
    for step in asked.steps:
        word = getattr(step.statement, "word", "")
        if word in ("OPEN", "CLOSE", "OPENI", "CLOSEI", "MOVES", "DEPARTS"):
            places.setdefault(word, []).append(step)
    written = asked.written
    for word, steps in places.items():
        if len(steps) < 2:
            continue
        line = min((step.line for step in steps), key=asked.against)
        for text in ("BREAK", "OPENI", "CLOSEI"):
            for behind in (0, 1):
                edits: list[Edit] = []
                for step in steps:
                    at = written.line_start(step.line + behind)
                    more = f"{written.indent(step.line)}{text}\n"
                    edits.append(replacement(written.source, at, at, more))
                said = "after" if behind else "before"
                yield asked.candidate(
                    Does.ADD,
                    line,
                    edits,
                    size=len(steps),
                    priced=1.8,
                    unusual=0.4,
                    old=f"{said} every `{word}`",
                    new=text,
                )
