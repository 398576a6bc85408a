"""A way past several places, gone the other way round: the places in the opposite order."""

from collections.abc import Iterator, Sequence

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.statements import Simple
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import MOVES_TO, Asked
from vrts.repair.visits import Part, visits
from vrts.repair.written import WrittenStep

BESIDE = ("BREAK", "SPEED", "DEPART", "DEPARTS", "DELAY")  # steps that are no end of a way
FEWEST = 3  # places of a way


def turned_round(asked: Asked) -> Iterator[Candidate]:
    """Yield each way with its places in the opposite order, where a task asks for an order."""
    if not asked.task.ordered or len(asked.task.vias) < 2:
        return
    for way in _ways(asked):
        names = list(dict.fromkeys(key(name.text) for _, name in way))
        if len(names) < FEWEST or not all(asked.matters(step.line) for step, _ in way):
            continue
        spelt = {key(name.text): name.text for _, name in way}
        other = {a: spelt[b] for a, b in zip(names, reversed(names), strict=True)}
        source = asked.written.source
        changed = [name for _, name in way if other[key(name.text)] != name.text]
        yield asked.candidate(
            Does.ORDER,
            min((step.line for step, _ in way), key=asked.against),
            [replacement(source, n.start, n.end, other[key(n.text)]) for n in changed],
            size=len(changed),
            priced=1.6,
            unusual=-0.2,
            old=", ".join(spelt[name] for name in names),
            new=", ".join(spelt[name] for name in reversed(names)),
        )


def _ways(asked: Asked) -> Iterator[Sequence[tuple[WrittenStep, Name]]]:
    """Yield motions to named places one after another, none of which the hand moves at."""
    handled = {visit.target for visit in visits(asked.written) if visit.of(Part.HAND) is not None}
    way: list[tuple[WrittenStep, Name]] = []
    for step in asked.written.steps:
        if step.text.split()[0].upper() in BESIDE:
            continue
        match step.statement:
            case Simple(word, (Name() as name, *_)) if (
                word in MOVES_TO
                and key(name.text) not in handled
                and (not way or way[-1][0].program == step.program)
            ):
                way.append((step, name))
            case _:
                yield way
                way = []
    yield way
