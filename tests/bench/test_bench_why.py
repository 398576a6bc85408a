"""What chains of causes cost a verification, and where they are asked for: by hand, `-s`.

Nothing is recorded for them that is not recorded without (a run is the same object), so recording
costs nothing more; what is measured is looking backward.
"""

from statistics import median
from time import process_time

from tests.golden.examples import EXAMPLES
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import setting_for
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
