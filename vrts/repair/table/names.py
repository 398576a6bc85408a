"""Other names: misspelt ones, exchanged ones, parts of compounds left out or turned round."""

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Name,
)
from vrts.lang.syntax.statements import CallStatement, For, SetLocation, Simple
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.arguments import arguments, swap
from vrts.repair.table.asked import MOVES_TO, TRUST, Asked, name_of, names_in, series, target_of
from vrts.repair.table.compounds import (
    NEAR,
    approaches,
    compounds,
    location_operands,
    visits,
)
from vrts.repair.table.numbers import AWAY, word_of
from vrts.repair.table.placing import same
from vrts.repair.written import WrittenStep

NOT_NAMED = 0.4  # what a teacher says against a name far from the one that nothing defines
PARTED = 0.6  # what a teacher says against going near one location and then to another
UNLIKE = 0.5  # and against exchanging where one goes with what another only goes near
FORGOTTEN = 0.5  # what it costs that a line is not to blame, for a program that nothing calls
TWICE = 0.4  # what speaks for a location that nothing names, in place of one that is named twice
ONE_FOR_ALL = -0.6  # what speaks for one header that is wrong, where several calls are alike
COUNTER = 0.7  # what a teacher says against a distance that is the counter of a loop
FEW = 2  # letters in which a misspelt name differs
LEFT = 0.5  # what a teacher says against leaving a location that was taught and named unused


def other_names(asked: Asked) -> Iterator[Candidate]:
    """Yield every step with another name, and definitions under the name that is used."""
    used = {key(name.text) for step in asked.written.steps for name in names_in(step)}
    for step in asked.steps:
        yield from _in_step(asked, step)
        yield from compounds(asked, step)
        yield from arguments(asked, step)
    yield from _everywhere(asked)
    yield from _definitions(asked, used)
    yield from _headers(asked, used)
    yield from _exchanged(asked)


def letters_apart(a: str, b: str) -> int:
    """Return how many letters are to be changed, added or removed; two exchanged count one."""
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        above, row = row, [i]
        for j, y in enumerate(b, 1):
            best = min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                best = min(best, before[j - 2] + 1)
            row.append(best)
        before = above
    return row[-1]


def slipped(wrong: str, right: str) -> bool:
    """Return whether of two names the one is more likely mistyped than the other.

    A letter is doubled, or something is hung on; else one is left out.
    """
    for k in range(len(wrong)):
        if wrong[:k] + wrong[k + 1 :] == right:
            return k + 1 == len(wrong) or wrong[k] in (wrong[k - 1 : k], wrong[k + 1])
    for k in range(1, len(right) - 1):
        if right[:k] + right[k + 1 :] == wrong:
            return right[k - 1] != right[k] and right[k] != right[k + 1]
    return False


