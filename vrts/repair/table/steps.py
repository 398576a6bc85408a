"""A step more, a step less, and steps in another order."""

from collections.abc import Iterator

from vrts.base.diagnostic import Edit
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name
from vrts.lang.syntax.statements import (
    Simple,
    SpeedStatement,
)
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.nodes import nodes_of_step
from vrts.repair.table.asked import MOVES_TO, Asked, names_in
from vrts.repair.table.placing import fits, idle_hand, in_place, opens, same, there
from vrts.repair.table.wanted import BLOCKS, Wanted, movable, wanted_steps
from vrts.repair.visits import stop_of
from vrts.repair.written import WrittenStep

APPROACHES = (120, 100, 60, 150)
IDLE_HAND = 0.4  # what a teacher says against a step of the hand that moves no finger
LEFT = 0.5  # what a teacher says against leaving a location that was taught and named unused
NEEDED = 0.4  # what a teacher says against a motion that is too much, unless it is there twice
EARLIER = 0.06  # of two steps that are alike the later one is too much
THERE = 0.5  # what a teacher says against a step more that stands there already, nearly
OTHERWISE = 0.6  # and against a program that nobody calls, called by another than the first
AMID = 2  # steps beside a READY of which one is of a visit
OFF = 0.8  # what a teacher says against leaving a way past several places for one that it has been
EARLY = 0.02  # for each step before it: a number is set at the beginning
SURELY = 0.7  # of a step that is as much to blame as this
GONE_BY = 0.2  # that a teacher says less against it, for each node
GO_BY = 0.35  # what speaks for going by a place, as the program does elsewhere, before it
CLOSED = 0.3  # how little the first motion is to blame for a hand that nobody opened before
ORDERLY = 0.9  # what speaks for an order in which the program does all as it does elsewhere
FARTHEST = 6  # steps that a step may have to be moved by
RARE = frozenset({"BASE", "TOOL", "DRIVE", "SINGLE", "RETURN", "STOP", "HALT", "PAUSE", "DELAY"})


def other_steps(asked: Asked) -> Iterator[Candidate]:
    """Yield the program with a step less, more, or elsewhere."""
    steps = asked.written.steps
    for step in asked.steps:
        if not isinstance(step.statement, BLOCKS):
            yield _without(asked, step, steps)
    wanted = list(wanted_steps(asked))
    for k, step in enumerate(steps):
        yield from _more(asked, k, wanted)
        if not isinstance(step.statement, BLOCKS):
            yield from _elsewhere(asked, k)
    yield from _everywhere(asked)


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
    rare = step.text.split()[0].upper() in RARE or _is_amid(asked, k)
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


def _is_amid(asked: Asked, k: int) -> bool:
    """Return whether a step is READY with motions before and behind it: it is far from them."""
    steps = asked.written.steps
    if getattr(steps[k].statement, "word", "") != "READY":
        return False
    beside = (steps[max(k - AMID, 0) : k], steps[k + 1 : k + 1 + AMID])
    return all(
        any(each.program == steps[k].program and stop_of(each) is not None for each in some)
        for some in beside
    )


def _is_on_way(asked: Asked, line: int, text: str) -> bool:
    """Return whether a step goes back to a place between two motions past places like it."""
    ways = asked.ways
    behind = next((k for k, each in enumerate(asked.written.steps) if each.line >= line), 0)
    beside = asked.written.steps[max(behind - 1, 0) : behind + 1]
    return text in ways and len(beside) == 2 and all(each.text in ways for each in beside)


def _more(asked: Asked, k: int, wanted: list[Wanted]) -> Iterator[Candidate]:
    """Yield a step more before one, and behind the last of a program."""
    steps = asked.written.steps
    step = steps[k]
    before = steps[k - 1] if k and steps[k - 1].program == step.program else None
    last = k + 1 == len(steps) or steps[k + 1].program != step.program
    reached = asked.matters(step.line) or (before is not None and asked.matters(before.line))
    after = steps[k + 1] if k + 1 < len(steps) and not last else None
    near = [*wanted, *_fitting(asked, k, after)]
    ways = asked.ways
    if reached:
        against = asked.against(step.line)
        if before is not None:
            against = min(against, asked.against(before.line))
        first = opens(asked, k)
        for each in near:
            fit = fits(each.text, before, step) + in_place(each.text, before, step, after)
            if each.text.startswith("CALL ") and each.trust < 1.0:
                fit += OTHERWISE if step.program else 0.3 if before is not None else -0.3
            if each.text in ways and asked.blame.weight(step.line) >= SURELY:
                fit -= GO_BY
            if each.is_number:
                fit += EARLY * min(k, 10)
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
        doubt=each.doubt
        - (GONE_BY * (each.size - 1) if each.text in asked.ways else 0.0)
        + 0.2 * (each.size - 1)
        + (IDLE_HAND if idle_hand(asked, line, each.text) else 0.0)
        + (OFF if _is_on_way(asked, line, each.text) else 0.0)
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
        if by == 1 or stop_of(step) is not None:
            others = (*steps[:k], *steps[k + 1 :])
            moved = (*others[:j], step, *others[j:])
            habit = max(-ORDERLY, 0.3 * min(asked.odder(moved), 0.0))
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
