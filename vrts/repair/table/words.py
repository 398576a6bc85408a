"""Other keywords and operators: MOVE for MOVES, APPRO for MOVE, ALWAYS, a condition's sense."""

import math
from collections.abc import Collection, Iterator, Sequence
from types import MappingProxyType

from vrts.lang.syntax.expressions import Infix, Item, Number, Prefix
from vrts.lang.syntax.statements import (
    Goto,
    If,
    Setting,
    Simple,
    SpeedStatement,
    Until,
    While,
)
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.nodes import nodes, operands, parts
from vrts.repair.table.asked import Asked, written_number
from vrts.repair.table.numbers import value_of
from vrts.repair.table.placing import HAND, is_first_of_hand
from vrts.repair.written import WrittenStep

INSTEAD = MappingProxyType(
    {
        "MOVE": ("MOVES",),
        "MOVES": ("MOVE",),
        "APPRO": ("APPROS",),
        "APPROS": ("APPRO",),
        "DEPART": ("DEPARTS",),
        "DEPARTS": ("DEPART",),
        "OPEN": ("OPENI", "CLOSE", "CLOSEI"),
        "CLOSE": ("CLOSEI", "OPEN", "OPENI"),
        "OPENI": ("CLOSEI", "OPEN"),
        "CLOSEI": ("OPENI", "CLOSE"),
        "RELAX": ("OPENI", "CLOSEI"),
        "RELAXI": ("OPENI", "CLOSEI"),
        "COARSE": ("FINE",),
        "RIGHTY": ("LEFTY",),
        "LEFTY": ("RIGHTY",),
        "ABOVE": ("BELOW",),
        "BELOW": ("ABOVE",),
        "FLIP": ("NOFLIP",),
        "NOFLIP": ("FLIP",),
    }
)
NEAR = MappingProxyType({"MOVE": "APPRO", "MOVES": "APPROS"})  # with a distance
WAYS = ({"MOVE", "MOVES"}, {"APPRO", "APPROS"}, {"DEPART", "DEPARTS"})
STRAIGHT = frozenset({"MOVES", "APPROS"})
BLAMED = 0.3  # how little is said against a line that is to blame for sure
ACROSS = (
    0.5  # what a teacher says against a straight way there, if the program goes round elsewhere
)
ANOTHER_WAY = 0.25  # what a teacher says against another way to the same place: it may be luck
MISSING = 0.35  # and against going where one only goes near, if no step beside it is about it
UNVISITED = 0.4  # what a teacher says against going near a location that nothing goes to
AFTER_HAND = 0.3  # what speaks for a way out behind a step of the hand
SETTLED = 0.6  # and against taking ALWAYS from the one step that sets the usual speed
HEIGHTS = (120, 100, 80, 60, 150, 200, 40)
COMPARED = ("<", "<=", ">", ">=", "==", "<>")
SUMS = ("+", "-")
PRODUCTS = ("*", "/")
LOGICAL = ("AND", "OR", "XOR")


def other_words(asked: Asked) -> Iterator[Candidate]:
    """Yield every step with another keyword or operator, alone and with all that are alike."""
    alike: dict[tuple[str, str], list[WrittenStep]] = {}
    for step in asked.steps:
        word = getattr(step.statement, "word", "")
        for k, other in enumerate(INSTEAD.get(word, ())):
            yield _word(asked, step, word, other, 0.15 * k)
            alike.setdefault((word, other), []).append(step)
        yield from _near(asked, step)
        yield from _always(asked, step)
        yield from _operators(asked, step)
    for (word, other), steps in alike.items():
        if len(steps) > 1:
            yield _words(asked, steps, word, other)
    yield from _waiting(asked)


def keyword_end(asked: Asked, step: WrittenStep) -> int:
    """Return the offset behind the keyword of a step."""
    text = asked.written.text
    end = step.start
    while end < step.end and (text[end].isalnum() or text[end] in "._"):
        end += 1
    return end


def _word(
    asked: Asked, step: WrittenStep, word: str, other: str, unusual: float, size: float = 1
) -> Candidate:
    end = keyword_end(asked, step)
    edit = replacement(asked.written.source, step.start, end, other)
    doubt = ANOTHER_WAY if {word, other} in WAYS else 0.0
    if doubt and other in STRAIGHT and asked.ways and asked.against(step.line) < BLAMED:
        doubt += ACROSS
    against = None
    if word.startswith("CLOSE") and other.startswith("OPEN") and is_first_of_hand(asked, step):
        against, unusual = 0.0, unusual - 0.3  # the hand is closed when a run starts
    return asked.candidate(
        Does.WORD,
        step.line,
        (edit,),
        size=size,
        unusual=unusual,
        against=against,
        old=word,
        new=other,
        doubt=doubt,
    )


