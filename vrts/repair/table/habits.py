"""What a program does at all places but one: the step, word or distance that is missing there."""

from collections import Counter
from collections.abc import Iterator, Sequence

from vrts.base.diagnostic import Edit
from vrts.base.source import SourceFile
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import Asked, written_number
from vrts.repair.table.placing import idle_hand
from vrts.repair.visits import (
    WORDS,
    Part,
    Stop,
    Visit,
    number,
    odd_distances,
    oddness,
    turned_rows,
    visits,
)
from vrts.repair.written import WrittenStep, read

HABIT = -0.45  # what speaks for a step that a place lacks and most places have
STANDS_OUT = -0.5  # and for another distance where one stands out
AS_MOST = -0.3  # and for a location turned like most
TRUSTED = 1.0  # what it costs that its line is not to blame
FEW = 3  # parts that a visit may lack to be one that is not finished
MOST = 3  # usual distances tried
RATE = 0.45  # what a teacher says against a change that makes a program odder by one
MOST_ODD = 1.4  # and at most
CURED = 0.8  # what speaks for one that makes it less odd, at most


def odder(asked: Asked, text: str) -> float:
    """Return what its own habits say against what a program becomes; less than 0: for it."""
    source = SourceFile(asked.written.source.name, text)
    by = RATE * (oddness(read(source, asked.dialect), asked.usual) - asked.oddness)
    return max(-CURED, min(MOST_ODD, by))


def as_usual(asked: Asked) -> Iterator[Candidate]:
    """Yield the program with one visit made like its others, and with all that lack the same."""
    found = visits(asked.written)
    usual = asked.usual.parts
    for visit in found:
        lacks = usual - {stop.part for stop in visit.stops}
        whole = visit.of(Part.HAND) is not None or visit.of(Part.LEAVE) is not None
        if whole and len(lacks - {Part.SPEED}) < FEW:
            for part in sorted(lacks):
                yield from _more(asked, found, visit, part)
    yield from _go_there(asked, found)
    yield from _distances(asked, found)
    yield from _turned(asked)


def _turned(asked: Asked) -> Iterator[Candidate]:
    """Yield each location that is turned otherwise than most turned like them."""
    usual = asked.usual.turned
    for row, turn in turned_rows(asked.written, usual):
        if not asked.matters(row.line):
            continue
        values = row.node.values[3:]
        edits = [
            replacement(asked.written.source, value.start, value.end, written_number(other))
            for value, at, other in zip(values, turn, usual, strict=True)
            if at != other
        ]
        yield asked.candidate(
            Does.NUMBER if len(edits) == 1 else Does.ROW,
            row.line,
            edits,
            size=len(edits),
            priced=1.2,
            unusual=AS_MOST,
            trust=TRUSTED,
            old=" ".join(edit.span.text for edit in edits),
            new=" ".join(edit.replacement for edit in edits),
        )


def _more(asked: Asked, found: Sequence[Visit], visit: Visit, part: Part) -> Iterator[Candidate]:
    """Yield a visit with the step that it lacks."""
    after = next((stop for stop in visit.stops if stop.part > part), None)
    beside = visit.stops[-1].step if after is None else after.step
    line = beside.line + (after is None)
    against = min(asked.against(each) for each in visit.lines)
    if not any(asked.matters(each) for each in visit.lines):
        return
    for k, (text, size) in enumerate(_texts(asked, found, visit, part)):
        if idle_hand(asked, line, text):
            continue
        yield _added(asked, line, beside, text, size, against, HABIT + 0.1 * k)