def _in_step(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    defined = asked.defined | asked.taught.keys()
    target = target_of(step)
    beside = _visited_beside(asked, step)
    again = _again(asked, step)
    counters = {
        key(each.statement.target.text)
        for each in asked.written.steps
        if isinstance(each.statement, For) and isinstance(each.statement.target, Name)
    }
    is_away = word_of(step.statement) in AWAY
    for name in names_in(step):
        mine = key(name.text)
        others = _like(asked, mine, step)
        for other in sorted(others - {mine}):
            apart = letters_apart(mine, other)
            unusual = 0.3
            if mine not in asked.defined:
                unusual = -0.8 if apart <= FEW else 0.1
            elif apart == 1:
                unusual = 0.2
            if target is not None and name_of(target) == name.text:
                unusual += 0.4
            if other not in defined:
                unusual += 0.4
            elif other in asked.idle:
                unusual -= 0.5 + (TWICE if asked.used[mine] > 1 else 0.0)
            left = asked.used[mine] == 1 and mine in asked.row_names and other not in asked.idle
            doubt = LEFT if left else 0.0
            if mine not in asked.defined:
                doubt = 0.0 if apart <= FEW else NOT_NAMED
                right = mine in asked.taught or series(mine) in asked.series
                right = right and not slipped(mine, other)
                right = right or asked.familiar(mine) > asked.familiar(other)
                if right or slipped(other, mine):
                    doubt, unusual = doubt + 0.3, unusual + 0.3  # its row is misspelt, not it
                    unusual += 0.5 if other in asked.idle else 0.0  # so nobody used it
            if other in counters and is_away:
                unusual, doubt = unusual + COUNTER, doubt + COUNTER
            if mine in beside:
                unusual, doubt = unusual + 0.3, doubt + PARTED
            elif other in beside:
                unusual -= 0.6
            if again:
                unusual -= 0.4
            yield asked.instead(Does.NAME, step.line, name, other, unusual=unusual, doubt=doubt)
    if isinstance(step.statement, CallStatement):
        program = step.statement.program
        for other in asked.written.programs[1:]:
            if other.name != key(program.text):
                forgotten = other.name not in asked.called
                unusual = -0.7 if forgotten else 0.2
                trust = FORGOTTEN if forgotten else None
                yield asked.instead(
                    Does.NAME, step.line, program, other.name, unusual=unusual, trust=trust
                )


def _visited_beside(asked: Asked, step: WrittenStep) -> set[str]:
    """Return the locations of the motion that one belongs to: the way there after an approach."""
    if not visits(step):
        return set()
    steps = asked.written.steps
    k = steps.index(step)
    goes_near = approaches(step)
    way = steps[k + 1 :] if goes_near else steps[:k][::-1]
    near = next((each for each in way[:NEAR] if visits(each)), None)
    if near is None or near.program != step.program or approaches(near) == goes_near:
        return set()
    return {key(name.text) for name in names_in(near)}


def _again(asked: Asked, step: WrittenStep) -> bool:
    """Return whether a motion says what the one before or after it says."""
    steps = asked.written.steps
    k = steps.index(step)
    beside = (*steps[max(k - 1, 0) : k], *steps[k + 1 : k + 2])
    return visits(step) and any(same(step.text, each.text) for each in beside)


def _like(asked: Asked, name: str, step: WrittenStep) -> set[str]:
    """Return the names that may stand where a name stands."""
    if name in asked.arrays:
        return set(asked.arrays)
    formals = {
        key(f.name.text) for f in asked.written.programs[step.program].formals if f and not f.array
    }
    if name in asked.locations:
        return set(asked.locations) | formals
    if name in asked.numbers:
        return set(asked.numbers) | formals
    if name in asked.defined:
        return set(asked.locations | asked.numbers) | formals
    return set(asked.locations | asked.numbers | asked.arrays) | formals | set(asked.taught)


def _everywhere(asked: Asked) -> Iterator[Candidate]:
    """Yield a name that nothing defines as one that is like it, wherever it stands: one mistake."""
    source = asked.written.source
    for name in sorted(asked.undefined):
        places = [
            (step.line, part)
            for step in asked.written.steps
            for part in names_in(step)
            if key(part.text) == name
        ]
        if len(places) < 2:
            continue
        for other in sorted(asked.defined | asked.taught.keys()):
            if letters_apart(name, other) > FEW:
                continue
            edits = [replacement(source, part.start, part.end, other) for _, part in places]
            meant = slipped(name, other) or other in asked.taught or series(other) in asked.series
            meant = meant or asked.familiar(other) > asked.familiar(name)
            yield asked.candidate(
                Does.NAME,
                places[0][0],
                edits,
                size=len(edits),
                priced=1,
                against=0.3,
                unusual=-0.8 - (0.2 if meant else 0.0),
                old=name,
                new=other,
            )


def _definitions(asked: Asked, used: set[str]) -> Iterator[Candidate]:
    """Yield rows and assignments under a name that is used and that nothing defines."""
    wanted = sorted(used - asked.defined)
    targets = [(row.line, row.node.target) for row in asked.written.rows]
    rows = {line for line, _ in targets}
    for step in asked.written.steps:
        target = target_of(step)
        if target is not None:
            targets.append((step.line, target))
    times = Counter(key(name_of(target)) for _, target in targets if isinstance(target, Name))
    for line, target in targets:
        name = target if isinstance(target, Name) else target.name
        mine = key(name.text)
        for other in wanted:
            twice = times[mine] > 1
            if mine in used and not twice and letters_apart(mine, other) > FEW:
                continue
            near = letters_apart(mine, other) <= FEW
            meant = other in asked.taught or series(other) in asked.series
            meant = meant and not slipped(other, mine)
            meant = meant or slipped(mine, other) or asked.familiar(other) > asked.familiar(mine)
            right = mine in asked.taught or series(mine) in asked.series
            right = (right and not slipped(mine, other)) or slipped(other, mine)
            again = twice and line not in rows  # a step gives a value to what has one already
            edit = replacement(asked.written.source, name.start, name.end, other)
            yield asked.candidate(
                Does.NAME,
                line,
                (edit,),
                against=0.3,
                unusual=(-0.8 if near else -0.5 if again else 0.3)
                - (0.2 if meant else 0.0)
                + (0.6 if right and not again else 0.0),
                old=name.text,
                new=other,
            )


def _headers(asked: Asked, used: set[str]) -> Iterator[Candidate]:
    """Yield formal arguments exchanged, or under the name that their program uses."""
    source = asked.written.source
    for number, program in enumerate(asked.written.programs):
        mine = {
            key(name.text)
            for step in asked.written.steps
            if step.program == number
            for name in names_in(step)
        }
        formals = [f for f in program.formals if f]
        for formal in formals:
            name = formal.name
            for other in sorted(mine - asked.defined - {key(name.text)}):
                edit = replacement(source, name.start, name.end, other)
                near = letters_apart(key(name.text), other) <= FEW
                yield asked.candidate(
                    Does.NAME,
                    program.line,
                    (edit,),
                    against=0.3,
                    unusual=-0.6 if near else 0.2,
                    old=name.text,
                    new=other,
                )
        calls = sum(
            isinstance(step.statement, CallStatement)
            and key(step.statement.program.text) == program.name
            for step in asked.written.steps
        )
        for one, other in pairwise(formals):
            a, b = one.name, other.name
            edits = (
                replacement(source, a.start, a.end, b.text),
                replacement(source, b.start, b.end, a.text),
            )
            yield asked.candidate(
                Does.ORDER,
                program.line,
                edits,
                size=2,
                against=0.5 if calls < 2 else 0.3,
                unusual=0.3 if calls < 2 else ONE_FOR_ALL,
                old=f"{a.text}, {b.text}",
                new=f"{b.text}, {a.text}",
            )


def _exchanged(asked: Asked) -> Iterator[Candidate]:
    """Yield the operands of two steps of one kind exchanged: `SET from[1]` and `SET from[2]`."""
    settings = [step for step in asked.steps if isinstance(step.statement, SetLocation)]
    motions = [
        step
        for step in asked.steps
        if isinstance(step.statement, Simple) and step.statement.word in MOVES_TO
    ]
    for steps in (settings, motions):
        for k, one in enumerate(steps):
            for other in steps[k + 1 :]:
                a, b = next(location_operands(one), None), next(location_operands(other), None)
                if a is None or b is None or asked.text_of(a) == asked.text_of(b):
                    continue
                found = swap(asked, one, a, b, 0.2)
                less = min(asked.against(one.line), asked.against(other.line))
                by = TRUST[Does.ORDER] * (less - asked.against(one.line))
                unlike = approaches(one) != approaches(other)
                doubt = UNLIKE if unlike else 0.0
                yield found._replace(cost=found.cost + by + doubt, doubt=doubt)