def _words(asked: Asked, steps: list[WrittenStep], word: str, other: str) -> Candidate:
    source = asked.written.source
    edits = [replacement(source, s.start, keyword_end(asked, s), other) for s in steps]
    line = min((step.line for step in steps), key=asked.against)
    return asked.candidate(
        Does.WORD, line, edits, size=len(steps), priced=1.6, unusual=0.3, old=word, new=other
    )


def _waiting(asked: Asked) -> Iterator[Candidate]:
    """Yield OPENI for every OPEN and CLOSEI for every CLOSE: nobody waits for the hand."""
    source = asked.written.source
    steps = [s for s in asked.steps if getattr(s.statement, "word", "") in ("OPEN", "CLOSE")]
    words = dict.fromkeys(getattr(step.statement, "word", "") for step in steps)
    if len(words) < 2:
        return
    ends = [keyword_end(asked, step) for step in steps]
    edits = [replacement(source, end, end, "I") for end in ends]
    line = min((step.line for step in steps), key=asked.against)
    yield asked.candidate(
        Does.WORD,
        line,
        edits,
        size=len(steps),
        priced=1.2,
        unusual=-0.2,
        old="every OPEN and CLOSE",
        new="OPENI and CLOSEI, which wait for the hand",
    )


def _near(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    """Yield APPRO for MOVE with a distance, and MOVE for APPRO without one."""
    statement = step.statement
    if not isinstance(statement, Simple):
        return
    source = asked.written.source
    end = keyword_end(asked, step)
    given = [each for each in statement.operands if each is not None]
    doubt = 0.0 if given and _visited(asked, given[0]) > 1 else UNVISITED
    if statement.word in NEAR and len(given) == 1:
        for k, height in enumerate(_heights(asked)):
            text = f"{NEAR[statement.word]}{source.text[end : given[0].end]}, "
            new = text + written_number(height)
            edit = replacement(source, step.start, given[0].end, new)
            unusual = 0.1 + 0.08 * k
            old = source.text[step.start : given[0].end]
            yield asked.candidate(
                Does.WORD,
                step.line,
                (edit,),
                size=2,
                unusual=unusual,
                old=old,
                new=new,
                doubt=doubt,
            )
    if statement.word in NEAR.values() and len(given) == 2:
        bare = "MOVE" + statement.word.removeprefix("APPRO")
        old = source.text[step.start : given[1].end]
        yield from _away(asked, step, given[1])
        again = 0.5 if _approached_before(asked, step, given[0]) else 0.0
        alone = 0.0 if again or _is_gone_to_soon(asked, step, given[0]) else MISSING
        if _lacks(asked, given[1]):
            again += 0.5
        for k, word in enumerate((bare, "MOVES" if bare == "MOVE" else "MOVE")):
            new = f"{word}{source.text[end : given[0].end]}"
            edit = replacement(source, step.start, given[1].end, new)
            size = 1 + nodes(given[1])
            yield asked.candidate(
                Does.WORD,
                step.line,
                (edit,),
                size=size,
                unusual=0.1 + 0.2 * k - again,
                old=old,
                new=new,
                doubt=alone,
            )


def _away(asked: Asked, step: WrittenStep, distance: Item) -> Iterator[Candidate]:
    """Yield a way out from where the hand has moved, in place of the way near something."""
    k = asked.written.steps.index(step)
    before = asked.written.steps[k - 1] if k else None
    after_hand = before is not None and getattr(before.statement, "word", "") in HAND
    for n, word in enumerate(("DEPARTS", "DEPART")):
        new = f"{word} {asked.text_of(distance)}"
        yield asked.candidate(
            Does.WORD,
            step.line,
            (replacement(asked.written.source, step.start, distance.end, new),),
            size=2,
            unusual=0.1 + 0.2 * n - (AFTER_HAND if after_hand else 0.0),
            old=asked.written.text[step.start : distance.end],
            new=new,
            doubt=0.0 if after_hand else MISSING,
        )


def _visited(asked: Asked, target: Item) -> int:
    """Return how many motions go to a location or near it."""
    text = asked.text_of(target)
    return sum(
        isinstance(step.statement, Simple)
        and step.statement.word in (*NEAR, *NEAR.values())
        and step.statement.operands[0] is not None
        and asked.text_of(step.statement.operands[0]) == text
        for step in asked.written.steps
    )


def _lacks(asked: Asked, distance: Item) -> bool:
    """Return whether a thing is just as far from where it should be as a step says."""
    if not isinstance(distance, Number):
        return False
    return any(abs(math.hypot(*each) - distance.value) < 1.0 for each in asked.blame.residuals)


def _approached_before(asked: Asked, step: WrittenStep, target: Item) -> bool:
    """Return whether a step shortly before one approaches the same location."""
    steps = asked.written.steps
    k = steps.index(step)
    return _leads_there(asked, steps[max(k - 4, 0) : k], step.program, NEAR.values(), target)


def _is_gone_to_soon(asked: Asked, step: WrittenStep, target: Item) -> bool:
    """Return whether a step shortly behind one goes to the same location."""
    steps = asked.written.steps
    k = steps.index(step)
    return _leads_there(asked, steps[k + 1 : k + 5], step.program, NEAR.keys(), target)


def _leads_there(
    asked: Asked,
    steps: Sequence[WrittenStep],
    program: int,
    words: Collection[str],
    target: Item,
) -> bool:
    """Return whether a step of a program has one of the words, and a location as its first."""
    return any(
        each.program == program
        and isinstance(each.statement, Simple)
        and each.statement.word in words
        and each.statement.operands[0] is not None
        and asked.text_of(each.statement.operands[0]) == asked.text_of(target)
        for each in steps
    )


def _heights(asked: Asked) -> list[float]:
    """Return the distances of APPRO in the program, then usual ones."""
    found: dict[float, None] = {}
    for step in asked.written.steps:
        match step.statement:
            case Simple("APPRO" | "APPROS", (_, distance)) if distance is not None:
                try:
                    found[value_of(distance)] = None
                except AssertionError:
                    continue
            case _:
                continue
    return [*found, *(float(h) for h in HEIGHTS if h not in found)]


def _always(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    statement = step.statement
    if not isinstance(statement, SpeedStatement | Setting):
        return
    source = asked.written.source
    text = source.text[step.start : step.end]
    if statement.always:
        at = step.start + text.upper().rindex("ALWAYS")
        blank = at - len(text[: at - step.start]) + len(text[: at - step.start].rstrip())
        edit = replacement(source, blank, at + len("ALWAYS"), "")
        yield asked.candidate(
            Does.WORD,
            step.line,
            (edit,),
            unusual=0.15,
            old=text.strip(),
            new=text.strip()[:-7],
            doubt=SETTLED if _is_the_only_speed(asked, step) else 0.0,
        )
    else:
        end = step.start + len(text.rstrip())
        edit = replacement(source, end, end, " ALWAYS")
        yield asked.candidate(
            Does.WORD,
            step.line,
            (edit,),
            unusual=0.15,
            old=text.strip(),
            new=f"{text.strip()} ALWAYS",
        )


def _is_the_only_speed(asked: Asked, step: WrittenStep) -> bool:
    """Return whether no other step sets a speed for good."""
    settled = [
        each
        for each in asked.written.steps
        if isinstance(each.statement, SpeedStatement) and each.statement.always
    ]
    return settled == [step]


def _operators(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    statement = step.statement
    decides = isinstance(statement, If | While | Until | Goto)
    source = asked.written.source
    for item in operands(statement):
        for part in parts(item):
            if isinstance(part, Infix):
                yield from _operator(asked, step, part)
            elif isinstance(part, Prefix) and not isinstance(part.operand, Number):
                inner = asked.text_of(part.operand)
                yield asked.instead(Does.WORD, step.line, part, inner, unusual=0.2)
        if decides:
            text = source.text[item.start : item.end]
            yield asked.instead(Does.WORD, step.line, item, f"NOT ({text})", size=2, unusual=0.3)


def _operator(asked: Asked, step: WrittenStep, part: Infix) -> Iterator[Candidate]:
    for group in (COMPARED, SUMS, PRODUCTS, LOGICAL):
        if part.operator not in group:
            continue
        source = asked.written.source
        at = part.operator_start
        end = part.right.start
        old = source.text[at:end].split()[0]
        if old.startswith(part.operator):
            old = part.operator
        for k, other in enumerate(group):
            if other == part.operator:
                continue
            edit = replacement(source, at, at + len(old), other)
            yield asked.candidate(
                Does.WORD, step.line, (edit,), unusual=0.1 + 0.1 * (k > 2), old=old, new=other
            )
