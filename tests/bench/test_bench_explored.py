"""How many random scenarios of random programs show only what the search of all futures knows."""

import os
import time
from collections import Counter

from tests.property.test_explored import among_the_futures
from tests.property.test_walked import walked
from vrts.base.stack import deep_stack
from vrts.prove.proof import What

PROGRAMS, SCENARIOS = int(os.environ.get("PROGRAMS", "300")), 34


@deep_stack()
def test_scenarios_show_no_future_that_is_not_explored() -> None:
    """Asked for: 10,000 scenarios of 300 programs. Fails at the first state that is not known."""
    before = time.process_time()
    for number in range(PROGRAMS):
        among_the_futures(number, SCENARIOS)
    took_s = time.process_time() - before
    print(f"\n{PROGRAMS * SCENARIOS:,} scenarios of {PROGRAMS} programs: every state was explored")
    print(f"{took_s:.0f} s of processor time")


@deep_stack()
def test_nothing_that_chance_decides_is_beside_what_was_explored() -> None:
    """Fails at the first state that is not known, or run of a scenario that ends otherwise."""
    before, ended, programs = time.process_time(), 0, 0
    decided = Counter[What]()
    for number in range(PROGRAMS):
        walks, kinds = walked(number, SCENARIOS)
        ended, programs = ended + walks, programs + (walks > 0)
        decided.update(kinds)
    took_s = time.process_time() - before
    print(f"\n{ended:,} walks of {programs} programs: every state was explored, every end the same")
    print(f"{PROGRAMS - programs} programs have more futures than were looked at")
    print(
        "programs in which it was decided: "
        + ", ".join(f"{w.value} {n}" for w, n in decided.items())
    )
    print(f"{took_s:.0f} s of processor time")
