"""What chains of causes cost a verification, and where they are asked for: by hand, `-s`.

Nothing is recorded for them that is not recorded without (a run is the same object), so recording
costs nothing more; what is measured is looking backward.
"""

from collections import Counter
from functools import cache
from statistics import median
from time import process_time

from tests.golden.examples import EXAMPLES
from tests.mutants.given import Mutant, mutants
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import load_task, setting_for
from vrts.pipeline.where import Where

TIMES = 5


def spent(request: Request) -> float:
    """Return the processor time of a verification [s]."""
    before = process_time()
    assess(request)
    return process_time() - before


def test_chains_of_causes_cost_a_verification_less_than_a_tenth() -> None:
    ratios: list[float] = []
    for example in EXAMPLES:
        for path in sorted((example / "submissions").glob("*.v2")):
            setting = setting_for(path, Where())
            assert setting is not None
            file = ProgramFile(path.read_bytes(), path.name)
            without = Request(file, setting, checks=Checks())
            having = Request(file, setting, checks=Checks(causes=True))
            if assess(without).run is None:
                continue
            pairs = [(spent(without), spent(having)) for _ in range(TIMES)]
            ratios.append(median(b for _, b in pairs) / median(a for a, _ in pairs))
    print(f"\n{len(ratios)} submissions: with chains {median(ratios):.3f} of without (median),")
    print(f"{max(ratios):.3f} at most")
    assert median(ratios) < 1.1


def mistaken(mutant: Mutant) -> set[int]:
    """Return the lines of a mutant that differ from what they were."""
    lines: set[int] = set()
    moved = 0
    for first, old, new in mutant.edits:
        lines |= set(range(first + moved, first + moved + len(new)))
        moved += len(new) - len(old)
    return lines


def test_chains_name_the_line_of_the_mistake() -> None:
    """Of mutants with one mistake; where a line is missing, no chain can name it."""
    setting = cache(load_task)
    named, all_of = Counter[str](), Counter[str]()
    for mutant in mutants():
        lines = mistaken(mutant)
        if len(mutant.kinds) != 1 or not lines:
            continue
        file = ProgramFile(mutant.text.encode(), "prog.v2")
        a = assess(Request(file, setting(mutant.task), checks=Checks(causes=True)))
        if a.run is None or a.grade is None:
            continue
        told = {link.span.line for chain in a.chains for link in chain.links if link.span}
        told |= {loss.span.line for loss in a.grade.losses if loss.span}
        kind = mutant.kinds[0]
        all_of[kind] += 1
        named[kind] += bool(told & lines)
    found, every = named.total(), all_of.total()
    print(f"\nthe line of the mistake is named in {found} of {every} ({100 * found / every:.1f} %)")
    for kind, count in sorted(all_of.items()):
        if named[kind] < count:
            print(f"  {kind:24} {named[kind]:3} of {count}")
    assert found > 0.8 * every