def _texts(
    asked: Asked, found: Sequence[Visit], visit: Visit, part: Part
) -> Iterator[tuple[str, int]]:
    """Yield what a step may say that is a part of a visit, and how many nodes it has."""
    like = [s for each in found if (s := each.of(part)) and WORDS.get(s.word, part) is part]
    if part in (Part.APPROACH, Part.PLACE) and not visit.target:
        return
    target = _spelt(asked, visit) if visit.target else ""
    size = 1 + target.count("[") + 2 * target.count(":")
    words = [word for word, _ in Counter(stop.word for stop in like).most_common(2)]
    mine = visit.stops[0].step.program
    known = [s for s in like if s.step.program == mine or number(s.distance) is not None]
    distances = [text for text, _ in Counter(stop.distance for stop in known).most_common(MOST)]
    for word in words:
        match part:
            case Part.PLACE:
                yield f"{word} {target}", 1 + size
            case Part.APPROACH:
                yield from ((f"{word} {target}, {each}", 2 + size) for each in distances)
            case Part.LEAVE | Part.SPEED:
                yield from ((f"{word} {each}", 2) for each in distances)
            case _:
                yield word, 1


def _spelt(asked: Asked, visit: Visit) -> str:
    """Return the location of a visit as the program writes it."""
    stop = next(each for each in visit.stops if each.target)
    text = stop.step.text.split(None, 1)[1]
    return (text.rpartition(",")[0] if WORDS[stop.word] is Part.APPROACH else text).strip()


def _added(
    asked: Asked,
    line: int,
    beside: WrittenStep,
    text: str,
    size: int,
    against: float,
    unusual: float,
) -> Candidate:
    written = asked.written
    at = written.line_start(line)
    more = f"{written.indent(beside.line)}{text}\n"
    return asked.candidate(
        Does.ADD,
        line,
        (replacement(written.source, at, at, more),),
        size=size,
        priced=1.3,
        against=against,
        trust=TRUSTED,
        unusual=unusual,
        new=text,
    )


def _go_there(asked: Asked, found: Sequence[Visit]) -> Iterator[Candidate]:
    """Yield a motion to each place that is only approached before the hand moves: one mistake."""
    lacking = [
        visit
        for visit in found
        if visit.target and visit.of(Part.PLACE) is None and visit.of(Part.HAND) is not None
    ]
    if len(lacking) < 2:
        return
    written = asked.written
    edits: list[Edit] = []
    for visit in lacking:
        after = next(stop for stop in visit.stops if stop.part > Part.PLACE)
        at = written.line_start(after.step.line)
        more = f"{written.indent(after.step.line)}MOVES {_spelt(asked, visit)}\n"
        edits.append(replacement(written.source, at, at, more))
    lines = [
        next(stop.step.line for stop in visit.stops if stop.part > Part.PLACE) for visit in lacking
    ]
    yield asked.candidate(
        Does.ADD,
        min(lines, key=asked.against),
        edits,
        size=2 * len(edits),
        priced=1.6,
        unusual=-0.2,
        old="before the hand at each place that is only approached",
        new="MOVES",
    )


def _distances(asked: Asked, found: Sequence[Visit]) -> Iterator[Candidate]:
    """Yield the usual distance where one stands out."""
    for stop, how_far in odd_distances(found):
        if not asked.matters(stop.step.line):
            continue
        yield from _usual(asked, found, stop, how_far)


def _usual(asked: Asked, found: Sequence[Visit], stop: Stop, how_far: float) -> Iterator[Candidate]:
    like = [other for visit in found if (other := visit.of(stop.part)) is not None]
    counted = Counter(each.distance for each in like if each.distance != stop.distance)
    end = stop.step.start + len(stop.step.text.rstrip())
    start = end - len(stop.distance)
    if asked.written.text[start:end] != stop.distance:
        return
    for k, (text, _) in enumerate(counted.most_common(MOST)):
        if number(text) is None:
            continue
        yield asked.candidate(
            Does.NUMBER,
            stop.step.line,
            (replacement(asked.written.source, start, end, text),),
            unusual=STANDS_OUT * how_far + 0.1 * k,
            trust=TRUSTED,
            old=stop.distance,
            new=text,
        )
